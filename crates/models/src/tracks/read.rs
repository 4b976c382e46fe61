//! Reading trajectories: CSV with the columns `t,id,x,y` or others by name, rows and columns in any order, other columns ignored.

use super::times::Clock;
use super::trackers::{self, Form};
use super::{BridgeShape, Gap, Vector};
use arithmetic::Complex;
use std::collections::{BTreeMap, HashMap};

/// The columns that are needed: time, name of the fish, position.
const COLUMNS: [&str; 4] = ["t", "id", "x", "y"];

/// How a table is read.
#[derive(Debug, Clone, PartialEq)]
pub struct Format {
    /// What the columns of time, name, x and y are called in the header.
    columns: [String; 4],
    /// Frames per second: then the column of time holds numbers of frames. Seconds without it.
    pub(super) fps: Option<f64>,
    /// The body part that stands for a fish; the mean of those that were seen without it.
    pub(super) part: Option<String>,
    /// Body parts with a smaller score are not seen.
    pub(super) least_score: f64,
}

/// Why a format cannot be used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FormatError {
    /// Not `NAME=t` or the like.
    #[error("`{0}` is not NAME=t, NAME=id, NAME=x or NAME=y, where NAME is a column of the header")]
    Column(String),
    /// One of the four is said twice.
    #[error("two columns are to be {0}")]
    Twice(&'static str),
    /// Not a positive number.
    #[error("{0} frames per second are not a positive number")]
    Rate(f64),
}

impl Default for Format {
    fn default() -> Self {
        Format { columns: COLUMNS.map(str::to_string), fps: None, part: None, least_score: 0.0 }
    }
}

impl Format {
    /// Columns by name, such as `frame=t` and `particle=id`, and frames per second where times are numbers of frames.
    ///
    /// # Errors
    /// [`FormatError`].
    pub fn new<S: AsRef<str>>(columns: &[S], fps: Option<f64>) -> Result<Format, FormatError> {
        let mut format = Format { fps, ..Format::default() };
        let mut said = [false; 4];
        for text in columns {
            let wrong = || FormatError::Column(text.as_ref().to_string());
            let (name, meaning) = text.as_ref().rsplit_once('=').ok_or_else(wrong)?;
            let place = COLUMNS.iter().position(|column| *column == meaning.trim()).ok_or_else(wrong)?;
            if std::mem::replace(&mut said[place], true) {
                return Err(FormatError::Twice(COLUMNS[place]));
            }
            format.columns[place] = name.trim().to_string();
        }
        match fps {
            Some(rate) if !(rate > 0.0 && rate.is_finite()) => Err(FormatError::Rate(rate)),
            _ => Ok(format),
        }
    }

    /// The same with a body part that stands for a fish, the mean of all that were seen without one, of scores of at least `least_score`.
    pub fn of_parts(self, part: Option<String>, least_score: f64) -> Format {
        Format { part, least_score, ..self }
    }
}

/// Numbers beyond are refused, so that no square overflows.
pub(super) const LARGEST: f64 = 1e100;
/// How far, as a share of the frame step, a step may be from a multiple of it: times are often written with three decimals.
const JITTER: f64 = 0.1;
/// The same for a hole of many steps, as a share of its length: the step is known from rounded times only.
const HOLE_JITTER: f64 = 0.01;
/// More frames than this are never missing in one piece.
const LONGEST_GAP: f64 = 1e9;

