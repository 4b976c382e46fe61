//! TOML as sections, keys and numbers, each with its line, so that every error can say where it is.

use super::document::{line_of, parse_toml};
use super::error::{ConfigError, Problem};
use arithmetic::{Rational, parse_rational, shown};
use num_traits::ToPrimitive;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The column of a place in its line, from 1, in characters.
fn column_of(text: &str, place: usize) -> usize {
    let before = text.get(..place).unwrap_or(text);
    1 + before[before.rfind('\n').map_or(0, |end| end + 1)..].chars().count()
}

/// A configuration that was parsed but not yet understood.
pub struct Source<'a> {
    text: &'a str,
    /// Which of several runs that differ in what is drawn, from 0.
    pub replica: u64,
    table: Spanned<DeTable<'a>>,
}

impl<'a> Source<'a> {
    /// Parses a text.
    pub fn parse(text: &'a str) -> Result<Self, ConfigError> {
        let table = parse_toml(text).map_err(|error| ConfigError::Toml { line: line_of(text, error.at), error })?;
        Ok(Source { text, replica: 0, table })
    }

    /// Where the number `state.velocities[1][2]` stands in the text; indices from 1.
    pub fn place(&self, path: &str) -> Option<std::ops::Range<usize>> {
        let mut table = self.table.get_ref();
        let mut found: Option<&Spanned<DeValue>> = None;
        for part in path.split('.') {
            let (key, indices) = part.split_once('[').map_or((part, ""), |(key, _)| (key, &part[key.len()..]));
            let (_, mut value) = table.iter().find(|(known, _)| known.get_ref().as_ref() == key)?;
            for index in indices.split('[').skip(1) {
                let DeValue::Array(items) = value.get_ref() else { return None };
                let index: usize = index.strip_suffix(']')?.parse().ok()?;
                value = items.get(index.checked_sub(1)?)?;
            }
            found = Some(value);
            if let DeValue::Table(inner) = value.get_ref() {
                table = inner;
            }
        }
        let value = found?;
        matches!(value.get_ref(), DeValue::String(_) | DeValue::Integer(_) | DeValue::Float(_)).then(|| value.span())
    }

    /// The keys outside any section.
    pub fn top(&self) -> Section<'_> {
        Section { name: "", text: self.text, line: 1, table: self.table.get_ref() }
    }

    /// A section, where there is one.
    pub fn section(&self, name: &'static str) -> Result<Option<Section<'_>>, ConfigError> {
        self.top().get(name).map(|entry| entry.table(name)).transpose()
    }

    /// A section that must be there.
    pub fn needed(&self, name: &'static str) -> Result<Section<'_>, ConfigError> {
        self.section(name)?.ok_or(ConfigError::MissingSection(name))
    }
}

/// A table of the configuration.
#[derive(Clone, Copy)]
pub struct Section<'a> {
    name: &'static str,
    text: &'a str,
    line: usize,
    table: &'a DeTable<'a>,
}

impl<'a> Section<'a> {
    fn called(&self) -> String {
        if self.name.is_empty() { "the configuration".to_string() } else { format!("[{}]", self.name) }
    }

    /// Refuses keys that are not in the list; `among` says more about the section, such as the model.
    pub fn allow(&self, keys: &[&str], among: &str) -> Result<(), ConfigError> {
        let unknown = self.table.iter().filter(|(key, _)| !keys.contains(&key.get_ref().as_ref()));
        match unknown.min_by_key(|(key, _)| key.span().start) {
            None => Ok(()),
            Some((key, _)) => Err(ConfigError::UnknownKey {
                line: line_of(self.text, key.span().start),
                key: shown(key.get_ref()),
                section: format!("{}{among}", self.called()),
                allowed: if keys.is_empty() { "none".to_string() } else { keys.join(", ") },
            }),
        }
    }

