//! Functions of numbers and vectors.

use super::{Compiler, Made, Scope, Value};
use crate::function::Function;
use crate::problem::Problem;
use crate::program::{Id, Op};
use crate::syntax::Node;

impl Compiler<'_> {
    pub(super) fn function(&mut self, name: &str, arguments: &[Node], scope: &Scope) -> Made<Value> {
        match name {
            "pi" => return Ok(Value::Number(self.things.add(Op::Pi))),
            "t" => return Ok(Value::Number(self.things.add(Op::Time))),
            "agents" if self.of_any => return Ok(Value::Number(self.things.add(Op::Agents))),
            "agents" => return Ok(Value::Number(self.things.integer(self.agents as i64))),
            "if" => return self.choice(arguments, scope),
            "dot" | "cross" | "norm" | "norm2" | "unit" | "turn" | "heading" => {
                return self.function_of_vectors(name, arguments, scope);
            }
            _ => {}
        }
        let first = self.value(&arguments[0], scope)?;
        if let (Value::Angle(id), "abs") = (&first, name) {
            return Ok(Value::Number(self.turned_least(*id)));
        }
        let (Value::Number(first) | Value::Angle(first)) = first else {
            return self.refuse(arguments[0].at, Problem::expected("a number", first.words()));
        };
        let function = match name {
            "sqrt" => Function::Root,
            "exp" => Function::Exponential,
            "log" => Function::Logarithm,
            "sin" => Function::Sine,
            "cos" => Function::Cosine,
            "abs" => return Ok(Value::Number(self.things.add(Op::Absolute(first)))),
            _ => {
                let mut best = first;
                for node in &arguments[1..] {
                    let other = self.number(node, scope)?;
                    best =
                        self.things.add(if name == "max" { Op::Larger(best, other) } else { Op::Smaller(best, other) });
                }
                return Ok(Value::Number(best));
            }
        };
        Ok(Value::Number(self.things.add(Op::Function(function, first))))
    }

    /// The size of an angle on the circle, from 0 to pi.
    pub(super) fn turned_least(&mut self, angle: Id) -> Id {
        let things = &mut self.things;
        let (sine, cosine) =
            (things.add(Op::Function(Function::Sine, angle)), things.add(Op::Function(Function::Cosine, angle)));
        let turned = things.add(Op::Angle(sine, cosine));
        things.add(Op::Absolute(turned))
    }

    pub(super) fn choice(&mut self, arguments: &[Node], scope: &Scope) -> Made<Value> {
        let condition = self.condition(&arguments[0], scope)?;
        let (a, b) = (self.value(&arguments[1], scope)?, self.value(&arguments[2], scope)?);
        let things = &mut self.things;
        let mut join = |a, b| things.add(Op::Choice(condition, a, b));
        match (a, b) {
            (Value::Vector(a), Value::Vector(b)) => {
                Ok(Value::Vector(a.into_iter().zip(b).map(|(a, b)| join(a, b)).collect()))
            }
            (Value::Angle(a), Value::Angle(b)) => Ok(Value::Angle(join(a, b))),
            (Value::Number(a) | Value::Angle(a), Value::Number(b) | Value::Angle(b)) => Ok(Value::Number(join(a, b))),
            (first @ Value::Truth(_), _) => {
                self.refuse(arguments[1].at, Problem::expected("a number, an angle or a vector", first.words()))
            }
            (first, second) => self.refuse(arguments[2].at, Problem::expected(first.words(), second.words())),
        }
    }

    pub(super) fn dot(&mut self, a: &[Id], b: &[Id]) -> Id {
        let things = &mut self.things;
        let products: Vec<Id> = a.iter().zip(b).map(|(a, b)| things.add(Op::Product(*a, *b))).collect();
        products.into_iter().reduce(|a, b| things.add(Op::Sum(a, b))).unwrap_or_else(|| things.integer(0))
    }

    /// `a_k b_l - a_l b_k`.
    pub(super) fn minor(&mut self, a: &[Id], b: &[Id], (k, l): (usize, usize)) -> Id {
        let things = &mut self.things;
        let (first, second) = (things.add(Op::Product(a[k], b[l])), things.add(Op::Product(a[l], b[k])));
        things.add(Op::Difference(first, second))
    }

    pub(super) fn function_of_vectors(&mut self, name: &str, arguments: &[Node], scope: &Scope) -> Made<Value> {
        let first = self.vector(&arguments[0], scope)?;
        let flat = |this: &Self| match first.len() {
            2 => Ok(()),
            _ => this
                .refuse(arguments[0].at, Problem::expected(format!("a vector of the plane, for `{name}`,"), "another")),
        };
        Ok(match name {
            "dot" => {
                let second = self.vector(&arguments[1], scope)?;
                Value::Number(self.dot(&first, &second))
            }
            "cross" => {
                let second = self.vector(&arguments[1], scope)?;
                match first.len() {
                    3 => Value::Vector([(1, 2), (2, 0), (0, 1)].map(|pair| self.minor(&first, &second, pair)).to_vec()),
                    _ => {
                        flat(self)?;
                        Value::Number(self.minor(&first, &second, (0, 1)))
                    }
                }
            }
            "norm2" => Value::Number(self.dot(&first, &first)),
            "norm" => Value::Number(self.norm(&first)),
            "unit" => {
                let norm = self.norm(&first);
                let numbers = first.iter().map(|id| self.things.add(Op::Quotient(*id, norm))).collect();
                self.as_vector(numbers)
            }
            "turn" => {
                flat(self)?;
                let angle = self.number(&arguments[1], scope)?;
                let sine = self.things.add(Op::Function(Function::Sine, angle));
                let cosine = self.things.add(Op::Function(Function::Cosine, angle));
                let back = self.things.add(Op::Negated(sine));
                Value::Vector(vec![self.dot(&[cosine, back], &first), self.dot(&[sine, cosine], &first)])
            }
            _ => {
                flat(self)?;
                Value::Angle(self.things.add(Op::Angle(first[1], first[0])))
            }
        })
    }

    /// In one dimension the absolute value.
    pub(super) fn norm(&mut self, vector: &[Id]) -> Id {
        if let [one] = vector {
            return self.things.add(Op::Absolute(*one));
        }
        let square = self.dot(vector, vector);
        self.things.add(Op::Function(Function::Root, square))
    }
}

/// A number of arguments in words.
pub(super) fn words_for(arguments: usize) -> String {
    match arguments {
        0 => "no arguments".to_string(),
        1 => "one argument".to_string(),
        n => format!("{n} arguments"),
    }
}
