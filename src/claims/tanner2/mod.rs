//! Claims of Tanner, Jadbabaie and Pappas, Flocking in fixed and switching networks.

use crate::ledger::AnyClaim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn AnyClaim>> {
    vec![]
}
