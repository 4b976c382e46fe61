//! Controls that the program makes where the question has none, and hypotheses that are never met.

use crate::decide::over_family;
use crate::error::QuestionError;
use crate::outcome::Outcome;
use crate::question::{Expression, Question};
use crate::syntax::{Kind, Node, Relation};
use crate::truth::Truth;
use arithmetic::{Dyadic, Progress, Rational, rational, simplest_between};
use num_traits::Signed;

/// Times that a bound is tightened, a hundredfold each.
const TIGHTENED: usize = 3;

/// What was found out about a question beside its property.
pub(crate) struct Made {
    /// Altered properties that were refuted.
    pub controls: Vec<Expression>,
    /// What a reader should know, in sentences.
    pub remarks: Vec<String>,
}

/// The controls of a question without any: its negation, its conclusion without the hypothesis, a bound tightened until it fails. Only those that are
/// refuted are controls; of the others is said what that means.
pub(crate) fn controls(
    question: &Question,
    property: &Expression,
    outcome: &Outcome,
    progress: &dyn Progress,
) -> Result<Made, QuestionError> {
    let mut made = Made { controls: Vec::new(), remarks: Vec::new() };
    let node = &property.node;
    let negation = like(property, Kind::Not(Box::new(node.clone())));
    match refuted(question, &negation, progress)? {
        true => made.controls.push(negation),
        false if outcome.truth == Truth::False && !outcome.boxed => {
            made.remarks.push("The property fails for every member of the family that was decided.".to_string());
        }
        false => {}
    }
    if let Kind::Implies(_, conclusion) = &node.kind {
        let alone = like(property, conclusion.kind.clone());
        match refuted(question, &alone, progress)? {
            true => made.controls.push(alone),
            false if outcome.truth == Truth::True => {
                made.remarks
                    .push(format!("No member was found for which {} fails without the hypothesis.", alone.node));
            }
            false => {}
        }
    }
    if outcome.truth == Truth::True
        && let Some(tightened) = tightened(question, property, outcome, progress)?
    {
        made.controls.push(tightened);
    }
    Ok(made)
}

/// That the hypothesis of the property is met by no member of a finite family, where that is so.
pub(crate) fn unmet(
    question: &Question,
    property: &Expression,
    outcome: &Outcome,
    progress: &dyn Progress,
) -> Result<Option<String>, QuestionError> {
    let Kind::Implies(hypothesis, _) = &property.node.kind else { return Ok(None) };
    if outcome.boxed || outcome.truth != Truth::True || question.law().is_some() {
        return Ok(None);
    }
    let never = like(property, Kind::Not(hypothesis.clone()));
    let found = over_family(question, &never, progress);
    let holds = match found {
        Err(QuestionError::Cancelled(cancelled)) => return Err(cancelled.into()),
        found => found.is_ok_and(|found| found.truth == Truth::True),
    };
    let message = || {
        format!(
            "No member of the family meets the hypothesis {hypothesis}, so that the property says nothing about it."
        )
    };
    Ok(holds.then(message))
}

fn like(property: &Expression, kind: Kind) -> Expression {
    Expression { node: Node { kind, at: property.node.at }, base: property.base, inequalities: Vec::new() }
}

/// Whether a control is false for some member; one that has no value where it matters is no control.
fn refuted(question: &Question, control: &Expression, progress: &dyn Progress) -> Result<bool, QuestionError> {
    match over_family(question, control, progress) {
        Err(QuestionError::Cancelled(cancelled)) => Err(cancelled.into()),
        Err(_) => Ok(false),
        Ok(outcome) => Ok(outcome.truth == Truth::False),
    }
}

/// The inequality of the property, or of its conclusion, by so much sharper that it fails.
fn tightened(
    question: &Question,
    property: &Expression,
    outcome: &Outcome,
    progress: &dyn Progress,
) -> Result<Option<Expression>, QuestionError> {
    let (hypothesis, conclusion) = match &property.node.kind {
        Kind::Implies(hypothesis, conclusion) => (Some(hypothesis), conclusion.as_ref()),
        _ => (None, &property.node),
    };
    let Kind::Relation(left, others) = &conclusion.kind else { return Ok(None) };
    let [(relation, right)] = &others[..] else { return Ok(None) };
    if matches!(relation, Relation::Equal | Relation::Different) {
        return Ok(None);
    }
    // Where nothing is known of the margin, what is tried begins near 0.
    let margin = outcome.margin.and_then(|margin| Dyadic::from_f64(margin.hi)).map(|margin| margin.to_rational());
    let margin = margin.unwrap_or_default().max(rational(0, 1));
    let upwards = matches!(relation, Relation::Greater | Relation::AtLeast);
    let mut step = margin.clone().max(rational(1, 1));
    for _ in 0..TIGHTENED {
        let by = simplest_between(&(&margin + &step * rational(1, 1000)), &(&margin + &step * rational(1, 100)));
        let sharper = Kind::Relation(left.clone(), vec![(*relation, moved(right, by, upwards))]);
        let sharper = match hypothesis {
            None => sharper,
            Some(hypothesis) => Kind::Implies(hypothesis.clone(), Box::new(Node { kind: sharper, at: conclusion.at })),
        };
        let control = like(property, sharper);
        if refuted(question, &control, progress)? {
            return Ok(Some(control));
        }
        step *= rational(100, 1);
    }
    Ok(None)
}

/// An expression plus, or minus, a positive number.
fn moved(node: &Node, by: Rational, upwards: bool) -> Node {
    let at = node.at;
    let number = Node { kind: Kind::Number(by.abs()), at };
    let mut terms = match &node.kind {
        Kind::Sum(terms) => terms.clone(),
        _ => vec![(false, node.clone())],
    };
    terms.push((!upwards, number));
    Node { kind: Kind::Sum(terms), at }
}
