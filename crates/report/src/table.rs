//! The table of verdicts and the summary per paper, within 80 columns.

use ledger::{Entry, Report, Verdict};
use std::collections::BTreeSet;
use std::fmt::Write;

/// One line per claim: id, verdict, clauses covered for all parameters, controls, seconds, the strongest grade of evidence.
pub fn verdict_table(entries: &[Entry]) -> String {
    let widest = |f: fn(&Entry) -> usize, header: &str| entries.iter().map(f).max().unwrap_or(0).max(header.len());
    let (id, verdict) = (widest(|e| e.id.len(), "claim"), widest(|e| e.verdict.word().len(), "verdict"));
    let mut text = format!("{:id$} {:verdict$} {:>4} {:>5} {:>5} evidence\n", "claim", "verdict", "all", "ctrl", "s");
    for e in entries {
        let strongest = e.grades().first().map_or("", |grade| grade.word());
        let controls = format!("{}/{}", e.controls.refuted, e.controls.total);
        let (whole, clauses) = e.reach();
        let reach = format!("{whole}/{clauses}");
        let (name, seconds) = (e.verdict.word(), e.seconds);
        // Writing to a string cannot fail, here and below.
        let _ = writeln!(text, "{:id$} {name:verdict$} {reach:>4} {controls:>5} {seconds:>5.2} {strongest}", e.id);
        for k in e.clauses_that_hold() {
            let clause = format!("  its clause {k}");
            let _ = writeln!(text, "{clause:id$} {}", Verdict::Holds.word());
        }
    }
    let held: Vec<(usize, usize)> = entries.iter().filter(|e| e.verdict == Verdict::Holds).map(Entry::reach).collect();
    let (whole, clauses) = held.iter().fold((0, 0), |(a, b), (c, d)| (a + c, b + d));
    let count = if held.is_empty() { String::new() } else { format!(" ({whole} of {clauses} in what holds)") };
    let _ = writeln!(text, "\nall: clauses covered for all parameters{count}\nctrl: negative controls refuted");
    text
}

/// Verdicts per paper, of the claims that were asked for.
pub fn summary(report: &Report) -> String {
    let papers: BTreeSet<&str> = report.entries.iter().map(|e| e.paper.as_str()).collect();
    let line = |paper: &str| {
        let count = |v: Verdict| report.entries.iter().filter(|e| e.paper == paper && e.verdict == v).count();
        let counts = Verdict::ALL.into_iter().map(|v| (count(v), v.word())).filter(|(n, _)| *n > 0);
        let counts: Vec<String> = counts.map(|(n, word)| format!("{n} {word}")).collect();
        let options = textwrap::Options::new(80).subsequent_indent("          ");
        textwrap::fill(&format!("{paper:9} {}", counts.join(", ")), options) + "\n"
    };
    papers.into_iter().map(line).collect()
}
