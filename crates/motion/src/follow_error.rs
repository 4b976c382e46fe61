//! Why a motion ends early.

use super::IntegrationError;
use arithmetic::ArithmeticError;

/// Why a motion cannot be followed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FollowError {
    /// The integrator, or the series ends, as before a singularity.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// The law has no value.
    #[error("the law has no value near t = {time}: {error}")]
    Law {
        /// About when.
        time: f64,
        /// What was asked for.
        error: ArithmeticError,
    },
    /// Something switches without end, as a pair that stays at the radius.
    #[error("links switch without end at t = {0}: the motion along the switching distance is not followed")]
    Sliding(f64),
    /// The law jumps where the motion stays, as with dry friction or a rate that changes its sign at a threshold.
    #[error(
        "the law jumps without end near t = {0}: most steps are refused, and the motion along the jump is not followed; smooth the jump, or take fixed steps (`step` in [run])"
    )]
    Jumps(f64),
    /// A link of an agent with itself, or with one that is not there. Agents are counted from 0.
    #[error("agents {} and {} of {count} cannot be linked", pair.0, pair.1)]
    Link {
        /// The two.
        pair: (usize, usize),
        /// How many agents there are.
        count: usize,
    },
}
