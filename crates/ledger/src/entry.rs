//! What the ledger says about one claim; the JSON of `verify --json`.

use super::{Evidence, Fault, Grade, Scope, Verdict, Witness};
use arithmetic::{ArithmeticError, Interval, RealCyclotomic, decimals};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

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
    /// The verdict on each clause ([`Entry::verdicts_by_clause`]); nothing where it has none of its own.
    #[serde(default)]
    pub clause_verdicts: Vec<Option<Verdict>>,
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
    /// What is in the counterexample, with its numbers.
    #[serde(default)]
    pub witnesses: Vec<Witness>,
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
