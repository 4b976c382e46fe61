//! Whole turns of an angle.

use std::f64::consts::TAU;

/// The number of whole turns that leave an angle in `(-pi, pi]` when they are taken away.
pub fn whole_turns(angle: f64) -> f64 {
    (angle / TAU - 0.5).ceil()
}