/// Why a table holds no trajectories that can be analysed. Lines are counted from 1.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TracksError {
    /// Nothing, or a header only.
    #[error("there are no rows in it; a header with t,id,x,y and a row for each fish in each frame are expected")]
    Empty,
    /// A column is missing.
    #[error(
        "line 1: the header has no column `{column}`; t, id, x and y are needed, or others by name, and it has {found}"
    )]
    NoColumn {
        /// The column.
        column: String,
        /// The header.
        found: String,
    },
    /// A column is there twice.
    #[error("line 1: the header has the column `{0}` twice")]
    ColumnTwice(String),
    /// A row of another length than the header.
    #[error("line {line}: there are {found} fields where the header has {expected}")]
    Fields {
        /// The line.
        line: u64,
        /// How many fields it has.
        found: usize,
        /// How many the header has.
        expected: usize,
    },
    /// Not a number.
    #[error("line {line}: {column} is `{found}`, not a finite number; leave out the row where a fish was not seen")]
    Number {
        /// The line.
        line: u64,
        /// The column.
        column: String,
        /// The field.
        found: String,
    },
    /// Numbers of frames without their rate.
    #[error(
        "times are numbers of frames in a table of this form ({form}): say how many frames there are in a second (fps)"
    )]
    NoRate {
        /// The form.
        form: &'static str,
    },
    /// A column that is named after frames holds whole numbers, and nobody says their rate.
    #[error(
        "the column of times is called `{column}` and holds whole numbers, as of frames: say how many frames there are in a second (fps; 1 if these are seconds)"
    )]
    Numbered {
        /// The column.
        column: String,
    },
    /// Body parts or scores where there are none.
    #[error("a table of this form ({form}) has no body parts and no scores")]
    NoParts {
        /// The form.
        form: &'static str,
    },
    /// No part was seen surely enough.
    #[error("no body part that was seen has a score of at least {least}")]
    NoScore {
        /// The smallest score.
        least: f64,
    },
    /// A time that is no number of frames.
    #[error("line {line}: {column} is `{found}`, not a whole number of frames; leave fps out where times are seconds")]
    Fraction {
        /// The line.
        line: u64,
        /// The column.
        column: String,
        /// The field.
        found: String,
    },
    /// A time that is neither.
    #[error(
        "line {line}: {column} is `{found}`, neither a number nor a date such as 2024-05-01T12:00:00.04, as in the first row"
    )]
    Time {
        /// The line.
        line: u64,
        /// The column.
        column: String,
        /// The field.
        found: String,
    },
    /// A body part that is not there.
    #[error("there is no body part `{part}`; there are {known}")]
    NoPart {
        /// The part.
        part: String,
        /// Those that are there.
        known: String,
    },
    /// Not a date as in the first row.
    #[error("line {line}: {column} is `{found}`, not a date like that of the first row, such as {example}")]
    Date {
        /// The line.
        line: u64,
        /// The column.
        column: String,
        /// The field.
        found: String,
        /// A date that is written as in the first row.
        example: &'static str,
    },
    /// Dates where numbers of frames are said to be.
    #[error(
        "line {line}: {column} is the date `{found}`; frames per second are for numbers of frames, dates need none"
    )]
    DateAndRate {
        /// The line.
        line: u64,
        /// The column.
        column: String,
        /// The field.
        found: String,
    },
    /// A number that is too large.
    #[error("line {line}: {column} is {found}, beyond 1e100")]
    Large {
        /// The line.
        line: u64,
        /// The column.
        column: String,
        /// The field.
        found: String,
    },
    /// A fish without a name.
    #[error("line {0}: id is empty or has a control character")]
    NoId(u64),
    /// Two rows of one fish at one time.
    #[error("line {line}: fish {id} at t = {time} is there twice, first in line {first}")]
    Duplicate {
        /// The second line.
        line: u64,
        /// The first line.
        first: u64,
        /// The fish.
        id: String,
        /// The time.
        time: f64,
    },
    /// One fish.
    #[error("there is only one fish, {0}; at least two are needed")]
    OneFish(String),
    /// One frame.
    #[error("all rows have the same time t = {0}; at least three frames are needed")]
    OneFrame(f64),
    /// Times that are not on a grid.
    #[error(
        "line {line}: the frame times are not uniform: {step} from the frame before to t = {time}, but {usual} elsewhere"
    )]
    Uneven {
        /// The line where the frame starts.
        line: u64,
        /// Its time.
        time: f64,
        /// The time since the frame before.
        step: f64,
        /// The frame step of the others.
        usual: f64,
    },
    /// A fish that is asked for and is not there.
    #[error("there is no fish {id}; there are {known}")]
    UnknownFish {
        /// The fish.
        id: String,
        /// Those that are there.
        known: String,
    },
    /// An array of NumPy that is no recording.
    #[error("the array of NumPy cannot be read: {what}")]
    Array {
        /// Why.
        what: String,
    },
    /// A row that is not CSV.
    #[error("line {line}: {what}")]
    Csv {
        /// The line.
        line: u64,
        /// What the reader says.
        what: String,
    },
}

