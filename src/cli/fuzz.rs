//! `fuzz`: campaigns of random cases over what must always be true.

use super::interrupt::{self, Watch};
use super::{CliError, check, output, progress};
use flockproof::arithmetic::Progress;
use flockproof::campaign::fuzz::{Again, Attack, Failed, Fuzz, Replay, Summary, one_case};
use flockproof::campaign::invariants::{Checked, Stop, Tested, find, table};
use flockproof::campaign::job::Campaign;
use flockproof::campaign::store::{Run, Shard, merge, run_in_memory, run_shard};
use flockproof::report::Provenance;
use serde_json::{Value, json};
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

#[derive(clap::Args)]
pub struct Arguments {
    /// Names of invariants, none meaning all; or the file of one question
    #[arg(value_name = "INVARIANT|QUESTION.toml")]
    names: Vec<String>,
    /// List the invariants
    #[arg(long)]
    list: bool,
    /// Random cases of each invariant
    #[arg(long, value_name = "N", default_value_t = 1000, allow_negative_numbers = true)]
    cases: u64,
    /// Seed of the random cases, any text
    #[arg(long, value_name = "S", default_value = "0")]
    seed: String,
    /// Only this part of the cases, i/n with i from 1 to n
    #[arg(long, value_name = "i/n", requires = "store")]
    shard: Option<Shard>,
    /// Folder for the finished cases
    #[arg(long, value_name = "DIR")]
    store: Option<PathBuf>,
    /// Go on with what the folder has
    #[arg(long, requires = "store")]
    resume: bool,
    /// Put the shards of a folder together
    #[arg(long, value_name = "DIR", conflicts_with_all = ["names", "list", "cases", "seed", "shard", "store", "resume", "case", "replay"])]
    merge: Option<PathBuf>,
    /// Only this case of one invariant
    #[arg(long, value_name = "K", allow_negative_numbers = true, conflicts_with_all = ["list", "cases", "shard", "store", "replay"])]
    case: Option<u64>,
    /// Decide the case of a replay file
    #[arg(long, value_name = "FILE", conflicts_with_all = ["names", "list", "cases", "seed", "shard", "store"])]
    replay: Option<PathBuf>,
    /// Print one JSON document: flockproof.fuzz/1, of --case and --replay flockproof.fuzz-case/1, of --list flockproof.invariants/1
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    if arguments.list {
        return list(arguments.json);
    }
    if let Some(folder) = &arguments.merge {
        return merged(folder, arguments.json);
    }
    if let Some(path) = &arguments.replay {
        let text = output::read_input(path)?.text;
        let replay = Replay::read(&text).map_err(|error| CliError::file(path, error))?;
        let configuration = json!({"command": "fuzz", "replay": text});
        return told(replay.invariant.id, &replay.decide(), Some(&replay), (arguments.json, None, configuration));
    }
    if let Some(file) = arguments.names.iter().find(|name| is_question(name)) {
        return attack(Path::new(file), arguments);
    }
    let fuzz = Fuzz::new(&arguments.names, arguments.cases, &arguments.seed).map_err(refused)?;
    if let Some(case) = arguments.case {
        let [invariant] = fuzz.invariants() else {
            return Err(CliError::Use("--case is for one invariant, which has to be named".to_string()));
        };
        let (checked, _) = one_case(invariant, fuzz.seed(), case, Tested::AsItIs);
        let configuration = json!({"command": "fuzz", "invariant": invariant.id, "seed": fuzz.seed(), "case": case});
        return told(invariant.id, &checked, None, (arguments.json, Some(fuzz.seed()), configuration));
    }
    campaign(&fuzz, &fuzz.names(), None, arguments)
}

/// Whether a name is that of a file, and of no invariant.
fn is_question(name: &str) -> bool {
    name == "-" || name.ends_with(".toml") || (find(name).is_none() && Path::new(name).is_file())
}

/// Random members of the family of a question.
fn attack(path: &Path, arguments: &Arguments) -> Result<ExitCode, CliError> {
    if arguments.names.len() > 1 {
        return Err(CliError::Use("a question is attacked alone, without invariants or other questions".to_string()));
    }
    if arguments.case.is_some() {
        return Err(CliError::Use("--case is for invariants; a counterexample is a question for `check`".to_string()));
    }
    let question = check::read(path)?;
    if question.law_name().is_some() {
        let why = "`check` decides questions about all states, and looks for counterexamples at random states itself";
        return Err(CliError::file(path, why));
    }
    let attack = Attack::new(question, arguments.cases, &arguments.seed).map_err(|e| CliError::file(path, e))?;
    campaign(&attack, &[attack.id()], Some(path), arguments)
}

