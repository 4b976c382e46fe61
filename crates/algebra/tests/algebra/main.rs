//! Mirrors `src/`.

mod graph;
mod matrix;
mod spectrum;
