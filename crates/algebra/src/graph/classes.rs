//! One graph of each isomorphism class: all graphs, connected ones, trees, digraphs.
//!
//! Every graph of order `n` has a vertex of the largest key (degree, then the degrees of its neighbours), and what is left without it is
//! isomorphic to one of the classes of order `n - 1`. So each class is found by joining a vertex of largest key to a class of order
//! `n - 1`; those found twice are told apart by a canonical form.

use super::{Graph, WeightedGraph};
use arithmetic::threads::map;
use arithmetic::{Cancelled, Progress, rational};
use std::collections::BTreeSet;

/// Largest order of [`graphs`] and [`connected_graphs`].
pub const LARGEST_CLASSES: usize = 9;
/// Largest order of [`bipartite_graphs`] and [`regular_graphs`]: the code of a graph has 128 bits.
pub const LARGEST_SPARSE_CLASSES: usize = 11;
/// Largest order of [`digraphs`].
pub const LARGEST_DIGRAPH_CLASSES: usize = 5;
/// Largest order of [`trees`].
pub const LARGEST_TREE_CLASSES: usize = 18;

/// More vertices than any class has here.
const LARGEST: usize = 16;

/// Arcs as sets of bits: bit `j` of `out[i]` is the arc from `i` to `j`.
#[derive(Clone)]
struct Arcs {
    out: Vec<u16>,
    into: Vec<u16>,
}

impl Arcs {
    fn new(out: Vec<u16>) -> Self {
        let column = |j: usize| (0..out.len()).filter(|&i| out[i] >> j & 1 == 1).map(|i| 1 << i).sum();
        let into = (0..out.len()).map(column).collect();
        Arcs { out, into }
    }

    /// The graph with one more vertex and the arcs from and to it.
    fn joined(&self, from: u16, to: u16) -> Self {
        let new = self.out.len();
        let mut out = self.out.clone();
        out.iter_mut().enumerate().for_each(|(i, row)| *row |= (to >> i & 1) << new);
        out.push(from);
        let mut into = self.into.clone();
        into.iter_mut().enumerate().for_each(|(i, row)| *row |= (from >> i & 1) << new);
        into.push(to);
        Arcs { out, into }
    }

    fn count(&self) -> u32 {
        self.out.iter().map(|row| row.count_ones()).sum()
    }

    fn degree(&self, v: usize) -> u32 {
        self.out[v].count_ones() + self.into[v].count_ones()
    }

    /// What isomorphic vertices share: degree, out-degree, the degrees of the neighbours.
    fn key(&self, v: usize) -> (u32, u32, u32) {
        let around = bits(self.out[v]).chain(bits(self.into[v])).map(|v| self.degree(v)).sum();
        (self.degree(v), self.out[v].count_ones(), around)
    }

    /// Whether the last vertex has the largest key.
    fn last_is_largest(&self) -> bool {
        let last = self.out.len() - 1;
        let (degree, largest) = (self.degree(last), self.key(last));
        let exceeds = |v: usize| {
            let other = self.degree(v);
            other > degree || (other == degree && self.key(v) > largest)
        };
        !(0..last).any(exceeds)
    }

    /// Whether exchanging the two vertices changes nothing.
    fn are_twins(&self, u: usize, v: usize) -> bool {
        let swap = |row: u16| {
            let (a, b) = (row >> u & 1, row >> v & 1);
            row & !(1 << u) & !(1 << v) | a << v | b << u
        };
        swap(self.out[u]) == self.out[v] && swap(self.into[u]) == self.into[v]
    }

