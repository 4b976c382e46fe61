//! `fuzz`: shards, merging, killed processes, wrong input.

use super::{assert_refused, file, flockproof, folder, stdout};
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Stdio};

const NAMES: [&str; 2] = ["matrix.tau_1_of_products", "matrix.tau_1_twin"];

fn shard(store: &Path, shard: &str, more: &[&str]) -> std::process::Output {
    let store = store.to_str().expect("UTF-8");
    flockproof(&[&["fuzz"], &NAMES[..], &["--cases", "4000", "--store", store, "--shard", shard], more].concat())
}

fn merged(store: &Path) -> (Value, Vec<u8>) {
    let output = flockproof(&["fuzz", "--merge", store.to_str().expect("UTF-8"), "--json"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let bytes = std::fs::read(store.join("merged.jsonl")).expect("written");
    (serde_json::from_str(&stdout(&output)).expect("one JSON document"), bytes)
}

#[test]
fn shards_are_merged_to_the_same_bytes() {
    let whole = folder("fuzz_whole");
    assert!(shard(&whole, "1/1", &[]).status.success());
    let parts = folder("fuzz_parts");
    for part in ["3/3", "1/3", "2/3"] {
        assert!(shard(&parts, part, &[]).status.success());
    }
    let (document, bytes) = merged(&whole);
    assert_eq!((document.clone(), bytes), merged(&parts));
    assert_eq!((&document["schema"], &document["failed"]), (&"flockproof.fuzz/1".into(), &0.into()));
    assert_eq!((&document["cases"], &document["missing_jobs"]), (&8000.into(), &0.into()));
    assert!(document["invariants"][0]["margin"]["value"].as_str().is_some_and(|margin| margin.starts_with('~')));
    // Without a store the same is found.
    let output = flockproof(&[&["fuzz"], &NAMES[..], &["--cases", "4000", "--json"]].concat());
    assert_eq!(serde_json::from_str::<Value>(&stdout(&output)).expect("JSON"), document);
    std::fs::remove_file(parts.join("shard-2-of-3.jsonl")).expect("a shard");
    let store = parts.to_str().expect("UTF-8");
    assert_refused(&["fuzz", "--merge", store], "are in no finished shard");
    assert!(shard(&parts, "1/1", &[]).status.success());
    assert_refused(&["fuzz", "--merge", store], "is both in");
}

/// SIGKILL at some moment, again and again: what was finished is there, and in the end all is as if nothing had happened.
#[cfg(unix)]
#[test]
fn a_killed_shard_goes_on() {
    let (store, calm) = (folder("fuzz_killed"), folder("fuzz_calm"));
    let arguments = |store: &Path| {
        let store = store.to_str().expect("UTF-8").to_string();
        ["fuzz", "matrix.product_tree", "--cases", "60000", "--store", &store, "--resume"].map(str::to_string)
    };
    let part = store.join("shard-1-of-1.jsonl.part");
    let mut finished = 0;
    for _ in 0..3 {
        let mut command = Command::new(env!("CARGO_BIN_EXE_flockproof"));
        let mut child = command.args(arguments(&store)).stdout(Stdio::null()).spawn().expect("the program starts");
        let lines = || std::fs::read_to_string(&part).map_or(0, |text| text.matches('\n').count());
        while lines() < finished + 20 && child.try_wait().expect("a child").is_none() {
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        child.kill().expect("killed");
        child.wait().expect("it ends");
        if part.exists() {
            assert!(lines() >= finished, "what was finished is lost");
            finished = lines();
        }
    }
    for folder in [&store, &calm] {
        let output = flockproof(&arguments(folder).iter().map(String::as_str).collect::<Vec<_>>());
        assert!(output.status.success());
    }
    assert_eq!(merged(&store), merged(&calm));
}

#[test]
fn invariants_are_listed_and_replayed() {
    let text = stdout(&flockproof(&["fuzz", "--list"]));
    assert!(text.contains("matrix.tau_1_of_products\n    tau_1(P Q) <= tau_1(P) tau_1(Q)."));
    let output = flockproof(&["fuzz", "matrix.inverse", "--case", "5", "--json"]);
    let document: Value = serde_json::from_str(&stdout(&output)).expect("JSON");
    assert_eq!((&document["verdict"], &document["invariant"]), (&"holds".into(), &"matrix.inverse".into()));
    assert_eq!(document["again"], Value::Null);
    // A file that says that a case failed which holds.
    let folder = folder("fuzz_replay");
    let recorded = serde_json::json!({
        "schema": "flockproof.replay/1", "version": env!("CARGO_PKG_VERSION"), "invariant": "matrix.inverse", "draws": [],
        "why": "once it failed", "instance": "a matrix"
    });
    let path = file(&folder, "failure.json", recorded.to_string().as_bytes());
    let output = flockproof(&["fuzz", "--replay", &path]);
    assert!(output.status.success());
    let text = stdout(&output);
    assert!(text.contains("It does not fail any more.\nrecorded: once it failed\na matrix\n"), "{text}");
}

#[test]
fn bad_campaigns_are_refused() {
    let folder = folder("fuzz_bad");
    let path = |name: &str| folder.join(name).to_str().expect("UTF-8").to_string();
    assert_refused(&["fuzz", "tau_1"], "there is no invariant `tau_1` (did you mean matrix.tau_1");
    assert_refused(&["fuzz", "--cases", "0"], "number of cases");
    assert_refused(&["fuzz", "--cases", "-1"], "--cases");
    assert_refused(&["fuzz", "--cases", "99999999999999999999"], "--cases");
    assert_refused(&["fuzz", "--cases", "9999999999999999999"], "2^50");
    assert_refused(&["fuzz", "--shard", "1/2"], "--store");
    assert_refused(&["fuzz", "--resume"], "--store");
    assert_refused(&["fuzz", "--store", &path("x"), "--shard", "3/2"], "--shard");
    assert_refused(&["fuzz", "--store", &path("x"), "--shard", "two"], "--shard");
    assert_refused(&["fuzz", "--case", "1"], "one invariant");
    assert_refused(&["fuzz", "--merge", &path("nowhere")], "nowhere");
    assert_refused(&["fuzz", "--merge", &path("x"), "--cases", "5"], "--cases");
    let occupied = file(&folder, "occupied", b"");
    assert_refused(&["fuzz", "matrix.inverse", "--store", &occupied], "occupied");
    let replay = file(&folder, "replay.json", b"{\"schema\": \"flockproof.replay/1\", \"version\": \"0.0.0\"}");
    assert_refused(&["fuzz", "--replay", &replay], "version 0.0.0");
    assert_refused(&["fuzz", "--replay", &occupied], "not JSON");
    let store = path("store");
    assert!(flockproof(&["fuzz", "matrix.inverse", "--cases", "10", "--store", &store]).status.success());
    assert_refused(&["fuzz", "matrix.inverse", "--cases", "10", "--store", &store], "--resume goes on with it");
    assert_refused(&["fuzz", "matrix.inverse", "--cases", "11", "--store", &store, "--resume"], "another question");
}
