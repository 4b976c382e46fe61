//! Quantities of graphs in properties: theorems that hold, and planted statements that do not.

use super::{answer, asked, read, refusal, verdict};
use algebra::graph::{AnyGraph, Graph};
use question::Verdict::{False, Holds};

const CONNECTED: &str = "n = \"1..6\"\ngraph = \"connected(n)\"";

/// Each with a statement that differs from it by little and is false.
#[test]
fn theorems_hold_and_what_is_like_them_does_not() {
    for (family, theorem, planted) in [
        (CONNECTED, "sum(i, degree(i)) = 2*edges", "sum(i, degree(i)) = 2*edges + 1"),
        (CONNECTED, "radius <= diameter <= 2*radius", "diameter < 2*radius or n = 1"),
        (CONNECTED, "tree implies spanning_trees = 1", "tree implies spanning_trees = 2"),
        (CONNECTED, "tree or girth <= 2*diameter + 1", "tree or girth <= 2*diameter"),
        // Whitney.
        (
            CONNECTED,
            "vertex_connectivity <= edge_connectivity <= min_degree",
            "edge_connectivity <= vertex_connectivity",
        ),
        // Fiedler.
        (
            CONNECTED,
            "edges = n*(n - 1)/2 or lambda(2) <= vertex_connectivity",
            "n = 1 or lambda(2) <= vertex_connectivity",
        ),
        // Brooks.
        (
            CONNECTED,
            "chromatic_number <= max_degree or edges = n*(n - 1)/2 or (max_degree = 2 and not bipartite)",
            "chromatic_number <= max_degree or edges = n*(n - 1)/2",
        ),
        // Gallai, for graphs without isolated vertices; bipartite graphs: König.
        (
            CONNECTED,
            "bipartite and n > 1 implies independence_number + matching_number = n",
            "n > 1 implies independence_number + matching_number = n",
        ),
        (CONNECTED, "planar implies chromatic_number <= 4", "planar implies chromatic_number <= 3"),
        (CONNECTED, "n < 3 or not planar or edges <= 3*n - 6", "n < 3 or planar or edges > 3*n - 6"),
        // Kirchhoff and Foster: the resistances of the edges sum to n - 1.
        (CONNECTED, "sum(edge(i, j), resistance(i, j)) = n - 1", "sum(edge(i, j), resistance(i, j)) = n"),
        (
            CONNECTED,
            "kirchhoff_index = sum(pair(i, j), resistance(i, j))",
            "kirchhoff_index = sum(edge(i, j), resistance(i, j))",
        ),
        (
            CONNECTED,
            "max(pair(i, j), distance(i, j)) = diameter or n = 1",
            "max(edge(i, j), distance(i, j)) = diameter or n = 1",
        ),
        (CONNECTED, "min(vertex(i), eccentricity(i)) = radius", "max(vertex(i), eccentricity(i)) = radius"),
        (CONNECTED, "count(i, degree(i) = max_degree) >= 1", "count(i, degree(i) = max_degree) >= 2"),
        (
            CONNECTED,
            "sum(i where degree(i) > 1, 1) = n - count(i, degree(i) <= 1)",
            "sum(i where degree(i) > 1, 1) = n",
        ),
        (CONNECTED, "count(edge(i, j), adjacent(j, i)) = edges", "count(pair(i, j), adjacent(i, j)) < edges"),
        (
            "n = \"2..5\"\ngraph = \"connected(n)\"",
            "cheeger^2/2 <= lambda(2, normalised) <= 2*cheeger",
            "lambda(2, normalised) <= cheeger",
        ),
        (
            "n = \"2..5\"\ngraph = \"connected(n)\"",
            "lambda(2)/2 <= isoperimetric_number",
            "lambda(2) <= isoperimetric_number",
        ),
        (CONNECTED, "automorphisms >= 1", "automorphisms >= 2"),
        (
            "n = \"2..6\"\ngraph = \"bipartite(n)\"",
            "bipartite and (not connected or lambda(n, normalized) = 2)",
            "connected",
        ),
        ("n = \"2..6\"\ngraph = \"planar(n)\"", "planar", "edges < n*(n - 1)/2"),
        ("n = \"4..8\"\ngraph = \"regular(n, 3)\"", "regular and spectral_radius = 3", "connected"),
    ] {
        assert_eq!((verdict(family, theorem), verdict(family, planted)), (Holds, False), "{theorem}; {planted}");
    }
}

