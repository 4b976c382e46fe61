//! Why there is no spectrum, and the sizes up to which there is one.

use crate::graph::{LaplacianError, NameError};
use crate::matrix::MatrixError;

/// Most significant digits.
pub const LARGEST_DIGITS: u32 = 10_000;

/// Order of the irreducible blocks up to which characteristic polynomials are used at all.
pub const LARGEST_EXACT_ORDER: usize = 40;

/// Order of the irreducible blocks up to which tridiagonal ones are solved in floating point.
pub const LARGEST_TRIDIAGONAL_ORDER: usize = 20_000;

/// Order of the irreducible blocks up to which non-symmetric ones are solved in floating point.
pub const LARGEST_GENERAL_ORDER: usize = 1000;

/// Order of the irreducible blocks up to which dense floating-point methods are used.
pub const LARGEST_DENSE_ORDER: usize = 3000;

/// Why there is no spectrum.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SpectrumError {
    /// No digits, or too many.
    #[error("the number of digits must lie between 1 and {LARGEST_DIGITS}, but it is {0}")]
    Digits(u32),
    /// The graph is too large to store.
    #[error(transparent)]
    Name(#[from] NameError),
    /// The graph has no such matrix.
    #[error(transparent)]
    Kind(#[from] LaplacianError),
    /// An empty matrix.
    #[error(transparent)]
    Matrix(#[from] MatrixError),
    /// An irreducible block too large for any method.
    #[error(
        "the matrix has an irreducible block of order {order}, and without a closed form blocks of order up to {most} are solved"
    )]
    TooLarge {
        /// Its order.
        order: usize,
        /// The largest order.
        most: usize,
    },
    /// Floating point does not reach the digits.
    #[error(
        "{asked} digits need the exact characteristic polynomial, which is for irreducible blocks of order up to \
         {LARGEST_EXACT_ORDER}; this one has order {order}, for which {possible} digits are possible"
    )]
    TooManyDigits {
        /// Digits asked for.
        asked: u32,
        /// Order of the block.
        order: usize,
        /// What the certified enclosures give.
        possible: u32,
    },
    /// The exact characteristic polynomials do not help.
    #[error(
        "{asked} digits need the roots of the exact characteristic polynomial apart from one another, and they were not isolated; \
         {possible} digits are possible"
    )]
    NotIsolated {
        /// Digits asked for.
        asked: u32,
        /// What the certified enclosures give.
        possible: u32,
    },
    /// No bounds could be proved.
    #[error("no enclosure of the eigenvalues could be proved: {0}")]
    Unproved(&'static str),
}

/// An entry that floats are not used for.
pub(super) const OUT_OF_RANGE: SpectrumError = SpectrumError::Unproved("an entry lies outside 1e-100 to 1e100");
