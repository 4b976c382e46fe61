//! A TOML text as keys and values, or what is wrong with it: a key that stands twice is named with both its places.

use arithmetic::shown;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Why a text is not TOML.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("not valid TOML: {message}")]
pub struct NotToml {
    /// The byte where it is seen.
    pub at: usize,
    /// What is wrong there.
    pub message: String,
}

/// The line of a byte of a text, from 1.
pub fn line_of(text: &str, place: usize) -> usize {
    1 + text.as_bytes().iter().take(place).filter(|byte| **byte == b'\n').count()
}

/// Parses a text.
///
/// # Errors
/// [`NotToml`] with the first thing that is wrong.
pub fn parse_toml(text: &str) -> Result<Spanned<DeTable<'_>>, NotToml> {
    DeTable::parse(text).map_err(|error| {
        let span = error.span().unwrap_or_default();
        let message = match error.message().lines().next().unwrap_or_default() {
            "duplicate key" => there_twice(text, &span),
            deep if deep.contains("recursion depth") => "lists and sections are nested too deeply".to_string(),
            message => message.to_string(),
        };
        NotToml { at: span.start, message }
    })
}

/// The sentence about a key that stands at `second`, and before.
fn there_twice(text: &str, second: &Range<usize>) -> String {
    let key = shown(text.get(second.clone()).unwrap_or_default());
    match first_place(text, second) {
        Some(place) => format!("the key `{key}` stands there twice, first in line {}", line_of(text, place)),
        None => format!("the key `{key}` stands there twice"),
    }
}

/// Where a key that stands at `second` stood first. The parser does not tell: the second is given a name of its own, and
/// the first is then the one of the old name in the same table.
fn first_place(text: &str, second: &Range<usize>) -> Option<usize> {
    let (before, after) = (text.get(..second.start)?, text.get(second.end..)?);
    let own = (0..).map(|k| format!("second-{k}")).find(|name| !text.contains(name.as_str()))?;
    let key = format!("{} = 0", text.get(second.clone())?);
    let name = DeTable::parse(&key).ok()?.get_ref().keys().next()?.get_ref().to_string();
    let renamed = format!("{before}{own}{after}");
    let (table, _) = DeTable::parse_recoverable(&renamed);
    let mut tables = vec![table.get_ref()];
    while let Some(table) = tables.pop() {
        if table.keys().any(|key| *key.get_ref() == own) {
            return table.keys().find(|key| *key.get_ref() == name).map(|key| key.span().start);
        }
        table.values().for_each(|value| tables_in(value.get_ref(), &mut tables));
    }
    None
}

/// Adds the tables of a value, and of its lists.
fn tables_in<'a, 'i>(value: &'a DeValue<'i>, tables: &mut Vec<&'a DeTable<'i>>) {
    match value {
        DeValue::Table(table) => tables.push(table),
        DeValue::Array(items) => items.iter().for_each(|item| tables_in(item.get_ref(), tables)),
        _ => {}
    }
}
