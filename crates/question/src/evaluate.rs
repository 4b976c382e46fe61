//! Values and truth of expressions in one case.

mod curve;
mod growth;
mod steps;
mod terms;
mod time;
mod until;

pub(crate) use time::horizon;

use crate::binder::{Binder, Gathered, Over};
use crate::bindings::Value;
use crate::case::Case;
use crate::error::Problem;
use crate::failure::Failure;
use crate::names::{FUNCTIONS, GIVEN, OWN};
use crate::subject::graph::{GraphSubject, kind_number};
use crate::syntax::{Kind, Node, Relation};
use crate::timeline::{Measured, Moment, Piece};
use crate::truth::{Margin, Truth};
use algebra::graph::LaplacianKind;
use arithmetic::{Interval, Rational, Sign, rational};
use arithmetic::{Obstacle, RealNumber as Number};
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive};
use std::rc::Rc;

/// Evaluates the expressions of a case at a precision, at a moment if there is one.
pub(crate) struct Evaluator<'c, 'q> {
    pub case: &'c Case<'q>,
    pub precision: u32,
    pub moment: Option<&'c dyn Moment>,
    /// The times of the moment.
    pub piece: Option<&'c Piece>,
}

type Judged = Result<(Truth, Margin), Failure>;

fn negated((truth, margin): (Truth, Margin)) -> (Truth, Margin) {
    (truth.negated(), margin.negated())
}

/// Whether all parts are true, in three-valued logic: one that is false decides, whatever is missing; what is not known may still be false.
fn all(parts: impl Iterator<Item = Judged>) -> Judged {
    joined(parts, true)
}

/// The same; unless it stops at the first part that is false, the margin is that of all parts.
fn joined(mut parts: impl Iterator<Item = Judged>, stops: bool) -> Judged {
    let (mut truth, mut margin, mut missing) = (Truth::True, Margin::of_truth(true), None);
    while let Some(part) = parts.next() {
        let (next, own) = match part {
            Err(Failure::Open(doubt)) => (Truth::Unknown(doubt), Margin::ANY),
            Err(failure @ Failure::Refused(..)) => {
                missing.get_or_insert(failure);
                continue;
            }
            part => part?,
        };
        (truth, margin) = (truth.and(next), margin.least(own));
        // What the parts have that were not looked at is not known.
        if stops && truth == Truth::False && (missing.is_some() || parts.size_hint().1 != Some(0)) {
            return Ok((truth, Margin { lo: f64::NEG_INFINITY, ..margin }));
        }
    }
    match missing {
        Some(failure) if truth == Truth::True => Err(failure),
        Some(_) => Ok((truth, Margin { lo: f64::NEG_INFINITY, ..margin })),
        None => Ok((truth, margin)),
    }
}

/// What is at least 0, or above 0, where a relation is true (the difference where it says equal or different), and its margin.
pub(crate) fn slack(a: &Number, relation: Relation, b: &Number, precision: u32) -> (Number, Margin) {
    let slack = match relation {
        Relation::Less | Relation::AtMost => b.minus(a, precision),
        _ => a.minus(b, precision),
    };
    let enclosure = match slack.sign() {
        Some(Sign::Zero) => Interval::from_rational(&rational(0, 1), precision),
        _ => slack.enclosure(precision),
    };
    let margin = match relation {
        Relation::Equal | Relation::Different => {
            let size = Number::interval(enclosure).absolute(precision).enclosure(precision);
            let size = Margin::between(size.lo(), size.hi());
            if relation == Relation::Equal { size.negated() } else { size }
        }
        _ => Margin::between(enclosure.lo(), enclosure.hi()),
    };
    (slack, margin)
}

/// The kind of matrix that an argument names.
pub(crate) fn kind_argument(node: &Node) -> Result<Number, (usize, Problem)> {
    // `out-degree` is read as a difference.
    let name = node.to_string().replace(' ', "");
    let names = LaplacianKind::NAMES.iter().map(|(name, _)| *name);
    kind_number(&name).map(Number::integer).ok_or_else(|| (node.at, Problem::unknown("kind of matrix", &name, names)))
}

