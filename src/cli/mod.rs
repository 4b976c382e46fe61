//! Dispatch, errors and output of the command line.
//!
//! Exit status: 0 when all is as it should be, 1 when `verify` differs from what is recorded, 2 on bad use, 130 when
//! interrupted; `check` and `reach` have 1 for false, 3 for undecided and 4 where a control was not refuted.

mod certify;
mod check;
mod completions;
mod ergodicity;
mod explain;
mod flock;
mod fuzz;
mod help;
mod interrupt;
mod list;
mod man;
mod output;
mod pattern;
mod progress;
mod prove;
mod reach;
mod report;
mod reproduce;
mod resonance;
mod serve;
mod simulate;
mod spectrum;
mod sweep;
mod texts;
mod tracks;
mod verify;

use clap::error::ErrorKind;
use clap::{FromArgMatches, Parser, Subcommand};
use std::process::ExitCode;

/// Checks what is claimed about flocking: every statement with a verdict, graded evidence and negative controls.
#[derive(Parser)]
#[command(name = "flockproof", version, about, subcommand_required = true, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Run the ledger: a table of claims, verdicts, evidence, controls and times
    Verify(verify::Arguments),
    /// Search the claims: words, paper, verdict, fault, grade, scope
    List(list::Arguments),
    /// Explain one claim: statement, verdict, derivation, evidence, counterexample, correction
    Explain(explain::Arguments),
    /// Write the site: a page for every claim, with figures, errata and results
    Report(report::Arguments),
    /// Show the site with live pages, on 127.0.0.1 only
    Serve(serve::Arguments),
    /// Reproduce tables and figures of the papers as CSV, SVG and PNG
    Reproduce(reproduce::Arguments),
    /// Enclose the peak of a platoon rigorously: two-sided, or on any communication graph, or of a linear system
    Resonance(resonance::Arguments),
    /// Enclose the eigenvalues of a Laplacian or adjacency matrix of a graph
    Spectrum(spectrum::Arguments),
    /// Decide which symmetric patterns of steered particles are stable under given gains
    Pattern(pattern::Arguments),
    /// Analyse measured trajectories of a school: order, potentials, zones, null models
    Tracks(tracks::Arguments),
    /// Let Coq check the proofs that the ledger rests on
    Prove(prove::Arguments),
    /// Decide statements of one's own: a file says what a property ranges over
    Check(check::Arguments),
    /// Worst cases of switched linear systems with bounded inputs, from a TOML file
    Reach(reach::Arguments),
    /// Write exact results of the ledger as certificates that a separate program, or Coq, checks
    Certify(certify::Arguments),
    /// Products, footprints, stabilisers and ergodicity coefficients of a sequence of stochastic matrices
    Ergodicity(ergodicity::Arguments),
    /// Exact flocks: step them, or decide what becomes of them
    Flock(flock::Arguments),
    /// Tabulate the quantities of a question over its family
    Sweep(sweep::Arguments),
    /// Run campaigns of random cases over what must always be true
    Fuzz(fuzz::Arguments),
    /// Simulate a flock from a TOML file: samples, events, trajectory, plots
    Simulate(simulate::Arguments),
    /// Print a script that completes commands and options in a shell
    Completions(completions::Arguments),
    /// Write the manual pages, one for each command
    Man(man::Arguments),
}

/// A failure: one sentence for standard error, exit status 2.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// Anything that a person can mend by other arguments or files.
    #[error("{0}")]
    Use(String),
    /// The reader of the output is gone: nothing to say.
    #[error("the output was closed")]
    ClosedOutput,
}

impl CliError {
    /// A failure about a file.
    fn file(path: &std::path::Path, error: impl std::fmt::Display) -> Self {
        CliError::Use(help::plain(&format!("{}: {error}", path.display())))
    }
}

/// Parses the arguments, of which the first is the name of the program, and runs the subcommand; the exit status.
pub fn main(arguments: impl IntoIterator<Item = std::ffi::OsString>) -> u8 {
    let code = run(arguments);
    // The number in an `ExitCode` cannot be asked for.
    (0..=u8::MAX).find(|&status| ExitCode::from(status) == code).unwrap_or(u8::MAX)
}

fn run(arguments: impl IntoIterator<Item = std::ffi::OsString>) -> ExitCode {
    let given = with_counts(arguments);
    let parsed = help::command().try_get_matches_from(&given).and_then(|matches| Arguments::from_arg_matches(&matches));
    let arguments = match parsed {
        Ok(arguments) => arguments,
        // Nothing was asked for: all that can be asked for.
        Err(error) if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            eprint!("{}", error.render());
            return ExitCode::from(2);
        }
        Err(error) if error.kind() == ErrorKind::InvalidUtf8 => {
            // File names may be such; where there are several of them, one is meant.
            let such: Vec<_> = given.iter().filter(|a| a.to_str().is_none()).map(|a| a.to_string_lossy()).collect();
            output::complain(&format!("error: this argument is not text in UTF-8: {}", such.join(", or ")));
            return ExitCode::from(2);
        }
        Err(error) if error.use_stderr() => {
            output::complain(&help::one_sentence(&error.render().to_string()));
            return ExitCode::from(2);
        }
        // Help and version.
        Err(error) => return finish(output::print(&error.render().to_string()).map(|()| ExitCode::SUCCESS)),
    };
    interrupt::listen();
    finish(match arguments.command {
        Command::Verify(arguments) => verify::run(&arguments),
        Command::List(arguments) => list::run(&arguments),
        Command::Explain(arguments) => explain::run(&arguments),
        Command::Report(arguments) => report::run(&arguments),
        Command::Serve(arguments) => serve::run(&arguments),
        Command::Reproduce(arguments) => reproduce::run(&arguments),
        Command::Resonance(arguments) => resonance::run(&arguments),
        Command::Spectrum(arguments) => spectrum::run(&arguments),
        Command::Pattern(arguments) => pattern::run(&arguments),
        Command::Tracks(arguments) => tracks::run(&arguments),
        Command::Prove(arguments) => prove::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Reach(arguments) => reach::run(&arguments),
        Command::Certify(arguments) => certify::run(&arguments),
        Command::Ergodicity(arguments) => ergodicity::run(&arguments),
        Command::Flock(arguments) => flock::run(&arguments),
        Command::Sweep(arguments) => sweep::run(&arguments),
        Command::Fuzz(arguments) => fuzz::run(&arguments),
        Command::Simulate(arguments) => simulate::run(&arguments),
        Command::Completions(arguments) => completions::run(&arguments),
        Command::Man(arguments) => man::run(&arguments),
    })
}

/// The arguments, with a number after `--tight`, which need not have one, as its value: it may come before the name of a file, too.
fn with_counts(arguments: impl IntoIterator<Item = std::ffi::OsString>) -> Vec<std::ffi::OsString> {
    let mut given: Vec<std::ffi::OsString> = Vec::new();
    for argument in arguments {
        let number = argument.to_str().filter(|text| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit()));
        match (given.last_mut(), number) {
            (Some(last), Some(number)) if *last == "--tight" => last.push(format!("={number}")),
            _ => given.push(argument),
        }
    }
    given
}

fn finish(result: Result<ExitCode, CliError>) -> ExitCode {
    match result {
        Ok(code) => code,
        Err(CliError::ClosedOutput) => ExitCode::SUCCESS,
        Err(error) => {
            output::complain(&format!("error: {}", output::without_system_words(&error.to_string())));
            ExitCode::from(2)
        }
    }
}
