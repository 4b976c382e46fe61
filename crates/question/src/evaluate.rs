//! Values and truth of expressions in one case.

mod steps;
mod time;
mod until;

pub(crate) use time::horizon;

use crate::bindings::Value;
use crate::case::Case;
use crate::error::Problem;
use crate::failure::Failure;
use crate::names::FUNCTIONS;
use crate::number::{Number, Obstacle};
use crate::syntax::{Kind, Node, Relation};
use crate::timeline::{Measured, Moment, Piece};
use crate::truth::{Margin, Truth};
use arithmetic::{Interval, Sign, rational};
use num_integer::Integer;
use num_traits::Signed;

/// Evaluates the expressions of a case at a precision, at a moment if there is one.
pub(crate) struct Evaluator<'c, 'q> {
    pub case: &'c Case<'q>,
    pub precision: u32,
    pub moment: Option<&'c dyn Moment>,
    /// The times of the moment.
    pub piece: Option<&'c Piece>,
}

type Judged = Result<(Truth, Margin), Failure>;

impl Evaluator<'_, '_> {
    /// The truth of a property with its margin; what cannot be told is unknown.
    pub fn judge(&self, node: &Node) -> Judged {
        match &node.kind {
            Kind::Not(body) => self.judge(body).map(|(truth, margin)| (truth.negated(), margin.negated())),
            Kind::And(nodes) => self.all(nodes),
            Kind::Or(nodes) => {
                let (mut truth, mut margin) = (Truth::False, Margin::of_truth(false));
                for node in nodes {
                    let (next, own) = self.judge(node)?;
                    (truth, margin) = (truth.or(next), margin.largest(own));
                    if truth == Truth::True {
                        return Ok((truth, Margin { hi: f64::INFINITY, ..margin }));
                    }
                }
                Ok((truth, margin))
            }
            Kind::Implies(first, second) => {
                let (truth, margin) = self.judge(first)?;
                if truth == Truth::False {
                    return Ok((Truth::True, Margin { hi: f64::INFINITY, ..margin.negated() }));
                }
                let (other, own) = self.judge(second)?;
                Ok((truth.negated().or(other), margin.negated().largest(own)))
            }
            Kind::Relation(first, others) => self.related(first, others),
            Kind::Always(..) | Kind::Until(_) => self.over_time(node),
            Kind::Name { .. } => self.named_truth(node),
            _ => Err(Failure::Refused(node.at, Problem::expected("something true or false", "a number"))),
        }
    }

