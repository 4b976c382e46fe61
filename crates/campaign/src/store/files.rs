//! The files of shards, line by line.

use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fmt;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::atomic::{AtomicU64, Ordering};

/// The form of the files.
const SCHEMA: &str = "flockproof.shard/2";

/// Why a store cannot be written, resumed or merged. Files are named by their paths.
#[derive(Debug, thiserror::Error)]
pub enum StoreError {
    /// The file system refuses.
    #[error("{}: {error}", path.display())]
    File {
        /// Where.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// Not a shard.
    #[error("`{0}` is no shard: it should be i/n with 1 <= i <= n")]
    Shard(String),
    /// There already, and not to be gone on with.
    #[error("{}: it is there already; --resume goes on with it, another folder begins anew", .0.display())]
    Exists(PathBuf),
    /// Another process has it.
    #[error("{}: another process is writing it", .0.display())]
    Locked(PathBuf),
    /// A line that is not of a store.
    #[error("{}, line {line}: {what}", path.display())]
    Line {
        /// The file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// What is wrong.
        what: String,
    },
    /// Results of another version.
    #[error("{}: it was made by version {found}, not {expected}", path.display())]
    Version {
        /// The file.
        path: PathBuf,
        /// Its version.
        found: String,
        /// The version of the others, or of this program.
        expected: String,
    },
    /// Results of another campaign.
    #[error("{}: it belongs to another question ({found}, not {expected}), and this one needs a folder of its own", path.display())]
    Campaign {
        /// The file.
        path: PathBuf,
        /// Its digest.
        found: String,
        /// That of the others, or of this campaign.
        expected: String,
    },
    /// A case that makes no sense.
    #[error("case {case}: {why}")]
    Refused {
        /// The case.
        case: u64,
        /// Why.
        why: String,
    },
    /// Nothing to merge.
    #[error("{}: there is no finished shard in it", .0.display())]
    Nothing(PathBuf),
    /// Cases that no shard has.
    #[error("{}: {missing} of {cases} cases are in no finished shard, the first is case {first}{hint}", path.display())]
    Gap {
        /// The folder.
        path: PathBuf,
        /// How many.
        missing: u64,
        /// Of how many.
        cases: u64,
        /// The first.
        first: u64,
        /// What may be done.
        hint: String,
    },
    /// A case that two shards have.
    #[error("case {case} is both in {} and in {}", first.display(), second.display())]
    Overlap {
        /// The case.
        case: u64,
        /// One file.
        first: PathBuf,
        /// The other.
        second: PathBuf,
    },
}

impl StoreError {
    /// For `map_err`.
    pub(super) fn at(path: &Path) -> impl Fn(io::Error) -> StoreError + '_ {
        move |error| StoreError::File { path: path.to_path_buf(), error }
    }
}

/// One part of a campaign: the cases `index - 1` modulo `of`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Which, from 1.
    pub index: u64,
    /// How many there are.
    pub of: u64,
}

impl Shard {
    /// All cases.
    pub const WHOLE: Shard = Shard { index: 1, of: 1 };

    /// Whether a case belongs to it.
    pub fn has(self, case: u64) -> bool {
        case % self.of == self.index - 1
    }

    /// How many of so many cases it has.
    pub fn count(self, all: u64) -> u64 {
        all.saturating_sub(self.index - 1).div_ceil(self.of)
    }

    /// Its `k`-th case, from 0.
    pub fn case(self, k: u64) -> u64 {
        self.index - 1 + k * self.of
    }

    /// The finished file.
    pub fn path(self, store: &Path) -> PathBuf {
        store.join(format!("shard-{}-of-{}.jsonl", self.index, self.of))
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

impl FromStr for Shard {
    type Err = StoreError;

    fn from_str(text: &str) -> Result<Self, StoreError> {
        let digits = |part: &str| part.bytes().all(|b| b.is_ascii_digit()).then(|| part.parse().ok()).flatten();
        let parts = text.split_once('/').and_then(|(i, n)| Some((digits(i)?, digits(n)?)));
        match parts {
            Some((index, of)) if (1..=of).contains(&index) => Ok(Shard { index, of }),
            _ => Err(StoreError::Shard(text.to_string())),
        }
    }
}

/// What a file belongs to: its first line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Header {
    /// The version of the program.
    pub version: String,
    /// The canonical text of the campaign.
    pub campaign: String,
    /// Number of cases of all shards.
    pub cases: u64,
    /// Which shard; `None` for a merged store.
    pub shard: Option<Shard>,
}

impl Header {
    pub(super) fn line(&self) -> String {
        let shard = self.shard.map(|shard| shard.to_string());
        let header = json!({
            "schema": SCHEMA, "version": self.version, "campaign": self.campaign, "cases": self.cases, "shard": shard
        });
        sealed(&header.to_string(), "")
    }

    /// What the lines belong to: the same for all shards.
    fn salt(&self) -> String {
        Header { shard: None, ..self.clone() }.line()
    }

    fn parse(line: &str) -> Result<Self, String> {
        let value: Value = serde_json::from_str(line).map_err(|_| "it is not JSON".to_string())?;
        if value["schema"] != SCHEMA {
            return Err(format!("it does not begin with the schema {SCHEMA}"));
        }
        check_seal(line, "")?;
        let text = |name: &str| value[name].as_str().map(str::to_string).ok_or(format!("there is no `{name}`"));
        let shard = match &value["shard"] {
            Value::Null => None,
            shard => Some(shard.as_str().unwrap_or_default().parse().map_err(|error: StoreError| error.to_string())?),
        };
        let cases = value["cases"].as_u64().ok_or("there is no number of `cases`")?;
        Ok(Header { version: text("version")?, campaign: text("campaign")?, cases, shard })
    }
}

/// The result of one case.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The case.
    pub case: u64,
    /// What it gave.
    pub result: Value,
}

