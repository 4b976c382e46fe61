//! A configuration as sections, keys and numbers, each with its line, so that every error can say where it is; and with other numbers put in.

use super::document::{line_of, parse_toml};
use super::error::{ConfigError, Problem};
use super::path::{Path, Step};
use arithmetic::{NumberError, Rational, parse_rational, shown};
use models::platoon::read_numbers;
use num_traits::ToPrimitive;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The column of a place in its line, from 1, in characters.
fn column_of(text: &str, place: usize) -> usize {
    let before = text.get(..place).unwrap_or(text);
    1 + before[before.rfind('\n').map_or(0, |end| end + 1)..].chars().count()
}

/// A value with its bytes in the text.
#[derive(Debug, Clone)]
struct Node {
    span: Range<usize>,
    value: Value,
}

#[derive(Debug, Clone)]
enum Value {
    Text(String),
    /// An integer or a decimal as it is written, without underscores.
    Decimal(String),
    /// A number that was put in.
    PutIn(Rational),
    Flag(bool),
    List(Vec<Node>),
    Table(Table),
    /// What no configuration has: dates, integers that are not decimal.
    Other,
}

/// Keys with the bytes where they stand, and their values.
type Table = Vec<(String, usize, Node)>;

impl Node {
    fn of(value: &Spanned<DeValue>) -> Self {
        let node = match value.get_ref() {
            DeValue::String(text) => Value::Text(text.to_string()),
            DeValue::Integer(integer) if integer.radix() == 10 => Value::Decimal(integer.as_str().to_string()),
            DeValue::Float(float) => Value::Decimal(float.as_str().to_string()),
            DeValue::Boolean(flag) => Value::Flag(*flag),
            DeValue::Array(items) => Value::List(items.iter().map(Node::of).collect()),
            DeValue::Table(table) => Value::Table(table_of(table)),
            DeValue::Integer(_) | DeValue::Datetime(_) => Value::Other,
        };
        Node { span: value.span(), value: node }
    }

    /// What is a step further.
    fn at(&mut self, step: &Step) -> Option<&mut Self> {
        match (&mut self.value, step) {
            (Value::Table(table), Step::Key(name)) => {
                table.iter_mut().find(|(key, ..)| key == name).map(|(.., node)| node)
            }
            (Value::List(items), Step::Index(index)) => items.get_mut(*index),
            _ => None,
        }
    }

    /// Whether another number can stand in its place.
    fn is_number(&self) -> bool {
        matches!(self.value, Value::Text(_) | Value::Decimal(_) | Value::PutIn(_))
    }
}

fn table_of(table: &DeTable) -> Table {
    table.iter().map(|(key, value)| (key.get_ref().to_string(), key.span().start, Node::of(value))).collect()
}

/// A configuration that was parsed but not yet understood.
#[derive(Debug, Clone)]
pub struct Source {
    text: String,
    /// Which of several runs that differ in what is drawn, from 0.
    pub(super) replica: u64,
    root: Node,
}

impl Source {
    /// Parses a text.
    ///
    /// # Errors
    /// [`ConfigError::Toml`].
    pub fn parse(text: &str) -> Result<Self, ConfigError> {
        let table = parse_toml(text).map_err(|error| ConfigError::Toml { line: line_of(text, error.at), error })?;
        let root = Node { span: table.span(), value: Value::Table(table_of(table.get_ref())) };
        Ok(Source { text: text.to_string(), replica: 0, root })
    }

