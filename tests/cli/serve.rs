//! `serve`: its pages, its answers, and what it refuses.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// A server on a free port, that ends with the test.
struct Server {
    child: Child,
    port: u16,
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn start(name: &str) -> Server {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("a folder");
    let ledger = folder.join("ledger.json");
    std::fs::write(&ledger, r#"{"schema": "flockproof.ledger/2", "version": "0", "seed": "s", "claims": []}"#)
        .expect("a file");
    let mut child = Command::new(env!("CARGO_BIN_EXE_flockproof"))
        .args(["serve", "--port", "0", "--no-figures", "--ledger"])
        .arg(&ledger)
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut line = String::new();
    BufReader::new(child.stdout.take().expect("its output")).read_line(&mut line).expect("a line");
    let port = line.trim_start_matches("http://127.0.0.1:").split('/').next().and_then(|port| port.parse().ok());
    Server { child, port: port.expect("a port") }
}

impl Server {
    /// The whole reply to bytes that may be anything.
    fn raw(&self, request: &[u8]) -> String {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).expect("a connection");
        stream.set_read_timeout(Some(Duration::from_secs(60))).expect("a limit");
        // It may refuse before it has read everything.
        let _ = stream.write_all(request);
        let mut reply = Vec::new();
        let _ = stream.read_to_end(&mut reply);
        String::from_utf8_lossy(&reply).into_owned()
    }

    /// A request of one's own: the first line, further headers, the body.
    fn ask(&self, line: &str, headers: &str, body: &str) -> (u16, String) {
        let port = self.port;
        let length = body.len();
        let request = format!(
            "{line} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n{headers}Content-Length: {length}\r\n\r\n{body}"
        );
        let reply = self.raw(request.as_bytes());
        let status = reply.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0);
        (status, reply)
    }

    fn question(&self, what: &str, body: &str) -> (u16, String) {
        self.ask(&format!("POST /api/{what}"), "Content-Type: application/json\r\n", body)
    }
}

