//! Verdicts clause by clause.

use super::judge::CORRECTED;
use super::{Entry, Scope, Verdict};

impl Entry {
    /// The verdict on each clause, in order; `None` where the evidence does not tell the clause from others.
    ///
    /// - Every clause of a statement that holds, and of a correction, holds.
    /// - A printed clause that evidence refutes alone has the word of the claim.
    /// - One that is established for all parameters, and not refuted, holds, whatever becomes of the others.
    /// - Of a statement that fails the others have no verdict: several may have been refuted together, or nothing looked at this one. Of one that is
    ///   undecided or not checkable they are so too.
    pub fn verdicts_by_clause(&self) -> Vec<Option<Verdict>> {
        let clauses = (1..).zip(&self.clauses);
        clauses.map(|(k, clause)| self.verdict_on(k, clause.starts_with(CORRECTED))).collect()
    }

    fn verdict_on(&self, clause: usize, corrected: bool) -> Option<Verdict> {
        match self.verdict {
            _ if corrected => Some(Verdict::Holds),
            Verdict::Holds => Some(Verdict::Holds),
            failed if self.refuted_alone(clause) => Some(failed),
            _ if self.established(clause)
                && !self.evidence.iter().any(|e| e.refutes && e.clauses.contains(&clause)) =>
            {
                Some(Verdict::Holds)
            }
            open @ (Verdict::Undecided | Verdict::NotCheckable) => Some(open),
            Verdict::NeedsHypothesis | Verdict::Misprint | Verdict::False => None,
        }
    }

    fn refuted_alone(&self, clause: usize) -> bool {
        self.evidence.iter().any(|e| e.refutes && e.clauses == [clause])
    }

    /// Whether evidence covers the clause for all parameters.
    fn established(&self, clause: usize) -> bool {
        self.evidence.iter().any(|e| !e.refutes && e.scope == Some(Scope::All) && e.clauses.contains(&clause))
    }

    /// The printed clauses that hold although the claim does not, counted from 1.
    pub fn clauses_that_hold(&self) -> Vec<usize> {
        let printed = self.clauses.iter().filter(|clause| !clause.starts_with(CORRECTED)).count();
        let holds = (1..=printed).zip(&self.clause_verdicts).filter(|(_, verdict)| **verdict == Some(Verdict::Holds));
        if self.verdict == Verdict::Holds { Vec::new() } else { holds.map(|(k, _)| k).collect() }
    }

    /// The clauses that one piece of evidence refutes and another establishes for all parameters: that cannot be.
    pub(super) fn contradicted(&self) -> Vec<usize> {
        (1..=self.clauses.len()).filter(|&k| self.refuted_alone(k) && self.established(k)).collect()
    }
}
