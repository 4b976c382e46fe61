//! Graphs: undirected simple ones, which the flocking networks are made of, and directed ones with rational weights.

mod any;
mod arc_list;
pub mod classes;
mod components;
pub mod graph6;
pub mod invariants;
mod isomorphism;
mod laplacian;
mod named;
pub mod read;
mod weighted;

pub use any::{AnyGraph, GraphTextError};
pub use arc_list::ArcList;
pub use components::{component_numbers, components};
pub use laplacian::{LaplacianError, LaplacianKind};
pub use named::{LARGEST_ORDER, NameError, NamedGraph, nearest_form};
pub use weighted::WeightedGraph;

use crate::matrix::{Footprint, MatrixError, RationalMatrix};
use arithmetic::{Rational, words};
use num_bigint::BigInt;

/// An undirected graph without loops on the vertices `0..order`. Memory: its vertices and edges.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Graph {
    /// The neighbours of each vertex, in order.
    near: Vec<Vec<u32>>,
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
    /// The graph in which `i` and `j > i` are joined where `joined(i, j)`; asks for all pairs.
    pub fn from_fn(order: usize, joined: impl Fn(usize, usize) -> bool) -> Self {
        Graph::of_pairs(order, (0..order).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| joined(i, j)))
    }

    /// The graph that joins these pairs of different vertices.
    fn of_pairs(order: usize, pairs: impl Iterator<Item = (usize, usize)>) -> Self {
        let mut near = vec![Vec::new(); order];
        for (i, j) in pairs {
            near[i].push(j as u32);
            near[j].push(i as u32);
        }
        for list in &mut near {
            list.sort_unstable();
            list.dedup();
        }
        Graph { near }
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
        Ok(Graph::of_pairs(order, edges.iter().copied()))
    }

    /// The graph without edges.
    pub fn empty(order: usize) -> Self {
        Graph::of_pairs(order, std::iter::empty())
    }

    /// The path `0 - 1 - ... - (order - 1)`.
    pub fn path(order: usize) -> Self {
        Graph::of_pairs(order, (1..order).map(|j| (j - 1, j)))
    }

    /// The graph in which all are joined.
    pub fn complete(order: usize) -> Self {
        Graph::from_fn(order, |_, _| true)
    }

    /// The ring `0 - 1 - ... - (order - 1) - 0`; on two vertices one edge, on one none.
    pub fn ring(order: usize) -> Self {
        let closing = Some((0, order.saturating_sub(1))).filter(|_| order > 2);
        Graph::of_pairs(order, (1..order).map(|j| (j - 1, j)).chain(closing))
    }

    /// The star: vertex 0 is joined to all others.
    pub fn star(order: usize) -> Self {
        Graph::of_pairs(order, (1..order).map(|j| (0, j)))
    }

    /// All `2^(order (order - 1)/2)` labelled graphs; nobody lives to see the last of them for `order > 9`.
    pub fn all(order: usize) -> impl Iterator<Item = Graph> {
        // Pair (i, j), i < j, is bit j (j - 1)/2 + i.
        let graph = move |bits: Vec<bool>| Graph::from_fn(order, |i, j| bits[j * (j - 1) / 2 + i]);
        all_choices(order * order.saturating_sub(1) / 2).map(graph)
    }

    /// Joins two different vertices, or parts them where they are joined. What is no pair of vertices stays as it is.
    pub fn toggle(&mut self, i: usize, j: usize) {
        if i == j || i.max(j) >= self.order() {
            return;
        }
        for (own, other) in [(i, j as u32), (j, i as u32)] {
            let list = &mut self.near[own];
            match list.binary_search(&other) {
                Ok(place) => drop(list.remove(place)),
                Err(place) => list.insert(place, other),
            }
        }
    }

    /// Number of vertices.
    pub fn order(&self) -> usize {
        self.near.len()
    }

    /// Whether `i` and `j` are joined; vertices that are not there are joined to none.
    pub fn has_edge(&self, i: usize, j: usize) -> bool {
        u32::try_from(j).is_ok_and(|j| self.neighbours(i).binary_search(&j).is_ok())
    }

    /// The adjacency with ones on the diagonal: the footprint of every matrix `I - CL` with `0 < c_i d_i < 1`.
    pub fn closed_adjacency(&self) -> Footprint {
        let rows = self.near.iter().enumerate().map(|(i, list)| list.iter().map(|&j| j as usize).chain([i]));
        Footprint::from_ones(self.order(), rows)
    }

    /// Number of neighbours of `i`.
    pub fn degree(&self, i: usize) -> usize {
        self.neighbours(i).len()
    }

    /// The graph on these vertices, which become `0, 1, ...` in the order given, with all edges among them.
    pub fn induced(&self, vertices: &[usize]) -> Self {
        let mut places: Vec<(u32, usize)> = vertices.iter().enumerate().map(|(place, &i)| (i as u32, place)).collect();
        places.sort_unstable();
        let place_of = |i: &u32| places.binary_search_by_key(i, |&(vertex, _)| vertex).ok().map(|k| places[k].1);
        let pairs = vertices
            .iter()
            .enumerate()
            .flat_map(|(place, &i)| self.neighbours(i).iter().filter_map(place_of).map(move |other| (place, other)));
        Graph::of_pairs(vertices.len(), pairs)
    }

    /// The graph with more edges.
    pub fn with_edges(&self, more: &[(usize, usize)]) -> Self {
        let mut graph = self.clone();
        for &(i, j) in more.iter().filter(|&&(i, j)| !self.has_edge(i, j)) {
            if !graph.has_edge(i, j) {
                graph.toggle(i, j);
            }
        }
        graph
    }

    /// The neighbours of `i` in order.
    pub fn neighbours(&self, i: usize) -> &[u32] {
        self.near.get(i).map_or(&[], Vec::as_slice)
    }

    /// The edges `(i, j)` with `i < j`.
    pub fn edges(&self) -> Vec<(usize, usize)> {
        let before = |j: usize| self.near[j].iter().map(|&i| i as usize).take_while(move |&i| i < j);
        (0..self.order()).flat_map(|j| before(j).map(move |i| (i, j))).collect()
    }

    /// Whether there is a path between any two vertices (and at least one vertex).
    pub fn is_connected(&self) -> bool {
        self.components().len() == 1
    }

    /// Whether it is connected and has no cycle.
    pub fn is_tree(&self) -> bool {
        let ends: usize = self.near.iter().map(Vec::len).sum();
        self.is_connected() && ends == 2 * (self.order() - 1)
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

    /// The number of the connected component of each vertex, in the order of their smallest vertex, and how many there are.
    pub fn component_numbers(&self) -> (Vec<u32>, usize) {
        let pairs = self.near.iter().enumerate().flat_map(|(i, near)| near.iter().map(move |&j| (i, j as usize)));
        let (numbers, count) = component_numbers(self.order(), pairs.filter(|(i, j)| i < j));
        (numbers.into_iter().map(|number| number as u32).collect(), count)
    }

    /// The connected components, each sorted, in the order of their smallest vertex.
    pub fn components(&self) -> Vec<Vec<usize>> {
        let (numbers, count) = self.component_numbers();
        let mut components = vec![Vec::new(); count];
        numbers.iter().enumerate().for_each(|(i, &number)| components[number as usize].push(i));
        components
    }
}
