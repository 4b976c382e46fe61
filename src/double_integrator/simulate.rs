//! Plain floating-point motion for the figures: Dormand and Prince's pair of orders 5 and 4 with an adaptive step.
//!
//! No bound is proved here. Links that switch are not located: a step over a switch is made short by the error estimate only.

use super::{Coordinates, State, Vector, difference, scaled, sum};
use crate::arithmetic::ArithmeticError;
use crate::simulate::uniform;
use rand_chacha::ChaCha8Rng;

/// Why a motion could not be followed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RunError {
    /// The law has no value at a state.
    #[error(transparent)]
    Law(#[from] ArithmeticError),
    /// The step became too short for the tolerance.
    #[error("the step became too short at t = {0}")]
    Step(f64),
}

/// An adaptive integrator of `rdot = v`, `vdot = law(state)`.
#[derive(Debug, Clone, Copy)]
pub struct Stepper {
    /// Largest error estimate of a step in any coordinate.
    pub tolerance: f64,
    /// Longest step.
    pub longest: f64,
    /// Shortest step.
    pub shortest: f64,
}

/// Rows of the tableau of Dormand and Prince; the last row is the solution of order 5.
const TABLEAU: [&[f64]; 6] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
/// Order 5 minus order 4.
const ERROR: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];

/// A rate of change: velocities and accelerations.
type Rate = (Vec<Vector<f64>>, Vec<Vector<f64>>);

fn moved(state: &State<f64>, step: f64, weights: &[f64], rates: &[Rate]) -> State<f64> {
    let mut next = state.clone();
    for (weight, (velocities, accelerations)) in weights.iter().zip(rates) {
        let by = step * weight;
        for (r, v) in next.positions.iter_mut().zip(velocities) {
            *r = sum(r, &scaled(&by, v));
        }
        for (v, a) in next.velocities.iter_mut().zip(accelerations) {
            *v = sum(v, &scaled(&by, a));
        }
    }
    next
}

impl Default for Stepper {
    fn default() -> Self {
        Stepper { tolerance: 1e-6, longest: 0.5, shortest: 1e-9 }
    }
}

impl Stepper {
    /// The state after the time `until`; `observe(t, state)` is called after every step.
    ///
    /// # Errors
    /// [`RunError`].
    pub fn run(
        &self,
        start: &State<f64>,
        until: f64,
        law: impl Fn(&State<f64>) -> Result<Vec<Vector<f64>>, ArithmeticError>,
        mut observe: impl FnMut(f64, &State<f64>),
    ) -> Result<State<f64>, RunError> {
        let rate = |state: &State<f64>| -> Result<Rate, RunError> { Ok((state.velocities.clone(), law(state)?)) };
        let (mut state, mut time, mut step) = (start.clone(), 0.0, self.longest.min(1e-3));
        let mut first = rate(&state)?;
        while time < until {
            let last = until - time <= step;
            let taken = if last { until - time } else { step };
            let mut rates = vec![first.clone()];
            let mut next = state.clone();
            for row in TABLEAU {
                next = moved(&state, taken, row, &rates);
                rates.push(rate(&next)?);
            }
            let error = largest(&moved(&state.map(|_| 0.0), taken, &ERROR, &rates));
            if error <= self.tolerance || taken <= self.shortest {
                if taken <= self.shortest && !last && error > self.tolerance * 1e6 {
                    return Err(RunError::Step(time));
                }
                time = if last { until } else { time + taken };
                state = next;
                first = rates.swap_remove(6);
                observe(time, &state);
            }
            let factor = (0.9 * (self.tolerance / error.max(1e-300)).powf(0.2)).clamp(0.2, 4.0);
            step = (taken * factor).clamp(self.shortest, self.longest);
        }
        Ok(state)
    }
}

fn largest(state: &State<f64>) -> f64 {
    state.positions.iter().chain(&state.velocities).flatten().fold(0.0, |m: f64, x| m.max(x.abs()))
}

/// `sqrt(sum |v_i - mean|²)`.
pub fn disagreement(state: &State<f64>) -> f64 {
    let count = state.count().max(1) as f64;
    let total = state.velocities.iter().fold([0.0, 0.0], |s, v| sum(&s, v));
    let mean = scaled(&(1.0 / count), &total);
    state.velocities.iter().map(|v| Coordinates::Cartesian.square(&difference(v, &mean))).sum::<f64>().sqrt()
}

/// A random flock: positions even in the square `|x|, |y| < half`, speeds even in `(0, speed)`, directions even.
pub fn random_flock(count: usize, half: f64, speed: f64, random: &mut ChaCha8Rng) -> State<f64> {
    let mut even = || uniform(random);
    let positions = (0..count).map(|_| [half * (2.0 * even() - 1.0), half * (2.0 * even() - 1.0)]).collect();
    let velocities = (0..count)
        .map(|_| {
            let (size, angle) = (speed * even(), 2.0 * std::f64::consts::PI * even());
            [size * angle.cos(), size * angle.sin()]
        })
        .collect();
    State { positions, velocities }
}
