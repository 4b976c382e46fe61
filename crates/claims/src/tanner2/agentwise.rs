//! (10b) read agent by agent: the two agents of a pair at distance `R` may then weigh their link differently.
//!
//! Three agents on a line, `V = s + 1/s - 2`, `R = 9/5`: agents 1 and 2 move together at distance `R`, and agent 3 swings between them,
//! at `(1/50) sin t` from the middle. Its acceleration is that of the law, with the links to both; so is that of the pair, if
//! agent 1 has the tied link with weight `m` and agent 2 with weight `m'`, both between 0 and 1 at all times.

use super::fixtures::{PLANE, spring};
use arithmetic::{Field, Interval, Rational, Ring, Signed, rational};
use ledger::CheckError;
use models::double_integrator::{State, linked_within, velocity_alignment};

/// The weights `m` and `m'` where the sine and the cosine of the time are these; `None` where the links are not as described.
fn weights<T: Field + Signed>(sine: &T, cosine: &T) -> Result<Option<[T; 2]>, CheckError> {
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
    let slope = |_: usize, _: usize, s: &T| spring().slope(s);
    let own = velocity_alignment(&state, &links, PLANE, slope)?;
    let tied = velocity_alignment(&state, &[(0, 1)], PLANE, slope)?;
    // Agent 3 has the acceleration of the pair minus the swing (1/50) sin t.
    let pair = own[2][0].clone() + size * sine;
    let weight = |k: usize| (pair.clone() - &own[k][0]).over(&tied[k][0]);
    Ok(Some([weight(0)?, weight(1)?]))
}

/// Whether the swing is a solution: with any weights in `[0, 1]`, or with the same one for both agents.
pub fn swing(agentwise: bool) -> Result<Option<String>, CheckError> {
    if !agentwise {
        let same = weights::<Rational>(&rational(1, 1), &rational(0, 1))?.is_some_and(|[a, b]| a == b);
        return Ok(same.then(|| "the weights agree at t = pi/2".to_string()));
    }
    // The whole period at once.
    let all = Interval::hull_of_rationals(&rational(-1, 1), &rational(1, 1), 80);
    let Some(found) = weights(&all, &all)? else { return Ok(None) };
    let between = |m: &Interval| m.is_certainly_positive() && (m.one() - m).is_certainly_positive();
    Ok(found.iter().all(between).then(|| {
        "V = s + 1/s - 2, R = 9/5, agents 1 and 2 at distance R and agent 3 between them, at (1/50) sin t from the middle: a solution for all time if agents 1 and 2 weigh their link differently; velocities never agree".to_string()
    }))
}
