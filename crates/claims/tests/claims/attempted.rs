//! Which attempt at a counterexample stands against which clause: every clause of every claim that holds has one, and every attempt exists.

use claims::RECORDED;
use ledger::{Verdict, recorded};
use std::collections::{BTreeMap, BTreeSet};

/// Claim, clauses (`2` or `1-3`), attempt: a test (`file::function`), an entry of a list of searches (`file: name`), or `argument: ...`.
const TABLE: &str = include_str!("attempts.tsv");

const SOURCES: [(&str, &str); 8] = [
    ("chazelle", include_str!("attempts/chazelle.rs")),
    ("chazelle_late", include_str!("attempts/chazelle_late.rs")),
    ("chazelle_networks", include_str!("attempts/chazelle_networks.rs")),
    ("veerman", include_str!("attempts/veerman.rs")),
    ("phases", include_str!("motion_attempts/phases.rs")),
    ("particles", include_str!("motion_attempts/particles.rs")),
    ("flocks", include_str!("motion_attempts/flocks.rs")),
    ("switching", include_str!("motion_attempts/switching.rs")),
];

/// The tests and the searches of the sources, as the table names them.
fn attempts() -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for (file, source) in SOURCES {
        let lines: Vec<&str> = source.lines().map(str::trim).collect();
        for pair in lines.windows(2).filter(|pair| pair[0] == "#[test]" && !pair[1].contains("_survive")) {
            let name = pair[1].strip_prefix("fn ").and_then(|rest| rest.strip_suffix("() {"));
            names.insert(format!("{file}::{}", name.expect("a test without arguments")));
        }
        let listed = lines.iter().filter_map(|line| line.strip_prefix("Attempt { name: \"")?.split_once('"'));
        names.extend(listed.map(|(name, _)| format!("{file}: {name}")));
    }
    names
}

#[test]
fn every_clause_that_holds_is_attempted() {
    let (attempts, mut named) = (attempts(), BTreeSet::new());
    let mut attempted: BTreeMap<&str, BTreeSet<usize>> = BTreeMap::new();
    for row in TABLE.lines().skip(1) {
        let [claim, clauses, attempt] = row.split('\t').collect::<Vec<_>>()[..] else { panic!("three columns: {row}") };
        let (first, last) = clauses.split_once('-').unwrap_or((clauses, clauses));
        let number = |text: &str| text.parse::<usize>().expect("a number");
        attempted.entry(claim).or_default().extend(number(first)..=number(last));
        if !attempt.starts_with("argument: ") {
            assert!(attempts.contains(attempt), "no such attempt: {attempt}");
            named.insert(attempt.to_string());
        }
    }
    let mut wrong = Vec::new();
    for row in recorded(RECORDED) {
        let found = attempted.remove(row.id).unwrap_or_default();
        let count: usize = row.reach.split_once('/').and_then(|(_, all)| all.parse().ok()).expect("a reach");
        let unknown = found.last().is_some_and(|last| *last > count);
        if unknown || row.verdict == Verdict::Holds.word() && found.len() < count {
            wrong.push(format!("{}: {found:?} of {count}", row.id));
        }
    }
    assert_eq!((wrong, attempted), (Vec::new(), BTreeMap::new()));
    assert_eq!(
        attempts.difference(&named).collect::<Vec<_>>(),
        Vec::<&String>::new(),
        "attempts that stand against nothing"
    );
}