impl Evaluator<'_, '_> {
    /// The truth of a property with its margin; what cannot be told is unknown. A value that is missing (`Refused`) is the third one of three-valued
    /// logic: `true or missing` is true, `missing and false` is false, and what is left missing is refused by whoever asked.
    pub fn judge(&self, node: &Node) -> Judged {
        match &node.kind {
            Kind::Not(body) => self.judge(body).map(negated),
            Kind::And(nodes) => all(nodes.iter().map(|node| self.judge(node))),
            Kind::Or(nodes) => all(nodes.iter().map(|node| self.judge(node).map(negated))).map(negated),
            Kind::Implies(first, second) => {
                // A hypothesis is met or not: the margin is that of the conclusion.
                let hypothesis = self.judge(first).map(|(truth, _)| {
                    let margin = match truth {
                        Truth::True => Margin::of_truth(true),
                        Truth::False => Margin::of_truth(false),
                        Truth::Unknown(_) => Margin::ANY,
                    };
                    (truth, margin)
                });
                let parts = [hypothesis].into_iter().chain(std::iter::once_with(|| self.judge(second).map(negated)));
                all(parts).map(negated)
            }
            Kind::Relation(first, others) => self.related(first, others),
            Kind::Always(..) | Kind::Until(_) => self.over_time(node),
            Kind::Name { .. } => self.named_truth(node),
            _ => Err(Failure::Refused(node.at, Problem::expected("something true or false", "a number"))),
        }
    }

    fn named_truth(&self, node: &Node) -> Judged {
        match self.measured(node) {
            Ok(Measured::Truth(value)) => Ok((Truth::of(value), Margin::of_truth(value))),
            Ok(Measured::Number(_)) => {
                Err(Failure::Refused(node.at, Problem::expected("something true or false", "a number")))
            }
            Err(Failure::Open(doubt)) => Ok((Truth::Unknown(doubt), Margin::ANY)),
            Err(other) => Err(other),
        }
    }

    /// A chain of relations, each link between its neighbours.
    fn related(&self, first: &Node, others: &[(Relation, Node)]) -> Judged {
        let (mut left, mut before) = (self.number(first), first);
        let links = others.iter().map(|(relation, node)| {
            let right = self.number(node);
            let link = match (&left, &right) {
                (Ok(a), Ok(b)) => Ok(match self.by_definition(before, *relation, node) {
                    Some(true) => self.certain(a, *relation, b),
                    _ => match self.compared(a, *relation, b) {
                        (Truth::Unknown(doubt), margin) => {
                            (self.by_stability(before, *relation, node).unwrap_or(Truth::Unknown(doubt)), margin)
                        }
                        decided => decided,
                    },
                }),
                (Err(Failure::Open(doubt)), Ok(_)) | (Ok(_), Err(Failure::Open(doubt))) => {
                    let known = self.by_stability(before, *relation, node).ok_or_else(|| Failure::Open(doubt.clone()));
                    known.map(|truth| (truth, Margin::ANY))
                }
                (Err(Failure::Open(_)), Err(failure)) | (Err(failure), _) | (_, Err(failure)) => Err(failure.clone()),
            };
            (left, before) = (right, node);
            link
        });
        joined(links, false)
    }

