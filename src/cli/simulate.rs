//! `simulate`: a flock of one's own from a TOML file.

use super::interrupt::{self, Watch};
use super::{CliError, output, progress};
use flockproof::report::{
    File, Provenance, animation, events_csv, observables_csv, sample_table, simulation_pictures, simulation_summary,
    trajectory_csv,
};
use flockproof::scenario::{End, Outcome, Scenario};
use serde_json::{Value, json};
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(after_help = "Files are written at the end, or when the run is stopped: what was reached is kept.\n\n\
Example:\n  flockproof simulate assets/scenarios/three_agents.toml --out out --animate")]
pub struct Arguments {
    /// Model, graph, start, law and times as TOML, see notes/simulate.md
    #[arg(value_name = "CONFIG")]
    config: PathBuf,
    /// Folder for summary.json, the CSV files and the plots; it is made if it is missing
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Write animation.html too, one page that plays the run in a browser
    #[arg(long)]
    animate: bool,
    /// Print summary.json, flockproof.simulate/1, instead of the table
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let refuse = |error: &dyn std::fmt::Display| CliError::file(&arguments.config, error);
    let input = output::read_input(&arguments.config)?;
    let scenario = Scenario::read(&input.text).map_err(|error| refuse(&error))?;
    output::make_folder(&arguments.out)?;
    let watch = Watch::with(progress::styled("{bar:30} {percent} % of the time, {eta} left"));
    if !arguments.json {
        output::print(&declared(&scenario.declaration()))?;
    }
    let seed = scenario.seed().map(str::to_string);
    let outcome = scenario.run(&watch);
    watch.finish();
    interrupt::finishing();
    let configuration = json!({"command": "simulate", "file": input.origin, "toml": input.text});
    let provenance = Provenance::new("flockproof.simulate/1", seed.as_deref(), configuration);
    let summary = provenance.stamp(simulation_summary(&outcome));
    let written = write(&outcome, &summary, &provenance, arguments)?;
    if arguments.json {
        output::print_json(&summary)?;
    } else {
        let (table, events) = (sample_table(&outcome), outcome.events.len());
        let (remarks, folder) = (declared(&outcome.remarks), arguments.out.display());
        let events = format!("{events} event{}", if events == 1 { "" } else { "s" });
        let files = declared(&[format!("{}written: {}", provenance.line(), written.join(", "))]);
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
fn write(
    outcome: &Outcome,
    summary: &Value,
    provenance: &Provenance,
    arguments: &Arguments,
) -> Result<Vec<String>, CliError> {
    let folder = &arguments.out;
    let file = |name: &str, contents: Vec<u8>| File { name: name.to_string(), contents };
    let mut files = vec![
        file("summary.json", format!("{summary:#}\n").into_bytes()),
        file("trajectory.csv", trajectory_csv(outcome).into_bytes()),
        file("observables.csv", observables_csv(outcome).into_bytes()),
        file("events.csv", events_csv(outcome).into_bytes()),
    ];
    files.push(file("about.txt", provenance.about(&files).into_bytes()));
    if arguments.animate {
        let page =
            animation(outcome).ok_or_else(|| CliError::Use("--animate: this model has no positions".to_string()))?;
        files.push(file("animation.html", page.into_bytes()));
    }
    let mut names = Vec::new();
    let mut put = |file: File| {
        output::write_file(&folder.join(&file.name), &file.contents)?;
        names.push(file.name);
        Ok(())
    };
    files.into_iter().try_for_each(&mut put)?;
    for (name, picture) in simulation_pictures(outcome) {
        // Who stops a run does not wait for its pictures: the numbers are kept.
        if interrupt::happened() {
            break;
        }
        put(file(&format!("{name}.svg"), picture.svg().into_bytes()))?;
        let png = picture.png().map_err(|error| CliError::Use(format!("{name}.png: {error}")))?;
        put(file(&format!("{name}.png"), png))?;
    }
    Ok(names)
}
