//! Which cases a campaign has and what a job of it gives.

use crate::VERSION;
use crate::draws::{Draws, shrunk};
use crate::invariants::{Checked, Invariant, Stop, Tested, decide, find, table};
use crate::job::{Campaign, JobError};
use arithmetic::{Cancelled, Progress};
use question::nearest_ids;
use serde_json::{Value, json};

/// Most cases of one invariant.
pub const MOST_CASES: u64 = 1 << 50;

/// Trials to make a failure simpler.
const MOST_TRIALS: usize = 2000;

/// Failures of one job that are written out; all are counted.
const MOST_FAILURES: usize = 2;

/// Why there is no such campaign.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum FuzzError {
    /// No invariant of this name.
    #[error("there is no invariant `{0}`{1}; `fuzz --list` names all")]
    Unknown(String, String),
    /// No cases, or too many.
    #[error("the number of cases should be from 1 to 2^50, not {0}")]
    Cases(u64),
    /// A question that only tabulates.
    #[error("{0}: the question has no property to attack, only values")]
    NoProperty(question::Place),
    /// A text that is not the canonical text of such a campaign.
    #[error("it is not a campaign over built-in invariants")]
    NoFuzz,
}

/// So many random cases of some invariants.
pub struct Fuzz {
    invariants: Vec<&'static Invariant>,
    cases: u64,
    seed: String,
}

impl Fuzz {
    /// A campaign over the invariants named, or over all of them; `cases` of each.
    ///
    /// # Errors
    /// [`FuzzError`].
    pub fn new(names: &[String], cases: u64, seed: &str) -> Result<Self, FuzzError> {
        if !(1..=MOST_CASES).contains(&cases) {
            return Err(FuzzError::Cases(cases));
        }
        if let Some(unknown) = names.iter().find(|name| find(name).is_none()) {
            return Err(FuzzError::Unknown(unknown.clone(), nearest(unknown)));
        }
        let asked = |invariant: &&Invariant| names.is_empty() || names.iter().any(|name| name == invariant.id);
        Ok(Fuzz { invariants: table().filter(asked).collect(), cases, seed: seed.to_string() })
    }

    /// The campaign with this canonical text.
    ///
    /// # Errors
    /// [`FuzzError::NoFuzz`] and those of [`Fuzz::new`].
    pub fn read(canonical: &str) -> Result<Self, FuzzError> {
        let value: Value = serde_json::from_str(canonical).map_err(|_| FuzzError::NoFuzz)?;
        let fuzz = &value["fuzz"];
        let (Some(names), Some(cases), Some(seed)) =
            (fuzz["invariants"].as_array(), fuzz["cases"].as_u64(), fuzz["seed"].as_str())
        else {
            return Err(FuzzError::NoFuzz);
        };
        let names: Vec<String> = names.iter().filter_map(Value::as_str).map(str::to_string).collect();
        Fuzz::new(&names, cases, seed)
    }

    /// Its invariants.
    pub fn invariants(&self) -> &[&'static Invariant] {
        &self.invariants
    }

    /// Their names.
    pub fn names(&self) -> Vec<&'static str> {
        self.invariants.iter().map(|invariant| invariant.id).collect()
    }

    /// Its seed.
    pub fn seed(&self) -> &str {
        &self.seed
    }

    /// The invariant of a job and the first of its cases.
    fn job(&self, mut job: u64) -> Option<(&'static Invariant, u64)> {
        for invariant in &self.invariants {
            let jobs = self.cases.div_ceil(invariant.block);
            if job < jobs {
                return Some((invariant, job * invariant.block));
            }
            job -= jobs;
        }
        None
    }
}

/// The name in the table that is spelled most alike, as a question.
fn nearest(unknown: &str) -> String {
    let near = nearest_ids(table().map(|invariant| invariant.id), unknown, 1);
    near.first().map_or(String::new(), |id| format!(" (did you mean {id}?)"))
}

/// The draws of one case; they depend on the version, the invariant, the seed and the case, not on the campaign around it.
fn draws(invariant: &Invariant, seed: &str, case: u64) -> Draws {
    Draws::random(VERSION, &format!("fuzz {} seed {seed}", invariant.id), case)
}

/// Decides one case; the draws say what it was.
pub fn one_case(invariant: &Invariant, seed: &str, case: u64, tested: Tested) -> (Checked, Vec<u64>) {
    let mut draws = draws(invariant, seed, case);
    let checked = decide(invariant, &mut draws, tested);
    (checked, draws.taken().to_vec())
}

impl Campaign for Fuzz {
    fn canonical(&self) -> String {
        json!({"fuzz": {"cases": self.cases, "invariants": self.names(), "seed": self.seed}}).to_string()
    }

    fn cases(&self) -> u64 {
        self.invariants.iter().map(|invariant| self.cases.div_ceil(invariant.block)).sum()
    }

    /// `{"invariant", "first", "cases", "undecided", "why", "margin": {"value", "case"} | null, "failed", "failures": [..]}`.
    fn run(&self, job: u64, progress: &dyn Progress) -> Result<Value, JobError> {
        let Some((invariant, first)) = self.job(job) else { return Ok(Value::Null) };
        let cases = invariant.block.min(self.cases - first);
        let (mut undecided, mut why, mut failed, mut failures) = (0u64, None, 0u64, Vec::new());
        let mut margin: Option<(f64, u64)> = None;
        for case in first..first + cases {
            progress.checkpoint()?;
            let mut draws = draws(invariant, &self.seed, case);
            match decide(invariant, &mut draws, Tested::AsItIs) {
                Ok(Some(found)) if margin.is_none_or(|(least, _)| found < least) => margin = Some((found, case)),
                Ok(_) => {}
                Err(Stop::Undecided(reason)) => {
                    undecided += 1;
                    why.get_or_insert(reason);
                }
                Err(Stop::Fails { .. }) => {
                    failed += 1;
                    if failures.len() < MOST_FAILURES {
                        failures.push(failure(invariant, case, draws.taken(), progress)?);
                    }
                }
            }
        }
        let margin = margin.map(|(value, case)| json!({"value": format!("~{value:?}"), "case": case}));
        Ok(json!({
            "invariant": invariant.id, "first": first, "cases": cases, "undecided": undecided, "why": why,
            "margin": margin, "failed": failed, "failures": failures
        }))
    }
}

/// A failure after it was made simpler.
fn failure(invariant: &Invariant, case: u64, taken: &[u64], progress: &dyn Progress) -> Result<Value, Cancelled> {
    let fails = |list: &[u64]| !progress.is_cancelled() && matches!(again(invariant, list), Err(Stop::Fails { .. }));
    let simplest = shrunk(taken, MOST_TRIALS, fails);
    progress.checkpoint()?;
    let (why, instance) = match again(invariant, &simplest) {
        Err(Stop::Fails { why, instance }) => (why, instance),
        _ => ("it did not fail again".to_string(), String::new()),
    };
    Ok(json!({"case": case, "draws": simplest, "why": why, "instance": instance}))
}

fn again(invariant: &Invariant, list: &[u64]) -> Checked {
    decide(invariant, &mut Draws::given(list), Tested::AsItIs)
}
