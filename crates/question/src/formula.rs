//! A property as functions that are compared with zero: what is needed to decide it where it is attained. Only properties of numbers and functions
//! of them have that form; those with quantities of a subject have not.

use crate::bindings::{Bindings, Value};
use crate::syntax::{Kind, Node, Relation};
use arithmetic::{ArithmeticError, Interval, Number, Rational, rational};
use num_traits::{Signed, ToPrimitive, Zero};
use polynomials::{Compared, Function, Literal};
use std::sync::Arc;

/// A function of one number.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Elementary {
    /// Of this degree.
    Root(u64),
    Exponential,
    Logarithm,
    Sine,
    Cosine,
}

impl Elementary {
    fn of<T: Number>(self, x: &T) -> Result<T, ArithmeticError> {
        match self {
            Elementary::Root(2) => x.sqrt(),
            Elementary::Root(degree) => x.root(degree),
            Elementary::Exponential => x.exp(),
            Elementary::Logarithm => x.ln(),
            Elementary::Sine => x.sin(),
            Elementary::Cosine => x.cos(),
        }
    }
}

/// An expression of bound numbers.
#[derive(Debug, Clone, PartialEq)]
enum Term {
    Number(Rational),
    /// The one of that number among the names that stand for intervals.
    Variable(usize),
    Pi,
    Negated(Arc<Term>),
    Sum(Vec<Term>),
    Product(Vec<Term>),
    Reciprocal(Arc<Term>),
    Power(Arc<Term>, u64),
    Call(Elementary, Arc<Term>),
    Absolute(Arc<Term>),
    /// The larger one, or the smaller one.
    Extreme(bool, Vec<Term>),
}

/// An expression as a function of the names that stand for intervals.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Formula {
    term: Arc<Term>,
}

/// One of several literals is true.
pub(crate) type Clause = Vec<Literal<Formula>>;

/// A property as clauses, all of which have to hold.
pub(crate) struct Clauses {
    pub list: Vec<Clause>,
    /// What has to be true so that every operation in it has a value.
    pub conditions: Vec<Literal<Formula>>,
}

/// More clauses, or literals in one, are not decided in this way.
const MOST_CLAUSES: usize = 64;
const MOST_LITERALS: usize = 12;

impl Function for Formula {
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        let like = at.first().ok_or(ArithmeticError::Domain("a variable"))?;
        self.term.value(at, like)
    }
}

impl Term {
    fn value<T: Number>(&self, at: &[T], like: &T) -> Result<T, ArithmeticError> {
        let all = |terms: &[Term]| terms.iter().map(|term| term.value(at, like)).collect::<Result<Vec<T>, _>>();
        Ok(match self {
            Term::Number(q) => like.rational(q),
            Term::Variable(k) => at.get(*k).cloned().ok_or(ArithmeticError::Domain("a variable"))?,
            Term::Pi => like.circle()?,
            Term::Negated(body) => -body.value(at, like)?,
            Term::Sum(terms) => all(terms)?.into_iter().reduce(|a, b| a + b).unwrap_or_else(|| like.zero()),
            Term::Product(terms) => {
                // Equal factors are squares, which are never negative.
                if let [a, b] = &terms[..]
                    && a == b
                {
                    return Ok(a.value(at, like)?.square());
                }
                all(terms)?.into_iter().reduce(|a, b| a * b).unwrap_or_else(|| like.one())
            }
            Term::Reciprocal(body) => body.value(at, like)?.recip()?,
            Term::Power(body, exponent) => body.value(at, like)?.power(*exponent),
            Term::Call(function, body) => function.of(&body.value(at, like)?)?,
            Term::Absolute(body) => body.value(at, like)?.absolute()?,
            Term::Extreme(larger, terms) => {
                let mut values = all(terms)?.into_iter();
                let first = values.next().ok_or(ArithmeticError::Domain("an argument"))?;
                values.try_fold(first, |best, x| if *larger { best.larger(&x) } else { best.smaller(&x) })?
            }
        })
    }

