//! Circulant matrices with real weights: all eigenvalues in floats, with a proved bound.
//!
//! `λ_k = sum_s c_s z^(sk)`, `z = e^(2 pi i/n)`, for the matrix with `c_s` in row `i` and column `i + s` modulo `n`. With the row sum `r`,
//! `λ_k = r - sum_s c_s (1 - cos(2 pi sk/n)) + i sum_s c_s sin(2 pi sk/n)`.
//!
//! | weights | method | bound |
//! |---|---|---|
//! | few | these sums, from a table of `1 - cos` and one of `sin` | relative for Laplacians with weights of one sign |
//! | many | [fast Fourier transform](super::fourier) | absolute, a small multiple of `u log n sum_s |c_s|` |
//!
//! **Sums.** The numbers `1 - cos` have the relative error [`CHORD_ERROR`], a weight `e`, a product and each of `J` sums one
//! rounding: the real part without `r` is within `(CHORD_ERROR + e + (J + 2) u) sum_s |c_s| (1 - cos)` of the exact one. If no
//! weight is positive (the off-diagonal of a Laplacian), the sum is the value itself, and the bound is relative. The
//! imaginary part: the same with `|c_s|`.

use super::Eigenvalue;
use super::enclosed::merged;
use super::error::{OUT_OF_RANGE, SpectrumError};
use super::float_bounds::{RANGE, SLACK, UNDERFLOW, UNIT, around, nearest};
use super::fourier::real_transform;
use super::turn::{CHORD_ERROR, ROOT_ERROR, chord, root_of_unity};
use arithmetic::{Dyadic, Rational};
use num_traits::Zero;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Most pairs of offsets `s`, `n - s` for which the sums are taken: about where they are as fast as the transform.
const MOST_SUMS: usize = 24;

const EMPTY: SpectrumError = SpectrumError::Unproved("a matrix of order 0 has no eigenvalues");

/// Eigenvalues that one task works on.
const CHUNK: usize = 8192;

/// A circulant matrix: `c_s` in row `i` and column `i + s` modulo the order.
#[derive(Debug, Clone)]
pub struct Circulant {
    order: usize,
    /// `c_0`.
    diagonal: f64,
    /// The offsets from 1 on with the weights that are not zero.
    weights: Vec<(usize, f64)>,
    /// Bound of the relative error of these.
    weight_error: f64,
    /// The row sum, rounded, and its error.
    row_sum: (f64, f64),
    /// Whether the exact weights of `s` and `n - s` are equal; those of rounded ones may be by chance.
    symmetric: bool,
}

/// All eigenvalues of a [`Circulant`]: number `k` belongs to the eigenvector `e^(2 pi i jk/n)`.
///
/// `|λ - λ_k| <= absolute + relative |λ|` for the float `λ` of number `k`, for the real and for the imaginary part.
#[derive(Debug, Clone)]
pub struct CirculantSpectrum {
    order: usize,
    re: Vec<f64>,
    /// Empty for symmetric matrices.
    im: Vec<f64>,
    /// Absolute part of the error bound.
    pub absolute: f64,
    /// Relative part of the error bound.
    pub relative: f64,
}

impl Circulant {
    /// The matrix with this first row of floats.
    ///
    /// # Errors
    /// [`SpectrumError::Unproved`] where a number other than zero lies outside 1e-100 to 1e100, or there is none.
    pub fn from_first_row(row: &[f64]) -> Result<Self, SpectrumError> {
        let Some(&diagonal) = row.first() else { return Err(EMPTY) };
        if !row.iter().all(|x| *x == 0.0 || RANGE.contains(&x.abs())) {
            return Err(OUT_OF_RANGE);
        }
        let weights: Vec<(usize, f64)> = row.iter().copied().enumerate().skip(1).filter(|(_, x)| *x != 0.0).collect();
        let exact = row.iter().filter_map(|&x| Dyadic::from_f64(x)).fold(Dyadic::zero(), |sum, x| sum.plus(&x));
        let row_sum = rounded(&exact.to_rational())?;
        let symmetric = row[1..].iter().eq(row[1..].iter().rev());
        Ok(Circulant { order: row.len(), diagonal, weights, weight_error: 0.0, row_sum, symmetric })
    }