#[test]
fn several_matrices_stand_in_one_property() {
    let regular = "n = \"3..6\"\nd = 2\ngraph = \"regular(n, d)\"";
    assert_eq!(verdict(regular, "lambda(2) = d - lambda(n - 1, adjacency)"), Holds);
    assert_eq!(verdict(regular, "lambda(2) = d - lambda(n, adjacency)"), False);
    for k in 1..=3 {
        let same = format!("lambda({k}, walk) = lambda({k}, normalised) and lambda({k}) = lambda({k}, laplacian)");
        assert_eq!(verdict("graph = [\"path:3\", \"star:4\", \"petersen\", \"edges:3:1-2\"]", &same), Holds, "{k}");
    }
    // The order of eigenvalues is that of one matrix, not of two.
    assert_eq!(verdict("graph = \"path:3\"", "lambda(1, laplacian) <= lambda(2, adjacency)"), Holds);
    assert_eq!(verdict("graph = \"complete:3\"", "lambda(1, laplacian) <= lambda(2, adjacency)"), False);
    assert_eq!(verdict("graph = \"complete:3\"", "lambda(1, laplacian) <= lambda(2)"), Holds);
    assert_eq!(verdict("graph = \"path:3\"", "lambda(2, reduced) > lambda(1, reduced)"), Holds);
    let message = refusal(&asked("graph = \"path:3\"", "lambda(2, signless) > 0", "1 < 0"));
    assert!(message.contains("kind of matrix"), "{message}");
    let message = refusal(&asked("graph = \"path:3\"", "lambda(3, reduced) > 0", "1 < 0"));
    assert!(message.contains("between 1 and 2"), "{message}");
}

/// The signs of the eigenvector by iteration in floating point, where it tells zeros from others.
fn iterated(graph: &Graph) -> Vec<i64> {
    let n = graph.order();
    let mut v: Vec<f64> = (0..n).map(|i| ((i * i + 3 * i) as f64 * 0.7).sin()).collect();
    for _ in 0..4000 {
        let mean = v.iter().sum::<f64>() / n as f64;
        v.iter_mut().for_each(|x| *x -= mean);
        let shifted = |i: usize| {
            let around: f64 = graph.neighbours(i).iter().map(|&j| v[j as usize]).sum();
            (2.0 * n as f64 - graph.degree(i) as f64) * v[i] + around
        };
        let next: Vec<f64> = (0..n).map(shifted).collect();
        let size = next.iter().map(|x| x * x).sum::<f64>().sqrt();
        v = next.into_iter().map(|x| x / size).collect();
    }
    let sign = |x: f64| if x.abs() < 1e-7 { 0 } else { x.signum() as i64 };
    let first = v.iter().map(|&x| sign(x)).find(|&s| s != 0).unwrap_or(1);
    v.iter().map(|&x| first * sign(x)).collect()
}

#[test]
fn signs_of_the_fiedler_vector() {
    let mut seen = 0;
    for n in 2..=5 {
        for graph in algebra::graph::classes::connected_graphs(n, &arithmetic::Unwatched).expect("graphs") {
            let text = AnyGraph::Simple(graph.clone()).to_string();
            let family = format!("graph = \"{text}\"");
            let is_simple = n == 2 || verdict(&family, "lambda(3) > lambda(2)") == Holds;
            let signs = iterated(&graph);
            let all: Vec<String> = (1..=n).map(|i| format!("fiedler_sign({i}) = {}", signs[i - 1])).collect();
            if is_simple {
                seen += 1;
                assert_eq!(verdict(&family, &all.join(" and ")), Holds, "{text} {signs:?}");
            } else {
                assert!(refusal(&asked(&family, "fiedler_sign(1) = 1", "1 < 0")).contains("not simple"), "{text}");
            }
        }
    }
    assert!(seen > 10, "{seen}");
    assert_eq!(verdict("graph = \"path:4\"", "fiedler_sign(1) = 1 and fiedler_sign(4) = 1"), False);
}

