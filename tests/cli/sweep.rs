//! `sweep`, and `fuzz` of a question: tables, shards, counterexamples, wrong input.

use super::{assert_refused, file, flockproof, folder, stdout};
use std::process::Output;

const SQUARES: &[u8] =
    b"[question]\nid = \"test.squares\"\n[for]\nn = \"1..9\"\n[values]\nsquare = \"n^2\"\nroot = \"sqrt(n)\"\n";

fn false_one(family: &str) -> String {
    format!(
        "[question]\nid = \"test.false\"\n[for]\n{family}\n[holds]\nproperty = \"n^2 < 40\"\ncontrols = [\"n^2 < 10\"]\n"
    )
}

#[test]
fn tables_do_not_depend_on_shards() {
    let folder = folder("sweep");
    let question = file(&folder, "squares.toml", SQUARES);
    let store = |name: &str| folder.join(name).to_str().expect("UTF-8").to_string();
    let whole = flockproof(&["sweep", &question, "--store", &store("whole")]);
    assert_eq!(whole.status.code(), Some(0), "{}", String::from_utf8_lossy(&whole.stderr));
    assert!(stdout(&whole).lines().next().is_some_and(|line| line.contains("square")));
    for shard in ["2/2", "1/2"] {
        let output = flockproof(&["sweep", &question, "--store", &store("parts"), "--shard", shard]);
        assert!(output.status.success() && stdout(&output).contains(&format!("shard {shard} is finished")));
    }
    let merged = flockproof(&["sweep", "--merge", &store("parts")]);
    let table = |output: &Output| stdout(output).split("written: ").next().map(str::to_string);
    assert_eq!(table(&merged), table(&whole));
    for name in ["table.csv", "table.jsonl", "merged.jsonl", "about.txt"] {
        let read = |store: &str| std::fs::read(folder.join(store).join(name)).expect("written");
        assert_eq!(read("whole"), read("parts"), "{name}");
    }
    let lines = stdout(&flockproof(&["sweep", "--merge", &store("parts"), "--json"]));
    assert_eq!(lines.lines().count(), 9);
    assert!(lines.starts_with("{\"n\":\"1\",\"root\":\"1\",\"square\":\"1\"}"), "{lines}");
    let about = std::fs::read_to_string(folder.join("whole/about.txt")).expect("written");
    let (origin, columns) = about.split_once('\n').expect("lines");
    let origin: serde_json::Value = serde_json::from_str(origin).expect("JSON");
    assert_eq!(
        (&origin["schema"], &origin["version"]),
        (&"flockproof.sweep/1".into(), &env!("CARGO_PKG_VERSION").into())
    );
    assert!(origin["digest"].is_string() && columns.starts_with("table.csv: columns n,square,root"), "{about}");
    // A table is no campaign, and a campaign no table.
    assert_refused(&["fuzz", "--merge", &store("parts")], "not a campaign");
    let fuzzed = flockproof(&["fuzz", "matrix.inverse", "--cases", "5", "--store", &store("fuzz")]);
    assert!(fuzzed.status.success());
    assert_refused(&["sweep", "--merge", &store("fuzz")], "no table");
}

#[test]
fn a_counterexample_is_decided_alone() {
    let folder = folder("fuzz_question");
    let question = file(&folder, "false.toml", false_one("n = \"1..9\"").as_bytes());
    let store = folder.join("store");
    let output = flockproof(&["fuzz", &question, "--cases", "50", "--store", store.to_str().expect("UTF-8")]);
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    let text = stdout(&output);
    assert!(text.contains("n = 7\n"), "{text}");
    let command = text.lines().find(|line| line.starts_with("flockproof check ")).expect("a command");
    let replay = command.strip_prefix("flockproof check ").expect("a file");
    let checked = flockproof(&["check", replay, "--replay", folder.to_str().expect("UTF-8")]);
    assert_eq!(checked.status.code(), Some(1), "{}", stdout(&checked));
    // What survives ends with 0.
    let good = file(&folder, "good.toml", false_one("n = \"1..6\"").as_bytes());
    assert_eq!(flockproof(&["fuzz", &good, "--cases", "50"]).status.code(), Some(0));
}

