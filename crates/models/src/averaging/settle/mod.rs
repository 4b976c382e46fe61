//! The settling decision (Chazelle, proof of Lemma 3.9): every switch of the network by exact jumps, and whether it can
//! ever change again.
//!
//! On a fixed network `x_i - x_j = A + B s - transients`, and the transients are halved every so many steps (`contraction`). So
//! after finitely many exact steps every pair without relative drift keeps its status for good (unless `|A| = 1`, where the
//! leading terms decide), and pairs with drift follow a quadratic polynomial in `s` whose roots are found exactly, however
//! far away they are. `notes/settling.md` has the argument.

mod cycle;
mod limits;
mod pairs;
mod perturbation;
mod ties;

use super::{FilteredFlock, Flock, FlockError, Switch, transition_matrix};
use algebra::graph::Graph;
use algebra::matrix::MatrixError;
use algebra::spectrum::RecurrenceError;
use arithmetic::{ArithmeticError, Cancelled, Interval, Progress, Rational, Sign, rational};
use limits::{FixedNetwork, Motion};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;
use pairs::{Approach, Prospects, prospects};
use perturbation::{Functional, Jump, Stage, difference_functional, value_of};
use std::sync::Arc;

/// Why a flock could not be followed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SettleError {
    /// The flock cannot go on.
    #[error(transparent)]
    Flock(FlockError),
    /// A matrix without a limit.
    #[error(transparent)]
    Matrix(MatrixError),
    /// A sign in the long run that is not decided.
    #[error(transparent)]
    Recurrence(RecurrenceError),
    /// An interval operation without a result.
    #[error(transparent)]
    Arithmetic(#[from] ArithmeticError),
    /// A network that contracts too slowly to be followed.
    #[error("the network contracts too slowly")]
    TooSlow,
    /// Contributions that cannot be told apart.
    #[error("contributions too small to be written as numbers decide, and they cannot be told apart")]
    Unresolved,
    /// Stopped by the caller.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A jump that does not pass its own check: never to be seen.
    #[error("the switch predicted for t = {0} does not pass the rule")]
    Inconsistent(String),
}

impl From<FlockError> for SettleError {
    fn from(error: FlockError) -> Self {
        match error {
            FlockError::Cancelled(stopped) => SettleError::Cancelled(stopped),
            other => SettleError::Flock(other),
        }
    }
}

impl From<MatrixError> for SettleError {
    fn from(error: MatrixError) -> Self {
        match error {
            MatrixError::Cancelled(stopped) => SettleError::Cancelled(stopped),
            other => SettleError::Matrix(other),
        }
    }
}

impl From<RecurrenceError> for SettleError {
    fn from(error: RecurrenceError) -> Self {
        match error {
            RecurrenceError::Cancelled(stopped) => SettleError::Cancelled(stopped),
            other => SettleError::Recurrence(other),
        }
    }
}

/// How far to go.
#[derive(Debug, Clone)]
pub struct Limits {
    /// Exact steps on one network.
    pub steps: u64,
    /// Switches in all.
    pub switches: usize,
    /// Bits to which the numbers of the state may grow in an exact jump; longer jumps keep what is left out as sequences.
    pub jump_bits: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Limits { steps: 400_000, switches: 100_000, jump_bits: 1 << 22 }
    }
}

/// How it ends.
#[derive(Debug, Clone)]
pub enum Ending {
    /// The network never changes again.
    Steady,
    /// The network repeats a cycle of this length forever.
    Alternating {
        /// Length of the cycle.
        period: usize,
    },
    /// The next switch comes, but at a time whose digits cannot be written down.
    Beyond {
        /// The pair that comes within distance 1 (from 0), or all that may be the first.
        pairs: Vec<(usize, usize)>,
        /// Encloses the binary logarithm of the time from the last switch on.
        log2_steps: Interval,
    },
    /// Not decided, and why.
    Undecided(String),
    /// Stopped by the caller.
    Interrupted,
}

/// What became of a flock.
#[derive(Debug, Clone)]
pub struct Settlement {
    /// The network after the last switch.
    pub network: Graph,
    /// The time of the last switch, 0 if there was none.
    pub last_switch: BigInt,
    /// How it ends.
    pub ending: Ending,
    /// Why.
    pub why: String,
}

/// Steps that are taken one by one after a switch before anything is analysed.
const PATIENCE: u64 = 48;

