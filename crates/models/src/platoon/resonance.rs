//! The main resonance of the two-sided platoon, enclosed rigorously at a cost that grows like log M.
//!
//! `|a_M| = 1/|T_M(gamma(w))|` is largest where `F = |T_M|²` is smallest. That one certified minimum is the global one is
//! proved in `notes/resonance.md` for all `f, g < 0` and `M >= 2`; in short, with `gamma = cos(x - i y)`:
//! 1. `F = cos²(Mx) + sinh²(My)`, and `y` increases with `w`. With `w_h` the first frequency where `Mx = pi/2`,
//!    `F(w) > F(w_h)` for all `w > w_h`.
//! 2. On `(0, w_h]` the derivative `F'` has exactly one zero, from minus to plus.
//!
//! What is left to compute: one zero of `F'`, enclosed by interval Newton steps (which include the sign change), and that
//! it lies in `(0, w_h]`. For `M = 1` there is no other zero.

use super::law::{Gains, SIGNS};
use super::response::{chebyshev, positive_root};
use super::shape::{FrequencyResponse, frequency_response};
use super::theorem1;
use arithmetic::{
    ArithmeticError, Ball, Complex, Dyadic, Field, Interval, Number, Rational, Ring, Sign, Signed, significant_digits,
};
use num_traits::ToPrimitive;

/// The largest number of followers that is accepted.
pub const LARGEST_FOLLOWERS: u64 = 1_000_000_000_000;

/// The largest number of digits that is accepted.
pub const LARGEST_DIGITS: u32 = 10_000;

/// The main resonance of a platoon.
#[derive(Debug, Clone)]
pub struct Resonance {
    /// Encloses the angular frequency (rad/s) at which the last car's amplitude is largest: `F'` is negative below the
    /// interval and positive above it, up to `w_h`.
    pub omega: Interval,
    /// Encloses that amplitude (per unit amplitude of the leader).
    pub amplitude: Interval,
}

/// The first relative half-width of the Newton interval, as a power of two.
const FIRST_RADIUS: i64 = -44;

/// Why there is no resonance to enclose.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ResonanceError {
    /// The platoon is only stable for negative gains (Lemma 1).
    #[error("{name} must be negative, but it is {value}: {}", SIGNS)]
    GainNotNegative {
        /// `f` or `g`.
        name: &'static str,
        /// What was given.
        value: String,
    },
    /// No cars, or too many.
    #[error("the number of followers must lie between 1 and {LARGEST_FOLLOWERS}, but it is {0}")]
    Followers(u64),
    /// No digits, or too many.
    #[error("the number of digits must lie between 1 and {LARGEST_DIGITS}, but it is {0}")]
    Digits(u32),
    /// Gains so extreme that no float can hold them.
    #[error("the gains are too extreme: |f|, |g| and g²/|f| must lie between 1e-100 and 1e100")]
    Extreme,
    /// The enclosures did not become thin enough.
    #[error("the resonance could not be isolated at {0} bits")]
    NotIsolated(u32),
}

/// Encloses the main resonance of `followers` cars: the global maximum of `|a_M(w)|` over `w > 0`, with a relative width
/// of at most `10^-digits` in frequency and amplitude.
///
/// # Errors
/// [`ResonanceError`]: gains that are not negative, numbers out of range.
pub fn resonance(gains: &Gains<Rational>, followers: u64, digits: u32) -> Result<Resonance, ResonanceError> {
    check_arguments(gains, followers, digits)?;
    let start = uncertified_start(gains, followers).ok_or(ResonanceError::Extreme)?;
    resonance_from(gains, followers, start, digits)
}

/// The same from a frequency that somebody proposes. Where that leads to another peak there is an error, never another result.
///
/// # Errors
/// As [`resonance`].
pub fn resonance_from(
    gains: &Gains<Rational>,
    followers: u64,
    start: f64,
    digits: u32,
) -> Result<Resonance, ResonanceError> {
    // Where the response is so flat that floats do not find its peak, bisection on certified signs does.
    let found = match peak_near(gains, followers, start, digits) {
        Err(ResonanceError::NotIsolated(_)) => {
            let platoon = Platoon { gains, followers, digits };
            platoon.critical_point(platoon.bisected_start()?)?
        }
        other => other?,
    };
    if is_below_full_phase(gains, followers, &found.omega) { Ok(found) } else { Err(ResonanceError::NotIsolated(64)) }
}

/// Encloses a local maximum of `|a_M(w)|` near a frequency that somebody proposes, which is positive.
///
/// # Errors
/// As [`resonance`]; `NotIsolated` where no maximum is found there.
pub fn peak_near(
    gains: &Gains<Rational>,
    followers: u64,
    start: f64,
    digits: u32,
) -> Result<Resonance, ResonanceError> {
    check_arguments(gains, followers, digits)?;
    let start = Dyadic::from_f64(start).filter(|_| start > 0.0).ok_or(ResonanceError::NotIsolated(0))?;
    Platoon { gains, followers, digits }.critical_point(start)
}

