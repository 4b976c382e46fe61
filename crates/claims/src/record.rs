//! Claims as records: for papers with many short claims, whose checks are functions of a variant.

use ledger::{CheckError, Claim, Control, Fault, Outcome, Repair, Run, Source};

/// A check of one variant.
type Examine<V> = fn(&V, &mut Run) -> Result<Outcome, CheckError>;

/// A claim: its data and the function that decides a variant.
pub(super) struct Record<V> {
    id: &'static str,
    derivation: &'static str,
    printed: V,
    examine: Examine<V>,
    source: Option<(&'static str, &'static str)>,
    repair: Option<(Fault, &'static str, V)>,
    controls: Vec<(&'static str, V)>,
}

impl<V> Record<V> {
    /// A claim without correction and controls.
    pub fn new(id: &'static str, derivation: &'static str, printed: V, examine: Examine<V>) -> Self {
        Record { id, derivation, printed, examine, source: None, repair: None, controls: Vec::new() }
    }

    /// Place and statement, for claims beyond the papers.
    pub fn stated(mut self, place: &'static str, statement: &'static str) -> Self {
        self.source = Some((place, statement));
        self
    }

    /// The corrected statement.
    pub fn repaired(mut self, fault: Fault, statement: &'static str, variant: V) -> Self {
        self.repair = Some((fault, statement, variant));
        self
    }

    /// One more negative control.
    pub fn control(mut self, what: &'static str, variant: V) -> Self {
        self.controls.push((what, variant));
        self
    }
}

impl<V: Clone + Send + Sync + 'static> Claim for Record<V> {
    type Variant = V;

    fn id(&self) -> &str {
        self.id
    }

    fn source(&self) -> Option<Source> {
        self.source.map(|(place, statement)| Source { place: place.to_string(), statement: statement.to_string() })
    }

    fn derivation(&self) -> &str {
        self.derivation
    }

    fn printed(&self) -> V {
        self.printed.clone()
    }

    fn repair(&self) -> Option<Repair<V>> {
        let (fault, statement, variant) = self.repair.as_ref()?;
        Some(Repair { fault: *fault, statement: statement.to_string(), variant: variant.clone() })
    }

    fn controls(&self) -> Vec<Control<V>> {
        self.controls.iter().map(|(what, variant)| Control::new(what, variant.clone())).collect()
    }

    fn examine(&self, variant: &V, run: &mut Run) -> Result<Outcome, CheckError> {
        (self.examine)(variant, run)
    }
}
