//! How fast a flock with aligned velocities approaches an equilibrium, to first order, in floats.

use super::equilibria::{Equilibrium, Framework};
use super::linearisation::linearisation;
use crate::double_integrator::laws::{Coordinates, State};
use algebra::faer::Mat;
use algebra::matrix::floating::{EigenError, eigenvalues, least_singular_value, product};
use arithmetic::ArithmeticError;

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
    let transposed = Mat::from_fn(kept, half, |i, j| basis[(j, i)]);
    let part = |column: usize| {
        let block = Mat::from_fn(half, half, |i, j| rows[half + i][column + j]);
        product(&product(&transposed, &block), &basis)
    };
    let (stiffness, damping) = (part(0), part(half));
    let matrix = Mat::from_fn(2 * kept, 2 * kept, |i, j| match (i < kept, j < kept) {
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
    let pencil = pencil(&stiffness, &damping, (slowest.re, slowest.im));
    let residual = least_singular_value(&pencil)?;
    Ok(Relaxation { rate: -slowest.re, swings: slowest.im.abs() > 1e-6, neutral, residual })
}

/// `mu² - mu damping - stiffness = P + iQ` at `mu = x + iy` as the real matrix `(P, -Q; Q, P)`: its singular values are the same, twice each.
fn pencil(stiffness: &Mat<f64>, damping: &Mat<f64>, (x, y): (f64, f64)) -> Mat<f64> {
    let kept = stiffness.nrows();
    Mat::from_fn(2 * kept, 2 * kept, |row, column| {
        let (i, j) = (row % kept, column % kept);
        let unit = f64::from(u8::from(i == j));
        if (row < kept) == (column < kept) {
            unit * (x * x - y * y) - x * damping[(i, j)] - stiffness[(i, j)]
        } else {
            let imaginary = unit * (2.0 * x * y) - y * damping[(i, j)];
            if row < kept { -imaginary } else { imaginary }
        }
    })
}

/// An orthonormal basis of the planar vectors whose sum over all agents is zero (Helmert), in columns.
fn without_uniform(count: usize) -> Mat<f64> {
    Mat::from_fn(2 * count, 2 * count.saturating_sub(1), |row, column| {
        let (agent, k) = (row / 2, column / 2 + 1);
        if row % 2 != column % 2 || agent > k {
            return 0.0;
        }
        let scale = ((k * (k + 1)) as f64).sqrt();
        if agent < k { 1.0 / scale } else { -(k as f64) / scale }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `(mu² - mu damping - stiffness)(u + iw)` by complex numbers, column by column.
    #[test]
    fn the_pencil_is_the_complex_matrix() {
        let stiffness = Mat::from_fn(3, 3, |i, j| (3 * i + j) as f64 - 4.5);
        let damping = Mat::from_fn(3, 3, |i, j| 0.5 * (i * i) as f64 - 2.0 * j as f64 + 1.0);
        let (x, y) = (0.75, -1.25);
        let found = pencil(&stiffness, &damping, (x, y));
        for i in 0..3 {
            for j in 0..3 {
                let square = if i == j { (x * x - y * y, 2.0 * x * y) } else { (0.0, 0.0) };
                let re = square.0 - x * damping[(i, j)] - stiffness[(i, j)];
                let im = square.1 - y * damping[(i, j)];
                let block = [found[(i, j)], found[(i, j + 3)], found[(i + 3, j)], found[(i + 3, j + 3)]];
                assert_eq!(block, [re, -im, im, re], "{i} {j}");
            }
        }
    }

    /// Columns of length 1, at right angles, whose sums over the agents vanish in both coordinates.
    #[test]
    fn the_basis_leaves_uniform_motions_out() {
        for count in 1..6 {
            let basis = without_uniform(count);
            assert_eq!((basis.nrows(), basis.ncols()), (2 * count, 2 * count - 2));
            for j in 0..2 * count - 2 {
                for k in 0..2 * count - 2 {
                    let product: f64 = (0..2 * count).map(|i| basis[(i, j)] * basis[(i, k)]).sum();
                    assert!((product - f64::from(u8::from(j == k))).abs() < 1e-14);
                }
                for axis in [0, 1] {
                    assert!((0..count).map(|i| basis[(2 * i + axis, j)]).sum::<f64>().abs() < 1e-14);
                    // The columns take turns between the axes.
                    assert!(j % 2 == axis || (0..count).all(|i| basis[(2 * i + axis, j)] == 0.0));
                }
            }
        }
    }
}
