//! The modes of the two-sided platoon (2): the spectrum of `P_2` and how its modes move.
//!
//! `P_2` has the eigenvalues `lambda_k = 1 - cos phi_k`, `phi_k = (2k - 1) pi/(2M)`, k = 1 to M, and the eigenvectors
//! `sin(j phi_k)`. With the weights 1 for j < M and 1/2 for j = M these are orthogonal with the squared norm M/2
//! (`notes/veerman_platoons.md`).

use super::Gains;
use arithmetic::{ArithmeticError, Dyadic, Interval, Rational, Real, Sign, Signed};

/// The angle `phi_k`, of the kind of `like`; `1 <= k <= followers`.
pub fn mode_angle<T: Real>(like: &T, followers: u64, k: u64) -> T {
    let (over, under) = (2 * i128::from(k) - 1, 2 * i128::from(followers.max(1)));
    let share = match (i64::try_from(over), i64::try_from(under)) {
        (Ok(over), Ok(under)) => like.ratio(over, under),
        _ => like.rational(&Rational::new(over.into(), under.into())),
    };
    like.pi() * share
}

/// The eigenvalue `lambda_k = 1 - cos phi_k = 2 sin²(phi_k/2)` of `P_2`.
///
/// # Errors
/// [`ArithmeticError`] of the sine.
pub fn mode_eigenvalue<T: Real>(like: &T, followers: u64, k: u64) -> Result<T, ArithmeticError> {
    let half = mode_angle(like, followers, k) * like.ratio(1, 2);
    Ok(half.sin()?.square() * like.integer(2))
}

/// The free motion of one mode, `z'' = lambda (f z + g z')`, whose characteristic roots are `-decay ± i frequency`, or
/// `-decay ± frequency` where it is overdamped.
#[derive(Debug, Clone)]
pub struct Mode<T> {
    /// `lambda |g|/2`, 1/s.
    pub decay: T,
    /// `sqrt|lambda² g²/4 - lambda |f||`, rad/s.
    pub frequency: T,
    /// Whether the roots are real.
    pub overdamped: bool,
    /// The slower of the two rates at which it decays, 1/s.
    pub rate: T,
}

impl<T: Real + Signed> Mode<T> {
    /// The mode of the eigenvalue `lambda > 0`, for `f, g < 0`.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] where it cannot be told whether the mode oscillates, as in the case of a double root.
    pub fn new(gains: &Gains<T>, lambda: &T) -> Result<Self, ArithmeticError> {
        let (decay, discriminant) = decay_and_discriminant(gains, lambda);
        let (overdamped, size) = match discriminant.sign() {
            Some(Sign::Positive) => (true, discriminant),
            Some(Sign::Negative) => (false, -discriminant),
            _ => return Err(ArithmeticError::Domain("modes with distinct roots")),
        };
        let frequency = size.sqrt()?;
        // decay - frequency without the cancellation: the product of the two rates is lambda |f|.
        let faster = decay.clone() + &frequency;
        let rate = if overdamped { (-(lambda.clone() * &gains.f)).over(&faster)? } else { decay.clone() };
        Ok(Mode { decay, frequency, overdamped, rate })
    }

    /// `(c, s)` such that the free motion is `z(t) = c z(0) + s z'(0)`.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn propagator(&self, t: &T) -> Result<(T, T), ArithmeticError> {
        let angle = self.frequency.clone() * t;
        if self.overdamped && (angle.clone() - t.one()).is_certainly_positive() {
            // Both exponentials decrease; their difference is far from zero here.
            let slow = (-(self.rate.clone() * t)).exp()?;
            let fast = (-((self.decay.clone() + &self.frequency) * t)).exp()?;
            let half = t.ratio(1, 2);
            let s = (slow.clone() - &fast).over(&self.frequency)? * &half;
            return Ok(((slow + fast) * half + self.decay.clone() * &s, s));
        }
        let envelope = (-(self.decay.clone() * t)).exp()?;
        let (sine, cosine) = if self.overdamped { angle.sinh_cosh()? } else { angle.sin_cos()? };
        let s = sine.over(&self.frequency)?;
        Ok((envelope.clone() * (cosine + self.decay.clone() * &s), envelope * s))
    }
}

/// `lambda |g|/2` and its square less `lambda |f|`, whose roots are the imaginary or real distances of the characteristic roots from `-lambda |g|/2`.
fn decay_and_discriminant<T: Real>(gains: &Gains<T>, lambda: &T) -> (T, T) {
    let decay = -(lambda.clone() * &gains.g) * lambda.ratio(1, 2);
    let discriminant = decay.square() + lambda.clone() * &gains.f;
    (decay, discriminant)
}

/// The slower of the two rates of a mode, also where its roots may be double.
fn slower_rate(gains: &Gains<Interval>, lambda: &Interval) -> Result<Interval, ArithmeticError> {
    let (decay, discriminant) = decay_and_discriminant(gains, lambda);
    if matches!(discriminant.sign(), Some(Sign::Positive | Sign::Negative)) {
        return Ok(Mode::new(gains, lambda)?.rate);
    }
    // The rate is decay - sqrt(max(discriminant, 0)).
    let above = Interval::between(Dyadic::zero(), discriminant.hi().clone(), decay.precision());
    Ok(decay - above.sqrt()?)
}

/// The slowest rate of decay of the platoon (2), `-max Re spec(M)`.
///
/// As a function of `lambda` the rate of a mode is `|g| lambda/2` up to `lambda = 4|f|/g²` and
/// `2|f|/(|g| + sqrt(g² - 4|f|/lambda))`, which decreases, beyond; so the slowest mode is the first or the last.
///
/// # Errors
/// [`ArithmeticError`] of the elementary functions.
pub fn slowest_rate(gains: &Gains<Interval>, followers: u64) -> Result<Interval, ArithmeticError> {
    let rate = |k| slower_rate(gains, &mode_eigenvalue(&gains.f, followers, k)?);
    let (first, last) = (rate(1)?, rate(followers.max(1))?);
    let (lo, hi) = (first.lo().min(last.lo()), first.hi().min(last.hi()));
    Ok(Interval::between(lo.clone(), hi.clone(), first.precision()))
}
