//! Mirrors `src/graph`.

use algebra::graph::classes::{digraphs, graphs, trees};
use algebra::graph::read::{GraphReadError, read_graph};
use algebra::graph::{
    AnyGraph, Graph, LaplacianError, LaplacianKind, NameError, NamedGraph, WeightedGraph, components,
};
use algebra::matrix::{Footprint, SparseMatrix};
use arithmetic::{Ring, Unwatched, rational};

mod families;

fn named(text: &str) -> NamedGraph {
    text.parse().unwrap_or_else(|error| panic!("{text}: {error}"))
}

#[test]
fn names_are_read_and_written() {
    for text in ["ring:3", "cycle:1", "path:1", "complete:4", "star:2", "circulant:12:1,3", "platoon1:1", "platoon2:8"]
    {
        assert_eq!(named(text).to_string(), text);
    }
    assert_eq!(named("circulant:12:11,3,1").to_string(), "circulant:12:1,3");
    for text in
        ["", "ring", "ring:", "ring:2", "ring:0", "ring:+5", "ring:3:3", "path:0", "path:-1", "path:2000000", "Ring:3"]
    {
        assert!(text.parse::<NamedGraph>().is_err(), "{text}");
    }
    for text in ["circulant:12", "circulant:12:", "circulant:12:0", "circulant:12:12", "circulant:1:1", "platoon2:0"] {
        assert!(text.parse::<NamedGraph>().is_err(), "{text}");
    }
    for text in ["geometric:0:1:1", "geometric:5:0:1", "geometric:5:x:1", "geometric:5:1/2:-1", "geometric:5:1/2"] {
        assert!(text.parse::<NamedGraph>().is_err(), "{text}");
    }
    assert!(matches!(named("complete:1048576").build(), Err(NameError::TooManyArcs(_))));
}

/// Who is joined to whom, by the numbers alone.
#[test]
fn named_graphs_have_the_arcs_of_their_definition() {
    let apart = |n: usize, i: usize, j: usize| (i + n - j) % n;
    type Joined<'a> = &'a dyn Fn(usize, usize, usize) -> bool;
    let kinds: [(&str, Joined); 6] = [
        ("ring", &|n, i, j| [1, n - 1].contains(&apart(n, i, j))),
        ("cycle", &|n, i, j| apart(n, j, i) == 1 % n),
        ("path", &|_, i, j| i.abs_diff(j) == 1),
        ("complete", &|_, i, j| i != j),
        ("star", &|_, i, j| i != j && i.min(j) == 0),
        ("platoon1", &|_, i, j| i == j + 1),
    ];
    let of = |text: &str| named(text).build().expect("small");
    let agrees = |graph: &WeightedGraph, n: usize, joined: &dyn Fn(usize, usize) -> bool| {
        assert_eq!(graph.order(), n);
        for i in 0..n {
            let row: Vec<_> = (0..n).filter(|&j| joined(i, j)).map(|j| (j, rational(1, 1))).collect();
            assert_eq!(graph.adjacency().row(i), row, "{n} {i}");
        }
    };
    for (kind, joined) in kinds {
        for n in 3..8 {
            let named = if kind == "platoon1" { n - 1 } else { n };
            agrees(&of(&format!("{kind}:{named}")), n, &|i, j| joined(n, i, j));
        }
    }
    for (n, offsets) in [(7, &[2][..]), (8, &[1, 4]), (9, &[2, 3]), (2, &[1])] {
        let list: Vec<String> = offsets.iter().map(ToString::to_string).collect();
        let graph = of(&format!("circulant:{n}:{}", list.join(",")));
        agrees(&graph, n, &|i, j| offsets.iter().any(|a| [*a, n - a].contains(&apart(n, i, j))));
    }
    // Equation (2) of Veerman: the last car follows one, all others two, with half the weight each.
    for m in 1..6 {
        let graph = of(&format!("platoon2:{m}"));
        for i in 0..=m {
            let half = |j: usize| (j, rational(1, 2));
            let known = match i {
                0 => vec![],
                _ if i == m => vec![(m - 1, rational(1, 1))],
                _ => vec![half(i - 1), half(i + 1)],
            };
            assert_eq!(graph.adjacency().row(i), known, "{m} {i}");
        }
    }
}