    /// The matrix with these entries `(s, c_s)` in its first row; offsets count modulo the order, and entries of the same
    /// offset are added.
    ///
    /// # Errors
    /// [`SpectrumError::Unproved`] for weights outside 1e-100 to 1e100, or for order 0.
    pub fn new(order: usize, entries: impl IntoIterator<Item = (usize, Rational)>) -> Result<Self, SpectrumError> {
        if order == 0 {
            return Err(EMPTY);
        }
        let mut weights: BTreeMap<usize, Rational> = BTreeMap::new();
        for (offset, weight) in entries {
            *weights.entry(offset % order).or_insert_with(Rational::zero) += weight;
        }
        weights.retain(|_, weight| !weight.is_zero());
        let row_sum = rounded(&weights.values().sum())?;
        let symmetric = weights.iter().all(|(&s, weight)| s == 0 || weights.get(&(order - s)) == Some(weight));
        let mut matrix = Circulant { order, diagonal: 0.0, weights: Vec::new(), weight_error: 0.0, row_sum, symmetric };
        for (offset, weight) in weights {
            let (value, error) = rounded(&weight)?;
            matrix.weight_error = matrix.weight_error.max(error / value.abs() * SLACK);
            if offset == 0 {
                matrix.diagonal = value;
            } else {
                matrix.weights.push((offset, value));
            }
        }
        Ok(matrix)
    }

    /// The Laplacian `D - A` of the graph in which every vertex `i` senses `i + s` with the weights `(s, a_s)`.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn laplacian(order: usize, arcs: impl IntoIterator<Item = (usize, Rational)>) -> Result<Self, SpectrumError> {
        Circulant::new(order, arcs.into_iter().flat_map(|(s, weight)| [(s, -weight.clone()), (0, weight)]))
    }

    /// Number of rows.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Whether it equals its transpose.
    pub fn is_symmetric(&self) -> bool {
        self.symmetric
    }

    /// All eigenvalues. Cost: `n` times the number of weights, or `n log n`.
    ///
    /// # Errors
    /// [`SpectrumError::Unproved`] where the bound is not finite.
    pub fn eigenvalues(&self) -> Result<CirculantSpectrum, SpectrumError> {
        if self.weights.len() <= 2 * MOST_SUMS { Ok(self.by_sums()) } else { self.by_transform() }
    }

    fn size(&self) -> f64 {
        (self.diagonal.abs() + self.weights.iter().map(|(_, c)| c.abs()).sum::<f64>()) * SLACK
    }

    pub(super) fn by_transform(&self) -> Result<CirculantSpectrum, SpectrumError> {
        let mut row = vec![0.0; self.order];
        row[0] = self.diagonal;
        self.weights.iter().for_each(|&(offset, value)| row[offset] = value);
        let (values, error) = real_transform(&row).ok_or(OUT_OF_RANGE)?;
        let absolute = (error + self.weight_error * self.size()) * SLACK;
        let im = if self.is_symmetric() { Vec::new() } else { values.im };
        Ok(CirculantSpectrum { order: self.order, re: values.re, im, absolute, relative: 0.0 })
    }

    pub(super) fn by_sums(&self) -> CirculantSpectrum {
        let n = self.order;
        let half = n / 2;
        // By offsets up to n/2: the weights of the cosine and of the sine.
        let mut pairs: BTreeMap<usize, (f64, f64)> = BTreeMap::new();
        for &(offset, value) in &self.weights {
            let (short, sign) = if offset <= half { (offset, 1.0) } else { (n - offset, -1.0) };
            let (even, odd) = pairs.entry(short).or_default();
            (*even, *odd) = (*even + value, *odd + sign * value);
        }
        let even: Vec<(usize, f64)> = pairs.iter().map(|(&s, w)| (s, w.0)).collect();
        let odd: Vec<(usize, f64)> = pairs.iter().map(|(&s, w)| (s, w.1)).filter(|(_, w)| *w != 0.0).collect();
        let (row_sum, row_error) = self.row_sum;
        let mut re = weighted_sums(n, &even, |m| chord(m as f64, n as f64), 1.0);
        re.par_chunks_mut(CHUNK).for_each(|part| part.iter_mut().for_each(|x| *x = row_sum - *x));
        let sine = |m: usize| root_of_unity(m as u64, n as u64).1;
        let im = if self.is_symmetric() { Vec::new() } else { weighted_sums(n, &odd, sine, -1.0) };
        let rounding = self.weight_error + (pairs.len() + 3) as f64 * UNIT;
        let eta = (CHORD_ERROR + rounding) * SLACK;
        let is_negative = |k: usize| self.weights[k].1.is_sign_negative();
        let one_sign = (1..self.weights.len()).all(|k| is_negative(k) == is_negative(0));
        // Of one sign: the sum is at most |λ| + |r|.
        let size = if one_sign { row_sum.abs() } else { 2.0 * self.size() };
        let relative = if one_sign { eta + UNIT } else { UNIT } * SLACK;
        let sines = if im.is_empty() { 0.0 } else { (ROOT_ERROR + rounding) * self.size() };
        let absolute = f64::max(eta * size + row_error, sines) * SLACK + UNDERFLOW;
        CirculantSpectrum { order: n, re, im, absolute, relative }
    }
}

