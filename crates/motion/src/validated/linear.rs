//! Small matrices of floats and intervals.

use super::IntervalVector;
use arithmetic::{FloatInterval, Ring};
use nalgebra::DMatrix;

/// A square matrix of intervals, by rows.
pub(super) type IntervalMatrix = Vec<IntervalVector>;

const ZERO: f64 = 0.0;

/// `sum a_k b_k`.
pub(super) fn dot(a: &[FloatInterval], b: &[FloatInterval]) -> FloatInterval {
    a.iter().zip(b).fold(FloatInterval::point(ZERO), |sum, (x, y)| sum + *x * y)
}

/// A matrix times a vector.
pub(super) fn apply(a: &[IntervalVector], x: &[FloatInterval]) -> IntervalVector {
    a.iter().map(|row| dot(row, x)).collect()
}

/// A product of matrices.
pub(super) fn times(a: &[IntervalVector], b: &[IntervalVector]) -> IntervalMatrix {
    let columns: IntervalMatrix = (0..b.len()).map(|j| b.iter().map(|row| row[j]).collect()).collect();
    a.iter().map(|row| columns.iter().map(|column| dot(row, column)).collect()).collect()
}

/// A matrix of floats.
pub(super) fn points(a: &DMatrix<f64>) -> IntervalMatrix {
    a.row_iter().map(|row| row.iter().map(|&x| FloatInterval::point(x)).collect()).collect()
}

/// The largest sum of the magnitudes in a row, rounded up.
pub(super) fn row_norm(a: &[IntervalVector]) -> f64 {
    let row = |row: &IntervalVector| {
        row.iter().fold(FloatInterval::point(ZERO), |sum, x| sum + FloatInterval::point(x.magnitude())).hi()
    };
    a.iter().map(row).fold(ZERO, |most, x| if x > most || x.is_nan() { x } else { most })
}

/// An orthogonal matrix, up to rounding, whose first columns span the longest of the columns of `a`.
pub(super) fn frame_of(a: &[IntervalVector], lengths: &[f64]) -> DMatrix<f64> {
    let size = a.len();
    let middle = DMatrix::from_fn(size, size, |i, j| a[i][j].midpoint() * lengths[j]);
    let mut order: Vec<usize> = (0..size).collect();
    order.sort_by(|&i, &j| middle.column(j).norm().total_cmp(&middle.column(i).norm()));
    DMatrix::from_fn(size, size, |i, j| middle[(i, order[j])]).qr().q()
}

/// A bound of `‖(FᵀF)⁻¹ - I‖` in the norm of row sums, for a frame that is nearly orthogonal; `None` where it is not.
pub(super) fn departure(frame: &DMatrix<f64>) -> Option<f64> {
    let size = frame.nrows();
    let mut gram = times(&points(&frame.transpose()), &points(frame));
    (0..size).for_each(|i| gram[i][i] = gram[i][i] - FloatInterval::point(1.0));
    let g = row_norm(&gram);
    // (I + G)⁻¹ - I = -G + G² - ...
    (g < 0.25).then(|| (FloatInterval::point(g) * FloatInterval::point(1.5)).hi())
}

/// The unit matrix, each entry a scalar of the kind of `like`.
pub(super) fn unit_vectors<T: Ring>(size: usize, like: &T) -> impl Iterator<Item = Vec<T>> {
    let (zero, one) = (like.zero(), like.one());
    (0..size).map(move |k| (0..size).map(|j| if j == k { one.clone() } else { zero.clone() }).collect())
}
