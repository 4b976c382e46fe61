//! Particles with coupled phases and fish.

mod abscissa;
mod circles;
mod flights;
mod laws;
mod networks;
mod reached;
mod shapes;