    /// The text that it was read from.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The same with other numbers in some places.
    ///
    /// # Errors
    /// [`ConfigError::NoPlace`] where there is no number.
    pub fn with<'n>(&self, numbers: impl IntoIterator<Item = (&'n Path, Rational)>) -> Result<Self, ConfigError> {
        let mut changed = self.clone();
        for (path, number) in numbers {
            let node = path.steps().iter().try_fold(&mut changed.root, Node::at).filter(|node| node.is_number());
            node.ok_or_else(|| ConfigError::NoPlace(path.to_string()))?.value = Value::PutIn(number);
        }
        Ok(changed)
    }

    /// Whether it draws its start at random.
    ///
    /// # Errors
    /// [`ConfigError`] where `state` is no section.
    pub fn is_drawn(&self) -> Result<bool, ConfigError> {
        Ok(self.section("state")?.is_some_and(|state| state.get("random").is_some()))
    }

    /// The keys outside any section.
    pub fn top(&self) -> Section<'_> {
        let table: &Table = if let Value::Table(table) = &self.root.value { table } else { const { &Vec::new() } };
        Section { name: "", text: &self.text, line: 1, table }
    }

    /// A section, where there is one.
    ///
    /// # Errors
    /// [`ConfigError`] where it is no table.
    pub fn section(&self, name: &'static str) -> Result<Option<Section<'_>>, ConfigError> {
        self.top().get(name).map(|entry| entry.table(name)).transpose()
    }

    /// A section that must be there.
    ///
    /// # Errors
    /// [`ConfigError`] where it is not, or is no table.
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
    table: &'a Table,
}

impl<'a> Section<'a> {
    fn called(&self) -> String {
        if self.name.is_empty() { "the configuration".to_string() } else { format!("[{}]", self.name) }
    }

    /// Refuses keys that are not in the list; `among` says more about the section, such as the model.
    pub fn allow(&self, keys: &[&str], among: &str) -> Result<(), ConfigError> {
        let unknown = self.table.iter().filter(|(key, ..)| !keys.contains(&key.as_str()));
        match unknown.min_by_key(|(_, at, _)| *at) {
            None => Ok(()),
            Some((key, at, _)) => Err(ConfigError::UnknownKey {
                line: line_of(self.text, *at),
                key: shown(key),
                section: format!("{}{among}", self.called()),
                allowed: if keys.is_empty() { "none".to_string() } else { keys.join(", ") },
            }),
        }
    }

