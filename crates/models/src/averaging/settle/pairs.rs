//! Each pair of birds on a fixed network: when its status is settled, or when it can change next.

use super::error::SettleError;
use super::limits::{FixedNetwork, Motion, dot, log2_below};
use super::perturbation::{Functional, Magnitude, Stage, difference_functional, value_of};
use super::ties;
use crate::averaging::flock::Flock;
use crate::averaging::hysteresis::Hysteresis;
use arithmetic::{Field, Interval, Number, Progress, Rational, Ring, Sign, Signed, rational};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed as _, Zero};
use std::collections::BTreeMap;

/// Bits up to which the polynomial of an approach is reduced.
const LONGEST_REDUCED: u64 = 40_000;

/// Two birds of different flocks with `|x_i - x_j|² - 1 = (a + b s + c s²)/scale` but for transients, `c > 0`, `scale > 0`.
pub(super) struct Approach {
    pub pair: (usize, usize),
    pub a: BigInt,
    pub b: BigInt,
    pub c: BigInt,
}

/// Two birds of different flocks that approach at a speed too small to be written as a number.
pub(super) struct SlowApproach {
    pub pair: (usize, usize),
    /// Encloses `log2` of the number of steps until they are within distance 1.
    pub log2_steps: Interval,
}

/// What all pairs come to on a fixed network.
#[derive(Default)]
pub(super) struct Prospects {
    /// From this many steps on, pairs without relative drift keep their status, and pairs with drift follow `Approach`.
    pub horizon: u64,
    pub approaches: Vec<Approach>,
    pub slow_approaches: Vec<SlowApproach>,
    /// Pairs of different flocks that part at a speed too small to be written as a number.
    pub parting: usize,
    /// Why something stays open.
    pub open: Option<String>,
}

/// Looks at every pair.
pub(super) fn prospects(
    flock: &Flock,
    fixed: &FixedNetwork,
    motion: &Motion,
    stages: &[Stage],
    progress: &dyn Progress,
) -> Result<Prospects, SettleError> {
    let mut all = Prospects::default();
    let mut drifts = BTreeMap::new();
    for j in 0..flock.birds() {
        for i in 0..j {
            progress.checkpoint()?;
            let mut pair = Pair { flock, fixed, motion, stages, drifts: &mut drifts, progress, i, j };
            if let Err(error) = pair.look(&mut all) {
                match error {
                    SettleError::Unresolved | SettleError::Recurrence(_) => {
                        all.open.get_or_insert_with(|| format!("birds {} and {}: {error}", i + 1, j + 1));
                    }
                    other => return Err(other),
                }
            }
        }
    }
    Ok(all)
}

struct Pair<'a> {
    flock: &'a Flock,
    fixed: &'a FixedNetwork,
    motion: &'a Motion,
    stages: &'a [Stage],
    /// The differences of drift that were left out of numbers, by pair of flocks.
    drifts: &'a mut BTreeMap<(usize, usize), Vec<Magnitude>>,
    progress: &'a dyn Progress,
    i: usize,
    j: usize,
}

