//! From the outcomes of a check to a verdict.

use super::correction::correction_id;
use super::{CheckError, Claim, Control, Controls, Entry, Evidence, Fault, Outcome, Repair, Run, Source, Verdict};
use std::time::Instant;

/// What the printed statement and its correction come to.
struct Ruling {
    verdict: Verdict,
    evidence: Vec<Evidence>,
    counterexample: Option<String>,
    corrected: Option<String>,
    why: Option<String>,
}

impl Ruling {
    fn undecided(why: impl Into<String>) -> Self {
        Ruling {
            verdict: Verdict::Undecided,
            evidence: Vec::new(),
            counterexample: None,
            corrected: None,
            why: Some(why.into()),
        }
    }
}

/// What is asked of the check of a claim: the statement to rule on and the altered ones that it must refute.
struct Question<V> {
    id: String,
    statement: V,
    repair: Option<Repair<V>>,
    controls: Vec<Control<V>>,
    derivation: String,
}

/// Examines the printed statement, the correction where the printed one fails, and every control.
///
/// - printed holds: `holds`;
/// - printed fails, the correction holds: `misprint` or `false`, as the claim says;
/// - printed fails and there is no correction: `false`;
/// - printed fails but the correction does not hold either, or nothing is established: `undecided`.
///
/// Checked Coq theorems join the evidence; one that contradicts the verdict makes it `undecided`.
pub fn judge<C: Claim>(claim: &C, source: &Source, run: &mut Run) -> Entry {
    let question = Question {
        id: Claim::id(claim).to_string(),
        statement: claim.printed(),
        repair: claim.repair(),
        controls: claim.controls(),
        derivation: claim.derivation().to_string(),
    };
    answer(claim, question, source, run)
}

/// The same for the correction as a statement of its own (a claim without one is judged as printed): besides the controls
/// of the claim, the check must refute the printed statement.
pub(super) fn judge_correction<C: Claim>(claim: &C, source: &Source, run: &mut Run) -> Entry {
    let Some(repair) = claim.repair() else { return judge(claim, source, run) };
    let of = Claim::id(claim);
    let fault = match repair.fault {
        Fault::Misprint => "is misprinted",
        Fault::False => "is false as printed",
    };
    let mut controls = claim.controls();
    controls.push(Control::new("as printed", claim.printed()));
    let question = Question {
        id: correction_id(of),
        statement: repair.variant,
        repair: None,
        controls,
        derivation: format!("{of} {fault} (`explain {of}` has its counterexample). {}", claim.derivation()),
    };
    answer(claim, question, source, run)
}

fn answer<C: Claim>(claim: &C, question: Question<C::Variant>, source: &Source, run: &mut Run) -> Entry {
    let started = Instant::now();
    let mut ruling = match claim.examine(&question.statement, run) {
        Err(error) => Ruling::undecided(error.to_string()),
        Ok(Outcome::Undecided(why)) => Ruling::undecided(why),
        Ok(Outcome::NotCheckable(why, evidence)) => {
            Ruling { verdict: Verdict::NotCheckable, evidence, ..Ruling::undecided(why) }
        }
        Ok(Outcome::Holds(evidence)) if evidence.is_empty() => Ruling::undecided("the check gave no evidence"),
        Ok(Outcome::Holds(evidence)) => {
            Ruling { verdict: Verdict::Holds, evidence, counterexample: None, corrected: None, why: None }
        }
        Ok(Outcome::Fails { counterexample, evidence }) => {
            refuted(claim, question.repair, (counterexample, evidence), run)
        }
    };
    match super::proofs::evidence(&question.id, ruling.verdict) {
        Ok(proofs) => ruling.evidence.extend(proofs),
        Err(contradiction) => ruling = Ruling::undecided(contradiction),
    }
    let values = run.take_values();
    let (controls, surviving_controls) = run_controls(claim, question.controls, run);
    Entry {
        paper: question.id.split('.').next().unwrap_or_default().to_string(),
        id: question.id,
        place: source.place.clone(),
        statement: source.statement.clone(),
        verdict: ruling.verdict,
        corrected: ruling.corrected,
        counterexample: ruling.counterexample,
        evidence: ruling.evidence,
        controls,
        values,
        why: ruling.why,
        seconds: started.elapsed().as_secs_f64(),
        surviving_controls,
        derivation: question.derivation,
    }
}

fn refuted<C: Claim>(
    claim: &C,
    repair: Option<Repair<C::Variant>>,
    (counterexample, mut evidence): (String, Vec<Evidence>),
    run: &mut Run,
) -> Ruling {
    let Some(repair) = repair else {
        return Ruling {
            verdict: Verdict::False,
            evidence,
            counterexample: Some(counterexample),
            corrected: None,
            why: None,
        };
    };
    let problem = match claim.examine(&repair.variant, run) {
        Ok(Outcome::Holds(support)) if !support.is_empty() => {
            evidence.extend(support.into_iter().map(|e| Evidence { part: format!("corrected: {}", e.part), ..e }));
            return Ruling {
                verdict: match repair.fault {
                    Fault::Misprint => Verdict::Misprint,
                    Fault::False => Verdict::False,
                },
                evidence,
                counterexample: Some(counterexample),
                corrected: Some(repair.statement),
                why: None,
            };
        }
        Ok(Outcome::Fails { counterexample, .. }) => format!("the correction fails too: {counterexample}"),
        Ok(Outcome::Undecided(why) | Outcome::NotCheckable(why, _)) => format!("the correction is undecided: {why}"),
        Ok(Outcome::Holds(_)) => "the check of the correction gave no evidence".to_string(),
        Err(error) => format!("the correction could not be checked: {error}"),
    };
    Ruling { counterexample: Some(counterexample), ..Ruling::undecided(problem) }
}

fn run_controls<C: Claim>(claim: &C, controls: Vec<Control<C::Variant>>, run: &mut Run) -> (Controls, Vec<String>) {
    let total = controls.len();
    let mut surviving = Vec::new();
    for control in controls {
        let what = match claim.examine(&control.variant, run) {
            Ok(Outcome::Fails { .. }) => continue,
            Ok(Outcome::Holds(_)) => "it holds".to_string(),
            Ok(Outcome::Undecided(why) | Outcome::NotCheckable(why, _)) => why,
            Err(CheckError::OutOfTime) => "the time limit was reached".to_string(),
            Err(error) => error.to_string(),
        };
        surviving.push(format!("{}: {what}", control.what));
    }
    run.take_values();
    (Controls { refuted: total - surviving.len(), total }, surviving)
}
