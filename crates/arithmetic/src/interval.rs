//! Outward-rounded intervals with dyadic endpoints, at any precision.

use super::dyadic::Round;
use super::elementary;
use super::number::{decimal, fixed, significant};
use super::operators::operators;
use super::{ArithmeticError, Dyadic, Field, Number, Rational, Real, Ring, Sign, Signed};
use num_bigint::BigInt;
use num_traits::ToPrimitive;

/// A closed interval `[lo, hi]` with `lo <= hi`, and the number of significant bits that results are rounded to.
///
/// Every operation returns an interval that contains the exact result for every choice of points in the operands.
/// The precision of a result is the smaller precision of the operands.
#[derive(Debug, Clone)]
pub struct Interval {
    lo: Dyadic,
    hi: Dyadic,
    precision: u32,
}

/// The smallest precision an interval can have, in bits.
const LEAST_PRECISION: u32 = 8;

impl Interval {
    /// The interval between two dyadics in either order, at `precision` bits (8 at least).
    pub fn between(a: Dyadic, b: Dyadic, precision: u32) -> Self {
        let precision = precision.max(LEAST_PRECISION);
        let (lo, hi) = if a <= b { (a, b) } else { (b, a) };
        Interval { lo: lo.rounded(precision, Round::Down), hi: hi.rounded(precision, Round::Up), precision }
    }

    /// The tightest enclosure of a rational at `precision` bits (8 at least).
    pub fn from_rational(q: &Rational, precision: u32) -> Self {
        let precision = precision.max(LEAST_PRECISION);
        Interval {
            lo: Dyadic::from_rational(q, precision, Round::Down),
            hi: Dyadic::from_rational(q, precision, Round::Up),
            precision,
        }
    }

    /// The enclosure of everything between two rationals, in either order.
    pub fn hull_of_rationals(a: &Rational, b: &Rational, precision: u32) -> Self {
        Interval::from_rational(a, precision).hull(&Interval::from_rational(b, precision))
    }

    /// The lower end.
    pub fn lo(&self) -> &Dyadic {
        &self.lo
    }

    /// The upper end.
    pub fn hi(&self) -> &Dyadic {
        &self.hi
    }

    /// Significant bits that the ends of results are rounded to; the ends of a [`hull`](Self::hull) may have more.
    pub fn precision(&self) -> u32 {
        self.precision
    }

    /// The same set, with later results rounded to `precision` bits.
    pub fn with_precision(&self, precision: u32) -> Self {
        Interval::between(self.lo.clone(), self.hi.clone(), precision)
    }

    /// Whether the rational lies in the interval.
    pub fn contains(&self, q: &Rational) -> bool {
        self.lo.to_rational() <= *q && *q <= self.hi.to_rational()
    }

    /// Whether zero lies in the interval.
    pub fn contains_zero(&self) -> bool {
        !self.lo.is_positive() && !self.hi.is_negative()
    }

    /// Whether the other interval lies inside this one.
    pub fn encloses(&self, other: &Self) -> bool {
        self.lo <= other.lo && other.hi <= self.hi
    }

