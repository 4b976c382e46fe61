//! Dense matrices of floats, by faer: products, eigenvalues, singular values, inverses.
//!
//! Nothing is promised of the results: who uses them finds bounds of their own. The crate is here so that faer's generic algorithms, a fifth of
//! what the spectra are compiled from, are compiled once and for the kinds of numbers that are used.

pub use faer::{self, Mat, MatMut, MatRef, c64};

use faer::linalg::matmul::matmul;
use faer::linalg::solvers::DenseSolveCore;
use faer::{Accum, Par, Side};

/// The product of an `m x k` and a `k x n` matrix.
///
/// # Panics
/// Where the inner dimensions differ.
pub fn product(left: MatRef<'_, f64>, right: MatRef<'_, f64>) -> Mat<f64> {
    let mut result = Mat::zeros(left.nrows(), right.ncols());
    matmul(result.as_mut(), Accum::Replace, left, right, 1.0, Par::Seq);
    result
}

/// Adds `factor` times the product of an `m x k` and a `k x n` matrix to one of `m x n`.
///
/// # Panics
/// Where the dimensions do not fit.
pub fn add_product(to: MatMut<'_, f64>, factor: f64, left: MatRef<'_, f64>, right: MatRef<'_, f64>) {
    matmul(to, Accum::Add, left, right, factor, Par::Seq);
}

/// The product of complex matrices.
///
/// # Panics
/// Where the inner dimensions differ.
pub fn complex_product(left: MatRef<'_, c64>, right: MatRef<'_, c64>) -> Mat<c64> {
    let mut result = Mat::zeros(left.nrows(), right.ncols());
    matmul(result.as_mut(), Accum::Replace, left, right, c64::new(1.0, 0.0), Par::Seq);
    result
}

/// The inverse of a complex square matrix; entries that are not finite where it is singular.
///
/// # Panics
/// Where it is not square.
pub fn complex_inverse(matrix: MatRef<'_, c64>) -> Mat<c64> {
    matrix.partial_piv_lu().inverse()
}

/// Eigenvalues and, in the columns, an eigenvector of each.
pub struct Eigen {
    /// The eigenvalues, in no particular order.
    pub values: Vec<c64>,
    /// Eigenvectors, of any length.
    pub vectors: Mat<c64>,
}

/// The eigenvalues of a real square matrix; `None` where the iteration does not converge.
///
/// # Panics
/// Where it is not square.
pub fn eigen(matrix: MatRef<'_, f64>) -> Option<Eigen> {
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

/// Eigenvalues and eigenvectors of a symmetric matrix, of which the lower half is read; `None` where the iteration does not converge.
///
/// # Panics
/// Where it is not square.
pub fn symmetric_eigen(matrix: MatRef<'_, f64>) -> Option<SymmetricEigen> {
    let eigen = matrix.self_adjoint_eigen(Side::Lower).ok()?;
    Some(SymmetricEigen { values: eigen.S().column_vector().iter().copied().collect(), vectors: eigen.U().to_owned() })
}

/// The singular values of a matrix of any shape; `None` where the iteration does not converge.
pub fn singular_values(matrix: MatRef<'_, f64>) -> Option<Vec<f64>> {
    matrix.singular_values().ok()
}
