//! The settling decision (Chazelle, proof of Lemma 3.9): every switch of the network by exact jumps, and whether it can
//! ever change again.
//!
//! On a fixed network `x_i - x_j = A + B s - transients`, and the transients are halved every so many steps (`contraction`). So
//! after finitely many exact steps every pair without relative drift keeps its status for good (unless `|A| = 1`, where the
//! leading terms decide), and pairs with drift follow a quadratic polynomial in `s` whose roots are found exactly, however
//! far away they are. `notes/settling.md` has the argument.

mod cycle;
mod ending;
mod error;
mod limits;
mod pairs;
mod perturbation;
mod recent;
mod remainder;
mod repetition;
mod ties;
mod trajectory;
mod verdict;

pub use ending::{Ending, Limits, Settlement};
pub use error::SettleError;

use super::flock::{Flock, Switch};
use arithmetic::Progress;
use repetition::Cycle;
use trajectory::{Next, Trajectory};

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
