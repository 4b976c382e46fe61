//! What a check says.

use super::{Counterexample, Evidence, Witness};

/// What the check says of one variant.
#[derive(Debug, Clone, PartialEq)]
pub enum Outcome {
    /// It holds, on this evidence.
    Holds(Vec<Evidence>),
    /// It fails.
    Fails {
        /// Where it fails, so that anyone can check.
        counterexample: Counterexample,
        /// How that was established.
        evidence: Vec<Evidence>,
        /// The parts after it that fail as well; [`Run::all`](super::Run::all) fills them in.
        later: Vec<String>,
    },
    /// Neither could be established, and why.
    Undecided(String),
    /// There is nothing to check, and why; with what could be checked all the same.
    NotCheckable(String, Vec<Evidence>),
}

impl Outcome {
    /// A failure on several pieces of evidence.
    pub fn failure(counterexample: impl Into<Counterexample>, evidence: Vec<Evidence>) -> Self {
        Outcome::Fails { counterexample: counterexample.into(), evidence, later: Vec::new() }
    }

    /// The parts that fail: those of the evidence of a failure, and those after it.
    pub fn failing_parts(&self) -> Vec<String> {
        match self {
            Outcome::Fails { evidence, later, .. } => {
                evidence.iter().map(|e| e.part.clone()).chain(later.clone()).collect()
            }
            _ => Vec::new(),
        }
    }

    /// A failure on one piece of evidence.
    pub fn fails(counterexample: impl Into<Counterexample>, evidence: Evidence) -> Self {
        Outcome::failure(counterexample, vec![evidence])
    }

    /// The same, where it fails, with something more that is to be seen.
    pub fn seen(mut self, witness: Witness) -> Self {
        if let Outcome::Fails { counterexample, .. } = &mut self {
            counterexample.witnesses.insert(0, witness);
        }
        self
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
            Outcome::Fails { counterexample, evidence, later } => {
                Outcome::Fails { counterexample, evidence: each(evidence), later }
            }
            Outcome::NotCheckable(why, evidence) => Outcome::NotCheckable(why, each(evidence)),
            Outcome::Undecided(why) => Outcome::Undecided(why),
        }
    }
}

/// Why a check could not be carried out. Every error of the libraries below converts into it.
#[derive(Debug)]
pub enum CheckError {
    /// The limit of work or of time was reached, or the run was interrupted.
    Limit,
    /// A part of the check looked at no case: that is no evidence.
    NoCases(String),
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
            CheckError::NoCases(part) => write!(f, "no case was looked at for \"{part}\""),
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
