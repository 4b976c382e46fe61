//! `simulate`: a flock of one's own from a TOML file.

mod ensemble;

use super::interrupt::{self, Watch};
use super::{CliError, output, progress};
use flockproof::arithmetic::Progress;
use flockproof::campaign::store::Shard;
use flockproof::report::{
    File, Provenance, animation, events_csv, npz, observables_csv, sample_table, shown, simulation_arrays,
    simulation_pictures, simulation_summary, trajectory_csv,
};
use flockproof::scenario::{ConfigError, End, Ensemble, Outcome, Scenario, with_law};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::{Arc, Mutex, PoisonError};

#[derive(clap::Args, Clone)]
#[command(
    after_help = "Files are written at the end, or when the run is stopped: what was reached is kept, and a single run begins again.\n\n\
A file with [ensemble] replicas = 100, or with numbers in [sweep], makes many runs, on all cores: members.csv has the observables of each at the \
samples, statistics.csv means and standard deviations. Finished runs are kept as they are finished.\n\n\
Examples:\n  flockproof simulate assets/scenarios/three_agents.toml --out out --animate\n  \
flockproof simulate assets/scenarios/noise_sweep.toml --out out --resume"
)]
pub struct Arguments {
    /// Model, graph, start, law and times as TOML, see notes/simulate.md
    #[arg(value_name = "CONFIG")]
    config: PathBuf,
    /// Folder for summary.json, the CSV files, run.npz and the plots; it is made if it is missing
    #[arg(long, value_name = "DIR", required_unless_present_any = ["html", "json"])]
    out: Option<PathBuf>,
    /// Write animation.html too, one page that plays the run in a browser
    #[arg(long, requires = "out")]
    animate: bool,
    /// Write the run as a page that needs no other file: the motion, samples, events and plots
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Of many runs only this one, with all files of a single run; from 1
    #[arg(long, value_name = "K", allow_negative_numbers = true, conflicts_with_all = ["shard", "resume", "merge"])]
    member: Option<u64>,
    /// Of many runs only this part, i/n with i from 1 to n
    #[arg(long, value_name = "i/n")]
    shard: Option<Shard>,
    /// Go on with the runs that the folder has
    #[arg(long)]
    resume: bool,
    /// Put the parts in the folder together
    #[arg(long, conflicts_with_all = ["shard", "resume"])]
    merge: bool,
    /// Print summary.json, flockproof.simulate/1 or flockproof.ensemble/1, instead of the table
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let mut input = output::read_input(&arguments.config)?;
    let files = output::beside(&arguments.config);
    let whole = with_law(&input.text, &files).map_err(|error| CliError::file(&arguments.config, error))?;
    input.text = whole.text().to_string();
    let refuse = |error: &ConfigError| CliError::file(&arguments.config, whole.told(error));
    let ensemble = Ensemble::read(&input.text).map_err(|error| refuse(&error))?;
    let scenario = match (&ensemble, arguments.member) {
        (Some(ensemble), None) => return ensemble::run(arguments, ensemble, &input),
        (Some(ensemble), Some(member)) => {
            let count = ensemble.members();
            let place = member.checked_sub(1).filter(|place| *place < count);
            let place = place.ok_or_else(|| CliError::Use(format!("--member: there are the runs 1 to {count}")))?;
            ensemble.member(place)
        }
        (None, _) => {
            let options = [("member", arguments.member.is_some()), ("shard", arguments.shard.is_some())];
            let more = [("resume", arguments.resume), ("merge", arguments.merge)];
            if let Some((name, _)) = options.into_iter().chain(more).find(|(_, given)| *given) {
                let why = "is for many runs, and the file has neither [ensemble] nor [sweep]";
                return Err(CliError::Use(format!("--{name} {why}")));
            }
            Scenario::read(&input.text)
        }
    };
    let scenario = scenario.map_err(|error| refuse(&error))?;
    if arguments.animate && !scenario.has_positions() {
        return Err(CliError::Use("--animate: this model has phases only, without places".to_string()));
    }
    arguments.out.as_deref().map_or(Ok(()), output::make_folder)?;
    arguments.html.as_deref().map_or(Ok(()), output::check_writable)?;
    let watch = Watch::with(progress::styled("{wide_bar} {percent} % of the time, {eta} left"));
    let ending = Ending { arguments: arguments.clone(), provenance: provenance(&scenario, &input, arguments.member) };
    let reached = Arc::new(Mutex::new(scenario.outset()));
    // One step of a large flock takes longer than who stops the work waits.
    interrupt::at_last({
        let (ending, reached) = (ending.clone(), reached.clone());
        move || {
            let reached = reached.lock().unwrap_or_else(PoisonError::into_inner);
            if let Err(error) = ending.written(&reached) {
                output::complain(&error.to_string());
            }
        }
    });
    if !arguments.json {
        output::print(&declared(&scenario.declaration()))?;
    }
    scenario.run_into(&watch, &reached);
    watch.finish();
    interrupt::finishing();
    let outcome = reached.lock().unwrap_or_else(PoisonError::into_inner);
    ending.written(&outcome)
}

