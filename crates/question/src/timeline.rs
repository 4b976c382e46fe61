//! Something that moves, with its time cut into pieces, and what is measured in them.

use crate::failure::Failure;
use crate::names::Quantity;
use crate::syntax::Node;
use crate::truth::{Doubt, Margin, Truth};
use arithmetic::RealNumber as Number;
use arithmetic::{Rational, rational};
use num_bigint::BigInt;
use polynomials::{Side, Symbolic};
use scenario::Amount;

/// A quantity that was measured.
#[derive(Debug, Clone)]
pub(crate) enum Measured {
    Number(Number),
    Truth(bool),
}

/// What moving quantities are measured on: a moment, or all moments of a short time at once.
pub(crate) trait Moment {
    fn measure(&self, quantity: &Quantity, arguments: &[Number], precision: u32) -> Result<Measured, Failure>;

    /// A number of a law of one's own by its name, `x[2].1` or an observable.
    fn own(&self, _: &str, _: u32) -> Result<Measured, Failure> {
        Err(Failure::open("there is no law of one's own", None))
    }

    /// The truth of a time operator at the moment, where it was found before.
    fn known(&self, _: &Node) -> Option<Result<(Truth, Margin), Failure>> {
        None
    }
}

/// What is measured, as functions of some numbers.
pub(crate) trait Formulas {
    /// A constant.
    fn number(&self, q: &Rational) -> Option<Symbolic>;

    /// The quantity as it is given by the state; of a list the entry that is asked for.
    fn amount(&self, quantity: &Quantity, arguments: &[Number]) -> Option<Amount<Symbolic>>;

    /// A number of a law of one's own by its name.
    fn own(&self, name: &str) -> Option<Symbolic>;
}

/// What is measured at the times of a piece, as functions of one number that each time has.
pub(crate) trait Curve: Formulas {
    /// What the number ranges over.
    fn range(&self) -> &Side;
}

/// What is measured in a piece as functions of the state and, last, the time, and how these move.
pub(crate) trait Field: Formulas {
    /// What the numbers range over in the piece; at time 0 just the starts, where these are known exactly.
    fn region(&self) -> &[Side];

    /// How fast they change.
    fn rates(&self) -> &[Symbolic];

    /// The least value of a function of them in the piece, or less.
    fn least(&self, function: &Symbolic) -> Option<f64>;

    /// The squared distances of all pairs.
    fn squares(&self) -> Option<Vec<Symbolic>>;

    /// The links in force, which tell one law of a motion from another one.
    fn links(&self) -> &[(usize, usize)];
}

/// All times from one to another, or on for ever.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Piece {
    pub from: Rational,
    pub to: Option<Rational>,
}

/// The pieces of a stretch of time as far as it is known, and what stands in the way of knowing the rest.
pub(crate) struct Covered {
    pub pieces: Vec<Piece>,
    pub rest: Option<Doubt>,
}

/// From a step on, what is asked for at a step is what it was a period before.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Repeats {
    pub from: BigInt,
    /// At least 1.
    pub period: BigInt,
}

impl Repeats {
    /// How far a step can be moved back by whole periods so that it is at least `least`, which is not before all repeats; 0 for one before it.
    pub fn whole_periods(&self, step: &BigInt, least: &BigInt) -> BigInt {
        if step < least { BigInt::ZERO } else { (step - least) / &self.period * &self.period }
    }
}

/// Something that moves, with its time cut into pieces.
pub(crate) trait Timeline {
    /// The pieces that a stretch begins with; `moving` are the names of the moving quantities that are asked for.
    fn pieces(&self, from: &Rational, to: Option<&Rational>, moving: &[&str]) -> Result<Covered, Failure>;

    /// Whether these moving quantities are known to repeat for ever, where times up to `to` are asked for.
    fn repeats(&self, _to: Option<&Rational>, _moving: &[&str]) -> Result<Option<Repeats>, Failure> {
        Ok(None)
    }

