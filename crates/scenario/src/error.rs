//! Why a configuration is refused or a run ends early.

use super::document::NotToml;
use arithmetic::{ArithmeticError, NumberError};
use models::averaging::FlockError;
use models::double_integrator::{FlockError as LargeFlockError, InputError, MotionError};
use models::platoon::{CommunicationError, LineError};
use motion::FollowError;

/// Why a text is not a scenario. Lines, agents and entries are counted from 1.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ConfigError {
    /// Not TOML.
    #[error("line {line}: {error}")]
    Toml {
        /// The line.
        line: usize,
        /// What is wrong there.
        error: NotToml,
    },
    /// A section that every scenario of the model has.
    #[error("the section [{0}] is missing")]
    MissingSection(&'static str),
    /// A key that is needed.
    #[error("`{key}` is missing in {section}: it should be {expected}")]
    MissingKey {
        /// The section, as it is called in a sentence.
        section: String,
        /// The key.
        key: &'static str,
        /// What it should be.
        expected: String,
    },
    /// A key that is not known there.
    #[error("line {line}: there is no key `{key}` in {section}; allowed are {allowed}")]
    UnknownKey {
        /// The line.
        line: usize,
        /// The key.
        key: String,
        /// The section, as it is called in a sentence.
        section: String,
        /// All keys that are allowed there.
        allowed: String,
    },
    /// Numbers of a sweep that make no scenario.
    #[error("with {numbers}: {error}")]
    PutIn {
        /// The places with their numbers.
        numbers: String,
        /// What is wrong then.
        error: Box<ConfigError>,
    },
    /// Several runs where there can be one.
    #[error("line {0}: [ensemble] and [sweep] make several runs, and here there can be one only")]
    Several(usize),
    /// A place that another number was to be put in.
    #[error("there is no number at `{0}`")]
    NoPlace(String),
    /// An expression of a law of one's own.
    #[error("line {line}, column {column}: `{key}`: {problem}")]
    Expression {
        /// The line.
        line: usize,
        /// The column, in characters.
        column: usize,
        /// The key with its section.
        key: String,
        /// What is wrong.
        problem: expressions::Problem,
    },
    /// A value that cannot be used.
    #[error("line {line}: `{key}`: {problem}")]
    Value {
        /// The line.
        line: usize,
        /// The key with its section, and the place in a list.
        key: String,
        /// What is wrong.
        problem: Problem,
    },
}

impl ConfigError {
    /// The line that it names.
    pub(super) fn line_mut(&mut self) -> Option<&mut usize> {
        match self {
            ConfigError::Toml { line, .. }
            | ConfigError::UnknownKey { line, .. }
            | ConfigError::Expression { line, .. }
            | ConfigError::Value { line, .. }
            | ConfigError::Several(line) => Some(line),
            ConfigError::PutIn { error, .. } => error.line_mut(),
            ConfigError::MissingSection(_) | ConfigError::MissingKey { .. } | ConfigError::NoPlace(_) => None,
        }
    }
}

