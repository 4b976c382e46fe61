//! Tridiagonal matrices with positive products of opposite entries (weighted paths, platoons): eigenvalues by Laguerre's
//! iteration, enclosed by counting negative pivots.
//!
//! **Counts in floating point.** The pivots `q_i = (a_i - x) - b²_{i-1}/q_{i-1}` computed with rounding have the signs of the
//! exact pivots of a matrix whose `b²` differ by factors of four roundings each: divide `q_i` by the factors of its two
//! subtractions (Kahan 1966; Demmel, Applied Numerical Linear Algebra, 5.3.4). With the rounding of the entries themselves
//! that moves `b` by less than `7 u b`, so no eigenvalue moves by more than `14 u max b` plus the largest error of an `a_i`
//! (Weyl). Pivots below `1e-200` are replaced, which is a change of `a_i` of that size.

use super::block::symmetric_entry;
use super::enclosed::merged;
use super::error::{OUT_OF_RANGE, SpectrumError};
use super::float_bounds::{RANGE, SLACK, UNIT, around, nearest};
use super::{Eigenvalue, FloatEnclosure};
use crate::matrix::SparseMatrix;
use arithmetic::threads::map_chunks;

/// Pivots closer to zero are replaced.
const LEAST_PIVOT: f64 = 1e-200;

/// What replaced pivots and underflow change.
const REPLACED: f64 = 1e-190;

/// Shifts that are counted at once: as many as keep the divider busy while each waits for its last quotient.
const LANES: usize = 16;

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
    let matrix = Tridiagonal::new(a, order).ok_or(OUT_OF_RANGE)?;
    let found = rayon::scope(|_| matrix.eigenvalues()).ok_or(UNPROVED)?;
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
    let matrix = Tridiagonal::from_floats(diagonal.to_vec(), beside);
    let found = rayon::scope(|_| matrix.eigenvalues()).ok_or(UNPROVED)?;
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
        let found = map_chunks(&places, LANES / 2, |chunk| {
            let end = |lane: usize| {
                let k = chunk[(lane / 2).min(chunk.len() - 1)];
                if lane.is_multiple_of(2) { values[k] - first } else { values[k] + first }
            };
            let counts = self.counts(std::array::from_fn(end));
            let enclosure = |(slot, &k): (usize, &usize)| {
                let proved = counts[2 * slot] <= k && counts[2 * slot + 1] > k;
                if proved { Some((values[k], first + rounding)) } else { self.bisected(values[k], k, first) }
            };
            chunk.iter().enumerate().map(enclosure).collect::<Option<Vec<(f64, f64)>>>()
        });
        let found: Vec<Vec<(f64, f64)>> = found.into_iter().collect::<Option<_>>()?;
        let whole = |radius: f64| ((radius + self.spread) * SLACK).next_up();
        let mut last = f64::NEG_INFINITY;
        let in_order = |(value, radius): (f64, f64)| {
            // Of two that are as good as equal the centres may be exchanged.
            let moved = (last - value).max(0.0);
            last = value + moved;
            (last, whole(radius + 2.0 * moved))
        };
        Some(found.into_iter().flatten().map(in_order).collect())
    }

    /// The numbers of eigenvalues below each shift, for a matrix within `spread`.
    fn counts(&self, shifts: [f64; LANES]) -> [usize; LANES] {
        pulp::Arch::new().dispatch(Counts { matrix: self, shifts }).map(|count| count as usize)
    }

    /// A centre and a radius of about `wanted` that the counts prove to hold eigenvalue `k`, which is somewhere about a value: among several close to
    /// each other the iteration may have come to another one.
    fn bisected(&self, value: f64, k: usize, wanted: f64) -> Option<(f64, f64)> {
        let (mut lo, mut hi) = self.bracket(value, k, wanted)?;
        for _ in 0..MOST_DOUBLINGS {
            if hi - lo <= 2.0 * wanted {
                break;
            }
            let part = (hi - lo) / (LANES + 1) as f64;
            let shifts = std::array::from_fn(|lane| lo + part * (lane + 1) as f64);
            let above = self.counts(shifts).iter().position(|count| *count > k).unwrap_or(LANES);
            lo = above.checked_sub(1).map_or(lo, |below| shifts[below]);
            hi = shifts.get(above).copied().unwrap_or(hi);
        }
        // The centre and the differences are rounded.
        let centre = lo.midpoint(hi);
        Some((centre, (hi - centre).max(centre - lo) + UNIT * (lo.abs() + hi.abs())))
    }

    /// Two numbers between which the counts prove eigenvalue `k` to be, no nearer to a value than twice the radius.
    fn bracket(&self, value: f64, k: usize, mut radius: f64) -> Option<(f64, f64)> {
        for _ in 0..MOST_DOUBLINGS {
            radius *= 2.0;
            let (lo, hi) = (value - radius, value + radius);
            let counts = self.counts(std::array::from_fn(|lane| if lane == 0 { lo } else { hi }));
            if counts[0] <= k && counts[1] > k {
                return Some((lo, hi));
            }
        }
        None
    }

    /// The eigenvalues in order, nearly: brackets from counts on a grid, then Laguerre's iteration where the next root is the one
    /// that is sought, and bisection elsewhere (Li and Zeng 1994). No promise.
    fn approximate(&self) -> Option<Vec<f64>> {
        let order = self.diagonal.len();
        let beside = |i: usize| self.squares.get(i).map_or(0.0, |b| b.sqrt());
        let reach = |i: usize| beside(i) + if i > 0 { beside(i - 1) } else { 0.0 };
        let least = (0..order).map(|i| self.diagonal[i] - reach(i)).fold(f64::INFINITY, f64::min);
        let most = (0..order).map(|i| self.diagonal[i] + reach(i)).fold(f64::NEG_INFINITY, f64::max);
        let size = least.abs().max(most.abs());
        if !size.is_finite() {
            return None;
        }
        let (least, most) = (least - 8.0 * UNIT * size - REPLACED, most + 8.0 * UNIT * size + REPLACED);
        let shifts: Vec<f64> = (0..=order).map(|k| least + (most - least) * (k as f64 / order as f64)).collect();
        let counted = |chunk: &[f64]| self.counts(std::array::from_fn(|k| chunk[k.min(chunk.len() - 1)]));
        let mut counts: Vec<usize> = map_chunks(&shifts, LANES, counted).concat();
        counts.truncate(order + 1);
        let mut searches: Vec<Search> = (0..order)
            .map(|k| {
                let above = counts.partition_point(|&count| count <= k).clamp(1, order);
                Search::new(k, shifts[above - 1], shifts[above])
            })
            .collect();
        let mut active: Vec<usize> = (0..order).collect();
        for _ in 0..MOST_ROUNDS {
            let moved = map_chunks(&active, LANES, |chunk| {
                let at = std::array::from_fn(|lane| searches[chunk[lane.min(chunk.len() - 1)]].x);
                let found = pulp::Arch::new().dispatch(Logarithm { matrix: self, shifts: at });
                let next = |(lane, &k): (usize, &usize)| (k, searches[k].next(found.at(lane), order as f64, size));
                chunk.iter().enumerate().map(next).collect::<Vec<(usize, Search)>>()
            });
            active.clear();
            for (k, search) in moved.into_iter().flatten() {
                searches[k] = search;
                if !search.done {
                    active.push(k);
                }
            }
            if active.is_empty() {
                break;
            }
        }
        Some(searches.into_iter().map(|search| search.x).collect())
    }
}