/// Certified bounds for all pairs at once are given up for exact limits after so many steps on one network: what these cost
/// grows with the cube of the number of birds, and a step by balls costs next to nothing.
fn patience_for_bounds(birds: usize) -> u64 {
    PATIENCE + (birds as u64).saturating_pow(3) / 4
}

/// Steps on one network until velocities should have settled so far that the balls can jump.
const PATIENCE_FOR_JUMPS: u64 = 8192;

/// Balls do not jump over more steps than this; beyond, exact limits are quicker.
const LONGEST_JUMP: u64 = 1 << 40;

/// The longest cycle of networks that is looked for.
const LONGEST_CYCLE: usize = 6;

/// Times a cycle is seen before it is analysed.
const REPETITIONS: usize = 6;

/// Follows a flock to its end; `found` sees every switch at once. Stopped by `progress`, it ends in [`Ending::Interrupted`] with the
/// network after the last switch that was found.
///
/// # Errors
/// [`SettleError`] where the flock is refused on its way.
pub fn settle(
    flock: Flock,
    limits: &Limits,
    found: &mut dyn FnMut(&Switch),
    progress: &dyn Progress,
) -> Result<Settlement, SettleError> {
    let mut course = Course::new(flock, progress);
    let (ending, why) = loop {
        match course.next(limits) {
            Err(SettleError::Cancelled(stopped)) => break (Ending::Interrupted, stopped.to_string()),
            Err(SettleError::Unresolved) => {
                let why = SettleError::Unresolved.to_string();
                break (Ending::Undecided(why.clone()), why);
            }
            Err(error) => return Err(error),
            // Found once more, after starting again.
            Ok(Next::Switch(switch)) if switch.time <= course.last_switch => {}
            Ok(Next::Switch(switch)) => {
                course.last_switch.clone_from(&switch.time);
                course.switches += 1;
                found(&switch);
                if course.switches >= limits.switches {
                    let why = format!("stopped after {} switches", limits.switches);
                    break (Ending::Undecided(why.clone()), why);
                }
                let cycle = match course.proved_cycle(limits) {
                    Err(SettleError::Cancelled(stopped)) => break (Ending::Interrupted, stopped.to_string()),
                    found => found?,
                };
                match cycle {
                    Cycle::None => {}
                    Cycle::Proved(period) => {
                        let why = format!(
                            "the networks repeat a cycle of {period}: if they do, every distance keeps its side of 1 at each \
                             phase, by the leading term of its recurrence"
                        );
                        break (Ending::Alternating { period }, why);
                    }
                    Cycle::TooFar(why) => break (Ending::Undecided(why.clone()), why),
                }
            }
            Ok(Next::Moved) => {}
            Ok(Next::End(ending, why)) => break (ending, why),
        }
    };
    let network = course.network().clone();
    Ok(Settlement { network, last_switch: course.last_switch, ending, why })
}

/// A flock on its way.
struct Course<'a> {
    /// The exact flock; behind the balls where there are some.
    flock: Flock,
    /// The flock stepped by balls, as long as nothing was left out.
    balls: Option<FilteredFlock>,
    /// Where to start again with exact numbers, should balls that have jumped not be enough.
    before_jumps: Option<FilteredFlock>,
    may_jump: bool,
    /// What happened since the last exact state; empty while the state is exact.
    stages: Vec<Stage>,
    /// The networks of the last steps, as long as switches follow one another closely.
    recent: Vec<Arc<Graph>>,
    last_switch: BigInt,
    switches: usize,
    /// A cycle is not looked for before so many switches.
    next_attempt: usize,
    progress: &'a dyn Progress,
}

/// Whether the networks go round for ever.
enum Cycle {
    None,
    Proved(usize),
    TooFar(String),
}

enum Next {
    Switch(Switch),
    /// Some steps later, nothing has changed: a contact that was an exact tie in the limit and is not reached.
    Moved,
    End(Ending, String),
}

impl<'a> Course<'a> {
    fn new(flock: Flock, progress: &'a dyn Progress) -> Self {
        Course {
            flock,
            balls: None,
            before_jumps: None,
            may_jump: true,
            stages: Vec::new(),
            recent: Vec::new(),
            last_switch: BigInt::ZERO,
            switches: 0,
            next_attempt: 0,
            progress,
        }
    }

    /// The network of now.
    fn network(&self) -> &Graph {
        self.balls.as_ref().map_or_else(|| self.flock.network(), FilteredFlock::network)
    }