    /// Whether `a <= b` holds whatever the numbers are: no gain of the last car is above the peak, and eigenvalues are numbered in order.
    pub fn by_definition(&self, left: &Node, relation: Relation, right: &Node) -> Option<bool> {
        let (lower, upper) = match relation {
            Relation::AtMost => (left, right),
            Relation::AtLeast => (right, left),
            _ => return None,
        };
        let (Kind::Name { name, arguments, .. }, Kind::Name { name: other, arguments: others, .. }) =
            (&lower.kind, &upper.kind)
        else {
            return None;
        };
        let integer =
            |arguments: &[Node]| arguments.first().and_then(|k| self.number(k).ok()).and_then(|k| k.as_integer());
        if name == "gain" && other == "peak" {
            let last = match self.case.bindings.get("followers") {
                Some(Value::Number(q)) if q.is_integer() => q.to_integer(),
                Some(_) => return None,
                None => self.case.bindings.iter().find_map(|(_, value)| match value {
                    Value::Graph(graph) => Some((graph.order() - 1).into()),
                    _ => None,
                })?,
            };
            return Some(integer(arguments)? == last);
        }
        let own = name.rsplit('.').next() == Some("lambda");
        // Of one and the same matrix.
        if own
            && name == other
            && arguments.len() == others.len()
            && arguments.iter().skip(1).map(ToString::to_string).eq(others.iter().skip(1).map(ToString::to_string))
        {
            return Some(integer(arguments)? <= integer(others)?);
        }
        None
    }

    /// The abscissa against 0: below it where the platoon is stable, at least 0 where it is not; nothing of other comparisons.
    fn by_stability(&self, left: &Node, relation: Relation, right: &Node) -> Option<Truth> {
        let is_abscissa = |node: &Node| matches!(&node.kind, Kind::Name { name, .. } if name == "abscissa");
        let is_zero = |node: &Node| matches!(&node.kind, Kind::Number(q) if *q == rational(0, 1));
        let relation = match (is_abscissa(left) && is_zero(right), is_zero(left) && is_abscissa(right)) {
            (true, _) => relation,
            (_, true) => match relation {
                Relation::Less => Relation::Greater,
                Relation::Greater => Relation::Less,
                Relation::AtMost => Relation::AtLeast,
                Relation::AtLeast => Relation::AtMost,
                same => same,
            },
            _ => return None,
        };
        let quantity = self.case.quantity(None, "stable").ok()?;
        let Ok(Measured::Truth(stable)) = self.case.measure(quantity, None, &[], self.precision) else { return None };
        match (stable, relation) {
            (true, Relation::Less | Relation::AtMost | Relation::Different) => Some(Truth::True),
            (true, Relation::Greater | Relation::AtLeast | Relation::Equal) => Some(Truth::False),
            (false, Relation::AtLeast) => Some(Truth::True),
            (false, Relation::Less) => Some(Truth::False),
            (false, _) => None,
        }
    }

    /// A relation that is known to hold, with the margin that the numbers leave.
    fn certain(&self, a: &Number, relation: Relation, b: &Number) -> (Truth, Margin) {
        let (_, margin) = self.compared(a, relation, b);
        (Truth::True, margin.held())
    }

    fn compared(&self, a: &Number, relation: Relation, b: &Number) -> (Truth, Margin) {
        let (slack, margin) = slack(a, relation, b, self.precision);
        let sign = slack.sign();
        let Some(sign) = sign else { return (self.undecided(&slack, relation), margin) };
        let holds = match relation {
            Relation::Equal => sign == Sign::Zero,
            Relation::Different => sign != Sign::Zero,
            Relation::Less | Relation::Greater => sign == Sign::Positive,
            Relation::AtMost | Relation::AtLeast => sign != Sign::Negative,
        };
        (Truth::of(holds), margin)
    }

    /// A difference whose sign is not known. An interval that begins at 0 decides `>=`.
    fn undecided(&self, slack: &Number, relation: Relation) -> Truth {
        let interval = slack.enclosure(self.precision);
        match relation {
            Relation::AtMost | Relation::AtLeast if !interval.lo().is_negative() => return Truth::True,
            Relation::Less | Relation::Greater if !interval.hi().is_positive() => return Truth::False,
            _ => {}
        }
        let (lo, hi) = arithmetic::decimals(&interval, 3);
        let why = format!("the difference of the two sides is only known to lie in [{lo}, {hi}]");
        // Without a bound there may be no precision that is enough; the caller has a limit.
        Truth::unknown(why, Some(slack.needed_bits().unwrap_or(u64::MAX)))
    }