/// Points whose coordinates are the words of the generator over 2^32, compared as rationals.
#[test]
fn geometric_graphs_join_points_that_are_close() {
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};
    for (radius, text, seed) in [(rational(1, 4), "1/4", 3), (rational(1, 2), "1/2", 11), (rational(9, 10), "9/10", 4)]
    {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut word = || rational(i64::from(random.next_u32()), 1 << 32);
        let points: Vec<_> = (0..12).map(|_| [word(), word()]).collect();
        let graph = named(&format!("geometric:12:{text}:{seed}")).build().expect("small");
        for i in 0..12 {
            let close = |j: usize| {
                let square: arithmetic::Rational = (0..2).map(|k| (&points[i][k] - &points[j][k]).square()).sum();
                i != j && square <= radius.square()
            };
            let row: Vec<_> = (0..12).filter(|&j| close(j)).map(|j| (j, rational(1, 1))).collect();
            assert_eq!(graph.adjacency().row(i), row, "{text} {i}");
        }
    }
}

#[test]
fn names_have_their_limits() {
    let bad = |text: &str| text.parse::<NamedGraph>().is_err();
    for (kind, least, most) in [
        ("ring", 3, 1 << 20),
        ("cycle", 1, 1 << 20),
        ("star", 1, 1 << 20),
        ("platoon1", 1, (1 << 20) - 1),
        ("platoon2", 1, (1 << 20) - 1),
    ] {
        let outside = [least - 1, most + 1].map(|n| bad(&format!("{kind}:{n}")));
        let inside = [least, most].map(|n| bad(&format!("{kind}:{n}")));
        assert_eq!((outside, inside), ([true; 2], [false; 2]), "{kind}");
    }
    assert!(!bad("circulant:2:1") && !bad("circulant:5:4") && bad("circulant:5:5"));
    assert!(!bad("geometric:16384:1:0") && bad("geometric:16385:1:0") && bad("geometric::1:0"));
    // 2^21 arcs are allowed: 1448² of a complete graph are fewer, 1449² more.
    for (text, fits) in [
        ("complete:1448", true),
        ("complete:1449", false),
        ("circulant:1048576:1", true),
        ("circulant:1048576:1,2", false),
    ] {
        assert_eq!(named(text).build().is_ok(), fits, "{text}");
    }
}

#[test]
fn laplacian_is_incidence_times_its_transpose() {
    for graph in Graph::all(4).filter(|graph| !graph.edges().is_empty()) {
        let incidence = graph.incidence().expect("edges");
        let product = incidence.times(&incidence.transpose()).expect("shapes");
        assert_eq!(product, graph.laplacian().expect("vertices"));
        let weighted = WeightedGraph::from(&graph).matrix(LaplacianKind::Combinatorial).expect("a Laplacian");
        assert_eq!(weighted.to_dense().expect("vertices"), product);
    }
}

#[test]
fn kinds_are_what_they_say() {
    let arcs = [(0, 1, rational(2, 1)), (1, 2, rational(1, 3)), (2, 0, rational(1, 1)), (2, 1, rational(4, 1))];
    let graph = WeightedGraph::from_arcs(3, arcs);
    let matrix = |kind| graph.matrix(kind);
    let out = matrix(LaplacianKind::OutDegree).expect("exists");
    assert!(out.row_sums().iter().all(|sum| *sum == rational(0, 1)));
    assert_eq!(out, matrix(LaplacianKind::Combinatorial).expect("exists"));
    let inward = matrix(LaplacianKind::InDegree).expect("exists");
    assert!(inward.transpose().row_sums().iter().all(|sum| *sum == rational(0, 1)));
    assert_eq!(inward.get(1, 1), Some(&rational(6, 1)));
    let walk = matrix(LaplacianKind::Walk).expect("exists");
    assert_eq!((walk.get(2, 2), walk.get(2, 1)), (Some(&rational(1, 1)), Some(&rational(-4, 5))));
    assert_eq!(matrix(LaplacianKind::Normalised), Err(LaplacianError::Directed));
    assert_eq!(matrix(LaplacianKind::Reduced).expect("exists"), out.principal(&[1, 2]));
    let balanced = WeightedGraph::from_arcs(2, [(0, 0, rational(1, 1)), (0, 1, rational(-1, 1))]);
    assert_eq!(balanced.matrix(LaplacianKind::Walk), Err(LaplacianError::ZeroDegree(1)));
    assert_eq!(WeightedGraph::from_arcs(1, []).matrix(LaplacianKind::Reduced), Err(LaplacianError::NothingLeft));
}