fn refused(error: impl std::fmt::Display) -> CliError {
    CliError::Use(error.to_string())
}

fn list(json: bool) -> Result<ExitCode, CliError> {
    if json {
        let row = |i: &flockproof::campaign::invariants::Invariant| json!({"id": i.id, "statement": i.statement, "control": i.control});
        let provenance = Provenance::new("flockproof.invariants/1", None, json!({"command": "fuzz", "list": true}));
        output::print_json(&provenance.stamp(json!({"invariants": table().map(row).collect::<Vec<_>>()})))?;
    } else {
        let width = output::width().min(100);
        let indent = textwrap::Options::new(width).initial_indent("    ").subsequent_indent("    ");
        for invariant in table() {
            let text = textwrap::fill(invariant.statement, &indent);
            output::print(&format!("{}\n{text}\n", invariant.id))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// One case in words, or as JSON with its seed and configuration, compared with its recording where it has one; exit status 1 where it fails.
fn told(
    id: &str,
    checked: &Checked,
    recording: Option<&Replay>,
    (json, seed, configuration): (bool, Option<&str>, Value),
) -> Result<ExitCode, CliError> {
    let (verdict, why, instance, margin) = match checked {
        Ok(margin) => ("holds", "", "", *margin),
        Err(Stop::Undecided(why)) => ("undecided", why.as_str(), "", None),
        Err(Stop::Fails { why, instance }) => ("fails", why.as_str(), instance.as_str(), None),
    };
    let again = recording.map(|replay| replay.compared(checked));
    if json {
        let margin = margin.map(|margin| format!("~{margin:?}"));
        let provenance = Provenance::new("flockproof.fuzz-case/1", seed, configuration);
        output::print_json(&provenance.stamp(json!({
            "invariant": id, "verdict": verdict, "why": why, "instance": instance, "margin": margin,
            "again": again.map(Again::word)
        })))?;
    } else {
        let margin = margin.map_or(String::new(), |margin| format!(", margin {margin:?}"));
        let mut lines = vec![format!("{id}: {verdict}{margin}"), why.to_string(), instance.to_string()];
        if let (Some(again), Some(replay)) = (again, recording) {
            let (then, case) = &replay.recorded;
            let recorded = if again == Again::Same { String::new() } else { format!("recorded: {then}\n{case}") };
            lines.extend([again.sentence().to_string(), recorded]);
        }
        let lines: Vec<&str> = lines.iter().map(|line| line.trim_end()).filter(|line| !line.is_empty()).collect();
        output::print(&(lines.join("\n") + "\n"))?;
    }
    Ok(ExitCode::from(u8::from(verdict == "fails")))
}

fn campaign(
    fuzz: &dyn Campaign,
    names: &[&str],
    asked: Option<&Path>,
    arguments: &Arguments,
) -> Result<ExitCode, CliError> {
    let started = Instant::now();
    let watch = Watch::with(progress::bar());
    let run = match &arguments.store {
        None => run_in_memory(fuzz, &watch).map_err(refused)?,
        Some(store) => {
            let shard = arguments.shard.unwrap_or(Shard::WHOLE);
            run_shard(fuzz, store, shard, arguments.resume, &watch).map_err(refused)?
        }
    };
    interrupt::finishing();
    watch.finish();
    let summary = Summary::new(names, &arguments.seed, run.cases, &run.rows).map_err(refused)?;
    if std::io::stderr().is_terminal() {
        let seconds = started.elapsed().as_secs_f64();
        eprintln!("{:.0} cases a second", summary.cases() as f64 / seconds.max(1e-9));
    }
    told_interrupted(&run, &watch);
    let code = finished(&summary, &fuzz.canonical(), (arguments.store.as_deref(), asked), arguments.json)?;
    Ok(if run.is_complete() { code } else { interrupt::status(false) })
}

fn told_interrupted(run: &Run, watch: &dyn Progress) {
    if !run.is_complete() && watch.is_cancelled() {
        eprintln!("interrupted: {} of {} jobs are finished", run.rows.len(), run.cases);
    }
}

fn merged(folder: &Path, json: bool) -> Result<ExitCode, CliError> {
    let merged = merge(folder).map_err(refused)?;
    let (jobs, rows) = (merged.header.cases, &merged.rows);
    let summary = if let Some((id, seed)) = Attack::named(&merged.header.campaign) {
        Summary::new(&[&id], &seed, jobs, rows)
    } else {
        let fuzz = Fuzz::read(&merged.header.campaign).map_err(|error| CliError::file(folder, error))?;
        Summary::new(&fuzz.names(), fuzz.seed(), jobs, rows)
    };
    let summary = summary.map_err(|error| CliError::file(folder, error))?;
    finished(&summary, &merged.header.campaign, (Some(folder), None), json)
}

/// Prints a summary and writes its failures, one file each: a question for `check`, or a replay of an invariant to the store. `asked` is the file of the
/// question, where it is known.
fn finished(
    summary: &Summary,
    canonical: &str,
    (store, asked): (Option<&Path>, Option<&Path>),
    json: bool,
) -> Result<ExitCode, CliError> {
    for own in &summary.invariants {
        for failed in &own.failures {
            if let Some(path) = file_of(store, &own.id, failed) {
                let text = match (&failed.question, asked) {
                    (Some(text), Some(asked)) => check::from_elsewhere(text, asked),
                    (Some(text), None) => text.clone(),
                    (None, _) => Replay::text(&own.id, failed),
                };
                output::write_file(&path, text.as_bytes())?;
            }
        }
    }
    if json {
        let campaign: Value = serde_json::from_str(canonical).unwrap_or_else(|_| canonical.into());
        let configuration = json!({"command": "fuzz", "campaign": campaign});
        let provenance = Provenance::new("flockproof.fuzz/1", Some(&summary.seed), configuration);
        output::print_json(&provenance.stamp(summary.to_json()))?;
    } else {
        output::print(&text(summary, store))?;
    }
    Ok(match (summary.failed() > 0, summary.controls_bite()) {
        (_, false) => ExitCode::from(WITHHELD),
        (failed, true) => ExitCode::from(u8::from(failed)),
    })
}

/// As `check` ends where a control is not refuted.
const WITHHELD: u8 = 4;

/// Where a failure is written: to the store, and a question without a store where `check` writes it, too.
fn file_of(store: Option<&Path>, id: &str, failed: &Failed) -> Option<PathBuf> {
    let name = format!("failure-{id}-{}", failed.case);
    match (&failed.question, store) {
        (Some(_), store) => Some(store.unwrap_or(Path::new(".")).join(name + ".toml")),
        (None, store) => Some(store?.join(name + ".json")),
    }
}

fn text(summary: &Summary, store: Option<&Path>) -> String {
    let widest = summary.invariants.iter().map(|own| own.id.len()).max().unwrap_or(0);
    let mut text =
        format!("{:<widest$} {:>10} {:>7} {:>10} {:>12}\n", "invariant", "cases", "failed", "undecided", "margin");
    for own in &summary.invariants {
        let margin = own.margin.map_or(String::new(), |margin| format!("{:.4e}", margin.value));
        text.push_str(&format!(
            "{:<widest$} {:>10} {:>7} {:>10} {margin:>12}\n",
            own.id, own.cases, own.failed, own.undecided
        ));
    }
    for own in summary.invariants.iter().filter(|own| !own.controls.is_empty()) {
        let (refuted, total) = (own.refuted(), own.controls.len());
        text.push_str(&format!("controls refuted: {refuted} of {total}\n"));
        if refuted < total {
            text.push_str("A control that no case refutes shows no bite: nothing follows from these cases.\n");
        }
    }
    for own in &summary.invariants {
        for failed in &own.failures {
            let statement = find(&own.id).map_or("", |invariant| invariant.statement);
            text.push_str(&format!("\n{} fails in case {}: {}\n", own.id, failed.case, failed.why));
            let lines = [statement, &failed.instance];
            lines.iter().filter(|line| !line.is_empty()).for_each(|line| text.push_str(&format!("{line}\n")));
            text.push_str(&match (file_of(store, &own.id, failed), &failed.question) {
                (Some(path), Some(_)) => format!("flockproof check {}\n", path.display()),
                (Some(path), None) => format!("flockproof fuzz --replay {}\n", path.display()),
                (None, _) => format!("flockproof fuzz {} --seed {} --case {}\n", own.id, summary.seed, failed.case),
            });
        }
    }
    text
}
