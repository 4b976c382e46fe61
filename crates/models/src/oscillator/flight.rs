//! Following particles in floating point: the classical Runge-Kutta method with a fixed step.

use super::state::State;
use crate::angles::within_a_turn;
use arithmetic::random::uniform;
use arithmetic::{ArithmeticError, Complex, Field};
use motion::Rk4;
use rand_chacha::rand_core::Rng;
use std::f64::consts::TAU;

/// Positions and phases of `N` particles, in floating point.
#[derive(Debug, Clone, PartialEq)]
pub struct Flight {
    /// `r_k`.
    pub positions: Vec<Complex<f64>>,
    /// `theta_k`, not reduced to one turn.
    pub phases: Vec<f64>,
}

/// Turning rates at a state.
type Steering<'a> = &'a dyn Fn(&State<f64>) -> Result<Vec<f64>, ArithmeticError>;

impl Flight {
    /// The state with phasors, on which the laws are written.
    pub fn state(&self) -> State<f64> {
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
        self.advance_by((step, steps), drift, &steering)
    }

    /// [`Self::advance`], compiled once and here: crates that call it are not optimised as fully.
    fn advance_by(
        &mut self,
        (step, steps): (f64, usize),
        drift: &Complex<f64>,
        steering: Steering<'_>,
    ) -> Result<(), ArithmeticError> {
        let mut state = self.state();
        let rate = |list: &[f64], rate: &mut [f64]| {
            read(list, &mut state);
            write_rate(&state, drift, &steering(&state)?, rate);
            Ok(())
        };
        *self = Flight::from_list(&followed(self.to_list(), (step, steps), rate)?);
        Ok(())
    }

    /// The same without drift in the circle centres `c_k = r_k + i e^{i theta_k}/omega` and the phases, by (18):
    /// `cdot_k = e^{i theta_k} (1 - steering_k/omega)`. Where all turn at the rate `omega` the centres rest and the method makes no error,
    /// whatever the step; in positions it keeps the particles on circles too large by a share `(omega step)^4/2880`.
    ///
    /// # Errors
    /// Whatever the steering returns; [`ArithmeticError::DivisionByZero`] for `omega = 0`.
    pub fn advance_by_centres(
        &mut self,
        omega: f64,
        (step, steps): (f64, usize),
        steering: impl Fn(&State<f64>) -> Result<Vec<f64>, ArithmeticError>,
    ) -> Result<(), ArithmeticError> {
        self.advance_centres(omega, (step, steps), &steering)
    }

    /// [`Self::advance_by_centres`], compiled once.
    fn advance_centres(
        &mut self,
        omega: f64,
        (step, steps): (f64, usize),
        steering: Steering<'_>,
    ) -> Result<(), ArithmeticError> {
        let radius = Field::recip(&omega)?;
        let mut state = self.state();
        let rate = |list: &[f64], rate: &mut [f64]| {
            read(list, &mut state);
            for (place, z) in state.positions.iter_mut().zip(&state.phasors) {
                *place = around(place, z, -radius);
            }
            let turning = steering(&state)?;
            let velocity = |(z, u): (&Complex<f64>, &f64)| {
                let speed = 1.0 - u * radius;
                [z.re * speed, z.im * speed]
            };
            write(state.phasors.iter().zip(&turning).map(velocity), &turning, rate);
            Ok(())
        };
        let moved = Flight::from_list(&followed(self.shifted(radius).to_list(), (step, steps), rate)?);
        *self = moved.shifted(-radius);
        Ok(())
    }

    /// Every particle displaced by `radius` to the left of its heading.
    fn shifted(&self, radius: f64) -> Self {
        let state = self.state();
        let positions = state.positions.iter().zip(&state.phasors).map(|(r, z)| around(r, z, radius)).collect();
        Flight { positions, phases: self.phases.clone() }
    }

    /// Positions uniform in a square of this half-width around the origin, uniform phases.
    pub fn random(random: &mut impl Rng, particles: usize, half: f64) -> Self {
        let mut uniform = || uniform(random);
        let place = |at: f64| 2.0 * half * at - half;
        let positions = (0..particles).map(|_| Complex::new(place(uniform()), place(uniform()))).collect();
        Flight { positions, phases: (0..particles).map(|_| TAU * uniform()).collect() }
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

fn phasor(theta: &f64) -> Complex<f64> {
    let (sin, cos) = theta.sin_cos();
    Complex::new(cos, sin)
}

/// Makes the state that of a list in the order of [`Flight::to_list`], with as many particles.
fn read(list: &[f64], state: &mut State<f64>) {
    let (places, phases) = list.split_at(list.len() / 3 * 2);
    for (to, from) in state.positions.iter_mut().zip(places.chunks_exact(2)) {
        *to = Complex::new(from[0], from[1]);
    }
    state.phasors.iter_mut().zip(phases).for_each(|(to, theta)| *to = phasor(theta));
}

/// Writes velocities and then rates of turning.
fn write(velocities: impl ExactSizeIterator<Item = [f64; 2]>, turning: &[f64], rate: &mut [f64]) {
    let (places, turns) = rate.split_at_mut((2 * velocities.len()).min(rate.len()));
    places.chunks_exact_mut(2).zip(velocities).for_each(|(to, velocity)| to.copy_from_slice(&velocity));
    turns.iter_mut().zip(turning).for_each(|(to, u)| *to = *u);
}

/// `r + i radius e^{i theta}`.
fn around(r: &Complex<f64>, z: &Complex<f64>, radius: f64) -> Complex<f64> {
    Complex::new(r.re - radius * z.im, r.im + radius * z.re)
}

/// The list after so many steps of the classical Runge-Kutta method.
fn followed(
    mut list: Vec<f64>,
    (step, steps): (f64, usize),
    mut rate: impl FnMut(&[f64], &mut [f64]) -> Result<(), ArithmeticError>,
) -> Result<Vec<f64>, ArithmeticError> {
    let mut method = Rk4::new(list.len());
    let mut failure = None;
    let mut field = |_: f64, list: &[f64], rates: &mut [f64]| {
        if let Err(error) = rate(list, rates) {
            failure.get_or_insert(error);
            rates.fill(f64::NAN);
        }
    };
    (0..steps).for_each(|_| method.step(&mut field, 0.0, step, &mut list));
    failure.map_or(Ok(list), Err)
}

/// Writes the rates of (1)-(2) in the order of [`Flight::to_list`].
pub fn write_rate(state: &State<f64>, drift: &Complex<f64>, turning: &[f64], rate: &mut [f64]) {
    write(state.phasors.iter().map(|z| [z.re + drift.re, z.im + drift.im]), turning, rate);
}
