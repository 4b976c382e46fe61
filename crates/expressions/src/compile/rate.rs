//! `rate(e)`: how fast an expression changes along the law, or by how much over a step of discrete time, as expressions of the state: what is computed for
//! `e` is differentiated thing by thing, and the numbers of the state change as the law says.

use super::{Compiler, Made, Scope, Value};
use crate::function::Function;
use crate::law::Time;
use crate::problem::Problem;
use crate::program::{FLOCK, Gather, Id, Of, Op};
use crate::syntax::{Node, Relation};

impl<'a> Compiler<'a> {
    /// The value of `rate(e)`.
    pub(super) fn rate(&mut self, node: &Node, arguments: &[Node], scope: &Scope) -> Made<Value> {
        if self.reading.iter().any(|(table, _)| *table == "rates") {
            let why = "a law cannot ask for rates; `rate` is for observables and properties".to_string();
            return self.refuse(node.at, Problem::Other(why));
        }
        Ok(match self.value(&arguments[0], scope)? {
            Value::Number(id) | Value::Angle(id) => Value::Number(self.changed(node, id)?),
            Value::Vector(ids) => {
                Value::Vector(ids.into_iter().map(|id| self.changed(node, id)).collect::<Made<Vec<_>>>()?)
            }
            other => return self.refuse(arguments[0].at, Problem::expected("a number or a vector", other.words())),
        })
    }

    fn changed(&mut self, node: &Node, root: Id) -> Made<Id> {
        let discrete = self.text.time == Time::Discrete;
        // What a thing needs has a smaller number.
        for id in self.things.wanted(&[root]) {
            if !self.changes.contains_key(&id) {
                let change = if discrete { self.next(node, id)? } else { self.derivative(node, id)? };
                self.changes.insert(id, change);
            }
        }
        let change = self.changes[&root];
        Ok(if discrete { self.things.add(Op::Difference(change, root)) } else { change })
    }

    /// The rate, or next value, of a number of the state.
    fn of_state(&mut self, start: usize, component: usize, of: Of) -> Made<Id> {
        let variable = self.variables.iter().position(|variable| variable.start == start).unwrap_or_default();
        if let Some(known) = self.rates_of.get(&(variable, of)) {
            return Ok(known[component]);
        }
        let text = self.text;
        let name = &self.variables[variable].name;
        let Some((key, rate)) = text.rates.iter().find(|(known, _)| known == name) else {
            let problem = format!("the rate of `{name}` is missing");
            return self.refuse_entry("rates", "", Problem::Other(problem));
        };
        self.reading.push(("rates", key));
        let node = self.parse(rate)?;
        let innermost = if let Of::Slot(slot) = of { slot } else { FLOCK };
        let scope = Scope { own: Some(of), innermost, hears: Some(of), agents: vec![("i".to_string(), of)] };
        let numbers = match self.value(&node, &scope)? {
            Value::Vector(ids) => ids,
            Value::Number(id) | Value::Angle(id) => vec![id],
            other => return self.refuse(node.at, Problem::expected("a number", other.words())),
        };
        self.reading.pop();
        let wanted = numbers[component];
        self.rates_of.insert((variable, of), numbers);
        Ok(wanted)
    }

    /// A number that has no value.
    fn missing(&mut self) -> Id {
        let (one, zero) = (self.things.integer(1), self.things.integer(0));
        self.things.add(Op::Quotient(one, zero))
    }

    /// The derivative of a number; of a condition, whether it stays as it is while the state moves a little.
    fn derivative(&mut self, node: &Node, id: Id) -> Made<Id> {
        let op = self.things.ops[id].clone();
        let of = |this: &Self, id: &Id| this.changes[id];
        let zero = self.things.integer(0);
        Ok(match &op {
            Op::Number(_) | Op::Pi | Op::Agents | Op::Parameter(..) => zero,
            Op::Time => self.things.integer(1),
            Op::State { start, .. } if self.is_open(*start) => zero,
            Op::State { start, component, of, .. } => self.of_state(*start, *component, *of)?,
            Op::Negated(a) => self.negated(of(self, a)),
            Op::Sum(a, b) => self.things.add(Op::Sum(of(self, a), of(self, b))),
            Op::Difference(a, b) => self.minus(of(self, a), of(self, b)),
            Op::Product(a, b) => {
                let (first, second) = (self.times(of(self, a), *b), self.times(*a, of(self, b)));
                self.things.add(Op::Sum(first, second))
            }
            Op::Quotient(a, b) => {
                let back = self.times(id, of(self, b));
                let top = self.minus(of(self, a), back);
                self.over(top, *b)
            }
            Op::Power(a, exponent) => {
                let factor = self.things.integer(i64::from(*exponent));
                let power = self.things.add(Op::Power(*a, exponent.saturating_sub(1)));
                let slope = self.times(factor, power);
                self.times(slope, of(self, a))
            }
            Op::Function(function, a) => {
                let inner = of(self, a);
                self.slope(*function, id, *a, inner)
            }
            Op::Angle(y, x) => {
                let (first, second) = (self.times(*x, of(self, y)), self.times(*y, of(self, x)));
                let top = self.minus(first, second);
                let square = self.dot(&[*x, *y], &[*x, *y]);
                self.over(top, square)
            }
            Op::Absolute(a) => {
                let (change, minus) = (of(self, a), self.negated(of(self, a)));
                self.chosen_by_sign(*a, zero, change, minus)
            }
            Op::Larger(a, b) => self.chosen_by_sign(*a, *b, of(self, a), of(self, b)),
            Op::Smaller(a, b) => self.chosen_by_sign(*a, *b, of(self, b), of(self, a)),
            Op::Choice(c, a, b) => {
                let change = self.things.add(Op::Choice(*c, of(self, a), of(self, b)));
                self.where_steady(of(self, c), change)
            }
            Op::Compared(_, a, b) => self.things.add(Op::Compared(Relation::Different, *a, *b)),
            Op::Both(a, b) => self.things.add(Op::Both(of(self, a), of(self, b))),
            Op::Not(a) => of(self, a),
            Op::Gathered(number, place) => {
                let this = self.things.loops[*number].clone();
                let (gather, body) = this.bodies[*place];
                let change = match gather {
                    Gather::Count => zero,
                    Gather::Sum | Gather::Mean => {
                        let body = of(self, &body);
                        self.things.gather(this.slot, this.condition, gather, body)
                    }
                    Gather::Largest | Gather::Smallest => {
                        let why = "the largest or smallest value over agents has no rate where two agree";
                        return self.refuse(node.at, Problem::Other(why.to_string()));
                    }
                };
                match this.condition {
                    None => change,
                    // Nobody is about to come or to go.
                    Some(condition) => {
                        let steady = self.where_steady(of(self, &condition), zero);
                        let guard = self.things.gather(this.slot, None, Gather::Sum, steady);
                        self.things.add(Op::Sum(change, guard))
                    }
                }
            }
        })
    }

