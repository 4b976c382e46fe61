//! Running the cases of one shard.

use super::files::{Header, Row, Salt, Shard, StoreError, read, text, write_aside};
use crate::VERSION;
use crate::job::{Campaign, JobError, digest};
use arithmetic::Progress;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{File, OpenOptions, TryLockError};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc;

/// What a run reached.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// The results by case.
    pub rows: BTreeMap<u64, Value>,
    /// How many there should be.
    pub cases: u64,
}

impl Run {
    /// Whether nothing is missing.
    pub fn is_complete(&self) -> bool {
        self.rows.len() as u64 == self.cases
    }
}

/// Runs all cases without a store.
///
/// # Errors
/// [`StoreError::Refused`].
pub fn run_in_memory(campaign: &dyn Campaign, progress: &dyn Progress) -> Result<Run, StoreError> {
    let mut rows = BTreeMap::new();
    let pending = Pending::new(Shard::WHOLE, campaign.cases(), BTreeSet::new());
    let keep = |row: Row| {
        rows.insert(row.case, row.result);
        Ok(())
    };
    run_cases(campaign, &pending, keep, progress)?;
    Ok(Run { rows, cases: pending.all })
}

/// Runs one shard, or what is missing of it, with a line on the disk for every finished case.
///
/// # Errors
/// [`StoreError`]: the store is of another campaign or version, is there already, or cannot be written.
pub fn run_shard(
    campaign: &dyn Campaign,
    store: &Path,
    shard: Shard,
    resume: bool,
    progress: &dyn Progress,
) -> Result<Run, StoreError> {
    std::fs::create_dir_all(store).map_err(StoreError::at(store))?;
    let header = Header {
        version: VERSION.to_string(),
        campaign: campaign.canonical(),
        cases: campaign.cases(),
        shard: Some(shard),
    };
    let path = shard.path(store);
    let mut part = path.clone().into_os_string();
    part.push(".part");
    let part = PathBuf::from(part);
    // A file without results is in nobody's way.
    let is_begun = || part.exists() && read(&part).map_or(true, |found| !found.rows.is_empty());
    if !resume && path.exists() {
        return Err(StoreError::Exists(path));
    }
    if !resume && is_begun() {
        return Err(StoreError::Exists(part));
    }
    let cases = shard.count(header.cases);
    if path.exists() {
        let found = read(&path)?;
        belongs(&path, found.header.as_ref(), &header)?;
        let run = Run { rows: found.rows, cases };
        if run.is_complete() {
            // A process killed between the two leaves it behind.
            let _ = std::fs::remove_file(&part);
            return Ok(run);
        }
    }
    let (mut file, mut rows) = open(&part, &header)?;
    let pending = Pending::new(shard, header.cases, rows.keys().copied().collect());
    let salt = Salt::of(&header);
    let keep = |row: Row| {
        file.write_all((row.line(&salt) + "\n").as_bytes()).map_err(StoreError::at(&part))?;
        rows.insert(row.case, row.result);
        Ok(())
    };
    run_cases(campaign, &pending, keep, progress)?;
    let run = Run { rows, cases };
    if run.is_complete() {
        write_aside(&path, &text(&header, &run.rows))?;
        std::fs::remove_file(&part).map_err(StoreError::at(&part))?;
    }
    Ok(run)
}

/// Whether a file is of the campaign of this header.
fn belongs(path: &Path, found: Option<&Header>, expected: &Header) -> Result<(), StoreError> {
    let Some(found) = found else { return Ok(()) };
    let path = path.to_path_buf();
    if found.version != expected.version {
        let (found, expected) = (found.version.clone(), expected.version.clone());
        return Err(StoreError::Version { path, found, expected });
    }
    if (&found.campaign, found.cases, found.shard) != (&expected.campaign, expected.cases, expected.shard) {
        let (found, expected) = (digest(&found.campaign), digest(&expected.campaign));
        return Err(StoreError::Campaign { path, found, expected });
    }
    Ok(())
}

/// Opens the file of finished cases, with what an earlier process finished, and keeps others away from it.
fn open(part: &Path, header: &Header) -> Result<(File, BTreeMap<u64, Value>), StoreError> {
    let at = StoreError::at(part);
    let mut file = OpenOptions::new().create(true).append(true).open(part).map_err(&at)?;
    match file.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => return Err(StoreError::Locked(part.to_path_buf())),
        // Some network file systems know no locks.
        Err(TryLockError::Error(error)) if error.kind() == std::io::ErrorKind::Unsupported => {}
        Err(TryLockError::Error(error)) => return Err(at(error)),
    }
    let found = read(part)?;
    let is_empty = found.rows.is_empty();
    if !is_empty {
        belongs(part, found.header.as_ref(), header)?;
    }
    // The half of a line that a killed process left, or the header of a run that finished nothing.
    file.set_len(if is_empty { 0 } else { found.whole }).map_err(&at)?;
    if is_empty {
        file.write_all((header.line() + "\n").as_bytes()).map_err(&at)?;
    }
    Ok((file, found.rows))
}

/// The cases of a shard that are not finished; they may be too many to be listed.
struct Pending {
    shard: Shard,
    all: u64,
    done: BTreeSet<u64>,
    next: AtomicU64,
}

impl Pending {
    fn new(shard: Shard, cases: u64, done: BTreeSet<u64>) -> Self {
        Pending { shard, all: shard.count(cases), done, next: AtomicU64::new(0) }
    }

    /// The next case that nobody has.
    fn next(&self) -> Option<u64> {
        loop {
            let k = self.next.fetch_add(1, Ordering::Relaxed);
            let case = (k < self.all).then(|| self.shard.case(k))?;
            if !self.done.contains(&case) {
                return Some(case);
            }
        }
    }
}

/// Runs cases on all threads; `keep` sees every result on this thread as it is finished. Ends early where it fails, a case is refused or
/// `progress` stops.
fn run_cases(
    campaign: &dyn Campaign,
    pending: &Pending,
    mut keep: impl FnMut(Row) -> Result<(), StoreError>,
    progress: &dyn Progress,
) -> Result<(), StoreError> {
    let stopped = AtomicBool::new(false);
    let (sender, receiver) = mpsc::channel();
    let work = |sender: mpsc::Sender<Result<Row, StoreError>>| {
        while let Some(case) = pending.next() {
            if stopped.load(Ordering::Relaxed) || progress.is_cancelled() {
                return;
            }
            let finished = match campaign.run(case, progress) {
                Ok(result) => Ok(Row { case, result }),
                Err(JobError::Cancelled(_)) => return,
                Err(JobError::Refused(why)) => Err(StoreError::Refused { case, why }),
            };
            if sender.send(finished).is_err() {
                return;
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..rayon::current_num_threads() {
            let sender = sender.clone();
            scope.spawn(|| work(sender));
        }
        drop(sender);
        let mut done = pending.done.len() as u64;
        for finished in receiver {
            finished.and_then(&mut keep).inspect_err(|_| stopped.store(true, Ordering::Relaxed))?;
            done += 1;
            progress.tell("", done, Some(pending.all));
        }
        Ok(())
    })
}