/// A frame that has a row: its number on the grid of times, from 0, and its time as written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Number on the grid; numbers that are skipped are frames without any row.
    pub number: u64,
    /// Time in seconds.
    pub time: f64,
}

/// Trajectories of at least two fish over at least two frames.
#[derive(Debug, Clone, PartialEq)]
pub struct Tracks {
    /// Names, in the order of numbers where all are numbers, else of the alphabet.
    pub ids: Vec<String>,
    /// Frames in order.
    pub frames: Vec<Frame>,
    /// Frame step in seconds: the mean over the recording.
    pub step: f64,
    /// `positions[fish][frame]`; `None` where the fish has no row.
    pub positions: Vec<Vec<Option<Vector>>>,
    /// The form of the table.
    pub form: Form,
    /// The body parts whose mean stands for a fish; none where the table has none.
    pub parts: Vec<String>,
    /// The gaps that were bridged; none in what is read.
    pub bridged: Vec<Gap>,
    /// How they were bridged.
    pub bridged_by: BridgeShape,
    /// The date of `t = 0` where the times of the file are dates: the first of them.
    pub start: Option<String>,
}

/// A fish in a frame of the table.
pub(super) struct Row {
    pub(super) line: u64,
    pub(super) time: f64,
    /// The time as a date, in nanoseconds.
    pub(super) date: Option<i128>,
    pub(super) id: String,
    pub(super) place: Vector,
}

impl Tracks {
    /// Reads a table.
    ///
    /// # Errors
    /// [`TracksError`], with the line.
    pub fn from_csv(text: &str) -> Result<Tracks, TracksError> {
        Tracks::from_table(text, &Format::default())
    }

    /// Reads a table with columns of other names, or times in frames.
    ///
    /// # Errors
    /// [`TracksError`], with the line.
    pub fn from_table(text: &str, format: &Format) -> Result<Tracks, TracksError> {
        let Table { mut rows, clock, form, parts } = rows(text, format)?;
        let column = &format.columns[0];
        let counted = form == Form::Rows && column.to_lowercase().starts_with("frame");
        if counted && format.fps.is_none() && rows.iter().all(|row| row.date.is_none() && row.time.fract() == 0.0) {
            return Err(TracksError::Numbered { column: column.clone() });
        }
        let first = rows.iter().filter_map(|row| row.date).min();
        for row in &mut rows {
            if let Some((first, date)) = first.zip(row.date) {
                row.time = (date - first) as f64 / 1e9;
            }
        }
        Ok(Tracks { form, parts, start: first.map(|first| clock.text(first)), ..Tracks::from_rows(&rows)? })
    }

