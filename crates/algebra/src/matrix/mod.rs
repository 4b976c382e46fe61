//! Exact matrices as integers over one common denominator: stochastic products, footprints, ergodicity coefficients.

mod characteristic;
mod digit_product;
mod digits;
mod elimination;
mod ergodicity;
mod families;
pub mod floating;
mod footprint;
mod inertia;
mod integer_rows;
mod kronecker;

mod product;
mod rational_matrix;
pub mod read;
mod smallest_entries;
mod solve;
mod sparse;
mod stabiliser;
mod stochastic;
mod transfer;

pub use characteristic::{CharacteristicPolynomial, characteristic_coefficients};
pub use elimination::SparseLdl;
pub use ergodicity::{Norm, diameter, tau_1, tau_2_squared, tau_2_squared_watched, tau_infinity};
pub use footprint::Footprint;
pub use inertia::{Inertia, inertia};
pub use integer_rows::{AverageRow, IntegerRows};
pub use kronecker::kronecker_of_rows;
pub use product::{prefix_products, product_of_rows, product_sequential, product_tree};
pub use rational_matrix::RationalMatrix;
pub use smallest_entries::{SmallestEntry, smallest_entries};
pub use solve::{determinant_over_field, solve_over_field};
pub use sparse::SparseMatrix;
pub use stabiliser::{Stabiliser, StabiliserStream, stabilisers};
pub use stochastic::StochasticMatrix;
pub use transfer::{Transfer, transfer_function, transfer_function_watched};

/// Why a matrix or a product of matrices is refused. Rows and columns are counted from 1.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum MatrixError {
    /// No rows or no columns.
    #[error("the matrix is empty")]
    Empty,
    /// Rows of different lengths.
    #[error("row {row} has {found} entries where row 1 has {expected}")]
    Ragged {
        /// The row at fault.
        row: usize,
        /// Entries of the first row.
        expected: usize,
        /// Entries of this row.
        found: usize,
    },
    /// The number of entries is not rows times columns.
    #[error("{found} entries do not fill a matrix of {rows} x {cols}")]
    EntryCount {
        /// Rows asked for.
        rows: usize,
        /// Columns asked for.
        cols: usize,
        /// Entries given.
        found: usize,
    },
    /// A denominator that is zero.
    #[error("the common denominator is zero")]
    ZeroDenominator,
    /// A negative entry in a stochastic matrix.
    #[error("the entry in row {row}, column {col} is negative")]
    Negative {
        /// Row of the entry.
        row: usize,
        /// Column of the entry.
        col: usize,
    },
    /// A row that does not sum to one.
    #[error("row {row} sums to {sum}, not to 1")]
    RowSum {
        /// The row at fault.
        row: usize,
        /// Its sum.
        sum: String,
    },
    /// Two matrices that cannot be multiplied.
    #[error("a matrix of {left_cols} columns cannot multiply one of {right_rows} rows")]
    Shapes {
        /// Columns of the left factor.
        left_cols: usize,
        /// Rows of the right factor.
        right_rows: usize,
    },
    /// Two matrices that cannot be added.
    #[error("a matrix of {} x {} and one of {} x {} have no sum", left.0, left.1, right.0, right.1)]
    DifferentShapes {
        /// Rows and columns of the left matrix.
        left: (usize, usize),
        /// Rows and columns of the right matrix.
        right: (usize, usize),
    },
    /// A matrix that must be square and is not.
    #[error("a matrix of {rows} x {cols} is not square")]
    NotSquare {
        /// Its rows.
        rows: usize,
        /// Its columns.
        cols: usize,
    },
    /// A matrix without inverse.
    #[error("the matrix is singular")]
    Singular,
    /// A stochastic matrix whose powers do not forget where they started.
    #[error("the powers of the matrix do not converge to a matrix of equal rows")]
    NotErgodic,
    /// A product whose entries do not fit the integers that it is made in, or an entry that is negative there.
    #[error("entries of such long products, or negative ones, do not fit 128 bits")]
    TooLong,
    /// A product of no matrices.
    #[error("there is no matrix to multiply")]
    NoFactors,
    /// Stopped by the caller.
    #[error(transparent)]
    Cancelled(#[from] arithmetic::Cancelled),
}
