//! From the outcomes of a check to a verdict.

use super::{CheckError, Claim, Controls, Counterexample, Entry, Evidence, Fault, Form, Outcome, Source, Verdict};
use std::collections::BTreeMap;

/// What the check said of one form, and the numbers that it recorded on the way.
#[derive(Debug)]
pub(super) struct Examined {
    pub outcome: Result<Outcome, CheckError>,
    pub values: BTreeMap<String, String>,
}

/// The id of the correction of a claim: `beyond.paley.eq21` for `paley.eq21`.
pub fn correction_id(of: &str) -> String {
    format!("beyond.{of}")
}

/// What the statement and its correction come to.
struct Ruling {
    verdict: Verdict,
    fault: Option<Fault>,
    evidence: Vec<Evidence>,
    counterexample: Option<Counterexample>,
    corrected: Option<String>,
    why: Option<String>,
}

impl Ruling {
    fn of(verdict: Verdict, evidence: Vec<Evidence>) -> Self {
        Ruling { verdict, fault: None, evidence, counterexample: None, corrected: None, why: None }
    }

    /// Notes at each piece of evidence which controls fail through it: their failure names its part.
    fn reached_by(&mut self, failures: &[Failure]) {
        // Where the printed statement is refuted, the evidence for its correction is what the controls are to reach.
        let judged = self.evidence.iter_mut().filter_map(|e| match &self.corrected {
            None => Some((e.part.clone(), e)),
            Some(_) => Some((e.part.strip_prefix(CORRECTED)?.to_string(), e)),
        });
        for (part, evidence) in judged.filter(|_| self.verdict != Verdict::False || self.corrected.is_some()) {
            let through = |part: &str| -> Vec<String> {
                failures.iter().filter(|f| f.parts.iter().any(|p| p == part)).map(|f| f.control.clone()).collect()
            };
            evidence.controls = through(&part);
            evidence.steps.iter_mut().for_each(|step| step.controls = through(&step.part));
        }
    }

    fn undecided(why: impl Into<String>) -> Self {
        Ruling { why: Some(why.into()), ..Ruling::of(Verdict::Undecided, Vec::new()) }
    }
}

/// Where the check of a negative control fails.
struct Failure {
    /// Its number, from 1; `p` for the printed form.
    control: String,
    /// The parts that fail.
    parts: Vec<String>,
}

/// Judges the printed statement of a claim, or its correction as a statement of its own.
pub(super) struct Judge<'a> {
    pub claim: &'a dyn Claim,
    pub source: &'a Source,
    /// Whether the correction is what is judged: the printed form then joins the controls.
    pub correction: bool,
    /// Runs the check on a form.
    pub examine: &'a dyn Fn(Form) -> &'a Examined,
}

