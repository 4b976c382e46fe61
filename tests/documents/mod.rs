//! README and notes against the program: every command and every file that they show.
//!
//! A `console` block shows commands after `$ ` with what they print; a line `...` stands for any lines. They are run. A `sh` block
//! shows commands without output: those of flockproof are parsed, those of others are in a list. A comment `# exit status 1` says how a
//! command ends that does not end with 0. Blocks of `toml` and `json` are read by the program, those of `rust` are documentation tests of the library. Of Python
//! the names are looked up; it is run where the wheel is built (`python/tests/test_pages.py`).

mod page;
mod questions;
mod release;

use flockproof::question::Question;
use flockproof::report::{Figure, Site};
use flockproof::scenario::{Ensemble, Scenario};
use page::{Page, pages, root, spans};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// How commands of other programs begin.
const OF_OTHERS: [&str; 4] = ["cargo ", "git ", "python3 ", "source <("];

/// Folders of the repository whose files the pages name.
const FOLDERS: [&str; 11] = [
    ".ci/",
    "assets/",
    "benches/",
    "crates/",
    "documentation/",
    "fuzz/",
    "notes/",
    "packaging/",
    "proofs_checks/",
    "src/",
    "tests/",
];

/// A folder of its own with the examples that come with the program.
fn workplace(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    copy(&root().join("assets"), &folder.join("assets"));
    folder
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).expect("a folder");
    for entry in std::fs::read_dir(from).expect("a folder").map(|entry| entry.expect("an entry")) {
        let (source, target) = (entry.path(), to.join(entry.file_name()));
        if source.is_dir() {
            copy(&source, &target);
        } else {
            std::fs::copy(source, target).expect("a copy");
        }
    }
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_flockproof"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("the program starts")
}

/// The words of a command of flockproof, whether it is installed or not.
fn arguments(command: &str) -> Option<Vec<&str>> {
    let rest = ["flockproof ", "cargo run --release -- "].iter().find_map(|start| command.strip_prefix(start))?;
    let rest = rest.split(" #").next().unwrap_or("");
    assert!(!rest.contains(['"', '\'', '|', '>', ';']), "`{command}` is more than words");
    Some(rest.split_whitespace().collect())
}

/// Whether the program understands these arguments; nothing is run.
fn is_understood(arguments: &[&str]) -> bool {
    run(root(), &[arguments, &["--help"]].concat()).status.success()
}

/// Whether the lines are as shown, where `...` stands for any lines.
fn is_as_shown(shown: &[&str], lines: &[&str]) -> bool {
    match shown.split_first() {
        None => lines.is_empty(),
        Some((&"...", rest)) => (0..=lines.len()).any(|k| is_as_shown(rest, &lines[k..])),
        Some((first, rest)) => {
            lines.split_first().is_some_and(|(line, others)| line == first && is_as_shown(rest, others))
        }
    }
}

