//! The resonance of system (2) to the next order after Theorem 1, with explicit bounds of the error
//! (`notes/veerman_next_order.md`).
//!
//! With `b = |g|/sqrt|f|` and `a0 = pi/(2 sqrt2 M)`, and the leading terms of [`super::theorem1`]:
//! `w = w_0 (1 - a0² (1/12 + b²/8) + e_w)` and `A = A_0 (1 - a0² (1/12 - 3b²/8 + pi² b²/96) + e_A)`, where for
//! `M >= 5 max(1, b)` the errors are at most `1.7` and `11` times `(a0 max(1, b))^4`.

use super::law::Gains;
use super::theorem1;
use arithmetic::{ArithmeticError, Real};

/// The smallest size at which the bounds are proved, in units of `max(1, b)`.
pub const SMALLEST_SIZE: u64 = 5;

/// The bound of the relative error of the frequency, in units of `(a0 max(1, b))^4`: 17/10.
pub const FREQUENCY_BOUND: (i64, i64) = (17, 10);

/// The bound of the relative error of the amplitude, in units of `(a0 max(1, b))^4`: 11.
pub const AMPLITUDE_BOUND: (i64, i64) = (11, 1);

/// `a0² = pi²/(8 M²)`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] for M = 0.
pub fn square_of_leading<T: Real>(like: &T, followers: u64) -> Result<T, ArithmeticError> {
    let m = theorem1::count(like, followers);
    like.pi().square().over(&(m.square() * like.integer(8)))
}

/// `b² = g²/|f|`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where `f` may be zero.
pub fn relative_damping_square<T: Real>(gains: &Gains<T>) -> Result<T, ArithmeticError> {
    gains.g.square().over(&-gains.f.clone())
}

/// `w_0 (1 - a0² (1/12 + b²/8))`, in rad/s.
///
/// # Errors
/// [`ArithmeticError`] where `f` may be positive or `M` is zero.
pub fn frequency<T: Real>(gains: &Gains<T>, followers: u64) -> Result<T, ArithmeticError> {
    let b2 = relative_damping_square(gains)?;
    let coefficient = b2.ratio(1, 12) + b2.clone() * b2.ratio(1, 8);
    let correction = square_of_leading(&b2, followers)? * coefficient;
    Ok(theorem1::frequency(gains, followers)? * (b2.one() - correction))
}

/// `A_0 (1 - a0² (1/12 - 3b²/8 + pi² b²/96))`; the correction to `A_0` is
/// `sqrt2 (b (36 - pi²)/96 - 1/(12 b))/M`.
///
/// # Errors
/// [`ArithmeticError`] where `f` may be positive, `g` may be zero or `M` is zero.
pub fn amplitude<T: Real>(gains: &Gains<T>, followers: u64) -> Result<T, ArithmeticError> {
    let b2 = relative_damping_square(gains)?;
    let damping = b2.pi().square() * b2.ratio(1, 96) - b2.ratio(3, 8);
    let coefficient = b2.ratio(1, 12) + b2.clone() * damping;
    let correction = square_of_leading(&b2, followers)? * coefficient;
    Ok(theorem1::amplitude(gains, followers)? * (b2.one() - correction))
}

/// The limit of `M³ (w - w_0)`, `-sqrt|f| (pi³/(16 sqrt2)) (1/12 + b²/8)`.
///
/// # Errors
/// [`ArithmeticError`] where `f` may be positive.
pub fn frequency_limit<T: Real>(gains: &Gains<T>) -> Result<T, ArithmeticError> {
    let b2 = relative_damping_square(gains)?;
    let factor = b2.ratio(1, 12) + b2.clone() * b2.ratio(1, 8);
    let root = (-gains.f.clone()).sqrt()?;
    (-(b2.pi().power(3) * factor * root)).over(&(b2.integer(16) * b2.integer(2).sqrt()?))
}

/// The limit of `M (A - A_0)`, `sqrt2 (b (36 - pi²)/96 - 1/(12 b))`.
///
/// # Errors
/// [`ArithmeticError`] where `f` may be positive or `g` may be zero.
pub fn amplitude_limit<T: Real>(gains: &Gains<T>) -> Result<T, ArithmeticError> {
    let b = relative_damping_square(gains)?.sqrt()?;
    let damping = (b.integer(36) - b.pi().square()) * b.ratio(1, 96) * &b;
    Ok((damping - b.ratio(1, 12).over(&b)?) * b.integer(2).sqrt()?)
}
