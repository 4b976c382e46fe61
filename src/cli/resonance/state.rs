//! The response of a system that is given by its state matrices.

use super::super::{CliError, output, progress};
use super::Arguments;
use super::peak::Found;
use super::responses::Responses;
use flockproof::arithmetic::{Rational, Unwatched, parse_rational};
use flockproof::platoon::bode::enclosed;
use flockproof::platoon::state_space::StateSpace;
use flockproof::platoon::{MOST_STATES_PROVED, peak_of_system};
use flockproof::report::{Provenance, digest};
use serde_json::{Map, Value, json};
use std::path::Path;
use std::process::ExitCode;

/// Most states; a frequency costs their cube.
const MOST_STATES: usize = 400;

type Rows = Vec<Vec<Rational>>;

/// NAME.csv or NAME.npy in a folder, with what it came from.
fn matrix(folder: &Path, name: &str) -> Result<Option<(Rows, Value)>, CliError> {
    let (text, array) = (folder.join(format!("{name}.csv")), folder.join(format!("{name}.npy")));
    if text.exists() {
        let input = output::read_input(&text)?;
        let rows = from_csv(&input.text).map_err(|why| CliError::file(&text, why))?;
        return Ok(Some((rows, input.origin)));
    }
    if array.exists() {
        let bytes = std::fs::read(&array).map_err(|error| CliError::file(&array, output::sentence(&error)))?;
        let rows = from_npy(&bytes).map_err(|why| CliError::file(&array, why))?;
        return Ok(Some((rows, json!({"name": format!("{name}.npy"), "sha256": digest(&bytes)}))));
    }
    Ok(None)
}

/// A row on each line, numbers with commas, semicolons or spaces between them, read exactly.
fn from_csv(text: &str) -> Result<Rows, String> {
    let mut rows = Rows::new();
    for (line, number) in text.lines().zip(1..).filter(|(line, _)| !line.trim().is_empty()) {
        let cells = line.split([',', ';', ' ', '\t']).filter(|cell| !cell.is_empty());
        let row = cells.map(parse_rational).collect::<Result<_, _>>();
        rows.push(row.map_err(|error| format!("line {number}: {error}"))?);
    }
    Ok(rows)
}

/// A two-dimensional array of doubles in NumPy's format, each taken as the exact value of that double.
fn from_npy(bytes: &[u8]) -> Result<Rows, String> {
    let wrong = || "it is no two-dimensional array of little-endian doubles (numpy.save of float64)".to_string();
    let long = match bytes.get(..8) {
        Some(b"\x93NUMPY\x01\x00") => false,
        Some(b"\x93NUMPY\x02\x00" | b"\x93NUMPY\x03\x00") => true,
        _ => return Err(wrong()),
    };
    let at = |k: usize| bytes.get(k).map(|byte| usize::from(*byte)).ok_or_else(wrong);
    let (start, length) = match long {
        false => (10, at(8)? + 256 * at(9)?),
        true => (12, at(8)? + 256 * at(9)? + 65536 * at(10)?),
    };
    let header = bytes.get(start..start + length).ok_or_else(wrong)?;
    let header: String = String::from_utf8_lossy(header).split_whitespace().collect();
    let shape = header.split("'shape':(").nth(1).and_then(|rest| rest.split(')').next()).ok_or_else(wrong)?;
    let shape: Vec<usize> = shape.split(',').filter_map(|length| length.parse().ok()).collect();
    let ([rows, columns], true) = (&shape[..], header.contains("'descr':'<f8'")) else { return Err(wrong()) };
    let by_columns = header.contains("'fortran_order':True");
    let data = &bytes[start + length..];
    if rows.checked_mul(*columns).and_then(|count| count.checked_mul(8)) != Some(data.len()) {
        return Err(wrong());
    }
    let number = |i: usize, j: usize| {
        let place = if by_columns { j * rows + i } else { i * columns + j };
        let bytes: [u8; 8] = data[8 * place..8 * place + 8].try_into().map_err(|_| wrong())?;
        let value = f64::from_le_bytes(bytes);
        Rational::from_float(value).ok_or_else(|| format!("row {}, column {}: {value} is not a number", i + 1, j + 1))
    };
    (0..*rows).map(|i| (0..*columns).map(|j| number(i, j)).collect()).collect()
}

