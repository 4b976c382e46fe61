//! What the ledger says about one claim; the JSON of `verify --json`.

use super::Fault;
use arithmetic::{ArithmeticError, Interval, RealCyclotomic, decimals};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// The verdict on a claim as printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The printed claim holds.
    Holds,
    /// It fails only where a hypothesis is missing that the paper does not state; true with it.
    NeedsHypothesis,
    /// It fails as printed; the intended text is evident, or a wrong step does not touch the use made of it.
    Misprint,
    /// The mathematics is wrong: a counterexample within the paper's own hypotheses and standing conventions.
    False,
    /// Neither could be established.
    Undecided,
    /// There is nothing that could be checked.
    NotCheckable,
}

impl Verdict {
    /// All verdicts, in the order of a summary.
    pub const ALL: [Verdict; 6] = [
        Verdict::Holds,
        Verdict::NeedsHypothesis,
        Verdict::Misprint,
        Verdict::False,
        Verdict::Undecided,
        Verdict::NotCheckable,
    ];

    /// The word used in the ledger.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::NeedsHypothesis => "needs_hypothesis",
            Verdict::Misprint => "misprint",
            Verdict::False => "false",
            Verdict::Undecided => "undecided",
            Verdict::NotCheckable => "not_checkable",
        }
    }
}

/// Grades of evidence, strongest first; `notes/guarantees.md` says what each promises.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Grade {
    /// Stated and proved in Coq for all parameters.
    Kernel,
    /// Exact identity of rational functions, tested at random points with an error bound.
    Identity,
    /// Every case of a finite family.
    Exhaustive,
    /// Interval enclosures that imply the statement, for a box of parameters or an instance.
    Certified,
    /// A proof on paper in notes/, with its computed checks beside it.
    Argued,
    /// Exact arithmetic on named instances; also a counterexample.
    Exact,
    /// Floating-point run with a derived tolerance.
    Simulated,
    /// Property test.
    Fuzzed,
    /// Internal consistency of the text only.
    Text,
}

impl Grade {
    /// All grades, strongest first.
    pub const ALL: [Grade; 9] = [
        Grade::Kernel,
        Grade::Identity,
        Grade::Exhaustive,
        Grade::Certified,
        Grade::Argued,
        Grade::Exact,
        Grade::Simulated,
        Grade::Fuzzed,
        Grade::Text,
    ];

    /// The word used in the ledger.
    pub fn word(self) -> &'static str {
        match self {
            Grade::Kernel => "kernel",
            Grade::Identity => "identity",
            Grade::Exhaustive => "exhaustive",
            Grade::Certified => "certified",
            Grade::Argued => "argued",
            Grade::Exact => "exact",
            Grade::Simulated => "simulated",
            Grade::Fuzzed => "fuzzed",
            Grade::Text => "text",
        }
    }
}

/// How far a piece of evidence reaches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Scope {
    /// All parameters of its clauses.
    All,
    /// Some of them.
    Instances,
}

/// One piece of evidence for a stated part of a claim.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Evidence {
    /// Its grade.
    pub grade: Grade,
    /// The clauses that it bears on, counted from 1.
    pub clauses: Vec<usize>,
    /// How far it reaches; nothing for the text against itself.
    pub scope: Option<Scope>,
    /// The part of the claim it supports.
    pub part: String,
    /// What was done.
    pub detail: String,
    /// Number of cases, where cases were counted.
    pub cases: Option<u64>,
    /// `2^-k`, for identities.
    pub error_bound: Option<String>,
}

impl Evidence {
    /// Evidence on instances, without a count or bound. It bears on the only clause of a statement that has one; for others
    /// see [`Evidence::on`].
    pub fn new(grade: Grade, part: impl Into<String>, detail: impl Into<String>) -> Self {
        let scope = (grade != Grade::Text).then_some(Scope::Instances);
        Evidence {
            grade,
            clauses: Vec::new(),
            scope,
            part: part.into(),
            detail: detail.into(),
            cases: None,
            error_bound: None,
        }
    }

    /// A proof on paper for all parameters; `place` names the note and its steps.
    pub fn argued(part: impl Into<String>, place: impl Into<String>) -> Self {
        Evidence::new(Grade::Argued, part, place).for_all()
    }

