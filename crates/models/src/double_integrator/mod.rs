//! Tanner, Jadbabaie and Pappas: agents with accelerations, heading and velocity alignment, fixed and switching networks.
//!
//! Potentials are functions of the squared distance `s = |r_i - r_j|²`, so that every gradient is rational in the positions:
//! `grad_{r_i} V_ij = 2 V'(s) (r_i - r_j)`. The laws take the slope `V'` of a pair as a function, which may differ from pair to
//! pair: an identity of first derivatives that holds for the potentials `g_ij s`, with variables `g_ij`, holds for all
//! differentiable potentials.

mod any_headings;
mod any_potentials;
mod arrival;
mod closed_loop;
mod enclosed;
mod energy;
mod energy_log;
pub mod equilibria;
mod flock;
mod fork;
mod heading;
mod individual;
mod input;
mod known_motions;
mod law;
mod linearisation;
mod motion;
mod observation;
mod potential;
mod random;
pub mod relaxation;
mod rhombus;
mod saturated;
mod setup;
mod state;
mod steady;
mod step_field;
mod swing;
mod switching;
mod threshold;
mod tied;
mod triangle;

pub use any_headings::AnyHeadings;
pub use any_potentials::{AnyPotentials, PairGradient};
pub use closed_loop::follow;
pub use enclosed::{Crossing, EnclosedEvent, EnclosedFlock, EnclosedRun, EnclosureError, FixedNetwork};
pub use energy::{agent_potential, kinetic_energy, potential_energy, saturated_potential};
pub use energy_log::{EnergyLog, Excess};
pub use flock::{FlockError, SwitchingFlock};
pub use fork::{Branch, Fork, ForkError, MOST_GRAZING, Way, fork};
pub use heading::{HeadingDifference, gyroscopic, heading, heading_rate, heading_spread};
pub use individual::{HeadingLaw, VelocityLaw};
pub use input::{Alignment, Flock, InputError, Network};
pub use law::{disagreements, linked_within, potential_gradients, pull, tied, velocity_alignment};
pub use linearisation::{hessian, inertia, linearisation, loop_modes};
pub use motion::{Choice, Event, EventKind, Motion, MotionError, Options, Prefer, Sample};
pub use observation::{Observation, Trial};
pub use potential::{Potential, PotentialError, Slope, Value};
pub use random::{random_flock, random_vectors};
pub use rhombus::{crosses_for_ever, real_decaying_modes, rhombus, symmetric_modes};
pub use saturated::{Kink, Span};
pub use setup::{HeadingReading, LinkRule, Setup, StartRule};
pub use state::{Coordinates, State, Vector, cross, difference, disagreement, dot, rotated, scaled, sum};
pub use steady::SteadyMotion;
pub use step_field::StepField;
pub use swing::swing_weights;
pub use tied::{TiedRate, rate_along, saturated_rate};
pub use triangle::turning_triangle;

/// A pair of agents, counted from 0.
pub type Pair = (usize, usize);
