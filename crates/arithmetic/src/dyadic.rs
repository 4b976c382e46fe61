//! Dyadic numbers `m 2^e`: the endpoints of intervals, with directed rounding.

use super::Rational;
use num_bigint::{BigInt, BigUint, Sign};
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cmp::Ordering;

/// Direction of rounding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Round {
    Down,
    Up,
}

/// The exact number `mantissa * 2^exponent`.
#[derive(Debug, Clone)]
pub struct Dyadic {
    mantissa: BigInt,
    exponent: i64,
}

impl Dyadic {
    /// `mantissa * 2^exponent`.
    pub fn new(mantissa: BigInt, exponent: i64) -> Self {
        Dyadic { mantissa, exponent }
    }

    /// Zero.
    pub fn zero() -> Self {
        Dyadic { mantissa: BigInt::ZERO, exponent: 0 }
    }

    /// The exact value of a finite float, or `None` for an infinity or NaN.
    pub fn from_f64(x: f64) -> Option<Self> {
        let (mantissa, exponent, sign) = num_traits::float::FloatCore::integer_decode(x);
        x.is_finite().then(|| Dyadic::new(BigInt::from(mantissa) * BigInt::from(sign), i64::from(exponent)))
    }

    /// The integer factor.
    pub fn mantissa(&self) -> &BigInt {
        &self.mantissa
    }

    /// The power of two.
    pub fn exponent(&self) -> i64 {
        self.exponent
    }

    /// Whether this is zero.
    pub fn is_zero(&self) -> bool {
        self.mantissa.is_zero()
    }

    /// Whether this is less than zero.
    pub fn is_negative(&self) -> bool {
        self.mantissa.sign() == Sign::Minus
    }

    /// Whether this is greater than zero.
    pub fn is_positive(&self) -> bool {
        self.mantissa.sign() == Sign::Plus
    }

    /// The smallest `k` with `|self| < 2^k`; for zero the smallest exponent there is.
    pub fn top(&self) -> i64 {
        if self.is_zero() { i64::MIN / 4 } else { self.exponent + self.mantissa.bits() as i64 }
    }

    /// The exact value as a rational.
    pub fn to_rational(&self) -> Rational {
        if self.exponent >= 0 {
            Rational::from_integer(&self.mantissa << self.exponent as u64)
        } else {
            // Twos are all that can be cancelled.
            let twos = self.mantissa.trailing_zeros().unwrap_or(u64::MAX).min(self.exponent.unsigned_abs());
            Rational::of_lowest_terms(&self.mantissa >> twos, BigInt::one() << (self.exponent.unsigned_abs() - twos))
        }
    }

    /// The value rounded to a float (not in a guaranteed direction).
    pub fn to_f64(&self) -> f64 {
        let bits = self.mantissa.bits() as i64;
        let shift = (bits - 64).max(0);
        let head = (&self.mantissa >> shift as u64).to_f64().unwrap_or(f64::NAN);
        let power = (self.exponent + shift).clamp(-2200, 2200) as i32;
        head * 2f64.powi(power / 2) * 2f64.powi(power - power / 2)
    }

    /// The mean of two dyadics, exact.
    pub fn midpoint(&self, other: &Self) -> Self {
        let sum = self.plus(other);
        Dyadic { mantissa: sum.mantissa, exponent: sum.exponent - 1 }
    }

    /// The exact sum.
    pub fn plus(&self, other: &Self) -> Self {
        if self.is_zero() {
            return other.clone();
        }
        if other.is_zero() {
            return self.clone();
        }
        let (high, low) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let gap = (high.exponent - low.exponent) as u64;
        let mantissa = if gap == 0 { &high.mantissa + &low.mantissa } else { (&high.mantissa << gap) + &low.mantissa };
        Dyadic { mantissa, exponent: low.exponent }
    }

    /// The negated number.
    pub fn negated(&self) -> Self {
        Dyadic { mantissa: -&self.mantissa, exponent: self.exponent }
    }

    /// `2^shift` times the number.
    pub fn scaled(&self, shift: i64) -> Self {
        Dyadic { mantissa: self.mantissa.clone(), exponent: self.exponent + shift }
    }

