//! Steered particles (1)-(2) for large groups whose members have steps of their own.

use super::circles::{ahead, centre};
use super::steering::sine_of_difference;
use arithmetic::{ArithmeticError, Complex, Field};
use motion::{IndividualLaw, Moving, Rates};

/// Steered particles with orientation control (14), in its form as sums over pairs, and spacing control (20) or a beacon. The phase is the further
/// state, and `e^(i theta)` the velocity less the drift, so that no series of a sine is needed.
#[derive(Debug, Clone)]
pub struct ParticleLaw {
    /// `omega_0`; not zero where there is spacing control or a beacon.
    pub frequency: f64,
    /// `K_1/N`.
    pub orientation: f64,
    /// `omega_0 K_0/N` of the spacing control; 0 for none.
    pub spacing: f64,
    /// `omega_0 K_0` and the place of a beacon.
    pub beacon: Option<(f64, Complex<f64>)>,
    /// Added to all velocities.
    pub drift: Complex<f64>,
}

/// The position and `e^(i theta)`.
#[inline(always)]
fn read<T: Field + Copy>(at: &Moving<T, 1>, drift: [T; 2]) -> (Complex<T>, Complex<T>) {
    let ([x, y], [u, v]) = (at.position, at.velocity);
    (Complex { re: x, im: y }, Complex { re: u - drift[0], im: v - drift[1] })
}

impl ParticleLaw {
    #[inline(always)]
    fn drift<T>(&self, number: impl Fn(f64) -> T) -> [T; 2] {
        [number(self.drift.re), number(self.drift.im)]
    }

    /// The radius of the circles, with its sign.
    fn radius(&self) -> f64 {
        1.0 / self.frequency
    }
}

impl IndividualLaw<1, 1> for ParticleLaw {
    #[inline(always)]
    fn pair<T: Field + Copy>(
        &self,
        own: &Moving<T, 1>,
        other: &Moving<T, 1>,
        number: impl Fn(f64) -> T + Copy,
    ) -> Result<[T; 1], ArithmeticError> {
        let drift = self.drift(number);
        let ((r, z), (s, w)) = (read(own, drift), read(other, drift));
        let turn = sine_of_difference(&z, &w) * number(self.orientation);
        if self.spacing == 0.0 {
            return Ok([turn]);
        }
        let radius = number(self.radius());
        let (here, there) = (centre(&radius, &r, &z), centre(&radius, &s, &w));
        Ok([turn + ahead(&z, &here, &there) * number(self.spacing)])
    }

    #[inline(always)]
    fn rates<T: Field + Copy>(
        &self,
        own: &Moving<T, 1>,
        [influence]: &[T; 1],
        number: impl Fn(f64) -> T + Copy,
    ) -> Result<Rates<T, 1>, ArithmeticError> {
        let (r, z) = read(own, self.drift(number));
        let mut turning = *influence + number(self.frequency);
        if let Some((gain, place)) = &self.beacon {
            let place = Complex { re: number(place.re), im: number(place.im) };
            turning = turning + ahead(&z, &centre(&number(self.radius()), &r, &z), &place) * number(*gain);
        }
        // d/dt e^(i theta) = i thetadot e^(i theta)
        Ok(Rates { velocity: [-(z.im * turning), z.re * turning], further: [turning] })
    }

    fn velocity(&self, at: &Moving<f64, 1>) -> [f64; 2] {
        let (sin, cos) = at.further[0].sin_cos();
        [cos + self.drift.re, sin + self.drift.im]
    }
}
