//! `completions`: what a shell needs to complete commands and options.

use super::{CliError, output};
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(after_help = "Example:\n  source <(flockproof completions bash)")]
pub struct Arguments {
    /// The shell that is to read the script: bash, elvish, fish, powershell, zsh
    #[arg(value_name = "SHELL")]
    shell: clap_complete::Shell,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let mut command = super::help::command();
    let name = command.get_name().to_string();
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, name, &mut script);
    output::print_raw(&String::from_utf8_lossy(&script))?;
    Ok(ExitCode::SUCCESS)
}
