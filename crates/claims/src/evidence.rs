//! Evidence of each grade, and what a check makes of it.

use arithmetic::Interval;
use ledger::{CheckError, Counterexample, Evidence, Grade, Outcome, Run};

/// Exact arithmetic on instances.
pub(crate) fn exact(part: impl Into<String>, detail: impl Into<String>) -> Evidence {
    Evidence::new(Grade::Exact, part, detail)
}

/// Every case of a finite family.
pub(crate) fn exhaustive(part: impl Into<String>, detail: impl Into<String>) -> Evidence {
    Evidence::new(Grade::Exhaustive, part, detail)
}

/// Enclosures.
pub(crate) fn certified(part: impl Into<String>, detail: impl Into<String>) -> Evidence {
    Evidence::new(Grade::Certified, part, detail)
}

/// A property test.
pub(crate) fn fuzzed(part: impl Into<String>, detail: impl Into<String>) -> Evidence {
    Evidence::new(Grade::Fuzzed, part, detail)
}

/// What holds, on one piece of evidence.
pub(crate) fn holds(evidence: Evidence) -> Result<Outcome, CheckError> {
    Ok(Outcome::Holds(vec![evidence]))
}

/// Numbers, or other things, as text.
pub(crate) fn list<T: ToString>(numbers: impl IntoIterator<Item = T>) -> String {
    numbers.into_iter().map(|x| x.to_string()).collect::<Vec<_>>().join(", ")
}

/// The evidence, if nothing is wrong.
pub(crate) fn unless(wrong: Option<impl Into<Counterexample>>, evidence: Evidence) -> Result<Outcome, CheckError> {
    Ok(match wrong {
        Some(counterexample) => Outcome::fails(counterexample, evidence),
        None => Outcome::Holds(vec![evidence]),
    })
}

/// Whether `x <= bound`, where the enclosures decide it.
///
/// # Errors
/// Enclosures that overlap: then neither is shown, and the check is undecided.
pub(crate) fn at_most(x: &Interval, bound: &Interval) -> Result<bool, CheckError> {
    if x.hi() <= bound.lo() {
        return Ok(true);
    }
    if x.lo() > bound.hi() {
        return Ok(false);
    }
    Err(CheckError::Other("the enclosures are too wide to decide".to_string()))
}

/// Whether `x` and `y` differ by at most `slack`, where the enclosures decide it.
///
/// # Errors
/// As [`at_most`].
pub(crate) fn are_within(x: &Interval, y: &Interval, slack: &Interval) -> Result<bool, CheckError> {
    let difference = x.clone() - y;
    Ok(at_most(&difference, slack)? && at_most(&-difference, slack)?)
}

/// The evidence, with what it checks of the proof beside it ([`Placed::checks`]).
pub(crate) fn checking(evidence: Evidence, what: &str) -> Evidence {
    Evidence { detail: format!("{}; {what}", evidence.detail), ..evidence }
}

/// Says which clauses the evidence of a check bears on.
pub(crate) trait Placed {
    /// [`Outcome::on`].
    fn on(self, clauses: impl Into<Vec<usize>>) -> Self;
    /// [`Outcome::for_all`].
    fn for_all(self) -> Self;
    /// Names, where it holds, what of the proof beside it the computed evidence checks: a numbered step that it would fail without, or
    /// the conclusion.
    fn checks(self, what: &str) -> Self;
}

impl Placed for Result<Outcome, CheckError> {
    fn on(self, clauses: impl Into<Vec<usize>>) -> Self {
        self.map(|outcome| outcome.on(clauses))
    }

    fn for_all(self) -> Self {
        self.map(Outcome::for_all)
    }

    fn checks(self, what: &str) -> Self {
        self.map(|outcome| match outcome {
            Outcome::Holds(evidence) => Outcome::Holds(evidence.into_iter().map(|e| checking(e, what)).collect()),
            other => other,
        })
    }
}

/// A proof in the notes of these clauses (none: of the only one), for all their parameters; `place` names the note and its steps.
pub(crate) fn argued(clauses: &[usize], part: &str, place: &str) -> Result<Outcome, CheckError> {
    Ok(Outcome::Holds(vec![Evidence::argued(part, place).on(clauses)]))
}

/// The same for statements whose constants nobody names: what is computed are steps of the proof on instances, which bear on no
/// clause by themselves and are named beside it.
pub(crate) fn argued_with(
    clauses: &[usize],
    part: &str,
    place: &str,
    steps: impl IntoIterator<Item = Result<Outcome, CheckError>>,
) -> Result<Outcome, CheckError> {
    let steps = match Run::all(steps)? {
        Outcome::Holds(steps) => steps,
        other => return Ok(other.on(clauses)),
    };
    let count = |e: &Evidence| e.cases.map_or(String::new(), |cases| format!(", {cases} cases"));
    let computed: Vec<String> = steps.iter().map(|e| format!("{} ({}{})", e.part, e.detail, count(e))).collect();
    let place = format!("{place}; computed beside it: {}", computed.join("; "));
    Ok(Outcome::Holds(vec![Evidence::argued(part, place).on(clauses).beside(steps)]))
}
