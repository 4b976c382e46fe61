//! Four agents on two equilateral triangles side by side: an equilibrium, with the long diagonal linked or not where the potential has
//! slope zero at its length, and the motions near it that keep both diagonals.

use crate::double_integrator::laws::{Coordinates, Pair, Potential, State, linked_within, potential_gradients, tied};
use crate::double_integrator::theory::linearisation;
use algebra::matrix::{MatrixError, RationalMatrix};
use algebra::spectrum::Polynomial;
use arithmetic::{ArithmeticError, Rational, Ring, rational};

const LATTICE: Coordinates = Coordinates::Triangular;

/// The displacements of agents 1, 2, 3, 4 that keep both diagonals, in triangular coordinates and halves: 2 and 4 part along the short
/// diagonal, 1 and 3 along the long one.
const SYMMETRIC_MODES: [[i64; 8]; 2] = [[0, 0, -2, 0, 0, 0, 2, 0], [-1, 2, 0, 0, 1, -2, 0, 0]];

/// The rhombus at rest: agents 1 and 3 at squared distance 3, the other five distances 1, in triangular coordinates.
pub fn rhombus() -> State<Rational> {
    let q = |n: i64| rational(n, 1);
    let positions = [(0, 1), (0, 0), (1, -1), (1, 0)].map(|(x, y)| [q(x), q(y)]).to_vec();
    State { positions, velocities: vec![[q(0), q(0)]; 4] }
}

/// The characteristic polynomial of the linearised loop on the motions that keep both diagonals: displacements along both, and their
/// rates.
///
/// # Errors
/// [`ArithmeticError`], which does not happen for a potential with a slope at 1 and at 3.
pub fn symmetric_modes(edges: &[Pair], potential: &Potential) -> Result<Polynomial, ArithmeticError> {
    let rows = linearisation(&rhombus(), edges, LATTICE, potential)?;
    let polynomial = restricted(&rows).and_then(|rows| RationalMatrix::from_rows(&rows)?.characteristic_polynomial());
    let polynomial =
        polynomial.map_err(|_| ArithmeticError::Domain("a linearisation of four agents that can be formed"))?;
    Ok(Polynomial::from_rationals(&polynomial.coefficients()))
}

/// The matrix of order 16 on the symmetric modes.
fn restricted(rows: &[Vec<Rational>]) -> Result<Vec<Vec<Rational>>, MatrixError> {
    let matrix = RationalMatrix::from_rows(rows)?;
    let mut rows = vec![vec![rational(0, 1); 4]; 4];
    for column in 0..4 {
        let mut vector = vec![rational(0, 1); 16];
        for (k, half) in SYMMETRIC_MODES[column % 2].into_iter().enumerate() {
            vector[8 * (column / 2) + k] = rational(half, 2);
        }
        let image = matrix.apply(&vector)?;
        // Read off at agent 4 (first coordinate) and at agent 1 (second coordinate), positions and then velocities.
        for (row, place) in [6, 1, 14, 9].into_iter().enumerate() {
            rows[row][column] = image[place].clone();
        }
    }
    Ok(rows)
}

/// An integer that no root exceeds in size: the leading coefficient is an integer other than 0, so that none is larger than the sum of all.
fn bound(modes: &Polynomial) -> Rational {
    Rational::from_integer(modes.coefficients().iter().map(num_traits::Signed::abs).sum())
}

/// How many modes the motions near the rhombus have that keep both diagonals and the long one within R, whose square this is, if all of them
/// decay without turning: one that tends to it along the slowest of them does not pass R any more. The bars couple both diagonals, so that the
/// long one takes part in it. `None` where the rhombus is no equilibrium with its long diagonal at R and slope zero there, a mode turns or grows, or two of them are equal.
///
/// # Errors
/// [`ArithmeticError`], which does not happen for a potential with a slope at 1 and at 3.
pub fn real_decaying_modes(potential: &Potential, square: &Rational) -> Result<Option<usize>, ArithmeticError> {
    let state = rhombus();
    let flat = |s: &Rational| potential.slope(s).map(|slope| slope == slope.zero());
    if tied(&state.positions, square, LATTICE) != [(0, 2)] || !flat(&rational(1, 1))? || !flat(square)? {
        return Ok(None);
    }
    let linked = linked_within(&state.positions, square, LATTICE).with_edges(&[(0, 2)]);
    let modes = symmetric_modes(&linked.edges(), potential)?;
    let real = modes.roots_in(&-bound(&modes), &bound(&modes)).len();
    Ok((modes.is_hurwitz() && modes.is_square_free() && real == modes.degree()).then_some(real))
}

/// Whether all modes decay and turn: stable, with simple roots, none of them real. Then none leaves a diagonal at rest: in equilibrium the
/// bars of length 1 have slope 0 and couple the diagonals by their stiffness, without which the short one has none.
fn only_decaying_oscillations(modes: &Polynomial) -> bool {
    modes.is_hurwitz() && modes.is_square_free() && modes.roots_in(&-bound(modes), &bound(modes)).is_empty()
}

/// Whether the rhombus with its long diagonal at R, whose square this is, is an equilibrium with and without that link, which symmetric motions nearby approach in decaying oscillations on both sides, of both diagonals: they pass R for ever.
///
/// # Errors
/// [`ArithmeticError`], which does not happen for a potential with a slope at 1 and at 3.
pub fn crosses_for_ever(potential: &Potential, square: &Rational) -> Result<bool, ArithmeticError> {
    let state = rhombus();
    let linked = linked_within(&state.positions, square, LATTICE);
    // Then the bars of length 1 are shorter than R, and the graph is connected.
    if tied(&state.positions, square, LATTICE) != [(0, 2)] {
        return Ok(false);
    }
    for edges in [linked.edges(), linked.with_edges(&[(0, 2)]).edges()] {
        let slope = |_: usize, _: usize, s: &Rational| potential.slope(s);
        let forces = potential_gradients(&state.positions, &edges, LATTICE, slope)?;
        let rests = forces.iter().flatten().all(|x| *x == x.zero());
        if !rests || !only_decaying_oscillations(&symmetric_modes(&edges, potential)?) {
            return Ok(false);
        }
    }
    Ok(true)
}
