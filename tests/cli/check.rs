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
        ("log(1 + sqrt(2)) + log(sqrt(2) - 1) = 0", "edges < 0", 3, "undecided"),
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
    let path = file(&folder, "question.toml", question("planar", "edges < 0").as_bytes());
    assert_refused(&["check", "--all", "0", &path], "--all");
    let unread = question("edges > 0", "edges < 0").replace("[for]", "scenario = \"flock.toml\"\n[for]");
    assert_refused(&["check", &file(&folder, "question.toml", unread.as_bytes())], "line 3, column 12");
}

/// Counterexamples and members with equality in order, each graph a text that `spectrum` reads; controls that the program made.
#[test]
fn members_are_listed() {
    let folder = folder("check-members");
    let text = format!("{QUESTION}property = \"edges <= n\"\n");
    let path = file(&folder, "question.toml", text.as_bytes());
    let replay = folder.to_string_lossy().into_owned();
    let output = flockproof(&["check", &path, "--json", "--all", "2", "--tight", "3", "--replay", &replay]);
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let document: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(document["controls"]["made"], true);
    for (key, count) in [("counterexamples", 2), ("tight", 3)] {
        let members = document[key]["members"].as_array().expect("a list");
        assert_eq!(members.len(), count, "{document}");
        for member in members {
            let graph = member["member"]["graph"].as_str().expect("a graph");
            assert!(flockproof(&["spectrum", "--graph", graph]).status.success(), "{graph}");
        }
    }
}

/// The verdict comes first where there is no inequality that can be an equation.
#[test]
fn nothing_is_tight_without_a_bound() {
    let folder = folder("check-tight");
    let path = file(&folder, "question.toml", question("edges < n*n and n = n", "edges < 0").as_bytes());
    let output = flockproof(&["check", "--tight", &path]);
    let text = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(text.starts_with("mine: holds"), "{text}");
    assert!(text.ends_with("no members with equality: the property has neither `<=` nor `>=`\n"), "{text}");
    let output = flockproof(&["check", "--tight", "--json", &path]);
    let document: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!((document["verdict"].as_str(), &document["tight"]), (Some("holds"), &Value::Null));
}

/// A replay of a question without controls has none, and is decided alike.
#[test]
fn a_replay_makes_its_controls_again() {
    let folder = folder("check-made");
    let path = file(&folder, "question.toml", format!("{QUESTION}property = \"edges <= n\"\n").as_bytes());
    let out = folder.to_string_lossy().into_owned();
    let replay = checked(&path, &out).1["replay"].as_str().expect("a replay").to_string();
    let text = std::fs::read_to_string(&replay).expect("a file");
    assert!(!text.contains("controls"), "{text}");
    let (status, document) = checked(&replay, &out);
    assert_eq!((status, document["controls"]["total"].as_u64()), (1, Some(0)));
    assert!(document["controls"]["why_none"].as_str().is_some_and(|why| why.contains("holds for every member")));
}

/// Sums of squares as files: they say the question itself where it is one of polynomials, and the separate checker agrees.
#[test]
fn certificates_are_written_and_accepted() {
    let folder = folder("check-certificate");
    let asked = |names: &str, property: &str| {
        format!(
            "[question]\nid = \"mine\"\n[for]\n{names}\n[holds]\nproperty = \"{property}\"\ncontrols = [\"1 < 0\"]\n"
        )
    };
    let out = folder.join("out.cert").to_string_lossy().into_owned();
    let written = |names: &str, property: &str| {
        let path = file(&folder, "question.toml", asked(names, property).as_bytes());
        let output = flockproof(&["check", &path, "--certificate", &out]);
        assert_eq!(output.status.code(), Some(0), "{}", stdout(&output));
        assert!(stdout(&output).contains("written: "), "{}", stdout(&output));
        let text = std::fs::read(&out).expect("a certificate");
        (stdout(&output), flockproof_checker::check(&text).expect("the checker accepts it").claim)
    };
    let (_, claim) = written("x = \"any\"\ny = \"any\"", "x^4*y^2 + x^2*y^4 + 1 >= 3*x^2*y^2");
    assert!(claim.starts_with("for all x in R, y in R: "), "{claim}");
    let (_, claim) = written("n = 2\nx = \"[0, 1]\"\ny = \"[-1, 1]\"", "x >= y^2 implies x*(x + 1) >= n*x*y");
    assert!(claim.starts_with("for all x in [0, 1], y in [-1, 1]: ") && claim.contains(" or "), "{claim}");
    // That there is a root, and what is shown of polynomials after it was taken away.
    let (_, claim) = written("x = \"[0, 1]\"\ny = \"[0, 1]\"", "sqrt(x*y) <= (x + y)/2");
    assert_eq!(claim, "for all x in [0, 1], y in [0, 1]: x*y >= 0");
    let second = std::fs::read(format!("{out}.2")).expect("a certificate");
    let claim = flockproof_checker::check(&second).expect("the checker accepts it").claim;
    assert!(claim.starts_with("for all real x1, x2"), "{claim}");
    let (told, _) = written("x = \"[0, 1]\"\ny = \"[0, 1]\"", "2*x*y <= x^2 + y^2 and exp(x) >= 1 + x");
    assert!(told.contains("proved without a certificate: 1 of the parts"), "{told}");
    let path = file(&folder, "question.toml", asked("x = \"[0, 1]\"", "exp(x) >= 1 + x").as_bytes());
    let output = flockproof(&["check", &path, "--certificate", &out]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("no answer rests on a sum of squares"));
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
