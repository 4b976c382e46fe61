//! Quantities of graphs here and by petgraph, with the cost of building its graph (`notes/graphs.md`): connected graphs of eight vertices.

use criterion::{Criterion, criterion_group, criterion_main};
use flockproof::arithmetic::Unwatched;
use flockproof::graph::Graph;
use flockproof::graph::classes::connected_graphs;
use petgraph::algo::{
    connected_components, is_bipartite_undirected, maximal_cliques::maximal_cliques, subgraph_isomorphisms_iter,
};
use petgraph::graph::{NodeIndex, UnGraph};
use std::hint::black_box;

/// One graph in so many is looked at.
const STEP: usize = 20;

fn theirs(graph: &Graph) -> UnGraph<(), ()> {
    let mut theirs = UnGraph::with_capacity(graph.order(), 0);
    for _ in 0..graph.order() {
        theirs.add_node(());
    }
    for (i, j) in graph.edges() {
        theirs.add_edge(NodeIndex::new(i), NodeIndex::new(j), ());
    }
    theirs
}

fn automorphisms(graph: &Graph) -> usize {
    let theirs = theirs(graph);
    subgraph_isomorphisms_iter(&&theirs, &&theirs, &mut |_, _| true, &mut |_, _| true).map_or(0, Iterator::count)
}

type Measure = fn(&Graph) -> usize;

fn quantities(criterion: &mut Criterion) {
    let graphs: Vec<Graph> = connected_graphs(8, &Unwatched).expect("graphs").into_iter().step_by(STEP).collect();
    let rows: [(&str, Measure, Measure); 4] = [
        ("components", |graph| graph.components().len(), |graph| connected_components(&theirs(graph))),
        (
            "bipartite",
            |graph| usize::from(graph.is_bipartite()),
            |graph| usize::from(is_bipartite_undirected(&theirs(graph), NodeIndex::new(0))),
        ),
        (
            "cliques",
            |graph| graph.clique_number(&Unwatched).ok().flatten().unwrap_or(0),
            |graph| maximal_cliques(&theirs(graph)).iter().map(|clique| clique.len()).max().unwrap_or(0),
        ),
        ("automorphisms", |graph| graph.automorphism_count(&Unwatched).map_or(0, |n| n.bits() as usize), automorphisms),
    ];
    for (name, here, petgraph) in rows {
        let mut group = criterion.benchmark_group(name);
        group.sample_size(10);
        for (who, measure) in [("here", here), ("petgraph", petgraph)] {
            group.bench_function(who, |b| {
                b.iter(|| graphs.iter().map(|graph| black_box(measure(graph))).sum::<usize>())
            });
        }
        group.finish();
    }
}

criterion_group!(benches, quantities);
criterion_main!(benches);
