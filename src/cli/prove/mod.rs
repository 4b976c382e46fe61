//! `prove`: let Coq check the proofs that the ledger rests on.

mod compile;

use super::interrupt::{self, Watch};
use super::{CliError, output, progress, verify};
use compile::{ProveError, Workshop, cache, prove};
use flockproof::kernel::{Source, Theorem, Transcript, files, needed, proofs_of, recorded, statements, theorems};
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(
    after_help = "Needs coqc, and without it says how to install it; takes minutes. What is compiled is kept: stopped, the next run goes on.\n\n\
Examples:\n  flockproof prove --out proofs\n  flockproof prove --claim tanner2.thm1a"
)]
pub struct Arguments {
    /// Folder of your own in which the development is compiled [default: flockproof/proofs in $XDG_CACHE_HOME or ~/.cache, or the next one that no other run uses]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Compile all anew, whatever earlier runs left in the folder
    #[arg(long)]
    fresh: bool,
    /// Only the theorems about this claim, and the files that they rest on (may be repeated) [default: all]
    #[arg(long, value_name = "ID", value_parser = clap::builder::NonEmptyStringValueParser::new(), conflicts_with = "transcript")]
    claim: Vec<String>,
    /// Write what coqc said to this file
    #[arg(long, value_name = "FILE")]
    transcript: Option<PathBuf>,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    arguments.transcript.as_deref().map_or(Ok(()), output::check_writable)?;
    let theorems = asked(&arguments.claim)?;
    let sources = sources_of(&arguments.claim, &theorems);
    let workshop = match &arguments.out {
        Some(folder) => Workshop::open(folder),
        None => cache().and_then(|folder| Workshop::open_first_free(&folder)),
    };
    let workshop = workshop.map_err(use_error)?;
    if arguments.fresh {
        workshop.forget(files()).map_err(use_error)?;
    }
    let watch = Watch::with(progress::bar());
    let transcript = prove(&workshop, &sources, &theorems, &watch).and_then(|transcript| {
        // In the place of whole audits, which need more files.
        let again = (!arguments.claim.is_empty()).then(|| statements(&theorems, &sources));
        again.map_or(Ok(()), |text| workshop.state(&text, &watch)).map(|()| transcript)
    });
    watch.finish();
    let transcript = match transcript {
        Ok(transcript) => transcript,
        Err(error @ ProveError::Interrupted(_)) => {
            eprintln!("{error}");
            return Ok(ExitCode::from(interrupt::STATUS));
        }
        Err(error) => return Err(use_error(error)),
    };
    if let Some(path) = &arguments.transcript {
        output::write_file(path, transcript.text().as_bytes())?;
    }
    output::print(&table(&theorems, &transcript))?;
    let differences = differences(&theorems, &sources, &transcript);
    output::print(&summary(&theorems, &transcript, &differences))?;
    let written_anew = arguments.transcript.is_some();
    Ok(if differences.is_empty() || written_anew { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The theorems about these claims, all where none is named.
fn asked(claims: &[String]) -> Result<Vec<Theorem>, CliError> {
    if claims.is_empty() {
        return Ok(theorems().to_vec());
    }
    let ledger = verify::ledger()?;
    ledger.select(&[], claims).map_err(|error| verify::use_error(&ledger, &[], error))?;
    let mut found: Vec<Theorem> = Vec::new();
    for id in claims {
        let own = proofs_of(id).map(|(theorem, _)| theorem.clone()).filter(|theorem| !found.contains(theorem));
        let own: Vec<Theorem> = own.collect();
        if own.is_empty() {
            return Err(CliError::Use(format!(
                "no theorem of Coq speaks of {id}; `flockproof list --grade kernel` shows the claims that have one"
            )));
        }
        found.extend(own);
    }
    Ok(found)
}

/// The files that the theorems rest on; all, with every audit, where no claim is named.
fn sources_of(claims: &[String], theorems: &[Theorem]) -> Vec<Source> {
    let names: Vec<&str> = theorems.iter().map(|theorem| theorem.file).collect();
    if claims.is_empty() { files().to_vec() } else { needed(&names).into_iter().cloned().collect() }
}

fn use_error(error: ProveError) -> CliError {
    CliError::Use(error.to_string())
}

fn table(theorems: &[Theorem], transcript: &Transcript) -> String {
    let widest = |f: fn(&Theorem) -> usize| theorems.iter().map(f).max().unwrap_or(0);
    let (claim, path) = (widest(|t| t.claim.len()), widest(|t| t.path().len()));
    let mut text = String::new();
    for theorem in theorems {
        let axioms = transcript.theorems.get(&theorem.path()).map_or("not proved", |axioms| axioms.words());
        text.push_str(&format!(
            "{:claim$} {:path$} {:9} {axioms}\n",
            theorem.claim,
            theorem.path(),
            theorem.covers.word()
        ));
    }
    text
}

/// Theorems that do not have the axioms of the table, and what differs from the transcript of the program.
fn differences(theorems: &[Theorem], sources: &[Source], transcript: &Transcript) -> Vec<String> {
    let unlike_table = theorems
        .iter()
        .filter(|theorem| transcript.theorems.get(&theorem.path()) != Some(&theorem.axioms))
        .map(|theorem| format!("{}: the table says {}", theorem.path(), theorem.axioms.words()));
    let unstated = theorems
        .iter()
        .filter(|theorem| theorem.audited().is_none())
        .map(|theorem| format!("{}: no audit states it again", theorem.path()));
    let recorded = recorded();
    // Of a part of the development only that part is compared.
    let all = sources.len() == files().len();
    let contains = recorded.contains(transcript);
    let same = contains && (!all || transcript.contains(recorded));
    let stale = (!same).then(|| "the transcript that comes with the program".to_string());
    unlike_table.chain(unstated).chain(stale).collect()
}

fn summary(theorems: &[Theorem], transcript: &Transcript, differences: &[String]) -> String {
    let mut claims: Vec<&str> = theorems.iter().map(|theorem| theorem.claim).collect();
    claims.sort_unstable();
    claims.dedup();
    let mut text: String = differences.iter().map(|difference| format!("DIFFERS {difference}\n")).collect();
    text.push_str(&format!(
        "Coq {}: {} files, {} theorems for {} claims{}\n",
        transcript.coq,
        transcript.digests.len(),
        transcript.theorems.len(),
        claims.len(),
        if differences.is_empty() { ", all as recorded" } else { "" }
    ));
    text
}