    fn slope(&mut self, function: Function, id: Id, argument: Id, inner: Id) -> Id {
        match function {
            Function::Root => {
                let two = self.things.integer(2);
                let twice = self.times(two, id);
                self.over(inner, twice)
            }
            Function::Exponential => self.times(id, inner),
            Function::Logarithm | Function::LogarithmOfBase => self.over(inner, argument),
            Function::Sine => {
                let cosine = self.things.add(Op::Function(Function::Cosine, argument));
                self.times(cosine, inner)
            }
            Function::Cosine => {
                let sine = self.things.add(Op::Function(Function::Sine, argument));
                let product = self.times(sine, inner);
                self.negated(product)
            }
        }
    }

    /// The first where `a > b`, the second where `a < b`; nothing where they are equal.
    fn chosen_by_sign(&mut self, a: Id, b: Id, first: Id, second: Id) -> Id {
        let above = self.things.add(Op::Compared(Relation::Greater, a, b));
        let apart = self.things.add(Op::Compared(Relation::Different, a, b));
        let change = self.things.add(Op::Choice(above, first, second));
        self.where_steady(apart, change)
    }

    fn where_steady(&mut self, steady: Id, change: Id) -> Id {
        let missing = self.missing();
        self.things.add(Op::Choice(steady, change, missing))
    }

    fn is_zero(&self, id: Id) -> bool {
        matches!(&self.things.ops[id], Op::Number(q) if *q == arithmetic::rational(0, 1))
    }

    fn times(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(a) || self.is_zero(b) { self.things.integer(0) } else { self.things.add(Op::Product(a, b)) }
    }

    fn over(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(a) { a } else { self.things.add(Op::Quotient(a, b)) }
    }

    fn minus(&mut self, a: Id, b: Id) -> Id {
        if self.is_zero(b) { a } else { self.things.add(Op::Difference(a, b)) }
    }

    fn negated(&mut self, a: Id) -> Id {
        if self.is_zero(a) { a } else { self.things.add(Op::Negated(a)) }
    }

    /// The value after a step of discrete time.
    fn next(&mut self, node: &Node, id: Id) -> Made<Id> {
        let op = self.things.ops[id].clone();
        let of = |id: &Id| self.changes[id];
        let next = match &op {
            Op::Number(_) | Op::Pi | Op::Agents | Op::Parameter(..) => return Ok(id),
            Op::Time => {
                let why = "the change over a step of what depends on `t` is not there yet";
                return self.refuse(node.at, Problem::Other(why.to_string()));
            }
            Op::State { start, .. } if self.is_open(*start) => return Ok(id),
            Op::State { start, component, of, .. } => return self.of_state(*start, *component, *of),
            Op::Gathered(number, place) => {
                let this = self.things.loops[*number].clone();
                if self.text.links_change && self.things.slots[this.slot].hears.is_some() {
                    let why = "the change over a step of what is gathered from neighbours is not known where links are others after it";
                    return self.refuse(node.at, Problem::Other(why.to_string()));
                }
                let (gather, body) = this.bodies[*place];
                let (condition, body) = (this.condition.map(|id| of(&id)), of(&body));
                return Ok(self.things.gather(this.slot, condition, gather, body));
            }
            Op::Negated(a) => Op::Negated(of(a)),
            Op::Sum(a, b) => Op::Sum(of(a), of(b)),
            Op::Difference(a, b) => Op::Difference(of(a), of(b)),
            Op::Product(a, b) => Op::Product(of(a), of(b)),
            Op::Quotient(a, b) => Op::Quotient(of(a), of(b)),
            Op::Power(a, exponent) => Op::Power(of(a), *exponent),
            Op::Function(function, a) => Op::Function(*function, of(a)),
            Op::Angle(a, b) => Op::Angle(of(a), of(b)),
            Op::Absolute(a) => Op::Absolute(of(a)),
            Op::Larger(a, b) => Op::Larger(of(a), of(b)),
            Op::Smaller(a, b) => Op::Smaller(of(a), of(b)),
            Op::Choice(c, a, b) => Op::Choice(of(c), of(a), of(b)),
            Op::Compared(relation, a, b) => Op::Compared(*relation, of(a), of(b)),
            Op::Both(a, b) => Op::Both(of(a), of(b)),
            Op::Not(a) => Op::Not(of(a)),
        };
        Ok(self.things.add(next))
    }
}