/// Whether `|gamma - 1| <= 4/M²` at a frequency, that is `w⁴ M⁴ <= 16 (f² + w² g²)`, which implies `M x <= pi` up to `w`, where `F'` has
/// no zero beyond `w_h` (`notes/resonance.md`, step 3).
pub fn is_below_full_phase(gains: &Gains<Rational>, followers: u64, w: &Interval) -> bool {
    let w = w.with_precision(64);
    let gains = gains.map(|q| w.rational(q));
    let square = w.square();
    let m4 = theorem1::count(&w, followers).square().square();
    let bound = w.integer(16) * (gains.f.square() + square.clone() * gains.g.square());
    (bound - square.square() * m4).is_certainly_positive()
}

fn check_arguments(gains: &Gains<Rational>, followers: u64, digits: u32) -> Result<(), ResonanceError> {
    for (name, value) in [("f", &gains.f), ("g", &gains.g)] {
        if !value.is_certainly_negative() {
            return Err(ResonanceError::GainNotNegative { name, value: value.to_string() });
        }
    }
    if followers == 0 || followers > LARGEST_FOLLOWERS {
        return Err(ResonanceError::Followers(followers));
    }
    if digits == 0 || digits > LARGEST_DIGITS {
        return Err(ResonanceError::Digits(digits));
    }
    Ok(())
}

/// Encloses the `k`-th lesser resonance, k >= 2: a local maximum of `|a_M(w)|` where `Mx` lies between `(k - 3/4) pi` and
/// `(k - 1/2) pi` with `gamma = cos(x - iy)` (Corollary 3; `notes/veerman_platoons.md`). That it is a local maximum is certified, its
/// number only as far as its place tells it.
///
/// # Errors
/// [`ResonanceError`]; `NotIsolated` also where the damping has flattened that maximum.
pub fn lesser_resonance(
    gains: &Gains<Rational>,
    followers: u64,
    k: u64,
    digits: u32,
) -> Result<Resonance, ResonanceError> {
    check_arguments(gains, followers, digits)?;
    let start = uncertified_lesser_start(gains, followers, k).ok_or(ResonanceError::NotIsolated(0))?;
    peak_near(gains, followers, start, digits)
}

/// Bits by which the angle per car is smaller than one: what doubling loses twice.
fn size_bits(followers: u64) -> u32 {
    u64::BITS - followers.leading_zeros()
}

struct Platoon<'a> {
    gains: &'a Gains<Rational>,
    followers: u64,
    digits: u32,
}

