//! The nearest of each agent: when two others change places in the order of their distances from it.
//!
//! Whether they do depends on three series, so a look at one agent covers all that it senses and all others that can come as near before one of these
//! series ends; it is made anew as soon as one of them is.

use super::cells::{Cells, Place};
use super::next::Kind;
use super::path::SQUARE;
use super::watch::ROUNDING;
use super::{Agent, IndividualFlock, IndividualLaw, Moving, Pair, Switch};
use crate::{FollowError, first_downcrossing};
use std::collections::BTreeSet;

/// Fences wider than so many times the scale are listed; the others are found by cells.
const WIDE: f64 = 3.0;

/// The cells are made anew where fences are on average so many times as wide as the scale, or less by the same factor.
const RESCALED: f64 = 2.0;

/// Whom a look at an agent covers.
#[derive(Debug, Clone, Copy, Default)]
struct Fence {
    /// Where the agent was then.
    centre: [f64; 2],
    /// Others that do not come nearer than this to the centre have no part in it.
    radius: f64,
    looks: u32,
    /// Who changes places next: one that is sensed, and one that is not.
    next: Pair,
}

/// The looks at all agents.
#[derive(Debug, Clone)]
pub struct Ranks {
    fences: Vec<Fence>,
    wide: BTreeSet<usize>,
    /// No agent in force gets farther on its series.
    farthest: f64,
    /// The round in which an agent was asked last.
    asked: Vec<u64>,
    round: u64,
    /// Looks until the scale is thought over.
    left: usize,
}

impl Ranks {
    pub fn new(count: usize) -> Self {
        let (fences, asked) = (vec![Fence::default(); count], vec![0; count]);
        Ranks { fences, wide: BTreeSet::new(), farthest: 0.0, asked, round: 0, left: count }
    }

    /// How often an agent was looked at.
    pub fn looks(&self, agent: usize) -> u32 {
        self.fences[agent].looks
    }

    /// Whether an agent is asked for the first time in this round.
    fn ask(&mut self, agent: usize) -> bool {
        std::mem::replace(&mut self.asked[agent], self.round) != self.round
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (x, y) = (a[0] - b[0], a[1] - b[1]);
    (x * x + y * y).sqrt()
}

/// The mean distance of the farthest that an agent senses; 1 where that is no positive number.
pub fn typical<const F: usize>(start: &[Moving<f64, F>], arcs: &[Pair]) -> f64 {
    let mut far = vec![0.0f64; start.len()];
    for &(k, j) in arcs {
        far[k] = far[k].max(distance(start[k].position, start[j].position));
    }
    let mean = far.iter().sum::<f64>() / far.len() as f64;
    if mean > 0.0 && mean.is_finite() { mean } else { 1.0 }
}

impl<L: IndividualLaw<F, M>, const F: usize, const M: usize> IndividualFlock<L, F, M> {
    /// Looks at all agents in whose nearest some that have new series may have a part.
    pub(super) fn watch_ranks(&mut self, time: f64, changed: &[usize]) {
        let reach = changed.iter().map(|&agent| self.agents[agent].reach);
        self.ranks.farthest = reach.fold(self.ranks.farthest, f64::max);
        self.ranks.round += 1;
        let mut asked = Vec::new();
        let wide: Vec<usize> = self.ranks.wide.iter().copied().collect();
        for &agent in changed {
            let ranks = &mut self.ranks;
            let sensing = self.agents[agent].observers.iter().copied().chain([agent]);
            asked.extend(sensing.filter(|&other| ranks.ask(other)));
            let (point, reach) = (self.agents[agent].path.point(), self.agents[agent].reach);
            let far = WIDE * self.scale + reach + ranks.farthest;
            let near = self.cells.near(point, far).map(|place| place.agent);
            for other in near.chain(wide.iter().copied()) {
                let fence = &ranks.fences[other];
                if distance(point, fence.centre) <= fence.radius + reach && ranks.ask(other) {
                    asked.push(other);
                }
            }
        }
        asked.iter().for_each(|&agent| self.watch_rank(time, agent));
        self.ranks.left = self.ranks.left.saturating_sub(asked.len());
        if self.ranks.left == 0 {
            self.rescale();
        }
    }

