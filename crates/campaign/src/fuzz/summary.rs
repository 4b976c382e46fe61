//! What a campaign found, from the results of its jobs.

use crate::VERSION;
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// Failures of one invariant that a summary tells.
const MOST_TOLD: usize = 3;

/// A failure, made simpler.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Failed {
    /// The case in which it was found.
    pub case: u64,
    /// The draws of the simpler case.
    pub draws: Vec<u64>,
    /// What is wrong.
    pub why: String,
    /// The simpler case.
    pub instance: String,
    /// The simpler case as a question of its own, where it is one.
    pub question: Option<String>,
}

/// The smallest margin of an inequality.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Smallest {
    /// The margin, rounded.
    pub value: f64,
    /// The first case that has it.
    pub case: u64,
}

impl Smallest {
    /// Lowers the smallest margin so far to that of a row, where it has one; the first case with it stays.
    fn lower(least: &mut Option<Smallest>, margin: &Value) -> Option<()> {
        if !margin.is_null() {
            let value: f64 = margin["value"].as_str()?.strip_prefix('~')?.parse().ok()?;
            if least.is_none_or(|least| value < least.value) {
                *least = Some(Smallest { value, case: margin["case"].as_u64()? });
            }
        }
        Some(())
    }
}

/// What was found about one invariant.
#[derive(Debug, Clone, PartialEq)]
pub struct InvariantSummary {
    /// Its name.
    pub id: String,
    /// Cases that were tried.
    pub cases: u64,
    /// Cases that could not be decided.
    pub undecided: u64,
    /// Why the first of these could not.
    pub why: Option<String>,
    /// The smallest margin, where it is an inequality.
    pub margin: Option<Smallest>,
    /// The same of each inequality of a question by itself; empty for the invariants.
    pub inequalities: Vec<(String, Option<Smallest>)>,
    /// Cases that fail.
    pub failed: u64,
    /// The first of them.
    pub failures: Vec<Failed>,
    /// For each control of a question whether some case refuted it; empty for the invariants, whose altered computations are refuted in the tests.
    pub controls: Vec<bool>,
}

/// What a campaign found.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// Its seed.
    pub seed: String,
    /// Jobs that are missing.
    pub missing: u64,
    /// By invariant, in the order of the table.
    pub invariants: Vec<InvariantSummary>,
}

/// Results that no job gives.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SummaryError {
    /// A row of another form.
    #[error("the result of job {0} is not one of `fuzz`")]
    Row(u64),
}

impl Summary {
    /// From the results by job, of the invariants or the question with these names.
    ///
    /// # Errors
    /// [`SummaryError`].
    pub fn new(names: &[&str], seed: &str, jobs: u64, rows: &BTreeMap<u64, Value>) -> Result<Self, SummaryError> {
        let mut invariants: Vec<InvariantSummary> = names
            .iter()
            .map(|name| InvariantSummary {
                id: name.to_string(),
                cases: 0,
                undecided: 0,
                why: None,
                margin: None,
                inequalities: Vec::new(),
                failed: 0,
                failures: Vec::new(),
                controls: Vec::new(),
            })
            .collect();
        for (job, row) in rows {
            let own = invariants.iter_mut().find(|own| row["invariant"] == own.id);
            own.and_then(|own| own.add(row)).ok_or(SummaryError::Row(*job))?;
        }
        Ok(Summary { seed: seed.to_string(), missing: jobs - rows.len() as u64, invariants })
    }

    /// Cases of all invariants.
    pub fn cases(&self) -> u64 {
        self.invariants.iter().map(|own| own.cases).sum()
    }

    /// Cases that fail.
    pub fn failed(&self) -> u64 {
        self.invariants.iter().map(|own| own.failed).sum()
    }

    /// Whether every control of a question was refuted by some case.
    pub fn controls_bite(&self) -> bool {
        self.invariants.iter().flat_map(|own| &own.controls).all(|refuted| *refuted)
    }

    /// `{"schema": "flockproof.fuzz/1", "version", "seed", "cases", "failed", "undecided", "invariants": [..]}`.
    pub fn to_json(&self) -> Value {
        let failure = |failed: &Failed| json!({"case": failed.case, "draws": failed.draws, "why": failed.why, "instance": failed.instance});
        let smallest =
            |margin: Option<Smallest>| margin.map(|m| json!({"value": format!("~{:?}", m.value), "case": m.case}));
        let invariant = |own: &InvariantSummary| {
            let mut value = json!({
                "id": own.id, "cases": own.cases, "undecided": own.undecided, "why": own.why,
                "margin": smallest(own.margin),
                "failed": own.failed, "failures": own.failures.iter().map(failure).collect::<Vec<_>>()
            });
            if !own.inequalities.is_empty() {
                let each = own.inequalities.iter();
                let each = each.map(|(text, margin)| json!({"inequality": text, "margin": smallest(*margin)}));
                value["inequalities"] = each.collect();
            }
            if !own.controls.is_empty() {
                value["controls"] = json!({"refuted": own.refuted(), "total": own.controls.len()});
            }
            value
        };
        let undecided: u64 = self.invariants.iter().map(|own| own.undecided).sum();
        json!({
            "schema": "flockproof.fuzz/1", "version": VERSION, "seed": self.seed, "cases": self.cases(),
            "failed": self.failed(), "undecided": undecided, "missing_jobs": self.missing,
            "invariants": self.invariants.iter().map(invariant).collect::<Vec<_>>()
        })
    }
}

impl InvariantSummary {
    /// Controls that some case refuted.
    pub fn refuted(&self) -> usize {
        self.controls.iter().filter(|refuted| **refuted).count()
    }

    /// Adds a job; jobs come in order.
    fn add(&mut self, row: &Value) -> Option<()> {
        self.cases += row["cases"].as_u64()?;
        self.undecided += row["undecided"].as_u64()?;
        self.failed += row["failed"].as_u64()?;
        if self.why.is_none() {
            self.why = row["why"].as_str().map(str::to_string);
        }
        for (k, refuted) in row["controls"].as_array().into_iter().flatten().enumerate() {
            if self.controls.len() <= k {
                self.controls.push(false);
            }
            self.controls[k] |= refuted.as_bool()?;
        }
        Smallest::lower(&mut self.margin, &row["margin"])?;
        for (k, own) in row["inequalities"].as_array().into_iter().flatten().enumerate() {
            let text = own["inequality"].as_str()?;
            if self.inequalities.len() <= k {
                self.inequalities.push((text.to_string(), None));
            }
            let (known, least) = self.inequalities.get_mut(k)?;
            if known != text {
                return None;
            }
            Smallest::lower(least, &own["margin"])?;
        }
        for failure in row["failures"].as_array()? {
            let draws: Vec<u64> = failure["draws"].as_array()?.iter().map(Value::as_u64).collect::<Option<_>>()?;
            // Different cases often become the same one when they are made simpler.
            if self.failures.len() < MOST_TOLD && self.failures.iter().all(|known| known.draws != draws) {
                self.failures.push(Failed {
                    case: failure["case"].as_u64()?,
                    draws,
                    why: failure["why"].as_str()?.to_string(),
                    instance: failure["instance"].as_str()?.to_string(),
                    question: failure["question"].as_str().map(str::to_string),
                });
            }
        }
        Some(())
    }
}
