//! The floating side: nearest `f64` matrices (nalgebra), their diameters, and eigenvalues (faer) with residual bounds.
//!
//! Nothing here can support an exact claim; it is for looking, plotting and comparing.

use super::RationalMatrix;
use faer::Mat;
use nalgebra::DMatrix;
use num_traits::ToPrimitive;

/// The matrix with each entry rounded to the nearest float.
pub fn to_floats(matrix: &RationalMatrix) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.rows(), matrix.cols(), |i, j| matrix.entry(i, j).to_f64().unwrap_or(f64::NAN))
}

/// `max_{i,j} |a_i* - a_j*|_p` over the rows, for `p` = 1, 2 or infinity; tau_1 is half of it for `p` = 1.
pub fn row_diameter(matrix: &DMatrix<f64>, p: f64) -> f64 {
    let distance = |i: usize, j: usize| {
        let difference = matrix.row(i) - matrix.row(j);
        if p == 1.0 {
            difference.iter().map(|x| x.abs()).sum()
        } else if p == 2.0 {
            difference.norm()
        } else {
            difference.amax()
        }
    };
    (0..matrix.nrows()).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| distance(i, j)).fold(0.0, f64::max)
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
pub fn eigenvalues(matrix: &DMatrix<f64>) -> Result<Vec<FloatEigenvalue>, EigenError> {
    let (rows, cols) = matrix.shape();
    if rows != cols {
        return Err(EigenError::NotSquare { rows, cols });
    }
    let a = Mat::from_fn(rows, cols, |i, j| matrix[(i, j)]);
    let eigen = a.eigen().map_err(|_| EigenError::NoConvergence)?;
    let (values, vectors) = (eigen.S(), eigen.U());
    let mut found: Vec<FloatEigenvalue> = (0..rows)
        .map(|k| {
            let value = values[k];
            let (mut error, mut size) = (0.0, 0.0);
            for i in 0..rows {
                let image: faer::c64 =
                    (0..cols).fold(faer::c64::new(0.0, 0.0), |sum, j| sum + vectors[(j, k)] * matrix[(i, j)]);
                error += (image - value * vectors[(i, k)]).norm_sqr();
                size += vectors[(i, k)].norm_sqr();
            }
            FloatEigenvalue { re: value.re, im: value.im, residual: (error / size).sqrt() }
        })
        .collect();
    found.sort_by(|a, b| b.re.hypot(b.im).total_cmp(&a.re.hypot(a.im)));
    Ok(found)
}
