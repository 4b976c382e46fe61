//! Conditions that are linear in the states, from texts.

use crate::system::{Condition, Side};
use arithmetic::Rational;
use expressions::{Node, NodeKind, Problem, Relation, parse_property};
use num_traits::Zero;

/// A problem at a byte of the text.
type Located = (usize, Problem);

/// `row x + constant`.
struct Affine {
    row: Vec<Rational>,
    constant: Rational,
}

impl Affine {
    fn constant(states: usize, constant: Rational) -> Self {
        Affine { row: vec![Rational::ZERO; states], constant }
    }

    fn is_constant(&self) -> bool {
        self.row.iter().all(Zero::is_zero)
    }

    fn scaled(self, factor: &Rational) -> Self {
        Affine { row: self.row.iter().map(|x| x * factor).collect(), constant: self.constant * factor }
    }

    fn plus(self, other: Self) -> Self {
        let row = self.row.iter().zip(&other.row).map(|(x, y)| x + y).collect();
        Affine { row, constant: self.constant + other.constant }
    }
}

/// Reads a conjunction of linear inequalities.
pub(crate) fn read(text: &str, states: &[String]) -> Result<Vec<Condition>, Located> {
    let mut conditions = Vec::new();
    collect(&parse_property(text)?, states, &mut conditions)?;
    Ok(conditions)
}

fn refuse<T>(node: &Node, expected: &str, found: &str) -> Result<T, Located> {
    Err((node.at, Problem::expected(expected, found)))
}

const INEQUALITY: &str = "inequalities between states, joined by `and`";

fn collect(node: &Node, states: &[String], into: &mut Vec<Condition>) -> Result<(), Located> {
    match &node.kind {
        NodeKind::And(parts) => parts.iter().try_for_each(|part| collect(part, states, into)),
        NodeKind::Relation(first, rest) => {
            let mut left = affine(first, states)?;
            for (relation, node) in rest {
                let right = affine(node, states)?;
                into.push(condition(&left, *relation, &right, node)?);
                left = right;
            }
            Ok(())
        }
        NodeKind::Or(_) => refuse(node, INEQUALITY, "`or`"),
        NodeKind::Not(_) => refuse(node, INEQUALITY, "`not`"),
        NodeKind::Implies(..) => refuse(node, INEQUALITY, "`implies`"),
        NodeKind::Always(..) | NodeKind::Until(..) => refuse(node, INEQUALITY, "an operator of time"),
        _ => refuse(node, INEQUALITY, "a number"),
    }
}

/// The states on the left, numbers on the right.
fn condition(left: &Affine, relation: Relation, right: &Affine, at: &Node) -> Result<Condition, Located> {
    let (side, strict) = match relation {
        Relation::AtLeast => (Side::AtLeast, false),
        Relation::Greater => (Side::AtLeast, true),
        Relation::AtMost => (Side::AtMost, false),
        Relation::Less => (Side::AtMost, true),
        Relation::Equal => return refuse(at, "`<`, `<=`, `>` or `>=`", "`=`"),
        Relation::Different => return refuse(at, "`<`, `<=`, `>` or `>=`", "`!=`"),
    };
    // A number on the left and states on the right read the other way round.
    let (left, right, side) = match (left.is_constant(), right.is_constant()) {
        (true, true) => return refuse(at, "a state on one side", "numbers on both"),
        (true, false) => (right, left, if side == Side::AtLeast { Side::AtMost } else { Side::AtLeast }),
        _ => (left, right, side),
    };
    let row = left.row.iter().zip(&right.row).map(|(x, y)| x - y).collect();
    Ok(Condition { row, constant: left.constant.clone(), side, strict, bound: right.constant.clone() })
}

fn affine(node: &Node, states: &[String]) -> Result<Affine, Located> {
    match &node.kind {
        NodeKind::Number(q) => Ok(Affine::constant(states.len(), q.clone())),
        NodeKind::Name { name, called: false, .. } => match states.iter().position(|state| state == name) {
            Some(i) => {
                let mut form = Affine::constant(states.len(), Rational::ZERO);
                form.row[i] = Rational::ONE;
                Ok(form)
            }
            None => Err((node.at, Problem::unknown("state", name, states.iter().map(String::as_str)))),
        },
        NodeKind::Negated(inner) => Ok(affine(inner, states)?.scaled(&-Rational::ONE)),
        NodeKind::Sum(terms) => {
            terms.iter().try_fold(Affine::constant(states.len(), Rational::ZERO), |sum, (minus, term)| {
                let sign = if *minus { -Rational::ONE } else { Rational::ONE };
                Ok(sum.plus(affine(term, states)?.scaled(&sign)))
            })
        }
        NodeKind::Product(factors) => {
            factors.iter().try_fold(Affine::constant(states.len(), Rational::ONE), |product, (divides, factor)| {
                times(product, affine(factor, states)?, *divides, factor)
            })
        }
        _ => refuse(node, "something linear in the states", "another expression"),
    }
}

fn times(product: Affine, factor: Affine, divides: bool, node: &Node) -> Result<Affine, Located> {
    match (product.is_constant(), factor.is_constant(), divides) {
        (_, true, true) if factor.constant.is_zero() => refuse(node, "a divisor other than 0", "0"),
        (_, true, true) => Ok(product.scaled(&factor.constant.recip())),
        (_, true, false) => Ok(product.scaled(&factor.constant)),
        (true, false, false) => Ok(factor.scaled(&product.constant)),
        _ => refuse(node, "something linear in the states", "a product or quotient of states"),
    }
}
