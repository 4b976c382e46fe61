//! From a question to its verdict: every member is decided, a continuum is divided, controls must be refuted.

use crate::answer::{Answer, Verdict};
use crate::bindings::{Bindings, Value};
use crate::case::Case;
use crate::division::Division;
use crate::error::{Problem, QuestionError};
use crate::evaluate::Evaluator;
use crate::failure::Failure;
use crate::made;
use crate::names::{Subject, quantity_of};
use crate::number::Number;
use crate::outcome::{Decided, Judged, Outcome, Spot};
use crate::point::{FIRST_BITS, MOST_BITS};
use crate::question::{Asked, Expression, Question};
use crate::shrink::Shrunk;
use crate::states;
use crate::subject::platoon::signs;
use crate::syntax::Kind;
use crate::timeline::Measured;
use crate::truth::{Doubt, Margin, Truth};
use arithmetic::Progress;
use arithmetic::threads::side_by_side;

/// Boxes that a continuum is divided into at most, for all members of the family together.
const MOST_BOXES: u64 = 200_000;

/// The same where each box is a motion to be enclosed.
const MOST_MOTIONS: u64 = 500;

/// Least number of boxes for each member.
const LEAST_BOXES: u64 = 64;

impl Question {
    /// Decides the property for one case.
    ///
    /// # Errors
    /// [`QuestionError`] where the question is wrong there.
    pub fn decide(&self, bindings: &Bindings, progress: &dyn Progress) -> Result<Decided, QuestionError> {
        self.decide_expression(self.asked()?, bindings, self.most_boxes(1), progress)
    }

    /// Most boxes for each of so many members.
    fn most_boxes(&self, members: u64) -> u64 {
        let all = if self.subjects().contains(&Subject::Motion) { MOST_MOTIONS } else { MOST_BOXES };
        let budget = self.budget();
        (all.min(budget) / members.max(1)).max(LEAST_BOXES.min(budget))
    }

    /// The property for one of so many members, which share the boxes, and its margin; both are unknown, with the reason, where a value is missing.
    ///
    /// # Errors
    /// [`QuestionError::Cancelled`], or a question without a property.
    pub fn tabulated(
        &self,
        bindings: &Bindings,
        members: u64,
        progress: &dyn Progress,
    ) -> Result<(Truth, Margin), QuestionError> {
        match self.decide_expression(self.asked()?, bindings, self.most_boxes(members), progress) {
            Ok(decided) => Ok((decided.truth, decided.margin)),
            Err(QuestionError::At { problem, .. }) if !problem.is_misuse() => {
                Ok((Truth::unknown(problem.told_there(), None), Margin::ANY))
            }
            Err(error) => Err(error),
        }
    }

    /// The quantities of `[values]` for one of so many members, which share the boxes: exact, enclosed, true or false. A value that is missing is unknown, with
    /// the reason.
    ///
    /// # Errors
    /// [`QuestionError`] where the words of the question are wrong for every member, or it was cancelled.
    pub fn values(
        &self,
        bindings: &Bindings,
        members: u64,
        progress: &dyn Progress,
    ) -> Result<Vec<(String, Tabulated)>, QuestionError> {
        let case = Case::new(self, bindings.clone(), progress);
        let measured = |Asked { expression, is_truth, .. }: &Asked| -> Result<Tabulated, QuestionError> {
            if *is_truth {
                let found = self.decide_expression(expression, bindings, self.most_boxes(members), progress)?;
                return Ok(match found.truth {
                    Truth::Unknown(doubt) => Tabulated::Unknown(doubt.why),
                    // One point is enough for that, and elsewhere it may be true.
                    Truth::False if !bindings.sides().is_empty() => Tabulated::Unknown(
                        "it is false at a point of the box; whether it is everywhere was not asked".to_string(),
                    ),
                    truth => Tabulated::Truth(truth == Truth::True),
                });
            }
            let at =
                |precision| Evaluator { case: &case, precision, moment: None, piece: None }.measured(&expression.node);
            let found = match at(2 * FIRST_BITS) {
                // Bits that will tell, where that is known.
                Err(Failure::Open(Doubt { bits: Some(needed), .. })) if needed <= MOST_BITS => {
                    at(u32::try_from(needed.next_power_of_two() * 2).unwrap_or(2 * FIRST_BITS))
                }
                found => found,
            };
            Ok(match found {
                Ok(Measured::Number(number)) => Tabulated::Number(number),
                Ok(Measured::Truth(truth)) => Tabulated::Truth(truth),
                Err(Failure::Open(doubt)) => Tabulated::Unknown(doubt.why),
                Err(failure) => return Err(self.refused(failure, expression.base)),
            })
        };
        let value = |asked: &Asked| match measured(asked) {
            Err(QuestionError::At { problem, .. }) if !problem.is_misuse() => {
                Ok((asked.name.clone(), Tabulated::Unknown(problem.told_there())))
            }
            found => Ok((asked.name.clone(), found?)),
        };
        self.asked_values().iter().map(value).collect()
    }