    /// The same for these clauses, counted from 1.
    pub fn on(mut self, clauses: impl Into<Vec<usize>>) -> Self {
        self.clauses = clauses.into();
        self
    }

    /// The same for all parameters of its clauses. To be said only where the evidence would change if the clause were false for any of them.
    pub fn for_all(mut self) -> Self {
        self.scope = Some(Scope::All);
        self
    }

    /// The same with a number of cases.
    pub fn cases(mut self, cases: usize) -> Self {
        self.cases = Some(cases as u64);
        self
    }

    /// The same with an error bound of `2^-bits`.
    pub fn error_bits(mut self, bits: u64) -> Self {
        self.error_bound = Some(format!("2^-{bits}"));
        self
    }
}

/// What became of the negative controls.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Controls {
    /// How many the check refuted.
    pub refuted: usize,
    /// How many there are.
    pub total: usize,
    /// What each alters.
    pub what: Vec<String>,
    /// Where each failed, in the same order; for one that was not refuted, what happened instead.
    pub failed: Vec<String>,
}

/// The entry of one claim.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Entry {
    /// The id.
    pub id: String,
    /// The first part of the id.
    pub paper: String,
    /// Where the claim stands.
    pub place: String,
    /// The claim as printed.
    pub statement: String,
    /// The sentences of the statement that can be true or false alone; those of a correction follow, marked as such.
    pub clauses: Vec<String>,
    /// How the statement is read, where that is a choice.
    pub reading: Option<String>,
    /// The verdict.
    pub verdict: Verdict,
    /// What is wrong with a statement that fails.
    pub fault: Option<Fault>,
    /// The corrected statement, itself checked.
    pub corrected: Option<String>,
    /// Where the printed claim fails.
    pub counterexample: Option<String>,
    /// The evidence.
    pub evidence: Vec<Evidence>,
    /// The negative controls.
    pub controls: Controls,
    /// Named exact or enclosed numbers.
    pub values: BTreeMap<String, String>,
    /// The reason of `undecided` and `not_checkable`.
    pub why: Option<String>,
    /// Wall time of the check; 0 where a document does not say.
    #[serde(default)]
    pub seconds: f64,
    /// Controls that the check did not refute, with what happened.
    #[serde(skip)]
    pub surviving_controls: Vec<String>,
    /// The argument in words.
    #[serde(skip)]
    pub derivation: String,
}

impl Entry {
    /// The distinct grades, strongest first.
    pub fn grades(&self) -> Vec<Grade> {
        let mut grades: Vec<Grade> = self.evidence.iter().map(|e| e.grade).collect();
        grades.sort();
        grades.dedup();
        grades
    }

    /// The clauses that evidence covers, or covers for all parameters. What evidence names beyond them is no clause.
    pub fn covered(&self, for_all: bool) -> BTreeSet<usize> {
        let counts = |e: &&Evidence| e.scope.is_some() && (!for_all || e.scope == Some(Scope::All));
        let clauses = 1..=self.clauses.len();
        let named = self.evidence.iter().filter(counts).flat_map(|e| e.clauses.iter().copied());
        named.filter(|k| clauses.contains(k)).collect()
    }

    /// How many clauses are covered for all parameters, of how many.
    pub fn reach(&self) -> (usize, usize) {
        (self.covered(true).len(), self.clauses.len())
    }
}

/// An enclosure as a value of the ledger: `[lo, hi]` with `digits` significant digits, rounded outward.
pub fn interval_value(x: &Interval, digits: u32) -> String {
    let (lo, hi) = decimals(x, digits);
    format!("[{lo}, {hi}]")
}

/// A number of a real cyclotomic field as a value of the ledger: exactly where it is rational, otherwise enclosed to 12 digits.
///
/// # Errors
/// [`ArithmeticError`] where it cannot be enclosed.
pub fn exact_value(x: &RealCyclotomic) -> Result<String, ArithmeticError> {
    Ok(match x.rational_value() {
        Some(q) => q.to_string(),
        None => interval_value(&x.enclose(80)?, 12),
    })
}
