//! Matrices of floats with bounds: rounding of rationals, products whose error is known.

use arithmetic::{Dyadic, Interval, Number, Rational};
use dense::{Mat, MatRef, add_product, product};
use num_traits::ToPrimitive;

/// Half an ulp of one: the relative error of a rounding.
pub(super) const UNIT: f64 = f64::EPSILON / 2.0;

/// What a norm of fewer than `2^30` terms, or a bound put together from a few norms, may have lost to rounding.
pub(super) const SLACK: f64 = 1.0 + 1e-6;

/// Largest and least size of numbers that are worked on, so that nothing over- or underflows on the way.
pub(super) const RANGE: std::ops::Range<f64> = 1e-100..1e100;

/// Underflow in sums of fewer than `2^60` products, far below all that matters in [`RANGE`].
pub(super) const UNDERFLOW: f64 = 1e-280;

/// A float and a bound of its distance from a rational; `None` outside the range.
pub(super) fn nearest(q: &Rational) -> Option<(f64, f64)> {
    let value = q.to_f64()?;
    let size = value.abs();
    if value == 0.0 && q.numer().bits() == 0 {
        return Some((0.0, 0.0));
    }
    let exact = q.is_integer() && q.numer().bits() <= 53;
    // An ulp at least: no trust in the last bit of the conversion is needed.
    RANGE.contains(&size).then_some((value, if exact { 0.0 } else { 4.0 * UNIT * size }))
}

/// `sign * sqrt(q)` in the same way; `None` for a negative rational too.
pub(super) fn nearest_root(q: &Rational, sign: f64) -> Option<(f64, f64)> {
    let root = Interval::from_rational(q, 64).sqrt().ok()?;
    let value = root.to_f64();
    // The enclosure has 64 bits, the float 53.
    RANGE.contains(&value).then_some((sign * value, 4.0 * UNIT * value))
}

/// The Frobenius norm, rounded up; infinite where an entry is not finite.
pub(super) fn frobenius(a: MatRef<'_, f64>) -> f64 {
    const LANES: usize = 8;
    let mut lanes = [0.0; LANES];
    for column in a.col_iter() {
        match column.try_as_col_major() {
            Some(column) => {
                let chunks = column.as_slice().chunks_exact(LANES);
                chunks.remainder().iter().zip(&mut lanes).for_each(|(x, lane)| *lane += x * x);
                chunks.for_each(|chunk| chunk.iter().zip(&mut lanes).for_each(|(x, lane)| *lane += x * x));
            }
            None => column.iter().zip((0..LANES).cycle()).for_each(|(x, k)| lanes[k] += x * x),
        }
    }
    let sum: f64 = lanes.iter().sum();
    if sum.is_finite() { (sum.sqrt() + 1e-150) * SLACK } else { f64::INFINITY }
}

/// `a b = exact + rest` up to `error` in the Frobenius norm.
pub(super) struct Product {
    pub exact: Mat<f64>,
    pub rest: Mat<f64>,
    pub error: f64,
}

/// Splits `a = head + tail` by a number for each place: beside it floats are multiples of a power of two, so that the sum is rounded to one and the
/// differences are exact.
fn split(a: Mat<f64>, shift: impl Fn(usize, usize) -> f64) -> (Mat<f64>, Mat<f64>) {
    let (mut head, mut tail) = (Mat::zeros(a.nrows(), a.ncols()), a);
    for j in 0..tail.ncols() {
        let entries = head.col_as_slice_mut(j).iter_mut().zip(tail.col_as_slice_mut(j)).enumerate();
        entries.for_each(|(i, (head, tail)): (usize, (&mut f64, &mut f64))| {
            let shift = shift(i, j);
            *head = (*tail + shift) - shift;
            *tail -= *head;
        });
    }
    (head, tail)
}

/// A number beside which floats up to `largest` are rounded to multiples, by integers of at most `bits` bits, of one power of two.
fn shift(largest: f64, bits: i32) -> f64 {
    let top = Dyadic::from_f64(largest).map_or(0, |x| x.top().clamp(-900, 900));
    1.5 * 2f64.powi(top as i32 - bits + 52)
}

/// A left factor of products whose leading parts are exact, after Ozaki, Ogita, Oishi and Rump (2012): both factors are split so
/// that the product of the heads is exact in whatever order it is summed (its partial sums are integers below `2^53` times
/// one power of two). The rest is small, so its rounding, `k u |a||b|` for inner dimension `k` in any order of summation
/// (Higham, Accuracy and Stability, (3.13)), is too.
pub(super) struct Split {
    head: Mat<f64>,
    tail: Mat<f64>,
    /// Norms of head and tail.
    sizes: (f64, f64),
    bits: i32,
}

impl Split {
    /// Each row has a power of two of its own.
    pub fn new(a: Mat<f64>) -> Self {
        let sum_bits = (usize::BITS - a.ncols().leading_zeros()) as i32;
        let bits = (53 - sum_bits) / 2;
        let mut largest = vec![0.0; a.nrows()];
        for j in 0..a.ncols() {
            largest.iter_mut().zip(a.col_as_slice(j)).for_each(|(most, x)| *most = f64::max(*most, x.abs()));
        }
        let shifts: Vec<f64> = largest.into_iter().map(|largest| shift(largest, bits)).collect();
        let (head, tail) = split(a, |i, _| shifts[i]);
        let sizes = (frobenius(head.as_ref()), frobenius(tail.as_ref()));
        Split { head, tail, sizes, bits }
    }

    /// The product with a matrix of floats in range.
    pub fn times(&self, b: &Mat<f64>) -> Product {
        let inner = b.nrows();
        let largest = |j: usize| b.col_as_slice(j).iter().fold(0.0, |most, x| f64::max(most, x.abs()));
        let shifts: Vec<f64> = (0..b.ncols()).map(|j| shift(largest(j), self.bits)).collect();
        let (b_head, b_tail) = split(b.clone(), |_, j| shifts[j]);
        let exact = product(self.head.as_ref(), b_head.as_ref());
        let mut rest = product(self.head.as_ref(), b_tail.as_ref());
        add_product(rest.as_mut(), 1.0, self.tail.as_ref(), b.as_ref());
        let sizes = self.sizes.0 * frobenius(b_tail.as_ref()) + self.sizes.1 * frobenius(b.as_ref());
        let error = 2.0 * (inner as f64 + 2.0) * UNIT * sizes * SLACK + UNDERFLOW;
        Product { exact, rest, error }
    }
}

/// The interval of all numbers within `radius` of a float.
pub(super) fn around(centre: f64, radius: f64) -> Option<Interval> {
    let lo = Dyadic::from_f64((centre - radius).next_down())?;
    let hi = Dyadic::from_f64((centre + radius).next_up())?;
    Some(Interval::between(lo, hi, 64))
}

#[cfg(test)]
mod tests;
