//! Proofs from outside the program, as the ledger sees them.

use super::judge::CORRECTED;
use super::{Entry, Evidence, Verdict};

/// A body of machine-checked proofs. The ledger asks it about every claim that it has judged.
pub trait Proofs: Send + Sync {
    /// The evidence that checked theorems give for a claim with this verdict. The clauses of its correction follow the `printed` first
    /// ones of the entry.
    ///
    /// # Errors
    /// What a theorem proves that contradicts the verdict.
    fn evidence(&self, claim: &str, verdict: Verdict, printed: usize) -> Result<Vec<Evidence>, String>;
}

/// No proofs.
pub(super) struct NoProofs;

impl Proofs for NoProofs {
    fn evidence(&self, _: &str, _: Verdict, _: usize) -> Result<Vec<Evidence>, String> {
        Ok(Vec::new())
    }
}

/// Adds what is proved of a claim to its entry; a contradiction leaves it undecided.
pub(super) fn join(entry: &mut Entry, proofs: &dyn Proofs) {
    let printed = entry.clauses.iter().filter(|clause| !clause.starts_with(CORRECTED)).count();
    match proofs.evidence(&entry.id, entry.verdict, printed) {
        Ok(more) => entry.evidence.extend(more),
        Err(contradiction) => {
            entry.verdict = Verdict::Undecided;
            entry.why = Some(contradiction);
            entry.fault = None;
            entry.evidence.clear();
            (entry.corrected, entry.counterexample) = (None, None);
            entry.witnesses.clear();
        }
    }
}