impl Platoon<'_> {
    fn at(&self, w: &Interval) -> Result<FrequencyResponse<Interval>, ArithmeticError> {
        let gains = self.gains.map(|q| w.rational(q));
        frequency_response(&gains, self.followers, w, |d| self.chain(d, w.precision()))
    }

    /// The Chebyshev chain in the smallest balls that hold the precision, or in intervals.
    fn chain(&self, d: &Complex<Interval>, precision: u32) -> (Complex<Interval>, Complex<Interval>) {
        let in_balls = match precision {
            0..=128 => self.chain_in_balls::<3>(d, precision),
            129..=192 => self.chain_in_balls::<4>(d, precision),
            193..=448 => self.chain_in_balls::<8>(d, precision),
            _ => None,
        };
        in_balls.unwrap_or_else(|| chebyshev(self.followers, d))
    }

    fn chain_in_balls<const LIMBS: usize>(
        &self,
        d: &Complex<Interval>,
        precision: u32,
    ) -> Option<(Complex<Interval>, Complex<Interval>)> {
        let ball = Complex::new(Ball::<LIMBS>::from_interval(&d.re), Ball::from_interval(&d.im));
        let (t, u) = chebyshev(self.followers, &ball);
        let back =
            |z: Complex<Ball<LIMBS>>| Some(Complex::new(z.re.to_interval(precision)?, z.im.to_interval(precision)?));
        Some((back(t)?, back(u)?))
    }

    /// Bits that settle the asked digits, after what the doubling steps lose.
    fn precision(&self) -> u32 {
        (f64::from(self.digits) * std::f64::consts::LOG2_10) as u32 + 2 * size_bits(self.followers) + 40
    }

    fn is_thin_enough(&self, x: &Interval) -> bool {
        significant_digits(x) >= self.digits
    }

    fn more(&self, precision: u32) -> Result<u32, ResonanceError> {
        let next = precision + precision / 2;
        if next > 4 * self.precision() + 20_000 { Err(ResonanceError::NotIsolated(precision)) } else { Ok(next) }
    }

    /// Interval Newton on `F'`: if `N = m - F'(m)/F''(W)` lies in `W` and `F'' > 0` on `W`, there is exactly one zero
    /// of `F'` in `W`, it lies in `N`, and `F'` changes sign from minus to plus there.
    fn critical_point(&self, mut middle: Dyadic) -> Result<Resonance, ResonanceError> {
        let mut precision = self.precision();
        // The start is good to about 2^-48; `radius` is the exponent of the relative half-width of W.
        let mut radius = FIRST_RADIUS;
        let mut economical = true;
        loop {
            // F'' is only needed to about the relative width of W, as long as that suffices.
            let rough = 2 * size_bits(self.followers) + 48 + 2 * radius.unsigned_abs() as u32;
            let wide_bits = if economical { precision.min(rough) } else { precision };
            let half_width = Dyadic::new(1.into(), middle.top() + radius);
            let wide = Interval::between(middle.plus(&half_width.negated()), middle.plus(&half_width), wide_bits);
            let point = Interval::between(middle.clone(), middle.clone(), precision);
            match self.newton_step(&point, &wide) {
                Some((omega, minimum)) => {
                    let amplitude = minimum.sqrt().and_then(|root| root.recip()).ok();
                    if let Some(amplitude) = amplitude.filter(|a| self.is_thin_enough(a) && self.is_thin_enough(&omega))
                    {
                        return Ok(Resonance { omega, amplitude });
                    }
                    let reached = omega.width().top() - middle.top() + 1;
                    if reached > radius - 4 || -reached > i64::from(precision) - 8 {
                        precision = self.more(precision)?;
                    }
                    middle = omega.midpoint(precision).lo().clone();
                    radius = reached.min(radius);
                }
                None if economical => economical = false,
                None if radius < -8 => radius += 6,
                None => {
                    radius = FIRST_RADIUS;
                    precision = self.more(precision)?;
                }
            }
        }
    }

    /// The Newton interval `N` and the enclosure of the minimum of `F`, if `N` lies in `wide`.
    fn newton_step(&self, point: &Interval, wide: &Interval) -> Option<(Interval, Interval)> {
        let curvature = self.at(wide).ok()?.curvature.with_precision(point.precision());
        if !curvature.is_certainly_positive() {
            return None;
        }
        let here = self.at(point).ok()?;
        let step = -here.slope.over(&curvature).ok()?;
        let omega = point.clone() + &step;
        // F(w*) = F(m) + F'(m) s + F''(xi) s²/2.
        let minimum = here.inverse_square + here.slope * &step + curvature.scaled(-1) * step.square();
        wide.encloses(&omega).then_some((omega, minimum))
    }

    /// Bisection on certified signs of `F'`, from a frequency below the zero, to a relative width of `2^-50`.
    fn bisected_start(&self) -> Result<Dyadic, ResonanceError> {
        let below = self.below_the_zero(64).map_err(|_| ResonanceError::NotIsolated(64))?;
        let mut low = below.lo().clone();
        let mut ratio = 1;
        let mut high = low.scaled(ratio);
        while !self.slope_is_positive(&high)? {
            low = high;
            ratio = (2 * ratio).min(64);
            high = low.scaled(ratio);
        }
        while high.plus(&low.negated()).top() > low.top() - 50 {
            // Halve the exponents while they differ, then the numbers.
            let gap = high.top() - low.top();
            let middle = if gap > 2 { low.scaled(gap / 2) } else { low.midpoint(&high) };
            if self.slope_is_positive(&middle)? { high = middle } else { low = middle }
        }
        Ok(low.midpoint(&high))
    }

    fn slope_is_positive(&self, w: &Dyadic) -> Result<bool, ResonanceError> {
        let mut precision = self.precision();
        loop {
            let point = Interval::between(w.clone(), w.clone(), precision);
            match self.at(&point).ok().and_then(|response| response.slope.sign()) {
                Some(sign) => return Ok(sign == Sign::Positive),
                None => precision = self.more(precision)?,
            }
        }
    }

    /// Every factor of `F` decreases below its `s_k` with `b s² + 2 s = 2 d_k`, `w² = |f| s`; here `d = 1/M² < d_1`.
    fn below_the_zero(&self, precision: u32) -> Result<Interval, ArithmeticError> {
        let f = Interval::from_rational(&-self.gains.f.clone(), precision);
        let b = Interval::from_rational(&self.gains.g, precision).square().over(&f)?;
        let d = f.integer(self.followers as i64).square().recip()?;
        (f * positive_root(&b, &d)?).sqrt()
    }
}

/// The platoon in floating point, without any guarantee: where the enclosures start. Frequencies are given as `s = w²/|f|`.
struct Rough {
    /// `|f|`.
    f: f64,
    /// `g²/|f|`.
    b: f64,
    /// The number of followers.
    m: f64,
}

