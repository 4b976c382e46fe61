//! What the claims about figures share: their starts, their evidence and the rule by which they are read.

use arithmetic::ArithmeticError;
use ledger::{CheckError, Evidence, Grade, Run};
use models::oscillator::Flight;
use runs::{self, DECLARATION, Experiment, ZoneFormation};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

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

/// The runs of Figure 8 that a statement and its controls have in common, each made once.
#[derive(Clone, Default)]
pub struct Flights(Arc<Mutex<Known>>);

/// Ends of runs by the bits of what they depend on.
type Known = BTreeMap<Vec<u64>, Arc<OnceLock<Result<Flight, ArithmeticError>>>>;

impl Flights {
    /// The run of a replicate, so many times as long as usual.
    pub fn fly(
        &self,
        formation: &ZoneFormation,
        (replicate, lengths): (u64, usize),
        run: &Run,
    ) -> Result<Flight, CheckError> {
        run.checkpoint()?;
        let start = random_start(run, replicate);
        let ZoneFormation { law, spacing, orientation, clusters, rim } = formation;
        let law = [*law as u64, u64::from(rim.by_centres), *clusters as u64, lengths as u64];
        let numbers = [*spacing, *orientation, rim.step, rim.margin].into_iter().chain(start.to_list());
        let key = law.into_iter().chain(numbers.map(f64::to_bits)).collect();
        let end = self.0.lock().unwrap_or_else(PoisonError::into_inner).entry(key).or_default().clone();
        let fly = || {
            let mut flight = start;
            formation.advance(&mut flight, lengths * ZoneFormation::STEPS).map(|()| flight)
        };
        Ok(end.get_or_init(fly).clone()?)
    }
}

/// Evidence from runs, with what all runs declare.
pub fn simulated(part: &str, detail: &str, cases: usize) -> Evidence {
    Evidence::new(Grade::Simulated, part, format!("{detail}; {DECLARATION}")).cases(cases)
}
