//! The equilateral triangle that turns for ever: three linked agents whose headings, with wrapped differences, never align.
//!
//! Squared side `s`, centre at rest, rate `omega`: the potential forces are `-6 V'(s) r_i` (the three positions sum to zero), so the motion
//! needs `omega² = 6 V'(s)`; with `V = 1/s + log s` and `s = 2` that is 3/2. Each agent sees the two others with headings a third of a turn
//! to either side: wrapped differences cancel, whatever the (equal) weights. The law is the same in turned coordinates, so that what is
//! true at one time is true for ever.

use crate::double_integrator::laws::{
    Coordinates, Potential, State, Vector, cross, gyroscopic, potential_gradients, rotated, scaled,
};
use arithmetic::{ArithmeticError, CosineField, Field, Rational, RealCyclotomic, Ring, Sign, Signed, rational};

const PLANE: Coordinates = Coordinates::Cartesian;
const PAIRS: [(usize, usize); 3] = [(0, 1), (0, 2), (1, 2)];

/// Whether the triangle of squared side 2 that turns with `omega = rate sqrt(3/2)` is a motion of (1), (4), (5) of the first paper, where
/// the differences of the headings of agents 1 and 2, 1 and 3, 2 and 3 are the wrapped ones plus so many whole turns (for those of (2)
/// one of the three is off by a turn at each time): exactly, in the field of the cosines of multiples of a 24th of a turn, which has the square roots of 2
/// and 3.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] for a potential without slope at 2.
pub fn turning_triangle(
    potential: &Potential,
    rate: &Rational,
    whole_turns: [i64; 3],
) -> Result<bool, ArithmeticError> {
    let field = CosineField::new(24);
    // sqrt 2 = 2 cos(pi/4), sqrt 3 = 2 cos(pi/6).
    let root = field.cos(3) * field.cos(2) * field.number(&rational(4, 1));
    let radius = root.clone() * root.ratio(1, 3);
    let omega = root * field.number(&(rate / rational(2, 1)));
    let positions: Vec<Vector<RealCyclotomic>> =
        (0..3).map(|k| scaled(&radius, &[field.cos(8 * k), field.sin(8 * k)])).collect();
    let velocities = positions.iter().map(|r| scaled(&omega, &rotated(r))).collect();
    let state = State { positions, velocities };
    let slope = potential.slope_over(&omega);
    let gradients = potential_gradients(&state.positions, &PAIRS, PLANE, |_, _, s| slope.at(s))?;
    let mut thirds = Vec::with_capacity(3);
    for ((i, j), whole) in PAIRS.into_iter().zip(whole_turns) {
        let Some(third) = third_of_a_turn(&state.velocities[j], &state.velocities[i]) else { return Ok(false) };
        thirds.push(((i, j), third + 3 * whole));
    }
    // Differences in units of a third of a turn. The forces are linear in them: zero in one unit is zero in all.
    let differ = |i: usize, j: usize| {
        let known = thirds.iter().find(|(pair, _)| *pair == (i, j)).map_or(0, |(_, third)| *third);
        omega.integer(known)
    };
    let accelerations = gyroscopic(&state, &gradients, &PAIRS, differ)?;
    let centripetal = omega.clone() * &omega;
    Ok(accelerations.iter().zip(&state.positions).all(|(a, r)| *a == scaled(&-centripetal.clone(), r)))
}

/// 1 or -1 where `w` points a third of a turn to the left or right of `v`, one of which it does unless both are zero: the side tells.
fn third_of_a_turn(v: &Vector<RealCyclotomic>, w: &Vector<RealCyclotomic>) -> Option<i64> {
    match cross(v, w).sign()? {
        Sign::Positive => Some(1),
        Sign::Negative => Some(-1),
        Sign::Zero => None,
    }
}
