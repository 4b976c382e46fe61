//! Campaigns over the invariants.

mod campaign;
mod replay;
mod summary;

pub use campaign::{Fuzz, FuzzError, MOST_CASES, one_case};
pub use replay::{Replay, ReplayError};
pub use summary::{Failed, InvariantSummary, Smallest, Summary, SummaryError};