    /// The terms in it.
    fn parts(&self) -> Vec<&Term> {
        match self {
            Term::Number(_) | Term::Variable(_) | Term::Pi => Vec::new(),
            Term::Negated(body)
            | Term::Reciprocal(body)
            | Term::Power(body, _)
            | Term::Call(_, body)
            | Term::Absolute(body) => vec![body],
            Term::Sum(terms) | Term::Product(terms) | Term::Extreme(_, terms) => terms.iter().collect(),
        }
    }

    /// With a term in the place of another one.
    fn with(&self, old: &Term, new: &Term) -> Term {
        if self == old {
            return new.clone();
        }
        let one = |body: &Term| Arc::new(body.with(old, new));
        let all = |terms: &[Term]| terms.iter().map(|term| term.with(old, new)).collect::<Vec<Term>>();
        match self {
            Term::Number(_) | Term::Variable(_) | Term::Pi => self.clone(),
            Term::Negated(body) => Term::Negated(one(body)),
            Term::Reciprocal(body) => Term::Reciprocal(one(body)),
            Term::Power(body, exponent) => Term::Power(one(body), *exponent),
            Term::Call(function, body) => Term::Call(*function, one(body)),
            Term::Absolute(body) => Term::Absolute(one(body)),
            Term::Sum(terms) => Term::Sum(all(terms)),
            Term::Product(terms) => Term::Product(all(terms)),
            Term::Extreme(larger, terms) => Term::Extreme(*larger, all(terms)),
        }
    }

    /// An absolute value, minimum or maximum in it that has none inside: the term, what its choice depends on, and what it is where that is at least 0, and at
    /// most 0.
    fn kink(&self) -> Option<[Term; 4]> {
        if let Some(inner) = self.parts().into_iter().find_map(Term::kink) {
            return Some(inner);
        }
        match self {
            Term::Absolute(body) => {
                Some([self.clone(), body.as_ref().clone(), body.as_ref().clone(), negated(body.as_ref().clone())])
            }
            Term::Extreme(larger, terms) => match &terms[..] {
                [only] => Some([self.clone(), Term::Number(rational(0, 1)), only.clone(), only.clone()]),
                [a, b, rest @ ..] => {
                    let kept = |own: &Term| Term::Extreme(*larger, std::iter::once(own).chain(rest).cloned().collect());
                    let apart = sum(vec![a.clone(), negated(b.clone())]);
                    let (above, below) = if *larger { (kept(a), kept(b)) } else { (kept(b), kept(a)) };
                    Some([self.clone(), apart, above, below])
                }
                [] => None,
            },
            _ => None,
        }
    }

    fn as_number(&self) -> Option<&Rational> {
        match self {
            Term::Number(q) => Some(q),
            _ => None,
        }
    }
}

impl Term {
    /// A polynomial as a text; `None` of anything else.
    fn text(&self, names: &[&str]) -> Option<String> {
        let all = |terms: &[Term]| terms.iter().map(|term| term.text(names)).collect::<Option<Vec<String>>>();
        Some(match self {
            Term::Number(q) if q.is_negative() => format!("({q})"),
            Term::Number(q) => q.to_string(),
            Term::Variable(k) => (*names.get(*k)?).to_string(),
            Term::Negated(body) => format!("(-{})", body.text(names)?),
            Term::Sum(terms) => format!("({})", all(terms)?.join(" + ")),
            Term::Product(terms) => all(terms)?.join("*"),
            Term::Power(body, exponent) => match body.as_ref() {
                Term::Variable(_) | Term::Sum(_) => format!("{}^{exponent}", body.text(names)?),
                other => format!("({})^{exponent}", other.text(names)?),
            },
            _ => return None,
        })
    }
}

/// A clause of polynomials in words: `x*y + (-1) > 0 or x >= 0`; `None` of anything else, and of equations.
pub(crate) fn text(clause: &Clause, names: &[&str]) -> Option<String> {
    let literal = |literal: &Literal<Formula>| {
        let relation = match literal.compared {
            Compared::Positive => ">",
            Compared::NotNegative => ">=",
            Compared::NotZero => "!=",
            Compared::Zero => return None,
        };
        let text = match literal.function.term.as_ref() {
            Term::Sum(terms) => terms.iter().map(|term| term.text(names)).collect::<Option<Vec<_>>>()?.join(" + "),
            term => term.text(names)?,
        };
        Some(format!("{text} {relation} 0"))
    };
    clause.iter().map(literal).collect::<Option<Vec<String>>>().map(|all| all.join(" or "))
}

