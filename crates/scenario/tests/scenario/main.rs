//! Mirrors `src/scenario`: runs against closed forms and against other parts of the library.

extern crate flockproof_scenario as scenario;

mod arcs;
mod individual;
mod observables;
mod own;

use arithmetic::{Progress, Unwatched};
use models::platoon::Gains;
use models::platoon::time_domain::Modes;
use scenario::{
    Amount, End, Ensemble, Links, Model, Outcome, Row, Scenario, Value, View, measure, named_files, with_law,
};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

fn run(text: &str) -> Outcome {
    let scenario = Scenario::read(text).unwrap_or_else(|error| panic!("{error}"));
    let outcome = scenario.run(&Unwatched);
    assert_eq!(outcome.end, End::Finished);
    outcome
}

fn value(row: &Row, name: &str) -> f64 {
    match row.observables.iter().find(|o| o.name == name).map(|o| &o.value) {
        Some(Value::Number(x)) => *x,
        Some(Value::Count(Some(n))) => *n as f64,
        other => panic!("{name}: {other:?}"),
    }
}

/// A graph by any of its texts is the network of its edges.
#[test]
fn networks_have_the_names_of_graphs() {
    let phases = |agents: usize, graph: &str| {
        let start: Vec<String> = (0..agents).map(|k| format!("\"{}/10\"", k * k + 1)).collect();
        let start = start.join(", ");
        format!(
            "model = \"phase\"\n[graph]\n{graph}\n[state]\nphases = [{start}]\n[law]\nK1 = -1\n[run]\nuntil = 1\nrows = 1\n"
        )
    };
    let end = |agents: usize, graph: &str| run(&phases(agents, graph)).rows.last().expect("a row").frame.phases.clone();
    let square = "kind = \"edges\"\nedges = [[1, 2], [1, 3], [2, 4], [3, 4]]";
    for text in ["grid:2x2", "edges:4:3-4,1-2,2-4,1-3", "graph6:Cr", "hypercube:2"] {
        assert_eq!(end(4, &format!("kind = \"{text}\"")), end(4, square), "{text}");
    }
    let arcs = "kind = \"edges\"\nedges = [[1, 2], [2, 3], [2, 1]]\ndirected = true";
    assert_eq!(end(3, "kind = \"arcs:3:2-3,2-1,1-2\""), end(3, arcs));
    assert_eq!(end(10, "kind = \"petersen\"").len(), 10);
    for (agents, graph, word) in [
        (4, "kind = \"petersen\"", "10"),
        (4, "kind = \"grid:2y2\"", "grid:AxB"),
        (4, "kind = \"edges:4:1-2*2\"", "without weights"),
        (4, "kind = \"edges:4:1-2,2-2*1\"", "without loops"),
        (4, "kind = \"peterson\"", "did you mean petersen?"),
        (4, "kind = \"complet\"", "did you mean complete?"),
        (4, "kind = \"wheel\"", "wheel:N"),
        (4, "kind = \"nothing\"", "hypercube:3"),
        (4, "kind = \"grid:2x2\"\nradius = 1", "radius"),
    ] {
        let error = Scenario::read(&phases(agents, graph)).expect_err(graph).to_string();
        assert!(error.contains(word), "{graph}: {error}");
    }
}

/// A network stands in a file beside the scenario, in any of the formats of graphs.
#[test]
fn networks_stand_in_files() {
    let text = |kind: &str| {
        format!(
            "model = \"phase\"\n[graph]\nkind = \"{kind}\"\n[state]\nphases = [0, 1, \"3/2\", 3]\n[law]\nK1 = -1\n[run]\nuntil = 1\nrows = 1\n"
        )
    };
    let read = |file: &'static str| {
        move |name: &str| if name == "net" { Ok(file.to_string()) } else { Err(format!("no {name}")) }
    };
    let end = |text: &str| run(text).rows.last().expect("a row").frame.phases.clone();
    let listed = end(&text("edges:4:1-2,1-3,2-4,3-4"));
    for file in ["1 2\n1 3\n2 4\n3 4\n", "Cr\n", ">>graph6<<Cr\n"] {
        let whole = with_law(&text("file:net"), &read(file)).expect("a scenario");
        assert_eq!(end(whole.text()), listed, "{file}");
        assert_eq!(named_files(&text("file:net")), ["net"]);
    }
    assert!(named_files(&text("path")).is_empty());
    for (kind, file, word) in [
        ("file:net", "1 2\n1 1\n", "line 3: `graph.kind`: the file of the graph: net: line 2"),
        ("file:net", "Cr\nCF\n", "several graphs"),
        ("file:other", "", "no other"),
    ] {
        let error = with_law(&text(kind), &read(file)).expect_err(file).to_string();
        assert!(error.contains(word), "{error}");
    }
}

