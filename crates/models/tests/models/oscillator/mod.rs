//! Oscillators: potentials against their definitions, controls against gradients, exact patterns.

mod all_to_all;
mod critical;
mod fields;
mod laws;
