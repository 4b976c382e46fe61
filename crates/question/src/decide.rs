//! From a question to its verdict: every member is decided, a continuum is divided, controls must be refuted.

use crate::answer::{Answer, Verdict};
use crate::bindings::Bindings;
use crate::case::Case;
use crate::division::Division;
use crate::error::{Problem, QuestionError};
use crate::evaluate::{Evaluator, Failure, Measured};
use crate::names::Subject;
use crate::number::Number;
use crate::question::{Expression, Question};
use crate::shrink::Shrunk;
use crate::syntax::Node;
use crate::truth::{Doubt, Margin, Truth};
use arithmetic::Progress;
use motion::side_by_side;

/// Bits that every comparison is tried with first.
pub(crate) const FIRST_BITS: u32 = 64;

/// Most bits where it is known that they decide.
const MOST_BITS: u64 = 1 << 16;

/// Most bits where it is not known whether any number of them decides.
const MOST_HOPEFUL_BITS: u64 = 1 << 11;

/// Boxes that a continuum is divided into at most, for all members of the family together.
const MOST_BOXES: u64 = 200_000;

/// The same where each box is a motion to be enclosed.
const MOST_MOTIONS: u64 = 500;

/// Least number of boxes for each member.
const LEAST_BOXES: u64 = 64;

/// What was found for one case.
#[derive(Debug, Clone)]
pub struct Decided {
    /// Whether the property holds for all that the names stand for.
    pub truth: Truth,
    /// Encloses the smallest margin.
    pub margin: Margin,
    /// The same of each inequality of the property by itself.
    pub inequalities: Vec<Margin>,
    /// Whether `where` leaves the case out.
    pub excluded: bool,
    /// Members or boxes that were looked at.
    pub boxes: u64,
    /// Boxes that stayed undecided.
    pub open: u64,
    /// Names for which the property fails, confirmed.
    pub counterexample: Option<Bindings>,
}

/// The outcome of a property over a whole family.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// True for all, false for some, or not known.
    pub truth: Truth,
    /// Encloses the smallest margin of all that were looked at.
    pub margin: Option<Margin>,
    /// The same of each inequality of the property by itself.
    pub inequalities: Vec<Margin>,
    /// Members of the family, a continuum counting as one.
    pub total: u64,
    /// Members, or boxes of members, that were looked at.
    pub cases: u64,
    /// Those that stayed undecided.
    pub open: u64,
    /// Whether a continuum was among them.
    pub boxed: bool,
    /// The first counterexample.
    pub counterexample: Option<Bindings>,
}

impl Question {
    /// Decides the property for one case.
    ///
    /// # Errors
    /// [`QuestionError`] where the question is wrong there.
    pub fn decide(&self, bindings: &Bindings, progress: &dyn Progress) -> Result<Decided, QuestionError> {
        self.decide_expression(self.asked()?, bindings, MOST_BOXES, progress)
    }

    /// The quantities of `[values]` for one case, exact or enclosed.
    ///
    /// # Errors
    /// [`QuestionError`] where the question is wrong there.
    pub fn values(
        &self,
        bindings: &Bindings,
        progress: &dyn Progress,
    ) -> Result<Vec<(String, Tabulated)>, QuestionError> {
        let case = Case::new(self, bindings.clone(), true, progress);
        let value = |(name, expression): &(String, Expression)| {
            let evaluator = Evaluator { case: &case, precision: 2 * FIRST_BITS, moment: None, piece: None };
            let value = match evaluator.measured(&expression.node) {
                Ok(Measured::Number(number)) => Tabulated::Number(number),
                Ok(Measured::Truth(truth)) => Tabulated::Truth(truth),
                Err(Failure::Open(doubt)) => Tabulated::Unknown(doubt.why),
                Err(failure) => return Err(self.refused(failure, expression.base)),
            };
            Ok((name.clone(), value))
        };
        self.value_expressions().iter().map(value).collect()
    }