#[test]
fn two_phases_follow_their_closed_form() {
    // With N = 2 the difference d obeys d' = K1 sin d: tan(d/2) = tan(d_0/2) e^(K1 t).
    for kind in ["\"all-to-all\"", "\"path\"", "\"edges\"\nedges = [[1, 2]]"] {
        let text = format!(
            "model = \"phase\"\n[graph]\nkind = {kind}\n[state]\nphases = [0, 2]\n[law]\nomega0 = \"1/3\"\nK1 = \"-1/2\"\n\
             [run]\nuntil = 6\nsamples = [1, 3, 6]\ntolerance = 1e-12\n"
        );
        let outcome = run(&text);
        for row in outcome.samples() {
            let difference = row.frame.phases[1] - row.frame.phases[0];
            let expected = 2.0 * (1f64.tan() * (-0.5 * row.time).exp()).atan();
            assert!((difference - expected).abs() < 1e-10, "{kind}, t = {}", row.time);
            let mean = 0.5 * (row.frame.phases[0] + row.frame.phases[1]);
            assert!((mean - 1.0 - row.time / 3.0).abs() < 1e-10);
        }
    }
}

#[test]
fn free_particles_go_round_and_drift() {
    let outcome = run(
        "model = \"particles\"\n[state]\npositions = [[1, 2]]\nphases = [\"1/2\"]\n[law]\nomega0 = 2\ndrift = [\"1/4\", 0]\n\
         [run]\nuntil = 5\nsamples = [5]\ntolerance = 1e-12\n",
    );
    let row = outcome.samples().next().expect("a sample");
    let theta = 0.5 + 2.0 * 5.0;
    let expected =
        [1.0 + 0.25 * 5.0 + (f64::sin(theta) - 0.5f64.sin()) / 2.0, 2.0 - (f64::cos(theta) - 0.5f64.cos()) / 2.0];
    assert!((row.frame.positions[0][0] - expected[0]).abs() < 1e-10);
    assert!((row.frame.positions[0][1] - expected[1]).abs() < 1e-10);
    assert!(value(row, "min_distance").is_infinite());
    assert!(value(row, "centre_spread").abs() < 1e-12);
}

#[test]
fn the_reference_phase_turns_with_the_particles() {
    let text = "model = \"phase\"\n[state]\nphases = [0, 1, 2, \"3/10\"]\n[law]\nomega0 = 1\nK1 = -1\nreference = \"1/2\"\n\
        [run]\nuntil = 200\nsamples = [100, 200]\n";
    for row in run(text).samples() {
        for theta in &row.frame.phases {
            assert!((theta - 0.5 - row.time).abs() < 1e-6, "t = {}: {theta}", row.time);
        }
    }
    // Particles end on one circle, all at the reference phase.
    let text = "model = \"particles\"\n[state]\npositions = [[0, 0], [3, 0], [0, 4]]\nphases = [0, 1, 2]\n\
        [law]\nomega0 = \"1/2\"\nK0 = \"1/2\"\nK1 = -1\nreference = 0\n[run]\nuntil = 600\n";
    let outcome = run(text);
    let row = outcome.samples().next().expect("a sample");
    assert!(value(row, "centre_spread") < 1e-6, "{}", value(row, "centre_spread"));
    let apart = |theta: &f64| (theta - 300.0).rem_euclid(std::f64::consts::TAU);
    assert!(row.frame.phases.iter().all(|theta| apart(theta).min(std::f64::consts::TAU - apart(theta)) < 1e-6));
    // Their centres are those of the circles through them.
    for ((r, theta), c) in row.frame.positions.iter().zip(&row.frame.phases).zip(&row.frame.centres) {
        assert!((r[0] - theta.sin() / 0.5 - c[0]).abs() < 1e-9 && (r[1] + theta.cos() / 0.5 - c[1]).abs() < 1e-9);
    }
}

