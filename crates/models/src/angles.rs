//! Angles modulo whole turns.

use std::f64::consts::TAU;

/// An angle less the nearest number of whole turns, in `[-pi, pi]`.
pub fn modulo_turns(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// An angle less the whole turns below it, in `[0, 2 pi]`; the upper end by rounding only.
pub fn within_a_turn(angle: f64) -> f64 {
    angle.rem_euclid(TAU)
}
