//! `report`: the site, a page for every claim.

use super::interrupt::{self, Watch};
use super::{CliError, output, progress, texts, verify};
use flockproof::json;
use flockproof::ledger::{Document, Options, to_json_with};
use flockproof::report::{FIGURES, Figure, Made, Page, Site, ledger_origin};
use rayon::prelude::*;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(clap::Args)]
pub struct Arguments {
    /// Folder for the site; it is made if it is missing
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// A ledger that `verify --json` wrote; without it all claims are checked first
    #[arg(long, value_name = "LEDGER.json")]
    ledger: Option<PathBuf>,
    /// Leave out the tables and figures
    #[arg(long)]
    no_figures: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    output::make_folder(&arguments.out)?;
    let Some(pages) = pages(arguments.ledger.as_deref(), !arguments.no_figures)? else {
        return Ok(ExitCode::from(interrupt::STATUS));
    };
    interrupt::finishing();
    let folders: BTreeSet<PathBuf> =
        pages.iter().filter_map(|page| Some(arguments.out.join(Path::new(&page.path).parent()?))).collect();
    for folder in &folders {
        std::fs::create_dir_all(folder).map_err(|error| CliError::file(folder, error))?;
    }
    for page in &pages {
        output::write_file(&arguments.out.join(&page.path), &page.contents)?;
    }
    let (count, index) = (pages.len(), arguments.out.join("index.html"));
    output::print(&format!("{count} pages and files; begin with {}\n", index.display()))?;
    Ok(ExitCode::SUCCESS)
}

/// Every page of the site; none if the run was interrupted.
pub fn pages(path: Option<&Path>, figures: bool) -> Result<Option<Vec<Page>>, CliError> {
    let ledger = verify::ledger()?;
    let Some(document) = document(path, &ledger)? else { return Ok(None) };
    let Some(figures) = made(if figures { FIGURES.iter().collect() } else { Vec::new() })? else { return Ok(None) };
    let pages = Site::new(&document, &ledger, &figures, texts::text).pages();
    pages.map(Some).map_err(|error| CliError::Use(error.to_string()))
}

/// The ledger of a file, or a new one; none if the run was interrupted.
fn document(path: Option<&Path>, ledger: &flockproof::ledger::Ledger) -> Result<Option<Document<'static>>, CliError> {
    let text = match path {
        Some(path) => output::read_input(path)?.text,
        None => {
            let ids = ledger.select(&[], &[]).map_err(|error| verify::use_error(ledger, &[], error))?;
            let watch = Watch::with(progress::bar());
            let options = Options { progress: watch.shared(), ..Options::default() };
            let report = ledger.verify(&ids, &options, |_| {});
            watch.finish();
            if !report.missing.is_empty() {
                return Ok(None);
            }
            for difference in &report.differences {
                eprintln!("differs: {difference}");
            }
            to_json_with(&report, &options, ledger_origin(&[], &[], &options))
        }
    };
    let place = path.unwrap_or(Path::new("ledger"));
    // Of a key that stands twice in a file one would be left out without a word.
    json::parse(&text).map_err(|error| CliError::file(place, format!("not valid JSON: {error}")))?;
    let mut document = Document::read(&text).map_err(|error| CliError::file(place, error))?;
    document.more = origin(&text);
    Ok(Some(document))
}

/// Where a ledger says that it comes from.
fn origin(text: &str) -> BTreeMap<String, Value> {
    // It was read as a ledger, so that it is an object.
    let whole: BTreeMap<String, Value> = serde_json::from_str(text).unwrap_or_default();
    whole.into_iter().filter(|(key, _)| ["configuration", "digest", "kernel"].contains(&key.as_str())).collect()
}

/// These figures, in their order; nothing if a signal came.
pub fn made(figures: Vec<&'static Figure>) -> Result<Option<Vec<Made>>, CliError> {
    let count = figures.len();
    let results = interrupt::results(move |sender| {
        figures.par_iter().enumerate().for_each_with(sender, |sender, (place, figure)| {
            // Nobody listens any more after a signal.
            let _ = sender.send((place, *figure, figure.reproduce()));
        });
    });
    let mut figures = Vec::new();
    for (place, figure, made) in results {
        let (text, files) = made.map_err(|error| CliError::Use(format!("{}: {error}", figure.name)))?;
        figures.push((place, Made { figure, text, files }));
    }
    figures.sort_by_key(|(place, _)| *place);
    let made: Vec<Made> = figures.into_iter().map(|(_, made)| made).collect();
    Ok((made.len() == count).then_some(made))
}
