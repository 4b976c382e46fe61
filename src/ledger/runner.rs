//! The ledger and its parallel runner.

use super::correction::Correction;
use super::{AnyClaim, Controls, Entry, Evidence, Grade, Run, Source, Verdict, listed, recorded};
use serde::Serialize;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, mpsc};
use std::time::Duration;

/// How the ledger is run.
#[derive(Clone)]
pub struct Options {
    /// Seed of everything random.
    pub seed: String,
    /// More cases.
    pub full: bool,
    /// Time limit of each claim; a claim that exceeds it is undecided.
    pub limit: Duration,
    /// Number of claims checked at a time.
    pub threads: usize,
    /// Asked before each claim: whether to stop handing out claims.
    pub interrupted: fn() -> bool,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            seed: "flockproof".to_string(),
            full: false,
            limit: Duration::from_secs(60),
            threads: std::thread::available_parallelism().map_or(1, usize::from),
            interrupted: || false,
        }
    }
}

/// Why a claim cannot be registered or found.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum LedgerError {
    /// Two claims with one id.
    #[error("the claim {0} is registered twice")]
    Twice(String),
    /// Neither in the list nor with a source of its own.
    #[error("the claim {0} is not in the list of claims and has no source of its own")]
    NoSource(String),
    /// An id that is not registered.
    #[error("there is no claim {0}")]
    Unknown(String),
    /// An id of the list without a check.
    #[error("the claim {0} is listed, but its check is not built yet")]
    NotBuilt(String),
    /// A paper that does not exist.
    #[error("there is no paper {0}; there are {1}")]
    NoPaper(String, String),
}

struct Registered {
    claim: Arc<dyn AnyClaim>,
    source: Source,
}

/// A set of claims with checks, and the verdicts they are expected to reach.
pub struct Ledger {
    claims: BTreeMap<String, Arc<Registered>>,
    expected: BTreeMap<String, Expected>,
}

/// The words of a verdict and of its grades.
struct Expected {
    verdict: String,
    grades: String,
}

impl Default for Ledger {
    fn default() -> Self {
        let expect = |row: super::Recorded| {
            (row.id.to_string(), Expected { verdict: row.verdict.to_string(), grades: row.grades.to_string() })
        };
        Ledger { claims: BTreeMap::new(), expected: recorded().map(expect).collect() }
    }
}

/// What a run of the ledger came to.
#[derive(Debug, Clone)]
pub struct Report {
    /// The entries, sorted by id.
    pub entries: Vec<Entry>,
    /// Differences from the recorded verdicts, one sentence each.
    pub differences: Vec<String>,
    /// Whether it was interrupted before all claims were checked.
    pub interrupted: bool,
}

impl Report {
    /// Whether every claim reached its recorded verdict with all controls refuted.
    pub fn is_as_recorded(&self) -> bool {
        self.differences.is_empty() && !self.interrupted
    }
}

impl Ledger {
    /// A ledger without claims, with the recorded verdicts of the project.
    pub fn new() -> Self {
        Ledger::default()
    }

    /// Records the verdict and the grades of evidence (strongest first) that a claim is expected to reach.
    pub fn expect(&mut self, id: &str, verdict: Verdict, grades: &[Grade]) {
        let expected = Expected { verdict: verdict.word().to_string(), grades: words(grades) };
        self.expected.insert(id.to_string(), expected);
    }

    /// Adds a claim.
    ///
    /// # Errors
    /// [`LedgerError::Twice`] or [`LedgerError::NoSource`].
    pub fn register(&mut self, claim: impl AnyClaim + 'static) -> Result<(), LedgerError> {
        self.register_boxed(Box::new(claim))
    }

    /// Adds a boxed claim.
    ///
    /// # Errors
    /// As [`Ledger::register`].
    pub fn register_boxed(&mut self, claim: Box<dyn AnyClaim>) -> Result<(), LedgerError> {
        let id = claim.id().to_string();
        let from_list = || {
            let row = listed().find(|row| row.id == id)?;
            Some(Source { place: row.place.to_string(), statement: row.statement.to_string() })
        };
        let source = claim.source().or_else(from_list).ok_or_else(|| LedgerError::NoSource(id.clone()))?;
        self.insert(id, Registered { claim: claim.into(), source })
    }

    /// Adds the corrected statements of the registered claims whose printed form fails, as claims of their own, where
    /// `wanted` says so of the id of the printed claim.
    ///
    /// # Errors
    /// [`LedgerError::Twice`].
    pub fn register_corrections(&mut self, wanted: impl Fn(&str) -> bool) -> Result<(), LedgerError> {
        let printed: Vec<Arc<Registered>> = self.claims.values().filter(|r| wanted(r.claim.id())).cloned().collect();
        for registered in printed {
            if let Some(correction) = Correction::of(&registered.claim, &registered.source) {
                self.register(correction)?;
            }
        }
        Ok(())
    }

    fn insert(&mut self, id: String, registered: Registered) -> Result<(), LedgerError> {
        match self.claims.insert(id.clone(), Arc::new(registered)) {
            Some(_) => Err(LedgerError::Twice(id)),
            None => Ok(()),
        }
    }

