//! What quantities are measured on.

pub(crate) mod flock;
pub(crate) mod graph;
pub(crate) mod matrices;
pub(crate) mod measured;
pub(crate) mod motion;
pub(crate) mod platoon;
pub(crate) mod run;
pub(crate) mod steps;
