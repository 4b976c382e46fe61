//! Attacks on what the grade `kernel` rests on, each on a copy of the development: `verify` notices every one.

use claims::{ledger, ledger_with};
use ledger::Options;
use proofs::kernel::{AxiomSet, Covers, Development, Source, Theorem};

const CLAIM: &str = "chazelle.tau1";

/// The first theorem about the claim.
fn theorem() -> &'static Theorem {
    Development::own().theorems.iter().find(|theorem| theorem.claim == CLAIM).unwrap()
}

/// What `verify` says of the claim on this development.
fn differences(development: Development) -> Vec<String> {
    let ledger = ledger_with(Box::leak(Box::new(development))).unwrap();
    ledger.verify(&[CLAIM.to_string()], &Options::default(), |_| {}).differences
}

fn assert_noticed(what: &str, development: Development) {
    assert!(!differences(development).is_empty(), "{what}");
}

/// The development with a file changed, and, where the attacker let Coq compile it again, with a transcript of what is there now.
fn altered(file: &str, change: impl Fn(&str) -> String, compiled_again: bool) -> Development {
    let own = Development::own();
    let text = |source: &Source| -> &'static str {
        if source.name != file {
            return source.text;
        }
        let text = change(source.text);
        assert_ne!(text, source.text, "{file} is changed");
        Box::leak(text.into_boxed_str())
    };
    let sources: Vec<(&'static str, &'static str)> =
        own.files().iter().map(|source| (source.name, text(source))).collect();
    let mut copy = own.with_sources(&sources);
    if compiled_again {
        let now = copy.files().iter().map(|file| (file.name.to_string(), file.digest.clone())).collect();
        copy.transcript.digests = now;
    }
    copy
}

#[test]
fn nothing_is_noticed_where_nothing_is_changed() {
    assert_eq!(differences(Development::own().clone()), Vec::<String>::new());
    let claims = ledger().unwrap();
    assert!(claims.verify(&[CLAIM.to_string()], &Options::default(), |_| {}).differences.is_empty());
    // Nor where a file was compiled again that neither the theorem nor its audit needs, or a proof is written in another way.
    for file in ["veerman_size_limit", theorem().file] {
        assert_eq!(differences(altered(file, |text| format!("{text}\n(* end *)\n"), true)), Vec::<String>::new());
    }
}

#[test]
fn changed_files_are_noticed() {
    let own = Development::own();
    let (audit, statement) = own.audited(theorem()).unwrap();
    let file = own.files().iter().find(|file| file.name == theorem().file).unwrap();
    for name in file.needs.iter().copied().chain([file.name, audit.name]) {
        assert_noticed(name, altered(name, |text| format!("{text}\n(* end *)\n"), false));
    }
    // What Coq accepts is not enough: the statement is another one, is not compared with the theorem, or its words mean something else.
    let whole = audit.text.find(statement).unwrap();
    let check = audit.text[..whole].rfind("Check").unwrap();
    let end = whole + audit.text[whole..].find(").").unwrap() + 2;
    let replaced = |text: &str, sentence: String| format!("{}{sentence}{}", &text[..check], &text[end..]);
    let sentence = &audit.text[check..end];
    for other in [
        sentence.replacen(statement, "True", 1),
        sentence.replacen(':', ": True \\/ ", 1),
        format!("(* {sentence} *)"),
        format!("Fail {sentence}"),
        format!("Definition words := \"\n{sentence}\n\"."),
        String::new(),
    ] {
        assert_noticed(&other, altered(audit.name, |text| replaced(text, other.clone()), true));
    }
}

/// A definition behind a statement is a part of what was audited, wherever it stands.
#[test]
fn changed_definitions_are_noticed() {
    let own = Development::own();
    let (audit, statement) = own.audited(theorem()).unwrap();
    let defined = proofs::kernel::definitions_of(statement, own.files());
    let behind = |name: &str| name == audit.name || audit.needs.contains(&name);
    let definition =
        defined.iter().find(|definition| behind(definition.file)).expect("the statement has words of its own");
    let change = |text: &str| {
        text.replacen(definition.text, &definition.text.replacen(":=", ":= id (", 1).replacen('.', ").", 1), 1)
    };
    assert_noticed(definition.text, altered(definition.file, change, true));
    let notation = |text: &str| format!("{text}\nNotation \"a <= b\" := True.\n");
    assert_noticed("a notation", altered(audit.name, notation, true));
}

#[test]
fn an_altered_transcript_is_noticed() {
    let own = Development::own();
    let (audit, _) = own.audited(theorem()).unwrap();
    for name in [theorem().file, audit.name] {
        let mut copy = own.clone();
        copy.transcript.digests.get_mut(name).unwrap().replace_range(..1, "g");
        assert_noticed(name, copy);
        let mut copy = own.clone();
        copy.transcript.digests.remove(name);
        assert_noticed(name, copy);
    }
    let mut copy = own.clone();
    copy.transcript.theorems.remove(&theorem().path());
    assert_noticed("a theorem less", copy);
    let mut copy = own.clone();
    let other = if theorem().axioms == AxiomSet::None { AxiomSet::Reals } else { AxiomSet::None };
    copy.transcript.theorems.insert(theorem().path(), other);
    assert_noticed("other axioms", copy);
}

#[test]
fn altered_tables_are_noticed() {
    let own = Development::own();
    let edits: [fn(&mut Theorem); 6] = [
        |row| row.covers = Covers::Negation,
        |row| row.clauses.push(7),
        |row| row.whole = !row.whole,
        |row| row.part += " And more.",
        |row| row.claim = "chazelle.eq2.3",
        |row| row.name = "nothing",
    ];
    for (k, edit) in (1..).zip(edits) {
        let mut copy = own.clone();
        edit(copy.theorems.iter_mut().find(|row| *row == theorem()).unwrap());
        assert_noticed(&format!("edit {k}"), copy);
    }
    let row = own.row(theorem());
    let mut copy = own.clone();
    assert!(copy.audited.remove(row.as_str()));
    assert_noticed("a row less in what was audited", copy);
}
