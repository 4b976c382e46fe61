//! `list`, `explain` and help: finding things.

use super::{assert_refused, flockproof, stdout};
use serde_json::Value;

fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&stdout(&flockproof(arguments))).expect("one JSON document")
}

fn ids(arguments: &[&str]) -> Vec<String> {
    let document = json(&[&["list", "--json"], arguments].concat());
    let claims = document["claims"].as_array().expect("a list").clone();
    claims.iter().map(|claim| claim["id"].as_str().expect("an id").to_string()).collect()
}

#[test]
fn claims_are_searched_and_filtered() {
    let all = ids(&[]);
    assert!(all.len() > 300 && all.is_sorted());
    let lemmas = ids(&["lemma", "2.3"]);
    assert!(lemmas.contains(&"chazelle.lem2.3".to_string()) && lemmas.len() < all.len());
    let wrong = json(&["list", "--paper", "veerman", "--verdict", "false,misprint", "--json"]);
    for claim in wrong["claims"].as_array().expect("a list") {
        assert_eq!(claim["paper"], "veerman");
        assert!(claim["verdict"] == "false" || claim["verdict"] == "misprint");
        assert!(claim["fault"].is_string());
    }
    let slips = ids(&["--fault", "slip", "--fault", "typo"]);
    assert!(slips.iter().all(|id| ids(&["--verdict", "misprint"]).contains(id)));
    // The scopes divide all claims among them.
    let divided: usize = ["all", "part", "instances", "none"].iter().map(|scope| ids(&["--scope", scope]).len()).sum();
    assert_eq!(divided, all.len());
    assert!(ids(&["--grade", "kernel"]).len() > 50);
    assert!(ids(&["no such words"]).is_empty());
    let text = stdout(&flockproof(&["list", "resonance"]));
    assert!(text.contains("veerman.") && text.contains("flockproof explain ID"));
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    assert_refused(&["list", "--verdict", "wrong"], "--verdict: `wrong` is none of");
    assert_refused(&["list", "--paper", "reynolds"], "--paper: `reynolds` is none of beyond, chazelle");
    assert_refused(&["list", "--scope", "most"], "--scope");
    assert_refused(&["list", "--grade", "proved"], "--grade");
    assert_refused(&["list", "--fault", "bad"], "--fault");
}

#[test]
fn figures_and_claims_name_each_other() {
    let all = ids(&[]);
    for figure in flockproof::report::FIGURES {
        assert!(!figure.claims.is_empty(), "{} is about nothing", figure.name);
        for claim in figure.claims {
            assert!(all.iter().any(|id| id == claim), "{}: there is no claim {claim}", figure.name);
        }
    }
    let text = stdout(&flockproof(&["explain", "veerman.fig1"]));
    assert!(text.contains("figures         veerman.fig1"), "{text}");
    assert!(text.contains("Checked anew by flockproof"), "{text}");
    let document = json(&["explain", "veerman.fig1", "--json"]);
    assert_eq!(document["claim"]["figures"][0], "veerman.fig1");
}

/// Every command has help with an example, an exit status, and no line that is wider than 80 columns.
#[test]
fn help_has_examples_and_an_exit_status() {
    let commands: [&[&str]; 16] = [
        &[],
        &["verify"],
        &["list"],
        &["explain"],
        &["reproduce"],
        &["resonance"],
        &["spectrum"],
        &["tracks"],
        &["prove"],
        &["certify"],
        &["ergodicity"],
        &["flock", "run"],
        &["flock", "settle"],
        &["simulate"],
        &["completions"],
        &["man"],
    ];
    for command in commands {
        let text = stdout(&flockproof(&[command, &["--help"]].concat()));
        assert!(text.contains("Example") && text.contains("Exit status: 0; 1 if"), "{command:?}:\n{text}");
        assert!(text.lines().all(|line| line.chars().count() <= 80), "{command:?}:\n{text}");
    }
}

#[test]
fn nothing_asked_is_answered_with_help() {
    for command in [&[][..], &["flock"]] {
        let output = flockproof(command);
        assert_eq!(output.status.code(), Some(2));
        assert!(String::from_utf8_lossy(&output.stderr).contains("Usage: flockproof"), "{command:?}");
    }
}
