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

/// `(P (x) I_d) v` for the velocities of the birds, one row for each: every coordinate is averaged by itself, those that all birds have.
///
/// # Errors
/// [`MatrixError::Shapes`] where there are not as many birds as columns.
pub fn averaged(matrix: &RationalMatrix, velocities: &[Vec<Rational>]) -> Result<Vec<Vec<Rational>>, MatrixError> {
    let dimension = velocities.iter().map(Vec::len).min().unwrap_or(0);
    let coordinate = |k: usize| velocities.iter().map(|v| v[k].clone()).collect::<Vec<_>>();
    let columns = (0..dimension).map(|k| matrix.apply(&coordinate(k))).collect::<Result<Vec<_>, _>>()?;
    Ok((0..matrix.rows()).map(|i| columns.iter().map(|column| column[i].clone()).collect()).collect())
}
