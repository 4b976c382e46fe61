//! Mirrors `src/simulate`.

mod golden;
mod integrators;
mod phases;
mod statistics;
