//! Whether all roots of a real polynomial have negative real parts, decided exactly (Routh's table).

use super::Polynomial;
use crate::arithmetic::{Rational, Ring};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::Signed;

impl Polynomial {
    /// Whether every complex root has a negative real part. A constant other than zero has no roots; the zero polynomial is not
    /// stable.
    ///
    /// Routh: with a positive leading coefficient, this is so exactly where every entry of the first column of the
    /// table is positive. Cost: `degree²/2` products.
    pub fn is_hurwitz(&self) -> bool {
        let mut descending: Vec<BigInt> = self.coefficients().iter().rev().cloned().collect();
        let Some(lead) = descending.first() else { return false };
        if lead.is_negative() {
            descending.iter_mut().for_each(|c| *c = -std::mem::take(c));
        }
        let every_other = |start: usize| descending.iter().skip(start).step_by(2).cloned().collect::<Vec<_>>();
        let (mut upper, mut lower) = (every_other(0), every_other(1));
        loop {
            let (Some(top), first) = (upper.first().cloned(), lower.first()) else { return true };
            let Some(bottom) = first.cloned() else { return top.is_positive() };
            if !top.is_positive() || !bottom.is_positive() {
                return false;
            }
            // Scaling a row by a positive number does not change the signs.
            let entry = |k: usize| {
                let below = lower.get(k).cloned().unwrap_or_default();
                &bottom * &upper[k] - &top * below
            };
            let next = without_content((1..upper.len()).map(entry).collect());
            upper = std::mem::replace(&mut lower, next);
        }
    }

    /// A positive multiple of the polynomial whose roots are these roots plus `shift`.
    pub fn with_roots_moved(&self, shift: &Rational) -> Self {
        // p(x - shift) by Horner's rule.
        let mut moved: Vec<Rational> = Vec::new();
        for c in self.coefficients().iter().rev() {
            let mut next = vec![shift.zero(); moved.len() + 1];
            for (k, x) in moved.iter().enumerate() {
                next[k + 1] += x;
                next[k] -= x * shift;
            }
            next[0] += Rational::from_integer(c.clone());
            moved = next;
        }
        Polynomial::from_rationals(&moved)
    }
}

/// The row divided by the greatest common divisor of its entries.
fn without_content(mut row: Vec<BigInt>) -> Vec<BigInt> {
    let content = row.iter().fold(BigInt::ZERO, |g, c| g.gcd(c));
    if content > BigInt::from(1) {
        row.iter_mut().for_each(|c| *c /= &content);
    }
    row
}
