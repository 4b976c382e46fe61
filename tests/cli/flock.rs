//! `flock` on model K and on flocks with control.

use super::{assert_refused, file, flockproof, folder, stdout};
use std::path::Path;
use std::process::Output;

const KINEMATIC: &[u8] = br#"{"model": "K", "speed": "1/2", "headings": ["0", "1", "3/2"],
    "positions": [["0", "0"], ["1", "0"], ["5", "-3"]], "hysteresis": "1/1024"}"#;

#[test]
fn model_k_runs_with_the_same_contract() {
    let folder = folder("kinematic");
    let path = file(&folder, "k.json", KINEMATIC);
    let log = folder.join("log.jsonl");
    let log = log.to_str().expect("UTF-8");
    let output = flockproof(&["flock", "run", &path, "--until", "40", "--json", "--log", log]);
    assert!(output.status.success() && output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    let document: serde_json::Value = serde_json::from_str(&stdout(&output)).expect("one JSON document");
    let switches = document["switches"].as_array().expect("a list");
    let logged = std::fs::read_to_string(log).expect("a log");
    let logged: Vec<serde_json::Value> = logged.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    assert_eq!(switches, &logged);
    assert!(switches.iter().all(|s| s["t"].is_string() && s["gained"].is_array() && s["lost"].is_array()));
    assert!(document["flocks"].is_array() && document["steady_from"].is_null() && document["why"].is_string());
    assert!(document["denominator_bits"].is_u64());
    assert_eq!(document["precision_bits"], 128);
    let text = stdout(&flockproof(&["flock", "run", &path, "--until", "3"]));
    for part in ["model K, 3 birds", "sigma = 1/2", "extra rule", "hysteresis", "positions: 128 bits"] {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
    assert!(text.lines().all(|line| line.chars().count() <= 100));
    assert_refused(&["flock", "settle", &path], "model D only");
}

#[test]
fn constant_control_is_applied_and_declared() {
    let folder = folder("control");
    // Two birds far apart; the control turns the second one back at once.
    let path = file(
        &folder,
        "d.json",
        br#"{"model": "D", "weights": "lazy", "positions": [[0], ["9/2"]], "velocities": [[0], [1]],
            "control": [[1, 0], [0, -1]]}"#,
    );
    let text = stdout(&flockproof(&["flock", "run", &path, "--until", "5"]));
    assert!(text.contains("control") && text.contains("(0, -1)") && text.contains("0 switches"), "{text}");
    assert_refused(&["flock", "settle", &path], "without `control`");
    let kappa = br#"{"model": "K", "speed": 1, "positions": [[0, 0]], "headings": [0], "kappa": ["1/7"]}"#;
    let text = stdout(&flockproof(&["flock", "run", &file(&folder, "k.json", kappa), "--until", "5"]));
    assert!(text.contains("kappa = (1/7)"), "{text}");
}

/// A flock that is good but for one alteration is refused with a sentence that names it; returns the file.
fn assert_altered_is_refused(folder: &Path, name: &str, good: &str, (from, to): (&str, &str), named: &str) -> String {
    assert!(good.contains(from), "{from}");
    let path = file(folder, name, good.replace(from, to).as_bytes());
    assert_refused(&["flock", "run", &path, "--until", "3"], named);
    path
}

#[test]
fn bad_flocks_of_model_k_are_refused() {
    let folder = folder("bad_kinematic");
    let text = std::str::from_utf8(KINEMATIC).expect("UTF-8");
    for (name, from, to, named) in [
        ("speed.json", "\"1/2\"", "\"0\"", "speed must be positive"),
        ("heading.json", "\"3/2\"", "\"7\"", "[0, 2 pi)"),
        ("negative.json", "\"3/2\"", "\"-1/9\"", "[0, 2 pi)"),
        ("headings.json", ", \"3/2\"", "", "2 headings"),
        ("nan.json", "\"3/2\"", "\"NaN\"", "headings, bird 3"),
        ("weights.json", "\"speed\"", "\"weights\": \"lazy\", \"speed\"", "weights"),
        ("velocities.json", "\"speed\"", "\"velocities\": [], \"speed\"", "velocities"),
        ("dimension.json", "\"speed\"", "\"dimension\": 3, \"speed\"", "dimension"),
        ("model.json", "\"K\"", "\"V\"", "model"),
    ] {
        assert_altered_is_refused(&folder, name, text, (from, to), named);
    }
}

/// The four birds of Chazelle, section 3, with this hysteresis.
fn four_birds(hysteresis: &str) -> String {
    format!(
        r#"{{"model": "D", "dimension": 1, "weights": "lazy", "positions": [["0"], ["1/2"], ["21/16"], ["29/16"]],
            "velocities": [["1/8"], ["-1/8"], ["1/8"], ["-1/8"]], "hysteresis": "{hysteresis}"}}"#
    )
}

