//! Particles with coupled phases and fish.

mod abscissa;
mod laws;
mod networks;
mod reached;
