//! Platoons on a line that follow an independent leader (Veerman, Stosic and Olvera).
//!
//! Conventions. `M = N + 1` followers, numbered 1 to M, behind the leader 0; `y_k = x_k - h_k` is the deviation from the
//! desired position and `u_k` its rate; the gains `f` (1/s²) and `g` (1/s) are negative; the leader moves as
//! `y_0 = e^{i w t}` with angular frequency `w >= 0` (a negative `w` only conjugates everything).

pub mod banded;
pub mod bode;
mod cars;
mod communication_graph;
pub mod front_in_time;
pub mod gain_margin;
pub mod growth;
mod law;
mod line;
pub mod modes;
mod neighbourhood;
pub mod next_order;
pub mod observe;
mod peak;
pub mod phase_margin;
mod resonance;
mod response;
mod shape;
pub mod state_space;
pub mod theorem1;
pub mod time_domain;
pub mod vector_form;

pub use cars::Platoon;
pub use communication_graph::{CommunicationError, CommunicationGraph};
pub use law::{Communication, Gains, SIGNS, accelerations};
pub use line::{Line, LineError, Parameter, read_numbers};
pub use modes::slowest_rate;
pub use neighbourhood::Neighbourhood;
pub use peak::{
    MOST_FOLLOWERS_PROVED, MOST_STATES_PROVED, Peak, PeakError, peak_of_platoon, peak_of_system, peak_on_graph,
};
pub use resonance::{
    LARGEST_DIGITS, LARGEST_FOLLOWERS, Resonance, ResonanceError, is_below_full_phase, lesser_resonance, peak_near,
    resonance, resonance_from,
};
pub use response::{
    amplitude_one_sided, amplitude_two_sided, amplitude_with_first_car, amplitudes_two_sided, chebyshev,
    gain_fraction_one_sided, gain_squared_one_sided, gamma, gamma_minus_one, inverse_square_two_sided,
    larger_root_modulus, larger_root_power, strongest_one_sided_square,
};
pub use shape::{FrequencyResponse, frequency_response};
