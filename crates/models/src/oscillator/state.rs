//! The state of the particle model (1)-(2) and derivatives along it.

use arithmetic::{ArithmeticError, Complex, Dual, Field, Ring};

/// Positions `r_k` and phasors `e^{i theta_k}` of `N` particles; the phase model (6) leaves the positions out of account.
#[derive(Debug, Clone, PartialEq)]
pub struct State<T> {
    /// `r_k`, `N` of them.
    pub positions: Vec<Complex<T>>,
    /// `e^{i theta_k}`, `N` of them, each of modulus one.
    pub phasors: Vec<Complex<T>>,
}

/// `(1 + i t)^2 / (1 + t^2)`: the phasor of the phase `2 arctan t`, rational where `t` is. Every phasor but -1 has a `t`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where `1 + t^2` may be zero, which only an interval that is not a number allows.
pub fn phasor<T: Field>(t: &T) -> Result<Complex<T>, ArithmeticError> {
    let scale = (t.one() + t.square()).recip()?;
    Ok(Complex::new(t.one() - t.square(), t.clone() + t).scale(&scale))
}

impl<T: Ring> State<T> {
    /// The state with derivatives along (1)-(2): `rdot_k = e^{i theta_k} + drift_k`, `thetadot_k = steering_k`. What is
    /// computed from it by a potential has as its derivative the rate of change along the closed loop.
    ///
    /// `steering` has one entry for each particle; so has `drift`, or it is empty where there is none.
    pub fn moving(&self, steering: &[T], drift: &[Complex<T>]) -> State<Dual<T>> {
        let pair = |value: &Complex<T>, rate: Complex<T>| {
            Complex::new(Dual::new(value.re.clone(), rate.re), Dual::new(value.im.clone(), rate.im))
        };
        let positions = self.positions.iter().zip(&self.phasors).enumerate().map(|(k, (r, z))| {
            let velocity = drift.get(k).map_or_else(|| z.clone(), |drift| z.clone() + drift);
            pair(r, velocity)
        });
        // d/dt e^{i theta} = i thetadot e^{i theta}
        let turning = |z: &Complex<T>, u: &T| Complex::new(-(z.im.clone() * u), z.re.clone() * u);
        let phasors = self.phasors.iter().zip(steering).map(|(z, u)| pair(z, turning(z, u)));
        State { positions: positions.collect(), phasors: phasors.collect() }
    }
}
