//! Graphs up to the names of their vertices.

use super::classes::connected_graphs;
use super::{AnyGraph, Graph, WeightedGraph};
use arithmetic::{Unwatched, rational};
use num_bigint::BigUint;
use std::collections::BTreeSet;

/// Largest order of which all pairs are bits of 128.
const LARGEST_IN_A_WORD: usize = 16;

impl AnyGraph {
    /// The graphs, without weights, that this one is with other names of its vertices, each once and with its own names first: `order!` over the number of
    /// automorphisms. Costs `order!` renamings.
    pub fn labellings(&self) -> Vec<AnyGraph> {
        let (order, arcs, is_directed) = (self.order(), self.arcs(), self.is_directed());
        let mut seen = BTreeSet::new();
        let renamed = permutations(order).filter_map(|names| {
            let mut renamed: Vec<(usize, usize)> = arcs.iter().map(|&(i, j)| (names[i], names[j])).collect();
            renamed.sort_unstable();
            seen.insert(renamed.clone()).then_some(renamed)
        });
        let graph = |arcs: Vec<(usize, usize)>| match is_directed {
            true => {
                let arcs = arcs.into_iter().map(|(i, j)| (i, j, rational(1, 1)));
                AnyGraph::Directed(WeightedGraph::from_arcs(order, arcs))
            }
            false => AnyGraph::Simple(Graph::from_fn(order, |i, j| arcs.binary_search(&(i, j)).is_ok())),
        };
        renamed.map(graph).collect()
    }
}

impl Graph {
    /// One connected graph of each isomorphism class, the first in the order of [`Graph::all`], and in that order (1, 1, 2, 6, 21, 112, 853 of
    /// them for the orders 1 to 7); none for orders above [`LARGEST_CLASSES`](super::classes::LARGEST_CLASSES).
    ///
    /// The classes are those of [`connected_graphs`]; finding the first of each costs `order!` renamings.
    pub fn connected_up_to_isomorphism(order: usize) -> Vec<Graph> {
        // Nobody stops it.
        let classes = connected_graphs(order, &Unwatched).unwrap_or_default();
        let mut codes: Vec<BigUint> = classes.iter().map(Graph::isomorphism_code).collect();
        codes.sort_unstable();
        codes.iter().map(|code| Graph::from_fn(order, |i, j| code.bit(pair_bit(i, j) as u64))).collect()
    }

    /// A number that isomorphic graphs of the same order share and others do not: the least code among all `order!` renamings.
    pub fn isomorphism_code(&self) -> BigUint {
        let edges = self.edges();
        if self.order() <= LARGEST_IN_A_WORD {
            let code =
                |names: Vec<usize>| edges.iter().map(|&(i, j)| 1u128 << pair_bit(names[i], names[j])).sum::<u128>();
            return permutations(self.order()).map(code).min().map(BigUint::from).unwrap_or_default();
        }
        permutations(self.order()).map(|names| code(&edges, |i| names[i])).min().unwrap_or_default()
    }
}

/// The number of a graph in the order of [`Graph::all`] after a renaming.
fn code(edges: &[(usize, usize)], name: impl Fn(usize) -> usize) -> BigUint {
    let mut code = BigUint::ZERO;
    edges.iter().for_each(|&(i, j)| code.set_bit(pair_bit(name(i), name(j)) as u64, true));
    code
}

/// The place of the bit of a pair in the numbering of [`Graph::all`].
fn pair_bit(i: usize, j: usize) -> usize {
    i.max(j) * (i.max(j) - 1) / 2 + i.min(j)
}

/// All orders of `0..count`, one after the other in lexicographic order.
fn permutations(count: usize) -> impl Iterator<Item = Vec<usize>> {
    let mut next = Some((0..count).collect::<Vec<usize>>());
    std::iter::from_fn(move || {
        let current = next.take()?;
        next = following(current.clone());
        Some(current)
    })
}

/// The next order in lexicographic order: the last rise is raised by as little as possible, and what comes after it is put in order.
fn following(mut order: Vec<usize>) -> Option<Vec<usize>> {
    let rise = order.windows(2).rposition(|pair| pair[0] < pair[1])?;
    let larger = order.iter().rposition(|&x| x > order[rise])?;
    order.swap(rise, larger);
    order[rise + 1..].reverse();
    Some(order)
}
