//! The table of theorems, the digests and the transcript, against naive twins.

use proofs::kernel::{
    AxiomSet, Covers, Development, Forbidden, Source, Theorem, Transcript, audited_rows, files, recorded, scan,
    theorems, with_digests,
};
use sha2::{Digest, Sha256};

#[test]
fn words_are_read_as_they_are_written() {
    for covers in [Covers::Claim, Covers::Part, Covers::Corrected, Covers::Negation, Covers::Instance] {
        assert_eq!(Covers::parse(covers.word()), Some(covers));
    }
    for axioms in [AxiomSet::None, AxiomSet::Reals, AxiomSet::RealsAndClassic] {
        assert_eq!(AxiomSet::parse(axioms.words()), Some(axioms));
    }
    assert_eq!(AxiomSet::parse("classic"), None);
    let reals = |name: &str| format!("Coq.Reals.ClassicalDedekindReals.{name}");
    let extensionality = "Coq.Logic.FunctionalExtensionality.functional_extensionality_dep".to_string();
    for axiom in [reals("sig_not_dec"), reals("sig_forall_dec"), extensionality] {
        assert_eq!(AxiomSet::of([axiom.as_str()]), Ok(AxiomSet::Reals));
        assert_eq!(AxiomSet::of(["Coq.Logic.Classical_Prop.classic", &axiom]), Ok(AxiomSet::RealsAndClassic));
    }
    // A file of the project, or of anyone else, is not the library.
    for other in
        ["Classical_Prop.classic", "Flockproof.Classical_Prop.classic", "classic", "Coq.Logic.Classical.classic"]
    {
        assert_eq!(AxiomSet::of([other]), Err(other.to_string()));
    }
}

#[test]
fn rows_of_the_table_are_theorems() {
    let table = std::fs::read_to_string(super::folder().join("theorems.tsv")).unwrap();
    for (line, theorem) in table.lines().skip(1).zip(theorems()) {
        let clauses: Vec<String> = theorem.clauses.iter().map(usize::to_string).collect();
        let scope = if theorem.whole { "all" } else { "instances" };
        let Theorem { claim, file, name, part, .. } = theorem;
        let (axioms, covers) = (theorem.axioms.words(), theorem.covers.word());
        assert_eq!([claim, file, name, axioms, covers, &clauses.join(","), scope, part].join("\t"), line);
        assert_eq!(theorem.path(), format!("{file}.{name}"));
    }
}

