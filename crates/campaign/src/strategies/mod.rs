//! Generators: functions of [`Draws`] that give matrices, graphs, flocks, states and numbers. With all draws 0 they give the simplest.
//!
//! With the feature `proptest`, `strategy` of its module `proptest` makes a strategy of any of them.

mod flocks;
mod graphs;
mod matrices;
mod numbers;
#[cfg(feature = "proptest")]
pub mod proptest;
mod states;

pub use flocks::{flock, long_flock, start};
pub use graphs::{connected_graph, digraph, graph, permutation, tracking};
pub use matrices::{rational_matrix, stochastic, stochastic_sequence, symmetric};
pub use numbers::{fraction, integer, positive};
pub use states::{phasors, platoon_gains, potential, separated_state, unit_phasor};

use crate::draws::Draws;

/// A list of what `each` gives.
pub fn list<T>(draws: &mut Draws, length: usize, mut each: impl FnMut(&mut Draws) -> T) -> Vec<T> {
    (0..length).map(|_| each(draws)).collect()
}
