//! `spectrum`: its contract and wrong input.

use super::{assert_refused, file, flockproof, folder, stdout};
use serde_json::Value;

fn document(arguments: &[&str]) -> Value {
    let output = flockproof(&[&["spectrum", "--json"], arguments].concat());
    assert!(output.status.success() && output.stderr.is_empty(), "{arguments:?}");
    serde_json::from_str(&stdout(&output)).expect("one JSON document")
}

#[test]
fn rings_have_double_eigenvalues() {
    let ring = document(&["--graph", "ring:12", "--digits", "30"]);
    assert_eq!((&ring["graph"], &ring["kind"], &ring["order"]), (&"ring:12".into(), &"laplacian".into(), &12.into()));
    assert_eq!(ring["method"], "closed form");
    let parts = ring["eigenvalues"].as_array().expect("a list");
    let times: Vec<u64> = parts.iter().filter_map(|part| part["multiplicity"].as_u64()).collect();
    assert_eq!(times, [1, 2, 2, 2, 2, 2, 1]);
    for end in ["lo", "hi"] {
        assert!(parts[1][end].as_str().is_some_and(|x| x.starts_with("0.26794919243112270647255365849")));
    }
    assert_eq!((&parts[2]["lo"], &parts[2]["exact"]), (&"1".into(), &"1".into()));
    let cycle = document(&["--graph", "cycle:4", "--kind", "adjacency"]);
    assert_eq!(cycle["eigenvalues"][2]["re"]["lo"], "0");
    assert!(cycle["eigenvalues"][2]["im"]["lo"].as_str().is_some_and(|x| x == "1" || x.starts_with("0.9999999999")));
    assert!(cycle["eigenvalues"][2]["certificate"].is_string());
}

#[test]
fn the_root_of_reduced_matrices() {
    // Without its middle vertex the path falls apart.
    let middle = document(&["--graph", "path:3", "--kind", "reduced", "--root", "2"]);
    assert_eq!((&middle["root"], &middle["eigenvalues"][0]["exact"]), (&2.into(), &"1".into()));
    assert_eq!(middle["eigenvalues"][0]["multiplicity"], 2);
    let first = document(&["--graph", "star:5", "--kind", "reduced", "--root", "1"]);
    assert_eq!((&first["root"], &first["eigenvalues"][0]["multiplicity"]), (&1.into(), &4.into()));
}

#[test]
fn tables_fit_the_terminal() {
    for arguments in [
        ["ring:9", "laplacian", "40"],
        ["platoon2:8", "walk", "9"],
        ["cycle:7", "adjacency", "50"],
        ["geometric:30:1/2:1", "normalised", "9"],
    ] {
        let output =
            flockproof(&["spectrum", "--graph", arguments[0], "--kind", arguments[1], "--digits", arguments[2]]);
        let text = stdout(&output);
        assert!(output.status.success() && !text.is_empty());
        assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    }
}

#[test]
fn files_are_read() {
    let folder = folder("spectrum");
    let path = file(&folder, "path.txt", b"1 2\n2 3\n");
    assert_eq!(document(&["--graph", &path])["eigenvalues"][1]["exact"], "1");
    let market = b"%%MatrixMarket matrix coordinate real general\n4 4 4\n1 2 1\n2 3 1\n3 4 1\n4 1 1\n";
    let cycle = file(&folder, "cycle.mtx", market);
    let found = document(&["--graph", &cycle, "--kind", "adjacency"]);
    assert_eq!((&found["method"], found["eigenvalues"].as_array().map(Vec::len)), (&"exact".into(), Some(4)));
    let bad = file(&folder, "bad.txt", b"1 2\n1 two\n");
    assert_refused(&["spectrum", "--graph", &bad], "line 2: `two`");
    let binary = file(&folder, "binary", &[0xff, 0xfe, 0]);
    assert_refused(&["spectrum", "--graph", &binary], "text file");
    assert_refused(&["spectrum", "--graph", &folder.to_string_lossy()], "it is a folder");
}

/// A graph with a name need not be stored where its spectrum has a closed form; one by its edges is what it says.
#[test]
fn names_and_lists_of_edges() {
    let found = |graph: &str| {
        let output = flockproof(&["spectrum", "--graph", graph, "--kind", "normalized", "--json"]);
        serde_json::from_slice::<serde_json::Value>(&output.stdout).unwrap_or_else(|_| panic!("{graph}: {output:?}"))
    };
    let large = found("complete:100000");
    assert_eq!((&large["method"], &large["kind"]), (&"closed form".into(), &"normalised".into()));
    let eigenvalues = |graph: &str| found(graph)["eigenvalues"].clone();
    for other in ["graph6:Cr", "edges:4:1-2,1-3,2-4,3-4", "grid:2x2", "hypercube:2", "sparse6::Cci"] {
        assert_eq!(eigenvalues(other).as_array().map(Vec::len), Some(3), "{other}");
    }
}

#[test]
fn bad_spectra_are_refused() {
    let ask = |graph: &str, more: &[&str], named: &str| {
        assert_refused(&[&["spectrum", "--graph", graph], more].concat(), named);
    };
    ask("ring:0", &[], "number of vertices");
    ask("ring:99999999999999999999", &[], "number of vertices");
    ask("circulant:12:1,13", &[], "an offset");
    ask("platoon2:0", &[], "number of followers");
    ask("wheels:5", &[], "names no graph");
    ask("graph6:D", &[], "characters");
    ask("edges:3:1-2,2-1", &[], "already");
    ask("no such file", &[], "there is no file");
    ask("ring:5", &["--kind", "signless"], "--kind");
    ask("ring:5", &["--digits", "0"], "digits");
    ask("ring:5", &["--digits", "10001"], "digits");
    ask("ring:5", &["--digits", "-1"], "--digits");
    ask("platoon2:5", &["--kind", "normalised"], "undirected");
    ask("path:1", &["--kind", "reduced"], "first one");
    ask("geometric:50:1/2:1", &["--digits", "40"], "order 50");
    ask("geometric:9000:1/2:1", &[], "too many");
    ask("geometric:3500:1/16:1", &[], "irreducible block of order 3500");
    ask("path:3", &["--kind", "reduced", "--root", "4"], "--root: vertex 4");
    ask("path:3", &["--kind", "reduced", "--root", "0"], "--root: vertex 0");
    ask("path:3", &["--root", "2"], "--root is for");
    assert_refused(&["spectrum"], "--graph");
}