    /// Looks when the nearest of an agent change, as long as the series of those that have a part last.
    fn watch_rank(&mut self, time: f64, agent: usize) {
        let own = &self.agents[agent];
        let path = own.path.after(time - own.from);
        let point = path.point();
        // From the point where its series begins the agent gets `reach` far, from where it is now twice that.
        let moved = 2.0 * own.reach;
        let far_off = |other: &Agent<F>| distance(point, other.path.point()) + other.reach;
        let inner: Vec<(usize, f64)> =
            own.neighbours.iter().map(|one| (one.agent, far_off(&self.agents[one.agent]))).collect();
        let far = inner.iter().fold(0.0, |far: f64, (_, off)| far.max(*off));
        let rounding = 1e-9 * (far + self.scale);
        let slack = 4.0 * ROUNDING * far * (far + point[0].abs() + point[1].abs());
        let mut next: Option<(f64, Pair)> = None;
        let mut squares: Vec<Option<[f64; SQUARE]>> = vec![None; inner.len()];
        let square = |other: &Agent<F>| path.squared_distance(&other.path.after(time - other.from));
        for place in self.cells.near(point, far + 2.0 * moved + rounding + self.ranks.farthest) {
            let near = distance(point, place.anchor) - place.reach - 2.0 * moved - rounding;
            if near > far || place.agent == agent || own.place(place.agent).is_ok() {
                continue;
            }
            let outer = &self.agents[place.agent];
            let there = square(outer);
            for (&(one, off), known) in inner.iter().zip(&mut squares) {
                if near > off {
                    continue;
                }
                let sensed = &self.agents[one];
                let here = known.get_or_insert_with(|| square(sensed));
                let mut side: [f64; SQUARE] = std::array::from_fn(|k| there[k] - here[k]);
                side[0] += slack;
                let lasts = own.until.min(outer.until).min(sensed.until) - time;
                let length = next.map_or(lasts, |(delay, _)| lasts.min(delay));
                let found = first_downcrossing(&side, length).map(|delay| (delay, (one, place.agent)));
                let earlier = |&(delay, pair): &(f64, Pair)| next.is_none_or(|next| (delay, pair) < next);
                next = found.filter(earlier).or(next);
            }
        }
        let fence = &mut self.ranks.fences[agent];
        (fence.centre, fence.radius) = (point, far + 2.0 * moved + rounding);
        fence.looks = fence.looks.wrapping_add(1);
        if fence.radius > WIDE * self.scale {
            self.ranks.wide.insert(agent);
        } else {
            self.ranks.wide.remove(&agent);
        }
        if let Some((delay, pair)) = next {
            self.ranks.fences[agent].next = pair;
            self.expect(time + delay, Kind::Rank, (agent, agent));
        }
    }

    /// One that an agent senses and another one change places.
    pub(super) fn change_places(&mut self, time: f64, agent: usize) -> Result<[Switch; 2], FollowError> {
        let (lost, gained) = self.ranks.fences[agent].next;
        self.unlink((agent, lost));
        self.link(time, (agent, gained));
        self.restart(time, &[agent])?;
        let switch = |gained: bool, other: usize| Switch { time, gained, pair: (agent, other) };
        Ok([switch(false, lost), switch(true, gained)])
    }

    /// Cells of another width where the flock has become wider or narrower. What happens does not depend on it, except through the length of series.
    fn rescale(&mut self) {
        let count = self.agents.len();
        self.ranks.left = 4 * count;
        let mean = self.ranks.fences.iter().map(|fence| fence.radius).sum::<f64>() / count as f64;
        let factor = mean / self.scale;
        if !(mean > 0.0 && mean.is_finite()) || (1.0 / RESCALED..=RESCALED).contains(&factor) {
            return;
        }
        self.scale = mean;
        self.cells = Cells::new(count, mean);
        for (k, agent) in self.agents.iter().enumerate() {
            self.cells.put(Place { agent: k, anchor: agent.path.point(), reach: agent.reach });
        }
        self.ranks.farthest = self.agents.iter().fold(0.0, |far: f64, agent| far.max(agent.reach));
        let wide = self.ranks.fences.iter().enumerate().filter(|(_, fence)| fence.radius > WIDE * mean);
        self.ranks.wide = wide.map(|(k, _)| k).collect();
    }
}
