//! One claim in words.

use super::{Figure, WrittenProof};
use ledger::{Entry, Ledger, Scope, correction_id};
use proofs::kernel::proofs_of;
use serde_json::{Value, json};
use std::fmt::Write;

/// The printed claim, verdict, derivation, counterexample, correction, evidence, controls and numbers, wrapped to
/// `width` columns. The ledger has the verdicts that are recorded.
pub fn explain(entry: &Entry, ledger: &Ledger, width: usize) -> String {
    let width = width.clamp(40, 120);
    let first = format!("{}  ({})", entry.id, entry.place);
    let mut text = textwrap::fill(&first, textwrap::Options::new(width).subsequent_indent("  ")) + "\n";
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
        if ledger.recorded().any(|row| row.id == own) {
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
            let verdict = match entry.clause_verdicts.get(k - 1) {
                Some(Some(verdict)) => verdict.word(),
                _ => "no verdict of its own",
            };
            section(&mut text, width, &format!("clause {k}"), &format!("{clause} [{verdict}; {how}]"));
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
            let place = format!("{} in {}.v, stated again in {}.v:", theorem.name, theorem.file, audit.name);
            section(&mut text, width, "Coq", &place);
            verbatim(&mut text, width, statement);
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
    for (name, value) in &entry.values {
        section(&mut text, width, "value", &format!("{name} = {value}"));
    }
    let figures: Vec<&str> = Figure::of_claim(&entry.id).map(|figure| figure.name).collect();
    if !figures.is_empty() {
        let command = format!("{} (flockproof reproduce {} --out DIR)", figures.join(", "), figures[0]);
        section(&mut text, width, "figures", &command);
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

/// Lines with their own indentation below a section.
fn verbatim(text: &mut String, width: usize, lines: &str) {
    let margin = |line: &&str| line.len() - line.trim_start().len();
    let least =
        lines.lines().skip(1).filter(|line| !line.trim().is_empty()).map(|line| margin(&line)).min().unwrap_or(0);
    for (k, line) in lines.lines().enumerate() {
        let line = if k == 0 { line.trim() } else { line.get(least..).unwrap_or_default().trim_end() };
        let indent = " ".repeat(20 + margin(&line));
        let rest = format!("{indent}  ");
        let options = textwrap::Options::new(width).initial_indent(&indent).subsequent_indent(&rest);
        for line in textwrap::wrap(line.trim_start(), options) {
            text.push_str(&line);
            text.push('\n');
        }
    }
}

/// The proofs on paper, as they stand in the notes, each with its file.
pub fn explain_proofs(proofs: &[WrittenProof], width: usize) -> String {
    let mut text = String::new();
    for proof in proofs {
        text += &format!("\n  {}\n\n", proof.file);
        for line in proof.text.lines() {
            let margin = " ".repeat(2 + line.len() - line.trim_start().len());
            let rest = if line.trim_start().starts_with(|c: char| c.is_ascii_digit() || c == '-') {
                format!("{margin}   ")
            } else {
                margin.clone()
            };
            let options = textwrap::Options::new(width.clamp(40, 120)).initial_indent(&margin).subsequent_indent(&rest);
            text += &(textwrap::fill(line.trim_start(), options) + "\n");
        }
    }
    text
}

/// What the grades and scopes of an explanation mean, each that stands in it once.
pub fn legend(entry: &Entry, width: usize) -> String {
    let mut parts: Vec<String> =
        entry.grades().into_iter().map(|grade| format!("{}: {}", grade.word(), grade.meaning())).collect();
    if !entry.evidence.is_empty() {
        parts.push("[all]: for all parameters of the clause; [instances]: for named cases, or for a part of what the clause says, only".to_string());
    }
    textwrap::fill(&parts.join(". "), width.clamp(40, 120)) + if parts.is_empty() { "" } else { "\n" }
}

/// The same as JSON: the entry of the ledger, and beside it the derivation, controls that were not refuted, the theorems of Coq, the
/// claim that checks the correction, the recorded verdict, and the figures.
pub fn explanation(entry: &Entry, ledger: &Ledger) -> Value {
    let theorem = |theorem: &proofs::kernel::Theorem| {
        let statement = theorem.audited().map(|(_, text)| text.split_whitespace().collect::<Vec<_>>().join(" "));
        json!({"theorem": theorem.path(), "states": statement, "axioms": theorem.axioms.words(), "covers": theorem.covers.word()})
    };
    let own = correction_id(&entry.id);
    let recorded_as = |id: &str| ledger.recorded().find(|row| row.id == id);
    // Strings, numbers and lists only: this cannot fail.
    let mut document = serde_json::to_value(entry).unwrap_or_default();
    document["derivation"] = json!(entry.derivation);
    document["surviving_controls"] = json!(entry.surviving_controls);
    document["theorems"] = proofs_of(&entry.id).map(|(t, _)| theorem(t)).collect();
    document["checked_as"] = json!(recorded_as(&own).map(|row| row.id));
    document["recorded_verdict"] = json!(recorded_as(&entry.id).map(|row| row.verdict));
    document["figures"] = Figure::of_claim(&entry.id).map(|figure| figure.name).collect();
    json!({"claim": document, "coq": {"version": proofs::kernel::recorded().coq, "checked": CHECKED}})
}

/// When Coq checked the proofs of the ledger.
const CHECKED: &str =
    "when the transcript was written that comes with the program; `flockproof prove` checks anew and needs coqc";
