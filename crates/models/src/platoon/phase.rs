//! Phase lags of the harmonic response.

use super::{Gains, amplitudes_two_sided, gamma};
use arithmetic::{ArithmeticError, Complex, Field, Real, Ring};

/// The angle of a complex number in (-pi, pi), by `2 atan(im/(|z| + re))`.
///
/// # Errors
/// [`ArithmeticError`] where the number may be zero or on the negative real axis.
pub fn argument<T: Real>(z: &Complex<T>) -> Result<T, ArithmeticError> {
    let half = z.im.over(&(z.norm_squared().sqrt()? + &z.re))?.atan()?;
    Ok(half.clone() + half)
}

/// System (1): by how much the phase of a car lags behind that of the car in front, the angle of `gamma`. It is the same for
/// all cars.
///
/// # Errors
/// [`ArithmeticError`] where `gamma` does not exist.
pub fn phase_lag_one_sided<T: Real>(gains: &Gains<T>, w: &T) -> Result<T, ArithmeticError> {
    argument(&gamma(gains, w)?)
}

/// System (2): by how much the phase of car `k` lags behind that of car `k - 1`, in (-pi, pi), for k = 1 to M.
///
/// # Errors
/// [`ArithmeticError`] where an amplitude may vanish or two successive cars are in opposite phases.
pub fn phase_lags_two_sided<T: Real>(gains: &Gains<T>, w: &T, followers: usize) -> Result<Vec<T>, ArithmeticError> {
    let amplitudes = amplitudes_two_sided(gains, w, followers)?;
    let leader = amplitudes.first().map(Ring::one);
    let front = leader.iter().chain(&amplitudes);
    front.zip(&amplitudes).map(|(front, own)| argument(&front.over(own)?)).collect()
}
