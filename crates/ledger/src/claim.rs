//! The trait that a claim implements.

use super::{Evidence, Run, Verdict};
use serde::{Deserialize, Serialize};

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

    /// The same with evidence that bears on these clauses, counted from 1.
    pub fn on(self, clauses: impl Into<Vec<usize>>) -> Self {
        let clauses = clauses.into();
        self.with(|e| e.on(clauses.clone()))
    }

    /// The same, where it holds, with evidence for all parameters of its clauses.
    pub fn for_all(self) -> Self {
        match self {
            Outcome::Holds(_) => self.with(Evidence::for_all),
            other => other,
        }
    }

    fn with(self, change: impl Fn(Evidence) -> Evidence) -> Self {
        let each = |evidence: Vec<Evidence>| evidence.into_iter().map(&change).collect();
        match self {
            Outcome::Holds(evidence) => Outcome::Holds(each(evidence)),
            Outcome::Fails { counterexample, evidence } => Outcome::Fails { counterexample, evidence: each(evidence) },
            Outcome::NotCheckable(why, evidence) => Outcome::NotCheckable(why, each(evidence)),
            Outcome::Undecided(why) => Outcome::Undecided(why),
        }
    }
}

/// What is wrong with a printed claim that fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Fault {
    /// A hypothesis is missing that the paper does not state (a degenerate size, connectedness); true with it.
    Hypothesis,
    /// The intended text is evident.
    Typo,
    /// A step of algebra or an estimate is wrong, and the use made of it survives.
    Slip,
    /// The mathematics is wrong.
    False,
}

impl Fault {
    /// The verdict on a statement with this fault.
    pub fn verdict(self) -> Verdict {
        match self {
            Fault::Hypothesis => Verdict::NeedsHypothesis,
            Fault::Typo | Fault::Slip => Verdict::Misprint,
            Fault::False => Verdict::False,
        }
    }

    /// The word used in the ledger.
    pub fn word(self) -> &'static str {
        match self {
            Fault::Hypothesis => "hypothesis",
            Fault::Typo => "typo",
            Fault::Slip => "slip",
            Fault::False => "false",
        }
    }
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
    /// How it is read, where that is a choice.
    pub reading: Option<String>,
}

/// Why a check could not be carried out. Every error of the libraries below converts into it.
#[derive(Debug)]
pub enum CheckError {
    /// The limit of work or of time was reached, or the run was interrupted.
    Limit,
    /// What the check computes with failed.
    Failed(Box<dyn std::error::Error + Send + Sync>),
    /// Anything else.
    Other(String),
}

// Not an error type itself: the conversion below would overlap with that of a type into itself.
impl std::fmt::Display for CheckError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            CheckError::Limit => write!(f, "the limit of work was reached"),
            CheckError::Failed(error) => write!(f, "{error}"),
            CheckError::Other(what) => write!(f, "{what}"),
        }
    }
}

impl<E: std::error::Error + Send + Sync + 'static> From<E> for CheckError {
    fn from(error: E) -> Self {
        CheckError::Failed(Box::new(error))
    }
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
    /// How the statement is read, where that is a choice.
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
