//! Tables as trackers write them: all fish in one row (idtracker.ai), body parts (DeepLabCut, SLEAP), other names of columns (trackpy, Ctrax).

use super::Vector;
use super::read::{Format, Row, TracksError, no_column, number, time};
use arithmetic::Complex;
use csv::StringRecord;

/// How a table is laid out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// A row for each fish in each frame.
    Rows,
    /// A row for each frame with `x1, y1, x2, y2, ..` after the time: idtracker.ai.
    Wide,
    /// A row for each frame under lines that begin with `scorer`, `individuals`, `bodyparts`, `coords`: DeepLabCut.
    DeepLabCut,
    /// A row for each fish in each frame with `track`, `frame_idx` and `NAME.x, NAME.y, NAME.score` of each body part: SLEAP.
    Sleap,
    /// A row for each fish in each frame with `frame, time, individual, x, y`: idtracker.ai.
    Tidy,
    /// A row for each particle in each frame with `frame, particle, x, y`: trackpy.
    Trackpy,
    /// A row for each fly in each frame with `timestamp` or `frame` and `identity, x_pos, y_pos`: Ctrax.
    Ctrax,
    /// An array of NumPy, of shape (frames, fish, 2).
    Array,
}

impl Form {
    /// By the first line; a table with all the columns that are looked for has a row for each fish.
    pub(super) fn of(header: &StringRecord, columns: &[String]) -> Form {
        let has = |name: &str| header.iter().any(|field| field == name);
        if columns.iter().all(|column| has(column)) {
            Form::Rows
        } else if header.get(0) == Some("scorer") {
            Form::DeepLabCut
        } else if has("track") && has("frame_idx") {
            Form::Sleap
        } else if has("x1") && has("y1") {
            Form::Wide
        } else if ["time", "individual", "x", "y"].into_iter().all(has) {
            Form::Tidy
        } else if ["frame", "particle", "x", "y"].into_iter().all(has) {
            Form::Trackpy
        } else if ["identity", "x_pos", "y_pos"].into_iter().all(has) {
            Form::Ctrax
        } else {
            Form::Rows
        }
    }

    /// The unit of the positions, where the software that writes this form has one.
    pub fn unit(self) -> Option<&'static str> {
        match self {
            Form::Rows | Form::Array => None,
            Form::Wide | Form::Tidy | Form::DeepLabCut | Form::Sleap | Form::Trackpy | Form::Ctrax => Some("pixels"),
        }
    }

    /// As part of what is printed.
    pub fn words(self) -> &'static str {
        match self {
            Form::Rows => "a row for each fish in each frame",
            Form::Wide => "all fish in one row, as idtracker.ai writes it",
            Form::DeepLabCut => "body parts of DeepLabCut",
            Form::Sleap => "body parts of SLEAP",
            Form::Tidy => "a row for each fish in each frame, as idtracker.ai writes it",
            Form::Trackpy => "a row for each particle in each frame, as trackpy writes it",
            Form::Ctrax => "a row for each fly in each frame, as Ctrax writes it",
            Form::Array => "an array of NumPy",
        }
    }
}

/// The columns of one body part, or of a fish where there are none.
struct Part {
    name: String,
    x: usize,
    y: usize,
    score: Option<usize>,
}

/// Where a table has what.
struct Layout {
    form: Form,
    /// The column of time.
    time: usize,
    /// Whether it counts frames whatever it is called.
    in_frames: bool,
    /// The column of names, where a row is of one fish.
    name: Option<usize>,
    /// Fish by name; one without a name where a row is of one fish.
    fish: Vec<(String, Vec<Part>)>,
}

/// The rows of a table in such a form, and the body parts that are used.
pub(super) fn rows(
    form: Form,
    records: &[StringRecord],
    format: &Format,
) -> Result<(Vec<Row>, Vec<String>), TracksError> {
    let (layout, data) = match form {
        Form::DeepLabCut => deep_lab_cut(records)?,
        Form::Sleap => (sleap(&records[0])?, &records[1..]),
        Form::Tidy => (named(form, &records[0], &["time"], ["individual", "x", "y"])?, &records[1..]),
        Form::Trackpy => (named(form, &records[0], &["frame"], ["particle", "x", "y"])?, &records[1..]),
        Form::Ctrax => {
            let times = ["timestamp", "timestamps", "time", "t", "frame"];
            (named(form, &records[0], &times, ["identity", "x_pos", "y_pos"])?, &records[1..])
        }
        Form::Wide | Form::Rows | Form::Array => (wide(&records[0])?, &records[1..]),
    };
    let parts = || layout.fish.iter().flat_map(|(_, parts)| parts);
    let mut known: Vec<String> = parts().map(|part| part.name.clone()).filter(|name| !name.is_empty()).collect();
    known.sort();
    known.dedup();
    if known.is_empty() && (format.part.is_some() || format.least_score > 0.0) {
        return Err(TracksError::NoParts { form: form.words() });
    }
    if let Some(part) = format.part.as_ref().filter(|part| !parts().any(|known| known.name == **part)) {
        return Err(TracksError::NoPart { part: part.clone(), known: known.join(", ") });
    }
    if layout.in_frames && format.fps.is_none() {
        return Err(TracksError::NoRate { form: layout.form.words() });
    }
    let mut rows = Vec::new();
    for record in data {
        let line = record.position().map_or(0, csv::Position::line);
        if record.len() != records[0].len() {
            return Err(TracksError::Fields { line, found: record.len(), expected: records[0].len() });
        }
        let time = time(record, layout.time, line, format, "the time")?;
        for (name, parts) in &layout.fish {
            let id = layout.name.and_then(|column| record.get(column)).unwrap_or(name).to_string();
            if id.is_empty() || id.contains(char::is_control) {
                return Err(TracksError::NoId(line));
            }
            let chosen = parts.iter().filter(|part| format.part.as_ref().is_none_or(|name| part.name == *name));
            let seen =
                chosen.map(|part| place(record, part, line, format.least_score)).collect::<Result<Vec<_>, _>>()?;
            let seen: Vec<Vector> = seen.into_iter().flatten().collect();
            if !seen.is_empty() {
                let sum = seen.iter().fold(Complex::new(0.0, 0.0), |sum, r| sum + r);
                rows.push(Row { line, time, date: None, id, place: sum.scale(&(1.0 / seen.len() as f64)) });
            }
        }
    }
    if rows.is_empty() {
        let least = format.least_score;
        return Err(if data.is_empty() || known.is_empty() {
            TracksError::Empty
        } else {
            TracksError::NoScore { least }
        });
    }
    known.retain(|name| format.part.as_ref().is_none_or(|part| part == name));
    Ok((rows, known))
}

