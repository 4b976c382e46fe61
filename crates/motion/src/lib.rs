//! Simulation in floats, shared by the continuous models: integrators, events, neighbours in the plane, individual steps, shares
//! of runs.
//!
//! A model is a [`VectorField`]: it fills in `dy/dt` at a state. Results do not depend on the number of threads: work is cut into
//! chunks of fixed size, and sums over chunks are taken in their order. Nothing here proves anything.
//!
//! Half a turn of an oscillator by the method of Dormand and Prince of order eight:
//!
//! ```
//! use flockproof_motion::{Tolerance, integrate};
//!
//! let mut oscillator = |_: f64, state: &[f64], rate: &mut [f64]| {
//!     rate[0] = state[1];
//!     rate[1] = -state[0];
//! };
//! let tolerance = Tolerance { relative: 1e-12, absolute: 1e-12 };
//! let states = integrate(&mut oscillator, 0.0, &[1.0, 0.0], &[std::f64::consts::PI], tolerance).unwrap();
//! assert!((states[0][0] + 1.0).abs() < 1e-10 && states[0][1].abs() < 1e-10);
//! ```

mod cells;
mod descent;
mod dop853;
mod dop853_table;
pub mod enclose;
mod event;
mod follow_error;
mod golden;
mod individual;
mod jet;
mod lanes;
mod near;
mod rk4;
pub mod sets;
mod sine;
mod statistics;
mod system;
mod turn_count;

pub use cells::{CellError, CellList, first_not_finite, nearest};
pub use descent::{first_downcrossing, shifted, value_at};
pub use dop853::{IntegrationError, Integrator, Tolerance, integrate};
pub use event::{Crossing, Margin, root, step_to_crossing};
pub use follow_error::FollowError;
pub use golden::golden;
pub use individual::{IndividualFlock, IndividualLaw, Moving, Pace, Rates, Sensing, Switch, Turns};
pub use jet::Jet;
pub use lanes::Lanes;
pub use near::NearLists;
pub use rk4::Rk4;
pub use sine::{LARGEST_FAST_ANGLE, SINE_ERROR, sin_cos_of};
pub use statistics::{Sample, Share};
pub use system::System;
pub use turn_count::whole_turns;

/// The right-hand side of `dy/dt = f(t, y)`. A field may keep scratch space, so it is asked by a mutable reference; the
/// answer must depend on `time` and `state` only. Closures `FnMut(f64, &[f64], &mut [f64])` are fields.
pub trait VectorField {
    /// Writes `f(time, state)` into `rate`, which is as long as `state`.
    fn rate(&mut self, time: f64, state: &[f64], rate: &mut [f64]);
}

impl<F: FnMut(f64, &[f64], &mut [f64])> VectorField for F {
    fn rate(&mut self, time: f64, state: &[f64], rate: &mut [f64]) {
        self(time, state, rate);
    }
}

/// Numbers that one task works on, whatever the number of threads.
pub const CHUNK: usize = 4096;
