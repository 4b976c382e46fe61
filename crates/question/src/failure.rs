//! Why an expression has no value.

use crate::error::Problem;
use crate::truth::Doubt;
use arithmetic::Cancelled;

/// Why an expression has no value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Failure {
    /// The question is wrong at this byte of the expression.
    Refused(usize, Problem),
    /// It could not be told yet.
    Open(Doubt),
    /// It was told to stop.
    Cancelled,
}

impl From<Cancelled> for Failure {
    fn from(_: Cancelled) -> Self {
        Failure::Cancelled
    }
}

impl Failure {
    pub fn open(why: impl Into<String>, bits: Option<u64>) -> Self {
        Failure::Open(Doubt { why: why.into(), bits })
    }
}
