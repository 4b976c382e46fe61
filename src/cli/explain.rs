//! `explain`: one claim in words.

use super::{CliError, output, progress, report, texts, verify};
use flockproof::ledger::{Document, Ledger, Options, Report};
use flockproof::report::{Figure, Provenance, Site, explain, explanation, version};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(
    after_help = "The claim is checked anew, which may take seconds. For an unknown id, similar ids are suggested; `flockproof list` searches.\n\n\
Examples:\n  flockproof explain veerman.gain_max\n  flockproof explain chazelle.tau1 --json"
)]
pub struct Arguments {
    /// Id of the claim, such as veerman.lem2
    #[arg(value_name = "ID", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    id: String,
    /// Print one JSON document, flockproof.explain/1
    #[arg(long)]
    json: bool,
    /// Write the claim as a page that needs no other file, with its figures
    #[arg(long, value_name = "FILE", conflicts_with = "json")]
    html: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    arguments.html.as_deref().map_or(Ok(()), output::check_writable)?;
    let ledger = verify::ledger()?;
    let ids =
        ledger.select(&[], std::slice::from_ref(&arguments.id)).map_err(|error| verify::use_error(&ledger, error))?;
    let bar = progress::spinner(&format!("checking {} anew", arguments.id));
    let options = Options::default();
    let report = ledger.verify(&ids, &options, |_| {});
    bar.finish_and_clear();
    if let Some(path) = &arguments.html {
        write_page(path, &arguments.id, &report, &options, &ledger)?;
        return Ok(ExitCode::SUCCESS);
    }
    for entry in &report.entries {
        if arguments.json {
            let configuration = json!({"command": "explain", "claim": entry.id, "full": options.full});
            let provenance = Provenance::new("flockproof.explain/1", Some(&options.seed), configuration);
            output::print_json(&provenance.stamp(explanation(entry, &ledger)))?;
        } else {
            let text = explain(entry, &ledger, output::width())
                + &textwrap::fill(&checked(&report, &options), output::width());
            output::print(&(text + "\n"))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// That all of it was computed now, and by what.
fn checked(report: &Report, options: &Options) -> String {
    let recorded = match report.differences.as_slice() {
        [] => "as recorded".to_string(),
        differences => format!("not as recorded: {}", differences.join("; ")),
    };
    format!("Checked anew by flockproof {}, seed {}: {recorded}.", version(), options.seed)
}

fn write_page(path: &Path, id: &str, report: &Report, options: &Options, ledger: &Ledger) -> Result<(), CliError> {
    let Some(figures) = report::made(Figure::of_claim(id).collect())? else { return Ok(()) };
    let document = Document::new(report, options);
    let page = Site::new(&document, ledger, &figures, texts::text).alone(id);
    // The claim was found and checked, so there is a page.
    output::write_file(path, page.unwrap_or_default().as_bytes())?;
    output::print(&format!("written: {}\n", path.display()))
}
