//! Mirrors `src/arithmetic`.

extern crate flockproof_arithmetic as arithmetic;

mod arb;
mod ball;
mod complex_dual_series;
mod degree;
mod enclosure;
mod float;
mod float_interval;
mod identity;
mod identity_search;
mod interval;
mod number;
mod progress;
mod radical;
mod random;
mod rational;
mod real_cyclotomic;
mod rounding;
mod small_arguments;
mod surd;
