//! Texts of the ledger as HTML: ids, notes and theorems become links, formulas are set.

use super::notation;
use crate::figures::Figure;
use crate::page::{Links, escape};
use maud::{Markup, PreEscaped, html};
use proofs::kernel::Theorem;
use std::collections::BTreeSet;

/// What texts may name.
pub(super) struct Names {
    /// Ids of claims.
    pub claims: BTreeSet<String>,
    /// The Coq theorems that the transcript holds.
    pub theorems: Vec<&'static Theorem>,
    /// Figures that are shown.
    pub figures: Vec<&'static Figure>,
}

impl Names {
    /// The claims that a text names.
    pub fn claims_in<'a>(&'a self, text: &'a str) -> impl Iterator<Item = &'a str> {
        words(text).filter(|word| !word.is_empty() && self.claims.contains(*word))
    }

    /// A text with its links and formulas.
    pub fn rich(&self, text: &str, links: Links) -> Markup {
        self.with(text, links, notation::typeset)
    }

    /// A text with its links.
    pub fn linked(&self, text: &str, links: Links) -> Markup {
        self.with(text, links, escape)
    }

    fn with(&self, text: &str, links: Links, set: fn(&str) -> String) -> Markup {
        let (mut out, mut plain) = (String::new(), String::new());
        for word in words(text) {
            match self.target(word).filter(|_| links != Links::Alone) {
                Some((path, shown)) => {
                    out.push_str(&set(&plain));
                    plain.clear();
                    out.push_str(&links.link(&path, html! { (shown) }).into_string());
                }
                None => plain.push_str(word),
            }
        }
        out.push_str(&set(&plain));
        PreEscaped(out)
    }

    /// The page that a word names.
    fn target<'a>(&self, word: &'a str) -> Option<(String, &'a str)> {
        if self.claims.contains(word) {
            return Some((format!("claims/{word}.html"), word));
        }
        if let Some(figure) = self.figures.iter().find(|figure| figure.name == word) {
            return Some((format!("papers/{}.html#{word}", figure.paper()), word));
        }
        if let Some(theorem) =
            self.theorems.iter().find(|theorem| word.split_once('.') == Some((theorem.file, theorem.name)))
        {
            return Some((format!("coq/{}.html#{}", theorem.file, theorem.name), word));
        }
        let note = word.strip_prefix("notes/")?.strip_suffix(".md")?;
        super::notes::NOTES.contains(&note).then(|| (super::notes::path(note), word))
    }
}

/// A text cut into words that may be names, and what lies between them; joined they are the text.
pub(super) fn words(text: &str) -> impl Iterator<Item = &str> {
    let part_of_name = |c: char| c.is_ascii_alphanumeric() || "._/-".contains(c);
    let mut rest = text;
    std::iter::from_fn(move || {
        let inside = part_of_name(rest.chars().next()?);
        let mut end = rest.find(|c| part_of_name(c) != inside).unwrap_or(rest.len());
        // A point at the end of a sentence belongs to no name.
        let trimmed = rest[..end].trim_end_matches(['.', '-', '/']).len();
        if inside && trimmed > 0 {
            end = trimmed;
        }
        let (word, after) = rest.split_at(end);
        rest = after;
        Some(word)
    })
}
