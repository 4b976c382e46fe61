//! `sweep`: the quantities of a question for every member of its family.

mod picture;

use super::interrupt::{self, Watch};
use super::{CliError, check, output, progress};
use flockproof::campaign::store::{Shard, StoreError, merge, run_shard};
use flockproof::campaign::sweep::{Sweep, Table};
use flockproof::question::QuestionError;
use flockproof::report::{File, Provenance};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(
    override_usage = "flockproof sweep [OPTIONS] --store <DIR> <QUESTION.toml>\n       flockproof sweep [OPTIONS] --merge <DIR>",
    after_help = "A row for each member of the family. The folder gets table.csv and table.jsonl, with about.txt, which tells where they \
come from; finished members are kept as they are finished, so that a stopped sweep goes on with --resume.\n\n\
Examples:\n  flockproof sweep question.toml --store out --resume\n  \
flockproof sweep question.toml --store out --shard 2/8\n  flockproof sweep --merge out --json"
)]
pub struct Arguments {
    /// The question, a TOML file as notes/questions.md describes it
    #[arg(value_name = "QUESTION.toml", required_unless_present = "merge", requires = "store")]
    file: Option<PathBuf>,
    /// Folder for the finished members and the table
    #[arg(long, value_name = "DIR")]
    store: Option<PathBuf>,
    /// Only this part of the members, i/n with i from 1 to n
    #[arg(long, value_name = "i/n", requires = "store")]
    shard: Option<Shard>,
    /// Go on with what the folder has
    #[arg(long, requires = "store")]
    resume: bool,
    /// Put the shards of a folder together
    #[arg(long, value_name = "DIR", conflicts_with_all = ["file", "store", "shard", "resume"])]
    merge: Option<PathBuf>,
    /// Draw the regions in which the property holds, fails and is open, for a question of one or two intervals; they are in the JSON, too
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    /// Print one JSON object on a line for each member, as table.jsonl has them
    #[arg(long)]
    json: bool,
}

/// Rows of the table that is printed; the files have all.
const MOST_ROWS: usize = 40;

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    arguments.plot.as_deref().map_or(Ok(()), output::check_writable)?;
    if let Some(folder) = &arguments.merge {
        return merged(folder, arguments);
    }
    let (Some(path), Some(store)) = (&arguments.file, &arguments.store) else {
        return Err(CliError::Use("a question and a folder for its table are needed".to_string()));
    };
    let watch = Watch::with(progress::bar());
    let sweep = match Sweep::new(check::read(path)?, &watch) {
        Ok(sweep) => sweep,
        Err(QuestionError::Cancelled(_)) => return Ok(interrupt::status(false)),
        Err(error) => return Err(CliError::file(path, error)),
    };
    let sweep = match &arguments.plot {
        Some(_) => sweep.with_maps(&watch).map_err(|error| CliError::file(path, error))?,
        None => sweep,
    };
    let shard = arguments.shard.unwrap_or(Shard::WHOLE);
    let run = run_shard(&sweep, store, shard, arguments.resume, &watch).map_err(|error| match error {
        StoreError::Refused { why, .. } => CliError::file(path, why),
        other => CliError::Use(other.to_string()),
    })?;
    interrupt::finishing();
    watch.finish();
    if !run.is_complete() {
        eprintln!("interrupted: {} of {} members are finished; --resume goes on", run.rows.len(), run.cases);
        return Ok(interrupt::status(false));
    }
    if shard == Shard::WHOLE {
        return merged(store, arguments);
    }
    output::print(&format!("shard {shard} is finished: {} members\n", run.cases))?;
    Ok(ExitCode::SUCCESS)
}

/// The question in its canonical form is all that a table depends on.
fn provenance(canonical: &str) -> Provenance {
    let campaign: Value = serde_json::from_str(canonical).unwrap_or_else(|_| canonical.into());
    Provenance::new("flockproof.sweep/1", None, json!({"command": "sweep", "campaign": campaign}))
}

/// Writes the table as CSV and JSON lines, and the picture, and prints the beginning of the table.
fn merged(folder: &Path, arguments: &Arguments) -> Result<ExitCode, CliError> {
    let merged = merge(folder).map_err(|error| CliError::Use(error.to_string()))?;
    let table = Table::new(&merged.header.campaign, &merged.rows).map_err(|error| CliError::file(folder, error))?;
    let csv = table.csv().map_err(|error| CliError::file(folder, error))?;
    let csv = File { name: "table.csv".to_string(), contents: csv.into_bytes() };
    let about = provenance(&merged.header.campaign).about(std::slice::from_ref(&csv));
    output::write_file(&folder.join(&csv.name), &csv.contents)?;
    output::write_file(&folder.join("about.txt"), about.as_bytes())?;
    if let Some(file) = &arguments.plot {
        let picture = picture::picture(&table).map_err(|error| CliError::file(folder, error))?;
        output::write_file(file, picture.svg().as_bytes())?;
    }
    let lines = table.json_lines();
    output::write_file(&folder.join("table.jsonl"), lines.as_bytes())?;
    if arguments.json {
        output::print_raw(&lines)
    } else {
        let files = ["table.csv", "table.jsonl", "about.txt"].map(|name| folder.join(name));
        let written = files.iter().chain(&arguments.plot).map(|file| file.display().to_string());
        let written = written.collect::<Vec<_>>().join(", ");
        output::print_folded(&format!("{}written: {written}\n", table.text(MOST_ROWS, output::width())))
    }?;
    Ok(ExitCode::SUCCESS)
}