    pub(super) fn from_rows(rows: &[Row]) -> Result<Tracks, TracksError> {
        let mut starts: Vec<(f64, u64)> = rows.iter().map(|row| (row.time, row.line)).collect();
        starts.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        starts.dedup_by(|later, first| later.0 == first.0);
        let mut ids: Vec<String> = rows.iter().map(|row| row.id.clone()).collect();
        ids.sort_by(|a, b| natural_order(a, b));
        ids.dedup();
        let number_of: BTreeMap<&str, usize> = ids.iter().enumerate().map(|(k, id)| (id.as_str(), k)).collect();
        let frame_of: HashMap<u64, usize> = starts.iter().enumerate().map(|(i, (t, _))| (t.to_bits(), i)).collect();
        let mut positions = vec![vec![None; starts.len()]; ids.len()];
        let mut lines = vec![vec![0; starts.len()]; ids.len()];
        for row in rows {
            let (fish, frame) = (number_of[row.id.as_str()], frame_of[&row.time.to_bits()]);
            if positions[fish][frame].replace(row.place.clone()).is_some() {
                let (line, first) = (row.line, lines[fish][frame]);
                return Err(TracksError::Duplicate { line, first, id: row.id.clone(), time: row.time });
            }
            lines[fish][frame] = row.line;
        }
        if let [only] = ids.as_slice() {
            return Err(TracksError::OneFish(only.clone()));
        }
        let (frames, step) = grid(&starts)?;
        Ok(Tracks {
            ids,
            frames,
            step,
            positions,
            form: Form::Rows,
            parts: vec![],
            bridged: vec![],
            bridged_by: BridgeShape::Line,
            start: None,
        })
    }

    /// Number of fish.
    pub fn fish(&self) -> usize {
        self.ids.len()
    }

    /// Whether there is a place in each frame for each fish, and frames are numbered in order: so it is of all that were read.
    pub(super) fn is_whole(&self) -> bool {
        self.positions.len() == self.fish()
            && self.positions.iter().all(|places| places.len() == self.frames.len())
            && self.frames.is_sorted_by(|a, b| a.number < b.number)
    }

    /// Frames from the first to the last, also those without any row.
    pub fn recorded_frames(&self) -> u64 {
        self.frames.last().map_or(0, |frame| frame.number.saturating_add(1))
    }

    /// The time of a frame number, also of one without rows.
    pub fn time_of(&self, number: u64) -> f64 {
        match self.frames.binary_search_by_key(&number, |frame| frame.number) {
            Ok(found) => self.frames[found].time,
            Err(_) => self.frames.first().map_or(0.0, |frame| frame.time) + number as f64 * self.step,
        }
    }

    /// The same recording with these fish only.
    ///
    /// # Errors
    /// [`TracksError::UnknownFish`], or [`TracksError::OneFish`] for fewer than two.
    pub fn only(&self, ids: &[String]) -> Result<Tracks, TracksError> {
        if let Some(id) = ids.iter().find(|id| !self.ids.contains(id)) {
            return Err(TracksError::UnknownFish { id: id.clone(), known: self.ids.join(", ") });
        }
        let kept: Vec<usize> = (0..self.fish()).filter(|&k| ids.contains(&self.ids[k])).collect();
        if let [only] = kept.as_slice() {
            return Err(TracksError::OneFish(self.ids[*only].clone()));
        }
        Ok(Tracks {
            ids: kept.iter().map(|&k| self.ids[k].clone()).collect(),
            frames: self.frames.clone(),
            step: self.step,
            positions: kept.iter().map(|&k| self.positions.get(k).cloned().unwrap_or_default()).collect(),
            bridged: kept
                .iter()
                .enumerate()
                .flat_map(|(fish, k)| {
                    let of_fish = self.bridged.iter().filter(move |gap| gap.fish == *k);
                    of_fish.map(move |gap| Gap { fish, ..gap.clone() })
                })
                .collect(),
            form: self.form,
            parts: self.parts.clone(),
            bridged_by: self.bridged_by,
            start: self.start.clone(),
        })
    }

    /// The recording up to so many of its frames.
    pub fn first(&self, frames: usize) -> Tracks {
        let mut first = self.clone();
        first.frames.truncate(frames);
        first.positions.iter_mut().for_each(|row| row.truncate(frames));
        // Of the bridges those that were reached, the last ones only as far.
        let end = first.recorded_frames();
        let reached = self.bridged.iter().filter(|gap| gap.first < end).map(|gap| {
            let frames = gap.frames.min(end - gap.first);
            Gap { frames, to: first.time_of(gap.first + frames - 1), ..gap.clone() }
        });
        first.bridged = reached.collect();
        first
    }

