//! `man`: manual pages, made from the same descriptions as `--help`.

use super::{CliError, output};
use clap::Command;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(after_help = "Example:\n  flockproof man --out ~/.local/share/man/man1")]
pub struct Arguments {
    /// Folder for the pages flockproof.1, flockproof-verify.1 and so on; it is made if it is missing
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    output::make_folder(&arguments.out)?;
    let mut command = super::help::command().disable_help_subcommand(true);
    // Gives the subcommands their full names.
    command.build();
    write(&command, &arguments.out)?;
    Ok(ExitCode::SUCCESS)
}

/// Writes the page of a command and those of its subcommands.
fn write(command: &Command, folder: &Path) -> Result<(), CliError> {
    let page = clap_mangen::Man::new(command.clone());
    let path = folder.join(page.get_filename());
    let mut text = Vec::new();
    page.render(&mut text).map_err(|error| CliError::file(&path, error))?;
    output::write_file(&path, &text)?;
    output::print(&format!("{}\n", path.display()))?;
    command.get_subcommands().try_for_each(|subcommand| write(subcommand, folder))
}
