//! Controls that the program makes where the question has none, and hypotheses that are never met.

use crate::bindings::Bindings;
use crate::decide::over_family;
use crate::error::QuestionError;
use crate::names::Subject;
use crate::outcome::Outcome;
use crate::question::{Expression, Question};
use crate::sharper::{bounds, just_past};
use crate::syntax::{Kind, Node};
use crate::truth::{Margin, Truth};
use arithmetic::{Dyadic, Progress, rational};

/// Times that a bound is made sharper where its smallest margin is not known, a hundredfold each.
const TRIED: usize = 3;

/// An altered property that the same check refutes.
#[derive(Debug, Clone)]
pub struct MadeControl {
    /// The property as it was altered.
    pub property: String,
    /// The first member, or point, for which it is false.
    pub fails_at: Bindings,
}

/// The controls of a question that has none itself.
#[derive(Debug, Clone, Default)]
pub struct Made {
    /// Altered properties that were refuted.
    pub controls: Vec<MadeControl>,
    /// Why there is none.
    pub why_none: Option<String>,
    /// What was found out beside them, in sentences.
    pub remarks: Vec<String>,
}

/// What became of an altered property.
enum Tried {
    Refuted(MadeControl),
    /// It is none, for a reason.
    Kept(String),
}

/// The controls of a question without any: its negation, its conclusions without their hypotheses, each bound just past its smallest margin. Only those that are
/// refuted are controls; of the others is said what that means.
pub(crate) fn controls(
    question: &Question,
    property: &Expression,
    outcome: &Outcome,
    progress: &dyn Progress,
) -> Result<Made, QuestionError> {
    let mut made = Made::default();
    let negation = like(property, Kind::Not(Box::new(property.node.clone())));
    match tried(question, property, negation, progress)? {
        Tried::Refuted(control) => made.controls.push(control),
        Tried::Kept(why) => {
            if outcome.truth == Truth::False && !outcome.boxed {
                made.remarks.push("The property fails for every member of the family that was decided.".to_string());
            }
            made.why_none = Some(why);
        }
    }
    for (_, conclusion) in implications(&property.node) {
        match tried(question, property, conclusion.clone(), progress)? {
            Tried::Refuted(control) => made.controls.push(control),
            Tried::Kept(_) if outcome.truth == Truth::True => {
                made.remarks.push(format!("No member was found for which {conclusion} fails without the hypothesis."));
            }
            Tried::Kept(_) => {}
        }
    }
    if outcome.truth == Truth::True {
        made.controls.extend(sharper(question, property, outcome, progress)?);
    }
    made.why_none = made.why_none.filter(|_| made.controls.is_empty());
    Ok(made)
}

/// The hypotheses that no member of a family, or point of its boxes, meets, in sentences.
pub(crate) fn unmet(
    question: &Question,
    property: &Expression,
    outcome: &Outcome,
    progress: &dyn Progress,
) -> Result<Vec<String>, QuestionError> {
    let mut never_met = Vec::new();
    // A motion would be enclosed anew for each.
    let moves = question.subjects().contains(&Subject::Motion);
    if outcome.boxed && moves || outcome.truth != Truth::True || question.law().is_some() {
        return Ok(never_met);
    }
    for hypothesis in hypotheses(&property.node) {
        let never = Expression::like(property, like(property, Kind::Not(Box::new(hypothesis.clone()))));
        let found = over_family(question, &never, progress);
        let holds = match found {
            Err(QuestionError::Cancelled(cancelled)) => return Err(cancelled.into()),
            found => found.is_ok_and(|found| found.truth == Truth::True),
        };
        if holds {
            let who = if outcome.boxed { "No point of the family" } else { "No member of the family" };
            never_met
                .push(format!("{who} meets the hypothesis {hypothesis}, so that what follows from it says nothing."));
        }
    }
    Ok(never_met)
}

/// The parts of a property that have a hypothesis, with their conclusions.
fn implications(node: &Node) -> Vec<(&Node, &Node)> {
    match &node.kind {
        Kind::And(list) => list.iter().flat_map(implications).collect(),
        Kind::Implies(hypothesis, conclusion) => vec![(hypothesis, conclusion)],
        _ => Vec::new(),
    }
}

/// The hypotheses of a property; of one within a conclusion with those before it.
fn hypotheses(node: &Node) -> Vec<Node> {
    match &node.kind {
        Kind::And(list) => list.iter().flat_map(hypotheses).collect(),
        Kind::Implies(hypothesis, conclusion) => {
            let and = |inner: Node| {
                let at = inner.at;
                Node { kind: Kind::And(vec![hypothesis.as_ref().clone(), inner]), at }
            };
            let inner = hypotheses(conclusion).into_iter().map(and);
            std::iter::once(hypothesis.as_ref().clone()).chain(inner).collect()
        }
        _ => Vec::new(),
    }
}

fn like(property: &Expression, kind: Kind) -> Node {
    Node { kind, at: property.node.at }
}

/// Whether an altered property is false for some member; one that has no value where it matters is no control.
fn tried(
    question: &Question,
    property: &Expression,
    node: Node,
    progress: &dyn Progress,
) -> Result<Tried, QuestionError> {
    let text = node.to_string();
    let found = match over_family(question, &Expression::like(property, node), progress) {
        Err(QuestionError::Cancelled(cancelled)) => return Err(cancelled.into()),
        Err(error) => return Ok(Tried::Kept(format!("{text} has no value ({error})"))),
        Ok(found) => found,
    };
    Ok(match (found.truth, found.counterexample) {
        (Truth::False, Some(fails_at)) => Tried::Refuted(MadeControl { property: text, fails_at }),
        (Truth::False, None) => Tried::Kept(format!("{text} is false, and no member shows it")),
        (Truth::True, _) => Tried::Kept(format!("{text} holds for every member that was decided")),
        (Truth::Unknown(doubt), _) => Tried::Kept(format!("{text} stayed undecided: {}", doubt.why)),
    })
}

/// The bounds of the property, each so much sharper that it fails.
fn sharper(
    question: &Question,
    property: &Expression,
    outcome: &Outcome,
    progress: &dyn Progress,
) -> Result<Vec<MadeControl>, QuestionError> {
    let mut found = Vec::new();
    let exact = |margin: &Margin| Dyadic::from_f64(margin.hi).map(|margin| margin.to_rational());
    // A motion is enclosed anew for each.
    let most = if question.subjects().contains(&Subject::Motion) { 1 } else { TRIED };
    for bound in bounds(&property.node) {
        let margin = match property.place(&bound.alone) {
            Some(Some(place)) => outcome.inequalities.get(place).copied(),
            Some(None) | None => outcome.margin,
        };
        let smallest = margin.as_ref().and_then(exact);
        // Of a finite family: nothing rests on this bound, since some other part of the property is true wherever it is asked.
        if smallest.is_none() && !outcome.boxed && question.law().is_none() {
            continue;
        }
        let mut by = just_past(&smallest.unwrap_or_default().max(rational(0, 1)));
        for _ in 0..most {
            if let Tried::Refuted(control) = tried(question, property, (bound.by)(&by), progress)? {
                found.push(control);
                break;
            }
            by *= rational(100, 1);
        }
    }
    Ok(found)
}
