//! The laws that are enclosed, over any scalar.

use super::constants::Constants;
use arithmetic::{ArithmeticError, Complex, Number, Rational, Ring};
use models::double_integrator::{
    Coordinates, Pair, Potential, State as Flock, gyroscopic, heading_rate, potential_gradients,
};
use models::oscillator::{Neighbours, Spacing, State, laplacian_control};
use models::platoon::Platoon;
use motion::System;

/// The phase model as phasors: `z' = i (omega_0 + u) z`, real parts and imaginary parts by turns.
pub(super) struct PhaseLaw<'a> {
    pub frequency: &'a Rational,
    pub gain: &'a Rational,
    pub network: &'a Neighbours,
    pub constants: Constants<'a>,
}

impl System for PhaseLaw<'_> {
    fn rate<T: Number>(&self, _: &T, list: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let (state, still) = self.constants.split(list);
        let numbers = self.constants.number("omega0", self.frequency, list);
        let Some((frequency, gain)) = numbers.zip(self.constants.number("K1", self.gain, list)) else {
            return Ok(Vec::new());
        };
        let phasors = phasors_of(state);
        let control = laplacian_control(&gain, self.network, &phasors)?;
        let turned = phasors.into_iter().zip(control).flat_map(|(z, u)| {
            let rate = u + &frequency;
            [-(z.im * &rate), z.re * rate]
        });
        Ok(turned.chain(still.iter().map(Ring::zero)).collect())
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
    /// `omega_0`, `K_1` and the spacing control.
    pub steering: (&'a Rational, &'a Rational, &'a Spacing<Rational>),
    pub drift: &'a [Rational; 2],
    pub network: &'a Neighbours,
    pub constants: Constants<'a>,
}

impl System for ParticleLaw<'_> {
    fn rate<T: Number>(&self, _: &T, list: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let (state, still) = self.constants.split(list);
        let drift = self.constants.vector("drift", [&self.drift[0], &self.drift[1]], list);
        let Some((steering, [x, y])) = self.constants.steering(self.steering, list).zip(drift) else {
            return Ok(Vec::new());
        };
        let mut positions = phasors_of(state);
        let phasors = positions.split_off(positions.len() / 2);
        let state = State { positions, phasors };
        let turning = steering.turning(self.network, None, &state)?;
        let drift = Complex::new(x, y);
        let moving = state.moving(&turning, &vec![drift; turning.len()]);
        let rates = moving.positions.into_iter().chain(moving.phasors);
        let rates = rates.flat_map(|z| [z.re.derivative, z.im.derivative]);
        Ok(rates.chain(still.iter().map(Ring::zero)).collect())
    }
}

/// Deviations, rates, and the swing `(A cos wt, A sin wt)` of the leader at the end.
pub(super) struct PlatoonLaw<'a> {
    pub platoon: &'a Platoon<Rational>,
    pub frequency: &'a Rational,
    pub constants: Constants<'a>,
}

impl System for PlatoonLaw<'_> {
    fn rate<T: Number>(&self, _: &T, list: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let cars = self.platoon.followers() + 1;
        let (state, still) = self.constants.split(list);
        let numbers = self.constants.platoon(self.platoon, list);
        let numbers = numbers.zip(self.constants.number("leader.frequency", self.frequency, list));
        let (Some(swing), Some((platoon, w))) = (state.get(2 * cars..), numbers) else { return Ok(Vec::new()) };
        let swing_rate = [-(swing[1].clone() * &w), swing[0].clone() * &w];
        let place = state[0].clone() + &swing[0];
        let speed = state[cars].clone() + &swing_rate[0];
        let (positions, velocities) = (&state[1..cars], &state[cars + 1..2 * cars]);
        let forces = platoon.accelerations((&place, &speed), positions, velocities);
        let rates = state[cars..2 * cars].iter().cloned();
        let still = still.iter().map(Ring::zero);
        Ok(rates.chain([w.zero()]).chain(forces).chain(swing_rate).chain(still).collect())
    }
}
