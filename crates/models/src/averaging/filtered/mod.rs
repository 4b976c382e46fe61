//! Model D with an exact network and hardly any exact number: every decision by a ball where that can, by a finer ball where that
//! can, and exactly where nothing else will do (`notes/exact_flocks.md`).

mod ahead;
mod balls;
mod classes;
mod leap;
mod links;
mod outlook;
mod settled;
mod stride;
mod watch;
mod wholes;
mod words;

use super::flock::{Flock, IntegerState, Start, Switch};
use super::hysteresis::Threshold;
use super::weights::{FlockError, Weights};
use algebra::graph::Graph;
use arithmetic::Progress;
use balls::{Balls, PairBall};
use classes::Classes;
use leap::{LONGEST_LEAP, SHORTEST_LEAP};
use links::{Change, Multiplier};
use num_bigint::BigInt;
use num_traits::{One, Pow, Zero};
pub(super) use outlook::Outlook;
use settled::Left;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use watch::Watch;

/// A flock of model D that is stepped by balls: the same networks as [`Flock`], bit for bit, without its long numbers.
#[derive(Debug, Clone)]
pub struct FilteredFlock {
    /// The exact flock at an earlier time.
    exact: Flock,
    exact_applied: usize,
    /// The time of the exact flock when this one was made.
    origin: BigInt,
    /// Common denominator of the state then.
    first_unit: BigInt,
    weights: Weights,
    threshold: Threshold,
    network: Graph,
    /// What has changed since the start.
    changes: Vec<Change>,
    /// The state now, of the birds that are not left behind.
    state: State,
    /// Their numbers in the whole flock. Where nothing else is said, birds are numbered as in the state.
    names: Vec<u32>,
    left: Left,
    /// Finer states of earlier times, where they were needed.
    finer: Finer,
    watch: Watch,
    classes: Classes,
    /// Steps since the start.
    time: u64,
    /// Whether the balls have jumped: exact numbers are out of reach then.
    jumped: bool,
}

/// The balls that are stepped, or the exact flock alone where numbers are too large for balls.
#[derive(Debug, Clone)]
enum State {
    Balls(Box<Balls<2>>),
    Exact,
}

#[derive(Debug, Clone, Default)]
struct Finer {
    middle: Option<Box<Balls<8>>>,
    long: Option<Box<Balls<32>>>,
}

/// Exact numbers of fewer bits than this are as quick as balls.
const SHORT: u64 = 1024;

impl FilteredFlock {
    /// The flock at `t = 0`.
    ///
    /// # Errors
    /// [`FlockError`] where the start is not a flock.
    pub fn new(start: &Start) -> Result<Self, FlockError> {
        FilteredFlock::from_exact(Flock::new(start)?)
    }

    /// The flock from the state of an exact one on.
    ///
    /// # Errors
    /// [`FlockError`] where the weights do not suit the network.
    pub fn from_exact(exact: Flock) -> Result<Self, FlockError> {
        let integers = exact.integers();
        let (network, weights) = (exact.network().clone(), exact.weights().clone());
        let balls = Balls::new(&integers, network.clone(), &weights, (0, 0))?;
        Ok(FilteredFlock {
            origin: exact.time().clone(),
            first_unit: integers.unit,
            threshold: exact.threshold().clone(),
            exact_applied: 0,
            exact,
            weights,
            names: (0..network.order() as u32).collect(),
            left: Left::default(),
            network,
            changes: Vec::new(),
            state: balls.map_or(State::Exact, |balls| State::Balls(Box::new(balls))),
            finer: Finer::default(),
            watch: Watch::default(),
            classes: Classes::default(),
            time: 0,
            jumped: false,
        })
    }

    /// The time `t`.
    pub fn time(&self) -> BigInt {
        &self.origin + self.time
    }

    /// `G_t`.
    pub fn network(&self) -> &Graph {
        &self.network
    }

    /// The weights.
    pub fn weights(&self) -> &Weights {
        &self.weights
    }

    /// Number of birds.
    pub fn birds(&self) -> usize {
        self.network.order()
    }

    /// Bits of the common denominator that the exact state has, not reduced.
    pub fn denominator_bits(&self) -> u64 {
        let mut powers: BTreeMap<BigInt, u64> = BTreeMap::new();
        let mut now = Multiplier::new(self.network.clone(), &self.weights);
        // Backwards, from the network of now.
        let mut until = self.time;
        for change in self.changes.iter().rev() {
            *powers.entry(now.value()).or_default() += until + 1 - change.time;
            until = change.time - 1;
            change.pairs.iter().for_each(|&pair| now.toggle(pair));
        }
        *powers.entry(now.value()).or_default() += until;
        let power = |(m, count): (BigInt, u64)| if m.is_one() { m } else { Pow::pow(m, count) };
        powers.into_iter().map(power).fold(self.first_unit.clone(), |product, p| product * p).bits()
    }

