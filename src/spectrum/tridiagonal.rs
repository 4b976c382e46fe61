//! Tridiagonal matrices with positive products of opposite entries (weighted paths, platoons): eigenvalues by implicit QL,
//! enclosed by counting negative pivots.
//!
//! **Counts in floating point.** The pivots `q_i = (a_i - x) - b²_{i-1}/q_{i-1}` computed with rounding have the signs of the
//! exact pivots of a matrix whose `b²` differ by factors of four roundings each: divide `q_i` by the factors of its two
//! subtractions (Kahan 1966; Demmel, Applied Numerical Linear Algebra, 5.3.4). With the rounding of the entries themselves
//! that moves `b` by less than `7 u b`, so no eigenvalue moves by more than `14 u max b` plus the largest error of an `a_i`
//! (Weyl). Pivots below `1e-200` are replaced, which is a change of `a_i` of that size.

use super::block::symmetric_entry;
use super::choose::OUT_OF_RANGE;
use super::enclosed::merged;
use super::float_bounds::{RANGE, SLACK, UNIT, around, nearest};
use super::{Eigenvalue, FloatEnclosure, SpectrumError};
use crate::matrix::SparseMatrix;
use rayon::prelude::*;

/// Pivots closer to zero are replaced.
const LEAST_PIVOT: f64 = 1e-200;

/// What replaced pivots and underflow change.
const REPLACED: f64 = 1e-190;

/// Shifts that are counted at once.
const LANES: usize = 8;

/// Doublings of the radius before an enclosure is given up.
const MOST_DOUBLINGS: usize = 60;

/// A symmetric tridiagonal matrix, known up to `spread`.
pub(super) struct Tridiagonal {
    diagonal: Vec<f64>,
    /// Products of opposite entries, `b²`, rounded.
    squares: Vec<f64>,
    /// How far an eigenvalue that is counted may be from one of the matrix that was given.
    spread: f64,
}

/// Encloses the eigenvalues of a matrix whose off-diagonal entries form the path `order`, with positive products of
/// opposite ones.
///
/// # Errors
/// [`SpectrumError::Unproved`].
pub(super) fn tridiagonal_spectrum(a: &SparseMatrix, order: &[usize]) -> Result<Vec<Eigenvalue>, SpectrumError> {
    let found = Tridiagonal::new(a, order).ok_or(OUT_OF_RANGE)?.eigenvalues().ok_or(UNPROVED)?;
    let part = |(value, radius): (f64, f64)| Some(Eigenvalue::real(around(value, radius)?, 1));
    Ok(merged(found.into_iter().map(part).collect::<Option<Vec<_>>>().ok_or(UNPROVED)?))
}

/// The eigenvalues, in order, of the symmetric tridiagonal matrix with this diagonal and these entries beside it, each
/// with a proved bound.
///
/// # Errors
/// [`SpectrumError::Unproved`] where a number other than zero lies outside 1e-100 to 1e100, or `beside` is not one shorter.
pub fn tridiagonal_eigenvalues(diagonal: &[f64], beside: &[f64]) -> Result<Vec<FloatEnclosure>, SpectrumError> {
    if diagonal.len() != beside.len() + 1 {
        return Err(SpectrumError::Unproved("the side of a tridiagonal matrix is one shorter than its diagonal"));
    }
    if !diagonal.iter().chain(beside).all(|x| *x == 0.0 || RANGE.contains(&x.abs())) {
        return Err(OUT_OF_RANGE);
    }
    let found = Tridiagonal::from_floats(diagonal.to_vec(), beside).eigenvalues().ok_or(UNPROVED)?;
    Ok(found.into_iter().map(|(re, radius)| FloatEnclosure { re, im: 0.0, radius, multiplicity: 1 }).collect())
}

const UNPROVED: SpectrumError = SpectrumError::Unproved("the iteration for a tridiagonal matrix did not converge");

impl Tridiagonal {
    fn new(a: &SparseMatrix, order: &[usize]) -> Option<Self> {
        let diagonal: Vec<(f64, f64)> = order.iter().map(|&i| symmetric_entry(a, i, i)).collect::<Option<_>>()?;
        let square = |pair: &[usize]| nearest(&(a.get(pair[0], pair[1])? * a.get(pair[1], pair[0])?));
        let squares: Vec<f64> = order.windows(2).map(|pair| square(pair).map(|(x, _)| x)).collect::<Option<_>>()?;
        let error = diagonal.iter().fold(0.0, |most: f64, &(_, error)| most.max(error));
        let largest = squares.iter().fold(0.0, |most: f64, &x| most.max(x)).sqrt();
        let spread = (error + 14.0 * UNIT * largest) * SLACK + REPLACED;
        Some(Tridiagonal { diagonal: diagonal.into_iter().map(|(x, _)| x).collect(), squares, spread })
    }

    /// The matrix with this diagonal and these entries beside it, exactly.
    pub(super) fn from_floats(diagonal: Vec<f64>, beside: &[f64]) -> Self {
        let largest = beside.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        // A square below the range of floats hides an entry below 1e-150.
        let spread = 14.0 * UNIT * largest * SLACK + 1e-150;
        Tridiagonal { diagonal, squares: beside.iter().map(|b| b * b).collect(), spread }
    }

