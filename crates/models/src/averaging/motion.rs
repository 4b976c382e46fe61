//! The equations of motion (1.2) under given transition matrices, in any dimension.

use algebra::matrix::{MatrixError, RationalMatrix};
use arithmetic::Rational;

/// Positions and velocities of all birds, the coordinates of a bird next to each other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct State {
    /// `x(t)`.
    pub positions: Vec<Rational>,
    /// `v(t + 1)`, the velocity of the next step.
    pub velocities: Vec<Rational>,
}

/// The states at `t = 0, 1, .., T` from `x(0)` and `v(1)`, with the transition matrices `P(1), .., P(T)`:
/// `x(t) = x(t-1) + v(t)` and `v(t+1) = (P(t) (x) I_d) v(t)` (Chazelle, equation (1.2) without control).
///
/// # Errors
/// [`MatrixError::Shapes`] where the lists do not fit the matrices.
pub fn motion(start: State, dimension: usize, matrices: &[RationalMatrix]) -> Result<Vec<State>, MatrixError> {
    let lift = RationalMatrix::identity(dimension)?;
    let mut states = vec![start];
    for matrix in matrices {
        let State { positions, velocities } = &states[states.len() - 1];
        if positions.len() != velocities.len() {
            return Err(MatrixError::Shapes { left_cols: positions.len(), right_rows: velocities.len() });
        }
        let moved = positions.iter().zip(velocities).map(|(x, v)| x + v).collect();
        let averaged = matrix.kronecker(&lift).apply(velocities)?;
        states.push(State { positions: moved, velocities: averaged });
    }
    Ok(states)
}