    /// Rounded to at most `bits` significant bits.
    pub(super) fn rounded(self, bits: u32, round: Round) -> Self {
        let excess = self.mantissa.bits() as i64 - i64::from(bits);
        if excess <= 0 {
            return self;
        }
        let (sign, magnitude) = self.mantissa.into_parts();
        let away = matches!((sign, round), (Sign::Plus, Round::Up) | (Sign::Minus, Round::Down));
        let exact = away && magnitude.trailing_zeros().is_some_and(|zeros| zeros >= excess as u64);
        let mut kept: BigUint = magnitude >> excess as u64;
        let mut exponent = self.exponent + excess;
        if away && !exact {
            kept += 1u32;
            if kept.bits() > u64::from(bits) {
                // A carry all the way: a power of two.
                kept >>= 1u32;
                exponent += 1;
            }
        }
        Dyadic { mantissa: BigInt::from_biguint(sign, kept), exponent }
    }

    pub(super) fn add_rounded(&self, other: &Self, bits: u32, round: Round) -> Self {
        let (big, small) = if self.top() >= other.top() { (self, other) } else { (other, self) };
        let span = i64::from(bits).max(big.mantissa.bits() as i64) + 4;
        if !small.is_zero() && big.top() - small.top() > span {
            // The small part only decides which way the big one is rounded.
            let nudge = match (small.is_negative(), round) {
                (false, Round::Down) | (true, Round::Up) => return big.clone().rounded(bits, round),
                (negative, _) => Dyadic::new(BigInt::from(if negative { -1 } else { 1 }), big.top() - span),
            };
            return big.plus(&nudge).rounded(bits, round);
        }
        big.plus(small).rounded(bits, round)
    }

    pub(super) fn mul_rounded(&self, other: &Self, bits: u32, round: Round) -> Self {
        Dyadic { mantissa: &self.mantissa * &other.mantissa, exponent: self.exponent + other.exponent }
            .rounded(bits, round)
    }

    /// The quotient; the divisor must not be zero.
    pub(super) fn div_rounded(&self, divisor: &Self, bits: u32, round: Round) -> Self {
        let shift = (i64::from(bits) + 2 + divisor.mantissa.bits() as i64 - self.mantissa.bits() as i64).max(0);
        let numerator = &self.mantissa << shift as u64;
        let quotient = match round {
            Round::Down => numerator.div_floor(&divisor.mantissa),
            Round::Up => -(-numerator).div_floor(&divisor.mantissa),
        };
        Dyadic { mantissa: quotient, exponent: self.exponent - divisor.exponent - shift }.rounded(bits, round)
    }

    /// The square root of a non-negative number.
    pub(super) fn sqrt_rounded(&self, bits: u32, round: Round) -> Self {
        let mut shift = (2 * i64::from(bits) + 2 - self.mantissa.bits() as i64).max(0);
        if (self.exponent - shift).is_odd() {
            shift += 1;
        }
        let radicand = self.mantissa.magnitude() << shift as u64;
        let mut root = radicand.sqrt();
        if round == Round::Up && &root * &root != radicand {
            root += 1u32;
        }
        Dyadic { mantissa: BigInt::from(root), exponent: (self.exponent - shift) / 2 }.rounded(bits, round)
    }

    /// The nearest dyadic of `bits` significant bits on one side of a rational.
    pub(super) fn from_rational(q: &Rational, bits: u32, round: Round) -> Self {
        let numerator = Dyadic::new(q.numer(), 0);
        if q.is_integer() {
            return numerator.rounded(bits, round);
        }
        numerator.div_rounded(&Dyadic::new(q.denom(), 0), bits, round)
    }

    /// The largest integer that is not above the number.
    pub fn floor(&self) -> BigInt {
        if self.exponent >= 0 {
            &self.mantissa << self.exponent as u64
        } else {
            // BigInt's shift to the right rounds down.
            &self.mantissa >> self.exponent.unsigned_abs()
        }
    }

    /// The absolute value.
    pub fn absolute(&self) -> Self {
        Dyadic { mantissa: self.mantissa.abs(), exponent: self.exponent }
    }
}

impl PartialEq for Dyadic {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Dyadic {}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Self) -> Ordering {
        let signs = self.mantissa.signum().cmp(&other.mantissa.signum());
        if signs != Ordering::Equal || self.is_zero() {
            return signs;
        }
        if self.exponent == other.exponent {
            return self.mantissa.cmp(&other.mantissa);
        }
        let tops = self.top().cmp(&other.top());
        if tops != Ordering::Equal {
            return if self.is_negative() { tops.reverse() } else { tops };
        }
        self.plus(&other.negated()).mantissa.sign().cmp(&Sign::NoSign)
    }
}