#[test]
fn names_of_kinds() {
    for (name, kind) in LaplacianKind::NAMES {
        assert_eq!((kind.name(), LaplacianKind::from_name(name)), (name, Some(kind)));
    }
    assert_eq!(LaplacianKind::from_name("signless"), None);
}

#[test]
fn normalised_and_walk_matrices_and_what_has_none() {
    let edge = |i: usize, j: usize, w: i64| [(i, j, rational(w, 1)), (j, i, rational(w, 1))];
    let path = WeightedGraph::from_arcs(3, edge(0, 1, 2).into_iter().chain(edge(1, 2, 1)));
    let walk = path.matrix(LaplacianKind::Walk).expect("exists");
    assert_eq!(path.matrix(LaplacianKind::Normalised), Ok(walk.clone()));
    let rows = [[3, -3, 0], [-2, 3, -1], [0, -3, 3]];
    let dense = walk.to_dense().expect("vertices");
    assert!((0..9).all(|k| dense.entry(k / 3, k % 3) == rational(rows[k / 3][k % 3], 3)));
    let negative = WeightedGraph::from_arcs(3, edge(0, 1, 2).into_iter().chain(edge(1, 2, -1)));
    assert_eq!(negative.matrix(LaplacianKind::Normalised), Err(LaplacianError::Negative(2)));
    let last =
        WeightedGraph::from_arcs(3, edge(0, 1, 2).into_iter().chain([(2, 0, rational(1, 1)), (2, 1, rational(-1, 1))]));
    assert_eq!(last.matrix(LaplacianKind::Walk), Err(LaplacianError::ZeroDegree(3)));
    let out = path.matrix(LaplacianKind::OutDegree).expect("exists");
    assert_eq!(path.grounded(2), Ok(out.principal(&[0, 1])));
    assert_eq!(path.grounded(1), Ok(out.principal(&[0, 2])));
    let two = WeightedGraph::from_arcs(2, edge(0, 1, 5));
    assert_eq!(two.grounded(1).expect("a vertex").get(0, 0), Some(&rational(5, 1)));
}

#[test]
fn platoons_have_a_leader_without_neighbours() {
    let two = named("platoon2:3").build().expect("small");
    let half = rational(1, 2);
    assert!(two.adjacency().row(0).is_empty());
    assert_eq!(two.adjacency().row(1), [(0, half.clone()), (2, half.clone())]);
    assert_eq!(two.adjacency().row(3), [(2, rational(1, 1))]);
    assert_eq!(two.matrix(LaplacianKind::Combinatorial), two.matrix(LaplacianKind::Walk));
    assert_eq!(named("platoon1:2").build().expect("small").adjacency().row(2), [(1, rational(1, 1))]);
}

#[test]
fn strong_components_agree_with_reachability() {
    for code in 0..1u32 << 12 {
        // All digraphs on 4 vertices.
        let places: Vec<(usize, usize)> =
            (0..4).flat_map(|i| (0..4).map(move |j| (i, j))).filter(|(i, j)| i != j).collect();
        let arcs: Vec<(usize, usize)> =
            places.into_iter().enumerate().filter(|(k, _)| code >> k & 1 == 1).map(|(_, arc)| arc).collect();
        let mut reach = [[false; 4]; 4];
        (0..4).for_each(|i| reach[i][i] = true);
        for _ in 0..4 {
            for &(i, j) in &arcs {
                for row in &mut reach {
                    row[j] |= row[i];
                }
            }
        }
        let matrix = SparseMatrix::from_entries(4, arcs.iter().map(|&(i, j)| (i, j, rational(1, 1))));
        let components = matrix.strong_components();
        assert_eq!(components.iter().map(Vec::len).sum::<usize>(), 4);
        for component in &components {
            let together = |i: usize| (0..4).filter(|&j| reach[i][j] && reach[j][i]).collect::<Vec<_>>();
            assert!(component.iter().all(|&i| together(i) == *component), "{arcs:?}");
        }
    }
}

