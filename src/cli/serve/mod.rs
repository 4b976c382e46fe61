//! `serve`: the site from the program, with live pages that ask it.
//!
//! Pages are bytes in memory, found by their exact names: no request reads or writes a file. A question runs this program once more,
//! as its command line would, with a list of arguments that is made here, and is stopped when its time is over.

mod ask;

use super::{CliError, interrupt, report};
use flockproof::report::Page;
use std::collections::HashMap;
use std::io::Read;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Duration;
use tiny_http::{Header, Method, Request, Response, Server};

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
}

/// Requests that are answered at a time.
const WORKERS: usize = 4;
/// The longest question, in bytes.
const LONGEST: u64 = 64 * 1024;

/// What answers requests.
struct Site {
    pages: HashMap<String, Vec<u8>>,
    /// What `Host` may say.
    hosts: [String; 2],
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let Some(pages) = report::pages(arguments.ledger.as_deref(), !arguments.no_figures)? else {
        return Ok(ExitCode::from(interrupt::STATUS));
    };
    let server = Server::http(("127.0.0.1", arguments.port))
        .map_err(|error| CliError::Use(format!("--port {}: {error}", arguments.port)))?;
    let port = server.server_addr().to_ip().map_or(arguments.port, |address| address.port());
    let site = Arc::new(Site {
        pages: pages.into_iter().map(|Page { path, contents }| (path, contents)).collect(),
        hosts: [format!("127.0.0.1:{port}"), format!("localhost:{port}")],
    });
    super::output::print(&format!("http://127.0.0.1:{port}/ (Ctrl-C ends it)\n"))?;
    let server = Arc::new(server);
    let workers: Vec<_> = (0..WORKERS)
        .map(|_| {
            let (server, site) = (server.clone(), site.clone());
            std::thread::spawn(move || work(&server, &site))
        })
        .collect();
    for worker in workers {
        // A worker that panicked has answered nothing more; the others go on.
        let _ = worker.join();
    }
    Ok(ExitCode::SUCCESS)
}

fn work(server: &Server, site: &Site) {
    while !interrupt::happened() {
        match server.recv_timeout(Duration::from_millis(100)) {
            Ok(Some(request)) => site.answer(request),
            Ok(None) => {}
            Err(_) => return,
        }
    }
}

impl Site {
    fn answer(&self, mut request: Request) {
        let (status, kind, body) = self.reply(&mut request);
        let mut response = Response::from_data(body).with_status_code(status);
        let headers = [
            ("Content-Type", kind),
            ("X-Content-Type-Options", "nosniff"),
            ("Referrer-Policy", "no-referrer"),
            ("Cache-Control", "no-store"),
            ("Content-Security-Policy", "default-src 'self' data: 'unsafe-inline'; frame-ancestors 'none'"),
        ];
        for header in headers.iter().filter_map(|(name, value)| Header::from_bytes(*name, *value).ok()) {
            response.add_header(header);
        }
        // Who asked may be gone.
        let _ = request.respond(response);
    }

    fn reply(&self, request: &mut Request) -> (u16, &'static str, Vec<u8>) {
        const TEXT: &str = "text/plain; charset=utf-8";
        let refused = |status: u16, why: &str| (status, TEXT, format!("{why}\n").into_bytes());
        if !self.is_own(request) {
            return refused(403, "only pages of this program may ask");
        }
        let path = request.url().split(['?', '#']).next().unwrap_or_default().to_string();
        let path = path.trim_start_matches('/');
        match (request.method().clone(), path.strip_prefix("api/")) {
            (Method::Post, Some(what)) => {
                let mut text = String::new();
                let read = request.as_reader().take(LONGEST + 1).read_to_string(&mut text);
                if read.is_err() || text.len() as u64 > LONGEST {
                    return refused(413, "a question has at most 64 KiB of UTF-8");
                }
                match ask::answer(what, &text) {
                    Ok(json) => (200, "application/json", json),
                    Err(ask::AskError::Unknown) => refused(404, "there is nothing here"),
                    Err(error) => refused(422, &error.to_string()),
                }
            }
            (Method::Get | Method::Head, None) => {
                let path = if path.is_empty() { "index.html" } else { path };
                match self.pages.get(path) {
                    Some(contents) => (200, content_type(path), contents.clone()),
                    None => refused(404, "there is no such page"),
                }
            }
            _ => refused(405, "that cannot be done here"),
        }
    }

    /// Asked under its own name, and by its own pages: names that lead here by chance or malice are refused.
    fn is_own(&self, request: &Request) -> bool {
        let values = |name: &'static str| {
            request.headers().iter().filter(move |h| h.field.equiv(name)).map(|h| h.value.as_str().to_ascii_lowercase())
        };
        let mut hosts = values("Host");
        let host = hosts.next().is_some_and(|host| self.hosts.contains(&host)) && hosts.next().is_none();
        let origin = values("Origin")
            .all(|origin| origin.strip_prefix("http://").is_some_and(|host| self.hosts.iter().any(|own| own == host)));
        let site = values("Sec-Fetch-Site").all(|site| site == "same-origin" || site == "none");
        let json = request.method() != &Method::Post
            || values("Content-Type").any(|kind| kind.starts_with("application/json"));
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
