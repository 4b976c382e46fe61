//! Something that moves, with its time cut into pieces, and what is measured in them.

use crate::failure::Failure;
use crate::names::Quantity;
use crate::syntax::Node;
use crate::truth::{Doubt, Margin, Truth};
use arithmetic::Rational;
use arithmetic::RealNumber as Number;

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

/// Something that moves, with its time cut into pieces.
pub(crate) trait Timeline {
    /// The pieces that a stretch begins with; `moving` are the names of the moving quantities that are asked for.
    fn pieces(&self, from: &Rational, to: Option<&Rational>, moving: &[&str]) -> Result<Covered, Failure>;

    /// Everything that is measured in a piece, enclosed for all its times at once.
    fn moment<'t>(&'t self, piece: &Piece) -> Result<Box<dyn Moment + 't>, Failure>;

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