/// A clause with absolute values, minima and maxima as several without: each choice is one more literal, that it is not made. `None` where there are none, or
/// too many.
pub(crate) fn without_kinks(clause: &Clause) -> Option<Vec<Clause>> {
    const MOST: usize = 16;
    let kink = |clause: &Clause| clause.iter().find_map(|literal| literal.function.term.kink());
    let mut all = vec![clause.clone()];
    kink(clause)?;
    while let Some((place, [whole, apart, above, below])) =
        all.iter().enumerate().find_map(|(place, clause)| Some((place, kink(clause)?)))
    {
        let clause = all.remove(place);
        for (guard, chosen) in [(negated(apart.clone()), above), (apart, below)] {
            let literal = |term: Term, compared: Compared| Literal {
                function: Formula { term: Arc::new(term) },
                compared,
                guarded: true,
            };
            let put = clause.iter().map(|own| literal(own.function.term.with(&whole, &chosen), own.compared));
            all.push(put.chain([literal(guard, Compared::Positive)]).collect());
        }
        if all.len() > MOST {
            return None;
        }
    }
    Some(all)
}

/// Reads expressions in one case, and notes where they have values.
struct Reader<'a> {
    bindings: &'a Bindings,
    variables: Vec<&'a str>,
    conditions: Vec<(Term, Compared)>,
    all: Vec<Literal<Formula>>,
}

/// A property, and what `where` says, as clauses; `None` where they have not that form.
pub(crate) fn clauses(bindings: &Bindings, restriction: Option<&Node>, property: &Node) -> Option<Clauses> {
    let several = |value: &Value| value.is_interval() || matches!(value, Value::Integers(..));
    let variables: Vec<&str> = bindings.iter().filter(|(_, value)| several(value)).map(|(name, _)| name).collect();
    let mut reader = Reader { bindings, variables, conditions: Vec::new(), all: Vec::new() };
    let mut all = reader.property(property, true)?;
    if let Some(restriction) = restriction {
        all = either(&[reader.property(restriction, false)?, all])?;
    }
    // A literal that is true whatever happens makes its clause true.
    all.retain(|clause| !clause.iter().any(|literal| constant(literal) == Some(true)));
    all.iter_mut().for_each(|clause| clause.retain(|literal| constant(literal).is_none()));
    Some(Clauses { list: all, conditions: reader.all })
}

fn constant(literal: &Literal<Formula>) -> Option<bool> {
    use arithmetic::Signed as _;
    let sign = literal.function.term.as_number()?.sign()?;
    Some(literal.compared.admits(sign))
}

/// Of lists of clauses that all have to hold, one list: clauses that hold where one of the lists does.
fn either(lists: &[Vec<Clause>]) -> Option<Vec<Clause>> {
    let mut all: Vec<Clause> = vec![Vec::new()];
    for list in lists {
        all = all
            .iter()
            .flat_map(|clause| list.iter().map(move |other| [clause.clone(), other.clone()].concat()))
            .collect();
        if all.len() > MOST_CLAUSES || all.iter().any(|clause| clause.len() > MOST_LITERALS) {
            return None;
        }
    }
    Some(all)
}

