//! Claims as records: data, and the function that decides a variant.

use super::{CheckError, Claim, Correction, Fault, Form, Outcome, Run, Source};

/// A check of one variant.
type Examine<V> = fn(&V, &mut Run) -> Result<Outcome, CheckError>;

/// A claim: its data and the function that decides a variant.
///
/// ```
/// use flockproof_ledger::Record;
/// let squares = Record::new("mine.squares", "n n < n^k for n >= 2 and k > 2.", 3u32, |k, run| {
///     let larger = |n: &u64| (n.pow(2) >= n.pow(*k)).then(|| format!("n = {n}"));
///     run.exhaustive("n from 2 to 9", "compared", 2..=9u64, |n| Ok(larger(&n)))
/// })
/// .stated("school", "n^2 < n^3 for every integer n from 2 to 9.")
/// .control("the square itself", 2)
/// .altered("a smaller power", |k| *k -= 2);
/// ```
pub struct Record<V> {
    texts: Box<Texts>,
    printed: V,
    repaired: Option<V>,
    controls: Vec<V>,
    examine: Examine<V>,
}

/// What does not depend on the kind of the variants, so that it is compiled once.
struct Texts {
    id: &'static str,
    derivation: &'static str,
    source: Option<(&'static str, &'static str)>,
    clauses: &'static [&'static str],
    reading: Option<&'static str>,
    repair: Option<(Fault, &'static str)>,
    repaired_clauses: &'static [&'static str],
    controls: Vec<&'static str>,
}

impl Texts {
    fn new(id: &'static str, derivation: &'static str) -> Box<Self> {
        Box::new(Texts {
            id,
            derivation,
            source: None,
            clauses: &[],
            reading: None,
            repair: None,
            repaired_clauses: &[],
            controls: Vec::new(),
        })
    }

    fn source(&self) -> Option<Source> {
        let (place, statement) = self.source?;
        Some(Source { place: place.to_string(), statement: whole(statement, self.clauses) })
    }

    fn correction(&self) -> Option<Correction> {
        let (fault, statement) = self.repair?;
        let clauses = self.repaired_clauses;
        Some(Correction { fault, statement: whole(statement, clauses), clauses: owned(clauses) })
    }
}

impl<V> Record<V> {
    /// A claim without correction and controls.
    pub fn new(id: &'static str, derivation: &'static str, printed: V, examine: Examine<V>) -> Self {
        Record { texts: Texts::new(id, derivation), printed, repaired: None, controls: Vec::new(), examine }
    }

    /// Place and statement, for claims beyond the papers. An empty statement is that of its clauses, one after the other; the same for
    /// [`Record::repaired`].
    pub fn stated(mut self, place: &'static str, statement: &'static str) -> Self {
        self.texts.source = Some((place, statement));
        self
    }

    /// The sentences of the statement that can be true or false alone, for statements of several.
    pub fn clauses(mut self, clauses: &'static [&'static str]) -> Self {
        self.texts.clauses = clauses;
        self
    }

    /// How the printed statement is read, where that is a choice. A corrected one has no reading: its words leave no choice.
    pub fn reading(mut self, reading: &'static str) -> Self {
        self.texts.reading = Some(reading);
        self
    }

    /// The clauses of the corrected statement, where it has several.
    pub fn repaired_clauses(mut self, clauses: &'static [&'static str]) -> Self {
        self.texts.repaired_clauses = clauses;
        self
    }

    /// The corrected statement.
    pub fn repaired(mut self, fault: Fault, statement: &'static str, variant: V) -> Self {
        self.texts.repair = Some((fault, statement));
        self.repaired = Some(variant);
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
        let mut variant = self.repaired.as_ref().unwrap_or(&self.printed).clone();
        alter(&mut variant);
        self.control(what, variant)
    }

    /// One more negative control.
    pub fn control(mut self, what: &'static str, variant: V) -> Self {
        self.texts.controls.push(what);
        self.controls.push(variant);
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
        self.texts.id
    }

    fn source(&self) -> Option<Source> {
        self.texts.source()
    }

    fn derivation(&self) -> &str {
        self.texts.derivation
    }

    fn clauses(&self) -> Vec<String> {
        owned(self.texts.clauses)
    }

    fn reading(&self) -> Option<String> {
        self.texts.reading.map(str::to_string)
    }

    fn correction(&self) -> Option<Correction> {
        self.texts.correction()
    }

    fn alterations(&self) -> Vec<&str> {
        self.texts.controls.clone()
    }

    fn examine(&self, form: Form, run: &mut Run) -> Result<Outcome, CheckError> {
        let variant = match form {
            Form::Printed => Some(&self.printed),
            Form::Corrected => self.repaired.as_ref(),
            Form::Control(k) => self.controls.get(k),
        };
        match variant {
            Some(variant) => (self.examine)(variant, run),
            None => Err(no_such_form()),
        }
    }
}

#[cold]
fn no_such_form() -> CheckError {
    CheckError::Other("the claim has no such form".to_string())
}
