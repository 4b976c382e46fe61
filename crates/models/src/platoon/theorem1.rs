//! The leading-order resonance of system (2) as Theorem 1 prints it.

use super::Gains;
use arithmetic::{ArithmeticError, Real};

/// `sqrt(|f|) pi / (M 2 sqrt 2)` with `M = N + 1` followers (Theorem 1), in rad/s.
///
/// # Errors
/// [`ArithmeticError`] where `f` may be positive or `M` is zero.
pub fn frequency<T: Real>(gains: &Gains<T>, followers: u64) -> Result<T, ArithmeticError> {
    let m = gains.f.integer(followers as i64);
    let root = (-gains.f.clone()).sqrt()? * gains.f.pi();
    root.over(&(m * gains.f.integer(2) * gains.f.integer(2).sqrt()?))
}

/// `8 sqrt(2 |f|) M / (pi² |g|)` with `M = N + 1` followers (Theorem 1).
///
/// # Errors
/// [`ArithmeticError`] where `f` may be positive or `g` may be zero.
pub fn amplitude<T: Real>(gains: &Gains<T>, followers: u64) -> Result<T, ArithmeticError> {
    let m = gains.f.integer(followers as i64);
    let root = (gains.f.integer(-2) * &gains.f).sqrt()?;
    (root * gains.f.integer(8) * m).over(&(gains.f.pi().square() * -gains.g.clone()))
}
