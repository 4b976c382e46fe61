//! The trait that a claim implements.

use super::{Evidence, Run};
use crate::arithmetic::ArithmeticError;
use crate::arithmetic::identity::IdentityError;
use crate::averaging::FlockError;
use crate::averaging::settle::SettleError;
use crate::matrix::MatrixError;
use crate::platoon::{CommunicationError, ResonanceError};

/// A statement with a check. `notes/own_claims.md` shows how to write and register one.
pub trait Claim: Send + Sync + 'static {
    /// The data in which variants of the statement differ: a sign, an index, a factor, a bound.
    type Variant;

    /// The id, such as `veerman.lem2`.
    fn id(&self) -> &str;

    /// Place and text of the statement; `None` for the ids of the papers, whose list the ledger has.
    fn source(&self) -> Option<Source> {
        None
    }

    /// The argument in words, for `explain`.
    fn derivation(&self) -> &str;

    /// The statement as printed.
    fn printed(&self) -> Self::Variant;

    /// The corrected statement, for claims whose printed form fails.
    fn repair(&self) -> Option<Repair<Self::Variant>> {
        None
    }

    /// Altered variants that the check must refute.
    fn controls(&self) -> Vec<Control<Self::Variant>>;

    /// Decides a variant.
    ///
    /// # Errors
    /// [`CheckError`] where the check itself could not be carried out.
    fn examine(&self, variant: &Self::Variant, run: &mut Run) -> Result<Outcome, CheckError>;
}

/// Where a statement comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// Section, equation, lemma.
    pub place: String,
    /// The statement.
    pub statement: String,
}

/// What the check says of one variant.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// It holds, on this evidence.
    Holds(Vec<Evidence>),
    /// It fails.
    Fails {
        /// Where it fails, so that anyone can check.
        counterexample: String,
        /// How that was established.
        evidence: Vec<Evidence>,
    },
    /// Neither could be established, and why.
    Undecided(String),
    /// There is nothing to check, and why; with what could be checked all the same.
    NotCheckable(String, Vec<Evidence>),
}

impl Outcome {
    /// A failure on one piece of evidence.
    pub fn fails(counterexample: impl Into<String>, evidence: Evidence) -> Self {
        Outcome::Fails { counterexample: counterexample.into(), evidence: vec![evidence] }
    }
}

/// What is wrong with a printed claim that fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    /// Misprinted: an evident correction holds.
    Misprint,
    /// False: the repaired statement says something else.
    False,
}

/// A corrected statement.
#[derive(Debug, Clone)]
pub struct Repair<V> {
    /// What kind of fault it corrects.
    pub fault: Fault,
    /// The corrected statement in words.
    pub statement: String,
    /// The corrected statement for the check.
    pub variant: V,
}

/// A negative control.
#[derive(Debug, Clone)]
pub struct Control<V> {
    /// What was altered.
    pub what: &'static str,
    /// The altered statement for the check.
    pub variant: V,
}

impl<V> Control<V> {
    /// A named control.
    pub fn new(what: &'static str, variant: V) -> Self {
        Control { what, variant }
    }
}

/// Why a check could not be carried out.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CheckError {
    /// The time limit was reached.
    #[error("the time limit was reached")]
    OutOfTime,
    /// An operation without a result.
    #[error(transparent)]
    Arithmetic(#[from] ArithmeticError),
    /// A matrix that is refused.
    #[error(transparent)]
    Matrix(#[from] MatrixError),
    /// A flock that is refused.
    #[error(transparent)]
    Flock(#[from] FlockError),
    /// A flock that could not be followed.
    #[error(transparent)]
    Settle(#[from] SettleError),
    /// An identity that could not be tested.
    #[error(transparent)]
    Identity(#[from] IdentityError),
    /// A resonance that could not be enclosed.
    #[error(transparent)]
    Resonance(#[from] ResonanceError),
    /// A communication graph that is refused.
    #[error(transparent)]
    Communication(#[from] CommunicationError),
    /// Anything else.
    #[error("{0}")]
    Other(String),
}

/// A claim of any variant type, as the ledger holds it.
pub trait AnyClaim: Send + Sync {
    /// The id.
    fn id(&self) -> &str;
    /// Place and text, for claims that are not in the list of the papers.
    fn source(&self) -> Option<Source>;
    /// The corrected statement, for claims whose printed form fails.
    fn corrected(&self) -> Option<String>;
    /// Runs the check on the printed statement, the correction and the controls.
    fn judge(&self, source: &Source, run: &mut Run) -> super::Entry;
    /// Runs the check on the corrected statement, as a claim of its own; the printed one joins the controls.
    fn judge_correction(&self, source: &Source, run: &mut Run) -> super::Entry;
}

impl<C: Claim> AnyClaim for C {
    fn id(&self) -> &str {
        Claim::id(self)
    }
    fn source(&self) -> Option<Source> {
        Claim::source(self)
    }
    fn judge(&self, source: &Source, run: &mut Run) -> super::Entry {
        super::judge(self, source, run)
    }
    fn corrected(&self) -> Option<String> {
        self.repair().map(|repair| repair.statement)
    }
    fn judge_correction(&self, source: &Source, run: &mut Run) -> super::Entry {
        super::judge::judge_correction(self, source, run)
    }
}