#[test]
fn networks_are_replaced_at_given_times() {
    let text = |graph: &str| {
        format!(
            "model = \"phase\"\n[graph]\nkind = \"edges\"\n{graph}\n[state]\nphases = [0, 2, 3]\n[law]\nK1 = -3\n\
             [run]\nuntil = 2\nsamples = [1, 2]\ntolerance = 1e-13\n"
        )
    };
    // Only two phases are coupled at a time: a difference d obeys d' = K1 (2/N) sin d.
    let after = |d: f64| 2.0 * ((d / 2.0).tan() * (-2.0f64).exp()).atan();
    let outcome = run(&text("edges = [[1, 2]]\nswitches = [{ at = 1, edges = [[2, 3]] }]"));
    let rows: Vec<&Row> = outcome.samples().collect();
    let events: Vec<_> = outcome.events.iter().map(|e| (e.time, e.gained, e.pair)).collect();
    assert_eq!(events, [(1.0, false, (1, 2)), (1.0, true, (2, 3))]);
    let phases = [&rows[0].frame.phases, &rows[1].frame.phases];
    assert!((phases[0][1] - phases[0][0] - after(2.0)).abs() < 1e-10 && phases[0][2] == 3.0);
    assert!((phases[1][2] - phases[1][1] - after(3.0 - phases[0][1])).abs() < 1e-10 && phases[1][0] == phases[0][0]);
    // A complete network that becomes an arc is not all-to-all, and a network may become empty.
    let outcome = run(&text(
        "edges = [[1, 2], [2, 1], [1, 3], [3, 1], [2, 3], [3, 2]]\ndirected = true\n\
         switches = [{ at = 1, edges = [[1, 2]] }, { at = \"3/2\", edges = [] }]",
    ));
    let rows: Vec<&Row> = outcome.samples().collect();
    assert_eq!(rows[0].frame.phases[1..], rows[1].frame.phases[1..]);
    assert!(rows[0].frame.phases[0] != rows[1].frame.phases[0]);
    assert_eq!((value(rows[0], "components"), value(rows[1], "components")), (2.0, 3.0));
    for (graph, named) in [
        ("edges = []\nswitches = [{ at = 1, edges = [] }, { at = 1, edges = [] }]", "must increase"),
        ("edges = []\nswitches = [{ at = 0, edges = [] }]", "above 0"),
        ("edges = []\nswitches = [{ at = 1, edges = [[1, 9]] }]", "9"),
        ("edges = []\nswitches = [{ edges = [[1, 2]] }]", "`at`"),
    ] {
        let error = Scenario::read(&text(graph)).expect_err(graph).to_string();
        assert!(error.contains(named), "{error}");
    }
}

#[test]
fn fish_turn_at_random_where_asked() {
    let text = |noise: &str| {
        format!(
            "model = \"fish\"\n[state]\npositions = [[0, 0], [100, 0]]\nphases = [0, 1]\n[law]\nT = \"1/10\"\nomega0 = \"1/2\"\n\
             repulsion = 1\norientation = 2\nattraction = 3\n{noise}\n[run]\nuntil = 1000\n"
        )
    };
    // Fish that sense nobody: the phases are sums of T times their turning rates.
    let turned = |noise: &str| {
        let outcome = run(&text(noise));
        let row = outcome.samples().next().expect("a sample").clone();
        [row.frame.phases[0] - 500.0, row.frame.phases[1] - 501.0]
    };
    assert!(turned("").iter().all(|off| off.abs() < 1e-6));
    let [a, b] = turned("noise = 2");
    // A normal number with variance 10000 (2/10)² for each: four deviations are 80.
    assert!(a != b && a.abs().max(b.abs()) < 80.0 && a.abs().min(b.abs()) > 0.01, "{a} {b}");
    assert_eq!(turned("noise = 2\nseed = 1"), [a, b]);
    assert!(turned("noise = 2\nseed = 2") != [a, b]);
    assert!(Scenario::read(&text("noise = -1")).expect_err("negative").to_string().contains("above 0"));
}

