//! Paley, Leonard, Sepulchre, Grünbaum and Parrish: coupled oscillators, steered particles, patterns and fish.
//!
//! A phase is kept as its phasor `e^{i theta}`, a complex number over any scalar, so that statements about phases are
//! exact over the Gaussian rationals; see [`State`]. Symmetric patterns are exact over
//! [`RealCyclotomic`](crate::arithmetic::RealCyclotomic).

mod laplacian;
mod moments;
mod pattern;
mod state;
mod steering;
mod variation;

pub use laplacian::{laplacian_rows, misalignment, phase_potential, phase_potential_gradient, quadratic_form};
pub use moments::{
    mean, moment, moment_gradient, moment_potential, pattern_gradient, pattern_potential, powers, quarter_turn,
};
pub use pattern::{clusters_of_pattern, symmetric_pattern};
pub use state::{State, phasor};
pub use steering::{gradient_control, laplacian_control, pairwise_control, pattern_control, sine_of_difference};
pub use variation::{phase_gradient, phase_jacobian, rate_of_change, turning};