impl Row {
    /// The line in a file with this header.
    pub(super) fn line(&self, salt: &Salt) -> String {
        sealed(&json!({"case": self.case, "result": self.result}).to_string(), &salt.0)
    }

    fn parse(line: &str, salt: &Salt) -> Result<Self, String> {
        let mut value: Value = serde_json::from_str(line).map_err(|_| "it is not JSON".to_string())?;
        let case = value["case"].as_u64().ok_or("there is no `case`")?;
        let result = value.get_mut("result").map(Value::take).ok_or("there is no `result`")?;
        check_seal(line, &salt.0)?;
        Ok(Row { case, result })
    }
}

/// What the lines of a campaign have in common.
pub(super) struct Salt(String);

impl Salt {
    pub(super) fn of(header: &Header) -> Self {
        Salt(header.salt())
    }
}

/// The name of the last field of a line: a digest of the text before it and of what the line belongs to, so that no altered line, nor one of
/// another campaign, is taken for a result.
const SEAL: &str = ",\"sha256\":\"";

/// Digits of a seal.
const SEAL_DIGITS: usize = 32;

/// A JSON object with its digest.
fn sealed(object: &str, salt: &str) -> String {
    let open = object.strip_suffix('}').unwrap_or(object);
    format!("{open}{SEAL}{}\"}}", seal(open, salt))
}

fn seal(text: &str, salt: &str) -> String {
    let hash = Sha256::new().chain_update(salt).chain_update("\n").chain_update(text).finalize();
    hash.iter().take(SEAL_DIGITS / 2).map(|byte| format!("{byte:02x}")).collect()
}

/// Whether a line is as it was written.
fn check_seal(line: &str, salt: &str) -> Result<(), String> {
    let parts = line.rsplit_once(SEAL).and_then(|(text, seal)| Some((text, seal.strip_suffix("\"}")?)));
    match parts {
        Some((text, found)) if found == seal(text, salt) => Ok(()),
        Some(_) => Err("it was altered: it does not have its digest".to_string()),
        None => Err("there is no digest, `sha256`, at its end".to_string()),
    }
}

/// A file of a store. `whole` is the number of bytes of its whole lines.
pub(super) struct Contents {
    pub header: Option<Header>,
    pub rows: BTreeMap<u64, Value>,
    pub whole: u64,
}

/// Reads a file. What a killed process left of a last line is not read.
pub(super) fn read(path: &Path) -> Result<Contents, StoreError> {
    let mut bytes = Vec::new();
    std::fs::File::open(path).and_then(|mut file| file.read_to_end(&mut bytes)).map_err(StoreError::at(path))?;
    let whole = bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |end| end + 1);
    let wrong = |line: usize, what: String| StoreError::Line { path: path.to_path_buf(), line, what };
    let text = std::str::from_utf8(&bytes[..whole]).map_err(|_| wrong(1, "it is not text (UTF-8)".to_string()))?;
    let mut lines = text.lines().enumerate().map(|(k, line)| (k + 1, line));
    let header = lines.next().map(|(_, line)| Header::parse(line).map_err(|what| wrong(1, what))).transpose()?;
    let mut rows = BTreeMap::new();
    let salt = header.as_ref().map_or(Salt(String::new()), Salt::of);
    for (line, text) in lines {
        let row = Row::parse(text, &salt).map_err(|what| wrong(line, what))?;
        let header = header.as_ref();
        let is_there = header.is_some_and(|h| row.case < h.cases && h.shard.is_none_or(|shard| shard.has(row.case)));
        if !is_there {
            return Err(wrong(line, format!("case {} is not one of this shard", row.case)));
        }
        if rows.insert(row.case, row.result).is_some() {
            return Err(wrong(line, format!("case {} comes twice", row.case)));
        }
    }
    Ok(Contents { header, rows, whole: whole as u64 })
}

/// The whole file: the header, then the rows by their cases.
pub(super) fn text(header: &Header, rows: &BTreeMap<u64, Value>) -> String {
    let mut text = header.line() + "\n";
    let salt = Salt::of(header);
    for (case, result) in rows {
        text.push_str(&Row { case: *case, result: result.clone() }.line(&salt));
        text.push('\n');
    }
    text
}

/// A name beside a file under which it is written before it is renamed: of this process and this call alone, so that nobody else writes, renames or removes
/// it.
pub fn aside(path: &Path) -> PathBuf {
    static WRITTEN: AtomicU64 = AtomicU64::new(0);
    let number = WRITTEN.fetch_add(1, Ordering::Relaxed);
    let mut name = path.as_os_str().to_owned();
    name.push(format!(".{}-{number}.new", std::process::id()));
    name.into()
}

/// Writes a file aside, lets the disk have it, and renames it.
pub(super) fn write_aside(path: &Path, contents: &str) -> Result<(), StoreError> {
    let aside = aside(path);
    std::fs::File::create_new(&aside)
        .and_then(|mut file| file.write_all(contents.as_bytes()).and_then(|()| file.sync_all()))
        .map_err(StoreError::at(&aside))?;
    std::fs::rename(&aside, path).map_err(StoreError::at(path))
}
