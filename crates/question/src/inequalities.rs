//! The inequalities of a property, each by itself under the time operators around it, so that each has a margin of its own.

use crate::syntax::{Kind, Node, Relation};
use arithmetic::rational;

/// Every inequality of a property once, in order, with the time operators around it and nothing else. What stands under `not` or before `implies` is turned
/// round, so that every margin is positive where the inequality speaks for the property. Of `p until[a, b] q`, `p` is looked at up to `a`, and `q` from `a` to
/// `b`.
pub(crate) fn inequalities(property: &Node) -> Vec<Node> {
    let mut found: Vec<Node> = Vec::new();
    let mut texts = std::collections::BTreeSet::new();
    for node in parts(property, true) {
        if texts.insert(node.to_string()) {
            found.push(node);
        }
    }
    found
}

fn parts(node: &Node, positive: bool) -> Vec<Node> {
    let like = |kind: Kind| Node { kind, at: node.at };
    let timed = |always: bool, from: &Node, to: &Node, body: &Node| -> Vec<Node> {
        let within = |body: Node| like(Kind::Always(always, Box::new([from.clone(), to.clone(), body])));
        parts(body, positive).into_iter().map(within).collect()
    };
    match &node.kind {
        Kind::Not(body) => parts(body, !positive),
        Kind::And(list) | Kind::Or(list) => list.iter().flat_map(|node| parts(node, positive)).collect(),
        Kind::Implies(first, second) => [parts(first, !positive), parts(second, positive)].concat(),
        Kind::Always(always, all) => {
            let [from, to, body] = all.as_ref();
            // Not always is eventually not.
            timed(*always == positive, from, to, body)
        }
        Kind::Until(all) => {
            let [from, to, first, second] = all.as_ref();
            let now = Node { kind: Kind::Number(rational(0, 1)), at: from.at };
            [timed(positive, &now, from, first), timed(!positive, from, to, second)].concat()
        }
        Kind::Relation(first, others) => {
            let lefts = std::iter::once(first.as_ref()).chain(others.iter().map(|(_, right)| right));
            let link = |(left, (relation, right)): (&Node, &(Relation, Node))| {
                let relation = if positive { *relation } else { relation.turned() };
                Node { kind: Kind::Relation(Box::new(left.clone()), vec![(relation, right.clone())]), at: left.at }
            };
            lefts.zip(others).map(link).collect()
        }
        _ => Vec::new(),
    }
}
