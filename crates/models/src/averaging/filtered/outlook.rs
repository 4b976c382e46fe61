//! What can still happen on a network that stays: from certified bounds for all pairs at once.
//!
//! The steps of the argument are those of `notes/exact_flocks.md`.

use super::ahead::{Ahead, Certain};
use super::balls::Balls;
use super::classes::Classes;
use super::watch::quiet_steps;
use super::wholes::{SLACK, Whole, norm};
use crate::averaging::boxes::{Between, Boxes};
use crate::averaging::hysteresis::Threshold;
use crate::averaging::weights::FlockError;
use arithmetic::{Cancelled, Progress};
use rayon::prelude::*;

/// What is certain about a network.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::averaging) struct Outlook {
    /// Steps in which no pair changes its status; `u64::MAX` for ever.
    pub quiet: u64,
    /// Where that is for ever, pairs of different flocks of which a relative drift is certain.
    pub drifting: usize,
    /// Steps that had to be looked at for that.
    pub looked: u64,
}

impl Outlook {
    pub fn is_steady(&self) -> bool {
        self.quiet == u64::MAX
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Steps that flocks are first followed; then four times as many.
const FIRST: u64 = 64;

/// What is certain from this state on, as far as following the flocks for so many steps at most shows.
pub(super) fn outlook<const L: usize>(
    balls: &Balls<L>,
    threshold: &Threshold,
    classes: &Classes,
    longest: u64,
    progress: &dyn Progress,
) -> Result<Outlook, FlockError> {
    let wholes = balls.wholes();
    let around = Around::new(balls, &wholes, classes);
    let (mut quiet, mut looked) = (around.quiet(progress)?, 0);
    let mut flocks = Vec::new();
    for (number, whole) in wholes.iter().enumerate().filter(|(_, whole)| whole.members.len() > 1) {
        // Who moves alike keeps all distances.
        if !around.is_still(number) {
            match within(balls, whole, threshold) {
                Some(ahead) => flocks.push(ahead),
                None => quiet = 0,
            }
        }
    }
    let mut until = FIRST.min(longest);
    while !flocks.is_empty() && quiet > 0 {
        let most = until.min(quiet);
        let certain: Vec<Certain> =
            flocks.par_iter_mut().map(|flock| flock.go(most, progress)).collect::<Result<_, Cancelled>>()?;
        let mut rest = certain.iter();
        flocks.retain(|_| !matches!(rest.next(), Some(Certain::Ever(_))));
        for certain in certain {
            match certain {
                Certain::For(steps) => quiet = if steps < most { quiet.min(steps) } else { quiet },
                Certain::Ever(steps) => looked = looked.max(steps),
            }
        }
        if until >= quiet {
            break;
        }
        if until >= longest && !flocks.is_empty() {
            quiet = until;
            break;
        }
        until = until.saturating_mul(4).min(longest);
    }
    let drifting = if quiet == u64::MAX { around.drifting() } else { 0 };
    Ok(Outlook { quiet, drifting, looked })
}

/// The pairs of one flock, where it is certain that all keep their status at least for now.
fn within<'a, const L: usize>(balls: &'a Balls<L>, whole: &'a Whole, threshold: &Threshold) -> Option<Ahead<'a>> {
    let (position_error, _) = balls.errors();
    let ahead = Ahead::new(whole, |i, j, k| balls.position_difference(i, j, k), position_error, balls.dimension());
    if threshold.holds_nothing() {
        return Some(ahead);
    }
    // An edge that is longer than 1 is held for good once no two velocities differ by the threshold.
    let held = threshold.log2_below().is_some_and(|limit| (2.0 * whole.range).log2() < limit as f64 - 1.0);
    if held { Some(ahead.without_edges()) } else { ahead.edges_are_short().then_some(ahead) }
}

/// All flocks beside one another.
struct Around<'a, const L: usize> {
    balls: &'a Balls<L>,
    wholes: &'a [Whole],
    /// The flock of each bird, and its place there.
    places: Vec<(u32, u32)>,
    /// By flock: the velocity of its first member in double precision, and its length with that of the mean less it.
    velocities: Vec<Vec<f64>>,
    sizes: Vec<f64>,
    /// By flock: the class of all its velocities, where they are known to agree.
    still: Vec<Option<u64>>,
}

impl<'a, const L: usize> Around<'a, L> {
    fn new(balls: &'a Balls<L>, wholes: &'a [Whole], classes: &Classes) -> Self {
        let (_, velocities) = balls.floats();
        let d = balls.dimension();
        let mut places = vec![(0, 0); balls.network.order()];
        for (number, whole) in wholes.iter().enumerate() {
            for (place, &i) in whole.members.iter().enumerate() {
                places[i] = (number as u32, place as u32);
            }
        }
        let first = |whole: &Whole| velocities[whole.members[0] * d..][..d].to_vec();
        let velocities: Vec<Vec<f64>> = wholes.iter().map(first).collect();
        let sizes = velocities.iter().zip(wholes).map(|(v, whole)| norm(v) + norm(&whole.mean)).collect();
        let still = wholes.iter().map(|whole| classes.common(&whole.members)).collect();
        Around { balls, wholes, places, velocities, sizes, still }
    }

