//! The program as a user meets it: contracts of the subcommands, wrong input, closed pipes.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

mod certify;
mod check;
mod finding;
mod flock;
mod fuzz;
mod inputs;
#[cfg(unix)]
mod interrupt;
mod pattern;
#[cfg(unix)]
mod prove;
mod record;
mod refused;
mod resonance;
mod schemas;
mod serve;
mod shell;
mod simulate;
mod spectrum;
mod sweep;
mod tracks;

fn flockproof(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_flockproof")).args(arguments).output().expect("the program starts")
}

/// With a standard input, from a folder.
fn with_input(arguments: &[impl AsRef<std::ffi::OsStr>], folder: &Path, input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_flockproof"))
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    // Most commands do not read it, and may be gone already.
    let _ = child.stdin.take().expect("a pipe").write_all(input.as_bytes());
    child.wait_with_output().expect("it ends")
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("UTF-8")
}

/// A folder of its own for each test, under the target folder.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a folder");
    path
}

fn file(folder: &Path, name: &str, contents: &[u8]) -> String {
    let path = folder.join(name);
    std::fs::write(&path, contents).expect("a file");
    path.to_string_lossy().into_owned()
}

/// Exit status 2, nothing on standard output, one line on standard error that names what is wrong.
fn assert_refused(arguments: &[&str], named: &str) {
    let output = flockproof(arguments);
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {error}");
    assert!(output.stdout.is_empty(), "{arguments:?} printed something");
    assert_eq!(error.trim_end().lines().count(), 1, "{arguments:?}: {error}");
    assert!(error.contains(named), "{arguments:?}: `{error}` does not name `{named}`");
    assert!(!error.contains("panicked"));
}

/// Where nothing can be made, and an argument that is no text.
#[cfg(target_os = "linux")]
#[test]
fn folders_and_arguments_are_named() {
    use std::os::unix::ffi::OsStrExt;
    assert_refused(&["man", "--out", "/proc/x"], "/proc/x: the folder cannot be made there");
    let argument = std::ffi::OsStr::from_bytes(b"veerman.\xff");
    let mut command = Command::new(env!("CARGO_BIN_EXE_flockproof"));
    let output = command.args(["verify", "--claim"]).arg(argument).output().expect("the program starts");
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{error}");
    assert!(error.contains("this argument is not text in UTF-8: veerman.\u{fffd}"), "{error}");
}

#[test]
fn resonance_keeps_its_contract() {
    let output =
        flockproof(&["resonance", "--followers", "128", "--f", "-1", "--g", "-1.0", "--digits", "25", "--json"]);
    assert!(output.status.success() && output.stderr.is_empty());
    let document: serde_json::Value = serde_json::from_str(&stdout(&output)).expect("one JSON document");
    assert_eq!(document["followers"], 128);
    assert_eq!((document["f"].as_str(), document["g"].as_str()), (Some("-1"), Some("-1")));
    for (name, digits) in [("omega", "0.0086773696075884626268238"), ("amplitude", "146.73083377805038714666")] {
        for end in ["lo", "hi"] {
            assert!(document[name][end].as_str().is_some_and(|s| s.starts_with(digits)), "{name} {end}");
        }
    }
    assert!(document["theorem1"]["omega"].as_str().is_some_and(|s| s.starts_with("0.00867750573")));
    assert!(document["theorem1"]["amplitude"].as_str().is_some_and(|s| s.starts_with("146.728747")));
}

#[test]
fn ends_of_a_resonance_are_as_narrow_as_the_output() {
    // All digits, wherever the lines end.
    let joined = |text: &str| text.split_whitespace().collect::<String>();
    for digits in [&[][..], &["--digits", "20"], &["--digits", "60"], &["--digits", "200"]] {
        let arguments = [&["resonance", "--followers", "128", "--f", "-1", "--g", "-1"], digits].concat();
        let (table, json) = (flockproof(&arguments), flockproof(&[&arguments[..], &["--json"]].concat()));
        let table = stdout(&table);
        let json: serde_json::Value = serde_json::from_str(&stdout(&json)).expect("one JSON document");
        assert!(table.lines().all(|line| line.chars().count() <= 80), "{table}");
        for name in ["omega", "amplitude"] {
            let [lo, hi] = ["lo", "hi"].map(|end| json[name][end].as_str().expect("a number").to_string());
            assert!(joined(&table).contains(&format!("{name}in[{lo},{hi}]")), "{table}");
        }
    }
}