    /// The table again, sorted by time and fish.
    pub fn to_csv(&self) -> String {
        let mut text = String::from("t,id,x,y\n");
        for (i, frame) in self.frames.iter().enumerate() {
            for (id, places) in self.ids.iter().zip(&self.positions) {
                if let Some(Some(r)) = places.get(i) {
                    text.push_str(&format!("{},{},{},{}\n", frame.time, csv_field(id), r.re, r.im));
                }
            }
        }
        text
    }
}

/// What a table has: rows in the order of the file, how their times are written, its form, and the body parts that are used.
struct Table {
    rows: Vec<Row>,
    clock: Clock,
    form: Form,
    parts: Vec<String>,
}

fn rows(text: &str, format: &Format) -> Result<Table, TracksError> {
    let broken = |error: &csv::Error| TracksError::Csv {
        line: error.position().map_or(0, csv::Position::line),
        what: "it cannot be read as CSV".to_string(),
    };
    let mut reader = csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers().map_err(|error| broken(&error))?.clone();
    if header.is_empty() {
        return Err(TracksError::Empty);
    }
    let form = Form::of(&header, &format.columns);
    if form != Form::Rows {
        let mut records = vec![header];
        for record in reader.records() {
            records.push(record.map_err(|error| broken(&error))?);
        }
        let (rows, parts) = trackers::rows(form, &records, format)?;
        return Ok(Table { rows, clock: Clock::Numbers, form, parts });
    }
    if format.part.is_some() || format.least_score > 0.0 {
        return Err(TracksError::NoParts { form: form.words() });
    }
    let mut columns = [0; 4];
    for (place, column) in columns.iter_mut().zip(&format.columns) {
        let mut found = header.iter().enumerate().filter(|(_, name)| name == column).map(|(i, _)| i);
        *place = found.next().ok_or_else(|| no_column(column, &header))?;
        if found.next().is_some() {
            return Err(TracksError::ColumnTwice(column.clone()));
        }
    }
    let mut rows = Vec::new();
    let mut record = csv::StringRecord::new();
    let mut clock = None;
    while reader.read_record(&mut record).map_err(|error| broken(&error))? {
        let clock = *clock.get_or_insert_with(|| Clock::of(record.get(columns[0]).unwrap_or_default()));
        rows.push(row(&record, format, clock, &columns, header.len())?);
    }
    clock.map(|clock| Table { rows, clock, form, parts: vec![] }).ok_or(TracksError::Empty)
}

fn row(
    record: &csv::StringRecord,
    format: &Format,
    clock: Clock,
    columns: &[usize; 4],
    expected: usize,
) -> Result<Row, TracksError> {
    let line = record.position().map_or(0, csv::Position::line);
    if record.len() != expected {
        return Err(TracksError::Fields { line, found: record.len(), expected });
    }
    let field = |c: usize| record.get(columns[c]).unwrap_or_default();
    let number = |c: usize| number(record, columns[c], line, &format.columns[c]);
    let id = field(1).to_string();
    if id.is_empty() || id.contains(char::is_control) {
        return Err(TracksError::NoId(line));
    }
    let place = Complex::new(number(2)?, number(3)?);
    if clock == Clock::Numbers {
        return Ok(Row {
            line,
            time: time(record, columns[0], line, format, &format.columns[0])?,
            date: None,
            id,
            place,
        });
    }
    let (column, found) = (format.columns[0].clone(), shown(field(0), 40));
    match clock.date(field(0)) {
        Some(_) if format.fps.is_some() => Err(TracksError::DateAndRate { line, column, found }),
        Some(date) => Ok(Row { line, time: 0.0, date: Some(date), id, place }),
        None => Err(TracksError::Date { line, column, found, example: clock.example() }),
    }
}

