//! A law of one's own with noise in continuous time: fixed steps of Euler and Maruyama.

use super::continuous::Moving;
use super::measured::{Heard, in_words};
use super::read::Described;
use crate::error::RunError;
use crate::simulation::{Event, Follower, Law, replace_due};
use crate::stepped::steps_to;
use arithmetic::Progress;
use arithmetic::random::normal;
use expressions::Evaluator;
use rand_chacha::ChaCha8Rng;

/// The law with its state.
pub(super) struct Noisy {
    law: Moving,
    strength: Option<Evaluator<f64>>,
    state: Vec<f64>,
    time: f64,
    /// The longest step.
    step: f64,
    random: ChaCha8Rng,
}

impl Noisy {
    pub fn new(own: Described, state: Vec<f64>, step: f64) -> Self {
        let (strength, random) = (own.law.noise_evaluator(), own.random.clone());
        let mut law = Moving::new(own);
        law.settle(&state);
        Noisy { law, strength, state, time: 0.0, step, random }
    }

    fn single_step(&mut self, length: f64) -> Result<(), RunError> {
        let (mut rates, mut noise) = (vec![0.0; self.state.len()], vec![0.0; self.state.len()]);
        self.law.rate(self.time, &self.state, &mut rates).map_err(|error| RunError::law(self.time, error))?;
        if let Some(strength) = &mut self.strength {
            let (law, network) = self.law.parts();
            law.write_noise(strength, (self.time, &self.state), &Heard(network), &mut noise)
                .map_err(|fault| RunError::Own { time: self.time, fault: in_words(law, &fault) })?;
        }
        let root = length.sqrt();
        for ((x, rate), noise) in self.state.iter_mut().zip(&rates).zip(&noise) {
            *x += length * rate;
            if *noise != 0.0 {
                *x += root * noise * normal(&mut self.random);
            }
        }
        if self.state.iter().any(|x| !x.is_finite()) {
            let fault = "a number grows beyond the floats".to_string();
            return Err(RunError::Own { time: self.time, fault });
        }
        self.law.settle(&self.state);
        Ok(())
    }
}

impl Follower for Noisy {
    type Law = Moving;

    fn go(&mut self, until: f64, events: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError> {
        while self.time < until {
            let from = self.time;
            let end = self.law.held_until(from, until);
            let (steps, length) = steps_to(from, end, self.step);
            for taken in 0..steps {
                if progress.is_cancelled() {
                    return Ok(false);
                }
                self.single_step(length)?;
                self.time = from + (taken + 1) as f64 * length;
            }
            self.time = end;
            replace_due(&mut self.law, end, &self.state, events);
        }
        Ok(true)
    }

    fn at(&self) -> (&Moving, f64, &[f64]) {
        (&self.law, self.time, &self.state)
    }

    fn method(&self) -> Vec<String> {
        vec![format!(
            "integrator: Euler and Maruyama, equal steps of at most {} from each time that is written to the next, rows of trajectory.csv included; links are those of the positions before each step: switches are neither located nor listed, and the tolerance has no effect",
            self.step
        )]
    }
}
