//! Every line of evidence has a negative control that fails in it, so that a check that loses the line is noticed; `unreached.tsv` has the lines
//! in which none can fail, and why.

use super::recorded::report;
use claims::EVIDENCE;
use ledger::{Entry, Evidence, Grade, Options, Verdict, correction_id};
use std::collections::{BTreeMap, BTreeSet};

/// How a reason begins that says where the same part is reached.
const ELSEWHERE: &str = "reached in ";

/// Reasons that are about the size of a case: what the controls alter is empty or commutes there. The same formula is reached at another size.
const AT_THIS_SIZE: [&str; 2] = [
    "at one agent or one entry what the controls alter does not occur; larger sizes are reached",
    "what the controls alter makes no difference at this size; other sizes of the same formula are reached",
];

/// The only line that is not computed.
const OF_THE_TEXT: &str = "the text against itself: nothing is computed";

/// What a part says before its first number.
fn formula(part: &str) -> &str {
    part.split(|c: char| c.is_ascii_digit()).next().unwrap_or_default()
}

/// The lines of an entry that its check computes for what holds: no theorem of Coq, no proof on paper, and not the evidence against a statement
/// that fails, which its own correction is told apart by.
fn computed(entry: &Entry) -> Vec<(String, &Evidence)> {
    let holds = matches!(entry.verdict, Verdict::Holds | Verdict::NotCheckable);
    let is_judged = |e: &&Evidence| holds || e.part.starts_with("corrected: ");
    let mut lines = Vec::new();
    for e in entry.evidence.iter().filter(is_judged).filter(|e| !e.detail.starts_with("Coq theorem ")) {
        if !matches!(e.grade, Grade::Kernel | Grade::Argued) {
            lines.push((e.part.clone(), e));
        }
        lines.extend(e.steps.iter().map(|step| (format!("{}, beside it: {}", e.part, step.part), step)));
    }
    lines
}

#[test]
fn every_line_of_evidence_is_reached_by_a_control() {
    let entries = &report().entries;
    let own: BTreeSet<&str> = entries.iter().map(|entry| entry.id.as_str()).collect();
    let (mut reached, mut unreached) = (BTreeSet::new(), BTreeSet::new());
    for entry in entries {
        // What a correction rests on is looked at where it is a claim of its own.
        let is_elsewhere = entry.corrected.is_some() && own.contains(correction_id(&entry.id).as_str());
        let lines = computed(entry);
        let names: BTreeSet<&String> = lines.iter().map(|(part, _)| part).collect();
        // Controls are known by the names of the parts that they fail in.
        assert_eq!(names.len(), lines.len(), "{}: two lines of one name: {lines:#?}", entry.id);
        for (part, line) in lines.into_iter().filter(|_| !is_elsewhere) {
            let list = if line.controls.is_empty() { &mut unreached } else { &mut reached };
            list.insert((entry.id.as_str(), part));
        }
    }
    let table = include_str!("unreached.tsv");
    let mut rows: BTreeMap<(&str, String), &str> = BTreeMap::new();
    for line in table.lines().skip(1) {
        let [claim, part, why] = line.split('\t').collect::<Vec<_>>()[..] else { panic!("{line} is no row") };
        assert!(rows.insert((claim, part.to_string()), why).is_none(), "{claim}, {part} is there twice");
    }
    let new: Vec<_> = unreached.iter().filter(|line| !rows.contains_key(*line)).collect();
    assert!(
        new.is_empty(),
        "no control fails in these lines: give each one, or say in unreached.tsv why none can: {new:#?}"
    );
    let stale: Vec<_> = rows.keys().filter(|line| !unreached.contains(*line)).collect();
    assert!(stale.is_empty(), "a control reaches these, or they are gone: take them out of unreached.tsv: {stale:#?}");
    // The same part, computed alike, is altered where it says so; the same formula at another size, in the same claim or in one that has that part too.
    for ((claim, part), why) in &rows {
        let own = part.trim_start_matches("corrected: ");
        if let Some(other) = why.strip_prefix(ELSEWHERE) {
            assert!(
                reached.iter().any(|(id, part)| *id == other && part == own),
                "{claim}, {part}: not reached in {other}"
            );
        } else if AT_THIS_SIZE.contains(why) {
            let is_sibling =
                |id: &str, part: &str| id == *claim && formula(part.trim_start_matches("corrected: ")) == formula(own);
            let elsewhere = rows.iter().filter(|(_, why)| why.starts_with(ELSEWHERE)).map(|(line, _)| line);
            let siblings = reached.iter().chain(elsewhere);
            assert!(
                siblings.into_iter().any(|(id, part)| is_sibling(id, part)),
                "{claim}, {part}: no other size is reached"
            );
        } else {
            let entry = entries.iter().find(|entry| entry.id == *claim).unwrap();
            let is_text = entry.evidence.iter().any(|e| e.part == *part && e.grade == Grade::Text);
            assert!(*why == OF_THE_TEXT && is_text, "{claim}, {part}: {why} is no reason");
        }
    }
}

/// The lines that were seen to count for nothing: a line that vanished without a case, an identity with a constant in its place, a lost comparison.
#[test]
fn lines_that_could_be_lost_have_controls() {
    for (claim, part, least) in [
        ("tanner1.Omega.bounded", "speeds", 1),
        ("tanner1.Omega.bounded", "distances", 1),
        ("veerman.lem1", "the quadratic of every mode, whose coefficients decide", 1),
        ("veerman.lem1", "instances", 3),
        ("beyond.paley.sync.par", "common rate", 1),
        ("beyond.paley.sync.par", "common direction", 2),
        ("beyond.paley.sync.par", "the rate", 2),
        ("beyond.paley.sync.par", "parallel where it is zero", 2),
    ] {
        let entry = report().entries.iter().find(|entry| entry.id == claim).unwrap();
        let line =
            entry.evidence.iter().find(|e| e.part == part).unwrap_or_else(|| panic!("{claim} has no line {part}"));
        assert!(line.controls.len() >= least && line.cases.is_some_and(|cases| cases > 0), "{claim}: {line:?}");
    }
}

/// A line that a check loses, gains, or rests on fewer cases is told: made here on the table, which then has a line more, one less, or another number.
#[test]
fn a_lost_line_differs_from_what_is_recorded() {
    for claim in ["tanner1.Omega.bounded", "veerman.lem1", "paley.sync.par"] {
        let differences = |table: String| {
            let ledger = claims::ledger().unwrap().with_evidence(&table);
            ledger.verify(&[claim.to_string()], &Options::default(), |_| {}).differences
        };
        assert_eq!(differences(EVIDENCE.to_string()), Vec::<String>::new());
        let start = format!("{claim}\t");
        let rows: Vec<&str> = EVIDENCE.lines().filter(|line| line.starts_with(&start)).collect();
        for row in [rows[0], rows[rows.len() - 1]] {
            let more = differences(format!("{EVIDENCE}{row}\n"));
            assert!(more.len() == 1 && more[0].contains("was not reached"), "{more:?}");
            let fewer = differences(EVIDENCE.replacen(&format!("{row}\n"), "", 1));
            assert!(fewer.len() == 1 && fewer[0].contains("differs from what is recorded"), "{fewer:?}");
            let mut words: Vec<&str> = row.split('\t').collect();
            words[6] = "1000000";
            let other = differences(EVIDENCE.replacen(row, &words.join("\t"), 1));
            assert_eq!(other.len(), 2, "{other:?}");
        }
    }
}
