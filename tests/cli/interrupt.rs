//! SIGTERM to a running command: it ends with status 130 and keeps what was finished.
//!
//! Nothing here looks at a clock. Where a machine is too busy for the work to ask in time, the program gives up in the middle and says
//! so; that is an end as good as the other, and what was written before is there in both.

use super::{file, folder};
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

fn start(command: &mut Command) -> Child {
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

fn flockproof(arguments: &[&str]) -> Child {
    start(Command::new(env!("CARGO_BIN_EXE_flockproof")).args(arguments))
}

fn terminate(child: &Child) {
    let sent = Command::new("kill").args(["-TERM", &child.id().to_string()]).status().expect("kill starts");
    assert!(sent.success());
}

/// Waits until something is there, as long as the command runs. Every command here has work for much longer; where one that was not
/// signalled has ended all the same, its status and what it said tell why.
fn wait_for(child: &mut Child, ready: impl Fn() -> bool) {
    while !ready() {
        if let Some(status) = child.try_wait().expect("a child") {
            let mut said = String::new();
            let _ = child.stderr.take().map(|mut pipe| pipe.read_to_string(&mut said));
            panic!("the command ended before it was interrupted, {status}: {said}");
        }
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// Sends SIGTERM after the first line of output that begins like this; all of the output.
fn terminated_after(mut child: Child, begins: &str) -> Output {
    let mut reader = BufReader::new(child.stdout.take().expect("a pipe"));
    let mut text = String::new();
    loop {
        let mut line = String::new();
        assert!(reader.read_line(&mut line).expect("UTF-8") > 0, "no line begins with {begins}:\n{text}");
        text.push_str(&line);
        if line.starts_with(begins) {
            break;
        }
    }
    terminate(&child);
    reader.read_to_string(&mut text).expect("UTF-8");
    let mut output = child.wait_with_output().expect("it ends");
    output.stdout = text.into_bytes();
    output
}

/// Status 130, and one of two ends: with the closing words, or given up in the middle.
fn assert_interrupted(output: &Output, closed: bool) -> String {
    let (text, error) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert_eq!(output.status.code(), Some(130), "{text}\n{error}");
    assert!(!error.contains("panicked"), "{error}");
    assert!(closed || error.contains("in the middle of a computation"), "{text}\n{error}");
    text.into_owned()
}

fn contains(output: &Output, words: &str) -> bool {
    String::from_utf8_lossy(&output.stdout).contains(words) || String::from_utf8_lossy(&output.stderr).contains(words)
}

/// Birds at pseudo-random places in a square, as many as one flock takes minutes to settle.
fn birds(count: u64) -> String {
    let mut seed = 1u64;
    let mut number = |below: u64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) % below
    };
    let places: Vec<String> =
        (0..count).map(|_| format!("[\"{}/100\", \"{}/100\"]", number(800), number(800))).collect();
    let speeds: Vec<String> =
        (0..count).map(|_| format!("[\"{}/1000\", \"-{}/1000\"]", number(100), number(100))).collect();
    format!(
        "{{\"model\": \"D\", \"weights\": \"lazy\", \"positions\": [{}], \"velocities\": [{}]}}",
        places.join(", "),
        speeds.join(", ")
    )
}

#[test]
fn settling_many_birds_ends_with_the_switches_found() {
    let folder = folder("interrupt_settle");
    let path = file(&folder, "birds.json", birds(150).as_bytes());
    let log = folder.join("log.jsonl");
    let found = || std::fs::metadata(&log).is_ok_and(|file| file.len() > 0);
    let mut child = flockproof(&["flock", "settle", &path, "--log", log.to_str().expect("UTF-8")]);
    wait_for(&mut child, found);
    terminate(&child);
    let output = child.wait_with_output().expect("it ends");
    let text = assert_interrupted(&output, contains(&output, "interrupted\nflocks: "));
    assert!(text.contains("150 birds") && text.lines().any(|line| line.starts_with("t = ")), "{text}");
}

#[test]
fn a_run_of_a_flock_ends_where_it_is() {
    let path = file(&folder("interrupt_run"), "birds.json", birds(4).as_bytes());
    let output = terminated_after(flockproof(&["flock", "run", &path, "--until", "1000000000"]), "model D");
    assert_interrupted(&output, contains(&output, "interrupted after t = "));
}

/// Many short steps; and steps of so many links that one of them may take longer than who stops the work waits.
#[test]
fn a_simulation_keeps_what_it_reached() {
    let folder = folder("interrupt_simulate");
    let short =
        "model = \"phase\"\n[state]\nphases = [0, 1, 2]\n[law]\nomega0 = 1000\nK1 = -1\n[run]\nuntil = 1000000\n";
    let long = "model = \"velocity-alignment\"\n[graph]\nkind = \"complete\"\n[state]\nrandom = { agents = 1500 }\n\
                [law]\npotential = \"inverse-square-log\"\n[run]\nuntil = 100\n";
    for (name, text) in [("short", short), ("long", long)] {
        let (config, out) = (file(&folder, &format!("{name}.toml"), text.as_bytes()), folder.join(name));
        let child = flockproof(&["simulate", &config, "--out", out.to_str().expect("UTF-8")]);
        let output = terminated_after(child, "");
        assert_interrupted(&output, true);
        // Also where it is given up in the middle of a step.
        assert!(contains(&output, "is kept"), "{name}");
        let files = ["summary.json", "trajectory.csv", "observables.csv", "events.csv", "run.npz", "about.txt"];
        assert!(files.iter().all(|file| out.join(file).exists()), "{name}");
        let summary = std::fs::read_to_string(out.join("summary.json")).expect("written");
        let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
        assert_eq!(summary["ended"], "interrupted", "{name}");
    }
}

#[test]
fn figures_are_kept_as_they_are_made() {
    let out = folder("interrupt_reproduce");
    let made = |out: &Path| std::fs::read_dir(out).expect("a folder").count() > 0;
    let mut child = flockproof(&["reproduce", "all", "--out", out.to_str().expect("UTF-8")]);
    wait_for(&mut child, || made(&out));
    terminate(&child);
    let output = child.wait_with_output().expect("it ends");
    assert_interrupted(&output, contains(&output, "they are written"));
    assert!(made(&out));
}

#[test]
fn tracks_keep_what_was_measured() {
    let out = folder("interrupt_tracks");
    let arguments = ["--synthetic", "coupled", "--fish", "20", "--null", "100000"];
    let mut child = flockproof(&[&["tracks", "--out", out.to_str().expect("UTF-8")], &arguments[..]].concat());
    // The last of the files that are written before the null models.
    wait_for(&mut child, || out.join("about.txt").exists());
    terminate(&child);
    let output = child.wait_with_output().expect("it ends");
    assert_interrupted(&output, contains(&output, "interrupted: what was measured of all frames is written"));
    let read = |name: &str| std::fs::read_to_string(out.join(name)).expect("written");
    let summary: serde_json::Value = serde_json::from_str(&read("summary.json")).expect("JSON");
    assert!(summary["null_models"].is_null() && summary["means"]["p_1"].is_number(), "{summary}");
    assert_eq!(read("frames.csv").lines().count(), 3001);
    assert!(["fish.csv", "gaps.csv", "histograms.csv"].iter().all(|name| out.join(name).exists()));
    assert!(contains(&output, "The null models were not reached.") && contains(&output, "histograms.csv"));
}

#[test]
fn tracks_keep_the_frames_that_were_measured() {
    let out = folder("interrupt_frames");
    let arguments = ["--synthetic", "milling", "--fish", "300", "--frames", "600", "--window", "3"];
    let mut child = flockproof(&[&["tracks", "--out", out.to_str().expect("UTF-8")], &arguments[..]].concat());
    wait_for(&mut child, || out.join("tracks.csv").exists());
    terminate(&child);
    let output = child.wait_with_output().expect("it ends");
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(130), "{error}");
    // Whenever the signal came: what is said to be written is there.
    let reached = error.split("the first ").nth(1).and_then(|rest| rest.split(' ').next()?.parse::<usize>().ok());
    if let Some(reached) = reached {
        let frames = std::fs::read_to_string(out.join("frames.csv")).expect("written");
        assert_eq!(frames.lines().count(), reached + 1);
    }
    assert!(!error.contains("is written") || out.join("about.txt").exists(), "{error}");
}