impl Judge<'_> {
    /// Examines the statement, the correction where the printed one fails, and every control.
    ///
    /// - the statement holds: `holds`;
    /// - printed fails, the correction holds: `needs_hypothesis`, `misprint` or `false`, by the fault that the claim names;
    /// - printed fails and there is no correction: `false`;
    /// - printed fails but the correction does not hold either, or nothing is established: `undecided`.
    pub fn judge(&self) -> Entry {
        let mut values = BTreeMap::new();
        let statement = if self.correction { Form::Corrected } else { Form::Printed };
        let ruling = match self.outcome(statement, &mut values) {
            Err(error) => Ruling::undecided(error.to_string()),
            Ok(Outcome::Undecided(why)) => Ruling::undecided(why),
            Ok(Outcome::NotCheckable(why, evidence)) => {
                Ruling { why: Some(why.clone()), ..Ruling::of(Verdict::NotCheckable, self.placed(evidence, 0)) }
            }
            Ok(Outcome::Holds(evidence)) if evidence.is_empty() => Ruling::undecided("the check gave no evidence"),
            Ok(Outcome::Holds(evidence)) => Ruling::of(Verdict::Holds, self.placed(evidence, 0)),
            Ok(Outcome::Fails { counterexample, evidence, .. }) => {
                let against = self.placed(evidence, 0).into_iter().map(Evidence::refuting).collect();
                self.refuted(counterexample, against, &mut values)
            }
        };
        let (controls, surviving_controls, failures) = self.controls();
        let mut ruling = ruling;
        ruling.reached_by(&failures);
        let mut clauses = self.clauses();
        if ruling.corrected.is_some() {
            clauses.extend(self.corrected_clauses().into_iter().map(|clause| format!("{CORRECTED}{clause}")));
        }
        let (text, witnesses) = ruling.counterexample.map(|found| (found.text, found.witnesses)).unzip();
        let witnesses = witnesses.unwrap_or_default();
        let id = if self.correction { correction_id(self.claim.id()) } else { self.claim.id().to_string() };
        Entry {
            paper: id.split('.').next().unwrap_or_default().to_string(),
            id,
            place: self.source.place.clone(),
            statement: self.source.statement.clone(),
            clauses,
            clause_verdicts: Vec::new(),
            reading: if self.correction { None } else { self.claim.reading() },
            verdict: ruling.verdict,
            fault: ruling.fault,
            corrected: ruling.corrected,
            counterexample: text,
            witnesses,
            evidence: ruling.evidence,
            controls,
            values,
            why: ruling.why,
            seconds: 0.0,
            surviving_controls,
            derivation: self.derivation(),
        }
    }

    fn derivation(&self) -> String {
        let (of, derivation) = (self.claim.id(), self.claim.derivation());
        match self.claim.correction().filter(|_| self.correction) {
            None => derivation.to_string(),
            Some(repair) => {
                let fault = match repair.fault {
                    Fault::Hypothesis => "lacks a hypothesis",
                    Fault::Typo | Fault::Slip => "is misprinted",
                    Fault::False => "is false as printed",
                };
                format!("{of} {fault} (`explain {of}` has its counterexample). {derivation}")
            }
        }
    }

    /// The clauses of the statement that is judged.
    fn clauses(&self) -> Vec<String> {
        if self.correction {
            return self.corrected_clauses();
        }
        let clauses = self.claim.clauses();
        if clauses.is_empty() { vec![self.source.statement.clone()] } else { clauses }
    }

    fn corrected_clauses(&self) -> Vec<String> {
        match self.claim.correction() {
            Some(repair) if repair.clauses.is_empty() => vec![repair.statement],
            Some(repair) => repair.clauses,
            None => Vec::new(),
        }
    }

    /// Evidence with the numbers of its clauses in the entry, where those before are `skipped`. What names no clause bears
    /// on the only one.
    fn placed(&self, evidence: &[Evidence], skipped: usize) -> Vec<Evidence> {
        let count = if skipped == 0 { self.clauses().len() } else { self.corrected_clauses().len() };
        let place = |e: &Evidence| {
            let own = if e.clauses.is_empty() && e.scope.is_some() && count == 1 { vec![1] } else { e.clauses.clone() };
            Evidence { clauses: own.into_iter().map(|k| k + skipped).collect(), ..e.clone() }
        };
        evidence.iter().map(place).collect()
    }

    fn outcome(&self, form: Form, values: &mut BTreeMap<String, String>) -> Result<&Outcome, &CheckError> {
        let examined = (self.examine)(form);
        values.extend(examined.values.clone());
        examined.outcome.as_ref()
    }

    fn refuted(
        &self,
        counterexample: &Counterexample,
        mut evidence: Vec<Evidence>,
        values: &mut BTreeMap<String, String>,
    ) -> Ruling {
        let counterexample = Some(counterexample.clone());
        let Some(repair) = self.claim.correction().filter(|_| !self.correction) else {
            let fault = Some(Fault::False);
            return Ruling { fault, counterexample, ..Ruling::of(Verdict::False, evidence) };
        };
        let problem = match self.outcome(Form::Corrected, values) {
            Ok(Outcome::Holds(support)) if !support.is_empty() => {
                let support = self.placed(support, self.clauses().len());
                evidence.extend(support.into_iter().map(|e| Evidence { part: format!("{CORRECTED}{}", e.part), ..e }));
                let (fault, corrected) = (Some(repair.fault), Some(repair.statement));
                return Ruling { fault, counterexample, corrected, ..Ruling::of(repair.fault.verdict(), evidence) };
            }
            Ok(Outcome::Fails { counterexample, .. }) => format!("the correction fails too: {counterexample}"),
            Ok(Outcome::Undecided(why) | Outcome::NotCheckable(why, _)) => {
                format!("the correction is undecided: {why}")
            }
            Ok(Outcome::Holds(_)) => "the check of the correction gave no evidence".to_string(),
            Err(error) => format!("the correction could not be checked: {error}"),
        };
        Ruling { counterexample, ..Ruling::undecided(problem) }
    }

    /// What became of the controls, those that were not refuted, and where the others failed.
    fn controls(&self) -> (Controls, Vec<String>, Vec<Failure>) {
        let own = self.claim.alterations().into_iter().enumerate().map(|(k, what)| (what, Form::Control(k)));
        let altered = own.chain(self.correction.then_some(("as printed", Form::Printed)));
        let (mut controls, mut surviving, mut failures) = (Controls::default(), Vec::new(), Vec::new());
        // The printed form is one more where it is refuted: what holds is the correction.
        failures.extend(self.failure("p", Form::Printed));
        for (what, form) in altered {
            if let Form::Control(k) = form {
                failures.extend(self.failure(&(k + 1).to_string(), form));
            }
            let (refuted, said) = match self.outcome(form, &mut BTreeMap::new()) {
                Ok(Outcome::Fails { counterexample, .. }) => (true, counterexample.text.clone()),
                Ok(Outcome::Holds(_)) => (false, "it holds".to_string()),
                Ok(Outcome::Undecided(why) | Outcome::NotCheckable(why, _)) => (false, why.clone()),
                Err(error) => (false, error.to_string()),
            };
            controls.total += 1;
            controls.refuted += usize::from(refuted);
            if !refuted {
                surviving.push(format!("{what}: {said}"));
            }
            controls.what.push(what.to_string());
            controls.failed.push(said);
        }
        (controls, surviving, failures)
    }

    fn failure(&self, control: &str, form: Form) -> Option<Failure> {
        let parts = (self.examine)(form).outcome.as_ref().map(Outcome::failing_parts).unwrap_or_default();
        (!parts.is_empty()).then(|| Failure { control: control.to_string(), parts })
    }
}

/// What marks the clauses of a correction, and the evidence for it, in the entry of the printed statement.
pub(super) const CORRECTED: &str = "corrected: ";
