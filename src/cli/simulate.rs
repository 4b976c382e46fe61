//! `simulate`: a flock of one's own from a TOML file.

use super::{CliError, interrupt, output};
use flockproof::report::{observables_csv, sample_table, simulation_pictures, simulation_summary, trajectory_csv};
use flockproof::scenario::{End, Outcome, Scenario};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
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
    interrupt::listen();
    if !arguments.json {
        output::print(&declared(&scenario.declaration()))?;
    }
    let bar = progress();
    let until = scenario.until();
    let outcome = scenario.run(&interrupt::happened, &mut |time| bar.set_position((1000.0 * time / until) as u64));
    bar.finish_and_clear();
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
        End::Finished => Ok(ExitCode::SUCCESS),
        End::Interrupted => {
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
    let mut files = vec![
        ("summary.json".to_string(), format!("{:#}\n", simulation_summary(outcome)).into_bytes()),
        ("trajectory.csv".to_string(), trajectory_csv(outcome).into_bytes()),
        ("observables.csv".to_string(), observables_csv(outcome).into_bytes()),
    ];
    for (name, picture) in simulation_pictures(outcome) {
        files.push((format!("{name}.svg"), picture.svg().into_bytes()));
        let png = picture.png().map_err(|error| CliError::Use(format!("{name}.png: {error}")))?;
        files.push((format!("{name}.png"), png));
    }
    for (name, contents) in &files {
        output::write_file(&folder.join(name), contents)?;
    }
    Ok(files.into_iter().map(|(name, _)| name).collect())
}

fn progress() -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::with_draw_target(Some(1000), ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {percent} % of the time, {eta} left") {
        bar.set_style(style);
    }
    bar
}