    /// Whether `where` keeps the case.
    ///
    /// # Errors
    /// [`QuestionError`] also where that cannot be told.
    pub fn is_kept(&self, bindings: &Bindings, progress: &dyn Progress) -> Result<bool, QuestionError> {
        let Some(restriction) = &self.restriction else { return Ok(true) };
        match self.decide_point(restriction, bindings, progress)?.truth {
            Truth::True => Ok(true),
            Truth::False => Ok(false),
            Truth::Unknown(_) if !bindings.boxes().is_empty() => Ok(true),
            Truth::Unknown(doubt) => {
                let why = format!("`where` could not be decided for {bindings}: {}", doubt.why);
                Err(self.at(restriction.base, Problem::Other(why)))
            }
        }
    }

    /// How many controls there are.
    pub fn control_count(&self) -> usize {
        self.controls.len()
    }

    /// Whether a control, counted from 0, is refuted by one case.
    ///
    /// # Errors
    /// [`QuestionError`] where the question is wrong there.
    pub fn refutes(&self, control: usize, bindings: &Bindings, progress: &dyn Progress) -> Result<bool, QuestionError> {
        let Some(control) = self.controls.get(control) else { return Ok(false) };
        let decided = self.decide_expression(control, bindings, MOST_BOXES, progress)?;
        Ok(!decided.excluded && decided.truth == Truth::False)
    }

    pub(crate) fn decide_expression(
        &self,
        expression: &Expression,
        bindings: &Bindings,
        most: u64,
        progress: &dyn Progress,
    ) -> Result<Decided, QuestionError> {
        if !bindings.boxes().is_empty() {
            return Division { question: self, expression, progress, most }.decide(bindings);
        }
        if !self.is_kept(bindings, progress)? {
            return Ok(Decided { excluded: true, ..Decided::nothing() });
        }
        let Judged { truth, margin, inequalities } = self.decide_point(expression, bindings, progress)?;
        let counterexample = (truth == Truth::False).then(|| bindings.clone());
        let open = u64::from(matches!(truth, Truth::Unknown(_)));
        Ok(Decided { truth, margin, inequalities, excluded: false, boxes: 1, open, counterexample })
    }

