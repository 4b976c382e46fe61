//! `reproduce`: tables and figures of the papers.

use super::{CliError, interrupt, output};
use flockproof::report::{FIGURES, Figure, FigureError, File};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
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

/// What comes of a figure: its text and files.
type Made = Result<(String, Vec<File>), FigureError>;

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
    let work = figures.clone();
    let made = interrupt::results(move |sender| {
        work.par_iter().enumerate().for_each_with(sender, |sender, (place, figure)| {
            // Nobody listens any more after a signal.
            let _ = sender.send((place, figure.reproduce()));
        });
    });
    // Files are written as soon as their figure is made; texts are printed in the order of the figures.
    let mut texts: BTreeMap<usize, String> = BTreeMap::new();
    let mut printed = 0;
    for (place, made) in made {
        texts.insert(place, written(figures[place], made, &arguments.out)?);
        while let Some(text) = texts.remove(&printed) {
            output::print(&text)?;
            printed += 1;
        }
    }
    interrupt::finishing();
    let count = printed + texts.len();
    for text in texts.values() {
        output::print(text)?;
    }
    if count < figures.len() {
        eprintln!("interrupted: {count} of {} are made, they are written", figures.len());
    }
    Ok(interrupt::status(count == figures.len()))
}

/// Writes the files of a figure and tells what they show.
fn written(figure: &Figure, made: Made, folder: &Path) -> Result<String, CliError> {
    let (text, files) = made.map_err(|error| CliError::Use(format!("{}: {error}", figure.name)))?;
    for file in &files {
        output::write_file(&folder.join(&file.name), &file.contents)?;
    }
    let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
    let (names, folder) = (names.join(", "), folder.display());
    let claims = textwrap::fill(&format!("claims: {}", figure.claims.join(", ")), 80);
    Ok(format!("{}: {}\n\n{text}{claims}\nwritten: {names} in {folder}\n\n", figure.name, figure.about))
}
