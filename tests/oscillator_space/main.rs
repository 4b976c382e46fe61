//! Particles with coupled phases and fish.

mod laws;
mod networks;
mod reached;
