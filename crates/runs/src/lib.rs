//! What the claims and the figures share. Of Paley and others the runs behind Figures 1, 3 to 6 and 8, each law with the parameters that the
//! paper gives and those that it leaves open, and the arrangements of Figure 2; of Veerman and others Table 1 as printed.
//!
//! ```
//! use flockproof_runs::table1;
//!
//! // Table 1 of Veerman and others as printed: the "simulated" amplitudes double exactly with the number of cars.
//! let amplitude = |n| table1::ROWS.iter().find(|row| row.n == n).unwrap().namp.parse::<f64>().unwrap();
//! assert!((amplitude(8) / amplitude(4) - 2.0).abs() < 1e-8);
//! ```

pub mod figure2;
mod formations;
pub mod table1;
mod zones;

pub use formations::{
    CyclicFormation, DriftingOrbit, FourMotions, PatternFormation, PatternPhases, ReferenceTracking, RingPhases,
};
pub use zones::{Rim, ZoneFormation, ZoneLaw, zones_of_figure_7};

use arithmetic::{ArithmeticError, Complex};
use models::oscillator::{Flight, State};
use rand_chacha::rand_core::Rng;

/// `N` of the figures.
pub const PARTICLES: usize = 12;
/// `omega_0` of the circular figures.
pub const OMEGA: f64 = 0.1;
/// What all runs have in common and the paper does not state.
pub const DECLARATION: &str =
    "classical Runge-Kutta with fixed step; positions uniform in a square of half-width 10, phases uniform";

/// The start of a run of twelve particles: positions uniform in a square of half-width 10 around the origin, uniform phases.
pub fn random_start(random: &mut impl Rng) -> Flight {
    Flight::random(random, PARTICLES, 10.0)
}

/// A law with the step and the length of its run.
pub trait Experiment {
    /// The length of a step.
    const STEP: f64;
    /// The steps of a whole run.
    const STEPS: usize;

    /// `u_k`, `N` of them.
    ///
    /// # Errors
    /// [`ArithmeticError`] for no particles.
    fn steering(&self, state: &State<f64>) -> Result<Vec<f64>, ArithmeticError>;

    /// The drift common to all particles.
    fn drift(&self) -> Complex<f64> {
        Complex::new(0.0, 0.0)
    }

    /// Goes on by some steps.
    ///
    /// # Errors
    /// As [`Experiment::steering`].
    fn advance(&self, flight: &mut Flight, steps: usize) -> Result<(), ArithmeticError> {
        flight.advance((Self::STEP, steps), &self.drift(), |state| self.steering(state))
    }

    /// The state at the end of the whole run.
    ///
    /// # Errors
    /// As [`Experiment::steering`].
    fn end(&self, mut flight: Flight) -> Result<Flight, ArithmeticError> {
        self.advance(&mut flight, Self::STEPS)?;
        Ok(flight)
    }

    /// Goes on until `reached` says what has been reached; it is asked after every `every` steps. `None` after `most` steps.
    ///
    /// # Errors
    /// As [`Experiment::steering`], or what `reached` returns.
    fn until<S>(
        &self,
        mut flight: Flight,
        (every, most): (usize, usize),
        mut reached: impl FnMut(&Flight) -> Result<Option<S>, ArithmeticError>,
    ) -> Result<Option<S>, ArithmeticError> {
        let every = every.max(1);
        for _ in 0..most / every {
            self.advance(&mut flight, every)?;
            let state = reached(&flight)?;
            if state.is_some() {
                return Ok(state);
            }
        }
        Ok(None)
    }

    /// The states of the whole run with their times: the first, and one after every `every` steps.
    ///
    /// # Errors
    /// As [`Experiment::steering`].
    fn trajectory(&self, start: Flight, every: usize) -> Result<Vec<(f64, Flight)>, ArithmeticError> {
        let every = every.max(1);
        let mut states = vec![(0.0, start.clone())];
        let mut flight = start;
        for n in 1..=Self::STEPS / every {
            self.advance(&mut flight, every)?;
            states.push(((n * every) as f64 * Self::STEP, flight.clone()));
        }
        Ok(states)
    }
}
