//! What the claims about figures share: their starts, their evidence and the rule by which they are read.

use crate::paley::runs::{self, DECLARATION, Experiment, ZoneFormation};
use ledger::{CheckError, Evidence, Grade, Run};
use models::oscillator::Flight;

/// A panel of a figure shows an outcome of the stated law where that outcome is stable and not rare: a share of the runs from random
/// starts above this ends so.
///
/// The rule for all reports of runs, with its reasons, is in `notes/paley_particles.md`.
pub const SHOWN: f64 = 0.05;
/// A sentence on what the particles do says what happens in more than this share of the runs from random starts.
pub const TYPICAL: f64 = 0.5;

/// `K_0` of Figure 8.
pub const SPACING: f64 = 0.1;

/// The start of a replicate of a claim about a figure.
pub fn random_start(run: &Run, replicate: u64) -> Flight {
    runs::random_start(&mut run.random(replicate))
}

/// The run of Figure 8 of a replicate, so many times as long as usual.
pub fn fly(formation: &ZoneFormation, (replicate, lengths): (u64, usize), run: &Run) -> Result<Flight, CheckError> {
    run.checkpoint()?;
    let mut flight = random_start(run, replicate);
    formation.advance(&mut flight, lengths * ZoneFormation::STEPS)?;
    Ok(flight)
}

/// Evidence from runs, with what all runs declare.
pub fn simulated(part: &str, detail: &str, cases: usize) -> Evidence {
    Evidence::new(Grade::Simulated, part, format!("{detail}; {DECLARATION}")).cases(cases)
}
