//! `simulate`: contract of the files, one run of each model, wrong configurations.

use super::{assert_refused, file, flockproof, folder, stdout};
use serde_json::Value;
use std::path::Path;

const THREE: &str = include_str!("../../assets/scenarios/three_agents.toml");

/// Runs a configuration and returns its summary.
fn simulate(folder: &Path, name: &str, config: &str) -> Value {
    let path = file(folder, &format!("{name}.toml"), config.as_bytes());
    let out = folder.join(name);
    let output = flockproof(&["simulate", &path, "--out", out.to_str().expect("UTF-8")]);
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    let text = stdout(&output);
    let lines = || text.lines().filter(|line| !line.starts_with("in /"));
    assert!(lines().all(|line| line.chars().count() <= 80), "{name}: wider than 80 columns:\n{text}");
    for written in ["trajectory.csv", "observables.csv", "observables.svg", "observables.png"] {
        assert!(out.join(written).is_file(), "{name}: {written}");
    }
    serde_json::from_str(&std::fs::read_to_string(out.join("summary.json")).expect("written")).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

#[test]
fn three_agents_keep_the_contract() {
    let folder = folder("simulate-three");
    let summary = simulate(&folder, "three", THREE);
    assert_eq!(summary["model"], "velocity-alignment");
    assert!(summary["declaration"].as_str().is_some_and(|text| text.contains("integrator")));
    assert_eq!(summary["events"], serde_json::json!([]));
    let samples = summary["samples"].as_array().expect("a list");
    let times: Vec<f64> = samples.iter().map(|sample| number(&sample["t"])).collect();
    assert_eq!(times, [1.0, 10.0, 100.0]);
    for sample in samples {
        let observables = &sample["observables"];
        let [potential, kinetic] = ["potential", "kinetic"].map(|name| number(&observables[name]));
        assert!((number(&observables["energy"]) - potential - kinetic).abs() < 1e-12);
        assert_eq!(observables["saturated_energy"], observables["energy"]);
        assert_eq!(observables["components"], 1);
        // Momentum is conserved: the start has (0, 2).
        assert!(number(&observables["momentum"][0]).abs() < 1e-9);
        assert!((number(&observables["momentum"][1]) - 2.0).abs() < 1e-9);
        assert_eq!(sample["positions"].as_array().map(Vec::len), Some(3));
        assert_eq!(sample["velocities"][2].as_array().map(Vec::len), Some(2));
    }
    let energies: Vec<f64> = samples.iter().map(|sample| number(&sample["observables"]["energy"])).collect();
    assert!(energies.is_sorted_by(|a, b| a > b), "{energies:?}");
    // At the end all move together at the distance 1, where the potential has its minimum 1: energy 3 + (3/2)(2/3)².
    let last = &samples[2]["observables"];
    assert!(number(&last["disagreement"]) < 1e-6);
    assert!((number(&last["min_distance"]) - 1.0).abs() < 1e-6);
    assert!((number(&last["energy"]) - 3.0 - 2.0 / 3.0).abs() < 1e-6);
    let trajectory = std::fs::read_to_string(folder.join("three/trajectory.csv")).expect("written");
    assert!(trajectory.starts_with("t,agent,x,y,vx,vy\n0.0,1,0.0,0.0,1.0,0.0\n"));
    // 501 times of the grid, which has the samples, with three agents each, and the header.
    assert_eq!(trajectory.lines().count(), 1 + 3 * 501);
    assert!(std::fs::read(folder.join("three/paths.png")).expect("written").starts_with(b"\x89PNG"));
}

#[test]
fn files_are_the_same_for_any_number_of_threads() {
    let folder = folder("simulate-threads");
    let config = include_str!("../../assets/scenarios/switching_flock.toml");
    let path = file(&folder, "flock.toml", config.as_bytes());
    let run = |threads: &str| {
        let out = folder.join(threads);
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_flockproof"))
            .args(["simulate", &path, "--json", "--out", out.to_str().expect("UTF-8")])
            .env("RAYON_NUM_THREADS", threads)
            .output()
            .expect("it starts");
        assert!(output.status.success());
        let written = std::fs::read(out.join("summary.json")).expect("written");
        assert_eq!(output.stdout, written);
        [written, std::fs::read(out.join("paths.svg")).expect("written")]
    };
    assert_eq!(run("1"), run("3"));
}

#[test]
fn switches_are_events() {
    let folder = folder("simulate-events");
    // Two agents pass each other on parallel lines without a force: linked while |x| < 2 sqrt(6), at speed 2 - but
    // alignment slows them down only while they are linked.
    let config = r#"
        model = "velocity-alignment"
        [graph]
        kind = "within"
        radius = 1
        [state]
        positions = [[-2, 0], [2, 0], [0, 50]]
        velocities = [[2, 0], [-2, 0], [0, 0]]
        [law]
        potential = "none"
        [run]
        until = 3
        samples = [0, 3]
    "#;
    let summary = simulate(&folder, "pass", config);
    let events = summary["events"].as_array().expect("a list");
    assert_eq!((&events[0]["kind"], &events[0]["pair"]), (&"link".into(), &serde_json::json!([1, 2])));
    // The distance 4 - 4 t is 1 at t = 3/4.
    assert!((number(&events[0]["t"]) - 0.75).abs() < 1e-12, "{}", events[0]);
    // Then d' = -4 exp(-2 s), so that the distance goes from 1 down to -1: never below -1, no unlink.
    assert_eq!(events.len(), 1);
    let last = &summary["samples"][1]["observables"];
    assert_eq!(last["components"], 2);
    let distance = 1.0 - 2.0 * (1.0 - (-2.0f64 * 2.25).exp());
    assert!((number(&last["min_distance"]) - distance.abs()).abs() < 1e-8);
    let flock = simulate(&folder, "flock", include_str!("../../assets/scenarios/switching_flock.toml"));
    let events = flock["events"].as_array().expect("a list");
    assert!(!events.is_empty());
    assert!(events.iter().all(|event| event["pair"][0].as_u64() < event["pair"][1].as_u64()));
    assert!(events.iter().map(|event| number(&event["t"])).is_sorted());
    let saturated =
        flock["samples"].as_array().into_iter().flatten().map(|s| number(&s["observables"]["saturated_energy"]));
    assert!(saturated.is_sorted_by(|a, b| a >= b));
}

#[test]
fn particles_form_a_pattern() {
    let folder = folder("simulate-pattern");
    let config = include_str!("../../assets/scenarios/pattern.toml");
    let longer = config.replace("until = 300", "until = 1000").replace("200, 300]", "300, 1000]");
    let summary = simulate(&folder, "pattern", &longer);
    let last = &summary["samples"][3]["observables"];
    assert_eq!((&last["pattern_order"], &last["clusters"]), (&3.into(), &3.into()));
    assert!(number(&last["centre_spread"]) < 1e-2);
    assert!((number(&last["order"][2]) - 1.0 / 3.0).abs() < 1e-3);
    assert_eq!(summary["samples"][0]["phases"].as_array().map(Vec::len), Some(12));
}

/// A start of four agents, a graph and a law each.
const MODELS: [(&str, &str); 7] = [
    (
        "phase",
        "model = \"phase\"\n[graph]\nkind = \"ring\"\n[state]\nphases = [0, 1, \"5/2\", 4]\n[law]\nomega0 = 1\nK1 = -1\n[run]\nuntil = 60\n",
    ),
    (
        "reference",
        "model = \"particles\"\n[graph]\nkind = \"all-to-all\"\n[state]\npositions = [[0, 0], [1, 0], [0, 1], [1, 1]]\nphases = [0, 1, 2, 3]\n[law]\nK1 = -1\nreference = \"1/2\"\n[run]\nuntil = 100\n",
    ),
    (
        "nearest",
        "model = \"particles\"\n[graph]\nkind = \"nearest\"\nnearest = 2\n[state]\npositions = [[0, 0], [1, 0], [0, 1], [3, 1]]\nphases = [0, 1, 2, 3]\n[law]\nK1 = -1\nomega0 = \"1/2\"\nK0 = \"1/2\"\ndrift = [\"1/10\", 0]\n[run]\nuntil = 20\n",
    ),
    (
        "fish",
        "model = \"fish\"\n[state]\npositions = [[0, 0], [1, 0], [0, 1], [3, 1]]\nphases = [0, 1, 2, 3]\n[law]\nT = \"1/10\"\nKrep = 5\nKori = 1\nKatt = 1\nrepulsion = \"1/2\"\norientation = 2\nattraction = 10\nblind_angle = 60\n[run]\nuntil = 20\n",
    ),
    (
        "heading",
        "model = \"heading-alignment\"\n[graph]\nkind = \"path\"\n[state]\npositions = [[0, 0], [1, 0], [0, 1], [3, 1]]\nvelocities = [[1, 0], [0, 1], [-1, 1], [-1, -1]]\n[law]\npotential = \"inverse-square-log\"\n[run]\nuntil = 20\n",
    ),
    (
        "platoon",
        "model = \"platoon\"\n[state]\npositions = [[0], [-1], [-2], [-3]]\nvelocities = [[1], [1], [1], [0]]\n[law]\nf = -1\ng = -2\n[run]\nuntil = 100\n",
    ),
    (
        "vicsek",
        "model = \"vicsek\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\npositions = [[0, 0], [1, 0], [0, 1], [3, 1]]\nvelocities = [[1, 0], [1, 1], [1, 0], [\"1/2\", 0]]\n[run]\nuntil = 20\n",
    ),
];

#[test]
fn every_model_runs() {
    let folder = folder("simulate-models");
    let last = |name: &str| -> Value {
        let config = MODELS.iter().find(|(known, _)| *known == name).expect("it is there").1;
        let summary = simulate(&folder, name, config);
        assert_eq!(summary["ended"], "finished");
        summary["samples"].as_array().and_then(|list| list.last()).expect("a sample")["observables"].clone()
    };
    let phase = last("phase");
    assert!((number(&phase["order"][0]) - 1.0).abs() < 1e-6 && number(&phase["phase_potential"]) < 1e-6);
    let reference = last("reference");
    assert!((number(&reference["momentum"][0]) - 4.0 * 0.5f64.cos()).abs() < 1e-3, "{reference}");
    assert!(number(&last("nearest")["centre_spread"]).is_finite());
    assert!(number(&last("fish")["min_distance"]) > 0.0);
    let heading = last("heading");
    assert!(number(&heading["heading_spread"]) <= std::f64::consts::PI);
    let platoon = last("platoon");
    assert!((number(&platoon["min_gap"]) - 1.0).abs() < 1e-6 && (number(&platoon["max_gap"]) - 1.0).abs() < 1e-6);
    assert!(number(&platoon["disagreement"]) < 1e-6);
    assert!(number(&last("vicsek")["disagreement"]).is_finite());
    // Phases instead of velocities: model K.
    let config = MODELS[6].1.replace(
        "velocities = [[1, 0], [1, 1], [1, 0], [\"1/2\", 0]]",
        "phases = [0, 1, 2, 3]\n[law]\nspeed = \"1/10\"",
    );
    let kinematic = simulate(&folder, "model-k", &config);
    assert!(kinematic["samples"][0]["phases"].is_array() && kinematic["samples"][0]["observables"]["order"].is_array());
}

/// A configuration that is good but for one alteration is refused with a sentence that has all these parts.
fn assert_altered_is_refused(kind: &str, good: &str, (from, to): (&str, &str), named: &[&str]) {
    assert!(good.contains(from), "{from}");
    let folder = folder(&format!("simulate-bad-{kind}"));
    let path = file(&folder, "bad.toml", good.replacen(from, to, 1).as_bytes());
    let out = folder.join("out");
    for part in named.iter().chain(&["bad.toml"]) {
        assert_refused(&["simulate", &path, "--out", out.to_str().expect("UTF-8")], part);
    }
    assert!(!out.exists(), "{to}: a folder was made");
}

#[test]
fn bad_configurations_are_refused() {
    for (from, to, named) in [
        (
            "model = \"velocity-alignment\"",
            "model = \"boids\"",
            &["line 3", "boids", "velocity-alignment", "vicsek"][..],
        ),
        ("model = \"velocity-alignment\"", "", &["`model` is missing"]),
        ("model", "\nmodell", &["line 4", "modell", "allowed are model, graph"]),
        ("kind = \"complete\"", "kind = \"star\"", &["line 6", "graph.kind", "star", "within"]),
        ("kind = \"complete\"", "", &["`kind` is missing in [graph]"]),
        ("[graph]\nkind = \"complete\"", "", &["[graph] is missing"]),
        ("kind = \"complete\"", "kind = \"complete\"\nradius = 1", &["line 7", "no key `radius`", "allowed are kind"]),
        ("kind = \"complete\"", "kind = \"within\"\nradius = 0", &["line 7", "graph.radius", "above 0"]),
        ("kind = \"complete\"", "kind = \"within\"\nradius = \"-1/2\"", &["graph.radius", "above 0"]),
        ("kind = \"complete\"", "kind = \"within\"", &["`radius` is missing"]),
        ("kind = \"complete\"", "kind = \"nearest\"\nnearest = 1", &["undirected"]),
        ("kind = \"complete\"", "kind = \"circulant\"\noffsets = [3]", &["graph.offsets, entry 1", "1 to 2"]),
        (
            "kind = \"complete\"",
            "kind = \"edges\"\nedges = [[1, 2], [2, 4]]",
            &["graph.edges, entry 2", "2-4", "3 agents"],
        ),
        ("kind = \"complete\"", "kind = \"edges\"\nedges = [[0, 2]]", &["0-2"]),
        ("kind = \"complete\"", "kind = \"edges\"\nedges = [[1, 2], [2, 1]]", &["2-1", "twice"]),
        ("kind = \"complete\"", "kind = \"edges\"\nedges = [[2, 2]]", &["with itself"]),
        ("kind = \"complete\"", "kind = \"edges\"\nedges = [[1, 2, 3]]", &["edges without weights"]),
        ("kind = \"complete\"", "kind = \"edges\"\nedges = [[1, 2]]\ndirected = true", &["directed", "undirected"]),
        ("[[\"0\", \"0\"], [\"2\", \"0\"], [\"0\", \"1\"]]", "[]", &["state.positions", "no agents"]),
        ("[\"2\", \"0\"]", "[\"2\"]", &["state.positions, entry 2", "1 coordinates instead of 2"]),
        ("[\"2\", \"0\"]", "[\"2\", \"0/0\"]", &["line 9", "state.positions, entry 2, entry 2", "zero denominator"]),
        ("[\"2\", \"0\"]", "[nan, 0]", &["state.positions, entry 2, entry 1", "nan"]),
        ("[\"2\", \"0\"]", "[inf, 0]", &["state.positions, entry 2, entry 1", "inf"]),
        ("[\"2\", \"0\"]", "[\"1e400\", 0]", &["too large"]),
        ("[\"2\", \"0\"]", "[\"0\", \"0\"]", &["agents 1 and 2", "same place"]),
        (", [\"-1\", \"1\"]]", "]", &["state.velocities", "2 entries for 3 agents"]),
        ("velocities =", "speeds =", &["no key `speeds`", "positions, velocities"]),
        ("[law]\npotential = \"inverse-square-log\"", "", &["[law] is missing"]),
        ("potential = \"inverse-square-log\"", "", &["`potential` is missing"]),
        ("\"inverse-square-log\"", "\"gravity\"", &["law.potential", "gravity", "inverse-square-spring"]),
        ("\"inverse-square-log\"", "{ slope = [[1, nan]], at = 1, value = 0 }", &["nan"]),
        ("\"inverse-square-log\"", "{ slope = [[-64, -1]], at = \"1e-300\", value = 0 }", &["not finite"]),
        ("\"inverse-square-log\"", "\"inverse-square-log\"\nminimum = 0", &["law.minimum", "above 0"]),
        ("\"inverse-square-log\"", "\"inverse-square-log\"\nomega0 = 1", &["omega0", "allowed are potential"]),
        ("until = 100", "until = 0", &["run.until", "above 0"]),
        ("until = 100", "", &["`until` is missing"]),
        ("[1, 10, 100]", "[1, 10, 101]", &["run.samples, entry 3", "101", "beyond until = 100"]),
        ("[1, 10, 100]", "[10, 1, 100]", &["run.samples, entry 2", "1 follows 10"]),
        ("[1, 10, 100]", "[-1]", &["not negative"]),
        ("1e-12", "0", &["run.tolerance", "1e-14"]),
        ("1e-12", "-1", &["run.tolerance"]),
        ("1e-12", "nan", &["run.tolerance"]),
        ("[run]", "[run", &["line 15", "TOML"]),
        ("until = 100", "until = 100\nuntil = 100", &["line 17", "twice"]),
    ] {
        assert_altered_is_refused("three", THREE, (from, to), named);
    }
}

#[test]
fn bad_configurations_of_other_models_are_refused() {
    let good = |name: &str| MODELS.iter().find(|(known, _)| *known == name).expect("it is there").1;
    for (name, from, to, named) in [
        ("phase", "\"ring\"", "\"within\"\nradius = 1", &["no positions"][..]),
        ("phase", "phases = [0, 1, \"5/2\", 4]", "phases = [0, 1]", &["3 agents for a ring"]),
        ("phase", "K1 = -1", "K = [1, 1, -1]", &["law.K", "M = 3", "N = 4"]),
        ("phase", "K1 = -1", "K = [1, -1]", &["all-to-all"]),
        ("phase", "K1 = -1", "K1 = -1\nK = [1]", &["`K` and `K1`"]),
        ("phase", "K1 = -1", "K0 = -1", &["K0", "allowed are omega0, K1, K, reference"]),
        ("nearest", "omega0 = \"1/2\"", "omega0 = 0", &["law.omega0", "must not be 0"]),
        ("nearest", "nearest = 2", "nearest = 4", &["graph.nearest", "1 to 3"]),
        ("nearest", "drift = [\"1/10\", 0]", "drift = [1]", &["law.drift", "instead of 2"]),
        ("fish", "T = \"1/10\"", "T = 0", &["law.T", "above 0"]),
        ("fish", "orientation = 2", "orientation = \"1/4\"", &["law.orientation", "at least 0.5"]),
        ("fish", "blind_angle = 60", "blind_angle = 400", &["180 degrees"]),
        ("fish", "until = 20", "until = \"401/40\"", &["multiple"]),
        ("fish", "[1, 0]", "[0, 0]", &["same place"]),
        ("heading", "[0, 1], [-1, 1]", "[0, 0], [-1, 1]", &["agent 2", "no heading"]),
        ("platoon", "g = -2", "g = 0", &["law.g", "g must be negative"]),
        (
            "platoon",
            "[[0], [-1], [-2], [-3]]\nvelocities = [[1], [1], [1], [0]]",
            "[[0]]\nvelocities = [[1]]",
            &["follower"],
        ),
        ("platoon", "[law]", "[graph]\nkind = \"path\"\n[law]\ncommunication = \"front\"", &["cannot both"]),
        ("vicsek", "\"within\"", "\"ring\"", &["within"]),
        ("vicsek", "until = 20", "until = 20\nsamples = [\"1/2\"]", &["multiple of the time step 1"]),
    ] {
        assert_altered_is_refused(name, good(name), (from, to), named);
    }
    let out = std::env::temp_dir();
    assert_refused(&["simulate", "/nowhere.toml", "--out", out.to_str().expect("UTF-8")], "/nowhere.toml");
    assert_refused(&["simulate", "/nowhere.toml"], "--out");
}

#[test]
fn random_starts_are_repeated_by_their_seed() {
    let folder = folder("simulate-random");
    let config = |seed: u64| {
        format!(
            "model = \"phase\"\n[state]\nrandom = {{ agents = 5000, seed = {seed} }}\n[law]\nK1 = -1\n[run]\nuntil = 1\nrows = 2\n"
        )
    };
    let ends: Vec<Value> =
        [("a", 1), ("b", 1), ("c", 2)].map(|(name, seed)| simulate(&folder, name, &config(seed))).into();
    assert!(ends[0]["samples"] == ends[1]["samples"]);
    assert!(ends[0]["samples"] != ends[2]["samples"]);
    assert_altered_is_refused("random", &config(1), ("[law]", "phases = [0]\n[law]"), &["`random` and `phases`"]);
    assert_altered_is_refused("random", &config(1), ("5000", "0"), &["state.random.agents", "from 1 to"]);
    assert_altered_is_refused("random", &config(1), ("seed", "sed"), &["no key `sed`"]);
    let path = file(&folder, "good.toml", config(1).as_bytes());
    let occupied = file(&folder, "occupied", b"");
    assert_refused(&["simulate", &path, "--out", &occupied], "occupied");
}

/// Many runs: the same bytes for any number of threads and shards; a member alone draws the same.
#[test]
fn ensembles_do_not_depend_on_threads_or_shards() {
    let folder = folder("simulate-ensemble");
    let config = include_str!("../../assets/scenarios/noise_sweep.toml").replace("agents = 100", "agents = 20");
    let config = config.replace("until = 200", "until = 20").replace("[100, 200]", "[10, 20]");
    let path = file(&folder, "sweep.toml", config.as_bytes());
    let run = |name: &str, threads: &str, more: &[&str]| {
        let out = folder.join(name);
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_flockproof"))
            .args(["simulate", &path, "--out", out.to_str().expect("UTF-8")])
            .args(more)
            .env("RAYON_NUM_THREADS", threads)
            .output()
            .expect("the program starts");
        assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
        stdout(&output)
    };
    let text = run("one", "1", &[]);
    assert!(text.starts_with("56 runs: 8 replicas of each point\n") && text.contains("law.noise = 6"), "{text}");
    run("four", "4", &[]);
    for shard in ["2/3", "1/3", "3/3"] {
        run("shards", "2", &["--shard", shard]);
    }
    run("shards", "2", &["--merge"]);
    let read = |name: &str, of: &str| std::fs::read(folder.join(of).join(name)).expect(name);
    for name in ["summary.json", "members.csv", "statistics.csv", "statistics.svg", "about.txt"] {
        assert_eq!(read(name, "one"), read(name, "four"), "{name}");
        assert_eq!(read(name, "one"), read(name, "shards"), "{name}");
    }
    // Finished runs are taken from the folder, also after a part of them was lost.
    let before = read("members.csv", "one");
    let all = String::from_utf8(read("shard-1-of-1.jsonl", "one")).expect("text");
    let half: Vec<&str> = all.lines().take(20).collect();
    std::fs::remove_file(folder.join("one/shard-1-of-1.jsonl")).expect("there");
    std::fs::write(folder.join("one/shard-1-of-1.jsonl.part"), half.join("\n") + "\n").expect("written");
    run("one", "2", &["--resume"]);
    assert_eq!(read("members.csv", "one"), before);
    run("member", "1", &["--member", "12"]);
    let observables = String::from_utf8(read("observables.csv", "member")).expect("text");
    let last = observables.lines().last().expect("a line").split_once(',').expect("columns").1.to_string();
    let members = String::from_utf8(before).expect("text");
    assert!(members.lines().any(|line| line.starts_with("12,1,4,0,20.0,") && line.ends_with(&last)), "{last}");
}

/// `run.npz` is a ZIP archive that names its arrays.
#[test]
fn runs_are_arrays_too() {
    let folder = folder("simulate-npz");
    simulate(&folder, "three", THREE);
    let bytes = std::fs::read(folder.join("three/run.npz")).expect("written");
    assert!(bytes.starts_with(b"PK\x03\x04") && bytes.len() > 501 * 3 * 4 * 8);
    let has = |text: &[u8]| bytes.windows(text.len()).any(|part| part == text);
    assert!(has(b"positions.npy") && has(b"'shape': (501, 3, 2), }") && has(b"energy.npy") && has(b"events.npy"));
}

/// Every law of the gallery runs to its end; what the literature says of it is seen in the run.
#[test]
fn the_gallery_of_laws_runs() {
    let folder = folder("simulate-laws");
    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/laws");
    let read = |name: &str| std::fs::read_to_string(gallery.join(format!("{name}.toml"))).expect("a law");
    let mut names: Vec<String> = std::fs::read_dir(&gallery)
        .expect("a folder")
        .map(|entry| entry.expect("a file").path())
        .filter(|path| path.is_file())
        .map(|path| path.file_stem().expect("a name").to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert!(names.len() >= 19, "{names:?}");
    let runs: std::collections::BTreeMap<String, Value> =
        names.iter().map(|name| (name.clone(), simulate(&folder, name, &read(name)))).collect();
    for (name, summary) in &runs {
        assert_eq!(summary["ended"], "finished", "{name}");
        assert!(summary["declaration"].as_str().is_some_and(|text| text.contains("law of one's own")), "{name}");
    }
    let samples = |name: &str| runs[name]["samples"].as_array().expect("a list").clone();
    // Cucker and Smale: the momentum stays, the fluctuation falls. Motsch and Tadmor: the momentum does not stay.
    let all = samples("cucker_smale");
    for pair in all.windows(2) {
        for k in 0..2 {
            let momentum = |sample: &Value| number(&sample["observables"]["momentum"][k]);
            assert!((momentum(&pair[0]) - momentum(&pair[1])).abs() < 1e-8);
        }
        assert!(number(&pair[1]["observables"]["fluctuation"]) < number(&pair[0]["observables"]["fluctuation"]));
    }
    let all = samples("motsch_tadmor");
    let momentum = |sample: &Value| number(&sample["observables"]["momentum"][0]);
    assert!((momentum(&all[0]) - momentum(&all[2])).abs() > 1e-3);
    // Hegselmann and Krause: opinions in groups more than the confidence apart.
    let opinions: Vec<f64> =
        samples("hegselmann_krause")[0]["x"].as_array().expect("a list").iter().map(number).collect();
    assert!(opinions.windows(2).all(|pair| pair[1] - pair[0] == 0.0 || pair[1] - pair[0] > 1.0), "{opinions:?}");
    // Kuramoto: locked at this coupling, at the mean of the natural frequencies, which is 0.
    let order = |k: usize| number(&samples("kuramoto")[k]["observables"]["order"][0]);
    assert!((order(1) - order(2)).abs() < 1e-2 && order(2) > 0.9);
}

/// Laws of the papers, written as files, move as the built-in ones.
#[test]
fn files_of_built_in_laws_move_as_these() {
    let folder = folder("simulate-built-in");
    let read = |name: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("assets/laws/{name}.toml"));
        std::fs::read_to_string(path).expect("a law")
    };
    let numbers = |value: &Value| -> Vec<f64> {
        let list = value.as_array().expect("a list");
        list.iter()
            .flat_map(|x| x.as_array().map_or_else(|| vec![x.clone()], Clone::clone))
            .map(|x| number(&x))
            .collect()
    };
    let alike = |own: &Value, built_in: &Value, names: &[(&str, &str)]| {
        let (a, b) = (own["samples"].as_array().expect("a list"), built_in["samples"].as_array().expect("a list"));
        assert_eq!(a.len(), b.len());
        for (a, b) in a.iter().zip(b) {
            for (mine, theirs) in names {
                for (x, y) in numbers(&a[*mine]).iter().zip(numbers(&b[*theirs])) {
                    assert!((x - y).abs() < 1e-7, "{mine}: {x} {y}");
                }
            }
        }
    };
    let names = [("x", "positions"), ("v", "velocities")];
    let text = read("velocity_alignment");
    let end = text.find("[law]").zip(text.find("[graph]")).expect("sections");
    let built_in = text.replace(&text[end.0..end.1], "[law]\npotential = \"inverse-square-log\"\n");
    let built_in = built_in.replace("\"own\"", "\"velocity-alignment\"").replace("\nx = ", "\npositions = ");
    let built_in = built_in.replace("\nv = ", "\nvelocities = ");
    let (own, built_in) = (simulate(&folder, "own", &text), simulate(&folder, "built-in", &built_in));
    alike(&own, &built_in, &names);
    let times = |summary: &Value| -> Vec<(f64, Value)> {
        let events = summary["events"].as_array().expect("a list");
        events.iter().map(|event| (number(&event["t"]), event["pair"].clone())).collect()
    };
    let (a, b) = (times(&own), times(&built_in));
    assert!(!a.is_empty() && a.len() == b.len());
    assert!(a.iter().zip(&b).all(|(x, y)| (x.0 - y.0).abs() < 1e-7 && x.1 == y.1), "{a:?} {b:?}");
    let text = read("platoon_behind");
    let built_in = "model = \"platoon\"\n[state]\npositions = [0, -1, \"-5/2\", -3]\nvelocities = [1, 0, 0, 0]\n[law]\nf = -1\ng = -1\ncommunication = \"front\"\n[run]\nuntil = 30\nsamples = [1, 10, 30]\n";
    let (own, built_in) = (simulate(&folder, "behind", &text), simulate(&folder, "front", built_in));
    alike(&own, &built_in, &[("x", "positions"), ("v", "velocities")].map(|(a, b)| (a, b)));
    // The exact flock: x(0) = x(1) - v(1), and every switch in the same step.
    let own = simulate(&folder, "lazy", &read("lazy_averaging"));
    let flock = r#"{"model":"D","dimension":1,"weights":"lazy","positions":[["-1/8"],["1"],["8/5"],["14/5"]],"velocities":[["1/8"],["0"],["1/5"],["0"]]}"#;
    let path = file(&folder, "lazy.json", flock.as_bytes());
    let output = flockproof(&["flock", "run", &path, "--until", "21", "--json"]);
    let exact: Value = serde_json::from_str(&stdout(&output)).expect("JSON");
    let mut wanted = Vec::new();
    for switch in exact["switches"].as_array().expect("a list") {
        let time: f64 = switch["t"].as_str().expect("a text").parse().expect("a number");
        for (key, kind) in [("gained", "link"), ("lost", "unlink")] {
            let pairs = switch[key].as_array().expect("a list").iter();
            wanted.extend(pairs.map(|pair| (time - 1.0, kind.to_string(), pair.clone())));
        }
    }
    let events = own["events"].as_array().expect("a list").iter();
    let mut found: Vec<_> = events
        .map(|event| (number(&event["t"]), event["kind"].as_str().expect("a text").to_string(), event["pair"].clone()))
        .collect();
    let by = |a: &(f64, String, Value), b: &(f64, String, Value)| {
        a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.to_string().cmp(&b.2.to_string()))
    };
    found.sort_by(by);
    wanted.retain(|(time, ..)| *time > 0.0);
    wanted.sort_by(by);
    assert!(!found.is_empty());
    assert_eq!(found, wanted);
}
