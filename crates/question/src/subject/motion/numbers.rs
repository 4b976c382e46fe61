//! The numbers of a motion: where they stand in its start, and their enclosures between floats, in which motions are followed, and between longer
//! numbers, in which states are measured.

pub(super) use crate::subject::measured::{BITS, between_floats as widened};
use arithmetic::{Dyadic, FloatInterval, Interval, Rational};

/// Which list of the start.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Start {
    Positions,
    Velocities,
    Phases,
    /// A part of the state of a law of one's own.
    Own(String),
    /// A number of the law, or a list of which one entry is meant.
    Constant {
        name: String,
        listed: bool,
    },
}

impl Start {
    /// The name of the list.
    pub fn part(&self) -> &str {
        match self {
            Start::Positions => "positions",
            Start::Velocities => "velocities",
            Start::Phases => "phases",
            Start::Own(part) => part,
            Start::Constant { name, .. } => name,
        }
    }
}

/// The narrowest floats around a rational.
pub(super) fn point(q: &Rational) -> FloatInterval {
    FloatInterval::from_rational(q)
}

/// An enclosure between floats: the ends themselves where they are floats.
pub(super) fn narrowed(x: &Interval) -> FloatInterval {
    let is_float = |end: &Dyadic| Dyadic::from_f64(end.to_f64()).is_some_and(|float| float == *end);
    match is_float(x.lo()) && is_float(x.hi()) {
        true => FloatInterval::between(x.lo().to_f64(), x.hi().to_f64()),
        false => FloatInterval::from_interval(x),
    }
}
