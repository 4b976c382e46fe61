//! Simulated scenarios and measured trajectories.

use super::convert::{count, optional_count};
use super::refuse;
use super::watch::{Watch, watched};
use flockproof::report::{Known, Provenance, TracksReport, digest};
use flockproof::scenario::{End, Ensemble, Outcome, Row, Scenario, with_law};
use flockproof::tracks::{
    BridgeShape, Choices, ChoicesError, Format, NearestRule, PositionsUsed, Smoothing, Tracks, analyse, delays, named,
};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use serde_json::json;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The scenario of a text, with the files that it may name: of many runs the member, from 1, which has to be named.
fn scenario(text: &str, files: &BTreeMap<String, String>, member: Option<u64>) -> Result<Scenario, String> {
    let file = |name: &str| files.get(name).cloned().ok_or_else(|| format!("there is no file `{name}`"));
    let whole = with_law(text, &file).map_err(|error| error.to_string())?;
    let told = |error: flockproof::scenario::ConfigError| whole.told(&error);
    let text = whole.text();
    match (Ensemble::read(text).map_err(told)?, member) {
        (None, None) => Scenario::read(text).map_err(told),
        (None, Some(_)) => {
            Err("member is for many runs, and the scenario has neither [ensemble] nor [sweep]".to_string())
        }
        (Some(ensemble), member) => {
            let count = ensemble.members();
            let member =
                member.ok_or(format!("the scenario makes {count} runs: choose one of them, member=1 to {count}"))?;
            let place = member.checked_sub(1).filter(|place| *place < count);
            let place = place.ok_or(format!("member: there are the runs 1 to {count}"))?;
            ensemble.member(place).map_err(told)
        }
    }
}

/// The files that a scenario names: of its law, of its graph. What else is wrong is told when it is read.
#[pyfunction]
pub fn named_files(text: &str) -> Vec<String> {
    flockproof::scenario::named_files(text)
}

/// Runs a scenario that is given as TOML; arrays over all times that are written.
#[pyfunction]
pub fn simulate<'py>(
    py: Python<'py>,
    text: &str,
    files: BTreeMap<String, String>,
    member: Option<&Bound<'py, PyAny>>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let text = text.to_string();
    let member = optional_count("member", member)?;
    let run = move |watch: &Arc<Watch>| scenario(&text, &files, member).map(|scenario| scenario.run(&**watch));
    let outcome = watched(py, progress, run)?.map_err(refuse)?;
    if let End::Failed(error) = &outcome.end {
        return Err(refuse(format!("{error}; t = {} was reached", outcome.reached())));
    }
    let found = PyDict::new(py);
    found.set_item("model", outcome.model)?;
    found.set_item("declaration", outcome.declaration.join("\n"))?;
    found.set_item("remarks", &outcome.remarks)?;
    found.set_item("t", numbers(py, &outcome, |row| vec![row.time])?.call_method0("ravel")?)?;
    let sampled: Vec<bool> = outcome.rows.iter().map(|row| row.sample).collect();
    found.set_item("sampled", PyArray1::from_vec(py, sampled))?;
    found.set_item("states", states(py, &outcome)?)?;
    found.set_item("observables", observables(py, &outcome)?)?;
    let events: Vec<_> = outcome.events.iter().map(|e| (e.time, e.gained, e.pair)).collect();
    found.set_item("events", events)?;
    Ok(found)
}

/// An array with a row for each time.
fn numbers<'py>(py: Python<'py>, outcome: &Outcome, row: impl Fn(&Row) -> Vec<f64>) -> PyResult<Bound<'py, PyAny>> {
    let rows: Vec<Vec<f64>> = outcome.rows.iter().map(row).collect();
    let (height, width) = (rows.len(), rows.iter().map(Vec::len).max().unwrap_or(0));
    let mut all = Vec::with_capacity(height * width);
    for mut row in rows {
        // Lists differ in length only where a number does not exist.
        row.resize(width, f64::NAN);
        all.extend(row);
    }
    Ok(PyArray1::from_vec(py, all).reshape([height, width])?.into_any())
}

/// What each agent has, by its name; vectors as times x agents x coordinates.
fn states<'py>(py: Python<'py>, outcome: &Outcome) -> PyResult<Bound<'py, PyDict>> {
    let states = PyDict::new(py);
    let Some(first) = outcome.rows.first() else { return Ok(states) };
    for (place, (name, part)) in first.frame.parts().into_iter().enumerate() {
        let flat =
            numbers(py, outcome, |row| row.frame.parts().get(place).map_or_else(Vec::new, |(_, part)| part.flat()))?;
        let shaped = match part.width() {
            None => flat,
            Some(width) => flat.call_method1("reshape", ((outcome.rows.len(), first.frame.agents(), width),))?,
        };
        states.set_item(name, shaped)?;
    }
    Ok(states)
}

fn observables<'py>(py: Python<'py>, outcome: &Outcome) -> PyResult<Bound<'py, PyDict>> {
    use flockproof::scenario::Value;
    let observables = PyDict::new(py);
    let Some(first) = outcome.rows.first() else { return Ok(observables) };
    for (place, observable) in first.observables.iter().enumerate() {
        let values = |row: &Row| -> Vec<f64> {
            row.observables.get(place).map_or_else(Vec::new, |o| o.columns().into_iter().map(|(_, x)| x).collect())
        };
        let table = numbers(py, outcome, values)?;
        let list = matches!(observable.value, Value::List(_));
        let table = if list { table } else { table.call_method0("ravel")? };
        observables.set_item(observable.name.as_ref(), table)?;
    }
    Ok(observables)
}

