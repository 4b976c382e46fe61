//! Claims of Paley, Leonard, Sepulchre, Grünbaum and Parrish, Oscillator models and collective motion.

mod phase;
mod space;

pub use phase::CyclicVariant;

use ledger::Claim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn Claim>> {
    phase::claims().into_iter().chain(space::claims()).collect()
}