/// Rounds of the iteration; bisection alone would need about as many.
const MOST_ROUNDS: usize = 120;

/// The search for one eigenvalue.
#[derive(Debug, Clone, Copy)]
struct Search {
    /// Which one, from 0.
    k: usize,
    lo: f64,
    hi: f64,
    /// Where the matrix is looked at next.
    x: f64,
    /// The last step of the iteration, zero after a bisection and after a step towards several roots.
    step: f64,
    done: bool,
}

impl Search {
    fn new(k: usize, lo: f64, hi: f64) -> Self {
        Search { k, lo, hi, x: lo.midpoint(hi), step: 0.0, done: false }
    }

    /// The search after a look at `x`.
    fn next(mut self, look: Look, order: f64, size: f64) -> Self {
        if look.below <= self.k {
            self.lo = self.lo.max(self.x);
        } else {
            self.hi = self.hi.min(self.x);
        }
        // The next root to the right is the one sought, or the next one to the left.
        let towards = if look.below <= self.k { 1.0 } else { -1.0 };
        let laguerre = |multiplicity: f64| {
            let share = (order - multiplicity) / multiplicity;
            let spread = (share * (order * look.squares - look.sum * look.sum)).max(0.0).sqrt();
            order / (look.sum + towards * spread)
        };
        let mut step = laguerre(1.0);
        // Linear convergence: several roots, as many as this quotient says near them.
        let several = step.abs() > 0.15 * self.step.abs() && step.abs() < 0.5 * self.step.abs();
        if several {
            step = laguerre((look.sum * look.sum / look.squares).round().clamp(1.0, order));
        }
        let near = (self.k..=self.k + 3).contains(&look.below);
        let adjacent = look.below == self.k || look.below == self.k + 1;
        let target = self.x + step;
        // Convergence towards one root is cubic: the next step is to this one as the cube of this one to that of the last.
        let settling = adjacent && !several && step.abs() < 1e-2 * self.step.abs();
        let next = if settling { (step / self.step).powi(3) * step } else { f64::INFINITY };
        if near && (step.abs() <= 2.0 * UNIT * size || next.abs() <= 1e-3 * UNIT * size) {
            (self.x, self.done) = (target, true);
        } else if adjacent && self.lo < target && target < self.hi {
            (self.x, self.step) = (target, if several { 0.0 } else { step });
        } else {
            self.done = self.hi - self.lo <= 2.0 * UNIT * size;
            (self.x, self.step) = (self.lo.midpoint(self.hi), 0.0);
        }
        self
    }
}

