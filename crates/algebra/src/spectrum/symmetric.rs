//! Real symmetric matrices: floating-point eigenvalues with proved enclosures, whatever their multiplicities.
//!
//! **Theorem** (Bhatia, Davis and Kittaneh 1991; Cao, Xie and Li 1996). Let `S` and `T` be symmetric, `Q` square and regular with
//! least singular value `σ`. With both sequences in order, `|λ_k(S) - λ_k(T)| <= ‖SQ - QT‖₂/σ`.
//!
//! *Proof.* Let `Q = UH` with `U` orthogonal and `H` positive definite, `B = UᵀSU`, `D = B - T` and `R = Uᵀ(SQ - QT) = BH - HT`. Then
//! `R + Rᵀ = DH + HD`. For a unit vector `x` with `Dx = dx`, `|d| = ‖D‖`, it gives `2 |d| xᵀHx = |xᵀ(R + Rᵀ)x| <= 2 ‖R‖`, and
//! `xᵀHx >= σ`. So `‖B - T‖ <= ‖R‖/σ`, and the rest is Weyl's theorem. ∎
//!
//! Here `T` is tridiagonal, found by reflections, and its eigenvalues are proved by [counts](super::tridiagonal). `σ`
//! need not be sharp; a bound comes with the [`reflections`](super::reflections) that `Q` is made of. The residual is a sum of few products where `S` is sparse; otherwise
//! a product whose leading part is exact in any order of summation. Nothing is assumed of how `Q` and `T` were found.

use super::Eigenvalue;
use super::block::Symmetric;
use super::enclosed::merged;
use super::float_bounds::{SLACK, Split, UNIT, around, frobenius};
use super::reduction::Reduction;
use super::tridiagonal::Tridiagonal;
use arithmetic::threads::map;
use dense::Mat;

/// Columns of `Q` that one task works on; the results do not depend on the number of threads.
const PANEL: usize = 128;

/// Columns of which a residual is summed up together.
const TOGETHER: usize = 4;

/// A matrix with more than one entry in so many is multiplied as a dense one.
const SPARSE: usize = 12;

/// Encloses the eigenvalues; `None` where nothing could be proved.
pub(super) fn symmetric_spectrum(s: &Symmetric) -> Option<Vec<Eigenvalue>> {
    let part = |(value, radius): (f64, f64)| Some(Eigenvalue::real(around(value, radius)?, 1));
    Some(merged(symmetric_floats(s)?.into_iter().map(part).collect::<Option<_>>()?))
}

/// The eigenvalues in order, each with a bound of its error.
pub(super) fn symmetric_floats(s: &Symmetric) -> Option<Vec<(f64, f64)>> {
    match s.rows.first() {
        None => return Some(Vec::new()),
        Some(row) if s.rows.len() == 1 => return Some(vec![(row.first().map_or(0.0, |&(_, x)| x), s.error)]),
        Some(_) => {}
    }
    // As a whole on a thread of the pool: from any other one, each of a hundred calls would have to wake one and wait for it.
    rayon::scope(|_| reduced_floats(s))
}

fn reduced_floats(s: &Symmetric) -> Option<Vec<(f64, f64)>> {
    let reduced = Reduced::new(s);
    if reduced.least.is_nan() || reduced.least < 0.5 {
        return None;
    }
    let residual = reduced.residual(s);
    let moved = (residual / reduced.least * SLACK + s.error) * SLACK;
    let found = Tridiagonal::from_floats(reduced.diagonal, &reduced.beside).eigenvalues()?;
    moved.is_finite().then(|| found.into_iter().map(|(value, radius)| (value, (radius + moved) * SLACK)).collect())
}

/// `SQ` is nearly `QT` for the tridiagonal `T`; nothing is promised.
struct Reduced {
    diagonal: Vec<f64>,
    beside: Vec<f64>,
    /// `Q` in panels of [`PANEL`] columns.
    panels: Vec<Mat<f64>>,
    /// A bound from below of its least singular value, or NaN.
    least: f64,
    /// `S` as a factor of products, where it is multiplied as a dense matrix.
    split: Option<Split>,
}

impl Reduced {
    /// Householder's reduction of a matrix of order 2 at least.
    fn new(s: &Symmetric) -> Self {
        let order = s.rows.len();
        let Reduction { diagonal, beside, reflections } = Reduction::new(dense(s));
        let panel = |k: usize| reflections.columns(k * PANEL, PANEL.min(order - k * PANEL));
        let entries: usize = s.rows.iter().map(Vec::len).sum();
        let split = || (entries > order * order / SPARSE).then(|| Split::new(dense(s)));
        let (panels, (least, split)) = rayon::join(
            || map(order.div_ceil(PANEL), panel),
            || rayon::join(|| reflections.least_singular_value(), split),
        );
        Reduced { diagonal, beside, panels, least, split }
    }

