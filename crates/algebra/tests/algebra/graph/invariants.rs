//! Every quantity against a twin that only counts, over all graphs of up to five vertices with labels and all classes of six.

use algebra::graph::Graph;
use algebra::graph::classes::{bipartite_graphs, graphs, planar_graphs, regular_graphs};
use algebra::graph::invariants::{is_rooted, period};
use algebra::graph::{NamedGraph, WeightedGraph};
use arithmetic::{Rational, Unwatched, rational};
use num_bigint::{BigInt, BigUint};

/// All labelled graphs of one to four vertices and a graph of each class of five and six.
fn small() -> Vec<Graph> {
    let classes = (5..=6).flat_map(|n| graphs(n, &Unwatched).expect("graphs"));
    (1..=4).flat_map(Graph::all).chain(classes).collect()
}

/// Random graphs of 7 to 11 vertices, from few edges to nearly all; the same in every run.
fn random(count: usize) -> impl Iterator<Item = Graph> {
    let mut state = 5u64;
    let mut next = move |below: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % below
    };
    (0..count).map(move |k| {
        let (order, share) = (7 + k % 5, 1 + next(9));
        let pairs = (0..order).flat_map(|j| (0..j).map(move |i| (i, j)));
        let edges: Vec<(usize, usize)> = pairs.filter(|_| next(10) < share).collect();
        Graph::from_edges(order, &edges).expect("a graph")
    })
}

fn sets(count: usize) -> impl Iterator<Item = Vec<usize>> {
    (0u64..1 << count).map(move |bits| (0..count).filter(|k| bits >> k & 1 == 1).collect())
}

/// All lists of different vertices.
fn sequences(order: usize, length: usize) -> Vec<Vec<usize>> {
    if length == 0 {
        return vec![Vec::new()];
    }
    let longer = |list: Vec<usize>| {
        (0..order).filter(|v| !list.contains(v)).map(|v| [&list[..], &[v]].concat()).collect::<Vec<_>>()
    };
    sequences(order, length - 1).into_iter().flat_map(longer).collect()
}

fn named(name: &str) -> Graph {
    let graph = name.parse::<NamedGraph>().expect("a name").build().expect("a graph");
    Graph::from_fn(graph.order(), |i, j| graph.adjacency().get(i, j).is_some())
}

fn twins<T: PartialEq + std::fmt::Debug>(fast: impl Fn(&Graph) -> T, naive: impl Fn(&Graph) -> T) {
    for graph in small() {
        assert_eq!(fast(&graph), naive(&graph), "{:?}", graph.edges());
    }
}

fn boundary(graph: &Graph, set: &[usize]) -> usize {
    graph.edges().iter().filter(|(i, j)| set.contains(i) != set.contains(j)).count()
}

fn is_forest(order: usize, edges: &[(usize, usize)]) -> bool {
    algebra::graph::component_numbers(order, edges.iter().copied()).1 + edges.len() == order
}

#[test]
fn girth_is_the_shortest_cycle() {
    twins(Graph::girth, |graph| {
        let n = graph.order();
        let closes = |list: &Vec<usize>| (0..list.len()).all(|k| graph.has_edge(list[k], list[(k + 1) % list.len()]));
        (3..=n).find(|&length| sequences(n, length).iter().any(closes))
    });
    assert_eq!(
        ["petersen", "hypercube:4", "ring:11", "path:9", "wheel:6"].map(|name| named(name).girth()),
        [Some(5), Some(4), Some(11), None, Some(3)]
    );
}

#[test]
fn two_colours_are_enough_for_bipartite_graphs() {
    twins(Graph::is_bipartite, |graph| sets(graph.order()).any(|set| boundary(graph, &set) == graph.edges().len()));
}

