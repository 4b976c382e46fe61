//! Mirrors `src/simulate`.

mod golden;
mod integrators;
mod series;
mod sines;
mod statistics;
