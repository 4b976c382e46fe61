//! Exact linear systems: fraction-free elimination over the integers (Bareiss).

use super::{MatrixError, RationalMatrix};
use num_bigint::BigInt;
use num_traits::{One, Zero};

impl RationalMatrix {
    /// The solution `X` of `self * X = right`. `self` is square and has as many rows as `right`.
    ///
    /// Cost: `order^2 (order + columns of right)` products of minors; no number exceeds Hadamard's bound.
    ///
    /// # Errors
    /// [`MatrixError::NotSquare`], [`MatrixError::Shapes`] or [`MatrixError::Singular`].
    pub fn solve(&self, right: &Self) -> Result<Self, MatrixError> {
        let order = self.square_order()?;
        if right.rows() != order {
            return Err(MatrixError::Shapes { left_cols: order, right_rows: right.rows() });
        }
        let mut rows: Vec<Vec<BigInt>> = (0..order).map(|i| [self.row(i), right.row(i)].concat()).collect();
        let pivot = eliminate(&mut rows).ok_or(MatrixError::Singular)?;
        // With self = N/d and right = B/e the solution is (d/e) N^-1 B, and the rows now hold pivot * N^-1 B.
        let scale = self.denominator();
        let numerators = rows.iter().flat_map(|row| &row[order..]).map(|x| x * scale).collect();
        Ok(RationalMatrix::new(order, right.cols(), numerators, pivot * right.denominator())?.reduced())
    }

    /// The inverse, reduced.
    ///
    /// # Errors
    /// [`MatrixError::NotSquare`] or [`MatrixError::Singular`].
    pub fn inverse(&self) -> Result<Self, MatrixError> {
        self.solve(&RationalMatrix::identity(self.square_order()?)?)
    }

    /// The number of rows, where there are as many columns.
    pub(super) fn square_order(&self) -> Result<usize, MatrixError> {
        match (self.rows(), self.cols()) {
            (rows, cols) if rows == cols => Ok(rows),
            (rows, cols) => Err(MatrixError::NotSquare { rows, cols }),
        }
    }
}

/// Gauss-Jordan elimination without fractions on the rows `[N | B]`, `N` square: afterwards they are `[p I | p N^-1 B]`
/// and `p`, the determinant of `N` up to sign, is returned. `None` if `N` is singular.
///
/// Every division is exact, because after step `k` each entry is a minor of order `k` or `k + 1` (Bareiss 1968).
fn eliminate(rows: &mut [Vec<BigInt>]) -> Option<BigInt> {
    let mut previous = BigInt::one();
    for k in 0..rows.len() {
        let with_pivot = (k..rows.len()).find(|&i| !rows[i][k].is_zero())?;
        rows.swap(k, with_pivot);
        let pivot_row = rows[k].clone();
        let pivot = &pivot_row[k];
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = row[k].clone();
            for (x, y) in row.iter_mut().zip(&pivot_row) {
                *x = (pivot * &*x - &factor * y) / &previous;
            }
        }
        previous.clone_from(pivot);
    }
    Some(previous)
}
