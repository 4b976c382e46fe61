//! Comparisons on a piece of time as functions of one number: so a value that is touched and not passed is decided.

use super::Evaluator;
use super::terms::{Terms, difference};
use super::time::Operator;
use crate::syntax::{Kind, Node, Relation};
use crate::timeline::{Curve, Piece};
use crate::truth::Truth;
use arithmetic::{Cancelled, Interval};
use polynomials::decide::{Decision, Effort, decide};
use polynomials::{Function, Literal};

/// A piece of time on which what is measured is known as functions of one number.
struct OnPiece<'a, 'c, 'q> {
    evaluator: &'a Evaluator<'c, 'q>,
    /// The same with enclosures over the whole piece.
    enclosed: &'a Evaluator<'c, 'q>,
    curve: &'a dyn Curve,
}

impl Operator<'_, '_, '_> {
    /// What is known of the body at all times of a piece: a truth that was not found by enclosures, where comparisons decide it as functions of one number.
    pub fn settled(&self, piece: &Piece, truth: Truth) -> Result<Truth, Cancelled> {
        if !matches!(truth, Truth::Unknown(_)) {
            return Ok(truth);
        }
        let Some(curve) = self.timeline.curve(piece, self.evaluator.precision) else { return Ok(truth) };
        let Ok(moment) = self.timeline.moment(piece) else { return Ok(truth) };
        let enclosed = Evaluator { moment: Some(moment.as_ref()), piece: Some(piece), ..*self.evaluator };
        let on = OnPiece { evaluator: self.evaluator, enclosed: &enclosed, curve: curve.as_ref() };
        for wanted in [true, false] {
            if on.holds(self.body, wanted)? {
                return Ok(Truth::of(wanted != self.negated));
            }
        }
        Ok(truth)
    }
}

impl OnPiece<'_, '_, '_> {
    /// Whether a property, or its negation, is proved for all times of the piece.
    fn holds(&self, node: &Node, wanted: bool) -> Result<bool, Cancelled> {
        let together = |list: &mut dyn Iterator<Item = (&Node, bool)>, all: bool| {
            for (node, wanted) in list {
                if self.holds(node, wanted)? != all {
                    return Ok(!all);
                }
            }
            Ok(all)
        };
        match &node.kind {
            Kind::Not(body) => self.holds(body, !wanted),
            Kind::And(list) => together(&mut list.iter().map(|node| (node, wanted)), wanted),
            Kind::Or(list) => together(&mut list.iter().map(|node| (node, wanted)), !wanted),
            Kind::Implies(a, b) => together(&mut [(a.as_ref(), !wanted), (b.as_ref(), wanted)].into_iter(), !wanted),
            Kind::Relation(first, others) => self.chain(first, others, wanted),
            _ => Ok(false),
        }
    }

    fn chain(&self, first: &Node, others: &[(Relation, Node)], wanted: bool) -> Result<bool, Cancelled> {
        let mut left = first;
        for (relation, right) in others {
            let relation = if wanted { *relation } else { relation.turned() };
            if self.link(left, relation, right)? != wanted {
                return Ok(!wanted);
            }
            left = right;
        }
        Ok(wanted)
    }

    /// One comparison at all times of the piece, where both sides have values.
    fn link(&self, left: &Node, relation: Relation, right: &Node) -> Result<bool, Cancelled> {
        const EFFORT: Effort = Effort { boxes: 200, squares: false, certified: false, conditions: false };
        // Functions are simplified, and then say nothing about where they have no value: what has an enclosure on the whole piece has values there.
        if self.enclosed.number(left).is_err() || self.enclosed.number(right).is_err() {
            return Ok(false);
        }
        let terms = Terms { evaluator: self.evaluator, formulas: self.curve, at_start: false };
        let Some((a, b)) = terms.term(left).zip(terms.term(right)) else { return Ok(false) };
        let (function, compared) = difference(a, relation, b);
        let range = [self.curve.range().clone()];
        // Where it has an enclosure on the whole range, it has a value at every point of it.
        let whole = |lo, hi| Interval::hull_of_rationals(lo, hi, self.evaluator.precision);
        let ends = range[0].lo.as_ref().zip(range[0].hi.as_ref());
        let guarded = ends.is_some_and(|(lo, hi)| function.value(&[whole(lo, hi)]).is_ok());
        let literal = Literal { function, compared, guarded };
        Ok(matches!(decide(&[literal], &range, EFFORT, self.evaluator.case.progress())?, Decision::Holds(_)))
    }
}
