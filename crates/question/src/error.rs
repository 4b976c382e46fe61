//! Why a question is refused: one sentence with line and column.

use arithmetic::{Cancelled, NumberError, shown};
use std::fmt;

/// A place in a question file, counted from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// The line.
    pub line: usize,
    /// The column, in characters.
    pub column: usize,
}

impl Place {
    /// The place of a byte of a text.
    pub fn of(text: &str, byte: usize) -> Self {
        let mut end = byte.min(text.len());
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        let before = &text[..end];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        Place { line: 1 + before.matches('\n').count(), column: 1 + before[line_start..].chars().count() }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}", self.line, self.column)
    }
}

/// Why a question cannot be read or decided at all.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum QuestionError {
    /// Something at a place of the file.
    #[error("{place}: {problem}")]
    At {
        /// Where.
        place: Place,
        /// What.
        problem: Problem,
    },
    /// It was told to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// What is wrong.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Problem {
    /// Not TOML.
    #[error("{0}")]
    Toml(scenario::NotToml),
    /// A platoon of which there is no peak.
    #[error("the platoon is not stable, so that it has no peak (z'' = f (z - m) + g (z' - m'): negative gains pull)")]
    NotStable,
    /// A number that exists, and is too long to be written down.
    #[error("the number has too many digits to be computed")]
    TooManyDigits,
    /// A number that cannot be read.
    #[error(transparent)]
    Number(#[from] NumberError),
    /// No expression of the language.
    #[error(transparent)]
    Expression(#[from] expressions::Problem),
    /// A key that must be there.
    #[error("`{key}` is missing in [{section}]: {expected}")]
    Missing {
        /// The section.
        section: &'static str,
        /// The key.
        key: &'static str,
        /// What it should be.
        expected: &'static str,
    },
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
    /// A quantity of something that the question does not have.
    #[error("`{name}` is a quantity of {subject}, and {missing}")]
    NoSubject {
        /// The quantity.
        name: String,
        /// Of what.
        subject: &'static str,
        /// What would have to be there.
        missing: String,
    },
    /// Time where nothing moves.
    #[error("`{0}` needs something that moves in time: a `scenario`; the quantities of this question have no time")]
    Static(&'static str),
    /// Unbounded time where the future is not decided.
    #[error("`inf` is for averaging flocks only, whose whole future is decided; a continuous motion needs a last time")]
    Unbounded,
    /// A number that is not an integer.
    #[error("{what} must be an integer, but it is {found}")]
    NotInteger {
        /// Which.
        what: String,
        /// What it is.
        found: String,
    },
    /// A number out of range.
    #[error("{what} must be {expected}, but it is {found}")]
    Range {
        /// Which.
        what: String,
        /// What it should be.
        expected: String,
        /// What it is.
        found: String,
    },
    /// The divisor is zero.
    #[error("division by zero")]
    DivisionByZero,
    /// An argument outside the domain of a function.
    #[error("{}", outside(.0))]
    Domain(&'static str),
    /// A value that is missing in one case.
    #[error("{problem} where {at}")]
    Where {
        /// What is missing.
        problem: Box<Problem>,
        /// The names with their numbers.
        at: String,
    },
    /// A name of `[for]` without a use.
    #[error("nothing uses `{0}`: neither the property, nor a control, nor `where`, nor a later name")]
    Unused(String),
    /// Nothing to range over.
    #[error("the family is empty: {0}")]
    Empty(String),
    /// More members than can be gone through.
    #[error(
        "the family has {size} members, which are more than the budget of {budget}; `budget` in [question] raises it, up to a thousand million"
    )]
    TooMany {
        /// How many.
        size: String,
        /// The budget.
        budget: u64,
    },
    /// Classes of graphs that are not made.
    #[error("{what} has {size} members; orders up to {most} are gone through")]
    TooLarge {
        /// The family.
        what: String,
        /// Its size.
        size: String,
        /// Largest order.
        most: usize,
    },
    /// A file, a scenario, a graph.
    #[error("{0}")]
    Other(String),
}

/// That a function has no value.
fn outside(function: &str) -> String {
    match function {
        "^" => "a negative number has no power with an exponent that is not an integer".to_string(),
        _ => format!("the argument of `{function}` lies outside its domain"),
    }
}

impl Problem {
    /// Whether there is a number, which is too long.
    pub(crate) fn is_length(&self) -> bool {
        match self {
            Problem::Where { problem, .. } => problem.is_length(),
            problem => *problem == Problem::TooManyDigits,
        }
    }

    /// The same with the case in which it arises.
    pub(crate) fn there(self, bindings: &crate::bindings::Bindings) -> Self {
        match bindings.iter().next() {
            None => self,
            Some(_) => Problem::Where { problem: Box::new(self), at: shown(&bindings.to_string()) },
        }
    }

    /// The problem without the case in which it arises, which stands beside it.
    pub(crate) fn told_there(&self) -> String {
        match self {
            Problem::Where { problem, .. } => problem.told_there(),
            own => own.to_string(),
        }
    }

    /// Whether it lies in the words of the question, so that it is there for every member.
    pub(crate) fn is_misuse(&self) -> bool {
        match self {
            Problem::Where { problem, .. } => problem.is_misuse(),
            Problem::Expression(_) | Problem::Arguments { .. } | Problem::NoSubject { .. } | Problem::Static(_) => true,
            _ => false,
        }
    }

    pub(crate) fn expected(expected: impl Into<String>, found: impl Into<String>) -> Self {
        expressions::Problem::expected(expected, found).into()
    }

    /// An unknown name, with the nearest of the known ones if one is near.
    pub(crate) fn unknown<'a>(what: &'static str, name: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        expressions::Problem::unknown(what, name, known).into()
    }
}
