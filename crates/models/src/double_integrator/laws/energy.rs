//! Energies as the papers print them.

use super::law::check_links;
use super::state::{Coordinates, Pair, Vector, difference};
use arithmetic::{ArithmeticError, Field};

/// `V_i`: the sum of `V_ij` over the neighbours of `i`; `value(i, j, s)` is `V_ij` at the squared distance `s`.
///
/// # Errors
/// Whatever the value returns.
pub fn agent_potential<T: Field>(
    agent: usize,
    positions: &[Vector<T>],
    edges: &[Pair],
    coordinates: Coordinates,
    value: impl Fn(usize, usize, &T) -> Result<T, ArithmeticError>,
) -> Result<T, ArithmeticError> {
    let own: Vec<Pair> = edges.iter().copied().filter(|&(i, j)| i == agent || j == agent).collect();
    potential_energy(positions, &own, coordinates, value)
}

/// The sum of `V_ij` over the edges, each once; this is half the sum of all `V_i`.
///
/// # Errors
/// Whatever the value returns; [`ArithmeticError::Domain`] for no agents and for a link to an agent that is not there.
pub fn potential_energy<T: Field>(
    positions: &[Vector<T>],
    edges: &[Pair],
    coordinates: Coordinates,
    value: impl Fn(usize, usize, &T) -> Result<T, ArithmeticError>,
) -> Result<T, ArithmeticError> {
    let Some(first) = positions.first() else { return Err(ArithmeticError::Domain("at least one agent")) };
    check_links(edges, positions.len())?;
    edges.iter().try_fold(first[0].zero(), |total, &(i, j)| {
        let s = coordinates.square(&difference(&positions[i], &positions[j]));
        Ok(total + value(i, j, &s)?)
    })
}

/// The potential part of `Q`, equation (11) of the second paper: the sum of `V_ij` over the links, each once, and `beyond`, which is
/// `V(R)`, for every other pair. With duals and the links of one side of a tie it has the rate on that side.
///
/// # Errors
/// Whatever the value returns.
pub fn saturated_potential<T: Field>(
    positions: &[Vector<T>],
    links: &[Pair],
    coordinates: Coordinates,
    value: impl Fn(usize, usize, &T) -> Result<T, ArithmeticError>,
    beyond: &T,
) -> Result<T, ArithmeticError> {
    let others = (positions.len() * positions.len().saturating_sub(1) / 2).saturating_sub(links.len());
    let others = beyond.integer(others as i64);
    Ok(potential_energy(positions, links, coordinates, value)? + others * beyond)
}

/// Half the sum of the squared speeds.
///
/// # Errors
/// [`ArithmeticError::Domain`] where there is no agent.
pub fn kinetic_energy<T: Field>(velocities: &[Vector<T>], coordinates: Coordinates) -> Result<T, ArithmeticError> {
    let Some(first) = velocities.first() else { return Err(ArithmeticError::Domain("at least one agent")) };
    let twice = velocities.iter().fold(first[0].zero(), |total, v| total + coordinates.square(v));
    Ok(twice * first[0].ratio(1, 2))
}
