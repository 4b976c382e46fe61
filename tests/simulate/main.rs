//! Mirrors `src/simulate`.

mod cells;
mod integrators;
mod phases;
mod statistics;