#[test]
fn bad_sweeps_are_refused() {
    let folder = folder("sweep_bad");
    let path = |name: &str| folder.join(name).to_str().expect("UTF-8").to_string();
    let question = file(&folder, "squares.toml", SQUARES);
    assert_refused(&["sweep"], "QUESTION.toml");
    assert_refused(&["sweep", &question], "--store");
    assert_refused(&["sweep", &path("nowhere.toml"), "--store", &path("s")], "nowhere.toml");
    assert_refused(&["sweep", &question, "--store", &path("s"), "--shard", "0/2"], "--shard");
    assert_refused(&["sweep", "--merge", &path("nowhere")], "nowhere");
    assert_refused(&["sweep", "--merge", &path("nowhere"), "--resume"], "--resume");
    let large = file(
        &folder,
        "large.toml",
        b"[question]\nid = \"a\"\n[for]\nn = \"1..2000000\"\nm = \"1..1000000\"\n[values]\nx = \"n*m\"\n",
    );
    assert_refused(&["sweep", &large, "--store", &path("s")], "large.toml");
    assert!(flockproof(&["sweep", &question, "--store", &path("s")]).status.success());
    assert_refused(&["sweep", &question, "--store", &path("s")], "--resume goes on with it");
    let text = String::from_utf8_lossy(SQUARES).replace("1..9", "1..8");
    let other = file(&folder, "other.toml", text.as_bytes());
    assert_refused(&["sweep", &other, "--store", &path("s"), "--resume"], "another question");
    // Only values: nothing to attack.
    assert_refused(&["fuzz", &question], "no property");
    assert_refused(&["fuzz", &question, "matrix.inverse"], "alone");
    assert_refused(&["fuzz", &question, "--case", "3"], "--case");
    assert_refused(&["fuzz", &path("nowhere.toml")], "nowhere.toml");
}

/// A member without a value is a row with a reason, in each form of the table, and not the end of it; so is a property that cannot be decided.
#[test]
fn what_is_missing_has_its_reason() {
    let folder = folder("sweep_missing");
    let path = |name: &str| folder.join(name).to_str().expect("UTF-8").to_string();
    let head = "[question]\nid = \"test.missing\"\n[for]\nfollowers = 60\nf = \"-1\"\ng = \"-1\"\n\
                f_ahead = [\"1/2\", \"3/5\"]\ng_ahead = \"1/2\"\n";
    let values =
        "[values]\nheight = \"peak\"\nsafe = \"stable\"\nlow = \"stable and peak < 10^9\"\nroom = \"1/(f + 1)\"\n";
    let holds = "[holds]\nproperty = \"peak < 10^9\"\ncontrols = [\"peak < 1\"]\n";
    let reason = "the platoon is not stable, so that it has no peak";
    for (name, section) in [("values", values), ("holds", holds)] {
        let question = file(&folder, &format!("{name}.toml"), format!("{head}{section}").as_bytes());
        let output = flockproof(&["sweep", &question, "--store", &path(name)]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let text = stdout(&output).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(reason) && text.contains("written: "), "{text}");
        assert!(stdout(&output).lines().all(|line| line.chars().count() <= 80 || !line.contains(' ')), "{text}");
        let csv = std::fs::read_to_string(folder.join(name).join("table.csv")).expect("written");
        let rows: Vec<&str> = csv.lines().collect();
        assert!(rows.len() == 3 && rows[0].ends_with(",reason"), "{csv}");
        assert!(rows[2].contains(reason) && (name == "values" || !rows[1].contains(reason)), "{csv}");
        let json = stdout(&flockproof(&["sweep", "--merge", &path(name), "--json"]));
        let rows: Vec<serde_json::Value> = json.lines().map(|row| serde_json::from_str(row).expect("JSON")).collect();
        let unknown = |k: usize, column: &str| rows[k][column]["unknown"].as_str().map(str::to_string);
        let column = if name == "values" { "height" } else { "holds" };
        assert!(
            unknown(0, column).is_none() && unknown(1, column).is_some_and(|why| why.starts_with(reason)),
            "{json}"
        );
        if name == "values" {
            let truths = [0, 1].map(|k| (rows[k]["safe"].clone(), rows[k]["low"].clone()));
            assert_eq!(truths, [(true.into(), true.into()), (false.into(), false.into())]);
            assert!(unknown(0, "room").is_some_and(|why| why == "division by zero"), "{json}");
        }
    }
    // Without comparisons there is no margin, which is said, too; a table without empty cells needs no reasons.
    let stable = format!("{head}[holds]\nproperty = \"stable\"\ncontrols = [\"1 < 0\"]\n");
    let stable = file(&folder, "stable.toml", stable.as_bytes());
    assert!(flockproof(&["sweep", &stable, "--store", &path("stable")]).status.success());
    let csv = std::fs::read_to_string(folder.join("stable/table.csv")).expect("written");
    assert!(csv.contains("false,,margin: no margin: what decides compares no numbers"), "{csv}");
    let squares = file(&folder, "squares.toml", SQUARES);
    assert!(flockproof(&["sweep", &squares, "--store", &path("squares")]).status.success());
    let csv = std::fs::read_to_string(folder.join("squares/table.csv")).expect("written");
    assert!(!csv.contains("reason"), "{csv}");
}

