//! Comparisons that hold at one time and go on to hold, because the difference of their sides never falls along the motion: what is attained at the start of every
//! motion of a set, or at all times.

use super::terms::{Terms, difference};
use super::time::{Operator, moving_names, now};
use super::{Evaluator, Judged};
use crate::failure::Failure;
use crate::syntax::{Kind, Node, Relation};
use crate::timeline::{Field, Piece};
use crate::truth::Truth;
use arithmetic::{ArithmeticError, Cancelled, FloatInterval, Number, Rational, Sign, Signed, rational};
use models::double_integrator::Pair;
use num_traits::Zero;
use polynomials::decide::{Decision, Effort, decide};
use polynomials::{Compared, Function, Literal, Settled, Side, Symbolic};
use scenario::Amount;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// A body that says that several comparisons hold.
pub(super) struct Growth<'n> {
    comparisons: Vec<Comparison<'n>>,
    /// What was found on all states.
    known: RefCell<BTreeMap<Question, bool>>,
    /// How many more pieces may be looked at in vain.
    pub left: usize,
    /// The last time at which the body was shown to hold; pieces come in order.
    shown: Option<Rational>,
}

/// Whether a function never falls (or never rises) under the law of some links, whatever the state: of a sum by the address of its node, one of its parts by its number.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Question {
    of: Part,
    up: bool,
    links: Vec<Pair>,
}

/// A node of the body, by its address, and which of the functions that belong to it.
type Part = (usize, usize);

/// The number of the sum that begins with a node.
const WHOLE: usize = usize::MAX;

/// Pieces that are looked at in vain.
const MOST_IN_VAIN: usize = 12;

/// The orders of expansions at the start.
const MOST_ORDERS: usize = 3;

const EVERYWHERE: Effort = Effort { boxes: 100, squares: true, certified: false, conditions: false };
const NEARBY: Effort = Effort { boxes: 20, squares: false, certified: false, conditions: false };
const AT_START: Effort = Effort { boxes: 2000, squares: true, certified: false, conditions: false };

/// The largest functions of which more is done than to enclose them.
const MOST_TERMS: usize = 300;

type Comparison<'n> = (&'n Node, Relation, &'n Node);

/// A term of a difference, with its sign.
type Summand<'n> = (bool, &'n Node);

/// A function has a sign, or one of others is above 0.
struct Clause<'a> {
    function: &'a Symbolic,
    compared: Compared,
    others: &'a [Symbolic],
}

/// A function of the numbers on which it depends.
struct Restricted {
    function: Settled,
    places: Vec<usize>,
    all: usize,
}

impl Function for Restricted {
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        let zero = at.first().ok_or(ArithmeticError::Domain("a variable"))?.zero();
        let mut point = vec![zero; self.all];
        self.places.iter().zip(at).for_each(|(place, x)| point[*place] = x.clone());
        self.function.value(&point)
    }
}

impl<'n> Growth<'n> {
    /// Of a body, or of its negation.
    pub fn of(body: &'n Node, negated: bool) -> Self {
        let mut comparisons = Vec::new();
        let is_clear = collected(body, negated, &mut comparisons);
        comparisons.truncate(if is_clear { comparisons.len() } else { 0 });
        Growth { comparisons, known: RefCell::default(), left: MOST_IN_VAIN, shown: None }
    }

    /// Whether one more piece is looked at.
    pub fn is_worth_while(&self) -> bool {
        self.left > 0 && !self.comparisons.is_empty()
    }

    /// Notes that the body holds at all times of a piece.
    pub fn note(&mut self, piece: &Piece) {
        self.shown.clone_from(&piece.to);
    }
}

/// Of what is no polynomial sums of squares are out of reach, and boxes help little.
fn is_small(function: &Symbolic) -> bool {
    function.is_polynomial() && function.count_of_terms() <= MOST_TERMS
}

fn address(node: &Node) -> usize {
    std::ptr::from_ref(node).addr()
}

/// Comparisons all of which have to hold; false if it is not as simple as that.
fn collected<'n>(node: &'n Node, negated: bool, list: &mut Vec<Comparison<'n>>) -> bool {
    match &node.kind {
        Kind::Not(body) => collected(body, !negated, list),
        Kind::And(nodes) if !negated => nodes.iter().all(|node| collected(node, false, list)),
        Kind::Or(nodes) if negated => nodes.iter().all(|node| collected(node, true, list)),
        Kind::Relation(first, others) if !negated || others.len() == 1 => {
            let mut left = first.as_ref();
            for (relation, right) in others {
                list.push((left, if negated { relation.turned() } else { *relation }, right));
                left = right;
            }
            true
        }
        _ => false,
    }
}

