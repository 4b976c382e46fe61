//! Statements of one's own: a file says what a property ranges over, and the property is decided with graded evidence.
//!
//! [`Question::read`] reads a question; [`decide`] decides it; [`Question::case`] and [`Question::values`] serve tables and campaigns. The crate opens no
//! files: those that a question names are given to it. `notes/questions.md` has the language with examples.
//!
//! ```
//! # use arithmetic as flockproof_arithmetic;
//! use flockproof_arithmetic::Unwatched;
//! use flockproof_question::{Question, Verdict, decide};
//!
//! let text = r#"
//!     [question]
//!     id = "slowest_path"
//!     [for]
//!     n = "2..5"
//!     graph = "connected(n)"
//!     [holds]
//!     property = "lambda(2) >= 2*(1 - cos(pi/n))"
//!     controls = ["lambda(2) >= 2*(1 - cos(pi/n)) + 1/100"]
//! "#;
//! // It names no file.
//! let question = Question::read(text, &|name| Err(format!("there is no file {name}"))).unwrap();
//! let answer = decide(&question, &Unwatched).unwrap();
//! assert_eq!(answer.verdict, Verdict::Holds);
//! ```

mod answer;
mod binder;
mod bindings;
mod case;
mod decide;
mod decisive;
mod definitions;
mod division;
mod domain;
mod draw;
mod drawn;
mod error;
mod evaluate;
mod failure;
mod family;
mod floats;
mod formula;
mod given;
mod inequalities;
mod made;
mod members;
pub mod names;
mod number;
mod outcome;
mod point;
mod question;
mod regions;
mod scenario_file;
mod sharper;
mod shrink;
mod source;
mod states;
mod subject;
mod syntax;
mod timeline;
mod truth;
mod tube;

/// A graph, as a family gives it.
pub use algebra::graph::AnyGraph;
pub use answer::{Answer, Verdict};
pub use bindings::{Bindings, Value};
pub use decide::{Tabulated, decide};
pub use decisive::Decisive;
pub use drawn::Instance;
pub use error::{Place, Problem, QuestionError};
pub use expressions::nearest_ids;
pub use given::{Given, GivenValue, Measure};
pub use made::{Made, MadeControl};
pub use members::{Listed, Member};
pub use motion::sets::{Range, Tube};
pub use number::Number;
pub use outcome::{Decided, Outcome, Spot, Unsettled};
/// Proofs by sums of squares.
pub use polynomials::sums::Certificate;
pub use question::Question;
pub use regions::{Region, Standing};
pub use scenario_file::Files;
pub use truth::{Doubt, Margin, Truth};
pub use tube::Tubes;
