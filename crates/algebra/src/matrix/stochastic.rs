//! Row-stochastic matrices: non-negative integers over one common denominator, every row summing to it.

use super::digits::DigitMatrix;
use super::{Footprint, MatrixError, RationalMatrix};
use arithmetic::{Cancelled, Progress, Rational, Unwatched};
use num_bigint::{BigInt, BigUint};
use num_traits::Signed;

/// A row-stochastic matrix. Being stochastic is checked once, when it is made; products keep it.
#[derive(Debug, Clone)]
pub struct StochasticMatrix {
    numerators: DigitMatrix,
    denominator: BigUint,
}

impl StochasticMatrix {
    /// From rows of rationals.
    ///
    /// # Errors
    /// [`MatrixError`] where the rows are empty, ragged, negative somewhere or do not sum to one.
    pub fn from_rows(rows: &[Vec<Rational>]) -> Result<Self, MatrixError> {
        StochasticMatrix::try_from(&RationalMatrix::from_rows(rows)?)
    }

    /// From rows of small integers over a small denominator.
    ///
    /// # Errors
    /// As [`StochasticMatrix::from_rows`].
    pub fn from_integers<R: AsRef<[i64]>>(rows: &[R], denominator: i64) -> Result<Self, MatrixError> {
        StochasticMatrix::try_from(&RationalMatrix::from_integers(rows, denominator)?)
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.numerators.rows
    }

    /// Number of columns.
    pub fn cols(&self) -> usize {
        self.numerators.cols
    }

    /// The common denominator (of a product: the product of the denominators, not reduced).
    pub fn denominator(&self) -> &BigUint {
        &self.denominator
    }

    /// The numerators row by row.
    pub fn numerators(&self) -> impl Iterator<Item = BigUint> + '_ {
        self.numerators.entries()
    }

    /// The product `self * right`. Cost: rows x cols x inner products of entries, accumulated without allocation.
    ///
    /// # Errors
    /// [`MatrixError::Shapes`].
    pub fn times(&self, right: &Self) -> Result<Self, MatrixError> {
        self.times_watched(right, &Unwatched)
    }

    /// As [`StochasticMatrix::times`], until `progress` stops it.
    ///
    /// # Errors
    /// As there, and [`MatrixError::Cancelled`].
    pub fn times_watched(&self, right: &Self, progress: &dyn Progress) -> Result<Self, MatrixError> {
        if self.cols() != right.rows() {
            return Err(MatrixError::Shapes { left_cols: self.cols(), right_rows: right.rows() });
        }
        let denominator = &self.denominator * &right.denominator;
        let numerators = self.numerators.times(&right.numerators, progress)?;
        Ok(StochasticMatrix { numerators, denominator })
    }

    /// The footprint: ones where the entries are not zero.
    pub fn footprint(&self) -> Footprint {
        Footprint::from_fn(self.rows(), self.cols(), |i, j| !self.numerators.is_zero(i, j))
    }

    /// The ergodicity coefficient `tau_1 = 1 - min_{i,j} sum_k min(a_ik, a_jk)` (Chazelle, section 2, Ergodicity), as
    /// `max_{i,j} sum_k max(a_ik - a_jk, 0)`, which is the same for equal row sums.
    pub fn tau_1(&self) -> Rational {
        Rational::new(BigInt::from(self.tau_1_numerator()), BigInt::from(self.denominator.clone()))
    }

    /// The numerator of [`StochasticMatrix::tau_1`] over [`StochasticMatrix::denominator`], not reduced.
    pub fn tau_1_numerator(&self) -> BigUint {
        // Nobody stops it.
        self.numerators.largest_excess(&Unwatched).unwrap_or_default()
    }

    /// As [`StochasticMatrix::tau_1`], until `progress` stops it.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn tau_1_watched(&self, progress: &dyn Progress) -> Result<Rational, Cancelled> {
        let numerator = self.numerators.largest_excess(progress)?;
        Ok(Rational::new(BigInt::from(numerator), BigInt::from(self.denominator.clone())))
    }

    /// The same matrix as a plain rational one.
    pub fn to_rational_matrix(&self) -> RationalMatrix {
        let numerators = self.numerators().map(BigInt::from).collect();
        RationalMatrix::of_known_shape(self.rows(), self.cols(), numerators, BigInt::from(self.denominator.clone()))
    }
}

impl TryFrom<&RationalMatrix> for StochasticMatrix {
    type Error = MatrixError;

    fn try_from(matrix: &RationalMatrix) -> Result<Self, MatrixError> {
        let mut entries = Vec::new();
        for i in 0..matrix.rows() {
            let row = matrix.row(i);
            if let Some(col) = row.iter().position(Signed::is_negative) {
                return Err(MatrixError::Negative { row: i + 1, col: col + 1 });
            }
            let sum: BigInt = row.iter().sum();
            if sum != *matrix.denominator() {
                let sum = Rational::new(sum, matrix.denominator().clone()).to_string();
                return Err(MatrixError::RowSum { row: i + 1, sum });
            }
            entries.extend(row.iter().map(|x| x.magnitude().clone()));
        }
        Ok(StochasticMatrix {
            numerators: DigitMatrix::from_entries(matrix.rows(), matrix.cols(), &entries),
            denominator: matrix.denominator().magnitude().clone(),
        })
    }
}

impl PartialEq for StochasticMatrix {
    /// Equality of the matrices, whatever their denominators.
    fn eq(&self, other: &Self) -> bool {
        self.to_rational_matrix() == other.to_rational_matrix()
    }
}
