//! Motions that are known in closed form, and counterexamples.

mod known_motions;
mod rhombus;
mod steady;
mod swing;
mod triangle;

pub use rhombus::{crosses_for_ever, real_decaying_modes, rhombus, symmetric_modes};
pub use steady::SteadyMotion;
pub use swing::swing_weights;
pub use triangle::turning_triangle;
