//! The abscissa of a polynomial, the largest real part of a root, enclosed.
//!
//! All roots of `p` lie to the left of `x` exactly where those of `p(s + x)` have negative real parts, and Routh's table decides
//! that. So halving the interval that Cauchy's bound gives encloses the abscissa; no root is isolated. A polynomial `p` with complex
//! coefficients has the abscissa of the real one `p p̄`, whose roots are those of `p` and their conjugates.

use super::Polynomial;
use super::stability::{roots_moved, routh};
use arithmetic::{Complex, Field, FloatInterval, Interval, Rational, Ring, Sign, Signed, Unwatched};
use num_bigint::BigInt;

/// Sixteenths of the interval at which the question is asked, until it has an answer.
const PLACES: [i64; 3] = [8, 5, 11];

impl Polynomial {
    /// Encloses the largest real part of a root, within `2^-bits` of Cauchy's bound; `None` for constants.
    pub fn abscissa(&self, bits: u32) -> Option<Interval> {
        let lead = Rational::from_integer(self.coefficients().last()?.clone());
        let sizes = self.coefficients().iter().map(|c| Rational::from_integer(c.clone()) / &lead);
        let bound = power_above(sizes.map(|q| if q < q.zero() { -q } else { q }))?;
        (self.degree() > 0).then(|| halved(&bound, bits, |x| Some(self.with_roots_moved(&-x.clone()).is_hurwitz())))
    }
}

/// Encloses the largest real part of a root of the monic polynomial with these coefficients, the constant one first: within
/// `2^-bits` of Cauchy's bound, or as far as the precision of the coefficients decides. `None` for constants.
pub fn complex_abscissa(coefficients: &[Complex<Interval>], bits: u32) -> Option<Interval> {
    let size = |c: &Complex<Interval>| c.re.magnitude().to_rational() + c.im.magnitude().to_rational();
    let bound = power_above(coefficients.iter().map(size))?;
    (coefficients.len() > 1).then(|| {
        let roots = Roots::of(coefficients);
        halved(&bound, bits, |x| roots.are_left_of(x))
    })
}

/// Whether all roots of the polynomial, given as for [`complex_abscissa`], certainly have real parts below `x`. One table of Routh's.
pub fn roots_are_left_of(coefficients: &[Complex<Interval>], x: &Rational) -> bool {
    Roots::of(coefficients).are_left_of(x) == Some(true)
}

/// A polynomial with complex coefficients whose roots are asked for their side.
struct Roots<'a> {
    coefficients: &'a [Complex<Interval>],
    /// The same between floats: most questions are decided so.
    coarse: Vec<Complex<FloatInterval>>,
    real: bool,
}

impl<'a> Roots<'a> {
    fn of(coefficients: &'a [Complex<Interval>]) -> Self {
        let coarse = |c: &Complex<Interval>| {
            Complex::new(FloatInterval::from_interval(&c.re), FloatInterval::from_interval(&c.im))
        };
        Roots {
            coefficients,
            coarse: coefficients.iter().map(coarse).collect(),
            real: coefficients.iter().all(|c| c.im.sign() == Some(Sign::Zero)),
        }
    }

    /// Whether all roots lie to the left of `x`; `None` where that is not decided.
    fn are_left_of(&self, x: &Rational) -> Option<bool> {
        is_stable_moved(&self.coarse, self.real, x).or_else(|| is_stable_moved(self.coefficients, self.real, x))
    }
}

/// Whether all roots, moved by `-x`, have negative real parts.
fn is_stable_moved<T: Field + Signed>(coefficients: &[Complex<T>], real: bool, x: &Rational) -> Option<bool> {
    let shift = coefficients.first()?.rational(&-x);
    let moved = roots_moved(coefficients, &shift);
    let squared = if real { moved.into_iter().map(|c| c.re).collect() } else { times_conjugate(&moved)? };
    routh(squared.into_iter().rev().collect(), |row| row, &Unwatched).unwrap_or_default()
}

/// The real polynomial `p p̄`.
fn times_conjugate<T: Ring>(p: &[Complex<T>]) -> Option<Vec<T>> {
    let mut product = vec![p.first()?.re.zero(); 2 * p.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in p.iter().enumerate() {
            // The imaginary parts of the terms (i, j) and (j, i) cancel.
            product[i + j] = product[i + j].clone() + a.dot(b);
        }
    }
    Some(product)
}

/// A power of two above `1 + max`, so that halving keeps the ends short.
fn power_above(sizes: impl Iterator<Item = Rational>) -> Option<Rational> {
    let largest = sizes.max()?;
    let bits = (largest.one() + &largest).ceil().to_integer().bits();
    Some(Rational::from_integer(BigInt::from(1) << bits))
}

/// Encloses the abscissa, below `bound` in modulus, given whether all roots lie to the left of a number.
fn halved(bound: &Rational, bits: u32, left: impl Fn(&Rational) -> Option<bool>) -> Interval {
    let (mut lo, mut hi) = (-bound.clone(), bound.clone());
    let width = bound / Rational::from_integer(BigInt::from(1) << bits);
    while &hi - &lo > width {
        let answer = PLACES.iter().find_map(|&place| {
            let x = &lo + (&hi - &lo) * lo.ratio(place, 16);
            left(&x).map(|left| (x, left))
        });
        match answer {
            Some((x, true)) => hi = x,
            Some((x, false)) => lo = x,
            None => break,
        }
    }
    Interval::hull_of_rationals(&lo, &hi, bits + 32)
}
