//! The process that answers one question: it can open no file, uses bounded memory, and ends when nobody waits any more.

use super::super::{CliError, output};
use super::ask;
use flockproof::arithmetic::Progress;
use serde_json::json;
use std::io::{BufRead, Read};
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Least time between two messages about progress.
const PAUSE: Duration = Duration::from_millis(100);

/// Reads the length of a question and the question from standard input, and writes lines of JSON; `memory` is in MiB.
pub fn run(what: &str, memory: u64) -> Result<ExitCode, CliError> {
    confine(memory)?;
    let question = read()?;
    // Who asked holds the other end of standard input as long as the answer is wanted.
    std::thread::spawn(|| {
        let _ = std::io::stdin().lock().read(&mut [0]);
        std::process::exit(0);
    });
    let progress = Told { last: Mutex::new(None) };
    let line = match ask::answer(what, &question, &progress) {
        Ok(answered) => json!({"answer": answered.document, "shown": answered.shown}),
        Err(error) => json!({"refused": error.to_string().trim_start_matches("-: ")}),
    };
    output::print(&format!("{line}\n"))?;
    Ok(ExitCode::SUCCESS)
}

fn read() -> Result<String, CliError> {
    let lost = |error: std::io::Error| CliError::Use(format!("standard input: {error}"));
    // Byte by byte up to the end of the line: what follows is the question.
    let mut input = std::io::stdin().lock();
    let mut length = String::new();
    input.read_line(&mut length).map_err(lost)?;
    let length: usize = length.trim().parse().map_err(|_| CliError::Use("the length is no number".to_string()))?;
    let mut bytes = vec![0; length.min(super::LONGEST)];
    input.read_exact(&mut bytes).map_err(lost)?;
    // Bytes that are no text make no question.
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Takes from this process what no question needs: opening and writing files, and more than so many MiB of memory.
#[cfg(unix)]
fn confine(memory: u64) -> Result<(), CliError> {
    use rustix::process::{Resource, Rlimit, setrlimit};
    let limits = [(Resource::Nofile, 3), (Resource::Fsize, 0), (Resource::Core, 0), (Resource::Data, memory << 20)];
    for (resource, most) in limits {
        let limit = Rlimit { current: Some(most), maximum: Some(most) };
        setrlimit(resource, limit).map_err(|error| CliError::Use(format!("limits of the process: {error}")))?;
    }
    Ok(())
}

/// Elsewhere what answers opens no files by itself.
#[cfg(not(unix))]
fn confine(_: u64) -> Result<(), CliError> {
    Ok(())
}

/// Tells how far the work is, in lines.
struct Told {
    last: Mutex<Option<Instant>>,
}

impl Progress for Told {
    fn is_cancelled(&self) -> bool {
        false
    }

    fn tell(&self, stage: &str, done: u64, total: Option<u64>) {
        let Ok(mut last) = self.last.lock() else { return };
        if last.is_none_or(|last| last.elapsed() > PAUSE) {
            *last = Some(Instant::now());
            // Who does not read it ends this process.
            let _ =
                output::print(&format!("{}\n", json!({"progress": {"stage": stage, "done": done, "total": total}})));
        }
    }
}
