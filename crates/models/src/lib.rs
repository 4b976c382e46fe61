//! The models of the five papers, each law written once over the scalar traits of `arithmetic`.

/// Crates that stand in signatures.
pub use algebra::faer;
pub use rand_chacha;

pub mod angles;
pub mod averaging;
pub mod double_integrator;
pub mod oscillator;
pub mod platoon;
pub mod tracks;
