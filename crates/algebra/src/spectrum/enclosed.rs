//! What a spectrum is reported as: enclosures that together hold every eigenvalue, with their numbers.

use arithmetic::{Interval, Rational};
use num_traits::Zero;
use std::cmp::Ordering;

/// A part of the spectrum.
#[derive(Debug, Clone)]
pub struct Eigenvalue {
    /// Encloses the real part.
    pub re: Interval,
    /// Encloses the imaginary part.
    pub im: Interval,
    /// How many eigenvalues, each counted as often as it is a root of the characteristic polynomial, lie in this
    /// enclosure. With [`Method::ClosedForm`] and [`Method::Exact`] they are all equal.
    pub multiplicity: usize,
    /// The eigenvalue itself, where it is known to be this rational.
    pub exact: Option<Rational>,
}

/// Eigenvalues near a float: their real and imaginary parts are each within `radius` of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloatEnclosure {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
    /// Bound of the error of each part.
    pub radius: f64,
    /// How many eigenvalues.
    pub multiplicity: usize,
}

/// How a spectrum was found, and what the multiplicities mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// A formula for the family; different eigenvalues are told apart exactly.
    ClosedForm,
    /// Roots of the exact characteristic polynomials of the irreducible blocks; different eigenvalues are told apart
    /// exactly.
    Exact,
    /// Floating point with proved error bounds; eigenvalues too close to be told apart share an enclosure.
    Certified,
}

impl Method {
    /// The name in output.
    pub fn name(self) -> &'static str {
        match self {
            Method::ClosedForm => "closed form",
            Method::Exact => "exact",
            Method::Certified => "certified",
        }
    }
}

/// All eigenvalues of a matrix.
#[derive(Debug, Clone)]
pub struct Spectrum {
    /// Order of the matrix: the sum of the multiplicities.
    pub order: usize,
    /// How it was found.
    pub method: Method,
    /// The formula, or the theorem that the bounds rest on.
    pub reason: String,
    /// The parts by increasing real part, then imaginary part.
    pub eigenvalues: Vec<Eigenvalue>,
}

impl Eigenvalue {
    /// Eigenvalues equal to a real rational.
    pub fn rational(value: Rational, multiplicity: usize, precision: u32) -> Self {
        let re = Interval::from_rational(&value, precision);
        Eigenvalue { re, im: zero(precision), multiplicity, exact: Some(value) }
    }

    /// Real eigenvalues in an enclosure.
    pub fn real(re: Interval, multiplicity: usize) -> Self {
        let im = zero(re.precision());
        Eigenvalue { re, im, multiplicity, exact: None }
    }

    /// Whether it is known to be real.
    pub fn is_real(&self) -> bool {
        self.im.lo().is_zero() && self.im.hi().is_zero()
    }

    /// Whether the two enclosures have a point in common.
    fn meets(&self, other: &Self) -> bool {
        self.re.overlaps(&other.re) && self.im.overlaps(&other.im)
    }
}

fn zero(precision: u32) -> Interval {
    Interval::from_rational(&Rational::zero(), precision)
}

/// Bits that hold this many decimal digits.
pub(super) fn bits(digits: u32) -> u32 {
    (f64::from(digits) * std::f64::consts::LOG2_10).ceil() as u32
}

/// The exponent of a power of two that is not above the least absolute value in an interval without zero.
pub(super) fn least_top(x: &Interval) -> i64 {
    x.lo().top().min(x.hi().top()) - 1
}

/// By the middle of the real parts, then of the imaginary parts.
pub(super) fn order(a: &Eigenvalue, b: &Eigenvalue) -> Ordering {
    let middle = |x: &Interval| x.lo().midpoint(x.hi());
    middle(&a.re).cmp(&middle(&b.re)).then_with(|| middle(&a.im).cmp(&middle(&b.im)))
}

/// Joins enclosures that have points in common and adds their numbers, until all are apart. Real ones stay real.
pub(super) fn merged(mut parts: Vec<Eigenvalue>) -> Vec<Eigenvalue> {
    loop {
        parts.sort_by(|a, b| a.re.lo().cmp(b.re.lo()));
        let before = parts.len();
        let mut apart: Vec<Eigenvalue> = Vec::with_capacity(before);
        // Enclosures to the left of this one by their upper ends are done with.
        let mut open: Vec<usize> = Vec::new();
        for part in parts {
            open.retain(|&k| apart[k].re.hi() >= part.re.lo());
            match open.iter().find(|&&k| apart[k].meets(&part)) {
                Some(&k) => {
                    let kept = &mut apart[k];
                    let same = kept.exact.is_some() && kept.exact == part.exact;
                    kept.multiplicity += part.multiplicity;
                    if !same {
                        kept.exact = None;
                        kept.re = kept.re.hull(&part.re);
                        kept.im = kept.im.hull(&part.im);
                    }
                }
                None => {
                    open.push(apart.len());
                    apart.push(part);
                }
            }
        }
        parts = apart;
        if parts.len() == before {
            parts.sort_by(order);
            return parts;
        }
    }
}

#[cfg(test)]
mod tests;
