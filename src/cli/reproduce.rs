//! `reproduce`: tables and figures of the papers.

use super::{CliError, output};
use flockproof::report::{svg_to_png, table1};
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(clap::Args)]
pub struct Arguments {
    /// What to reproduce: table1, or all
    #[arg(value_name = "WHAT")]
    what: String,
    /// Folder for the CSV, SVG and PNG files; it is made if it is missing
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// What can be reproduced.
const KNOWN: [&str; 1] = ["table1"];

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    if arguments.what != "all" && !KNOWN.contains(&arguments.what.as_str()) {
        let known = KNOWN.join(", ");
        return Err(CliError::Use(format!(
            "there is no table or figure `{}`; there are: {known}, all",
            arguments.what
        )));
    }
    std::fs::create_dir_all(&arguments.out).map_err(|error| CliError::file(&arguments.out, error))?;
    let refuse = |error: &dyn std::fmt::Display| CliError::Use(error.to_string());
    let table = table1().map_err(|error| refuse(&error))?;
    let svg = table.svg().map_err(|error| refuse(&error))?;
    let png = svg_to_png(&svg).map_err(|error| refuse(&error))?;
    output::write_file(&arguments.out.join("table1.csv"), table.csv().as_bytes())?;
    output::write_file(&arguments.out.join("table1.svg"), svg.as_bytes())?;
    output::write_file(&arguments.out.join("table1.png"), &png)?;
    output::print(&table.text())?;
    output::print(&format!("written: table1.csv, table1.svg, table1.png in {}\n", arguments.out.display()))?;
    Ok(ExitCode::SUCCESS)
}
