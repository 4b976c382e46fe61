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
mod remainder;
mod repetition;
mod ties;
mod trajectory;
mod verdict;

use super::{Flock, FlockError, Switch};
use algebra::graph::Graph;
use algebra::matrix::MatrixError;
use algebra::spectrum::RecurrenceError;
use arithmetic::{ArithmeticError, Cancelled, Interval, Progress};
use num_bigint::BigInt;
use repetition::Cycle;
use trajectory::{Next, Trajectory};

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
    let mut trajectory = Trajectory::new(flock, progress);
    let (ending, why) = loop {
        match trajectory.next(limits) {
            Err(SettleError::Cancelled(stopped)) => break (Ending::Interrupted, stopped.to_string()),
            Err(SettleError::Unresolved) => {
                let why = SettleError::Unresolved.to_string();
                break (Ending::Undecided(why.clone()), why);
            }
            Err(error) => return Err(error),
            // Found once more, after starting again.
            Ok(Next::Switch(switch)) if switch.time <= trajectory.last_switch => {}
            Ok(Next::Switch(switch)) => {
                trajectory.last_switch.clone_from(&switch.time);
                trajectory.switches += 1;
                found(&switch);
                let enough = || {
                    let why = format!("stopped after {} switches", limits.switches);
                    (Ending::Undecided(why.clone()), why)
                };
                if trajectory.switches >= limits.switches {
                    break enough();
                }
                let cycle = match trajectory.proved_cycle(limits) {
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
                    Cycle::For(round) => match trajectory.go_round(*round, limits, found) {
                        Err(SettleError::Cancelled(stopped)) => break (Ending::Interrupted, stopped.to_string()),
                        Ok(true) => {}
                        Ok(false) => break enough(),
                        Err(error) => return Err(error),
                    },
                }
            }
            Ok(Next::Moved) => {}
            Ok(Next::End(ending, why)) => break (ending, why),
        }
    };
    let network = trajectory.network().clone();
    Ok(Settlement { network, last_switch: trajectory.last_switch, ending, why })
}
