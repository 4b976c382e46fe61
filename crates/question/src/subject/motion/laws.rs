//! The laws that are enclosed, over any scalar.

use arithmetic::{ArithmeticError, Complex, Number, Rational, Ring};
use models::double_integrator::{
    Coordinates, Pair, Potential, State as Flock, gyroscopic, heading_rate, potential_gradients,
};
use models::oscillator::{Neighbours, State, Steering, laplacian_control};
use models::platoon::Platoon;
use motion::System;

/// The phase model as phasors: `z' = i (omega_0 + u) z`, real parts and imaginary parts by turns.
pub(super) struct PhaseLaw<'a> {
    pub frequency: &'a Rational,
    pub gain: &'a Rational,
    pub network: &'a Neighbours,
}

impl System for PhaseLaw<'_> {
    fn rate<T: Number>(&self, _: &T, state: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let Some(like) = state.first() else { return Ok(Vec::new()) };
        let phasors = phasors_of(state);
        let (frequency, gain) = (like.rational(self.frequency), like.rational(self.gain));
        let control = laplacian_control(&gain, self.network, &phasors)?;
        let turned = phasors.into_iter().zip(control).flat_map(|(z, u)| {
            let rate = u + &frequency;
            [-(z.im * &rate), z.re * rate]
        });
        Ok(turned.collect())
    }
}

/// Heading alignment with headings that are followed as further numbers: positions, velocities, headings.
pub(super) struct HeadingLaw<'a> {
    pub potential: &'a Potential,
    pub edges: &'a [Pair],
}

impl System for HeadingLaw<'_> {
    fn rate<T: Number>(&self, _: &T, state: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let agents = state.len() / 5;
        let (list, headings) = state.split_at(4 * agents);
        let (Some(like), Some(moving)) = (list.first(), Flock::from_list(agents, list)) else { return Ok(Vec::new()) };
        let slope = self.potential.slope_over(like);
        let gradients =
            potential_gradients(&moving.positions, self.edges, Coordinates::Cartesian, |_, _, s| slope.at(s))?;
        let forces = gyroscopic(&moving, &gradients, self.edges, |i, j| headings[i].clone() - &headings[j])?;
        let turning = moving.velocities.iter().zip(&forces).map(|(v, a)| heading_rate(v, a));
        let turning = turning.collect::<Result<Vec<T>, _>>()?;
        Ok(moving.velocities.into_iter().chain(forces).flatten().chain(turning).collect())
    }
}

/// Complex numbers from their parts by turns.
pub(super) fn phasors_of<T: Ring>(state: &[T]) -> Vec<Complex<T>> {
    state.chunks_exact(2).map(|pair| Complex::new(pair[0].clone(), pair[1].clone())).collect()
}

/// Steered particles: positions, then phasors.
pub(super) struct ParticleLaw<'a> {
    pub steering: Steering<Rational>,
    pub drift: &'a [Rational; 2],
    pub network: &'a Neighbours,
}

impl System for ParticleLaw<'_> {
    fn rate<T: Number>(&self, _: &T, state: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let Some(like) = state.first() else { return Ok(Vec::new()) };
        let mut positions = phasors_of(state);
        let phasors = positions.split_off(positions.len() / 2);
        let state = State { positions, phasors };
        let turning = self.steering.over(like).turning(self.network, None, &state)?;
        let drift = Complex::new(like.rational(&self.drift[0]), like.rational(&self.drift[1]));
        let moving = state.moving(&turning, &vec![drift; turning.len()]);
        let rates = moving.positions.into_iter().chain(moving.phasors);
        Ok(rates.flat_map(|z| [z.re.derivative, z.im.derivative]).collect())
    }
}

/// Deviations, rates, and the swing `(A cos wt, A sin wt)` of the leader at the end.
pub(super) struct PlatoonLaw<'a> {
    pub platoon: &'a Platoon<Rational>,
    pub frequency: &'a Rational,
}

impl System for PlatoonLaw<'_> {
    fn rate<T: Number>(&self, _: &T, state: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let cars = self.platoon.followers() + 1;
        let (Some(swing), Some(like)) = (state.get(2 * cars..), state.first()) else { return Ok(Vec::new()) };
        let w = like.rational(self.frequency);
        let swing_rate = [-(swing[1].clone() * &w), swing[0].clone() * &w];
        let place = state[0].clone() + &swing[0];
        let speed = state[cars].clone() + &swing_rate[0];
        let (positions, velocities) = (&state[1..cars], &state[cars + 1..2 * cars]);
        let platoon = self.platoon.map(|q| like.rational(q));
        let forces = platoon.accelerations((&place, &speed), positions, velocities);
        let rates = state[cars..2 * cars].iter().cloned();
        Ok(rates.chain([like.zero()]).chain(forces).chain(swing_rate).collect())
    }
}
