//! Putting shards together.

use super::files::{Header, StoreError, read, text, write_aside};
use crate::job::digest;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The file of all cases, in the store.
pub const MERGED: &str = "merged.jsonl";

/// All cases of a campaign.
#[derive(Debug, Clone, PartialEq)]
pub struct Merged {
    /// What they belong to.
    pub header: Header,
    /// The results by case.
    pub rows: BTreeMap<u64, Value>,
}

impl Merged {
    /// The file: the same bytes for any number of shards.
    pub fn text(&self) -> String {
        text(&self.header, &self.rows)
    }
}

/// Reads all finished shards of a folder, checks that together they are one campaign, and writes [`MERGED`].
///
/// # Errors
/// [`StoreError`]: gaps, overlaps, shards of other versions or campaigns, files that cannot be read or written.
pub fn merge(store: &Path) -> Result<Merged, StoreError> {
    let mut names: Vec<PathBuf> = std::fs::read_dir(store)
        .and_then(|entries| entries.map(|entry| Ok(entry?.path())).collect())
        .map_err(StoreError::at(store))?;
    names.sort();
    let is_shard = |path: &&PathBuf, end: &str| {
        path.file_name()
            .and_then(|name| name.to_str())
            .is_some_and(|name| name.starts_with("shard-") && name.ends_with(end))
    };
    let shards: Vec<&PathBuf> = names.iter().filter(|path| is_shard(path, ".jsonl")).collect();
    let mut common: Option<Header> = None;
    let (mut rows, mut owners) = (BTreeMap::new(), BTreeMap::new());
    for &path in &shards {
        let found = read(path)?;
        let no_header = || StoreError::Line { path: path.clone(), line: 1, what: "it is empty".to_string() };
        let header = Header { shard: None, ..found.header.ok_or_else(no_header)? };
        check_same(path, common.get_or_insert_with(|| header.clone()), &header)?;
        for (case, result) in found.rows {
            if let Some(first) = owners.insert(case, path) {
                return Err(StoreError::Overlap { case, first: first.clone(), second: path.clone() });
            }
            rows.insert(case, result);
        }
    }
    let unfinished = names.iter().find(|path| is_shard(path, ".jsonl.part") && !path.with_extension("").exists());
    let Some(header) = common else { return Err(StoreError::Nothing(store.to_path_buf())) };
    if let Some(first) = (0..header.cases).zip(rows.keys()).find(|(k, case)| k != *case).map(|(k, _)| k).or_else(|| {
        let count = rows.len() as u64;
        (count < header.cases).then_some(count)
    }) {
        let hint = unfinished.map_or(String::new(), |path| format!("; {} is unfinished", path.display()));
        let missing = header.cases - rows.len() as u64;
        return Err(StoreError::Gap { path: store.to_path_buf(), missing, cases: header.cases, first, hint });
    }
    let merged = Merged { header, rows };
    write_aside(&store.join(MERGED), &merged.text())?;
    Ok(merged)
}

fn check_same(path: &Path, expected: &Header, found: &Header) -> Result<(), StoreError> {
    let path = path.to_path_buf();
    if found.version != expected.version {
        let (found, expected) = (found.version.clone(), expected.version.clone());
        return Err(StoreError::Version { path, found, expected });
    }
    if found != expected {
        let (found, expected) = (digest(&found.campaign), digest(&expected.campaign));
        return Err(StoreError::Campaign { path, found, expected });
    }
    Ok(())
}
