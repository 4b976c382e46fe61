//! What is to come, in the order of time.

use super::Pair;
use std::cmp::Ordering;

/// What happens next: the end of the series of `pair.0 = pair.1`, or an arrival of a pair at the radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Next {
    pub time: f64,
    pub pair: Pair,
    /// How often these were restarted when this was found; it is void if they were restarted since.
    pub restarts: (u32, u32),
}

impl Eq for Next {}

impl PartialOrd for Next {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Next {
    fn cmp(&self, other: &Self) -> Ordering {
        self.time.total_cmp(&other.time).then(self.pair.cmp(&other.pair)).then(self.restarts.cmp(&other.restarts))
    }
}
