//! What the ledger says about one claim; the JSON of `verify --json`.

use arithmetic::{Interval, decimals};
use serde::Serialize;
use std::collections::BTreeMap;

/// The verdict on a claim as printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The printed claim holds.
    Holds,
    /// The printed form fails, an evident correction holds.
    Misprint,
    /// The printed claim fails.
    False,
    /// Neither could be established.
    Undecided,
    /// There is nothing that could be checked.
    NotCheckable,
}

impl Verdict {
    /// The word used in the ledger.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::Misprint => "misprint",
            Verdict::False => "false",
            Verdict::Undecided => "undecided",
            Verdict::NotCheckable => "not_checkable",
        }
    }
}

/// Grades of evidence, strongest first; `notes/guarantees.md` says what each promises.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Grade {
    /// Stated and proved in Coq for all parameters.
    Kernel,
    /// Exact identity of rational functions, tested at random points with an error bound.
    Identity,
    /// Exact arithmetic on the concrete instance.
    Exact,
    /// Every case up to a stated size.
    Exhaustive,
    /// Interval enclosures that imply the statement.
    Certified,
    /// Floating-point run with a derived tolerance.
    Simulated,
    /// Property test.
    Fuzzed,
    /// Internal consistency of the text only.
    Text,
}

impl Grade {
    /// The word used in the ledger.
    pub fn word(self) -> &'static str {
        match self {
            Grade::Kernel => "kernel",
            Grade::Identity => "identity",
            Grade::Exact => "exact",
            Grade::Exhaustive => "exhaustive",
            Grade::Certified => "certified",
            Grade::Simulated => "simulated",
            Grade::Fuzzed => "fuzzed",
            Grade::Text => "text",
        }
    }
}

/// One piece of evidence for a stated part of a claim.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Evidence {
    /// Its grade.
    pub grade: Grade,
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
    /// Evidence without a count or bound.
    pub fn new(grade: Grade, part: impl Into<String>, detail: impl Into<String>) -> Self {
        Evidence { grade, part: part.into(), detail: detail.into(), cases: None, error_bound: None }
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

/// How many negative controls were refuted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Controls {
    /// Refuted by the check.
    pub refuted: usize,
    /// All there are.
    pub total: usize,
}

/// The entry of one claim.
#[derive(Debug, Clone, Serialize)]
pub struct Entry {
    /// The id.
    pub id: String,
    /// The first part of the id.
    pub paper: String,
    /// Where the claim stands.
    pub place: String,
    /// The claim as printed.
    pub statement: String,
    /// The verdict.
    pub verdict: Verdict,
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
    /// Wall time of the check.
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
}

/// An enclosure as a value of the ledger: `[lo, hi]` with `digits` significant digits, rounded outward.
pub fn interval_value(x: &Interval, digits: u32) -> String {
    let (lo, hi) = decimals(x, digits);
    format!("[{lo}, {hi}]")
}
