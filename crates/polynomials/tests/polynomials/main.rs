//! Mirrors `src/`.

extern crate flockproof_polynomials as polynomials;

mod decide;
mod random;
mod sums;
