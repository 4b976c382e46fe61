//! What the claims about figures share: their starts, shares with confidence intervals, evidence.

use crate::ledger::{Evidence, Grade, Run};
use crate::oscillator::{DECLARATION, Flight, PARTICLES};
use crate::simulate::wilson;

/// The start of a replicate of a claim about a figure.
pub fn random_start(run: &Run, replicate: u64) -> Flight {
    Flight::random(&mut run.random(replicate), PARTICLES)
}

/// The 95% confidence interval of a share, as a value of the ledger.
pub fn share(found: usize, of: usize) -> String {
    let (low, high) = wilson(found, of);
    format!("[{low:.3}, {high:.3}]")
}

/// Evidence from runs, with what all runs declare.
pub fn simulated(part: &str, detail: &str, cases: usize) -> Evidence {
    Evidence::new(Grade::Simulated, part, format!("{detail}; {DECLARATION}")).cases(cases)
}