#[test]
fn cliques_independent_sets_and_colours() {
    let within = |graph: &Graph, joined: bool| {
        let all = |set: &Vec<usize>| set.iter().all(|&i| set.iter().all(|&j| i == j || graph.has_edge(i, j) == joined));
        sets(graph.order()).filter(all).map(|set| set.len()).max()
    };
    twins(|graph| graph.clique_number(&Unwatched), |graph| Ok(within(graph, true)));
    twins(|graph| graph.independence_number(&Unwatched), |graph| Ok(within(graph, false)));
    let proper = |graph: &Graph, colours: usize| {
        let edges = graph.edges();
        (0..colours.pow(graph.order() as u32)).any(|code| {
            let colour = |v: usize| code / colours.pow(v as u32) % colours;
            edges.iter().all(|&(i, j)| colour(i) != colour(j))
        })
    };
    twins(|graph| graph.chromatic_number(&Unwatched), |graph| Ok((1..).find(|&colours| proper(graph, colours))));
    let petersen = named("petersen");
    assert_eq!(petersen.chromatic_number(&Unwatched), Ok(Some(3)));
    assert_eq!(
        (petersen.clique_number(&Unwatched), petersen.independence_number(&Unwatched)),
        (Ok(Some(2)), Ok(Some(4)))
    );
    assert_eq!(named("complete:64").chromatic_number(&Unwatched), Ok(Some(64)));
    assert_eq!(named("path:65").chromatic_number(&Unwatched), Ok(None));
}

#[test]
fn matchings_are_the_largest_sets_of_separate_edges() {
    twins(Graph::matching_number, |graph| {
        let edges = graph.edges();
        let separate = |set: &Vec<usize>| {
            let mut ends: Vec<usize> = set.iter().flat_map(|&k| [edges[k].0, edges[k].1]).collect();
            ends.sort_unstable();
            ends.windows(2).all(|pair| pair[0] != pair[1])
        };
        sets(edges.len()).filter(separate).map(|set| set.len()).max().unwrap_or(0)
    });
    // By Tutte and Berge, over classes of eight vertices and larger graphs, where blossoms lie in blossoms: the least of (n + |U| - odd components without U)/2.
    let classes = graphs(8, &Unwatched).expect("graphs");
    for graph in classes.into_iter().step_by(5).chain(random(40)) {
        let order = graph.order();
        let bound = |set: Vec<usize>| {
            let rest: Vec<usize> = (0..order).filter(|v| !set.contains(v)).collect();
            let odd = graph.induced(&rest).components().iter().filter(|part| part.len() % 2 == 1).count();
            (order + set.len() - odd) / 2
        };
        assert_eq!(Some(graph.matching_number()), sets(order).map(bound).min(), "{:?}", graph.edges());
    }
    assert_eq!(named("petersen").matching_number(), 5);
}

#[test]
fn connectivity_is_what_must_be_removed() {
    twins(
        |graph| graph.edge_connectivity(&Unwatched).expect("a number"),
        |graph| {
            let n = graph.order();
            sets(n).filter(|set| !set.is_empty() && set.len() < n).map(|set| boundary(graph, &set)).min().unwrap_or(0)
        },
    );
    twins(
        |graph| graph.vertex_connectivity(&Unwatched).expect("a number"),
        |graph| {
            let left = |set: &Vec<usize>| (0..graph.order()).filter(|v| !set.contains(v)).collect::<Vec<usize>>();
            let parts = |set: &Vec<usize>| left(set).len() == 1 || graph.induced(&left(set)).components().len() > 1;
            sets(graph.order()).filter(parts).map(|set| set.len()).min().unwrap_or(0)
        },
    );
    for graph in random(60) {
        let (n, held) = (graph.order(), graph.vertex_connectivity(&Unwatched).expect("a number"));
        let cuts = sets(n).filter(|set| !set.is_empty() && set.len() < n);
        assert_eq!(graph.edge_connectivity(&Unwatched).ok(), cuts.map(|set| boundary(&graph, &set)).min(), "{graph:?}");
        let left = |set: &Vec<usize>| (0..n).filter(|v| !set.contains(v)).collect::<Vec<usize>>();
        let parts = |set: &Vec<usize>| left(set).len() == 1 || graph.induced(&left(set)).components().len() > 1;
        assert_eq!(Some(held), sets(n).filter(parts).map(|set| set.len()).min(), "{graph:?}");
    }
    assert_eq!(named("petersen").vertex_connectivity(&Unwatched), Ok(3));
    assert_eq!(named("hypercube:5").edge_connectivity(&Unwatched), Ok(5));
}

