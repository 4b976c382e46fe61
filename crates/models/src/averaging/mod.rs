//! Averaging on geometric graphs (Chazelle's models D and K): the transition matrix, its stationary distribution and how
//! fast its powers converge, the distance rule, the hysteresis rule, flocks of model D stepped exactly and of model K with
//! certified positions.

mod affine;
mod boxes;
mod contraction;
mod declaration;
mod filling;
mod filtered;
mod flock;
mod headings;
mod history;
mod hysteresis;
mod kinematic;
mod kinematic_start;
mod modes;
mod motion;
mod noisy;
mod observe;
pub mod read;
mod rule;
pub mod settle;
mod starts;
mod stationary;
mod transients;
mod weights;

pub use affine::{Affine, HalfOpenRange};
pub use contraction::{Contraction, contraction, contraction_watched};
pub use declaration::{declaration, kinematic_declaration};
pub use filling::{Filling, GroupRule};
pub use filtered::FilteredFlock;
pub use flock::{Flock, Start, Switch, check_control};
pub use history::{NetworkHistory, random_network};
pub use hysteresis::Hysteresis;
pub use kinematic::{KinematicFlock, MOST_BITS, check_kappa};
pub use kinematic_start::KinematicStart;
pub use modes::{Mode, rational_modes};
pub use motion::{State, averaged, motion};
pub use noisy::{NoisyError, NoisyFlock};
pub use observe::{Decay, Observer};
pub use stationary::{deviation_matrix, deviation_matrix_watched, equal_rows, stationary_distribution};
pub use transients::{Separation, Transients};
pub use weights::{FlockError, Weights, transition_matrix};