fn json(output: &Output) -> serde_json::Value {
    serde_json::from_str(&stdout(output)).unwrap_or_else(|error| panic!("{error}: {}", stdout(output)))
}

#[test]
fn flocks_are_run_and_settled() {
    let folder = folder("flock");
    let held = file(&folder, "held.json", four_birds("paper").as_bytes());
    let settled = json(&flockproof(&["flock", "settle", &held, "--json"]));
    assert_eq!(settled["steady_from"], "322");
    assert_eq!(settled["flocks"], serde_json::json!([[1, 2, 3, 4]]));
    assert_eq!(settled["switches"][0], serde_json::json!({"t": "1", "gained": [], "lost": [[2, 3]]}));
    assert_eq!(settled["switches"].as_array().map(Vec::len), Some(322));
    let ran = json(&flockproof(&["flock", "run", &held, "--until", "330", "--json"]));
    assert_eq!(ran["switches"], settled["switches"]);
    assert_eq!((&ran["steady_from"], &ran["until"]), (&serde_json::Value::Null, &serde_json::json!(330)));
    let free = file(&folder, "free.json", four_birds("none").as_bytes());
    let endless = json(&flockproof(&["flock", "settle", &free, "--json"]));
    assert_eq!((&endless["ending"], &endless["period"]), (&"alternating".into(), &2.into()));
    assert!(endless["steady_from"].is_null());
    let text = stdout(&flockproof(&["flock", "settle", &held]));
    assert!(text.contains("steady from t = 322 on") && text.contains("strictly"));
    assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
    // The log has one JSON object for each change.
    let log = folder.join("log.jsonl");
    let arguments = ["flock", "run", &held, "--until", "20", "--log", log.to_str().expect("UTF-8")];
    assert!(flockproof(&arguments).status.success());
    let lines = std::fs::read_to_string(&log).expect("written");
    assert_eq!(lines.lines().count(), 20);
    assert!(lines.lines().all(|line| serde_json::from_str::<serde_json::Value>(line).is_ok()));
}

#[test]
fn a_run_shows_stabilisers_and_mixing() {
    let folder = folder("observed");
    let held = file(&folder, "held.json", four_birds("paper").as_bytes());
    let ran = json(&flockproof(&["flock", "run", &held, "--until", "64", "--products", "--json"]));
    assert_eq!(ran["footprint"], "1111 1111 1111 1111");
    assert_eq!(ran["stabilisers"][0], serde_json::json!({"time": 3, "members": [1, 2, 3, 4]}));
    assert_eq!(ran["block_order"], serde_json::json!([1, 2, 3, 4]));
    let decay = ran["decay"].as_array().expect("a list");
    assert_eq!(decay.len(), 7);
    assert_eq!((&decay[0]["t"], &decay[0]["tau_1"]), (&1.into(), &"1".into()));
    assert!(ran["bits"]["state"].as_u64() > Some(100));
    let text = stdout(&flockproof(&["flock", "run", &held, "--until", "8", "--products"]));
    assert!(text.contains("V_1 = {1, 2, 3, 4}") && text.contains("tau_1"), "{text}");
}

#[test]
fn bad_flocks_are_refused() {
    let folder = folder("bad-flock");
    let good = four_birds("1/1024");
    for (name, from, to, named) in [
        ("weights", "\"lazy\"", "\"heavy\"", "weights"),
        ("heavy", "\"lazy\"", "{\"c\": [\"1\", \"1/3\", \"1/3\", \"1/3\"]}", "0 < c d < 1"),
        ("few", "\"lazy\"", "{\"c\": [\"1/3\"]}", "c_2"),
        ("dimension", "\"dimension\": 1", "\"dimension\": 2", "dimension"),
        ("number", "\"21/16\"", "\"21/x\"", "bird 3"),
        ("hysteresis", "1/1024", "-1/1024", "negative"),
        ("model", "\"D\"", "\"Z\"", "model"),
        ("ids", "\"model\"", "\"ids\": [\"a\", \"b\", \"a\", \"c\"], \"model\"", "two birds"),
        ("json", "}", "", "JSON"),
    ] {
        let path = assert_altered_is_refused(&folder, name, &good, (from, to), named);
        assert_refused(&["flock", "settle", &path], named);
    }
    let path = file(&folder, "good.json", good.as_bytes());
    assert_refused(&["flock", "run", &path], "--until");
    assert_refused(&["flock", "run", &path, "--until", "-1"], "--until");
    assert_refused(&["flock", "settle", &path, "--log", "/nowhere/log"], "/nowhere/log");
    assert_refused(&["flock", "settle", "/nowhere.json"], "/nowhere.json");
}
