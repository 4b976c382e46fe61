//! Members of a family one by one: counterexamples beyond the first, and those at which a bound is attained.

use crate::bindings::Bindings;
use crate::decisive::Decisive;
use crate::error::QuestionError;
use crate::question::{Expression, Question};
use crate::syntax::{Kind, Node, Relation};
use crate::truth::{Margin, Truth};
use arithmetic::Progress;
use arithmetic::threads::side_by_side;

/// A member with what decides there.
#[derive(Debug, Clone)]
pub struct Member {
    /// The names with what they stand for.
    pub bindings: Bindings,
    /// The inequality that decides, with the values of its sides; `None` where none does.
    pub decisive: Option<Decisive>,
    /// The margin of the property there.
    pub margin: Margin,
}

/// Members that were asked for, in the order of the family.
#[derive(Debug, Clone)]
pub struct Listed {
    /// What is true of them.
    pub what: String,
    /// They themselves.
    pub members: Vec<Member>,
    /// Whether there may be more, since no more were asked for.
    pub cut: bool,
}

impl Question {
    /// The first counterexamples, so many at most.
    pub(crate) fn counterexamples(
        &self,
        property: &Expression,
        most: u64,
        progress: &dyn Progress,
    ) -> Result<Listed, QuestionError> {
        let what = format!("not ({})", property.node);
        self.listed(property, [property, property], Truth::False, what, most, progress)
    }

    /// The first members at which an inequality of the property is an equation, so many at most; `None` where it has no inequality that can be.
    pub(crate) fn tight(
        &self,
        property: &Expression,
        most: u64,
        progress: &dyn Progress,
    ) -> Result<Option<Listed>, QuestionError> {
        let like = |node: Node| Expression::like(property, node);
        let Some((whole, alone)) = equation(&property.node, true).zip(equation(&property.node, false)) else {
            return Ok(None);
        };
        let what = whole.to_string();
        self.listed(property, [&like(whole), &like(alone)], Truth::True, what, most, progress).map(Some)
    }

    /// Whether the property has no inequality that can be an equation.
    pub fn cannot_be_tight(&self) -> bool {
        self.property.as_ref().is_some_and(|property| equation(&property.node, true).is_none())
    }

    /// Members for which a condition has the truth that is wanted; those for which it is not known, or has no value, are none. What is shown of a
    /// member is the inequality that decides in the second expression.
    fn listed(
        &self,
        property: &Expression,
        [condition, shown]: [&Expression; 2],
        wanted: Truth,
        what: String,
        most: u64,
        progress: &dyn Progress,
    ) -> Result<Listed, QuestionError> {
        const CHUNK: u64 = 2048;
        let total = self.cases(progress)?;
        let mut listed = Listed { what, members: Vec::new(), cut: false };
        let mut next = 0;
        while next < total {
            let numbers: Vec<u64> = (next..(next + CHUNK).min(total)).collect();
            next += CHUNK;
            let is_one = |&number: &u64| -> Result<Option<Bindings>, QuestionError> {
                let Some(bindings) = self.case(number, progress)?.filter(|found| found.sides().is_empty()) else {
                    return Ok(None);
                };
                match self.is_kept(&bindings, progress).and_then(|kept| match kept {
                    true => self.decide_point(condition, &bindings, progress).map(|found| found.truth == wanted),
                    false => Ok(false),
                }) {
                    Err(QuestionError::Cancelled(cancelled)) => Err(cancelled.into()),
                    found => Ok(found.is_ok_and(|found| found).then_some(bindings)),
                }
            };
            for found in side_by_side(&numbers, is_one) {
                let Some(bindings) = found? else { continue };
                if listed.members.len() as u64 == most {
                    listed.cut = true;
                    return Ok(listed);
                }
                let margin = self.decide_point(property, &bindings, progress)?.margin;
                let decisive = self.decisive(shown, &bindings, wanted == Truth::True, progress)?;
                listed.members.push(Member { bindings, decisive, margin });
            }
            progress.tell("members", next.min(total), Some(total));
        }
        Ok(listed)
    }
}

/// That some inequality of a property is an equation where the property speaks of it: `a implies b <= c` as `a and b = c`, or, without the hypotheses, as `b = c`.
/// `None` where it has none.
fn equation(node: &Node, with_hypotheses: bool) -> Option<Node> {
    let like = |kind| Node { kind, at: node.at };
    let some = |parts: Vec<Node>| match parts.len() {
        0 => None,
        1 => parts.into_iter().next(),
        _ => Some(like(Kind::Or(parts))),
    };
    match &node.kind {
        Kind::Implies(_, conclusion) if !with_hypotheses => equation(conclusion, false),
        Kind::Implies(hypothesis, conclusion) => {
            Some(like(Kind::And(vec![hypothesis.as_ref().clone(), equation(conclusion, true)?])))
        }
        Kind::And(parts) | Kind::Or(parts) => {
            some(parts.iter().filter_map(|part| equation(part, with_hypotheses)).collect())
        }
        Kind::Relation(first, others) => {
            let lefts = std::iter::once(first.as_ref()).chain(others.iter().map(|(_, right)| right));
            let attained =
                lefts.zip(others).filter(|(_, (relation, _))| matches!(relation, Relation::AtMost | Relation::AtLeast));
            let equal = |(left, (_, right)): (&Node, &(Relation, Node))| {
                like(Kind::Relation(Box::new(left.clone()), vec![(Relation::Equal, right.clone())]))
            };
            some(attained.map(equal).collect())
        }
        _ => None,
    }
}