    fn column(&self, k: usize) -> &[f64] {
        self.panels[k / PANEL].col_as_slice(k % PANEL)
    }

    /// Bound of the Frobenius norm of `Q`.
    fn size(&self) -> f64 {
        let norms = map(self.panels.len(), |k| frobenius(self.panels[k].as_ref()));
        norms.into_iter().map(|x| x * x).sum::<f64>().sqrt() * SLACK
    }

    /// `‖SQ - QT‖` in the Frobenius norm, rounded up.
    fn residual(&self, s: &Symmetric) -> f64 {
        let (order, size) = (self.diagonal.len(), self.size());
        // Rows and columns of T sum to at most this in absolute value, and so its norm is at most this.
        let largest = |x: &[f64]| x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let small = largest(&self.diagonal) + 2.0 * largest(&self.beside);
        let (squares, rounding) = if let Some(split) = &self.split {
            self.dense_residual(split, small)
        } else {
            let squares = map(order.div_ceil(TOGETHER), |k| self.sparse_residual(s, k * TOGETHER)).concat();
            // Sums of at most so many products; |S| has a norm of at most its largest row sum.
            let terms = s.rows.iter().map(Vec::len).max().unwrap_or(0) + 5;
            let sums = s.rows.iter().map(|row| row.iter().map(|(_, x)| x.abs()).sum::<f64>()).fold(0.0, f64::max);
            (squares, terms as f64 * UNIT * (sums + small) * size)
        };
        squares.into_iter().sum::<f64>().sqrt() * SLACK + rounding * SLACK + 1e-150
    }

    /// `Q t_k`, where `t_k` is column `k` of `T`, for one row.
    #[inline(always)]
    fn image(&self, k: usize) -> impl Fn(usize) -> f64 {
        let own = self.column(k);
        let (before, left) = if k > 0 { (self.column(k - 1), self.beside[k - 1]) } else { (own, 0.0) };
        let (after, right) =
            if k + 1 < self.diagonal.len() { (self.column(k + 1), self.beside[k]) } else { (own, 0.0) };
        let diagonal = self.diagonal[k];
        move |i| own[i] * diagonal + before[i] * left + after[i] * right
    }

    /// The sums of the squares of some columns of `SQ - QT`, from `start` on.
    fn sparse_residual(&self, s: &Symmetric, start: usize) -> [f64; TOGETHER] {
        let (count, last) = (self.diagonal.len() - start, self.diagonal.len() - 1);
        let columns: [usize; TOGETHER] = std::array::from_fn(|c| (start + c).min(last));
        let (own, images) = (columns.map(|k| self.column(k)), columns.map(|k| self.image(k)));
        let mut squares = [0.0; TOGETHER];
        for (i, row) in s.rows.iter().enumerate() {
            let mut sums = images.each_ref().map(|image| -image(i));
            for &(j, x) in row {
                sums.iter_mut().zip(&own).for_each(|(sum, own)| *sum += x * own[j]);
            }
            squares.iter_mut().zip(sums).for_each(|(square, sum)| *square += sum * sum);
        }
        std::array::from_fn(|c| if c < count { squares[c] } else { 0.0 })
    }

    /// The sums of the squares by panels, and a bound of the rounding.
    fn dense_residual(&self, split: &Split, small: f64) -> (Vec<f64>, f64) {
        let panel = |number: usize| {
            let mut product = split.times(&self.panels[number]);
            let sizes = frobenius(product.exact.as_ref()) + frobenius(product.rest.as_ref());
            for j in 0..self.panels[number].ncols() {
                let image = self.image(number * PANEL + j);
                let entries =
                    product.rest.col_as_slice_mut(j).iter_mut().zip(product.exact.col_as_slice(j)).enumerate();
                entries.for_each(|(i, (rest, exact))| *rest += exact - image(i));
            }
            let norm = frobenius(product.rest.as_ref());
            (norm * norm, product.error + 8.0 * UNIT * sizes)
        };
        let parts: Vec<(f64, f64)> = map(self.panels.len(), panel);
        let rounding = parts.iter().map(|part| part.1).sum::<f64>() + 8.0 * UNIT * small * self.size();
        (parts.into_iter().map(|part| part.0).collect(), rounding)
    }
}

fn dense(s: &Symmetric) -> Mat<f64> {
    let mut matrix = Mat::zeros(s.rows.len(), s.rows.len());
    for (i, row) in s.rows.iter().enumerate() {
        // Column by column; entry `(j, i)` is the same.
        row.iter().for_each(|&(j, x)| matrix[(j, i)] = x);
    }
    matrix
}

#[cfg(test)]
mod tests {
    use super::super::testing::{assert_rounded_up, whole};
    use super::*;

