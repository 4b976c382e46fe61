//! How many edges, or vertices, hold a graph together: by Menger's theorem, from largest flows.

use crate::graph::Graph;
use arithmetic::{Cancelled, Progress};

impl Graph {
    /// Least number of edges without which the graph is not connected; 0 where it is not, and of a single vertex.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn edge_connectivity(&self, progress: &dyn Progress) -> Result<usize, Cancelled> {
        let mut least = (0..self.order()).map(|i| self.degree(i)).min().unwrap_or(0);
        let edges = self.edges();
        // Some other vertex lies on the other side of a least cut than vertex 0.
        for end in 1..self.order() {
            progress.checkpoint()?;
            let both = edges.iter().flat_map(|&(i, j)| [(i, j), (j, i)]);
            least = Flow::new(self.order(), both).largest(0, end, least);
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
        let mut start = 0;
        // Of any `least + 1` vertices one lies outside a least separating set.
        while start <= least && start < order {
            for end in (0..order).filter(|&end| end != start && !self.has_edge(start, end)) {
                progress.checkpoint()?;
                // Every vertex is an arc from its entrance `2 i` to its exit `2 i + 1`.
                let inner = (0..order).map(|i| (2 * i, 2 * i + 1));
                let outer = self.edges().into_iter().flat_map(|(i, j)| [(2 * i + 1, 2 * j), (2 * j + 1, 2 * i)]);
                least = Flow::new(2 * order, inner.chain(outer)).largest(2 * start + 1, 2 * end, least);
            }
            start += 1;
        }
        Ok(least)
    }
}

/// Arcs that carry one unit each.
struct Flow {
    /// Arcs from each vertex, by number; arc `k ^ 1` leads back.
    from: Vec<Vec<usize>>,
    ends: Vec<usize>,
    is_free: Vec<bool>,
}

impl Flow {
    fn new(order: usize, arcs: impl Iterator<Item = (usize, usize)>) -> Self {
        let mut flow = Flow { from: vec![Vec::new(); order], ends: Vec::new(), is_free: Vec::new() };
        for (i, j) in arcs {
            for (tail, head, is_free) in [(i, j, true), (j, i, false)] {
                flow.from[tail].push(flow.ends.len());
                flow.ends.push(head);
                flow.is_free.push(is_free);
            }
        }
        flow
    }

    /// The largest flow from one vertex to another, or `most` where it is at least that.
    fn largest(mut self, start: usize, end: usize, most: usize) -> usize {
        (0..most).find(|_| !self.augment(start, end)).unwrap_or(most)
    }

    /// One more unit by a shortest way, where there is one.
    fn augment(&mut self, start: usize, end: usize) -> bool {
        let mut came: Vec<Option<usize>> = vec![None; self.from.len()];
        let (mut queue, mut next) = (vec![start], 0);
        while came[end].is_none() {
            let Some(&i) = queue.get(next) else { return false };
            next += 1;
            for &arc in self.from[i].iter().filter(|&&arc| self.is_free[arc]) {
                let j = self.ends[arc];
                if j != start && came[j].is_none() {
                    came[j] = Some(arc);
                    queue.push(j);
                }
            }
        }
        let mut at = end;
        while let Some(arc) = came[at] {
            self.is_free[arc] = false;
            self.is_free[arc ^ 1] = true;
            at = self.ends[arc ^ 1];
        }
        true
    }
}
