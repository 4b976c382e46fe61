//! Mirrors `src/`.

extern crate flockproof_motion as motion;

mod enclose;
mod simulate;
