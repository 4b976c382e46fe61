//! Paley, Leonard, Sepulchre, Grünbaum and Parrish: coupled oscillators, steered particles, patterns and fish.
//!
//! A phase is kept as its phasor `e^{i theta}`, a complex number over any scalar, so that statements about phases are
//! exact over the Gaussian rationals; see [`State`]. Symmetric patterns are exact over
//! [`RealCyclotomic`](arithmetic::RealCyclotomic).

mod abscissa;
mod all_to_all;
mod arrangement;
mod circles;
mod control;
pub mod critical;
mod fish;
mod flight;
mod individual;
mod laplacian;
mod linearisation;
mod moments;
mod network;
mod pattern;
mod reached;
mod sensed;
mod state;
mod steering;
mod variation;

pub use abscissa::{FourierFormation, Mode, TransverseSpectrum};
pub use all_to_all::AllToAll;
pub use arrangement::{
    ExactPhasors, exact_phasors, fourier_column, in_turns, on_the_line, phasors, squared_lengths, up_to_rotation,
};
pub use circles::{
    CircularGains, beacon_control, beacon_potential, centre_spread, circle_centres, circular_control,
    circular_formation, composite_potential, heading_components, reference_control, relative_position_control,
    spacing_control, spacing_potential,
};
pub use control::{Orientation, Spacing, Steering};
pub use fish::{
    BehaviourGains, Zone, ZoneNetworks, Zones, alignment, attraction, behaviour_control, laplacian_behaviour_control,
    repulsion, steering_towards,
};
pub use flight::Flight;
pub use flight::write_rate;
pub use individual::ParticleLaw;
pub use laplacian::{
    circulant_eigenvalue, is_eigenvector, misalignment, phase_potential, phase_potential_gradient, quadratic_form,
};
pub use linearisation::{Stability, linearisation, shape_dimension, stability, without_symmetries};
pub use moments::{
    mean, moment, moment_gradient, moment_potential, pattern_gradient, pattern_potential, powers, quarter_turn,
};
pub use network::{Everyone, Interaction, Neighbours, laplacian_rows};
pub use pattern::{clusters_of_pattern, symmetric_pattern};
pub use reached::{CLUSTER, cluster_gap, nearest_twist, order, pattern, ring_differences, shape_rate, winding};
pub use sensed::Sensed;
pub use state::{State, phasor};
pub use steering::{gradient_control, laplacian_control, pairwise_control, pattern_control, sine_of_difference};
pub use variation::{phase_gradient, phase_jacobian, rate_of_change, turning};
