//! Proofs on paper as evidence.

use ledger::{CheckError, Evidence, Outcome, Run};

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
    argued(clauses, part, &format!("{place}; computed beside it: {}", computed.join("; ")))
}