#[test]
fn composite_potentials_do_not_increase() {
    let start = "[state]\npositions = [[0, 0], [3, 0], [0, 4], [-5, 1]]\nphases = [0, 1, 2, 5]\n";
    for law in ["K1 = -1", "K1 = \"1/2\"\nreference = 1", "K = [1, \"-1/4\"]", "K1 = -1\nbeacon = [1, 2]"] {
        for graph in ["complete", "ring", "path"] {
            if law.contains("K = ") && graph != "complete" {
                continue;
            }
            let text = format!(
                "model = \"particles\"\n[graph]\nkind = \"{graph}\"\n{start}[law]\nomega0 = \"-1/2\"\nK0 = \"1/3\"\n{law}\n[run]\nuntil = 30\n"
            );
            let rows = run(&text).rows;
            let values: Vec<f64> = rows.iter().map(|row| value(row, "composite_potential")).collect();
            assert!(values.windows(2).all(|pair| pair[1] <= pair[0] + 1e-9), "{law}, {graph}");
            assert!(values[values.len() - 1] < values[0] - 0.1, "{law}, {graph}: {values:?}");
        }
    }
}

#[test]
fn a_platoon_moves_as_the_sum_of_its_modes() {
    let outcome = run(
        "model = \"platoon\"\n[state]\npositions = [[0], [-1], [-2], [-3], [-4]]\nvelocities = [[0], [0], [0], [0], [0]]\n\
         [law]\nf = -1\ng = \"-1/2\"\nleader = { frequency = \"3/10\" }\n[run]\nuntil = 50\nsamples = [0, 1, 20, 50]\ntolerance = 1e-12\n",
    );
    let modes =
        Modes::new(&Gains { f: -1.0, g: -0.5 }, 4).expect("modes").behind_harmonic_leader(&0.3).expect("a start");
    for row in outcome.samples() {
        let exact = modes.followers(&row.time).expect("a motion");
        assert!((row.frame.positions[0][0] - (0.3 * row.time).cos()).abs() < 1e-12);
        for (k, y) in exact.positions.iter().enumerate() {
            assert!((row.frame.positions[k + 1][0] + (k + 1) as f64 - y).abs() < 1e-9, "t = {}, car {k}", row.time);
            assert!((row.frame.velocities[k + 1][0] - exact.velocities[k]).abs() < 1e-9);
        }
    }
}

const HEADINGS: &str = "model = \"heading-alignment\"\n[graph]\nkind = \"complete\"\n[state]\n\
    positions = [[0, 0], [2, 0], [0, 1], [3, 1]]\nvelocities = [[-1, \"1/100\"], [-1, \"-1/10\"], [1, 1], [\"1/2\", -1]]\n\
    [law]\npotential = \"inverse-square-spring\"\nstiffness = \"1/2\"\nheading_difference = \"READING\"\n\
    [run]\nuntil = 8\nsamples = [0, 1, 2, 4, 8]\ntolerance = 1e-12\n";

#[test]
fn gyroscopic_forces_keep_the_energy_in_every_reading() {
    let mut ends = Vec::new();
    for reading in ["raw", "wrapped", "unwrapped"] {
        let outcome = run(&HEADINGS.replace("READING", reading));
        let rows: Vec<&Row> = outcome.samples().collect();
        for row in &rows {
            let drift = (value(row, "energy") - value(rows[0], "energy")).abs();
            assert!(drift < 1e-8, "{reading}, t = {}: {drift}", row.time);
        }
        ends.push(rows[4].frame.positions.concat());
    }
    // The readings differ: headings on both sides of pi.
    assert!(ends[0] != ends[1]);
}

#[test]
fn zero_coupling_leaves_every_network_alone() {
    // Straight flight at unit speed: the distance of two particles is known, and so are the times of the switches.
    let outcome = run(
        "model = \"particles\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\npositions = [[0, 0], [10, 1]]\n\
         phases = [0, \"3.141592653589793\"]\n[law]\nomega0 = 0\n[run]\nuntil = 10\nsamples = [0, 5, 10]\ntolerance = 1e-12\n",
    );
    // |(10 - 2 t, 1)| = 2.
    let half = 3f64.sqrt() / 2.0;
    let times: Vec<(f64, bool)> = outcome.events.iter().map(|e| (e.time, e.gained)).collect();
    assert_eq!(times.len(), 2, "{times:?}");
    assert!((times[0].0 - 5.0 + half).abs() < 1e-12 && times[0].1);
    assert!((times[1].0 - 5.0 - half).abs() < 1e-12 && !times[1].1);
    assert_eq!(outcome.samples().map(|row| value(row, "components")).collect::<Vec<_>>(), [2.0, 1.0, 2.0]);
}

