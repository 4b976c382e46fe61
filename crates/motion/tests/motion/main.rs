//! Mirrors `src/`.

mod simulate;
mod validated;