    fn all(&self, nodes: &[Node]) -> Judged {
        let (mut truth, mut margin) = (Truth::True, Margin::of_truth(true));
        for node in nodes {
            let (next, own) = self.judge(node)?;
            (truth, margin) = (truth.and(next), margin.least(own));
            if truth == Truth::False {
                return Ok((truth, Margin { lo: f64::NEG_INFINITY, ..margin }));
            }
        }
        Ok((truth, margin))
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

    fn related(&self, first: &Node, others: &[(Relation, Node)]) -> Judged {
        let (mut truth, mut margin) = (Truth::True, Margin::of_truth(true));
        let mut left = self.number(first);
        for (relation, node) in others {
            let right = self.number(node);
            let (next, own) = match (&left, &right) {
                (Ok(a), Ok(b)) => self.compared(a, *relation, b),
                (Err(Failure::Open(doubt)), Ok(_) | Err(Failure::Open(_))) | (Ok(_), Err(Failure::Open(doubt))) => {
                    (Truth::Unknown(doubt.clone()), Margin::ANY)
                }
                (Err(failure), _) | (_, Err(failure)) => return Err(failure.clone()),
            };
            (truth, margin) = (truth.and(next), margin.least(own));
            left = right;
        }
        Ok((truth, margin))
    }

    fn compared(&self, a: &Number, relation: Relation, b: &Number) -> (Truth, Margin) {
        // The margin is what is at least 0, or above 0, where the relation is true.
        let slack = match relation {
            Relation::Less | Relation::AtMost => b.minus(a, self.precision),
            _ => a.minus(b, self.precision),
        };
        let sign = slack.sign();
        let enclosure = match sign {
            Some(Sign::Zero) => Interval::from_rational(&rational(0, 1), self.precision),
            _ => slack.enclosure(self.precision),
        };
        let margin = Margin::between(enclosure.lo(), enclosure.hi());
        let margin = match relation {
            Relation::Equal | Relation::Different => {
                let size = Number::interval(enclosure).absolute(self.precision).enclosure(self.precision);
                let size = Margin::between(size.lo(), size.hi());
                if relation == Relation::Equal { size.negated() } else { size }
            }
            _ => margin,
        };
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

    /// What an obstacle means here: an error of the question, or a doubt.
    fn obstacle(&self, obstacle: Obstacle, argument: &Node) -> Failure {
        let at = || format!(" where {}", arithmetic::shown(&self.case.bindings.to_string()));
        let whole_box = || {
            let boxed = self.case.bindings.boxes();
            !boxed.is_empty() && self.case.is_first && self.uses_each_box_once(argument)
        };
        match obstacle {
            Obstacle::Never("/") => Failure::Refused(argument.at, Problem::DivisionByZero(at())),
            Obstacle::Perhaps("/") if whole_box() => {
                Failure::Refused(argument.at, Problem::DivisionInBox(self.case.bindings.to_string()))
            }
            Obstacle::Never(function) => Failure::Refused(argument.at, Problem::Domain { function, at: at() }),
            Obstacle::Perhaps("/") => Failure::open("a divisor may be zero", Some(u64::MAX)),
            Obstacle::Perhaps(function) => {
                Failure::open(format!("the argument of `{function}` may lie outside its domain"), Some(u64::MAX))
            }
            Obstacle::TooLarge => Failure::Refused(
                argument.at,
                Problem::Other("the number has too many digits to be computed".to_string()),
            ),
        }
    }

    /// Whether interval arithmetic gives the exact range of the expression over the boxes: each stands in it at most once, and nothing
    /// else is enclosed.
    fn uses_each_box_once(&self, node: &Node) -> bool {
        let mut seen: Vec<&str> = Vec::new();
        let mut exact = true;
        node.visit(&mut |node| {
            if let Kind::Name { name, .. } = &node.kind {
                match self.case.bindings.get(name) {
                    Some(Value::Box(..)) if seen.contains(&name.as_str()) => exact = false,
                    Some(Value::Box(..)) => seen.push(name),
                    Some(Value::Integers(..)) => exact = false,
                    Some(_) => {}
                    None => exact = exact && FUNCTIONS.iter().any(|f| f.name == name),
                }
            }
        });
        exact && !seen.is_empty()
    }

    /// The value of a name: what is bound, a function, a quantity.
    pub fn measured(&self, node: &Node) -> Result<Measured, Failure> {
        let Kind::Name { name, arguments, called } = &node.kind else {
            return self.number(node).map(Measured::Number);
        };
        if !called {
            match self.case.bindings.get(name) {
                Some(Value::Number(q)) => return Ok(Measured::Number(Number::Exact(q.clone()))),
                Some(value @ (Value::Box(..) | Value::Integers(..))) => {
                    let (lo, hi) = value.ends().unwrap_or_default();
                    let interval = Interval::hull_of_rationals(&lo, &hi, self.precision);
                    return Ok(Measured::Number(Number::interval(interval)));
                }
                Some(Value::Graph(_) | Value::Matrices(_)) => {
                    return Err(Failure::Refused(node.at, Problem::expected("a number", format!("`{name}`"))));
                }
                None => {}
            }
        }
        if FUNCTIONS.iter().any(|function| function.name == name) {
            return self.function(name, arguments, node);
        }
        let (owner, own_name) = match name.split_once('.') {
            Some((owner, rest)) => (Some(owner), rest),
            None => (None, name.as_str()),
        };
        let quantity = self.case.quantity(owner, own_name).map_err(|problem| Failure::Refused(node.at, problem))?;
        let arguments = arguments.iter().map(|node| self.number(node)).collect::<Result<Vec<_>, _>>()?;
        let found = match self.moment {
            Some(moment) if quantity.moves => moment.measure(quantity, &arguments, self.precision),
            _ => self.case.measure(quantity, owner, &arguments, self.precision),
        };
        found.map_err(|failure| match failure {
            // Subjects do not know where they are asked.
            Failure::Refused(_, problem) => Failure::Refused(node.at, problem),
            other => other,
        })
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
            let problem = || Problem::NotInteger { what: "an argument of `gcd`".to_string(), found: value.text() };
            let integer = value.as_integer().ok_or_else(|| Failure::Refused(node.at, problem()))?;
            divisor = divisor.gcd(&integer.abs());
        }
        Ok(Measured::Number(Number::Exact(divisor.into())))
    }
}
