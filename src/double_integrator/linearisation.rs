//! Hessians of the potential and linearised closed loops, exact by duals.

use super::{Coordinates, Pair, Potential, State, Vector, potential_gradients, velocity_alignment};
use crate::arithmetic::{ArithmeticError, Dual, Rational, rational};
use crate::matrix::{MatrixError, RationalMatrix};

/// Numbers of negative, zero and positive eigenvalues.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Inertia {
    /// Negative eigenvalues.
    pub negative: usize,
    /// How often 0 is an eigenvalue.
    pub zero: usize,
    /// Positive eigenvalues.
    pub positive: usize,
}

/// The inertia of a matrix whose eigenvalues are all real.
///
/// # Errors
/// [`MatrixError::NotSquare`].
pub fn inertia(matrix: &RationalMatrix) -> Result<Inertia, MatrixError> {
    let characteristic = matrix.characteristic_polynomial()?;
    let zero = rational(0, 1);
    Ok(Inertia {
        negative: characteristic.count_below(&zero),
        zero: characteristic.multiplicity(&zero),
        positive: characteristic.count_above(&zero),
    })
}

fn directions(count: usize) -> impl Iterator<Item = Vec<Rational>> {
    (0..count).map(move |k| (0..count).map(|j| rational(i64::from(j == k), 1)).collect())
}

fn flat<T: Clone>(vectors: &[Vector<T>]) -> Vec<T> {
    vectors.iter().flatten().cloned().collect()
}

fn with_direction(values: &[Vector<Rational>], rates: &[Rational]) -> Vec<Vector<Dual<Rational>>> {
    let pair = |(v, r): (&Vector<Rational>, &[Rational])| [0, 1].map(|k| Dual::new(v[k].clone(), r[k].clone()));
    values.iter().zip(rates.chunks(2)).map(pair).collect()
}

/// The derivative of all gradients `grad_{r_i} V_i` by all positions, of order `2N`. In Cartesian coordinates it is the Hessian of the
/// potential; in triangular ones it is similar to it.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where linked agents coincide.
pub fn hessian(
    positions: &[Vector<Rational>],
    edges: &[Pair],
    coordinates: Coordinates,
    potential: &Potential,
) -> Result<Vec<Vec<Rational>>, ArithmeticError> {
    let columns: Result<Vec<Vec<Rational>>, ArithmeticError> = directions(2 * positions.len())
        .map(|direction| {
            let moved = with_direction(positions, &direction);
            let gradients = potential_gradients(&moved, edges, coordinates, |_, _, s| potential.slope(s))?;
            Ok(flat(&gradients).into_iter().map(|x| x.derivative).collect())
        })
        .collect();
    Ok(transposed(&columns?))
}

/// The matrix of the linearised closed loop of velocity alignment, equation (4) of the second paper, on `(r, v)`; of order `4N`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where linked agents coincide.
pub fn linearisation(
    state: &State<Rational>,
    edges: &[Pair],
    coordinates: Coordinates,
    potential: &Potential,
) -> Result<Vec<Vec<Rational>>, ArithmeticError> {
    let half = 2 * state.count();
    let columns: Result<Vec<Vec<Rational>>, ArithmeticError> = directions(2 * half)
        .map(|direction| {
            let moved = State {
                positions: with_direction(&state.positions, &direction[..half]),
                velocities: with_direction(&state.velocities, &direction[half..]),
            };
            let accelerations = velocity_alignment(&moved, edges, coordinates, |_, _, s| potential.slope(s))?;
            let rates = flat(&accelerations).into_iter().map(|x| x.derivative);
            Ok(direction[half..].iter().cloned().chain(rates).collect())
        })
        .collect();
    Ok(transposed(&columns?))
}

fn transposed(columns: &[Vec<Rational>]) -> Vec<Vec<Rational>> {
    let rows = columns.first().map_or(0, Vec::len);
    (0..rows).map(|i| columns.iter().map(|column| column[i].clone()).collect()).collect()
}
