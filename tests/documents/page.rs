//! What a page of Markdown contains: fenced blocks, code within sentences, text that is indented like code.

use std::path::{Path, PathBuf};

/// A page of the repository.
pub struct Page {
    /// Its path from the root.
    pub path: PathBuf,
    text: String,
}

/// A fenced block.
pub struct Block<'a> {
    /// The word after the fence.
    pub language: &'a str,
    /// Its lines.
    pub lines: Vec<&'a str>,
    /// The paragraph before it.
    pub before: String,
}

/// A command of a console block with the lines that are shown below it.
pub struct Shown<'a> {
    /// Without the prompt.
    pub command: &'a str,
    /// What it prints; `...` stands for any lines.
    pub output: Vec<&'a str>,
}

/// The root of the repository.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All pages that people read: those at the root, the notes, and those beside proofs, the Python package and benches.
pub fn pages() -> Vec<Page> {
    let in_folder = |folder: &str| {
        let entries = std::fs::read_dir(root().join(folder)).expect("a folder");
        let names = entries.map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8"));
        names.filter(|name| name.ends_with(".md")).map(|name| Path::new(folder).join(name)).collect::<Vec<_>>()
    };
    let mut paths: Vec<PathBuf> =
        ["", "notes", "proofs_checks", "python", "benches/peers"].iter().flat_map(|folder| in_folder(folder)).collect();
    paths.sort();
    paths
        .into_iter()
        .map(|path| Page { text: std::fs::read_to_string(root().join(&path)).expect("text"), path })
        .collect()
}

impl Page {
    /// Its fenced blocks in order.
    pub fn blocks(&self) -> Vec<Block<'_>> {
        let mut blocks: Vec<Block> = Vec::new();
        let (mut open, mut before) = (false, String::new());
        for line in self.text.lines() {
            match (line.strip_prefix("```"), open) {
                (Some(language), false) => {
                    blocks.push(Block { language, lines: Vec::new(), before: std::mem::take(&mut before) });
                    open = true;
                }
                (Some(_), true) => open = false,
                (None, true) => blocks.last_mut().expect("an open block").lines.push(line),
                (None, false) if line.starts_with('#') => before.clear(),
                (None, false) => before.push_str(&format!("{line}\n")),
            }
        }
        assert!(!open, "{}: a block does not end", self.path.display());
        for block in &mut blocks {
            let paragraph = block.before.trim_end().rsplit("\n\n").next().unwrap_or("").to_string();
            block.before = paragraph;
        }
        blocks
    }

    /// Everything outside fenced blocks.
    fn prose(&self) -> String {
        self.text.split("```").step_by(2).collect()
    }

    /// Code within sentences.
    pub fn spans(&self) -> Vec<String> {
        spans(&self.prose())
    }

    /// Lines outside fenced blocks that Markdown shows as code.
    pub fn indented(&self) -> Vec<String> {
        self.prose().lines().filter_map(|line| line.strip_prefix("    ")).map(str::to_string).collect()
    }
}

/// What stands between backticks.
pub fn spans(text: &str) -> Vec<String> {
    text.split('`').skip(1).step_by(2).map(|span| span.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

impl<'a> Block<'a> {
    /// The commands of a console block.
    pub fn commands(&self) -> Vec<Shown<'a>> {
        let mut commands: Vec<Shown> = Vec::new();
        for &line in &self.lines {
            match (line.strip_prefix("$ "), commands.last_mut()) {
                (Some(command), _) => commands.push(Shown { command, output: Vec::new() }),
                (None, Some(shown)) => shown.output.push(line),
                (None, None) => panic!("`{line}` stands before the first command"),
            }
        }
        commands
    }
}