/// A program in the place of coqc that tells its version and otherwise sleeps.
#[test]
fn proofs_end_with_the_coqc_that_runs() {
    let folder = folder("interrupt_prove");
    let script = "#!/bin/sh\ncase \"$1\" in --print-version) echo 8.0 4.0; exit 0;; -where) echo /nowhere; exit 0;; esac\necho $$ > \"$STARTED.part\"\nmv \"$STARTED.part\" \"$STARTED\"\nexec sleep 600\n";
    let coqc = file(&folder, "coqc", script.as_bytes());
    assert!(Command::new("chmod").args(["+x", &coqc]).status().expect("chmod starts").success());
    let (started, out) = (folder.join("started"), folder.join("out"));
    let path = format!("{}:{}", folder.display(), std::env::var("PATH").expect("a path"));
    let mut child = start(
        Command::new(env!("CARGO_BIN_EXE_flockproof"))
            .args(["prove", "--out", out.to_str().expect("UTF-8")])
            .env("PATH", &path)
            .env("STARTED", &started)
            .env("RAYON_NUM_THREADS", "1"),
    );
    wait_for(&mut child, || started.exists());
    let second = Command::new(env!("CARGO_BIN_EXE_flockproof"))
        .args(["prove", "--out", out.to_str().expect("UTF-8")])
        .env("PATH", &path)
        .output()
        .expect("it starts");
    assert!(contains(&second, "in use by another run"), "two runs in one folder");
    terminate(&child);
    let output = child.wait_with_output().expect("it ends");
    assert_interrupted(&output, contains(&output, "what was compiled is kept"));
    let coqc = std::fs::read_to_string(&started).expect("a process");
    let alive = Command::new("kill").args(["-0", coqc.trim()]).stderr(Stdio::null()).status().expect("kill starts");
    assert!(!alive.success() || contains(&output, "in the middle"), "coqc {coqc} still runs");
}

