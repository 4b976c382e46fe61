//! What scalars that enclose real numbers have in common.

use super::{Ball, Dyadic, FloatInterval, Interval, Rational, Ring};

/// A scalar that stands for a set of real numbers, an interval, and whose operations enclose those of all its numbers. Scalars that round do not
/// belong here.
pub trait Enclosure: Ring {
    /// Everything between two rationals, in either order, with the precision of `self`.
    fn around(&self, a: &Rational, b: &Rational) -> Self;

    /// A float that is not above any number of the set; minus infinity where there is none.
    fn lower(&self) -> f64;

    /// A float that is not below any number of the set; infinity where there is none.
    fn upper(&self) -> f64;

    /// The ends, exactly; `None` where the set is not bounded.
    fn ends(&self) -> Option<(Rational, Rational)>;

    /// The narrowest scalar around both.
    fn joined(&self, other: &Self) -> Self;

    /// The narrowest scalar around the numbers of both; `None` where it is certain that there is none.
    fn common(&self, other: &Self) -> Option<Self>;

    /// A scalar of one number of the set, near its middle; zero where the set is not bounded.
    fn middle(&self) -> Self;

    /// The difference of the ends, rounded up.
    #[inline]
    fn spread(&self) -> f64 {
        let (lower, upper) = (self.lower(), self.upper());
        if lower == upper { 0.0 } else { (upper - lower).next_up() }
    }

    /// The largest absolute value, rounded up.
    #[inline]
    fn largest(&self) -> f64 {
        self.upper().max(-self.lower())
    }
}

impl Enclosure for FloatInterval {
    fn around(&self, a: &Rational, b: &Rational) -> Self {
        FloatInterval::from_rational(a).hull(&FloatInterval::from_rational(b))
    }

    #[inline]
    fn lower(&self) -> f64 {
        self.lo()
    }

    #[inline]
    fn upper(&self) -> f64 {
        self.hi()
    }

    fn ends(&self) -> Option<(Rational, Rational)> {
        Some((Dyadic::from_f64(self.lo())?.to_rational(), Dyadic::from_f64(self.hi())?.to_rational()))
    }

    #[inline]
    fn joined(&self, other: &Self) -> Self {
        self.hull(other)
    }

    #[inline]
    fn common(&self, other: &Self) -> Option<Self> {
        self.intersection(other)
    }

    #[inline]
    fn middle(&self) -> Self {
        FloatInterval::point(self.midpoint())
    }
}

/// The float at or below a dyadic.
fn below(x: &Dyadic) -> f64 {
    let near = x.to_f64();
    if Dyadic::from_f64(near).is_some_and(|float| float <= *x) { near } else { near.next_down() }
}

impl Enclosure for Interval {
    fn around(&self, a: &Rational, b: &Rational) -> Self {
        Interval::hull_of_rationals(a, b, self.precision())
    }

    fn lower(&self) -> f64 {
        below(self.lo())
    }

    fn upper(&self) -> f64 {
        -below(&self.hi().negated())
    }

    fn ends(&self) -> Option<(Rational, Rational)> {
        Some(self.to_rationals())
    }

    fn joined(&self, other: &Self) -> Self {
        self.hull(other)
    }

    fn common(&self, other: &Self) -> Option<Self> {
        let (lo, hi) = (self.lo().max(other.lo()), self.hi().min(other.hi()));
        let precision = self.precision().min(other.precision());
        (lo <= hi).then(|| Interval::between(lo.clone(), hi.clone(), precision))
    }

    fn middle(&self) -> Self {
        self.midpoint(self.precision())
    }
}

/// Bits in which the ends of a ball are taken: enough for every number that a ball holds.
const fn bits_of(limbs: usize) -> u32 {
    64 * (limbs as u32 + 1)
}

/// Where a result has overflowed there are no ends.
impl<const LIMBS: usize> Enclosure for Ball<LIMBS> {
    fn around(&self, a: &Rational, b: &Rational) -> Self {
        Ball::from_interval(&Interval::hull_of_rationals(a, b, bits_of(LIMBS)))
    }

    fn lower(&self) -> f64 {
        self.to_interval(bits_of(LIMBS)).map_or(f64::NEG_INFINITY, |x| x.lower())
    }

    fn upper(&self) -> f64 {
        self.to_interval(bits_of(LIMBS)).map_or(f64::INFINITY, |x| x.upper())
    }

    fn ends(&self) -> Option<(Rational, Rational)> {
        self.to_interval(bits_of(LIMBS)).map(|x| x.to_rationals())
    }

    fn joined(&self, other: &Self) -> Self {
        match (self.to_interval(bits_of(LIMBS)), other.to_interval(bits_of(LIMBS))) {
            (Some(a), Some(b)) => Ball::from_interval(&a.hull(&b)),
            (None, _) => self.clone(),
            _ => other.clone(),
        }
    }

    fn common(&self, other: &Self) -> Option<Self> {
        match (self.to_interval(bits_of(LIMBS)), other.to_interval(bits_of(LIMBS))) {
            (Some(a), Some(b)) => a.common(&b).map(|x| Ball::from_interval(&x)),
            (None, _) => Some(other.clone()),
            _ => Some(self.clone()),
        }
    }

    fn middle(&self) -> Self {
        let middle = self.to_interval(bits_of(LIMBS)).map(|x| x.middle());
        middle.map_or_else(|| self.zero(), |x| Ball::from_interval(&x))
    }
}