#[test]
fn directed_graphs_have_roots_periods_and_moduli() {
    for (graph, property) in [
        ("cycle:6", "strongly_connected and rooted and period = 6 and second_modulus = 1"),
        ("arcs:3:1-2,3-2", "rooted and not strongly_connected and in_degree(2) = 2 and degree(2) = 0"),
        ("arcs:3:2-1,2-3", "not rooted"),
        ("ring:5", "period = 1 and second_modulus = cos(pi/5)"),
        ("ring:6", "period = 2 and second_modulus = 1"),
        ("complete:5", "second_modulus = 1/4"),
        ("arcs:2:1-1,1-2,2-1", "period = 1 and second_modulus = 1/2"),
        ("cycle:6", "spectral_radius = 1"),
        ("star:5", "spectral_radius = 2"),
    ] {
        assert_eq!(verdict(&format!("graph = \"{graph}\""), property), Holds, "{graph}");
    }
    // Of two states the other eigenvalue is the trace minus 1.
    assert_eq!(verdict("m = \"matrices:1/3 2/3; 1/4 3/4\"", "second_modulus = 1/12 and tau_1 = 1/12"), Holds);
    assert_eq!(verdict("m = \"matrices:0 1 0; 0 0 1; 1 0 0\"", "second_modulus = 1"), Holds);
    // Of three states the other two are conjugate here: their product is the determinant, 1/4.
    assert_eq!(verdict("m = \"matrices:1/2 1/2 0; 0 1/2 1/2; 1/2 0 1/2\"", "second_modulus = 1/2"), Holds);
    assert_eq!(verdict("m = \"stochastic(3, 2)\"", "second_modulus <= tau_1"), Holds);
    assert_eq!(verdict("m = \"stochastic(3, 2)\"", "second_modulus <= tau_1/2"), False);
    for (graph, property, word) in [
        ("arcs:2:1-2", "period > 0", "does not exist"),
        ("arcs:2:1-2", "second_modulus > 0", "no neighbour"),
        ("cycle:5", "girth > 0", "undirected"),
        ("path:4", "girth > 0", "without cycles"),
        ("edges:2:1-2*2", "spanning_trees > 0", "weight 1"),
        ("edges:2:1-2*-1", "spectral_radius > 0", "negative"),
        ("path:4", "degree(5) > 0", "between 1 and 4"),
        ("path:65", "chromatic_number > 0", "stayed undecided"),
    ] {
        let text = asked(&format!("graph = \"{graph}\""), property, "1 < 0");
        let message = match question::decide(&read(&text).expect("a question"), &arithmetic::Unwatched) {
            Ok(answer) => answer.why,
            Err(error) => error.to_string(),
        };
        assert!(message.contains(word), "{graph}: {message}");
    }
}