/// The peak with proof, or searched among more states.
fn found(system: &StateSpace, digits: u32) -> Result<Found, String> {
    if system.states() <= MOST_STATES_PROVED {
        return Found::proved(peak_of_system(system, digits, &Unwatched)).map_err(|error| error.to_string());
    }
    let peak = system.searched_peak().map_err(|error| format!("the response does not exist: {error}"))?;
    let how = format!(
        "48 frequencies for each factor of 10 and around each eigenvalue, in floating point ({} states are more than the {MOST_STATES_PROVED} of which the \
         peak is proved)",
        system.states()
    );
    Ok(Found::Searched { peak, how })
}

/// What `--response` and `--plot` show.
fn responses<'a>(system: &'a StateSpace, found: &Found) -> Responses<'a> {
    let exact = |w: &Rational, digits: u32| enclosed(w, digits, |w| Ok(vec![system.response(w)?]));
    let small = system.states() <= MOST_STATES_PROVED;
    Responses {
        names: vec!["y".to_string()],
        enclosed: if small { Some(Box::new(exact)) } else { None },
        float: Box::new(|w| Ok(vec![system.float_response(w)?])),
        peaks: found.place().into_iter().collect(),
        proved: matches!(found, Found::Certified(_)),
        stable: found.stable(),
    }
}

pub fn run(arguments: &Arguments, folder: &Path) -> Result<ExitCode, CliError> {
    if !folder.is_dir() {
        return Err(CliError::file(folder, "there is no such folder with A.csv, B.csv and C.csv, or .npy"));
    }
    let mut origins = Map::new();
    let mut read = |name: &str| -> Result<Option<Rows>, CliError> {
        let Some((rows, origin)) = matrix(folder, name)? else { return Ok(None) };
        origins.insert(name.to_string(), origin);
        Ok(Some(rows))
    };
    let missing = |name: &str| CliError::file(folder, format!("there is neither {name}.csv nor {name}.npy in it"));
    let a = read("A")?.ok_or_else(|| missing("A"))?;
    let b = read("B")?.ok_or_else(|| missing("B"))?;
    let c = read("C")?.ok_or_else(|| missing("C"))?;
    let d = read("D")?;
    let refuse = |error: &dyn std::fmt::Display| CliError::file(folder, error);
    if a.len() > MOST_STATES {
        return Err(refuse(&format!("{} states are more than {MOST_STATES}", a.len())));
    }
    let system = StateSpace::new(&a, &b, &c, d.as_deref()).map_err(|error| refuse(&error))?;
    let bar = progress::spinner("searching the peak");
    let found = found(&system, arguments.digits);
    bar.finish_and_clear();
    let found = found.map_err(|why| refuse(&why))?;
    let responses = responses(&system, &found);
    let written = responses.draw(arguments, &format!("{} states of {}", system.states(), folder.display()), "")?;
    let table = responses.table(arguments)?;
    let configuration =
        json!({"command": "resonance", "state": origins, "response": arguments.response, "digits": arguments.digits});
    let provenance = Provenance::new("flockproof.state-response/1", None, configuration);
    if arguments.json {
        let mut document = json!({
            "states": system.states(), "inputs": b[0].len(),
            "peak": found.document(arguments.digits),
            "stable": found.stable(),
        });
        if let Some((rows, _)) = table {
            document["response"] = rows;
        }
        return output::print_json(&provenance.stamp(document)).map(|()| ExitCode::SUCCESS);
    }
    let input = if b[0].len() == 2 { "position and velocity" } else { "position" };
    let head = format!("{} states, the leader's {input} as input", system.states());
    let text = found.text(&head, arguments.digits, None) + &table.map_or(String::new(), |(_, table)| table);
    output::print_folded(&(text + &written))?;
    Ok(ExitCode::SUCCESS)
}
