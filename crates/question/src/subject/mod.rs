//! What quantities are measured on.

pub(crate) mod graph;
