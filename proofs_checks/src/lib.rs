//! What is proved outside the program: the Coq development, and exact results as certificates for a separate checker.

pub mod certificates;
pub mod kernel;
