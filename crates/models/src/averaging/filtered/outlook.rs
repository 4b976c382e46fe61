//! What can still happen on a network that stays: from certified bounds for all pairs at once.
//!
//! The steps of the argument are those of `notes/exact_flocks.md`.

use super::balls::Balls;
use super::wholes::{SLACK, Whole, norm};
use crate::averaging::hysteresis::Threshold;
use crate::averaging::weights::FlockError;
use arithmetic::Progress;

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

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// What is certain from this state on.
pub(super) fn outlook<const L: usize>(
    balls: &Balls<L>,
    threshold: &Threshold,
    progress: &dyn Progress,
) -> Result<Outlook, FlockError> {
    let wholes = balls.wholes();
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
