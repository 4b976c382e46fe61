//! What is to come, in the order of time.

use std::cmp::Ordering;

/// What happens.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// The series of an agent ends, which is both of the pair.
    End,
    /// A pair comes to the radius.
    Radius,
    /// One that an agent does not sense comes as near as one that it senses; the agent is both of the pair.
    Rank,
    /// The angle of an agent, which is both of the pair, or the difference of the angles of a pair, comes to half a turn.
    Turn,
}

/// What happens next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Next {
    pub time: f64,
    pub pair: (usize, usize),
    pub kind: Kind,
    /// How often these were restarted when this was found, for a rank how often it was looked for; it is void if that has changed since.
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
        let rest = |next: &Next| (next.pair, next.kind, next.restarts);
        self.time.total_cmp(&other.time).then(rest(self).cmp(&rest(other)))
    }
}
