//! Scenarios: a model, its start and the times to look at, read from TOML, run, and observed.
//!
//! The laws are those of the models' modules; here they are only chosen, integrated and measured. Observables are functions of a
//! state, apart from the integration. `notes/simulate.md` lists keys, defaults and observables.

mod agents;
mod alignment;
mod config;
mod document;
mod ensemble;
mod error;
mod exact;
mod fish;
mod individual;
mod known;
mod links;
mod network;
mod noisy;
mod observables;
mod oscillator;
mod own;
mod platoon;
mod potential;
mod run;
mod simulation;
mod source;
mod start;
mod stepped;
mod switching;
mod turns;
mod vicsek;

pub use config::Scenario;
pub use document::{NotToml, line_of, parse_toml};
pub use ensemble::Ensemble;
pub use error::{ConfigError, Problem, RunError};
pub use exact::{ExactMotion, ExactSpacing, is_drawn, with_numbers};
pub use observables::{Observable, Value, min_distance, pattern_order, total};
pub use own::OwnMotion;
pub use run::{End, Outcome, Row};
pub use simulation::{Event, Frame, Part};
