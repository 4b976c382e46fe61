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
    start_with(name, &[])
}

/// The same with further arguments.
fn start_with(name: &str, arguments: &[&str]) -> Server {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("a folder");
    let ledger = folder.join("ledger.json");
    std::fs::write(&ledger, r#"{"schema": "flockproof.ledger/2", "version": "0", "seed": "s", "claims": []}"#)
        .expect("a file");
    let mut child = Command::new(env!("CARGO_BIN_EXE_flockproof"))
        .args(["serve", "--port", "0", "--no-figures", "--ledger"])
        .arg(&ledger)
        .args(arguments)
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
        stream.set_read_timeout(Some(Duration::from_secs(120))).expect("a limit");
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

/// The last line of an answer, as it is streamed.
fn answer(reply: &str) -> serde_json::Value {
    let line = reply.trim_end().lines().last().unwrap_or_default();
    serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {reply}"))
}

/// What the command line prints for the same, with this standard input.
fn printed(arguments: &[&str], input: &str) -> serde_json::Value {
    let output = super::with_input(arguments, std::path::Path::new("."), input);
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{arguments:?}: {error}"))
}

fn asset(name: &str) -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets").join(name);
    std::fs::read_to_string(path).expect("an asset")
}

#[test]
fn pages_and_answers() {
    let server = start("serve-answers");
    for page in ["/", "/index.html", "/site.css", "/explore/live-resonance.html", "/data/ledger.json?x#y"] {
        let (status, reply) = server.ask(&format!("GET {page}"), "", "");
        assert_eq!(status, 200, "{page}");
        assert!(reply.contains("Content-Security-Policy: default-src 'self'"), "{page}");
    }
    let (status, reply) = server.ask("HEAD /", "", "");
    assert!(status == 200 && reply.ends_with("\r\n\r\n"), "{reply}");
    let edges = "vertices 4\n1 2\n2 3\n3 4\n";
    let birds = r#"{"model":"D","dimension":1,"weights":"lazy","hysteresis":"none","positions":[["0"],["2"]],"velocities":[["1/8"],["0"]]}"#;
    let scenario = asset("scenarios/three_agents.toml");
    let cars = asset("systems/two_cars.toml");
    let question = asset("questions/gap_and_diameter.toml");
    let form = |fields: &[(&str, &str)]| {
        serde_json::Value::Object(fields.iter().map(|(k, v)| (k.to_string(), (*v).into())).collect()).to_string()
    };
    for (what, body, arguments, input) in [
        (
            "resonance",
            form(&[("followers", "4"), ("f", "-1"), ("g", "-1")]),
            vec!["resonance", "--followers", "4", "--f", "-1", "--g", "-1", "--digits", "15", "--json"],
            "",
        ),
        (
            "spectrum",
            form(&[("graph", "ring:4"), ("kind", "laplacian"), ("edges", "no graph")]),
            vec!["spectrum", "--graph", "ring:4", "--json"],
            "",
        ),
        ("spectrum", form(&[("graph", ""), ("edges", edges)]), vec!["spectrum", "--graph", "-", "--json"], edges),
        ("flock", birds.to_string(), vec!["flock", "settle", "-", "--json"], birds),
        (
            "pattern",
            form(&[("particles", "6"), ("gains", "1/5,1/5,-1/25"), ("omega0", "1/10"), ("K0", "1/10")]),
            vec!["pattern", "--particles", "6", "--gains", "1/5,1/5,-1/25", "--json"],
            "",
        ),
        ("scenario", form(&[("scenario", &scenario)]), vec!["simulate", "-", "--json"], &scenario),
        ("system", form(&[("system", &cars)]), vec!["reach", "-", "--json"], &cars),
    ] {
        let (status, reply) = server.question(what, &body);
        assert_eq!(status, 200, "{what}: {reply}");
        let said = answer(&reply);
        assert_eq!(said["answer"], printed(&arguments, input), "{what}");
        assert!(said["shown"].as_str().is_some_and(|shown| shown.contains('<')), "{what}");
    }
    // `check` writes the counterexample to a file, and the page shows it.
    let (_, reply) = server.question("question", &form(&[("question", &question)]));
    let (said, folder) = (answer(&reply), env!("CARGO_TARGET_TMPDIR"));
    let mut whole = printed(&["check", "-", "--replay", folder, "--json"], &question);
    assert_eq!(said["answer"]["replay"], serde_json::Value::Null);
    whole["replay"] = serde_json::Value::Null;
    assert_eq!(said["answer"], whole);
    assert!(said["shown"].as_str().is_some_and(|shown| shown.contains("<svg") && shown.contains("[question]")));
}

#[test]
fn certificates_and_texts_beside_questions() {
    let server = start("serve-texts");
    let certificate = "flockproof-certificate 1 inertia\nclaim the symmetric matrix A below has 1 positive, 1 negative and 0 zero eigenvalues, counted with \
         multiplicity\norder 2\nA over 1\n0 1\n1 2\npivots 2 1\nL over 2\n2 0\n1 2\nD over 2\n4 -1\nend\n";
    let ask =
        |text: &str| answer(&server.question("certificate", &serde_json::json!({"certificate": text}).to_string()).1);
    assert_eq!(ask(certificate)["answer"]["accepted"], true);
    let wrong = ask(&certificate.replace("4 -1", "4 -2"));
    assert!(wrong["answer"]["accepted"] == false && wrong["answer"]["line"].as_u64().is_some(), "{wrong}");
    let (question, flock) = (asset("questions/never_meets.toml"), asset("questions/two_pairs.json"));
    let body = serde_json::json!({"question": question, "beside": flock}).to_string();
    assert_eq!(answer(&server.question("question", &body).1)["answer"]["verdict"], "holds");
}

/// Children of the server that run, by their ids.
#[cfg(target_os = "linux")]
fn children(server: &Server) -> Vec<u32> {
    let parent = format!(" {} ", server.child.id());
    let stat =
        |entry: std::io::Result<std::fs::DirEntry>| std::fs::read_to_string(entry.ok()?.path().join("stat")).ok();
    let of_server = |stat: String| {
        let rest = stat.rsplit(')').next().unwrap_or_default();
        let own = rest.get(2..).is_some_and(|rest| rest.starts_with(&parent)) && !rest.starts_with(" Z");
        own.then(|| stat.split(' ').next()?.parse().ok()).flatten()
    };
    std::fs::read_dir("/proc").expect("/proc").filter_map(stat).filter_map(of_server).collect()
}

/// A question of a thousand million cases.
const ENDLESS: &str = "[question]\nid = \"endless\"\nbudget = 1000000000\n[for]\nn = \"1..1000000000\"\n[holds]\nproperty = \"n > 0\"\ncontrols = [\"n > 5\"]\n";

#[cfg(target_os = "linux")]
#[test]
fn a_closed_page_stops_its_work() {
    let server = start("serve-closed");
    let body = serde_json::json!({"question": ENDLESS}).to_string();
    let port = server.port;
    let request = format!(
        "POST /api/question HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nContent-Type: application/json\r\nContent-Length: {}\r\n\r\n{body}",
        body.len()
    );
    let open = || {
        let mut stream = TcpStream::connect(("127.0.0.1", port)).expect("a connection");
        stream.set_read_timeout(Some(Duration::from_secs(120))).expect("a limit");
        stream.write_all(request.as_bytes()).expect("it listens");
        // Progress comes before the answer does.
        let mut lines = BufReader::new(stream.try_clone().expect("the same"));
        let mut line = String::new();
        while !line.starts_with("{\"progress\"") {
            line.clear();
            assert_ne!(lines.read_line(&mut line).expect("a line"), 0, "it ended without progress");
        }
        stream
    };
    let pages: Vec<TcpStream> = (0..4).map(|_| open()).collect();
    assert_eq!(children(&server).len(), 4);
    for child in children(&server) {
        let limits = std::fs::read_to_string(format!("/proc/{child}/limits")).expect("the limits of a child");
        let memory = limits.lines().find(|line| line.starts_with("Max data size")).expect("of memory");
        assert_eq!(memory.split_whitespace().nth(3), Some("2147483648"), "{memory}");
    }
    // All places are taken, and pages still come.
    assert_eq!(server.question("question", &body).0, 503);
    assert_eq!(server.ask("GET /", "", "").0, 200);
    drop(pages);
    // Usually at once; the limit is a last resort, below the minute that is their own limit.
    let gone = (0..400).any(|_| {
        std::thread::sleep(Duration::from_millis(100));
        children(&server).is_empty()
    });
    assert!(gone, "{} questions are still worked on", children(&server).len());
    assert_eq!(server.question("spectrum", r#"{"graph": "ring:4"}"#).0, 200);
}

/// Eight million links, which are within what a scenario may have, take more than 64 MiB.
#[cfg(target_os = "linux")]
#[test]
fn memory_is_bounded() {
    let server = start_with("serve-memory", &["--memory", "64"]);
    let scenario = "model = \"velocity-alignment\"\n[graph]\nkind = \"complete\"\n[state]\n\
        random = { agents = 4000, seed = 1, half = 1000 }\n[law]\npotential = \"inverse-square-log\"\n[run]\nuntil = 1\n";
    let (status, reply) = server.question("scenario", &serde_json::json!({"scenario": scenario}).to_string());
    assert!(status == 422 && reply.contains("the question needs more memory than a page may use"), "{reply}");
    // The next one is answered, and pages still come.
    assert_eq!(server.question("spectrum", r#"{"graph": "ring:4"}"#).0, 200);
    assert_eq!(server.ask("GET /", "", "").0, 200);
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
        ("spectrum", r#"{"graph": "", "edges": "/etc/passwd"}"#),
        ("spectrum", r#"{"graph": "", "edges": "vertices 100000000\n1 2"}"#),
        ("spectrum", r#"{"graph": "file:/etc/passwd"}"#),
        ("spectrum", r#"{"graph": 7}"#),
        ("spectrum", r#"{"graph": "geometric:50:1/4:7:9"}"#),
        ("pattern", r#"{"particles": "61", "gains": "1", "omega0": "1", "K0": "1"}"#),
        ("pattern", r#"{"particles": "12", "gains": "1", "omega0": "0", "K0": "1"}"#),
        ("pattern", r#"{"particles": "2", "gains": "1,1,1", "omega0": "1", "K0": "1"}"#),
        ("pattern", r#"{"particles": "12", "gains": "a", "omega0": "1", "K0": "1"}"#),
        ("pattern", r#"{"particles": "12"}"#),
        ("system", r#"{"system": ""}"#),
        ("system", r#"{"system": "[system]\nstates = [\"x\"]"}"#),
        ("system", r#"{"system": 7}"#),
        ("question", r#"{"question": ""}"#),
        ("question", r#"{"question": "[question]"}"#),
        (
            "question",
            r#"{"question": "[question]\nid = \"a\"\nscenario = \"/etc/passwd\"\n[for]\nn = \"1..2\"\n[holds]\nproperty = \"n > 0\"\ncontrols = [\"n > 1\"]"}"#,
        ),
        (
            "question",
            r#"{"question": "[question]\nid = \"a\"\n[for]\ng = \"file:/etc/passwd\"\n[holds]\nproperty = \"n > 0\"\ncontrols = [\"n > 1\"]"}"#,
        ),
        (
            "question",
            r#"{"question": "[question]\nid = \"../../tmp/x\"\n[for]\nn = \"1..2\"\n[holds]\nproperty = \"n > 0\"\ncontrols = [\"n > 1\"]"}"#,
        ),
        (
            "question",
            r#"{"question": "[question]\nid = \"a\"\n[for]\nn = \"1..99999999999999\"\n[holds]\nproperty = \"n > 0\"\ncontrols = [\"n > 1\"]"}"#,
        ),
        ("question", r#"{"question": ["a"]}"#),
        ("scenario", r#"{"scenario": ""}"#),
        ("scenario", r#"{"scenario": "model = \"fish\""}"#),
        (
            "scenario",
            r#"{"scenario": "model = \"vicsek-noise\"\n[state]\nrandom = { agents = 999999999999 }\n[law]\nbox = 7\nspeed = 1\n[run]\nuntil = 2"}"#,
        ),
        ("scenario", r#"{}"#),
        ("certificate", "[]"),
        ("worker", "{}"),
        ("resonance?x", "{}"),
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
    let long = format!("{{\"positions\": \"{}\"}}", "9".repeat(7_000_000));
    assert_eq!(server.question("flock", &long).0, 413);
    let birds = vec!["[\"0\"]"; 25].join(",");
    assert_eq!(server.question("flock", &format!("{{\"positions\": [{birds}], \"velocities\": [{birds}]}}")).0, 422);
    let deep = format!("{}{}", "[".repeat(30_000), "]".repeat(30_000));
    assert_eq!(server.question("flock", &deep).0, 422);
    for length in ["100000000000000", "18446744073709551615", "99999999999999999999999", "-1", "x", "0x10", "6291457"] {
        let head = format!("POST /api/flock HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nContent-Type: application/json\r\n");
        let reply = server.raw(format!("{head}Content-Length: {length}\r\n\r\n{{}}").as_bytes());
        assert!(reply.contains(" 413 ") || reply.contains(" 400 "), "Content-Length: {length}: {reply}");
    }
    let two = "POST /api/flock HTTP/1.1\r\nContent-Length: 2\r\nContent-Length: 3\r\n\r\n{}";
    assert!(server.raw(two.as_bytes()).contains(" 400 "), "two lengths");
    let chunked = "POST /api/flock HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n";
    assert!(server.raw(chunked.as_bytes()).contains(" 501 "), "chunks");
    let many: String = (0..100).map(|k| format!("X{k}: y\r\n")).collect();
    assert!(server.raw(format!("GET / HTTP/1.1\r\n{many}\r\n").as_bytes()).contains(" 431 "), "many headers");
    let long_header = format!("GET / HTTP/1.1\r\nX: {}\r\n\r\n", "y".repeat(40_000));
    assert!(server.raw(long_header.as_bytes()).contains(" 431 "), "long headers");
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
