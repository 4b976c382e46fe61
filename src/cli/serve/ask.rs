//! A question of a live page: checked, then put to the command line.

use serde_json::{Map, Value};
use std::io::{Read, Write};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// How long one question may take.
const LONGEST: Duration = Duration::from_secs(20);
/// The longest answer, in bytes.
const LARGEST: u64 = 4 << 20;
const TICK: Duration = Duration::from_millis(20);

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
pub enum AskError {
    /// No such question.
    #[error("there is nothing here")]
    Unknown,
    /// What is wrong with it.
    #[error("{0}")]
    Refused(String),
}

fn refused(why: impl Into<String>) -> AskError {
    AskError::Refused(why.into())
}

/// The answer as JSON.
///
/// # Errors
/// [`AskError`].
pub fn answer(what: &str, text: &str) -> Result<Vec<u8>, AskError> {
    let question: Map<String, Value> =
        serde_json::from_str(text).map_err(|error| refused(format!("the question is no JSON object: {error}")))?;
    let word = |name: &str| question.get(name).and_then(Value::as_str).unwrap_or_default();
    match what {
        "resonance" => {
            let followers: u64 = word("followers")
                .parse()
                .ok()
                .filter(|n| (1..=1_000_000_000_000).contains(n))
                .ok_or_else(|| refused("followers: a number from 1 to 10^12"))?;
            let (f, g) = (number(word("f"))?, number(word("g"))?);
            run(
                &[
                    "resonance".into(),
                    format!("--followers={followers}"),
                    format!("--f={f}"),
                    format!("--g={g}"),
                    "--digits=15".into(),
                    "--json".into(),
                ],
                "",
            )
        }
        "spectrum" => {
            let (graph, kind) = (graph(word("graph"))?, kind(word("kind"))?);
            run(&["spectrum".into(), format!("--graph={graph}"), format!("--kind={kind}"), "--json".into()], "")
        }
        "flock" => {
            let birds = question.get("positions").and_then(Value::as_array).map_or(0, Vec::len);
            if !(1..=24).contains(&birds) {
                return Err(refused("positions: 1 to 24 birds"));
            }
            run(&["flock".into(), "settle".into(), "-".into(), "--json".into()], text)
        }
        _ => Err(AskError::Unknown),
    }
}

/// An integer, fraction or decimal of at most 40 characters.
fn number(text: &str) -> Result<&str, AskError> {
    let good = !text.is_empty() && text.len() <= 40 && text.chars().all(|c| c.is_ascii_digit() || "-./".contains(c));
    if good { Ok(text) } else { Err(refused("a number is an integer, a fraction or a decimal")) }
}

/// A named graph with at most 400 vertices: never the name of a file.
fn graph(text: &str) -> Result<&str, AskError> {
    let (name, rest) = text.split_once(':').ok_or_else(|| refused("a graph is a name and a size, such as ring:12"))?;
    let numbers = rest.split([':', ',', '/']).all(|part| part.parse::<u64>().is_ok_and(|n| n <= 400));
    let good = !name.is_empty() && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-');
    if good && numbers {
        Ok(text)
    } else {
        Err(refused("a graph is a name and sizes up to 400, such as circulant:12:1,3"))
    }
}

fn kind(text: &str) -> Result<&str, AskError> {
    let kinds = ["laplacian", "out-degree", "in-degree", "normalised", "walk", "adjacency"];
    kinds.into_iter().find(|kind| *kind == text).ok_or_else(|| refused(format!("kind: one of {}", kinds.join(", "))))
}

/// Runs this program with arguments and a standard input.
fn run(arguments: &[String], input: &str) -> Result<Vec<u8>, AskError> {
    let program = std::env::current_exe().map_err(|error| refused(format!("the program cannot be found: {error}")))?;
    let mut child = Command::new(program)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|error| refused(format!("the program cannot be started: {error}")))?;
    if let Some(mut pipe) = child.stdin.take() {
        // What is not read is not missed: the program says why it stopped.
        let _ = pipe.write_all(input.as_bytes());
    }
    // Both are read while it runs, so that it does not wait for us.
    let reader = |pipe: Option<Box<dyn Read + Send>>| {
        std::thread::spawn(move || {
            let mut bytes = Vec::new();
            let _ = pipe.map(|pipe| pipe.take(LARGEST).read_to_end(&mut bytes));
            bytes
        })
    };
    let out = reader(child.stdout.take().map(|pipe| Box::new(pipe) as _));
    let err = reader(child.stderr.take().map(|pipe| Box::new(pipe) as _));
    let begun = Instant::now();
    let status = loop {
        match child.try_wait() {
            Ok(Some(status)) => break Some(status),
            Ok(None) if begun.elapsed() < LONGEST && !super::super::interrupt::happened() => std::thread::sleep(TICK),
            _ => {
                let _ = child.kill();
                let _ = child.wait();
                break None;
            }
        }
    };
    let (out, err) = (out.join().unwrap_or_default(), err.join().unwrap_or_default());
    match status {
        Some(status) if status.success() => Ok(out),
        Some(_) => Err(refused(String::from_utf8_lossy(&err).trim().trim_start_matches("error: ").to_string())),
        None => Err(refused(format!(
            "not decided within {} seconds; the command line has no such limit",
            LONGEST.as_secs()
        ))),
    }
}
