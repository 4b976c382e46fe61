//! Moments of the phasors and the potentials of all-to-all interaction: (7), (8), (23), (24), (25).

use arithmetic::{ArithmeticError, Complex, Field, Ring};

/// A scalar of the kind of the phasors.
pub(super) fn kind<T>(phasors: &[Complex<T>]) -> Result<&T, ArithmeticError> {
    phasors.first().map(|z| &z.re).ok_or(ArithmeticError::Domain("at least one particle"))
}

/// `i z`: a phasor turned by a quarter.
pub fn quarter_turn<T: Ring>(z: &Complex<T>) -> Complex<T> {
    Complex::new(-z.im.clone(), z.re.clone())
}

/// `e^{i m theta_k}`, `N` of them.
pub fn powers<T: Ring>(phasors: &[Complex<T>], m: u32) -> Vec<Complex<T>> {
    if m == 1 { phasors.to_vec() } else { phasors.iter().map(|z| z.power(u64::from(m))).collect() }
}

/// `(1/N) sum_k x_k`: the centre of mass (4) of positions, the order parameter (7) of phasors.
///
/// # Errors
/// [`ArithmeticError::Domain`] where there are none.
pub fn mean<T: Field>(x: &[Complex<T>]) -> Result<Complex<T>, ArithmeticError> {
    let share = kind(x)?.ratio(1, x.len() as i64);
    let zero = share.zero();
    Ok(x.iter().fold(Complex::real(zero), |sum, x| sum + x).scale(&share))
}

/// `p_m = (1/(m N)) sum_k e^{i m theta_k}` (23), for `m >= 1`; `p_1` is the order parameter `p_theta` of (7).
///
/// # Errors
/// [`ArithmeticError`] for no particles or `m = 0`.
pub fn moment<T: Field>(phasors: &[Complex<T>], m: u32) -> Result<Complex<T>, ArithmeticError> {
    let order = kind(phasors)?.integer(i64::from(m));
    Ok(mean(&powers(phasors, m))?.scale(&order.recip()?))
}

/// `U_m = (N/2) |p_m|^2` (24); `U_1` is (8).
///
/// # Errors
/// As [`moment`].
pub fn moment_potential<T: Field>(phasors: &[Complex<T>], m: u32) -> Result<T, ArithmeticError> {
    let half = kind(phasors)?.ratio(phasors.len() as i64, 2);
    Ok(moment(phasors, m)?.norm_squared() * half)
}

/// `dU_m/dtheta_k = <i e^{i m theta_k}, p_m>`, `N` of them (the display after (8) for `m = 1`).
///
/// # Errors
/// As [`moment`].
pub fn moment_gradient<T: Field>(phasors: &[Complex<T>], m: u32) -> Result<Vec<T>, ArithmeticError> {
    let p = moment(phasors, m)?;
    Ok(powers(phasors, m).iter().map(|z| quarter_turn(z).dot(&p)).collect())
}

/// `U^{M,N} = sum_{m=1}^M K_m U_m` (25), with `gains = [K_1, ..., K_M]`.
///
/// # Errors
/// As [`moment`].
pub fn pattern_potential<T: Field>(gains: &[T], phasors: &[Complex<T>]) -> Result<T, ArithmeticError> {
    let mut sum = kind(phasors)?.zero();
    for (m, gain) in (1..).zip(gains) {
        sum = sum + moment_potential(phasors, m)? * gain;
    }
    Ok(sum)
}

/// The gradient of (25), `N` entries.
///
/// # Errors
/// As [`moment`].
pub fn pattern_gradient<T: Field>(gains: &[T], phasors: &[Complex<T>]) -> Result<Vec<T>, ArithmeticError> {
    let mut sum = vec![kind(phasors)?.zero(); phasors.len()];
    for (m, gain) in (1..).zip(gains) {
        for (sum, slope) in sum.iter_mut().zip(moment_gradient(phasors, m)?) {
            *sum = sum.clone() + slope * gain;
        }
    }
    Ok(sum)
}
