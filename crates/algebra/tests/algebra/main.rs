//! Mirrors `src/`.

extern crate flockproof_algebra as algebra;

mod graph;
mod matrix;
mod spectrum;