/// What is seen of the characteristic polynomial at some places: `sum 1/(λ - x)`, `sum 1/(λ - x)²`, and how many `λ` are below.
struct Looks {
    below: [u64; LANES],
    sums: [f64; LANES],
    squares: [f64; LANES],
}

#[derive(Debug, Clone, Copy)]
struct Look {
    below: usize,
    sum: f64,
    squares: f64,
}

impl Looks {
    fn at(&self, lane: usize) -> Look {
        Look { below: self.below[lane] as usize, sum: self.sums[lane], squares: self.squares[lane] }
    }
}

/// The logarithmic derivatives of the characteristic polynomial, the product of the pivots `q`: with `r = 1/q`, `u = q'r` and
/// `v = q''r`, the next pivot has `q' = -1 + b² r u` and `q'' = b² r (v - 2u²)`.
struct Logarithm<'a> {
    matrix: &'a Tridiagonal,
    shifts: [f64; LANES],
}

impl pulp::WithSimd for Logarithm<'_> {
    type Output = Looks;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Looks {
        let mut looks = Looks { below: [0; LANES], sums: [0.0; LANES], squares: [0.0; LANES] };
        let (mut r, mut u, mut v) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        let squares = std::iter::once(&0.0).chain(&self.matrix.squares);
        for (&a, &square) in self.matrix.diagonal.iter().zip(squares) {
            for lane in 0..LANES {
                let weight = square * r[lane];
                let pivot = (a - self.shifts[lane]) - weight;
                let pivot = if pivot.abs() < LEAST_PIVOT { -LEAST_PIVOT } else { pivot };
                let inverse = 1.0 / pivot;
                let slope = (weight * u[lane] - 1.0) * inverse;
                let bend = (weight * (v[lane] - 2.0 * u[lane] * u[lane])) * inverse;
                (r[lane], u[lane], v[lane]) = (inverse, slope, bend);
                looks.sums[lane] -= slope;
                looks.squares[lane] += slope * slope - bend;
                looks.below[lane] += u64::from(pivot < 0.0);
            }
        }
        looks
    }
}

/// The numbers of negative pivots.
struct Counts<'a> {
    matrix: &'a Tridiagonal,
    shifts: [f64; LANES],
}

impl pulp::WithSimd for Counts<'_> {
    type Output = [u64; LANES];

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> [u64; LANES] {
        let mut counts = [0; LANES];
        let mut pivots = [1.0f64; LANES];
        let squares = std::iter::once(&0.0).chain(&self.matrix.squares);
        for (&a, &square) in self.matrix.diagonal.iter().zip(squares) {
            for lane in 0..LANES {
                let pivot = (a - self.shifts[lane]) - square / pivots[lane];
                pivots[lane] = if pivot.abs() < LEAST_PIVOT { -LEAST_PIVOT } else { pivot };
                counts[lane] += u64::from(pivots[lane] < 0.0);
            }
        }
        counts
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use arithmetic::rational;

    /// Twice the largest error of a diagonal entry that is rounded, with squares that are rounded too.
    #[test]
    fn a_matrix_of_rationals_is_known_up_to_the_rounding_of_its_entries() {
        let third = |n: i64| rational(n, 3);
        let entries = [
            (0, 0, third(-7)),
            (0, 1, third(2)),
            (1, 0, third(8)),
            (1, 1, third(1)),
            (1, 2, third(1)),
            (2, 1, third(1)),
        ];
        let matrix = Tridiagonal::new(&SparseMatrix::from_entries(3, entries), &[0, 1, 2]).expect("in range");
        let derived = 4.0 * UNIT * (7.0 / 3.0) + 14.0 * UNIT * (4.0 / 3.0);
        assert!(derived <= matrix.spread && matrix.spread <= derived * SLACK * SLACK, "{}", matrix.spread / UNIT);
    }

    #[test]
    fn a_value_that_is_off_leads_to_the_eigenvalue() {
        let matrix = Tridiagonal::from_floats(vec![1.0, 2.0, 4.0], &[0.0, 0.0]);
        for (k, exact) in [1.0, 2.0, 4.0].into_iter().enumerate() {
            for off in [-0.9, -0.3, -1e-9, 0.0, 1e-9, 0.3, 0.9] {
                let (lo, hi) = matrix.bracket(exact + off, k, 1e-14).expect("a bracket");
                assert!(lo <= exact && exact <= hi && hi - lo <= f64::abs(off) * 4.1 + 5e-14, "{k}, {off}: {lo} {hi}");
                let (centre, radius) = matrix.bisected(exact + off, k, 1e-14).expect("a radius");
                assert!((centre - exact).abs() <= radius && radius <= 1.1e-14, "{k}, {off}: {centre} {radius}");
            }
        }
        assert!(matrix.bracket(1e99, 0, 1e-14).is_none());
        // One look at sixteen places cuts a bracket of [3, 5] into seventeen parts.
        let (centre, radius) = matrix.bisected(4.0, 2, 0.5).expect("a radius");
        assert!((centre - 4.0).abs() < 1e-14 && (radius - 1.0 / 17.0).abs() < 1e-14, "{centre} {radius}");
    }
}
