//! `reproduce`: tables and figures of the papers.

use super::{CliError, output};
use flockproof::report::{FIGURES, Figure};
use rayon::prelude::*;
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(clap::Args)]
pub struct Arguments {
    /// What to reproduce: a name such as veerman.table1, or all
    #[arg(value_name = "WHAT")]
    what: String,
    /// Folder for the CSV, SVG and PNG files; it is made if it is missing
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// The figures that are asked for.
fn chosen(what: &str) -> Result<Vec<&'static Figure>, CliError> {
    if what == "all" {
        return Ok(FIGURES.iter().collect());
    }
    let names = |figures: &[&Figure]| figures.iter().map(|figure| figure.name).collect::<Vec<_>>().join(", ");
    let named = Figure::named(what);
    match named.len() {
        0 => {
            let known = names(&FIGURES.iter().collect::<Vec<_>>());
            Err(CliError::Use(format!("there is no table or figure `{what}`; there are: {known}, all")))
        }
        1 => Ok(named),
        _ => Err(CliError::Use(format!("`{what}` is ambiguous; it may be: {}", names(&named)))),
    }
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let figures = chosen(&arguments.what)?;
    std::fs::create_dir_all(&arguments.out).map_err(|error| CliError::file(&arguments.out, error))?;
    let made: Vec<_> = figures.par_iter().map(|figure| figure.reproduce()).collect();
    for (figure, made) in figures.into_iter().zip(made) {
        let (text, files) = made.map_err(|error| CliError::Use(format!("{}: {error}", figure.name)))?;
        for file in &files {
            output::write_file(&arguments.out.join(&file.name), &file.contents)?;
        }
        let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
        let (names, folder) = (names.join(", "), arguments.out.display());
        output::print(&format!("{}: {}\n\n{text}written: {names} in {folder}\n\n", figure.name, figure.about))?;
    }
    Ok(ExitCode::SUCCESS)
}