#[test]
fn pages_and_answers() {
    let server = start("serve-answers");
    for page in ["/", "/index.html", "/site.css", "/explore/live-resonance.html", "/data/ledger.json?x#y"] {
        let (status, reply) = server.ask(&format!("GET {page}"), "", "");
        assert_eq!(status, 200, "{page}");
        assert!(reply.contains("Content-Security-Policy: default-src 'self'"), "{page}");
    }
    let (status, reply) = server.question("resonance", r#"{"followers": "4", "f": "-1", "g": "-1"}"#);
    assert_eq!(status, 200);
    assert!(reply.contains("0.273108564"), "the digits of the command line: {reply}");
    let (status, reply) = server.question("spectrum", r#"{"graph": "ring:4", "kind": "laplacian"}"#);
    assert!(status == 200 && reply.contains("\"multiplicity\""), "{reply}");
    let birds = r#"{"model":"D","dimension":1,"weights":"lazy","hysteresis":"none","positions":[["0"],["2"]],"velocities":[["1/8"],["0"]]}"#;
    let (status, reply) = server.question("flock", birds);
    assert!(status == 200 && reply.contains("\"switches\""), "{reply}");
}

#[test]
fn hostile_requests_are_refused() {
    let server = start("serve-hostile");
    let secret = "root:";
    let paths = [
        "/../../etc/passwd",
        "/..%2f..%2fetc/passwd",
        "/%2e%2e/%2e%2e/etc/passwd",
        "//etc/passwd",
        "/etc/passwd",
        "/....//etc/passwd",
        "/index.html/..",
        "/claims/../../../etc/passwd",
        "/\\..\\..\\etc\\passwd",
        "/index.html%00",
        "/file:///etc/passwd",
        "/.git/config",
        "/Cargo.toml",
        "/api/",
        "/api/resonance",
        "/api/../index.html",
        "/nothing",
        "/claims/",
        "/data",
        "/%",
        "/%zz",
        "/index.html/",
        "/INDEX.HTML",
        "/?/../etc/passwd/..",
        "/data/ledger.json/../../x",
    ];
    for path in paths {
        let (status, reply) = server.ask(&format!("GET {path}"), "", "");
        assert!(!reply.contains(secret) && (status != 200 || path.starts_with("/?")), "{path}: {reply}");
    }
    for method in ["PUT", "DELETE", "PATCH", "TRACE", "OPTIONS", "CONNECT", "POST", "NONSENSE"] {
        assert_ne!(
            server.ask(&format!("{method} /index.html"), "Content-Type: application/json\r\n", "").0,
            200,
            "{method}"
        );
    }
    let port = server.port;
    for host in [
        "evil.example",
        "127.0.0.1",
        "127.0.0.1:1",
        "localhost.evil.example",
        "0.0.0.0",
        "[::1]",
        "",
        "127.0.0.1.evil.example:80",
    ] {
        let reply = server.raw(format!("GET / HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").as_bytes());
        assert!(!reply.contains(" 200 "), "Host: {host}: {reply}");
    }
    let two = format!("GET / HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nHost: evil.example\r\nConnection: close\r\n\r\n");
    assert!(!server.raw(two.as_bytes()).contains(" 200 "), "two names");
    for header in [
        "Origin: http://evil.example",
        "Origin: null",
        "Origin: https://127.0.0.1",
        "Origin: http://127.0.0.1:1",
        "Origin: file://",
        "Sec-Fetch-Site: cross-site",
        "Sec-Fetch-Site: same-site",
    ] {
        let headers = format!("{header}\r\nContent-Type: application/json\r\n");
        let (status, _) = server.ask("POST /api/resonance", &headers, r#"{"followers": "4", "f": "-1", "g": "-1"}"#);
        assert_eq!(status, 403, "{header}");
    }
    for kind in ["text/plain", "application/x-www-form-urlencoded", "multipart/form-data"] {
        assert_eq!(server.ask("POST /api/resonance", &format!("Content-Type: {kind}\r\n"), "{}").0, 403, "{kind}");
    }
    let questions = [
        ("resonance", r#"{"followers": "0", "f": "-1", "g": "-1"}"#),
        ("resonance", r#"{"followers": "99999999999999999999", "f": "-1", "g": "-1"}"#),
        ("resonance", r#"{"followers": "4", "f": "--help", "g": "-1"}"#),
        ("resonance", r#"{"followers": "4", "f": "", "g": "-1"}"#),
        ("resonance", r#"{"followers": "4", "f": "1/0", "g": "-1"}"#),
        ("resonance", r#"{"followers": "4", "f": "1", "g": "-1"}"#),
        ("resonance", r#"{"followers": 4}"#),
        ("resonance", "[]"),
        ("resonance", "null"),
        ("resonance", "{"),
        ("resonance", ""),
        ("resonance", "\u{0}"),
        ("spectrum", r#"{"graph": "/etc/passwd", "kind": "laplacian"}"#),
        ("spectrum", r#"{"graph": "../x:1", "kind": "laplacian"}"#),
        ("spectrum", r#"{"graph": "-", "kind": "laplacian"}"#),
        ("spectrum", r#"{"graph": "ring:100000000", "kind": "laplacian"}"#),
        ("spectrum", r#"{"graph": "ring:12 --json", "kind": "laplacian"}"#),
        ("spectrum", r#"{"graph": "ring:12", "kind": "--help"}"#),
        ("spectrum", r#"{"graph": "ring:", "kind": "laplacian"}"#),
        ("spectrum", r#"{"graph": "complete:-3", "kind": "laplacian"}"#),
        ("spectrum", r#"{"graph": "nonsense:3", "kind": "laplacian"}"#),
        ("spectrum", r#"{}"#),
        ("flock", r#"{"positions": []}"#),
        ("flock", r#"{"positions": [["0"]]}"#),
        ("flock", r#"{"positions": "x"}"#),
        ("flock", r#"{"positions": [["1/0"]], "velocities": [["0"]]}"#),
        ("nothing", "{}"),
        ("", "{}"),
        ("resonance/../spectrum", "{}"),
        ("RESONANCE", "{}"),
    ];
    for (what, body) in questions {
        let (status, reply) = server.question(what, body);
        assert!(
            matches!(status, 400..=499) && !reply.contains(secret) && !reply.contains("panicked"),
            "{what} {body}: {reply}"
        );
    }
    let long = format!("{{\"positions\": \"{}\"}}", "9".repeat(100_000));
    assert_eq!(server.question("flock", &long).0, 413);
    let deep = format!("{}{}", "[".repeat(30_000), "]".repeat(30_000));
    assert_eq!(server.question("flock", &deep).0, 422);
    for nonsense in [
        &b"\x00\x01\x02\r\n\r\n"[..],
        b"GET\r\n\r\n",
        b"GET / HTTP/9.9\r\n\r\n",
        b"\xff\xfe / HTTP/1.1\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost\r\n\r\n",
    ] {
        assert!(!server.raw(nonsense).contains(" 200 "), "{nonsense:?}");
    }
    // After all that it still answers.
    assert_eq!(server.ask("GET /", "", "").0, 200);
}
