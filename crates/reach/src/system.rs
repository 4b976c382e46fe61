//! What is asked: modes, inputs, start, switching, checks. All numbers are rationals.

use crate::platoon::Platoon;
use arithmetic::Rational;
pub use motion::sets::Range;

/// An input: any measurable function of time within the range, or an unknown constant.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Its name.
    pub name: String,
    /// Where its values lie.
    pub range: Range,
    /// Whether it keeps one value.
    pub constant: bool,
}

/// `x' = A x + B u + c`.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Its name.
    pub name: String,
    /// `n x n`, by rows.
    pub a: Vec<Vec<Rational>>,
    /// `n x m`, by rows.
    pub b: Vec<Vec<Rational>>,
    /// Of length `n`.
    pub c: Vec<Rational>,
}

/// How long a mode lasts each time.
#[derive(Debug, Clone, PartialEq)]
pub struct Stay {
    /// At least so long.
    pub least: Rational,
    /// At most so long, if there is a limit.
    pub most: Option<Rational>,
}

/// When one mode follows another. Modes by their index.
#[derive(Debug, Clone, PartialEq)]
pub enum Switching {
    /// The modes in turn from time 0, each for the period; one mode is for ever.
    Periodic {
        /// The modes in turn.
        order: Vec<usize>,
        /// How long each lasts.
        period: Rational,
    },
    /// The modes in turn, each next one from an unknown instant of its window on; the last for ever.
    Windows {
        /// The modes in turn.
        order: Vec<usize>,
        /// One fewer; they increase and do not overlap.
        windows: Vec<Range>,
    },
    /// Any measurable choice of a mode at each time.
    Arbitrary,
    /// Any mode after any other, each staying as long as it may.
    Dwell {
        /// The mode at time 0, just entered; any where there is none.
        first: Option<usize>,
        /// For each mode, how long it stays. The last one may be cut off by the time that is looked at.
        stays: Vec<Stay>,
    },
}

/// How a value is compared with its bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// `>=`, or `>` where strict: the least value is the worst.
    AtLeast,
    /// `<=`, or `<` where strict: the greatest value is the worst.
    AtMost,
}

/// `row x + constant >= bound`, or with another relation.
#[derive(Debug, Clone, PartialEq)]
pub struct Condition {
    /// The coefficients of the states.
    pub row: Vec<Rational>,
    /// Added to them.
    pub constant: Rational,
    /// Which way.
    pub side: Side,
    /// Whether equality is excluded.
    pub strict: bool,
    /// The other side.
    pub bound: Rational,
}

impl Condition {
    /// Whether a value of the left side satisfies it.
    pub fn admits(&self, value: &Rational) -> bool {
        match (self.side, self.strict) {
            (Side::AtLeast, false) => *value >= self.bound,
            (Side::AtLeast, true) => *value > self.bound,
            (Side::AtMost, false) => *value <= self.bound,
            (Side::AtMost, true) => *value < self.bound,
        }
    }
}

/// What is to hold for all inputs, starts and orders of modes: a conjunction of conditions.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// As it was written.
    pub text: String,
    /// Its parts.
    pub conditions: Vec<Condition>,
    /// The one time at which it is to hold; at all times where there is none.
    pub at: Option<Rational>,
}

/// A switched linear system with what is asked about it.
#[derive(Debug, Clone, PartialEq)]
pub struct System {
    /// Names of the states.
    pub states: Vec<String>,
    /// The inputs.
    pub inputs: Vec<Input>,
    /// Where each state starts.
    pub start: Vec<Range>,
    /// The modes; at least one.
    pub modes: Vec<Mode>,
    /// When which mode is on.
    pub switching: Switching,
    /// The last time that is looked at; none where it goes on for ever.
    pub until: Option<Rational>,
    /// What is asked.
    pub checks: Vec<Check>,
    /// The platoon that the rest was made from. Beyond 100 followers the matrices of its mode are left out.
    pub platoon: Option<Platoon>,
}

impl System {
    /// Whether the matrices of the modes are there.
    pub(crate) fn is_written_out(&self) -> bool {
        self.modes.iter().all(|mode| !mode.a.is_empty())
    }
}