    /// The eigenvalues in order, each with a bound of its error; `None` where none could be proved.
    pub(super) fn eigenvalues(&self) -> Option<Vec<(f64, f64)>> {
        let mut values = self.approximate()?;
        values.sort_by(f64::total_cmp);
        let size = self.diagonal.iter().chain(&values).fold(0.0, |most: f64, x| most.max(x.abs()));
        let first = 16.0 * UNIT * size + self.spread;
        // The ends `value +- radius` are rounded.
        let rounding = 2.0 * UNIT * (size + first);
        let places: Vec<usize> = (0..values.len()).collect();
        // Each half of the lanes holds the lower and the upper ends of as many eigenvalues.
        let radii = places.par_chunks(LANES / 2).map(|chunk| {
            let end = |lane: usize| {
                let k = chunk[(lane / 2).min(chunk.len() - 1)];
                if lane.is_multiple_of(2) { values[k] - first } else { values[k] + first }
            };
            let counts = self.counts(std::array::from_fn(end));
            let radius = |(slot, &k): (usize, &usize)| {
                let proved = counts[2 * slot] <= k && counts[2 * slot + 1] > k;
                if proved { Some(first + rounding) } else { self.radius(values[k], k, first) }
            };
            chunk.iter().enumerate().map(radius).collect::<Option<Vec<f64>>>()
        });
        let radii: Vec<Vec<f64>> = radii.collect::<Option<_>>()?;
        let whole = |radius: f64| ((radius + self.spread) * SLACK).next_up();
        Some(values.into_iter().zip(radii.into_iter().flatten().map(whole)).collect())
    }

    /// The numbers of eigenvalues below each shift, for a matrix within `spread`.
    fn counts(&self, shifts: [f64; LANES]) -> [usize; LANES] {
        let mut counts = [0usize; LANES];
        let mut pivots = [1.0f64; LANES];
        let mut square = 0.0;
        for (i, &a) in self.diagonal.iter().enumerate() {
            for lane in 0..LANES {
                let pivot = (a - shifts[lane]) - square / pivots[lane];
                pivots[lane] = if pivot.abs() < LEAST_PIVOT { -LEAST_PIVOT } else { pivot };
                counts[lane] += usize::from(pivots[lane] < 0.0);
            }
            square = self.squares.get(i).copied().unwrap_or(0.0);
        }
        counts
    }

    /// A radius around a value that the counts prove to hold eigenvalue `k`.
    fn radius(&self, value: f64, k: usize, first: f64) -> Option<f64> {
        let mut radius = first;
        for _ in 0..MOST_DOUBLINGS {
            radius *= 2.0;
            let (lo, hi) = (value - radius, value + radius);
            let counts = self.counts(std::array::from_fn(|lane| if lane == 0 { lo } else { hi }));
            if counts[0] <= k && counts[1] > k {
                // The ends themselves are rounded.
                return Some(radius + UNIT * (lo.abs() + hi.abs()));
            }
        }
        None
    }

    /// The eigenvalues by implicit QL with Wilkinson's shift (Bowdler, Martin, Reinsch and Wilkinson 1968): no promise.
    fn approximate(&self) -> Option<Vec<f64>> {
        const MOST_STEPS: usize = 60;
        let mut d = self.diagonal.clone();
        let mut e: Vec<f64> = self.squares.iter().map(|x| x.sqrt()).chain([0.0]).collect();
        let order = d.len();
        for l in 0..order {
            for step in 0.. {
                let small = |m: usize| e[m].abs() <= UNIT * (d[m].abs() + d[m + 1].abs());
                let m = (l..order - 1).find(|&m| small(m)).unwrap_or(order - 1);
                if m == l {
                    break;
                }
                if step == MOST_STEPS {
                    return None;
                }
                sweep(&mut d, &mut e, l, m);
            }
        }
        d.iter().all(|x| x.is_finite()).then_some(d)
    }
}

/// One sweep on the rows `l..=m`.
fn sweep(d: &mut [f64], e: &mut [f64], l: usize, m: usize) {
    let slope = (d[l + 1] - d[l]) / (2.0 * e[l]);
    let root = (slope * slope + 1.0).sqrt();
    let mut g = d[m] - d[l] + e[l] / (slope + root.copysign(slope));
    let (mut sin, mut cos, mut p) = (1.0, 1.0, 0.0);
    for i in (l..m).rev() {
        let (f, b) = (sin * e[i], cos * e[i]);
        let r = (f * f + g * g).sqrt();
        e[i + 1] = r;
        if r == 0.0 {
            d[i + 1] -= p;
            e[m] = 0.0;
            return;
        }
        (sin, cos) = (f / r, g / r);
        g = d[i + 1] - p;
        let t = (d[i] - g) * sin + 2.0 * cos * b;
        p = sin * t;
        d[i + 1] = g + p;
        g = cos * t - b;
    }
    d[l] -= p;
    e[l] = g;
    e[m] = 0.0;
}