#[test]
fn cuts_are_compared_with_all_sets() {
    fn least(graph: &Graph, size: impl Fn(&[usize]) -> usize) -> Option<Rational> {
        let ratio = |set: Vec<usize>| {
            let other: Vec<usize> = (0..graph.order()).filter(|v| !set.contains(v)).collect();
            let smaller = size(&set).min(size(&other));
            (smaller > 0).then(|| rational(boundary(graph, &set) as i64, smaller as i64))
        };
        sets(graph.order()).filter_map(ratio).min()
    }
    let volume = |graph: &Graph| least(graph, |set| set.iter().map(|&v| graph.degree(v)).sum());
    twins(|graph| graph.cheeger_constant(&Unwatched).expect("a number"), volume);
    twins(|graph| graph.isoperimetric_number(&Unwatched).expect("a number"), |graph| least(graph, <[usize]>::len));
    assert_eq!(named("hypercube:4").isoperimetric_number(&Unwatched), Ok(Some(rational(1, 1))));
    assert_eq!(named("path:25").cheeger_constant(&Unwatched), Ok(None));
}

#[test]
fn trees_and_resistances_are_counted_by_forests() {
    let forests = |graph: &Graph, size: usize| {
        let edges = graph.edges();
        let chosen = sets(edges.len()).filter(|set| set.len() == size);
        let list = chosen.map(|set| set.into_iter().map(|k| edges[k]).collect::<Vec<_>>());
        list.filter(|list| is_forest(graph.order(), list)).collect::<Vec<_>>()
    };
    twins(Graph::spanning_trees, |graph| BigInt::from(forests(graph, graph.order() - 1).len()));
    // The resistance is the share of forests of two parts that hold the two vertices apart, among the trees.
    twins(Graph::resistances, |graph| {
        let n = graph.order();
        let trees = forests(graph, n - 1).len() as i64;
        let pairs = if n > 1 { forests(graph, n - 2) } else { Vec::new() };
        let apart = |i: usize, j: usize| {
            let held = |list: &&Vec<(usize, usize)>| {
                let (numbers, _) = algebra::graph::component_numbers(n, list.iter().copied());
                numbers[i] != numbers[j]
            };
            pairs.iter().filter(held).count() as i64
        };
        (trees > 0).then(|| (0..n).map(|i| (0..n).map(|j| rational(apart(i, j), trees)).collect()).collect())
    });
    twins(Graph::kirchhoff_index, |graph| {
        let resistances = graph.resistances()?;
        Some(resistances.iter().flatten().fold(Rational::default(), |sum, r| sum + r) * rational(1, 2))
    });
    // Cayley, on either side of the largest order that is counted in words.
    for n in [15u32, 16, 17, 20] {
        assert_eq!(Graph::complete(n as usize).spanning_trees(), BigInt::from(n).pow(n - 2), "{n}");
    }
    assert_eq!(named("petersen").spanning_trees(), BigInt::from(2000));
    assert_eq!(named("complete:7").kirchhoff_index(), Some(rational(6, 1)));
}

#[test]
fn automorphisms_are_the_renamings_that_change_nothing() {
    twins(
        |graph| graph.automorphism_count(&Unwatched).expect("a number"),
        |graph| {
            let n = graph.order();
            let same = |names: &&Vec<usize>| {
                (0..n).all(|i| (0..i).all(|j| graph.has_edge(i, j) == graph.has_edge(names[i], names[j])))
            };
            BigUint::from(sequences(n, n).iter().filter(same).count())
        },
    );
    for (name, count) in [
        ("petersen", 120u64),
        ("hypercube:4", 384),
        ("ring:30", 60),
        ("bipartite:3,3", 72),
        ("complete:20", 2_432_902_008_176_640_000),
    ] {
        assert_eq!(named(name).automorphism_count(&Unwatched), Ok(BigUint::from(count)), "{name}");
    }
}

/// Kuratowski and Wagner: not planar is what can be contracted to a graph that holds the complete graph of five, or three and three.
fn has_forbidden_minor(graph: &Graph) -> bool {
    let n = graph.order();
    let complete = |list: &Vec<usize>| list.iter().all(|&i| list.iter().all(|&j| i == j || graph.has_edge(i, j)));
    if sets(n).filter(|set| set.len() == 5).any(|set| complete(&set)) {
        return true;
    }
    let threes = || sets(n).filter(|set| set.len() == 3);
    let sides = |a: &Vec<usize>, b: &Vec<usize>| a.iter().all(|&i| b.iter().all(|&j| graph.has_edge(i, j)));
    if threes().any(|a| threes().any(|b| sides(&a, &b))) {
        return true;
    }
    let contracted = |(i, j): (usize, usize)| {
        let rest: Vec<usize> = (0..n).filter(|&v| v != j).collect();
        Graph::from_fn(n - 1, |a, b| {
            let (a, b) = (rest[a], rest[b]);
            graph.has_edge(a, b) || (a == i && graph.has_edge(j, b)) || (b == i && graph.has_edge(a, j))
        })
    };
    n > 5 && graph.edges().into_iter().any(|edge| has_forbidden_minor(&contracted(edge)))
}

