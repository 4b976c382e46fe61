//! The way of one flock on a network that stays, in double precision with bounds: as far as nothing can change in it.
//!
//! With `s` steps from now `x_i - x_j = A - z_i(s) + z_j(s)`, where `A` is the difference of the two in the end and `z(s) = P^s Gamma u`
//! (`notes/exact_flocks.md`). Only `z` is stepped; it dies out, and pairs that are farther from distance 1 in the end than it can make up for
//! are not looked at any more.

use super::stride::SHORTEST_STRIDE;
use super::wholes::{Part, SLACK, Whole, diameter, norm};
use crate::averaging::boxes;
use arithmetic::{Cancelled, Progress};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// What becomes of the pairs of a flock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Certain {
    /// None changes its status in so many steps; later one may.
    For(u64),
    /// None ever does; this was looked at for so many steps.
    Ever(u64),
}

/// What a look at a pair shows.
enum Look {
    /// It may have changed its status.
    Doubt,
    /// It has its status, and keeps it before so many steps.
    Again(u64),
    /// It keeps it for ever.
    Never,
}

/// A flock on its way.
pub(super) struct Ahead<'a> {
    pub(super) part: &'a Part,
    pub(super) dimension: usize,
    /// Where the members tend to, less where the first one does.
    ends: Vec<f64>,
    /// What is left of the way.
    pub(super) rest: Vec<f64>,
    next: Vec<f64>,
    /// Of a difference of two positions, in the end and on the way.
    pub(super) error: f64,
    /// The velocities, measured now and then, have had this length at most.
    speed: f64,
    /// The same of the changes of velocities in a step.
    change: f64,
    /// The error when they were measured.
    measured: f64,
    /// Of differences in a step, over the largest one.
    pub(super) rounding: f64,
    /// No number of the rest is larger.
    pub(super) largest: f64,
    pub(super) steps: u64,
    /// What leaps may still add to the error.
    pub(super) spare: f64,
    /// No leap before this.
    pub(super) patient: u64,
    /// Whether joined pairs are looked at.
    with_edges: bool,
    /// The next time at which to look at a pair; none is due before `until` that is not there.
    due: BinaryHeap<Reverse<(u64, u32, u32)>>,
    until: u64,
}

/// Pairs are watched that may get to distance 1 from as far as this.
const NEAR: f64 = 0.25;

/// Members whose averages cost as much as a look at a pair.
const SHARE: usize = 8;

/// Steps between two measurements of how fast all move: so many, and a part of those made.
const MEASURED: u64 = 16;

impl<'a> Ahead<'a> {
    /// The flock of these positions (coordinate `k` of `x_i - x_j` by members, up to an error in each).
    pub fn new(
        whole: &'a Whole,
        difference: impl Fn(usize, usize, usize) -> f64,
        error: f64,
        dimension: usize,
    ) -> Self {
        let mut ends = whole.rest.clone();
        for (place, end) in ends.chunks_mut(dimension).enumerate() {
            for (k, x) in end.iter_mut().enumerate() {
                *x += difference(whole.members[place], whole.members[0], k) - whole.rest[k];
            }
        }
        let largest = ends.iter().chain(&whole.rest).fold(1.0f64, |most, x| most.max(x.abs()));
        let root = (dimension as f64).sqrt();
        let error = 4.0 * whole.rest_error + (4.0 * error + SLACK * largest) * root;
        let neighbours = whole.part.near.iter().map(Vec::len).max().unwrap_or(0) as f64;
        let mut ahead = Ahead {
            part: &whole.part,
            dimension,
            ends,
            next: whole.rest.clone(),
            rest: whole.rest.clone(),
            error,
            speed: 0.0,
            change: 0.0,
            measured: error,
            // Of the difference of two averages of numbers up to 1, each with so many roundings.
            rounding: f64::EPSILON * (4.0 * neighbours + 32.0) * root,
            largest: whole.rest.iter().fold(0.0f64, |most, z| most.max(z.abs())),
            steps: 0,
            spare: error,
            patient: 0,
            with_edges: true,
            due: BinaryHeap::new(),
            until: 0,
        };
        ahead.measure();
        ahead.watch();
        ahead
    }

    /// The same without a look at joined pairs, which stay so.
    pub fn without_edges(mut self) -> Self {
        self.with_edges = false;
        self.watch();
        self
    }

    /// Whether all joined pairs are certainly below distance 1.
    pub fn edges_are_short(&self) -> bool {
        let edges = self.part.near.iter().enumerate().flat_map(|(i, near)| near.iter().map(move |&j| (i as u32, j)));
        edges.into_iter().all(|pair| self.distances(pair).1 < 1.0 - self.error)
    }