#[test]
fn bad_resonances_are_refused() {
    let ask = |m, f, g, d, named| {
        assert_refused(&["resonance", "--followers", m, "--f", f, "--g", g, "--digits", d], named);
    };
    ask("0", "-1", "-1", "10", "followers");
    ask("-3", "-1", "-1", "10", "--followers");
    ask("1e9", "-1", "-1", "10", "--followers");
    ask("99999999999999999999", "-1", "-1", "10", "--followers");
    ask("4", "1", "-1", "10", "f must be negative");
    ask("4", "-1", "0", "10", "g must be negative");
    ask("4", "-1", "minus one", "10", "--g");
    ask("4", "-1/0", "-1", "10", "--f");
    ask("4", "-1", "-1", "0", "digits");
    ask("4", "-1", "-1", "999999999", "digits");
    ask("4", "-1e-900", "-1", "9", "extreme");
    ask("4", "-1e99999999999", "-1", "9", "--f");
    assert_refused(&["resonance", "--followers", "4"], "--f");
}

#[test]
fn verify_writes_the_ledger() {
    let folder = folder("verify");
    let path = folder.join("ledger.json");
    let path = path.to_str().expect("UTF-8");
    let output = flockproof(&["verify", "--paper", "tanner1", "--json", path]);
    assert!(output.status.success(), "{}", stdout(&output));
    let text = stdout(&output);
    assert!(text.contains("tanner1.propIV3a") && !text.contains("missing") && !text.contains("veerman."));
    assert!(text.lines().all(|line| line.chars().count() <= 80), "wider than 80 columns:\n{text}");
    let document: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(path).expect("written")).expect("JSON");
    let ids: Vec<&str> =
        document["claims"].as_array().expect("a list").iter().filter_map(|c| c["id"].as_str()).collect();
    assert!(ids.is_sorted() && ids.contains(&"tanner1.eq9"));
    let printed = flockproof(&["verify", "--claim", "chazelle.ex15", "--json", "-"]);
    let only: serde_json::Value = serde_json::from_str(&stdout(&printed)).expect("only JSON on standard output");
    assert_eq!(only["claims"][0]["verdict"], "holds");
}

#[test]
fn bad_uses_of_verify_and_explain_are_refused() {
    assert_refused(&["verify", "--paper", "reynolds"], "reynolds");
    assert_refused(&["verify", "--claim", "veerman.lem99"], "veerman.lem99");
    assert_refused(&["verify", "--claim", "veerman.lem2", "--json", "/nowhere/at/all.json"], "/nowhere/at/all.json");
    assert_refused(&["verify", "--threads", "0"], "--threads");
    assert_refused(&["explain", "nonsense"], "nonsense");
    assert_refused(&["explain"], "ID");
    assert_refused(&["fly"], "fly");
    assert_refused(
        &["explain", "veerman.lem"],
        "the nearest are veerman.lem1, veerman.lem2, veerman.lem3, veerman.lem2_eigvec",
    );
    assert_refused(&["explain", "gain_mx"], "veerman.gain_max");
    assert_refused(
        &["verify", "--paper", "chazelle", "--claim", "veerman.lem2"],
        "veerman.lem2 is not a claim of chazelle",
    );
}

