//! Where the velocities and the positions of a fixed connected network go (Chazelle, section 3).

use super::weights::Weights;
use algebra::graph::Graph;
use algebra::matrix::{MatrixError, RationalMatrix};
use arithmetic::{Progress, Rational, Ring, Unwatched};
use num_traits::Zero;

/// The stationary distribution `pi = (tr C^-1)^-1 C^-1 1` of the transition matrix of a connected graph; `[1]` for a
/// single bird.
///
/// # Errors
/// [`MatrixError::NotErgodic`] for a graph that is not connected, [`MatrixError::Singular`] for a weight of zero (or
/// weights whose reciprocals sum to zero), and [`MatrixError`] for a graph without vertices or too few given weights.
pub fn stationary_distribution(graph: &Graph, weights: &Weights) -> Result<Vec<Rational>, MatrixError> {
    match graph.components().len() {
        0 => return Err(MatrixError::Empty),
        1 => {}
        _ => return Err(MatrixError::NotErgodic),
    }
    let c = weights.all(graph)?;
    if let [only] = c.as_slice() {
        return Ok(vec![only.one()]);
    }
    if c.iter().any(Zero::is_zero) {
        return Err(MatrixError::Singular);
    }
    let reciprocals: Vec<Rational> = c.iter().map(Rational::recip).collect();
    let trace: Rational = reciprocals.iter().sum();
    if trace.is_zero() {
        return Err(MatrixError::Singular);
    }
    Ok(reciprocals.iter().map(|x| x / &trace).collect())
}

/// The square matrix `1 pi^T`, whose rows all are `pi`.
///
/// # Errors
/// [`MatrixError::Empty`].
pub fn equal_rows(pi: &[Rational]) -> Result<RationalMatrix, MatrixError> {
    RationalMatrix::from_rows(&vec![pi.to_vec(); pi.len()])
}

/// `Gamma = lim (-t 1 pi^T + sum_{s<t} P^s) = (I - P + 1 pi^T)^-1 - 1 pi^T` (Chazelle, Lemma 3.3), the group inverse of
/// `I - P`, for a stochastic `P` whose powers converge to `1 pi^T`.
///
/// # Errors
/// [`MatrixError::Singular`] where 1 is more than a simple eigenvalue of `P`, and [`MatrixError`] where the shapes do not
/// fit.
pub fn deviation_matrix(p: &RationalMatrix, pi: &[Rational]) -> Result<RationalMatrix, MatrixError> {
    deviation_matrix_watched(p, pi, &Unwatched)
}

/// As [`deviation_matrix`], until `progress` stops it.
///
/// # Errors
/// As there, and [`MatrixError::Cancelled`].
pub fn deviation_matrix_watched(
    p: &RationalMatrix,
    pi: &[Rational],
    progress: &dyn Progress,
) -> Result<RationalMatrix, MatrixError> {
    let limit = equal_rows(pi)?;
    let fundamental = RationalMatrix::identity(pi.len())?.minus(p)?.plus(&limit)?.inverse_watched(progress)?;
    fundamental.minus(&limit)?.reduced_watched(progress)
}
