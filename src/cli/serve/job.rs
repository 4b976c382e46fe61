//! One question of a page, answered by a process of its own, which is ended when its time is over or the page is closed.

use super::super::interrupt;
use super::http::Reply;
use serde_json::json;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// How long one question may take.
const LONGEST: Duration = Duration::from_secs(60);
/// The longest answer, in bytes.
const LARGEST: u64 = 16 << 20;
/// How often the page is looked after.
const TICK: Duration = Duration::from_millis(100);

/// What the worker says in its first line, if the question makes no sense.
const REFUSED: &str = "{\"refused\":";

/// Answers in lines of JSON: `{"progress": ..}` as often as there is any, and at the end `{"answer": .., "shown": ..}` or
/// `{"refused": ..}`; `memory` is in MiB. A question that makes no sense is refused with status 422.
pub fn answer(what: &str, question: &[u8], memory: u64, reply: &mut Reply) -> io::Result<()> {
    let worker = match Worker::start(what, question, memory) {
        Ok(worker) => worker,
        Err(error) => return reply.refuse(503, &format!("the program cannot be started: {error}")),
    };
    let mut begun = false;
    loop {
        let line = match worker.lines.recv_timeout(TICK) {
            Ok(line) => line,
            Err(RecvTimeoutError::Timeout) if reply.is_closed() || interrupt::happened() => return Ok(()),
            Err(RecvTimeoutError::Timeout) if worker.begun.elapsed() < LONGEST => continue,
            Err(RecvTimeoutError::Timeout) => {
                refusal(&format!("no answer within {} seconds; the command line has no such limit", LONGEST.as_secs()))
            }
            // It was ended from outside, or by the bounds of its memory.
            Err(RecvTimeoutError::Disconnected) => refusal(
                "the question needs more memory than a page may use, or a longer answer; the command line has no such limit",
            ),
        };
        if !begun && line.starts_with(REFUSED) {
            let why = serde_json::from_str::<serde_json::Value>(&line).unwrap_or_default();
            return reply.refuse(422, why["refused"].as_str().unwrap_or("the question makes no sense"));
        }
        if !begun {
            reply.begin("application/x-ndjson")?;
            begun = true;
        }
        reply.write(line.as_bytes())?;
        if line.starts_with(REFUSED) || line.starts_with("{\"answer\":") {
            return Ok(());
        }
    }
}

fn refusal(why: &str) -> String {
    format!("{}\n", json!({"refused": why}))
}

/// The process; it ends with this.
struct Worker {
    child: Child,
    lines: Receiver<String>,
    begun: Instant,
}

impl Worker {
    fn start(what: &str, question: &[u8], memory: u64) -> io::Result<Self> {
        let mut child = Command::new(std::env::current_exe()?)
            // Where another program runs this command line, such as Python, that comes first.
            .args(std::env::args_os().skip(1).take_while(|word| word != "serve"))
            .args(["serve", "--worker", what, "--memory", &memory.to_string()])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()?;
        let (pipe, out) = (child.stdin.take(), child.stdout.take());
        let question = question.to_vec();
        // The pipe stays open: where it is closed the worker knows that nobody waits any more.
        let (sender, lines) = channel();
        let worker = Worker { child, lines, begun: Instant::now() };
        std::thread::Builder::new().spawn(move || {
            let Some((mut pipe, out)) = pipe.zip(out) else { return };
            // What is not read is not missed: the worker says why it stopped.
            let _ = pipe.write_all(format!("{}\n", question.len()).as_bytes()).and_then(|()| pipe.write_all(&question));
            let _ = pipe.flush();
            let mut out = BufReader::new(out.take(LARGEST));
            loop {
                let mut line = String::new();
                match out.read_line(&mut line) {
                    Ok(count) if count > 0 && line.ends_with('\n') && sender.send(line).is_ok() => {}
                    _ => return,
                }
            }
        })?;
        Ok(worker)
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
