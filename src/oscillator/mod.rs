//! Paley, Leonard, Sepulchre, Grünbaum and Parrish: coupled oscillators, steered particles, patterns and fish.
//!
//! A phase is kept as its phasor `e^{i theta}`, a complex number over any scalar, so that statements about phases are
//! exact over the Gaussian rationals; see [`State`].

mod state;

pub use state::{State, phasor};
