//! What can still happen on a network that stays: from certified bounds for all pairs at once.
//!
//! The steps of the argument are those of `notes/exact_flocks.md`.

use super::balls::Balls;
use super::links::Links;
use crate::averaging::hysteresis::Threshold;
use crate::averaging::{FlockError, Weights};
use arithmetic::Progress;
use num_traits::ToPrimitive;

/// What is certain about a network.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::averaging) struct Outlook {
    /// Steps in which no pair changes its status; `u64::MAX` for ever.
    pub quiet: u64,
    /// Pairs of different flocks of which a relative drift is certain.
    pub drifting: usize,
}

impl Outlook {
    pub fn is_steady(&self) -> bool {
        self.quiet == u64::MAX
    }
}

/// Relative rounding, generously.
const SLACK: f64 = 1e-12;

/// A connected part of the network and where it goes.
pub(super) struct Whole {
    pub members: Vec<usize>,
    /// The stationary mean of the velocities less the velocity of the first member, by coordinate.
    mean: Vec<f64>,
    mean_error: f64,
    /// No velocity is farther from the mean than this, ever.
    pub range: f64,
    /// No bird ever strays farther than twice this from a straight way at the mean velocity.
    pub stray: f64,
}

fn norm(x: &[f64]) -> f64 {
    x.iter().map(|a| a * a).sum::<f64>().sqrt()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The connected parts of a network.
pub(super) fn wholes<const L: usize>(balls: &Balls<L>, weights: &Weights) -> Vec<Whole> {
    let (component_of, components) = balls.links.components();
    let mut members = vec![Vec::new(); components];
    for (i, &component) in component_of.iter().enumerate() {
        members[component as usize].push(i);
    }
    members.into_iter().map(|members| whole(balls, weights, members)).collect()
}

fn whole<const L: usize>(balls: &Balls<L>, weights: &Weights, members: Vec<usize>) -> Whole {
    let dimension = balls.dimension();
    let (_, velocity_error) = balls.errors();
    let velocity_error = velocity_error * (dimension as f64).sqrt() * 2.0;
    if members.len() == 1 {
        let mean = vec![0.0; dimension];
        return Whole { members, mean, mean_error: velocity_error, range: 0.0, stray: 0.0 };
    }
    let reciprocal = |&i: &usize| {
        let c = weights.of(balls.links.degree(i), i).and_then(|c| c.to_f64()).unwrap_or(f64::NAN);
        1.0 / c
    };
    let reciprocals: Vec<f64> = members.iter().map(reciprocal).collect();
    let total: f64 = reciprocals.iter().sum();
    let first = members[0];
    let (mut mean, mut largest) = (vec![0.0; dimension], 0.0f64);
    let mut difference = vec![0.0; dimension];
    for (&i, r) in members.iter().zip(&reciprocals) {
        for k in 0..dimension {
            difference[k] = balls.velocity_difference(i, first, k);
            mean[k] += difference[k] * (r / total);
        }
        largest = largest.max(norm(&difference));
    }
    // Step 5: no velocity is farther from the first one than this, the mean neither.
    let range = 2.0 * largest * (1.0 + SLACK) + 2.0 * velocity_error;
    let paths = longest_path(&balls.links, &members) as f64;
    let stray = range * paths * total * total.sqrt() * 0.5 * (1.0 + SLACK);
    let mean_error = velocity_error + SLACK * largest;
    Whole { members, mean, mean_error, range, stray }
}

/// At least the length of the longest shortest path: twice the distance of the farthest from the first.
fn longest_path(links: &Links, members: &[usize]) -> usize {
    let mut seen = vec![false; links.order()];
    let (mut layer, mut depth) = (vec![members[0]], 0);
    seen[members[0]] = true;
    loop {
        let mut next = Vec::new();
        for &i in &layer {
            for &j in links.near(i) {
                if !std::mem::replace(&mut seen[j as usize], true) {
                    next.push(j as usize);
                }
            }
        }
        if next.is_empty() {
            return (2 * depth).min(members.len() - 1);
        }
        depth += 1;
        layer = next;
    }
}

/// What is certain from this state on.
pub(super) fn outlook<const L: usize>(
    balls: &Balls<L>,
    weights: &Weights,
    threshold: &Threshold,
    progress: &dyn Progress,
) -> Result<Outlook, FlockError> {
    let wholes = wholes(balls, weights);
    let mut all = Outlook { quiet: u64::MAX, drifting: 0 };
    for (f, a) in wholes.iter().enumerate() {
        progress.checkpoint()?;
        all.quiet = all.quiet.min(within(balls, a, threshold));
        for b in &wholes[..f] {
            let (quiet, drifts) = between(balls, a, b);
            all.quiet = all.quiet.min(quiet);
            all.drifting += if drifts { a.members.len() * b.members.len() } else { 0 };
        }
        if all.quiet == 0 {
            break;
        }
    }
    Ok(all)
}

/// For how long the pairs of one flock keep their status: for ever, or it is not certain for any step.
fn within<const L: usize>(balls: &Balls<L>, whole: &Whole, threshold: &Threshold) -> u64 {
    let (position_error, _) = balls.errors();
    let mut difference = vec![0.0; balls.dimension()];
    // An edge that is longer than 1 is held for good once no two velocities differ by the threshold.
    let held = threshold.log2_below().is_some_and(|limit| (2.0 * whole.range).log2() < limit as f64 - 1.0);
    for (place, &i) in whole.members.iter().enumerate() {
        let near = balls.links.near(i);
        for &j in &whole.members[..place] {
            for (k, x) in difference.iter_mut().enumerate() {
                *x = balls.position_difference(i, j, k);
            }
            let distance = norm(&difference);
            let error = SLACK * (1.0 + distance) + 4.0 * position_error * difference.len() as f64;
            let beyond = distance - 1.0;
            let certain = beyond.abs() > 4.0 * whole.stray * (1.0 + SLACK) + error;
            let long_edge = beyond > -error && near.contains(&(j as u32));
            let fixed = if long_edge { held } else { certain };
            if !fixed {
                return 0;
            }
        }
    }
    u64::MAX
}

/// For how long no pair of these flocks comes within distance 1, and whether a relative drift is certain.
fn between<const L: usize>(balls: &Balls<L>, a: &Whole, b: &Whole) -> (u64, bool) {
    let (position_error, _) = balls.errors();
    let dimension = balls.dimension();
    let velocity = |k: usize| balls.velocity_difference(a.members[0], b.members[0], k) + a.mean[k] - b.mean[k];
    let drift: Vec<f64> = (0..dimension).map(velocity).collect();
    let speed = norm(&drift);
    let size = speed + norm(&a.mean) + norm(&b.mean);
    let drift_error = a.mean_error + b.mean_error + SLACK * size;
    let drifts = speed > 1e5 * drift_error;
    let stray = 2.0 * (a.stray + b.stray) * (1.0 + SLACK);
    let mut quiet = u64::MAX;
    let mut place = vec![0.0; dimension];
    for &i in &a.members {
        for &j in &b.members {
            for (k, x) in place.iter_mut().enumerate() {
                *x = balls.position_difference(i, j, k);
            }
            let distance = norm(&place);
            let limit = 1.0 + stray + SLACK * distance + 4.0 * position_error * dimension as f64;
            quiet = quiet.min(apart(&place, &drift, distance, speed, limit, drift_error, drifts));
        }
    }
    (quiet, drifts)
}

/// The steps `s` for which `|place + s drift| > limit + s drift_error` is certain.
fn apart(place: &[f64], drift: &[f64], distance: f64, speed: f64, limit: f64, drift_error: f64, drifts: bool) -> u64 {
    let steps = |s: f64| if s > 0.0 { s as u64 } else { 0 };
    if !drifts {
        // At most this: nothing is certain about the direction. Never for ever, as a drift may be hidden.
        return steps((distance - limit) / (speed + drift_error) * (1.0 - SLACK)).min(u64::MAX - 1);
    }
    let along = dot(place, drift);
    let least = 1.0 - 1e-9;
    if along >= 0.0 {
        return if distance * least > limit { u64::MAX } else { 0 };
    }
    let nearest = -along / (speed * speed);
    let limit = limit + nearest * drift_error * 2.0;
    let across = (distance * distance - (along / speed).powi(2) - SLACK * distance * distance).max(0.0);
    if across.sqrt() * least > limit {
        return u64::MAX;
    }
    let half_way = (limit * limit - across).max(0.0).sqrt() / speed;
    steps((nearest - half_way) * (1.0 - SLACK) - SLACK * distance / speed - 1.0).min(u64::MAX - 1)
}

#[cfg(test)]
mod tests;
