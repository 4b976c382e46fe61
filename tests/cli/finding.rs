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
    assert!(all.len() > 300);
    // The statements of the papers come first, then our own.
    let own = all.iter().position(|id| id.starts_with("beyond.")).expect("results of our own");
    assert!(all[..own].is_sorted() && all[own..].is_sorted() && all[own..].iter().all(|id| id.starts_with("beyond.")));
    let both = ids(&["--paper", "tanner"]);
    assert_eq!(both.len(), ids(&["--paper", "tanner1,tanner2"]).len());
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
fn a_claim_is_found_by_its_place() {
    let text = stdout(&flockproof(&["explain", "lemma 2", "--paper", "veerman"]));
    assert!(text.starts_with("veerman.lem2  (Lemma 2"), "{text}");
    let several = ["tanner2.thm2_coll", "tanner2.thm2_pot", "tanner2.thm2_vel"];
    let theorem = ["explain", "Theorem 2", "--paper", "tanner"];
    let text = stdout(&flockproof(&theorem));
    let places: Vec<_> = several.iter().map(|id| text.find(&format!("{id}  (Theorem 2"))).collect();
    assert!(places.is_sorted() && places[0] == Some(0), "{places:?}");
    // A document has one claim.
    assert_refused(&[&theorem[..], &["--json"]].concat(), "choose one: tanner2.thm2_coll, tanner2.thm2_pot");
    assert_refused(&["explain", "Theorem 99"], "Theorem 99");
    assert_refused(&["explain", "Theorem 1", "--paper", "tanner1"], "in tanner1; `flockproof list tanner1` shows");
    assert_refused(&["explain", "veerman.lem2", "--paper", "paley"], "is not a claim of paley");
    assert_refused(&["explain", "Lemma 2", "--paper", "reynolds"], "there is no paper reynolds");
}

/// Theorems keep their lines; what is argued is printed where it is asked for, and only the sections that are named.
#[test]
fn explanations_have_the_statements_and_the_proofs() {
    // With the sections that the proof and the evidence lean on.
    let leaning = stdout(&flockproof(&["explain", "tanner2.thm1a", "--proof"]));
    let (_, proof) = leaning.split_once("\n  notes/tanner2.md\n").expect("a proof on paper");
    for section in ["Theorem 1", "Bounds", "Identities", "Laplacians"] {
        assert!(proof.contains(section), "{section} is missing in\n{proof}");
    }
    let text = stdout(&flockproof(&["explain", "beyond.tanner2.thm2_pot", "--proof"]));
    let (before, proof) = text.split_once("\n  notes/tanner2.md\n").expect("a proof on paper");
    assert!(before.contains("argued: proof on paper") && before.contains("[instances]: for named"), "{before}");
    assert!(proof.contains("## Section 5") && !proof.contains("## Bounds"), "{proof}");
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    let text = stdout(&flockproof(&["explain", "chazelle.tau1", "--proof"]));
    assert!(
        text.contains("Coq             tau1_") && text.contains("No clause of it rests on a proof on paper."),
        "{text}"
    );
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
    let commands: [&[&str]; 20] = [
        &[],
        &["verify"],
        &["list"],
        &["explain"],
        &["reproduce"],
        &["resonance"],
        &["spectrum"],
        &["tracks"],
        &["prove"],
        &["check"],
        &["fuzz"],
        &["report"],
        &["certify"],
        &["ergodicity"],
        &["reach"],
        &["flock", "run"],
        &["flock", "settle"],
        &["simulate"],
        &["completions"],
        &["man"],
    ];
    for command in commands {
        let text = stdout(&flockproof(&[command, &["--help"]].concat()));
        assert!(text.contains("Example") && text.contains("Exit status: 0"), "{command:?}:\n{text}");
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

/// The names of all commands, those with subcommands first.
fn commands(of: &[&str]) -> Vec<Vec<String>> {
    let help = stdout(&flockproof(&[of, &["--help"]].concat()));
    let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let names = listed.filter(|line| !line.starts_with("   ")).filter_map(|line| line.split_whitespace().next());
    let mut all = vec![of.iter().map(|name| name.to_string()).collect::<Vec<_>>()];
    for name in names.filter(|name| *name != "help") {
        all.extend(commands(&[of, &[name]].concat()));
    }
    all
}

/// Each tells its exit statuses and has an example; a command with an option for JSON names the schema.
#[test]
fn every_help_has_examples_and_exit_statuses() {
    let all = commands(&[]);
    assert!(all.len() > 20);
    for command in all {
        let arguments: Vec<&str> = command.iter().map(String::as_str).chain(["--help"]).collect();
        let help = stdout(&flockproof(&arguments));
        assert!(help.contains("Exit status: ") && help.contains("after Ctrl-C"), "{command:?}:\n{help}");
        assert!(
            help.contains("\nExample") && help.contains("\n  flockproof ") || help.contains("source <("),
            "{command:?}"
        );
        assert!(help.lines().all(|line| line.chars().count() <= 80), "{command:?}:\n{help}");
        if let Some((_, told)) = help.split_once("  --json") {
            let told = &told[..told.find("\n  -").unwrap_or(told.len())];
            let words = told.split_whitespace().collect::<String>();
            let ours = words.contains("flockproof.") || ["verify", "sweep"].contains(&command[0].as_str());
            assert!(ours, "{command:?}: {told}");
        }
    }
}
