//! A flock on its way: steps by balls, by exact numbers, and jumps from switch to switch.

use super::ending::{Ending, Limits};
use super::error::SettleError;
use super::limits::{FixedNetwork, Motion};
use super::pairs::prospects;
use super::perturbation::Stage;
use super::recent::Recent;
use crate::averaging::filtered::FilteredFlock;
use crate::averaging::flock::{Flock, Switch};
use crate::averaging::weights::FlockError;
use algebra::graph::Graph;
use arithmetic::Progress;
use num_bigint::BigInt;

/// Steps that are taken one by one after a switch before anything is analysed.
const PATIENCE: u64 = 48;

/// More are never taken.
const MOST_PATIENCE: u64 = 4096;

/// Certified bounds for all pairs at once are given up for exact limits after so many steps on one network: what these cost
/// grows with the cube of the number of birds, and a step by balls costs next to nothing.
fn patience_for_bounds(birds: usize) -> u64 {
    PATIENCE + (birds as u64).saturating_pow(3) / 4
}

/// Steps on one network until velocities should have settled so far that the balls can jump.
const PATIENCE_FOR_JUMPS: u64 = 8192;

/// Balls do not jump over more steps than this; beyond, exact limits are quicker.
const LONGEST_JUMP: u64 = 1 << 40;

/// A flock on its way.
pub(super) struct Trajectory<'a> {
    /// The exact flock; behind the balls where there are some.
    pub(super) flock: Flock,
    /// The flock stepped by balls, as long as nothing was left out.
    pub(super) balls: Option<FilteredFlock>,
    /// Where to start again with exact numbers, should balls that have jumped not be enough.
    pub(super) before_jumps: Option<FilteredFlock>,
    pub(super) may_jump: bool,
    /// What happened since the last exact state; empty while the state is exact.
    pub(super) stages: Vec<Stage>,
    pub(super) recent: Recent,
    pub(super) last_switch: BigInt,
    pub(super) switches: usize,
    /// A cycle is not looked for before so many switches.
    pub(super) next_attempt: usize,
    /// Steps that were taken one by one.
    pub(super) walked: u64,
    /// Settled flocks are not looked for before so many of them.
    pub(super) next_look: u64,
    pub(super) progress: &'a dyn Progress,
}

/// What comes next.
pub(super) enum Next {
    Switch(Switch),
    /// Some steps later, nothing has changed: a contact that was an exact tie in the limit and is not reached.
    Moved,
    End(Ending, String),
}

impl<'a> Trajectory<'a> {
    pub(super) fn new(flock: Flock, progress: &'a dyn Progress) -> Self {
        Trajectory {
            flock,
            balls: None,
            before_jumps: None,
            may_jump: true,
            stages: Vec::new(),
            recent: Recent::default(),
            last_switch: BigInt::ZERO,
            switches: 0,
            next_attempt: 0,
            walked: 0,
            next_look: PATIENCE,
            progress,
        }
    }

    /// The network of now.
    pub(super) fn network(&self) -> &Graph {
        self.balls.as_ref().map_or_else(|| self.flock.network(), FilteredFlock::network)
    }

    pub(super) fn next(&mut self, limits: &Limits) -> Result<Next, SettleError> {
        match self.next_by_balls(limits) {
            Err(SettleError::Flock(FlockError::Undecided { .. })) => {}
            Ok(Some(next)) => return Ok(next),
            Ok(None) => {}
            Err(error) => return Err(error),
        }
        if let Some(start) = self.before_jumps.take() {
            // Exact numbers are needed that the jumps have left behind: the whole way again, without them.
            self.balls = Some(start);
            self.may_jump = false;
            self.recent.clear();
            return Ok(Next::Moved);
        }
        self.next_exactly(limits)
    }

    /// The next switch or the end, where the balls show it; otherwise the exact flock is brought to some steps after the last switch.
    pub(super) fn next_by_balls(&mut self, limits: &Limits) -> Result<Option<Next>, SettleError> {
        self.leave_settled()?;
        let patience = self.patience();
        if let Some(switch) = self.walk(patience)? {
            return Ok(Some(Next::Switch(switch)));
        }
        self.recent.clear();
        let Some(balls) = &self.balls else { return Ok(None) };
        let start = balls.time();
        let most = patience_for_bounds(balls.birds()).max(patience);
        let (mut walked, mut decided) = (patience, patience);
        loop {
            let Some(balls) = &mut self.balls else { return Ok(None) };
            let Some(outlook) = balls.outlook(self.progress)? else { break };
            if outlook.is_steady() {
                let why = self.why_steady(outlook.drifting, outlook.looked);
                return Ok(Some(Next::End(Ending::Steady, why)));
            }
            let far = self.may_jump && outlook.quiet > 2 * walked;
            if far {
                let before = self.before_jumps.is_none().then(|| balls.clone());
                if outlook.quiet <= LONGEST_JUMP && balls.jump(outlook.quiet) {
                    self.before_jumps = self.before_jumps.take().or(before);
                    walked = PATIENCE;
                    continue;
                }
            }
            // A jump needs velocities that have settled.
            let most = if far && outlook.quiet <= LONGEST_JUMP { 16 * most + PATIENCE_FOR_JUMPS } else { most };
            if walked >= most || decided >= limits.steps {
                break;
            }
            // What is certain needs no look at the pairs.
            let certain = outlook.quiet.min(most - walked).min(4 * walked);
            balls.coast(certain, self.progress)?;
            let steps = if certain >= walked { PATIENCE } else { walked }.min(limits.steps);
            if let Some(switch) = self.walk(steps)? {
                return Ok(Some(Next::Switch(switch)));
            }
            self.recent.clear();
            decided += steps;
            walked += certain + steps;
        }
        if self.before_jumps.is_none()
            && let Some(balls) = self.balls.take()
        {
            self.flock = balls.into_exact(&start, self.progress)?;
        }
        Ok(None)
    }

