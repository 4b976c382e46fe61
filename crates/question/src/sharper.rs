//! The bounds of a property that can be made sharper, one by one, and by how much.

use crate::syntax::{Kind, Node, Relation};
use arithmetic::{Rational, rational};
use num_traits::{Signed, Zero};

/// Makes a bound sharper by a positive number.
type Alteration<'n> = Box<dyn Fn(&Rational) -> Node + 'n>;

/// A bound of a property.
pub(crate) struct Sharper<'n> {
    /// The bound where it decides: after its hypotheses, and where the other parts of its disjunction fail. The margin of this is how much sharper the bound may
    /// be.
    pub alone: Node,
    /// The part of the property in which it stands, with the bound sharper by so much.
    pub by: Alteration<'n>,
}

/// The bounds of a property: those of all parts of conjunctions and disjunctions, of conclusions, and at all times. What a hypothesis says is none, nor is an
/// equation.
pub(crate) fn bounds(node: &Node) -> Vec<Sharper<'_>> {
    let like = move |kind: Kind| Node { kind, at: node.at };
    match &node.kind {
        Kind::And(list) => list.iter().flat_map(bounds).collect(),
        Kind::Or(list) => {
            let around = move |k: usize, part: Node| {
                like(Kind::Or(
                    list.iter().enumerate().map(|(j, own)| if j == k { &part } else { own }).cloned().collect(),
                ))
            };
            let of_part = move |(k, part)| {
                let others = list.iter().enumerate().filter(|(j, _)| *j != k).map(|(_, own)| own.clone());
                let fail = like(Kind::Not(Box::new(joined(others.collect(), node.at))));
                bounds(part).into_iter().map(move |own| Sharper {
                    alone: like(Kind::Implies(Box::new(fail.clone()), Box::new(own.alone))),
                    by: Box::new(move |by| around(k, (own.by)(by))),
                })
            };
            list.iter().enumerate().flat_map(of_part).collect()
        }
        Kind::Implies(hypothesis, conclusion) => {
            let after = move |conclusion: Node| like(Kind::Implies(hypothesis.clone(), Box::new(conclusion)));
            around(bounds(conclusion), after)
        }
        Kind::Always(true, parts) => {
            let [from, to, body] = parts.as_ref();
            let always = move |body: Node| like(Kind::Always(true, Box::new([from.clone(), to.clone(), body])));
            around(bounds(body), always)
        }
        Kind::Relation(first, others) => {
            let lefts = std::iter::once(first.as_ref()).chain(others.iter().map(|(_, right)| right));
            let bounds = lefts.zip(others).filter_map(move |(left, (relation, right))| {
                let link = move |right: Node| like(Kind::Relation(Box::new(left.clone()), vec![(*relation, right)]));
                let upwards = match relation {
                    Relation::Equal | Relation::Different => return None,
                    Relation::Greater | Relation::AtLeast => true,
                    Relation::Less | Relation::AtMost => false,
                };
                let by: Alteration = Box::new(move |by| link(moved(right, by, upwards)));
                Some(Sharper { alone: link(right.clone()), by })
            });
            bounds.collect()
        }
        _ => Vec::new(),
    }
}

/// The same bounds inside something else.
fn around<'n>(bounds: Vec<Sharper<'n>>, inside: impl Fn(Node) -> Node + Copy + 'n) -> Vec<Sharper<'n>> {
    let within = |own: Sharper<'n>| Sharper { alone: inside(own.alone), by: Box::new(move |by| inside((own.by)(by))) };
    bounds.into_iter().map(within).collect()
}

/// One of several.
fn joined(mut parts: Vec<Node>, at: usize) -> Node {
    match parts.len() {
        1 => parts.remove(0),
        _ => Node { kind: Kind::Or(parts), at },
    }
}

/// An expression plus, or minus, a positive number.
fn moved(node: &Node, by: &Rational, upwards: bool) -> Node {
    let at = node.at;
    let number = Node { kind: Kind::Number(by.clone()), at };
    let mut terms = match &node.kind {
        Kind::Sum(terms) => terms.clone(),
        _ => vec![(false, node.clone())],
    };
    terms.push((!upwards, number));
    Node { kind: Kind::Sum(terms), at }
}

/// The next number above a margin that has two digits behind its first one; 1/100 above 0.
pub(crate) fn just_past(margin: &Rational) -> Rational {
    let ten = rational(10, 1);
    let mut unit = rational(1, 100);
    if margin.is_positive() {
        while margin >= &(&unit * rational(1000, 1)) {
            unit *= &ten;
        }
        while margin < &(&unit * rational(100, 1)) {
            unit *= rational(1, 10);
        }
    }
    let whole = if margin.is_positive() { (margin / &unit).floor() } else { Rational::zero() };
    (whole + rational(1, 1)) * unit
}