    fn is_still(&self, flock: usize) -> bool {
        self.still[flock].is_some()
    }

    /// Whether the relative drift of two flocks is known to be zero.
    fn move_alike(&self, f: usize, g: usize) -> bool {
        self.still[f].is_some() && self.still[f] == self.still[g]
    }

    /// Drift of one flock less that of the other, its error, and whether it is certain that there is one.
    fn drift(&self, f: usize, g: usize) -> (Vec<f64>, f64, bool) {
        let (a, b) = (&self.wholes[f], &self.wholes[g]);
        let velocity = |k: usize| self.balls.velocity_difference(a.members[0], b.members[0], k) + a.mean[k] - b.mean[k];
        let drift: Vec<f64> = (0..self.balls.dimension()).map(velocity).collect();
        let speed = norm(&drift);
        let error = a.mean_error + b.mean_error + SLACK * (speed + norm(&a.mean) + norm(&b.mean));
        let drifts = speed > 1e5 * error;
        (drift, error, drifts)
    }

    /// Pairs of birds of different flocks of which a relative drift is certain.
    fn drifting(&self) -> usize {
        // Flocks whose first coordinates differ by more than this certainly drift.
        let most = self.wholes.iter().zip(&self.sizes).map(|(w, size)| w.mean_error + 4.0 * SLACK * size);
        let most = 1e5 * 2.0 * most.fold(0.0, f64::max) * (1.0 + SLACK);
        let mut order: Vec<(f64, usize)> =
            (0..self.wholes.len()).map(|f| (self.velocities[f][0] + self.wholes[f].mean[0], f)).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0));
        let birds = |f: usize| self.wholes[f].members.len();
        let (mut before, mut all, mut start) = (0, 0, 0);
        for (place, &(v, f)) in order.iter().enumerate() {
            while v - order[start].0 > most {
                start += 1;
            }
            let alike = order[start..place].iter().filter(|&&(_, g)| !self.drift(f.max(g), f.min(g)).2);
            all += birds(f) * (before - alike.map(|&(_, g)| birds(g)).sum::<usize>());
            before += birds(f);
        }
        all
    }

    /// For how long no pair of different flocks comes within distance 1.
    fn quiet(&self, progress: &dyn Progress) -> Result<u64, Cancelled> {
        if self.wholes.len() < 2 {
            return Ok(u64::MAX);
        }
        let boxes = self.boxes();
        let share_one = |(a, b): (usize, usize)| {
            let flock = |bird: &u32| self.places[*bird as usize].0;
            let first = flock(&boxes.birds(a)[0]);
            boxes.birds(a).iter().chain(boxes.birds(b)).all(|bird| flock(bird) == first)
        };
        let quiet = std::cell::Cell::new(u64::MAX);
        let (_, velocity_error) = self.balls.errors();
        let mut stopped = Ok(());
        boxes.pairs(
            |places| {
                if stopped.is_err() {
                    return true;
                }
                stopped = progress.checkpoint();
                // Along the ways on which the flocks are now, and along those that they tend to.
                let earliest = boxes.earliest(places, (0, 1), 1.0).max(boxes.earliest(places, (2, 3), 1.0));
                // What comes late comes, however late it is.
                let is_later = (earliest as u64).min(u64::MAX - 1) >= quiet.get();
                earliest == f64::INFINITY || is_later || share_one(places)
            },
            |i, j| {
                if self.places[i as usize].0 != self.places[j as usize].0 {
                    quiet.set(quiet.get().min(self.pair((i.max(j), i.min(j)), velocity_error)));
                }
            },
        );
        stopped.map(|()| quiet.get())
    }

    /// The birds in boxes: where they are and the velocities of their flocks, where they tend to and how fast they go there.
    fn boxes(&self) -> Boxes {
        let d = self.balls.dimension();
        let (positions, velocities) = self.balls.floats();
        let (position_error, velocity_error) = self.balls.errors();
        let largest = |list: &[f64]| list.iter().fold(0.0f64, |most, x| most.max(x.abs())) * 4.0 * SLACK;
        let (place_slack, speed_slack) =
            (largest(&positions) + 4.0 * position_error + 4.0 * SLACK, largest(&velocities) + 4.0 * velocity_error);
        let count = positions.len();
        let empty = || [vec![0.0; count], vec![0.0; count]];
        let [mut now, mut speeds, mut ends, mut drifts] = [empty(), empty(), empty(), empty()];
        for (whole, v) in self.wholes.iter().zip(&self.velocities) {
            for k in 0..d {
                let of = |i: &usize| velocities[i * d + k];
                let slowest = whole.members.iter().map(of).fold(f64::INFINITY, f64::min);
                let fastest = whole.members.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
                let mean = v[k] + whole.mean[k];
                for (place, &i) in whole.members.iter().enumerate() {
                    let end = positions[i * d + k] + whole.rest[place * d + k];
                    let (stray, error) =
                        (whole.stray + 2.0 * whole.rest_error, whole.mean_error + 4.0 * SLACK * mean.abs());
                    for (list, at, off) in [
                        (&mut now, positions[i * d + k], place_slack),
                        (&mut ends, end, stray + place_slack),
                        (&mut drifts, mean, error + speed_slack),
                    ] {
                        (list[0][i * d + k], list[1][i * d + k]) = (at - off, at + off);
                    }
                    (speeds[0][i * d + k], speeds[1][i * d + k]) = (slowest - speed_slack, fastest + speed_slack);
                }
            }
        }
        let given = [&now, &speeds, &ends, &drifts].map(|[lowest, highest]| Between { lowest, highest });
        Boxes::new(d, &given, (0..self.places.len() as u32).collect())
    }

    /// For how long two birds of different flocks do not come within distance 1: by where they tend to, or by where they are.
    fn pair(&self, (i, j): (u32, u32), velocity_error: f64) -> u64 {
        let ((f, p), (g, q)) = (self.places[i as usize], self.places[j as usize]);
        let (f, g) = (f as usize, g as usize);
        let (a, b) = (&self.wholes[f], &self.wholes[g]);
        let d = self.balls.dimension();
        let (position_error, _) = self.balls.errors();
        let (i, j) = (i as usize, j as usize);
        let now: Vec<f64> = (0..d).map(|k| self.balls.position_difference(i, j, k)).collect();
        let error = SLACK * (1.0 + norm(&now)) + 4.0 * position_error * d as f64;
        let rest = |k: usize| a.rest[p as usize * d + k] - b.rest[q as usize * d + k];
        let place: Vec<f64> = now.iter().enumerate().map(|(k, x)| x + rest(k)).collect();
        let (distance, stray) = (norm(&place), a.stray + b.stray + 2.0 * (a.rest_error + b.rest_error));
        let limit = 1.0 + stray * (1.0 + SLACK) + error + SLACK * distance;
        if self.move_alike(f, g) {
            return if norm(&now) - 1.0 > 2.0 * error { u64::MAX } else { 0 };
        }
        let (drift, drift_error, drifts) = self.drift(f, g);
        let in_the_end = apart(&place, &drift, distance, norm(&drift), limit, drift_error, drifts);
        if in_the_end == u64::MAX || stray == 0.0 {
            return in_the_end;
        }
        let moved: Vec<f64> = (0..d).map(|k| self.balls.velocity_difference(i, j, k)).collect();
        let turn = 2.0 * (a.range + b.range) + 4.0 * velocity_error * d as f64;
        in_the_end.max(quiet_steps(&now, &moved, false, turn, error).min(u64::MAX - 1))
    }
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