    /// Whether the two intervals have a point in common.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.lo <= other.hi && other.lo <= self.hi
    }

    /// The smallest interval that contains both, with their ends as they are, whatever the smaller precision is.
    pub fn hull(&self, other: &Self) -> Self {
        Interval {
            lo: self.lo.clone().min(other.lo.clone()),
            hi: self.hi.clone().max(other.hi.clone()),
            precision: self.precision.min(other.precision),
        }
    }

    /// The interval of one point: the midpoint, exact up to the rounding to `precision` bits.
    pub fn midpoint(&self, precision: u32) -> Self {
        let middle = self.lo.midpoint(&self.hi).rounded(precision, Round::Down);
        Interval { lo: middle.clone(), hi: middle, precision }
    }

    /// The width, rounded up.
    pub fn width(&self) -> Dyadic {
        self.hi.add_rounded(&self.lo.negated(), self.precision, Round::Up)
    }

    /// Both endpoints as rationals.
    pub fn to_rationals(&self) -> (Rational, Rational) {
        (self.lo.to_rational(), self.hi.to_rational())
    }

    /// The midpoint as a float, without a bound.
    pub fn to_f64(&self) -> f64 {
        self.lo.midpoint(&self.hi).to_f64()
    }

    /// The largest absolute value in the interval.
    pub fn magnitude(&self) -> Dyadic {
        self.lo.absolute().max(self.hi.absolute())
    }

    /// `2^shift` times the interval, exactly.
    pub fn scaled(&self, shift: i64) -> Self {
        Interval { lo: self.lo.scaled(shift), hi: self.hi.scaled(shift), precision: self.precision }
    }

    fn map_monotone(
        &self,
        f: impl Fn(&Dyadic, u32) -> Result<(Dyadic, Dyadic), ArithmeticError>,
    ) -> Result<Self, ArithmeticError> {
        let (lo, mut hi) = f(&self.lo, self.precision)?;
        if self.lo != self.hi {
            hi = f(&self.hi, self.precision)?.1;
        }
        Ok(Interval::between(lo, hi, self.precision))
    }

    fn sum(a: &Self, b: &Self) -> Self {
        let precision = a.precision.min(b.precision);
        Interval {
            lo: a.lo.add_rounded(&b.lo, precision, Round::Down),
            hi: a.hi.add_rounded(&b.hi, precision, Round::Up),
            precision,
        }
    }

    fn difference(a: &Self, b: &Self) -> Self {
        Interval::sum(a, &Interval::negation(b))
    }

    fn negation(a: &Self) -> Self {
        Interval { lo: a.hi.negated(), hi: a.lo.negated(), precision: a.precision }
    }

    /// Endpoint products chosen by the signs of the operands; only two intervals around zero need all four.
    fn product(a: &Self, b: &Self) -> Self {
        let precision = a.precision.min(b.precision);
        let down = |x: &Dyadic, y: &Dyadic| x.mul_rounded(y, precision, Round::Down);
        let up = |x: &Dyadic, y: &Dyadic| x.mul_rounded(y, precision, Round::Up);
        let above = |x: &Self| !x.lo.is_negative();
        let below = |x: &Self| !x.hi.is_positive();
        let (lo, hi) = match (above(a), below(a), above(b), below(b)) {
            (true, _, true, _) => (down(&a.lo, &b.lo), up(&a.hi, &b.hi)),
            (true, _, _, true) => (down(&a.hi, &b.lo), up(&a.lo, &b.hi)),
            (_, true, true, _) => (down(&a.lo, &b.hi), up(&a.hi, &b.lo)),
            (_, true, _, true) => (down(&a.hi, &b.hi), up(&a.lo, &b.lo)),
            (true, _, _, _) => (down(&a.hi, &b.lo), up(&a.hi, &b.hi)),
            (_, true, _, _) => (down(&a.lo, &b.hi), up(&a.lo, &b.lo)),
            (_, _, true, _) => (down(&a.lo, &b.hi), up(&a.hi, &b.hi)),
            (_, _, _, true) => (down(&a.hi, &b.lo), up(&a.lo, &b.lo)),
            _ => (down(&a.lo, &b.hi).min(down(&a.hi, &b.lo)), up(&a.lo, &b.lo).max(up(&a.hi, &b.hi))),
        };
        Interval { lo, hi, precision }
    }
}

operators!([] Interval, Interval::sum, Interval::difference, Interval::product, Interval::negation);

impl Ring for Interval {
    fn integer(&self, n: i64) -> Self {
        let exact = Dyadic::new(BigInt::from(n), 0);
        Interval::between(exact.clone(), exact, self.precision)
    }

    fn square(&self) -> Self {
        let (small, large) = {
            let (a, b) = (self.lo.absolute(), self.hi.absolute());
            if a <= b { (a, b) } else { (b, a) }
        };
        let lo =
            if self.contains_zero() { Dyadic::zero() } else { small.mul_rounded(&small, self.precision, Round::Down) };
        Interval { lo, hi: large.mul_rounded(&large, self.precision, Round::Up), precision: self.precision }
    }
}

impl Field for Interval {
    fn rational(&self, q: &Rational) -> Self {
        Interval::from_rational(q, self.precision)
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        self.one().over(self)
    }

    fn over(&self, divisor: &Self) -> Result<Self, ArithmeticError> {
        if divisor.contains_zero() {
            return Err(ArithmeticError::DivisionByZero);
        }
        let precision = self.precision.min(divisor.precision);
        if divisor.hi.is_negative() {
            return Interval::negation(self).over(&Interval::negation(divisor));
        }
        let (for_lo, for_hi) = (
            if self.lo.is_negative() { &divisor.lo } else { &divisor.hi },
            if self.hi.is_negative() { &divisor.hi } else { &divisor.lo },
        );
        Ok(Interval {
            lo: self.lo.div_rounded(for_lo, precision, Round::Down),
            hi: self.hi.div_rounded(for_hi, precision, Round::Up),
            precision,
        })
    }
}

