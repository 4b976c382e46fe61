//! The language of questions: that of laws, with the errors of questions.

use crate::error::Problem;
pub(crate) use expressions::{KEYWORDS, Node, NodeKind as Kind, Relation};

/// A problem at a byte of the text.
pub(crate) type Located = (usize, Problem);

/// Reads a property: something that is true or false, or a number.
pub(crate) fn parse_property(text: &str) -> Result<Node, Located> {
    expressions::parse_property(text).map_err(|(at, problem)| (at, problem.into()))
}

/// Reads what a name ranges over.
pub(crate) fn parse_domain(text: &str) -> Result<Node, Located> {
    expressions::parse_domain(text).map_err(|(at, problem)| (at, problem.into()))
}
