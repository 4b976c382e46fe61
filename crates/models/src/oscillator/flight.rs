//! Following particles in floating point: the classical Runge-Kutta method with a fixed step.

use super::state::State;
use crate::angles::within_a_turn;
use arithmetic::{ArithmeticError, Complex};
use motion::Rk4;
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
        let mut list = self.to_list();
        let mut method = Rk4::new(list.len());
        let mut failure = None;
        let mut field = |_: f64, list: &[f64], rate: &mut [f64]| {
            let state = Flight::from_list(list).state();
            match steering(&state) {
                Ok(turning) => write_rate(&state, drift, &turning, rate),
                Err(error) => {
                    failure.get_or_insert(error);
                    rate.fill(f64::NAN);
                }
            }
        };
        (0..steps).for_each(|_| method.step(&mut field, 0.0, step, &mut list));
        if let Some(error) = failure {
            return Err(error);
        }
        *self = Flight::from_list(&list);
        Ok(())
    }

    /// `x_1, y_1, ..., x_N, y_N, theta_1, ..., theta_N`.
    pub fn to_list(&self) -> Vec<f64> {
        let places = self.positions.iter().flat_map(|r| [r.re, r.im]);
        places.chain(self.phases.iter().copied()).collect()
    }

    /// The particles of such a list, a third of its length.
    pub fn from_list(list: &[f64]) -> Self {
        let (places, phases) = list.split_at(list.len() / 3 * 2);
        let positions = places.chunks_exact(2).map(|r| Complex::new(r[0], r[1])).collect();
        Flight { positions, phases: phases.to_vec() }
    }

    /// The angles in radians from each phase to the next around the circle, from the smallest in `[0, 2 pi)` on, `N` of them.
    pub fn gaps(&self) -> Vec<f64> {
        let mut angles: Vec<f64> = self.phases.iter().map(|theta| within_a_turn(*theta)).collect();
        angles.sort_by(f64::total_cmp);
        let around = angles.first().map(|first| first + TAU);
        let next = angles.iter().skip(1).copied().chain(around);
        angles.iter().zip(next).map(|(angle, next)| next - angle).collect()
    }

    /// The clusters of phases around the circle: sizes, and the angles in radians from the last of one to the first of the next.
    /// Neighbours on the circle belong together where they are less than `tolerance` radians apart.
    pub fn clusters(&self, tolerance: f64) -> Vec<(usize, f64)> {
        let gaps = self.gaps();
        let count = gaps.len();
        let ends: Vec<usize> = (0..count).filter(|&k| gaps[k] >= tolerance).collect();
        let Some(&last) = ends.last() else { return vec![(count, 0.0)] };
        let mut before = last as isize - count as isize;
        let mut clusters = Vec::new();
        for end in ends {
            clusters.push(((end as isize - before) as usize, gaps[end]));
            before = end as isize;
        }
        clusters
    }
}

/// Writes the rates of (1)-(2) in the order of [`Flight::to_list`].
pub fn write_rate(state: &State<f64>, drift: &Complex<f64>, turning: &[f64], rate: &mut [f64]) {
    let velocities = state.phasors.iter().flat_map(|z| [z.re + drift.re, z.im + drift.im]);
    rate.iter_mut().zip(velocities.chain(turning.iter().copied())).for_each(|(rate, value)| *rate = value);
}
