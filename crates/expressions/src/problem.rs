//! What is wrong with an expression: one sentence.

use arithmetic::nearest_name;
use arithmetic::{NumberError, shown};

/// What is wrong.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Problem {
    /// Something else was expected.
    #[error("{expected} is expected here, but it is {found}")]
    Expected {
        /// What should be there.
        expected: String,
        /// What is there.
        found: String,
    },
    /// A name that is not known.
    #[error("there is no {what} `{name}`{}", nearest.as_ref().map_or(String::new(), |near| format!("; the nearest known name is `{near}`")))]
    Unknown {
        /// What sort of name.
        what: &'static str,
        /// The name.
        name: String,
        /// The nearest known one.
        nearest: Option<String>,
    },
    /// A number that cannot be read.
    #[error(transparent)]
    Number(#[from] NumberError),
    /// Brackets, or operators, inside each other.
    #[error("the expression is nested more than {0} levels deep")]
    TooDeep(usize),
    /// An expression of too many parts.
    #[error("the expression has more than {0} parts")]
    TooLong(usize),
    /// A number of arguments.
    #[error("`{name}` takes {expected}, not {found}")]
    Arguments {
        /// The function.
        name: String,
        /// What it takes.
        expected: String,
        /// How many there are.
        found: usize,
    },
    /// A definition in terms of itself.
    #[error("the definition of `{0}` uses itself")]
    Circular(String),
    /// A bare name where no agent is meant.
    #[error("of which agent is `{0}`? No agent has a name of its own here: write `{0}[j]` inside a sum over j")]
    NoAgent(String),
    /// An agent's name that is taken.
    #[error("the agent `{0}` is already bound here; take another letter")]
    Bound(String),
    /// Anything else.
    #[error("{0}")]
    Other(String),
}

impl Problem {
    /// Something else was expected.
    pub fn expected(expected: impl Into<String>, found: impl Into<String>) -> Self {
        Problem::Expected { expected: expected.into(), found: found.into() }
    }

    /// An unknown name, with the nearest of the known ones if one is near.
    pub fn unknown<'a>(what: &'static str, name: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        Problem::Unknown { what, name: shown(name), nearest: nearest_name(name, known) }
    }
}
