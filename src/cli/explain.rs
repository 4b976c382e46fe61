//! `explain`: one claim in words.

use super::{CliError, output, verify};
use flockproof::ledger::Options;
use std::process::ExitCode;

#[derive(clap::Args)]
pub struct Arguments {
    /// Id of the claim, such as veerman.lem2
    #[arg(value_name = "ID")]
    id: String,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let ledger = verify::ledger()?;
    let ids = ledger.select(&[], std::slice::from_ref(&arguments.id)).map_err(verify::use_error)?;
    let report = ledger.verify(&ids, &Options::default(), |_| {});
    for entry in &report.entries {
        output::print(&flockproof::report::explain(entry, output::width()))?;
    }
    Ok(ExitCode::SUCCESS)
}
