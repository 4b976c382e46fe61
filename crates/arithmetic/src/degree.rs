//! Degrees and sizes of coefficients of a rational expression, found by running the expression itself.

use super::operators::operators;
use super::{ArithmeticError, Field, Rational, Ring};

/// Upper bounds for numerator and denominator of a rational expression, written over the integers: their total degrees in its variables, and the
/// logarithms to base 2 of the sums of the moduli of their coefficients.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DegreeBound {
    /// Degree of the numerator, at most.
    pub numerator: u64,
    /// Degree of the denominator, at most.
    pub denominator: u64,
    /// Bits of the coefficients of the numerator together, at most.
    pub numerator_bits: u64,
    /// Bits of the coefficients of the denominator together, at most.
    pub denominator_bits: u64,
}

impl DegreeBound {
    /// A variable.
    pub const VARIABLE: Self = DegreeBound { numerator: 1, ..DegreeBound::constant(0, 0) };

    /// A constant `p/q` with integers of so many bits.
    pub const fn constant(numerator_bits: u64, denominator_bits: u64) -> Self {
        DegreeBound { numerator: 0, denominator: 0, numerator_bits, denominator_bits }
    }

    fn sum(a: &Self, b: &Self) -> Self {
        // Over a common denominator; equal constant denominators cost nothing, others are multiplied out.
        let crossed =
            |a: u64, b_below: u64, b: u64, a_below: u64| a.saturating_add(b_below).max(b.saturating_add(a_below));
        DegreeBound {
            numerator: crossed(a.numerator, b.denominator, b.numerator, a.denominator),
            numerator_bits: crossed(a.numerator_bits, b.denominator_bits, b.numerator_bits, a.denominator_bits)
                .saturating_add(1),
            ..DegreeBound::product(a, b)
        }
    }

    fn product(a: &Self, b: &Self) -> Self {
        DegreeBound {
            numerator: a.numerator.saturating_add(b.numerator),
            denominator: a.denominator.saturating_add(b.denominator),
            numerator_bits: a.numerator_bits.saturating_add(b.numerator_bits),
            denominator_bits: a.denominator_bits.saturating_add(b.denominator_bits),
        }
    }
}

operators!([] DegreeBound, DegreeBound::sum, DegreeBound::sum, DegreeBound::product, |a| *a);

impl Ring for DegreeBound {
    fn integer(&self, n: i64) -> Self {
        DegreeBound::constant(u64::from(u64::BITS - n.unsigned_abs().leading_zeros()), 0)
    }
}

impl Field for DegreeBound {
    fn rational(&self, q: &Rational) -> Self {
        DegreeBound::constant(q.numer().bits(), q.denom().bits())
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        Ok(DegreeBound {
            numerator: self.denominator,
            denominator: self.numerator,
            numerator_bits: self.denominator_bits,
            denominator_bits: self.numerator_bits,
        })
    }
}
