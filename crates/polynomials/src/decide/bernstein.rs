//! Polynomials in several variables on a box in Bernstein's basis: the least coefficient bounds the values from below.

use crate::function::Side;
use crate::multivariate::Multivariate;
use arithmetic::{Cancelled, Progress, Rational, rational};
use num_traits::Signed;

/// Coefficients of a box, the last variable running fastest.
struct Patch {
    degrees: Vec<usize>,
    coefficients: Vec<Rational>,
    depth: u32,
}

/// Larger arrays are not made.
const MOST_COEFFICIENTS: usize = 4096;

/// Most boxes.
const MOST_BOXES: usize = 200;

/// Whether the polynomial is at least 0 (or above 0) on the box, where that is seen from coefficients.
pub(super) fn holds(
    target: &Multivariate<Rational>,
    strict: bool,
    sides: &[(usize, Side)],
    progress: &dyn Progress,
) -> Result<bool, Cancelled> {
    let Some(first) = patch(target, sides) else { return Ok(false) };
    let mut queue = vec![first];
    let mut looked = 0;
    while let Some(patch) = queue.pop() {
        progress.checkpoint()?;
        looked += 1;
        let fits = |c: &Rational| if strict { c.is_positive() } else { !c.is_negative() };
        if patch.coefficients.iter().all(fits) {
            continue;
        }
        // A corner has its own coefficient.
        if looked + queue.len() >= MOST_BOXES || patch.coefficients.first().is_some_and(|c| !fits(c)) {
            return Ok(false);
        }
        queue.extend(patch.halves());
    }
    Ok(true)
}

/// On the unit box, after a change of variables.
fn patch(target: &Multivariate<Rational>, sides: &[(usize, Side)]) -> Option<Patch> {
    let zero = rational(0, 1);
    let arity = target.arity();
    let mut places = vec![Multivariate::of(zero.clone()); arity];
    for (number, (variable, side)) in sides.iter().enumerate() {
        let (lo, hi) = side.lo.as_ref().zip(side.hi.as_ref())?;
        if let Some(place) = places.get_mut(*variable) {
            *place = Multivariate::x(number).scaled(&(hi - lo)) + Multivariate::of(lo.clone());
        }
    }
    let moved = target.substituted(&places);
    let degrees: Vec<usize> = (0..sides.len()).map(|k| moved.degree_in(k) as usize).collect();
    let size =
        degrees.iter().try_fold(1usize, |size, d| size.checked_mul(d + 1)).filter(|n| *n <= MOST_COEFFICIENTS)?;
    let mut coefficients = vec![zero; size];
    for (monomial, c) in moved.terms() {
        let exponent = |k: usize| monomial.get(k).copied().unwrap_or(0) as usize;
        let place = degrees.iter().enumerate().fold(0, |place, (k, d)| place * (d + 1) + exponent(k));
        coefficients[place] = c.clone();
    }
    let mut patch = Patch { degrees, coefficients, depth: 0 };
    for k in 0..sides.len() {
        let degree = patch.degrees[k];
        let binomials = binomials(degree);
        patch.along(k, |line| {
            // b_i = sum_(j<=i) C(i, j)/C(d, j) a_j, by differences.
            line.iter_mut().zip(&binomials).for_each(|(a, b)| *a = &*a / b);
            for stage in 1..=degree {
                for i in (stage..=degree).rev() {
                    let before = line[i - 1].clone();
                    line[i] += before;
                }
            }
        });
    }
    Some(patch)
}

fn binomials(n: usize) -> Vec<Rational> {
    let next = |c: &mut Rational, k: usize| {
        let own = c.clone();
        *c = &own * rational((n - k) as i64, k as i64 + 1);
        Some(own)
    };
    (0..=n).scan(rational(1, 1), |c, k| next(c, k)).collect()
}

impl Patch {
    /// Every line of coefficients along a variable.
    fn along(&mut self, k: usize, f: impl Fn(&mut [Rational])) {
        let stride: usize = self.degrees[k + 1..].iter().map(|d| d + 1).product();
        let length = self.degrees[k] + 1;
        for start in 0..self.coefficients.len() {
            if !(start / stride).is_multiple_of(length) {
                continue;
            }
            let mut line: Vec<Rational> =
                (0..length).map(|i| std::mem::take(&mut self.coefficients[start + i * stride])).collect();
            f(&mut line);
            line.into_iter().enumerate().for_each(|(i, c)| self.coefficients[start + i * stride] = c);
        }
    }

    fn halves(self) -> [Patch; 2] {
        let active: Vec<usize> = (0..self.degrees.len()).filter(|&k| self.degrees[k] > 0).collect();
        let k = active.get(self.depth as usize % active.len().max(1)).copied().unwrap_or(0);
        let copy = |patch: &Patch| Patch {
            degrees: patch.degrees.clone(),
            coefficients: patch.coefficients.clone(),
            depth: patch.depth + 1,
        };
        let (mut left, mut right) = (copy(&self), copy(&self));
        let half = rational(1, 2);
        left.along(k, |line| {
            for stage in 1..line.len() {
                for i in (stage..line.len()).rev() {
                    line[i] = (&line[i] + &line[i - 1]) * &half;
                }
            }
        });
        right.along(k, |line| {
            for stage in 1..line.len() {
                for i in 0..line.len() - stage {
                    line[i] = (&line[i] + &line[i + 1]) * &half;
                }
            }
        });
        [left, right]
    }
}
