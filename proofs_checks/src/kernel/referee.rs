//! What a referee takes home: the theorems of one claim with what they rest on, and nothing else.

use super::scan::{first_word, sentences};
use super::{Covers, Source, Theorem, definitions_of, files, needed, proofs_of, recorded};
use ledger::Entry;
use std::fmt::Write;

/// The file in which the statements are written out and compared with the theorems.
const STATEMENTS: &str = "statements";

/// The files for a folder, by their names: `README.md` (statements, then definitions, then how to check), `statements.v`, `check.sh`, and the least set of
/// sources. `None` where no checked theorem speaks of the claim.
pub fn bundle(entry: &Entry) -> Option<Vec<(String, String)>> {
    let theorems: Vec<Theorem> = proofs_of(&entry.id).map(|(theorem, _)| theorem.clone()).collect();
    let names: Vec<&str> = theorems.iter().map(|theorem| theorem.file).collect();
    if names.is_empty() {
        return None;
    }
    let sources: Vec<Source> = needed(&names).into_iter().cloned().collect();
    let mut files = vec![
        ("README.md".to_string(), readme(entry, &theorems, &sources)),
        (format!("{STATEMENTS}.v"), statements(&theorems, &sources)),
        ("check.sh".to_string(), script(&sources)),
    ];
    files.extend(sources.iter().map(|source| (format!("{}.v", source.name), source.text.to_string())));
    Some(files)
}

/// The statement of a theorem as the audit writes it out.
fn stated(theorem: &Theorem) -> &'static str {
    theorem.audited().map_or("", |(_, statement)| statement)
}

fn readme(entry: &Entry, theorems: &[Theorem], sources: &[Source]) -> String {
    let mut text =
        format!("# {} ({})\n\n{}\n\nVerdict: {}.\n", entry.id, entry.place, entry.statement, entry.verdict.word());
    let mut say = |line: std::fmt::Arguments<'_>| {
        // Writing to a string cannot fail.
        let _ = text.write_fmt(line);
    };
    if let Some(reading) = &entry.reading {
        say(format_args!("\nRead as: {reading}\n"));
    }
    if let Some(corrected) = &entry.corrected {
        say(format_args!("\nCorrected: {corrected}\n"));
    }
    if entry.clauses.len() > 1 {
        say(format_args!("\nClause by clause:\n\n"));
        for (clause, k) in entry.clauses.iter().zip(1..) {
            say(format_args!("{k}. {clause}\n"));
        }
    }
    say(format_args!("\n## What Coq proves\n"));
    for theorem in theorems {
        let clauses = theorem.clauses.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
        say(format_args!(
            "\n{}\n\n({}; clause {clauses}{}; axioms: {})\n\n```coq\n{} :\n  {}.\n```\n",
            theorem.part,
            theorem.covers.word(),
            if theorem.covers == Covers::Corrected { " of the correction" } else { "" },
            theorem.axioms.words(),
            theorem.path(),
            stated(theorem)
        ));
    }
    say(format_args!("\n## What the words mean\n"));
    let all: String = theorems.iter().map(|theorem| stated(theorem)).collect::<Vec<_>>().join("\n");
    let mut file = "";
    let mut places = sources.to_vec();
    for (audit, _) in theorems.iter().filter_map(Theorem::audited) {
        if !places.contains(audit) {
            places.push(audit.clone());
        }
    }
    for definition in definitions_of(&all, &places) {
        if definition.file != file {
            say(format_args!(
                "{}\nIn `{}.v`:\n\n```coq\n",
                if file.is_empty() { "" } else { "```\n" },
                // What the audits define stands with the statements.
                if sources.iter().any(|source| source.name == definition.file) { definition.file } else { STATEMENTS }
            ));
            file = definition.file;
        }
        say(format_args!("{}\n", definition.text));
    }
    say(format_args!("{}", if file.is_empty() { "\nNothing but Coq's own libraries.\n" } else { "```\n" }));
    say(format_args!(
        "\n## How to check\n\n`sh check.sh` compiles the {} files below in their order with coqc, then `{STATEMENTS}.v`, which writes the statements out again and prints \
         the axioms that they rest on. It needs Coq {} with its libraries Coquelicot, Interval and mathcomp. What is to be trusted is Coq, and that the \
         statements and definitions above say what the claim says.\n\n",
        sources.len(),
        recorded().coq
    ));
    for source in sources {
        say(format_args!("- `{}.v`\n", source.name));
    }
    text
}

