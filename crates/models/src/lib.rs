//! The models of the five papers, each law written once over the scalar traits of `arithmetic`.
//!
//! Three birds of Chazelle's model on a line: every switch of their network is found exactly, and that it never changes again is proved.
//!
//! ```
//! # use arithmetic as flockproof_arithmetic;
//! use flockproof_arithmetic::{Unwatched, rational};
//! use flockproof_models::averaging::settle::{Ending, Limits, settle};
//! use flockproof_models::averaging::{Flock, Hysteresis, Start, Weights};
//!
//! let positions = vec![rational(0, 1), rational(9, 10), rational(5, 2)];
//! let velocities = vec![rational(1, 8), rational(0, 1), rational(-1, 8)];
//! let start = Start::on_the_line(positions, velocities, Weights::Lazy, Hysteresis::None);
//! let mut times = Vec::new();
//! let flock = Flock::new(&start).unwrap();
//! let found = settle(flock, &Limits::default(), &mut |switch| times.push(switch.time.clone()), &Unwatched).unwrap();
//! assert!(matches!(found.ending, Ending::Steady), "{}", found.why);
//! assert_eq!(times.last(), Some(&found.last_switch));
//! ```

/// Crates that stand in signatures.
pub use algebra::faer;
pub use rand_chacha;

pub mod angles;
pub mod averaging;
pub mod double_integrator;
pub mod oscillator;
pub mod platoon;
pub mod tracks;
