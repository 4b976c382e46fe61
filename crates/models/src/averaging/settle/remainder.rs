//! Steps and jumps of a flock of which something was left out: a jump goes to the limit motion, and what it leaves out decides exact ties.

use super::ending::Limits;
use super::error::SettleError;
use super::limits::{FixedNetwork, Motion};
use super::pairs::{Approach, Prospects};
use super::perturbation::{Functional, Jump, Stage, difference_functional, value_of};
use super::trajectory::{Next, Trajectory};
use crate::averaging::flock::{Flock, IntegerState, Switch};
use crate::averaging::weights::transition_matrix;
use algebra::graph::Graph;
use arithmetic::{Rational, Sign, rational};
use num_bigint::BigInt;
use num_traits::ToPrimitive;

impl Trajectory<'_> {
    /// Whether what was left out is too small to change any comparison of numbers with denominators of so many bits, but for
    /// exact ties. Later jumps enlarge an older remainder by their number of steps at most, and steps by theirs.
    pub(super) fn left_out_is_below(&self, bits: u64) -> Result<(), SettleError> {
        let enlarged: u64 = self.stages.iter().map(Stage::growth_bits).sum();
        let needed = BigInt::from(8 * bits + 8 * enlarged + 4096);
        let too_large = |stage: &Stage| matches!(stage, Stage::Jump(jump) if jump.smallness < needed);
        if self.stages.iter().any(too_large) { Err(SettleError::Unresolved) } else { Ok(()) }
    }

    /// A step of the rational part of a state of which something was left out: exact ties are decided by that.
    pub(super) fn careful_step(&mut self) -> Result<Option<Switch>, SettleError> {
        self.left_out_is_below(self.flock.denominator_bits())?;
        let before = self.flock.clone();
        let mut switch = self.flock.step()?;
        if self.flock.threshold().log2_below().is_some() {
            // A change of distance could tie with the threshold.
            let near = self.flock.distance_network();
            if before.network().edges().into_iter().any(|(i, j)| !near.has_edge(i, j)) {
                return Err(SettleError::Unresolved);
            }
        }
        if !self.flock.ties().is_empty() {
            let mut network = self.flock.network().clone();
            for &(i, j) in self.flock.ties() {
                if self.is_beyond(&before, (i, j))? {
                    if before.network().has_edge(i, j) && self.flock.threshold().log2_below().is_some() {
                        return Err(SettleError::Unresolved);
                    }
                    network = Graph::from_fn(network.order(), |a, b| (a, b) != (i, j) && network.has_edge(a, b));
                }
            }
            if network != *self.flock.network() {
                self.flock = before.clone();
                self.flock.step_on(&network)?;
                let changed = network != *before.network();
                switch = changed.then(|| Switch::between(before.network(), &network, self.flock.time().clone()));
            }
        }
        match self.stages.last_mut() {
            Some(Stage::Steps { network, steps, .. }) if network == self.flock.network() => *steps += 1,
            _ => {
                let transition = transition_matrix(self.flock.network(), self.flock.weights())?;
                self.stages.push(Stage::Steps { network: self.flock.network().clone(), transition, steps: 1 });
            }
        }
        Ok(switch)
    }

    /// Whether two birds at distance exactly 1 in the rational part are in truth farther apart; `before` is one step earlier.
    pub(super) fn is_beyond(&self, before: &Flock, (i, j): (usize, usize)) -> Result<bool, SettleError> {
        if self.flock.dimension() > 1 {
            // The second order of what was left out can outweigh the first.
            return Err(SettleError::Unresolved);
        }
        let unit = self.flock.denominator();
        let over = |x| Rational::new(x, unit.clone());
        let difference: Vec<_> = self.flock.position_difference(i, j).into_iter().map(over).collect();
        // Positions after the move are x + v of one step earlier.
        let positions = difference_functional(before.birds(), (i, j), &difference)?;
        let functional = Functional { velocities: positions.clone(), positions };
        Ok(value_of(&self.stages, functional, self.progress)?.sign() == Sign::Positive)
    }

    /// Jumps to the contact `steps` after `start`, where `motion` began.
    pub(super) fn jump(
        &mut self,
        fixed: &FixedNetwork,
        motion: &Motion,
        all: &Prospects,
        start: &BigInt,
        steps: BigInt,
        limits: &Limits,
    ) -> Result<Next, SettleError> {
        // Whatever approaches too slowly for numbers has to come later.
        let contact = Rational::from_integer(BigInt::from(steps.bits() + 1));
        if all.slow_approaches.iter().any(|slow| slow.log2_steps.to_rationals().0 <= contact) {
            return Err(SettleError::Unresolved);
        }
        let time = start + &steps;
        let straight = self.stages.is_empty() && motion.is_straight();
        if let Some(few) = self.exact_jump(fixed, &steps, limits).filter(|_| !straight) {
            // The state one step before, then a step by the rule itself.
            let state = motion.state_after(fixed, few - 1, self.progress)?;
            self.flock = self.flock.moved_to(&state, fixed.network.clone(), &time - 1)?;
            self.balls = None;
            return match self.flock.step()? {
                Some(switch) => Ok(Next::Switch(switch)),
                None if all.approaches.iter().any(|a| a.sign_at(&steps) == Sign::Zero) => Ok(Next::Moved),
                None => Err(SettleError::Inconsistent(time.to_string())),
            };
        }
        self.limit_jump(fixed, motion, &all.approaches, time, steps)
    }

    /// The number of steps, where the state after them is short enough to be written exactly.
    pub(super) fn exact_jump(&self, fixed: &FixedNetwork, steps: &BigInt, limits: &Limits) -> Option<u64> {
        let growth = fixed.transition.denominator().bits();
        let largest = fixed.flocks.iter().map(Vec::len).max().unwrap_or(1) as u64;
        let few = steps.to_u64()?;
        let bits = few.checked_mul(growth)?.checked_add(self.flock.denominator_bits())?;
        (self.stages.is_empty() && bits <= limits.jump_bits && bits.checked_mul(largest * largest)? <= 1 << 29)
            .then_some(few)
    }

    /// A jump to the limit motion; what it leaves out is kept as a sequence.
    pub(super) fn limit_jump(
        &mut self,
        fixed: &FixedNetwork,
        motion: &Motion,
        approaches: &[Approach],
        time: BigInt,
        steps: BigInt,
    ) -> Result<Next, SettleError> {
        let jump = Jump::new(fixed, motion, steps.clone(), self.progress)?;
        let mut joined = Vec::new();
        let mut ties = Vec::new();
        for approach in approaches {
            // One step before, all are apart.
            if approach.sign_at(&(&steps - 1)) != Sign::Positive {
                return Err(SettleError::Inconsistent(time.to_string()));
            }
            match approach.sign_at(&steps) {
                Sign::Positive => {}
                Sign::Negative => joined.push(approach.pair),
                Sign::Zero => ties.push(approach.pair),
            }
        }
        let mut state = IntegerState {
            positions: motion.place.clone(),
            velocities: motion.drift.clone(),
            unit: motion.unit.clone(),
        };
        for (row, drift) in state.positions.iter_mut().zip(&motion.drift) {
            row.iter_mut().zip(drift).for_each(|(x, d)| *x += d * &steps);
        }
        state.reduce(self.progress)?;
        // Where all velocities have their limits nothing is left out, and the state stays exact.
        let exact = self.stages.is_empty() && motion.is_straight();
        if exact {
            joined.append(&mut ties);
        } else {
            self.stages.push(Stage::Jump(Box::new(jump)));
        }
        if !ties.is_empty() && self.flock.dimension() > 1 {
            // The second order of what was left out can outweigh the first.
            return Err(SettleError::Unresolved);
        }
        for (i, j) in ties {
            let unit = &state.unit;
            let place = |b: usize, k: usize| &state.positions[b][k];
            let difference: Vec<_> =
                (0..self.flock.dimension()).map(|k| Rational::new(place(i, k) - place(j, k), unit.clone())).collect();
            let positions = difference_functional(self.flock.birds(), (i, j), &difference)?;
            let velocities = positions.scaled(&rational(0, 1));
            let value = value_of(&self.stages, Functional { positions, velocities }, self.progress)?;
            match value.sign() {
                Sign::Negative => joined.push((i, j)),
                Sign::Zero => joined.push((i, j)),
                Sign::Positive => {}
            }
        }
        let network = fixed.network.with_edges(&joined);
        let transition = transition_matrix(&network, self.flock.weights())?;
        // The last averaging of the jump is that of the new network.
        let mut averaged = self.flock.moved_to(&state, network.clone(), time.clone())?;
        averaged.average_again();
        self.flock = averaged;
        self.balls = None;
        if !exact {
            self.stages.push(Stage::Average(transition));
        }
        if joined.is_empty() {
            return Ok(Next::Moved);
        }
        Ok(Next::Switch(Switch::between(&fixed.network, &network, time)))
    }
}
