//! The main resonance of the two-sided platoon, enclosed rigorously at a cost that grows like log M.
//!
//! `|a_M| = 1/|T_M(gamma(w))|` is largest where `F = |T_M|²` is smallest. The proof that one certified minimum is the
//! global one is in `notes/resonance.md`; in short, with `gamma = cos(x - i y)`:
//! 1. `F = cos²(Mx) + sinh²(My)`, and `y` increases with `w`. With `w_h` the first frequency where `Mx = pi/2`,
//!    `F(w) > F(w_h)` for all `w > w_h`.
//! 2. On `(0, w_h]` there is exactly one critical point if `w² g² <= 8 f²` and `w² <= 2|f|` there: a rational condition
//!    on `f`, `g`, `M` ([`Uniqueness::Analytic`]). Otherwise the same is established by interval arithmetic on a
//!    compact range outside of which it is again proved ([`Uniqueness::Subdivision`]).
//! 3. The critical point is enclosed by interval Newton steps, which include a sign change of `F'`.

use super::shape::frequency_response_by;
use super::{FrequencyResponse, Gains, chebyshev, gain_squared_one_sided, strongest_one_sided_square};
use crate::arithmetic::{
    ArithmeticError, Ball, Complex, Dyadic, Field, Interval, Rational, Real, Ring, Signed, rational, significant_digits,
};
use num_traits::ToPrimitive;

/// The largest number of followers that is accepted.
pub const LARGEST_FOLLOWERS: u64 = 1_000_000_000_000;

/// The largest number of digits that is accepted.
pub const LARGEST_DIGITS: u32 = 10_000;

/// How it was established that the enclosed critical point is the only one up to `w_h`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Uniqueness {
    /// One follower: the maximum is the root of a quadratic.
    Quadratic,
    /// By the theorem in `notes/resonance.md`; its rational conditions hold.
    Analytic,
    /// By interval arithmetic on this many pieces.
    Subdivision(usize),
}

/// The main resonance of a platoon.
#[derive(Debug, Clone)]
pub struct Resonance {
    /// Encloses the angular frequency (rad/s) at which the last car's amplitude is largest: `F'` is negative below the
    /// interval and positive above it, up to `w_h`.
    pub omega: Interval,
    /// Encloses that amplitude (per unit amplitude of the leader).
    pub amplitude: Interval,
    /// How uniqueness was established.
    pub uniqueness: Uniqueness,
}

/// Why there is no resonance to enclose.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ResonanceError {
    /// The platoon is only stable for negative gains (Lemma 1).
    #[error("{name} must be negative, but it is {value}")]
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

impl From<(u32, ArithmeticError)> for ResonanceError {
    fn from((precision, _): (u32, ArithmeticError)) -> Self {
        ResonanceError::NotIsolated(precision)
    }
}

