//! `verify`: run the ledger.

use super::interrupt::{self, Watch};
use super::{CliError, output, progress};
use flockproof::kernel;
use flockproof::ledger::{Grade, Ledger, LedgerError, Options, Report, recorded_row, to_json_with};
use flockproof::report::{ledger_origin, not_found, summary, verdict_table};
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

#[derive(clap::Args)]
#[command(
    after_help = "Evidence of grade kernel rests on the transcript of Coq that comes with the program; `flockproof prove` lets Coq check it again, \
which needs coqc and takes minutes. All else is computed now.\n\n\
Examples:\n  flockproof verify\n  flockproof verify --paper tanner1 --paper tanner2\n  flockproof verify --claim veerman.lem2 --json -"
)]
pub struct Arguments {
    /// Only the claims of this paper: chazelle, veerman, paley, tanner1, tanner2, beyond (may be repeated; with --claim, the named ones
    /// of these papers) [default: all]
    #[arg(long, value_name = "P", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    paper: Vec<String>,
    /// Only this claim (may be repeated) [default: all]
    #[arg(long, value_name = "ID", value_parser = clap::builder::NonEmptyStringValueParser::new())]
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

/// A wrong id or paper, with the ids that may be meant.
pub fn use_error(ledger: &Ledger, error: LedgerError) -> CliError {
    CliError::Use(not_found(ledger, &error))
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let ledger = ledger()?;
    let ids = ledger.select(&arguments.paper, &arguments.claim).map_err(|error| use_error(&ledger, error))?;
    if ids.is_empty() {
        let (claims, papers) = (arguments.claim.join(", "), arguments.paper.join(", "));
        return Err(CliError::Use(format!("--claim: {claims} is not a claim of {papers}")));
    }
    let json_file = arguments.json.iter().filter(|path| path.as_os_str() != "-");
    json_file.chain(&arguments.record).try_for_each(|path| output::check_writable(path))?;
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
    if let Some(path) = &arguments.record {
        let rows: String = report.entries.iter().map(|entry| recorded_row(entry) + "\n").collect();
        output::write_file(path, format!("id\tverdict\tfault\treach\tgrades\n{rows}").as_bytes())?;
    }
    Ok(())
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
