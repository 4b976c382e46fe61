//! The language of laws and questions: one grammar and one syntax tree ([`Node`]), and laws of one's own ([`Law`]), which are
//! compiled once and then evaluated over any scalar: floats simulate them, rationals run them exactly, intervals, series and dual numbers enclose them.
//!
//! ```
//! use flockproof_expressions::{Everyone, Kind, LawText, Time};
//!
//! let text = LawText {
//!     time: Time::Continuous,
//!     dimension: 1,
//!     state: vec![("x".to_string(), Kind::Number)],
//!     rates: vec![("x".to_string(), "mean(j, x[j] - x)".to_string())],
//!     ..LawText::default()
//! };
//! let law = text.compile(3).unwrap();
//! let rates = law.rates(&0.0, &[0.0, 1.0, 5.0], &Everyone(3)).unwrap();
//! assert_eq!(rates, [3.0, 1.5, -4.5]);
//! ```

mod blocks;
mod bodies;
mod compile;
mod evaluate;
mod function;
mod law;
mod problem;
mod program;
mod syntax;

pub use arithmetic::{nearest_ids, nearest_name};
pub use blocks::{Blocks, Heading};
pub use bodies::Bodies;
pub use compile::{Clauses, Comparison};
pub use evaluate::{Evaluator, Everyone, Fault, Hearing};
pub use law::{Asked, Drawn, Kind, Law, LawError, LawText, OpenParameter, Parameter, Time, Variable};
pub use problem::Problem;
pub use program::Program;
pub use syntax::{KEYWORDS, Located, Node, NodeKind, Relation, parse_domain, parse_property};