fn script(sources: &[Source]) -> String {
    let names = sources.iter().map(|source| source.name).chain([STATEMENTS]).collect::<Vec<_>>().join(" ");
    format!(
        "#!/bin/sh\n# Compiles the proofs and their statements, each file after those that it needs.\nset -e\ncd \"$(dirname \"$0\")\"\n\
         set -- {names}\nall=$#\nfor file in \"$@\"; do\n  n=$((n + 1))\n  echo \"$n of $all: $file\" >&2\n  \
         coqc -q -Q . Flockproof -w -notation-overridden,-ambiguous-paths \"$file.v\"\ndone\necho \"All of it is proved.\"\n"
    )
}

/// A file of Coq that states theorems in the words of their audits, each with those imports and definitions of the audit that it needs, and asks for the axioms.
pub fn statements(theorems: &[Theorem], sources: &[Source]) -> String {
    let mut text = String::new();
    for (theorem, k) in theorems.iter().zip(1..) {
        let Some((audit, statement)) = theorem.audited() else { continue };
        let (module, path) = (format!("statement_{k}"), theorem.path());
        let own = definitions_of(statement, std::slice::from_ref(audit)).into_iter().map(|own| own.text.to_string());
        let around = surroundings(audit, theorem, sources).into_iter().chain(own).collect::<Vec<_>>().join("\n");
        text += &format!(
            "Module {module}.\n{around}\nCheck ({path} :\n  {statement}).\nPrint Assumptions {path}.\nEnd {module}.\n\n"
        );
    }
    text
}

/// Sentences that give those after them their meaning.
const SURROUND: [&str; 7] = ["From", "Require", "Import", "Open", "Set", "Unset", "Notation"];

/// The sentences of an audit in whose scope a theorem is stated; of the files that they require only those that are there.
fn surroundings(audit: &Source, theorem: &Theorem, sources: &[Source]) -> Vec<String> {
    let mut open: Vec<Vec<String>> = vec![Vec::new()];
    for (_, sentence) in sentences(audit.text) {
        let sentence = sentence.split_whitespace().collect::<Vec<_>>().join(" ");
        match first_word(&sentence) {
            Some("Check") if states(&sentence, theorem) => break,
            Some("Module" | "Section") if !sentence.contains(":=") => open.push(Vec::new()),
            Some("End") => drop(open.pop()),
            Some(word) if SURROUND.contains(&word) && !sentence.contains('"') => {
                open.last_mut().into_iter().for_each(|own| own.extend(there(&sentence, sources)));
            }
            _ => {}
        }
    }
    open.concat()
}

/// Whether a sentence is `Check (theorem : ...)`.
fn states(sentence: &str, theorem: &Theorem) -> bool {
    let rest = sentence.trim_start_matches("Check").trim_start().trim_start_matches(['(', '@', ' ']);
    [theorem.path().as_str(), theorem.name]
        .iter()
        .any(|name| rest.strip_prefix(name).is_some_and(|rest| rest.trim_start().starts_with(':')))
}

/// The sentence, without files of the development that are not there.
fn there(sentence: &str, sources: &[Source]) -> Option<String> {
    let known = |names: &[&str], word: &str| names.contains(&word);
    let all: Vec<&str> = files().iter().map(|file| file.name).collect();
    let own: Vec<&str> = sources.iter().map(|source| source.name).collect();
    let kept = |word: &&str| !known(&all, word.trim_end_matches('.')) || known(&own, word.trim_end_matches('.'));
    let words: Vec<&str> = sentence.split_whitespace().filter(kept).collect();
    let named = words.iter().any(|word| !["From", "Flockproof", "Require", "Import"].contains(word));
    named.then(|| words.join(" ").trim_end_matches('.').to_string() + ".")
}
