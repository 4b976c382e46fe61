//! What the words of a statement mean: the definitions of the development that it rests on.

use super::Source;
use super::scan::{first_word, sentences};
use std::collections::BTreeSet;

/// A sentence that gives a name its meaning.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Definition {
    /// The file, without `.v`.
    pub file: &'static str,
    /// The line where it begins, from 1.
    pub line: usize,
    /// The names that it gives.
    pub names: Vec<&'static str>,
    /// The sentence as it stands there.
    pub text: &'static str,
}

/// Words that open a definition.
const DEFINE: [&str; 13] = [
    "Definition",
    "Fixpoint",
    "CoFixpoint",
    "Function",
    "Inductive",
    "CoInductive",
    "Variant",
    "Record",
    "Structure",
    "Class",
    "Notation",
    "Let",
    "Instance",
];

/// The definitions in these files that a text speaks of, and those that they speak of in turn, in the order of the files. A name that two files give is
/// taken from both; names of Coq's own libraries are left out.
pub fn definitions_of(text: &str, files: &[Source]) -> Vec<Definition> {
    let all: Vec<Definition> = files.iter().flat_map(definitions_in).collect();
    let mut open = words(text);
    let (mut read, mut wanted) = (BTreeSet::new(), BTreeSet::new());
    while let Some(word) = open.pop() {
        if !read.insert(word) {
            continue;
        }
        for (place, definition) in all.iter().enumerate() {
            if definition.names.contains(&word) && wanted.insert(place) {
                open.extend(words(definition.text));
            }
        }
    }
    let mut place = 0..;
    all.into_iter().filter(|_| place.next().is_some_and(|place| wanted.contains(&place))).collect()
}

pub(super) fn definitions_in(file: &Source) -> Vec<Definition> {
    let starts: Vec<usize> = std::iter::once(0).chain(file.text.match_indices('\n').map(|(at, _)| at + 1)).collect();
    let sentences = sentences(file.text);
    let begun = |k: usize| sentences.get(k).map_or(file.text.len(), |(line, _)| starts[line - 1]);
    let defines = |sentence: &str| first_word(sentence).is_some_and(|word| DEFINE.contains(&word));
    let definition = |(k, (line, sentence)): (usize, &(usize, String))| {
        // Up to where the next sentence begins, without its comment.
        let text = file.text[begun(k)..begun(k + 1).max(begun(k))].trim_end();
        let text = text
            .rsplit_once(".\n")
            .filter(|(_, rest)| rest.trim_start().starts_with("(*"))
            .map_or(text, |(own, _)| &text[..own.len() + 1]);
        let names = names_given(text);
        (defines(sentence) && !names.is_empty()).then_some(Definition { file: file.name, line: *line, names, text })
    };
    sentences.iter().enumerate().filter_map(definition).collect()
}

/// The names that a sentence gives: the one after its first word, constructors and fields, the quoted words of a notation.
fn names_given(text: &str) -> Vec<&str> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
    let all = words(text);
    let Some(place) = all.iter().position(|word| DEFINE.contains(word)) else { return Vec::new() };
    if all[place] == "Notation" {
        let quoted = text.split('"').nth(1).unwrap_or_default();
        let own = if quoted.is_empty() { all.get(place + 1).copied() } else { None };
        return quoted.split(|c: char| !is_word(c)).filter(|word| word.len() > 1).chain(own).collect();
    }
    let mut names: Vec<&str> = all.get(place + 1).copied().into_iter().collect();
    if matches!(all[place], "Inductive" | "CoInductive" | "Variant") {
        names.extend(text.split('|').skip(1).filter_map(|part| words(part).first().copied()));
    }
    if matches!(all[place], "Record" | "Structure" | "Class") {
        let inside = text.split_once('{').map_or("", |(_, inside)| inside);
        names.extend(inside.split(';').filter_map(|part| words(part).first().copied()));
    }
    names
}

/// The names in a text, those of `file.name` by their last part.
pub(super) fn words(text: &str) -> Vec<&str> {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '\''))
        .filter(|word| word.starts_with(|c: char| c.is_alphabetic() || c == '_'))
        .collect()
}
