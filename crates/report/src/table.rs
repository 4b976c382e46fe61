//! The table of verdicts and the summary per paper, within 80 columns.

use claims::LISTED;
use ledger::{Entry, Report, Verdict, listed};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// One line per claim: id, verdict, clauses covered for all parameters, controls, time, the strongest grade of evidence and the number of other grades.
pub fn verdict_table(entries: &[Entry]) -> String {
    let widest = |f: fn(&Entry) -> usize, header: &str| entries.iter().map(f).max().unwrap_or(0).max(header.len());
    let (id, verdict) = (widest(|e| e.id.len(), "claim"), widest(|e| e.verdict.word().len(), "verdict"));
    let mut text =
        format!("{:id$} {:verdict$} {:>4} {:>5} {:>6} evidence\n", "claim", "verdict", "all", "ctrl", "time");
    for e in entries {
        let grades = match e.grades().as_slice() {
            [] => String::new(),
            [only] => only.word().to_string(),
            [strongest, others @ ..] => format!("{} +{}", strongest.word(), others.len()),
        };
        let controls = format!("{}/{}", e.controls.refuted, e.controls.total);
        let (whole, clauses) = e.reach();
        let reach = format!("{whole}/{clauses}");
        let (name, seconds) = (e.verdict.word(), e.seconds);
        // Writing to a string cannot fail, here and below.
        let _ = writeln!(text, "{:id$} {name:verdict$} {reach:>4} {controls:>5} {seconds:>5.2}s {grades}", e.id);
    }
    let held: Vec<(usize, usize)> = entries.iter().filter(|e| e.verdict == Verdict::Holds).map(Entry::reach).collect();
    let (whole, clauses) = held.iter().fold((0, 0), |(a, b), (c, d)| (a + c, b + d));
    let _ = writeln!(
        text,
        "\nall: clauses covered for all parameters ({whole} of {clauses} in what holds)\nctrl: negative controls refuted"
    );
    text
}

/// Counts per paper: claims built, verdicts, claims of the list that are missing.
pub fn summary(report: &Report, papers: &[String]) -> String {
    let paper_of = |id: &str| id.split('.').next().unwrap_or_default().to_string();
    let mut listed_per_paper: BTreeMap<String, BTreeSet<&str>> = BTreeMap::new();
    for row in listed(LISTED) {
        listed_per_paper.entry(paper_of(row.id)).or_default().insert(row.id);
    }
    let mut names: BTreeSet<String> = report.entries.iter().map(|e| e.paper.clone()).collect();
    names.extend(listed_per_paper.keys().filter(|p| papers.is_empty() || papers.contains(p)).cloned());
    let mut text = String::new();
    for paper in names {
        let entries: Vec<&Entry> = report.entries.iter().filter(|e| e.paper == paper).collect();
        let counts: Vec<String> = Verdict::ALL
            .into_iter()
            .map(|v| (v.word(), entries.iter().filter(|e| e.verdict == v).count()))
            .filter(|(_, n)| *n > 0)
            .map(|(word, n)| format!("{n} {word}"))
            .collect();
        let missing = listed_per_paper
            .get(&paper)
            .map_or(0, |ids| ids.iter().filter(|&&id| !entries.iter().any(|e| e.id == id)).count());
        let built = if entries.is_empty() { "none checked".to_string() } else { counts.join(", ") };
        let _ = writeln!(
            text,
            "{paper:9} {built}{}",
            if missing > 0 { format!("; {missing} missing") } else { String::new() }
        );
    }
    text
}
