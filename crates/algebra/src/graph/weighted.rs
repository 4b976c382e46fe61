//! Directed graphs with rational weights.

use super::{Graph, all_choices};
use crate::matrix::SparseMatrix;
use arithmetic::{Rational, rational};

/// A directed graph on the vertices `0..order`: the arc from `i` to `j` has the weight `a_ij`, "`i` senses `j`
/// with weight `a_ij`". An undirected graph has `a_ij = a_ji`. Weights may be negative, and loops are allowed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WeightedGraph {
    adjacency: SparseMatrix,
}

impl From<SparseMatrix> for WeightedGraph {
    /// The graph with this matrix of weights.
    fn from(adjacency: SparseMatrix) -> Self {
        WeightedGraph { adjacency }
    }
}

impl From<&Graph> for WeightedGraph {
    /// Weight 1 on every edge, in both directions.
    fn from(graph: &Graph) -> Self {
        let arcs = graph.edges().into_iter().flat_map(|(i, j)| [(i, j), (j, i)]);
        WeightedGraph::from_arcs(graph.order(), arcs.map(|(i, j)| (i, j, rational(1, 1))))
    }
}

impl WeightedGraph {
    /// The graph with these arcs `(i, j, a_ij)`; weights of the same arc are added, arcs to vertices that are not there
    /// are left out.
    pub fn from_arcs(order: usize, arcs: impl IntoIterator<Item = (usize, usize, Rational)>) -> Self {
        WeightedGraph { adjacency: SparseMatrix::from_entries(order, arcs) }
    }

    /// Weight 1 on the arc from `k` to `j != k` where `joined(k, j)`.
    pub fn from_fn(order: usize, joined: impl Fn(usize, usize) -> bool) -> Self {
        let pairs = (0..order).flat_map(|k| (0..order).map(move |j| (k, j)));
        let arcs = pairs.filter(|&(k, j)| k != j && joined(k, j));
        WeightedGraph::from_arcs(order, arcs.map(|(k, j)| (k, j, rational(1, 1))))
    }

    /// Weight 1 on all arcs between different vertices.
    pub fn complete(order: usize) -> Self {
        WeightedGraph::from_fn(order, |_, _| true)
    }

    /// All `2^(order (order - 1))` labelled digraphs without loops, with weight 1 on every arc.
    pub fn all(order: usize) -> impl Iterator<Item = WeightedGraph> {
        let others = order.saturating_sub(1);
        // The arc from k to j is bit k (order - 1) + j of all arcs, less one where j > k.
        let bit = move |k: usize, j: usize| k * others + if j > k { j - 1 } else { j };
        all_choices(order * others).map(move |bits| WeightedGraph::from_fn(order, |k, j| bits[bit(k, j)]))
    }

    /// The circulant digraphs, each with its offsets `s`, `0 < s < order`: there is an arc from `k` to `k + s` modulo the order. With
    /// `undirected` those whose offsets are symmetric.
    pub fn circulants(order: usize, undirected: bool) -> impl Iterator<Item = (Vec<usize>, WeightedGraph)> {
        let offsets = move |bits: Vec<bool>| (1..order).filter(|s| bits[s - 1]).collect::<Vec<usize>>();
        let symmetric = move |offsets: &Vec<usize>| offsets.iter().all(|s| offsets.contains(&(order - s)));
        let all = all_choices(order.saturating_sub(1)).map(offsets);
        all.filter(move |offsets| !undirected || symmetric(offsets)).map(move |offsets| {
            let graph = WeightedGraph::from_fn(order, |k, j| offsets.contains(&((j + order - k) % order)));
            (offsets, graph)
        })
    }

    /// Number of vertices.
    pub fn order(&self) -> usize {
        self.adjacency.order()
    }

    /// The matrix of the weights `a_ij`.
    pub fn adjacency(&self) -> &SparseMatrix {
        &self.adjacency
    }

    /// Whether `a_ij = a_ji` throughout.
    pub fn is_undirected(&self) -> bool {
        self.adjacency.is_symmetric()
    }

    /// The row sums `sum_j a_ij`: how much account each vertex takes of others.
    pub fn out_degrees(&self) -> Vec<Rational> {
        self.adjacency.row_sums()
    }

    /// The column sums `sum_j a_ji`.
    pub fn in_degrees(&self) -> Vec<Rational> {
        self.adjacency.transpose().row_sums()
    }

    /// Whether every vertex can be reached from every other along arcs (and there is one).
    pub fn is_strongly_connected(&self) -> bool {
        self.adjacency.strong_components().len() == 1
    }
}
