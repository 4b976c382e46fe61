//! Validated integration of `y' = f(y)`: enclosures of the solution, not approximations (Moore 1966, Lohner 1987).
//!
//! A step needs a box that contains the solution on the whole step (Picard and Lindelöf), Taylor's expansion of the solution with
//! its remainder taken over that box, and the derivative of the flow, so that the set of states is carried along as a
//! parallelepiped and does not grow by being wrapped in boxes. Everything is computed from the law itself, written once over
//! the scalar, by [`Series`](arithmetic::Series) and [`Dual`](arithmetic::Dual) over [`FloatInterval`].

mod linear;
mod parallelepiped;
mod rough;
mod step;
mod taylor;

pub use parallelepiped::Parallelepiped;
pub use rough::box_of_step;
pub use step::{Flow, Step};

use arithmetic::{ArithmeticError, FloatInterval};

/// Why a solution could not be enclosed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ValidationError {
    /// The law has no value on the box that was tried, even for the shortest step.
    #[error("no enclosure beyond t = {time}: {reason}")]
    Law {
        /// Where it ended.
        time: f64,
        /// Why.
        reason: ArithmeticError,
    },
    /// No box was found that contains the solution on a step.
    #[error("no enclosure beyond t = {0}: the step became too short")]
    Step(f64),
}

/// A box: an interval for each coordinate.
pub type IntervalVector = Vec<FloatInterval>;