/// Encloses the main resonance of `followers` cars: the global maximum of `|a_M(w)|` over `w > 0`, with a relative width
/// of at most `10^-digits` in frequency and amplitude.
///
/// # Errors
/// [`ResonanceError`]: gains that are not negative, numbers out of range.
pub fn resonance(gains: &Gains<Rational>, followers: u64, digits: u32) -> Result<Resonance, ResonanceError> {
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
    let platoon = Platoon { gains, followers, digits };
    if followers == 1 {
        return platoon.single_follower();
    }
    let start = resonance_uncertified_start(gains, followers).ok_or(ResonanceError::Extreme)?;
    let found = platoon.critical_point(start)?;
    let uniqueness = platoon.is_global(&found)?;
    Ok(Resonance { uniqueness, ..found })
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
        frequency_response_by(&gains, self.followers, w, |d| self.chain(d, w.precision()))
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
        let back = |z: Complex<Ball<LIMBS>>| Some(Complex::new(z.re.to_interval(precision)?, z.im.to_interval(precision)?));
        Some((back(t)?, back(u)?))
    }

    /// Bits that settle the asked digits, after what the doubling steps lose.
    fn precision(&self) -> u32 {
        (f64::from(self.digits) * std::f64::consts::LOG2_10) as u32 + 2 * size_bits(self.followers) + 40
    }

    fn is_thin_enough(&self, x: &Interval) -> bool {
        significant_digits(x) >= self.digits
    }

    fn single_follower(&self) -> Result<Resonance, ResonanceError> {
        let mut precision = self.precision();
        loop {
            let gains = self.gains.map(|q| Interval::from_rational(q, precision));
            let enclose = || {
                let square = strongest_one_sided_square(&gains)?;
                let gain = gain_squared_one_sided(&gains, &square)?;
                Ok((square.sqrt()?, gain.sqrt()?))
            };
            let (omega, amplitude) = enclose().map_err(|error| (precision, error))?;
            if self.is_thin_enough(&omega) && self.is_thin_enough(&amplitude) {
                return Ok(Resonance { omega, amplitude, uniqueness: Uniqueness::Quadratic });
            }
            precision = self.more(precision)?;
        }
    }

    fn more(&self, precision: u32) -> Result<u32, ResonanceError> {
        let next = precision + precision / 2;
        if next > 16 * (self.precision() + 700) { Err(ResonanceError::NotIsolated(precision)) } else { Ok(next) }
    }

    /// Interval Newton on `F'`: if `N = m - F'(m)/F''(W)` lies in `W` and `F'' > 0` on `W`, there is exactly one zero
    /// of `F'` in `W`, it lies in `N`, and `F'` changes sign from minus to plus there.
    fn critical_point(&self, start: f64) -> Result<Resonance, ResonanceError> {
        let mut precision = self.precision();
        let mut middle = Dyadic::from_f64(start).ok_or(ResonanceError::Extreme)?;
        // The start is good to about 2^-48; `radius` is the exponent of the relative half-width of W.
        let mut radius: i64 = -44;
        loop {
            let wide_bits = precision.min(2 * size_bits(self.followers) + 48 + 2 * radius.unsigned_abs() as u32);
            let half_width = Dyadic::new(1.into(), middle.top() + radius);
            let wide = Interval::between(middle.plus(&half_width.negated()), middle.plus(&half_width), wide_bits);
            let point = Interval::between(middle.clone(), middle.clone(), precision);
            let attempt = self.newton_step(&point, &wide).map_err(|error| (precision, error))?;
            match attempt {
                Some(step) if self.is_thin_enough(&step.omega) && self.is_thin_enough(&step.amplitude) => {
                    return Ok(step);
                }
                Some(step) => {
                    let width = step.omega.width();
                    let reached = width.top() - middle.top() + 1;
                    if reached > radius - 4 || -reached > i64::from(precision) {
                        precision = self.more(precision)?;
                    }
                    middle = step.omega.midpoint(precision).lo().clone();
                    radius = reached.min(radius);
                }
                None if radius < -8 => radius += 6,
                None => {
                    radius = -44;
                    precision = self.more(precision)?;
                }
            }
        }
    }

    fn newton_step(&self, point: &Interval, wide: &Interval) -> Result<Option<Resonance>, ArithmeticError> {
        let curvature = self.at(wide)?.curvature.with_precision(point.precision());
        if !curvature.is_certainly_positive() {
            return Ok(None);
        }
        let here = self.at(point)?;
        let step = -here.slope.over(&curvature)?;
        let omega = point.clone() + &step;
        if !wide.encloses(&omega) {
            return Ok(None);
        }
        // F(w*) = F(m) + F'(m) s + F''(xi) s²/2.
        let minimum = here.inverse_square + here.slope * &step + curvature.scaled(-1) * step.square();
        if !minimum.is_certainly_positive() {
            return Ok(None);
        }
        let amplitude = minimum.sqrt()?.recip()?;
        Ok(Some(Resonance { omega, amplitude, uniqueness: Uniqueness::Analytic }))
    }

    /// Steps 1 and 2 of the argument at the head of this file.
    fn is_global(&self, found: &Resonance) -> Result<Uniqueness, ResonanceError> {
        let precision = found.omega.precision();
        let upper = Interval::between(found.omega.hi().clone(), found.omega.hi().clone(), precision);
        if !self.phase_below_pi(&upper) {
            return Err(ResonanceError::NotIsolated(precision));
        }
        if self.analytic_conditions() && self.angle_increases(&upper) {
            return Ok(Uniqueness::Analytic);
        }
        let response = self.at(&upper).map_err(|error| (precision, error))?;
        if !response.real_part.is_certainly_positive() {
            return Err(ResonanceError::NotIsolated(precision));
        }
        self.subdivide(found).map(Uniqueness::Subdivision)
    }

    /// `w² <= 2|f|`, which implies `x' > 0` up to `w`: between `w_h` and `M x = pi` then `F' > 0`, so a zero of `F'`
    /// with `M x <= pi` lies below `w_h`.
    fn angle_increases(&self, w: &Interval) -> bool {
        let w = w.with_precision(64);
        (-(w.rational(&self.gains.f) * w.integer(2)) - w.square()).is_certainly_positive()
    }

    /// A sufficient condition for `M x(w) <= pi`: `|gamma - 1| <= 4/M²`, that is `w⁴ M⁴ <= 16 (f² + w² g²)`.
    fn phase_below_pi(&self, w: &Interval) -> bool {
        let w = w.with_precision(64);
        let gains = self.gains.map(|q| w.rational(q));
        let square = w.square();
        let m4 = w.integer(self.followers as i64).square().square();
        let bound = w.integer(16) * (gains.f.square() + square.clone() * gains.g.square());
        (bound - square.square() * m4).is_certainly_positive()
    }

    /// With `k = 1.2338 > pi²/8` and `b = g²/|f|`: `9 k b <= 8 M²` and `k <= 2 (M² - k b)` imply `w² g² <= 8 f²` and
    /// `w² <= 2|f|` for all `w <= w_h` (`notes/resonance.md`).
    fn analytic_conditions(&self) -> bool {
        let k = Interval::from_rational(&rational(12338, 10000), 64);
        let Ok(b) = k.rational(&self.gains.g).square().over(&-k.rational(&self.gains.f)) else { return false };
        let (kb, m2) = (k.clone() * b, k.integer(self.followers as i64).square());
        (k.integer(8) * &m2 - k.integer(9) * &kb).is_certainly_positive()
            && (k.integer(2) * (m2 - kb) - k).is_certainly_positive()
    }

    /// Covers `[w_1, w_h]` by pieces on which `F'` has one sign, or `F'' > 0` around the enclosed point. Below `w_1`
    /// every factor of `F` decreases (`notes/resonance.md`). Returns the number of pieces.
    fn subdivide(&self, found: &Resonance) -> Result<usize, ResonanceError> {
        const MOST_PIECES: usize = 20_000;
        let precision = 2 * size_bits(self.followers) + 96;
        let refuse = |error: ArithmeticError| ResonanceError::from((precision, error));
        let lowest = self.first_factor_minimum(precision).map_err(refuse)?;
        let highest = self.beyond_half_phase(found, precision)?;
        let mut pending = vec![Interval::between(lowest.lo().clone(), highest, precision)];
        let mut pieces = 0;
        while let Some(piece) = pending.pop() {
            pieces += 1;
            if pieces > MOST_PIECES {
                return Err(ResonanceError::NotIsolated(precision));
            }
            let decided = match self.at(&piece) {
                Ok(response) => {
                    let below = piece.is_below(&found.omega) && response.slope.is_certainly_negative();
                    let above = found.omega.is_below(&piece) && response.slope.is_certainly_positive();
                    below || above || response.curvature.is_certainly_positive()
                }
                Err(_) => false,
            };
            if !decided {
                let cut = piece.midpoint(precision);
                pending.push(Interval::between(piece.lo().clone(), cut.lo().clone(), precision));
                pending.push(Interval::between(cut.hi().clone(), piece.hi().clone(), precision));
            }
        }
        Ok(pieces)
    }

    /// Below the true first one: `b s² + 2 s = 2 d` with `d = 1/M² < d_1`, `w² = |f| s`.
    fn first_factor_minimum(&self, precision: u32) -> Result<Interval, ArithmeticError> {
        let f = Interval::from_rational(&-self.gains.f.clone(), precision);
        let b = Interval::from_rational(&self.gains.g, precision).square().over(&f)?;
        let d = f.integer(self.followers as i64).square().recip()?;
        // s = 2 d / (1 + sqrt(1 + 2 b d)).
        let two_d = d.clone() + d;
        let root = (b.one() + b * &two_d).sqrt()?;
        (f * two_d.over(&(root.clone() + root.one()))?).sqrt()
    }

    /// A frequency beyond `w_h`: `Re T_M < 0` while `M x <= pi`.
    fn beyond_half_phase(&self, found: &Resonance, precision: u32) -> Result<Dyadic, ResonanceError> {
        let start = found.omega.midpoint(precision);
        for step in 1..400 {
            let w = (start.clone() * start.ratio(100 + step, 100)).midpoint(precision);
            let response = self.at(&w).map_err(|error| (precision, error))?;
            if response.real_part.is_certainly_negative() {
                if !self.phase_below_pi(&w) {
                    break;
                }
                return Ok(w.hi().clone());
            }
        }
        Err(ResonanceError::NotIsolated(precision))
    }
}

