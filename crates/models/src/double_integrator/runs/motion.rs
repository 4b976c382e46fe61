//! Motions of flocks: what is asked for, what comes out, what can go wrong.

use super::energy_log::EnergyLog;
use super::fork::{Branch, ForkError};
use crate::double_integrator::laws::{Pair, State};
use arithmetic::ArithmeticError;
use motion::Tolerance;

/// The solution that is followed where there are several.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Prefer {
    /// Pairs stay on their side of `R`; a pair that starts at `R` is not linked. Otherwise they stay at `R`.
    #[default]
    Keep,
    /// Pairs at `R` part.
    Leave,
    /// Pairs at `R` approach.
    Enter,
    /// Pairs at `R` stay there.
    Stay,
}

/// How a motion is computed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Of the integrator; both parts positive.
    pub tolerance: Tolerance,
    /// At forks.
    pub prefer: Prefer,
    /// The way on at the start, by its place in the list of [`Choice::branches`]; without it, what is preferred.
    pub first_branch: Option<usize>,
    /// After so many arrivals of pairs at `R` it is given up.
    pub most_events: usize,
}

impl Default for Options {
    fn default() -> Self {
        let tolerance = Tolerance { relative: 1e-10, absolute: 1e-10 };
        Options { tolerance, prefer: Prefer::Keep, first_branch: None, most_events: 100_000 }
    }
}

/// What happened to a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventKind {
    /// It is linked from now on.
    Link,
    /// It is not linked any more.
    Unlink,
    /// It reached the distance `R` and went back to its side.
    Touch,
    /// It stays at distance `R` for a while.
    Stay,
}

/// Something that happened to a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// When.
    pub time: f64,
    /// To whom: `i < j`, counted from 0.
    pub pair: Pair,
    /// What.
    pub kind: EventKind,
    /// `d/dt |r_ij|²` at that time.
    pub rate: f64,
}

/// A state from which there is more than one way on.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// When.
    pub time: f64,
    /// The ways on; all signs that rounding may change count as open.
    pub branches: Vec<Branch<f64>>,
    /// The one that was followed.
    pub taken: usize,
}

/// The flock at a time that was asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// When.
    pub time: f64,
    /// Positions and velocities.
    pub state: State<f64>,
    /// Links in force from then on, without pairs that stay at `R`.
    pub links: Vec<Pair>,
    /// Energy: `W` on given graphs, `Q` with links within a radius.
    pub energy: f64,
}

/// A motion.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Motion {
    /// The times asked for.
    pub samples: Vec<Sample>,
    /// In order of time, and of pairs where several happen at once.
    pub events: Vec<Event>,
    /// Where there was more than one way on.
    pub choices: Vec<Choice>,
    /// The energy on the way.
    pub energy: EnergyLog,
    /// Steps of the integrator.
    pub steps: usize,
}

/// Why a motion could not be followed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MotionError {
    /// The end.
    #[error("the end of the motion must be a number that is not negative, but it is {0}")]
    Until(f64),
    /// The times asked for.
    #[error("the times of the samples must be numbers between 0 and {until} that do not decrease, but {sample} is not")]
    Samples {
        /// The end.
        until: f64,
        /// The first that does not fit.
        sample: f64,
    },
    /// The tolerance.
    #[error("both parts of the tolerance must be positive numbers below 1, but they are {} and {}", .0.relative, .0.absolute)]
    Tolerance(Tolerance),
    /// The solution ends.
    #[error("the motion cannot be followed beyond t = {time}{}", .closest.map_or(String::new(), |((i, j), d)| format!(", where the closest linked agents {} and {} are at distance {d}", i + 1, j + 1)))]
    Stuck {
        /// Where.
        time: f64,
        /// The closest linked agents.
        closest: Option<(Pair, f64)>,
    },
    /// It was told to stop.
    #[error("stopped at t = {0}")]
    Halted(f64),
    /// Events that do not end.
    #[error("there were {count} switches until t = {time}, the last of agents {} and {}", .pair.0 + 1, .pair.1 + 1)]
    TooManyEvents {
        /// How many.
        count: usize,
        /// When it was given up.
        time: f64,
        /// Who switched last.
        pair: Pair,
    },
    /// No such way on.
    #[error("branch {index} was asked for, but there are {count} ways on from the start")]
    NoSuchBranch {
        /// Asked for, from 0.
        index: usize,
        /// There are.
        count: usize,
    },
    /// Too many pairs at `R`.
    #[error("at t = {time}: {error}")]
    Fork {
        /// When.
        time: f64,
        /// Why.
        error: ForkError,
    },
    /// The law has no value.
    #[error(transparent)]
    Law(#[from] ArithmeticError),
}
