//! The values of expressions.

pub use arithmetic::RealNumber as Number;
