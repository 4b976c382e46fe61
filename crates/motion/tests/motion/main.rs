//! Mirrors `src/`.

extern crate flockproof_motion as motion;

mod simulate;
mod validated;
