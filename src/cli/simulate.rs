//! `simulate`: a flock of one's own from a TOML file.

use super::interrupt::{self, Watch};
use super::{CliError, output, progress};
use flockproof::report::{observables_csv, sample_table, simulation_pictures, simulation_summary, trajectory_csv};
use flockproof::scenario::{End, Outcome, Scenario};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(clap::Args)]
pub struct Arguments {
    /// Model, graph, start, law and times as TOML, see notes/simulate.md
    #[arg(value_name = "CONFIG")]
    config: PathBuf,
    /// Folder for summary.json, the CSV files and the plots; it is made if it is missing
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Print summary.json instead of the table
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let refuse = |error: &dyn std::fmt::Display| CliError::file(&arguments.config, error);
    let scenario = Scenario::read(&output::read_text(&arguments.config)?).map_err(|error| refuse(&error))?;
    std::fs::create_dir_all(&arguments.out).map_err(|error| CliError::file(&arguments.out, error))?;
    let watch = Watch::with(progress::styled("{bar:30} {percent} % of the time, {eta} left"));
    if !arguments.json {
        output::print(&declared(&scenario.declaration()))?;
    }
    let outcome = scenario.run(&watch);
    watch.finish();
    interrupt::finishing();
    let written = write(&outcome, &arguments.out)?;
    if arguments.json {
        output::print_json(&simulation_summary(&outcome))?;
    } else {
        let (table, events) = (sample_table(&outcome), outcome.events.len());
        let (remarks, folder) = (declared(&outcome.remarks), arguments.out.display());
        let events = format!("{events} event{}", if events == 1 { "" } else { "s" });
        let files = declared(&[format!("written: {}", written.join(", "))]);
        output::print(&format!("\n{table}{remarks}{events}\n{files}in {folder}\n"))?;
    }
    let kept = format!("what was reached up to t = {} is kept", outcome.reached());
    match outcome.end {
        End::Finished if !interrupt::happened() => Ok(ExitCode::SUCCESS),
        End::Finished | End::Interrupted => {
            eprintln!("interrupted: {kept}");
            Ok(ExitCode::from(interrupt::STATUS))
        }
        End::Failed(error) => Err(refuse(&format!("{error}; {kept}"))),
    }
}

/// The declaration within 80 columns.
fn declared(lines: &[String]) -> String {
    let options = textwrap::Options::new(output::width().min(80)).subsequent_indent("  ");
    lines.iter().map(|line| textwrap::fill(line, &options) + "\n").collect()
}

/// Writes all files and returns their names.
fn write(outcome: &Outcome, folder: &Path) -> Result<Vec<String>, CliError> {
    let mut names = Vec::new();
    let mut put = |name: String, contents: Vec<u8>| {
        output::write_file(&folder.join(&name), &contents)?;
        names.push(name);
        Ok(())
    };
    put("summary.json".to_string(), format!("{:#}\n", simulation_summary(outcome)).into_bytes())?;
    put("trajectory.csv".to_string(), trajectory_csv(outcome).into_bytes())?;
    put("observables.csv".to_string(), observables_csv(outcome).into_bytes())?;
    for (name, picture) in simulation_pictures(outcome) {
        // Who stops a run does not wait for its pictures: the numbers are kept.
        if interrupt::happened() {
            break;
        }
        put(format!("{name}.svg"), picture.svg().into_bytes())?;
        let png = picture.png().map_err(|error| CliError::Use(format!("{name}.png: {error}")))?;
        put(format!("{name}.png"), png)?;
    }
    Ok(names)
}