#[test]
fn geometric_graphs_depend_on_the_seed_only() {
    let graph = |text: &str| named(text).build().expect("small");
    assert_eq!(graph("geometric:30:1/3:7"), graph("geometric:30:1/3:7"));
    assert_ne!(graph("geometric:30:1/3:7"), graph("geometric:30:1/3:8"));
    assert_eq!(graph("geometric:6:3/2:1"), graph("complete:6"));
    assert!(graph("geometric:6:1e-9:1").adjacency().entries().next().is_none());
}

#[test]
fn both_formats_are_read() {
    let path = named("path:3").build().expect("small");
    assert_eq!(read_graph("# a path\n1 2\n\n2 3 # the end\n"), Ok(path.clone()));
    assert_eq!(read_graph("%%MatrixMarket matrix coordinate pattern symmetric\n% x\n3 3 2\n2 1\n3 2\n"), Ok(path));
    let arc = WeightedGraph::from_arcs(3, [(0, 1, rational(-1, 2))]);
    assert_eq!(read_graph("directed\nvertices 3\n1 2 -0.5\n"), Ok(arc.clone()));
    assert_eq!(read_graph("%%MatrixMarket matrix coordinate real general\n3 3 1\n1 2 -5e-1"), Ok(arc));
    let loops = read_graph("%%matrixmarket MATRIX coordinate integer general\r\n1 1 1\r\n1 1 7\r\n").expect("a loop");
    assert_eq!(loops.adjacency().get(0, 0), Some(&rational(7, 1)));
}

#[test]
fn bad_files_are_refused_with_the_line() {
    let refused = |text: &str, named: &str| {
        let error = read_graph(text).expect_err(text).to_string();
        assert!(error.contains(named), "`{error}` does not name `{named}`");
    };
    assert_eq!(read_graph(""), Err(GraphReadError::Nothing));
    assert_eq!(read_graph("# nothing\n"), Err(GraphReadError::Nothing));
    refused("1 2\n1 x\n", "line 2: `x`");
    refused("1 2\n0 1\n", "line 2: vertices are counted from 1");
    refused("1 2\n1 2 3 4\n", "line 2: an edge");
    refused("1\n", "line 1: an edge");
    refused("1 2 a\n", "line 1: `a`");
    refused("1 2 1/0\n", "zero denominator");
    refused("1 2\n2 1\n", "line 2: (2, 1) was given in line 1");
    refused("1 1\n", "line 1: the edge from vertex 1");
    refused("1 2\ndirected\n", "line 2");
    refused("vertices 2\n1 3\n", "line 2: `3`");
    refused("1 99999999999999999999\n", "line 1");
    refused("%%MatrixMarket matrix array real general\n1 1\n1\n", "line 1");
    refused("%%MatrixMarket matrix coordinate complex general\n1 1 0\n", "line 1");
    refused("%%MatrixMarket matrix coordinate real general\n", "no graph");
    refused("%%MatrixMarket matrix coordinate real general\n2 3 0\n", "line 2: a matrix of 2 x 3");
    refused("%%MatrixMarket matrix coordinate real general\n2 2 2\n1 2 1\n", "2 entries are announced");
    refused("%%MatrixMarket matrix coordinate real general\n2 2 1\n1 3 1\n", "line 3: `3`");
    refused("%%MatrixMarket matrix coordinate real general\n2 2 1\n1 2\n", "line 3");
    refused("%%MatrixMarket matrix coordinate real general\n2 2 1\n1 2 NaN\n", "line 3");
    refused("%%MatrixMarket matrix coordinate real symmetric\n2 2 1\n1 2 1\n", "line 3: an entry");
    refused("%%MatrixMarket matrix coordinate real general\n999999999999 999999999999 1\n1 2 1\n", "line 2");
}

#[test]
fn components_of_edges_are_those_of_the_graph() {
    let mut seed = 1u64;
    for order in 0..24 {
        for density in [1, 4, 12] {
            let mut edges = Vec::new();
            for j in 0..order {
                for i in 0..j {
                    seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                    if (seed >> 40) % 24 < density {
                        edges.push(if seed >> 39 & 1 == 0 { (i, j) } else { (j, i) });
                    }
                }
            }
            let graph = Graph::from_edges(order, &edges).expect("simple");
            assert_eq!(components(order, &edges), graph.components());
        }
    }
    assert_eq!(components(2, &[(0, 5), (1, 1)]), [[0], [1]]);
}

