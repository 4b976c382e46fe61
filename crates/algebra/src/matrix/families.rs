//! Families of row-stochastic matrices that need not be square: all over one denominator, and random ones.

use super::{MatrixError, RationalMatrix};
use arithmetic::{Rational, rational, words};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// All rows of so many integers that are not negative and have this sum.
fn compositions(total: i64, cols: usize) -> Vec<Vec<i64>> {
    match cols {
        0 => Vec::new(),
        1 => vec![vec![total]],
        _ => {
            let extend = |first: i64| {
                compositions(total - first, cols - 1).into_iter().map(move |rest| [vec![first], rest].concat())
            };
            (0..=total).flat_map(extend).collect()
        }
    }
}

impl RationalMatrix {
    /// All row-stochastic matrices of this shape whose entries have this common denominator.
    ///
    /// # Errors
    /// [`MatrixError`] for a shape without rows or columns, a denominator of zero, or more matrices than can be counted.
    pub fn all_stochastic(rows: usize, cols: usize, denominator: u32) -> Result<Vec<Self>, MatrixError> {
        if rows == 0 || cols == 0 {
            return Err(MatrixError::Empty);
        }
        let choices = compositions(denominator.into(), cols);
        u32::try_from(rows).ok().and_then(|rows| choices.len().checked_pow(rows)).ok_or(MatrixError::TooLong)?;
        let matrix = |word: Vec<usize>| {
            let picked: Vec<&Vec<i64>> = word.into_iter().map(|letter| &choices[letter]).collect();
            RationalMatrix::from_integers(&picked, denominator.into())
        };
        words(choices.len(), rows).map(matrix).collect()
    }

    /// A random row-stochastic matrix: weights below 1000, about half of them zero.
    ///
    /// # Errors
    /// [`MatrixError::Empty`] for a shape without rows or columns.
    pub fn random_stochastic(rows: usize, cols: usize, random: &mut ChaCha8Rng) -> Result<Self, MatrixError> {
        if cols == 0 {
            return Err(MatrixError::Empty);
        }
        let mut row = || {
            let mut weights: Vec<i64> = (0..cols)
                .map(|_| if random.next_u32().is_multiple_of(2) { i64::from(random.next_u32() % 1000) } else { 0 })
                .collect();
            weights[random.next_u32() as usize % cols] += 1;
            let sum: i64 = weights.iter().sum();
            weights.into_iter().map(|weight| rational(weight, sum)).collect::<Vec<Rational>>()
        };
        let rows: Vec<Vec<Rational>> = (0..rows).map(|_| row()).collect();
        RationalMatrix::from_rows(&rows)
    }
}
