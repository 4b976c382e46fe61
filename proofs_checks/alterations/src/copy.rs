//! The altered copy of the workspace, and its compilation: alterations that do not compile are dropped until the rest does.

use crate::sites::{Alteration, Found, find};
use crate::table::digest_of;
use crate::write::{Written, write};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What was compiled.
pub struct Built {
    pub alterations: Vec<Alteration>,
    /// The numbers of those that compile, from 1.
    pub live: BTreeSet<u32>,
    /// Test programs: crate folder, file.
    pub tests: Vec<(PathBuf, PathBuf)>,
    /// The command line, where claims are wanted.
    pub program: Option<PathBuf>,
}

/// Copies the workspace, alters the files, and compiles the tests of `packages` and, with `claims`, the command line.
pub fn build(
    root: &Path,
    scratch: &Path,
    files: &[String],
    packages: &[String],
    claims: bool,
) -> Result<Built, String> {
    let copy = scratch.join("workspace");
    synchronise(root, &copy, files)?;
    write_manifests(root, &copy, files)?;
    let mut alterations = Vec::new();
    let mut found: Vec<(String, Found)> = Vec::new();
    for (index, file) in files.iter().enumerate() {
        let source = read(&root.join(file))?;
        let sites = find(index, &source, &mut alterations).map_err(|error| format!("{file}: {error}"))?;
        found.push((source, sites));
    }
    // What does not compile is kept for the next run on the same sources.
    let kept = scratch.join("dropped.txt");
    let digest = digest_of(found.iter().map(|(source, _)| source.as_str()).collect::<String>().as_bytes());
    let text = std::fs::read_to_string(&kept).unwrap_or_default();
    let known = text.strip_prefix(&digest).unwrap_or_default();
    let mut dropped: BTreeSet<u32> = known.split_whitespace().filter_map(|k| k.parse().ok()).collect();
    let mut written: Vec<Option<Written>> = files.iter().map(|_| None).collect();
    loop {
        for (k, (source, sites)) in found.iter().enumerate() {
            let new = write(source, sites, &dropped);
            if written[k].as_ref().is_none_or(|old| old.text != new.text) {
                put_if_new(&copy.join(&files[k]), &new.text)?;
            }
            written[k] = Some(new);
        }
        let before = dropped.clone();
        let mut tests = Vec::new();
        let mut program = None;
        let mut commands = Vec::new();
        if !packages.is_empty() {
            let mut arguments = vec!["test".to_string(), "--no-run".to_string()];
            arguments.extend(packages.iter().flat_map(|package| ["-p".to_string(), package.clone()]));
            commands.push(arguments);
        }
        if claims {
            let words = ["build", "--profile", "test", "-p", "flockproof", "--bin", "flockproof"];
            commands.push(words.map(String::from).to_vec());
        }
        let mut failed = false;
        for command in commands {
            let messages = cargo(&copy, scratch, &command)?;
            failed |= !messages.success;
            for message in &messages.list {
                match message["reason"].as_str() {
                    Some("compiler-message") => drop_at_fault(message, &copy, files, &written, &before, &mut dropped),
                    Some("compiler-artifact") => {
                        let Some(executable) = message["executable"].as_str() else { continue };
                        let kinds = message["target"]["kind"].to_string();
                        let manifest = Path::new(message["manifest_path"].as_str().unwrap_or_default());
                        if message["profile"]["test"] == Value::Bool(true) {
                            let folder = manifest.parent().unwrap_or(&copy).to_path_buf();
                            tests.push((folder, PathBuf::from(executable)));
                        } else if kinds.contains("bin") && executable.ends_with("/flockproof") {
                            program = Some(PathBuf::from(executable));
                        }
                    }
                    _ => {}
                }
            }
            if failed {
                break;
            }
        }
        if !failed {
            let live = written.iter().flatten().flat_map(|w| &w.regions).flat_map(|(_, ks)| ks).copied();
            let live: BTreeSet<u32> = live.filter(|k| !dropped.contains(k)).collect();
            // Of alternatives only the first that compiles stands in the text.
            let text: String = written.iter().flatten().map(|w| w.text.as_str()).collect();
            let live = live.into_iter().filter(|k| text.contains(&format!("altered::at({k})"))).collect();
            eprintln!("compiled; {} alterations did not compile", dropped.len());
            return Ok(Built { alterations, live, tests, program });
        }
        if dropped.len() == before.len() {
            return Err("the altered copy does not compile, and no alteration is at fault".to_string());
        }
        eprintln!("{} alterations do not compile", dropped.len());
        let numbers: String = dropped.iter().map(|k| format!(" {k}")).collect();
        put(&kept, &format!("{digest}{numbers}\n"))?;
    }
}

fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

fn put(path: &Path, text: &str) -> Result<(), String> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    std::fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}

/// Makes the copy equal to the workspace but for the altered files and the manifests; files that are equal keep their times.
fn synchronise(root: &Path, copy: &Path, files: &[String]) -> Result<(), String> {
    let (wanted, there) = (list(root)?, list(copy)?);
    for (relative, path) in &there {
        if !wanted.contains_key(relative) {
            std::fs::remove_file(path).map_err(|error| format!("{}: {error}", path.display()))?;
        }
    }
    for (relative, path) in &wanted {
        if files.iter().any(|file| Path::new(file) == relative) || relative.ends_with("Cargo.toml") {
            continue;
        }
        let bytes = std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
        let target = copy.join(relative);
        if std::fs::read(&target).ok().as_ref() != Some(&bytes) {
            if let Some(folder) = target.parent() {
                std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
            }
            std::fs::copy(path, &target).map_err(|error| format!("{}: {error}", target.display()))?;
        }
    }
    Ok(())
}

/// All files of a workspace, by their paths within it.
fn list(folder: &Path) -> Result<BTreeMap<PathBuf, PathBuf>, String> {
    let mut all = BTreeMap::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(next) = open.pop() {
        let Ok(entries) = std::fs::read_dir(&next) else { continue };
        for entry in entries.filter_map(Result::ok) {
            let path = entry.path();
            let name = entry.file_name();
            if ["target", ".git", "node_modules", "altered"].iter().any(|skipped| name == *skipped) {
                continue;
            }
            if path.is_dir() {
                open.push(path);
            } else if let Ok(relative) = path.strip_prefix(folder) {
                all.insert(relative.to_path_buf(), path.clone());
            }
        }
    }
    Ok(all)
}

fn put_if_new(path: &Path, text: &str) -> Result<(), String> {
    if std::fs::read_to_string(path).is_ok_and(|old| old == text) { Ok(()) } else { put(path, text) }
}

/// The manifests, with the crate of the switches, on which every crate with an altered file depends.
fn write_manifests(root: &Path, copy: &Path, files: &[String]) -> Result<(), String> {
    put_if_new(&copy.join("altered/src/lib.rs"), include_str!("altered.rs"))?;
    let manifest = "[package]\nname = \"altered\"\nversion = \"0.0.0\"\nedition = \"2024\"\n";
    put_if_new(&copy.join("altered/Cargo.toml"), manifest)?;
    let altered: BTreeSet<&str> = files.iter().filter_map(|file| file.split_once("/src/").map(|(f, _)| f)).collect();
    let line = format!("[dependencies]\naltered = {{ path = {:?} }}", copy.join("altered").display().to_string());
    for relative in list(root)?.keys().filter(|relative| relative.ends_with("Cargo.toml")) {
        let mut text = read(&root.join(relative))?;
        let folder = relative.parent().and_then(Path::to_str).unwrap_or_default();
        if altered.contains(folder) && text.contains("\n[dependencies]") {
            text = text.replacen("[dependencies]", &line, 1);
        } else if altered.contains(folder) {
            text = format!("{text}\n{line}\n");
        }
        if folder.is_empty() {
            text = without_lints(&text)?;
        }
        put_if_new(&copy.join(relative), &text)?;
    }
    Ok(())
}

