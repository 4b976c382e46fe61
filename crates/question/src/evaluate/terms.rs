//! Expressions of what is measured as functions of the numbers that it depends on.

use super::Evaluator;
use super::time::moving_names;
use crate::names::{OWN, Quantity};
use crate::syntax::{Kind, Node, Relation};
use crate::timeline::Formulas;
use arithmetic::{Field, Number as _, RealNumber as Number, Ring, rational};
use num_traits::{Signed, ToPrimitive};
use polynomials::{Compared, Symbolic};
use scenario::Amount;

/// What is measured, as functions.
pub(super) struct Terms<'a, 'c, 'q, F: ?Sized> {
    pub evaluator: &'a Evaluator<'c, 'q>,
    pub formulas: &'a F,
    /// Whether it is time 0, at which what something was initially is what it is.
    pub at_start: bool,
}

/// A comparison as one of a function with 0.
pub(super) fn difference(a: Symbolic, relation: Relation, b: Symbolic) -> (Symbolic, Compared) {
    match relation {
        Relation::Less => (b - a, Compared::Positive),
        Relation::AtMost => (b - a, Compared::NotNegative),
        Relation::Greater => (a - b, Compared::Positive),
        Relation::AtLeast => (a - b, Compared::NotNegative),
        Relation::Equal => (a - b, Compared::Zero),
        Relation::Different => (a - b, Compared::NotZero),
    }
}

impl<F: Formulas + ?Sized> Terms<'_, '_, '_, F> {
    pub fn term(&self, node: &Node) -> Option<Symbolic> {
        if moving_names(self.evaluator, node).is_empty() {
            return match self.evaluator.number(node).ok()? {
                Number::Exact(q) => self.formulas.number(&q),
                _ => None,
            };
        }
        match &node.kind {
            Kind::Negated(body) => Some(-self.term(body)?),
            Kind::Sum(terms) => terms.iter().try_fold(self.formulas.number(&rational(0, 1))?, |sum, (minus, node)| {
                let term = self.term(node)?;
                Some(if *minus { sum - term } else { sum + term })
            }),
            Kind::Product(factors) => {
                factors.iter().try_fold(self.formulas.number(&rational(1, 1))?, |product, (divides, node)| {
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
            ("initial", [body]) => return self.at_start.then(|| self.term(body)).flatten(),
            ("abs", [body]) => return Some(self.term(body)?.size()),
            ("sqrt", [body]) => return self.term(body)?.sqrt().ok(),
            ("min" | "max", [_, _, ..]) => return first(&|a, b| a.extreme(&b, name == "max")),
            _ => {}
        }
        match self.amount(name, arguments)? {
            Amount::Number(x) => Some(x),
            Amount::Root(x) => x.sqrt().ok(),
            Amount::Count(Some([least, most])) if least == most => {
                self.formulas.number(&rational(i64::try_from(least).ok()?, 1))
            }
            Amount::Count(_) | Amount::List(_) | Amount::Unknown(_) => None,
        }
    }

    /// What is measured under this name.
    pub fn amount(&self, name: &str, arguments: &[Node]) -> Option<Amount<Symbolic>> {
        let quantity = self.quantity(name)?;
        if std::ptr::eq(quantity, &OWN) {
            return self.formulas.own(name).map(Amount::Number);
        }
        let numbers = arguments.iter().map(|node| self.evaluator.number(node).ok()).collect::<Option<Vec<_>>>()?;
        self.formulas.amount(quantity, &numbers)
    }

    fn quantity(&self, name: &str) -> Option<&'static Quantity> {
        self.evaluator.case.quantity(None, name).ok().filter(|quantity| quantity.moves)
    }
}
