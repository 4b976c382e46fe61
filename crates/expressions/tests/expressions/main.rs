//! Tests of the language of laws.

extern crate flockproof_expressions as expressions;

mod errors;
mod laws;
mod rates;
mod twin;
