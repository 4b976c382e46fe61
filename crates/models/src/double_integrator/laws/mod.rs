//! Agents with accelerations: states, potentials, and the laws by which velocities and headings align.

mod energy;
mod heading;
mod law;
mod potential;
mod saturated;
mod state;
mod step_field;

pub use energy::{agent_potential, kinetic_energy, potential_energy, saturated_potential};
pub use heading::{HeadingDifference, gyroscopic, heading, heading_rate, heading_spread};
pub(super) use heading::{turned, turning};
pub(super) use law::check_links;
pub use law::{disagreements, linked_within, potential_gradients, pull, tied, velocity_alignment};
pub use potential::{Potential, PotentialError, Slope, Value};
pub use saturated::{Kink, Span};
pub use state::{Coordinates, Pair, State, Vector, cross, difference, disagreement, dot, rotated, scaled, sum};
pub use step_field::StepField;
