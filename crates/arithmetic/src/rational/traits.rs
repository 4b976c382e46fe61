//! Rationals among the traits of `num_traits` and of the standard library: rounding, powers, texts, floats.

use super::{Parts, Rational, Sign, Signed};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::float::FloatCore;
use num_traits::{Num, One, ToPrimitive, Zero};
use std::fmt;
use std::str::FromStr;

impl Rational {
    /// The exact value of a finite float; `None` for an infinity or NaN.
    pub fn from_float<F: FloatCore>(x: F) -> Option<Self> {
        BigRational::from_float(x).map(|q| Rational::of_lowest_terms(q.numer().clone(), q.denom().clone()))
    }

    /// The integer part, towards zero.
    pub fn to_integer(&self) -> BigInt {
        match &self.0 {
            Parts::Small(p, q) => BigInt::from(p / q),
            Parts::Big(parts) => &parts.0 / &parts.1,
        }
    }

    /// The largest integer that is not above the number.
    pub fn floor(&self) -> Self {
        match &self.0 {
            Parts::Small(p, q) => Rational(Parts::Small(p.div_euclid(*q), 1)),
            Parts::Big(parts) => Rational::from_integer(parts.0.div_floor(&parts.1)),
        }
    }

    /// The smallest integer that is not below the number.
    pub fn ceil(&self) -> Self {
        -(-self).floor()
    }

    /// The integer part, towards zero.
    pub fn trunc(&self) -> Self {
        Rational::from_integer(self.to_integer())
    }

    /// What the integer part leaves, with the sign of the number.
    pub fn fract(&self) -> Self {
        self - self.trunc()
    }

    /// The nearest integer, halves away from zero.
    pub fn round(&self) -> Self {
        let half = super::rational(1, 2);
        match Signed::sign(self) {
            Some(Sign::Negative) => (self - half).ceil(),
            _ => (self + half).floor(),
        }
    }

    /// An integer power.
    ///
    /// # Panics
    /// For zero to a negative power, like a division.
    pub fn pow(&self, exponent: i32) -> Self {
        let base = if exponent < 0 { self.recip() } else { self.clone() };
        super::Ring::power(&base, u64::from(exponent.unsigned_abs()))
    }

    fn to_ratio(&self) -> BigRational {
        BigRational::new_raw(self.numer(), self.denom())
    }
}

impl Default for Rational {
    fn default() -> Self {
        Rational::ZERO
    }
}

impl Zero for Rational {
    fn zero() -> Self {
        Rational::ZERO
    }

    #[inline]
    fn is_zero(&self) -> bool {
        matches!(self.0, Parts::Small(0, _))
    }
}

impl One for Rational {
    fn one() -> Self {
        Rational::ONE
    }
}

impl Num for Rational {
    type FromStrRadixErr = NoRational;

    fn from_str_radix(text: &str, radix: u32) -> Result<Self, NoRational> {
        let (p, q) = text.split_once('/').unwrap_or((text, "1"));
        let read = |part| BigInt::from_str_radix(part, radix).map_err(|_| NoRational);
        let (p, q) = (read(p)?, read(q)?);
        if q.is_zero() { Err(NoRational) } else { Ok(Rational::new(p, q)) }
    }
}

impl num_traits::Signed for Rational {
    fn abs(&self) -> Self {
        if num_traits::Signed::is_negative(self) { -self } else { self.clone() }
    }

    fn abs_sub(&self, other: &Self) -> Self {
        if self <= other { Rational::ZERO } else { self - other }
    }

    fn signum(&self) -> Self {
        match Signed::sign(self) {
            Some(Sign::Positive) => Rational::ONE,
            Some(Sign::Negative) => -Rational::ONE,
            _ => Rational::ZERO,
        }
    }

    fn is_positive(&self) -> bool {
        Signed::sign(self) == Some(Sign::Positive)
    }

    fn is_negative(&self) -> bool {
        Signed::sign(self) == Some(Sign::Negative)
    }
}

impl ToPrimitive for Rational {
    fn to_i64(&self) -> Option<i64> {
        self.to_integer().to_i64()
    }

    fn to_u64(&self) -> Option<u64> {
        self.to_integer().to_u64()
    }

    fn to_i128(&self) -> Option<i128> {
        self.to_integer().to_i128()
    }

    fn to_u128(&self) -> Option<u128> {
        self.to_integer().to_u128()
    }

    /// Rounded to nearest.
    fn to_f64(&self) -> Option<f64> {
        const EXACT: u64 = 1 << 53;
        match &self.0 {
            Parts::Small(p, q) if p.unsigned_abs() <= EXACT && q.unsigned_abs() <= EXACT => Some(*p as f64 / *q as f64),
            _ => self.to_ratio().to_f64(),
        }
    }
}

impl From<BigInt> for Rational {
    fn from(n: BigInt) -> Self {
        Rational::from_integer(n)
    }
}

impl From<&BigRational> for Rational {
    /// The same number, also where it was put together with [`BigRational::new_raw`] and is not in lowest terms.
    ///
    /// # Panics
    /// Where the denominator is zero: such a one is no number to num-rational, either.
    fn from(q: &BigRational) -> Self {
        Rational::new(q.numer().clone(), q.denom().clone())
    }
}

impl From<BigRational> for Rational {
    /// As from a reference.
    fn from(q: BigRational) -> Self {
        let (numerator, denominator) = q.into_raw();
        Rational::new(numerator, denominator)
    }
}

impl From<&Rational> for BigRational {
    fn from(q: &Rational) -> Self {
        q.to_ratio()
    }
}

impl From<Rational> for BigRational {
    fn from(q: Rational) -> Self {
        q.to_ratio()
    }
}

impl std::iter::Sum for Rational {
    fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
        terms.fold(Rational::ZERO, |sum, term| sum + term)
    }
}

impl<'a> std::iter::Sum<&'a Rational> for Rational {
    fn sum<I: Iterator<Item = &'a Self>>(terms: I) -> Self {
        terms.fold(Rational::ZERO, |sum, term| sum + term)
    }
}

impl std::iter::Product for Rational {
    fn product<I: Iterator<Item = Self>>(factors: I) -> Self {
        factors.fold(Rational::ONE, |product, factor| product * factor)
    }
}

impl<'a> std::iter::Product<&'a Rational> for Rational {
    fn product<I: Iterator<Item = &'a Self>>(factors: I) -> Self {
        factors.fold(Rational::ONE, |product, factor| product * factor)
    }
}

/// A text that is no rational `p` or `p/q`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("not a rational p or p/q")]
pub struct NoRational;

impl FromStr for Rational {
    type Err = NoRational;

    fn from_str(text: &str) -> Result<Self, NoRational> {
        Rational::from_str_radix(text, 10)
    }
}

impl fmt::Display for Rational {
    /// `p`, or `p/q`.
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = match &self.0 {
            Parts::Small(p, 1) => p.unsigned_abs().to_string(),
            Parts::Small(p, q) => format!("{}/{q}", p.unsigned_abs()),
            Parts::Big(_) if self.is_integer() => self.numer().magnitude().to_string(),
            Parts::Big(parts) => format!("{}/{}", parts.0.magnitude(), parts.1),
        };
        to.pad_integral(!num_traits::Signed::is_negative(self), "", &text)
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, to)
    }
}
