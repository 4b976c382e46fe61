//! Positions and velocities as balls: integers of a few limbs over one power of two, with one bound of the error for all.
//!
//! `notes/exact_flocks.md` has the bounds, by the numbers of its steps.

use super::leap::{LONGEST_LEAP, SHORTEST_LEAP};
use super::links::{Change, weight};
use super::wholes::{Velocities, Whole, wholes};
use super::words::Words;
use crate::averaging::flock::IntegerState;
use crate::averaging::hysteresis::Threshold;
use crate::averaging::weights::{FlockError, Weights};
use algebra::graph::Graph;
use arithmetic::{Interval, Rational, Ring, Signed};
use num_bigint::BigInt;
use num_traits::Signed as _;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// A flock that follows given changes of its network.
#[derive(Debug, Clone)]
pub(super) struct Balls<const L: usize> {
    pub(super) dimension: usize,
    pub(super) weights: Weights,
    pub network: Graph,
    /// `c_i` in units of `2^-64L`.
    shares: Vec<Words<L>>,
    known_shares: BTreeMap<usize, Words<L>>,
    /// One unit is `2^-fraction`.
    fraction: u32,
    scales: [f64; L],
    pub(super) positions: Vec<Words<L>>,
    pub(super) velocities: Vec<Words<L>>,
    scratch: Vec<Words<L>>,
    /// In units, for every coordinate of every bird.
    position_error: u128,
    velocity_error: u128,
    /// Steps that certainly fit.
    pub(super) room: u64,
    /// Steps from the start of the whole flock.
    pub time: u64,
    /// Changes that are applied.
    applied: usize,
}

/// Steps that fit between two losses of resolution, as a power of two; sums over all neighbours fit too.
const ROOM_BITS: u64 = 32;

/// Quiet stretches of more steps than this are jumped over, where that costs little precision.
const LONG: u64 = 256;

/// Birds that are averaged by several processors.
const MANY: usize = 2048;

/// Differences of two birds after the move of the next step: `now` and the move itself, in units, and the bounds of the errors
/// of their coordinates.
pub(super) struct PairBall {
    pub now: Vec<BigInt>,
    pub moved: Vec<BigInt>,
    pub now_error: BigInt,
    pub moved_error: BigInt,
    /// Bits of one over the unit.
    pub fraction: u32,
}

impl<const L: usize> Balls<L> {
    /// A state at a time, on the network that it has then; `None` where the numbers are too large.
    pub fn new(
        state: &IntegerState,
        network: Graph,
        weights: &Weights,
        (time, applied): (u64, usize),
    ) -> Result<Option<Self>, FlockError> {
        let birds = state.positions.len();
        let all = || state.positions.iter().chain(&state.velocities).flatten();
        let whole = all().map(|x| (x.bits() + 1).saturating_sub(state.unit.bits() - 1)).max().unwrap_or(0);
        let above = whole + ROOM_BITS + u64::from(usize::BITS - birds.leading_zeros()) + 3;
        let Some(fraction) = (64 * L as u64).checked_sub(above).filter(|&f| f > 32) else { return Ok(None) };
        let rounded = |x: &BigInt| Words::from_integer(&((x << fraction) / &state.unit));
        let words = |rows: &[Vec<BigInt>]| -> Option<Vec<Words<L>>> { rows.iter().flatten().map(rounded).collect() };
        let (Some(positions), Some(velocities)) = (words(&state.positions), words(&state.velocities)) else {
            return Ok(None);
        };
        let mut balls = Balls {
            dimension: state.positions[0].len(),
            weights: weights.clone(),
            shares: vec![Words::ZERO; birds],
            known_shares: BTreeMap::new(),
            network,
            fraction: fraction as u32,
            scales: scales(fraction as u32),
            scratch: velocities.clone(),
            positions,
            velocities,
            position_error: 1,
            velocity_error: 1,
            room: 1 << ROOM_BITS,
            time,
            applied,
        };
        for i in 0..birds {
            balls.weigh(i, time)?;
        }
        Ok(Some(balls))
    }

    /// Notes the weight of a bird for its number of neighbours.
    fn weigh(&mut self, i: usize, time: u64) -> Result<(), FlockError> {
        let degree = self.network.degree(i);
        if degree == 0 {
            return Ok(());
        }
        let key = if matches!(self.weights, Weights::Given(_)) { i } else { degree };
        if let (Some(share), false) = (self.known_shares.get(&key), matches!(self.weights, Weights::Given(_))) {
            self.shares[i] = *share;
            return Ok(());
        }
        let c = weight(&self.network, &self.weights, i, &BigInt::from(time))?;
        self.shares[i] = Words::fraction(&c.numer(), &c.denom());
        self.known_shares.insert(key, self.shares[i]);
        Ok(())
    }

