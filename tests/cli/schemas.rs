//! Every JSON document that is printed or written keeps to its schema in `assets/schemas/`.

use super::{file, flockproof, folder, stdout, with_input};
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::path::Path;

/// Checks a value against the part of JSON Schema that the schemas use; other keywords are refused, so that none is passed over.
fn check(schema: &Value, value: &Value, place: &str) -> Result<(), String> {
    let keywords = schema.as_object().expect("a schema is an object");
    let refuse = |why: String| Err(format!("{place}: {why}"));
    for (keyword, rule) in keywords {
        match keyword.as_str() {
            "$schema" | "title" | "description" => {}
            "const" if value == rule => {}
            "const" => return refuse(format!("{value} is not {rule}")),
            "enum" if rule.as_array().expect("a list").contains(value) => {}
            "enum" => return refuse(format!("{value} is none of {rule}")),
            "type" => {
                let names = rule.as_array().cloned().unwrap_or_else(|| vec![rule.clone()]);
                if !names.iter().any(|name| is_of_type(name.as_str().expect("a word"), value)) {
                    return refuse(format!("{value} is not {rule}"));
                }
            }
            "pattern" => {
                assert_eq!(rule, "^[0-9a-f]{64}$", "no other pattern is known here");
                let text = value.as_str().unwrap_or_default();
                if text.len() != 64 || !text.bytes().all(|b| b.is_ascii_digit() || (b'a'..=b'f').contains(&b)) {
                    return refuse(format!("{value} is no digest"));
                }
            }
            "items" => {
                for (k, item) in value.as_array().into_iter().flatten().enumerate() {
                    check(rule, item, &format!("{place}[{k}]"))?;
                }
            }
            "required" => {
                let Some(object) = value.as_object() else { continue };
                let missing = rule
                    .as_array()
                    .expect("a list")
                    .iter()
                    .find(|key| !object.contains_key(key.as_str().expect("a key")));
                if let Some(key) = missing {
                    return refuse(format!("{key} is missing"));
                }
            }
            "properties" | "additionalProperties" => {}
            other => panic!("{place}: the keyword {other} is not known here"),
        }
    }
    let none = Map::new();
    let known = keywords.get("properties").and_then(Value::as_object).unwrap_or(&none);
    for (key, item) in value.as_object().into_iter().flatten() {
        match (known.get(key), keywords.get("additionalProperties")) {
            (Some(rule), _) => check(rule, item, &format!("{place}.{key}"))?,
            (None, Some(Value::Bool(false))) => return refuse(format!("there should be no key {key}")),
            (None, Some(rule @ Value::Object(_))) => check(rule, item, &format!("{place}.{key}"))?,
            (None, _) => {}
        }
    }
    Ok(())
}

fn is_of_type(name: &str, value: &Value) -> bool {
    match name {
        "string" => value.is_string(),
        "integer" => value.is_i64() || value.is_u64(),
        "number" => value.is_number(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        other => panic!("the type {other} is not known here"),
    }
}

fn schema(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("assets/schemas/{name}.json"));
    serde_json::from_str(&std::fs::read_to_string(&path).expect("a schema")).expect("JSON")
}

/// Checks a document, and that the schema notices what is left out, added or of another type.
fn assert_keeps(name: &str, document: &Value) {
    let schema = schema(name);
    check(&schema, document, name).unwrap_or_else(|why| panic!("{why}"));
    for key in schema["required"].as_array().expect("a list") {
        let key = key.as_str().expect("a key");
        let mut altered = document.clone();
        altered.as_object_mut().expect("an object").remove(key);
        assert!(check(&schema, &altered, name).is_err(), "{name}: {key} may be left out");
        altered[key] = serde_json::json!([true, [[true]]]);
        assert!(check(&schema, &altered, name).is_err(), "{name}: {key} may be a list of anything");
    }
    let mut altered = document.clone();
    altered["another"] = Value::Null;
    assert!(name == "check" || check(&schema, &altered, name).is_err(), "{name}: there may be another key");
}

