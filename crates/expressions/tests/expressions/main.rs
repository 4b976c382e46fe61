//! Tests of the language of laws.

mod errors;
mod laws;
mod twin;
