//! Quantities that are not computed by petgraph against it, whose algorithms are others: all classes of up to six vertices, and random graphs of up to 24.

use algebra::graph::classes::graphs;
use algebra::graph::invariants::{distances, is_rooted};
use algebra::graph::{Graph, components};
use arithmetic::Unwatched;
use num_bigint::BigUint;
use petgraph::algo::{
    articulation_points::articulation_points, bridges::bridges, coloring::dsatur_coloring, condensation,
    connected_components, floyd_warshall, is_bipartite_undirected, is_cyclic_undirected, is_isomorphic,
    maximal_cliques::maximal_cliques, subgraph_isomorphisms_iter, tarjan_scc,
};
use petgraph::graph::{DiGraph, NodeIndex, UnGraph};

type Theirs = UnGraph<(), ()>;

fn undirected(graph: &Graph) -> Theirs {
    let mut theirs = Theirs::with_capacity(graph.order(), 0);
    for _ in 0..graph.order() {
        theirs.add_node(());
    }
    for (i, j) in graph.edges() {
        theirs.add_edge(NodeIndex::new(i), NodeIndex::new(j), ());
    }
    theirs
}

fn directed(order: usize, arcs: impl Iterator<Item = (usize, usize)>) -> DiGraph<(), u32> {
    let mut theirs = DiGraph::with_capacity(order, 0);
    for _ in 0..order {
        theirs.add_node(());
    }
    for (i, j) in arcs {
        theirs.add_edge(NodeIndex::new(i), NodeIndex::new(j), 1);
    }
    theirs
}

/// Numbers below a bound, the same in every run.
fn numbers(mut state: u64) -> impl FnMut(usize) -> usize {
    move |below| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    }
}

/// Random graphs of 2 to 24 vertices, from few edges to nearly all.
fn random() -> impl Iterator<Item = Graph> {
    let mut next = numbers(7);
    (0..120).map(move |k| {
        let (order, share) = (2 + k % 23, 1 + next(9));
        let pairs = (0..order).flat_map(|j| (0..j).map(move |i| (i, j)));
        let edges: Vec<(usize, usize)> = pairs.filter(|_| next(10) < share).collect();
        Graph::from_edges(order, &edges).expect("a graph")
    })
}

fn all_cliques(graph: &Graph) -> Option<usize> {
    maximal_cliques(&undirected(graph)).iter().map(|clique| clique.len()).max()
}

fn automorphisms(graph: &Graph) -> usize {
    let theirs = undirected(graph);
    subgraph_isomorphisms_iter(&&theirs, &&theirs, &mut |_, _| true, &mut |_, _| true).map_or(0, Iterator::count)
}

fn is_bipartite(theirs: &Theirs) -> bool {
    theirs.node_indices().all(|start| is_bipartite_undirected(theirs, start))
}

fn compared(graph: &Graph) {
    let (order, theirs, edges) = (graph.order(), undirected(graph), graph.edges());
    let parts = components(order, &edges).len();
    assert_eq!(parts, connected_components(&theirs), "{edges:?}");
    assert_eq!(graph.is_bipartite(), is_bipartite(&theirs), "{edges:?}");
    assert_eq!(graph.is_tree(), parts == 1 && !is_cyclic_undirected(&theirs), "{edges:?}");
    assert_eq!(graph.clique_number(&Unwatched), Ok(all_cliques(graph)), "{edges:?}");
    let complement = Graph::from_fn(order, |i, j| !graph.has_edge(i, j));
    assert_eq!(graph.independence_number(&Unwatched), Ok(all_cliques(&complement)), "{edges:?}");
    let colours = graph.chromatic_number(&Unwatched).expect("not stopped").expect("few vertices");
    assert!(colours <= dsatur_coloring(&theirs).1, "{edges:?}");
    let least = graph.edge_connectivity(&Unwatched).expect("not stopped");
    assert_eq!(least >= 2, parts == 1 && order > 1 && bridges(&theirs).next().is_none(), "{edges:?}");
    let held = graph.vertex_connectivity(&Unwatched).expect("not stopped");
    assert_eq!(held >= 2, parts == 1 && order > 2 && articulation_points(&theirs).is_empty(), "{edges:?}");
    let ways = floyd_warshall(&theirs, |_| 1u32).expect("no negative cycle");
    for i in 0..order {
        for (j, distance) in distances(graph.lists(), i).into_iter().enumerate() {
            let other = ways[&(NodeIndex::new(i), NodeIndex::new(j))];
            assert_eq!(distance, (other < u32::MAX).then_some(other as usize), "{edges:?}");
        }
    }
}

#[test]
fn petgraph_agrees_on_small_and_random_graphs() {
    for n in 1..=6 {
        let classes = graphs(n, &Unwatched).expect("graphs");
        for (k, graph) in classes.iter().enumerate() {
            compared(graph);
            assert_eq!(graph.automorphism_count(&Unwatched), Ok(BigUint::from(automorphisms(graph))));
            let other =
                (k + 1..classes.len()).find(|&other| is_isomorphic(&undirected(graph), &undirected(&classes[other])));
            assert_eq!(other, None, "{n} {k}");
        }
    }
    random().for_each(|graph| compared(&graph));
}

#[test]
fn petgraph_agrees_on_directed_graphs() {
    let mut next = numbers(11);
    for k in 0..400 {
        let (order, share) = (1 + k % 12, 1 + next(5));
        let pairs = (0..order).flat_map(|i| (0..order).map(move |j| (i, j)));
        let arcs: Vec<(usize, usize)> = pairs.filter(|_| next(10) < share).collect();
        let theirs = directed(order, arcs.iter().copied());
        let mut out = vec![Vec::new(); order];
        arcs.iter().for_each(|&(i, j)| out[i].push(j as u32));
        let reached = (0..order).map(|i| distances(&out, i)).collect::<Vec<_>>();
        let strong = reached.iter().flatten().all(Option::is_some);
        assert_eq!(strong, tarjan_scc(&theirs).len() == 1, "{arcs:?}");
        // A root is in the only component that no arc leaves.
        let parts = condensation(theirs.clone(), true);
        let last = parts.node_indices().filter(|&part| parts.neighbors(part).next().is_none()).count();
        assert_eq!(is_rooted(&out), last == 1, "{arcs:?}");
        let ways = floyd_warshall(&theirs, |_| 1u32).expect("no negative cycle");
        for (i, row) in reached.iter().enumerate() {
            for (j, distance) in row.iter().enumerate() {
                let other = ways[&(NodeIndex::new(i), NodeIndex::new(j))];
                assert_eq!(*distance, (other < u32::MAX).then_some(other as usize), "{arcs:?}");
            }
        }
    }
}
