//! Graphs: undirected simple ones, which the flocking networks are made of, and directed ones with rational weights.

mod arc_list;
pub mod classes;
mod components;
mod isomorphism;
mod laplacian;
mod named;
pub mod read;
mod weighted;

pub use arc_list::ArcList;
pub use components::{component_numbers, components};
pub use laplacian::{LaplacianError, LaplacianKind};
pub use named::{LARGEST_ORDER, NameError, NamedGraph};
pub use weighted::WeightedGraph;

use crate::matrix::{Footprint, MatrixError, RationalMatrix};
use arithmetic::{Rational, words};
use num_bigint::BigInt;

/// An undirected graph without loops on the vertices `0..order`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Graph {
    adjacency: Footprint,
}

/// All choices among so many things, as binary numbers that count up, lowest bit first.
fn all_choices(count: usize) -> impl Iterator<Item = Vec<bool>> {
    words(2, count).map(|word| word.into_iter().map(|letter| letter == 1).collect())
}

/// Why a list of edges is not a simple graph. Vertices are counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum GraphError {
    /// An edge names a vertex that is not there.
    #[error("vertex {vertex} is not one of the {order} vertices")]
    NoSuchVertex {
        /// The vertex named.
        vertex: usize,
        /// Number of vertices.
        order: usize,
    },
    /// An edge from a vertex to itself.
    #[error("the edge from vertex {0} to itself is not allowed")]
    Loop(usize),
}

impl Graph {
    /// The graph in which `i` and `j > i` are joined where `joined(i, j)`.
    pub fn from_fn(order: usize, joined: impl Fn(usize, usize) -> bool) -> Self {
        Graph { adjacency: Footprint::from_fn(order, order, |i, j| i != j && joined(i.min(j), i.max(j))) }
    }

    /// The graph with these edges.
    ///
    /// # Errors
    /// [`GraphError`].
    pub fn from_edges(order: usize, edges: &[(usize, usize)]) -> Result<Self, GraphError> {
        for &(i, j) in edges {
            if let Some(vertex) = [i, j].into_iter().find(|&v| v >= order) {
                return Err(GraphError::NoSuchVertex { vertex, order });
            }
            if i == j {
                return Err(GraphError::Loop(i));
            }
        }
        Ok(Graph::from_fn(order, |i, j| edges.contains(&(i, j)) || edges.contains(&(j, i))))
    }

    /// The graph without edges.
    pub fn empty(order: usize) -> Self {
        Graph::from_fn(order, |_, _| false)
    }

    /// The path `0 - 1 - ... - (order - 1)`.
    pub fn path(order: usize) -> Self {
        Graph::from_fn(order, |i, j| j == i + 1)
    }

    /// The graph in which all are joined.
    pub fn complete(order: usize) -> Self {
        Graph::from_fn(order, |_, _| true)
    }

    /// The ring `0 - 1 - ... - (order - 1) - 0`; on two vertices one edge, on one none.
    pub fn ring(order: usize) -> Self {
        Graph::from_fn(order, |i, j| j == i + 1 || (i == 0 && j + 1 == order))
    }

    /// The star: vertex 0 is joined to all others.
    pub fn star(order: usize) -> Self {
        Graph::from_fn(order, |i, _| i == 0)
    }

    /// All `2^(order (order - 1)/2)` labelled graphs; nobody lives to see the last of them for `order > 9`.
    pub fn all(order: usize) -> impl Iterator<Item = Graph> {
        // Pair (i, j), i < j, is bit j (j - 1)/2 + i.
        let graph = move |bits: Vec<bool>| Graph::from_fn(order, |i, j| bits[j * (j - 1) / 2 + i]);
        all_choices(order * order.saturating_sub(1) / 2).map(graph)
    }

    /// Joins two different vertices, or parts them where they are joined. What is no pair of vertices stays as it is.
    pub fn toggle(&mut self, i: usize, j: usize) {
        if i != j && i.max(j) < self.order() {
            self.adjacency.flip(i, j);
            self.adjacency.flip(j, i);
        }
    }

    /// Number of vertices.
    pub fn order(&self) -> usize {
        self.adjacency.rows()
    }