/// Whether a process catches SIGTERM.
#[cfg(target_os = "linux")]
fn catches_sigterm(id: u32) -> bool {
    let status = std::fs::read_to_string(format!("/proc/{id}/status")).unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).map(str::trim).unwrap_or("0");
    u64::from_str_radix(mask, 16).is_ok_and(|mask| mask >> 14 & 1 == 1)
}

/// GNU timeout sends two signals at once: what was finished is written all the same, and it is told what is missing.
#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_ledger_says_what_is_missing() {
    let folder = folder("interrupt_verify");
    let path = folder.join("ledger.json");
    let mut child = flockproof(&["verify", "--threads", "1", "--json", path.to_str().expect("UTF-8")]);
    // Beside the first thread and the one that waits for signals a third one checks claims.
    let id = child.id();
    let threads = || std::fs::read_dir(format!("/proc/{id}/task")).map_or(0, Iterator::count);
    wait_for(&mut child, || catches_sigterm(id) && threads() > 2);
    let id = id.to_string();
    assert!(Command::new("kill").args(["-TERM", &id, &id]).status().expect("kill starts").success());
    let output = child.wait_with_output().expect("it ends");
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(130), "{error}");
    // Where the machine stood still between the two signals, the second one ended the program at once: then there may be no file.
    if let Ok(text) = std::fs::read_to_string(&path) {
        let ledger: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(ledger["interrupted"], true);
        assert!(ledger["missing"].as_array().is_some_and(|list| !list.is_empty()));
        assert!(contains(&output, "interrupted: the claims above were finished; missing:"));
    }
}

/// Commands that say nothing before their end: the signal is sent once they catch it.
#[cfg(target_os = "linux")]
#[test]
fn silent_commands_end_too() {
    let folder = folder("interrupt_silent");
    let row = |shift: usize| (0..48).map(|k| format!("{}/1128", (k + shift) % 48)).collect::<Vec<_>>().join(" ");
    let factor: String = (0..48).map(|i| row(7 * i * i + i) + "\n").collect();
    let factors = file(&folder, "factors.txt", vec![factor; 3000].join("\n").as_bytes());
    for arguments in [
        &["verify", "--threads", "1"][..],
        &["ergodicity", &factors],
        &["fuzz", "matrix.product_tree", "--cases", "100000000"],
        // The largest dense matrix, the most rows and the most digits that are taken.
        &["spectrum", "--graph", "geometric:3000:1/6:7"],
        &["resonance", "--followers", "1000000000", "--sweep", "f=-316..-1:316,g=-316..-1:316"],
        &["resonance", "--followers", "1000000000000", "--f", "-1", "--g", "-1", "--digits", "10000"],
    ] {
        let mut child = flockproof(arguments);
        let id = child.id();
        wait_for(&mut child, || catches_sigterm(id));
        terminate(&child);
        let output = child.wait_with_output().expect("it ends");
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(130), "{arguments:?}: {error}");
        // Either nothing was finished yet, or it is told what is missing.
        let named = error.contains("interrupted") || error.contains("in the middle");
        assert!(output.stdout.is_empty() || named || contains(&output, "missing"), "{arguments:?}: {error}");
    }
}
