//! Mirrors `src/`.

mod angles;
mod averaging;
mod cells;
mod double_integrator;
mod missing;
mod oscillator;
mod oscillator_space;
mod platoon;
mod tracks;
