//! `certify`: exact results of the ledger as certificates that other programs check.

use super::{CliError, interrupt, output, verify};
use flockproof::certificates::{Certificate, CertificateError, CoqTheorem, coq_file};
use flockproof::claims::certificates::LEDGER;
use flockproof::kernel::bundle;
use flockproof::ledger::Options;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(
    override_usage = "flockproof certify [OPTIONS] --out <DIR>\n       flockproof certify [OPTIONS] --claim <ID> --coq <DIR>",
    after_help = "With --claim and --coq the folder has all that somebody needs who wants to check one claim at home: README.md with the statements of its theorems and \
what their words mean, the least set of Coq files, and check.sh, which compiles them.\n\n\
Examples:\n  flockproof certify --out out\n  flockproof certify --claim chazelle.exAB --out out\n  flockproof certify --claim tanner2.thm1a --coq out"
)]
pub struct Arguments {
    /// Folder for the certificates, one file CLAIM.RESULT.cert for each
    #[arg(long, value_name = "DIR", required_unless_present = "coq")]
    out: Option<PathBuf>,
    /// Only those of this claim (may be repeated) [default: all]
    #[arg(long, value_name = "ID", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    claim: Vec<String>,
    /// Folder for theorems of Coq: with --claim those about this claim, with all that they rest on; else the results as gen_products.v, gen_limits.v, gen_switches.v,
    /// gen_inertia.v, gen_peaks.v
    #[arg(long, value_name = "DIR")]
    coq: Option<PathBuf>,
}

/// The kinds that Coq checks, with the names of their files.
const COQ_FILES: [(&str, &str); 5] = [
    ("product", "gen_products.v"),
    ("limit", "gen_limits.v"),
    ("switches", "gen_switches.v"),
    ("inertia", "gen_inertia.v"),
    ("peak", "gen_peaks.v"),
];

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    match (&arguments.coq, &arguments.claim[..]) {
        (Some(folder), [_, ..]) => write_theorems(folder, &arguments.claim)?,
        _ => return certificates(arguments, arguments.coq.as_deref()),
    }
    if arguments.out.is_some() { certificates(arguments, None) } else { Ok(ExitCode::SUCCESS) }
}

/// The theorems about claims with all that they rest on; each claim has a folder of its own where there are several.
fn write_theorems(folder: &Path, claims: &[String]) -> Result<(), CliError> {
    let ledger = verify::ledger()?;
    let ids = ledger.select(&[], claims).map_err(|error| verify::use_error(&ledger, &[], error))?;
    let report = ledger.verify(&ids, &Options::default(), |_| {});
    for entry in &report.entries {
        let none = || {
            CliError::Use(format!(
                "no theorem of Coq speaks of {}; `flockproof list --grade kernel` shows the claims that have one",
                entry.id
            ))
        };
        let files = bundle(entry).ok_or_else(none)?;
        let own = if ids.len() > 1 { folder.join(&entry.id) } else { folder.to_path_buf() };
        output::make_folder(&own)?;
        for (name, text) in &files {
            output::write_file(&own.join(name), text.as_bytes())?;
        }
        output::print(&format!(
            "{}: {} files; `sh {}` checks them\n",
            entry.id,
            files.len(),
            own.join("check.sh").display()
        ))?;
    }
    Ok(())
}

fn certificates(arguments: &Arguments, coq: Option<&Path>) -> Result<ExitCode, CliError> {
    if let Some(unknown) = arguments.claim.iter().find(|id| LEDGER.iter().all(|row| row.claim != **id)) {
        let mut ids: Vec<&str> = LEDGER.iter().map(|row| row.claim).collect();
        ids.dedup();
        return Err(CliError::Use(format!(
            "there is no certificate of {unknown}; there are some of {}",
            ids.join(", ")
        )));
    }
    let selected =
        LEDGER.iter().filter(|row| arguments.claim.is_empty() || arguments.claim.iter().any(|id| id == row.claim));
    let mut theorems = Vec::new();
    let rows: Vec<_> = selected.collect();
    let work = rows.clone();
    let certificates = interrupt::results(move |sender| {
        // Nobody listens any more after a signal.
        work.iter().take_while(|row| sender.send(row.make()).is_ok()).for_each(drop);
    });
    for (row, certificate) in rows.iter().zip(certificates) {
        let certificate = certificate.map_err(|error| CliError::Use(format!("{}: {error}", row.name())))?;
        if let Some(folder) = &arguments.out {
            let path = made(folder)?.join(format!("{}.cert", row.name()));
            output::write_file(&path, certificate.text_for(row.claim, row.result).as_bytes())?;
            output::print(&format!("{}: {}\n", path.display(), certificate.claim()))?;
        }
        theorems.push(CoqTheorem { name: row.name().replace('.', "_"), certificate });
    }
    if theorems.len() < rows.len() {
        eprintln!("interrupted: {} of {} certificates are made", theorems.len(), rows.len());
        return Ok(interrupt::status(false));
    }
    if let Some(folder) = coq {
        for (kind, name) in COQ_FILES {
            let Some(text) = coq_file(kind, &theorems) else { continue };
            let path = made(folder)?.join(name);
            output::write_file(&path, text.as_bytes())?;
            output::print(&format!("{}\n", path.display()))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// Refuses a file for a certificate that cannot be written.
pub fn check_asked(path: Option<&Path>) -> Result<(), CliError> {
    path.map_or(Ok(()), output::check_writable)
}

/// Writes the certificate of a run to the file that `--certificate` names.
pub fn write_asked(
    path: Option<&Path>,
    make: impl FnOnce() -> Result<Certificate, CertificateError>,
) -> Result<(), CliError> {
    let Some(path) = path else { return Ok(()) };
    let certificate = make().map_err(|error| CliError::Use(format!("--certificate: {error}")))?;
    output::write_file(path, certificate.text().as_bytes())
}

/// The folder, made where it is not there.
fn made(folder: &Path) -> Result<&Path, CliError> {
    output::make_folder(folder)?;
    Ok(folder)
}