impl Pair<'_> {
    /// Steps until something of at most this `log2` now, halved every so many steps, is below `limit`.
    fn steps_until(&self, log2: Option<i64>, limit: i64) -> u64 {
        let halvings = log2.map_or(0, |now| u64::try_from(now - limit).unwrap_or(0));
        halvings.saturating_mul(self.fixed.halving_steps)
    }

    fn look(&mut self, all: &mut Prospects) -> Result<(), SettleError> {
        let (a, b) = self.motion.difference(self.i, self.j);
        let transient = self.motion.log2_transient(self.fixed, self.i, self.j);
        if b.iter().any(|x| !x.is_zero()) {
            self.look_at_drift(&a, &b, transient, all);
            return Ok(());
        }
        let edge = self.fixed.network.has_edge(self.i, self.j);
        let one = self.motion.unit.square();
        let squared = dot(&a, &a);
        let excess = &squared - &one;
        let apart = self.fixed.flock_of[self.i] != self.fixed.flock_of[self.j];
        if apart && !self.stages.is_empty() {
            self.slow_approach(&a, &excess, all)?;
        }
        let held = edge && *self.flock.hysteresis() != Hysteresis::None;
        // log2 of a lower bound of |A| - 1 >= (|A|² - 1)/(|A|² + 2).
        let far_gap = || log2_below(&excess, &(&squared + &one * 2));
        let steps = match Signed::sign(&excess) {
            // Nearer than 1 in the limit: 1 - |A| >= (1 - |A|²)/2.
            Some(Sign::Negative) => self.steps_until(transient, log2_below(&excess, &one) - 1),
            // An edge under hysteresis stays once no change of distance reaches the threshold.
            _ if held => {
                match self.flock.threshold().log2_below() {
                    Some(limit) => self.steps_until(self.motion.log2_velocity(self.fixed, self.i), limit),
                    // A threshold of zero holds nothing.
                    None if excess.is_zero() => self.tie(&a, transient)?,
                    None => self.steps_until(transient, far_gap()),
                }
            }
            Some(Sign::Positive) => self.steps_until(transient, far_gap()),
            _ => self.tie(&a, transient)?,
        };
        all.horizon = all.horizon.max(steps);
        Ok(())
    }

    /// `|A| = 1`: from when on the signs of `|x_i - x_j|² - 1` at even and at odd times are those of their leading terms.
    fn tie(&self, a: &[BigInt], transient: Option<i64>) -> Result<u64, SettleError> {
        let a = self.motion.rationals(a);
        if !self.stages.is_empty() {
            // The limit itself may be off by what was left out.
            let positions = difference_functional(self.flock.birds(), (self.i, self.j), &a)?;
            let velocities = positions.times_watched(&self.fixed.gamma, self.progress)?;
            if !matches!(value_of(self.stages, Functional { positions, velocities }, self.progress)?, Magnitude::Zero) {
                return Err(SettleError::Unresolved);
            }
        }
        let signs = ties::eventual_signs(
            self.flock,
            std::slice::from_ref(&self.fixed.network),
            (self.i, self.j),
            &a,
            self.progress,
        )?;
        if !self.stages.is_empty() && signs.signs.contains(&Sign::Zero) {
            // A tie of the rational part for ever: what was left out would decide.
            return Err(SettleError::Unresolved);
        }
        Ok(signs.from.max(self.steps_until(transient, -1)))
    }

    /// Different flocks whose drifts agree as far as numbers go. Where they do not agree exactly, notes when they meet.
    fn slow_approach(&mut self, a: &[BigInt], excess: &BigInt, all: &mut Prospects) -> Result<(), SettleError> {
        let flocks = (self.fixed.flock_of[self.i], self.fixed.flock_of[self.j]);
        if !self.drifts.contains_key(&flocks) {
            let found = self.hidden_drift(a.len())?;
            self.drifts.insert(flocks, found);
        }
        let drifts = &self.drifts[&flocks];
        if drifts.iter().all(|d| matches!(d, Magnitude::Zero)) {
            return Ok(());
        }
        let ([place], [Magnitude::Known(drift)]) = (a, drifts.as_slice()) else {
            return Err(SettleError::Unresolved);
        };
        if !excess.is_positive() {
            return Err(SettleError::Unresolved);
        }
        if Signed::sign(place) == Some(drift.sign) {
            all.parting += 1;
            return Ok(());
        }
        let gap = Rational::new(place.abs() - &self.motion.unit, self.motion.unit.clone());
        let gap = Interval::from_rational(&gap, drift.log2.precision());
        let log2_gap = gap.ln()?.over(&gap.integer(2).ln()?)?;
        all.slow_approaches.push(SlowApproach { pair: (self.i, self.j), log2_steps: log2_gap - &drift.log2 });
        Ok(())
    }

    /// Drift of the flock of `i` less that of the flock of `j`, where their rational parts agree, by coordinate.
    fn hidden_drift(&self, dimension: usize) -> Result<Vec<Magnitude>, SettleError> {
        let coordinate = |k: usize| {
            let unit: Vec<Rational> = (0..dimension).map(|l| rational(i64::from(k == l), 1)).collect();
            let difference = difference_functional(self.flock.birds(), (self.i, self.j), &unit)?;
            let velocities = difference.times_watched(&self.fixed.limit, self.progress)?;
            let positions = velocities.scaled(&rational(0, 1));
            value_of(self.stages, Functional { positions, velocities }, self.progress)
        };
        (0..dimension).map(coordinate).collect()
    }

    fn look_at_drift(&self, a: &[BigInt], b: &[BigInt], transient: Option<i64>, all: &mut Prospects) {
        let one = self.motion.unit.square();
        let coefficients = [dot(a, a) - &one, dot(a, b) * 2, dot(b, b)];
        // Reducing shortens the horizon; the divisors of long numbers take longer than the steps saved.
        let short = one.bits() < LONGEST_REDUCED;
        let content = if short { coefficients.iter().fold(one.clone(), |g, x| g.gcd(x)) } else { BigInt::from(1) };
        let scale = one / &content;
        let [a, b, c] = coefficients.map(|x| x / &content);
        let approach = Approach { pair: (self.i, self.j), a, b, c };
        // The polynomial q is zero or at least 1/scale in absolute value; transients below 1/(4 scale) cannot turn its sign.
        let latest = self.steps_until(transient, -(scale.bits() as i64) - 2);
        // Where q >= m > 0, transients below min(1, m)/4 are enough: 2 z sqrt(q + 1) + z² < q.
        let enough = |m: &BigInt, of: &BigInt| self.steps_until(transient, log2_below(m, &(of * &scale)).min(0) - 2);
        let horizon = match approach.least_before_contact(latest) {
            Some((least, divisor)) => enough(&least, &divisor).min(latest),
            None => latest,
        };
        all.horizon = all.horizon.max(horizon);
        all.approaches.push(approach);
    }
}