    /// Lists the pairs to look at: all that may ever be at distance 1, where not much of the way is left; otherwise those that may be for
    /// some time.
    fn watch(&mut self) {
        let stray = self.stray();
        let last = stray <= NEAR;
        let steps = (NEAR / (2.0 * self.speed) * (1.0 - 1e-9)).max(1.0) as u64;
        let width = self.error + if last { stray } else { NEAR.max(2.0 * self.speed * steps as f64) };
        let now: Vec<f64> = self.ends.iter().zip(&self.rest).map(|(end, rest)| end - rest).collect();
        let tree = boxes::of_points(
            self.dimension,
            if last { &self.ends } else { &now },
            (0..self.part.near.len() as u32).collect(),
        );
        let mut list = Vec::new();
        tree.near_pairs((1.0 + width) * (1.0 + SLACK), |i, j| {
            let (end, now) = self.distances((i, j));
            let far = ((if last { end } else { now }) - 1.0).abs() > width * (1.0 + SLACK);
            if !far && (self.with_edges || self.part.near[i as usize].binary_search(&j).is_err()) {
                list.push(Reverse((self.steps, i.min(j), i.max(j))));
            }
        });
        // Strides may add a part of what the closest of them leaves.
        let closest = list.iter().map(|&Reverse((_, i, j))| (self.distances((i, j)).0 - 1.0).abs());
        self.spare = self.spare.max((closest.fold(NEAR, f64::min) - self.error) / 8.0);
        self.due = list.into();
        self.until = if last { u64::MAX } else { self.steps.saturating_add(steps) };
    }

    /// No difference of two positions differs more than this from the one in the end, now and later.
    fn stray(&self) -> f64 {
        diameter(&self.rest, self.dimension) * (1.0 + SLACK) + self.error
    }

    /// Goes on to this step, or until a pair may have changed its status.
    pub fn go(&mut self, until: u64, progress: &dyn Progress) -> Result<Certain, Cancelled> {
        let mut stray = self.stray();
        let mut measured = self.steps + MEASURED;
        loop {
            if let Some(steps) = self.look_at_due(stray) {
                return Ok(Certain::For(steps));
            }
            if self.due.is_empty() && self.until == u64::MAX {
                return Ok(Certain::Ever(self.steps));
            }
            if self.steps >= until {
                return Ok(Certain::For(self.steps));
            }
            progress.checkpoint()?;
            let due = self.due.peek().map_or(u64::MAX, |&Reverse((time, ..))| time);
            let free = due.min(until).min(self.until) - self.steps;
            if self.steps >= self.patient && free >= SHORTEST_STRIDE && self.stride(free, progress)? {
                measured = self.steps;
            } else {
                self.step();
            }
            if self.steps >= measured {
                self.measure();
                stray = self.stray();
                measured = self.steps + MEASURED + self.steps / 16;
            }
            if self.steps >= self.until {
                self.measure();
                self.watch();
                stray = self.stray();
            }
        }
    }

    /// Looks at the pairs that are due; where one may have changed its status, the steps before that. Some that are due soon are looked at with
    /// them, about as many as cost a step, so that more steps come between two looks.
    fn look_at_due(&mut self, stray: f64) -> Option<u64> {
        if self.due.peek().is_none_or(|&Reverse((time, ..))| time > self.steps) {
            return None;
        }
        let mut again = Vec::new();
        while let Some(&Reverse((time, i, j))) = self.due.peek()
            && (time <= self.steps || again.len() <= self.part.near.len() / SHARE)
        {
            match self.look((i, j), stray) {
                Look::Doubt => return Some(self.steps.saturating_sub(1)),
                Look::Again(steps) => again.push(Reverse((self.steps.saturating_add(steps), i, j))),
                Look::Never => {}
            }
            self.due.pop();
        }
        self.due.extend(again);
        None
    }