#[test]
fn definitions_are_put_in_their_places() {
    let text = |define: &str, property: &str| {
        format!("[question]\nid = \"x\"\n[for]\n{CONNECTED}\n[define]\n{define}\n[holds]\nproperty = \"{property}\"\n")
    };
    let verdict = |define: &str, property: &str| answer(&text(define, property)).verdict;
    // Randić's index is at most n/2, attained by regular graphs.
    let randic = "randic = \"sum(edge(i, j), 1/sqrt(degree(i)*degree(j)))\"";
    assert_eq!((verdict(randic, "randic <= n/2"), verdict(randic, "n = 1 or randic < n/2")), (Holds, False));
    // A name that the definition binds is not that of the argument.
    let around = "\"around(k)\" = \"count(i, adjacent(i, k))\"\nall = \"sum(i, around(i))\"";
    assert_eq!((verdict(around, "all = 2*edges"), verdict(around, "all = 0")), (Holds, False));
    let nested =
        "\"f(k)\" = \"sum(i, distance(i, k))\"\nwiener = \"sum(i, f(i))/2\"\n\"isolated(i)\" = \"degree(i) = 0\"";
    assert_eq!(verdict(nested, "wiener = sum(pair(i, j), distance(i, j)) and (n = 1 or not isolated(1))"), Holds);
    for (define, property, word) in [
        ("edges = \"1\"", "edges > 0", "stands for something else"),
        ("\"f(i, i)\" = \"1\"", "1 > 0", "a name"),
        ("f = \"g\"", "f > 0", "there is no name `g`"),
        ("f = \"f\"", "f > 0", "there is no name `f`"),
        ("\"f(i)\" = \"degree(i)\"", "f > 0", "takes 1 argument"),
        ("f = \"sum(edges, 1)\"", "f > 0", "stands for something else"),
        ("f = \"sum(i)\"", "f > 0", "goes through a graph"),
        ("f = \"sum(edge(i, i), 1)\"", "f > 0", "two names"),
        ("f = \"sum(i, sum(i, 1))\"", "f > 0", "a vertex already"),
        ("sum = \"1\"", "sum > 0", "word of the language"),
    ] {
        let message = refusal(&text(define, property));
        assert!(message.contains(word), "{define}: {message}");
    }
    let replay = answer(&text(around, "all < 6")).replay.expect("a replay");
    assert_eq!(answer(&replay).verdict, False);
}

#[test]
fn every_text_of_a_graph_stands_in_a_family() {
    for (graph, property) in [
        ("petersen", "n = 10 and edges = 15 and girth = 5 and automorphisms = 120 and not planar"),
        ("graph6:DQc", "n = 5 and edges = 4"),
        ("sparse6::Fa@x^", "n = 7 and edges = 4"),
        ("digraph6:&DI?AO?", "n = 5 and edges = 4 and in_degree(5) = 2"),
        ("grid:3x4", "n = 12 and bipartite"),
        ("bipartite:3,4", "n = 7 and chromatic_number = 2"),
        ("hypercube(3)", "n = 8 and regular"),
        ("wheel(5)", "n = 5 and chromatic_number = 3"),
    ] {
        assert_eq!(verdict(&format!("graph = '{graph}'"), property), Holds, "{graph}");
    }
    for (graph, word) in [
        ("peterson", "petersen"),
        ("rings:5", "did you mean ring:N"),
        ("conected(4)", "connected"),
        ("petersen(10)", "written petersen"),
        ("edges:4:1-5", "the vertices are 1 to 4"),
    ] {
        let message = refusal(&asked(&format!("graph = \"{graph}\""), "edges > 0", "1 < 0"));
        assert!(message.contains(word) && message.contains("line 4, column"), "{message}");
    }
    // A file of several graphs is a family.
    let text = asked("graph = \"file:some.g6\"", "edges = 4", "edges < 0");
    let files = |_: &str| Ok("DQc\nCF\n".to_string());
    let question = question::Question::read(&text, &files).expect("a question");
    let answer = question::decide(&question, &arithmetic::Unwatched).expect("an answer");
    assert_eq!((answer.verdict, answer.cases), (False, 2));
}

