//! Exact matrices, graphs, and spectra with enclosures.

/// Crates that stand in signatures.
pub use dense::faer;
pub use num_bigint;

pub mod graph;
pub mod json;
pub mod matrix;
pub mod spectrum;
