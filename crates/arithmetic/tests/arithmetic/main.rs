//! Mirrors `src/arithmetic`.

mod arb;
mod ball;
mod complex_dual_series;
mod identity;
mod interval;
mod number;
mod rational;
mod surd;