    /// The matrix with these entries, those of value zero left out.
    fn matrix(order: usize, error: f64, entry: impl Fn(usize, usize) -> f64) -> Symmetric {
        let row = |i: usize| (0..order).map(|j| (j, entry(i.min(j), i.max(j)))).filter(|(_, x)| *x != 0.0).collect();
        Symmetric { rows: (0..order).map(row).collect(), error }
    }

    /// Any `Q` and `T` of whole numbers beside it.
    fn beside(s: &Symmetric, is_dense: bool) -> Reduced {
        let order = s.rows.len();
        let panel = |&start: &usize| Mat::from_fn(order, PANEL.min(order - start), |i, j| whole(i + 2, start + j));
        Reduced {
            diagonal: (0..order).map(|k| whole(k, 5)).collect(),
            beside: (1..order).map(|k| whole(k, 1)).collect(),
            panels: (0..order).step_by(PANEL).collect::<Vec<_>>().iter().map(panel).collect(),
            least: 1.0,
            split: is_dense.then(|| Split::new(dense(s))),
        }
    }

    /// The square of `‖SQ - QT‖`, from the definition.
    fn exact_square(s: &Symmetric, reduced: &Reduced) -> f64 {
        let (order, s) = (s.rows.len(), dense(s));
        let q = |i: usize, k: usize| reduced.column(k)[i];
        let t = |j: usize, k: usize| match j.abs_diff(k) {
            0 => reduced.diagonal[k],
            1 => reduced.beside[j.min(k)],
            _ => 0.0,
        };
        let near = |k: usize| k.saturating_sub(1)..(k + 2).min(order);
        let entry = |(i, k): (usize, usize)| {
            let left: f64 = (0..order).map(|j| s[(i, j)] * q(j, k)).sum();
            left - near(k).map(|j| q(i, j) * t(j, k)).sum::<f64>()
        };
        (0..order).flat_map(|i| (0..order).map(move |k| (i, k))).map(|place| entry(place).powi(2)).sum()
    }

    #[test]
    fn residuals_are_rounded_up_and_hardly_at_all() {
        for order in [2, 3, 4, 5, 6, 7, 130, 259] {
            let s = matrix(order, 0.0, |i, j| if (i + j) % 5 < 2 || j < i + 2 { whole(i, j) } else { 0.0 });
            for is_dense in [false, true] {
                let reduced = beside(&s, is_dense);
                let exact = exact_square(&s, &reduced).sqrt();
                let found = reduced.residual(&s);
                assert_rounded_up(found, exact, &format!("{order}, {is_dense}"));
            }
        }
    }

    /// Where `SQ = QT` exactly, with `Q` the identity, what is left is what rounding might have done.
    #[test]
    fn rounding_counts_as_derived() {
        for order in [3, 40, 129] {
            let s = matrix(order, 0.0, |i, j| if j == i + 1 { 3.0 } else { 0.0 });
            for is_dense in [false, true] {
                let identity = beside(&s, is_dense);
                let column = |j: usize| move |i: usize, k: usize| f64::from(u8::from(i == j + k));
                let panels = identity.panels.iter().enumerate();
                let panels = panels.map(|(n, panel)| Mat::from_fn(order, panel.ncols(), column(n * PANEL))).collect();
                let reduced = Reduced { diagonal: vec![0.0; order], beside: vec![3.0; order - 1], panels, ..identity };
                let found = reduced.residual(&s);
                // |T| <= 6, |S| <= 6, |Q| = sqrt(n) in the Frobenius norm, and seven terms: two products, three of the image, two more sums.
                let (size, norm) = ((order as f64).sqrt(), (18.0 * (order - 1) as f64).sqrt());
                let derived = match is_dense {
                    false => 7.0 * UNIT * 12.0 * size,
                    // The exact parts of the products, by panels, and those of the images.
                    true => 8.0 * UNIT * 6.0 * size + 8.0 * UNIT * norm,
                };
                let most = if is_dense { 8.0 * UNIT * (6.0 * size + 2.0 * norm) } else { derived };
                assert!(derived <= found && found <= most * (1.0 + 1e-5), "{order}, {is_dense}: {}", found / UNIT);
            }
        }
    }

    #[test]
    fn what_is_not_known_of_the_entries_counts() {
        let all = |order: usize| matrix(order, 0.25, whole);
        for order in [1, 2, 5, 30] {
            for (_, radius) in symmetric_floats(&all(order)).expect("a bound") {
                assert!((0.25..0.25 + 1e-6).contains(&radius), "{order}: {radius}");
            }
        }
        let first = |order: usize| symmetric_floats(&all(order)).expect("a bound").first().copied();
        assert_eq!((first(0), first(1)), (None, Some((whole(0, 0), 0.25))));
        assert_eq!(symmetric_floats(&matrix(1, 0.5, |_, _| 0.0)), Some(vec![(0.0, 0.5)]));
    }
}