/// Functions that the program is given: exact numbers decide, floating-point numbers do not.
#[test]
fn functions_of_graphs_are_given() {
    use arithmetic::{Unwatched, rational};
    use question::{Given, GivenValue, Question, Verdict, decide};
    use std::sync::Arc;
    let given = |name: &str, is_float: bool| {
        let measure = move |graph: &AnyGraph| match (graph.order(), is_float) {
            (1, _) => GivenValue::Missing("a single vertex".to_string()),
            (n, false) => GivenValue::Exact(rational(n as i64, 2)),
            (n, true) => GivenValue::Float(rational(n as i64, 2)),
        };
        Given::new(name.to_string(), Arc::new(measure))
    };
    let text = |property: &str| asked("n = \"1..4\"\ngraph = \"connected(n)\"", property, "edges < 0");
    let verdict = |property: &str, is_float: bool| {
        let question = Question::read_with(&text(property), &super::no_files, vec![given("half", is_float)])?;
        decide(&question, &Unwatched).map(|answer| (answer.verdict, answer.grades))
    };
    assert_eq!(verdict("n > 1 implies half = n/2", false), Ok((Holds, vec!["exhaustive"])));
    assert_eq!(verdict("n > 1 implies graph.half < n/2", false), Ok((False, vec!["exact"])));
    assert_eq!(verdict("n > 1 implies half = n/2", true), Ok((Verdict::Undecided, vec!["simulated"])));
    assert_eq!(verdict("n > 1 implies half < n/2", true), Ok((Verdict::Undecided, vec!["simulated"])));
    assert!(verdict("half = n/2", false).expect_err("missing").to_string().contains("a single vertex"));
    for name in ["edges", "n", "sqrt", "sum", "not", "a b", "graph"] {
        let found = Question::read_with(&text("edges > 0"), &super::no_files, vec![given(name, false)]);
        assert!(found.is_err(), "{name}");
    }
}

/// What takes no account of loops or weights refuses them, rather than speak of another graph.
#[test]
fn loops_and_weights_are_refused_where_they_would_be_dropped() {
    for quantity in [
        "girth",
        "edge_connectivity",
        "vertex_connectivity",
        "clique_number",
        "independence_number",
        "chromatic_number",
        "matching_number",
        "automorphisms",
        "cheeger",
        "isoperimetric_number",
        "spanning_trees",
    ] {
        let text = asked("graph = \"edges:3:1-1*1,1-2,2-3,1-3\"", &format!("{quantity} >= 0"), "n < 0");
        let error = refusal(&text);
        assert!(error.contains("graphs without loops, and vertex 1 has one"), "{quantity}: {error}");
    }
    for truth in ["tree", "bipartite", "regular", "planar"] {
        let error = refusal(&asked("graph = \"edges:3:1-2,3-3*1,2-3\"", truth, "n < 0"));
        assert!(error.contains("vertex 3 has one"), "{truth}: {error}");
    }
    for quantity in ["automorphisms", "cheeger", "isoperimetric_number", "kirchhoff_index"] {
        let error = refusal(&asked("graph = \"edges:3:1-2*2,2-3\"", &format!("{quantity} > 0"), "n < 0"));
        assert!(error.contains("edges all have weight 1"), "{quantity}: {error}");
    }
}

/// Families around a graph take one by any of its names.
#[test]
fn graphs_with_names_have_neighbours() {
    for name in ["ring:5", "edges:5:1-2,2-3,3-4,4-5,1-5", "path:5", "petersen"] {
        let family = format!("g = \"{name}\"\ngraph = \"with_link(g)\"");
        assert_eq!(
            answer(&asked(&family, "graph.tree or graph.edges >= 4", "graph.edges < 4")).verdict,
            Holds,
            "{name}"
        );
    }
    let error =
        refusal(&asked("g = \"edges:3:1-2*2,2-3\"\ngraph = \"with_link(g)\"", "graph.edges > 0", "graph.edges < 0"));
    assert!(error.contains("weight 1"), "{error}");
}

/// A tie of two irrational eigenvalues takes many bits to be known: what is shown beside the counterexample is the inequality that fails all the same.
#[test]
fn the_inequality_that_fails_is_shown_where_it_is_a_tie() {
    for (graph, property, shown) in [
        ("ring:5", "edges = 5 implies lambda(2) < lambda(3)", "lambda(2) < lambda(3)"),
        ("ring:5", "diameter = 2 and radius = 2 implies lambda(2) > lambda(3)", "lambda(2) > lambda(3)"),
        ("ring:7", "n = 8 or lambda(2) < lambda(3)", "lambda(2) < lambda(3)"),
    ] {
        let found = answer(&asked(&format!("graph = \"{graph}\""), property, "edges < 0"));
        assert_eq!((found.verdict, found.decisive.map(|own| own.inequality)), (False, Some(shown.to_string())));
    }
}
