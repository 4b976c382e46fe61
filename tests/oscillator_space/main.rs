//! Particles with coupled phases and fish.

mod probe;
