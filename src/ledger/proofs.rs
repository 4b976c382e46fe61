//! Checked Coq theorems as evidence.

use super::{Evidence, Grade, Verdict};
use crate::kernel::{Covers, theorems};

/// The evidence that checked theorems give for a claim with this verdict.
///
/// # Errors
/// What a theorem proves that contradicts the verdict.
pub fn evidence(claim: &str, verdict: Verdict) -> Result<Vec<Evidence>, String> {
    let checked = theorems().iter().filter(|theorem| theorem.claim == claim && theorem.is_checked());
    let support = checked.map(|theorem| {
        if contradict(theorem.covers, verdict) {
            return Err(format!("the Coq theorem {} says otherwise than the check: {}", theorem.path(), theorem.part));
        }
        let said = theorem.part.trim_end_matches('.');
        let part = match theorem.covers {
            Covers::Claim | Covers::Part | Covers::Instance => said.to_string(),
            Covers::Corrected => format!("corrected: {said}"),
            Covers::Negation => format!("negation: {said}"),
        };
        let detail = format!("Coq theorem {}; axioms: {}", theorem.path(), theorem.axioms.words());
        let grade = if theorem.covers == Covers::Instance { Grade::Exact } else { Grade::Kernel };
        Ok(Evidence::new(grade, part, detail))
    });
    support.collect()
}

/// Whether a theorem and a verdict cannot both be right.
fn contradict(covers: Covers, verdict: Verdict) -> bool {
    match verdict {
        Verdict::Holds => matches!(covers, Covers::Corrected | Covers::Negation),
        Verdict::Misprint | Verdict::False => covers == Covers::Claim,
        Verdict::Undecided | Verdict::NotCheckable => false,
    }
}
