//! The inverse squared response `F(w) = |T_M(gamma(w))|²` of the last car with its first two derivatives.

use super::law::Gains;
use super::response::complex_gain;
use arithmetic::{ArithmeticError, Complex, Field, Ring};

/// `F`, `F'` and `F''` at one frequency.
#[derive(Debug, Clone)]
pub struct FrequencyResponse<T> {
    /// `F = |T_M(gamma)|² = 1/|a_M|²`.
    pub inverse_square: T,
    /// `dF/dw`.
    pub slope: T,
    /// `d²F/dw²`.
    pub curvature: T,
}

/// Evaluates `F` for `followers >= 1` cars at the frequency `w > 0`, with `(T_M, U_{M-1})` at `gamma = 1 + d` computed by `chain(d)`: [`super::chebyshev`], or the
/// same in a faster arithmetic.
///
/// With `z = f + i w g` and `d = gamma - 1 = w²/z`: `d' = w (2 f + i w g)/z²` and `d'' = 2 f²/z³`;
/// `T' = M U d'`, and `T''` by Chebyshev's equation `(gamma² - 1) T_gg = M² T - gamma M U`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where `w` may be zero.
pub fn frequency_response<T: Field>(
    gains: &Gains<T>,
    followers: u64,
    w: &T,
    chain: impl FnOnce(&Complex<T>) -> (Complex<T>, Complex<T>),
) -> Result<FrequencyResponse<T>, ArithmeticError> {
    let z = complex_gain(gains, w);
    let inverse = z.recip()?;
    let inverse_square = inverse.square();
    let d = inverse.scale(&w.square());
    let two = w.integer(2);
    let d1 = inverse_square.clone() * (z + Complex::real(gains.f.clone())).scale(w);
    let d2 = (inverse_square * &inverse).scale(&(two.clone() * gains.f.square()));

    let m = w.integer(followers as i64);
    let (t, u) = chain(&d);
    let t_gamma = u.scale(&m);
    let gamma = d.one() + &d;
    let s2 = d.clone() * (gamma.clone() + d.one());
    let t_gamma_gamma = (t.scale(&m.square()) - gamma * &t_gamma).over(&s2)?;
    let t1 = t_gamma.clone() * &d1;
    let t2 = t_gamma_gamma * d1.square() + t_gamma * d2;
    Ok(FrequencyResponse {
        inverse_square: t.norm_squared(),
        slope: two.clone() * t.dot(&t1),
        curvature: two * (t1.norm_squared() + t.dot(&t2)),
    })
}