#[test]
fn a_grazing_pass_is_seen_or_not_as_it_should() {
    for (offset, events) in [("1.9999999", 2), ("2.0000001", 0)] {
        let outcome = run(&format!(
            "model = \"particles\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\npositions = [[0, 0], [10, {offset}]]\n\
             phases = [0, \"3.141592653589793\"]\n[law]\nomega0 = 0\n[run]\nuntil = 10\ntolerance = 1e-12\nrows = 3\n"
        ));
        assert_eq!(outcome.events.len(), events, "{offset}");
    }
}

#[test]
fn a_grazing_pass_is_seen_beside_pairs_that_are_nearer_to_their_switch() {
    // Agents 3 and 4 fly side by side at a hair below the radius.
    let outcome = run("model = \"particles\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\n\
         positions = [[0, 0], [10, \"1.9999999\"], [50, 0], [50, \"1.99999999\"]]\nphases = [0, \"3.141592653589793\", 1, 1]\n\
         [law]\nomega0 = 0\n[run]\nuntil = 10\ntolerance = 1e-12\nrows = 3\n");
    let pairs: Vec<_> = outcome.events.iter().map(|e| (e.gained, e.pair)).collect();
    assert_eq!(pairs, [(true, (1, 2)), (false, (1, 2))]);
}

const SCHOOL: &str = "model = \"particles\"\n[graph]\nGRAPH\n[state]\nrandom = { agents = AGENTS, seed = 3, half = HALF }\n\
    [law]\nomega0 = \"1/5\"\nK0 = \"1/10\"\nK1 = \"-2\"\n[run]\nuntil = UNTIL\nrows = 2\n";

fn school(graph: &str, agents: usize, half: &str, until: &str) -> String {
    let text = SCHOOL.replace("GRAPH", graph).replace("AGENTS", &agents.to_string());
    text.replace("HALF", half).replace("UNTIL", until)
}

#[test]
fn particles_in_fixed_steps_agree_with_located_switches() {
    let end = |outcome: &Outcome| outcome.rows.last().expect("a row").frame.positions.concat();
    for graph in ["kind = \"within\"\nradius = 1", "kind = \"nearest\"\nnearest = 3"] {
        let text = school(graph, 20, "3", "2");
        let located = run(&text);
        assert!(located.events.len() > 10, "{graph}");
        let far = |step: &str| {
            let fixed = run(&format!("{text}step = \"{step}\"\n"));
            assert!(fixed.events.is_empty());
            end(&fixed).iter().zip(end(&located)).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
        };
        // A step over a switch is wrong by about its length, in the positions by its square.
        assert!(far("1/100") < 1e-2 && far("1/2000") < 2e-4, "{graph}: {} {}", far("1/100"), far("1/2000"));
    }
}

#[test]
fn large_schools_need_no_table_of_pairs() {
    for graph in ["kind = \"within\"\nradius = \"1/2\"", "kind = \"nearest\"\nnearest = 3"] {
        // A time without more than a few switches. So many are arranged by their places on the way.
        let text = school(graph, 20_000, "100", "\"1/100000\"");
        let outcome = run(&format!("{text}step = \"1/100000\"\n"));
        assert_eq!(outcome.rows.len(), 3, "{graph}");
        let located = run(&text);
        assert!(located.events.iter().all(|event| event.time <= 1e-5));
        let end = |outcome: &Outcome| outcome.rows.last().expect("a row").frame.clone();
        let (there, here) = (end(&outcome), end(&located));
        let far = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        assert!(far(&there.positions.concat(), &here.positions.concat()) < 1e-9, "{graph}");
        // Rates are about 1, and one switch changes them by less than 1/10.
        assert!(far(&there.phases, &here.phases) < 3e-6, "{graph}: {}", far(&there.phases, &here.phases));
    }
}

