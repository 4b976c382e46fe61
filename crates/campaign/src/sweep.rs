//! Tables: the quantities of a question for every member of its family.

use crate::job::{Campaign, JobError};
use arithmetic::{Interval, Progress, Real, decimals};
use question::{Margin, Number, Question, QuestionError, Region, Tabulated, Truth};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

/// Digits of enclosures.
const DIGITS: u32 = 20;

/// Bits of a rational multiple of pi.
const BITS: u32 = 128;

/// What the names of a member stand for, and its values.
type Member = (Map<String, Value>, Vec<Value>);

/// The table of one question.
pub struct Sweep {
    question: Question,
    cases: u64,
    maps: bool,
}

/// Why a property that is decided has no finite margin.
const COMPARES_NOTHING: &str = "no margin: what decides compares no numbers";

/// Boxes of one map.
const MOST_REGIONS: u64 = 2000;

impl Sweep {
    /// Counts the members of the family.
    ///
    /// # Errors
    /// [`QuestionError`] where the family is wrong, empty or larger than the budget.
    pub fn new(question: Question, progress: &dyn Progress) -> Result<Self, QuestionError> {
        let cases = question.cases(progress)?;
        Ok(Sweep { question, cases, maps: false })
    }

    /// With the regions of each member where the property holds, fails and is open, for a question of one or two intervals.
    ///
    /// # Errors
    /// A sentence where the question has no property, or other than one or two intervals.
    pub fn with_maps(mut self, progress: &dyn Progress) -> Result<Self, String> {
        let needed = "a map needs a property in [holds], and one or two names that range over an interval, none over `integers(a, b)`";
        let first = self.question.case(0, progress).map_err(|error| error.to_string())?;
        let boxes = first.iter().flat_map(|first| first.iter()).filter(|(_, value)| value.ends().is_some());
        let boxes: Vec<bool> = boxes.map(|(_, value)| value.is_interval()).collect();
        if !self.question.has_property() || !(1..=2).contains(&boxes.len()) || boxes.contains(&false) {
            return Err(needed.to_string());
        }
        self.maps = true;
        Ok(self)
    }

    /// The boxes of one member: `[{"box": {name: [lo, hi]}, "property": "holds" | "fails" | "open"}]`.
    fn regions(&self, case: u64, progress: &dyn Progress) -> Result<Value, QuestionError> {
        let Some(member) = self.question.case(case, progress)? else { return Ok(Value::Null) };
        let ends = |(name, value): (&str, &question::Value)| match value {
            question::Value::Box(range) => {
                Some((name.to_string(), json!([range.lo.to_string(), range.hi.to_string()])))
            }
            _ => None,
        };
        let region = |region: &Region| {
            let sides: Map<String, Value> = region.bindings.iter().filter_map(ends).collect();
            json!({"box": sides, "property": region.standing.word()})
        };
        let regions = self.question.regions(&member, MOST_REGIONS, progress)?;
        Ok(regions.iter().map(region).collect::<Vec<_>>().into())
    }

    /// What stands in the columns: the values of the question, or whether its property holds.
    fn columns(&self) -> Vec<String> {
        let values: Vec<String> = self.question.value_names().map(str::to_string).collect();
        if values.is_empty() { vec!["holds".to_string(), "margin".to_string()] } else { values }
    }

    fn values(&self, case: u64, progress: &dyn Progress) -> Result<Option<Member>, QuestionError> {
        let Some(bindings) = self.question.case(case, progress)? else { return Ok(None) };
        let names = bindings.iter().map(|(name, value)| (name.to_string(), value.text().into())).collect();
        match self.question.is_kept(&bindings, progress) {
            Ok(true) => {}
            Ok(false) => return Ok(None),
            // Whether it is a member is not known: a row that says so.
            Err(QuestionError::At { problem, .. }) => {
                let unknown = json!({"unknown": problem.to_string()});
                return Ok(Some((names, vec![unknown; self.columns().len()])));
            }
            Err(cancelled) => return Err(cancelled),
        }
        let values = if self.question.value_names().next().is_some() {
            self.question.values(&bindings, self.cases, progress)?.iter().map(|(_, value)| tabulated(value)).collect()
        } else {
            let (truth, margin) = self.question.tabulated(&bindings, self.cases, progress)?;
            let (truth, why) = match truth {
                Truth::True => (json!(true), COMPARES_NOTHING.to_string()),
                Truth::False => (json!(false), COMPARES_NOTHING.to_string()),
                Truth::Unknown(doubt) => (json!({"unknown": doubt.why}), doubt.why),
            };
            let ends = Margin::decimals(&margin).map(|(lo, hi)| json!({"lo": lo, "hi": hi}));
            vec![truth, ends.unwrap_or_else(|| json!({"unknown": why}))]
        };
        Ok(Some((names, values)))
    }
}

