//! Directed networks with as many arcs as there are pairs: nobody is sensed who has no arc to him.

use super::{run, value};
use scenario::{ExactMotion, Scenario};

fn phases(graph: &str, phases: &str, gains: &str) -> String {
    format!(
        "model = \"phase\"\n[graph]\nkind = \"edges\"\n{graph}\n[state]\nphases = {phases}\n[law]\n{gains}\n[run]\nuntil = 1\nrows = 1\ntolerance = 1e-13\n"
    )
}

const CYCLE: &str = "edges = [[1, 2], [2, 3], [3, 1]]\ndirected = true";

/// The numbers are those of SciPy's DOP853 with tolerances of 1e-13, summed arc by arc.
#[test]
fn as_many_arcs_as_pairs_are_not_all_to_all() {
    let end = |graph: &str, start: &str| {
        let outcome = run(&phases(graph, start, "K1 = -1"));
        outcome.rows.last().expect("a row").frame.phases.clone()
    };
    let close = |found: &[f64], expected: &[f64]| found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-7);
    let found = end(CYCLE, "[0, 1, 3]");
    assert!(close(&found, &[0.28354504, 1.32222497, 2.89406381]), "{found:?}");
    // Agent 2 senses nobody, and rests.
    let found = end("edges = [[1, 2]]\ndirected = true", "[0, 1]");
    assert!(close(&found, &[0.36007244, 1.0]), "{found:?}");
    assert_eq!(found[1], 1.0);
    // One that everyone senses, and nobody else: three arcs of three phases.
    let found = end("edges = [[2, 1], [3, 1], [3, 2]]\ndirected = true", "[0, 1, 3]");
    assert_eq!(found[0], 0.0);
    assert_eq!(end("edges = []\ndirected = true", "[1]"), [1.0]);
}

/// What everyone senses by its arcs is the same network as that of all edges.
#[test]
fn all_arcs_are_all_to_all_however_they_are_written() {
    let all = "edges = [[1, 2], [2, 1], [1, 3], [3, 1], [2, 3], [3, 2]]\ndirected = true";
    let edges = "edges = [[1, 2], [1, 3], [2, 3]]";
    for gains in ["K1 = -1", "K = [1, \"1/2\", -1]"] {
        let [a, b] = [all, edges].map(|graph| run(&phases(graph, "[0, 1, 3]", gains)));
        assert_eq!(
            a.rows,
            b.rows
                .into_iter()
                .zip(&a.rows)
                .map(|(row, a)| scenario::Row { links: a.links.clone(), ..row })
                .collect::<Vec<_>>()
        );
    }
}

#[test]
fn gains_of_harmonics_need_all_to_all_and_not_a_number_of_arcs() {
    for graph in [CYCLE, "edges = [[2, 1], [3, 1], [3, 2]]\ndirected = true", "edges = [[1, 2], [2, 3]]"] {
        let error = Scenario::read(&phases(graph, "[0, 1, 3]", "K = [1, -1, 1]")).expect_err(graph).to_string();
        assert!(error.contains("all-to-all"), "{error}");
    }
    let particles = "model = \"particles\"\n[graph]\nkind = \"edges\"\nedges = [[1, 2]]\ndirected = true\n[state]\npositions = [[0, 0], [1, 0]]\nphases = [0, 1]\n\
                     [law]\nomega0 = 1\nK = [1, -1]\n[run]\nuntil = 1\n";
    assert!(Scenario::read(particles).unwrap_err().to_string().contains("all-to-all"));
    assert!(Scenario::read(&particles.replace("[[1, 2]]", "[[1, 2], [2, 1]]")).is_ok());
}

/// What is enclosed has the arcs that are written.
#[test]
fn enclosed_networks_have_the_arcs_that_are_written() {
    let arcs = |graph: &str| match ExactMotion::read(&phases(graph, "[0, 1, 3]", "K1 = -1")) {
        Ok(ExactMotion::Phases { network, .. }) => network.arcs().collect::<Vec<_>>(),
        other => panic!("{other:?}"),
    };
    assert_eq!(arcs(CYCLE), [(0, 1), (1, 2), (2, 0)]);
    assert_eq!(arcs("edges = [[1, 2], [1, 3], [2, 3]]").len(), 6);
}