#[test]
fn headings_in_fixed_steps_agree_with_located_jumps() {
    let text = |reading: &str, run: &str| {
        HEADINGS
            .replace("\"complete\"", "\"within\"\nradius = 2")
            .replace("READING", reading)
            .replace("\"1/2\"\nheading", "\"1/50\"\nheading")
            .replace("until = 8\nsamples = [0, 1, 2, 4, 8]\ntolerance = 1e-12", run)
    };
    for reading in ["raw", "wrapped", "unwrapped"] {
        let end = |outcome: Outcome| outcome.rows.last().expect("a row").frame.positions.concat();
        let located = run(&text(reading, "until = 2\ntolerance = 1e-12"));
        let fixed = run(&text(reading, "until = 2\nstep = \"1/4000\""));
        let events = located.events.len();
        let error = end(located).iter().zip(end(fixed)).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        assert!(error < 1e-3 && events > 0, "{reading}: {error}, {events} events");
    }
}

#[test]
fn nearest_neighbours_change_when_distances_cross() {
    let outcome = run(
        "model = \"particles\"\n[graph]\nkind = \"nearest\"\nnearest = 1\n[state]\npositions = [[0, 0], [0, 10], [-1, 5]]\n\
         phases = [0, 0, \"0.1\"]\n[law]\nomega0 = 0\n[run]\nuntil = 4\nsamples = [4]\n",
    );
    // Agent 3 starts as near to 1 as to 2 (the smaller number is taken) and drifts towards 2 at once: one switch for it.
    let arcs: Vec<_> = outcome.events.iter().map(|e| (e.gained, e.pair)).collect();
    assert_eq!(arcs, [(false, (3, 1)), (true, (3, 2))]);
    assert!(outcome.events[0].time < 1e-9);
}

/// Stops a run after the 301 rows up to 6 of 10.
struct Rows(AtomicU64);

impl Progress for Rows {
    fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed) > 300
    }

    fn tell(&self, stage: &str, done: u64, total: Option<u64>) {
        assert_eq!((stage, total), ("rows", Some(501)));
        self.0.store(done, Ordering::Relaxed);
    }
}

/// Looks at a run while it goes on.
struct Looking<'a>(&'a Mutex<Outcome>);

impl Progress for Looking<'_> {
    fn is_cancelled(&self) -> bool {
        false
    }

    fn tell(&self, _: &str, done: u64, _: Option<u64>) {
        let outcome = self.0.lock().expect("nobody panicked");
        assert_eq!((outcome.rows.len() as u64, &outcome.end), (done, &End::Interrupted));
    }
}

#[test]
fn rows_are_there_as_soon_as_they_are_finished() {
    let text = "model = \"phase\"\n[state]\nphases = [0, 2]\n[law]\nK1 = -1\n[run]\nuntil = 1\nrows = 7\n";
    let scenario = Scenario::read(text).expect("good");
    let seen = Mutex::new(scenario.outset());
    scenario.run_into(&Looking(&seen), &seen);
    assert_eq!(seen.into_inner().expect("nobody panicked"), run(text));
}

#[test]
fn what_was_reached_is_kept() {
    let text = "model = \"phase\"\n[state]\nphases = [0, 2]\n[law]\nK1 = -1\n[run]\nuntil = 10\nsamples = [1, 5, 10]\n";
    let scenario = Scenario::read(text).expect("good");
    let outcome = scenario.run(&Rows(AtomicU64::new(0)));
    assert_eq!(outcome.end, End::Interrupted);
    assert_eq!(outcome.samples().map(|row| row.time).collect::<Vec<_>>(), [1.0, 5.0]);
    assert_eq!(outcome.rows.len(), 301);
    assert!((6.0..6.1).contains(&outcome.reached()));
    // Two agents that fall into each other.
    let text = "model = \"velocity-alignment\"\n[graph]\nkind = \"path\"\n[state]\npositions = [[0, 0], [1, 0]]\n\
        velocities = [[0, 0], [0, 0]]\n[law]\npotential = { slope = [[-2, 1]], at = 1, value = 0 }\n[run]\nuntil = 10\nsamples = [0, 10]\n";
    for graph in ["\"path\"", "\"within\"\nradius = 3"] {
        let scenario = Scenario::read(&text.replace("\"path\"", graph)).expect("good");
        let outcome = scenario.run(&Unwatched);
        assert!(matches!(outcome.end, End::Failed(_)), "{graph}: {:?}", outcome.end);
        assert_eq!(outcome.samples().count(), 1);
        assert!(outcome.reached() < 1.0 && outcome.rows.len() > 1, "{graph}");
    }
}

