//! Quantities of graphs that a conjecture may name, exact. Each has a naive twin in the tests, over all graphs of up to six vertices.
//!
//! Those that are decided by search (cliques, colourings, cuts, automorphisms) are for small graphs and can be stopped; the others take polynomial time.

mod automorphisms;
mod cliques;
mod connectivity;
mod cuts;
mod directed;
mod distances;
mod matching;
mod planarity;
mod trees;

pub use cliques::LARGEST_SEARCHED;
pub use cuts::LARGEST_CUT;
pub use directed::{is_rooted, period};
pub use distances::distances;

use crate::graph::Graph;
use petgraph::graph::{NodeIndex, UnGraph};

/// The graph in the form that petgraph's algorithms take.
fn undirected(graph: &Graph) -> UnGraph<(), ()> {
    let mut theirs = UnGraph::with_capacity(graph.order(), 0);
    for _ in 0..graph.order() {
        theirs.add_node(());
    }
    for (i, j) in graph.edges() {
        theirs.add_edge(NodeIndex::new(i), NodeIndex::new(j), ());
    }
    theirs
}