    /// Everything that is measured in a piece, enclosed for all its times at once.
    fn moment<'t>(&'t self, piece: &Piece) -> Result<Box<dyn Moment + 't>, Failure>;

    /// Some instants of a piece at which what is measured is known exactly, and which may decide what happens at one instant only; each with times between which it is.
    fn instants<'t>(&'t self, _: &Piece, _precision: u32) -> Vec<(Piece, Box<dyn Moment + 't>)> {
        Vec::new()
    }

    /// What is measured in a piece as functions of one number, where the motion has such a form.
    fn curve<'t>(&'t self, _: &Piece, _precision: u32) -> Option<Box<dyn Curve + 't>> {
        None
    }

    /// What is measured in a piece as functions of the state, where these and the rates of the state have such a form.
    fn field<'t>(&'t self, _: &Piece) -> Option<Box<dyn Field + 't>> {
        None
    }

    /// Whether there are such instants.
    fn has_instants(&self) -> bool {
        false
    }

    /// Why there are none, as the end of a sentence.
    fn without_instants(&self) -> &'static str {
        "the motion has no closed form with rational exponents and frequencies"
    }

    /// Two halves of a piece; `None` where it need not or cannot be divided.
    fn halves(&self, piece: &Piece) -> Option<[Piece; 2]>;

    /// Follows the motion at least up to a time, before pieces of it are asked for.
    fn prepare(&self, until: &Rational) -> Result<(), Failure>;

    /// Whether only integers are times. Then what moves is constant on each piece.
    fn is_discrete(&self) -> bool {
        false
    }

    /// The times that count in a stretch: of discrete time, the integers.
    fn inside(&self, from: Rational, to: Option<Rational>) -> (Rational, Option<Rational>);
}

/// A time as a reader wants it: at most six decimals.
pub(crate) fn clock(time: f64) -> String {
    let text = format!("{time:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

/// What steps through the whole numbers.
pub(crate) trait Steps {
    /// As [`Timeline::pieces`].
    fn pieces(&self, from: &Rational, to: Option<&Rational>, moving: &[&str]) -> Result<Covered, Failure>;

    /// As [`Timeline::repeats`].
    fn repeats(&self, _to: Option<&Rational>, _moving: &[&str]) -> Result<Option<Repeats>, Failure> {
        Ok(None)
    }

    /// As [`Timeline::moment`].
    fn moment<'t>(&'t self, piece: &Piece) -> Result<Box<dyn Moment + 't>, Failure>;
}

impl<T: Steps> Timeline for T {
    fn pieces(&self, from: &Rational, to: Option<&Rational>, moving: &[&str]) -> Result<Covered, Failure> {
        Steps::pieces(self, from, to, moving)
    }

    fn repeats(&self, to: Option<&Rational>, moving: &[&str]) -> Result<Option<Repeats>, Failure> {
        Steps::repeats(self, to, moving)
    }

    fn moment<'t>(&'t self, piece: &Piece) -> Result<Box<dyn Moment + 't>, Failure> {
        Steps::moment(self, piece)
    }

    fn halves(&self, piece: &Piece) -> Option<[Piece; 2]> {
        let to = piece.to.as_ref()?;
        if *to <= piece.from {
            return None;
        }
        let middle = ((&piece.from + to) * rational(1, 2)).floor();
        Some([
            Piece { from: piece.from.clone(), to: Some(middle.clone()) },
            Piece { from: middle + rational(1, 1), to: Some(to.clone()) },
        ])
    }

    fn prepare(&self, _: &Rational) -> Result<(), Failure> {
        Ok(())
    }

    fn is_discrete(&self) -> bool {
        true
    }

    fn inside(&self, from: Rational, to: Option<Rational>) -> (Rational, Option<Rational>) {
        (from.ceil(), to.map(|to| to.floor()))
    }
}
