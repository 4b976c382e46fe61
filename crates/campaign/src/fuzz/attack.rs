//! Campaigns over a question of one's own: random members of its family first, then the worst one of a job is made worse, and a counterexample
//! simpler.

use super::campaign::{FuzzError, MOST_CASES};
use crate::VERSION;
use crate::draws::{Draws, shrunk};
use crate::job::{Campaign, JobError};
use arithmetic::Progress;
use question::{Bindings, Decided, Question, QuestionError, Truth};
use serde_json::{Value, json};

/// Cases of one job.
const BLOCK: u64 = 64;

/// Steps that are tried to make the worst case of a job worse.
const MOST_STEPS: usize = 120;

/// Trials to make a counterexample simpler.
const MOST_TRIALS: usize = 600;

/// So many random members of the family of a question.
pub struct Attack {
    question: Question,
    cases: u64,
    seed: String,
}

/// What a list of draws gives.
enum Found {
    /// No member, or one that `where` leaves out.
    None,
    /// A member, decided.
    Member(Bindings, Box<Decided>),
}

impl Attack {
    /// Attacks a question that has a property.
    ///
    /// # Errors
    /// [`FuzzError`].
    pub fn new(question: Question, cases: u64, seed: &str) -> Result<Self, FuzzError> {
        if !(1..=MOST_CASES).contains(&cases) {
            return Err(FuzzError::Cases(cases));
        }
        if !question.has_property() {
            return Err(FuzzError::NoProperty(question.values_place()));
        }
        Ok(Attack { question, cases, seed: seed.to_string() })
    }

    /// The id of its question.
    pub fn id(&self) -> &str {
        self.question.id()
    }

    /// Its seed.
    pub fn seed(&self) -> &str {
        &self.seed
    }

    /// The id and the seed of the attack with this canonical text.
    pub fn named(canonical: &str) -> Option<(String, String)> {
        let value: Value = serde_json::from_str(canonical).ok()?;
        let attack = &value["attack"];
        Some((attack["id"].as_str()?.to_string(), attack["seed"].as_str()?.to_string()))
    }

    fn found(&self, draws: &mut Draws, progress: &dyn Progress) -> Result<Found, QuestionError> {
        let Some(member) = self.question.member(&mut |bound| draws.below(bound), progress)? else {
            return Ok(Found::None);
        };
        let decided = self.question.decide(&member, progress)?;
        Ok(if decided.excluded { Found::None } else { Found::Member(member, Box::new(decided)) })
    }

    /// The upper bound of the margin of a list of draws; none where it is no member or cannot be decided.
    fn margin(&self, list: &[u64], progress: &dyn Progress) -> Option<(f64, bool)> {
        match self.found(&mut Draws::given(list), progress) {
            Ok(Found::Member(_, decided)) => Some((decided.margin.hi, decided.truth == Truth::False)),
            _ => None,
        }
    }

    /// Steps along single draws as long as the margin becomes smaller.
    fn worsened(&self, start: &[u64], margin: f64, progress: &dyn Progress) -> (Vec<u64>, f64) {
        let (mut worst, mut least, mut left) = (start.to_vec(), margin, MOST_STEPS);
        loop {
            let before = least;
            for k in 0..worst.len() {
                for step in [1, -1, 16, -16, 1024, -1024, 1 << 16, -(1 << 16)] {
                    let Some(value) = worst[k].checked_add_signed(step).filter(|_| left > 0) else { continue };
                    if progress.is_cancelled() {
                        return (worst, least);
                    }
                    left -= 1;
                    let mut trial = worst.clone();
                    trial[k] = value;
                    if let Some((margin, _)) = self.margin(&trial, progress).filter(|(margin, _)| *margin < least) {
                        (worst, least) = (trial, margin);
                    }
                }
            }
            if left == 0 || least >= before {
                return (worst, least);
            }
        }
    }

    /// A counterexample after it was made simpler.
    fn failure(&self, case: u64, taken: &[u64], progress: &dyn Progress) -> Result<Value, JobError> {
        let fails = |list: &[u64]| self.margin(list, progress).is_some_and(|(_, fails)| fails);
        let simplest = shrunk(taken, MOST_TRIALS, fails);
        progress.checkpoint()?;
        let Found::Member(member, _) = self.found(&mut Draws::given(&simplest), progress).map_err(refused)? else {
            return Err(JobError::Refused("a counterexample is no member of the family any more".to_string()));
        };
        let question = self.question.instance(&member, progress).map_err(refused)?;
        Ok(json!({
            "case": case, "draws": simplest, "why": "the property fails, confirmed on exact or enclosed numbers",
            "instance": member.to_string(), "question": question
        }))
    }
}

