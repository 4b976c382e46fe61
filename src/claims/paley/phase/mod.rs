//! Claims about phases: the phase model, its potentials and the graphs (equations (7)-(16), (23)-(25)).

use crate::ledger::AnyClaim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn AnyClaim>> {
    vec![]
}
