//! Rational matrices with one common denominator.

use super::MatrixError;
use arithmetic::{Progress, Rational, Unwatched, common_denominator, content, lcm};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

/// A matrix of integers over one positive common denominator. Not reduced: call [`RationalMatrix::reduced`] once at the
/// end of a computation, not inside it.
#[derive(Debug, Clone)]
pub struct RationalMatrix {
    rows: usize,
    cols: usize,
    numerators: Vec<BigInt>,
    denominator: BigInt,
}

impl RationalMatrix {
    /// From numerators row by row over a denominator.
    ///
    /// # Errors
    /// [`MatrixError`] where the shape is empty or not filled, or the denominator is zero.
    pub fn new(
        rows: usize,
        cols: usize,
        mut numerators: Vec<BigInt>,
        mut denominator: BigInt,
    ) -> Result<Self, MatrixError> {
        if rows == 0 || cols == 0 {
            return Err(MatrixError::Empty);
        }
        if rows.checked_mul(cols) != Some(numerators.len()) {
            return Err(MatrixError::EntryCount { rows, cols, found: numerators.len() });
        }
        if denominator.is_zero() {
            return Err(MatrixError::ZeroDenominator);
        }
        if denominator.is_negative() {
            denominator = -denominator;
            numerators.iter_mut().for_each(|x| *x = -std::mem::take(x));
        }
        Ok(RationalMatrix { rows, cols, numerators, denominator })
    }

    /// As [`RationalMatrix::new`] where the shape is known to be filled and the denominator to be positive.
    pub(super) fn of_known_shape(rows: usize, cols: usize, numerators: Vec<BigInt>, denominator: BigInt) -> Self {
        RationalMatrix { rows, cols, numerators, denominator }
    }

    /// From rows of small integers over a small denominator.
    ///
    /// # Errors
    /// As [`RationalMatrix::from_rows`], and where the denominator is zero.
    pub fn from_integers<R: AsRef<[i64]>>(rows: &[R], denominator: i64) -> Result<Self, MatrixError> {
        let widths: Vec<usize> = rows.iter().map(|row| row.as_ref().len()).collect();
        let cols = common_width(&widths)?;
        let numerators = rows.iter().flat_map(|row| row.as_ref()).map(|&x| BigInt::from(x)).collect();
        RationalMatrix::new(rows.len(), cols, numerators, BigInt::from(denominator))
    }

    /// From rows of rationals; the common denominator is the least one.
    ///
    /// # Errors
    /// [`MatrixError::Empty`] or [`MatrixError::Ragged`].
    pub fn from_rows(rows: &[Vec<Rational>]) -> Result<Self, MatrixError> {
        RationalMatrix::from_rows_watched(rows, &Unwatched)
    }

    /// As [`RationalMatrix::from_rows`], until `progress` stops it.
    ///
    /// # Errors
    /// As there, and [`MatrixError::Cancelled`].
    pub fn from_rows_watched(rows: &[Vec<Rational>], progress: &dyn Progress) -> Result<Self, MatrixError> {
        let widths: Vec<usize> = rows.iter().map(Vec::len).collect();
        let cols = common_width(&widths)?;
        let mut denominator = BigInt::one();
        for x in rows.iter().flatten() {
            progress.checkpoint()?;
            denominator = lcm(&denominator, &x.denom());
        }
        let numerators = rows.iter().flatten().map(|x| x.numer() * (&denominator / x.denom())).collect();
        RationalMatrix::new(rows.len(), cols, numerators, denominator)
    }

