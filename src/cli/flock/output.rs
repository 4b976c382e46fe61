//! Switches and flocks as text and JSON; birds are counted from 1.

use super::super::{CliError, output};
use flockproof::averaging::Switch;
use flockproof::graph::Graph;
use num_bigint::BigInt;
use serde_json::{Value, json};
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

fn from_one(pairs: &[(usize, usize)]) -> Vec<[usize; 2]> {
    pairs.iter().map(|&(i, j)| [i + 1, j + 1]).collect()
}

/// One switch as JSON.
pub fn switch_json(switch: &Switch) -> Value {
    json!({"t": switch.time.to_string(), "gained": from_one(&switch.gained), "lost": from_one(&switch.lost)})
}

/// The flocks of a network, birds from 1.
pub fn flocks(network: &Graph) -> Vec<Vec<usize>> {
    network.components().into_iter().map(|c| c.into_iter().map(|i| i + 1).collect()).collect()
}

/// A long number with its middle left out.
pub fn shortened(t: &BigInt) -> String {
    let digits = t.to_string();
    if digits.len() <= 40 {
        return digits;
    }
    format!("{}...{} ({} digits)", &digits[..12], &digits[digits.len() - 12..], digits.len())
}

/// Switches as lines of text, with what they do to the flocks.
pub struct SwitchLine {
    /// Flocks of the network before.
    flocks: usize,
}

impl SwitchLine {
    pub fn new(network: &Graph) -> Self {
        SwitchLine { flocks: network.component_numbers().1 }
    }

    /// The next switch, with the network after it.
    pub fn of(&mut self, switch: &Switch, after: &Graph) -> String {
        let edges = |sign: &str, pairs: &[(usize, usize)]| -> String {
            pairs.iter().map(|(i, j)| format!(" {sign}{}-{}", i + 1, j + 1)).collect()
        };
        let (old, new) = (self.flocks, after.component_numbers().1);
        self.flocks = new;
        let what = match old.cmp(&new) {
            std::cmp::Ordering::Greater => format!("  flocks merge: {old} -> {new}"),
            std::cmp::Ordering::Less => format!("  flocks split: {old} -> {new}"),
            std::cmp::Ordering::Equal => String::new(),
        };
        format!("t = {}{}{}{what}\n", shortened(&switch.time), edges("+", &switch.gained), edges("-", &switch.lost))
    }
}

/// Where events go as they happen: one JSON object per line in a file, so that an interrupted run leaves all of them.
pub struct Log {
    file: Option<(PathBuf, File)>,
}

impl Log {
    pub fn new(path: Option<&Path>) -> Result<Self, CliError> {
        let open = |path: &Path| {
            output::check_writable(path)?;
            File::create(path).map_err(|error| CliError::file(path, output::sentence(&error)))
        };
        let file = path.map(|path| open(path).map(|file| (path.to_path_buf(), file))).transpose()?;
        Ok(Log { file })
    }

    pub fn write(&mut self, event: &Value) -> Result<(), CliError> {
        let Some((path, file)) = &mut self.file else { return Ok(()) };
        writeln!(file, "{event}").map_err(|error| CliError::file(path, output::sentence(&error)))
    }
}

/// Prints a line where the output is text.
pub fn tell(json: bool, line: &str) -> Result<(), CliError> {
    if json { Ok(()) } else { output::print(line) }
}
