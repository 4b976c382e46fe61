//! `reproduce`: tables and figures of the papers.

use super::{CliError, interrupt, output, progress};
use flockproof::arithmetic::shown;
use flockproof::question::nearest_ids;
use flockproof::report::{FIGURES, Figure, FigureError, File, Provenance, digest, version};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(
    after_help = "The files of each figure are written as soon as it is made. reproduce.json beside them tells which are there, with the version and the \
digest of every file; --resume leaves those alone. `all` takes minutes.\n\n\
Examples:\n  flockproof reproduce veerman.table1 --out out\n  flockproof reproduce all --out out --resume"
)]
pub struct Arguments {
    /// What to reproduce: a name such as veerman.table1 or table1, or all
    #[arg(value_name = "WHAT")]
    what: String,
    /// Folder for the CSV, SVG and PNG files; it is made if it is missing
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Go on: make only what this version has not yet written to the folder
    #[arg(long)]
    resume: bool,
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
        0 => Err(CliError::Use(format!("there is no table or figure `{}`; {}", shown(what), instead(what)))),
        1 => Ok(named),
        _ => Err(CliError::Use(format!("`{what}` is ambiguous; it may be: {}", names(&named)))),
    }
}

/// What may be meant instead of a name that is not known: the nearest, or all where none is near.
fn instead(what: &str) -> String {
    let known = || FIGURES.iter().map(|figure| figure.name);
    match nearest_ids(known(), what, 3).as_slice() {
        [] => format!("there are: {}, all", known().collect::<Vec<_>>().join(", ")),
        near => format!("similar: {}", near.join(", ")),
    }
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let figures = chosen(&arguments.what)?;
    output::make_folder(&arguments.out)?;
    let mut manifest = Manifest::read(&arguments.out);
    let (kept, figures): (Vec<&Figure>, Vec<&Figure>) =
        figures.into_iter().partition(|figure| arguments.resume && manifest.holds(figure.name));
    if !kept.is_empty() {
        let names: Vec<&str> = kept.iter().map(|figure| figure.name).collect();
        let text = format!("there already, made by this version: {}", names.join(", "));
        output::print(&(textwrap::fill(&text, output::width().min(80)) + "\n\n"))?;
    }
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
    let bar = progress::bar();
    bar.set_length(figures.len() as u64);
    bar.set_message("figures");
    for (place, made) in made {
        texts.insert(place, written(figures[place], made, &mut manifest)?);
        while let Some(text) = texts.remove(&printed) {
            bar.suspend(|| output::print(&text))?;
            printed += 1;
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    interrupt::finishing();
    let count = printed + texts.len();
    for text in texts.values() {
        output::print(text)?;
    }
    if count < figures.len() {
        eprintln!("interrupted: {count} of {} are made, they are written; --resume makes the others", figures.len());
    }
    Ok(interrupt::status(count == figures.len()))
}

/// Writes the files of a figure and tells what they show and which claims are about it.
fn written(figure: &Figure, made: Made, manifest: &mut Manifest) -> Result<String, CliError> {
    let (text, files) = made.map_err(|error| CliError::Use(format!("{}: {error}", figure.name)))?;
    for file in &files {
        output::write_file(&manifest.folder.join(&file.name), &file.contents)?;
    }
    manifest.add(figure.name, &files)?;
    let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
    let (names, folder) = (names.join(", "), manifest.folder.display());
    let filled = |text: String| textwrap::fill(&text, output::width().min(80));
    let head = filled(format!("{}: {}", figure.name, figure.about));
    let claims = filled(format!("claims (flockproof explain ID): {}", figure.claims.join(", ")));
    let there = filled(format!("written: {names} in {folder}"));
    Ok(format!("{head}\n{claims}\n\n{text}{there}\n\n"))
}

/// `reproduce.json`: which figures are in a folder, by which version, with the digests of their files.
struct Manifest {
    folder: PathBuf,
    figures: BTreeMap<String, Value>,
}

const MANIFEST: &str = "reproduce.json";
const SCHEMA: &str = "flockproof.reproduce/1";

impl Manifest {
    /// That of a folder; empty where there is none, or one that cannot be read.
    fn read(folder: &Path) -> Self {
        let text = std::fs::read_to_string(folder.join(MANIFEST)).unwrap_or_default();
        let document: Value = serde_json::from_str(&text).unwrap_or_default();
        let rows = document["figures"].as_object().cloned().unwrap_or_default();
        Manifest { folder: folder.to_path_buf(), figures: rows.into_iter().collect() }
    }

    /// Whether this version made the figure, and all its files are as they were written.
    fn holds(&self, name: &str) -> bool {
        let Some(row) = self.figures.get(name).filter(|row| row["version"] == version()) else { return false };
        let unchanged = |(file, expected): (&String, &Value)| {
            std::fs::read(self.folder.join(file)).is_ok_and(|bytes| *expected == digest(&bytes))
        };
        row["files"].as_object().is_some_and(|files| !files.is_empty() && files.iter().all(unchanged))
    }

    /// Adds a figure and writes what there is.
    fn add(&mut self, name: &str, files: &[File]) -> Result<(), CliError> {
        let digests: BTreeMap<&str, String> =
            files.iter().map(|file| (file.name.as_str(), digest(&file.contents))).collect();
        let provenance = Provenance::new(SCHEMA, None, json!({"command": "reproduce", "figure": name}));
        let claims = FIGURES.iter().find(|figure| figure.name == name).map_or(&[][..], |figure| figure.claims);
        let row = provenance.stamp(json!({"files": digests, "claims": claims}));
        self.figures.insert(name.to_string(), row);
        let document = json!({"schema": SCHEMA, "figures": self.figures});
        output::write_file(&self.folder.join(MANIFEST), format!("{document:#}\n").as_bytes())
    }
}