/// What is wrong with a value.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Problem {
    /// Not a number.
    #[error(transparent)]
    Number(#[from] NumberError),
    /// Gains and weights of a platoon.
    #[error(transparent)]
    Line(#[from] LineError),
    /// A number that no float holds.
    #[error("the number is too large for a float")]
    TooLarge,
    /// Work without an end.
    #[error("{time:?} in steps of {step:?} are {steps:.3e} steps; at most {most:.0e} are taken")]
    Endless {
        /// Until when.
        time: f64,
        /// The step.
        step: f64,
        /// How many there would be.
        steps: f64,
        /// How many there may be.
        most: f64,
    },
    /// A time that no float tells from the next step.
    #[error("{0:e} is more than {1:.0e}, the last time to which motions are followed")]
    TooLate(f64, f64),
    /// A value of another kind.
    #[error("it should be {0}")]
    Shape(String),
    /// A text that is no graph.
    #[error(transparent)]
    Graph(#[from] algebra::graph::GraphTextError),
    /// Not one of the names.
    #[error("`{found}` is not known; allowed are {allowed}")]
    Name {
        /// What was given.
        found: String,
        /// What there is.
        allowed: String,
    },
    /// A place without a number.
    #[error("there is no number at `{0}` in the file")]
    NoPlace(String),
    /// A key that something else asks for.
    #[error("`{0}` should be {1}")]
    Needs(&'static str, &'static str),
    /// The file of a graph.
    #[error("the file of the graph: {0}")]
    GraphFile(String),
    /// The file of a law.
    #[error("the file of the law: {0}")]
    LawFile(String),
    /// An empty list of agents.
    #[error("there are no agents")]
    NoAgents,
    /// Lists of different lengths.
    #[error("there are {found} entries for {agents} agents")]
    Count {
        /// The number of agents.
        agents: usize,
        /// Entries found.
        found: usize,
    },
    /// A vector of another dimension.
    #[error("there are {found} coordinates instead of {expected}")]
    Coordinates {
        /// The dimension of the model.
        expected: usize,
        /// Coordinates found.
        found: usize,
    },
    /// Agents at the same place where the law divides by their distance.
    #[error("agents {0} and {1} are at the same place")]
    Coincident(usize, usize),
    /// A zero velocity where a heading is needed.
    #[error("agent {0} has velocity zero, and so no heading")]
    NoHeading(usize),
    /// An edge to an agent that is not there.
    #[error("the edge {0}-{1} does not join two of the {2} agents")]
    EdgeRange(usize, usize, usize),
    /// A loop.
    #[error("the edge {0}-{0} joins an agent with itself")]
    Loop(usize),
    /// An edge that is given twice.
    #[error("the edge {}-{} is given twice, as entries {first} and {second}", pair.0, pair.1)]
    Duplicate {
        /// Its ends.
        pair: (usize, usize),
        /// Where it stands first, from 1.
        first: usize,
        /// Where it stands again.
        second: usize,
    },
    /// A number outside its range.
    #[error("it must be {0}")]
    Range(String),
    /// Gains for a pattern that does not exist.
    #[error("a pattern of M = {clusters} clusters needs M to divide N = {agents}")]
    Pattern {
        /// Number of gains.
        clusters: usize,
        /// Number of agents.
        agents: usize,
    },
    /// Circles without a radius.
    #[error("omega0 must not be 0 where K0 or a beacon asks for circles of radius 1/|omega0|")]
    NoCircles,
    /// A beacon without an effect.
    #[error("a beacon needs its gain `K0`, not 0")]
    NoGain,
    /// Two keys of which there can be one.
    #[error("`{0}` and `{1}` cannot both be given")]
    Both(&'static str, &'static str),
    /// A network that the model does not have.
    #[error("the {model} model needs {needs}")]
    Network {
        /// The model.
        model: &'static str,
        /// What it needs.
        needs: &'static str,
    },
    /// A potential without a value.
    #[error("the potential of agents {0} and {1} is not finite at the start")]
    Potential(usize, usize),
    /// A sample that is not on the grid of a model in discrete time.
    #[error("{time} is not a multiple of the time step {step}")]
    OffGrid {
        /// The sample.
        time: String,
        /// The step.
        step: String,
    },
    /// Times that do not increase.
    #[error("the times must increase, but {after} follows {before}")]
    Order {
        /// The earlier entry.
        before: f64,
        /// The later one.
        after: f64,
    },
    /// A sample after the end.
    #[error("the sample at {sample} is beyond until = {until}")]
    Beyond {
        /// The sample.
        sample: f64,
        /// The end.
        until: f64,
    },
    /// Not a flock of Chazelle's models.
    #[error(transparent)]
    Flock(#[from] FlockError),
    /// Not a platoon.
    #[error(transparent)]
    Communication(#[from] CommunicationError),
    /// Not a large flock.
    #[error(transparent)]
    Large(#[from] LargeFlockError),
    /// Not a flock of switching links.
    #[error(transparent)]
    Motion(#[from] InputError),
    /// Not a flock with individual steps.
    #[error(transparent)]
    Individual(#[from] FollowError),
    /// The law has no value at the start.
    #[error("the law has no value at the start: {0}")]
    Law(#[from] ArithmeticError),
    /// A law of one's own has no value at the start: which number, of whom and why.
    #[error("the law has no value at the start: {0}")]
    Start(String),
    /// An expression of a law of one's own.
    #[error(transparent)]
    Expression(#[from] expressions::Problem),
}

/// Why a run ended before its time.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RunError {
    /// The motion cannot be followed.
    #[error(transparent)]
    Follow(#[from] FollowError),
    /// An exact flock.
    #[error(transparent)]
    Flock(#[from] FlockError),
    /// A flock of switching links.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// What is measured has no value, though the law may have one.
    #[error("an observable has no value near t = {time}: {error}")]
    Observed {
        /// About when.
        time: f64,
        /// What was asked for.
        error: ArithmeticError,
    },
    /// A law of one's own in discrete time has no value.
    #[error("no step beyond t = {time}: {fault}")]
    Own {
        /// The last time that was reached.
        time: f64,
        /// Which number, of whom and why.
        fault: String,
    },
    /// A large flock.
    #[error("about t = {time}: {error}")]
    Large {
        /// About when.
        time: f64,
        /// Why there are no accelerations.
        error: LargeFlockError,
    },
}

impl RunError {
    /// The law has no value about a time.
    pub(super) fn law(time: f64, error: ArithmeticError) -> Self {
        FollowError::Law { time, error }.into()
    }
}