#[test]
fn console_blocks_show_what_is_printed() {
    let folder = workplace("documents-console");
    let (mut count, mut wrong) = (0, Vec::new());
    for page in pages() {
        let blocks = page.blocks();
        for shown in blocks.iter().filter(|block| block.language == "console").flat_map(|block| block.commands()) {
            let words = arguments(shown.command).unwrap_or_else(|| panic!("`{}` is not run", shown.command));
            let output = run(&folder, &words);
            let printed = String::from_utf8_lossy(&output.stdout).into_owned();
            let error = String::from_utf8_lossy(&output.stderr).into_owned();
            let expected = shown.command.split_once("# exit status ").map_or(Ok(0), |(_, code)| code.trim().parse());
            assert_eq!(output.status.code(), expected.ok(), "{}: `{}`: {error}", page.path.display(), shown.command);
            let lines: Vec<&str> = printed.trim_end().lines().map(str::trim_end).collect();
            if !is_as_shown(&shown.output, &lines) {
                wrong.push(format!(
                    "{} does not show what `{}` prints:\n{printed}",
                    page.path.display(),
                    shown.command
                ));
            }
            count += 1;
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 10);
}

#[test]
fn commands_are_understood() {
    let mut commands = BTreeSet::new();
    for page in pages() {
        for block in page.blocks().iter().filter(|block| block.language == "sh") {
            for line in block.lines.iter().filter(|line| !line.is_empty() && !line.starts_with('#')) {
                let known = arguments(line).is_some() || OF_OTHERS.iter().any(|start| line.starts_with(start));
                assert!(known, "{}: `{line}` is nobody's command", page.path.display());
                commands.insert(line.to_string());
            }
        }
        for line in page.indented() {
            let command = line.starts_with("flockproof ") || OF_OTHERS.iter().any(|start| line.starts_with(start));
            assert!(!command, "{}: `{line}` should stand in a block of console or sh", page.path.display());
        }
        commands.extend(page.spans());
    }
    for words in commands.iter().filter_map(|command| arguments(command)) {
        assert!(is_understood(&words), "`{}` is not understood", words.join(" "));
    }
}

#[test]
fn claims_and_figures_exist() {
    let ledger = flockproof::claims::ledger().expect("the ledger");
    for page in pages() {
        for span in page.spans() {
            let words: Vec<&str> = span.trim_start_matches("flockproof ").split(' ').collect();
            let known = match words[..] {
                ["explain", id] => {
                    id.chars().all(|c| c.is_uppercase()) || ledger.select(&[], &[id.to_string()]).is_ok()
                }
                ["reproduce", name, ..] => name == "all" || Figure::named(name).len() == 1,
                _ => true,
            };
            assert!(known, "{}: `{span}` names what does not exist", page.path.display());
        }
    }
}

#[test]
fn shown_files_can_be_read() {
    let folder = workplace("documents-files");
    let mut count = 0;
    for page in pages() {
        for block in page.blocks() {
            let contents = block.lines.join("\n") + "\n";
            let place = format!("{}, after `{}`", page.path.display(), block.before);
            match block.language {
                "toml" if contents.contains("[question]") => {
                    // Laws of the gallery may be named.
                    let files = |name: &str| match name.strip_prefix("assets/laws/") {
                        Some(law) => std::fs::read_to_string(root().join("assets/laws").join(law))
                            .map_err(|error| error.to_string()),
                        None => Err(format!("there is no file {name}")),
                    };
                    let read = Question::read(&contents, &files);
                    assert!(read.is_ok(), "{place}: {:?}", read.err());
                }
                "toml" if contents.contains("[[mode]]") || contents.contains("[platoon]") => {
                    let read = flockproof::reach::System::read(&contents);
                    assert!(read.is_ok(), "{place}: {:?}", read.err());
                }
                "toml" => {
                    let read = Ensemble::read(&contents).and_then(|many| match many {
                        Some(_) => Ok(()),
                        None => Scenario::read(&contents).map(|_| ()),
                    });
                    assert!(read.is_ok(), "{place}: {:?}", read.err());
                }
                "json" => {
                    std::fs::write(folder.join("shown.json"), &contents).expect("a file");
                    let output = run(&folder, &["flock", "run", "shown.json", "--until", "1"]);
                    assert!(output.status.success(), "{place}: {}", String::from_utf8_lossy(&output.stderr));
                }
                "console" | "sh" | "rust" | "python" | "text" => continue,
                other => panic!("{place}: a block of `{other}` is not checked"),
            }
            count += 1;
        }
    }
    assert!(count > 2);
}

/// The names of the Python package that the pages use.
#[test]
fn python_uses_names_that_exist() {
    let package = std::fs::read_to_string(root().join("python/flockproof/__init__.py")).expect("text");
    let (_, list) = package.split_once("__all__ = [").expect("the list of names");
    let names: BTreeSet<&str> = list.split(']').next().unwrap_or("").split('"').skip(1).step_by(2).collect();
    let mut used = 0;
    for page in pages() {
        let blocks = page.blocks();
        let of_block = |language: &'static str| blocks.iter().filter(move |block| block.language == language);
        let short = of_block("sh").flat_map(|block| &block.lines).filter(|line| line.starts_with("python3 -c "));
        for line in of_block("python").flat_map(|block| &block.lines).chain(short) {
            for after in line.split("flockproof.").skip(1) {
                let name = after.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or("");
                assert!(names.contains(name), "{}: there is no flockproof.{name}", page.path.display());
                used += 1;
            }
        }
    }
    assert!(used > 4);
}

/// Where the paragraph before a block of a file names one of the examples, the block is that file.
#[test]
fn shown_examples_are_those_that_come_with_the_program() {
    for page in pages() {
        for block in page.blocks().iter().filter(|block| ["toml", "json", "text"].contains(&block.language)) {
            for name in spans(&block.before).iter().filter(|name| root().join(name).is_file()) {
                let file = std::fs::read_to_string(root().join(name)).expect("text");
                assert_eq!(block.lines.join("\n"), file.trim_end(), "{} in {}", name, page.path.display());
            }
        }
    }
}

#[test]
fn named_files_exist() {
    let exists = |page: &Page, name: &str| {
        root().join(name).exists() || page.path.parent().is_some_and(|folder| root().join(folder).join(name).exists())
    };
    let is_placeholder = |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_uppercase());
    let mut missing = Vec::new();
    for page in pages() {
        let one_file = |span: &&String| !span.contains([' ', '*', '{']) && !span.split('/').any(is_placeholder);
        for span in page.spans().iter().filter(one_file) {
            let names_file = span.ends_with(".md") || FOLDERS.iter().any(|folder| span.starts_with(folder));
            if names_file && !exists(&page, span) {
                missing.push(format!("{}: there is no {span}", page.path.display()));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
    let readme = std::fs::read_to_string(root().join("README.md")).expect("text");
    for picture in readme.split("src=\"").skip(1).filter_map(|after| after.split('"').next()) {
        assert!(root().join(picture).is_file(), "README.md: there is no {picture}");
    }
}

/// The site shows the files as they are, and each place of a proof on paper is a note that is there.
#[test]
fn shown_and_named_notes_exist() {
    for path in Site::shown() {
        let file = std::fs::read_to_string(root().join(&path)).unwrap_or_else(|error| panic!("{path}: {error}"));
        assert!(!file.is_empty(), "{path}");
    }
    let mut folders = vec![root().join("crates/claims/src")];
    let mut named = BTreeSet::new();
    while let Some(folder) = folders.pop() {
        for path in std::fs::read_dir(&folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
            if path.is_dir() {
                folders.push(path);
            } else {
                let text = std::fs::read_to_string(&path).expect("text");
                let notes = text.split("notes/").skip(1).filter_map(|rest| rest.split_once(".md"));
                let is_name = |name: &str| name.chars().all(|c| c.is_ascii_alphanumeric() || "_-".contains(c));
                named.extend(notes.map(|(name, _)| name.to_string()).filter(|name| is_name(name)));
            }
        }
    }
    assert!(named.len() > 5, "{named:?}");
    for name in named {
        assert!(root().join(format!("notes/{name}.md")).is_file(), "there is no note {name}");
    }
}

#[test]
fn the_index_names_every_page_of_the_notes() {
    let pages = pages();
    let index = pages.iter().find(|page| page.path == Path::new("notes/README.md")).expect("the index");
    let named = index.spans();
    for page in pages.iter().filter(|page| page.path.starts_with("notes") && page.path != index.path) {
        let name = page.path.file_name().and_then(|name| name.to_str()).expect("UTF-8");
        let count = named.iter().filter(|span| *span == name).count();
        assert_eq!(count, 1, "notes/README.md names {name} {count} times");
    }
}

#[test]
fn the_two_commands_of_the_readme() {
    let readme = pages().into_iter().find(|page| page.path == Path::new("README.md")).expect("README.md");
    let blocks = readme.blocks();
    let lines: Vec<&str> = blocks.iter().filter(|block| block.language == "sh").flat_map(|b| b.lines.clone()).collect();
    for command in ["cargo run --release -- verify", "cargo test"] {
        assert!(lines.contains(&command), "{command}");
    }
}

#[test]
fn the_readme_counts_the_statements() {
    let readme = std::fs::read_to_string(root().join("README.md")).expect("text");
    let mut papers = BTreeMap::new();
    for row in flockproof::ledger::listed(flockproof::claims::LISTED) {
        *papers.entry(row.id.split('.').next().unwrap_or("")).or_insert(0) += 1;
    }
    assert_eq!(papers.len(), 5);
    for (paper, count) in &papers {
        assert!(readme.contains(&format!("| {count}: ")), "{paper}: {count}");
    }
    assert!(readme.contains(&format!("{} statements", papers.values().sum::<usize>())));
}

#[test]
fn what_differs_is_noticed() {
    let printed = ["one", "two", "three"];
    for shown in
        [&["one", "two", "three"][..], &["..."], &["one", "..."], &["...", "two", "..."], &["one", "...", "three"]]
    {
        assert!(is_as_shown(shown, &printed), "{shown:?}");
    }
    for shown in [&["one", "two"][..], &[], &["...", "two"], &["two", "..."], &["one", "...", "two"], &["one", "three"]]
    {
        assert!(!is_as_shown(shown, &printed), "{shown:?}");
    }
}

#[test]
fn equivalent_alterations_are_of_sources_that_exist() {
    let list = std::fs::read_to_string(root().join("proofs_checks/alterations/equivalent.tsv")).expect("a list");
    for row in list.lines().skip(1) {
        let fields: Vec<&str> = row.split('\t').collect();
        assert!(fields.len() == 5 && root().join(fields[0]).is_file(), "{row}");
    }
}

/// The first page of each crate that others can use shows by an example what it is for; `cargo test --doc` runs them.
#[test]
fn every_crate_begins_with_an_example() {
    let crates = std::fs::read_dir(root().join("crates")).expect("the crates");
    let mut folders: Vec<PathBuf> = crates.map(|entry| entry.expect("a crate").path()).collect();
    folders.extend(["", "proofs_checks", "proofs_checks/checker"].map(|name| root().join(name)));
    assert!(folders.len() > 15);
    for folder in folders {
        let source = std::fs::read_to_string(folder.join("src/lib.rs")).expect("a library");
        let first: Vec<&str> = source.lines().take_while(|line| line.starts_with("//!")).collect();
        assert_eq!(first.iter().filter(|line| **line == "//! ```").count(), 2, "{}", folder.display());
    }
}
