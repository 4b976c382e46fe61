//! Networks that come again and again: proving that a cycle that was seen goes on for ever, and going round it.

use super::cycle::{Future, future};
use super::ending::Limits;
use super::error::SettleError;
use super::trajectory::Trajectory;
use crate::averaging::filtered::FilteredFlock;
use crate::averaging::flock::{Flock, Switch};
use algebra::graph::Graph;
use num_bigint::BigInt;
use num_integer::Integer;

/// Whether the networks go round for ever.
pub(super) enum Cycle {
    None,
    Proved(usize),
    TooFar(String),
    /// They follow the cycle for so many steps from this state on, and then somebody is near.
    For(Box<Round>),
}

/// Some steps round a cycle of networks.
pub(super) struct Round {
    pub cycle: Vec<Graph>,
    pub flock: Flock,
    pub steps: u64,
}

/// Fewer steps are taken one by one, with all decisions.
const SHORTEST_ROUND: u64 = 256;

impl Trajectory<'_> {
    /// Looks for a cycle in the recent networks and proves that it goes on forever.
    pub(super) fn proved_cycle(&mut self, limits: &Limits) -> Result<Cycle, SettleError> {
        // Under hysteresis an edge that is lost again and again would need changes of distance that do not die out.
        if !self.stages.is_empty() || self.flock.threshold().log2_below().is_some() {
            return Ok(Cycle::None);
        }
        let Some(period) = self.recent.period() else { return Ok(Cycle::None) };
        // Each attempt costs more than the one before.
        if self.switches < self.next_attempt {
            return Ok(Cycle::None);
        }
        self.next_attempt = 2 * self.switches;
        let cycle = self.recent.last(period, self.network());
        let Some(flock) = self.exact()? else { return Ok(Cycle::None) };
        let (horizon, until) = match future(&flock, &cycle, limits.steps, self.progress) {
            Ok(Future::Keeps(horizon)) => (horizon, None),
            Ok(Future::For { from, to }) if to < from.saturating_add(SHORTEST_ROUND) => return Ok(Cycle::None),
            Ok(Future::For { from, to }) => (from, Some(to)),
            Ok(Future::Until((i, j))) => {
                let why = format!(
                    "the networks repeat a cycle of {period}, and birds {} and {} approach one another: whether that ends the cycle is not \
                     decided within the limit of {} steps",
                    i + 1,
                    j + 1,
                    limits.steps
                );
                return Ok(Cycle::TooFar(why));
            }
            Err(SettleError::Cancelled(stopped)) => return Err(stopped.into()),
            _ => return Ok(Cycle::None),
        };
        if horizon > limits.steps {
            let why = format!(
                "the networks repeat a cycle of {period}, which would have to be followed for {horizon} steps to be proved, more than \
                 the limit of {}",
                limits.steps
            );
            return Ok(Cycle::TooFar(why));
        }
        // Until the horizon the networks have to keep to the cycle too.
        let mut follower = FilteredFlock::from_exact(flock.clone())?;
        for step in 0..horizon {
            self.progress.checkpoint()?;
            follower.step(self.progress)?;
            if *follower.network() != cycle[(step as usize).mod_floor(&period)] {
                return Ok(Cycle::None);
            }
        }
        Ok(until.map_or(Cycle::Proved(period), |steps| Cycle::For(Box::new(Round { cycle, flock, steps }))))
    }

    /// Goes round a cycle as long as it is known to go on, without a decision about any distance: only the exact numbers are kept up. All
    /// switches are reported; stops at the limit of their number, and says so. Stopped by the caller, it is where the last switch was.
    pub(super) fn go_round(
        &mut self,
        Round { cycle, mut flock, steps }: Round,
        limits: &Limits,
        found: &mut dyn FnMut(&Switch),
    ) -> Result<bool, SettleError> {
        let before = |k: usize| &cycle[(k + cycle.len() - 1) % cycle.len()];
        let mut switches: Vec<Switch> =
            (0..cycle.len()).map(|k| Switch::between(before(k), &cycle[k], BigInt::ZERO)).collect();
        let mut within = Ok(true);
        for phase in (0..cycle.len()).cycle().take(usize::try_from(steps).unwrap_or(usize::MAX)) {
            if let Err(stopped) = self.progress.checkpoint() {
                within = Err(stopped.into());
                break;
            }
            flock.step_on(&cycle[phase])?;
            let switch = &mut switches[phase];
            if switch.gained.is_empty() && switch.lost.is_empty() {
                continue;
            }
            switch.time.clone_from(flock.time());
            self.last_switch.clone_from(flock.time());
            self.switches += 1;
            found(switch);
            if self.switches >= limits.switches {
                within = Ok(false);
                break;
            }
        }
        self.flock = flock;
        (self.balls, self.before_jumps) = (None, None);
        self.recent.clear();
        within
    }
}