impl Approach {
    fn at(&self, s: &BigInt) -> BigInt {
        (&self.c * s + &self.b) * s + &self.a
    }

    /// A lower bound `m/divisor > 0` of the polynomial (times its scale) on all `s >= 0`, or on those up to half the way to the first
    /// contact where that half way takes at least `latest` steps.
    fn least_before_contact(&self, latest: u64) -> Option<(BigInt, BigInt)> {
        let one = BigInt::from(1);
        let least = match self.first_contact(&one) {
            // The polynomial falls until the contact.
            Some(contact) if contact > BigInt::from(latest) * 2 + 2 => (self.at(&(contact / 2)), one),
            Some(_) => return None,
            None if !self.b.is_negative() => (self.a.clone(), one),
            // The value at the vertex.
            None => (BigInt::from(4) * &self.a * &self.c - self.b.square(), BigInt::from(4) * &self.c),
        };
        least.0.is_positive().then_some(least)
    }

    /// The sign of the polynomial at `s`.
    pub fn sign_at(&self, s: &BigInt) -> Sign {
        Signed::sign(&self.at(s)).unwrap_or(Sign::Zero)
    }

    /// The first `s >= from` at which the polynomial is not positive.
    pub fn first_contact(&self, from: &BigInt) -> Option<BigInt> {
        if self.sign_at(from) != Sign::Positive {
            return Some(from.clone());
        }
        let discriminant = self.b.square() - BigInt::from(4) * &self.a * &self.c;
        if discriminant.is_negative() {
            return None;
        }
        // The smaller root is (-b - sqrt(discriminant))/(2c); the floor of the square root is at most 1 too small.
        let root = discriminant.sqrt();
        let before: BigInt = -&self.b - &root - 1;
        let mut s = before.div_floor(&(BigInt::from(2) * &self.c));
        if s < *from {
            // Positive at `from` and beyond the smaller root: beyond both.
            s = from.clone();
        }
        // The estimate is at most a few steps before the root.
        for _ in 0..4 {
            if self.sign_at(&s) != Sign::Positive {
                return Some(s);
            }
            s += 1;
        }
        None
    }
}
