//! The Coq development as the program carries it.

extern crate flockproof_proofs as proofs;

mod certificates;
mod kernel;

use proofs::kernel::{AxiomSet, Covers, Transcript, files, recorded, theorems, with_digests};
use std::collections::BTreeSet;
use std::path::Path;

fn folder() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("coq")
}

/// The text without comments, which may nest.
fn without_comments(text: &str) -> String {
    let mut depth = 0usize;
    let mut kept = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        if rest.starts_with("(*") {
            depth += 1;
            rest = &rest[2..];
        } else if depth > 0 && rest.starts_with("*)") {
            depth -= 1;
            rest = &rest[2..];
        } else {
            if depth == 0 {
                kept.push(c);
            }
            rest = &rest[c.len_utf8()..];
        }
    }
    kept
}

#[test]
fn the_program_carries_the_files_of_the_project() {
    let project = std::fs::read_to_string(folder().join("_CoqProject")).unwrap();
    let listed: Vec<&str> = project.lines().filter_map(|line| line.strip_suffix(".v")).collect();
    let carried: Vec<&str> = files().iter().map(|file| file.name).collect();
    assert_eq!(carried, listed);
    let on_disk: BTreeSet<String> = std::fs::read_dir(folder())
        .unwrap()
        .filter_map(|entry| entry.unwrap().file_name().to_str()?.strip_suffix(".v").map(str::to_string))
        .collect();
    assert_eq!(on_disk, listed.iter().map(|name| name.to_string()).collect());
}

#[test]
fn every_row_is_a_theorem_that_coq_checked_and_an_audit_states_again() {
    let table = std::fs::read_to_string(folder().join("theorems.tsv")).unwrap();
    assert_eq!(theorems().len(), table.lines().count() - 1, "a row is malformed");
    for theorem in theorems() {
        assert!(theorem.audited().is_some(), "no audit states {} again", theorem.path());
        assert!(theorem.is_checked(), "{} is not in the transcript as it is now", theorem.path());
        assert!(!theorem.part.is_empty());
    }
}

#[test]
fn nothing_is_assumed() {
    let forbidden =
        ["Admitted", "admit", "Axiom", "Axioms", "Parameter", "Parameters", "Conjecture", "bypass_check", "give_up"];
    for file in files() {
        let code = without_comments(file.text);
        for word in code.split(|c: char| !c.is_alphanumeric() && c != '_') {
            assert!(!forbidden.contains(&word), "{}: {word}", file.name);
        }
        assert!(
            !code.contains("Unset Guard") && !code.contains("Unset Positivity") && !code.contains("Unset Universe")
        );
        assert!(!code.contains("-type-in-type") && !code.contains("Redirect"), "{}", file.name);
    }
}

#[test]
fn a_changed_file_changes_the_digests_of_all_that_need_it() {
    let before = [("a", "Definition x := 1."), ("b", "From Flockproof Require Import a."), ("c", "")];
    let after = [("a", "Definition x := 2."), before[1], before[2]];
    let (before, after) = (with_digests(&before), with_digests(&after));
    assert_eq!(before[1].needs, vec!["a"]);
    assert_ne!(before[0].digest, after[0].digest);
    assert_ne!(before[1].digest, after[1].digest);
    assert_eq!(before[2].digest, after[2].digest);
}

#[test]
fn axioms_are_those_of_the_standard_library() {
    assert_eq!(AxiomSet::of([]), Ok(AxiomSet::None));
    assert_eq!(AxiomSet::of(["Coq.Reals.ClassicalDedekindReals.sig_not_dec"]), Ok(AxiomSet::Reals));
    let classic =
        ["Coq.Logic.Classical_Prop.classic", "Coq.Logic.FunctionalExtensionality.functional_extensionality_dep"];
    assert_eq!(AxiomSet::of(classic), Ok(AxiomSet::RealsAndClassic));
    assert_eq!(AxiomSet::of(["chazelle.assumed"]), Err("chazelle.assumed".to_string()));
    assert_eq!(Covers::parse("whole"), None);
}

#[test]
fn transcripts_are_read_as_they_are_written() {
    assert_eq!(&Transcript::parse(&recorded().text()), recorded());
}
