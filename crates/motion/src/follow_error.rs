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
    /// A link of an agent with itself, or with one that is not there. Agents are counted from 0.
    #[error("agents {} and {} of {count} cannot be linked", pair.0, pair.1)]
    Link {
        /// The two.
        pair: (usize, usize),
        /// How many agents there are.
        count: usize,
    },
}