/// The choices of the command line.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Chosen {
    columns: Vec<String>,
    fps: Option<f64>,
    part: Option<String>,
    score: f64,
    max_gap: u64,
    bridge: String,
    min_fish: Option<usize>,
    smoothing: String,
    window: Option<usize>,
    smooth_positions: bool,
    body_length: f64,
    unit: Option<String>,
    times_from: String,
    body_length_from: String,
    zones: Vec<f64>,
    blind: f64,
    still: f64,
    plain_nearest: bool,
    nearest: Vec<usize>,
    delays: Option<f64>,
    ids: Option<Vec<String>>,
    seed: String,
    pictures: bool,
}

/// More shifts than this say nothing more.
const MOST_SHIFTS: u64 = 100_000;

type Files<'py> = Vec<(String, Bound<'py, PyBytes>)>;

/// The text for the terminal, and the files of `tracks`.
#[pyfunction]
pub fn tracks<'py>(
    py: Python<'py>,
    text: &str,
    source: String,
    chosen: Chosen,
    null: &Bound<'py, PyAny>,
    at: Option<f64>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<(String, Files<'py>)> {
    let shifts = count("null", null)?;
    if shifts > MOST_SHIFTS {
        return Err(refuse(format!("null = {shifts} is more than {MOST_SHIFTS} shifts")));
    }
    let format = Format::new(&chosen.columns, chosen.fps).map_err(refuse)?.of_parts(chosen.part.clone(), chosen.score);
    let mut tracks = Tracks::from_table(text, &format).map_err(refuse)?;
    if let Some(ids) = &chosen.ids {
        tracks = tracks.only(ids).map_err(refuse)?;
    }
    let (_, shape) = named(&BridgeShape::ALL, &chosen.bridge)
        .map_err(|error| refuse(format!("bridge = `{}`: {error}", chosen.bridge)))?;
    let tracks = tracks.bridge(chosen.max_gap, shape);
    let choices = choices(&chosen, &tracks)?;
    choices.check(tracks.fish()).map_err(|error| wrong(&error))?;
    let configuration = json!({
        "command": "tracks", "file": {"name": source, "sha256": digest(text.as_bytes())}, "columns": chosen.columns,
        "fps": chosen.fps, "part": chosen.part, "score": chosen.score, "max_gap": chosen.max_gap, "bridge": chosen.bridge, "min_fish": chosen.min_fish, "ids": chosen.ids,
        "smoothing": chosen.smoothing, "window": chosen.window, "smooth_positions": chosen.smooth_positions, "body_length": chosen.body_length,
        "zones": chosen.zones, "blind": chosen.blind, "still": chosen.still, "plain_nearest": chosen.plain_nearest,
        "nearest": chosen.nearest, "delays": chosen.delays, "null": shifts, "at": at,
    });
    let work = move |watch: &Arc<Watch>| {
        let analysis = analyse(&tracks, &choices, &**watch).map_err(|error| error.to_string())?;
        let null =
            analysis.null_models(shifts as usize, &chosen.seed, &**watch).map_err(|stopped| stopped.to_string())?;
        let found = chosen.delays.map(|seconds| delays(&tracks, &analysis.motion, seconds, &**watch)).transpose();
        let found = found.map_err(|error| error.to_string())?;
        let report = TracksReport {
            source: &source,
            tracks: &tracks,
            analysis: &analysis,
            null: null.as_ref(),
            delays: found.as_ref(),
            snapshot_at: at,
            known: Known {
                unit: chosen.unit.as_deref().or(tracks.form.unit()),
                times: &chosen.times_from,
                body_length: &chosen.body_length_from,
            },
        };
        let mut files = report.tables(&Provenance::new("flockproof.tracks/1", Some(&chosen.seed), configuration));
        if chosen.pictures {
            files.extend(report.pictures().map_err(|error| error.to_string())?);
        }
        Ok::<_, String>((report.text(), files))
    };
    let (text, files) = watched(py, progress, work)?.map_err(refuse)?;
    Ok((text, files.into_iter().map(|file| (file.name, PyBytes::new(py, &file.contents))).collect()))
}

/// A choice that makes no sense, with its name.
fn wrong(error: &ChoicesError) -> PyErr {
    refuse(match error.choice() {
        Some(choice) => format!("{choice}: {error}"),
        None => error.to_string(),
    })
}

fn choices(chosen: &Chosen, tracks: &Tracks) -> PyResult<Choices> {
    let zones = Choices::radii_of_zones(&chosen.zones).map_err(|error| wrong(&error))?;
    let (_, smoothing) = named(&Smoothing::ALL, &chosen.smoothing)
        .map_err(|error| refuse(format!("smoothing = `{}`: {error}", chosen.smoothing)))?;
    Ok(Choices {
        smoothing,
        window: chosen.window.unwrap_or(Choices::of_sidebar(tracks.step).window),
        positions: if chosen.smooth_positions { PositionsUsed::Smoothed } else { PositionsUsed::File },
        body_length: chosen.body_length,
        zones,
        blind: chosen.blind,
        still: chosen.still,
        rule: if chosen.plain_nearest { NearestRule::Nearest } else { NearestRule::SecondInRepulsion },
        nearest: chosen.nearest.clone(),
        min_fish: chosen.min_fish,
    })
}