/// Renamed graphs share the code; the classes of connected graphs have different ones.
#[test]
fn isomorphism_codes() {
    for order in 1..=5 {
        let mut codes: Vec<_> = Graph::connected_up_to_isomorphism(order).iter().map(Graph::isomorphism_code).collect();
        let count = codes.len();
        codes.sort_unstable();
        codes.dedup();
        assert_eq!(codes.len(), count);
    }
    // One graph of many vertices at a time; the numbering goes on as it began.
    let large: Vec<Graph> = Graph::all(40).take(3).collect();
    assert_eq!(large[2], Graph::from_edges(40, &[(0, 2)]).unwrap());
    assert_eq!(Graph::all(4).count(), 64);
    assert!((3..5).all(|order| Graph::all(order).last() == Some(Graph::from_fn(order, |_, _| true))));
    let path = Graph::path(5);
    let renamed = Graph::from_edges(5, &[(3, 1), (1, 4), (4, 0), (0, 2)]).unwrap();
    assert_eq!(path.isomorphism_code(), renamed.isomorphism_code());
}

/// The classes against all labelled graphs: of each orbit under all renamings the first.
#[test]
fn connected_graphs_are_the_first_of_their_orbits() {
    for order in 0..=6usize {
        let names = renamings(order);
        let bit = |i: usize, j: usize| 1usize << (i.max(j) * (i.max(j) - 1) / 2 + i.min(j));
        let mut seen = vec![false; 1 << (order * order.saturating_sub(1) / 2)];
        let mut first = Vec::new();
        for (code, graph) in Graph::all(order).enumerate() {
            if !seen[code] && graph.is_connected() {
                for name in &names {
                    seen[graph.edges().iter().map(|&(i, j)| bit(name[i], name[j])).sum::<usize>()] = true;
                }
                first.push(graph);
            }
        }
        assert_eq!(Graph::connected_up_to_isomorphism(order), first, "{order}");
    }
    assert_eq!(Graph::connected_up_to_isomorphism(7).len(), 853);
    assert!(Graph::connected_up_to_isomorphism(10).is_empty());
}

/// All orders of `0..count`.
fn renamings(count: usize) -> Vec<Vec<usize>> {
    let Some(last) = count.checked_sub(1) else { return vec![Vec::new()] };
    let inserted =
        |shorter: Vec<usize>| (0..count).map(move |place| [&shorter[..place], &[last], &shorter[place..]].concat());
    renamings(last).into_iter().flat_map(inserted).collect()
}

#[test]
fn edges_come_and_go() {
    for n in [1, 64, 65, 70, 130] {
        assert_eq!(Graph::path(n).closed_adjacency(), Footprint::from_fn(n, n, |i, j| i.abs_diff(j) < 2), "{n}");
    }
    for (i, j) in [(0, 1), (3, 2), (0, 69), (3, 64), (65, 69)] {
        let mut graph = Graph::path(70);
        graph.toggle(i, j);
        let joined = |a: usize, b: usize| (a.abs_diff(b) == 1) != ((a, b) == (i, j) || (a, b) == (j, i));
        assert_eq!(graph, Graph::from_fn(70, joined), "{i} {j}");
        graph.toggle(j, i);
        assert_eq!(graph, Graph::path(70));
        graph.toggle(i, i);
        graph.toggle(i, 70);
        graph.toggle(128, j);
        assert_eq!(graph, Graph::path(70));
    }
}

