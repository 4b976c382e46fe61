//! Input in all its forms: what is read, and that the examples of `assets/` are.

use super::{file, flockproof, folder, stdout, with_input};
use serde_json::Value;
use std::path::Path;

fn json(arguments: &[&str]) -> Value {
    let output = flockproof(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_str(&stdout(&output)).expect("one JSON document")
}

fn asset(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets").join(name).to_string_lossy().into_owned()
}

/// The same ring of four, in every form.
#[test]
fn graphs_are_read_in_every_form() {
    let folder = folder("inputs_graphs");
    let expected = json(&["spectrum", "--graph", "ring:4", "--json"])["eigenvalues"].clone();
    let exact = |list: &Value| -> Vec<(String, u64)> {
        let part =
            |e: &Value| (e["exact"].as_str().expect("exact").to_string(), e["multiplicity"].as_u64().expect("a count"));
        list.as_array().expect("a list").iter().map(part).collect()
    };
    for (name, text, more, labels) in [
        ("spaces", "1 2\n2 3\n3 4\n4 1\n", &[][..], None),
        ("commas", "1,2\n2, 3\n3 ,4\n4;1\n", &[], None),
        ("byte-order mark", "\u{feff}1 2\n2 3\n3 4\n4 1\n", &[], None),
        ("carriage returns", "1 2\r\n2 3\r\n3 4\r\n4 1\r\n", &[], None),
        ("from zero", "0 1\n1 2\n2 3\n3 0\n", &["--zero-based"], None),
        (
            "networkx",
            "0 1 {}\n1 2 {'colour': 'red'}\n2 3 {\"weight\": 1}\n3 0 {'weight': 1.0}\n",
            &["--zero-based"],
            None,
        ),
        ("names", "n b\nb c\nc d # last but one\nd n\n", &[], Some(["n", "b", "c", "d"])),
        (
            "GraphML",
            "<graphml><graph edgedefault=\"undirected\"><node id=\"0\"/><node id=\"x\"/><node id=\"y\"/><node id=\"z\"/>\
             <edge source=\"0\" target=\"x\"/><edge source=\"x\" target=\"y\"/><edge source=\"y\" target=\"z\"/>\
             <edge source=\"z\" target=\"0\"/></graph></graphml>",
            &[],
            Some(["0", "x", "y", "z"]),
        ),
        (
            "Matrix Market",
            "\u{feff}%%MatrixMarket matrix coordinate pattern symmetric\n4 4 4\n2 1\n3 2\n4 3\n4 1\n",
            &[],
            None,
        ),
    ] {
        let path = file(&folder, "graph", text.as_bytes());
        let found = json(&[&["spectrum", "--graph", &path, "--json"], more].concat());
        assert_eq!(exact(&found["eigenvalues"]), exact(&expected), "{name}");
        assert_eq!(found["vertices"], labels.map_or(Value::Null, |labels| serde_json::json!(labels)), "{name}");
    }
    // Weights, and the vertex of a name.
    let weighted = file(&folder, "weighted", b"a b {'weight': 2.5}\n");
    assert_eq!(json(&["spectrum", "--graph", &weighted, "--json"])["eigenvalues"][1]["exact"], "5");
    let rooted = json(&["spectrum", "--graph", &weighted, "--kind", "reduced", "--root", "b", "--json"]);
    assert_eq!((&rooted["root"], &rooted["eigenvalues"][0]["exact"]), (&2.into(), &"5/2".into()));
}

#[test]
fn standard_input_is_a_file() {
    for (arguments, input, key) in [
        (&["ergodicity", "-", "--json"][..], "1/2 1/2\n1/2 1/2\n".to_string(), "prefixes"),
        (&["spectrum", "--graph", "-", "--json"], "1 2\n".to_string(), "eigenvalues"),
        (
            &["flock", "settle", "-", "--json"],
            std::fs::read_to_string(asset("four_birds.json")).expect("text"),
            "steady_from",
        ),
    ] {
        let output = with_input(arguments, Path::new("."), &input);
        let document: Value = serde_json::from_str(&stdout(&output)).expect("JSON");
        assert!(!document[key].is_null() && document["configuration"]["file"]["name"] == "-", "{arguments:?}");
    }
}

/// Commands that read a file, `FILE` for its name, and what may stand in it.
fn readers() -> Vec<(Vec<&'static str>, &'static str, String)> {
    let asset = |name: &str| std::fs::read_to_string(asset(name)).expect("text");
    let question = asset("questions/algebraic_connectivity.toml");
    let ledger = stdout(&flockproof(&["verify", "--claim", "veerman.lem2", "--json", "-"]));
    let many = "model = \"phase\"\n[state]\nrandom = { agents = 3, seed = 1 }\n[law]\nK1 = -1\n[run]\nuntil = 1\n[ensemble]\nreplicas = 3\n";
    vec![
        (vec!["spectrum", "--graph", "FILE"], "g.txt", asset("graphs/bridge.txt")),
        (vec!["spectrum", "--graph", "FILE"], "g.graphml", asset("graphs/path.graphml")),
        (vec!["spectrum", "--graph", "FILE"], "g.mtx", asset("graphs/ring.mtx")),
        (vec!["resonance", "--graph", "FILE", "--f=-1", "--g=-1"], "g.txt", "1 2\n2 3\n".to_string()),
        (vec!["ergodicity", "FILE"], "m.txt", asset("two_matrices.txt")),
        (vec!["ergodicity", "FILE", "--normalise"], "m.json", asset("float_matrices.json")),
        (vec!["flock", "run", "FILE", "--until", "4"], "birds.json", asset("four_birds.json")),
        (vec!["flock", "settle", "FILE"], "birds.json", asset("four_birds.json")),
        (vec!["simulate", "FILE", "--out", "out"], "s.toml", asset("scenarios/three_agents.toml")),
        (vec!["simulate", "FILE", "--out", "many", "--resume"], "many.toml", many.to_string()),
        (vec!["tracks", "FILE", "--null", "3", "--out", "out"], "t.csv", asset("example_tracks.csv")),
        (vec!["reach", "FILE"], "system.toml", asset("systems/two_cars.toml").replace("rate <= 1/2", "rate <= 2")),
        (vec!["check", "FILE"], "q.toml", question.clone()),
        (vec!["sweep", "FILE", "--store", "table", "--resume"], "q.toml", question.clone()),
        (vec!["fuzz", "FILE", "--cases", "200"], "q.toml", question),
        (vec!["report", "--no-figures", "--out", "site", "--ledger", "FILE"], "l.json", ledger),
    ]
}

/// A file, the same with a byte-order mark, and either from standard input: one answer. Of JSON no key may stand twice.
#[test]
fn every_command_reads_marks_and_standard_input() {
    let folder = folder("inputs_readers");
    for (arguments, name, text) in readers() {
        let run = |file: &str, input: &str| {
            let filled: Vec<&str> = arguments.iter().map(|word| if *word == "FILE" { file } else { word }).collect();
            with_input(&filled, &folder, input)
        };
        let (marked, answer) = (format!("\u{feff}{text}"), |output: &std::process::Output| {
            let error = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(output.status.success(), "{arguments:?}: {error}");
            // The name of the file and the digest of its bytes are told; they differ.
            let told = stdout(output).replace(name, "-");
            told.lines()
                .filter(|line| !line.contains("configuration "))
                .map(|line| format!("{line}\n"))
                .collect::<String>()
        });
        std::fs::write(folder.join(name), &text).expect("a file");
        let plain = answer(&run(name, ""));
        assert_eq!(answer(&run("-", &text)), plain, "{arguments:?} from standard input");
        assert_eq!(answer(&run("-", &marked)), plain, "{arguments:?} from standard input, with a mark");
        std::fs::write(folder.join(name), &marked).expect("a file");
        assert_eq!(answer(&run(name, "")), plain, "{arguments:?} with a mark");
        if let Some(rest) = text.trim_start().strip_prefix('{') {
            let twice = format!("{{\"twice\": 1, \"twice\": 2, {rest}");
            let output = run("-", &twice);
            let error = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(output.status.code() == Some(2) && error.contains("the key `twice` is there twice"), "{error}");
        }
    }
}

#[test]
fn standard_input_is_read_once() {
    let question = std::fs::read_to_string(asset("questions/algebraic_connectivity.toml")).expect("text");
    let output = with_input(&["check", "-", "-"], Path::new("."), &question);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(String::from_utf8_lossy(&output.stderr), "error: -: standard input can be read only once\n");
}

#[test]
fn normalised_rows_are_told() {
    let found = json(&["ergodicity", &asset("float_matrices.json"), "--normalise", "--json"]);
    assert_eq!(found["changed"][0], "matrix 1, row 1: divided by its sum, 1 -1.000e-4");
    assert_eq!(found["changed"].as_array().map(Vec::len), Some(2));
    let text = stdout(&flockproof(&["ergodicity", &asset("float_matrices.json"), "--normalise"]));
    assert!(text.contains("matrix 2, row 3: divided by its sum, 1 +1.000e-7"), "{text}");
    // What is exact is not changed.
    let exact = json(&["ergodicity", &asset("two_matrices.txt"), "--normalise", "--json"]);
    assert_eq!(exact["changed"], serde_json::json!([]));
    assert_eq!(exact["product"], json(&["ergodicity", &asset("two_matrices.txt"), "--json"])["product"]);
}

/// Every example of `assets/` is read by its command.
#[test]
fn examples_are_read() {
    let out = folder("inputs_examples").to_string_lossy().into_owned();
    for name in ["bridge.txt", "names.txt", "ring.mtx", "path.graphml"] {
        json(&["spectrum", "--graph", &asset(&format!("graphs/{name}")), "--json"]);
    }
    json(&["spectrum", "--graph", &asset("graphs/networkx.txt"), "--zero-based", "--json"]);
    json(&["flock", "run", &asset("model_k.json"), "--until", "9", "--json"]);
    let eight = json(&["flock", "settle", &asset("eight_birds.json"), "--json"]);
    assert_eq!(eight["switches"][0]["t"], "171");
    assert_eq!(eight["switches"][1]["t"].as_str().map(str::len), Some(85));
    let sixteen = json(&["flock", "settle", &asset("sixteen_birds.json"), "--json"]);
    assert_eq!(sixteen["ending"], "beyond");
    assert!(sixteen["next"]["log2_steps"]["lo"].as_str().is_some_and(|lo| lo.starts_with("2.11")));
    // Three cars that follow the one ahead, with unequal gains, as --export writes them.
    let exported = json(&["resonance", "--state", &asset("state"), "--json"]);
    let gains = ["--graph", "front", "--followers", "3", "--f=-1,-2,-1", "--g=-1"];
    let cars = json(&[&["resonance", "--json"], &gains[..]].concat());
    let first_digits = |document: &Value| document["peak"]["amplitude"].to_string()[..14].to_string();
    assert_eq!(first_digits(&exported), first_digits(&cars));
    let noisy = json(&["simulate", &asset("scenarios/vicsek_noise.toml"), "--out", &out, "--animate", "--json"]);
    assert_eq!((&noisy["model"], &noisy["seed"]), (&"vicsek-noise".into(), &"1, 1".into()));
    let observables = noisy["samples"][2]["observables"].as_object().expect("an object");
    assert_eq!(observables.keys().collect::<Vec<_>>(), ["order"]);
    let page = std::fs::read_to_string(Path::new(&out).join("animation.html")).expect("written");
    assert!(page.contains("vicsek-noise, 300 agents") && !page.contains("http"));
    let platoon = json(&["simulate", &asset("scenarios/platoon.toml"), "--out", &out, "--json"]);
    assert_eq!(platoon["samples"][0]["observables"].as_object().map(|o| o.len()), Some(2));
    let events = std::fs::read_to_string(Path::new(&out).join("events.csv")).expect("written");
    assert_eq!(events, "t,kind,agent,other\n");
}

/// Drawn starts of every model, in every arrangement.
#[test]
fn every_model_can_start_at_random() {
    let folder = folder("inputs_random");
    let out = folder.join("out").to_string_lossy().into_owned();
    let fish = "[law]\nT = 1\nrepulsion = 1\norientation = 2\nattraction = 3\n";
    for (model, random, rest) in [
        ("phase", "", "[law]\nK1 = -1\n"),
        ("particles", ", place = \"ring\", spacing = 2", "[law]\nomega0 = 1\n"),
        ("fish", ", place = \"grid\", half = \"1/4\"", fish),
        (
            "heading-alignment",
            ", place = \"line\", spacing = 3",
            "[graph]\nkind = \"path\"\n[law]\npotential = \"none\"\n",
        ),
        (
            "velocity-alignment",
            ", place = \"grid\", speed = 2",
            "[graph]\nkind = \"path\"\n[law]\npotential = \"none\"\n",
        ),
        ("platoon", ", spacing = 2, half = \"1/2\", speed = 1", "[law]\nf = -1\ng = -1\nspacing = 2\n"),
        ("vicsek", ", half = 2", ""),
        ("vicsek", ", half = 2", "[law]\nspeed = \"1/10\"\n"),
        ("vicsek-noise", "", "[law]\nspeed = \"1/10\"\nbox = 5\n"),
    ] {
        let text = format!(
            "model = \"{model}\"\n[state]\nrandom = {{ agents = 7, seed = 3{random} }}\n{rest}[run]\nuntil = 2\nrows = 2\n"
        );
        let found = json(&["simulate", &file(&folder, "random.toml", text.as_bytes()), "--out", &out, "--json"]);
        assert_eq!((&found["ended"], &found["seed"]), (&"finished".into(), &"3".into()), "{model}");
        assert!(found["declaration"].as_str().is_some_and(|text| text.contains("seed 3")), "{model}");
    }
}

/// What is finished is not made again, what was altered is.
#[test]
fn figures_are_resumed() {
    let out = folder("inputs_resume");
    let ask = |more: &[&str]| {
        let folder = out.to_str().expect("UTF-8");
        let output = flockproof(&[&["reproduce", "veerman.table1", "--out", folder], more].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        stdout(&output)
    };
    let first = ask(&[]);
    assert!(first.contains("claims (flockproof explain ID): veerman.table1"), "{first}");
    assert!(ask(&["--resume"]).starts_with("there already, made by this version: veerman.table1"));
    let csv = out.join("veerman.table1.csv");
    let good = std::fs::read(&csv).expect("written");
    std::fs::write(&csv, b"spoiled").expect("a file");
    assert_eq!(ask(&["--resume"]), first);
    assert_eq!(std::fs::read(&csv).expect("written"), good);
}
