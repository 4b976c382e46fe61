//! Scenarios: a model, its start and the times to look at, read from TOML, run, and observed.
//!
//! The laws are those of the models' modules; here they are only chosen, integrated and measured. Observables are functions of a
//! state, apart from the integration. `notes/simulate.md` lists keys, defaults and observables.
//!
//! ```
//! # use arithmetic as flockproof_arithmetic;
//! use flockproof_arithmetic::Unwatched;
//! use flockproof_scenario::{End, Scenario, Value};
//!
//! let text = r#"
//!     model = "phase"
//!     [graph]
//!     kind = "complete"
//!     [state]
//!     phases = ["0", "1/2", "1"]
//!     [law]
//!     K1 = -1
//!     [run]
//!     until = 40
//!     observables = ["order"]
//! "#;
//! // Attracted phases agree: the first order parameter tends to 1.
//! let outcome = Scenario::read(text).unwrap().run(&Unwatched);
//! assert_eq!(outcome.end, End::Finished);
//! let Value::List(order) = &outcome.rows.last().unwrap().observables[0].value else { panic!("a list") };
//! assert!((order[0] - 1.0).abs() < 1e-6);
//! ```

mod agents;
mod alignment;
mod config;
mod described;
mod document;
mod ensemble;
mod error;
mod exact;
mod fish;
mod individual;
mod known;
mod law_file;
mod links;
mod model;
mod network;
mod noisy;
mod observables;
mod oscillator;
mod own;
mod path;
mod platoon;
mod potential;
mod run;
mod simulation;
pub mod source;
mod start;
mod stepped;
mod switching;
mod turns;
mod vicsek;
mod view;

pub use config::Scenario;
pub use document::{NotToml, line_of, parse_toml};
pub use ensemble::Ensemble;
pub use error::{ConfigError, Problem, RunError};
pub use exact::ExactMotion;
pub use law_file::{WithLaw, named_files, with_graph, with_law};
pub use model::Model;
pub use observables::{Found, Observable, QUANTITIES, Quantity, Value, measure, observables_as_markdown};
pub use own::{AffineFunction, AffineNumber, OwnFlock, OwnMotion, OwnSteps, law_problem, own_law, read_law};
pub use path::{Path, Step};
pub use run::{End, Outcome, Row};
pub use simulation::{Event, Frame, Part};
pub use source::Source;
pub use view::{Amount, Law, Links, Measurable, Rows, Sensing, View};
