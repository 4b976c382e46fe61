//! Validated integration of `y' = f(y)`: enclosures of the solution, not approximations (Moore 1966, Lohner 1987).
//!
//! A set of states is a polynomial image of a cube, the numbers of the start that are intervals, with a sum of parallelepipeds around it ([`Set`]). A step expands the
//! solutions in the time and in the start, in floats, bounds what that leaves out, and carries those along by the derivative of the flow. The
//! right-hand side, written once over the scalar, is written down as a list of operations, so that an expansion to order `n` costs `n²`.

mod bound;
mod cascade;
mod errors;
mod expanded;
mod expansion;
mod linear;
mod rough;
mod set;
mod shape;
mod step;
mod tape;
mod variation;

pub use expanded::Expanded;
pub use rough::box_of_step;
pub use set::Set;
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
