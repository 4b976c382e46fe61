//! `explain`: one claim in words.

use super::{CliError, output, progress, report, texts, verify};
use flockproof::ledger::{Document, Ledger, LedgerError, Options, Report};
use flockproof::report::{
    Figure, Provenance, Site, catalogue, explain, explain_proofs, explanation, legend, of_place, version,
    written_proofs,
};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(
    after_help = "The claim is checked anew, which may take seconds. For an unknown id, similar ids are suggested; `flockproof list` searches.\n\n\
Examples:\n  flockproof explain veerman.gain_max\n  flockproof explain \"Corollary 1\" --paper veerman\n  flockproof explain tanner2.thm1a --proof\n  flockproof explain chazelle.tau1 --json"
)]
pub struct Arguments {
    /// Id of the claim, such as veerman.lem2, or its place in the paper, such as "Theorem 1"
    #[arg(value_name = "ID", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    id: String,
    /// The paper in which the place is: chazelle, veerman, paley, tanner (tanner1 and tanner2) (may be repeated) [default: all]
    #[arg(long, value_name = "P", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    paper: Vec<String>,
    /// Print the proofs on paper too, step by step
    #[arg(long, conflicts_with_all = ["json", "html"])]
    proof: bool,
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
    let ids = found(arguments, &ledger)?;
    let bar = progress::spinner(&format!("checking {} anew", ids.join(", ")));
    let options = Options::default();
    let report = ledger.verify(&ids, &options, |_| {});
    bar.finish_and_clear();
    if let Some(path) = &arguments.html {
        write_page(path, &ids[0], &report, &options, &ledger)?;
        return Ok(ExitCode::SUCCESS);
    }
    for (i, entry) in report.entries.iter().enumerate() {
        if i > 0 {
            output::print("\n")?;
        }
        if arguments.json {
            let configuration = json!({"command": "explain", "claim": entry.id, "full": options.full});
            let provenance = Provenance::new("flockproof.explain/1", Some(&options.seed), configuration);
            output::print_json(&provenance.stamp(explanation(entry, &ledger)))?;
        } else {
            let width = output::width();
            let proofs = written_proofs(entry, texts::text);
            let mut text = explain(entry, &ledger, width) + &legend(entry, width);
            text += &(textwrap::fill(&checked(&report, &options), width) + "\n");
            match (arguments.proof, proofs.is_empty()) {
                (true, true) => text += "No clause of it rests on a proof on paper.\n",
                (true, false) => text += &explain_proofs(&proofs, width),
                (false, _) => {}
            }
            output::print(&text)?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// The ids that are meant, at least one: itself, or those of the claims at a place. A page and a document have one claim.
fn found(arguments: &Arguments, ledger: &Ledger) -> Result<Vec<String>, CliError> {
    let unknown = match ledger.select(&arguments.paper, std::slice::from_ref(&arguments.id)) {
        Ok(ids) => match ids.into_iter().next() {
            Some(id) => return Ok(vec![id]),
            None => {
                return Err(CliError::Use(format!(
                    "--paper: {} is not a claim of {}",
                    arguments.id,
                    arguments.paper.join(", ")
                )));
            }
        },
        Err(error @ LedgerError::NoPaper(..)) => return Err(verify::use_error(ledger, &arguments.paper, error)),
        Err(error) => error,
    };
    let all = catalogue(ledger);
    match of_place(&all, &arguments.paper, &arguments.id)[..] {
        [] => Err(verify::use_error(ledger, &arguments.paper, unknown)),
        ref several if several.len() > 1 && (arguments.json || arguments.html.is_some()) => Err(CliError::Use(
            format!("several claims stand at `{}`, choose one: {}", arguments.id, several.join(", ")),
        )),
        ref places => Ok(places.iter().map(ToString::to_string).collect()),
    }
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
