//! `flock settle`: every switch, and whether the network can ever change again.

use super::super::interrupt::{self, Watch};
use super::super::{CliError, output, progress};
use super::output::{Log, SwitchLine, flocks, shortened, switch_json, tell};
use flockproof::arithmetic::{Progress, decimals};
use flockproof::averaging::read::{Model, read_flock};
use flockproof::averaging::settle::{Ending, Limits, Settlement, settle};
use flockproof::averaging::{Flock, Start, Switch, declaration};
use flockproof::report::Provenance;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(
    after_help = "The answer comes first and the list of all switches after it, except where the run is stopped; --log writes each switch as it is found.\n\n\
Examples:\n  flockproof flock settle assets/four_birds.json\n  flockproof flock settle birds.json --quiet --log log.jsonl"
)]
pub struct Arguments {
    /// The flock as JSON
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Print one JSON document, flockproof.flock-settle/1
    #[arg(long)]
    json: bool,
    /// Print the answer only, without the list of switches
    #[arg(long, short)]
    quiet: bool,
    /// Write every switch as it is found to this file, one JSON object per line
    #[arg(long, value_name = "LOG")]
    log: Option<PathBuf>,
    /// Exact steps on one network before giving up
    #[arg(long, value_name = "STEPS", default_value_t = Limits::default().steps)]
    steps: u64,
    /// Switches before giving up
    #[arg(long, value_name = "SWITCHES", default_value_t = Limits::default().switches)]
    switches: usize,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let input = output::read_input(&arguments.file)?;
    let flock = Flock::new(&start(&input, &arguments.file)?).map_err(|error| CliError::file(&arguments.file, error))?;
    let mut log = Log::new(arguments.log.as_deref())?;
    let watch = Watch::with(progress::styled("{spinner} {msg}, {elapsed}"));
    watch.bar().set_message("following the flock from switch to switch");
    let declared = declaration(&flock, None);
    tell(arguments.json, &format!("{declared}\n"))?;
    let mut network = flock.network().clone();
    let mut line = SwitchLine::new(&network);
    let mut switches = Vec::new();
    let mut failure = None;
    let limits = Limits { steps: arguments.steps, switches: arguments.switches, ..Limits::default() };
    let mut found = |switch: &Switch| {
        switch.apply_to(&mut network);
        let event = switch_json(switch);
        if !arguments.json && !arguments.quiet {
            interrupt::keep(&line.of(switch, &network));
        }
        let written = log.write(&event);
        switches.push(event);
        watch.bar().set_message(format!("{} switches, the last at t = {}", switches.len(), shortened(&switch.time)));
        if let Err(error) = written {
            failure = Some(error);
            watch.stop();
        }
    };
    let settled = settle(flock, &limits, &mut found, &watch);
    if let Some(error) = failure {
        return Err(error);
    }
    let settled = settled.map_err(|error| CliError::file(&arguments.file, error))?;
    watch.finish();
    interrupt::finishing();
    if arguments.json {
        output::print_json(&stamped(&input, &limits, document(&settled, switches, &declared)))?;
    } else {
        let head = output::counted(switches.len(), "switch");
        let list = interrupt::kept();
        let tail = if list.is_empty() { format!("{head}\n") } else { format!("{head}:\n{list}") };
        output::print(&(closing(&settled) + &tail))?;
    }
    Ok(match settled.ending {
        Ending::Interrupted => ExitCode::from(interrupt::STATUS),
        _ => ExitCode::SUCCESS,
    })
}

/// The start of a flock that can be settled.
fn start(input: &output::Input, path: &Path) -> Result<Start, CliError> {
    match read_flock(&input.text).map_err(|error| CliError::file(path, error))?.model {
        Model::D { start, control: None } => Ok(start),
        Model::D { control: Some(_), .. } => {
            let why = "`flock settle` follows flocks without `control`; `flock run` steps this one";
            Err(CliError::file(path, why))
        }
        Model::K { .. } => {
            let why = "`flock settle` follows model D only, as the positions of model K are not rational; \
                       `flock run` steps it";
            Err(CliError::file(path, why))
        }
    }
}

fn stamped(input: &output::Input, limits: &Limits, document: Value) -> Value {
    let limits = json!({"steps": limits.steps, "switches": limits.switches});
    let configuration = json!({"command": "flock settle", "file": input.origin, "limits": limits});
    Provenance::new("flockproof.flock-settle/1", None, configuration).stamp(document)
}

/// A flock that was settled.
pub struct Settled {
    pub document: Value,
    pub start: Start,
    pub switches: Vec<Switch>,
    pub settlement: Settlement,
}

/// Settles a flock as it would come from standard input.
pub fn settled(input: &output::Input, progress: &dyn Progress) -> Result<Settled, CliError> {
    let path = Path::new("-");
    let start = start(input, path)?;
    let flock = Flock::new(&start).map_err(|error| CliError::file(path, error))?;
    let (declared, limits) = (declaration(&flock, None), Limits::default());
    let mut switches = Vec::new();
    let mut found = |switch: &Switch| {
        switches.push(switch.clone());
        progress.tell("switches", switches.len() as u64, None);
    };
    let settlement = settle(flock, &limits, &mut found, progress).map_err(|error| CliError::file(path, error))?;
    let list = switches.iter().map(switch_json).collect();
    let document = stamped(input, &limits, document(&settlement, list, &declared));
    Ok(Settled { document, start, switches, settlement })
}

fn document(settled: &Settlement, switches: Vec<Value>, declared: &str) -> Value {
    let steady = matches!(settled.ending, Ending::Steady).then(|| settled.last_switch.to_string());
    let mut document = json!({
        "declaration": declared,
        "switches": switches,
        "flocks": flocks(&settled.network),
        "steady_from": steady,
        "ending": word(&settled.ending),
        "why": settled.why,
    });
    match &settled.ending {
        Ending::Beyond { pairs, log2_steps } => {
            let (lo, hi) = decimals(log2_steps, 20);
            let pairs: Vec<[usize; 2]> = pairs.iter().map(|(i, j)| [i + 1, j + 1]).collect();
            document["next"] = json!({"one_of": pairs, "log2_steps": {"lo": lo, "hi": hi}});
        }
        Ending::Alternating { period } => document["period"] = json!(period),
        _ => {}
    }
    document
}

fn word(ending: &Ending) -> &'static str {
    match ending {
        Ending::Steady => "steady",
        Ending::Alternating { .. } => "alternating",
        Ending::Beyond { .. } => "beyond",
        Ending::Undecided(_) => "undecided",
        Ending::Interrupted => "interrupted",
    }
}

fn closing(settled: &Settlement) -> String {
    let list: Vec<String> = flocks(&settled.network).iter().map(|flock| format!("{flock:?}")).collect();
    let last = super::output::shortened(&settled.last_switch);
    let verdict = match &settled.ending {
        Ending::Steady => format!("steady from t = {last} on"),
        Ending::Alternating { period } => format!("alternates forever with period {period}"),
        Ending::Beyond { log2_steps, .. } => {
            let (lo, hi) = decimals(log2_steps, 12);
            format!("the next contact comes 2^L steps after t = {last},\nL in [{lo}, {hi}]")
        }
        Ending::Undecided(_) => "undecided".to_string(),
        Ending::Interrupted => "interrupted".to_string(),
    };
    let text = format!("{verdict}\nflocks: {}\n{}\n", list.join(" "), settled.why);
    textwrap::fill(&text, output::width().min(100)) + "\n"
}