/// Where a part is, if it was seen surely enough; trackers leave fields empty or write nan where it was not.
fn place(record: &StringRecord, part: &Part, line: u64, least: f64) -> Result<Option<Vector>, TracksError> {
    let missing =
        |column: usize| record.get(column).is_none_or(|field| field.is_empty() || field.eq_ignore_ascii_case("nan"));
    if missing(part.x) || missing(part.y) {
        return Ok(None);
    }
    let unsure = match part.score {
        Some(column) if !missing(column) => number(record, column, line, "the score")? < least,
        _ => false,
    };
    let place = Complex::new(number(record, part.x, line, "x")?, number(record, part.y, line, "y")?);
    Ok((!unsure).then_some(place))
}

/// `time, x1, y1, x2, y2, ..`; a column of frames is called `frame`.
fn wide(header: &StringRecord) -> Result<Layout, TracksError> {
    let column = |name: &str| header.iter().position(|field| field == name);
    let times = ["time", "t", "seconds", "frame"];
    let Some(time) = times.into_iter().find_map(column) else {
        return Err(no_column("time", header));
    };
    let fish = (1..).map_while(|k: usize| {
        let (x, y) = (column(&format!("x{k}"))?, column(&format!("y{k}"))?);
        Some((k.to_string(), vec![Part { name: String::new(), x, y, score: None }]))
    });
    let in_frames = header.get(time) == Some("frame");
    Ok(Layout { form: Form::Wide, time, in_frames, name: None, fish: fish.collect() })
}

/// A row for each fish in each frame, with such names of the columns; of the times the first that is there, and `frame` counts frames.
fn named(form: Form, header: &StringRecord, times: &[&str], columns: [&str; 3]) -> Result<Layout, TracksError> {
    let column = |name: &str| header.iter().position(|field| field == name);
    let found = times.iter().find_map(|&name| Some((name, column(name)?)));
    let (called, time) = found.ok_or_else(|| no_column(times[0], header))?;
    let [name, x, y] = columns.map(|name| column(name).ok_or_else(|| no_column(name, header)));
    let part = Part { name: String::new(), x: x?, y: y?, score: None };
    Ok(Layout { form, time, in_frames: called == "frame", name: Some(name?), fish: vec![(String::new(), vec![part])] })
}

/// `track, frame_idx, instance.score, NAME.x, NAME.y, NAME.score, ..`.
fn sleap(header: &StringRecord) -> Result<Layout, TracksError> {
    let column = |name: &str| header.iter().position(|field| field == name);
    let part = |(x, field): (usize, &str)| {
        let name = field.strip_suffix(".x")?.to_string();
        let y = column(&format!("{name}.y"))?;
        Some(Part { score: column(&format!("{name}.score")), name, x, y })
    };
    let parts: Vec<Part> = header.iter().enumerate().filter_map(part).collect();
    if parts.is_empty() {
        return Err(no_column("NAME.x", header));
    }
    let time = column("frame_idx").ok_or_else(|| no_column("frame_idx", header))?;
    Ok(Layout { form: Form::Sleap, time, in_frames: true, name: column("track"), fish: vec![(String::new(), parts)] })
}

/// Lines of names above the data: `scorer`, with several animals `individuals`, `bodyparts`, `coords`.
fn deep_lab_cut(records: &[StringRecord]) -> Result<(Layout, &[StringRecord]), TracksError> {
    let line = |name: &str| records.iter().take(4).position(|record| record.get(0) == Some(name));
    let missing =
        |column: &str| TracksError::NoColumn { column: column.to_string(), found: "lines of DeepLabCut".to_string() };
    let parts = line("bodyparts").ok_or_else(|| missing("bodyparts"))?;
    let coordinates = line("coords").ok_or_else(|| missing("coords"))?;
    let individuals = line("individuals");
    let field = |row: usize, column: usize| records[row].get(column).unwrap_or_default();
    let owner = |column: usize| individuals.map_or("1", |row| field(row, column));
    let mut fish: Vec<(String, Vec<Part>)> = Vec::new();
    for x in (1..records[0].len()).filter(|&x| field(coordinates, x) == "x") {
        let same = |column: usize| owner(column) == owner(x) && field(parts, column) == field(parts, x);
        let beside = |name: &str| (1..records[0].len()).find(|&c| same(c) && field(coordinates, c) == name);
        let Some(y) = beside("y") else { return Err(missing("y")) };
        let part = Part { name: field(parts, x).to_string(), x, y, score: beside("likelihood") };
        match fish.iter_mut().find(|(name, _)| name == owner(x)) {
            Some((_, parts)) => parts.push(part),
            None => fish.push((owner(x).to_string(), vec![part])),
        }
    }
    let layout = Layout { form: Form::DeepLabCut, time: 0, in_frames: true, name: None, fish };
    Ok((layout, &records[coordinates + 1..]))
}
