//! The one grammar of graphs.

use algebra::graph::read::read_graph_file;
use algebra::graph::{AnyGraph, Graph, graph6};
use arithmetic::Unwatched;

fn read(text: &str) -> AnyGraph {
    text.parse().unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn why(text: &str) -> String {
    text.parse::<AnyGraph>().expect_err("no graph").to_string()
}

#[test]
fn names_have_their_vertices_and_edges() {
    for (name, order, edges) in [
        ("petersen", 10, 15),
        ("hypercube:0", 1, 0),
        ("hypercube:3", 8, 12),
        ("grid:3x4", 12, 17),
        ("grid:1x5", 5, 4),
        ("grid:5x1", 5, 4),
        ("bipartite:3,4", 7, 12),
        ("wheel:4", 4, 6),
        ("wheel:7", 7, 12),
        ("empty:3", 3, 0),
    ] {
        let graph = read(name);
        assert_eq!(
            (graph.order(), graph.arcs().len(), graph.to_string()),
            (order, 2 * edges, name.to_string()),
            "{name}"
        );
        assert!(!graph.is_directed());
    }
    // Rows and columns as they are counted.
    assert_eq!(
        read("grid:2x3").simple().expect("undirected").edges(),
        [(0, 1), (1, 2), (0, 3), (1, 4), (3, 4), (2, 5), (4, 5)]
    );
}

/// What is printed is read again, and what is unknown is not taken for something else.
#[test]
fn texts_are_read_again() {
    for text in
        ["edges:4:1-2,2-3*1/2", "arcs:3:1-2,2-1,2-3", "edges:3:", "ring:7", "platoon2:4", "petersen", "bipartite:2,3"]
    {
        let graph = read(text);
        assert_eq!(graph.to_string(), text);
        assert_eq!(
            (read(&graph.to_string()).arcs(), graph.is_directed()),
            (graph.arcs(), text.starts_with("arcs") || text.starts_with("platoon"))
        );
    }
    for text in [
        "Petersen",
        "petersen:10",
        "hypercube",
        "grid:3,4",
        "bipartite:3x4",
        "wheel:3",
        "IheA@GUAo",
        "k4",
        "",
        "graph6",
        "edges",
        "ring:3:4",
    ] {
        let message = why(text);
        assert!(!message.is_empty() && text.parse::<AnyGraph>().is_err(), "{text}: {message}");
    }
    for (text, near) in [
        ("peterson", "petersen"),
        ("rign:4", "ring:N"),
        ("hipercube:3", "hypercube:D"),
        ("edge:3:1-2", "edges:N:1-2,2-3"),
    ] {
        assert!(why(text).contains(&format!("did you mean {near}? Known are ring:N, ")), "{}", why(text));
    }
    assert!(!why("nonsense:4").contains("did you mean"));
}

/// What is wrong in a list is told in plain words, with its byte.
#[test]
fn a_list_of_edges_is_refused_where_it_is_wrong() {
    for (text, at, word) in [
        ("edges:4:1-5", 8, "names `5`, and the vertices are 1 to 4"),
        ("arcs:4:1-2, 0-2", 12, "names `0`"),
        ("edges:4:1-2,3-3", 12, "the edge `3-3` joins a vertex with itself; a loop that is meant has a weight, 3-3*1"),
        ("edges:0:", 6, "between 1 and 10000, not `0`"),
        ("edges:4:1-2,23", 12, "not of the form"),
        ("edges:4:1-2*x", 8, "x"),
        ("edges:4", 6, "not of the form"),
    ] {
        let error = text.parse::<AnyGraph>().expect_err(text);
        assert_eq!(error.at(), at, "{error}");
        assert!(error.to_string().contains(word), "{error}");
    }
    let loops = read("edges:3:1-1*1,1-2");
    assert_eq!((loops.to_string().as_str(), loops.arcs().len()), ("edges:3:1-1*1,1-2", 3));
    assert_eq!(read("arcs:2:1-1,1-2").to_string(), "arcs:2:1-1,1-2");
}

#[test]
fn the_formats_of_nauty_are_read() {
    // From formats.txt of nauty: five vertices, 0-2, 0-4, 1-3, 3-4.
    let edges = [(0, 2), (1, 3), (0, 4), (3, 4)];
    assert_eq!(read("graph6:DQc").simple().expect("undirected").edges(), edges);
    // Seven vertices, 0-1, 0-2, 1-2, 5-6.
    assert_eq!(read("sparse6::Fa@x^").simple().expect("undirected").edges(), [(0, 1), (0, 2), (1, 2), (5, 6)]);
    assert_eq!(read(">>sparse6<<:Fa@x^").order(), 7);
    // Five vertices, 0->2, 0->4, 3->1, 3->4.
    let directed = read("digraph6:&DI?AO?");
    assert!(directed.is_directed());
    assert_eq!(directed.arcs(), [(0, 2), (0, 4), (3, 1), (3, 4)]);
    assert_eq!(read("graph6:IheA@GUAo").simple().expect("undirected").automorphism_count(&Unwatched), Ok(120u8.into()));
    for n in [0, 1, 2, 5, 6, 62, 63, 64, 100] {
        let graph = Graph::ring(n);
        assert_eq!(graph6::read_graph6(&graph.graph6().expect("a text")), Ok(graph), "{n}");
    }
    for text in [
        "graph6:D",
        "graph6:DQcc",
        "graph6:DQ\u{e9}",
        "graph6:",
        "graph6:?",
        "graph6:~~~~~~~~",
        "sparse6::",
        "digraph6:&D",
        "graph6:A`",
    ] {
        assert!(text.parse::<AnyGraph>().is_err(), "{text}");
    }
}

#[test]
fn files_of_nauty_have_one_graph_or_several() {
    for (text, count) in [
        ("DQc\n", 1),
        (">>graph6<<DQc\nCF\n", 2),
        (":Fa@x^\n\n:An\n", 2),
        ("1 2\n2 3\n", 1),
        ("directed\n1 2\n", 1),
        ("&DI?AO?\n", 1),
    ] {
        assert_eq!(AnyGraph::read_file(text, false).expect("graphs").len(), count, "{text}");
        assert_eq!(read_graph_file(text, false).is_ok(), count == 1, "{text}");
    }
    assert_eq!(
        AnyGraph::read_file("DQc\nDQcc\n", false).expect_err("no graph").to_string().split(':').next(),
        Some("line 2")
    );
}

/// Text of sparse6 without its mark would be read as some other graph; the vertex that is called leader is the first.
#[test]
fn marks_are_needed_and_leaders_come_first() {
    for text in ["sparse6:DQc", "sparse6:Bw", "digraph6:DI?AO?", ">>sparse6<<Fa@x^"] {
        assert!(text.parse::<AnyGraph>().expect_err("no mark").to_string().contains("begins with"), "{text}");
    }
    let read = |text: &str| AnyGraph::read_file(text, false).expect("a graph").remove(0);
    let arcs = |graph: &AnyGraph| graph.arcs().into_iter().filter(|(i, j)| i < j).collect::<Vec<_>>();
    assert_eq!(arcs(&read("car1 leader\ncar2 car1\ncar3 car1\n")), [(0, 1), (1, 2), (1, 3)]);
    assert_eq!(arcs(&read("leader car1\ncar2 car1\n")), [(0, 1), (1, 2)]);
    assert_eq!(arcs(&read("a b\nc b\n")), [(0, 1), (1, 2)]);
}
