//! Graphs up to the names of their vertices.

use super::Graph;
use num_bigint::BigUint;

impl Graph {
    /// One connected graph of each isomorphism class, the first in the order of [`Graph::all`] (1, 1, 2, 6, 21, 112, 853 of
    /// them for the orders 1 to 7; larger orders take more time than anybody has).
    ///
    /// Up to order 7 the whole orbit of each new graph is marked, so the cost is that of the classes times `order!`, plus one
    /// bit for each labelled graph.
    pub fn connected_up_to_isomorphism(order: usize) -> Vec<Graph> {
        const LARGEST_MARKED: usize = 7;
        if order > LARGEST_MARKED {
            let first = |graph: &Graph| graph.isomorphism_code() == code(&graph.edges(), |i| i);
            return Graph::all(order).filter(Graph::is_connected).filter(first).collect();
        }
        let orders: Vec<Vec<usize>> = permutations(order).collect();
        let mut seen = vec![false; 1 << (order * order.saturating_sub(1) / 2)];
        let mut found = Vec::new();
        for (code, graph) in Graph::all(order).enumerate() {
            if seen[code] || !graph.is_connected() {
                continue;
            }
            let edges = graph.edges();
            for names in &orders {
                seen[edges.iter().map(|&(i, j)| 1 << pair_bit(names[i], names[j])).sum::<usize>()] = true;
            }
            found.push(graph);
        }
        found
    }

    /// A number that isomorphic graphs of the same order share and others do not: the least code among all `order!` renamings.
    pub fn isomorphism_code(&self) -> BigUint {
        let edges = self.edges();
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
