//! The trait that a claim implements.

use super::{Evidence, Run, Verdict};
use serde::Serialize;

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

    /// The sentences of the statement that can be true or false alone, in order; none where the statement is one clause.
    fn clauses(&self) -> Vec<String> {
        Vec::new()
    }

    /// How the statement is read, where that is a choice.
    fn reading(&self) -> Option<String> {
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
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
#[derive(Debug, Clone)]
pub struct Repair<V> {
    /// What kind of fault it corrects.
    pub fault: Fault,
    /// The corrected statement in words.
    pub statement: String,
    /// Its clauses; none where it is one.
    pub clauses: Vec<String>,
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

/// A claim of any variant type, as the ledger holds it: the same for every claim, so that judging is compiled once.
pub trait AnyClaim: Send + Sync {
    /// The id.
    fn id(&self) -> &str;
    /// Place and text, for claims that are not in a list.
    fn source(&self) -> Option<Source>;
    /// The argument in words.
    fn derivation(&self) -> &str;
    /// The sentences of the printed statement, where it has several.
    fn clauses(&self) -> Vec<String>;
    /// How the statement is read.
    fn reading(&self) -> Option<String>;
    /// The corrected statement, for claims whose printed form fails.
    fn correction(&self) -> Option<Repair<()>>;
    /// What each negative control alters.
    fn alterations(&self) -> Vec<&'static str>;
    /// Decides one form.
    ///
    /// # Errors
    /// [`CheckError`] where the check could not be carried out, or has no such form.
    fn examine(&self, form: Form, run: &mut Run) -> Result<Outcome, CheckError>;
}

impl<C: Claim> AnyClaim for C {
    fn id(&self) -> &str {
        Claim::id(self)
    }
    fn source(&self) -> Option<Source> {
        Claim::source(self)
    }
    fn derivation(&self) -> &str {
        Claim::derivation(self)
    }
    fn clauses(&self) -> Vec<String> {
        Claim::clauses(self)
    }
    fn reading(&self) -> Option<String> {
        Claim::reading(self)
    }
    fn correction(&self) -> Option<Repair<()>> {
        let Repair { fault, statement, clauses, .. } = self.repair()?;
        Some(Repair { fault, statement, clauses, variant: () })
    }
    fn alterations(&self) -> Vec<&'static str> {
        self.controls().into_iter().map(|control| control.what).collect()
    }
    fn examine(&self, form: Form, run: &mut Run) -> Result<Outcome, CheckError> {
        let variant = match form {
            Form::Printed => Some(self.printed()),
            Form::Corrected => self.repair().map(|repair| repair.variant),
            Form::Control(k) => self.controls().into_iter().nth(k).map(|control| control.variant),
        };
        let variant = variant.ok_or_else(|| CheckError::Other("the claim has no such form".to_string()))?;
        Claim::examine(self, &variant, run)
    }
}
