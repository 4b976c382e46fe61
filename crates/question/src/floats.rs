//! What a run in floating point says of a property that could not be decided: an opinion, never a verdict.

use crate::bindings::Bindings;
use crate::case::Case;
use crate::error::Problem;
use crate::evaluate::{Evaluator, Failure, Measured, Moment};
use crate::names::Quantity;
use crate::number::Number;
use crate::question::Question;
use crate::time::{Covered, Piece, Timeline};
use crate::truth::{Doubt, Truth};
use arithmetic::{Dyadic, Interval, Progress, Rational};
use num_traits::ToPrimitive;
use scenario::{Row, Scenario, Value};

/// A run as rows; between them nothing is known.
pub(crate) struct FloatRun {
    rows: Vec<Row>,
}

impl Question {
    /// A sentence on the property at the times of a run, where there is a motion to run.
    pub(crate) fn float_opinion(&self, bindings: &Bindings, progress: &dyn Progress) -> Option<String> {
        let property = self.property.as_ref()?;
        let point = bindings.middle();
        let until = self.last_time(&point, progress)?;
        let text = self.scenario()?.run_text(&point, &until).ok()?;
        let rows = Scenario::read(&text).ok()?.run(progress).rows;
        let count = rows.len();
        let run = FloatRun { rows };
        let floats = Case::of_floats(self, point, run, progress);
        let evaluator = Evaluator { case: &floats, precision: 64, moment: None, piece: None };
        let seen = match evaluator.judge(&property.node).ok()?.0 {
            Truth::True => "is true",
            Truth::False => "is false",
            Truth::Unknown(_) => return None,
        };
        Some(format!("In floating point, at {count} moments of a run, the property {seen}."))
    }
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
