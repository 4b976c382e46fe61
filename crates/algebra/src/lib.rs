//! Exact matrices, graphs, and spectra with enclosures.

pub mod graph;
pub mod matrix;
pub mod spectrum;
