//! How far a flock is followed, and how it can end.

use algebra::graph::Graph;
use arithmetic::Interval;
use num_bigint::BigInt;

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
