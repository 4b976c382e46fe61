//! Events: the first time at which one of many functions of the state falls to zero.
//!
//! Each step is looked at in [`PARTS`] equal parts of the dense output. Only functions that can fall to zero in a part are examined in it. A
//! function falls in a part where it is negative at the end, or where it decreases at the beginning and increases at the
//! end, and its least value is negative. So near-grazing crossings are not missed as long as each function, not the least of
//! all, has at most one minimum in a part. The first crossing is then refined on states of full order, each by a step from the
//! beginning of the step, not on the dense output.

use super::{IntegrationError, Integrator, VectorField, golden};
use std::convert::Infallible;

/// Parts of a step.
const PARTS: usize = 8;

/// Steps of a golden section search for an extremum.
const SECTIONS: usize = 60;

/// Steps of the search for a root.
const MOST_ITERATIONS: usize = 100;

/// Crossings that the dense output puts within this part of a step's part are compared on states of full order.
const WINDOW: f64 = 1e-4;

/// A function of the state that is positive, however little, until its event.
pub trait Margin {
    /// Its value, where `at` gives the components of the state.
    fn value(&self, at: &dyn Fn(usize) -> f64) -> f64;
}

/// The first time at which a function falls to zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Crossing {
    /// When.
    pub time: f64,
    /// The state then: a function is zero or negative there.
    pub state: Vec<f64>,
}

/// One step forward, up to `until` at most, and the first crossing in it. `near(state, moved)` gives the functions that can fall while no component of the
/// state moves by more than `moved`: they are asked for at the beginning of each part of the step, where `moved` is twice the largest movement in any part. After a crossing, continue with
/// a new [`Integrator`] from its state.
///
/// # Errors
/// [`IntegrationError`].
pub fn step_to_crossing<M: Margin>(
    field: &mut impl VectorField,
    solution: &mut Integrator,
    until: f64,
    near: impl Fn(&[f64], &[f64]) -> Vec<M>,
) -> Result<Option<Crossing>, IntegrationError> {
    solution.step(field, until)?;
    let (from, to) = (solution.previous_time(), solution.time());
    let time = |k: usize| if k == PARTS { to } else { from + (to - from) * k as f64 / PARTS as f64 };
    let nodes: Vec<Vec<f64>> = (0..=PARTS).map(|k| solution.interpolate(field, time(k))).collect();
    let movement = |c: usize| nodes.windows(2).map(|pair| (pair[1][c] - pair[0][c]).abs()).fold(0.0, f64::max);
    let moved: Vec<f64> = (0..nodes[0].len()).map(|c| 2.0 * movement(c)).collect();
    Ok((0..PARTS).find_map(|k| {
        let margins = near(&nodes[k], &moved);
        in_part(field, solution, (time(k), time(k + 1)), &nodes[k + 1], &margins)
    }))
}

/// The first crossing in a part of the last step, whose dense output is known.
fn in_part(
    field: &mut impl VectorField,
    solution: &mut Integrator,
    (from, to): (f64, f64),
    end: &[f64],
    margins: &[impl Margin],
) -> Option<Crossing> {
    // By the dense output, with a time at which each is negative, or nearly so.
    let mut crossings = Vec::new();
    for margin in margins {
        let dense = |t: f64| margin.value(&|c| solution.component(c, t));
        let negative = if margin.value(&|c| end[c]) < 0.0 { Some(to) } else { dip(from, to, dense) };
        crossings.extend(negative.map(|negative| (root(from, negative, false, dense), negative, margin)));
    }
    crossings.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
    for (k, &(estimate, negative, _)) in crossings.iter().enumerate() {
        // Only those that fall about then: another one near zero would hide them in the least of all.
        let together = crossings[k..].iter().take_while(|(other, ..)| *other <= estimate + WINDOW * (to - from));
        let mut least = |t: f64| {
            let state = solution.within(field, t);
            together.clone().map(|(_, _, margin)| margin.value(&|c| state[c])).fold(f64::INFINITY, f64::min)
        };
        if least(negative) <= 0.0 {
            let time = root(from, negative, false, least);
            return Some(Crossing { time, state: solution.within(field, time) });
        }
    }
    None
}

/// Minima below this part of the values at both ends are looked at on states of full order.
const LOW: f64 = 1e-6;

/// Where a function that is positive at both ends may be negative in between: its minimum.
fn dip(a: f64, b: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    let width = (b - a) * 1e-3;
    let slope = |t: f64| f(t + width) - f(t - width);
    if slope(a) >= 0.0 || slope(b) <= 0.0 {
        return None;
    }
    let Ok((lowest, _)) = golden((a, b), SECTIONS, 0.0, |t| Ok::<f64, Infallible>(f(t)));
    (f(lowest) <= LOW * (f(a) + f(b))).then_some(lowest)
}

/// The place in `[a, b]` where a function gets the sign `positive`, by regula falsi with halved weights (Illinois): the later
/// end of the last bracket, so that the event has happened there.
pub fn root(mut a: f64, mut b: f64, positive: bool, mut f: impl FnMut(f64) -> f64) -> f64 {
    let sign = if positive { 1.0 } else { -1.0 };
    let (mut at_a, mut at_b) = ((sign * f(a)).min(0.0), sign * f(b));
    let mut side = 0;
    for _ in 0..MOST_ITERATIONS {
        if b - a <= 2.0 * f64::EPSILON * b.abs().max(a.abs()) || at_b <= 0.0 {
            break;
        }
        let weighted = b - at_b * (b - a) / (at_b - at_a);
        let middle = if weighted > a && weighted < b { weighted } else { a.midpoint(b) };
        if middle <= a || middle >= b {
            break;
        }
        let value = sign * f(middle);
        if value >= 0.0 {
            (b, at_b) = (middle, value);
            if side == 1 {
                at_a /= 2.0;
            }
            side = 1;
        } else {
            (a, at_a) = (middle, value);
            if side == -1 {
                at_b /= 2.0;
            }
            side = -1;
        }
    }
    b
}