    /// One step on a network of which these pairs change.
    pub fn step(&mut self, changed: &[(u32, u32)]) -> Result<(), FlockError> {
        if self.room == 0 {
            self.coarsen();
        }
        self.room -= 1;
        for (x, v) in self.positions.iter_mut().zip(&self.velocities) {
            *x = x.plus(*v);
        }
        self.position_error = self.position_error.saturating_add(self.velocity_error);
        self.time += 1;
        for &pair in changed {
            self.network.toggle(pair.0 as usize, pair.1 as usize);
        }
        let mut touched: Vec<u32> = changed.iter().flat_map(|&(i, j)| [i, j]).collect();
        touched.sort_unstable();
        for i in touched {
            self.weigh(i as usize, self.time)?;
        }
        self.average();
        Ok(())
    }

    /// `v_i + c_i (sum over neighbours - d_i v_i)`.
    fn average(&mut self) {
        let mut next = std::mem::take(&mut self.scratch);
        self.average_from(&self.velocities, &mut next);
        self.scratch = std::mem::replace(&mut self.velocities, next);
        self.velocity_error = self.velocity_error.saturating_add(L as u128 + 2);
    }

    /// Writes the averages of these numbers.
    pub(super) fn average_from(&self, from: &[Words<L>], to: &mut [Words<L>]) {
        match self.dimension {
            1 => self.average_in::<1>(from, to),
            2 => self.average_in::<2>(from, to),
            3 => self.average_in::<3>(from, to),
            _ => self.average_in_any(from, to),
        }
    }

    fn average_in<const D: usize>(&self, from: &[Words<L>], to: &mut [Words<L>]) {
        let (from, _) = from.as_chunks::<D>();
        let (to, _) = to.as_chunks_mut::<D>();
        let average = |i: usize, next: &mut [Words<L>; D]| {
            let (own, near) = (from[i], self.network.neighbours(i));
            *next = own;
            if near.is_empty() {
                return;
            }
            let mut sum = [Words::ZERO; D];
            for &j in near {
                let other = &from[j as usize];
                for k in 0..D {
                    sum[k] = sum[k].plus(other[k]);
                }
            }
            for k in 0..D {
                let pull = sum[k].minus(own[k].times(near.len() as u32));
                next[k] = own[k].plus(pull.share(&self.shares[i]));
            }
        };
        if to.len() < MANY {
            to.iter_mut().enumerate().for_each(|(i, next)| average(i, next));
        } else {
            to.par_iter_mut().with_min_len(MANY / 4).enumerate().for_each(|(i, next)| average(i, next));
        }
    }

    fn average_in_any(&self, from: &[Words<L>], to: &mut [Words<L>]) {
        for i in 0..self.network.order() {
            let near = self.network.neighbours(i);
            for k in 0..self.dimension {
                let at = |j: usize| from[j * self.dimension + k];
                let own = at(i);
                let sum = near.iter().fold(Words::ZERO, |sum, &j| sum.plus(at(j as usize)));
                let pull = sum.minus(own.times(near.len() as u32));
                let share = if near.is_empty() { Words::ZERO } else { pull.share(&self.shares[i]) };
                to[i * self.dimension + k] = own.plus(share);
            }
        }
    }

    /// These birds alone, in this order.
    pub(super) fn part(&self, birds: &[usize]) -> Self {
        let rows = |list: &[Words<L>]| -> Vec<Words<L>> {
            birds.iter().flat_map(|&i| &list[i * self.dimension..(i + 1) * self.dimension]).copied().collect()
        };
        let velocities = rows(&self.velocities);
        Balls {
            weights: self.weights.restricted(birds),
            network: self.network.induced(birds),
            shares: birds.iter().map(|&i| self.shares[i]).collect(),
            known_shares: self.known_shares.clone(),
            positions: rows(&self.positions),
            scratch: velocities.clone(),
            velocities,
            ..*self
        }
    }

    /// Gives up resolution for room.
    fn coarsen(&mut self) {
        let shift = (ROOM_BITS as u32).min(self.fraction);
        if shift == 0 {
            // Nothing is left to give: from here on these balls hold everything.
            (self.position_error, self.velocity_error, self.room) = (u128::MAX, u128::MAX, u64::MAX);
            return;
        }
        for x in self.positions.iter_mut().chain(&mut self.velocities) {
            *x = x.shifted(shift);
        }
        self.position_error = (self.position_error >> shift) + 2;
        self.velocity_error = (self.velocity_error >> shift) + 2;
        self.fraction -= shift;
        self.scales = scales(self.fraction);
        self.room = 1 << shift;
    }

