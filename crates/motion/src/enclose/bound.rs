//! Upper bounds in floats.

use std::iter::Sum;
use std::ops::{Add, Mul};

/// A number that is not negative and not below the one that is meant. Sums, products and quotients are rounded to nearest and moved up by one float, and so
/// are not below the exact ones: that lies within half a step of the rounded one, also where it is subnormal. What is not finite bounds nothing.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub(super) struct Bound(f64);

impl Bound {
    pub const ZERO: Self = Bound(0.0);

    /// More than `2^53` times the error of a product that underflows.
    pub const UNDERFLOW: Self = Bound(f64::MIN_POSITIVE);

    /// The absolute value.
    pub fn of(x: f64) -> Self {
        Bound(x.abs())
    }

    /// The sum of absolute values, each of which may have been rounded up to three times before. A sum of `n` floats that are not negative is at least
    /// `(1 - u)^(n-1)` times the exact one, and `(1 - u)^-k <= 1 + 2 k u` for `k u <= 1/2`, where `2 u` is the distance of the floats at 1.
    pub fn total(list: impl IntoIterator<Item = f64>) -> Self {
        let (mut sum, mut count) = (0.0, 3.0);
        for x in list {
            sum += x.abs();
            count += 1.0;
        }
        Bound(if sum == 0.0 { 0.0 } else { (sum * (1.0 + count * f64::EPSILON)).next_up() })
    }

    /// `sum a_k b_k`.
    pub fn dot(a: &[Self], b: &[Self]) -> Self {
        let sum = a.iter().zip(b).fold(0.0, |sum, (x, y)| sum + x.0 * y.0);
        // As many roundings of each product as there are terms, and what underflows.
        Bound((sum * (1.0 + (a.len() + 1) as f64 * f64::EPSILON)).next_up()) + Bound::UNDERFLOW
    }

    /// Divided by a number that is positive and not above the one that is meant.
    pub fn over(self, least: f64) -> Self {
        if self.0 == 0.0 { self } else { Bound((self.0 / least).next_up()) }
    }

    pub fn value(self) -> f64 {
        self.0
    }

    pub fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    /// The larger one; not a number where one is not.
    pub fn max(self, other: Self) -> Self {
        if self.0 >= other.0 || self.0.is_nan() { self } else { other }
    }
}

impl Add for Bound {
    type Output = Bound;
    fn add(self, other: Bound) -> Bound {
        match (self.0 == 0.0, other.0 == 0.0) {
            (true, _) => other,
            (_, true) => self,
            _ => Bound((self.0 + other.0).next_up()),
        }
    }
}

impl Mul for Bound {
    type Output = Bound;
    fn mul(self, other: Bound) -> Bound {
        if self.0 == 0.0 || other.0 == 0.0 { Bound::ZERO } else { Bound((self.0 * other.0).next_up()) }
    }
}

impl Mul<f64> for Bound {
    type Output = Bound;
    fn mul(self, factor: f64) -> Bound {
        self * Bound::of(factor)
    }
}

impl Sum for Bound {
    fn sum<I: Iterator<Item = Bound>>(list: I) -> Bound {
        list.fold(Bound::ZERO, Add::add)
    }
}

/// Bounds as plain numbers.
pub(super) fn values(list: &[Bound]) -> Vec<f64> {
    list.iter().map(|x| x.0).collect()
}
