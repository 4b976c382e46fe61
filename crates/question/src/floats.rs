//! What a run in floating point says of a property that could not be decided: an opinion, never a verdict.

use crate::bindings::Bindings;
use crate::case::Case;
use crate::evaluate::Evaluator;
use crate::question::Question;
use crate::subject::run::FloatRun;
use crate::truth::Truth;
use arithmetic::Progress;

impl Question {
    /// A sentence on the property at the times of a run, where there is a motion to run.
    pub(crate) fn float_opinion(&self, bindings: &Bindings, progress: &dyn Progress) -> Option<String> {
        let property = self.property.as_ref()?;
        let point = bindings.middle();
        let until = self.last_time(&point, progress)?;
        let rows = self.scenario()?.run(&point, &until).ok()?.run(progress).rows;
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
