//! `serve`: the site from the program, with live pages that ask it.
//!
//! Pages are bytes in memory, found by their exact names: no request reads or writes a file. A question is answered by a process of its
//! own ([`worker`]) that can open no files, has bounds of memory and time, and ends when the page that asked is closed.

mod ask;
mod http;
mod job;
mod worker;

use super::{CliError, interrupt, report};
use flockproof::report::Page;
use http::{Reply, Request, RequestError};
use std::collections::HashMap;
use std::net::{TcpListener, TcpStream};
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

#[derive(clap::Args)]
pub struct Arguments {
    /// Port on 127.0.0.1; 0 takes a free one
    #[arg(long, value_name = "PORT", default_value_t = 8017)]
    port: u16,
    /// A ledger that `verify --json` wrote; without it all claims are checked first
    #[arg(long, value_name = "LEDGER.json")]
    ledger: Option<PathBuf>,
    /// Leave out the tables and figures
    #[arg(long)]
    no_figures: bool,
    /// Memory that one question may take, in MiB
    #[arg(long, value_name = "MIB", default_value_t = 2048, value_parser = clap::value_parser!(u64).range(16..=1 << 20))]
    memory: u64,
    /// Answer one question from standard input: what the server starts for each
    #[arg(long, hide = true, value_name = "WHAT")]
    worker: Option<String>,
}

/// Connections that are open at a time, and questions that are answered.
const CONNECTIONS: usize = 64;
const QUESTIONS: usize = 4;
/// The longest question, in bytes: a certificate and its quotes.
const LONGEST: usize = 6 << 20;
/// How often a new connection is looked for.
const TICK: Duration = Duration::from_millis(10);

/// What answers requests.
struct Site {
    pages: HashMap<String, Vec<u8>>,
    /// What `Host` may say.
    hosts: [String; 2],
    questions: Room,
    /// MiB for each.
    memory: u64,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    if let Some(what) = &arguments.worker {
        return worker::run(what, arguments.memory);
    }
    let Some(pages) = report::pages(arguments.ledger.as_deref(), !arguments.no_figures)? else {
        return Ok(ExitCode::from(interrupt::STATUS));
    };
    let refused = |error: std::io::Error| CliError::Use(format!("--port {}: {error}", arguments.port));
    let listener = TcpListener::bind(("127.0.0.1", arguments.port)).map_err(refused)?;
    listener.set_nonblocking(true).map_err(refused)?;
    let port = listener.local_addr().map_err(refused)?.port();
    let site = Arc::new(Site {
        pages: pages.into_iter().map(|Page { path, contents }| (path, contents)).collect(),
        hosts: [format!("127.0.0.1:{port}"), format!("localhost:{port}")],
        questions: Room::new(QUESTIONS),
        memory: arguments.memory,
    });
    let connections = Room::new(CONNECTIONS);
    super::output::print(&format!("http://127.0.0.1:{port}/ (Ctrl-C ends it)\n"))?;
    while !interrupt::happened() {
        match listener.accept() {
            Ok((stream, _)) => site.clone().welcome(stream, connections.enter()),
            Err(_) => std::thread::sleep(TICK),
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// A room for so many.
#[derive(Clone)]
struct Room {
    inside: Arc<AtomicUsize>,
    most: usize,
}

impl Room {
    fn new(most: usize) -> Self {
        Room { inside: Arc::default(), most }
    }

    /// A place in it, where there is one.
    fn enter(&self) -> Option<Place> {
        let place = Place(self.inside.clone());
        (self.inside.fetch_add(1, Ordering::SeqCst) < self.most).then_some(place)
    }
}

/// A place that is free again when it is dropped.
struct Place(Arc<AtomicUsize>);

impl Drop for Place {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::SeqCst);
    }
}

impl Site {
    /// Answers on a thread of its own; where there is no place the connection is closed.
    fn welcome(self: Arc<Self>, stream: TcpStream, place: Option<Place>) {
        let Some(place) = place else { return };
        let answer = move || {
            let _place = place;
            if stream.set_nonblocking(false).is_ok() {
                self.answer(stream);
            }
        };
        // Without a thread there is no answer, and the next one may be.
        let _ = std::thread::Builder::new().spawn(answer);
    }

    fn answer(&self, mut stream: TcpStream) {
        let request = http::read(&mut stream, LONGEST);
        let bare = request.as_ref().is_ok_and(|request| request.method == "HEAD");
        let mut reply = Reply::new(&stream, bare);
        // Who asked may be gone.
        let _ = match request {
            Ok(request) => self.reply(&request, &mut reply),
            Err(RequestError::Refused(status, why)) => reply.refuse(status, why),
            Err(RequestError::Lost(_)) => return,
        };
        reply.end();
    }

    fn reply(&self, request: &Request, reply: &mut Reply) -> std::io::Result<()> {
        if !self.is_own(request) {
            return reply.refuse(403, "only pages of this program may ask");
        }
        let path = request.target.split(['?', '#']).next().unwrap_or_default();
        let Some(path) = path.strip_prefix('/') else { return reply.refuse(404, "there is no such page") };
        match (request.method.as_str(), path.strip_prefix("api/")) {
            ("POST", Some(what)) if ask::is_known(what) => match self.questions.enter() {
                Some(_place) => job::answer(what, &request.body, self.memory, reply),
                None => reply.refuse(503, "other questions are being answered; try again when one of them is"),
            },
            ("POST", Some(_)) => reply.refuse(404, "there is nothing here"),
            ("GET" | "HEAD", None) => {
                let path = if path.is_empty() { "index.html" } else { path };
                match self.pages.get(path) {
                    Some(contents) => reply.whole(200, content_type(path), contents),
                    None => reply.refuse(404, "there is no such page"),
                }
            }
            _ => reply.refuse(405, "that cannot be done here"),
        }
    }

    /// Asked under its own name, and by its own pages: names that lead here by chance or malice are refused.
    fn is_own(&self, request: &Request) -> bool {
        let mut hosts = request.values("Host");
        let host = hosts.next().is_some_and(|host| self.hosts.contains(&host)) && hosts.next().is_none();
        let origin = request
            .values("Origin")
            .all(|origin| origin.strip_prefix("http://").is_some_and(|host| self.hosts.iter().any(|own| own == host)));
        let site = request.values("Sec-Fetch-Site").all(|site| site == "same-origin" || site == "none");
        let json =
            request.method != "POST" || request.values("Content-Type").any(|kind| kind.starts_with("application/json"));
        host && origin && site && json
    }
}

fn content_type(path: &str) -> &'static str {
    match path.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("json") => "application/json",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        _ => "text/plain; charset=utf-8",
    }
}