impl Number for Interval {
    #[inline]
    fn either(&self, other: &Self) -> Option<Self> {
        Some(self.hull(other))
    }

    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(self.pi())
    }

    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        if self.lo.is_negative() {
            return Err(ArithmeticError::Argument("sqrt"));
        }
        Ok(Interval {
            lo: self.lo.sqrt_rounded(self.precision, Round::Down),
            hi: self.hi.sqrt_rounded(self.precision, Round::Up),
            precision: self.precision,
        })
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        self.map_monotone(elementary::exp)
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        if !self.lo.is_positive() {
            return Err(ArithmeticError::Argument("ln"));
        }
        self.map_monotone(elementary::ln)
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        if self.magnitude().top() > elementary::LARGEST_ANGLE_TOP {
            let everything = self.one().hull(&self.integer(-1));
            return Ok((everything.clone(), everything));
        }
        let (sin_lo, cos_lo) = self.sin_cos_at(&self.lo);
        let (sin_hi, cos_hi) = self.sin_cos_at(&self.hi);
        let half = self.ratio(1, 2);
        // sin is extreme at (n + 1/2) pi, cos at n pi.
        let turns = self.over(&self.pi())?;
        let sin = include_extremes(sin_lo.hull(&sin_hi), &(turns.clone() - half));
        let cos = include_extremes(cos_lo.hull(&cos_hi), &turns);
        Ok((sin, cos))
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        self.map_monotone(|x, precision| Ok(elementary::atan(x, precision)))
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        let sinh = self.map_monotone(elementary::sinh)?;
        // cosh² = 1 + sinh², increasing in |sinh|: no cancellation.
        let cosh = (sinh.square() + self.one()).sqrt()?;
        Ok((sinh, cosh))
    }
}

impl Real for Interval {
    fn pi(&self) -> Self {
        let (lo, hi) = elementary::pi(self.precision);
        Interval::between(lo, hi, self.precision)
    }
}

impl Interval {
    fn sin_cos_at(&self, x: &Dyadic) -> (Self, Self) {
        let ((sin_lo, sin_hi), (cos_lo, cos_hi)) = elementary::sin_cos(x, self.precision);
        (Interval::between(sin_lo, sin_hi, self.precision), Interval::between(cos_lo, cos_hi, self.precision))
    }
}

/// Adds to the hull of two endpoint values the extremes at the integers that `turns` may contain: +1 at even ones, -1
/// at odd ones.
fn include_extremes(ends: Interval, turns: &Interval) -> Interval {
    let one = ends.one();
    let (first, last) = (-turns.lo.negated().floor(), turns.hi.floor());
    let count = (last - &first).to_i64().unwrap_or(i64::MAX);
    if count < 0 {
        return ends;
    }
    let first_extreme = if first.bit(0) { -one.clone() } else { one.clone() };
    let with_first = ends.hull(&first_extreme);
    if count == 0 { with_first } else { with_first.hull(&-first_extreme) }
}

impl Signed for Interval {
    fn sign(&self) -> Option<Sign> {
        if self.lo.is_positive() {
            Some(Sign::Positive)
        } else if self.hi.is_negative() {
            Some(Sign::Negative)
        } else if self.lo.is_zero() && self.hi.is_zero() {
            Some(Sign::Zero)
        } else {
            None
        }
    }

    fn absolute(&self) -> Result<Self, ArithmeticError> {
        Ok(match self.sign() {
            Some(Sign::Negative) => -self.clone(),
            None if self.contains_zero() => Interval::between(Dyadic::zero(), self.magnitude(), self.precision),
            _ => self.clone(),
        })
    }

    fn larger(&self, other: &Self) -> Result<Self, ArithmeticError> {
        let end = |a: &Dyadic, b: &Dyadic| a.max(b).clone();
        Ok(Interval::between(end(&self.lo, &other.lo), end(&self.hi, &other.hi), self.precision))
    }

    fn smaller(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(-(-self.clone()).larger(&-other.clone())?)
    }
}

impl std::fmt::Display for Interval {
    /// `[lo, hi]` in decimals that are rounded outward: as many digits after the point as the format asks for, otherwise 20
    /// significant ones.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (lo, hi) = self.to_rationals();
        let end = |q: &Rational, up: bool| match f.precision() {
            Some(places) => fixed(q, places, up),
            None => significant(q, up),
        };
        write!(f, "[{}, {}]", end(&lo, false), end(&hi, true))
    }
}

/// The enclosure of an interval as two decimals of `digits` significant digits, rounded outward.
pub fn decimals(x: &Interval, digits: u32) -> (String, String) {
    let (lo, hi) = x.to_rationals();
    (decimal(&lo, digits, false), decimal(&hi, digits, true))
}

/// How many significant decimal digits of a number are settled by knowing that it lies in the interval: the relative
/// width is at most `10^-digits`. Never too many; at most one too few.
pub fn significant_digits(x: &Interval) -> u32 {
    let width = x.width();
    if width.is_zero() {
        return u32::MAX;
    }
    if x.contains_zero() {
        return 0;
    }
    // width < 2^top(width), and the smaller end is at least 2^(top - 1).
    let size = x.lo().top().min(x.hi().top()) - 1;
    let bits = (size - width.top()).clamp(0, i64::from(u32::MAX)) as f64;
    (bits * std::f64::consts::LOG10_2).floor() as u32
}
