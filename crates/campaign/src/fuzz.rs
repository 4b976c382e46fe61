//! Campaigns over the invariants, and over questions of one's own.

mod attack;
mod campaign;
mod replay;
mod summary;

pub use attack::Attack;
pub use campaign::{Fuzz, FuzzError, MOST_CASES, one_case};
pub use replay::{Again, Replay, ReplayError};
pub use summary::{Failed, InvariantSummary, Smallest, Summary, SummaryError};