/// Outside of matrices and graphs there is nothing, and nobody panics about it.
#[test]
fn places_that_are_not_there_are_zero() {
    let path = Graph::path(70);
    assert!(!path.has_edge(3, 70) && !path.has_edge(70, 3) && !path.has_edge(0, 128) && path.has_edge(68, 69));
    assert!(path.neighbours(70).is_empty() && path.degree(1000) == 0);
    assert_eq!(path.induced(&[68, 69, 70]), Graph::from_edges(3, &[(0, 1)]).unwrap());
    let small = Graph::path(2).closed_adjacency();
    assert_eq!(path.closed_adjacency().times(&small).rows(), 70);
    assert!(!path.closed_adjacency().contains(&small));
    let laplacian = path.laplacian().unwrap();
    assert!(laplacian.row(70).is_empty());
    assert_eq!(laplacian.entry(0, 70), rational(0, 1));
    let sparse = SparseMatrix::from_dense(&laplacian).unwrap();
    assert!(sparse.row(70).is_empty() && sparse.get(70, 0).is_none());
    assert_eq!(sparse.principal(&[0, 99]).order(), 2);
}

/// An edge is an arc each way: in every format it stands beside no arc between its ends, and both lines are told.
#[test]
fn edges_and_arcs_are_listed_once_in_every_format() {
    let graphml = |edges: &str| {
        format!(
            "<graphml><graph edgedefault=\"undirected\">\n<node id=\"a\"/><node id=\"b\"/>\n{edges}</graph></graphml>"
        )
    };
    let twice = [
        ("1 2\n2 3\n2 1 5\n".to_string(), 3, 1),
        ("directed\n1 2\n2 1\n1 2\n".to_string(), 4, 2),
        ("%%MatrixMarket matrix coordinate pattern general\n2 2 2\n1 2\n1 2\n".to_string(), 4, 3),
        (graphml("<edge source=\"a\" target=\"b\"/>\n<edge source=\"b\" target=\"a\"/>\n"), 4, 3),
        (graphml("<edge source=\"a\" target=\"b\"/>\n<edge source=\"b\" target=\"a\" directed=\"true\"/>\n"), 4, 3),
        (graphml("<edge source=\"a\" target=\"b\" directed=\"true\"/>\n<edge source=\"b\" target=\"a\"/>\n"), 4, 3),
    ];
    for (text, again, before) in twice {
        match read_graph(&text) {
            Err(GraphReadError::Repeated { line, first, .. }) => assert_eq!((line, first), (again, before), "{text}"),
            other => panic!("{text}: {other:?}"),
        }
    }
    // Both arcs between two vertices are no repetition, and stay arcs.
    for (text, directed) in [
        ("directed\n1 2\n2 1\n".to_string(), true),
        ("1 2\n".to_string(), false),
        ("%%MatrixMarket matrix coordinate pattern general\n2 2 2\n1 2\n2 1\n".to_string(), true),
        (graphml("<edge source=\"a\" target=\"b\"/>\n"), false),
        (graphml("<edge source=\"a\" target=\"b\" directed=\"true\"/>\n"), true),
    ] {
        let file = algebra::graph::read::read_graph_file(&text, false).expect("a graph");
        assert_eq!(
            (file.directed, file.graph.adjacency().entries().count() > 1),
            (directed, !text.contains("\"true\""))
        );
    }
}
mod invariants;
mod petgraph;
mod texts;

/// The labellings of one graph of each class are all labelled graphs, each once.
#[test]
fn labellings_of_classes_are_all_labelled_graphs() {
    let distinct = |classes: Vec<AnyGraph>| {
        let all: Vec<String> = classes.iter().flat_map(AnyGraph::labellings).map(|graph| graph.to_string()).collect();
        let count = all.len();
        assert_eq!(all.into_iter().collect::<std::collections::BTreeSet<_>>().len(), count);
        count
    };
    let simple = |list: Vec<Graph>| distinct(list.into_iter().map(AnyGraph::Simple).collect());
    assert_eq!([1, 2, 3, 4, 5].map(|n| simple(graphs(n, &Unwatched).unwrap())), [1, 2, 8, 64, 1024]);
    assert_eq!([1, 2, 3, 4, 5].map(|n| simple(trees(n, &Unwatched).unwrap())), [1, 1, 3, 16, 125]);
    let directed = |n| distinct(digraphs(n, &Unwatched).unwrap().into_iter().map(AnyGraph::Directed).collect());
    assert_eq!([1, 2, 3, 4].map(directed), [1, 4, 64, 4096]);
    let path: AnyGraph = "path:3".parse().unwrap();
    assert_eq!(path.labellings().first().map(|graph| graph.arcs()), Some(path.arcs()));
}