fn refused(error: QuestionError) -> JobError {
    match error {
        QuestionError::Cancelled(cancelled) => JobError::Cancelled(cancelled),
        other => JobError::Refused(other.to_string()),
    }
}

/// Lowers the smallest margins of the inequalities, one by one, to those of a case.
fn lowered(each: &mut [Option<(f64, u64)>], decided: &Decided, case: u64) {
    for (least, own) in each.iter_mut().zip(&decided.inequalities) {
        if own.hi.is_finite() && least.is_none_or(|(least, _)| own.hi < least) {
            *least = Some((own.hi, case));
        }
    }
}

impl Campaign for Attack {
    fn canonical(&self) -> String {
        let question = self.question.canonical();
        json!({"attack": {"id": self.id(), "cases": self.cases, "seed": self.seed, "question": question}}).to_string()
    }

    fn cases(&self) -> u64 {
        self.cases.div_ceil(BLOCK)
    }

    /// As the jobs of [`Fuzz`](super::Fuzz), with the counterexamples as questions, and for each control whether a case refuted it.
    fn run(&self, job: u64, progress: &dyn Progress) -> Result<Value, JobError> {
        let first = job * BLOCK;
        let cases = BLOCK.min(self.cases - first);
        let stream = format!("attack seed {} {}", self.seed, self.question.canonical());
        let (mut undecided, mut why, mut failed, mut failures) = (0u64, None, 0u64, Vec::new());
        let mut worst: Option<(f64, u64, Vec<u64>)> = None;
        let mut controls = vec![false; self.question.control_count()];
        let texts = self.question.inequality_texts();
        let mut each: Vec<Option<(f64, u64)>> = vec![None; texts.len()];
        for case in first..first + cases {
            progress.checkpoint()?;
            let mut draws = Draws::random(VERSION, &stream, case);
            let Found::Member(member, decided) = self.found(&mut draws, progress).map_err(refused)? else { continue };
            for (control, is_refuted) in controls.iter_mut().enumerate().filter(|(_, is_refuted)| !**is_refuted) {
                *is_refuted = self.question.refutes(control, &member, progress).map_err(refused)?;
            }
            lowered(&mut each, &decided, case);
            let margin = decided.margin.hi;
            if margin.is_finite() && worst.as_ref().is_none_or(|(least, ..)| margin < *least) {
                worst = Some((margin, case, draws.taken().to_vec()));
            }
            match decided.truth {
                Truth::True => {}
                Truth::Unknown(doubt) => {
                    undecided += 1;
                    why.get_or_insert(doubt.why);
                }
                Truth::False => {
                    failed += 1;
                    if failures.is_empty() {
                        failures.push(self.failure(case, draws.taken(), progress)?);
                    }
                }
            }
        }
        if let Some((margin, case, taken)) = &mut worst
            && failed == 0
        {
            let (worse, least) = self.worsened(taken, *margin, progress);
            progress.checkpoint()?;
            *margin = least;
            if let Found::Member(_, decided) = self.found(&mut Draws::given(&worse), progress).map_err(refused)? {
                lowered(&mut each, &decided, *case);
                if decided.truth == Truth::False {
                    failed += 1;
                    failures.push(self.failure(*case, &worse, progress)?);
                }
            }
        }
        let margin = worst.map(|(value, case, _)| json!({"value": format!("~{value:?}"), "case": case}));
        let own = |(text, least): (&String, &Option<(f64, u64)>)| {
            let margin = least.map(|(value, case)| json!({"value": format!("~{value:?}"), "case": case}));
            json!({"inequality": text, "margin": margin})
        };
        let inequalities: Vec<Value> = texts.iter().zip(&each).map(own).collect();
        Ok(json!({
            "invariant": self.id(), "first": first, "cases": cases, "undecided": undecided, "why": why,
            "margin": margin, "inequalities": inequalities, "failed": failed, "failures": failures, "controls": controls
        }))
    }
}
