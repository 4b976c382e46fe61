//! The controls that a run of the phase model (6) or of steered particles (1)-(2) can have, over any scalar.

use super::circles::{beacon_control, beacon_potential, reference_control, spacing_control, spacing_potential};
use super::laplacian::phase_potential;
use super::moments::pattern_potential;
use super::network::Interaction;
use super::state::State;
use super::steering::{laplacian_control, pattern_control};
use arithmetic::{ArithmeticError, Complex, Field, Rational};

/// The orientation control.
#[derive(Debug, Clone, PartialEq)]
pub enum Orientation<T> {
    /// (14), with `K_1`.
    Laplacian(T),
    /// The negative gradient of (25), with `K_1, ..., K_M`.
    Pattern(Vec<T>),
    /// (14) with `K_1`, the last particle coupled to a reference phase.
    Reference {
        /// `K_1`.
        gain: T,
        /// The reference phase at time 0, in radians.
        start: T,
        /// Its rate, `omega_0`.
        rate: T,
    },
}

impl Orientation<Rational> {
    /// The same over another scalar.
    pub fn over<T: Field>(&self, like: &T) -> Orientation<T> {
        let number = |q: &Rational| like.rational(q);
        match self {
            Orientation::Laplacian(gain) => Orientation::Laplacian(number(gain)),
            Orientation::Pattern(gains) => Orientation::Pattern(gains.iter().map(number).collect()),
            Orientation::Reference { gain, start, rate } => {
                Orientation::Reference { gain: number(gain), start: number(start), rate: number(rate) }
            }
        }
    }
}

impl Orientation<f64> {
    /// `e^(i theta_0)` of the reference phase at a time, where there is one.
    pub fn reference(&self, time: f64) -> Option<Complex<f64>> {
        let Orientation::Reference { start, rate, .. } = self else { return None };
        let (sin, cos) = (start + rate * time).sin_cos();
        Some(Complex::new(cos, sin))
    }
}

const NO_REFERENCE: ArithmeticError = ArithmeticError::Domain("the phasor of the reference phase");

impl<T: Field> Orientation<T> {
    /// `u_k`, `N` of them.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] for no particles, and without the phasor of a reference that there is.
    pub fn control(
        &self,
        network: &impl Interaction,
        reference: Option<&Complex<T>>,
        phasors: &[Complex<T>],
    ) -> Result<Vec<T>, ArithmeticError> {
        match self {
            Orientation::Laplacian(gain) => laplacian_control(gain, network, phasors),
            Orientation::Pattern(gains) => pattern_control(gains, phasors),
            Orientation::Reference { gain, .. } => {
                reference_control(gain, network, reference.ok_or(NO_REFERENCE)?, phasors)
            }
        }
    }

    /// The potential whose negative gradient the control is, on an undirected network: `-K_1 W_1`, with a reference phase
    /// `-K_1 (W_1 + 1 - cos(theta_0 - theta_N))`, or `sum K_m U_m`.
    ///
    /// # Errors
    /// As [`Self::control`].
    pub fn potential(
        &self,
        network: &impl Interaction,
        reference: Option<&Complex<T>>,
        phasors: &[Complex<T>],
    ) -> Result<T, ArithmeticError> {
        match self {
            Orientation::Laplacian(gain) => Ok(-(phase_potential(network, phasors, 1)? * gain)),
            Orientation::Pattern(gains) => pattern_potential(gains, phasors),
            Orientation::Reference { gain, .. } => {
                let reference = reference.ok_or(NO_REFERENCE)?;
                let apart = phasors.last().map_or(gain.zero(), |z| gain.one() - reference.dot(z));
                Ok(-((phase_potential(network, phasors, 1)? + apart) * gain))
            }
        }
    }
}

/// The spacing control.
#[derive(Debug, Clone, PartialEq)]
pub enum Spacing<T> {
    /// Nothing.
    None,
    /// (20), with `K_0`.
    Circle(T),
    /// That of the beacon, with `K_0` and its place.
    Beacon(T, Complex<T>),
}

impl Spacing<Rational> {
    /// The same over another scalar.
    pub fn over<T: Field>(&self, like: &T) -> Spacing<T> {
        let number = |q: &Rational| like.rational(q);
        match self {
            Spacing::None => Spacing::None,
            Spacing::Circle(gain) => Spacing::Circle(number(gain)),
            Spacing::Beacon(gain, place) => {
                Spacing::Beacon(number(gain), Complex::new(number(&place.re), number(&place.im)))
            }
        }
    }
}

impl<T: Field> Spacing<T> {
    /// What it lowers: `K_0 S`, or with a beacon `(K_0/2) sum |c_k - c_0|²`.
    ///
    /// # Errors
    /// [`ArithmeticError`] for `omega_0 = 0` or no particles.
    pub fn potential(&self, omega: &T, network: &impl Interaction, state: &State<T>) -> Result<T, ArithmeticError> {
        match self {
            Spacing::None => Ok(omega.zero()),
            Spacing::Circle(gain) => Ok(spacing_potential(omega, network, state)? * gain),
            Spacing::Beacon(gain, place) => {
                let share = beacon_potential(omega, place, state)?;
                Ok(gain.clone() * omega.integer(state.phasors.len() as i64) * share)
            }
        }
    }
}

/// All that turns a steered particle.
#[derive(Debug, Clone, PartialEq)]
pub struct Steering<T> {
    /// `omega_0`; not zero where there is a spacing control.
    pub frequency: T,
    /// What aligns the phases.
    pub orientation: Orientation<T>,
    /// What keeps the particles on circles.
    pub spacing: Spacing<T>,
}

impl Steering<Rational> {
    /// The same over another scalar.
    pub fn over<T: Field>(&self, like: &T) -> Steering<T> {
        let (orientation, spacing) = (self.orientation.over(like), self.spacing.over(like));
        Steering { frequency: like.rational(&self.frequency), orientation, spacing }
    }
}

impl<T: Field> Steering<T> {
    /// `d theta_k/dt`, `N` of them.
    ///
    /// # Errors
    /// [`ArithmeticError`] for no particles, for a spacing control with `omega_0 = 0`, and without the phasor of a reference that there is.
    pub fn turning(
        &self,
        network: &impl Interaction,
        reference: Option<&Complex<T>>,
        state: &State<T>,
    ) -> Result<Vec<T>, ArithmeticError> {
        let turning = self.orientation.control(network, reference, &state.phasors)?;
        let turning = turning.into_iter().map(|u| u + &self.frequency);
        let spacing = match &self.spacing {
            Spacing::None => return Ok(turning.collect()),
            Spacing::Circle(gain) => spacing_control(&self.frequency, gain, network, state)?,
            Spacing::Beacon(gain, place) => beacon_control(&self.frequency, gain, place, state)?,
        };
        Ok(turning.zip(spacing).map(|(u, spacing)| u + spacing).collect())
    }

    /// What both controls lower together on a fixed undirected network without a drift: the potential of the spacing control and
    /// `1/omega_0²` times that of the orientation control.
    ///
    /// # Errors
    /// As [`Self::turning`].
    pub fn potential(
        &self,
        network: &impl Interaction,
        reference: Option<&Complex<T>>,
        state: &State<T>,
    ) -> Result<T, ArithmeticError> {
        let orientation = self.orientation.potential(network, reference, &state.phasors)?;
        let orientation = orientation.over(&self.frequency.square())?;
        Ok(self.spacing.potential(&self.frequency, network, state)? + orientation)
    }
}
