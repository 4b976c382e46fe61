//! `completions` and `man`.

use super::{assert_refused, file, flockproof, folder, stdout};

const COMMANDS: [&str; 21] = [
    "verify",
    "list",
    "explain",
    "report",
    "reproduce",
    "resonance",
    "pattern",
    "spectrum",
    "tracks",
    "prove",
    "check",
    "reach",
    "sweep",
    "fuzz",
    "serve",
    "certify",
    "ergodicity",
    "flock",
    "simulate",
    "completions",
    "man",
];

#[test]
fn completions_know_every_command() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let output = flockproof(&["completions", shell]);
        assert!(output.status.success() && output.stderr.is_empty(), "{shell}");
        let script = stdout(&output);
        for word in COMMANDS.iter().chain(&["settle", "followers"]) {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
    assert_refused(&["completions", "csh"], "csh");
    assert_refused(&["completions"], "SHELL");
}

#[test]
fn every_command_has_a_manual_page() {
    let folder = folder("man");
    let out = folder.join("man1");
    let output = flockproof(&["man", "--out", out.to_str().expect("UTF-8")]);
    assert!(output.status.success() && output.stderr.is_empty());
    let subcommands = COMMANDS.iter().chain(&["flock-run", "flock-settle"]).map(|name| format!("flockproof-{name}"));
    let pages: Vec<String> = subcommands.chain(["flockproof".to_string()]).collect();
    for name in &pages {
        let page = std::fs::read_to_string(out.join(format!("{name}.1"))).expect("a page");
        assert!(page.contains(".TH") && page.contains(".SH SYNOPSIS"), "{name}");
    }
    assert_eq!(stdout(&output).lines().count(), pages.len());
    assert_eq!(std::fs::read_dir(&out).expect("a folder").count(), pages.len());
    assert_refused(&["man"], "--out");
    assert_refused(&["man", "--out", &file(&folder, "occupied", b"")], "occupied");
}
