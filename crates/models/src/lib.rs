//! The models of the five papers, each law written once over the scalar traits of `arithmetic`.

pub mod angles;
pub mod averaging;
pub mod double_integrator;
pub mod oscillator;
pub mod platoon;
pub mod tracks;