    /// The value of an expression.
    pub fn number(&self, node: &Node) -> Result<Number, Failure> {
        let precision = self.precision;
        match &node.kind {
            Kind::Number(q) => Ok(Number::Exact(q.clone())),
            Kind::Negated(body) => Ok(self.number(body)?.negated()),
            Kind::Sum(terms) => terms.iter().try_fold(Number::integer(0), |sum, (minus, term)| {
                let term = self.number(term)?;
                Ok(if *minus { sum.minus(&term, precision) } else { sum.plus(&term, precision) })
            }),
            Kind::Product(factors) => {
                let mut product: Option<Number> = None;
                for (divides, node) in factors {
                    let factor = self.number(node)?;
                    product = Some(match product {
                        None => factor,
                        Some(so_far) if *divides => {
                            so_far.over(&factor, precision).map_err(|o| self.obstacle(o, node))?
                        }
                        Some(so_far) => so_far.times(&factor, precision),
                    });
                }
                Ok(product.unwrap_or_else(|| Number::integer(1)))
            }
            Kind::Power(base, exponent) => {
                let (base_value, exponent) = (self.number(base)?, self.number(exponent)?);
                base_value.power(&exponent, precision).map_err(|o| self.obstacle(o, base))
            }
            Kind::Name { .. } => match self.measured(node)? {
                Measured::Number(number) => Ok(number),
                Measured::Truth(_) => {
                    Err(Failure::Refused(node.at, Problem::expected("a number", "something true or false")))
                }
            },
            _ => Err(Failure::Refused(node.at, Problem::expected("a number", "something true or false"))),
        }
    }

    /// What an obstacle means here: a value that is missing, or a doubt.
    fn obstacle(&self, obstacle: Obstacle, argument: &Node) -> Failure {
        let missing = |problem| Failure::Refused(argument.at, problem);
        match obstacle {
            Obstacle::Never("/") => missing(Problem::DivisionByZero),
            Obstacle::Never(function) => missing(Problem::Domain(function)),
            Obstacle::Perhaps("/") => Failure::open("a divisor may be zero", Some(u64::MAX)),
            Obstacle::Perhaps(function) => {
                Failure::open(format!("the argument of `{function}` may lie outside its domain"), Some(u64::MAX))
            }
            Obstacle::TooLarge => missing(Problem::TooManyDigits),
        }
    }