    /// What is certain about the network from now on, if anything is.
    pub(super) fn outlook(&self, progress: &dyn Progress) -> Result<Option<Outlook>, FlockError> {
        let State::Balls(balls) = &self.state else { return Ok(None) };
        let mut outlook = outlook::outlook(balls, &self.threshold, &self.classes, u64::MAX, progress)?;
        outlook.drifting += self.left.drifting;
        outlook.looked = outlook.looked.max(self.left.until.saturating_sub(self.time));
        Ok(Some(outlook))
    }

    /// Many steps at once in which nothing changes; whether that was possible.
    pub(super) fn jump(&mut self, steps: u64) -> bool {
        let State::Balls(balls) = &mut self.state else { return false };
        if !balls.jump(steps) {
            return false;
        }
        self.time += steps;
        self.jumped = true;
        self.watch.renew();
        true
    }

    /// Steps in which nothing changes, without a look at any pair.
    pub(super) fn coast(&mut self, steps: u64, progress: &dyn Progress) -> Result<(), FlockError> {
        self.watch.renew();
        let end = self.time + steps;
        while self.time < end {
            progress.checkpoint()?;
            let State::Balls(balls) = &mut self.state else { return Ok(()) };
            let left = end - self.time;
            if left >= SHORTEST_LEAP && !self.classes.are_known() && balls.leap(left.min(LONGEST_LEAP)) {
                self.time += left.min(LONGEST_LEAP);
                continue;
            }
            balls.step(&[])?;
            self.time += 1;
            self.classes.average(&balls.network, &self.weights);
        }
        Ok(())
    }

    /// Whether it has jumped.
    pub(super) fn has_jumped(&self) -> bool {
        self.jumped
    }

    /// The exact flock at this time.
    ///
    /// # Errors
    /// [`FlockError::Cancelled`].
    pub fn exact(&mut self, progress: &dyn Progress) -> Result<&Flock, FlockError> {
        self.follow_exactly(self.time, progress)?;
        Ok(&self.exact)
    }

    /// The exact flock at an earlier time.
    pub(super) fn into_exact(mut self, time: &BigInt, progress: &dyn Progress) -> Result<Flock, FlockError> {
        let time = u64::try_from(time - &self.origin).unwrap_or(0).min(self.time);
        self.follow_exactly(time, progress)?;
        Ok(self.exact)
    }

    fn follow_exactly(&mut self, time: u64, progress: &dyn Progress) -> Result<(), FlockError> {
        let mut network = self.exact.network().clone();
        while self.exact_time() < time {
            progress.checkpoint()?;
            let next = self.exact_time() + 1;
            if let Some(change) = self.changes.get(self.exact_applied).filter(|change| change.time == next) {
                for &(i, j) in &change.pairs {
                    network.toggle(i as usize, j as usize);
                }
                self.exact_applied += 1;
            }
            self.exact.step_on(&network)?;
        }
        Ok(())
    }

    fn exact_time(&self) -> u64 {
        u64::try_from(self.exact.time() - &self.origin).unwrap_or(u64::MAX)
    }

    /// One step, as [`Flock::step`], until `progress` stops it; it can go on then.
    ///
    /// # Errors
    /// As there, and [`FlockError::Cancelled`].
    pub fn step(&mut self, progress: &dyn Progress) -> Result<Option<Switch>, FlockError> {
        let State::Balls(balls) = &self.state else { return self.step_exactly() };
        let due = self.watch.due(balls, &self.classes);
        let mut changed = Vec::new();
        for &pair in &due {
            // Where this is stopped nothing has moved yet; a later attempt looks at all pairs again.
            if self.look_at(pair, progress).inspect_err(|_| self.watch.renew())? {
                changed.push(pair);
            }
        }
        self.time += 1;
        let State::Balls(balls) = &mut self.state else { return Ok(None) };
        let time = &self.origin + self.time;
        let names = &self.names;
        balls.step(&changed).map_err(|error| match error {
            FlockError::Inadmissible { bird, degree, c, .. } => {
                let bird = names[bird - 1] as usize + 1;
                FlockError::Inadmissible { bird, degree, c, time: time.to_string() }
            }
            other => other,
        })?;
        let switch = (!changed.is_empty()).then(|| self.note(changed, time));
        if let State::Balls(balls) = &self.state {
            self.classes.average(&balls.network, &self.weights);
        }
        Ok(switch)
    }

