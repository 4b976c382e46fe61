//! Directed graphs with rational weights.

use super::Graph;
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
