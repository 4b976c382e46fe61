//! The symbols of the papers.

use super::notation::set;
use crate::papers::papers;
use maud::{Markup, html};

/// The contents of the page.
pub(super) fn body() -> Markup {
    let rows: Vec<[&str; 3]> = include_str!("glossary.tsv")
        .lines()
        .skip(1)
        .filter_map(|line| line.split('\t').collect::<Vec<_>>().try_into().ok())
        .collect();
    let of = |key: &'static str| rows.iter().filter(move |row| row[0] == key);
    let groups = [("all", "Everywhere".to_string())]
        .into_iter()
        .chain(papers().map(|p| (p.key, format!("{} {}", p.short, p.year))));
    html! {
        h1 { "Symbols" }
        p.lead { "What the letters mean in the statements of each paper." }
        @for (key, name) in groups {
            section.glossary aria-labelledby=(key) {
                h2 id=(key) { (name) }
                dl { @for [_, symbol, meaning] in of(key) { dt { (set(symbol)) } dd { (set(meaning)) } } }
            }
        }
    }
}
