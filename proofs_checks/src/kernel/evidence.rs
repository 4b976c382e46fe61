//! Checked Coq theorems as evidence.

use super::{Covers, Development, Theorem};
use ledger::{Evidence, Grade, Proofs, Verdict, correction_id};

/// The checked theorems about a claim and how much of it each proves. What is proved of the corrected statement of a
/// claim is a part of its correction ([`correction_id`]).
pub fn proofs_of(claim: &str) -> impl Iterator<Item = (&'static Theorem, Covers)> {
    Development::own().proofs_of(claim)
}

impl Development {
    /// [`proofs_of`] in this development.
    pub fn proofs_of(&self, claim: &str) -> impl Iterator<Item = (&Theorem, Covers)> {
        let covers = move |theorem: &Theorem| match theorem.covers {
            covers if theorem.claim == claim => Some(covers),
            Covers::Corrected if correction_id(theorem.claim) == claim => Some(Covers::Part),
            _ => None,
        };
        let about = self.theorems.iter().filter_map(move |theorem| Some((theorem, covers(theorem)?)));
        about.filter(|(theorem, _)| self.is_checked(theorem))
    }
}

/// The Coq development as the ledger's proofs.
impl Proofs for &'static Development {
    fn evidence(&self, claim: &str, verdict: Verdict, printed: usize) -> Result<Vec<Evidence>, String> {
        let support = self.proofs_of(claim).map(|(theorem, covers)| {
            if contradict(covers, verdict) {
                return Err(format!(
                    "the Coq theorem {} says otherwise than the check: {}",
                    theorem.path(),
                    theorem.part
                ));
            }
            let said = theorem.part.trim_end_matches('.');
            let part = match covers {
                Covers::Claim | Covers::Part | Covers::Instance => said.to_string(),
                Covers::Corrected => format!("corrected: {said}"),
                Covers::Negation => format!("negation: {said}"),
            };
            let (path, axioms, coq) = (theorem.path(), theorem.axioms.words(), &self.transcript.coq);
            let detail = format!("Coq theorem {path}; axioms: {axioms}; checked earlier with Coq {coq}; `flockproof prove` checks it again");
            let grade = if covers == Covers::Instance { Grade::Exact } else { Grade::Kernel };
            // In the entry of the printed statement the clauses of its correction come last.
            let skipped = if covers == Covers::Corrected { printed } else { 0 };
            let clauses: Vec<usize> = theorem.clauses.iter().map(|k| k + skipped).collect();
            let evidence = Evidence::new(grade, part, detail).on(clauses);
            let evidence = if covers == Covers::Negation { evidence.refuting() } else { evidence };
            Ok(if theorem.whole && grade == Grade::Kernel { evidence.for_all() } else { evidence })
        });
        support.collect()
    }
}

/// Whether a theorem and a verdict cannot both be right.
fn contradict(covers: Covers, verdict: Verdict) -> bool {
    match verdict {
        Verdict::Holds => matches!(covers, Covers::Corrected | Covers::Negation),
        Verdict::NeedsHypothesis | Verdict::Misprint | Verdict::False => covers == Covers::Claim,
        Verdict::Undecided | Verdict::NotCheckable => false,
    }
}
