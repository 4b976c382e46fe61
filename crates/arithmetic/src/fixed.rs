//! Fixed-point numbers with a running error bound: the inner loops of the elementary functions.

use super::Dyadic;
use num_bigint::BigInt;
use num_traits::{One, Signed};

/// A number known to lie within `error` units of `value`, where one unit is `2^-scale`.
///
/// The error counts units. The series that use this run for fewer than `2^32` terms, each of which adds a few units, and
/// at most [`MOST_SQUARINGS`](super::elementary::MOST_SQUARINGS) squarings follow, each of which multiplies the count by
/// less than 5: below `2^96`, it does not overflow.
#[derive(Debug, Clone)]
pub(super) struct Fixed {
    pub value: BigInt,
    pub error: u128,
    pub scale: u32,
}

impl Fixed {
    pub fn integer(n: i64, scale: u32) -> Self {
        Fixed { value: BigInt::from(n) << scale, error: 0, scale }
    }

    /// The dyadic, cut to the scale.
    pub fn from_dyadic(x: &Dyadic, scale: u32) -> Self {
        let shift = x.exponent() + i64::from(scale);
        if shift >= 0 {
            Fixed { value: x.mantissa() << shift as u64, error: 0, scale }
        } else {
            Fixed { value: x.mantissa() >> shift.unsigned_abs(), error: 1, scale }
        }
    }

    pub fn plus(&self, other: &Self) -> Self {
        Fixed { value: &self.value + &other.value, error: self.error + other.error, scale: self.scale }
    }

    pub fn minus(&self, other: &Self) -> Self {
        Fixed { value: &self.value - &other.value, error: self.error + other.error, scale: self.scale }
    }

    /// `|ab - AB| <= |A| e_b + |B| e_a + e_a e_b`, in units of `2^-2 scale`, plus one unit for the cut.
    pub fn times(&self, other: &Self) -> Self {
        let spread = |error: u128, factor: &BigInt| {
            let bits = factor.bits() as i64 - i64::from(self.scale);
            match error {
                0 => 0,
                e if bits >= 0 => e << bits,
                e => (e >> (-bits).min(127)) + 1,
            }
        };
        // Far below the range of floats; one unit covers the rounding of this small term.
        let both = self.error as f64 * other.error as f64 * 2f64.powi(-(self.scale.min(1000) as i32));
        let error = spread(other.error, &self.value) + spread(self.error, &other.value) + both.ceil() as u128 + 3;
        Fixed { value: (&self.value * &other.value) >> self.scale, error, scale: self.scale }
    }

    pub fn times_small(&self, factor: u32) -> Self {
        Fixed { value: &self.value * factor, error: self.error * u128::from(factor), scale: self.scale }
    }

    pub fn over_small(&self, divisor: u64) -> Self {
        Fixed { value: &self.value / divisor, error: self.error / u128::from(divisor) + 2, scale: self.scale }
    }

    /// The quotient; `|other|` must be at least 1/4 and its error small against it.
    pub fn over(&self, other: &Self) -> Self {
        let value = (&self.value << self.scale) / &other.value;
        // |a/b - A/B| <= (e_a + |A/B| e_b) / |b|, and |b| >= 1/8 of a unit-scale one.
        let growth = (value.bits() as i64 - i64::from(self.scale)).max(0);
        let error = 8 * (self.error + (other.error << growth)) + 2;
        Fixed { value, error, scale: self.scale }
    }

    /// Division by a power of two.
    pub fn halved(&self, times: u32) -> Self {
        Fixed { value: &self.value >> times, error: (self.error >> times.min(127)) + 2, scale: self.scale }
    }

    /// The same number at a smaller scale.
    pub fn rescaled(&self, scale: u32) -> Self {
        Fixed { scale, ..self.halved(self.scale - scale) }
    }

    pub fn negated(&self) -> Self {
        Fixed { value: -&self.value, error: self.error, scale: self.scale }
    }

    /// Whether the value is below one unit.
    pub fn is_negligible(&self) -> bool {
        self.value.abs() <= BigInt::one()
    }

    /// The enclosing endpoints, times `2^shift`.
    pub fn bounds(&self, shift: i64) -> (Dyadic, Dyadic) {
        let exponent = shift - i64::from(self.scale);
        let error = BigInt::from(self.error);
        (Dyadic::new(&self.value - &error, exponent), Dyadic::new(&self.value + &error, exponent))
    }
}