    /// Follows the changes to a time.
    pub fn follow(
        &mut self,
        changes: &[Change],
        time: u64,
        progress: &dyn arithmetic::Progress,
    ) -> Result<(), FlockError> {
        while self.time < time {
            progress.checkpoint()?;
            let quiet = changes.get(self.applied).map_or(time, |change| time.min(change.time - 1)) - self.time;
            if quiet > LONG && self.time.is_multiple_of(LONG) && self.jump(quiet) {
                continue;
            }
            if quiet >= SHORTEST_LEAP && self.leap(quiet.min(LONGEST_LEAP)) {
                continue;
            }
            match changes.get(self.applied).filter(|change| change.time == self.time + 1) {
                Some(change) => {
                    self.applied += 1;
                    self.step(&change.pairs)?;
                }
                None => self.step(&[])?,
            }
        }
        Ok(())
    }

    /// Notes that one more change is applied, for who decides the changes.
    pub fn applied_one(&mut self) {
        self.applied += 1;
    }

    /// Bounds of the errors of positions and velocities, as numbers.
    pub fn errors(&self) -> (f64, f64) {
        let unit = self.scales[0];
        ((self.position_error as f64) * unit * 1.000_001, (self.velocity_error as f64) * unit * 1.000_001)
    }

    /// All positions and velocities in double precision, the coordinates of a bird next to each other.
    pub fn floats(&self) -> (Vec<f64>, Vec<f64>) {
        let list = |words: &[Words<L>]| words.iter().map(|x| x.to_f64(&self.scales)).collect();
        (list(&self.positions), list(&self.velocities))
    }

    /// `x_i - x_j` after the next move and `v_i - v_j` of the next move, in coordinate `k`.
    #[inline(always)]
    pub fn next_difference(&self, i: usize, j: usize, k: usize) -> (f64, f64) {
        let (a, b) = (i * self.dimension + k, j * self.dimension + k);
        let moved = self.velocities[a].minus(self.velocities[b]);
        let now = self.positions[a].minus(self.positions[b]).plus(moved);
        (now.to_f64(&self.scales), moved.to_f64(&self.scales))
    }

    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Coordinate `k` of `x_i - x_j`.
    #[inline(always)]
    pub fn position_difference(&self, i: usize, j: usize, k: usize) -> f64 {
        let (a, b) = (i * self.dimension + k, j * self.dimension + k);
        self.positions[a].minus(self.positions[b]).to_f64(&self.scales)
    }

    /// Coordinate `k` of `v_i - v_j`.
    pub fn velocity_difference(&self, i: usize, j: usize, k: usize) -> f64 {
        let (a, b) = (i * self.dimension + k, j * self.dimension + k);
        self.velocities[a].minus(self.velocities[b]).to_f64(&self.scales)
    }

    /// The connected parts of the network and where they go.
    pub fn wholes(&self) -> Vec<Whole> {
        let (_, error) = self.errors();
        let difference = |i, j, k| self.velocity_difference(i, j, k);
        wholes(&self.network, &self.weights, &Velocities { dimension: self.dimension, error, difference })
    }

    /// Many steps at once on a network that stays, where velocities have settled so far that this costs little precision; whether
    /// it was done.
    pub fn jump(&mut self, steps: u64) -> bool {
        let wholes = self.wholes();
        let unit = self.scales[0];
        let stray = wholes.iter().fold(0.0, |most: f64, w| most.max(2.0 * w.stray)) / unit;
        let range = wholes.iter().fold(0.0, |most: f64, w| most.max(w.range)) / unit;
        // Half the bits of a unit may be lost.
        let lost = 2f64.powi((self.fraction / 2).min(100) as i32);
        let drift_error = self.velocity_error.saturating_add(2);
        let error = drift_error as f64 * steps as f64 + stray;
        // Units below the range of floats have no bounds here.
        if unit == 0.0 || error.is_nan() || error > lost || self.room < steps {
            return false;
        }
        for whole in &wholes {
            let Some(mean) = self.mean(&whole.members) else { return false };
            for &i in &whole.members {
                for (k, mean) in mean.iter().enumerate() {
                    let place = i * self.dimension + k;
                    let way = mean.to_integer() * steps;
                    let Some(way) = Words::from_integer(&way) else { return false };
                    self.positions[place] = self.positions[place].plus(way);
                    self.velocities[place] = *mean;
                }
            }
        }
        self.room -= steps;
        self.time += steps;
        self.position_error = self.position_error.saturating_add(drift_error * u128::from(steps)) + stray as u128 + 1;
        self.velocity_error = drift_error + range as u128 + 1;
        true
    }

