//! Oscillators: potentials against their definitions, controls against gradients, exact patterns.

mod fields;
mod laws;
