//! The forces: gradients of potentials and velocity alignment; which agents are linked.

use super::state::{Coordinates, Pair, State, Vector, difference, scaled, sum};
use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Field, Ring, Sign, Signed};

/// `grad_{r_i} V_ij = 2 V_ij'(s_ij) r_ij` for one pair, from its separation `r_ij` and its slope.
#[inline(always)]
pub fn pull<T: Ring>(separation: &Vector<T>, slope: T) -> Vector<T> {
    let two = slope.integer(2);
    scaled(&(slope * two), separation)
}

/// That all links are between agents that are there.
pub(in crate::double_integrator) fn check_links(links: &[Pair], agents: usize) -> Result<(), ArithmeticError> {
    let there = links.iter().all(|&(i, j)| i.max(j) < agents);
    if there { Ok(()) } else { Err(ArithmeticError::Domain("links between agents that are there")) }
}

/// `grad_{r_i} V_i = sum over j ~ i of 2 V_ij'(s_ij) r_ij` for every agent; `slope(i, j, s)` is `V_ij'(s)`, asked for once for each
/// edge.
///
/// # Errors
/// Whatever the slope returns: [`ArithmeticError::DivisionByZero`] where linked agents coincide; [`ArithmeticError::Domain`] for a link
/// to an agent that is not there.
pub fn potential_gradients<T: Field>(
    positions: &[Vector<T>],
    edges: &[Pair],
    coordinates: Coordinates,
    slope: impl Fn(usize, usize, &T) -> Result<T, ArithmeticError>,
) -> Result<Vec<Vector<T>>, ArithmeticError> {
    check_links(edges, positions.len())?;
    let mut gradients: Vec<Vector<T>> = positions.iter().map(|r| [r[0].zero(), r[0].zero()]).collect();
    for &(i, j) in edges {
        let separation = difference(&positions[i], &positions[j]);
        let s = coordinates.square(&separation);
        let pull = pull(&separation, slope(i, j, &s)?);
        gradients[i] = sum(&gradients[i], &pull);
        gradients[j] = difference(&gradients[j], &pull);
    }
    Ok(gradients)
}

/// `sum over j ~ i of (v_i - v_j)` for every agent; links to agents that are not there are left out.
pub fn disagreements<T: Ring>(velocities: &[Vector<T>], edges: &[Pair]) -> Vec<Vector<T>> {
    let mut total: Vec<Vector<T>> = velocities.iter().map(|v| [v[0].zero(), v[0].zero()]).collect();
    for &(i, j) in edges.iter().filter(|&&(i, j)| i.max(j) < velocities.len()) {
        let relative = difference(&velocities[i], &velocities[j]);
        total[i] = sum(&total[i], &relative);
        total[j] = difference(&total[j], &relative);
    }
    total
}

/// The accelerations of the second paper, equation (4): minus the disagreements, minus the gradients.
///
/// # Errors
/// Whatever the slope returns.
pub fn velocity_alignment<T: Field>(
    state: &State<T>,
    edges: &[Pair],
    coordinates: Coordinates,
    slope: impl Fn(usize, usize, &T) -> Result<T, ArithmeticError>,
) -> Result<Vec<Vector<T>>, ArithmeticError> {
    let gradients = potential_gradients(&state.positions, edges, coordinates, slope)?;
    let total = disagreements(&state.velocities, edges).into_iter().zip(&gradients).map(|(a, b)| sum(&a, b));
    Ok(total.map(|[x, y]| [-x, -y]).collect())
}

/// The neighbouring graph of Section 5: a link where `|r_ij| < R`; `square` is `R²`. A pair whose order with `R` is not
/// decided is not linked.
pub fn linked_within<T: Field + Signed>(positions: &[Vector<T>], square: &T, coordinates: Coordinates) -> Graph {
    Graph::from_fn(positions.len(), |i, j| {
        let s = coordinates.square(&difference(&positions[i], &positions[j]));
        (s - square).sign() == Some(Sign::Negative)
    })
}

/// The pairs at distance exactly `R`.
pub fn tied<T: Field + Signed>(positions: &[Vector<T>], square: &T, coordinates: Coordinates) -> Vec<Pair> {
    let on = |i: usize, j: usize| {
        let s = coordinates.square(&difference(&positions[i], &positions[j]));
        (s - square).sign() == Some(Sign::Zero)
    };
    let pairs = (0..positions.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    pairs.filter(|&(i, j)| on(i, j)).collect()
}