    /// The value of a key, where it is given.
    pub fn get(&self, key: &str) -> Option<Entry<'a>> {
        let (_, value) = self.table.iter().find(|(known, _)| known.get_ref().as_ref() == key)?;
        let name = if self.name.is_empty() { key.to_string() } else { format!("{}.{key}", self.name) };
        Some(Entry { key: name, text: self.text, value })
    }

    /// All keys with their values, in the order of the file.
    pub fn entries(&self) -> Vec<(String, Entry<'a>)> {
        let table: &'a DeTable<'a> = self.table;
        let entry = |key: &str, value| Entry { key: format!("{}.{key}", self.name), text: self.text, value };
        let mut all: Vec<_> =
            table.iter().map(|(key, value)| (key.get_ref().to_string(), entry(key.get_ref(), value))).collect();
        all.sort_by_key(|(_, entry)| entry.value.span().start);
        all
    }

    /// The values with their paths: keys with dots, or tables in tables, `a.b = ..`; in the order of the file.
    pub fn leaves(&self) -> Vec<(String, Entry<'a>)> {
        let mut all = Vec::new();
        self.collect_leaves("", &mut all);
        all.sort_by_key(|(_, entry): &(String, Entry)| entry.value.span().start);
        all
    }

    fn collect_leaves(&self, before: &str, all: &mut Vec<(String, Entry<'a>)>) {
        let table: &'a DeTable<'a> = self.table;
        for (key, value) in table.iter() {
            let path = format!("{before}{}", key.get_ref());
            match value.get_ref() {
                DeValue::Table(inner) if !inner.iter().any(|(key, _)| key.get_ref() == "from") => {
                    Section { table: inner, ..*self }.collect_leaves(&format!("{path}."), all);
                }
                _ => all.push((path.clone(), Entry { key: format!("{}.{path}", self.name), text: self.text, value })),
            }
        }
    }

    /// The value of a key that must be there; `expected` is what it should be.
    pub fn need(&self, key: &'static str, expected: &str) -> Result<Entry<'a>, ConfigError> {
        let missing = || ConfigError::MissingKey { section: self.called(), key, expected: expected.to_string() };
        self.get(key).ok_or_else(missing)
    }

    /// A number with a default.
    pub fn number_or(&self, key: &str, default: f64) -> Result<f64, ConfigError> {
        self.get(key).map_or(Ok(default), |entry| entry.number())
    }

    /// Where it begins.
    pub fn line(&self) -> usize {
        self.line
    }

    /// A problem of the section as a whole.
    pub fn problem(&self, problem: Problem) -> ConfigError {
        ConfigError::Value { line: self.line, key: self.name.to_string(), problem }
    }
}

/// A value with its name.
#[derive(Clone)]
pub struct Entry<'a> {
    key: String,
    text: &'a str,
    value: &'a Spanned<DeValue<'a>>,
}

impl<'a> Entry<'a> {
    /// A problem of this value.
    pub fn problem(&self, problem: impl Into<Problem>) -> ConfigError {
        let line = line_of(self.text, self.value.span().start);
        ConfigError::Value { line, key: self.key.clone(), problem: problem.into() }
    }

    /// What is wrong at a byte of the text that is the value.
    pub fn in_text(&self, at: Option<usize>, problem: expressions::Problem) -> ConfigError {
        let span = self.value.span();
        let written = self.text.get(span.clone()).unwrap_or_default();
        // Behind the quotes, where nothing in the text is written in another way than it reads.
        let inside = self.value.get_ref().as_str().and_then(|text| written.find(text)).filter(|_| at.is_some());
        let place = span.start + inside.map_or(0, |start| start + at.unwrap_or(0));
        let (line, column) = (line_of(self.text, place), column_of(self.text, place));
        ConfigError::Expression { line, column, key: self.key.clone(), problem }
    }

    fn shape(&self, expected: &str) -> ConfigError {
        self.problem(Problem::Shape(expected.to_string()))
    }

    /// A range that the value breaks.
    pub fn range(&self, must: impl Into<String>) -> ConfigError {
        self.problem(Problem::Range(must.into()))
    }

