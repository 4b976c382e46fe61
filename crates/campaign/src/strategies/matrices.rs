//! Matrices.

use super::list;
use super::numbers::fraction;
use crate::draws::Draws;
use algebra::matrix::{MatrixError, RationalMatrix, StochasticMatrix};

/// A row-stochastic matrix whose entries have a common denominator of at most `most`; zeros are frequent.
///
/// # Errors
/// Does not fail for at least one row and column.
pub fn stochastic(draws: &mut Draws, rows: usize, cols: usize, most: u64) -> Result<StochasticMatrix, MatrixError> {
    let denominator = 1 + draws.below(most) as i64;
    let mut entries = vec![vec![0; cols]; rows];
    for row in &mut entries {
        let (start, mut left) = (draws.below(cols as u64) as usize, denominator);
        for k in 1..cols {
            let part = draws.below(left as u64 + 1) as i64;
            row[(start + k) % cols] = part;
            left -= part;
        }
        if let Some(first) = row.get_mut(start) {
            *first = left;
        }
    }
    StochasticMatrix::from_integers(&entries, denominator)
}

/// Square stochastic matrices of one order.
///
/// # Errors
/// Does not fail for at least one row.
pub fn stochastic_sequence(
    draws: &mut Draws,
    order: usize,
    length: usize,
    most: u64,
) -> Result<Vec<StochasticMatrix>, MatrixError> {
    (0..length).map(|_| stochastic(draws, order, order, most)).collect()
}

/// A matrix of small fractions.
///
/// # Errors
/// Does not fail for at least one row and column.
pub fn rational_matrix(draws: &mut Draws, rows: usize, cols: usize) -> Result<RationalMatrix, MatrixError> {
    let rows = list(draws, rows, |draws| list(draws, cols, |draws| fraction(draws, 5, 3)));
    RationalMatrix::from_rows(&rows)
}

/// A symmetric matrix of small fractions; zeros on the diagonal are frequent.
///
/// # Errors
/// Does not fail for at least one row.
pub fn symmetric(draws: &mut Draws, order: usize) -> Result<RationalMatrix, MatrixError> {
    let mut rows = vec![vec![arithmetic::rational(0, 1); order]; order];
    for i in 0..order {
        for j in 0..=i {
            if !draws.once_in(3) {
                let entry = fraction(draws, 4, 2);
                rows[i][j] = entry.clone();
                rows[j][i] = entry;
            }
        }
    }
    RationalMatrix::from_rows(&rows)
}
