//! TOML with the byte where each text stands, so that every error has its line and column.

use crate::error::{Place, Problem, QuestionError};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A file that was parsed but not yet understood.
pub(crate) struct Source<'a> {
    text: &'a str,
    table: Spanned<DeTable<'a>>,
}

/// A text in the file with the byte where its first letter stands.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Located {
    pub text: String,
    pub base: usize,
}

/// A table of the file.
#[derive(Clone, Copy)]
pub(crate) struct Section<'a> {
    name: &'static str,
    source: &'a str,
    /// The byte where it begins.
    at: usize,
    table: &'a DeTable<'a>,
}

/// A key with its value.
#[derive(Clone)]
pub(crate) struct Entry<'a> {
    pub key: String,
    pub key_at: usize,
    source: &'a str,
    value: &'a Spanned<DeValue<'a>>,
}

impl<'a> Source<'a> {
    pub fn parse(text: &'a str) -> Result<Self, QuestionError> {
        let table = scenario::parse_toml(text)
            .map_err(|error| QuestionError::At { place: Place::of(text, error.at), problem: Problem::Toml(error) })?;
        Ok(Source { text, table })
    }

    /// A section, where there is one; other keys at the top are refused.
    pub fn sections<const N: usize>(
        &self,
        names: &[&'static str; N],
    ) -> Result<[Option<Section<'_>>; N], QuestionError> {
        let top = Section { name: "", source: self.text, at: 0, table: self.table.get_ref() };
        top.allow(names)?;
        let mut sections = [None; N];
        for (section, name) in sections.iter_mut().zip(names) {
            let Some(entry) = top.get(name) else { continue };
            *section = match entry.value.get_ref() {
                DeValue::Table(table) => Some(Section { name, source: self.text, at: entry.at(), table }),
                other => return Err(entry.problem(Problem::expected("a section", kind(other)))),
            };
        }
        Ok(sections)
    }
}

impl<'a> Section<'a> {
    /// Refuses other keys.
    pub fn allow(&self, keys: &[&'static str]) -> Result<(), QuestionError> {
        let what = if self.name.is_empty() { "section" } else { "key" };
        match self.entries().into_iter().find(|entry| !keys.contains(&entry.key.as_str())) {
            None => Ok(()),
            Some(entry) => Err(QuestionError::At {
                place: Place::of(self.source, entry.key_at),
                problem: Problem::unknown(what, &entry.key, keys.iter().copied()),
            }),
        }
    }

    /// All entries, in the order of the file.
    pub fn entries(&self) -> Vec<Entry<'a>> {
        let entry = |(key, value): (&Spanned<std::borrow::Cow<'a, str>>, &'a Spanned<DeValue<'a>>)| Entry {
            key: key.get_ref().to_string(),
            key_at: key.span().start,
            source: self.source,
            value,
        };
        let mut entries: Vec<Entry> = self.table.iter().map(entry).collect();
        entries.sort_by_key(|entry| entry.key_at);
        entries
    }

    pub fn get(&self, key: &str) -> Option<Entry<'a>> {
        self.entries().into_iter().find(|entry| entry.key == key)
    }

    pub fn need(&self, key: &'static str, expected: &'static str) -> Result<Entry<'a>, QuestionError> {
        let missing = Problem::Missing { section: self.name, key, expected };
        self.get(key).ok_or_else(|| self.problem(missing))
    }

    /// The byte where it begins.
    pub fn at(&self) -> usize {
        self.at
    }

    /// A problem of the section as a whole.
    pub fn problem(&self, problem: Problem) -> QuestionError {
        QuestionError::At { place: Place::of(self.source, self.at), problem }
    }
}

impl<'a> Entry<'a> {
    fn at(&self) -> usize {
        self.value.span().start
    }

    /// A problem at the value.
    pub fn problem(&self, problem: Problem) -> QuestionError {
        QuestionError::At { place: Place::of(self.source, self.at()), problem }
    }

    /// A text, or a number as its text.
    pub fn text(&self) -> Result<Located, QuestionError> {
        match self.value.get_ref() {
            DeValue::String(text) => {
                let span = self.value.span();
                let raw = self.source.get(span.clone()).unwrap_or_default();
                let quotes = if raw.starts_with("\"\"\"") || raw.starts_with("'''") { 3 } else { 1 };
                let newline = usize::from(quotes == 3 && raw[3..].starts_with('\n'));
                Ok(Located { text: text.to_string(), base: span.start + quotes + newline })
            }
            DeValue::Integer(_) | DeValue::Float(_) => {
                let span = self.value.span();
                let text = self.source.get(span.clone()).unwrap_or_default().replace('_', "");
                Ok(Located { text, base: span.start })
            }
            other => Err(self.problem(Problem::expected("a text or a number", kind(other)))),
        }
    }

    /// The same, and a list of them as one text, `each:` before it.
    pub fn text_or_list(&self) -> Result<Located, QuestionError> {
        if !self.is_list() {
            return self.text();
        }
        let texts = self.items().iter().map(|item| item.text().map(|own| own.text)).collect::<Result<Vec<_>, _>>()?;
        Ok(Located { text: format!("each:{}", texts.join(",")), base: self.at() })
    }

    /// The items of a list; a single value is a list of one.
    pub fn items(&self) -> Vec<Entry<'a>> {
        match self.value.get_ref() {
            DeValue::Array(items) => items
                .iter()
                .map(|value| Entry { key: self.key.clone(), key_at: self.key_at, source: self.source, value })
                .collect(),
            _ => vec![self.clone()],
        }
    }

    pub fn is_list(&self) -> bool {
        matches!(self.value.get_ref(), DeValue::Array(_))
    }

    /// A whole number from 1 to a most.
    pub fn count(&self, most: u64) -> Result<u64, QuestionError> {
        let text = self.text()?.text;
        let number = text.parse().ok().filter(|n| (1..=most).contains(n));
        number.ok_or_else(|| {
            self.problem(Problem::Range {
                what: format!("`{}`", self.key),
                expected: format!("an integer from 1 to {most}"),
                found: arithmetic::shown(&text),
            })
        })
    }
}

/// What a value is, in words.
fn kind(value: &DeValue) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a section",
    }
}