    /// The value of a name: what is bound, a function, a quantity.
    pub fn measured(&self, node: &Node) -> Result<Measured, Failure> {
        let Kind::Name { name, arguments, called } = &node.kind else {
            return self.number(node).map(Measured::Number);
        };
        if !called {
            let place = self.case.places.borrow().iter().rev().find(|(own, _)| own == name).map(|(_, vertex)| *vertex);
            if let Some(vertex) = place {
                return Ok(Measured::Number(Number::integer(vertex as i64)));
            }
            if name == "n" {
                self.same_order().map_err(|problem| Failure::Refused(node.at, problem))?;
            }
            match self.case.bindings.get(name) {
                Some(Value::Number(q)) => return Ok(Measured::Number(Number::Exact(q.clone()))),
                Some(value @ (Value::Box(..) | Value::Integers(..))) => {
                    let range = value.ends().unwrap_or_default();
                    let interval = Interval::hull_of_rationals(&range.lo, &range.hi, self.precision);
                    return Ok(Measured::Number(Number::interval(interval)));
                }
                Some(Value::Any) => return Err(Failure::open(format!("`{name}` ranges over all reals"), None)),
                Some(Value::Graph(_) | Value::Matrices(_) | Value::Each(_)) => {
                    return Err(Failure::Refused(node.at, Problem::expected("a number", format!("`{name}`"))));
                }
                None => {}
            }
        }
        if let Some(binder) = Binder::of(node, |name| self.case.question.is_known(name)) {
            let binder = binder.map_err(|(at, problem)| Failure::Refused(at, problem))?;
            return self.gathered(&binder, node).map(Measured::Number);
        }
        if FUNCTIONS.iter().any(|function| function.name == name) {
            return self.function(name, arguments, node);
        }
        let (owner, own_name) = match name.split_once('.') {
            Some((owner, rest)) => (Some(owner), rest),
            None => (None, name.as_str()),
        };
        let quantity = self.case.quantity(owner, own_name).map_err(|problem| Failure::Refused(node.at, problem))?;
        let argument = |(place, node): (usize, &Node)| match quantity.arguments.get(place) {
            Some(&"kind") => kind_argument(node).map_err(|(at, problem)| Failure::Refused(at, problem)),
            _ => self.number(node),
        };
        let arguments = arguments.iter().enumerate().map(argument).collect::<Result<Vec<_>, _>>()?;
        let found = match self.moment {
            _ if std::ptr::eq(quantity, &GIVEN) => self.case.given(own_name, owner),
            Some(moment) if std::ptr::eq(quantity, &OWN) => moment.own(name, self.precision),
            Some(moment) if quantity.moves => moment.measure(quantity, &arguments, self.precision),
            _ => self.case.measure(quantity, owner, &arguments, self.precision),
        };
        found.map_err(|failure| match failure {
            // Subjects do not know where they are asked.
            Failure::Refused(_, problem) => Failure::Refused(node.at, problem),
            other => other,
        })
    }

    /// What a binder makes of the values of its body.
    fn gathered(&self, binder: &Binder, node: &Node) -> Result<Number, Failure> {
        let graph = binder.graph(self.case, node.at)?;
        let depth = self.case.places.borrow().len();
        let mut values = Vec::new();
        for place in binder.places(&graph) {
            let named = binder.names.iter().zip(place).map(|(name, vertex)| (name.to_string(), vertex));
            self.case.places.borrow_mut().extend(named);
            let value = self.gathered_value(binder);
            self.case.places.borrow_mut().truncate(depth);
            values.extend(value?);
        }
        let precision = self.precision;
        let mut values = values.into_iter();
        if matches!(binder.gathered, Gathered::Sum | Gathered::Count) {
            let sum = values.fold(Number::integer(0), |sum, value| sum.plus(&value, precision));
            return Ok(match sum {
                Number::Exact(_) => sum,
                sum => self.trace(binder, &graph).map_or(sum, Number::Exact),
            });
        }
        let larger = binder.gathered == Gathered::Largest;
        let none =
            || Failure::Refused(node.at, Problem::Other("there is nothing whose extreme could be taken".to_string()));
        let first = values.next().ok_or_else(none)?;
        Ok(values.fold(first, |best, value| best.extreme(&value, larger, precision)))
    }

    /// A sum of a power of all eigenvalues of a graph, exactly: the trace of the power of the matrix.
    fn trace(&self, binder: &Binder, graph: &Rc<GraphSubject>) -> Option<Rational> {
        let ([own], Over::Vertices, Gathered::Sum, None) =
            (&binder.names[..], binder.over, binder.gathered, binder.condition)
        else {
            return None;
        };
        let (eigenvalue, power) = match &binder.body.kind {
            Kind::Power(base, exponent) => match &exponent.kind {
                Kind::Number(q) => (base.as_ref(), q.to_integer().to_u32().filter(|_| q.is_integer())?),
                _ => return None,
            },
            _ => (binder.body, 1),
        };
        let Kind::Name { name, arguments, .. } = &eigenvalue.kind else { return None };
        let (owner, name) = name.split_once('.').map_or((None, name.as_str()), |(owner, name)| (Some(owner), name));
        let (first, kind) = arguments.split_first()?;
        let is_own = matches!(&first.kind, Kind::Name { name, called: false, .. } if name == own);
        let is_eigenvalue = name == "lambda" && is_own && kind.len() <= 1;
        let of = self.case.graph(owner).filter(|of| is_eigenvalue && Rc::ptr_eq(of, graph))?;
        let kind = kind.first().map(kind_argument).transpose().ok()?;
        of.power_sum(kind.as_ref(), power)
    }

