//! `certify` writes what is committed, and refuses with one sentence.

use super::{assert_refused, file, flockproof, folder, stdout};
use flockproof::certificates::{CertificateError, Inertia};
use flockproof::claims::certificates::LEDGER;
use flockproof::matrix::RationalMatrix;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

fn committed(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs_checks").join(path)
}

fn names(folder: &Path) -> BTreeSet<String> {
    std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect()
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn certificates_and_theorems_are_those_that_are_committed() {
    let (out, coq) = (folder("certify"), folder("certify_coq"));
    let arguments = ["certify", "--out", &out.to_string_lossy(), "--coq", &coq.to_string_lossy()];
    let output = flockproof(&arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(stdout(&output).lines().count(), names(&out).len() + names(&coq).len());
    let corpus = committed("checker/corpus/pass");
    let mut known = names(&corpus);
    known.retain(|name| !name.starts_with("extra_"));
    assert_eq!(names(&out), known);
    assert_eq!(names(&out), LEDGER.iter().map(|row| format!("{}.cert", row.name())).collect());
    for name in names(&out) {
        assert_eq!(text(&out.join(&name)), text(&corpus.join(&name)), "{name}");
    }
    for name in names(&coq) {
        assert_eq!(text(&coq.join(&name)), text(&committed("coq").join(&name)), "{name}");
    }
}

#[test]
fn certificates_belong_to_claims_in_order() {
    let listed = include_str!("../../crates/claims/src/listed.tsv");
    for row in &LEDGER {
        assert!(listed.lines().any(|line| line.split('\t').next() == Some(row.claim)), "{}", row.claim);
    }
    assert!(LEDGER.windows(2).all(|rows| (rows[0].claim, rows[0].result) < (rows[1].claim, rows[1].result)));
}

#[test]
fn other_commands_write_certificates_too() {
    let folder = folder("certificates_of_commands");
    let out = folder.join("out.cert").to_string_lossy().into_owned();
    let matrices = file(&folder, "matrices.txt", b"1/2 1/2\n1/3 2/3\n\n1 0\n0 1\n1/4 3/4\n");
    let flock = br#"{"model":"D","weights":"vicsek","positions":[["0"],["1"]],"velocities":[["0"],["1/2"]]}"#;
    let flock = file(&folder, "flock.json", flock);
    for (arguments, claim) in [
        (vec!["ergodicity", &matrices, "--json"], "tau_1 of the product of the 2 row-stochastic matrices below"),
        (vec!["flock", "run", &flock, "--until", "9", "--json"], "changes its network 1 times from t = 1 to t = 9"),
        (vec!["resonance", "--followers", "3", "--f=-2", "--g=-1/3", "--json"], "of the 3 followers"),
    ] {
        let output = flockproof(&[&arguments[..], &["--certificate", &out]].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_str::<serde_json::Value>(&stdout(&output)).expect("one JSON document");
        let text = text(Path::new(&out));
        assert!(text.lines().nth(1).unwrap().contains(claim), "{text}");
    }
}

#[test]
fn wrong_use_is_named() {
    let out = folder("certify_refused").to_string_lossy().into_owned();
    assert_refused(&["certify"], "--out");
    assert_refused(&["certify", "--out", &out, "--claim", "chazelle.nothing"], "chazelle.nothing");
    let many = ["resonance", "--followers", "97", "--f=-1", "--g=-1", "--certificate", &format!("{out}/c.cert")];
    assert_refused(&many, "at most 96 followers");
}

#[test]
fn inertia_needs_a_diagonal() {
    let swap = RationalMatrix::from_integers(&[[0, 1], [1, 0]], 1).unwrap();
    assert_eq!(Inertia::new(&swap).unwrap_err(), CertificateError::NoPivot);
    let slanted = RationalMatrix::from_integers(&[[0, 1], [2, 0]], 1).unwrap();
    assert_eq!(Inertia::new(&slanted).unwrap_err(), CertificateError::NotSymmetric);
    let zero_first = RationalMatrix::from_integers(&[[0, 1, 0], [1, 2, 0], [0, 0, 0]], 3).unwrap();
    assert_eq!(Inertia::new(&zero_first).unwrap().counts(), (1, 1, 1));
}

#[test]
fn a_claim_is_taken_home_with_what_its_theorems_rest_on() {
    let out = folder("certify_claim");
    let output = flockproof(&["certify", "--claim", "chazelle.tau1", "--coq", &out.to_string_lossy()]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let files: Vec<&str> = flockproof::kernel::proofs_of("chazelle.tau1").map(|(theorem, _)| theorem.file).collect();
    let sources = flockproof::kernel::needed(&files);
    assert!(files.contains(&"chazelle_ergodicity") && sources.len() < flockproof::kernel::files().len() / 4);
    let mut expected: BTreeSet<String> = sources.iter().map(|source| format!("{}.v", source.name)).collect();
    expected.extend(["README.md", "statements.v", "check.sh"].map(String::from));
    assert_eq!(names(&out), expected);
    for source in sources {
        assert_eq!(text(&out.join(format!("{}.v", source.name))), source.text);
    }
    // The statement stands before the definitions, these before the way to check.
    let readme = text(&out.join("README.md"));
    let place = |words: &str| readme.find(words).unwrap_or_else(|| panic!("{words}: {readme}"));
    assert!(
        place("## What Coq proves") < place("## What the words mean")
            && place("## What the words mean") < place("## How to check")
    );
    assert!(readme.contains("Definition tau1 "), "{readme}");
    assert!(text(&out.join("statements.v")).contains("Print Assumptions chazelle_ergodicity."));
    assert_refused(&["certify", "--claim", "paley.figS1_S3", "--coq", &out.to_string_lossy()], "paley.figS1_S3");
}

#[test]
fn bounds_of_worst_cases_are_certified() {
    let folder = folder("reach_bound");
    let out = folder.join("bound.cert");
    let asset = |name: &str| format!("{}/assets/systems/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let output = flockproof(&["reach", &asset("two_cars"), "--bound", &out.to_string_lossy()]);
    assert_eq!(output.status.code(), Some(1), "another check is false");
    let certified = flockproof_checker::check(text(&out).as_bytes()).expect("accepted");
    assert_eq!(certified.kind, "bound");
    // What cannot be certified is told after the answer.
    let output = flockproof(&["reach", &asset("forty_cars"), "--bound", &out.to_string_lossy()]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(String::from_utf8_lossy(&output.stdout).contains("gap1 <= 3020"), "{output:?}");
    assert!(String::from_utf8_lossy(&output.stderr).contains("at most 40 states"), "{output:?}");
}