    /// Refines colours until vertices of one colour have equally many neighbours of each colour. The names of the vertices play no part.
    fn refine(&self, colours: &mut [u8]) -> usize {
        let mut known = 0;
        let (mut all, mut sorted) = ([(0, 0, 0); LARGEST], [0; LARGEST]);
        let (keys, order) = (&mut all[..colours.len()], &mut sorted[..colours.len()]);
        loop {
            let counted = |row: u16| bits(row).fold(0u64, |sum, j| sum + (1 << (5 * colours[j])));
            for (v, key) in keys.iter_mut().enumerate() {
                *key = (colours[v], counted(self.out[v]), counted(self.into[v]));
                order[v] = v;
            }
            order.sort_unstable_by_key(|&v| keys[v]);
            let mut colour = 0;
            for (place, &v) in order.iter().enumerate() {
                colour += u8::from(place > 0 && keys[order[place - 1]] != keys[v]);
                colours[v] = colour;
            }
            let found = usize::from(colour) + usize::from(!order.is_empty());
            if found == known {
                return known;
            }
            known = found;
        }
    }

    /// The least code among all orders of the vertices that the colours leave open.
    fn least_code(&self, mut colours: Vec<u8>, best: &mut u128) {
        let size = colours.len();
        if self.refine(&mut colours) == size {
            let mut place = vec![0; size];
            colours.iter().enumerate().for_each(|(v, &colour)| place[usize::from(colour)] = v);
            let row = |i: usize| bits(self.out[place[i]]).map(|j| 1u128 << (i * size + usize::from(colours[j]))).sum();
            *best = (*best).min((0..size).map(row).fold(0, |a: u128, b: u128| a | b));
            return;
        }
        let several = |colour: u8| colours.iter().filter(|&&c| c == colour).count() > 1;
        let Some(open) = (0..size as u8).find(|&colour| several(colour)) else { return };
        let cell: Vec<usize> = (0..size).filter(|&v| colours[v] == open).collect();
        for (k, &v) in cell.iter().enumerate() {
            if !cell[..k].iter().any(|&u| self.are_twins(u, v)) {
                let mut next: Vec<u8> = colours.iter().map(|c| 2 * c + 1).collect();
                next[v] -= 1;
                // Colours stay below the order, so that counts of five bits fit.
                let mut ranks = next.clone();
                ranks.sort_unstable();
                ranks.dedup();
                next.iter_mut().for_each(|c| *c = ranks.binary_search(c).unwrap_or_default() as u8);
                self.least_code(next, best);
            }
        }
    }

    fn code(&self) -> u128 {
        let mut best = u128::MAX;
        self.least_code(vec![0; self.out.len()], &mut best);
        best
    }

    /// The undirected graph, where there is an arc back for each.
    fn graph(&self) -> Graph {
        Graph::from_fn(self.out.len(), |i, j| self.out[i] >> j & 1 == 1)
    }

    fn from_code(order: usize, code: u128) -> Self {
        let mask = (1u128 << order) - 1;
        Arcs::new((0..order).map(|i| (code >> (i * order) & mask) as u16).collect())
    }
}

fn bits(mut set: u16) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let first = (set != 0).then(|| set.trailing_zeros() as usize)?;
        set &= set - 1;
        Some(first)
    })
}

/// The classes of an order, by the number of arcs and then the code; from those of the order before. `kept` says which are wanted: with a graph it has to
/// keep what is left of it without any one vertex.
fn classes(
    order: usize,
    directed: bool,
    kept: impl Fn(&Arcs) -> bool + Sync,
    progress: &dyn Progress,
) -> Result<Vec<Arcs>, Cancelled> {
    let mut found = vec![Arcs::new(Vec::new())];
    for size in 1..=order {
        let children = |parent: &Arcs| {
            progress.checkpoint()?;
            let mut codes = Vec::new();
            let degrees: Vec<u32> = (0..size - 1).map(|v| parent.degree(v)).collect();
            for from in 0..1u16 << (size - 1) {
                let into = if directed { 0..1u16 << (size - 1) } else { from..from + 1 };
                for to in into {
                    // Most are told apart by degrees alone, before they are made.
                    let joins = |v: usize| u32::from(from >> v & 1) + u32::from(to >> v & 1);
                    let own = from.count_ones() + to.count_ones();
                    if degrees.iter().enumerate().any(|(v, degree)| degree + joins(v) > own) {
                        continue;
                    }
                    let graph = parent.joined(from, to);
                    if graph.last_is_largest() && kept(&graph) {
                        codes.push((graph.count(), graph.code()));
                    }
                }
            }
            Ok(codes)
        };
        let codes: Vec<Vec<(u32, u128)>> =
            map(found.len(), |k| children(&found[k])).into_iter().collect::<Result<_, Cancelled>>()?;
        let mut codes = codes.concat();
        codes.sort_unstable();
        codes.dedup();
        found = codes.into_iter().map(|(_, code)| Arcs::from_code(size, code)).collect();
    }
    Ok(found)
}