    /// Raises the precision until the property is decided, or that is known to be in vain.
    pub(crate) fn decide_point(
        &self,
        expression: &Expression,
        bindings: &Bindings,
        progress: &dyn Progress,
    ) -> Result<Judged, QuestionError> {
        let case = Case::new(self, bindings.clone(), false, progress);
        let mut precision = FIRST_BITS;
        loop {
            progress.checkpoint()?;
            let (truth, margin) = self.judged(&case, expression, precision)?;
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

    pub(crate) fn judged(
        &self,
        case: &Case,
        expression: &Expression,
        precision: u32,
    ) -> Result<(Truth, Margin), QuestionError> {
        let judged = Evaluator { case, precision, moment: None, piece: None }.judge(&expression.node);
        match judged {
            Ok(judged) => Ok(judged),
            Err(Failure::Open(doubt)) => Ok((Truth::Unknown(doubt), Margin::ANY)),
            Err(failure) => Err(self.refused(failure, expression.base)),
        }
    }

    /// The margins of the inequalities of a property one by one, that of the whole where it is one itself.
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
        expression.inequalities.iter().map(own).collect()
    }
}

/// What was found for one point.
#[derive(Debug, Clone)]
pub(crate) struct Judged {
    pub truth: Truth,
    pub margin: Margin,
    pub inequalities: Vec<Margin>,
}

impl Decided {
    /// Nothing was looked at yet.
    pub(crate) fn nothing() -> Self {
        Decided {
            truth: Truth::True,
            margin: Margin::of_truth(true),
            inequalities: Vec::new(),
            excluded: false,
            boxes: 0,
            open: 0,
            counterexample: None,
        }
    }
}

impl Tabulated {
    /// The value as tables show it: exact, enclosed, `true` or `false`; empty where it is not known.
    pub fn text(&self) -> String {
        match self {
            Tabulated::Number(number) => number.text(),
            Tabulated::Truth(truth) => truth.to_string(),
            Tabulated::Unknown(_) => String::new(),
        }
    }
}

/// A value of `[values]`.
#[derive(Debug, Clone)]
pub enum Tabulated {
    /// A number, exact or enclosed.
    Number(Number),
    /// True or false.
    Truth(bool),
    /// Not known, with the reason.
    Unknown(String),
}

/// Decides a question: its property over the whole family, then that its controls are refuted.
///
/// # Errors
/// [`QuestionError`] where the question is wrong, its family empty or too large.
pub fn decide(question: &Question, progress: &dyn Progress) -> Result<Answer, QuestionError> {
    let property = question.asked()?;
    let outcome = over_family(question, property, progress)?;
    let mut refuted = Vec::new();
    for control in &question.controls {
        refuted.push(over_family(question, control, progress)?.truth == Truth::False);
    }
    let shrunk = match &outcome.counterexample {
        Some(found) => {
            let simpler = Shrunk::of(question, property, found, progress)?;
            let replay = question.replay(&simpler, progress)?;
            Some((simpler, replay))
        }
        None => None,
    };
    let mut answer = Answer::new(question, outcome, shrunk, refuted);
    if answer.verdict == Verdict::Undecided
        && let Some(first) = question.case(0, progress)?
        && let Some(opinion) = question.float_opinion(&first, progress)
    {
        answer.why = format!("{} {opinion}", answer.why);
    }
    Ok(answer)
}

/// A property over the whole family, up to its first counterexample. The result does not depend on the number of threads.
fn over_family(
    question: &Question,
    expression: &Expression,
    progress: &dyn Progress,
) -> Result<Outcome, QuestionError> {
    const FIRST_CHUNK: u64 = 16;
    const LARGEST_CHUNK: u64 = 2048;
    let total = question.cases(progress)?;
    let all = if question.subjects().contains(&Subject::Motion) { MOST_MOTIONS } else { MOST_BOXES };
    let budget = question.budget();
    let most = (all.min(budget) / total.max(1)).max(LEAST_BOXES.min(budget));
    let mut outcome = Outcome {
        truth: Truth::True,
        margin: None,
        inequalities: Vec::new(),
        total,
        cases: 0,
        open: 0,
        boxed: false,
        counterexample: None,
    };
    let (mut next, mut chunk) = (0, FIRST_CHUNK);
    while next < total {
        let end = (next + chunk).min(total);
        let numbers: Vec<_> = (next..end).collect();
        let decide = |&number: &_| -> Result<Option<(Decided, bool)>, QuestionError> {
            let Some(bindings) = question.case(number, progress)? else { return Ok(None) };
            let boxed = !bindings.boxes().is_empty();
            Ok(Some((question.decide_expression(expression, &bindings, most, progress)?, boxed)))
        };
        let decided = side_by_side(&numbers, decide);
        for found in decided {
            let Some((found, boxed)) = found? else { continue };
            if found.excluded {
                continue;
            }
            outcome.cases += found.boxes;
            outcome.open += found.open;
            outcome.boxed |= boxed;
            outcome.margin = Some(outcome.margin.map_or(found.margin, |least| least.least(found.margin)));
            Margin::least_of_each(&mut outcome.inequalities, &found.inequalities);
            if found.counterexample.is_some() {
                outcome.truth = Truth::False;
                outcome.counterexample = found.counterexample;
                return Ok(outcome);
            }
            outcome.truth = outcome.truth.and(found.truth);
        }
        progress.tell("cases", end, Some(total));
        next = end;
        chunk = (2 * chunk).min(LARGEST_CHUNK);
    }
    if outcome.cases == 0 {
        let base = question.bounds.first().map_or(0, |bound| bound.base);
        return Err(question.at(base, Problem::Empty("`where` leaves out every member".to_string())));
    }
    Ok(outcome)
}

impl Answer {
    fn new(question: &Question, outcome: Outcome, shrunk: Option<(Shrunk, String)>, refuted: Vec<bool>) -> Self {
        let verdict = match (&outcome.truth, refuted.iter().all(|refuted| *refuted)) {
            (_, false) => Verdict::Withheld,
            (Truth::False, true) => Verdict::False,
            (Truth::True, true) if !question.is_sample() => Verdict::Holds,
            _ => Verdict::Undecided,
        };
        Answer::judged(question, verdict, outcome, shrunk, &refuted)
    }
}