    fn next(&mut self, limits: &Limits) -> Result<Next, SettleError> {
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
    fn next_by_balls(&mut self, limits: &Limits) -> Result<Option<Next>, SettleError> {
        if let Some(switch) = self.walk(PATIENCE)? {
            return Ok(Some(Next::Switch(switch)));
        }
        self.recent.clear();
        let Some(balls) = &self.balls else { return Ok(None) };
        let start = balls.time();
        let most = patience_for_bounds(balls.birds());
        let mut walked = PATIENCE;
        loop {
            let Some(balls) = &mut self.balls else { return Ok(None) };
            let Some(outlook) = balls.outlook(self.progress)? else { break };
            if outlook.is_steady() {
                let why = self.why_steady(outlook.drifting);
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
            if walked >= most.min(limits.steps) {
                break;
            }
            let steps = walked.min(limits.steps);
            if let Some(switch) = self.walk(steps)? {
                return Ok(Some(Next::Switch(switch)));
            }
            self.recent.clear();
            walked += steps;
        }
        if self.before_jumps.is_none()
            && let Some(balls) = self.balls.take()
        {
            self.flock = balls.into_exact(&start, self.progress)?;
        }
        Ok(None)
    }

    fn next_exactly(&mut self, limits: &Limits) -> Result<Next, SettleError> {
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
    fn mark(&self) -> (usize, u64) {
        let steps = match self.stages.last() {
            Some(Stage::Steps { steps, .. }) => *steps,
            _ => 0,
        };
        (self.stages.len(), steps)
    }

    /// Forgets the steps taken since a mark: a jump starts there.
    fn return_to(&mut self, (length, count): (usize, u64)) {
        self.stages.truncate(length);
        if let Some(Stage::Steps { steps, .. }) = self.stages.last_mut() {
            *steps = count;
        }
    }

    /// Why the network never changes again, with the number of pairs that have a relative drift.
    fn why_steady(&self, drifting: usize) -> String {
        let (birds, now) = match &self.balls {
            Some(balls) => (balls.birds(), balls.time()),
            None => (self.flock.birds(), self.flock.time().clone()),
        };
        if birds == 1 {
            return "one bird has no edges".to_string();
        }
        let drifting = match drifting {
            0 => "there is no pair with relative drift".to_string(),
            pairs => format!("the {pairs} pairs with relative drift never come within distance 1"),
        };
        format!(
            "checked step by step for {} steps after the last switch; from then on every pair without relative drift stays joined or \
             apart, because what is left of its motion is too small to change that, and {drifting}",
            now - &self.last_switch
        )
    }

    /// No switch comes at a time that can be written.
    fn end(&self, all: &Prospects) -> Next {
        let log2 = |interval: &Interval| interval.to_rationals();
        let Some(first) = all.creeps.iter().min_by(|a, b| log2(&a.log2_steps).0.cmp(&log2(&b.log2_steps).0)) else {
            let mut why = self.why_steady(all.approaches.len());
            if all.parting > 0 {
                why.push_str(&format!(
                    "; {} pairs of which the relative drift is too small to be written as a number move apart",
                    all.parting
                ));
            }
            return Next::End(Ending::Steady, why);
        };
        // All whose time may be as early.
        let latest = log2(&first.log2_steps).1;
        let may_be_first: Vec<_> = all.creeps.iter().filter(|c| log2(&c.log2_steps).0 <= latest).collect();
        let pairs: Vec<(usize, usize)> = may_be_first.iter().map(|c| c.pair).collect();
        let log2_steps = may_be_first.iter().fold(first.log2_steps.clone(), |hull, c| hull.hull(&c.log2_steps));
        let names: Vec<String> = pairs.iter().map(|(i, j)| format!("{} and {}", i + 1, j + 1)).collect();
        let why = format!(
            "birds {} approach at a speed too small to be written as a number; the time of contact is enclosed by its logarithm",
            names.join(", or ")
        );
        Next::End(Ending::Beyond { pairs, log2_steps }, why)
    }

    /// Steps, up to a number or the next switch.
    fn walk(&mut self, steps: u64) -> Result<Option<Switch>, SettleError> {
        for _ in 0..steps {
            self.progress.checkpoint()?;
            let switch = if self.stages.is_empty() {
                let balls = match &mut self.balls {
                    Some(balls) => balls,
                    none => none.insert(FilteredFlock::from_exact(self.flock.clone())?),
                };
                balls.step_watched(self.progress)?
            } else {
                self.careful_step()?
            };
            if self.recent.len() == 4 * LONGEST_CYCLE * REPETITIONS {
                self.recent.clear();
            }
            let same = self.recent.last().filter(|_| switch.is_none()).cloned();
            self.recent.push(same.unwrap_or_else(|| Arc::new(self.network().clone())));
            if switch.is_some() {
                return Ok(switch);
            }
        }
        Ok(None)
    }

    /// Whether what was left out is too small to change any comparison of numbers with denominators of so many bits, but for
    /// exact ties. Later jumps enlarge an older remainder by their number of steps at most, and steps by theirs.
    fn left_out_is_below(&self, bits: u64) -> Result<(), SettleError> {
        let enlarged: u64 = self.stages.iter().map(Stage::growth_bits).sum();
        let needed = BigInt::from(8 * bits + 8 * enlarged + 4096);
        let too_large = |stage: &Stage| matches!(stage, Stage::Jump(jump) if jump.smallness < needed);
        if self.stages.iter().any(too_large) { Err(SettleError::Unresolved) } else { Ok(()) }
    }

    /// A step of the rational part of a state of which something was left out: exact ties are decided by that.
    fn careful_step(&mut self) -> Result<Option<Switch>, SettleError> {
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
    fn is_beyond(&self, before: &Flock, (i, j): (usize, usize)) -> Result<bool, SettleError> {
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
    fn jump(
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
        if all.creeps.iter().any(|creep| creep.log2_steps.to_rationals().0 <= contact) {
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
    fn exact_jump(&self, fixed: &FixedNetwork, steps: &BigInt, limits: &Limits) -> Option<u64> {
        let growth = fixed.transition.denominator().bits();
        let largest = fixed.flocks.iter().map(Vec::len).max().unwrap_or(1) as u64;
        let few = steps.to_u64()?;
        let bits = few.checked_mul(growth)?.checked_add(self.flock.denominator_bits())?;
        (self.stages.is_empty() && bits <= limits.jump_bits && bits.checked_mul(largest * largest)? <= 1 << 29)
            .then_some(few)
    }

    /// A jump to the limit motion; what it leaves out is kept as a sequence.
    fn limit_jump(
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
        let mut state = super::flock::IntegerState {
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

    /// The exact flock of now, as long as it is within reach.
    fn exact(&mut self) -> Result<Option<Flock>, SettleError> {
        match &mut self.balls {
            Some(balls) if balls.has_jumped() => Ok(None),
            Some(balls) => Ok(Some(balls.exact(self.progress)?.clone())),
            None => Ok(Some(self.flock.clone())),
        }
    }

    /// Looks for a cycle in the recent networks and proves that it goes on forever.
    fn proved_cycle(&mut self, limits: &Limits) -> Result<Cycle, SettleError> {
        // Under hysteresis an edge that is lost again and again would need changes of distance that do not die out.
        if !self.stages.is_empty() || self.flock.threshold().log2_below().is_some() {
            return Ok(Cycle::None);
        }
        let recent = &self.recent;
        let repeats = |period: usize| {
            let seen = REPETITIONS * period;
            recent.len().is_multiple_of(2 * seen)
                && recent.len() >= 2 * seen
                && (recent.len() - seen..recent.len()).all(|k| recent[k] == recent[k - period])
        };
        let Some(period) = (2..=LONGEST_CYCLE).find(|&p| repeats(p)) else { return Ok(Cycle::None) };
        // Each attempt costs more than the one before.
        if self.switches < self.next_attempt {
            return Ok(Cycle::None);
        }
        self.next_attempt = 2 * self.switches;
        let cycle: Vec<Graph> = recent[recent.len() - period..].iter().map(|network| (**network).clone()).collect();
        let Some(flock) = self.exact()? else { return Ok(Cycle::None) };
        let horizon = match cycle::future(&flock, &cycle, limits.steps, self.progress) {
            Ok(cycle::Future::Keeps(horizon)) => horizon,
            Ok(cycle::Future::Until((i, j))) => {
                let why = format!(
                    "the networks repeat a cycle of {period}, and birds {} and {} approach, but come within distance 1 only after more \
                     steps than the limit of {}",
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
        let mut follower = FilteredFlock::from_exact(flock)?;
        for step in 0..horizon {
            self.progress.checkpoint()?;
            follower.step_watched(self.progress)?;
            if *follower.network() != cycle[(step as usize).mod_floor(&period)] {
                return Ok(Cycle::None);
            }
        }
        Ok(Cycle::Proved(period))
    }
}