/// One graph of each class of this order (1, 2, 4, 11, 34, 156, 1044, 12346, 274668 for 1 to 9), those with few edges first; none for
/// orders above [`LARGEST_CLASSES`].
///
/// # Errors
/// [`Cancelled`].
pub fn graphs(order: usize, progress: &dyn Progress) -> Result<Vec<Graph>, Cancelled> {
    undirected(order, LARGEST_CLASSES, |_| true, progress)
}

fn undirected(
    order: usize,
    most: usize,
    kept: impl Fn(&Arcs) -> bool + Sync,
    progress: &dyn Progress,
) -> Result<Vec<Graph>, Cancelled> {
    if order > most {
        return Ok(Vec::new());
    }
    Ok(classes(order, false, kept, progress)?.iter().map(Arcs::graph).collect())
}

/// One bipartite graph of each class of this order, connected or not (1, 2, 3, 7, 13, 35, 88, 303, 1119, 5479, 32303 for 1 to 11); none for orders above
/// [`LARGEST_SPARSE_CLASSES`].
///
/// # Errors
/// [`Cancelled`].
pub fn bipartite_graphs(order: usize, progress: &dyn Progress) -> Result<Vec<Graph>, Cancelled> {
    undirected(order, LARGEST_SPARSE_CLASSES, |arcs| arcs.graph().is_bipartite(), progress)
}

/// One planar graph of each class of this order, connected or not (1, 2, 4, 11, 33, 142, 822, 6966, 79853 for 1 to 9); none for orders above
/// [`LARGEST_CLASSES`].
///
/// # Errors
/// [`Cancelled`].
pub fn planar_graphs(order: usize, progress: &dyn Progress) -> Result<Vec<Graph>, Cancelled> {
    undirected(order, LARGEST_CLASSES, |arcs| arcs.graph().is_planar(), progress)
}

/// One graph of each class of this order whose vertices all have so many neighbours, connected or not (of degree 3: 1, 2, 6, 21 for 4, 6, 8, 10); none for
/// orders above [`LARGEST_SPARSE_CLASSES`].
///
/// # Errors
/// [`Cancelled`].
pub fn regular_graphs(order: usize, degree: usize, progress: &dyn Progress) -> Result<Vec<Graph>, Cancelled> {
    if degree >= order || (order * degree) % 2 == 1 {
        return Ok(Vec::new());
    }
    // Of a graph and its complement that with fewer edges.
    let least = degree.min(order - 1 - degree);
    // Each vertex that is still missing gives every other one neighbour at most.
    let kept = |arcs: &Arcs| {
        let missing = order - arcs.out.len();
        arcs.out.iter().map(|row| row.count_ones() as usize).all(|own| own <= least && own + missing >= least)
    };
    let found = undirected(order, LARGEST_SPARSE_CLASSES, kept, progress)?;
    let turned =
        |graph: Graph| if least == degree { graph } else { Graph::from_fn(order, |i, j| !graph.has_edge(i, j)) };
    Ok(found.into_iter().map(turned).collect())
}

/// One connected graph of each class of this order (1, 1, 2, 6, 21, 112, 853, 11117, 261080 for 1 to 9).
///
/// # Errors
/// [`Cancelled`].
pub fn connected_graphs(order: usize, progress: &dyn Progress) -> Result<Vec<Graph>, Cancelled> {
    Ok(graphs(order, progress)?.into_iter().filter(Graph::is_connected).collect())
}

