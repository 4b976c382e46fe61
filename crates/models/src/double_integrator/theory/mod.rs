//! What is known of the laws: identities for all potentials, equilibria with their linearisations, rates along the network.

mod any_headings;
mod any_potentials;
pub mod equilibria;
mod linearisation;
pub mod relaxation;
mod tied;

pub use any_headings::AnyHeadings;
pub use any_potentials::{AnyPotentials, PairGradient};
pub use linearisation::{hessian, linearisation, loop_modes};
pub use tied::{TiedRate, rate_along, saturated_rate};