/// An exact number as `"p/q"`, an enclosed one as `{"lo", "hi"}`, truths as they are, what is not known as `{"unknown": why}`.
fn tabulated(value: &Tabulated) -> Value {
    let enclosed = |x: &Interval| {
        let (lo, hi) = decimals(x, DIGITS);
        json!({"lo": lo, "hi": hi})
    };
    match value {
        Tabulated::Number(Number::Exact(q)) => q.to_string().into(),
        Tabulated::Number(Number::Turns(q)) => {
            let like = Interval::from_rational(q, BITS);
            enclosed(&(like.pi() * &like))
        }
        Tabulated::Number(Number::Enclosed(x, ..) | Number::Beyond(_, x)) => enclosed(x),
        Tabulated::Truth(truth) => (*truth).into(),
        Tabulated::Unknown(why) => json!({"unknown": why}),
    }
}

impl Campaign for Sweep {
    fn canonical(&self) -> String {
        let names: Vec<&str> = self.question.bound_names().collect();
        let (question, columns) = (self.question.canonical(), self.columns());
        let mut sweep = json!({"id": self.question.id(), "names": names, "columns": columns, "question": question});
        if self.maps {
            sweep["maps"] = MOST_REGIONS.into();
        }
        json!({"sweep": sweep}).to_string()
    }

    fn cases(&self) -> u64 {
        self.cases
    }

    /// `{"names": {..}, "values": [..]}`, with `"regions"` where there are maps, or null for a member that `where` leaves out.
    fn run(&self, case: u64, progress: &dyn Progress) -> Result<Value, JobError> {
        let row = self.values(case, progress).and_then(|found| match found {
            None => Ok(Value::Null),
            Some((names, values)) if self.maps => {
                Ok(json!({"names": names, "values": values, "regions": self.regions(case, progress)?}))
            }
            Some((names, values)) => Ok(json!({"names": names, "values": values})),
        });
        match row {
            Ok(row) => Ok(row),
            Err(QuestionError::Cancelled(cancelled)) => Err(JobError::Cancelled(cancelled)),
            Err(error) => Err(JobError::Refused(error.to_string())),
        }
    }
}

/// A row of a table: what the names stand for, the values, and the regions of its map, null without one.
#[derive(Debug, Clone, PartialEq)]
pub struct TableRow {
    /// What the names stand for.
    pub names: Vec<String>,
    /// The quantities.
    pub values: Vec<Value>,
    /// `[{"box": {name: [lo, hi]}, "property": "holds" | "fails" | "open"}]`.
    pub regions: Value,
}

/// A finished table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// The id of the question.
    pub id: String,
    /// The names of the family.
    pub names: Vec<String>,
    /// The quantities.
    pub columns: Vec<String>,
    /// A row for each member.
    pub rows: Vec<TableRow>,
}

/// A store that is not one of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("it holds no table of `sweep`")]
pub struct NoTable;

impl Table {
    /// From the canonical text of the sweep and its results.
    ///
    /// # Errors
    /// [`NoTable`].
    pub fn new(canonical: &str, results: &BTreeMap<u64, Value>) -> Result<Self, NoTable> {
        let value: Value = serde_json::from_str(canonical).map_err(|_| NoTable)?;
        let sweep = &value["sweep"];
        let list = |name: &str| -> Option<Vec<String>> {
            sweep[name].as_array()?.iter().map(|text| text.as_str().map(str::to_string)).collect()
        };
        let (Some(id), Some(names), Some(columns)) = (sweep["id"].as_str(), list("names"), list("columns")) else {
            return Err(NoTable);
        };
        let mut rows = Vec::new();
        for row in results.values().filter(|row| !row.is_null()) {
            let named = names.iter().map(|name| row["names"][name].as_str().map(str::to_string));
            let named: Vec<String> = named.collect::<Option<_>>().ok_or(NoTable)?;
            let values = row["values"].as_array().filter(|values| values.len() == columns.len()).ok_or(NoTable)?;
            rows.push(TableRow { names: named, values: values.clone(), regions: row["regions"].clone() });
        }
        Ok(Table { id: id.to_string(), names, columns, rows })
    }