#[test]
fn regions_are_drawn_and_listed() {
    let folder = folder("sweep_regions");
    let path = |name: &str| folder.join(name).to_str().expect("UTF-8").to_string();
    let text = "[question]\nid = \"test.disc\"\n[for]\nn = [1, 2]\nx = \"[0, 2]\"\ny = \"[0, 2]\"\n[holds]\n\
                property = \"x^2 + y^2 < n\"\ncontrols = [\"x < 0\"]\n";
    let question = file(&folder, "disc.toml", text.as_bytes());
    let output = flockproof(&["sweep", &question, "--store", &path("store"), "--plot", &path("disc.svg"), "--json"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let picture = std::fs::read_to_string(path("disc.svg")).expect("a picture");
    for word in ["<svg", "holds", "fails", "open", "n = 2"] {
        assert!(picture.contains(word), "{word}");
    }
    let number = |value: &serde_json::Value| {
        let text = value.as_str().expect("a number");
        let (p, q) = text.split_once('/').unwrap_or((text, "1"));
        p.parse::<f64>().expect("an integer") / q.parse::<f64>().expect("an integer")
    };
    for (line, n) in stdout(&output).lines().zip([1.0, 2.0]) {
        let row: serde_json::Value = serde_json::from_str(line).expect("JSON");
        let regions = row["regions"].as_array().expect("regions");
        let mut areas = std::collections::BTreeMap::new();
        for region in regions {
            let [x0, x1, y0, y1] = [("x", 0), ("x", 1), ("y", 0), ("y", 1)].map(|(s, k)| number(&region["box"][s][k]));
            let property = region["property"].as_str().expect("a word");
            match property {
                "holds" => assert!(x1 * x1 + y1 * y1 < n),
                "fails" => assert!(x0 * x0 + y0 * y0 >= n),
                _ => {}
            }
            *areas.entry(property.to_string()).or_insert(0.0) += (x1 - x0) * (y1 - y0);
        }
        assert!((areas.values().sum::<f64>() - 4.0).abs() < 1e-12 && areas["open"] < 0.2, "{areas:?}");
        assert!((areas["holds"] - n * std::f64::consts::PI / 4.0).abs() < 0.2, "{areas:?}");
    }
    let squares = file(&folder, "squares.toml", SQUARES);
    assert_refused(&["sweep", &squares, "--store", &path("s"), "--plot", &path("s.svg")], "one or two names");
}

/// What holds at some points of a box is neither true nor false there.
#[test]
fn a_truth_that_changes_within_a_box_is_not_known() {
    let folder = folder("sweep_boxes");
    for (place, range) in ["[0, 2]", "any"].into_iter().enumerate() {
        let question = format!(
            "[question]\nid = \"box\"\n[for]\nx = \"{range}\"\n[values]\na = \"x > 1\"\nb = \"not x > 1\"\nc = \"x > 1 or x <= 1\"\n"
        );
        let path = file(&folder, &format!("box_{place}.toml"), question.as_bytes());
        let store = folder.join(format!("store_{place}"));
        let swept = flockproof(&["sweep", &path, "--store", store.to_str().expect("UTF-8")]);
        assert!(swept.status.success(), "{}", String::from_utf8_lossy(&swept.stderr));
        let json = stdout(&flockproof(&["sweep", "--merge", store.to_str().expect("UTF-8"), "--json"]));
        let row: serde_json::Value = serde_json::from_str(json.lines().next().expect("a row")).expect("JSON");
        let unknown =
            |column: &str| row[column]["unknown"].as_str().is_some_and(|why| why.contains("a point of the box"));
        assert!(unknown("a") && unknown("b") && row["c"] == true, "{json}");
    }
}

/// What is wrong in the words of a question is refused, and is no column of question marks.
#[test]
fn misused_names_are_refused() {
    let folder = folder("sweep_misused");
    let store = folder.join("store");
    for (number, (values, said)) in
        [("lambda(2)", "a graph"), ("peak", "a platoon"), ("sqrt(n, n)", "sqrt")].into_iter().enumerate()
    {
        let text = format!("[question]\nid = \"test.misused\"\n[for]\nn = \"1..3\"\n[values]\nx = \"n + {values}\"\n");
        let question = file(&folder, &format!("{number}.toml"), text.as_bytes());
        assert_refused(&["sweep", &question, "--store", store.to_str().expect("UTF-8")], said);
    }
}
