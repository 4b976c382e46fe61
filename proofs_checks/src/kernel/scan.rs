//! What no file of the development may say: sentences that assume something, or that turn off a check of Coq.
//!
//! `Print Assumptions` tells the axioms under a theorem; this tells them where they are made, so that none can pass for one of the standard
//! library. What is assumed in a section is a hypothesis of the theorems that leave it.

/// Sentences that assume something for good, wherever they stand, or read what is no source.
const NEVER: [&str; 12] = [
    "Axiom",
    "Axioms",
    "Parameter",
    "Parameters",
    "Conjecture",
    "Conjectures",
    "Admitted",
    "Admit",
    "Declare",
    "Primitive",
    "Load",
    "Add",
];

/// Sentences that assume something for the section in which they stand.
const IN_SECTIONS: [&str; 5] = ["Variable", "Variables", "Hypothesis", "Hypotheses", "Context"];

/// Checks that no sentence and no attribute may turn off.
const CHECKS: [&str; 4] = ["Guard Checking", "Positivity Checking", "Universe Checking", "bypass_check"];

/// Words that come before the one that says what a sentence does.
const BEFORE: [&str; 14] = [
    "Local",
    "Global",
    "Export",
    "Polymorphic",
    "Monomorphic",
    "Cumulative",
    "NonCumulative",
    "Private",
    "Program",
    "Time",
    "Redirect",
    "Timeout",
    "Fail",
    "Succeed",
];

/// Files of the standard library that hold axioms which theorems may rest on: no file of the project bears such a name.
const LIBRARY: [&str; 3] = ["Classical_Prop", "ClassicalDedekindReals", "FunctionalExtensionality"];

/// What is wrong with a file.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Forbidden {
    /// A sentence.
    #[error("{file}.v:{line}: `{sentence}` {why}")]
    Sentence {
        /// The file without `.v`.
        file: String,
        /// Its line, from 1.
        line: usize,
        /// How the sentence begins.
        sentence: String,
        /// What it does.
        why: &'static str,
    },
    /// The name of a file.
    #[error("{0}.v has the name of a file of Coq's library, whose axioms are told by name")]
    Name(String),
}

/// Looks through a file.
///
/// # Errors
/// The first thing that it may not say.
pub fn scan(name: &str, text: &str) -> Result<(), Forbidden> {
    if LIBRARY.contains(&name) {
        return Err(Forbidden::Name(name.to_string()));
    }
    // What is open: sections and modules.
    let mut open: Vec<bool> = Vec::new();
    for (line, sentence) in sentences(text) {
        let Some(first) = first_word(&sentence) else { continue };
        let why = if NEVER.contains(&first) {
            Some("assumes something, or reads what is no source")
        } else if IN_SECTIONS.contains(&first) && !open.contains(&true) {
            Some("stands outside sections and so assumes something")
        } else if CHECKS.iter().any(|check| sentence.contains(check)) {
            Some("turns off a check of Coq")
        } else {
            None
        };
        if let Some(why) = why {
            let sentence = sentence.split_whitespace().take(4).collect::<Vec<_>>().join(" ");
            return Err(Forbidden::Sentence { file: name.to_string(), line, sentence, why });
        }
        match first {
            "Section" => open.push(true),
            "Module" if !sentence.contains(":=") => open.push(false),
            "End" => drop(open.pop()),
            _ => {}
        }
    }
    Ok(())
}

/// The word that says what a sentence does.
pub(super) fn first_word(sentence: &str) -> Option<&str> {
    let mut rest = sentence.trim_start_matches(|c: char| c.is_whitespace() || "{}-+*".contains(c));
    while let Some(attribute) = rest.strip_prefix("#[") {
        rest = attribute.split_once(']').map_or("", |(_, after)| after).trim_start();
    }
    let before = |word: &&str| BEFORE.contains(word) || word.parse::<u64>().is_ok() || word.starts_with('"');
    let mut words = rest.split(|c: char| c.is_whitespace() || "([{:.".contains(c)).filter(|word| !word.is_empty());
    words.find(|word| !before(word))
}

/// The sentences without their comments and with nothing in their strings, each with the line where it begins, from 1.
pub(super) fn sentences(text: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let (mut line, mut begun, mut sentence) = (1, 1, String::new());
    let (mut comments, mut in_string) = (0usize, false);
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        line += usize::from(c == '\n');
        let next = rest.peek().copied();
        match c {
            '"' => {
                in_string = !in_string;
                if comments == 0 {
                    sentence.push('"');
                }
            }
            _ if in_string => {}
            '(' if next == Some('*') => {
                comments += 1;
                rest.next();
            }
            '*' if next == Some(')') && comments > 0 => {
                comments -= 1;
                rest.next();
                sentence.push(' ');
            }
            _ if comments > 0 => {}
            '.' => {
                sentence.push('.');
                // `x .. y` stands in notations; `...` ends a sentence as `.` does.
                let dots = sentence.len() - sentence.trim_end_matches('.').len();
                if dots != 2 && next.is_none_or(char::is_whitespace) {
                    found.push((begun, std::mem::take(&mut sentence)));
                }
            }
            _ => {
                if sentence.trim().is_empty() {
                    begun = line;
                }
                sentence.push(c);
            }
        }
    }
    found.push((begun, sentence));
    found
}
