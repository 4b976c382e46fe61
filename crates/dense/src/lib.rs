//! Dense matrices of floats, by faer: products, eigenvalues, singular values, inverses.
//!
//! Nothing is promised of the results: who uses them finds bounds of their own. The crate is here so that faer's generic algorithms, a fifth of
//! what the spectra are compiled from, are compiled once and for the kinds of numbers that are used.
//!
//! ```
//! use flockproof_dense::{Mat, product, symmetric_eigen};
//!
//! // The Laplacian of two joined vertices: its eigenvalues are 0 and 2, but for rounding.
//! let laplacian = Mat::from_fn(2, 2, |i, j| if i == j { 1.0 } else { -1.0 });
//! let mut values = symmetric_eigen(laplacian.as_ref()).unwrap().values;
//! values.sort_by(f64::total_cmp);
//! assert!(values[0].abs() < 1e-14 && (values[1] - 2.0).abs() < 1e-14);
//!
//! // Shapes that do not fit give NaN and no panic.
//! let row: Mat<f64> = Mat::zeros(1, 3);
//! assert!(product(laplacian.as_ref(), row.as_ref())[(0, 0)].is_nan());
//! ```

pub use faer::{self, Mat, MatMut, MatRef, c64};

use faer::linalg::matmul::matmul;
use faer::linalg::solvers::DenseSolveCore;
use faer::{Accum, Par, Side};

/// The product of an `m x k` and a `k x n` matrix; `NaN` in each entry where the shapes do not fit.
pub fn product(left: MatRef<'_, f64>, right: MatRef<'_, f64>) -> Mat<f64> {
    if left.ncols() != right.nrows() {
        return Mat::full(left.nrows(), right.ncols(), f64::NAN);
    }
    let mut result = Mat::zeros(left.nrows(), right.ncols());
    matmul(result.as_mut(), Accum::Replace, left, right, 1.0, Par::Seq);
    result
}

/// Adds `factor` times the product of an `m x k` and a `k x n` matrix to one of `m x n`; `NaN` in each entry where the shapes do not fit.
pub fn add_product(mut to: MatMut<'_, f64>, factor: f64, left: MatRef<'_, f64>, right: MatRef<'_, f64>) {
    if left.ncols() != right.nrows() || (to.nrows(), to.ncols()) != (left.nrows(), right.ncols()) {
        return to.fill(f64::NAN);
    }
    matmul(to, Accum::Add, left, right, factor, Par::Seq);
}

/// The product of complex matrices; `NaN` in each entry where the shapes do not fit.
pub fn complex_product(left: MatRef<'_, c64>, right: MatRef<'_, c64>) -> Mat<c64> {
    if left.ncols() != right.nrows() {
        return Mat::full(left.nrows(), right.ncols(), c64::new(f64::NAN, f64::NAN));
    }
    let mut result = Mat::zeros(left.nrows(), right.ncols());
    matmul(result.as_mut(), Accum::Replace, left, right, c64::new(1.0, 0.0), Par::Seq);
    result
}

/// The inverse of a complex matrix; entries that are not finite where it is singular, `NaN` where it is not square.
pub fn complex_inverse(matrix: MatRef<'_, c64>) -> Mat<c64> {
    if matrix.nrows() != matrix.ncols() {
        return Mat::full(matrix.nrows(), matrix.ncols(), c64::new(f64::NAN, f64::NAN));
    }
    matrix.partial_piv_lu().inverse()
}

/// Eigenvalues and, in the columns, an eigenvector of each.
pub struct Eigen {
    /// The eigenvalues, in no particular order.
    pub values: Vec<c64>,
    /// Eigenvectors, of any length.
    pub vectors: Mat<c64>,
}

/// The eigenvalues of a real matrix; `None` where it is not square or the iteration does not converge.
pub fn eigen(matrix: MatRef<'_, f64>) -> Option<Eigen> {
    if matrix.nrows() != matrix.ncols() {
        return None;
    }
    let eigen = matrix.eigen().ok()?;
    let values = (0..matrix.nrows()).map(|k| eigen.S()[k]).collect();
    Some(Eigen { values, vectors: eigen.U().to_owned() })
}

/// A symmetric matrix turned to its axes.
#[derive(Debug, Clone)]
pub struct SymmetricEigen {
    /// The eigenvalues, ascending.
    pub values: Vec<f64>,
    /// Orthonormal eigenvectors in columns, in the same order.
    pub vectors: Mat<f64>,
}

/// Eigenvalues and eigenvectors of a symmetric matrix, of which the lower half is read; `None` where it is not square or the iteration does
/// not converge.
pub fn symmetric_eigen(matrix: MatRef<'_, f64>) -> Option<SymmetricEigen> {
    if matrix.nrows() != matrix.ncols() {
        return None;
    }
    let eigen = matrix.self_adjoint_eigen(Side::Lower).ok()?;
    Some(SymmetricEigen { values: eigen.S().column_vector().iter().copied().collect(), vectors: eigen.U().to_owned() })
}

/// The singular values of a matrix of any shape; `None` where the iteration does not converge.
pub fn singular_values(matrix: MatRef<'_, f64>) -> Option<Vec<f64>> {
    matrix.singular_values().ok()
}
