//! `flock`: exact flocks of model D, certified flocks of model K.

mod observed;
mod output;
mod run;
mod settle;
mod stepped;

pub use settle::settled;

use super::CliError;
use flockproof::averaging::read::{FlockFile, read_flock};
use serde_json::Value;
use std::path::Path;
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(subcommand_required = true, arg_required_else_help = true)]
pub struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand)]
enum Command {
    /// Step a flock exactly (model K: with certified positions) and log every change of its network
    Run(run::Arguments),
    /// Find every switch of a flock of model D by exact jumps and decide whether the network can ever change again
    Settle(settle::Arguments),
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    match &arguments.command {
        Command::Run(arguments) => run::run(arguments),
        Command::Settle(arguments) => settle::run(arguments),
    }
}

/// A flock with the name and the digest of its file.
fn read(path: &Path) -> Result<(FlockFile, Value), CliError> {
    let input = super::output::read_input(path)?;
    let flock = read_flock(&input.text).map_err(|error| CliError::file(path, error))?;
    Ok((flock, input.origin))
}
