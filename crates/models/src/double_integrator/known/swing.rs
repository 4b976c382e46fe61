//! An exact motion of three agents on a line whose links switch by distance, if the two agents of a pair at distance `R` may weigh their link
//! differently: (10b) of the second paper read agent by agent.
//!
//! `V = s + 1/s - 2`, `R = 9/5`: agents 1 and 2 move together at distance `R`, and agent 3 swings between them, at `(1/50) sin t` from the
//! middle. Its acceleration is that of the law, with the links to both; so is that of the pair, if agent 1 has the tied link with weight `m`
//! and agent 2 with weight `m'`, both between 0 and 1 at all times.

use crate::double_integrator::laws::{Coordinates, Potential, State, linked_within, velocity_alignment};
use arithmetic::{ArithmeticError, Field, Signed, rational};

const PLANE: Coordinates = Coordinates::Cartesian;

/// The weights `m` and `m'` where the sine and the cosine of the time are these; `None` where the links are not as described.
///
/// # Errors
/// [`ArithmeticError`] of the law, where agents coincide; a sine that would put them there has no such links.
pub fn swing_weights<T: Field + Signed>(sine: &T, cosine: &T) -> Result<Option<[T; 2]>, ArithmeticError> {
    let (radius, size, zero) = (sine.ratio(9, 5), sine.ratio(1, 50), sine.zero());
    let half = radius.clone() * sine.ratio(1, 2);
    let on_line = |x: T| [x, zero.clone()];
    // In the frame of the pair; the law does not change with the frame.
    let state = State {
        positions: vec![on_line(-half.clone()), on_line(half), on_line(size.clone() * sine)],
        velocities: vec![on_line(zero.clone()), on_line(zero.clone()), on_line(size.clone() * cosine)],
    };
    let links = [(0, 2), (1, 2)];
    let near = linked_within(&state.positions, &radius.square(), PLANE);
    if !links.iter().all(|&(i, j)| near.has_edge(i, j)) || near.has_edge(0, 1) {
        return Ok(None);
    }
    let spring = Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1));
    let slope = |_: usize, _: usize, s: &T| spring.slope(s);
    let own = velocity_alignment(&state, &links, PLANE, slope)?;
    let tied = velocity_alignment(&state, &[(0, 1)], PLANE, slope)?;
    // Agent 3 has the acceleration of the pair minus the swing (1/50) sin t.
    let pair = own[2][0].clone() + size * sine;
    let weight = |k: usize| (pair.clone() - &own[k][0]).over(&tied[k][0]);
    Ok(Some([weight(0)?, weight(1)?]))
}
