//! What moves in one case, for pictures.

use crate::bindings::Bindings;
use crate::case::Case;
use crate::evaluate::{Evaluator, horizon};
use crate::question::Question;
use arithmetic::{Progress, Rational, rational};
use models::averaging::Start;
use scenario::Source;

/// What moves.
#[derive(Debug, Clone)]
pub enum Instance {
    /// An averaging flock.
    Flock(Start),
    /// A scenario up to the last time that the property looks at.
    Motion(Box<Source>),
}

impl Question {
    /// The scenario of the question with these numbers; nothing where it has none.
    pub fn moving(&self, bindings: &Bindings, progress: &dyn Progress) -> Option<Instance> {
        let (scenario, point) = (self.scenario()?, bindings.middle());
        if scenario.is_flock() {
            return scenario.flock(&point).ok().map(Instance::Flock);
        }
        let until = self.last_time(&point, progress).filter(|t| *t > rational(0, 1)).unwrap_or(rational(1, 1));
        scenario.source(&point, &until).ok().map(|source| Instance::Motion(Box::new(source)))
    }

    /// The last time that the property looks at.
    pub(crate) fn last_time(&self, point: &Bindings, progress: &dyn Progress) -> Option<Rational> {
        let case = Case::new(self, point.clone(), progress);
        let evaluator = Evaluator { case: &case, precision: 64, moment: None, piece: None };
        horizon(&evaluator, &self.property.as_ref()?.node).ok()
    }
}