fn printed(arguments: &[&str]) -> Value {
    let output = flockproof(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_str(&stdout(&output)).expect("one JSON document on standard output")
}

#[test]
fn documents_keep_to_their_schemas() {
    let folder = folder("schemas");
    let (root, out) = (env!("CARGO_MANIFEST_DIR"), folder.join("out").to_string_lossy().into_owned());
    let asset = |name: &str| format!("{root}/assets/{name}");
    let (birds, matrices) = (asset("four_birds.json"), asset("two_matrices.txt"));
    let (scenario, tracks) = (asset("scenarios/switching_flock.toml"), asset("example_tracks.csv"));
    let cars = asset("systems/platoon_plad01.toml");
    let (names, floats) = (asset("graphs/path.graphml"), asset("float_matrices.json"));
    // Three cars in a circle, hardly led: stable with strong gains only.
    let circle = file(&folder, "circle.txt", b"directed\nb a 1\nb d 9\nc b\nd c\n");
    let single = file(&folder, "k.json", br#"{"model": "K", "speed": 1, "positions": [[0, 0]], "headings": [0]}"#);
    let free = std::fs::read_to_string(&birds).expect("text").replace("\"paper\"", "\"none\"");
    let free = file(&folder, "free.json", free.as_bytes());
    let drawn = "model = \"phase\"\n[state]\nrandom = { agents = 3 }\n[law]\nK1 = -1\n[run]\nuntil = 1\n[ensemble]\nreplicas = 2\n[sweep]\n\"law.K1\" = [-1, \"-1/2\"]\n";
    let ensemble = file(&folder, "ensemble.toml", drawn.as_bytes());
    let many = folder.join("many").to_string_lossy().into_owned();
    let matrices_of_cars = folder.join("matrices").to_string_lossy().into_owned();
    printed(&["resonance", "--followers", "2", "--f=-1,-3", "--g=-2", "--export", &matrices_of_cars, "--json"]);
    for (name, arguments) in [
        ("ledger", vec!["verify", "--claim", "veerman.lem2", "--claim", "veerman.gain_max", "--json", "-"]),
        ("list", vec!["list", "--json"]),
        ("explain", vec!["explain", "veerman.gain_max", "--json"]),
        ("explain", vec!["explain", "chazelle.tau1", "--json"]),
        ("resonance", vec!["resonance", "--followers", "4", "--f", "-1", "--g=-1/2", "--json"]),
        ("response", vec!["resonance", "--graph", "circulant:7:1,2", "--f", "-1", "--g=-1", "--json"]),
        ("resonance", vec!["resonance", "--followers", "4", "--f=-1", "--g=-1", "--response", "1,2", "--json"]),
        (
            "response",
            vec!["resonance", "--followers", "4", "--f=-1", "--g=-1", "--ahead=0.6", "--response=1", "--json"],
        ),
        (
            "response",
            vec![
                "resonance",
                "--graph",
                "front",
                "--followers",
                "120",
                "--f",
                "-1",
                "--g=-1",
                "--response=1",
                "--json",
            ],
        ),
        ("response", vec!["resonance", "--graph", "front", "--followers", "120", "--f", "-1", "--g=-1", "--json"]),
        ("response", vec!["resonance", "--graph", &circle, "--from", "a", "--f", "-5", "--g=-1/10", "--json"]),
        ("response", vec!["resonance", "--graph", &circle, "--from", "a", "--f", "-5", "--g=-10", "--json"]),
        ("resonance-sweep", vec!["resonance", "--followers", "4", "--sweep", "f=-2..-1:3,g=-1", "--json"]),
        ("spectrum", vec!["spectrum", "--graph", "ring:12", "--json"]),
        ("spectrum", vec!["spectrum", "--graph", &names, "--kind", "adjacency", "--json"]),
        ("ergodicity", vec!["ergodicity", &floats, "--normalise", "--json"]),
        ("spectrum", vec!["spectrum", "--graph", "platoon1:8", "--kind", "reduced", "--root", "2", "--json"]),
        ("spectrum", vec!["spectrum", "--graph", "circulant:7:1,3", "--kind", "adjacency", "--json"]),
        ("ergodicity", vec!["ergodicity", &matrices, "--json"]),
        ("flock-run", vec!["flock", "run", &birds, "--until", "9", "--products", "--json"]),
        ("flock-run", vec!["flock", "run", &single, "--until", "0", "--json"]),
        ("flock-settle", vec!["flock", "settle", &birds, "--json"]),
        ("flock-settle", vec!["flock", "settle", &free, "--json"]),
        ("simulate", vec!["simulate", &scenario, "--out", &out, "--json"]),
        ("ensemble", vec!["simulate", &ensemble, "--out", &many, "--json"]),
        ("state-response", vec!["resonance", "--state", &matrices_of_cars, "--response", "1", "--json"]),
        ("response", vec!["resonance", "--graph", "front", "--followers", "2", "--f=-1,-2", "--g=-1", "--json"]),
        ("fuzz", vec!["fuzz", "spectrum.exact", "--cases", "3", "--json"]),
        ("fuzz-case", vec!["fuzz", "spectrum.exact", "--case", "3", "--json"]),
        ("invariants", vec!["fuzz", "--list", "--json"]),
        ("pattern", vec!["pattern", "--particles", "6", "--gains", "1/5,1/5,-1/25", "--json"]),
        ("reach", vec!["reach", &cars, "--json"]),
        ("tracks", vec!["tracks", &tracks, "--null", "3", "--out", &out, "--json"]),
    ] {
        let document = printed(&arguments);
        assert_keeps(name, &document);
        assert_eq!(document["version"], env!("CARGO_PKG_VERSION"), "{name}");
    }
    let ledger =
        file(&folder, "ledger.json", &flockproof(&["verify", "--claim", "veerman.lem2", "--json", "-"]).stdout);
    let site = folder.join("site");
    assert!(
        flockproof(&["report", "--no-figures", "--ledger", &ledger, "--out", &site.to_string_lossy()]).status.success()
    );
    for (name, page) in [("ledger", "data/ledger.json"), ("claim", "data/claims/veerman.lem2.json")] {
        let text = std::fs::read_to_string(site.join(page)).expect("written");
        assert_keeps(name, &serde_json::from_str(&text).expect("JSON"));
    }
    let question = b"[question]\nid = \"mine.path\"\nstatement = \"...\"\n[for]\nn = \"2..4\"\ngraph = \"connected(n)\"\n[holds]\n\
        property = \"lambda(2) >= 2*(1 - cos(pi/n))\"\ncontrols = [\"lambda(2) >= 2*(1 - cos(pi/n)) + 1/100\"]\n";
    let (question, store) = (file(&folder, "question.toml", question), folder.join("store"));
    assert_keeps("check", &printed(&["check", &question, "--json"]));
    let campaign = printed(&["fuzz", &question, "--cases", "64", "--json"]);
    assert_keeps("fuzz", &campaign);
    let found = &campaign["invariants"][0];
    assert_eq!((&found["id"], found["controls"]["refuted"].as_u64()), (&Value::from("mine.path"), Some(1)));
    assert!(found["margin"].is_object() && found["inequalities"][0]["margin"].is_object(), "{found}");
    let wrong = std::fs::read_to_string(&question).expect("text").replacen("cos(pi/n))", "cos(pi/n)) + 1/9", 1);
    // What fails is written into the working folder.
    let failed = ["fuzz", &file(&folder, "wrong.toml", wrong.as_bytes()), "--cases", "64", "--json"];
    let failed = with_input(&failed, &folder, "");
    assert_eq!(failed.status.code(), Some(1), "{}", String::from_utf8_lossy(&failed.stderr));
    let failed: Value = serde_json::from_str(&stdout(&failed)).expect("JSON");
    assert_keeps("fuzz", &failed);
    assert!(failed["invariants"][0]["failures"][0]["instance"].is_string(), "{failed}");
    assert!(flockproof(&["sweep", &question, "--store", &store.to_string_lossy()]).status.success());
    let about = std::fs::read_to_string(store.join("about.txt")).expect("written");
    assert_keeps("sweep", &serde_json::from_str(about.lines().next().expect("a line")).expect("JSON"));
    assert!(flockproof(&["reproduce", "veerman.table1", "--out", &out]).status.success());
    let text = std::fs::read_to_string(folder.join("out/reproduce.json")).expect("written");
    assert_keeps("reproduce", &serde_json::from_str(&text).expect("JSON"));
}

#[test]
fn every_schema_is_of_this_program() {
    let entries = std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/schemas")).expect("a folder");
    let names: BTreeSet<String> =
        entries.map(|e| e.expect("an entry").file_name().to_string_lossy().trim_end_matches(".json").into()).collect();
    assert!(names.len() >= 12);
    for name in names {
        let title = schema(&name)["properties"]["schema"]["const"].as_str().map(str::to_string);
        let version = if name == "ledger" { 2 } else { 1 };
        assert_eq!(title, Some(format!("flockproof.{name}/{version}")));
    }
}

/// The digest is that of the configuration as it stands in the document.
#[test]
fn digests_can_be_computed_again() {
    let document = printed(&["resonance", "--followers", "4", "--f", "-1", "--g", "-1", "--json"]);
    let digest = flockproof::report::digest(document["configuration"].to_string().as_bytes());
    assert_eq!(document["digest"], digest);
    let other = printed(&["resonance", "--followers", "5", "--f", "-1", "--g", "-1", "--json"]);
    assert_ne!(document["digest"], other["digest"]);
}