fn min_distance(places: &[Vec<f64>]) -> f64 {
    let positions = scenario::Rows::of(places.len(), || places.to_vec());
    let view = View { positions, ..View::new(Model::Fish, Links::Everyone(places.len())) };
    match measure("min_distance", &view) {
        Ok(Some(Amount::Root(square))) => square.sqrt(),
        _ => f64::INFINITY,
    }
}

#[test]
fn places_without_coordinates_have_distances() {
    assert_eq!(min_distance(&[]), f64::INFINITY);
    assert_eq!(min_distance(&[vec![], vec![]]), 0.0);
    assert_eq!(min_distance(&[vec![], vec![3.0, 4.0], vec![0.0, 1.0]]), 0.0);
}

#[test]
fn the_smallest_distance_is_that_of_all_pairs() {
    let mut seed = 7u64;
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as f64 / 1e9
    };
    for count in [0, 1, 2, 3, 10, 60] {
        let points: Vec<Vec<f64>> = (0..count).map(|_| vec![next(), next()]).collect();
        let distance = |a: &[f64], b: &[f64]| ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)).sqrt();
        let pairs = (0..count).flat_map(|j| (0..j).map(move |i| (i, j)));
        let naive = pairs.map(|(i, j)| distance(&points[i], &points[j])).fold(f64::INFINITY, f64::min);
        assert_eq!(min_distance(&points), naive);
    }
    assert_eq!(min_distance(&[vec![1.0, 2.0], vec![3.0, 0.0], vec![1.0, 2.0]]), 0.0);
}

#[test]
fn fixed_steps_agree_with_located_switches() {
    let config = "model = \"velocity-alignment\"\n\
         [graph]\n\
         kind = \"within\"\n\
         radius = \"5/2\"\n\
         [state]\n\
         positions = [[0, 0], [2, 0], [1, 2], [-1, 1], [4, 1], [3, 3]]\n\
         velocities = [[1, 0], [\"1/2\", \"1/2\"], [0, -1], [1, \"1/4\"], [-1, 0], [\"-1/2\", \"-3/4\"]]\n\
         [law]\n\
         potential = \"inverse-square-log\"\n\
         [run]\n\
         until = 40\n\
         samples = [1, 5, 10, 20, 40]\n\
         tolerance = 1e-12\n";
    let located = run(config);
    let end = |outcome: &Outcome| outcome.rows.last().expect("a row").frame.positions.concat();
    let far = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
    // A step over a switch is wrong by about the square of its length; there are seven.
    for (step, most) in [("1/100", 1e-3), ("1/1000", 1e-4)] {
        let fixed = run(&config.replace("tolerance = 1e-12", &format!("step = \"{step}\"")));
        let error = far(&end(&fixed), &end(&located));
        assert!(error < most, "{step}: {error}");
        let last = fixed.samples().last().expect("a sample");
        let other = located.samples().last().expect("a sample");
        assert!((value(last, "saturated_energy") - value(other, "saturated_energy")).abs() < most);
        assert_eq!(value(last, "components"), 1.0);
    }
    let large = "model = \"velocity-alignment\"\n[graph]\nkind = \"within\"\nradius = 1\n[state]\nrandom = { agents = 17000, half = 92 }\n\
        [law]\npotential = \"none\"\n[run]\nuntil = \"1/10\"\nrows = 2\n";
    // Located too: all switches, in order, and the links at the end are those of the positions.
    let located = run(large);
    assert!(located.declaration.iter().any(|line| line.contains("individual steps")));
    assert!(located.events.len() > 100 && located.events.is_sorted_by(|a, b| a.time <= b.time));
    let fixed = run(&format!("{large}step = \"1/2000\"\n"));
    let error = far(&end(&fixed), &end(&located));
    assert!(error < 1e-4, "{error}");
    let components = |outcome: &Outcome| value(outcome.samples().last().expect("a sample"), "components");
    assert_eq!(components(&fixed), components(&located));
    let outcome = run(&format!("{large}step = \"1/20\"\n"));
    assert!(value(outcome.samples().last().expect("a sample"), "disagreement") > 0.0);
    let linked = config.replace("kind = \"within\"", "kind = \"complete\"").replace("radius = \"5/2\"\n", "");
    let fixed = linked.replace("tolerance = 1e-12", "step = 1");
    assert!(Scenario::read(&fixed).expect_err("no radius").to_string().contains("depend on distances"));
}