/// `sum_s w_s f(sk mod n)` for `k <= n/2`, where `f(n - m) = mirror f(m)`.
fn weighted_sums(n: usize, weights: &[(usize, f64)], f: impl Fn(usize) -> f64 + Sync, mirror: f64) -> Vec<f64> {
    let half = n / 2;
    let mut table = vec![0.0; half + 1];
    table.par_chunks_mut(CHUNK).enumerate().for_each(|(number, part)| {
        part.iter_mut().enumerate().for_each(|(place, x)| *x = f(number * CHUNK + place));
    });
    let mut sums = vec![0.0; half + 1];
    sums.par_chunks_mut(CHUNK).enumerate().for_each(|(number, part)| {
        for &(offset, weight) in weights {
            let mut m = (offset as u128 * (number * CHUNK) as u128 % n as u128) as usize;
            let mirrored = weight * mirror;
            let mut rest: &mut [f64] = part;
            while !rest.is_empty() {
                // Up the table, then down.
                let rising = m <= half;
                let steps = (if rising { half - m } else { n - 1 - m }) / offset + 1;
                let (run, later) = rest.split_at_mut(steps.min(rest.len()));
                if rising {
                    run.iter_mut().zip(table[m..].iter().step_by(offset)).for_each(|(sum, x)| *sum += weight * x);
                } else {
                    let down = table[..=n - m].iter().rev().step_by(offset);
                    run.iter_mut().zip(down).for_each(|(sum, x)| *sum += mirrored * x);
                }
                m = (m + steps * offset) % n;
                rest = later;
            }
        }
    });
    sums
}

impl CirculantSpectrum {
    /// Order of the matrix.
    pub fn order(&self) -> usize {
        self.order
    }

    /// Real parts of the numbers `0..=n/2`; number `n - k` is the conjugate of number `k`.
    pub fn re(&self) -> &[f64] {
        &self.re
    }

    /// Imaginary parts of the same numbers; empty for symmetric matrices, whose eigenvalues are real.
    pub fn im(&self) -> &[f64] {
        &self.im
    }

    /// Bound of the distance between a part of an eigenvalue and its float.
    pub fn radius(&self, value: f64) -> f64 {
        (self.absolute + self.relative * value.abs()) * SLACK
    }

    /// The eigenvalues as enclosures; those that overlap come as one, with their number.
    ///
    /// # Errors
    /// [`SpectrumError::Unproved`] where a float is not finite.
    pub fn enclosures(&self) -> Result<Vec<Eigenvalue>, SpectrumError> {
        let interval = |x: f64| around(x, self.radius(x)).ok_or(OUT_OF_RANGE);
        let mut parts = Vec::with_capacity(self.order);
        for (k, &re) in self.re.iter().enumerate() {
            let twice = k != 0 && 2 * k != self.order;
            match self.im.get(k).filter(|_| twice) {
                None => parts.push(Eigenvalue::real(interval(re)?, if twice { 2 } else { 1 })),
                Some(&im) => {
                    for im in [-im, im] {
                        parts.push(Eigenvalue { re: interval(re)?, im: interval(im)?, multiplicity: 1, exact: None });
                    }
                }
            }
        }
        Ok(merged(parts))
    }
}

/// A float in range with a bound of its error, zero where it is exact.
fn rounded(q: &Rational) -> Result<(f64, f64), SpectrumError> {
    let (value, error) = nearest(q).ok_or(OUT_OF_RANGE)?;
    let exact = Rational::from_float(value).as_ref() == Some(q);
    Ok((value, if exact { 0.0 } else { error }))
}

#[cfg(test)]
mod tests;
