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

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of all sizes, with errors of all sizes.
    fn numbers(scale: u32) -> Vec<Fixed> {
        let one = BigInt::one() << scale;
        let values: Vec<BigInt> =
            [0, 1, -3, 700].map(BigInt::from).into_iter().chain([1, -5, 37].map(|n| &one * n + 11)).collect();
        let errors = [0, 1, 7, 1000, 1 << 20];
        let with = |value: &BigInt| errors.map(|error| Fixed { value: value.clone(), error, scale });
        values.iter().flat_map(with).collect()
    }

    /// The two numbers at the ends of the error.
    fn ends(x: &Fixed) -> [BigInt; 2] {
        [&x.value - BigInt::from(x.error), &x.value + BigInt::from(x.error)]
    }

    /// How far the exact value, a quotient, is from the value, in units, rounded up.
    fn distance(x: &Fixed, numerator: &BigInt, denominator: &BigInt) -> BigInt {
        let off = (numerator - &x.value * denominator).abs();
        (off + denominator.abs() - BigInt::one()) / denominator.abs()
    }

    #[test]
    fn products_keep_within_their_error_and_it_is_no_more_than_twice_what_is_needed() {
        for scale in [10, 40] {
            for (a, b) in numbers(scale).iter().flat_map(|a| numbers(scale).into_iter().map(move |b| (a, b))) {
                let product = a.times(&b);
                let unit = BigInt::one() << scale;
                let corners = ends(a).into_iter().flat_map(|x| ends(&b).map(|y| distance(&product, &(&x * y), &unit)));
                let needed = corners.max().unwrap();
                let counted = BigInt::from(product.error);
                // A factor below one unit counts as one.
                let slack = 6 + ((a.error + b.error) >> scale);
                assert!(needed <= counted && counted <= needed * 2 + slack, "{a:?} times {b:?}");
            }
        }
    }

    #[test]
    fn quotients_keep_within_their_error() {
        for scale in [10, 40] {
            for a in numbers(scale) {
                for (divisor, error) in [(1, 0), (1, 1), (-5, 9), (37, 20)] {
                    let b = Fixed { value: (BigInt::one() << scale) * divisor + 3, error, scale };
                    let quotient = a.over(&b);
                    for (x, y) in ends(&a).iter().flat_map(|x| ends(&b).map(|y| (x.clone() << scale, y))) {
                        assert!(distance(&quotient, &x, &y) <= quotient.error.into(), "{a:?} over {b:?}");
                    }
                }
                for divisor in [1u32, 2, 7, 1024] {
                    for x in ends(&a) {
                        let exact = BigInt::from(divisor);
                        let by_small = a.over_small(divisor.into());
                        assert!(distance(&by_small, &x, &exact) <= by_small.error.into(), "{a:?} over {divisor}");
                        let times = divisor.trailing_zeros();
                        let halved = a.halved(times);
                        assert!(distance(&halved, &x, &(BigInt::one() << times)) <= halved.error.into());
                        let multiple = a.times_small(divisor);
                        assert!(distance(&multiple, &(x * divisor), &BigInt::one()) <= multiple.error.into());
                    }
                }
            }
        }
    }

    #[test]
    fn sums_and_numbers_cut_to_the_scale_keep_within_their_error() {
        for (a, b) in numbers(10).iter().flat_map(|a| numbers(10).into_iter().map(move |b| (a, b))) {
            for (result, sign) in [(a.plus(&b), 1), (a.minus(&b), -1)] {
                for (x, y) in ends(a).into_iter().flat_map(|x| ends(&b).map(|y| (x.clone(), y))) {
                    assert!(distance(&result, &(x + y * sign), &BigInt::one()) <= result.error.into());
                }
            }
        }
        for (mantissa, exponent) in [(5, 0), (-7, -3), (5, -10), (5, -11), (-9, -14)] {
            let cut = Fixed::from_dyadic(&Dyadic::new(BigInt::from(mantissa), exponent), 10);
            let exact = BigInt::from(mantissa) << 10u32;
            let below = BigInt::one() << exponent.unsigned_abs();
            assert!(distance(&cut, &exact, &below) <= cut.error.into());
            assert_eq!(cut.error, u128::from(exponent < -10));
        }
        let (lo, hi) = Fixed { value: BigInt::from(40), error: 3, scale: 10 }.bounds(2);
        assert!(lo == Dyadic::new(BigInt::from(37), -8) && hi == Dyadic::new(BigInt::from(43), -8));
    }
}
