//! The results: one table for each altered file.

use crate::sites::Alteration;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// What became of one alteration.
#[derive(Clone, PartialEq, Eq)]
pub struct Row {
    pub line: usize,
    pub column: usize,
    pub original: String,
    pub altered: String,
    pub verdict: String,
    pub by: String,
}

type Key = (usize, usize, String, String);

/// The table of a file.
pub struct Table {
    pub file: String,
    pub digest: String,
    /// Alterations that compile.
    pub total: usize,
    pub rows: BTreeMap<Key, Row>,
}

pub fn key(alteration: &Alteration) -> Key {
    (alteration.line, alteration.column, clean(&alteration.original), clean(&alteration.altered))
}

fn clean(text: &str) -> String {
    text.replace('\t', " ")
}

/// The digest of a source: lines of comments, which cannot be altered, count as empty ones, and tests at its end do not count.
pub fn digest(text: &str) -> String {
    let is_comment = |line: &str| line.trim_start().starts_with("//");
    let code = |line: &str| if is_comment(line) { "\n".to_string() } else { format!("{line}\n") };
    digest_of(without_tests(text).lines().map(code).collect::<String>().as_bytes())
}

/// A source without `mod tests` in its last lines.
fn without_tests(text: &str) -> &str {
    const START: &str = "\n#[cfg(test)]\nmod tests";
    let Some(start) = text.rfind(START) else { return text };
    let rest = &text[start + START.len()..];
    let ends_there = rest == ";\n" || rest.find("\n}\n").is_some_and(|end| end + 3 == rest.len());
    if ends_there { text[..start].trim_end() } else { text }
}

pub fn digest_of(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().take(8).map(|byte| format!("{byte:02x}")).collect()
}

pub fn path_of(results: &Path, file: &str) -> PathBuf {
    results.join(format!("{}.tsv", file.trim_end_matches(".rs").replace(['/'], "-").replace("-src-", "-")))
}

impl Table {
    /// The recorded table of a file, empty where there is none or it is of another state of the file.
    pub fn read(results: &Path, file: &str, source: &str) -> Table {
        let digest = digest(source);
        match Table::recorded(&path_of(results, file)) {
            Some(table) if table.digest == digest && table.file == file => table,
            _ => Table { file: file.to_string(), digest, total: 0, rows: BTreeMap::new() },
        }
    }

    /// A table as it stands in the folder of results.
    pub fn recorded(path: &Path) -> Option<Table> {
        let text = std::fs::read_to_string(path).ok()?;
        let mut lines = text.lines();
        let head: Vec<&str> = lines.next()?.split('\t').collect();
        let [file, digest, total] = head[..] else { return None };
        let mut rows = BTreeMap::new();
        for line in lines.skip(1) {
            let fields: Vec<&str> = line.split('\t').collect();
            let [line, column, original, altered, verdict, by] = fields[..] else { return None };
            let row = Row {
                line: line.parse().ok()?,
                column: column.parse().ok()?,
                original: original.to_string(),
                altered: altered.to_string(),
                verdict: verdict.to_string(),
                by: by.to_string(),
            };
            rows.insert((row.line, row.column, row.original.clone(), row.altered.clone()), row);
        }
        let total = total.strip_prefix("alterations ")?.parse().ok()?;
        let digest = digest.strip_prefix("sha256 ")?.to_string();
        Some(Table { file: file.to_string(), digest, total, rows })
    }

    pub fn put(&mut self, alteration: &Alteration, verdict: &str, by: &str) {
        let key = key(alteration);
        let row = Row {
            line: key.0,
            column: key.1,
            original: key.2.clone(),
            altered: key.3.clone(),
            verdict: verdict.to_string(),
            by: clean(by),
        };
        self.rows.insert(key, row);
    }

    pub fn write(&self, results: &Path) -> Result<(), String> {
        let mut text = format!("{}\tsha256 {}\talterations {}\n", self.file, self.digest, self.total);
        text.push_str("line\tcolumn\toriginal\taltered\tverdict\tnoticed by\n");
        for row in self.rows.values() {
            let Row { line, column, original, altered, verdict, by } = row;
            text.push_str(&format!("{line}\t{column}\t{original}\t{altered}\t{verdict}\t{by}\n"));
        }
        // Put in its place at once, so that an interruption leaves the table as it was or as it is now.
        let path = path_of(results, &self.file);
        let beside = path.with_extension("tsv.part");
        let written = std::fs::write(&beside, text).and_then(|()| std::fs::rename(&beside, &path));
        written.map_err(|error| format!("{}: {error}", path.display()))
    }

    pub fn count(&self, verdict: &str) -> usize {
        self.rows.values().filter(|row| row.verdict == verdict).count()
    }
}

/// Alterations that change nothing that is promised, with the reason: file, the line of the source, what is altered, into what. `*`
/// stands for whatever is altered in the line, but for leaving out a statement.
pub struct Equivalents(Vec<[String; 5]>);

impl Equivalents {
    pub fn read(path: &Path) -> Equivalents {
        let text = std::fs::read_to_string(path).unwrap_or_default();
        let row = |line: &str| {
            let fields: Vec<String> = line.split('\t').map(String::from).collect();
            <[String; 5]>::try_from(fields).ok()
        };
        Equivalents(text.lines().skip(1).filter_map(row).collect())
    }

    /// Rows of a file whose line does not stand in its source any more.
    pub fn stale<'a>(&'a self, file: &'a str, source: &'a str) -> impl Iterator<Item = &'a str> {
        let stands = |line: &str| source.lines().any(|other| other.trim() == line);
        self.0.iter().filter(move |row| row[0] == file && !stands(&row[1])).map(|row| row[1].as_str())
    }

    pub fn why(&self, file: &str, line: &str, original: &str, altered: &str) -> Option<&str> {
        let is_this = |row: &&[String; 5]| {
            let anything = row[2] == "*" && altered != "(left out)";
            let is_alteration = anything || row[2] == original && (row[3] == altered || row[3] == "*");
            row[0] == file && row[1] == line.trim() && is_alteration
        };
        self.0.iter().find(is_this).map(|row| row[4].as_str())
    }
}