impl Rough {
    /// `None` where the gains leave the range of floats.
    fn new(gains: &Gains<Rational>, followers: u64) -> Option<Self> {
        let (f, g) = (-gains.f.to_f64()?, -gains.g.to_f64()?);
        let b = g / f * g;
        let all = [f, g, b].iter().all(|x| (1e-100..1e100).contains(x));
        all.then_some(Rough { f, b, m: followers as f64 })
    }

    /// `y' sinh 2My / x' - sin 2Mx`, with the sign of `F'` where `x' > 0`.
    fn slope(&self, s: f64) -> f64 {
        let (x, y, tangent) = angles(s, self.b);
        tangent * (2.0 * self.m * y).sinh() - (2.0 * self.m * x).sin()
    }

    /// The same as long as `Mx < pi/2`, infinite beyond.
    fn slope_before_full_phase(&self, s: f64) -> f64 {
        if self.phase(s) < std::f64::consts::FRAC_PI_2 { self.slope(s) } else { f64::INFINITY }
    }

    /// `Mx`.
    fn phase(&self, s: f64) -> f64 {
        self.m * angles(s, self.b).0
    }

    /// A zero between two numbers where `value` is negative and positive: false position, Illinois variant, and halving where
    /// that leaves the bracket.
    fn zero(mut low: f64, mut high: f64, value: impl Fn(f64) -> f64) -> f64 {
        let (mut below, mut above) = (value(low), value(high));
        let (mut middle, mut side) = (low, 0);
        for _ in 0..100 {
            let last = middle;
            middle = low - below * (high - low) / (above - below);
            if !(middle > low && middle < high) {
                middle = 0.5 * (low + high);
            }
            if (middle - last).abs() <= f64::EPSILON * middle {
                break;
            }
            let here = value(middle);
            // An end that stays twice counts half, so that it does not stay for ever.
            if here > 0.0 {
                (high, above) = (middle, here);
                below *= if side == 1 { 0.5 } else { 1.0 };
                side = 1;
            } else {
                (low, below) = (middle, here);
                above *= if side == -1 { 0.5 } else { 1.0 };
                side = -1;
            }
        }
        middle
    }

    fn frequency(&self, s: f64) -> f64 {
        s.sqrt() * self.f.sqrt()
    }
}

/// The frequency of the main resonance in floating point: the zero of `F'` before `Mx = pi/2`. `None` where the gains leave the range of
/// floats.
fn uncertified_start(gains: &Gains<Rational>, followers: u64) -> Option<f64> {
    let rough = Rough::new(gains, followers)?;
    let slope = |s: f64| rough.slope_before_full_phase(s);
    let mut low = positive_root(&rough.b, &(rough.m * rough.m).recip()).ok()?;
    let mut high = 2.0 * low;
    while slope(high) < 0.0 {
        low = high;
        high *= 2.0;
    }
    Some(rough.frequency(Rough::zero(low, high, slope)))
}

/// The frequency of the `k`-th lesser resonance in floating point. `None` where there is none.
fn uncertified_lesser_start(gains: &Gains<Rational>, followers: u64, k: u64) -> Option<f64> {
    let rough = Rough::new(gains, followers)?;
    // x increases up to c² = 4; beyond, nothing is looked for.
    let end = (4.0 / rough.b).min(2.0);
    let place = |turns: f64| {
        let excess = |s: f64| rough.phase(s) - turns * std::f64::consts::PI;
        (excess(end) >= 0.0).then(|| Rough::zero(0.0, end, excess))
    };
    let (low, high) = (place(k as f64 - 0.75)?, place(k as f64 - 0.5)?);
    (rough.slope(low) < 0.0).then(|| rough.frequency(Rough::zero(low, high, |s| rough.slope(s))))
}

/// `x`, `y` and `y'/x'` for `gamma = cos(x - i y)` at `s = w²/|f|`, `b = g²/|f|`, in forms without cancellation.
fn angles(s: f64, b: f64) -> (f64, f64, f64) {
    let c2 = b * s;
    let c = c2.sqrt();
    // q = 1 - gamma = s/(1 + i c).
    let size = s / (1.0 + c2).sqrt();
    let re = s / (1.0 + c2);
    let other = ((2.0 - re).powi(2) + (re * c).powi(2)).sqrt();
    // 4 sin²(x/2) = |q| + (4 Re q - |q|²)/(2 + |2 - q|).
    let quadruple = size + (4.0 * re - size * size) / (2.0 + other);
    let x = 2.0 * (0.5 * quadruple.sqrt()).min(1.0).asin();
    let y = (re * c / x.sin()).asinh();
    let phi = c.atan() - (0.5 * c).atan() + 0.5 * (2.0 * c).atan2(2.0 - s);
    (x, y, phi.tan())
}
