//! One claim in words.

use super::Figure;
use claims::RECORDED;
use ledger::{Entry, Scope, correction_id, recorded};
use proofs::kernel::proofs_of;
use std::fmt::Write;

/// The printed claim, verdict, derivation, counterexample, correction, evidence, controls and numbers, wrapped to
/// `width` columns.
pub fn explain(entry: &Entry, width: usize) -> String {
    let width = width.clamp(40, 120);
    let mut text = format!("{}  ({})\n", entry.id, entry.place);
    let source = if entry.paper == "beyond" { "claim" } else { "printed" };
    section(&mut text, width, source, &entry.statement);
    if let Some(reading) = &entry.reading {
        section(&mut text, width, "reading", reading);
    }
    let verdict = match &entry.why {
        Some(why) => format!("{}: {why}", entry.verdict.word()),
        None => match entry.fault.filter(|fault| fault.word() != entry.verdict.word()) {
            Some(fault) => format!("{} ({})", entry.verdict.word(), fault.word()),
            None => entry.verdict.word().to_string(),
        },
    };
    section(&mut text, width, "verdict", &verdict);
    if let Some(counterexample) = &entry.counterexample {
        section(&mut text, width, "counterexample", counterexample);
    }
    if let Some(corrected) = &entry.corrected {
        section(&mut text, width, "corrected", corrected);
        let own = correction_id(&entry.id);
        if recorded(RECORDED).any(|row| row.id == own) {
            section(&mut text, width, "checked as", &own);
        }
    }
    section(&mut text, width, "why", &entry.derivation);
    let (all, some) = (entry.covered(true), entry.covered(false));
    if entry.clauses.len() > 1 {
        for (k, clause) in (1..).zip(&entry.clauses) {
            let how = match (all.contains(&k), some.contains(&k)) {
                (true, _) => "evidence for all parameters",
                (_, true) => "evidence on instances",
                _ => "no evidence of its own",
            };
            section(&mut text, width, &format!("clause {k}"), &format!("{clause} [{how}]"));
        }
    }
    for e in &entry.evidence {
        let clauses = e.clauses.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
        let which = match (entry.clauses.len(), e.scope) {
            (_, None) => String::new(),
            (0 | 1, Some(Scope::All)) => "[all] ".to_string(),
            (0 | 1, Some(Scope::Instances)) => "[instances] ".to_string(),
            (_, Some(Scope::All)) => format!("[{clauses}: all] "),
            (_, Some(Scope::Instances)) => format!("[{clauses}: instances] "),
        };
        let mut line = format!("{which}{}: {}", e.part, e.detail);
        if let Some(cases) = e.cases {
            // Writing to a string cannot fail.
            let _ = write!(line, " ({cases} cases)");
        }
        if let Some(bound) = &e.error_bound {
            let _ = write!(line, "; a wrong identity would pass with probability at most {bound}");
        }
        section(&mut text, width, e.grade.word(), &line);
    }
    for (theorem, _) in proofs_of(&entry.id) {
        if let Some((audit, statement)) = theorem.audited() {
            let statement = statement.split_whitespace().collect::<Vec<_>>().join(" ");
            section(
                &mut text,
                width,
                "Coq",
                &format!("{} : {statement}  (stated again in {})", theorem.path(), audit.name),
            );
        }
    }
    let controls =
        format!("{} of {} altered variants refuted by the same check", entry.controls.refuted, entry.controls.total);
    section(&mut text, width, "controls", &controls);
    for (what, failed) in entry.controls.what.iter().zip(&entry.controls.failed) {
        section(&mut text, width, "  altered", &format!("{what}: {failed}"));
    }
    for survivor in &entry.surviving_controls {
        section(&mut text, width, "NOT REFUTED", survivor);
    }
    let figures: Vec<&str> = Figure::of_claim(&entry.id).map(|figure| figure.name).collect();
    if !figures.is_empty() {
        section(&mut text, width, "figures", &format!("{} (reproduce NAME --out DIR)", figures.join(", ")));
    }
    for (name, value) in &entry.values {
        section(&mut text, width, "value", &format!("{name} = {value}"));
    }
    text
}

fn section(text: &mut String, width: usize, name: &str, body: &str) {
    let first = format!("  {name:<15} ");
    let options = textwrap::Options::new(width).initial_indent(&first).subsequent_indent("                  ");
    for line in textwrap::wrap(body, options) {
        text.push_str(&line);
        text.push('\n');
    }
}
