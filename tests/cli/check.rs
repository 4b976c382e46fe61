//! `check`: exit status, JSON, replay, wrong input.

use super::{assert_refused, file, flockproof, folder, stdout};
use serde_json::Value;

const QUESTION: &str = "[question]\nid = \"mine\"\n[for]\nn = \"2..5\"\ngraph = \"connected(n)\"\n[holds]\n";

fn question(property: &str, control: &str) -> String {
    format!("{QUESTION}property = \"{property}\"\ncontrols = [\"{control}\"]\n")
}

/// Exit status and document.
fn checked(path: &str, replay: &str) -> (i32, Value) {
    let output = flockproof(&["check", path, "--json", "--replay", replay]);
    let document = serde_json::from_str(&stdout(&output)).expect("one JSON document");
    (output.status.code().expect("a status"), document)
}

#[test]
fn verdicts_and_exit_statuses() {
    let folder = folder("check-verdicts");
    let replay = folder.to_string_lossy().into_owned();
    let bound = "lambda(2) >= 2*(1 - cos(pi/n))";
    for (property, control, status, verdict) in [
        (bound, "lambda(2) >= 1", 0, "holds"),
        ("edges < 6", "edges < 0", 1, "false"),
        ("exp(log(2)) = 2", "edges < 0", 3, "undecided"),
        (bound, "edges >= 0", 4, "withheld"),
    ] {
        let path = file(&folder, "question.toml", question(property, control).as_bytes());
        let (found, document) = checked(&path, &replay);
        assert_eq!((found, document["verdict"].as_str()), (status, Some(verdict)), "{document}");
        assert_eq!((&document["schema"], &document["id"]), (&"flockproof.check/1".into(), &"mine".into()));
        let total = document["controls"]["total"].as_u64();
        assert_eq!(total, Some(1));
        assert!(document["why"].as_str().is_some_and(|why| !why.is_empty()));
    }
}

#[test]
fn a_counterexample_is_decided_again() {
    let folder = folder("check-replay");
    let replay = folder.to_string_lossy().into_owned();
    let path = file(&folder, "question.toml", question("edges < 6", "edges < 0").as_bytes());
    let (_, document) = checked(&path, &replay);
    assert_eq!(document["counterexample"]["n"], "4");
    let written = document["replay"].as_str().expect("a file");
    let (status, again) = checked(written, &replay);
    assert_eq!((status, &again["verdict"], &again["cases"]), (1, &"false".into(), &1.into()));
    // `n` only made the graph.
    let graph = &document["counterexample"]["graph"];
    assert_eq!((&again["counterexample"], &again["replay"]), (&serde_json::json!({ "graph": graph }), &written.into()));
    assert_eq!((&again["margin"]["lo"], &again["margin"]["hi"]), (&"0".into(), &"0".into()));
}

/// Whoever writes the same file at the same time, each writes it whole.
#[test]
fn two_checks_write_one_replay() {
    let folder = folder("check-together");
    let replay = folder.to_string_lossy().into_owned();
    let path = file(&folder, "question.toml", question("edges < 6", "edges < 0").as_bytes());
    for _ in 0..8 {
        let statuses = std::thread::scope(|scope| {
            let running = [(); 4].map(|()| scope.spawn(|| checked(&path, &replay).0));
            running.map(|one| one.join().expect("no panic"))
        });
        assert_eq!(statuses, [1; 4]);
    }
    let left = std::fs::read_dir(&folder).expect("a folder").count();
    assert_eq!(left, 2, "the question and its replay");
}

#[test]
fn names_are_listed() {
    let output = flockproof(&["check", "--names"]);
    let text = stdout(&output);
    assert!(output.status.success());
    for name in ["connected(n)", "lambda(k)", "peak_frequency", "tau_1", "last_switch", "min_distance", "sqrt"] {
        assert!(text.contains(name), "{name}");
    }
}

#[test]
fn wrong_input() {
    let folder = folder("check-wrong");
    assert_refused(&["check"], "QUESTION.toml");
    assert_refused(&["check", "nowhere.toml"], "nowhere.toml");
    for (property, control, named) in [
        (
            "lamda(2) > 0",
            "edges < 0",
            "line 7, column 13: there is no name `lamda`; the nearest known name is `lambda`",
        ),
        ("always[0, 1](edges > 0)", "edges < 0", "line 7, column 13"),
        ("edges > 0", "edges >", "line 8, column 21"),
    ] {
        let path = file(&folder, "question.toml", question(property, control).as_bytes());
        assert_refused(&["check", &path], named);
    }
    let missing = format!("{QUESTION}property = \"edges > 0\"\n");
    assert_refused(&["check", &file(&folder, "question.toml", missing.as_bytes())], "controls");
    let unread = question("edges > 0", "edges < 0").replace("[for]", "scenario = \"flock.toml\"\n[for]");
    assert_refused(&["check", &file(&folder, "question.toml", unread.as_bytes())], "line 3, column 12");
}

/// The tube of a motion from a box of starts, with runs from its middle and corners.
#[test]
fn quantities_are_drawn_over_time() {
    let folder = folder("check-plot");
    let scenario = "model = \"velocity-alignment\"\n[graph]\nkind = \"edges\"\nedges = [[1, 2]]\n[state]\n\
        positions = [[0, 0], [1, 0]]\nvelocities = [[0, 0], [1, 0]]\n[law]\npotential = \"none\"\n[run]\nuntil = 2\n";
    file(&folder, "motion.toml", scenario.as_bytes());
    let question = "[question]\nid = \"mine\"\nscenario = \"motion.toml\"\n[for]\n\"state.velocities[1][1]\" = \"[0, 1/4]\"\n\
        [holds]\nproperty = \"always[0, 2](min_distance > 1/2)\"\ncontrols = [\"always[0, 2](min_distance > 6/5)\"]\n";
    let path = file(&folder, "question.toml", question.as_bytes());
    let plot = folder.join("tube.svg").to_string_lossy().into_owned();
    let output = flockproof(&["check", &path, "--plot", &plot]);
    assert!(output.status.success() && stdout(&output).ends_with(&format!("written: {plot}\n")), "{output:?}");
    let drawn = std::fs::read_to_string(&plot).expect("a picture");
    for text in ["min_distance", "all starts, enclosed", "single starts", "The worst of the starts"] {
        assert!(drawn.contains(text), "{text}");
    }
    // Nothing moves there, and one question is drawn at a time.
    let still = file(&folder, "still.toml", self::question("edges >= 0", "edges < 0").as_bytes());
    assert_refused(&["check", &still, "--plot", &plot], "has none");
    assert_refused(&["check", &still, &path, "--plot", &plot], "one question");
}
