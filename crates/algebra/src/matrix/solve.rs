//! Linear systems: fraction-free elimination over the integers (Bareiss), and plain elimination over any scalars.

use super::{MatrixError, RationalMatrix};
use arithmetic::{ArithmeticError, Cancelled, Field, Progress, Rational, Sign, Signed, Unwatched};
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
        self.solve_watched(right, &Unwatched)
    }

    /// As [`RationalMatrix::solve`], until `progress` stops it.
    ///
    /// # Errors
    /// As there, and [`MatrixError::Cancelled`].
    pub fn solve_watched(&self, right: &Self, progress: &dyn Progress) -> Result<Self, MatrixError> {
        let order = self.square_order()?;
        if right.rows() != order {
            return Err(MatrixError::Shapes { left_cols: order, right_rows: right.rows() });
        }
        let mut rows: Vec<Vec<BigInt>> = (0..order).map(|i| [self.row(i), right.row(i)].concat()).collect();
        let Elimination { pivot_columns, pivot, .. } = eliminate(&mut rows, order, progress)?;
        if pivot_columns.len() < order {
            return Err(MatrixError::Singular);
        }
        // With self = N/d and right = B/e the solution is (d/e) N^-1 B, and the rows now hold pivot * N^-1 B.
        let scale = self.denominator();
        let numerators = rows.iter().flat_map(|row| &row[order..]).map(|x| x * scale).collect();
        RationalMatrix::new(order, right.cols(), numerators, pivot * right.denominator())?.reduced_watched(progress)
    }

    /// The inverse, reduced.
    ///
    /// # Errors
    /// [`MatrixError::NotSquare`] or [`MatrixError::Singular`].
    pub fn inverse(&self) -> Result<Self, MatrixError> {
        self.inverse_watched(&Unwatched)
    }

    /// As [`RationalMatrix::inverse`], until `progress` stops it.
    ///
    /// # Errors
    /// As there, and [`MatrixError::Cancelled`].
    pub fn inverse_watched(&self, progress: &dyn Progress) -> Result<Self, MatrixError> {
        self.solve_watched(&RationalMatrix::identity(self.square_order()?)?, progress)
    }

    /// The determinant.
    ///
    /// # Errors
    /// [`MatrixError::NotSquare`].
    pub fn determinant(&self) -> Result<Rational, MatrixError> {
        let order = self.square_order()?;
        let mut rows: Vec<Vec<BigInt>> = (0..order).map(|i| self.row(i).to_vec()).collect();
        let Elimination { pivot_columns, pivot, odd } = eliminate(&mut rows, order, &Unwatched)?;
        if pivot_columns.len() < order {
            return Ok(Rational::zero());
        }
        Ok(Rational::new(if odd { -pivot } else { pivot }, num_traits::pow(self.denominator().clone(), order)))
    }

    /// A basis of the vectors `x` with `self * x = 0`, one for each column without pivot.
    pub fn kernel(&self) -> Vec<Vec<Rational>> {
        let mut rows: Vec<Vec<BigInt>> = (0..self.rows()).map(|i| self.row(i).to_vec()).collect();
        // Nobody stops it.
        let Ok(Elimination { pivot_columns, pivot, .. }) = eliminate(&mut rows, self.cols(), &Unwatched) else {
            return Vec::new();
        };
        let vector = |free: usize| {
            let mut x = vec![Rational::zero(); self.cols()];
            x[free] = Rational::one();
            for (row, &column) in rows.iter().zip(&pivot_columns) {
                x[column] = Rational::new(-&row[free], pivot.clone());
            }
            x
        };
        (0..self.cols()).filter(|j| !pivot_columns.contains(j)).map(vector).collect()
    }

    /// The number of rows, where there are as many columns.
    pub(super) fn square_order(&self) -> Result<usize, MatrixError> {
        match (self.rows(), self.cols()) {
            (rows, cols) if rows == cols => Ok(rows),
            (rows, cols) => Err(MatrixError::NotSquare { rows, cols }),
        }
    }
}

