//! Claims of Tanner, Jadbabaie and Pappas, Stable flocking of mobile agents, part I: fixed topology.

use crate::ledger::AnyClaim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn AnyClaim>> {
    vec![]
}
