//! Tanner, Jadbabaie and Pappas: agents with accelerations, heading and velocity alignment, fixed and switching networks.
//!
//! Potentials are functions of the squared distance `s = |r_i - r_j|²`, so that every gradient is rational in the positions:
//! `grad_{r_i} V_ij = 2 V'(s) (r_i - r_j)`. The laws take the slope `V'` of a pair as a function, which may differ from pair to
//! pair: an identity of first derivatives that holds for the potentials `g_ij s`, with variables `g_ij`, holds for all
//! differentiable potentials.

mod energy;
pub mod equilibria;
mod experiment;
mod heading;
mod law;
mod linearisation;
mod potential;
pub mod relaxation;
mod saturated;
mod setup;
mod simulate;
mod state;

pub use energy::{agent_potential, kinetic_energy, potential_energy};
pub use experiment::{Alignment, Experiment, Links, Observation, Trial};
pub use heading::{HeadingDifference, gyroscopic, heading, heading_rate};
pub use law::{disagreements, linked_within, pairs_within, potential_gradients, tied, velocity_alignment};
pub use linearisation::{Inertia, hessian, inertia, linearisation};
pub use potential::{Potential, PotentialError, Slope};
pub use saturated::{Kink, Span};
pub use setup::{HeadingReading, LinkRule, Setup, StartRule};
pub use simulate::{RunError, Stepper, disagreement, random_flock};
pub use state::{Coordinates, State, Vector, difference, rotated, scaled, sum};

/// A pair of agents, counted from 0.
pub type Pair = (usize, usize);
