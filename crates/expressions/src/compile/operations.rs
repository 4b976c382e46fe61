//! Operators and conditions.

use super::{Compiler, Made, Scope, Value};
use crate::function::Function;
use crate::law::Kind;
use crate::problem::Problem;
use crate::program::{Id, Op, Things};
use crate::syntax::{Node, NodeKind, Relation};
use arithmetic::{Rational, rational};
use num_traits::ToPrimitive;

/// Roots of roots: powers of an eighth.
const MOST_ROOTS: u32 = 3;

impl Compiler<'_> {
    /// A number for each number of a value.
    pub(super) fn each(&mut self, node: &Node, value: Value, f: impl Fn(&mut Things, Id) -> Id) -> Made<Value> {
        Ok(match value {
            Value::Number(id) => Value::Number(f(&mut self.things, id)),
            Value::Angle(id) => Value::Angle(f(&mut self.things, id)),
            Value::Vector(ids) => Value::Vector(ids.into_iter().map(|id| f(&mut self.things, id)).collect()),
            Value::Truth(_) => return self.refuse(node.at, Problem::expected("a number or a vector", value.words())),
        })
    }

    /// Whether it is a coordinate of a place, or a sum or a difference of such.
    fn is_length(&self, id: Id) -> bool {
        match &self.things.ops[id] {
            Op::State { start, .. } => {
                let is_place = |name: &String| self.text.position.as_ref() == Some(name);
                self.variables.iter().any(|own| own.start == *start && own.kind == Kind::Vector && is_place(&own.name))
            }
            Op::Negated(a) => self.is_length(*a),
            Op::Sum(a, b) | Op::Difference(a, b) => self.is_length(*a) || self.is_length(*b),
            _ => false,
        }
    }

    pub(super) fn added(&mut self, a: Value, b: Value, minus: bool, node: &Node) -> Made<Value> {
        if let (Value::Number(length), Value::Angle(_)) | (Value::Angle(_), Value::Number(length)) = (&a, &b)
            && self.is_length(*length)
        {
            return self.refuse(node.at, Problem::Other("an angle and a length are not added".to_string()));
        }
        let things = &mut self.things;
        let mut join = |a, b| things.add(if minus { Op::Difference(a, b) } else { Op::Sum(a, b) });
        match (a, b) {
            (Value::Number(a), Value::Number(b)) => Ok(Value::Number(join(a, b))),
            (Value::Number(a) | Value::Angle(a), Value::Angle(b)) | (Value::Angle(a), Value::Number(b)) => {
                Ok(Value::Angle(join(a, b)))
            }
            (Value::Vector(a), Value::Vector(b)) => {
                Ok(Value::Vector(a.into_iter().zip(b).map(|(a, b)| join(a, b)).collect()))
            }
            (first, second) => self.refuse(node.at, Problem::expected(first.words(), second.words())),
        }
    }

    pub(super) fn multiplied(&mut self, a: Value, b: Value, divides: bool, node: &Node) -> Made<Value> {
        let things = &mut self.things;
        let mut join = |a, b| things.add(if divides { Op::Quotient(a, b) } else { Op::Product(a, b) });
        match (a, b) {
            (Value::Number(a) | Value::Angle(a), Value::Number(b) | Value::Angle(b)) => Ok(Value::Number(join(a, b))),
            (Value::Vector(a), Value::Number(b) | Value::Angle(b)) => {
                Ok(Value::Vector(a.into_iter().map(|a| join(a, b)).collect()))
            }
            (Value::Number(a) | Value::Angle(a), Value::Vector(b)) if !divides => {
                Ok(Value::Vector(b.into_iter().map(|b| join(a, b)).collect()))
            }
            (Value::Vector(_), Value::Vector(_)) if !divides => {
                let why = "the product of two vectors: `dot(a, b)` is a number, `cross(a, b)` their vector product";
                self.refuse(node.at, Problem::Other(why.to_string()))
            }
            (_, other) => self.refuse(node.at, Problem::expected("a number", other.words())),
        }
    }

    /// Products, and roots where the exponent is a number of halves, quarters or eighths; by exponential and logarithm elsewhere.
    pub(super) fn power(&mut self, base: Id, exponent: Id) -> Id {
        let things = &mut self.things;
        let constant = if let Op::Number(q) = &things.ops[exponent] { Some(q.clone()) } else { None };
        let as_roots = |q: &Rational| {
            let whole = |roots: &u32| (q * rational(1 << roots, 1)).is_integer();
            let roots = (0..=MOST_ROOTS).find(whole)?;
            let times = (q * rational(1 << roots, 1)).to_integer().to_i64()?;
            (times.unsigned_abs() <= 128).then_some((roots, times))
        };
        let Some((roots, times)) = constant.as_ref().and_then(as_roots) else {
            let logarithm = things.add(Op::Function(Function::LogarithmOfBase, base));
            let product = things.add(Op::Product(exponent, logarithm));
            return things.add(Op::Function(Function::Exponential, product));
        };
        let root = (0..roots).fold(base, |base, _| things.add(Op::Function(Function::Root, base)));
        let size = u32::try_from(times.unsigned_abs()).unwrap_or_default();
        let one = things.integer(1);
        let power = if size == 0 { one } else { things.add(Op::Power(root, size)) };
        if times < 0 { things.add(Op::Quotient(one, power)) } else { power }
    }

    pub(super) fn condition(&mut self, node: &Node, scope: &Scope) -> Made<Id> {
        match &node.kind {
            NodeKind::Relation(first, others) => {
                let mut left = self.number(first, scope)?;
                let mut all = Vec::new();
                for (relation, node) in others {
                    let right = self.number(node, scope)?;
                    all.push(self.things.add(Op::Compared(*relation, left, right)));
                    left = right;
                }
                Ok(self.all_of(all))
            }
            NodeKind::Not(body) => {
                let body = self.condition(body, scope)?;
                Ok(self.things.add(Op::Not(body)))
            }
            NodeKind::And(nodes) => {
                let all = nodes.iter().map(|node| self.condition(node, scope)).collect::<Made<Vec<_>>>()?;
                Ok(self.all_of(all))
            }
            NodeKind::Or(nodes) => {
                let all = nodes.iter().map(|node| self.condition(node, scope)).collect::<Made<Vec<_>>>()?;
                Ok(self.one_of(all))
            }
            NodeKind::Implies(first, second) => {
                let (first, second) = (self.condition(first, scope)?, self.condition(second, scope)?);
                let first = self.things.add(Op::Not(first));
                Ok(self.one_of(vec![first, second]))
            }
            NodeKind::Name { .. } => match self.value(node, scope)? {
                Value::Truth(id) => Ok(id),
                other => self.refuse(node.at, Problem::expected("something true or false", other.words())),
            },
            _ => {
                let value = self.value(node, scope)?;
                self.refuse(node.at, Problem::expected("something true or false", value.words()))
            }
        }
    }

    pub(super) fn all_of(&mut self, conditions: Vec<Id>) -> Id {
        let things = &mut self.things;
        conditions.into_iter().reduce(|a, b| things.add(Op::Both(a, b))).unwrap_or_else(|| {
            let zero = things.integer(0);
            things.add(Op::Compared(Relation::Equal, zero, zero))
        })
    }

    /// Not all of them false.
    pub(super) fn one_of(&mut self, conditions: Vec<Id>) -> Id {
        let all = conditions.into_iter().map(|id| self.things.add(Op::Not(id))).collect();
        let none = self.all_of(all);
        self.things.add(Op::Not(none))
    }
}
