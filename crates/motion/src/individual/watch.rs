//! New series in force: how long they last, and what happens on them.

use super::cells::Place;
use super::next::{Kind, Next};
use super::path::{LENGTH, ORDER, Path};
use super::{FARTHEST, IndividualFlock, IndividualLaw, Pace, Pair, Sensing, Turns};
use crate::{FollowError, IntegrationError, first_downcrossing};
use std::cmp::Reverse;
use std::f64::consts::{PI, TAU};

/// The longest series, in units of time.
const LONGEST: f64 = 1.0;

/// Computed values near zero are wrong by this many times what rounding does to the numbers that they are made of.
pub(super) const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl<L: IndividualLaw<F, M>, const F: usize, const M: usize> IndividualFlock<L, F, M> {
    /// Puts new series into force and looks for what happens on them.
    pub(super) fn install(&mut self, time: f64, changed: &[usize]) -> Result<(), FollowError> {
        for &k in changed {
            let path = *self.together.path(k);
            let (length, reach) = self.length(&path);
            let until = time + length;
            if until.is_nan() || until <= time {
                return Err(IntegrationError::Stuck(time).into());
            }
            let agent = &mut self.agents[k];
            (agent.from, agent.until, agent.reach, agent.path) = (time, until, reach, path);
            agent.restarts = agent.restarts.wrapping_add(1);
            agent.round = self.together.round;
            self.restarts += 1;
            self.expect(until, Kind::End, (k, k));
            self.cells.put(Place { agent: k, anchor: path.point(), reach });
        }
        match self.sensing {
            Sensing::Within(radius) => changed.iter().for_each(|&k| self.watch_radius(time, k, radius)),
            Sensing::Nearest => self.watch_ranks(time, changed),
        }
        for &k in changed {
            match self.law.turns() {
                Turns::Never => {}
                Turns::OfAgents => self.watch_angle(time, k),
                Turns::OfPairs => self.watch_differences(time, k),
            }
        }
        Ok(())
    }

    pub(super) fn expect(&mut self, time: f64, kind: Kind, pair: Pair) {
        let count = |agent: usize| match kind {
            Kind::Rank => self.ranks.looks(agent),
            _ => self.agents[agent].restarts,
        };
        let restarts = (count(pair.0), count(pair.1));
        self.queue.push(Reverse(Next { time, pair, kind, restarts }));
    }

    /// How long a series may be used, and how far it leads.
    fn length(&self, path: &Path<F>) -> (f64, f64) {
        let mut length = match self.pace {
            Pace::Fixed(length) => length,
            Pace::Tolerance(tolerance) => {
                let root = |ratio: f64, m: usize| ratio.powf(1.0 / m as f64);
                let allowed = tolerance * (1.0 + path.size(1));
                let of = |m: usize| {
                    let velocity = root(allowed / ((m + 1) as f64 * path.size(m + 1)), m);
                    path.further.iter().map(|c| root(tolerance / c[m].abs(), m)).fold(velocity, f64::min)
                };
                of(ORDER).min(of(ORDER - 1)).min(LONGEST)
            }
        };
        let farthest = FARTHEST * self.scale;
        let mut reach = path.reach(length);
        while reach > farthest {
            length *= (farthest / reach).clamp(0.1, 0.9);
            reach = path.reach(length);
        }
        (if reach.is_finite() { length } else { f64::NAN }, reach)
    }

    /// Whether a pair is asked for another agent of this round too: of two that are new both would find it.
    fn is_asked_twice(&self, own: usize, other: usize) -> bool {
        self.agents[other].round == self.together.round && other < own
    }

    /// Finds the next arrivals of an agent's pairs at the radius while both series last.
    fn watch_radius(&mut self, time: f64, i: usize, radius: f64) {
        let own = &self.agents[i];
        let point = own.path.point();
        let mut found = Vec::new();
        for other in self.cells.around(point) {
            let (x, y) = (point[0] - other.anchor[0], point[1] - other.anchor[1]);
            let (square, both) = (x * x + y * y, own.reach + other.reach + 1e-9 * radius);
            let (near, far) = (radius - both, radius + both);
            let j = other.agent;
            if square > far * far || square < near * near || j == i || self.is_asked_twice(i, j) {
                continue;
            }
            let agent = &self.agents[j];
            let mut side = own.path.squared_distance(&agent.path.after(time - agent.from));
            side[0] -= radius * radius;
            if own.place(j).is_ok() {
                side.iter_mut().for_each(|c| *c = -*c);
            }
            let rounding = radius * (radius + 2.0 * (point[0].abs() + point[1].abs()));
            leave(&mut side, rounding);
            let length = own.until.min(agent.until) - time;
            found.extend(first_downcrossing(&side, length).map(|delay| (time + delay, (i.min(j), i.max(j)))));
        }
        found.into_iter().for_each(|(time, pair)| self.expect(time, Kind::Radius, pair));
    }

    /// Finds when the angle of an agent leaves `(-pi, pi]`.
    fn watch_angle(&mut self, time: f64, i: usize) {
        let own = &self.agents[i];
        let Some(angle) = own.path.further.first() else { return };
        if let Some(delay) = first_half_turn(angle, own.until - time, PI) {
            self.expect(time + delay, Kind::Turn, (i, i));
        }
    }

    /// Finds when the differences of the angles of an agent's pairs, as the law reads them, leave `(-pi, pi]`.
    fn watch_differences(&mut self, time: f64, i: usize) {
        let own = &self.agents[i];
        let Some(angle) = own.path.further.first() else { return };
        let mut found = Vec::new();
        for other in &own.neighbours {
            let (j, agent) = (other.agent, &self.agents[other.agent]);
            let after = agent.path.after(time - agent.from);
            let Some(theirs) = after.further.first().filter(|_| !self.is_asked_twice(i, j)) else { continue };
            let mut difference: [f64; LENGTH] = std::array::from_fn(|k| angle[k] - theirs[k]);
            difference[0] -= TAU * other.turns;
            let size = PI + angle[0].abs() + theirs[0].abs();
            let delay = first_half_turn(&difference, own.until.min(agent.until) - time, size);
            found.extend(delay.map(|delay| (time + delay, (i.min(j), i.max(j)))));
        }
        found.into_iter().for_each(|(time, pair)| self.expect(time, Kind::Turn, pair));
    }
}

/// Something that has just switched is at zero within rounding and leaves it.
fn leave<const N: usize>(side: &mut [f64; N], size: f64) {
    if side[0].abs() <= ROUNDING * size && side[1] > 0.0 {
        side[0] = 0.0;
    }
}

/// When an angle leaves `[-pi, pi]`; `size` is that of the numbers that it was made of.
fn first_half_turn(angle: &[f64; LENGTH], length: f64, size: f64) -> Option<f64> {
    let (mut below, mut above) = (angle.map(|c| -c), *angle);
    let falls = [&mut below, &mut above].map(|side| {
        side[0] += PI;
        leave(side, size);
        first_downcrossing(side, length)
    });
    falls.into_iter().flatten().reduce(f64::min)
}
