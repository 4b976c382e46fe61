//! Claims about particles in the plane and fish: (1)-(5), (17)-(22), (26)-(29).

use crate::ledger::AnyClaim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn AnyClaim>> {
    vec![]
}
