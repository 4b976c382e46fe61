//! Mirrors `src/simulate`.

mod integrators;
mod sines;
mod statistics;
