//! What may notice an alteration: claims and tests; which alterations each reaches, and whether it notices one.

use std::collections::BTreeSet;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};

/// A program whose parts can be run by name.
pub struct Program {
    pub file: PathBuf,
    pub folder: PathBuf,
    /// The command line with claims; else a test program.
    pub is_ledger: bool,
}

/// A claim or a test.
pub struct Probe {
    pub program: usize,
    pub name: String,
    pub seconds: f64,
    pub reach: BTreeSet<u32>,
}

/// What became of a run.
pub enum Outcome {
    Clean,
    /// The names of those that noticed.
    Noticed(Vec<String>),
}

/// The names of a program's parts.
pub fn names(program: &Program, root: &Path) -> Result<Vec<String>, String> {
    if program.is_ledger {
        let table = root.join("crates/claims/src/recorded.tsv");
        let text = std::fs::read_to_string(&table).map_err(|error| format!("{}: {error}", table.display()))?;
        return Ok(text.lines().skip(1).filter_map(|row| row.split('\t').next()).map(String::from).collect());
    }
    let output = Command::new(&program.file)
        .args(["--list", "--format", "terse"])
        .current_dir(&program.folder)
        .output()
        .map_err(|error| format!("{}: {error}", program.file.display()))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    Ok(text.lines().filter_map(|line| line.strip_suffix(": test")).map(String::from).collect())
}

/// The processor time is limited, so that the load of the machine does not matter; memory too. What was used goes to `ALTERED_TIMES`.
fn command(program: &Program, names: &[&str], limit: u64) -> Command {
    let mut command = Command::new("sh");
    let run =
        "\"$0\" \"$@\"; status=$?; if [ -n \"$ALTERED_TIMES\" ]; then times > \"$ALTERED_TIMES\"; fi; exit $status";
    command.arg("-c").arg(format!("ulimit -c 0; ulimit -t {limit}; ulimit -v 6000000; {run}"));
    command.arg(&program.file);
    if program.is_ledger {
        command.args(["verify", "--threads", "1"]);
        names.iter().for_each(|name| {
            command.args(["--claim", name]);
        });
    } else {
        command.args(["--exact", "--test-threads=1"]).args(names);
    }
    command
        .current_dir(&program.folder)
        .env("CARGO_MANIFEST_DIR", &program.folder)
        .env("RAYON_NUM_THREADS", "1")
        .env("RUST_BACKTRACE", "0")
        .env("COLUMNS", "200")
        // The same cases each time, none kept, and no search for smaller ones.
        .env("PROPTEST_RNG_SEED", "1")
        .env("PROPTEST_DISABLE_FAILURE_PERSISTENCE", "1")
        .env("PROPTEST_MAX_SHRINK_ITERS", "0")
        .stdin(Stdio::null());
    command
}

/// Runs one part unaltered: whether it passes, how long it takes, and what it reaches.
pub fn record(program: &Program, name: &str, limit: u64, log: &Path) -> Result<Option<(f64, BTreeSet<u32>)>, String> {
    let _ = std::fs::remove_file(log);
    let times = log.with_extension("times");
    let status = command(program, &[name], limit)
        .env("ALTERED", "record")
        .env("ALTERED_LOG", log)
        .env("ALTERED_TIMES", &times)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .map_err(|error| format!("{}: {error}", program.file.display()))?;
    let seconds = processor_seconds(&std::fs::read_to_string(&times).unwrap_or_default());
    let reach = std::fs::read_to_string(log).unwrap_or_default().lines().filter_map(|k| k.parse().ok()).collect();
    Ok(status.success().then_some((seconds, reach)))
}

/// User and system time of the children, from the second line of what `times` prints: `0m1.250s 0m0.010s`.
fn processor_seconds(times: &str) -> f64 {
    let one = |word: &str| {
        let (minutes, seconds) = word.strip_suffix('s')?.split_once('m')?;
        Some(60.0 * minutes.parse::<f64>().ok()? + seconds.parse::<f64>().ok()?)
    };
    times.lines().nth(1).unwrap_or_default().split_whitespace().filter_map(one).sum()
}

/// Runs parts of one program with one alteration.
pub fn run(program: &Program, names: &[&str], k: u32, seconds: f64, out: &Path) -> Result<Outcome, String> {
    let limit = (4.0 + 8.0 * seconds).ceil() as u64;
    let file = File::create(out).map_err(|error| format!("{}: {error}", out.display()))?;
    let status = command(program, names, limit)
        .env("ALTERED", k.to_string())
        .stdout(file)
        .stderr(Stdio::null())
        .status()
        .map_err(|error| format!("{}: {error}", program.file.display()))?;
    if status.success() {
        return Ok(Outcome::Clean);
    }
    let text = String::from_utf8_lossy(&std::fs::read(out).unwrap_or_default()).into_owned();
    let mut noticed: Vec<String> = if program.is_ledger {
        let said = text.lines().filter_map(|line| line.strip_prefix("DIFFERS "));
        said.filter_map(|line| line.split(':').next()).map(String::from).collect()
    } else {
        let failed = |line: &str| line.strip_prefix("test ")?.strip_suffix(" ... FAILED").map(String::from);
        text.lines().filter_map(failed).collect()
    };
    noticed.sort();
    noticed.dedup();
    if noticed.is_empty() {
        let more = if names.len() > 1 { format!(" (with {} more)", names.len() - 1) } else { String::new() };
        let first = names.first().unwrap_or(&"");
        noticed.push(format!("{first}{more}: {}", ended(status)));
    }
    Ok(Outcome::Noticed(noticed))
}

fn ended(status: ExitStatus) -> &'static str {
    use std::os::unix::process::ExitStatusExt;
    match (status.signal(), status.code()) {
        (Some(24 | 9), _) | (None, Some(152 | 137)) => "does not end",
        (Some(_), _) | (None, Some(129..)) => "is aborted",
        _ => "fails",
    }
}
