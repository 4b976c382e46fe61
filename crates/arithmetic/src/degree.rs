//! Degrees of a rational expression, found by running the expression itself.

use super::operators::operators;
use super::{ArithmeticError, Field, Rational, Ring};

/// Upper bounds of the total degrees of numerator and denominator of a rational expression in its variables.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DegreeBound {
    /// Degree of the numerator, at most.
    pub numerator: u64,
    /// Degree of the denominator, at most.
    pub denominator: u64,
}

impl DegreeBound {
    /// A constant.
    pub const CONSTANT: Self = DegreeBound { numerator: 0, denominator: 0 };
    /// A variable.
    pub const VARIABLE: Self = DegreeBound { numerator: 1, denominator: 0 };

    fn sum(a: &Self, b: &Self) -> Self {
        // Over a common denominator; equal constant denominators cost nothing, others are multiplied out.
        DegreeBound {
            numerator: (a.numerator + b.denominator).max(b.numerator + a.denominator),
            denominator: a.denominator + b.denominator,
        }
    }
}

operators!(
    [] DegreeBound,
    DegreeBound::sum,
    DegreeBound::sum,
    |a, b| DegreeBound { numerator: a.numerator + b.numerator, denominator: a.denominator + b.denominator },
    |a| *a
);

impl Ring for DegreeBound {
    fn integer(&self, _: i64) -> Self {
        DegreeBound::CONSTANT
    }
}

impl Field for DegreeBound {
    fn rational(&self, _: &Rational) -> Self {
        DegreeBound::CONSTANT
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        Ok(DegreeBound { numerator: self.denominator, denominator: self.numerator })
    }
}