#[test]
fn explain_tells_the_whole_story() {
    let text = stdout(&flockproof(&["explain", "veerman.gain_max"]));
    for part in ["verdict", "false", "28/13", "corrected", "sqrt(3) - 1", "controls", "3 of 3"] {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
    assert!(text.lines().all(|line| line.chars().count() <= 80));
}

#[test]
fn reproduce_writes_three_files() {
    let folder = folder("reproduce");
    let out = folder.join("new");
    let output = flockproof(&["reproduce", "table1", "--out", out.to_str().expect("UTF-8")]);
    assert!(output.status.success());
    assert!(stdout(&output).lines().all(|line| line.chars().count() <= 80 || line.starts_with("written")));
    let csv = std::fs::read_to_string(out.join("veerman.table1.csv")).expect("CSV");
    assert_eq!(csv.lines().count(), 25);
    assert!(csv.lines().all(|line| line.split(',').count() == 11));
    assert!(std::fs::read_to_string(out.join("veerman.table1.svg")).expect("SVG").contains("<svg"));
    assert!(std::fs::read(out.join("veerman.table1.png")).expect("PNG").starts_with(b"\x89PNG"));
    // What was chosen stands beside the numbers.
    let text = std::fs::read_to_string(out.join("veerman.table1.txt")).expect("text");
    assert!(!text.is_empty() && stdout(&output).contains(&text));
    let occupied = file(&folder, "occupied", b"");
    assert_refused(&["reproduce", "table1", "--out", &occupied], "occupied");
    assert_refused(&["reproduce", "figure77", "--out", &occupied], "figure77");
    let several = "`fig2` is ambiguous; it may be: veerman.fig2, paley.fig2, tanner1.fig2";
    assert_refused(&["reproduce", "fig2", "--out", &occupied], several);
}

#[test]
fn reproduce_draws_polygons_and_zones() {
    let folder = folder("reproduce_drawings");
    let out = folder.to_str().expect("UTF-8");
    for (name, files, marks) in [("paley.fig2", 6, "<path"), ("paley.fig7", 4, "fill-opacity")] {
        let output = flockproof(&["reproduce", name, "--out", out]);
        assert!(output.status.success());
        assert!(stdout(&output).lines().all(|line| line.chars().count() <= 80 || line.starts_with("written")));
        let made = std::fs::read_dir(&folder)
            .expect("folder")
            .filter(|entry| entry.as_ref().is_ok_and(|entry| entry.file_name().to_string_lossy().starts_with(name)));
        assert_eq!(made.count(), files);
        assert!(std::fs::read_to_string(folder.join(format!("{name}.svg"))).expect("SVG").contains(marks));
    }
    // Claimed false, and drawn as false.
    let text = std::fs::read_to_string(folder.join("paley.fig2.txt")).expect("text");
    assert!(text.contains("exactly") && !text.contains("NO"));
}

#[test]
fn ergodicity_reads_and_refuses() {
    let folder = folder("ergodicity");
    let good = file(&folder, "good.txt", b"1/2 1/2 0\n1/2 1/2 0\n0 0 1\n\n1 0 0\n0 1/2 1/2\n0 1/2 1/2\n");
    let output = flockproof(&["ergodicity", &good, "--json"]);
    let document: serde_json::Value = serde_json::from_str(&stdout(&output)).expect("JSON");
    assert_eq!(document["prefixes"][1]["tau_1"], "1/2");
    assert_eq!(document["prefixes"][1]["footprint"], "110 111 111");
    assert_eq!(document["product"][0], serde_json::json!(["1/2", "1/2", "0"]));
    assert_eq!(document["stabilisers"][0], serde_json::json!({"time": 2, "members": [1, 2, 3]}));
    assert!(stdout(&flockproof(&["ergodicity", &good])).contains("stabiliser V_1 = {1, 2, 3}"));
    for (name, contents, named) in [
        ("sum.txt", &b"1/2 1/3\n"[..], "sums to 5/6"),
        ("negative.txt", b"2 -1\n", "negative"),
        ("ragged.txt", b"1 0\n1\n", "row 2"),
        ("zero.txt", b"1/0\n", "zero denominator"),
        ("words.txt", b"one two\n", "one"),
        ("empty.txt", b"", "no matrix"),
        ("binary.txt", b"\xff\xfe\x00", "UTF-8"),
        ("shapes.txt", b"1\n\n1/2 1/2\n", "matrix 2"),
        ("broken.json", b"[[[1,", "JSON"),
    ] {
        assert_refused(&["ergodicity", &file(&folder, name, contents)], named);
    }
    if Path::new("/dev/zero").exists() {
        assert_refused(&["ergodicity", "/dev/zero"], "64 MiB");
    }
    assert_refused(&["ergodicity", "/nowhere.txt"], "/nowhere.txt");
    assert_refused(&["ergodicity", folder.to_str().expect("UTF-8")], "ergodicity");
}

#[test]
fn a_closed_pipe_is_no_error() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_flockproof"))
        .args(["verify", "--claim", "chazelle.ex15"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("it ends");
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(output.status.code(), Some(0));
}