    /// Without balls.
    fn step_exactly(&mut self) -> Result<Option<Switch>, FlockError> {
        let switch = self.exact.step()?;
        self.time += 1;
        if let Some(switch) = &switch {
            let all = switch.gained.iter().chain(&switch.lost);
            let pairs = all.map(|&(i, j)| (i as u32, j as u32)).collect();
            self.changes.push(Change { time: self.time, pairs });
            self.exact_applied += 1;
            self.network.clone_from(self.exact.network());
        }
        Ok(switch)
    }

    /// Notes what changed in the step to now.
    fn note(&mut self, mut changed: Vec<(u32, u32)>, time: BigInt) -> Switch {
        changed.iter_mut().for_each(|pair| *pair = (self.names[pair.0 as usize], self.names[pair.1 as usize]));
        // The order of `Graph::edges`.
        changed.sort_unstable_by_key(|&(i, j)| (j, i));
        let (mut gained, mut lost) = (Vec::new(), Vec::new());
        for &(i, j) in &changed {
            let pair = (i as usize, j as usize);
            self.network.toggle(pair.0, pair.1);
            if self.network.has_edge(pair.0, pair.1) {
                gained.push(pair);
            } else {
                lost.push(pair);
            }
        }
        self.changes.push(Change { time: self.time, pairs: changed });
        if let State::Balls(balls) = &mut self.state {
            balls.applied_one();
        }
        Switch { time, gained, lost }
    }

    /// Decides a pair in the next step and when to look again; whether its status changes.
    fn look_at(&mut self, pair: (u32, u32), progress: &dyn Progress) -> Result<bool, FlockError> {
        let (i, j) = (pair.0 as usize, pair.1 as usize);
        let State::Balls(balls) = &self.state else { return Ok(false) };
        let dimension = self.exact.dimension();
        let (mut now, mut moved) = ([0.0; 4], [0.0; 4]);
        let (mut more_now, mut more_moved) = (Vec::new(), Vec::new());
        let (now, moved) = if dimension <= 4 {
            (&mut now[..dimension], &mut moved[..dimension])
        } else {
            more_now.resize(dimension, 0.0);
            more_moved.resize(dimension, 0.0);
            (&mut more_now[..], &mut more_moved[..])
        };
        for k in 0..dimension {
            (now[k], moved[k]) = balls.next_difference(i, j, k);
        }
        let error = error_of_difference(dimension, balls.errors());
        let edge = balls.network.has_edge(i, j);
        let squared: f64 = now.iter().map(|x| x * x).sum();
        let doubt = error_of_square(squared, error);
        let joined = if squared - 1.0 < -doubt {
            true
        } else if squared - 1.0 > doubt && (!edge || self.threshold.holds_nothing()) {
            false
        } else {
            self.decide(pair, edge, progress)?
        };
        let time = self.time + 1;
        self.watch.schedule(pair, now, moved, joined, (time, error));
        Ok(joined != edge)
    }

    /// Where double precision is not enough.
    fn decide(&mut self, pair: (u32, u32), edge: bool, progress: &dyn Progress) -> Result<bool, FlockError> {
        if self.classes.is_tie(pair) {
            return Ok(true);
        }
        let (i, j) = (pair.0 as usize, pair.1 as usize);
        let by = |ball: PairBall, threshold: &Threshold| match ball.is_near()? {
            true => Some(true),
            false if !edge || threshold.holds_nothing() => Some(false),
            false => ball.is_held(threshold),
        };
        if let State::Balls(balls) = &self.state
            && let Some(joined) = by(balls.pair(i, j), &self.threshold)
        {
            return Ok(joined);
        }
        // Bits of exact numbers: at least one a step, mostly far more.
        let bits = self.first_unit.bits() + 4 * self.time;
        let (i, j) = (self.names[i] as usize, self.names[j] as usize);
        if bits > SHORT {
            if let Some(middle) = self.middle(progress)?
                && let Some(joined) = by(middle.pair(i, j), &self.threshold)
            {
                return Ok(joined);
            }
            if bits > 4 * SHORT
                && let Some(long) = self.long(progress)?
                && let Some(joined) = by(long.pair(i, j), &self.threshold)
            {
                return Ok(joined);
            }
        }
        self.decide_exactly(pair, edge, progress)
    }

