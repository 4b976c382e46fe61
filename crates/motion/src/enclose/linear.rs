//! Small matrices of floats and intervals.

use super::IntervalVector;
use arithmetic::FloatInterval;
use nalgebra::DMatrix;

/// A square matrix of intervals, by rows.
pub(super) type IntervalMatrix = Vec<IntervalVector>;

const ZERO: f64 = 0.0;

/// `sum a_k b_k`.
fn dot(a: &[FloatInterval], b: &[FloatInterval]) -> FloatInterval {
    a.iter().zip(b).fold(FloatInterval::point(ZERO), |sum, (x, y)| sum + *x * y)
}

/// A product of matrices.
fn times(a: &[IntervalVector], b: &[IntervalVector]) -> IntervalMatrix {
    let columns: IntervalMatrix = (0..b.len()).map(|j| b.iter().map(|row| row[j]).collect()).collect();
    a.iter().map(|row| columns.iter().map(|column| dot(row, column)).collect()).collect()
}

/// The columns of the unit matrix.
pub(super) fn unit_columns(size: usize) -> Vec<Vec<f64>> {
    (0..size).map(|j| (0..size).map(|i| f64::from(u8::from(i == j))).collect()).collect()
}

/// A square matrix of floats, by columns.
#[derive(Debug, Clone)]
pub(super) struct Frame(Vec<Vec<f64>>);

impl Frame {
    /// Its columns.
    pub fn into_columns(self) -> Vec<Vec<f64>> {
        self.0
    }

    /// The matrix.
    fn points(&self) -> IntervalMatrix {
        (0..self.0.len()).map(|i| self.0.iter().map(|column| FloatInterval::point(column[i])).collect()).collect()
    }

    /// Its transpose.
    pub fn transposed(&self) -> IntervalMatrix {
        self.0.iter().map(|column| column.iter().map(|&x| FloatInterval::point(x)).collect()).collect()
    }
}

/// The largest sum of the magnitudes in a row, rounded up.
fn row_norm(a: &[IntervalVector]) -> f64 {
    let row = |row: &IntervalVector| {
        row.iter().fold(FloatInterval::point(ZERO), |sum, x| sum + FloatInterval::point(x.magnitude())).hi()
    };
    a.iter().map(row).fold(ZERO, |most, x| if x > most || x.is_nan() { x } else { most })
}

/// An orthogonal matrix, up to rounding, whose first columns span the longest of at least as many columns as they have numbers; by nalgebra.
pub(super) fn frame_of(mut columns: Vec<Vec<f64>>) -> Frame {
    let square = |column: &[f64]| column.iter().map(|x| x * x).sum::<f64>();
    columns.sort_by(|x, y| square(y).total_cmp(&square(x)));
    let size = columns.first().map_or(0, Vec::len);
    let factor = DMatrix::from_fn(size, columns.len(), |i, j| columns[j][i]).qr().q();
    Frame(factor.column_iter().map(|column| column.iter().copied().collect()).collect())
}

/// A bound of `‖(FᵀF)⁻¹ - I‖` in the norm of row sums, for a frame that is nearly orthogonal; `None` where it is not.
pub(super) fn departure(frame: &Frame) -> Option<f64> {
    let mut gram = times(&frame.transposed(), &frame.points());
    gram.iter_mut().enumerate().for_each(|(i, row)| row[i] = row[i] - FloatInterval::point(1.0));
    let g = row_norm(&gram);
    // (I + G)⁻¹ - I = -G + G² - ...
    (g < 0.25).then(|| (FloatInterval::point(g) * FloatInterval::point(1.5)).hi())
}
