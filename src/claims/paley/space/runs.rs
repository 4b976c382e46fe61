//! What the claims about figures share: their starts and their evidence.

use crate::ledger::{Evidence, Grade, Run};
use crate::oscillator::{DECLARATION, Flight, PARTICLES};

/// The start of a replicate of a claim about a figure.
pub fn random_start(run: &Run, replicate: u64) -> Flight {
    Flight::random(&mut run.random(replicate), PARTICLES)
}

/// Evidence from runs, with what all runs declare.
pub fn simulated(part: &str, detail: &str, cases: usize) -> Evidence {
    Evidence::new(Grade::Simulated, part, format!("{detail}; {DECLARATION}")).cases(cases)
}