/// That a column is missing, with the start of the header.
pub(super) fn no_column(column: &str, header: &csv::StringRecord) -> TracksError {
    let found = shown(&header.iter().collect::<Vec<_>>().join(","), 60);
    TracksError::NoColumn { column: column.to_string(), found }
}

/// A time in seconds; with frames per second it is a whole number of frames.
pub(super) fn time(
    record: &csv::StringRecord,
    column: usize,
    line: u64,
    format: &Format,
    name: &str,
) -> Result<f64, TracksError> {
    let (column_name, found) = (name.to_string(), shown(record.get(column).unwrap_or_default(), 40));
    match (number(record, column, line, name), format.fps) {
        (Err(TracksError::Number { .. }), _) => Err(TracksError::Time { line, column: column_name, found }),
        (Ok(time), Some(_)) if time.fract() != 0.0 => Err(TracksError::Fraction { line, column: column_name, found }),
        (time, fps) => Ok(time? / fps.unwrap_or(1.0)),
    }
}

/// A field as a number.
pub(super) fn number(record: &csv::StringRecord, column: usize, line: u64, name: &str) -> Result<f64, TracksError> {
    let field = record.get(column).unwrap_or_default();
    let (column, found) = (name.to_string(), shown(field, 40));
    match field.parse::<f64>() {
        // Without the negative zero, which is another time for a hash.
        Ok(x) if x.abs() <= LARGEST => Ok(x + 0.0),
        Ok(x) if x.is_finite() => Err(TracksError::Large { line, column, found }),
        _ => Err(TracksError::Number { line, column, found }),
    }
}

/// A name as a field of CSV.
pub fn csv_field(name: &str) -> String {
    if name.contains([',', '"', '\n', '\r']) { format!("\"{}\"", name.replace('"', "\"\"")) } else { name.to_string() }
}

/// The start of a field as part of a sentence.
pub(super) fn shown(field: &str, length: usize) -> String {
    field.chars().take(length).map(|c| if c.is_control() { '?' } else { c }).collect()
}

/// Numbers by value and before other names.
fn natural_order(a: &str, b: &str) -> std::cmp::Ordering {
    let key = |id: &str| id.parse::<u64>().unwrap_or(u64::MAX);
    key(a).cmp(&key(b)).then_with(|| a.cmp(b))
}

/// The frames on a uniform grid and its step, from the distinct times and their first lines.
fn grid(starts: &[(f64, u64)]) -> Result<(Vec<Frame>, f64), TracksError> {
    let steps: Vec<f64> = starts.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
    let mut sorted = steps.clone();
    sorted.sort_by(f64::total_cmp);
    let Some(&median) = sorted.get(steps.len().saturating_sub(1) / 2) else {
        return Err(TracksError::OneFrame(starts.first().map_or(0.0, |start| start.0)));
    };
    // The median of times with few decimals is rounded; the mean of the single steps is not.
    let single: Vec<f64> = steps.iter().copied().filter(|step| (step / median - 1.0).abs() <= 2.0 * JITTER).collect();
    let usual = single.iter().sum::<f64>() / single.len() as f64;
    let mut frames = vec![Frame { number: 0, time: starts[0].0 }];
    let mut number = 0;
    for (step, &(time, line)) in steps.iter().zip(&starts[1..]) {
        let times = (step / usual).round();
        let uneven =
            (step / usual - times).abs() > JITTER.max(HOLE_JITTER * times) || !(1.0..=LONGEST_GAP).contains(&times);
        if uneven {
            return Err(TracksError::Uneven { line, time, step: *step, usual });
        }
        number += times as u64;
        frames.push(Frame { number, time });
    }
    let step = (starts[starts.len() - 1].0 - starts[0].0) / number as f64;
    Ok((frames, step))
}
