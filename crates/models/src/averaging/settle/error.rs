//! Why a flock cannot be followed to its end.

use crate::averaging::weights::FlockError;
use algebra::matrix::MatrixError;
use algebra::spectrum::RecurrenceError;
use arithmetic::{ArithmeticError, Cancelled};

/// Why a flock could not be followed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SettleError {
    /// The flock cannot go on.
    #[error(transparent)]
    Flock(FlockError),
    /// A matrix without a limit.
    #[error(transparent)]
    Matrix(MatrixError),
    /// A sign in the long run that is not decided.
    #[error(transparent)]
    Recurrence(RecurrenceError),
    /// An interval operation without a result.
    #[error(transparent)]
    Arithmetic(#[from] ArithmeticError),
    /// A network that contracts too slowly to be followed.
    #[error("the network contracts too slowly")]
    TooSlow,
    /// Contributions that cannot be told apart.
    #[error("contributions too small to be written as numbers decide, and they cannot be told apart")]
    Unresolved,
    /// Stopped by the caller.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A jump that does not pass its own check: never to be seen.
    #[error("the switch predicted for t = {0} does not pass the rule")]
    Inconsistent(String),
}

impl From<FlockError> for SettleError {
    fn from(error: FlockError) -> Self {
        match error {
            FlockError::Cancelled(stopped) => SettleError::Cancelled(stopped),
            other => SettleError::Flock(other),
        }
    }
}

impl From<MatrixError> for SettleError {
    fn from(error: MatrixError) -> Self {
        match error {
            MatrixError::Cancelled(stopped) => SettleError::Cancelled(stopped),
            other => SettleError::Matrix(other),
        }
    }
}

impl From<RecurrenceError> for SettleError {
    fn from(error: RecurrenceError) -> Self {
        match error {
            RecurrenceError::Cancelled(stopped) => SettleError::Cancelled(stopped),
            other => SettleError::Recurrence(other),
        }
    }
}
