//! Mirrors `src/simulate`.

mod integrators;
mod phases;
mod statistics;