impl Reader<'_> {
    fn property(&mut self, node: &Node, positive: bool) -> Option<Vec<Clause>> {
        let lists = |reader: &mut Self, nodes: &[(&Node, bool)]| {
            nodes.iter().map(|(node, positive)| reader.property(node, *positive)).collect::<Option<Vec<_>>>()
        };
        let parts: Vec<(&Node, bool)> = match &node.kind {
            Kind::Not(body) => return self.property(body, !positive),
            Kind::And(nodes) | Kind::Or(nodes) => nodes.iter().map(|node| (node, positive)).collect(),
            Kind::Implies(first, second) => vec![(first, !positive), (second, positive)],
            Kind::Relation(first, others) => return self.chain(first, others, positive),
            _ => return None,
        };
        let all = lists(self, &parts)?;
        let together = matches!(node.kind, Kind::And(_)) == positive;
        let joined = if together { Some(all.concat()) } else { either(&all) };
        joined.filter(|clauses| clauses.len() <= MOST_CLAUSES)
    }

    fn chain(&mut self, first: &Node, others: &[(Relation, Node)], positive: bool) -> Option<Vec<Clause>> {
        let mut links = Vec::new();
        let mut left = first;
        for (relation, right) in others {
            let relation = if positive { *relation } else { relation.turned() };
            links.push(self.link(left, relation, right)?);
            left = right;
        }
        if positive { Some(links.concat()) } else { either(&links) }
    }

    /// A comparison with the conditions under which both sides have values.
    fn link(&mut self, left: &Node, relation: Relation, right: &Node) -> Option<Vec<Clause>> {
        self.conditions.clear();
        let (a, b) = (self.term(left)?, self.term(right)?);
        let difference = |a: Term, b: Term| sum(vec![a, negated(b)]);
        let (term, compared) = match relation {
            Relation::Less => (difference(b, a), Compared::Positive),
            Relation::AtMost => (difference(b, a), Compared::NotNegative),
            Relation::Greater => (difference(a, b), Compared::Positive),
            Relation::AtLeast => (difference(a, b), Compared::NotNegative),
            Relation::Equal => (difference(a, b), Compared::Zero),
            Relation::Different => (difference(a, b), Compared::NotZero),
        };
        let literal =
            |(term, compared)| Literal { function: Formula { term: Arc::new(term) }, compared, guarded: true };
        let conditions: Vec<_> = std::mem::take(&mut self.conditions).into_iter().map(literal).collect();
        self.all.extend(conditions.clone());
        Some(conditions.into_iter().chain([literal((term, compared))]).map(|own| vec![own]).collect())
    }

    fn condition(&mut self, term: &Term, compared: Compared) {
        let known = match term {
            Term::Number(q) => arithmetic::Signed::sign(q).is_some_and(|sign| compared.admits(sign)),
            _ => false,
        };
        if !known && !self.conditions.iter().any(|own| own.0 == *term && own.1 == compared) {
            self.conditions.push((term.clone(), compared));
        }
    }

    fn term(&mut self, node: &Node) -> Option<Term> {
        match &node.kind {
            Kind::Number(q) => Some(Term::Number(q.clone())),
            Kind::Negated(body) => Some(negated(self.term(body)?)),
            Kind::Sum(terms) => {
                let one = |(minus, node): &(bool, Node)| {
                    let term = self.term(node)?;
                    Some(if *minus { negated(term) } else { term })
                };
                terms.iter().map(one).collect::<Option<Vec<_>>>().map(sum)
            }
            Kind::Product(factors) => {
                let one = |(divides, node): &(bool, Node)| {
                    let term = self.term(node)?;
                    if *divides { self.reciprocal(term) } else { Some(term) }
                };
                factors.iter().map(one).collect::<Option<Vec<_>>>().map(product)
            }
            Kind::Power(base, exponent) => {
                let (base, exponent) = (self.term(base)?, self.term(exponent)?);
                self.power(base, exponent)
            }
            Kind::Name { name, called: false, .. } if name != "pi" => match self.bindings.get(name)? {
                Value::Number(q) => Some(Term::Number(q.clone())),
                _ => self.variables.iter().position(|own| own == name).map(Term::Variable),
            },
            Kind::Name { name, arguments, .. } => {
                let terms = arguments.iter().map(|node| self.term(node)).collect::<Option<Vec<_>>>()?;
                self.call(name, terms)
            }
            _ => None,
        }
    }

    fn reciprocal(&mut self, term: Term) -> Option<Term> {
        if let Some(q) = term.as_number() {
            return (!q.is_zero()).then(|| Term::Number(q.recip()));
        }
        self.condition(&term, Compared::NotZero);
        Some(Term::Reciprocal(Arc::new(term)))
    }

    /// Whether a term is above 0 on all of the domain, by its enclosure.
    fn is_positive(&self, term: &Term) -> bool {
        const BITS: u32 = 64;
        let side = |name: &&str| {
            let range = self.bindings.get(name)?.ends()?;
            Some(Interval::hull_of_rationals(&range.lo, &range.hi, BITS))
        };
        let Some(at) = self.variables.iter().map(side).collect::<Option<Vec<Interval>>>() else { return false };
        let one = Interval::from_rational(&rational(1, 1), BITS);
        term.value(&at, &one).is_ok_and(|value| value.to_rationals().0.is_positive())
    }

    fn power(&mut self, base: Term, exponent: Term) -> Option<Term> {
        const LARGEST: u64 = 64;
        let call = |function: Elementary, term: Term| Term::Call(function, Arc::new(term));
        let Some(q) = exponent.as_number() else {
            self.condition(&base, Compared::Positive);
            let logarithm = call(Elementary::Logarithm, base);
            return Some(call(Elementary::Exponential, product(vec![exponent, logarithm])));
        };
        let size = q.numer().magnitude().to_u64().filter(|size| *size <= LARGEST)?;
        let root = match q.denom().to_u64()? {
            1 => base,
            degree @ (2 | 4 | 8) => {
                self.condition(&base, Compared::NotNegative);
                (0..degree.trailing_zeros()).fold(base, |root, _| call(Elementary::Root(2), root))
            }
            // Other roots have their value at 0, which the logarithm has not.
            degree if base.as_number().is_none() && self.is_positive(&base) => {
                self.condition(&base, Compared::Positive);
                let share = Term::Number(rational(1, i64::try_from(degree).ok()?));
                call(Elementary::Exponential, product(vec![share, call(Elementary::Logarithm, base)]))
            }
            degree => {
                self.condition(&base, Compared::NotNegative);
                call(Elementary::Root(degree), base)
            }
        };
        let power = match (size, root.as_number()) {
            (0, _) => return None,
            (1, _) => root,
            (_, Some(value)) => Term::Number(arithmetic::Ring::power(value, size)),
            _ => Term::Power(Arc::new(root), size),
        };
        if q.is_negative() { self.reciprocal(power) } else { Some(power) }
    }

    fn call(&mut self, name: &str, mut terms: Vec<Term>) -> Option<Term> {
        let function = match name {
            "pi" if terms.is_empty() => return Some(Term::Pi),
            "min" | "max" if !terms.is_empty() => return Some(Term::Extreme(name == "max", terms)),
            "abs" => return terms.pop().map(|term| Term::Absolute(Arc::new(term))),
            "sqrt" => Elementary::Root(2),
            "exp" => Elementary::Exponential,
            "log" => Elementary::Logarithm,
            "sin" => Elementary::Sine,
            "cos" => Elementary::Cosine,
            _ => return None,
        };
        let term = terms.pop()?;
        match function {
            Elementary::Root(_) => self.condition(&term, Compared::NotNegative),
            Elementary::Logarithm => self.condition(&term, Compared::Positive),
            _ => {}
        }
        Some(Term::Call(function, Arc::new(term)))
    }
}