/// What is altered need not be tidy, nor make sense on its own.
fn without_lints(manifest: &str) -> Result<String, String> {
    let lax = "[workspace.lints.rust]\nwarnings = { level = \"allow\", priority = -1 }\narithmetic_overflow = \"allow\"\n\
               unconditional_panic = \"allow\"\noverflowing_literals = \"allow\"\n";
    let start = manifest.find("[workspace.lints.rust]").ok_or("no lints in the workspace")?;
    let end = start + manifest[start..].find("\n[").map_or(manifest.len() - start, |at| at + 1);
    Ok(format!("{}{lax}\n{}", &manifest[..start], &manifest[end..]))
}

struct Messages {
    list: Vec<Value>,
    success: bool,
}

fn cargo(copy: &Path, scratch: &Path, arguments: &[String]) -> Result<Messages, String> {
    let (action, options) = arguments.split_first().ok_or("no command")?;
    let mut command = Command::new("cargo");
    command.arg(action).args(options).args(["--message-format=json", "--offline", "--quiet"]);
    command.current_dir(copy).env("CARGO_TARGET_DIR", scratch.join("target")).env("CARGO_INCREMENTAL", "1");
    let output = command.stderr(Stdio::piped()).output().map_err(|error| format!("cargo: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout);
    let list: Vec<Value> = text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    if !output.status.success() && !list.iter().any(|m| m["reason"] == "compiler-message") {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    Ok(Messages { list, success: output.status.success() })
}

/// Drops the alterations at which the compiler found an error: of the smallest region around the span, else of the function. The same
/// error may come from several targets: what counts is what stood in the text, `before`.
fn drop_at_fault(
    message: &Value,
    copy: &Path,
    files: &[String],
    written: &[Option<Written>],
    before: &BTreeSet<u32>,
    dropped: &mut BTreeSet<u32>,
) {
    let message = &message["message"];
    if message["level"] != "error" {
        return;
    }
    let spans = message["spans"].as_array().map_or(&[][..], Vec::as_slice);
    let place_of = |span: &Value| {
        let name = Path::new(span["file_name"].as_str().unwrap_or_default());
        files.iter().position(|file| name == Path::new(file) || name == copy.join(file))
    };
    for span in spans.iter().filter(|span| span["is_primary"] == Value::Bool(true)) {
        // Where it lies in a macro of somebody else: where that was used.
        let outward = std::iter::successors(Some(span), |span| span["expansion"].get("span"));
        let Some((k, span)) = outward.take(16).find_map(|span| Some((place_of(span)?, span))) else { continue };
        let Some(written) = &written[k] else { continue };
        let place = |key: &str| span[key].as_u64().unwrap_or(0) as usize;
        let (start, end) = (place("byte_start"), place("byte_end"));
        let around = written.regions.iter().filter(|(range, numbers)| {
            range.start <= start && end <= range.end && numbers.iter().any(|k| !before.contains(k))
        });
        let within = written.regions.iter().filter(|(range, numbers)| {
            start <= range.start && range.end <= end && numbers.iter().any(|k| !before.contains(k))
        });
        let smallest = around.min_by_key(|(range, numbers)| (range.len(), numbers.len()));
        if std::env::var_os("ALTERATIONS_VERBOSE").is_some() {
            eprintln!("{}", message["rendered"].as_str().unwrap_or_default());
        }
        // The sites within the span are nearer to the fault than the function around it.
        let inner: Vec<u32> = within.flat_map(|(_, numbers)| numbers.clone()).collect();
        match smallest {
            Some((_, numbers)) if inner.is_empty() || numbers.len() <= 4 => dropped.extend(numbers),
            _ => dropped.extend(inner),
        }
    }
}
