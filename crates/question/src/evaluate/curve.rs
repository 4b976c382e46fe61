//! Comparisons on a piece of time as functions of one number: so a value that is touched and not passed is decided.

use super::Evaluator;
use super::time::{Operator, moving_names};
use crate::names::OWN;
use crate::syntax::{Kind, Node, Relation};
use crate::timeline::{Curve, Piece};
use crate::truth::Truth;
use arithmetic::{Cancelled, Field, Interval, Number as _, RealNumber as Number, Ring, rational};
use num_traits::{Signed, ToPrimitive};
use polynomials::decide::{Decision, Effort, decide};
use polynomials::{Compared, Function, Literal, Symbolic};

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
        const EFFORT: Effort = Effort { boxes: 200, squares: false, certified: false };
        // Functions are simplified, and then say nothing about where they have no value: what has an enclosure on the whole piece has values there.
        if self.enclosed.number(left).is_err() || self.enclosed.number(right).is_err() {
            return Ok(false);
        }
        let Some((a, b)) = self.term(left).zip(self.term(right)) else { return Ok(false) };
        let (function, compared) = match relation {
            Relation::Less => (b - a, Compared::Positive),
            Relation::AtMost => (b - a, Compared::NotNegative),
            Relation::Greater => (a - b, Compared::Positive),
            Relation::AtLeast => (a - b, Compared::NotNegative),
            Relation::Equal => (a - b, Compared::Zero),
            Relation::Different => (a - b, Compared::NotZero),
        };
        let range = [self.curve.range().clone()];
        // Where it has an enclosure on the whole range, it has a value at every point of it.
        let whole = |lo, hi| Interval::hull_of_rationals(lo, hi, self.evaluator.precision);
        let ends = range[0].lo.as_ref().zip(range[0].hi.as_ref());
        let guarded = ends.is_some_and(|(lo, hi)| function.value(&[whole(lo, hi)]).is_ok());
        let literal = Literal { function, compared, guarded };
        Ok(matches!(decide(&[literal], &range, EFFORT, self.evaluator.case.progress())?, Decision::Holds(_)))
    }

    fn term(&self, node: &Node) -> Option<Symbolic> {
        if moving_names(self.evaluator, node).is_empty() {
            return match self.evaluator.number(node).ok()? {
                Number::Exact(q) => self.curve.number(&q),
                _ => None,
            };
        }
        match &node.kind {
            Kind::Negated(body) => Some(-self.term(body)?),
            Kind::Sum(terms) => terms.iter().try_fold(self.curve.number(&rational(0, 1))?, |sum, (minus, node)| {
                let term = self.term(node)?;
                Some(if *minus { sum - term } else { sum + term })
            }),
            Kind::Product(factors) => {
                factors.iter().try_fold(self.curve.number(&rational(1, 1))?, |product, (divides, node)| {
                    let factor = self.term(node)?;
                    if *divides { product.over(&factor).ok() } else { Some(product * factor) }
                })
            }
            Kind::Power(base, exponent) => match &exponent.kind {
                Kind::Number(q) if q.is_integer() && !q.is_negative() => {
                    Some(self.term(base)?.power(q.to_integer().to_u64().filter(|power| *power <= 16)?))
                }
                _ => None,
            },
            Kind::Name { name, arguments, .. } => self.named(name, arguments),
            _ => None,
        }
    }

    /// A moving quantity, or a function of one.
    fn named(&self, name: &str, arguments: &[Node]) -> Option<Symbolic> {
        let first = |fold: &dyn Fn(Symbolic, Symbolic) -> Symbolic| {
            arguments.iter().map(|node| self.term(node)).reduce(|a, b| Some(fold(a?, b?))).flatten()
        };
        match (name, arguments) {
            ("abs", [body]) => return Some(self.term(body)?.size()),
            ("sqrt", [body]) => return self.term(body)?.sqrt().ok(),
            ("min" | "max", [_, _, ..]) => return first(&|a, b| a.extreme(&b, name == "max")),
            _ => {}
        }
        let quantity = self.evaluator.case.quantity(None, name).ok().filter(|quantity| quantity.moves)?;
        if std::ptr::eq(quantity, &OWN) {
            return self.curve.own(name);
        }
        let numbers = arguments.iter().map(|node| self.evaluator.number(node).ok()).collect::<Option<Vec<_>>>()?;
        self.curve.measure(quantity, &numbers)
    }
}