    /// After many switches more steps are taken before anything is analysed: as many as cost little beside those that were taken.
    fn patience(&self) -> u64 {
        if self.stages.is_empty() { (self.walked / 64).clamp(PATIENCE, MOST_PATIENCE) } else { PATIENCE }
    }

    /// Leaves settled flocks behind, now and then: at a part of the cost of the steps that were taken.
    fn leave_settled(&mut self) -> Result<(), SettleError> {
        if let Some(balls) = &mut self.balls
            && self.walked >= self.next_look
        {
            balls.leave_settled(PATIENCE + self.walked / 4, self.progress)?;
            self.next_look = self.walked + PATIENCE + self.walked / 4;
        }
        Ok(())
    }

    pub(super) fn next_exactly(&mut self, limits: &Limits) -> Result<Next, SettleError> {
        let fixed = FixedNetwork::new(self.flock.network(), self.flock.weights(), self.progress)?;
        let motion = Motion::new(&fixed, &self.flock.integers(), self.progress)?;
        let start = self.flock.time().clone();
        let mark = self.mark();
        self.left_out_is_below(motion.unit.bits())?;
        let all = prospects(&self.flock, &fixed, &motion, &self.stages, self.progress)?;
        // A contact that comes before the horizon is met on the way there.
        if let Some(switch) = self.walk(all.horizon.min(limits.steps))? {
            return Ok(Next::Switch(switch));
        }
        if all.horizon > limits.steps {
            let why = format!(
                "{} exact steps would be needed on one network, more than the limit of {}",
                all.horizon, limits.steps
            );
            return Ok(Next::End(Ending::Undecided(why.clone()), why));
        }
        if let Some(why) = all.open {
            return Ok(Next::End(Ending::Undecided(why.clone()), why));
        }
        let from = BigInt::from(all.horizon) + 1;
        let contacts = all.approaches.iter().filter_map(|a| a.first_contact(&from));
        match contacts.min() {
            Some(steps) => {
                self.return_to(mark);
                self.jump(&fixed, &motion, &all, &start, steps, limits)
            }
            None => Ok(self.end(&all)),
        }
    }

    /// Where the list of stages ends now: its length and the steps of the last one.
    pub(super) fn mark(&self) -> (usize, u64) {
        let steps = match self.stages.last() {
            Some(Stage::Steps { steps, .. }) => *steps,
            _ => 0,
        };
        (self.stages.len(), steps)
    }

    /// Forgets the steps taken since a mark: a jump starts there.
    pub(super) fn return_to(&mut self, (length, count): (usize, u64)) {
        self.stages.truncate(length);
        if let Some(Stage::Steps { steps, .. }) = self.stages.last_mut() {
            *steps = count;
        }
    }

    /// Steps, up to a number or the next switch.
    pub(super) fn walk(&mut self, steps: u64) -> Result<Option<Switch>, SettleError> {
        for _ in 0..steps {
            self.progress.checkpoint()?;
            let switch = if self.stages.is_empty() {
                let balls = match &mut self.balls {
                    Some(balls) => balls,
                    none => none.insert(FilteredFlock::from_exact(self.flock.clone())?),
                };
                balls.step(self.progress)?
            } else {
                self.careful_step()?
            };
            self.walked += 1;
            self.recent.push(switch.as_ref());
            if switch.is_some() {
                return Ok(switch);
            }
        }
        Ok(None)
    }

    /// The exact flock of now, as long as it is within reach.
    pub(super) fn exact(&mut self) -> Result<Option<Flock>, SettleError> {
        match &mut self.balls {
            Some(balls) if balls.has_jumped() => Ok(None),
            Some(balls) => Ok(Some(balls.exact(self.progress)?.clone())),
            None => Ok(Some(self.flock.clone())),
        }
    }
}