/// The last car is car N, whoever leads; if it leads, it does not deviate.
#[test]
fn the_last_car_is_that_with_the_largest_number() {
    let text = |agent: usize| {
        format!(
            "model = \"platoon\"\n[graph]\nkind = \"complete\"\n[state]\npositions = [0, -1, \"-5/2\"]\nvelocities = [0, 0, 0]\n[law]\nf = -1\ng = -1\n\
             leader = {{ agent = {agent} }}\n[run]\nuntil = 1\nrows = 1\n"
        )
    };
    for agent in 1..=3 {
        let outcome = run(&text(agent));
        for row in &outcome.rows {
            let y = |k: usize| row.frame.positions[k][0] + k as f64;
            assert!((value(row, "last_deviation") - (y(2) - y(agent - 1))).abs() < 1e-12, "{agent}");
        }
        assert_eq!(value(&outcome.rows[0], "last_deviation"), [-0.5, -0.5, 0.0][agent - 1]);
    }
}

/// A platoon with weights, with weighted edges, and by its equations: after a short time the same numbers; and what is refused.
#[test]
fn platoons_have_weights_in_one_line_or_on_edges() {
    let text = |law: &str, graph: &str| {
        format!(
            "model = \"platoon\"\n{graph}[state]\npositions = [[0], [\"-3/2\"], [-2], [\"-7/2\"]]\nvelocities = [[1], [0], [0], [\"1/2\"]]\n\
             [law]\n{law}\n[run]\nuntil = 3\nrows = 1\ntolerance = 1e-13\n"
        )
    };
    let ends = |text: String| {
        let outcome = run(&text);
        let positions = &outcome.rows.last().expect("a row").frame.positions;
        positions.iter().flatten().copied().collect::<Vec<f64>>()
    };
    let near = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
    let line = ends(text("f = -1\ng = -2\nahead = \"3/5\"\nbehind = \"2/5\"", ""));
    let edges = "[graph]\nkind = \"edges\"\ndirected = true\nedges = [[2, 1, 3], [2, 3, 2], [3, 2, \"0.6\"], [3, 4, 0.4], [4, 3]]\n";
    assert!(near(&line, &ends(text("f = -1\ng = -2", edges))));
    assert!(near(
        &line,
        &ends(text("f = [-1, -1, -1]\ng = -2\nf_ahead = [3, 6, 1]\nf_behind = [2, 4, 9]\ng_ahead = 0.6", ""))
    ));
    assert!(near(
        &line,
        &ends(text("f_ahead = [\"-3/5\", \"-3/5\", -1]\nf_behind = \"-2/5\"\ng = -2\ng_ahead = 0.6", ""))
    ));
    // A text may be a list, in the forms of the command line and of questions.
    for lists in ["f = \"-1,-1,-1\"\nahead = \"0.6,3/5,1\"", "f = \"-1\"\nahead = \"each:3/5,3/5,1\""] {
        assert!(near(&line, &ends(text(&format!("{lists}\ng = -2"), ""))), "{lists}");
    }
    let plain = ends(text("f = -1\ng = -2", ""));
    assert!(near(&plain, &ends(text("f = -1\ng = -2\nahead = 1\nbehind = 1", ""))) && !near(&plain, &line));
    assert!(!near(&line, &ends(text("f = -1\ng = -2\nf_ahead = \"3/5\"", ""))));
    for (law, graph, words) in [
        ("f = 1\ng = -1", "", "`law.f`: f must be negative, but it is 1: the law is y'' = f e + g e'"),
        ("f = [-1, -1]\ng = -1", "", "`law.f`: f has 2 numbers for 3 followers"),
        ("g = -1", "", "f is needed"),
        ("f = -1\ng = -1\nahead = \"0.5,x,1\"", "", "`law.ahead`: `x` is not an integer"),
        ("f = -1\ng = -1\nahead = \"0.5,1\"", "", "`law.ahead`: ahead has 2 numbers for 3 followers"),
        ("f = -1\ng = -1\nahead = -1\nbehind = 1", "", "`law.ahead`: ahead is -1, but a weight is not negative"),
        ("f = -1\ng = -1\nahead = 0.5", edges, "`law.ahead`: ahead is for cars on a line"),
        ("f = -1\ng = -1\nahead = 0.5\ncommunication = \"front\"", "", "`law.ahead`: ahead is for cars on a line"),
        ("f = -1\ng = -1", "[graph]\nkind = \"edges\"\nedges = [[1, 2, 0]]\n", "entry 3`: it must be a number above 0"),
    ] {
        let refused = Scenario::read(&text(law, graph)).map(drop).expect_err(law).to_string();
        assert!(refused.contains(words), "{refused}");
    }
    let other = "model = \"phase\"\n[graph]\nkind = \"edges\"\nedges = [[1, 2, 3]]\n[state]\nphases = [0, 1]\n[law]\nK1 = 1\n[run]\nuntil = 1\nrows = 1\n";
    let refused = Scenario::read(other).map(drop).expect_err("weights").to_string();
    assert!(refused.contains("edges without weights"), "{refused}");
}