    /// The registered ids, sorted.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        self.claims.keys().map(String::as_str)
    }

    /// The ids of the named papers and claims, sorted; all ids where nothing is named.
    ///
    /// # Errors
    /// [`LedgerError`] for a name that is not there.
    pub fn select(&self, papers: &[String], claims: &[String]) -> Result<Vec<String>, LedgerError> {
        let paper_of = |id: &str| id.split('.').next().unwrap_or_default().to_string();
        let mut known: Vec<String> = listed().map(|row| paper_of(row.id)).chain(self.ids().map(paper_of)).collect();
        known.sort();
        known.dedup();
        for paper in papers {
            if !known.contains(paper) {
                return Err(LedgerError::NoPaper(paper.clone(), known.join(", ")));
            }
        }
        for id in claims {
            if !self.claims.contains_key(id) {
                let is_listed = listed().any(|row| row.id == *id);
                return Err(if is_listed { LedgerError::NotBuilt } else { LedgerError::Unknown }(id.clone()));
            }
        }
        let all = papers.is_empty() && claims.is_empty();
        let wanted = |id: &&str| all || papers.contains(&paper_of(id)) || claims.iter().any(|c| c == id);
        Ok(self.ids().filter(wanted).map(String::from).collect())
    }

    /// Checks the given claims in parallel and compares with the recorded verdicts; `done` is called after each claim.
    /// The result does not depend on the number of threads.
    pub fn verify(&self, ids: &[String], options: &Options, done: impl Fn(&Entry) + Sync) -> Report {
        let next = AtomicUsize::new(0);
        let finished: Mutex<Vec<Entry>> = Mutex::new(Vec::new());
        std::thread::scope(|scope| {
            for _ in 0..options.threads.clamp(1, ids.len().max(1)) {
                scope.spawn(|| {
                    while let Some(id) = ids.get(next.fetch_add(1, Ordering::Relaxed)) {
                        if (options.interrupted)() {
                            break;
                        }
                        if let Some(registered) = self.claims.get(id) {
                            let entry = check_in_time(registered, options);
                            done(&entry);
                            finished.lock().unwrap_or_else(|e| e.into_inner()).push(entry);
                        }
                    }
                });
            }
        });
        let mut entries = finished.into_inner().unwrap_or_else(|e| e.into_inner());
        entries.sort_by(|a, b| a.id.cmp(&b.id));
        let interrupted = entries.len() < ids.len();
        let differences = entries.iter().flat_map(|e| difference(e, self.expected.get(&e.id))).collect();
        Report { entries, differences, interrupted }
    }
}

/// Runs a check on a thread of its own, so that one that does not end or panics costs only its own verdict.
fn check_in_time(registered: &Arc<Registered>, options: &Options) -> Entry {
    let (sender, receiver) = mpsc::channel();
    let (shared, seed, full, limit) = (registered.clone(), options.seed.clone(), options.full, options.limit);
    std::thread::spawn(move || {
        let mut run = Run::new(shared.claim.id(), &seed, full, Some(limit));
        // The receiver is gone if the time limit passed: nobody waits for this entry any more.
        let _ = sender.send(shared.claim.judge(&shared.source, &mut run));
    });
    receiver.recv_timeout(limit + Duration::from_secs(1)).unwrap_or_else(|error| {
        let why = match error {
            mpsc::RecvTimeoutError::Timeout => format!("not decided within {} s", limit.as_secs()),
            mpsc::RecvTimeoutError::Disconnected => "the check ended in a panic".to_string(),
        };
        abandoned(registered, why, limit)
    })
}

fn abandoned(registered: &Registered, why: String, limit: Duration) -> Entry {
    let id = registered.claim.id().to_string();
    Entry {
        paper: id.split('.').next().unwrap_or_default().to_string(),
        id,
        place: registered.source.place.clone(),
        statement: registered.source.statement.clone(),
        verdict: Verdict::Undecided,
        corrected: None,
        counterexample: None,
        evidence: Vec::<Evidence>::new(),
        controls: Controls { refuted: 0, total: 0 },
        values: BTreeMap::new(),
        why: Some(why),
        seconds: limit.as_secs_f64(),
        surviving_controls: Vec::new(),
        derivation: String::new(),
    }
}

fn words(grades: &[Grade]) -> String {
    grades.iter().map(|grade| grade.word()).collect::<Vec<_>>().join(",")
}

/// One sentence for each way in which an entry is not as recorded.
fn difference(entry: &Entry, expected: Option<&Expected>) -> Vec<String> {
    let mut sentences = Vec::new();
    let reached = entry.verdict.word();
    let grades = words(&entry.grades());
    match expected {
        None => sentences.push(format!("{}: reached {reached} ({grades}), but no verdict is recorded", entry.id)),
        Some(row) if row.verdict != reached => {
            let why = entry.why.as_ref().map(|why| format!(" ({why})")).unwrap_or_default();
            sentences.push(format!("{}: recorded {}, reached {reached}{why}", entry.id, row.verdict));
        }
        Some(row) if row.grades != grades => {
            sentences.push(format!("{}: recorded evidence {}, reached {grades}", entry.id, row.grades));
        }
        Some(_) => {}
    }
    for control in &entry.surviving_controls {
        sentences.push(format!("{}: a negative control was not refuted: {control}", entry.id));
    }
    let only_text = grades == "text";
    if entry.controls.total == 0 && !only_text && matches!(reached, "holds" | "misprint" | "false") {
        sentences.push(format!("{}: there is no negative control", entry.id));
    }
    sentences
}

#[derive(Serialize)]
struct Document<'a> {
    schema: &'a str,
    version: &'a str,
    seed: &'a str,
    claims: &'a [Entry],
}

/// The JSON document of a run.
pub fn to_json(report: &Report, options: &Options) -> String {
    let document = Document {
        schema: "flockproof.ledger/1",
        version: env!("CARGO_PKG_VERSION"),
        seed: &options.seed,
        claims: &report.entries,
    };
    // Strings, numbers and lists only: this cannot fail.
    serde_json::to_string_pretty(&document).unwrap_or_default() + "\n"
}
