//! Mirrors `src/`.

extern crate flockproof_models as models;

mod angles;
mod averaging;
mod cells;
mod double_integrator;
mod individual;
mod laws_of_agents;
mod missing;
mod oscillator;
mod oscillator_space;
mod platoon;
mod tracks;