    /// The identity of the given order.
    ///
    /// # Errors
    /// [`MatrixError::Empty`] for order 0.
    pub fn identity(order: usize) -> Result<Self, MatrixError> {
        let entry = |k: usize| BigInt::from(u8::from(k / order == k % order));
        RationalMatrix::new(order, order, (0..order * order).map(entry).collect(), BigInt::one())
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn cols(&self) -> usize {
        self.cols
    }

    /// The common denominator, positive.
    pub fn denominator(&self) -> &BigInt {
        &self.denominator
    }

    /// The numerators of one row, counted from 0; none outside the matrix.
    pub fn row(&self, i: usize) -> &[BigInt] {
        if i < self.rows { &self.numerators[i * self.cols..(i + 1) * self.cols] } else { &[] }
    }

    /// The entry in row `i` and column `j`, counted from 0, in lowest terms; zero outside the matrix.
    pub fn entry(&self, i: usize, j: usize) -> Rational {
        self.row(i).get(j).map_or_else(Rational::zero, |x| Rational::new(x.clone(), self.denominator.clone()))
    }

    /// All entries in lowest terms, row by row.
    pub fn to_rows(&self) -> Vec<Vec<Rational>> {
        (0..self.rows).map(|i| (0..self.cols).map(|j| self.entry(i, j)).collect()).collect()
    }

    /// The smallest entry that is positive; `None` where none is.
    pub fn least_positive(&self) -> Option<Rational> {
        let least = self.numerators.iter().filter(|x| x.is_positive()).min()?;
        Some(Rational::new(least.clone(), self.denominator.clone()))
    }

    /// The matrix of these rows and columns in the order given, counted from 0; entries outside the matrix are zero.
    ///
    /// # Errors
    /// [`MatrixError::Empty`] for no rows or no columns.
    pub fn block(&self, rows: &[usize], cols: &[usize]) -> Result<Self, MatrixError> {
        let entry = |i: usize, j: usize| self.row(i).get(j).cloned().unwrap_or_default();
        let numerators = rows.iter().flat_map(|&i| cols.iter().map(move |&j| entry(i, j))).collect();
        RationalMatrix::new(rows.len(), cols.len(), numerators, self.denominator.clone())
    }

    /// The matrix with `self` and `other` as blocks on the diagonal and zeros beside them.
    ///
    /// # Errors
    /// None of matrices that there are.
    pub fn direct_sum(&self, other: &Self) -> Result<Self, MatrixError> {
        let zeros = |count: usize| vec![Rational::zero(); count];
        let upper = self.to_rows().into_iter().map(|row| [row, zeros(other.cols)].concat());
        let lower = other.to_rows().into_iter().map(|row| [zeros(self.cols), row].concat());
        RationalMatrix::from_rows(&upper.chain(lower).collect::<Vec<_>>())
    }

    /// The product `self * right`.
    ///
    /// # Errors
    /// [`MatrixError::Shapes`].
    pub fn times(&self, right: &Self) -> Result<Self, MatrixError> {
        self.times_watched(right, &Unwatched)
    }

    /// As [`RationalMatrix::times`], until `progress` stops it.
    ///
    /// # Errors
    /// As there, and [`MatrixError::Cancelled`].
    pub fn times_watched(&self, right: &Self, progress: &dyn Progress) -> Result<Self, MatrixError> {
        if self.cols != right.rows {
            return Err(MatrixError::Shapes { left_cols: self.cols, right_rows: right.rows });
        }
        let mut numerators = Vec::with_capacity(self.rows * right.cols);
        for i in 0..self.rows {
            progress.checkpoint()?;
            for j in 0..right.cols {
                let terms = self.row(i).iter().enumerate().map(|(k, x)| x * &right.numerators[k * right.cols + j]);
                numerators.push(terms.sum());
            }
        }
        RationalMatrix::new(self.rows, right.cols, numerators, &self.denominator * &right.denominator)
    }

    /// The matrix times a column vector.
    ///
    /// # Errors
    /// [`MatrixError::Shapes`].
    pub fn apply(&self, vector: &[Rational]) -> Result<Vec<Rational>, MatrixError> {
        if self.cols != vector.len() {
            return Err(MatrixError::Shapes { left_cols: self.cols, right_rows: vector.len() });
        }
        // Over one denominator, so that only the results are reduced.
        let common = common_denominator(vector);
        let numerators: Vec<BigInt> = vector.iter().map(|x| x.numer() * (&common / x.denom())).collect();
        let below = common * &self.denominator;
        let sum = |i: usize| -> BigInt { self.row(i).iter().zip(&numerators).map(|(a, x)| a * x).sum() };
        Ok((0..self.rows).map(|i| Rational::new(sum(i), below.clone())).collect())
    }

    /// The sum `self + other`.
    ///
    /// # Errors
    /// [`MatrixError::DifferentShapes`].
    pub fn plus(&self, other: &Self) -> Result<Self, MatrixError> {
        self.combine(other, |a, b| a + b)
    }

    /// The difference `self - other`.
    ///
    /// # Errors
    /// [`MatrixError::DifferentShapes`].
    pub fn minus(&self, other: &Self) -> Result<Self, MatrixError> {
        self.combine(other, |a, b| a - b)
    }

    /// Entry by entry over the least common denominator; `sum` must be homogeneous of degree one.
    fn combine(&self, other: &Self, sum: impl Fn(BigInt, BigInt) -> BigInt) -> Result<Self, MatrixError> {
        if (self.rows, self.cols) != (other.rows, other.cols) {
            let (left, right) = ((self.rows, self.cols), (other.rows, other.cols));
            return Err(MatrixError::DifferentShapes { left, right });
        }
        let denominator = lcm(&self.denominator, &other.denominator);
        let (left, right) = (&denominator / &self.denominator, &denominator / &other.denominator);
        let entries = self.numerators.iter().zip(&other.numerators);
        let numerators = entries.map(|(a, b)| sum(a * &left, b * &right)).collect();
        RationalMatrix::new(self.rows, self.cols, numerators, denominator)
    }

    /// The matrix times a number.
    pub fn scaled(&self, factor: &Rational) -> Self {
        RationalMatrix {
            rows: self.rows,
            cols: self.cols,
            numerators: self.numerators.iter().map(|x| x * factor.numer()).collect(),
            denominator: &self.denominator * factor.denom(),
        }
    }

    /// The transpose.
    pub fn transpose(&self) -> Self {
        let entry = |k: usize| self.numerators[k % self.rows * self.cols + k / self.rows].clone();
        RationalMatrix {
            rows: self.cols,
            cols: self.rows,
            numerators: (0..self.numerators.len()).map(entry).collect(),
            denominator: self.denominator.clone(),
        }
    }

    /// The same matrix with the least denominator.
    pub fn reduced(&self) -> Self {
        // Nobody stops it.
        self.reduced_watched(&Unwatched).unwrap_or_else(|_| self.clone())
    }

    /// As [`RationalMatrix::reduced`], until `progress` stops it.
    ///
    /// # Errors
    /// [`MatrixError::Cancelled`].
    pub fn reduced_watched(&self, progress: &dyn Progress) -> Result<Self, MatrixError> {
        let mut divisor = self.denominator.clone();
        for x in &self.numerators {
            progress.checkpoint()?;
            divisor = content([&divisor, x]);
        }
        Ok(RationalMatrix {
            rows: self.rows,
            cols: self.cols,
            numerators: self.numerators.iter().map(|x| x / &divisor).collect(),
            denominator: &self.denominator / &divisor,
        })
    }
}

impl PartialEq for RationalMatrix {
    /// Equality of the matrices, whatever their denominators.
    fn eq(&self, other: &Self) -> bool {
        (self.rows, self.cols) == (other.rows, other.cols)
            && self
                .numerators
                .iter()
                .zip(&other.numerators)
                .all(|(a, b)| a * &other.denominator == b * &self.denominator)
    }
}

impl Eq for RationalMatrix {}

/// The common length of the rows.
pub(super) fn common_width(widths: &[usize]) -> Result<usize, MatrixError> {
    match widths.first() {
        None | Some(0) => Err(MatrixError::Empty),
        Some(&expected) => match widths.iter().position(|&w| w != expected) {
            Some(row) => Err(MatrixError::Ragged { row: row + 1, expected, found: widths[row] }),
            None => Ok(expected),
        },
    }
}