    /// Whether these balls hold everything.
    pub(super) fn has_no_room(&self) -> bool {
        self.velocity_error == u128::MAX
    }

    /// The state after so many steps on a network that stays, with what it errs by beyond what errs already.
    pub(super) fn keep(&mut self, state: Vec<(Words<L>, Words<L>)>, steps: u64, (velocity, position): (u128, u128)) {
        (self.positions, self.velocities) = state.into_iter().unzip();
        self.position_error = self
            .position_error
            .saturating_add(self.velocity_error.saturating_mul(u128::from(steps)))
            .saturating_add(position);
        self.velocity_error = self.velocity_error.saturating_add(velocity);
        self.room -= steps;
        self.time += steps;
    }

    /// The stationary mean of the velocities of a connected part, less than a unit too small.
    pub(super) fn mean(&self, members: &[usize]) -> Option<Vec<Words<L>>> {
        let share = |&i: &usize| self.weights.of(self.network.degree(i), i).map(|c| c.recip());
        let shares = if members.len() == 1 {
            vec![Rational::from_integer(BigInt::from(1))]
        } else {
            members.iter().map(share).collect::<Option<Vec<Rational>>>()?
        };
        let total: Rational = shares.iter().sum();
        let coordinate = |k: usize| {
            let value = |i: usize| Rational::from_integer(self.velocities[i * self.dimension + k].to_integer());
            let sum: Rational = members.iter().zip(&shares).map(|(&i, share)| value(i) * share).sum();
            Words::from_integer(&(sum / &total).floor().to_integer())
        };
        (0..self.dimension).map(coordinate).collect()
    }

    pub fn pair(&self, i: usize, j: usize) -> PairBall {
        let difference = |list: &[Words<L>], k: usize| {
            list[i * self.dimension + k].to_integer() - list[j * self.dimension + k].to_integer()
        };
        let moved: Vec<BigInt> = (0..self.dimension).map(|k| difference(&self.velocities, k)).collect();
        PairBall {
            now: moved.iter().enumerate().map(|(k, v)| difference(&self.positions, k) + v).collect(),
            moved,
            now_error: BigInt::from(self.position_error.saturating_add(self.velocity_error)) * 2,
            moved_error: BigInt::from(self.velocity_error) * 2,
            fraction: self.fraction,
        }
    }
}

fn scales<const L: usize>(fraction: u32) -> [f64; L] {
    let mut scales = [0.0; L];
    for (k, scale) in scales.iter_mut().enumerate() {
        *scale = 2f64.powi(64 * k as i32 - fraction as i32);
    }
    scales
}

impl PairBall {
    /// Whether the distance is at most 1.
    pub fn is_near(&self) -> Option<bool> {
        let excess = self.now.iter().map(Ring::square).sum::<BigInt>() - (BigInt::from(1) << (2 * self.fraction));
        let error: BigInt = self.now.iter().map(|x| (x.abs() * 2 + &self.now_error) * &self.now_error).sum();
        if excess > error { Some(false) } else { (-excess >= error).then_some(true) }
    }

    /// Whether the change of distance is below the threshold.
    pub fn is_held(&self, threshold: &Threshold) -> Option<bool> {
        const PRECISION: u32 = 128;
        let (e, m) = (&self.now_error, &self.moved_error);
        // |now|² - |before|² = moved . (2 now - moved).
        let (mut change, mut change_error) = (BigInt::ZERO, BigInt::ZERO);
        let (mut now, mut before) = (BigInt::ZERO, BigInt::ZERO);
        for (x, v) in self.now.iter().zip(&self.moved) {
            let (sum, error): (BigInt, BigInt) = (x * 2 - v, e * 2 + m);
            change_error += sum.abs() * m + v.abs() * &error + m * &error;
            change += sum * v;
            now += x.square();
            before += (x - v).square();
        }
        // The sum of the two distances, in units.
        let roots = now.sqrt() + before.sqrt();
        let roots_error = (e * 2 + m) * self.now.len() + 2;
        let interval = |x: BigInt| Interval::from_rational(&Rational::from_integer(x), PRECISION);
        let limit = threshold.enclosure(PRECISION).scaled(i64::from(self.fraction));
        let size = change.abs();
        let (most, least) = (&size + &change_error, size - change_error);
        if least.is_positive() {
            let beyond = interval(least) - limit.clone() * interval(&roots + &roots_error);
            if beyond.is_certainly_positive() {
                return Some(false);
            }
        }
        let shortest: BigInt = roots - roots_error;
        let within = limit * interval(shortest.max(BigInt::ZERO)) - interval(most);
        within.is_certainly_positive().then_some(true)
    }
}

#[cfg(test)]
mod tests;