/// A platoon that is numbered the other way round, with its leader last, moves as the other one does.
#[test]
fn another_agent_can_lead() {
    let text = |edges: &str, state: &str, agent: usize, spacing: i32| {
        format!(
            "model = \"platoon\"\n[graph]\nkind = \"edges\"\ndirected = true\nedges = {edges}\n[state]\n{state}\n[law]\nf = -1\ng = -2\n\
             spacing = {}\nleader = {{ agent = {agent}, amplitude = \"1/10\", frequency = 1 }}\n[run]\nuntil = 7\n",
            spacing.abs()
        )
    };
    let (first, last) = (
        run(&text("[[2, 1], [2, 3], [3, 2]]", "positions = [0, -1, -2]\nvelocities = [1, 0, 0]", 1, 1)),
        run(&text("[[2, 3], [2, 1], [1, 2]]", "positions = [0, -1, -2]\nvelocities = [0, 0, 1]", 3, 1)),
    );
    let at = |outcome: &Outcome, agent: usize, shift: f64| {
        let row = outcome.samples().next().expect("a sample").frame.positions[agent][0];
        row + shift
    };
    // Deviations from the desired places are the same, car by car.
    for (a, b) in [(0, 2), (1, 1), (2, 0)] {
        let (x, y) = (at(&first, a, a as f64), at(&last, b, b as f64));
        assert!((x - y).abs() < 1e-9, "{a}: {x} {y}");
    }
    let without = text("[[2, 1]]", "positions = [0, -1, -2]\nvelocities = [0, 0, 1]", 4, 1);
    assert!(Scenario::read(&without).unwrap_err().to_string().contains("from 1 to 3"));
}

#[test]
fn ensembles_are_grids_of_replicas() {
    let text =
        "model = \"phase\"\n[state]\nrandom = { agents = 4, seed = 7 }\n[law]\nK1 = -1\nomega0 = 0\n[run]\nuntil = 1\n";
    assert!(Ensemble::read(text).unwrap().is_none());
    let many = format!(
        "{text}[ensemble]\nreplicas = 3\n[sweep]\nlaw.omega0 = [1, 2]\n\"law.K1\" = {{ from = -1, to = 0, count = 5 }}\n"
    );
    assert!(Scenario::read(&many).unwrap_err().to_string().contains("several runs"));
    let ensemble = Ensemble::read(&many).unwrap().expect("an ensemble");
    assert_eq!((ensemble.members(), ensemble.replicas()), (30, 3));
    let texts = |point: u64| ensemble.point(point).iter().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!(
        (texts(0), texts(4), texts(5)),
        (vec!["1".into(), "-1".into()], vec!["1".into(), "0".into()], vec!["2".into(), "-1".into()])
    );
    let start = |scenario: Scenario| scenario.run(&Unwatched).rows[0].frame.phases.clone();
    let plain = start(Scenario::read(text).unwrap());
    // The first replica draws what the file alone draws, at every point; the others something else.
    assert_eq!(start(ensemble.member(0).unwrap()), plain);
    assert_eq!(start(ensemble.member(27).unwrap()), plain);
    let others: Vec<Vec<f64>> = (1..3).map(|k| start(ensemble.member(k).unwrap())).collect();
    assert!(others[0] != plain && others[1] != plain && others[0] != others[1]);
    // Samples only: no rows before the end.
    assert_eq!(ensemble.sampled(5).unwrap().run(&Unwatched).rows.len(), 1);
    let wrong = many.replace("[1, 2]", "[1, \"x\"]");
    assert!(Ensemble::read(&wrong).unwrap_err().to_string().contains("`x` is not an integer"));
}
