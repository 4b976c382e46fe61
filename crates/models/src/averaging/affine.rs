//! Affine functions of one parameter and what can be decided about them on a half-open range: enough for proofs by
//! exact invariants.

use arithmetic::{Rational, Ring};

/// `constant + slope r`.
#[derive(Debug, Clone, PartialEq)]
pub struct Affine {
    /// Value at `r = 0`.
    pub constant: Rational,
    /// Coefficient of `r`.
    pub slope: Rational,
}

/// The values of `r` between an end that belongs to the range and the limit 0 that does not.
#[derive(Debug, Clone, PartialEq)]
pub struct HalfOpenRange {
    /// The end that belongs to the range; not 0.
    pub end: Rational,
}

impl Affine {
    /// The value at `r`.
    pub fn at(&self, r: &Rational) -> Rational {
        self.slope.clone() * r + &self.constant
    }

    /// The difference of two affine functions.
    pub fn minus(&self, other: &Self) -> Self {
        Affine { constant: self.constant.clone() - &other.constant, slope: self.slope.clone() - &other.slope }
    }

    /// The negated function.
    pub fn negated(&self) -> Self {
        Affine { constant: -self.constant.clone(), slope: -self.slope.clone() }
    }

    /// The function of `r` that is this one at `factor r`.
    pub fn rescaled(&self, factor: &Rational) -> Self {
        Affine { constant: self.constant.clone(), slope: self.slope.clone() * factor }
    }

    /// Whether `value <= bound` on the whole range: it is so at both ends, the open one included.
    pub fn is_at_most(&self, bound: &Rational, range: &HalfOpenRange) -> bool {
        self.constant <= *bound && self.at(&range.end) <= *bound
    }

    /// Whether `value > bound` on the whole range: not below at the open end and above at the closed one; every point of
    /// the range is a convex combination that gives the closed end some weight.
    pub fn exceeds(&self, bound: &Rational, range: &HalfOpenRange) -> bool {
        self.constant >= *bound && self.at(&range.end) > *bound
    }

    /// Decides `|value| <= 1` on the whole range, or `None` where it holds only on a part of it.
    pub fn is_within_one(&self, range: &HalfOpenRange) -> Option<bool> {
        let one = self.constant.one();
        let negated = self.negated();
        if self.is_at_most(&one, range) && negated.is_at_most(&one, range) {
            Some(true)
        } else if self.exceeds(&one, range) || negated.exceeds(&one, range) {
            Some(false)
        } else {
            None
        }
    }
}
