//! Headings, and the first paper's alignment by a force normal to the velocity.

use super::law::check_links;
use super::state::{Coordinates, Pair, State, Vector, cross, difference, rotated, scaled};
use crate::angles::{modulo_turns, within_a_turn};
use arithmetic::{ArithmeticError, Field, Real, Ring, Sign};
use std::f64::consts::PI;

/// What `theta_i - theta_j` means in equation (5) of the first paper, which does not say it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HeadingDifference {
    /// The difference of the headings in `(-pi, pi]`: it jumps where one of them passes `pi`.
    Raw,
    /// The difference of the headings, reduced to `(-pi, pi]`: it jumps where the agents move in opposite directions.
    Wrapped,
    /// The difference of headings that are followed continuously from the start, as further states.
    Unwrapped,
}

impl HeadingDifference {
    /// The difference that the law uses, from that of two headings in `(-pi, pi]`, or of two that are followed. An enclosure of the difference
    /// has to decide whether it is above `pi` and whether it is above `-pi`.
    pub fn read<T: Real>(self, difference: T) -> T {
        let pi = difference.pi();
        let turn = pi.clone() + &pi;
        match self {
            HeadingDifference::Raw | HeadingDifference::Unwrapped => difference,
            HeadingDifference::Wrapped if (difference.clone() - &pi).is_certainly_positive() => difference - turn,
            HeadingDifference::Wrapped if (difference.clone() + &pi).sign() != Some(Sign::Positive) => {
                difference + turn
            }
            HeadingDifference::Wrapped => difference,
        }
    }
}

/// `arctan(y, x)`, the angle in `(-pi, pi]` from the first axis to a vector.
///
/// # Errors
/// [`ArithmeticError::Domain`] for the zero vector, and where a sign is not decided.
pub fn heading<T: Real>(v: &Vector<T>) -> Result<T, ArithmeticError> {
    let undecided = ArithmeticError::Domain("vectors that are not zero");
    let [x, y] = v;
    let (across, up) = (x.sign().ok_or(undecided.clone())?, y.sign().ok_or(undecided.clone())?);
    let half = x.pi() * x.ratio(1, 2);
    Ok(match (across, up) {
        (Sign::Positive, _) => y.over(x)?.atan()?,
        (_, Sign::Positive) => half - x.over(y)?.atan()?,
        (_, Sign::Negative) => -half - x.over(y)?.atan()?,
        (Sign::Negative, Sign::Zero) => x.pi(),
        (Sign::Zero, Sign::Zero) => return Err(undecided),
    })
}

/// The largest angle between two of some headings in radians, at most `pi`; 0 for fewer than two. Cost: `N log N`.
pub fn heading_spread(headings: &[f64]) -> f64 {
    let mut angles: Vec<f64> = headings.iter().map(|theta| within_a_turn(*theta)).collect();
    angles.sort_by(f64::total_cmp);
    // Farthest from an angle is what comes next to its opposite.
    let farthest = |angle: f64| {
        let place = angles.partition_point(|other| *other < within_a_turn(angle + PI));
        let near = [place % angles.len(), (place + angles.len() - 1) % angles.len()];
        near.map(|k| modulo_turns(angles[k] - angle).abs()).into_iter().fold(0.0, f64::max)
    };
    angles.iter().map(|angle| farthest(*angle)).fold(0.0, f64::max)
}

/// The rate of change of the heading, `(v x a)/|v|²`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] for an agent at rest.
pub fn heading_rate<T: Field>(velocity: &Vector<T>, acceleration: &Vector<T>) -> Result<T, ArithmeticError> {
    cross(velocity, acceleration).over(&Coordinates::Cartesian.square(velocity))
}

/// The accelerations of the first paper, equations (4) and (5): minus the gradients, minus
/// `sum over j ~ i of differ(i, j)/|r_ij|² (z x v_i)`; `differ(i, j)` is the heading difference of `i` and `j`, odd in `(i, j)`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where linked agents coincide; [`ArithmeticError::Domain`] for a link to an agent that is not there.
pub fn gyroscopic<T: Field>(
    state: &State<T>,
    gradients: &[Vector<T>],
    edges: &[Pair],
    differ: impl Fn(usize, usize) -> T,
) -> Result<Vec<Vector<T>>, ArithmeticError> {
    let turning = turning_rates(state, edges, differ)?;
    let agents = state.velocities.iter().zip(gradients).zip(&turning);
    Ok(agents.map(|((v, gradient), rate)| turned(v, rate, gradient)).collect())
}

/// The acceleration of one agent that turns at a rate: `rate (z x v) - gradient`.
pub(in crate::double_integrator) fn turned<T: Ring>(velocity: &Vector<T>, rate: &T, gradient: &Vector<T>) -> Vector<T> {
    difference(&scaled(rate, &rotated(velocity)), gradient)
}

/// What a neighbour adds to the rate of turning: minus the difference of the headings, over the squared distance.
#[inline(always)]
pub(in crate::double_integrator) fn turning<T: Field>(differ: T, square: &T) -> Result<T, ArithmeticError> {
    Ok(-(differ * square.recip()?))
}

/// `-sum over j ~ i of differ(i, j)/|r_ij|²`: the right side of equation (7).
fn turning_rates<T: Field>(
    state: &State<T>,
    edges: &[Pair],
    differ: impl Fn(usize, usize) -> T,
) -> Result<Vec<T>, ArithmeticError> {
    check_links(edges, state.count())?;
    let mut rates: Vec<T> = state.positions.iter().map(|r| Ring::zero(&r[0])).collect();
    for &(i, j) in edges {
        let rate = turning(differ(i, j), &Coordinates::Cartesian.square(&state.separation(i, j)))?;
        rates[i] = rates[i].clone() + &rate;
        rates[j] = rates[j].clone() - rate;
    }
    Ok(rates)
}
