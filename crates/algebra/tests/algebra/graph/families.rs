//! Families of graphs and digraphs, trees and resistances, against counts and by hand.

use algebra::graph::{Graph, WeightedGraph};
use algebra::matrix::MatrixError;
use arithmetic::rational;

/// The arcs of a digraph on so many vertices.
fn arcs(graph: &WeightedGraph, order: usize) -> Vec<(usize, usize)> {
    let pairs = (0..order).flat_map(|k| (0..order).map(move |j| (k, j)));
    pairs.filter(|&(k, j)| graph.adjacency().get(k, j).is_some()).collect()
}

#[test]
fn named_graphs_have_their_edges() {
    assert_eq!(Graph::complete(4).edges().len(), 6);
    assert_eq!(Graph::star(4).edges(), [(0, 1), (0, 2), (0, 3)]);
    assert_eq!([1, 2, 3, 5].map(|n| Graph::ring(n).edges().len()), [0, 1, 3, 5]);
    assert!(Graph::ring(5).has_edge(0, 4) && !Graph::ring(5).has_edge(1, 3));
}

#[test]
fn labelled_trees_and_paths_are_counted() {
    // Cayley: n^(n-2) trees; n!/2 of them are paths.
    for (order, trees, paths) in [(1, 1, 1), (2, 1, 1), (3, 3, 3), (4, 16, 12), (5, 125, 60)] {
        assert_eq!(Graph::all(order).filter(Graph::is_tree).count(), trees, "{order}");
        assert_eq!(Graph::all(order).filter(Graph::is_path).count(), paths, "{order}");
    }
    assert!(!Graph::empty(0).is_tree());
}

#[test]
fn resistances_are_those_of_wires() {
    let largest = |graph: Graph| graph.largest_resistance();
    assert_eq!(largest(Graph::path(5)), Ok(Some(rational(4, 1))));
    assert_eq!(largest(Graph::star(5)), Ok(Some(rational(2, 1))));
    assert_eq!(largest(Graph::complete(5)), Ok(Some(rational(2, 5))));
    // Two arcs of two wires each, in parallel; of two and three.
    assert_eq!(largest(Graph::ring(4)), Ok(Some(rational(1, 1))));
    assert_eq!(largest(Graph::ring(5)), Ok(Some(rational(6, 5))));
    assert_eq!(largest(Graph::empty(1)), Ok(Some(rational(0, 1))));
    assert_eq!(largest(Graph::empty(2)), Ok(None));
    assert_eq!(largest(Graph::empty(0)), Err(MatrixError::Empty));
}

#[test]
fn digraphs_and_circulants_are_all_there() {
    for (order, count) in [(0, 1), (1, 1), (2, 4), (3, 64)] {
        let all: Vec<_> = WeightedGraph::all(order).map(|graph| arcs(&graph, order)).collect();
        assert_eq!(all.len(), count);
        assert_eq!(all.iter().collect::<std::collections::BTreeSet<_>>().len(), count);
    }
    for (order, all, undirected) in [(1, 1, 1), (2, 2, 2), (5, 16, 4), (6, 32, 8)] {
        assert_eq!(WeightedGraph::circulants(order, false).count(), all);
        assert_eq!(WeightedGraph::circulants(order, true).count(), undirected);
    }
    let (offsets, graph) = WeightedGraph::circulants(5, true).nth(1).expect("four of them");
    assert_eq!((offsets, arcs(&graph, 5).len()), (vec![2, 3], 10));
    assert_eq!(arcs(&WeightedGraph::complete(4), 4).len(), 12);
}