    /// The value for the present names; nothing where the condition leaves them out.
    fn gathered_value(&self, binder: &Binder) -> Result<Option<Number>, Failure> {
        let decided = |node: &Node| match self.judge(node)?.0 {
            Truth::True => Ok(true),
            Truth::False => Ok(false),
            Truth::Unknown(doubt) => Err(Failure::Open(doubt)),
        };
        if let Some(condition) = binder.condition
            && !decided(condition)?
        {
            return Ok(None);
        }
        match binder.gathered {
            Gathered::Count => Ok(Some(Number::integer(i64::from(decided(binder.body)?)))),
            _ => self.number(binder.body).map(Some),
        }
    }

    /// Refuses a bound `n` that hides another number of vertices of the only graph.
    fn same_order(&self) -> Result<(), Problem> {
        let graphs: Vec<_> = self.case.bindings.iter().filter(|(_, value)| matches!(value, Value::Graph(_))).collect();
        let (Some(bound), [(name, Value::Graph(graph))]) = (self.case.bindings.get("n"), &graphs[..]) else {
            return Ok(());
        };
        let order = graph.order();
        let same = matches!(bound, Value::Number(q) if *q == rational(order as i64, 1));
        let text = bound.text();
        let message =
            || format!("`n` is bound to {text}, but `{name}` has {order} vertices; give one of them another name");
        if same { Ok(()) } else { Err(Problem::Other(message())) }
    }

    fn function(&self, name: &str, arguments: &[Node], node: &Node) -> Result<Measured, Failure> {
        let precision = self.precision;
        if name == "initial" {
            return match arguments.first() {
                Some(inner) => self.initially(inner),
                None => Err(Failure::Refused(node.at, Problem::expected("a quantity", "nothing"))),
            };
        }
        if name == "pi" {
            return Ok(Measured::Number(Number::Turns(rational(1, 1))));
        }
        let values = arguments.iter().map(|node| self.number(node)).collect::<Result<Vec<_>, _>>()?;
        let Some((first, others)) = values.split_first() else {
            return Err(Failure::Refused(node.at, Problem::expected("an argument", "none")));
        };
        let found = match name {
            "sqrt" => first.sqrt(precision),
            "abs" => Ok(first.absolute(precision)),
            "sin" => first.sin(precision),
            "cos" => first.cos(precision),
            "exp" => first.exp(precision),
            "log" => first.log(precision),
            "min" | "max" => {
                let larger = name == "max";
                Ok(others.iter().fold(first.clone(), |best, x| best.extreme(x, larger, precision)))
            }
            _ => return self.divisor(&values, arguments),
        };
        found.map(Measured::Number).map_err(|o| self.obstacle(o, &arguments[0]))
    }

    fn divisor(&self, values: &[Number], arguments: &[Node]) -> Result<Measured, Failure> {
        let mut divisor = num_bigint::BigInt::ZERO;
        for (value, node) in values.iter().zip(arguments) {
            if value.may_be_integer(self.precision) {
                return Err(self.obstacle(Obstacle::Perhaps("gcd"), node));
            }
            let problem = || Problem::NotInteger { what: "an argument of `gcd`".to_string(), found: value.text() };
            let integer = value.as_integer().ok_or_else(|| Failure::Refused(node.at, problem()))?;
            divisor = divisor.gcd(&integer.abs());
        }
        Ok(Measured::Number(Number::Exact(divisor.into())))
    }
}
