//! The floating side: nearest `f64` matrices, their diameters, and eigenvalues with residual bounds.
//!
//! Nothing here can support an exact claim; it is for looking, plotting and comparing.

use super::RationalMatrix;
pub use dense::SymmetricEigen;
use dense::{Mat, c64};
use num_traits::ToPrimitive;

/// The matrix with each entry rounded to the nearest float.
pub fn to_floats(matrix: &RationalMatrix) -> Mat<f64> {
    Mat::from_fn(matrix.rows(), matrix.cols(), |i, j| matrix.entry(i, j).to_f64().unwrap_or(f64::NAN))
}

/// An eigenvalue with the residual of its eigenvector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloatEigenvalue {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
    /// `|A u - lambda u| / |u|` in the Euclidean norm, rounded: some matrix within that distance of `A` has exactly
    /// this eigenvalue.
    pub residual: f64,
}

/// Why there are no eigenvalues.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum EigenError {
    /// Rows and columns differ.
    #[error("a matrix of {rows} x {cols} has no eigenvalues")]
    NotSquare {
        /// Rows.
        rows: usize,
        /// Columns.
        cols: usize,
    },
    /// The iteration did not converge.
    #[error("the eigenvalue iteration did not converge")]
    NoConvergence,
}

/// The eigenvalues by decreasing modulus, each with its residual.
///
/// # Errors
/// [`EigenError`].
pub fn eigenvalues(matrix: &Mat<f64>) -> Result<Vec<FloatEigenvalue>, EigenError> {
    let rows = square(matrix)?;
    let dense::Eigen { values, vectors } = dense::eigen(matrix.as_ref()).ok_or(EigenError::NoConvergence)?;
    let mut found: Vec<FloatEigenvalue> = (0..rows)
        .map(|k| {
            let value = values[k];
            let (mut error, mut size) = (0.0, 0.0);
            for i in 0..rows {
                let image: c64 = (0..rows).fold(c64::new(0.0, 0.0), |sum, j| sum + vectors[(j, k)] * matrix[(i, j)]);
                error += (image - value * vectors[(i, k)]).norm_sqr();
                size += vectors[(i, k)].norm_sqr();
            }
            FloatEigenvalue { re: value.re, im: value.im, residual: (error / size).sqrt() }
        })
        .collect();
    found.sort_by(|a, b| b.re.hypot(b.im).total_cmp(&a.re.hypot(a.im)));
    Ok(found)
}

fn square(matrix: &Mat<f64>) -> Result<usize, EigenError> {
    let (rows, cols) = (matrix.nrows(), matrix.ncols());
    if rows == cols { Ok(rows) } else { Err(EigenError::NotSquare { rows, cols }) }
}

/// Eigenvalues and eigenvectors of a symmetric matrix, of which the lower half is read.
///
/// # Errors
/// [`EigenError`].
pub fn symmetric_eigen(matrix: &Mat<f64>) -> Result<SymmetricEigen, EigenError> {
    square(matrix)?;
    dense::symmetric_eigen(matrix.as_ref()).ok_or(EigenError::NoConvergence)
}

/// The product, `NaN` in each entry where the shapes do not fit.
pub fn product(left: &Mat<f64>, right: &Mat<f64>) -> Mat<f64> {
    dense::product(left.as_ref(), right.as_ref())
}

/// The least singular value.
///
/// # Errors
/// [`EigenError::NoConvergence`].
pub fn least_singular_value(matrix: &Mat<f64>) -> Result<f64, EigenError> {
    let values = dense::singular_values(matrix.as_ref()).ok_or(EigenError::NoConvergence)?;
    Ok(values.into_iter().fold(f64::INFINITY, f64::min))
}
