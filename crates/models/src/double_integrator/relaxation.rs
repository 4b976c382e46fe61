//! How fast a flock with aligned velocities approaches an equilibrium, to first order, in floats.

use super::equilibria::{Equilibrium, Framework};
use super::{Coordinates, State, linearisation};
use algebra::matrix::floating::{EigenError, eigenvalues};
use arithmetic::ArithmeticError;
use nalgebra::{Complex, DMatrix};

/// Why there is no rate.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RelaxationError {
    /// The law at the equilibrium.
    #[error(transparent)]
    Law(#[from] ArithmeticError),
    /// The eigenvalues.
    #[error(transparent)]
    Eigenvalues(#[from] EigenError),
}

/// The slowest part of the way to an equilibrium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relaxation {
    /// The least decay rate of a mode that moves the flock within the set of configurations up to congruence.
    pub rate: f64,
    /// Whether that mode swings.
    pub swings: bool,
    /// Modes of rate zero besides the uniform motions: rotations, and bendings that no potential resists.
    pub neutral: usize,
    /// The smallest singular value of `mu² + mu L + H` at that mode's eigenvalue `mu`: a change of `H` of this size makes it exact.
    pub residual: f64,
}

/// The slowest mode of velocity alignment, equation (4) of the second paper, around an equilibrium at rest. Uniform motions, in which
/// all agents have one velocity, are taken out; modes of rate zero are left out: they move along the set of equilibria.
///
/// # Errors
/// [`RelaxationError`].
pub fn relaxation(framework: &Framework, equilibrium: &Equilibrium) -> Result<Relaxation, RelaxationError> {
    let count = equilibrium.positions.len();
    let state = State { positions: equilibrium.positions.clone(), velocities: vec![[0.0, 0.0]; count] };
    let rows = linearisation(&state, &framework.edges, Coordinates::Cartesian, &framework.potential)?;
    let (half, kept) = (2 * count, 2 * count.saturating_sub(1));
    let basis = without_uniform(count);
    let part = |column: usize| {
        let block = DMatrix::from_fn(half, half, |i, j| rows[half + i][column + j]);
        basis.tr_mul(&block) * &basis
    };
    let (stiffness, damping) = (part(0), part(half));
    let matrix = DMatrix::from_fn(2 * kept, 2 * kept, |i, j| match (i < kept, j < kept) {
        (true, _) => f64::from(u8::from(j == i + kept)),
        (false, true) => stiffness[(i - kept, j)],
        (false, false) => damping[(i - kept, j - kept)],
    });
    let mut modes = eigenvalues(&matrix)?;
    // By decreasing modulus: the zeros come last, as many as the Hessian has besides translations.
    let neutral = equilibrium.inertia.zero.saturating_sub(2);
    modes.truncate(modes.len() - neutral.min(modes.len()));
    let Some(slowest) = modes.iter().min_by(|a, b| (-a.re).total_cmp(&-b.re)) else {
        return Ok(Relaxation { rate: f64::INFINITY, swings: false, neutral, residual: 0.0 });
    };
    let mu = Complex::new(slowest.re, slowest.im);
    let pencil = DMatrix::from_fn(kept, kept, |i, j| {
        let square = if i == j { mu * mu } else { Complex::new(0.0, 0.0) };
        square - mu * damping[(i, j)] - stiffness[(i, j)]
    });
    let residual = pencil.singular_values().min();
    Ok(Relaxation { rate: -slowest.re, swings: slowest.im.abs() > 1e-6, neutral, residual })
}

/// An orthonormal basis of the planar vectors whose sum over all agents is zero (Helmert), in columns.
fn without_uniform(count: usize) -> DMatrix<f64> {
    DMatrix::from_fn(2 * count, 2 * count.saturating_sub(1), |row, column| {
        let (agent, k) = (row / 2, column / 2 + 1);
        if row % 2 != column % 2 || agent > k {
            return 0.0;
        }
        let scale = ((k * (k + 1)) as f64).sqrt();
        if agent < k { 1.0 / scale } else { -(k as f64) / scale }
    })
}
