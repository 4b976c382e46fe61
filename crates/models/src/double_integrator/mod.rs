//! Tanner, Jadbabaie and Pappas: agents with accelerations, heading and velocity alignment, fixed and switching networks.
//!
//! Potentials are functions of the squared distance `s = |r_i - r_j|²`, so that every gradient is rational in the positions:
//! `grad_{r_i} V_ij = 2 V'(s) (r_i - r_j)`. The laws take the slope `V'` of a pair as a function, which may differ from pair to
//! pair: an identity of first derivatives that holds for the potentials `g_ij s`, with variables `g_ij`, holds for all
//! differentiable potentials.

mod known;
mod laws;
mod runs;
mod theory;

pub use known::{
    SteadyMotion, crosses_for_ever, real_decaying_modes, rhombus, swing_weights, symmetric_modes, turning_triangle,
};
pub use laws::{
    Coordinates, HeadingDifference, Kink, Pair, Potential, PotentialError, Slope, Span, State, StepField, Value,
    Vector, agent_potential, cross, difference, disagreement, disagreements, dot, gyroscopic, heading, heading_rate,
    heading_spread, kinetic_energy, linked_within, potential_energy, potential_gradients, pull, rotated,
    saturated_potential, scaled, sum, tied, velocity_alignment,
};
pub use runs::{
    Alignment, Branch, Choice, Crossing, EnclosedEvent, EnclosedFlock, EnclosedRun, EnclosureError, EnergyLog, Event,
    EventKind, Excess, FixedNetwork, Flock, FlockError, Fork, ForkError, HeadingLaw, HeadingReading, InputError,
    LinkRule, LinkedAgents, MOST_GRAZING, Motion, MotionError, Network, Observation, Options, Prefer, Sample, Setup,
    StartRule, SwitchingFlock, SwitchingMotion, Trial, VelocityLaw, Way, follow, fork, random_flock, random_vectors,
};
pub use theory::{
    AnyHeadings, AnyPotentials, PairGradient, TiedRate, equilibria, hessian, linearisation, loop_modes, rate_along,
    relaxation, saturated_rate,
};