    /// Whether `i` and `j` are joined; vertices that are not there are joined to none.
    pub fn has_edge(&self, i: usize, j: usize) -> bool {
        self.adjacency.get(i, j)
    }

    /// The adjacency with ones on the diagonal: the footprint of every matrix `I - CL` with `0 < c_i d_i < 1`.
    pub fn closed_adjacency(&self) -> Footprint {
        self.adjacency.closed()
    }

    /// Number of neighbours of `i`.
    pub fn degree(&self, i: usize) -> usize {
        if i < self.order() { self.adjacency.ones(i).count() } else { 0 }
    }

    /// The graph on these vertices, which become `0, 1, ...` in the order given, with all edges among them.
    pub fn induced(&self, vertices: &[usize]) -> Self {
        Graph::from_fn(vertices.len(), |i, j| self.has_edge(vertices[i], vertices[j]))
    }

    /// The graph with more edges.
    pub fn with_edges(&self, more: &[(usize, usize)]) -> Self {
        Graph::from_fn(self.order(), |i, j| self.has_edge(i, j) || more.contains(&(i, j)) || more.contains(&(j, i)))
    }

    /// The neighbours of `i` in order.
    pub fn neighbours(&self, i: usize) -> Vec<usize> {
        // Symmetric: the row is the column.
        if i < self.order() { self.adjacency.ones(i).collect() } else { Vec::new() }
    }

    /// The edges `(i, j)` with `i < j`.
    pub fn edges(&self) -> Vec<(usize, usize)> {
        (0..self.order()).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| self.has_edge(i, j)).collect()
    }

    /// Whether there is a path between any two vertices (and at least one vertex).
    pub fn is_connected(&self) -> bool {
        self.components().len() == 1
    }

    /// Whether it is connected and has no cycle: leaves can be taken away until one vertex is left.
    pub fn is_tree(&self) -> bool {
        let mut left: Vec<usize> = (0..self.order()).collect();
        while let Some(leaf) = left.iter().position(|&i| left.iter().filter(|&&j| self.has_edge(i, j)).count() == 1) {
            left.remove(leaf);
        }
        self.is_connected() && left.len() == 1
    }

    /// Whether it is a path, in any order of the vertices; a single vertex is one.
    pub fn is_path(&self) -> bool {
        self.is_tree() && (0..self.order()).all(|i| self.degree(i) <= 2)
    }

    /// The largest effective resistance between two vertices where every edge has the resistance 1: the largest `|x_i - x_j|²` with
    /// `<x, L x> = 1`, 0 for a single vertex. `None` where the graph is not connected.
    ///
    /// # Errors
    /// [`MatrixError::Empty`] for a graph without vertices.
    pub fn largest_resistance(&self) -> Result<Option<Rational>, MatrixError> {
        let laplacian = self.laplacian()?;
        if !self.is_connected() {
            return Ok(None);
        }
        let mut largest = Rational::default();
        // With one vertex at 0 the diagonal of the inverse holds the resistances to it.
        for ground in (0..self.order()).filter(|_| self.order() > 1) {
            let kept: Vec<usize> = (0..self.order()).filter(|&k| k != ground).collect();
            let inverse = laplacian.block(&kept, &kept)?.inverse()?;
            largest = (0..inverse.rows()).map(|k| inverse.entry(k, k)).fold(largest, Ord::max);
        }
        Ok(Some(largest))
    }

    /// The combinatorial Laplacian `D - A`.
    ///
    /// # Errors
    /// [`MatrixError::Empty`] for a graph without vertices.
    pub fn laplacian(&self) -> Result<RationalMatrix, MatrixError> {
        let order = self.order();
        let entry = |k: usize| match (k / order, k % order) {
            (i, j) if i == j => BigInt::from(self.degree(i)),
            (i, j) => -BigInt::from(u8::from(self.has_edge(i, j))),
        };
        RationalMatrix::new(order, order, (0..order * order).map(entry).collect(), BigInt::from(1))
    }

    /// The connected components, each sorted, in the order of their smallest vertex.
    pub fn components(&self) -> Vec<Vec<usize>> {
        components(self.order(), &self.edges())
    }
}
