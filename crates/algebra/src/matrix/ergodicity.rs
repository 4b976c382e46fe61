//! The diameters tau_p of the rows of a matrix (Chazelle, section 2, Ergodicity).
//!
//! These are the definitions, for any rational matrix. [`StochasticMatrix::tau_1`](super::StochasticMatrix::tau_1) is
//! the fast kernel for stochastic ones.

use super::RationalMatrix;
use arithmetic::{Cancelled, Progress, Rational, Ring, Unwatched};
use num_bigint::BigInt;
use num_traits::Signed;

/// The norms in which diameters are computed exactly.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Norm {
    /// Sum of absolute values.
    One,
    /// Square root of the sum of squares; its square is what is computed.
    TwoSquared,
    /// Largest absolute value.
    Infinity,
}

/// `max_{i,j} |a_i* - a_j*|` over the rows in the given norm (for [`Norm::TwoSquared`] the square of the distance).
/// It is the diameter of the convex hull of the rows, because a convex function is largest at corners.
pub fn diameter(matrix: &RationalMatrix, norm: Norm) -> Rational {
    // Nobody stops it.
    diameter_watched(matrix, norm, &Unwatched).unwrap_or_else(|Cancelled| Rational::from_integer(BigInt::ZERO))
}

fn diameter_watched(matrix: &RationalMatrix, norm: Norm, progress: &dyn Progress) -> Result<Rational, Cancelled> {
    let mut best = BigInt::default();
    for i in 0..matrix.rows() {
        progress.checkpoint()?;
        for j in 0..i {
            let differences = matrix.row(i).iter().zip(matrix.row(j)).map(|(a, b)| a - b);
            let distance = match norm {
                Norm::One => differences.map(|x| x.abs()).sum(),
                Norm::TwoSquared => differences.map(|x| &x * &x).sum(),
                Norm::Infinity => differences.map(|x| x.abs()).max().unwrap_or_default(),
            };
            best = best.max(distance);
        }
    }
    let scale = match norm {
        Norm::TwoSquared => matrix.denominator() * matrix.denominator(),
        Norm::One | Norm::Infinity => matrix.denominator().clone(),
    };
    Ok(Rational::new(best, scale))
}

/// The ergodicity coefficient tau_1: half the l1-diameter of the rows.
pub fn tau_1(matrix: &RationalMatrix) -> Rational {
    let diameter = diameter(matrix, Norm::One);
    let two = diameter.integer(2);
    diameter / two
}

/// tau_2 squared: the squared Euclidean diameter of the rows, exact.
pub fn tau_2_squared(matrix: &RationalMatrix) -> Rational {
    diameter(matrix, Norm::TwoSquared)
}

/// As [`tau_2_squared`], until `progress` stops it.
///
/// # Errors
/// [`Cancelled`].
pub fn tau_2_squared_watched(matrix: &RationalMatrix, progress: &dyn Progress) -> Result<Rational, Cancelled> {
    diameter_watched(matrix, Norm::TwoSquared, progress)
}

/// tau_infinity: the diameter of the rows in the maximum norm.
pub fn tau_infinity(matrix: &RationalMatrix) -> Rational {
    diameter(matrix, Norm::Infinity)
}