fn negated(term: Term) -> Term {
    match term {
        Term::Number(q) => Term::Number(-q),
        Term::Negated(body) => body.as_ref().clone(),
        term => Term::Negated(Arc::new(term)),
    }
}

/// With the numbers added.
fn sum(terms: Vec<Term>) -> Term {
    let mut number = rational(0, 1);
    let mut others = Vec::new();
    for term in terms {
        match term {
            Term::Number(q) => number += q,
            Term::Sum(own) => others.extend(own),
            term => others.push(term),
        }
    }
    if !number.is_zero() {
        others.push(Term::Number(number));
    }
    match others.len() {
        0 => Term::Number(rational(0, 1)),
        1 => others.remove(0),
        _ => Term::Sum(others),
    }
}

/// With the numbers multiplied.
fn product(terms: Vec<Term>) -> Term {
    let mut number = rational(1, 1);
    let mut others = Vec::new();
    for term in terms {
        match term {
            Term::Number(q) => number *= q,
            term => others.push(term),
        }
    }
    // Zero times what may be missing is not zero: its conditions are looked at separately.
    if number.is_zero() {
        return Term::Number(number);
    }
    if number != rational(1, 1) {
        others.insert(0, Term::Number(number));
    }
    match others.len() {
        0 => Term::Number(rational(1, 1)),
        1 => others.remove(0),
        _ => Term::Product(others),
    }
}
