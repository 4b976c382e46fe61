//! The trait that a claim implements.

use super::{CheckError, Fault, Outcome, Run};

/// Where a statement comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// Section, equation, lemma.
    pub place: String,
    /// The statement.
    pub statement: String,
}

/// A corrected statement.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Correction {
    /// What kind of fault it corrects.
    pub fault: Fault,
    /// The corrected statement in words.
    pub statement: String,
    /// Its clauses; none where it is one.
    pub clauses: Vec<String>,
}

/// Which form of a claim is examined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Form {
    /// As printed.
    Printed,
    /// As corrected.
    Corrected,
    /// The altered form of this negative control.
    Control(usize),
}

/// A statement with a check, as the ledger holds it. [`Record`](super::Record) is the way to write one; `notes/own_claims.md` shows how.
pub trait Claim: Send + Sync {
    /// The id, such as `veerman.lem2`.
    fn id(&self) -> &str;
    /// Place and text, for claims that are not in a list.
    fn source(&self) -> Option<Source>;
    /// The argument in words.
    fn derivation(&self) -> &str;
    /// The sentences of the printed statement that can be true or false alone; none where it is one clause.
    fn clauses(&self) -> Vec<String>;
    /// How the printed statement is read, where that is a choice; a correction leaves none.
    fn reading(&self) -> Option<String>;
    /// The corrected statement, for claims whose printed form fails.
    fn correction(&self) -> Option<Correction>;
    /// What each negative control alters.
    fn alterations(&self) -> Vec<&str>;
    /// Decides one form.
    ///
    /// # Errors
    /// [`CheckError`] where the check could not be carried out, or has no such form.
    fn examine(&self, form: Form, run: &mut Run) -> Result<Outcome, CheckError>;
}
