//! Mirrors `src/simulate`.

mod golden;
mod integrators;
mod sines;
mod statistics;