#[test]
fn planarity_is_that_of_kuratowski() {
    twins(Graph::is_planar, |graph| !has_forbidden_minor(graph));
    for graph in graphs(7, &Unwatched).expect("graphs").iter().step_by(3) {
        assert_eq!(graph.is_planar(), !has_forbidden_minor(graph), "{:?}", graph.edges());
    }
    for (name, is_planar) in [
        ("petersen", false),
        ("hypercube:3", true),
        ("hypercube:4", false),
        ("grid:7x9", true),
        ("wheel:12", true),
        ("bipartite:2,9", true),
        ("bipartite:3,3", false),
        ("circulant:12:1,6", false),
        ("circulant:12:1,2", true),
    ] {
        assert_eq!(named(name).is_planar(), is_planar, "{name}");
    }
}

/// OEIS A033995, A005470, A005638 and A033301.
#[test]
fn classes_have_the_known_numbers_and_are_those_of_all_graphs() {
    let count = |list: Result<Vec<Graph>, _>| list.expect("graphs").len();
    assert_eq!(
        (1..=9).map(|n| count(bipartite_graphs(n, &Unwatched))).collect::<Vec<_>>(),
        [1, 2, 3, 7, 13, 35, 88, 303, 1119]
    );
    assert_eq!(
        (1..=8).map(|n| count(planar_graphs(n, &Unwatched))).collect::<Vec<_>>(),
        [1, 2, 4, 11, 33, 142, 822, 6966]
    );
    assert_eq!([4, 6, 8, 10].map(|n| count(regular_graphs(n, 3, &Unwatched))), [1, 2, 6, 21]);
    assert_eq!([5, 6, 7, 8, 9, 10].map(|n| count(regular_graphs(n, 4, &Unwatched))), [1, 1, 2, 6, 16, 60]);
    for n in 1..=7 {
        let all = graphs(n, &Unwatched).expect("graphs");
        for d in 0..n {
            let filtered = all.iter().filter(|graph| (0..n).all(|i| graph.degree(i) == d)).count();
            assert_eq!(count(regular_graphs(n, d, &Unwatched)), filtered, "{n} {d}");
        }
        assert_eq!(count(bipartite_graphs(n, &Unwatched)), all.iter().filter(|graph| graph.is_bipartite()).count());
        assert_eq!(count(planar_graphs(n, &Unwatched)), all.iter().filter(|graph| graph.is_planar()).count());
    }
}

/// All digraphs of up to three vertices, loops left out: closed walks and ways by powers of the matrix.
#[test]
fn roots_and_periods_are_those_of_powers() {
    for order in 1..=3usize {
        for graph in WeightedGraph::all(order) {
            let joined = |i: usize, j: usize| graph.adjacency().get(i, j).is_some();
            let out: Vec<Vec<u32>> =
                (0..order).map(|i| (0..order as u32).filter(|&j| joined(i, j as usize)).collect()).collect();
            // Ways of each length up to 12.
            let mut powers: Vec<Vec<Vec<bool>>> =
                vec![(0..order).map(|i| (0..order).map(|j| i == j).collect()).collect()];
            for k in 0..12 {
                let last: &Vec<Vec<bool>> = &powers[k];
                let next = (0..order)
                    .map(|i| (0..order).map(|j| (0..order).any(|m| last[i][m] && joined(m, j))).collect())
                    .collect();
                powers.push(next);
            }
            let reaches = |i: usize, j: usize| powers.iter().any(|power| power[i][j]);
            let strong = (0..order).all(|i| (0..order).all(|j| reaches(i, j)));
            let lengths = (1..=12usize).filter(|&k| (0..order).any(|i| powers[k][i][i]));
            let divisor = lengths.fold(0, num_integer::gcd);
            assert_eq!(period(&out), (strong && divisor > 0).then_some(divisor), "{out:?}");
            assert_eq!(is_rooted(&out), (0..order).any(|root| (0..order).all(|i| reaches(i, root))), "{out:?}");
        }
    }
    assert_eq!(period(&[vec![0]]), Some(1));
    assert_eq!(period(&[vec![1], vec![2], vec![3], vec![0]]), Some(4));
    assert!(!is_rooted(&[]) && period(&[]).is_none());
}
