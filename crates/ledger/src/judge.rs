//! From the outcomes of a check to a verdict.

use super::{AnyClaim, CheckError, Controls, Entry, Evidence, Fault, Form, Outcome, Source, Verdict};
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
        let why = Some(why.into());
        Ruling { verdict: Verdict::Undecided, evidence: Vec::new(), counterexample: None, corrected: None, why }
    }
}

/// Judges the printed statement of a claim, or its correction as a statement of its own.
pub(super) struct Judge<'a> {
    pub claim: &'a dyn AnyClaim,
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
    /// - printed fails, the correction holds: `misprint` or `false`, as the claim says;
    /// - printed fails and there is no correction: `false`;
    /// - printed fails but the correction does not hold either, or nothing is established: `undecided`.
    pub fn judge(&self) -> Entry {
        let mut values = BTreeMap::new();
        let statement = if self.correction { Form::Corrected } else { Form::Printed };
        let ruling = match self.outcome(statement, &mut values) {
            Err(error) => Ruling::undecided(error.to_string()),
            Ok(Outcome::Undecided(why)) => Ruling::undecided(why),
            Ok(Outcome::NotCheckable(why, evidence)) => {
                let evidence = evidence.clone();
                Ruling { verdict: Verdict::NotCheckable, evidence, ..Ruling::undecided(why) }
            }
            Ok(Outcome::Holds(evidence)) if evidence.is_empty() => Ruling::undecided("the check gave no evidence"),
            Ok(Outcome::Holds(evidence)) => {
                let evidence = evidence.clone();
                Ruling { verdict: Verdict::Holds, evidence, counterexample: None, corrected: None, why: None }
            }
            Ok(Outcome::Fails { counterexample, evidence }) => {
                self.refuted(counterexample, evidence.clone(), &mut values)
            }
        };
        let (controls, surviving_controls) = self.controls();
        let id = self.id();
        Entry {
            paper: id.split('.').next().unwrap_or_default().to_string(),
            id,
            place: self.source.place.clone(),
            statement: self.source.statement.clone(),
            verdict: ruling.verdict,
            corrected: ruling.corrected,
            counterexample: ruling.counterexample,
            evidence: ruling.evidence,
            controls,
            values,
            why: ruling.why,
            seconds: 0.0,
            surviving_controls,
            derivation: self.derivation(),
        }
    }

    fn id(&self) -> String {
        if self.correction { correction_id(self.claim.id()) } else { self.claim.id().to_string() }
    }

    fn derivation(&self) -> String {
        let (of, derivation) = (self.claim.id(), self.claim.derivation());
        match self.claim.correction().filter(|_| self.correction) {
            None => derivation.to_string(),
            Some((fault, _)) => {
                let fault = match fault {
                    Fault::Misprint => "is misprinted",
                    Fault::False => "is false as printed",
                };
                format!("{of} {fault} (`explain {of}` has its counterexample). {derivation}")
            }
        }
    }

    fn outcome(&self, form: Form, values: &mut BTreeMap<String, String>) -> Result<&Outcome, &CheckError> {
        let examined = (self.examine)(form);
        values.extend(examined.values.clone());
        examined.outcome.as_ref()
    }

    fn refuted(
        &self,
        counterexample: &str,
        mut evidence: Vec<Evidence>,
        values: &mut BTreeMap<String, String>,
    ) -> Ruling {
        let counterexample = Some(counterexample.to_string());
        let Some((fault, statement)) = self.claim.correction().filter(|_| !self.correction) else {
            return Ruling { verdict: Verdict::False, evidence, counterexample, corrected: None, why: None };
        };
        let problem = match self.outcome(Form::Corrected, values) {
            Ok(Outcome::Holds(support)) if !support.is_empty() => {
                evidence
                    .extend(support.iter().cloned().map(|e| Evidence { part: format!("corrected: {}", e.part), ..e }));
                let verdict = match fault {
                    Fault::Misprint => Verdict::Misprint,
                    Fault::False => Verdict::False,
                };
                return Ruling { verdict, evidence, counterexample, corrected: Some(statement), why: None };
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

    fn controls(&self) -> (Controls, Vec<String>) {
        let own = self.claim.alterations();
        let own = own.into_iter().enumerate().map(|(k, what)| (what, Form::Control(k)));
        let altered: Vec<_> = own.chain(self.correction.then_some(("as printed", Form::Printed))).collect();
        let survives = |&(what, form): &(&str, Form)| {
            let said = match self.outcome(form, &mut BTreeMap::new()) {
                Ok(Outcome::Fails { .. }) => return None,
                Ok(Outcome::Holds(_)) => "it holds".to_string(),
                Ok(Outcome::Undecided(why) | Outcome::NotCheckable(why, _)) => why.clone(),
                Err(error) => error.to_string(),
            };
            Some(format!("{what}: {said}"))
        };
        let surviving: Vec<String> = altered.iter().filter_map(survives).collect();
        (Controls { refuted: altered.len() - surviving.len(), total: altered.len() }, surviving)
    }
}
