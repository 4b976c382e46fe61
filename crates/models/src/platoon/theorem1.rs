//! The leading-order resonance of system (2) as Theorem 1 prints it.

use super::law::Gains;
use arithmetic::{ArithmeticError, Complex, Field, Real, Ring, Series};

/// The number of followers in a scalar of the kind of `like`, exactly also where it has 64 bits.
pub(super) fn count<T: Ring>(like: &T, followers: u64) -> T {
    match i64::try_from(followers) {
        Ok(followers) => like.integer(followers),
        Err(_) => like.integer((followers / 2) as i64) * like.integer(2) + like.integer((followers % 2) as i64),
    }
}

/// `sqrt(|f|) pi / (M 2 sqrt 2)` with `M = N + 1` followers (Theorem 1), in rad/s.
///
/// # Errors
/// [`ArithmeticError`] where `f` may be positive or `M` is zero.
pub fn frequency<T: Real>(gains: &Gains<T>, followers: u64) -> Result<T, ArithmeticError> {
    let m = count(&gains.f, followers);
    let root = (-gains.f.clone()).sqrt()? * gains.f.pi();
    root.over(&(m * gains.f.integer(2) * gains.f.integer(2).sqrt()?))
}

/// `8 sqrt(2 |f|) M / (pi² |g|)` with `M = N + 1` followers (Theorem 1).
///
/// # Errors
/// [`ArithmeticError`] where `f` may be positive or `g` may be zero.
pub fn amplitude<T: Real>(gains: &Gains<T>, followers: u64) -> Result<T, ArithmeticError> {
    let m = count(&gains.f, followers);
    let root = (gains.f.integer(-2) * &gains.f).sqrt()?;
    (root * gains.f.integer(8) * m).over(&(gains.f.pi().square() * -gains.g.clone()))
}

/// `x = pi² |g|/(8 sqrt 2 sqrt|f|)` of the proof of Theorem 1 and of Proposition 2, with the amplitude `M/x`.
///
/// # Errors
/// [`ArithmeticError`] where `f` may be zero or positive, or `g` may be zero.
pub fn exponent<T: Real>(gains: &Gains<T>) -> Result<T, ArithmeticError> {
    amplitude(gains, 1)?.recip()
}

/// The exact expansion at small frequencies behind the proof, over series in `w`: with `r = sqrt|f|` and `G = |g|`, `gamma` and `E` such that
/// `sqrt(gamma² - 1) = i sqrt2 (w/r) E(w)`, to `order` coefficients each.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where `r` may be zero.
pub fn expansion<T: Field>(r: &T, g: &T, order: usize) -> Result<[Series<Complex<T>>; 2], ArithmeticError> {
    let size = r.square();
    let constant = |z: Complex<T>| Series::constant(z, order);
    let w = Series::variable(Complex::real(r.one()), order);
    // q = 1 - gamma = w²/(|f| + i w |g|).
    let denominator =
        constant(Complex::real(size.clone())) + Series::variable(Complex::new(r.zero(), g.clone()), order);
    let inverse = denominator.recip()?;
    let q = w.square() * &inverse;
    // gamma² - 1 = -q (2 - q) = -2 (w²/|f|) S with S = |f|/(|f| + i w |g|) (1 - q/2).
    let half = Complex::real(r.ratio(1, 2));
    let s = inverse.scale(&Complex::real(size)) * (q.one() - q.scale(&half));
    Ok([q.one() - q, s.sqrt_of_unit()?])
}
