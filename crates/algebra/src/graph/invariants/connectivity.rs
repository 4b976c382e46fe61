//! How many edges, or vertices, hold a graph together: by Menger's theorem, from largest flows.

use crate::graph::Graph;
use arithmetic::{Cancelled, Progress};
use petgraph::algo::maximum_flow::dinics;
use petgraph::graph::{DiGraph, NodeIndex};

impl Graph {
    /// Least number of edges without which the graph is not connected; 0 where it is not, and of a single vertex.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn edge_connectivity(&self, progress: &dyn Progress) -> Result<usize, Cancelled> {
        let mut least = (0..self.order()).map(|i| self.degree(i)).min().unwrap_or(0);
        let both = self.edges().into_iter().flat_map(|(i, j)| [(i, j), (j, i)]);
        let flow = Flow::new(self.order(), both);
        // Some other vertex lies on the other side of a least cut than vertex 0.
        for end in 1..self.order() {
            progress.checkpoint()?;
            least = least.min(flow.largest(0, end));
        }
        Ok(if self.order() < 2 { 0 } else { least })
    }

    /// Least number of vertices without which the graph is not connected or has one vertex only: `n - 1` of the complete graph, 0 of a graph that is
    /// not connected.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn vertex_connectivity(&self, progress: &dyn Progress) -> Result<usize, Cancelled> {
        let order = self.order();
        let mut least = (0..order).map(|i| self.degree(i)).min().unwrap_or(0).min(order.saturating_sub(1));
        // Every vertex is an arc from its entrance `2 i` to its exit `2 i + 1`.
        let inner = (0..order).map(|i| (2 * i, 2 * i + 1));
        let outer = self.edges().into_iter().flat_map(|(i, j)| [(2 * i + 1, 2 * j), (2 * j + 1, 2 * i)]);
        let flow = Flow::new(2 * order, inner.chain(outer));
        let mut start = 0;
        // Of any `least + 1` vertices one lies outside a least separating set.
        while start <= least && start < order {
            for end in (0..order).filter(|&end| end != start && !self.has_edge(start, end)) {
                progress.checkpoint()?;
                least = least.min(flow.largest(2 * start + 1, 2 * end));
            }
            start += 1;
        }
        Ok(least)
    }
}

/// Arcs that carry one unit each.
struct Flow(DiGraph<(), u32>);

impl Flow {
    fn new(order: usize, arcs: impl Iterator<Item = (usize, usize)>) -> Self {
        let mut network = DiGraph::with_capacity(order, 0);
        for _ in 0..order {
            network.add_node(());
        }
        for (i, j) in arcs {
            network.add_edge(NodeIndex::new(i), NodeIndex::new(j), 1);
        }
        Flow(network)
    }

    /// The largest flow from one vertex to another (Dinitz 1970).
    fn largest(&self, start: usize, end: usize) -> usize {
        dinics(&self.0, NodeIndex::new(start), NodeIndex::new(end)).0 as usize
    }
}
