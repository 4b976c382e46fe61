//! Events: the first time at which a function of time and state changes its sign.
//!
//! In each step the function is looked at in [`PARTS`] equal parts of the dense output. A part holds a crossing where the signs at its
//! ends differ, or where the function comes towards zero at its beginning and leaves it at its end: then its extremum is
//! sought, and if the sign differs there, the part has two crossings. So near-grazing crossings are not missed as long as the
//! function has at most one extremum in a part. Crossings are then refined on states of full order, each by a step
//! from the beginning of the step, not on the dense output.

use super::{IntegrationError, Integrator, VectorField};

/// Parts of a step.
const PARTS: usize = 8;

/// Steps of a golden section search for an extremum.
const SECTIONS: usize = 60;

/// Steps of the search for a root.
const MOST_ITERATIONS: usize = 100;

/// A crossing of zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Crossing {
    /// When.
    pub time: f64,
    /// The state then.
    pub state: Vec<f64>,
    /// Whether the function goes from negative to positive.
    pub rising: bool,
}

/// Steps forward until `event` crosses zero or `until` is reached. On a crossing, continue with a new [`Integrator`] from its state; a
/// zero right at the start is not a crossing.
///
/// # Errors
/// [`IntegrationError`].
pub fn next_crossing(
    field: &mut impl VectorField,
    solution: &mut Integrator,
    until: f64,
    mut event: impl FnMut(f64, &[f64]) -> f64,
) -> Result<Option<Crossing>, IntegrationError> {
    // The sign on the way; none before the first step, and as long as the function stays at zero.
    let start = event(solution.time(), solution.state());
    let mut sign = None;
    let mut first = true;
    while solution.time() < until {
        solution.step(field, until)?;
        let (from, to) = (solution.previous_time(), solution.time());
        let time = |k: usize| if k == PARTS { to } else { from + (to - from) * k as f64 / PARTS as f64 };
        let values: Vec<f64> = (0..=PARTS).map(time).map(|t| event(t, &solution.interpolate(field, t))).collect();
        let size = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        if std::mem::take(&mut first) {
            // At a zero, the sign just after it.
            let after = from + (time(1) - from) * 1e-6;
            let mut later = || event(after, &solution.interpolate(field, after)) - start;
            let value = if start.abs() > 1e-12 * size { start } else { later() };
            sign = (value != 0.0).then_some(value > 0.0);
        }
        for k in 0..PARTS {
            let (a, b) = (time(k), time(k + 1));
            let Some(positive) = sign else {
                // Still at zero: the next sign counts from the end of the part.
                sign = (values[k + 1] != 0.0).then_some(values[k + 1] > 0.0);
                continue;
            };
            let turned = |x: f64| x != 0.0 && (x > 0.0) != positive;
            let end = if turned(values[k + 1]) {
                Some(b)
            } else {
                let slope =
                    |t: f64, solution: &mut Integrator, field: &mut _, event: &mut dyn FnMut(f64, &[f64]) -> f64| {
                        let width = (b - a) * 1e-3;
                        let ahead = event(t + width, &solution.interpolate(field, t + width));
                        ahead - event(t - width, &solution.interpolate(field, t - width))
                    };
                let towards = if positive { -1.0 } else { 1.0 };
                let comes = slope(a, solution, field, &mut event) * towards > 0.0;
                let leaves = slope(b, solution, field, &mut event) * towards < 0.0;
                // The extremum by the dense output, its sign by a step of full order.
                if comes && leaves {
                    let nearest = golden(a, b, |t| -towards * event(t, &solution.interpolate(field, t)));
                    turned(event(nearest, &solution.within(field, nearest))).then_some(nearest)
                } else {
                    None
                }
            };
            if let Some(end) = end {
                let value = |t: f64| event(t, &solution.within(field, t));
                let time = root(a, end, !positive, value);
                let state = solution.within(field, time);
                return Ok(Some(Crossing { time, state, rising: !positive }));
            }
        }
    }
    Ok(None)
}

/// The place of the minimum of a function with one.
fn golden(mut a: f64, mut b: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let ratio = (5f64.sqrt() - 1.0) / 2.0;
    let (mut c, mut d) = (b - ratio * (b - a), a + ratio * (b - a));
    let (mut at_c, mut at_d) = (f(c), f(d));
    for _ in 0..SECTIONS {
        if at_c < at_d {
            (b, d, at_d) = (d, c, at_c);
            c = b - ratio * (b - a);
            at_c = f(c);
        } else {
            (a, c, at_c) = (c, d, at_d);
            d = a + ratio * (b - a);
            at_d = f(d);
        }
    }
    if at_c < at_d { c } else { d }
}

/// The place in `[a, b]` where a function gets the sign `positive`, by regula falsi with halved weights (Illinois): the later
/// end of the last bracket, so that the event has happened there.
pub(crate) fn root(mut a: f64, mut b: f64, positive: bool, mut f: impl FnMut(f64) -> f64) -> f64 {
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