/// What a run ends with, wherever it is stopped.
#[derive(Clone)]
struct Ending {
    arguments: Arguments,
    provenance: Provenance,
}

impl Ending {
    /// Writes and prints an outcome.
    fn written(&self, outcome: &Outcome) -> Result<ExitCode, CliError> {
        let Ending { arguments, provenance } = self;
        let summary = provenance.stamp(simulation_summary(outcome));
        let written = match &arguments.out {
            Some(folder) => Some((write(outcome, &summary, provenance, folder, arguments.animate)?, folder)),
            None => None,
        };
        if let Some(path) = &arguments.html {
            let name = arguments.config.file_name().unwrap_or(arguments.config.as_os_str()).to_string_lossy();
            let command = format!("flockproof simulate {name} --html FILE");
            let title = format!("{name}: a run of {}", outcome.model);
            output::write_file(path, shown::page(&title, &command, &shown::simulation(outcome)).as_bytes())?;
        }
        if arguments.json {
            output::print_json(&summary)?;
        } else {
            let (table, events) = (sample_table(outcome), outcome.events.len());
            let remarks = declared(&outcome.remarks);
            let events = output::counted(events, "event");
            let files = written.map_or(String::new(), |(names, folder)| {
                format!("{}in {}\n", declared(&[format!("written: {}", names.join(", "))]), folder.display())
            });
            let page = arguments.html.as_ref().map_or(String::new(), |path| format!("written: {}\n", path.display()));
            let origin = declared(&[provenance.line()]);
            output::print(&format!("\n{table}{remarks}{events}\n{origin}{files}{page}"))?;
        }
        let kept = format!("what was reached up to t = {} is kept", outcome.reached());
        match &outcome.end {
            End::Finished if !interrupt::happened() => Ok(ExitCode::SUCCESS),
            End::Finished | End::Interrupted => {
                eprintln!("interrupted: {kept}");
                Ok(ExitCode::from(interrupt::STATUS))
            }
            End::Failed(error) => Err(CliError::file(&arguments.config, format!("{error}; {kept}"))),
        }
    }
}

/// Where a run comes from: all of its scenario, and which of many runs it is.
fn provenance(scenario: &Scenario, input: &output::Input, member: Option<u64>) -> Provenance {
    let mut configuration = json!({"command": "simulate", "file": input.origin, "toml": input.text});
    if let Some(member) = member {
        configuration["member"] = member.into();
    }
    Provenance::new("flockproof.simulate/1", scenario.seed(), configuration)
}

/// Runs a scenario as it would come from standard input; what it leaves behind, and the summary of it.
pub fn ran(input: &output::Input, progress: &dyn Progress) -> Result<(Outcome, Value), CliError> {
    let scenario = Scenario::read(&input.text).map_err(|error| CliError::Use(error.to_string()))?;
    let provenance = provenance(&scenario, input, None);
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
    files.push(file("run.npz", npz(&simulation_arrays(outcome))));
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