/// Nothing but spaces, and the text with each run of spaces as one.
fn spaced(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn statements_are_those_of_the_audits() {
    for theorem in theorems() {
        let (audit, statement) = theorem.audited().unwrap();
        assert!(audit.name.starts_with("audit") && audit.needs.contains(&theorem.file), "{}", theorem.path());
        // The parenthesis that is closed after the statement is the one before the name.
        let mut open = 0;
        assert!(statement.chars().all(|c| {
            open += i32::from(c == '(') - i32::from(c == ')');
            open >= 0
        }));
        assert_eq!(open, 0, "{}", theorem.path());
        let text = spaced(audit.text).replace("( ", "(").replace(" )", ")").replace("(@", "(").replace(" :", ":");
        let check = |name: &str| format!("({name}: {}).", spaced(statement));
        let check = [theorem.path(), theorem.name.to_string()].map(|name| check(&name).replace(" :", ":"));
        let check = check.map(|sentence| sentence.replace("( ", "(").replace(" )", ")").replace("(@", "("));
        assert!(check.iter().any(|sentence| text.contains(sentence)), "{}: {statement}", theorem.path());
    }
    let one = theorems().iter().find(|theorem| theorem.path() == "chazelle_worked.eps_inequality").unwrap();
    let (audit, statement) = one.audited().unwrap();
    assert_eq!(audit.name, "audit_chazelle");
    assert_eq!(statement, "forall nu : nat, (1 <= nu)%nat -> exp (- INR (nu ^ nu ^ 2)) < / INR nu ^ nu ^ 4");
}

#[test]
fn a_theorem_counts_only_as_coq_saw_it() {
    let one = theorems().iter().find(|theorem| theorem.path() == "chazelle_worked.eps_inequality").unwrap();
    assert!(one.is_checked());
    // What the table says of it is what was audited, to the letter.
    let part = format!("{} And more.", one.part);
    let changed = [
        Theorem { claim: "chazelle.eq2.3", ..one.clone() },
        Theorem { covers: Covers::Part, ..one.clone() },
        Theorem { clauses: vec![2], ..one.clone() },
        Theorem { whole: !one.whole, ..one.clone() },
        Theorem { part, ..one.clone() },
    ];
    for theorem in changed {
        assert!(!theorem.is_checked(), "{theorem:?}");
    }
    // Other axioms than it may rest on; a theorem, a file or an audit that the transcript does not have as it is now.
    let other = if one.axioms == AxiomSet::None { AxiomSet::Reals } else { AxiomSet::None };
    assert!(!Theorem { axioms: other, ..one.clone() }.is_checked());
    assert!(!Theorem { name: "eps_inequalit", ..one.clone() }.is_checked());
    assert!(!Theorem { file: "chazelle_angle", ..one.clone() }.is_checked());
    let by = |transcript: &Transcript| {
        let mut copy = Development::own().clone();
        copy.transcript = transcript.clone();
        copy.is_checked(one)
    };
    for file in ["chazelle_worked", "audit_chazelle"] {
        let mut changed = recorded().clone();
        let digest = changed.digests.get_mut(file).unwrap();
        *digest = digest.chars().rev().collect();
        assert!(!by(&changed), "{file}");
        changed.digests.remove(file);
        assert!(!by(&changed), "{file}");
    }
    let mut without = recorded().clone();
    without.theorems.remove(&one.path());
    assert!(!by(&without));
}

#[test]
fn digests_are_of_the_text_and_of_what_it_needs() {
    let sha = |bytes: &[u8]| -> String { Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect() };
    let texts = [
        ("a", "Definition x := 1."),
        ("ab", "From Coq Require Import List."),
        ("b", "From Flockproof Require Import a."),
        ("c", "From Flockproof Require a.\nFrom Flockproof Require Import ab b. (* From c. *)"),
    ];
    let found: Vec<Source> = with_digests(&texts);
    assert_eq!(found.iter().map(|file| file.name).collect::<Vec<_>>(), ["a", "ab", "b", "c"]);
    let needs: Vec<&[&str]> = found.iter().map(|file| file.needs.as_slice()).collect();
    assert_eq!(needs, [&[][..], &[], &["a"], &["a", "ab", "b"]]);
    for file in &found {
        let mut bytes = file.text.as_bytes().to_vec();
        for need in &file.needs {
            bytes.push(0);
            bytes.extend(found.iter().find(|other| other.name == *need).unwrap().digest.bytes());
        }
        assert_eq!(file.digest, sha(&bytes), "{}", file.name);
    }
    for file in files() {
        assert_eq!(file.text, std::fs::read_to_string(super::folder().join(format!("{}.v", file.name))).unwrap());
    }
}

#[test]
fn transcripts_pass_over_other_lines() {
    let text =
        "# a word\ncoq 8.16.1\nfile a 01ab\nfile b\ntheorem a.x reals\ntheorem a.y choice\ntheorem a.z none more\n";
    let read = Transcript::parse(text);
    assert_eq!(read.coq, "8.16.1");
    assert_eq!(read.digests.into_iter().collect::<Vec<_>>(), [("a".to_string(), "01ab".to_string())]);
    assert_eq!(read.theorems.into_iter().collect::<Vec<_>>(), [("a.x".to_string(), AxiomSet::Reals)]);
    let written = Transcript::parse("coq 8.16.1\nfile a 01ab\ntheorem a.x reals+classic").text();
    let (first, rest) = written.split_once('\n').unwrap();
    assert_eq!(first, "# What coqc said; written by `flockproof prove --transcript FILE`.");
    assert_eq!(rest, "coq 8.16.1\nfile a 01ab\ntheorem a.x reals+classic\n");
    assert_eq!(std::fs::read_to_string(super::folder().join("transcript.txt")).unwrap(), recorded().text());
}

/// What is said of a text that it is not to say: the line, and how the sentence begins.
fn forbidden(text: &str) -> Option<(usize, String)> {
    match scan("a", text) {
        Ok(()) => None,
        Err(Forbidden::Sentence { line, sentence, .. }) => Some((line, sentence)),
        Err(other) => panic!("{other}"),
    }
}

#[test]
fn no_file_assumes_anything_for_good() {
    for file in files() {
        assert_eq!(scan(file.name, file.text), Ok(()), "{}", file.name);
    }
}

#[test]
fn what_assumes_something_is_refused_wherever_it_hides() {
    let refused = [
        "Axiom a : False.",
        "Theorem t : True. Proof. exact I. Qed. Axiom a : False.",
        "Variable classic : False.",
        "Hypothesis h : False.",
        "Hypotheses (h : False).",
        "Context {h : False}.",
        "Context{h : False}.",
        "Variables(a b : False).",
        "Parameter p : False.",
        "Conjecture c : False.",
        "Section S. Parameter p : False. End S.",
        "Section S. End S. Variable v : False.",
        "Module M. Variable v : False. End M.",
        "Section S. Variable v : nat. End S. Module M. Hypothesis h : False. End M.",
        "Local Axiom a : False.",
        "#[local] Axiom a : False.",
        "#[local] #[global] Time Timeout 5 Polymorphic Axiom a : False.",
        "Redirect \"out\" Axiom a : False.",
        "Theorem t : False. Proof. Admitted.",
        "Proof with auto. intros... Axiom a : False.",
        "Notation \"x .. y\" := (x, .. y ..). Axiom a : False.",
        "(* a \"*)\" *) Axiom a : False.",
        "(* (* *) *) Axiom a : False.",
        "Definition s := \"(*\". Axiom a : False.",
        "- Axiom a : False.",
        "Declare Module M : T.",
        "Declare Instance i : C.",
        "Unset Guard Checking.",
        "#[bypass_check(guard)] Fixpoint f (n : nat) : nat := f n.",
        "Load other.",
        "Add LoadPath \"elsewhere\".",
    ];
    for text in refused {
        assert!(forbidden(text).is_some(), "{text}");
    }
    let (line, sentence) = forbidden("Section S.\n(* one\n two *)\nEnd S.\n\n  Variable v : nat -> False.\n").unwrap();
    assert_eq!((line, sentence.as_str()), (6, "Variable v : nat"));
    for good in [
        "(* Axiom a : False. *) Definition x := 1.",
        "Definition s := \"Axiom a. \". Definition t := \". Axiom a\".",
        "Section S. Variable v : nat. Hypothesis h : v = v. Context {w : nat}. End S.",
        "Module M. Section S. Variables (a b : nat). End S. End M.",
        "Section S. Section T. End T. Variable v : nat. End S.",
        "Theorem axiom : True. Proof. - exact I. Qed.",
        "Module A := B. Definition x := A.Axiom.",
    ] {
        assert_eq!(forbidden(good), None, "{good}");
    }
    for name in ["Classical_Prop", "ClassicalDedekindReals", "FunctionalExtensionality"] {
        assert_eq!(scan(name, ""), Err(Forbidden::Name(name.to_string())));
    }
}

/// `audited.tsv` and the table say the same of every theorem; none of either is missing from the other.
#[test]
fn the_table_says_what_was_audited() {
    let rows: Vec<String> = theorems().iter().map(|theorem| Development::own().row(theorem)).collect();
    let again: Vec<&String> = rows.iter().filter(|row| !audited_rows().contains(row.as_str())).collect();
    assert!(again.is_empty(), "read these statements against their clauses, then put into audited.tsv:\n{again:#?}");
    let lost: Vec<&&str> = audited_rows().iter().filter(|row| !rows.iter().any(|own| own == **row)).collect();
    assert!(lost.is_empty(), "audited, but not in theorems.tsv as it was: {lost:#?}");
    assert_eq!(rows.len(), audited_rows().len(), "a theorem is there twice for one claim");
}

/// Edits of the table that say more, or less, than the statement: each makes the theorem count for nothing.
#[test]
fn edits_of_the_table_are_noticed() {
    let find = |claim: &str, path: &str| {
        let found = theorems().iter().find(|theorem| theorem.claim == claim && theorem.path() == path);
        found.unwrap_or_else(|| panic!("{path} is there")).clone()
    };
    let chain = find("veerman.lem2_eigvec", "veerman_chain.equation_2_chain");
    let decays = find("veerman.lem1", "veerman_settling.mode_decays");
    let fails = find("veerman.thm1_x", "veerman_exponent.exponent_printed_fails");
    assert_eq!((chain.clauses.as_slice(), decays.whole, fails.covers), (&[1, 2][..], false, Covers::Negation));
    for edited in [
        Theorem { clauses: vec![1], ..chain },
        Theorem { whole: true, ..decays },
        Theorem { covers: Covers::Part, ..fails },
    ] {
        assert!(
            !edited.is_checked() && !audited_rows().contains(Development::own().row(&edited).as_str()),
            "{edited:?}"
        );
    }
}