    /// Whether the property asks for a quantity of a platoon.
    fn asks_a_platoon(&self) -> bool {
        let mut asks = false;
        if let Some(property) = &self.property {
            property.node.visit(&mut |node| {
                asks |= matches!(&node.kind, Kind::Name { name, .. }
                    if quantity_of(name, self.subjects()).is_some_and(|own| own.subject == Subject::Platoon));
            });
        }
        asks
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
        if let Some(law) = self.law() {
            return states::decide(self, law, expression, bindings, progress);
        }
        if !bindings.sides().is_empty() {
            return Division { question: self, expression, progress, most }.decide(bindings);
        }
        let kept = self.is_kept(bindings, progress);
        if let Ok(false) = kept {
            return Ok(Decided { excluded: true, ..Decided::nothing() });
        }
        let Judged { truth, margin, inequalities } = match (kept, self.decide_point(expression, bindings, progress)) {
            // Where the property is true it does not matter whether `where` keeps the case.
            (Err(error @ QuestionError::At { .. }), decided) => {
                decided.ok().filter(|judged| judged.truth == Truth::True).ok_or(error)?
            }
            (kept, decided) => kept.and(decided)?,
        };
        let exactly = match &truth {
            Truth::Unknown(_) => Division { question: self, expression, progress, most: 1 }.at_numbers(bindings)?,
            _ => None,
        };
        let (truth, margin) = match exactly {
            Some(true) => (Truth::True, margin.held()),
            Some(false) => (Truth::False, margin),
            None => (truth, margin),
        };
        let counterexample = (truth == Truth::False).then(|| bindings.clone());
        let open = u64::from(matches!(truth, Truth::Unknown(_)));
        Ok(Decided {
            truth,
            margin,
            inequalities,
            excluded: false,
            boxes: 1,
            open,
            counterexample,
            ..Decided::nothing()
        })
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
    let mut made = None;
    let mut refuted = Vec::new();
    for control in &question.controls {
        refuted.push(over_family(question, control, progress)?.truth == Truth::False);
    }
    let unmet = made::unmet(question, property, &outcome, progress)?;
    if question.controls.is_empty() {
        let found = made::controls(question, property, &outcome, progress)?;
        refuted = vec![true; found.controls.len()];
        made = Some(found);
    }
    let counterexamples = match question.listed_counterexamples {
        0 => None,
        most => Some(question.counterexamples(property, most, progress)?),
    };
    let tight = match question.listed_tight {
        0 => None,
        most => question.tight(property, most, progress)?,
    };
    let shrunk = match &outcome.counterexample {
        Some(found) => {
            let simpler = match question.law() {
                // Simpler already.
                Some(_) => Shrunk { bindings: found.clone(), property: property.clone() },
                None => Shrunk::of(question, property, found, progress)?,
            };
            let replay = question.replay(&simpler, progress)?;
            Some((simpler, replay))
        }
        None => None,
    };
    let decisive = match (&shrunk, question.law()) {
        (None, _) => None,
        (Some((simpler, _)), None) => question.decisive(&simpler.property, &simpler.bindings, false, progress)?,
        (Some((simpler, _)), Some(law)) => states::decisive(question, law, &simpler.property, &simpler.bindings)?,
    };
    // What stands beside a counterexample is measured there.
    let there = match &shrunk {
        Some((simpler, _)) if question.law().is_none() => {
            Some(question.decide_point(property, &simpler.bindings, progress)?)
        }
        _ => None,
    };
    let mut answer = Answer::new(question, outcome, shrunk, refuted);
    if let Some(there) = there.filter(|_| answer.verdict == Verdict::False) {
        answer.margin = Some(there.margin);
        answer.inequalities.iter_mut().zip(there.inequalities).for_each(|(own, margin)| own.1 = Some(margin));
    }
    answer.without_floats(&question.float_names());
    (answer.counterexamples, answer.tight) = (counterexamples, tight);
    let looked = match &answer.counterexample {
        Some(found) => Some(found.clone()),
        None => question.case(0, progress)?,
    };
    let looked = looked.filter(|_| question.asks_a_platoon());
    let of_a_platoon = looked.iter().flat_map(|member| {
        let like_cars = match member.get("followers") {
            Some(Value::Number(followers)) => question.like_cars(followers),
            _ => None,
        };
        signs(member).into_iter().chain(like_cars)
    });
    let remarks = unmet.into_iter().chain(made.iter().flat_map(|made| made.remarks.clone())).chain(of_a_platoon);
    answer.why = std::iter::once(answer.why).chain(remarks).collect::<Vec<String>>().join(" ");
    answer.made = made;
    if question.law().is_some()
        && let Some(decisive) = &decisive
    {
        answer.margin = Some(decisive.margin);
    }
    answer.decisive = decisive.filter(|_| answer.counterexample.is_some());
    if let Some(law) = question.law().filter(|_| answer.verdict == Verdict::Holds) {
        let (grades, how) = law.told();
        answer.grades = grades;
        answer.why = format!("{} {how}", answer.why);
    }
    if answer.verdict == Verdict::Undecided
        && question.law().is_none()
        && let Some(first) = question.case(0, progress)?
        && let Some(opinion) = question.float_opinion(&first, progress)
    {
        answer.why = format!("{} {opinion}", answer.why);
    }
    Ok(answer)
}

/// A property over the whole family, up to its first counterexample. The result does not depend on the number of threads.
pub(crate) fn over_family(
    question: &Question,
    expression: &Expression,
    progress: &dyn Progress,
) -> Result<Outcome, QuestionError> {
    const FIRST_CHUNK: u64 = 16;
    const LARGEST_CHUNK: u64 = 2048;
    let total = question.cases(progress)?;
    let most = question.most_boxes(total);
    let mut outcome = Outcome {
        truth: Truth::True,
        margin: None,
        inequalities: Vec::new(),
        total,
        cases: 0,
        open: 0,
        boxed: false,
        counterexample: None,
        attained: None,
        closed: None,
        certificates: Vec::new(),
        uncertified: 0,
        unsettled: None,
    };
    // A counterexample decides, whatever has no value elsewhere.
    let mut missing = None;
    let (mut next, mut chunk) = (0, FIRST_CHUNK);
    while next < total {
        let end = (next + chunk).min(total);
        let numbers: Vec<_> = (next..end).collect();
        let decide = |&number: &_| -> Result<Option<(Decided, bool)>, QuestionError> {
            let Some(bindings) = question.case(number, progress)? else { return Ok(None) };
            let boxed = !bindings.sides().is_empty();
            let mut found = question.decide_expression(expression, &bindings, most, progress)?;
            let is_zero = found.truth == Truth::True && (found.margin.lo, found.margin.hi) == (0.0, 0.0);
            if is_zero && !boxed && !found.excluded {
                found.attained = Some(Spot::of(&bindings, &[]));
            }
            Ok(Some((found, boxed)))
        };
        let decided = side_by_side(&numbers, decide);
        for found in decided {
            let found = match found {
                Err(error @ QuestionError::At { .. }) => {
                    missing.get_or_insert(error);
                    continue;
                }
                found => found?,
            };
            let Some((found, boxed)) = found else { continue };
            if found.excluded {
                continue;
            }
            outcome.cases += found.boxes;
            outcome.open += found.open;
            outcome.boxed |= boxed;
            outcome.attained = outcome.attained.or(found.attained);
            outcome.certificates.extend(found.certificates);
            outcome.uncertified += found.uncertified;
            outcome.unsettled = outcome.unsettled.or(found.unsettled);
            outcome.margin = Some(outcome.margin.map_or(found.margin, |least| least.least(found.margin)));
            Margin::least_of_each(&mut outcome.inequalities, &found.inequalities);
            if found.counterexample.is_some() || found.closed.is_some() {
                outcome.truth = Truth::False;
                (outcome.counterexample, outcome.closed) = (found.counterexample, found.closed);
                return Ok(outcome);
            }
            outcome.truth = outcome.truth.and(found.truth);
        }
        progress.tell("cases", end, Some(total));
        next = end;
        chunk = (2 * chunk).min(LARGEST_CHUNK);
    }
    if let Some(missing) = missing {
        return Err(missing);
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
