//! Claims of Paley, Leonard, Sepulchre, Grünbaum and Parrish, Oscillator models and collective motion.

mod phase;
mod space;

pub use phase::{CyclicVariant, Kind};
pub(crate) use phase::{
    arrangements, critical_points, hessian, is_critical, is_on_a_line, linearisation, two_clusters,
};
pub use space::without_symmetries;

use ledger::Claim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn Claim>> {
    phase::claims().into_iter().chain(space::claims()).collect()
}