/// One digraph without loops of each class of this order (1, 3, 16, 218, 9608 for 1 to 5), all weights 1; none for orders above
/// [`LARGEST_DIGRAPH_CLASSES`].
///
/// # Errors
/// [`Cancelled`].
pub fn digraphs(order: usize, progress: &dyn Progress) -> Result<Vec<WeightedGraph>, Cancelled> {
    if order > LARGEST_DIGRAPH_CLASSES {
        return Ok(Vec::new());
    }
    let graph = |arcs: Arcs| {
        let list = (0..order).flat_map(|i| bits(arcs.out[i]).map(move |j| (i, j, rational(1, 1))).collect::<Vec<_>>());
        WeightedGraph::from_arcs(order, list)
    };
    Ok(classes(order, true, |_| true, progress)?.into_iter().map(graph).collect())
}

/// One tree of each class of this order (1, 1, 1, 2, 3, 6, 11, 23, 47 for 1 to 9); none for orders above [`LARGEST_TREE_CLASSES`].
///
/// # Errors
/// [`Cancelled`].
pub fn trees(order: usize, progress: &dyn Progress) -> Result<Vec<Graph>, Cancelled> {
    if order == 0 || order > LARGEST_TREE_CLASSES {
        return Ok(Vec::new());
    }
    // Depths in the order of a walk through the tree from its root: those of the first vertex of a centre.
    let mut found: BTreeSet<Vec<u8>> = BTreeSet::from([vec![0]]);
    for size in 2..=order {
        let mut next = BTreeSet::new();
        for depths in &found {
            progress.checkpoint()?;
            let parents = parents(depths);
            for at in 0..size - 1 {
                let mut list = parents.clone();
                list.push(at);
                next.insert(canonical_depths(&list));
            }
        }
        found = next;
    }
    let graph = |depths: &Vec<u8>| {
        let parents = parents(depths);
        Graph::from_fn(order, |i, j| parents[j] == i)
    };
    Ok(found.iter().map(graph).collect())
}

/// The parent of each vertex of a walk; the root is its own.
fn parents(depths: &[u8]) -> Vec<usize> {
    let parent = |v: usize| depths[..v].iter().rposition(|&depth| depth + 1 == depths[v]).unwrap_or(v);
    (0..depths.len()).map(parent).collect()
}

/// The largest list of depths from the centre, or from either of two.
fn canonical_depths(parents: &[usize]) -> Vec<u8> {
    let size = parents.len();
    let mut around = vec![Vec::new(); size];
    for (v, &p) in parents.iter().enumerate().filter(|(v, p)| v != *p) {
        around[v].push(p);
        around[p].push(v);
    }
    let mut degree: Vec<usize> = around.iter().map(Vec::len).collect();
    let mut left = size;
    let mut leaves: Vec<usize> = (0..size).filter(|&v| degree[v] <= 1).collect();
    while left > 2 {
        left -= leaves.len();
        let mut next = Vec::new();
        for leaf in leaves {
            for &v in &around[leaf] {
                degree[v] -= 1;
                if degree[v] == 1 {
                    next.push(v);
                }
            }
        }
        leaves = next;
    }
    leaves.into_iter().map(|root| depths_from(&around, root, root, 0)).max().unwrap_or_default()
}

fn depths_from(around: &[Vec<usize>], v: usize, parent: usize, depth: u8) -> Vec<u8> {
    let below = around[v].iter().filter(|&&w| w != parent);
    let mut branches: Vec<Vec<u8>> = below.map(|&w| depths_from(around, w, v, depth + 1)).collect();
    branches.sort_unstable_by(|a, b| b.cmp(a));
    std::iter::once(depth).chain(branches.into_iter().flatten()).collect()
}

#[cfg(test)]
mod tests;
