//! Claims as records: data, and the function that decides a variant.

use super::{CheckError, Claim, Correction, Fault, Form, Outcome, Run, Source};

/// A check of one variant.
type Examine<V> = fn(&V, &mut Run) -> Result<Outcome, CheckError>;

/// A claim: its data and the function that decides a variant.
///
/// ```
/// use ledger::Record;
/// let squares = Record::new("mine.squares", "n n < n^k for n >= 2 and k > 2.", 3u32, |k, run| {
///     let larger = |n: &u64| (n.pow(2) >= n.pow(*k)).then(|| format!("n = {n}"));
///     run.exhaustive("n from 2 to 9", "compared", 2..=9u64, |n| Ok(larger(&n)))
/// })
/// .stated("school", "n^2 < n^3 for every integer n from 2 to 9.")
/// .control("the square itself", 2)
/// .altered("a smaller power", |k| *k -= 2);
/// ```
pub struct Record<V> {
    id: &'static str,
    derivation: &'static str,
    printed: V,
    examine: Examine<V>,
    source: Option<(&'static str, &'static str)>,
    clauses: &'static [&'static str],
    reading: Option<&'static str>,
    repair: Option<(Fault, &'static str, V)>,
    repaired_clauses: &'static [&'static str],
    controls: Vec<(&'static str, V)>,
}

impl<V> Record<V> {
    /// A claim without correction and controls.
    pub fn new(id: &'static str, derivation: &'static str, printed: V, examine: Examine<V>) -> Self {
        Record {
            id,
            derivation,
            printed,
            examine,
            source: None,
            clauses: &[],
            reading: None,
            repair: None,
            repaired_clauses: &[],
            controls: Vec::new(),
        }
    }

    /// Place and statement, for claims beyond the papers. An empty statement is that of its clauses, one after the other; the same for
    /// [`Record::repaired`].
    pub fn stated(mut self, place: &'static str, statement: &'static str) -> Self {
        self.source = Some((place, statement));
        self
    }

    /// The sentences of the statement that can be true or false alone, for statements of several.
    pub fn clauses(mut self, clauses: &'static [&'static str]) -> Self {
        self.clauses = clauses;
        self
    }

    /// How the statement is read, where that is a choice.
    pub fn reading(mut self, reading: &'static str) -> Self {
        self.reading = Some(reading);
        self
    }

    /// The clauses of the corrected statement, where it has several.
    pub fn repaired_clauses(mut self, clauses: &'static [&'static str]) -> Self {
        self.repaired_clauses = clauses;
        self
    }

    /// The corrected statement.
    pub fn repaired(mut self, fault: Fault, statement: &'static str, variant: V) -> Self {
        self.repair = Some((fault, statement, variant));
        self
    }

    /// The corrected statement, as a change of the printed one.
    pub fn repaired_by(self, fault: Fault, statement: &'static str, change: impl FnOnce(&mut V)) -> Self
    where
        V: Clone,
    {
        let mut variant = self.printed.clone();
        change(&mut variant);
        self.repaired(fault, statement, variant)
    }

    /// One more negative control: what is true, with this change. That is the corrected statement where there is one, and so comes after
    /// [`Record::repaired`].
    pub fn altered(self, what: &'static str, alter: impl FnOnce(&mut V)) -> Self
    where
        V: Clone,
    {
        let mut variant = self.repair.as_ref().map_or(&self.printed, |(_, _, repaired)| repaired).clone();
        alter(&mut variant);
        self.control(what, variant)
    }

    /// One more negative control.
    pub fn control(mut self, what: &'static str, variant: V) -> Self {
        self.controls.push((what, variant));
        self
    }
}

/// A statement, or its clauses where it is empty.
fn whole(statement: &str, clauses: &[&str]) -> String {
    if statement.is_empty() { clauses.join(" ") } else { statement.to_string() }
}

fn owned(texts: &[&str]) -> Vec<String> {
    texts.iter().map(|text| text.to_string()).collect()
}

impl<V: Send + Sync + 'static> Claim for Record<V> {
    fn id(&self) -> &str {
        self.id
    }

    fn source(&self) -> Option<Source> {
        let (place, statement) = self.source?;
        Some(Source { place: place.to_string(), statement: whole(statement, self.clauses) })
    }

    fn derivation(&self) -> &str {
        self.derivation
    }

    fn clauses(&self) -> Vec<String> {
        owned(self.clauses)
    }

    fn reading(&self) -> Option<String> {
        self.reading.map(str::to_string)
    }

    fn correction(&self) -> Option<Correction> {
        let (fault, statement, _) = self.repair.as_ref()?;
        let clauses = self.repaired_clauses;
        Some(Correction { fault: *fault, statement: whole(statement, clauses), clauses: owned(clauses) })
    }

    fn alterations(&self) -> Vec<&str> {
        self.controls.iter().map(|(what, _)| *what).collect()
    }

    fn examine(&self, form: Form, run: &mut Run) -> Result<Outcome, CheckError> {
        let variant = match form {
            Form::Printed => Some(&self.printed),
            Form::Corrected => self.repair.as_ref().map(|(_, _, variant)| variant),
            Form::Control(k) => self.controls.get(k).map(|(_, variant)| variant),
        };
        let variant = variant.ok_or_else(|| CheckError::Other("the claim has no such form".to_string()))?;
        (self.examine)(variant, run)
    }
}
