//! Exact sums of square roots of rationals.

use super::{Rational, Sign, Signed};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};
use std::collections::BTreeMap;

/// A sum of rational multiples of square roots of square-free positive integers. These roots are linearly independent over the
/// rationals (Besicovitch 1940), so two sums are equal exactly when their terms are.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct RadicalSum {
    /// Coefficients, none of them zero, by square-free radicand.
    terms: BTreeMap<BigInt, Rational>,
}

impl RadicalSum {
    /// Adds `coefficient * sqrt(radicand)`; returns `false`, and adds nothing, where the radicand is negative.
    ///
    /// Cost: trial division of numerator times denominator, so the radicand should be small.
    pub fn add_root(&mut self, coefficient: &Rational, radicand: &Rational) -> bool {
        match radicand.sign() {
            Some(Sign::Negative) | None => return false,
            Some(Sign::Zero) => return true,
            Some(Sign::Positive) => {}
        }
        let (root, square_free) = split_square(radicand.numer() * radicand.denom());
        let term = self.terms.entry(square_free.clone()).or_insert_with(Rational::zero);
        *term += coefficient * Rational::new(root, radicand.denom());
        if term.is_zero() {
            self.terms.remove(&square_free);
        }
        true
    }
}

/// `(r, f)` with `n = r² f` and `f` square-free, for `n > 0`.
fn split_square(mut n: BigInt) -> (BigInt, BigInt) {
    let (mut root, mut square_free) = (BigInt::one(), BigInt::one());
    let mut prime = BigInt::from(2);
    while &prime * &prime <= n {
        let mut exponent = 0usize;
        while n.is_multiple_of(&prime) {
            n /= &prime;
            exponent += 1;
        }
        root *= num_traits::pow(prime.clone(), exponent / 2);
        square_free *= num_traits::pow(prime.clone(), exponent % 2);
        prime += 1;
    }
    (root, square_free * n)
}
