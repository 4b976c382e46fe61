//! `simulate`: a flock of one's own from a TOML file.

use super::interrupt::{self, Watch};
use super::{CliError, output, progress};
use flockproof::arithmetic::Progress;
use flockproof::report::{
    File, Provenance, animation, events_csv, observables_csv, sample_table, shown, simulation_pictures,
    simulation_summary, trajectory_csv,
};
use flockproof::scenario::{End, Outcome, Scenario};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(after_help = "Files are written at the end, or when the run is stopped: what was reached is kept.\n\n\
Example:\n  flockproof simulate assets/scenarios/three_agents.toml --out out --animate")]
pub struct Arguments {
    /// Model, graph, start, law and times as TOML, see notes/simulate.md
    #[arg(value_name = "CONFIG")]
    config: PathBuf,
    /// Folder for summary.json, the CSV files and the plots; it is made if it is missing
    #[arg(long, value_name = "DIR", required_unless_present_any = ["html", "json"])]
    out: Option<PathBuf>,
    /// Write animation.html too, one page that plays the run in a browser
    #[arg(long, requires = "out")]
    animate: bool,
    /// Write the run as a page that needs no other file: the motion, samples, events and plots
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Print summary.json, flockproof.simulate/1, instead of the table
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let refuse = |error: &dyn std::fmt::Display| CliError::file(&arguments.config, error);
    let input = output::read_input(&arguments.config)?;
    let scenario = Scenario::read(&input.text).map_err(|error| refuse(&error))?;
    if arguments.animate && !scenario.has_positions() {
        return Err(CliError::Use("--animate: this model has phases only, without places".to_string()));
    }
    arguments.out.as_deref().map_or(Ok(()), output::make_folder)?;
    arguments.html.as_deref().map_or(Ok(()), output::check_writable)?;
    let watch = Watch::with(progress::styled("{bar:30} {percent} % of the time, {eta} left"));
    if !arguments.json {
        output::print(&declared(&scenario.declaration()))?;
    }
    let provenance = provenance(&scenario, &input);
    let outcome = scenario.run(&watch);
    watch.finish();
    interrupt::finishing();
    let summary = provenance.stamp(simulation_summary(&outcome));
    let written = match &arguments.out {
        Some(folder) => Some((write(&outcome, &summary, &provenance, folder, arguments.animate)?, folder)),
        None => None,
    };
    if let Some(path) = &arguments.html {
        let name = arguments.config.file_name().unwrap_or(arguments.config.as_os_str()).to_string_lossy();
        let command = format!("flockproof simulate {name} --html FILE");
        let page = shown::page(&format!("{name}: a run of {}", outcome.model), &command, &shown::simulation(&outcome));
        output::write_file(path, page.as_bytes())?;
    }
    if arguments.json {
        output::print_json(&summary)?;
    } else {
        let (table, events) = (sample_table(&outcome), outcome.events.len());
        let remarks = declared(&outcome.remarks);
        let events = format!("{events} event{}", if events == 1 { "" } else { "s" });
        let files = written.map_or(String::new(), |(names, folder)| {
            format!("{}in {}\n", declared(&[format!("written: {}", names.join(", "))]), folder.display())
        });
        let page = arguments.html.as_ref().map_or(String::new(), |path| format!("written: {}\n", path.display()));
        let origin = declared(&[provenance.line()]);
        output::print(&format!("\n{table}{remarks}{events}\n{origin}{files}{page}"))?;
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

/// Where a run comes from: all of its scenario.
fn provenance(scenario: &Scenario, input: &output::Input) -> Provenance {
    let configuration = json!({"command": "simulate", "file": input.origin, "toml": input.text});
    Provenance::new("flockproof.simulate/1", scenario.seed(), configuration)
}

/// Runs a scenario as it would come from standard input; what it leaves behind, and the summary of it.
pub fn ran(input: &output::Input, progress: &dyn Progress) -> Result<(Outcome, Value), CliError> {
    let scenario = Scenario::read(&input.text).map_err(|error| CliError::Use(error.to_string()))?;
    let provenance = provenance(&scenario, input);
    let outcome = scenario.run(progress);
    if let End::Failed(error) = &outcome.end {
        return Err(CliError::Use(format!("{error}; t = {} was reached", outcome.reached())));
    }
    let summary = provenance.stamp(simulation_summary(&outcome));
    Ok((outcome, summary))
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
    folder: &Path,
    animate: bool,
) -> Result<Vec<String>, CliError> {
    let file = |name: &str, contents: Vec<u8>| File { name: name.to_string(), contents };
    let mut files = vec![
        file("summary.json", format!("{summary:#}\n").into_bytes()),
        file("trajectory.csv", trajectory_csv(outcome).into_bytes()),
        file("observables.csv", observables_csv(outcome).into_bytes()),
        file("events.csv", events_csv(outcome).into_bytes()),
    ];
    files.push(file("about.txt", provenance.about(&files).into_bytes()));
    if animate {
        files.extend(animation(outcome).map(|page| file("animation.html", page.into_bytes())));
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