    /// The value as a table.
    pub fn table(&self, name: &'static str) -> Result<Section<'a>, ConfigError> {
        let line = line_of(self.text, self.value.span().start);
        match self.value.get_ref() {
            DeValue::Table(table) => Ok(Section { name, text: self.text, line, table }),
            _ => Err(self.shape("a table")),
        }
    }

    /// Whether the value is a list.
    pub fn is_list(&self) -> bool {
        self.value.get_ref().is_array()
    }

    /// Whether the value is a table.
    pub fn is_table(&self) -> bool {
        self.value.get_ref().is_table()
    }

    /// The value as a text.
    pub fn word(&self) -> Result<&'a str, ConfigError> {
        self.value.get_ref().as_str().ok_or_else(|| self.shape("a text in quotes"))
    }

    /// One of some names.
    pub fn choice<T: Copy>(&self, names: &[(&str, T)]) -> Result<T, ConfigError> {
        let word = self.word()?;
        let known = names.iter().find(|(name, _)| *name == word);
        known.map(|(_, value)| *value).ok_or_else(|| {
            let allowed = names.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
            self.problem(Problem::Name { found: shown(word), allowed })
        })
    }

    /// True or false.
    pub fn flag(&self) -> Result<bool, ConfigError> {
        self.value.get_ref().as_bool().ok_or_else(|| self.shape("true or false"))
    }

    /// The value as an exact number: an integer, a decimal, or a text such as `"1/2"`.
    pub fn exact(&self) -> Result<Rational, ConfigError> {
        let text = match self.value.get_ref() {
            DeValue::String(text) => text.as_ref(),
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str(),
            DeValue::Float(float) => float.as_str(),
            _ => return Err(self.shape("a number: an integer, a decimal or a fraction in quotes")),
        };
        parse_rational(text).map_err(|error| self.problem(error))
    }

    /// The exact number, rounded once.
    pub fn number(&self) -> Result<f64, ConfigError> {
        let number = self.exact()?.to_f64().filter(|x| x.is_finite());
        number.ok_or_else(|| self.problem(Problem::TooLarge))
    }

    /// A number above zero.
    pub fn positive(&self) -> Result<f64, ConfigError> {
        let number = self.number()?;
        if number > 0.0 { Ok(number) } else { Err(self.range("a number above 0")) }
    }

    /// A number that is zero or above.
    pub fn not_negative(&self) -> Result<f64, ConfigError> {
        let number = self.number()?;
        if number >= 0.0 { Ok(number) } else { Err(self.range("a number that is not negative")) }
    }

    /// An integer from `least` to `most`.
    pub fn count(&self, least: usize, most: usize) -> Result<usize, ConfigError> {
        let refuse = || match least > most {
            true => self.range("left out: there are too few agents for it"),
            false => self.range(format!("an integer from {least} to {most}")),
        };
        let exact = self.exact()?;
        let count = exact.is_integer().then(|| exact.to_integer().to_usize()).flatten();
        count.filter(|n| (least..=most).contains(n)).ok_or_else(refuse)
    }

    /// The entries of a list.
    pub fn items(&self, expected: &str) -> Result<Vec<Entry<'a>>, ConfigError> {
        let list = self.value.get_ref().as_array().ok_or_else(|| self.shape(expected))?;
        let entry = |(i, value)| Entry { key: format!("{}, entry {}", self.key, i + 1), text: self.text, value };
        Ok(list.iter().enumerate().map(entry).collect())
    }

    /// A list of numbers.
    pub fn numbers(&self) -> Result<Vec<f64>, ConfigError> {
        self.items("a list of numbers")?.iter().map(Entry::number).collect()
    }

    /// A vector of the plane.
    pub fn vector(&self) -> Result<[f64; 2], ConfigError> {
        let numbers = self.numbers()?;
        let found = numbers.len();
        numbers.try_into().map_err(|_| self.problem(Problem::Coordinates { expected: 2, found }))
    }
}