    fn decide_exactly(&mut self, pair: (u32, u32), edge: bool, progress: &dyn Progress) -> Result<bool, FlockError> {
        let (i, j) = (self.names[pair.0 as usize] as usize, self.names[pair.1 as usize] as usize);
        if self.jumped {
            let (pair, bits) = ((i + 1, j + 1), 64 * 32);
            return Err(FlockError::Undecided { pair, time: self.time + 1, against: "distance 1", bits });
        }
        self.exact(progress)?;
        let (near, moved) = self.exact.next_comparison(i, j);
        if near == Ordering::Equal && moved.iter().all(Zero::is_zero) {
            let (exact, names) = (&self.exact, &self.names);
            self.classes.note(pair, || equal_velocities(&exact.integers(), names));
            self.watch.renew();
        }
        Ok(near != Ordering::Greater || (edge && self.exact.next_is_held(i, j)?))
    }

    fn middle(&mut self, progress: &dyn Progress) -> Result<Option<&Balls<8>>, FlockError> {
        if self.finer.middle.is_none() {
            self.finer.middle = self.balls_of_the_exact_state()?.map(Box::new);
        }
        if let Some(balls) = &mut self.finer.middle {
            balls.follow(&self.changes, self.time, progress)?;
        }
        Ok(self.finer.middle.as_deref())
    }

    fn long(&mut self, progress: &dyn Progress) -> Result<Option<&Balls<32>>, FlockError> {
        if self.jumped {
            // Its units are too small for bounds in double precision, without which there is no jump.
            return Ok(None);
        }
        if self.finer.long.is_none() {
            self.finer.long = self.balls_of_the_exact_state()?.map(Box::new);
        }
        if let Some(balls) = &mut self.finer.long {
            balls.follow(&self.changes, self.time, progress)?;
        }
        Ok(self.finer.long.as_deref())
    }

    /// Balls of any length at the time of the exact flock.
    fn balls_of_the_exact_state<const L: usize>(&self) -> Result<Option<Balls<L>>, FlockError> {
        let place = (self.exact_time(), self.exact_applied);
        Balls::new(&self.exact.integers(), self.exact.network().clone(), &self.weights, place)
    }
}

/// How far the next difference of two birds is from the exact one, whose coordinates each err by the errors of a position and of a velocity.
fn error_of_difference(dimension: usize, (position, velocity): (f64, f64)) -> f64 {
    2.0 * (dimension as f64).sqrt() * (position + velocity) * 1.001
}

/// How far the square of a difference is from the exact one: rounding errs by less than 1e-14 relative, the difference `x` by `(2 |x| + error)
/// error`, and `2 |x| <= 1 + |x|²`.
fn error_of_square(squared: f64, error: f64) -> f64 {
    1e-12 * (1.0 + squared) + (2.0 + squared + error) * error
}

/// Numbers that are the same for birds of equal velocities, among those with these names.
fn equal_velocities(state: &IntegerState, names: &[u32]) -> Vec<u64> {
    let mut known: BTreeMap<&[BigInt], u64> = BTreeMap::new();
    let mut number = |v| {
        let next = known.len() as u64;
        *known.entry(v).or_insert(next)
    };
    names.iter().map(|&i| number(state.velocities[i as usize].as_slice())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two birds whose every coordinate errs as far as it may, in opposite directions: that is what the bounds allow for, with little more.
    #[test]
    fn errors_of_differences_and_squares() {
        for (dimension, position, velocity) in [(1, 0.25, 0.0), (1, 0.0, 0.25), (4, 0.5, 0.125), (9, 1e-6, 3e-6)] {
            let worst = (dimension as f64).sqrt() * (2.0 * position + 2.0 * velocity);
            let bound = error_of_difference(dimension, (position, velocity));
            assert!(bound > worst && bound < worst * 1.0015, "{dimension} {position} {velocity}");
        }
        for (x, error) in [(0.0, 0.5), (0.5, 0.25), (1.0, 0.125), (1.0, 1e-6), (4.0, 2.0)] {
            let (square, worst) = (x * x, (x + error) * (x + error) - x * x);
            let bound = error_of_square(square, error);
            // What is given away: (2 - 2 x + x²) error, and the rounding.
            let given = (2.0 - 2.0 * x + square) * error + 1e-12 * (1.0 + square);
            assert!(bound > worst && (bound - worst - given).abs() < 1e-13, "{x} {error}");
        }
        assert_eq!(error_of_square(3.0, 0.0), 4e-12);
    }
}