    /// Whether a pair has its status still, and when that could next be otherwise.
    fn look(&self, (i, j): (u32, u32), stray: f64) -> Look {
        let (end, now) = self.distances((i, j));
        if (end - 1.0).abs() > stray + self.error {
            return Look::Never;
        }
        let gap = (now - 1.0).abs() - self.error;
        let joined = self.part.near[i as usize].binary_search(&j).is_ok();
        if gap.is_nan() || gap <= 0.0 || (now < 1.0) != joined {
            return Look::Doubt;
        }
        // In s steps the distance changes by at most 2 s times the speed of all. At the speed of now its gap grows by s rate - s^2 turn, where a
        // distance below 1 turns as on a straight way that passes by; what the speed changes by makes at most s^2 change of a difference.
        let (mut along, mut squared) = (0.0, 0.0);
        for k in 0..self.dimension {
            let moved = self.pull(i as usize, k) - self.pull(j as usize, k);
            let (end, rest) = self.coordinate((i, j), k);
            along += moved * (end - rest);
            squared += moved * moved;
        }
        let (doubt, later) = (2.0 * self.pull_error(), 2.0 * (self.error - self.measured));
        let speed = squared.sqrt() + doubt;
        let rate = along / now;
        let (away, bend) = match joined {
            _ if now < NEAR => (-speed, 0.0),
            true => (-rate - doubt - SLACK * speed, speed * speed / (2.0 * now)),
            false => (rate - doubt - SLACK * speed, 0.0),
        };
        let turn = self.change + 2.0 * later + bend;
        let steady = gap / (2.0 * (self.speed + later));
        let steps = steady.max(first_contact(gap, away, turn)) * (1.0 - 1e-9);
        // At the next step it is looked at at the latest.
        Look::Again((steps as u64).max(1))
    }

    /// The distance of two in the end, and now.
    fn distances(&self, pair: (u32, u32)) -> (f64, f64) {
        let (mut end, mut now) = (0.0, 0.0);
        for k in 0..self.dimension {
            let (last, rest) = self.coordinate(pair, k);
            end += last * last;
            now += (last - rest) * (last - rest);
        }
        (end.sqrt(), now.sqrt())
    }

    /// Coordinate `k` of the difference of two in the end, and of what is left of it.
    fn coordinate(&self, (i, j): (u32, u32), k: usize) -> (f64, f64) {
        let (a, b) = (i as usize * self.dimension + k, j as usize * self.dimension + k);
        (self.ends[a] - self.ends[b], self.rest[a] - self.rest[b])
    }

    /// Coordinate `k` of `(I - P) z` for a member: its velocity, less the mean.
    fn pull(&self, i: usize, k: usize) -> f64 {
        pull(self.part, &self.rest, self.dimension, i, k)
    }

    /// What `(I - P) z` errs by for the numbers that stand for `z`. What these are off by counts once, as it is averaged as they are.
    fn pull_error(&self) -> f64 {
        2.0 * self.rounding * self.largest
    }

    fn measure(&mut self) {
        let d = self.dimension;
        let of = |list: &[f64]| -> Vec<f64> {
            (0..list.len()).map(|place| pull(self.part, list, d, place / d, place % d)).collect()
        };
        let most = |list: &[f64]| list.chunks(d).fold(0.0f64, |most, v| most.max(norm(v)));
        let speeds = of(&self.rest);
        let changes = of(&speeds);
        (self.speed, self.change) = (most(&speeds) + self.pull_error(), most(&changes) + 2.0 * self.pull_error());
        self.measured = self.error;
    }

    pub(super) fn step(&mut self) {
        let (largest, steepest) = average(self.part, self.dimension, &self.rest, &mut self.next);
        std::mem::swap(&mut self.rest, &mut self.next);
        self.error += self.rounding * steepest + 2.0 * f64::EPSILON * (self.dimension as f64).sqrt() * largest;
        self.largest = largest;
        self.steps += 1;
    }
}

/// When a gap that grows by `s away - s^2 turn` in `s` steps may first be closed.
fn first_contact(gap: f64, away: f64, turn: f64) -> f64 {
    let root = (away * away + 4.0 * turn * gap).sqrt();
    if away > 0.0 { (away + root) / (2.0 * turn) } else { 2.0 * gap / (root - away) }
}

/// Writes the averages of these numbers; the largest of the numbers, and of the differences of neighbours.
pub(super) fn average(part: &Part, d: usize, from: &[f64], to: &mut [f64]) -> (f64, f64) {
    let (mut largest, mut steepest) = (0.0f64, 0.0f64);
    for (i, (near, r)) in part.near.iter().zip(&part.reciprocals).enumerate() {
        for k in 0..d {
            let own = from[i * d + k];
            let mut sum = 0.0;
            for &j in near {
                let difference = from[j as usize * d + k] - own;
                sum += difference;
                steepest = steepest.max(difference.abs());
            }
            to[i * d + k] = own + sum / r;
            largest = largest.max(own.abs());
        }
    }
    (largest, steepest)
}

/// Coordinate `k` of `c_i sum_j (z_i - z_j)`.
fn pull(part: &Part, list: &[f64], d: usize, i: usize, k: usize) -> f64 {
    let own = list[i * d + k];
    part.near[i].iter().map(|&j| own - list[j as usize * d + k]).sum::<f64>() / part.reciprocals[i]
}
