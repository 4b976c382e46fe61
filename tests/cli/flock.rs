//! `flock` on model K and on flocks with control.

use super::{assert_refused, file, flockproof, folder, stdout};

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
        assert!(text.contains(from), "{from}");
        let path = file(&folder, name, text.replace(from, to).as_bytes());
        assert_refused(&["flock", "run", &path, "--until", "3"], named);
    }
}