    /// The value of a key, where it is given.
    pub fn get(&self, key: &str) -> Option<Entry<'a>> {
        let (.., node) = self.table.iter().find(|(known, ..)| known == key)?;
        let name = if self.name.is_empty() { key.to_string() } else { format!("{}.{key}", self.name) };
        Some(Entry { key: name, text: self.text, node })
    }

    /// All keys with their values, in the order of the file.
    pub fn entries(&self) -> Vec<(String, Entry<'a>)> {
        let table: &'a Table = self.table;
        let name = |key: &String| format!("{}.{key}", self.name);
        let entry =
            |(key, _, node): &'a (String, usize, Node)| (key.clone(), Entry { key: name(key), text: self.text, node });
        let mut all: Vec<(String, Entry)> = table.iter().map(entry).collect();
        all.sort_by_key(|(_, entry)| entry.node.span.start);
        all
    }

    /// Where a key with its value stands.
    pub fn key_and_value(&self, key: &str) -> Option<std::ops::Range<usize>> {
        let (_, start, node) = self.table.iter().find(|(known, ..)| known == key)?;
        Some(*start..node.span.end)
    }

    /// The values with their paths: keys with dots, or tables in tables, `a.b = ..`; in the order of the file.
    pub fn leaves(&self) -> Vec<(String, Entry<'a>)> {
        let mut all = Vec::new();
        self.collect_leaves("", &mut all);
        all.sort_by_key(|(_, entry): &(String, Entry)| entry.node.span.start);
        all
    }

    fn collect_leaves(&self, before: &str, all: &mut Vec<(String, Entry<'a>)>) {
        let table: &'a Table = self.table;
        for (key, _, node) in table {
            let path = format!("{before}{key}");
            match &node.value {
                Value::Table(inner) if !inner.iter().any(|(key, ..)| key == "from") => {
                    Section { table: inner, ..*self }.collect_leaves(&format!("{path}."), all);
                }
                _ => all.push((path.clone(), Entry { key: format!("{}.{path}", self.name), text: self.text, node })),
            }
        }
    }

    /// The value of a key that must be there; `expected` is what it should be.
    pub fn need(&self, key: &'static str, expected: &str) -> Result<Entry<'a>, ConfigError> {
        let missing = || ConfigError::MissingKey { section: self.called(), key, expected: expected.to_string() };
        self.get(key).ok_or_else(missing)
    }

    /// An exact number with a default.
    pub fn exact_or(&self, key: &str, default: i64) -> Result<Rational, ConfigError> {
        self.get(key).map_or(Ok(Rational::from_integer(default.into())), |entry| entry.finite())
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
    node: &'a Node,
}

impl<'a> Entry<'a> {
    /// A problem of this value.
    pub fn problem(&self, problem: impl Into<Problem>) -> ConfigError {
        let line = line_of(self.text, self.node.span.start);
        ConfigError::Value { line, key: self.key.clone(), problem: problem.into() }
    }

    /// What is wrong at a byte of the text that is the value.
    pub fn in_text(&self, at: Option<usize>, problem: expressions::Problem) -> ConfigError {
        let span = self.node.span.clone();
        let written = self.text.get(span.clone()).unwrap_or_default();
        // Behind the quotes, where nothing in the text is written in another way than it reads.
        let inside = self.word().ok().and_then(|text| written.find(text)).filter(|_| at.is_some());
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
        let line = line_of(self.text, self.node.span.start);
        match &self.node.value {
            Value::Table(table) => Ok(Section { name, text: self.text, line, table }),
            _ => Err(self.shape("a table")),
        }
    }

    /// Whether the value is a list.
    pub fn is_list(&self) -> bool {
        matches!(self.node.value, Value::List(_))
    }

    /// Whether the value is a table.
    pub fn is_table(&self) -> bool {
        matches!(self.node.value, Value::Table(_))
    }

    /// The value as a text.
    pub fn word(&self) -> Result<&'a str, ConfigError> {
        match &self.node.value {
            Value::Text(text) => Ok(text),
            _ => Err(self.shape("a text in quotes")),
        }
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
        match self.node.value {
            Value::Flag(flag) => Ok(flag),
            _ => Err(self.shape("true or false")),
        }
    }

    /// The value as an exact number: an integer, a decimal, or a text such as `"1/2"`.
    pub fn exact(&self) -> Result<Rational, ConfigError> {
        let text = match &self.node.value {
            Value::Text(text) | Value::Decimal(text) => text,
            Value::PutIn(number) => return Ok(number.clone()),
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
        let Value::List(list) = &self.node.value else { return Err(self.shape(expected)) };
        let entry = |(i, node)| Entry { key: format!("{}, entry {}", self.key, i + 1), text: self.text, node };
        Ok(list.iter().enumerate().map(entry).collect())
    }

    /// The value as an exact number that is not too large for a float.
    pub fn finite(&self) -> Result<Rational, ConfigError> {
        self.number()?;
        self.exact()
    }

    /// The numbers that were read from the value, if none is too large for a float.
    pub fn all_finite(&self, read: Result<Vec<Rational>, NumberError>) -> Result<Vec<Rational>, ConfigError> {
        let numbers = read.map_err(|error| self.problem(error))?;
        let finite = |q: &Rational| q.to_f64().is_some_and(f64::is_finite);
        if numbers.iter().all(finite) { Ok(numbers) } else { Err(self.problem(Problem::TooLarge)) }
    }

    /// A list of such numbers.
    pub fn exact_numbers(&self) -> Result<Vec<Rational>, ConfigError> {
        self.items("a list of numbers")?.iter().map(Entry::finite).collect()
    }

    /// A number for all followers of a platoon, or a list of one for each; a text may be a list, too, as on the command line and in questions.
    pub fn one_or_each(&self) -> Result<Vec<Rational>, ConfigError> {
        match self.word() {
            _ if self.is_list() => self.exact_numbers(),
            Ok(text) if text.contains(',') || text.contains(':') => self.all_finite(read_numbers(text)),
            _ => Ok(vec![self.finite()?]),
        }
    }

    /// A vector of the plane.
    pub fn vector(&self) -> Result<[Rational; 2], ConfigError> {
        let numbers = self.exact_numbers()?;
        let found = numbers.len();
        numbers.try_into().map_err(|_| self.problem(Problem::Coordinates { expected: 2, found }))
    }
}