/// The frequency of the main resonance in floating point, without any guarantee: where the enclosure starts.
///
/// Bisection on `y' sinh(2My) - x' sin(2Mx)`, a multiple of `F'`, in `s = w²/|f|`. `None` where the gains leave the
/// range of floats.
pub fn resonance_uncertified_start(gains: &Gains<Rational>, followers: u64) -> Option<f64> {
    let (f, g) = (-gains.f.to_f64()?, -gains.g.to_f64()?);
    let b = g / f * g;
    if ![f, g, b].iter().all(|x| (1e-100..1e100).contains(x)) {
        return None;
    }
    let m = followers as f64;
    let slope_sign = |s: f64| {
        let (x, y, tangent) = angles(s, b);
        if m * x >= std::f64::consts::FRAC_PI_2 {
            return true;
        }
        tangent * (2.0 * m * y).sinh() > (2.0 * m * x).sin()
    };
    let d = 1.0 / (m * m);
    let mut low = 2.0 * d / (1.0 + (1.0 + 2.0 * b * d).sqrt());
    let mut high = 2.0 * low;
    while !slope_sign(high) {
        low = high;
        high *= 2.0;
    }
    for _ in 0..64 {
        let middle = 0.5 * (low + high);
        if slope_sign(middle) { high = middle } else { low = middle }
    }
    Some((0.5 * (low + high)).sqrt() * f.sqrt())
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