    /// One JSON object on a line for each member, names and values side by side.
    pub fn json_lines(&self) -> String {
        let row = |row: &TableRow| {
            let names = self.names.iter().cloned().zip(row.names.iter().map(|text| text.as_str().into()));
            let mut all: Map<String, Value> =
                names.chain(self.columns.iter().cloned().zip(row.values.clone())).collect();
            if !row.regions.is_null() {
                all.insert("regions".to_string(), row.regions.clone());
            }
            Value::from(all).to_string() + "\n"
        };
        self.rows.iter().map(row).collect()
    }

    /// CSV: a column for each name and each value, and two, the ends, for a value that is enclosed somewhere. What is not known is empty; where there is such a
    /// cell, a last column `reason` says why it is.
    ///
    /// # Errors
    /// [`csv::Error`] where a row has not as many cells as there are names and columns, which those of a sweep have.
    pub fn csv(&self) -> Result<String, csv::Error> {
        let has_ends = |value: &Value| value["lo"].is_string();
        let enclosed = |k: usize| self.rows.iter().any(|row| row.values.get(k).is_some_and(has_ends));
        let enclosed: Vec<bool> = (0..self.columns.len()).map(enclosed).collect();
        let mut writer = csv::Writer::from_writer(Vec::new());
        let column = |(name, enclosed): (&String, &bool)| match enclosed {
            true => vec![format!("{name}.lo"), format!("{name}.hi")],
            false => vec![name.clone()],
        };
        let columns = self.columns.iter().zip(&enclosed).flat_map(column);
        let reasons: Vec<String> = self.rows.iter().map(|row| self.reason(row)).collect();
        let has_reasons = reasons.iter().any(|reason| !reason.is_empty());
        let last = has_reasons.then(|| self.reason_name());
        writer.write_record(self.names.iter().cloned().chain(columns).chain(last))?;
        for (TableRow { names, values, .. }, reason) in self.rows.iter().zip(reasons) {
            let cells = values.iter().zip(&enclosed).flat_map(|(value, enclosed)| cells(value, *enclosed));
            writer.write_record(names.iter().cloned().chain(cells).chain(has_reasons.then_some(reason)))?;
        }
        let bytes = writer.into_inner().map_err(|error| error.into_error())?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    }

    /// Why cells of a row are empty, the columns with the same reason together; empty where none is.
    fn reason(&self, row: &TableRow) -> String {
        let mut all: Vec<(&str, Vec<&str>)> = Vec::new();
        for (name, value) in self.columns.iter().zip(&row.values) {
            let Some(why) = value["unknown"].as_str() else { continue };
            match all.iter_mut().find(|(known, _)| *known == why) {
                Some((_, names)) => names.push(name),
                None => all.push((why, vec![name])),
            }
        }
        all.iter().map(|(why, names)| format!("{}: {why}", names.join(", "))).collect::<Vec<_>>().join("; ")
    }

    /// The name of the column of reasons, which no other has.
    fn reason_name(&self) -> String {
        let is_taken = |name: &String| self.names.contains(name) || self.columns.contains(name);
        let names = std::iter::successors(Some("reason".to_string()), |name| Some(format!("{name}_")));
        names.into_iter().find(|name| !is_taken(name)).unwrap_or_default()
    }

