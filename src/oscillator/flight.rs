//! Following particles in floating point: the classical Runge-Kutta method with a fixed step.

use super::state::State;
use crate::arithmetic::{ArithmeticError, Complex};
use std::f64::consts::TAU;

/// Positions and phases of `N` particles, in floating point.
#[derive(Debug, Clone, PartialEq)]
pub struct Flight {
    /// `r_k`.
    pub positions: Vec<Complex<f64>>,
    /// `theta_k`, not reduced to one turn.
    pub phases: Vec<f64>,
}

impl Flight {
    /// The state with phasors, on which the laws are written.
    pub fn state(&self) -> State<f64> {
        let phasor = |theta: &f64| {
            let (sin, cos) = theta.sin_cos();
            Complex::new(cos, sin)
        };
        State { positions: self.positions.clone(), phasors: self.phases.iter().map(phasor).collect() }
    }

    /// `steps` steps of the classical Runge-Kutta method of order four for (1)-(2) with a drift common to all:
    /// `rdot_k = e^{i theta_k} + drift`, `thetadot_k = steering_k`. On a network that switches the order is lower.
    ///
    /// # Errors
    /// Whatever the steering returns.
    pub fn advance(
        &mut self,
        (step, steps): (f64, usize),
        drift: &Complex<f64>,
        steering: impl Fn(&State<f64>) -> Result<Vec<f64>, ArithmeticError>,
    ) -> Result<(), ArithmeticError> {
        for _ in 0..steps {
            let slope = |flight: &Flight| -> Result<(Vec<Complex<f64>>, Vec<f64>), ArithmeticError> {
                let state = flight.state();
                let turning = steering(&state)?;
                Ok((state.phasors.into_iter().map(|z| z + drift).collect(), turning))
            };
            let first = slope(self)?;
            let second = slope(&self.moved(step / 2.0, &first))?;
            let third = slope(&self.moved(step / 2.0, &second))?;
            let fourth = slope(&self.moved(step, &third))?;
            for (share, slope) in [(1.0, first), (2.0, second), (2.0, third), (1.0, fourth)] {
                *self = self.moved(step * share / 6.0, &slope);
            }
        }
        Ok(())
    }

    fn moved(&self, step: f64, (velocities, turning): &(Vec<Complex<f64>>, Vec<f64>)) -> Self {
        let positions = self.positions.iter().zip(velocities).map(|(r, v)| v.scale(&step) + r).collect();
        let phases = self.phases.iter().zip(turning).map(|(theta, u)| theta + step * u).collect();
        Flight { positions, phases }
    }

    /// The clusters of phases around the circle: sizes, and the angles in radians from the last of one to the first of the next.
    /// Neighbours on the circle belong together where they are less than `tolerance` radians apart.
    pub fn clusters(&self, tolerance: f64) -> Vec<(usize, f64)> {
        let mut angles: Vec<f64> = self.phases.iter().map(|theta| theta.rem_euclid(TAU)).collect();
        angles.sort_by(f64::total_cmp);
        let count = angles.len();
        let gap = |k: usize| (angles[(k + 1) % count] - angles[k]).rem_euclid(TAU);
        let ends: Vec<usize> = (0..count).filter(|&k| gap(k) >= tolerance).collect();
        let Some(&last) = ends.last() else { return vec![(count, 0.0)] };
        let mut before = last as isize - count as isize;
        let mut clusters = Vec::new();
        for end in ends {
            clusters.push(((end as isize - before) as usize, gap(end)));
            before = end as isize;
        }
        clusters
    }
}
