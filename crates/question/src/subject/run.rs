//! A run in floating point, of which nothing is known between its rows.

use crate::error::Problem;
use crate::failure::Failure;
use crate::names::Quantity;
use crate::timeline::{Covered, Measured, Moment, Piece, Timeline};
use crate::truth::Doubt;
use arithmetic::RealNumber as Number;
use arithmetic::{Dyadic, Interval, Rational};
use num_traits::ToPrimitive;
use scenario::{Row, Value};

/// A run as rows; between them nothing is known.
pub(crate) struct FloatRun {
    pub rows: Vec<Row>,
}

impl Timeline for FloatRun {
    fn pieces(&self, from: &Rational, to: Option<&Rational>, _: &[&str]) -> Result<Covered, Failure> {
        let exact = |row: &Row| Rational::from_float(row.time);
        let times = self.rows.iter().filter_map(exact);
        let inside = times.filter(|time| time >= from && to.is_none_or(|to| time <= to));
        let pieces: Vec<Piece> = inside.map(|time| Piece { from: time.clone(), to: Some(time) }).collect();
        let none = || Doubt { why: "the run has no row there".to_string(), bits: None };
        Ok(Covered { rest: pieces.is_empty().then(none), pieces })
    }

    fn moment<'t>(&'t self, piece: &Piece) -> Result<Box<dyn Moment + 't>, Failure> {
        let time = piece.from.to_f64().unwrap_or(f64::NAN);
        let row = self.rows.iter().find(|row| row.time >= time);
        let row = row.ok_or_else(|| Failure::open("the run has no row there", None))?;
        Ok(Box::new(AtRow { row }))
    }

    fn halves(&self, _: &Piece) -> Option<[Piece; 2]> {
        None
    }

    fn prepare(&self, _: &Rational) -> Result<(), Failure> {
        Ok(())
    }

    fn inside(&self, from: Rational, to: Option<Rational>) -> (Rational, Option<Rational>) {
        (from, to)
    }
}

/// A row of a run.
struct AtRow<'r> {
    row: &'r Row,
}

impl Moment for AtRow<'_> {
    fn measure(&self, quantity: &Quantity, arguments: &[Number], _: u32) -> Result<Measured, Failure> {
        let missing = || Failure::Refused(0, Problem::Other(format!("`{}` is not measured", quantity.name)));
        let found = self.row.observables.iter().find(|observable| observable.name == quantity.name);
        let index = arguments.first().and_then(Number::as_integer).and_then(|m| m.to_usize()).unwrap_or(1);
        let value = match &found.ok_or_else(missing)?.value {
            Value::Number(x) => *x,
            Value::Count(count) => count.ok_or_else(missing)? as f64,
            Value::List(list) => *index.checked_sub(1).and_then(|k| list.get(k)).ok_or_else(missing)?,
        };
        let exact = Dyadic::from_f64(value).ok_or_else(missing)?;
        Ok(Measured::Number(Number::interval(Interval::between(exact.clone(), exact, 64))))
    }
}
