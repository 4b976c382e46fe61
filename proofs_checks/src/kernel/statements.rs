//! What the audits state, and what the words of a statement mean.

use super::definitions::{definitions_in, words};
use super::scan::{first_word, sentences};
use super::{Definition, Source};
use std::collections::{BTreeMap, BTreeSet};

/// `Check (name : statement).` as it stands in an audit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Stated {
    /// The theorem, with its file where the audit names it.
    pub name: &'static str,
    /// What it states.
    pub statement: &'static str,
}

/// The statements of a file that coqc compares with theorems: its sentences `Check (name : statement).`, and nothing that stands in a comment, in a string, or after
/// another word such as `Fail`.
pub(super) fn stated_in(text: &'static str) -> Vec<Stated> {
    let starts: Vec<usize> = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
    let checks = sentences(text).into_iter().filter(|(_, sentence)| sentence.trim_start().starts_with("Check"));
    let found = checks.filter_map(|(line, sentence)| {
        let rest = text.get(starts[line - 1]..)?;
        let mut there = rest.match_indices("Check").filter_map(|(at, word)| read(&rest[at + word.len()..]));
        // The first of these words may stand in a comment before the sentence.
        there.find(|(_, whole)| spaced(whole) == spaced(&sentence)).map(|(stated, _)| stated)
    });
    found.collect()
}

/// The statement in what follows the word, and all of the sentence.
fn read(rest: &'static str) -> Option<(Stated, String)> {
    let inside = rest.trim_start().strip_prefix('(')?;
    let inside_end = closing(inside)?;
    let from = inside.trim_start().trim_start_matches('@');
    let end = from.find(|c: char| !(c.is_alphanumeric() || "_'.".contains(c)))?;
    let before = inside.len() - from.len();
    let colon = from[end..].find(':')?;
    from[end..end + colon].trim().is_empty().then_some(())?;
    let statement = inside.get(before + end + colon + 1..inside_end)?.trim();
    Some((Stated { name: &from[..end], statement }, format!("Check ({}).", &inside[..inside_end])))
}

/// Where the parenthesis closes that was opened before `text`.
fn closing(text: &str) -> Option<usize> {
    let mut open = 1usize;
    for (at, c) in text.char_indices() {
        match c {
            '(' => open += 1,
            ')' => open -= 1,
            _ => {}
        }
        if open == 0 {
            return Some(at);
        }
    }
    None
}

/// The text with each run of spaces as one.
pub(super) fn spaced(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Sentences that give symbols and structures their meaning, which no name of a statement leads to.
const EVERYWHERE: [&str; 5] = ["Notation", "Infix", "Coercion", "Canonical", "Instance"];

/// What the words of a development mean, file by file.
#[derive(Debug, Clone, Default)]
pub(super) struct Meanings {
    /// Definitions without their comments, with their files.
    definitions: Vec<(&'static str, String)>,
    /// Where each name is defined.
    named: BTreeMap<&'static str, Vec<usize>>,
    /// Sentences that are meant everywhere, by file.
    everywhere: BTreeMap<&'static str, Vec<String>>,
}

impl Meanings {
    pub fn of(files: &[Source]) -> Self {
        let mut meanings = Meanings::default();
        for file in files {
            for Definition { names, text, .. } in definitions_in(file) {
                for name in names {
                    meanings.named.entry(name).or_default().push(meanings.definitions.len());
                }
                let text: String = sentences(text).into_iter().map(|(_, sentence)| sentence).collect();
                meanings.definitions.push((file.name, spaced(&text)));
            }
            let meant = sentences(file.text).into_iter().map(|(_, sentence)| spaced(&sentence));
            let meant = meant.filter(|sentence| first_word(sentence).is_some_and(|word| EVERYWHERE.contains(&word)));
            meanings.everywhere.insert(file.name, meant.collect());
        }
        meanings
    }

    /// All that the names of a statement lead to in these files, and the sentences that are meant everywhere in them.
    pub fn behind(&self, statement: &str, files: &BTreeSet<&str>) -> String {
        let mut open: Vec<String> = words(statement).into_iter().map(String::from).collect();
        let (mut read, mut wanted) = (BTreeSet::new(), BTreeSet::new());
        while let Some(word) = open.pop() {
            if !read.insert(word.clone()) {
                continue;
            }
            for &place in self.named.get(word.as_str()).into_iter().flatten() {
                let (file, text) = &self.definitions[place];
                if files.contains(file) && wanted.insert(place) {
                    open.extend(words(text).into_iter().map(String::from));
                }
            }
        }
        let defined = wanted.into_iter().map(|place| self.definitions[place].1.as_str());
        let meant = files.iter().filter_map(|file| self.everywhere.get(file)).flatten().map(String::as_str);
        defined.chain(meant).collect::<Vec<_>>().join("\n")
    }
}