    /// An aligned text of at most so many rows, at most so wide: columns that do not fit stand below, beside the names again. What is not known is `?`, with
    /// the reason at the end.
    pub fn text(&self, most: usize, width: usize) -> String {
        let mut reasons: Vec<&str> = Vec::new();
        let shown_rows = || self.rows.iter().take(most);
        for row in shown_rows() {
            for value in &row.values {
                if let Some(why) = value["unknown"].as_str().filter(|why| !reasons.contains(why)) {
                    reasons.push(why);
                }
            }
        }
        let mark = |why: &str| match reasons.iter().position(|known| *known == why) {
            Some(k) if reasons.len() > 1 => format!("?{}", k + 1),
            _ => "?".to_string(),
        };
        let shown = |value: &Value| match value {
            Value::String(text) => text.clone(),
            Value::Bool(truth) => truth.to_string(),
            Value::Null => String::new(),
            other => match (other["lo"].as_str(), other["hi"].as_str()) {
                (Some(lo), Some(hi)) if lo == hi => lo.to_string(),
                (Some(lo), Some(hi)) => common_digits(lo, hi),
                _ => mark(other["unknown"].as_str().unwrap_or_default()),
            },
        };
        let names = self.names.iter().enumerate().map(|(k, name)| {
            let cells = shown_rows().map(|row| row.names.get(k).map_or("", String::as_str));
            [name.as_str()].into_iter().chain(cells).map(ToString::to_string).collect::<Vec<_>>()
        });
        let columns = self.columns.iter().enumerate().map(|(k, name)| {
            let cells = shown_rows().map(|row| row.values.get(k).map_or(String::new(), &shown));
            std::iter::once(name.clone()).chain(cells).collect::<Vec<_>>()
        });
        // A graph is never cut: one that takes half of the line stands at its end.
        let is_long = |column: &Vec<String>| column.iter().any(|cell| cell.chars().count() > width / 2);
        let (long, names): (Vec<_>, Vec<_>) = names.partition(is_long);
        let mut text = beside(&names, &columns.collect::<Vec<_>>(), &long, width);
        if self.rows.len() > most {
            text.push_str(&format!("and {} more rows\n", self.rows.len() - most));
        }
        for why in &reasons {
            text.push_str(&format!("{}: {why}\n", mark(why)));
        }
        text
    }
}

/// Columns one beside the other, each flush right; those that do not fit below, beside the first ones again. The last ones stand behind every line, flush left,
/// however wide they are.
fn beside(names: &[Vec<String>], columns: &[Vec<String>], last: &[Vec<String>], width: usize) -> String {
    let room = |column: &Vec<String>| 2 + column.iter().map(|cell| cell.chars().count()).max().unwrap_or(0);
    let first: usize = names.iter().map(room).sum();
    let mut blocks: Vec<Vec<&Vec<String>>> = vec![Vec::new()];
    let mut used = first;
    for column in columns {
        let fits = used + room(column) <= width + 2;
        if !fits && blocks.last().is_some_and(|block| !block.is_empty()) {
            blocks.push(Vec::new());
            used = first;
        }
        used += room(column);
        if let Some(block) = blocks.last_mut() {
            block.push(column);
        }
    }
    let mut text = String::new();
    for (k, block) in blocks.iter().enumerate() {
        let all: Vec<&Vec<String>> = names.iter().chain(block.iter().copied()).collect();
        let lines = all.iter().map(|column| column.len()).max().unwrap_or(0);
        text.push_str(if k > 0 { "\n" } else { "" });
        for line in 0..lines {
            let cell = |column: &&Vec<String>| format!("{:>1$}", column[line], room(column) - 2);
            let flush_left = last.iter().filter_map(|column| column.get(line)).cloned();
            let cells: Vec<String> = all.iter().map(cell).chain(flush_left).collect();
            text.push_str(cells.join("  ").trim_end());
            text.push('\n');
        }
    }
    text
}

fn cells(value: &Value, enclosed: bool) -> Vec<String> {
    let both = |text: &str| vec![text.to_string(); if enclosed { 2 } else { 1 }];
    match value {
        Value::String(text) => both(text),
        Value::Bool(truth) => both(&truth.to_string()),
        other => match (other["lo"].as_str(), other["hi"].as_str()) {
            (Some(lo), Some(hi)) => vec![lo.to_string(), hi.to_string()],
            _ => both(""),
        },
    }
}

/// The digits that both ends of an enclosure have, and `..`; both ends where these are few.
fn common_digits(lo: &str, hi: &str) -> String {
    let common: String = lo.chars().zip(hi.chars()).take_while(|(a, b)| a == b).map(|(a, _)| a).take(14).collect();
    let digits = common.chars().filter(char::is_ascii_digit).count();
    if digits >= 6 && common.contains('.') && !lo.contains('e') {
        format!("{common}..")
    } else {
        format!("[{lo}, {hi}]")
    }
}
