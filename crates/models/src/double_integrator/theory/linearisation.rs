//! Hessians of the potential and linearised closed loops, by duals over any field.

use crate::double_integrator::laws::{
    Coordinates, Pair, Potential, State, Vector, check_links, difference, potential_gradients, velocity_alignment,
};
use algebra::matrix::RationalMatrix;
use algebra::spectrum::Polynomial;
use arithmetic::{ArithmeticError, Dual, Field, Rational};

/// The derivative of `grad_{r_i} V_ij` by `r_i` where `r_ij` is this separation, by rows.
fn stiffness<T: Field>(
    separation: &Vector<T>,
    coordinates: Coordinates,
    potential: &Potential,
) -> Result<[[T; 2]; 2], ArithmeticError> {
    let zero = separation[0].zero();
    let column = |moved: usize| {
        let own = [0, 1].map(|k| {
            let rate = if k == moved { zero.one() } else { zero.clone() };
            Dual::new(separation[k].clone(), rate)
        });
        let other = std::array::from_fn(|_| Dual::constant(zero.clone()));
        let gradients = potential_gradients(&[own, other], &[(0, 1)], coordinates, |_, _, s| potential.slope(s))?;
        Ok::<_, ArithmeticError>(gradients[0].clone().map(|x| x.derivative))
    };
    let ([xx, yx], [xy, yy]) = (column(0)?, column(1)?);
    Ok([[xx, xy], [yx, yy]])
}

/// The derivative of all gradients `grad_{r_i} V_i` by all positions, of order `2N`. In Cartesian coordinates it is the Hessian of the
/// potential; in triangular ones it is similar to it.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where linked agents coincide; [`ArithmeticError::Domain`] for a link to an agent that is not there.
pub fn hessian<T: Field>(
    positions: &[Vector<T>],
    edges: &[Pair],
    coordinates: Coordinates,
    potential: &Potential,
) -> Result<Vec<Vec<T>>, ArithmeticError> {
    check_links(edges, positions.len())?;
    let Some(first) = positions.first() else { return Ok(Vec::new()) };
    let order = 2 * positions.len();
    let mut rows = vec![vec![first[0].zero(); order]; order];
    for &(i, j) in edges {
        let block = stiffness(&difference(&positions[i], &positions[j]), coordinates, potential)?;
        for k in 0..2 {
            for (l, entry) in block[k].iter().enumerate() {
                for agent in [i, j] {
                    let own = &mut rows[2 * agent + k][2 * agent + l];
                    *own = own.clone() + entry;
                }
                for (a, b) in [(i, j), (j, i)] {
                    let across = &mut rows[2 * a + k][2 * b + l];
                    *across = across.clone() - entry;
                }
            }
        }
    }
    Ok(rows)
}

fn with_direction<T: Field>(values: &[Vector<T>], moved: Option<usize>) -> Vec<Vector<Dual<T>>> {
    let rate = |like: &T, index: usize| if Some(index) == moved { like.one() } else { like.zero() };
    let pair = |(i, r): (usize, &Vector<T>)| [0, 1].map(|k| Dual::new(r[k].clone(), rate(&r[k], 2 * i + k)));
    values.iter().enumerate().map(pair).collect()
}

/// The matrix of the linearised closed loop of velocity alignment, equation (4) of the second paper, on `(r, v)`; of order `4N`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where linked agents coincide.
pub fn linearisation<T: Field>(
    state: &State<T>,
    edges: &[Pair],
    coordinates: Coordinates,
    potential: &Potential,
) -> Result<Vec<Vec<T>>, ArithmeticError> {
    let half = 2 * state.count();
    let columns: Result<Vec<Vec<T>>, ArithmeticError> = (0..2 * half)
        .map(|direction| {
            let moved = State {
                positions: with_direction(&state.positions, Some(direction)),
                velocities: with_direction(&state.velocities, direction.checked_sub(half)),
            };
            let accelerations = velocity_alignment(&moved, edges, coordinates, |_, _, s| potential.slope(s))?;
            let rates = moved.velocities.into_iter().chain(accelerations).flatten().map(|x| x.derivative);
            Ok(rates.collect())
        })
        .collect();
    Ok(transposed(&columns?))
}

fn transposed<T: Clone>(columns: &[Vec<T>]) -> Vec<Vec<T>> {
    let rows = columns.first().map_or(0, Vec::len);
    (0..rows).map(|i| columns.iter().map(|column| column[i].clone()).collect()).collect()
}

/// The characteristic polynomial of [`linearisation`] without the zeros, which are counted.
///
/// # Errors
/// As there, and [`ArithmeticError::Domain`] for no agents.
pub fn loop_modes(
    state: &State<Rational>,
    edges: &[Pair],
    coordinates: Coordinates,
    potential: &Potential,
) -> Result<(usize, Polynomial), ArithmeticError> {
    let matrix = RationalMatrix::from_rows(&linearisation(state, edges, coordinates, potential)?);
    let polynomial = matrix.and_then(|matrix| matrix.characteristic_polynomial());
    let polynomial = polynomial.map_err(|_| ArithmeticError::Domain("at least one agent"))?;
    Ok(Polynomial::from_rationals(&polynomial.coefficients()).without_root(0))
}
