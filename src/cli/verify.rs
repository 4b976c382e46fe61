//! `verify`: run the ledger.

use super::interrupt::{self, Watch};
use super::{CliError, output, progress};
use flockproof::kernel;
use flockproof::ledger::{Grade, Ledger, LedgerError, Options, Report, recorded_row, to_json_with};
use flockproof::report::{ledger_origin, not_found, summary, verdict_table};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

#[derive(clap::Args)]
#[command(
    after_help = "Evidence of grade kernel rests on the transcript of Coq that comes with the program; `flockproof prove` lets Coq check it again, \
which needs coqc and takes minutes. All else is computed now.\n\n\
Examples:\n  flockproof verify\n  flockproof verify --paper tanner1 --paper tanner2\n  flockproof verify --claim veerman.lem2 --json -"
)]
pub struct Arguments {
    /// Only the claims of this paper: chazelle, veerman, paley, tanner1, tanner2, tanner (both), beyond (may be repeated; with --claim, the named ones
    /// of these papers) [default: all]
    #[arg(long, value_name = "P", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    paper: Vec<String>,
    /// Only this claim (may be repeated) [default: all]
    #[arg(long, value_name = "ID", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    claim: Vec<String>,
    /// Write the ledger as JSON to this file; `-` prints it instead of the table
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write what was reached as the tables of what is recorded: recorded.tsv, the verdicts, and evidence.tsv, the lines of evidence, for crates/claims/src; with --full the
    /// numbers of cases of full runs
    #[arg(long, value_name = "DIR")]
    record: Option<PathBuf>,
    /// Seed of everything random
    #[arg(long, value_name = "S", default_value = "flockproof")]
    seed: String,
    /// Try more cases; may take minutes
    #[arg(long)]
    full: bool,
    /// Give up a claim after so many seconds of wall time, as a last resort: it is then undecided, and the run differs from what is recorded [default: 3600]
    #[arg(long, value_name = "SECONDS", value_parser = clap::value_parser!(u64).range(1..=86_400))]
    limit: Option<u64>,
    /// Claims checked at a time [default: as many as there are cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

/// The ledger of the program.
pub fn ledger() -> Result<Ledger, CliError> {
    flockproof::claims::ledger().map_err(|error| CliError::Use(error.to_string()))
}

/// A wrong id or paper, with the ids that may be meant, of these papers where some are named.
pub fn use_error(ledger: &Ledger, papers: &[String], error: LedgerError) -> CliError {
    CliError::Use(not_found(ledger, papers, &error))
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let ledger = ledger()?;
    let papers = &arguments.paper;
    let ids = ledger.select(papers, &arguments.claim).map_err(|error| use_error(&ledger, papers, error))?;
    if ids.is_empty() {
        let (claims, papers) = (arguments.claim.join(", "), arguments.paper.join(", "));
        return Err(CliError::Use(format!("--claim: {claims} is not a claim of {papers}")));
    }
    let mut json_file = arguments.json.iter().filter(|path| path.as_os_str() != "-");
    json_file.try_for_each(|path| output::check_writable(path))?;
    arguments.record.as_deref().map_or(Ok(()), output::make_folder)?;
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
    if let Some(folder) = &arguments.record {
        write_tables(folder, &ledger, &report, options.full)?;
    }
    Ok(match (!report.missing.is_empty(), report.is_as_recorded()) {
        (true, _) => ExitCode::from(interrupt::STATUS),
        (false, true) => ExitCode::SUCCESS,
        (false, false) => ExitCode::FAILURE,
    })
}

fn write_report(arguments: &Arguments, report: &Report, options: &Options) -> Result<(), CliError> {
    let json = to_json_with(report, options, ledger_origin(&arguments.paper, &arguments.claim, options));
    let printed_json = arguments.json.as_deref().is_some_and(|path| path.as_os_str() == "-");
    // What was reached is shown even where a file cannot be written any more.
    if printed_json {
        if !report.missing.is_empty() {
            eprintln!("interrupted: missing: {}", report.missing.join(", "));
        }
        output::print(&json)?;
    } else {
        output::print(&table(report))?;
    }
    if let Some(path) = arguments.json.as_ref().filter(|_| !printed_json) {
        output::write_file(path, json.as_bytes())?;
    }
    Ok(())
}

/// The tables that later runs are compared with.
fn write_tables(folder: &Path, ledger: &Ledger, report: &Report, full: bool) -> Result<(), CliError> {
    let rows: String = report.entries.iter().map(|entry| recorded_row(entry) + "\n").collect();
    let verdicts = format!("id\tverdict\tfault\treach\tgrades\n{rows}");
    output::write_file(&folder.join("recorded.tsv"), verdicts.as_bytes())?;
    output::write_file(&folder.join("evidence.tsv"), ledger.evidence_table(&report.entries, full).as_bytes())
}

fn table(report: &Report) -> String {
    let filled = |text: &str| textwrap::fill(text, output::width().min(80)) + "\n";
    let mut text = verdict_table(&report.entries);
    if report.entries.iter().any(|entry| entry.grades().contains(&Grade::Kernel)) {
        let coq = &kernel::recorded().coq;
        text += &filled(&format!(
            "kernel: proved in Coq; rests on the transcript of Coq {coq}, `flockproof prove` checks anew and needs coqc"
        ));
    }
    text.push('\n');
    text.push_str(&summary(report));
    for difference in &report.differences {
        text += &filled(&format!("DIFFERS {difference}"));
    }
    if !report.missing.is_empty() {
        let missing = format!("interrupted: the claims above were finished; missing: {}", report.missing.join(", "));
        text += &filled(&missing);
    } else if report.differences.is_empty() {
        text.push_str("every verdict is as recorded; every negative control was refuted\n");
    }
    text
}