/// The terms of a sum of sums.
fn summands<'n>(node: &'n Node, minus: bool, list: &mut Vec<Summand<'n>>) {
    match &node.kind {
        Kind::Negated(body) => summands(body, !minus, list),
        Kind::Sum(terms) => terms.iter().for_each(|(own, node)| summands(node, minus != *own, list)),
        _ => list.push((minus, node)),
    }
}

/// A piece of time with what is known of it.
struct OnPiece<'a, 'c, 'q> {
    evaluator: &'a Evaluator<'c, 'q>,
    /// With enclosures over the whole piece.
    enclosed: &'a Evaluator<'c, 'q>,
    field: &'a dyn Field,
    /// What the state ranges over at time 0, where the piece begins there.
    start: Option<Vec<Side>>,
    growth: &'a Growth<'a>,
}

impl Operator<'_, '_, '_> {
    /// Whether the body holds at all times of a piece that enclosures leave open, because it holds at the first one and its differences never fall. Time 0 is a piece
    /// of its own, at which differences of starts are looked at.
    pub fn grows(&self, growth: &Growth, piece: &Piece) -> Result<bool, Failure> {
        let (is_start, zero) = (piece.to.as_ref() == Some(&piece.from), piece.from.is_zero());
        let goes_on = growth.shown.as_ref() == Some(&piece.from);
        if growth.comparisons.is_empty() || !(goes_on || is_start && zero) {
            return Ok(false);
        }
        let (Some(field), Ok(moment)) = (self.timeline.field(piece), self.timeline.moment(piece)) else {
            return Ok(false);
        };
        let enclosed = Evaluator { moment: Some(moment.as_ref()), piece: Some(piece), ..*self.evaluator };
        let start = (zero && !is_start).then(|| self.timeline.field(&now())).flatten();
        let start = start.map(|field| field.region().to_vec());
        let on = OnPiece { evaluator: self.evaluator, enclosed: &enclosed, field: field.as_ref(), start, growth };
        for (left, relation, right) in &growth.comparisons {
            let holds = on.is_enclosed(left, *relation, right)?
                || match is_start {
                    true => on.holds_at_start(left, *relation, right)?,
                    false => on.keeps(left, *relation, right)?,
                };
            if !holds {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

impl<'a, 'c, 'q> OnPiece<'a, 'c, 'q> {
    /// Whether enclosures show it; nothing where a side may have no value.
    fn is_enclosed(&self, left: &Node, relation: Relation, right: &Node) -> Result<bool, Failure> {
        let judged: Judged = match (self.enclosed.number(left), self.enclosed.number(right)) {
            (Ok(a), Ok(b)) => Ok(self.enclosed.compared(&a, relation, &b)),
            (Err(failure), _) | (_, Err(failure)) => Err(failure),
        };
        match judged {
            Ok((truth, _)) => Ok(truth == Truth::True),
            Err(Failure::Refused(..) | Failure::Open(_)) => Ok(false),
            Err(stopped) => Err(stopped),
        }
    }

    /// Whether both sides have values at all times of the piece.
    fn have_values(&self, left: &Node, right: &Node) -> bool {
        self.enclosed.number(left).is_ok() && self.enclosed.number(right).is_ok()
    }

    /// Whether it holds for all starts.
    fn holds_at_start(&self, left: &Node, relation: Relation, right: &Node) -> Result<bool, Cancelled> {
        let terms = Terms { evaluator: self.evaluator, formulas: self.field, at_start: true };
        let Some((a, b)) = terms.term(left).zip(terms.term(right)) else { return Ok(false) };
        let (function, compared) = difference(a, relation, b);
        let clause = Clause { function: &function, compared, others: &[] };
        Ok(self.have_values(left, right) && self.is_so(&clause, self.field.region(), AT_START)?)
    }

    /// Whether what holds at the first time holds at all others.
    fn keeps(&self, left: &Node, relation: Relation, right: &Node) -> Result<bool, Cancelled> {
        if !self.have_values(left, right) {
            return Ok(false);
        }
        let sides = [(false, left), (true, right)];
        Ok(match relation {
            Relation::AtLeast | Relation::Greater => self.all_grow(&sides, true)?,
            Relation::AtMost | Relation::Less => self.all_grow(&sides, false)?,
            Relation::Equal | Relation::Different => self.all_grow(&sides, true)? && self.all_grow(&sides, false)?,
        })
    }

    /// Whether nothing in it moves but what is asked for at time 0.
    fn is_still(&self, node: &Node) -> bool {
        let is_initial = |node: &Node| matches!(&node.kind, Kind::Name { name, .. } if name == "initial");
        let (mut at_start, mut is_clear) = (0, true);
        node.visit(&mut |part| {
            if is_initial(part) {
                let mut depth = 0;
                part.visit(&mut |inner| depth += usize::from(is_initial(inner)));
                // What is asked for at time 0 inside such a part would be counted twice.
                is_clear &= depth == 1;
                at_start += moving_names(self.evaluator, part).len();
            }
        });
        is_clear && moving_names(self.evaluator, node).len() == at_start
    }

    /// Whether a sum never falls, or with `up` false never rises: as a whole, or because none of its terms does.
    fn all_grow(&self, parts: &[Summand], up: bool) -> Result<bool, Cancelled> {
        let mut list = Vec::new();
        parts.iter().for_each(|(minus, node)| summands(node, *minus, &mut list));
        list.retain(|(_, node)| !self.is_still(node));
        let Some(first) = parts.first().filter(|_| !list.is_empty()) else { return Ok(true) };
        let terms = self.terms();
        let signed = |(minus, node): &Summand| Some(if *minus { -terms.term(node)? } else { terms.term(node)? });
        let all = || list.iter().map(signed).collect::<Option<Vec<Symbolic>>>()?.into_iter().reduce(|a, b| a + b);
        // Of a single term that is no product the sum is that term.
        let is_more = list.len() > 1 || matches!(list[0].1.kind, Kind::Product(_));
        if let Some(whole) = is_more.then(all).flatten()
            && self.never_falls(&whole, up, (address(first.1), WHOLE), &[])?
        {
            return Ok(true);
        }
        for (minus, node) in list {
            if !self.grows(node, up != minus)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn each_grows(&self, nodes: &[Node], up: bool) -> Result<bool, Cancelled> {
        for node in nodes {
            if !self.all_grow(&[(false, node)], up)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn terms(&self) -> Terms<'a, 'c, 'q, dyn Field + 'a> {
        Terms { evaluator: self.evaluator, formulas: self.field, at_start: false }
    }

    /// Whether a term never falls, or never rises. Roots, minima and maxima do what those numbers do of which they are taken.
    fn grows(&self, node: &Node, up: bool) -> Result<bool, Cancelled> {
        let own = (address(node), 0);
        match &node.kind {
            Kind::Product(factors) => {
                let mut moving = factors.iter().filter(|(_, node)| !self.is_still(node));
                let (Some((false, factor)), None) = (moving.next(), moving.next()) else { return Ok(false) };
                let others = factors.iter().filter(|(_, node)| self.is_still(node));
                let signs = others.map(|(_, node)| self.evaluator.number(node).ok()?.sign());
                let turns =
                    signs.map(|sign| Some(sign? == Sign::Negative)).try_fold(false, |turns, own| Some(turns != own?));
                match turns {
                    Some(turns) => self.grows(factor, up != turns),
                    None => Ok(false),
                }
            }
            Kind::Name { name, arguments, .. } => match (name.as_str(), &arguments[..]) {
                ("sqrt", [_]) => self.each_grows(arguments, up),
                ("min" | "max", [_, _, ..]) => {
                    let terms = self.terms();
                    match arguments.iter().map(|own| terms.term(own)).collect::<Option<Vec<_>>>() {
                        Some(list) if self.extreme_grows(&list, name == "max", up, own.0)? => Ok(true),
                        _ => self.each_grows(arguments, up),
                    }
                }
                ("min_distance", _) => match self.field.squares() {
                    Some(squares) => self.extreme_grows(&squares, false, up, own.0),
                    None => Ok(false),
                },
                _ => match self.terms().amount(name, arguments) {
                    Some(Amount::Number(x) | Amount::Root(x)) => self.never_falls(&x, up, own, &[]),
                    _ => Ok(false),
                },
            },
            _ => self.terms().term(node).map_or(Ok(false), |x| self.never_falls(&x, up, own, &[])),
        }
    }

    /// Whether the largest of some functions, or the least one, never falls: because none of them does where it is the one. (A continuous function whose derivative
    /// to the right is nowhere negative does not fall, and that of a maximum is the largest one of those that attain it.)
    fn extreme_grows(&self, list: &[Symbolic], largest: bool, up: bool, node: usize) -> Result<bool, Cancelled> {
        for (part, own) in list.iter().enumerate() {
            let ahead = |other: &Symbolic| if largest { other.clone() - own } else { own.clone() - other };
            let others = list.iter().enumerate().filter(|(other, _)| *other != part).map(|(_, other)| ahead(other));
            if !self.never_falls(own, up, (node, part), &others.collect::<Vec<_>>())? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether a function of the state never falls, or never rises, in the piece where none of the others is above 0: by the sign of its rate on all states, or on those
    /// of the piece, or by its expansion at the start.
    fn never_falls(&self, function: &Symbolic, up: bool, of: Part, others: &[Symbolic]) -> Result<bool, Cancelled> {
        let Some(rate) = self.rate(function).map(|rate| if up { rate } else { -rate }) else { return Ok(false) };
        let clause = Clause { function: &rate, compared: Compared::NotNegative, others };
        if let Some(sign) = Signed::sign(&rate) {
            return Ok(sign != Sign::Negative);
        }
        let key = Question { of, up, links: self.field.links().to_vec() };
        let known = self.growth.known.borrow().get(&key).copied();
        let everywhere = match known {
            Some(known) => known,
            None => {
                let mut all = vec![Side::line(); self.field.region().len()];
                if let Some(time) = all.last_mut() {
                    time.lo = Some(rational(0, 1));
                }
                let found = is_small(&rate) && self.is_so(&clause, &all, EVERYWHERE)?;
                self.growth.known.borrow_mut().insert(key, found);
                found
            }
        };
        Ok(everywhere || self.is_so_here(&clause)? || self.is_positive_from_start(&rate, 1)?)
    }

    /// Whether a function of the state is never below 0 in a piece that begins with the start, by its expansion there.
    fn is_positive_from_start(&self, function: &Symbolic, order: usize) -> Result<bool, Cancelled> {
        let goes_on = order < MOST_ORDERS && function.count_of_terms() <= MOST_TERMS;
        let Some(start) = self.start.as_ref().filter(|_| goes_on) else { return Ok(false) };
        let Some(rate) = self.rate(function) else { return Ok(false) };
        let of = |function| Clause { function, compared: Compared::NotNegative, others: &[] };
        Ok(self.is_so(&of(function), start, NEARBY)?
            && (self.is_so_here(&of(&rate))? || self.is_positive_from_start(&rate, order + 1)?))
    }

    /// The rate of a function that has one wherever it has a value.
    fn rate(&self, function: &Symbolic) -> Option<Symbolic> {
        function.is_smooth().then(|| function.rate(self.field.rates()).ok()).flatten()
    }

    /// Whether a clause, of a function that is not negative, is true in the piece.
    fn is_so_here(&self, clause: &Clause) -> Result<bool, Cancelled> {
        let least = |function| self.field.least(function);
        if least(clause.function).is_some_and(|least| least >= 0.0)
            || clause.others.iter().any(|other| least(other).is_some_and(|least| least > 0.0))
        {
            return Ok(true);
        }
        Ok(is_small(clause.function) && self.is_so(clause, self.field.region(), NEARBY)?)
    }

    /// Whether a clause is true on a region.
    fn is_so(&self, clause: &Clause, region: &[Side], effort: Effort) -> Result<bool, Cancelled> {
        if let Some(sign) = Signed::sign(clause.function)
            && clause.compared.admits(sign)
        {
            return Ok(true);
        }
        let numbers = |side: &Side| {
            let end = |end: &Option<Rational>| end.as_ref().map(FloatInterval::from_rational);
            Some(end(&side.lo)?.hull(&end(&side.hi)?))
        };
        let numbers: Option<Vec<FloatInterval>> = region.iter().map(numbers).collect();
        let enclosed = numbers.and_then(|numbers| clause.function.value(&numbers).ok());
        if clause.compared == Compared::NotNegative && enclosed.is_some_and(|enclosed| enclosed.lo() >= 0.0) {
            return Ok(true);
        }
        let mut places = clause.function.depends_on();
        places.extend(clause.others.iter().flat_map(Symbolic::depends_on));
        places.sort_unstable();
        places.dedup();
        let Some(domain) = places.iter().map(|place| region.get(*place).cloned()).collect::<Option<Vec<Side>>>() else {
            return Ok(false);
        };
        // A common denominator of many distances is out of reach.
        let is_large = |own: &Symbolic| own.count_of_terms() > MOST_TERMS || own.has_divisors();
        if domain.is_empty() || is_large(clause.function) || clause.others.iter().any(is_large) {
            return Ok(false);
        }
        // It has a value at all states of the motion, where it is asked for.
        let literal = |function: &Symbolic, compared| {
            let function = Restricted { function: function.settled(), places: places.clone(), all: region.len() };
            Literal { function, compared, guarded: true }
        };
        let others = clause.others.iter().map(|other| literal(other, Compared::Positive));
        let literals: Vec<_> = std::iter::once(literal(clause.function, clause.compared)).chain(others).collect();
        let found = decide(&literals, &domain, effort, self.evaluator.case.progress())?;
        Ok(matches!(found, Decision::Holds(_)))
    }
}
