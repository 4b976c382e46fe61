//! Largest matchings, by petgraph.

use super::undirected;
use crate::graph::Graph;
use petgraph::algo::maximum_matching;

impl Graph {
    /// Number of edges of a largest matching: of edges without common ends (Gabow 1976). Cost: the cube of the order.
    pub fn matching_number(&self) -> usize {
        maximum_matching(&undirected(self)).len()
    }
}
