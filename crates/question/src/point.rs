//! A property at one point of a family, with as many bits as it takes.

use crate::bindings::Bindings;
use crate::case::Case;
use crate::error::{Problem, QuestionError};
use crate::evaluate::Evaluator;
use crate::failure::Failure;
use crate::outcome::Judged;
use crate::question::{Expression, Question};
use crate::syntax::Node;
use crate::truth::{Doubt, Margin, Truth};
use arithmetic::Progress;

/// Bits that every comparison is tried with first.
pub(crate) const FIRST_BITS: u32 = 64;

/// Most bits where it is known that they decide.
pub(crate) const MOST_BITS: u64 = 1 << 16;

/// Most bits where it is not known whether any number of them decides.
const MOST_HOPEFUL_BITS: u64 = 1 << 11;

impl Question {
    /// Whether `where` keeps the case.
    ///
    /// # Errors
    /// [`QuestionError`] also where that cannot be told.
    pub fn is_kept(&self, bindings: &Bindings, progress: &dyn Progress) -> Result<bool, QuestionError> {
        match self.kept(bindings, progress)? {
            Truth::True => Ok(true),
            Truth::False => Ok(false),
            Truth::Unknown(_) if !bindings.sides().is_empty() => Ok(true),
            Truth::Unknown(doubt) => {
                let why = format!("`where` could not be decided for {bindings}: {}", doubt.why);
                let base = self.restriction.as_ref().map_or(0, |restriction| restriction.base);
                Err(self.at(base, Problem::Other(why)))
            }
        }
    }

    /// The truth of `where`, which is missing where its value is.
    pub(crate) fn kept(&self, bindings: &Bindings, progress: &dyn Progress) -> Result<Truth, QuestionError> {
        match &self.restriction {
            None => Ok(Truth::True),
            Some(restriction) => Ok(self.decide_point(restriction, bindings, progress)?.truth),
        }
    }

    /// Raises the precision until the property is decided, or that is known to be in vain.
    ///
    /// # Errors
    /// [`QuestionError`] with the point where a value that matters is missing.
    pub(crate) fn decide_point(
        &self,
        expression: &Expression,
        bindings: &Bindings,
        progress: &dyn Progress,
    ) -> Result<Judged, QuestionError> {
        let case = Case::new(self, bindings.clone(), progress);
        let mut precision = FIRST_BITS;
        let missing = |failure| match failure {
            Failure::Refused(at, problem) => self.at(expression.base + at, problem.there(bindings)),
            failure => self.refused(failure, expression.base),
        };
        loop {
            progress.checkpoint()?;
            let (truth, margin) = self.judged(&case, expression, precision).map_err(missing)?;
            let wanted = match &truth {
                Truth::Unknown(Doubt { bits: Some(needed), .. }) if *needed <= MOST_BITS => {
                    needed.next_power_of_two() * 2
                }
                Truth::Unknown(Doubt { bits: Some(_), .. }) => MOST_HOPEFUL_BITS,
                _ => 0,
            };
            if u64::from(precision) * 2 > wanted {
                let inequalities = self.each_margin(&case, expression, precision, margin)?;
                return Ok(Judged { truth, margin, inequalities });
            }
            precision *= 2;
        }
    }

    /// The truth in a case; `Refused` where its value is missing.
    pub(crate) fn judged(
        &self,
        case: &Case,
        expression: &Expression,
        precision: u32,
    ) -> Result<(Truth, Margin), Failure> {
        let judged = Evaluator { case, precision, moment: None, piece: None }.judge(&expression.node);
        match judged {
            Err(Failure::Open(doubt)) => Ok((Truth::Unknown(doubt), Margin::ANY)),
            judged => judged,
        }
    }

    /// The margins of the inequalities of a property one by one, and of its bounds, that of the whole where it is one itself.
    pub(crate) fn each_margin(
        &self,
        case: &Case,
        expression: &Expression,
        precision: u32,
        whole: Margin,
    ) -> Result<Vec<Margin>, QuestionError> {
        let evaluator = Evaluator { case, precision, moment: None, piece: None };
        let own = |node: &Node| {
            if node.kind == expression.node.kind {
                return Ok(whole);
            }
            match evaluator.judge(node) {
                Ok((_, margin)) => Ok(margin),
                // What another part of the property keeps from being asked here.
                Err(Failure::Refused(..)) => Ok(Margin::of_truth(true)),
                Err(Failure::Open(_)) => Ok(Margin::ANY),
                Err(failure) => Err(self.refused(failure, expression.base)),
            }
        };
        expression.measured().map(own).collect()
    }
}
