//! `explain`: one claim in words.

use super::{CliError, output, report, verify};
use flockproof::ledger::{Document, Ledger, Options, Report};
use flockproof::report::{Figure, Site};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(clap::Args)]
pub struct Arguments {
    /// Id of the claim, such as veerman.lem2
    #[arg(value_name = "ID")]
    id: String,
    /// Write the claim as a page that needs no other file, with its figures
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let ledger = verify::ledger()?;
    let ids = ledger.select(&[], std::slice::from_ref(&arguments.id)).map_err(verify::use_error)?;
    let options = Options::default();
    let report = ledger.verify(&ids, &options, |_| {});
    if let Some(path) = &arguments.html {
        write_page(path, &arguments.id, &report, &options, &ledger)?;
        return Ok(ExitCode::SUCCESS);
    }
    for entry in &report.entries {
        output::print(&flockproof::report::explain(entry, output::width()))?;
    }
    Ok(ExitCode::SUCCESS)
}

fn write_page(path: &Path, id: &str, report: &Report, options: &Options, ledger: &Ledger) -> Result<(), CliError> {
    let Some(figures) = report::made(Figure::of_claim(id).collect())? else { return Ok(()) };
    let document = Document::new(report, options);
    let page = Site::new(&document, ledger, &figures).alone(id);
    // The claim was found and checked, so there is a page.
    output::write_file(path, page.unwrap_or_default().as_bytes())?;
    output::print(&format!("written: {}\n", path.display()))
}
