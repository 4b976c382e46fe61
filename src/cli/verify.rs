//! `verify`: run the ledger.

use super::interrupt::{self, Watch};
use super::{CliError, output, progress};
use flockproof::ledger::{Ledger, LedgerError, Options, Report, recorded_row, to_json};
use flockproof::report::{summary, verdict_table};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

#[derive(clap::Args)]
pub struct Arguments {
    /// Only the claims of this paper (may be repeated; with --claim, the named ones of these papers)
    #[arg(long, value_name = "P")]
    paper: Vec<String>,
    /// Only this claim (may be repeated)
    #[arg(long, value_name = "ID")]
    claim: Vec<String>,
    /// Write the ledger as JSON to this file; `-` prints it instead of the table
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write what was reached as a table of recorded verdicts, for crates/claims/src/recorded.tsv
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// Seed of everything random
    #[arg(long, value_name = "S", default_value = "flockproof")]
    seed: String,
    /// Try more cases; may take minutes
    #[arg(long)]
    full: bool,
    /// Give up a claim after so many seconds of wall time, as a last resort (3600); what is decided does not depend on it
    #[arg(long, value_name = "SECONDS", value_parser = clap::value_parser!(u64).range(1..=86_400))]
    limit: Option<u64>,
    /// Claims checked at a time (as many as there are cores)
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

/// The ledger of the program.
pub fn ledger() -> Result<Ledger, CliError> {
    flockproof::claims::ledger().map_err(use_error)
}

/// A wrong id or paper.
pub fn use_error(error: LedgerError) -> CliError {
    CliError::Use(error.to_string())
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let ledger = ledger()?;
    let ids = ledger.select(&arguments.paper, &arguments.claim).map_err(use_error)?;
    let mut options = Options { seed: arguments.seed.clone(), full: arguments.full, ..Options::default() };
    if let Some(seconds) = arguments.limit {
        options.longest = Duration::from_secs(seconds);
    }
    if let Some(threads) = arguments.threads {
        options.threads = usize::from(threads);
    }
    let watch = Watch::with(progress::bar());
    options.progress = watch.shared();
    let report = ledger.verify(&ids, &options, |_| {});
    watch.finish();
    interrupt::finishing();
    write_report(arguments, &report, &options)?;
    Ok(match (!report.missing.is_empty(), report.is_as_recorded()) {
        (true, _) => ExitCode::from(interrupt::STATUS),
        (false, true) => ExitCode::SUCCESS,
        (false, false) => ExitCode::FAILURE,
    })
}

fn write_report(arguments: &Arguments, report: &Report, options: &Options) -> Result<(), CliError> {
    if let Some(path) = &arguments.record {
        let rows: String = report.entries.iter().map(|entry| recorded_row(entry) + "\n").collect();
        output::write_file(path, format!("id\tverdict\tfault\treach\tgrades\n{rows}").as_bytes())?;
    }
    let json = to_json(report, options);
    match &arguments.json {
        Some(path) if path.as_os_str() == "-" => {
            if !report.missing.is_empty() {
                eprintln!("interrupted: missing: {}", report.missing.join(", "));
            }
            return output::print(&json);
        }
        Some(path) => output::write_file(path, json.as_bytes())?,
        None => {}
    }
    let mut text = verdict_table(&report.entries);
    text.push('\n');
    text.push_str(&summary(report));
    for difference in &report.differences {
        text.push_str(&format!("DIFFERS {difference}\n"));
    }
    if !report.missing.is_empty() {
        let missing = format!("interrupted: the claims above were finished; missing: {}", report.missing.join(", "));
        text.push_str(&(textwrap::fill(&missing, 80) + "\n"));
    } else if report.differences.is_empty() {
        text.push_str("every verdict is as recorded; every negative control was refuted\n");
    }
    output::print(&text)
}
