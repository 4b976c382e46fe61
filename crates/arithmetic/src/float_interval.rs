//! Intervals of floats: two words on the stack, for long integrations with proved bounds; [`Interval`] is the general type.
//!
//! Every operation rounds to nearest and then steps to the next float outwards, which needs no rounding modes: the exact result
//! lies within half a step of the rounded one.

use super::number::{fixed, significant};
use super::operators::operators;
use super::{ArithmeticError, Dyadic, Field, Interval, Number, Rational, Real, Ring, Sign, Signed};

/// From `lo` to `hi`. A result that may not be finite becomes the whole line, and stays it; a square becomes `[0, ∞)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloatInterval {
    lo: f64,
    hi: f64,
}

/// Bits asked of the enclosure of a rational that is not a float.
const BITS: u32 = 80;

impl FloatInterval {
    /// All real numbers.
    pub const LINE: Self = FloatInterval { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// Zero alone.
    pub const ZERO: Self = FloatInterval { lo: 0.0, hi: 0.0 };

    /// One number; all of them where it is not finite.
    #[inline]
    pub fn point(x: f64) -> Self {
        FloatInterval::between(x, x)
    }

    /// The numbers between two, in either order; all of them where one is not finite.
    #[inline]
    pub fn between(a: f64, b: f64) -> Self {
        if a.is_finite() && b.is_finite() { FloatInterval { lo: a.min(b), hi: a.max(b) } } else { FloatInterval::LINE }
    }

    /// An enclosure of a rational.
    #[inline]
    pub fn from_rational(q: &Rational) -> Self {
        // Words that floats hold: their quotient is rounded once, and exact where the denominator is a power of two.
        const EXACT: u64 = 1 << f64::MANTISSA_DIGITS;
        if let Some((p, q)) = q.words().filter(|(p, q)| p.unsigned_abs() <= EXACT && q.unsigned_abs() <= EXACT) {
            let x = p as f64 / q as f64;
            return if (q as u64).is_power_of_two() { FloatInterval::point(x) } else { FloatInterval::outward(x, x) };
        }
        let enclosure = Interval::from_rational(q, BITS);
        let (lo, hi) = (enclosure.lo().to_f64(), enclosure.hi().to_f64());
        // Floats that are themselves the ends of the enclosure need no step.
        if lo == hi && super::Dyadic::from_f64(lo).is_some_and(|x| x.to_rational() == *q) {
            FloatInterval::point(lo)
        } else {
            FloatInterval::outward(lo, hi)
        }
    }

    /// An enclosure of an interval between dyadics.
    pub fn from_interval(x: &Interval) -> Self {
        match (x.lo().is_zero(), x.hi().is_zero()) {
            (true, true) => FloatInterval::point(0.0),
            _ => FloatInterval::outward(x.lo().to_f64(), x.hi().to_f64()),
        }
    }

    /// The lower end.
    #[inline]
    pub fn lo(&self) -> f64 {
        self.lo
    }

    /// The upper end.
    #[inline]
    pub fn hi(&self) -> f64 {
        self.hi
    }

    /// A number in the interval: the midpoint, or zero for the whole line.
    #[inline]
    pub fn midpoint(&self) -> f64 {
        if self.is_bounded() { self.lo.midpoint(self.hi).clamp(self.lo, self.hi) } else { 0.0 }
    }

    /// The width, rounded up.
    #[inline]
    pub fn width(&self) -> f64 {
        if self.lo == self.hi { 0.0 } else { (self.hi - self.lo).next_up() }
    }

    /// The largest absolute value.
    #[inline]
    pub fn magnitude(&self) -> f64 {
        self.hi.max(-self.lo)
    }

    /// Whether both ends are finite.
    #[inline]
    pub fn is_bounded(&self) -> bool {
        self.lo.is_finite() && self.hi.is_finite()
    }

    /// Whether the number lies in the interval.
    #[inline]
    pub fn contains(&self, x: f64) -> bool {
        self.lo <= x && x <= self.hi
    }

    /// The smallest interval that contains both.
    #[inline]
    pub fn hull(&self, other: &Self) -> Self {
        FloatInterval { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The numbers in both; `None` where there is none.
    #[inline]
    pub fn intersection(&self, other: &Self) -> Option<Self> {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        (lo <= hi).then_some(FloatInterval { lo, hi })
    }

    /// Ends rounded to nearest, moved outwards.
    #[inline]
    fn outward(lo: f64, hi: f64) -> Self {
        let (lo, hi) = (lo.next_down(), hi.next_up());
        // Also where an end is not a number.
        if lo.is_finite() && hi.is_finite() { FloatInterval { lo, hi } } else { FloatInterval::LINE }
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.lo == 0.0 && self.hi == 0.0
    }

    #[inline]
    fn plus(a: &Self, b: &Self) -> Self {
        match (a.is_zero(), b.is_zero()) {
            (true, _) => *b,
            (_, true) => *a,
            _ => FloatInterval::outward(a.lo + b.lo, a.hi + b.hi),
        }
    }

    #[inline]
    fn minus(a: &Self, b: &Self) -> Self {
        FloatInterval::plus(a, &FloatInterval::negated(b))
    }

    #[inline]
    fn negated(a: &Self) -> Self {
        FloatInterval { lo: -a.hi, hi: -a.lo }
    }

    #[inline]
    fn times(a: &Self, b: &Self) -> Self {
        if a.is_zero() || b.is_zero() {
            return FloatInterval { lo: 0.0, hi: 0.0 };
        }
        if !(a.is_bounded() && b.is_bounded()) {
            return FloatInterval::LINE;
        }
        let products = [a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi];
        let least = products.into_iter().fold(f64::INFINITY, f64::min);
        FloatInterval::outward(least, products.into_iter().fold(f64::NEG_INFINITY, f64::max))
    }
}

operators!([] FloatInterval, FloatInterval::plus, FloatInterval::minus, FloatInterval::times, FloatInterval::negated);

impl Ring for FloatInterval {
    #[inline]
    fn integer(&self, n: i64) -> Self {
        let value = n as f64;
        if n.unsigned_abs() <= 1 << f64::MANTISSA_DIGITS {
            FloatInterval::point(value)
        } else {
            FloatInterval::outward(value, value)
        }
    }

    #[inline]
    fn square(&self) -> Self {
        if self.is_zero() || !self.is_bounded() {
            return *self;
        }
        let (a, b) = (self.lo * self.lo, self.hi * self.hi);
        let square = FloatInterval::outward(a.min(b), a.max(b));
        FloatInterval { lo: if self.contains(0.0) { 0.0 } else { square.lo.max(0.0) }, hi: square.hi }
    }
}

impl Field for FloatInterval {
    #[inline]
    fn rational(&self, q: &Rational) -> Self {
        FloatInterval::from_rational(q)
    }

    #[inline]
    fn recip(&self) -> Result<Self, ArithmeticError> {
        if self.contains(0.0) {
            return Err(ArithmeticError::DivisionByZero);
        }
        Ok(FloatInterval::outward(1.0 / self.hi, 1.0 / self.lo))
    }

    #[inline]
    fn ratio(&self, p: i64, q: i64) -> Self {
        let (value, exact) = (p as f64 / q as f64, 1u64 << f64::MANTISSA_DIGITS);
        if p.unsigned_abs() > exact || q.unsigned_abs() > exact {
            self.rational(&super::rational(p, q))
        } else if q.unsigned_abs().is_power_of_two() {
            FloatInterval::point(value)
        } else {
            FloatInterval::outward(value, value)
        }
    }
}

impl FloatInterval {
    /// The general enclosure; where an end is not finite, the argument lies outside the domain of `function`.
    fn general(&self, function: &'static str) -> Result<Interval, ArithmeticError> {
        let ends = Dyadic::from_f64(self.lo).zip(Dyadic::from_f64(self.hi));
        let (lo, hi) = ends.ok_or(ArithmeticError::Argument(function))?;
        Ok(Interval::between(lo, hi, BITS))
    }

    /// A function of the general enclosure.
    fn by(
        &self,
        name: &'static str,
        function: impl Fn(&Interval) -> Result<Interval, ArithmeticError>,
    ) -> Result<Self, ArithmeticError> {
        Ok(FloatInterval::from_interval(&function(&self.general(name)?)?))
    }
}

/// Functions by those of [`Interval`], rounded outward.
impl Number for FloatInterval {
    #[inline]
    fn either(&self, other: &Self) -> Option<Self> {
        Some(self.hull(other))
    }

    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(self.pi())
    }

    /// The root of a float is rounded to nearest, as its sum and product.
    #[inline]
    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        if self.lo < 0.0 || !self.is_bounded() {
            return Err(ArithmeticError::Argument("sqrt"));
        }
        if self.is_zero() {
            return Ok(*self);
        }
        let root = FloatInterval::outward(self.lo.sqrt(), self.hi.sqrt());
        Ok(FloatInterval { lo: root.lo.max(0.0), hi: root.hi })
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        if self.is_zero() { Ok(FloatInterval::point(1.0)) } else { self.by("exp", Interval::exp) }
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        self.by("ln", Interval::ln)
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        let (sin, cos) = self.general("sin")?.sin_cos()?;
        Ok((FloatInterval::from_interval(&sin), FloatInterval::from_interval(&cos)))
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        self.by("atan", Interval::atan)
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        let (sinh, cosh) = self.general("sinh")?.sinh_cosh()?;
        Ok((FloatInterval::from_interval(&sinh), FloatInterval::from_interval(&cosh)))
    }
}

impl Real for FloatInterval {
    fn pi(&self) -> Self {
        // The float below pi; the next one is above.
        let below = std::f64::consts::PI;
        FloatInterval { lo: below, hi: below.next_up() }
    }
}

impl Signed for FloatInterval {
    #[inline]
    fn sign(&self) -> Option<Sign> {
        match (self.lo > 0.0, self.hi < 0.0, self.is_zero()) {
            (true, _, _) => Some(Sign::Positive),
            (_, true, _) => Some(Sign::Negative),
            (_, _, true) => Some(Sign::Zero),
            _ => None,
        }
    }

    fn absolute(&self) -> Result<Self, ArithmeticError> {
        Ok(match self.sign() {
            Some(Sign::Negative) => FloatInterval::negated(self),
            Some(_) => *self,
            None => FloatInterval { lo: if self.contains(0.0) { 0.0 } else { self.lo }, hi: self.magnitude() },
        })
    }

    fn larger(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(FloatInterval { lo: self.lo.max(other.lo), hi: self.hi.max(other.hi) })
    }

    fn smaller(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(FloatInterval { lo: self.lo.min(other.lo), hi: self.hi.min(other.hi) })
    }
}

impl std::fmt::Display for FloatInterval {
    /// As [`Interval`] prints itself; an end that is not finite as `-inf` or `inf`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let end = |x: f64, up: bool| match (super::Dyadic::from_f64(x), f.precision()) {
            (None, _) => x.to_string(),
            (Some(x), Some(places)) => fixed(&x.to_rational(), places, up),
            (Some(x), None) => significant(&x.to_rational(), up),
        };
        write!(f, "[{}, {}]", end(self.lo, false), end(self.hi, true))
    }
}
