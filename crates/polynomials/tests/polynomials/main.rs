//! Mirrors `src/`.

extern crate flockproof_polynomials as polynomials;

mod attained;
mod campaign;
mod decide;
mod ends;
mod expression;
mod functions;
mod hostile;
mod random;
mod solutions;
mod sums;
mod threads;