/// What an elimination found.
struct Elimination {
    /// The pivot column of each of the first rows.
    pivot_columns: Vec<usize>,
    /// The common pivot: the determinant of the pivot columns in the pivot rows, up to sign.
    pivot: BigInt,
    /// Whether the rows were permuted oddly.
    odd: bool,
}

/// Gauss-Jordan elimination without fractions in the first `columns` columns. Afterwards the pivot column of each of the
/// first rows holds `pivot` in that row and 0 elsewhere, and the other rows are 0 in all these columns.
///
/// Every division is exact, because after `k` pivots each entry is a minor of order `k` or `k + 1` (Bareiss 1968).
fn eliminate(rows: &mut [Vec<BigInt>], columns: usize, progress: &dyn Progress) -> Result<Elimination, Cancelled> {
    let mut found = Elimination { pivot_columns: Vec::new(), pivot: BigInt::one(), odd: false };
    for column in 0..columns {
        let k = found.pivot_columns.len();
        let Some(with_pivot) = (k..rows.len()).find(|&i| !rows[i][column].is_zero()) else { continue };
        rows.swap(k, with_pivot);
        found.odd ^= k != with_pivot;
        let pivot_row = rows[k].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            progress.checkpoint()?;
            let factor = row[column].clone();
            for (x, y) in row.iter_mut().zip(&pivot_row) {
                *x = (&pivot_row[column] * &*x - &factor * y) / &found.pivot;
            }
        }
        found.pivot = pivot_row[column].clone();
        found.pivot_columns.push(column);
    }
    Ok(found)
}

/// The determinant over any ordered field; 1 for no rows.
///
/// # Errors
/// [`ArithmeticError`] where a pivot cannot be inverted (an interval around zero), or where there are not as many columns as rows.
pub fn determinant_over_field<T: Field + Signed>(mut rows: Vec<Vec<T>>, one: T) -> Result<T, ArithmeticError> {
    if rows.iter().any(|row| row.len() != rows.len()) {
        return Err(ArithmeticError::Domain("as many columns as rows"));
    }
    let mut product = one;
    for column in 0..rows.len() {
        let found = (column..rows.len()).find(|&i| rows[i][column].sign() != Some(Sign::Zero));
        let Some(pivot) = found else { return Ok(product.zero()) };
        if pivot != column {
            rows.swap(pivot, column);
            product = -product;
        }
        let inverse = rows[column][column].recip()?;
        product = product * &rows[column][column];
        let (upper, lower) = rows.split_at_mut(column + 1);
        for row in lower {
            let factor = row[column].clone() * &inverse;
            for (x, y) in row.iter_mut().zip(&upper[column]).skip(column) {
                *x = x.clone() - factor.clone() * y;
            }
        }
    }
    Ok(product)
}

/// Solves `A x = b` over any scalars, given as rows `(A | b)`, taking as pivot the first entry that can be inverted.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where no pivot can be inverted; [`ArithmeticError::Domain`] where `A` is not square or `b` is not
/// one column.
pub fn solve_over_field<T: Field>(mut rows: Vec<Vec<T>>) -> Result<Vec<T>, ArithmeticError> {
    let order = rows.len();
    if rows.iter().any(|row| row.len() != order + 1) {
        return Err(ArithmeticError::Domain("one column more than rows"));
    }
    for column in 0..order {
        let pivot = (column..order).find_map(|i| rows[i][column].recip().ok().map(|inverse| (i, inverse)));
        let (i, inverse) = pivot.ok_or(ArithmeticError::DivisionByZero)?;
        rows.swap(column, i);
        let pivot_row: Vec<T> = rows[column].iter().map(|x| x.clone() * &inverse).collect();
        for (_, row) in rows.iter_mut().enumerate().filter(|(k, _)| *k != column) {
            let factor = row[column].clone();
            for (x, y) in row.iter_mut().zip(&pivot_row).skip(column) {
                *x = x.clone() - factor.clone() * y;
            }
        }
        rows[column] = pivot_row;
    }
    Ok(rows.into_iter().filter_map(|mut row| row.pop()).collect())
}
