//! The ledger and its parallel runner.

use super::judge::{CORRECTED, Examined, Judge, correction_id};
use super::lines::Lines;
use super::proofs::{NoProofs, join};
use super::{
    CheckError, Claim, Controls, Correction, Entry, Evidence, Fault, Form, Grade, Outcome, Proofs, Recorded, Run,
    Source, Verdict, listed, recorded,
};
use arithmetic::{Progress, Unwatched};
use std::collections::{BTreeMap, BTreeSet, btree_map};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, OnceLock, mpsc};
use std::time::{Duration, Instant};

/// How the ledger is run.
#[derive(Clone)]
pub struct Options {
    /// Seed of everything random.
    pub seed: String,
    /// More cases.
    pub full: bool,
    /// Checkpoints that the check of one form may pass; one that passes more is undecided, on every machine.
    pub most_work: u64,
    /// The last resort against a check that passes no checkpoints: wall time for one claim.
    pub longest: Duration,
    /// Number of claims checked at a time.
    pub threads: usize,
    /// Asked often whether to stop; told of each finished claim.
    pub progress: Arc<dyn Progress + Send>,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            seed: "flockproof".to_string(),
            full: false,
            most_work: 10_000_000,
            longest: Duration::from_secs(3600),
            threads: std::thread::available_parallelism().map_or(1, usize::from),
            progress: Arc::new(Unwatched),
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

/// A claim in the ledger: its printed statement, or its correction as a statement of its own.
struct Registered {
    id: String,
    claim: Arc<dyn Claim>,
    source: Source,
    correction: bool,
}

/// A set of claims with checks, the verdicts they are expected to reach, and the proofs behind them.
pub struct Ledger {
    claims: BTreeMap<String, Arc<Registered>>,
    listed: BTreeMap<String, Source>,
    expected: BTreeMap<String, Expected>,
    lines: Option<Lines>,
    proofs: Box<dyn Proofs>,
}

/// What a claim is expected to reach, in the words of the table of verdicts.
struct Expected {
    verdict: String,
    /// Fault and reach; claims that are registered by a user need not say.
    more: Option<(String, String)>,
    grades: String,
}

impl Default for Ledger {
    fn default() -> Self {
        Ledger {
            claims: BTreeMap::new(),
            listed: BTreeMap::new(),
            expected: BTreeMap::new(),
            lines: None,
            proofs: Box::new(NoProofs),
        }
    }
}

/// What a run of the ledger came to.
#[derive(Debug, Clone)]
pub struct Report {
    /// The entries, sorted by id.
    pub entries: Vec<Entry>,
    /// Differences from the recorded verdicts, one sentence each.
    pub differences: Vec<String>,
    /// Claims that were asked for and not finished, because the run was interrupted.
    pub missing: Vec<String>,
}

impl Report {
    /// Whether every claim reached its recorded verdict with all controls refuted.
    pub fn is_as_recorded(&self) -> bool {
        self.differences.is_empty() && self.missing.is_empty()
    }
}

impl Ledger {
    /// A ledger without claims.
    pub fn new() -> Self {
        Ledger::default()
    }

    /// The same with a list of what is claimed ([`listed`]): claims of the list need no source of their own.
    pub fn with_list(mut self, table: &str) -> Self {
        let source = |place: &str, statement: &str| Source { place: place.into(), statement: statement.into() };
        self.listed.extend(listed(table).map(|row| (row.id.to_string(), source(row.place, row.statement))));
        self
    }

    /// The same with verdicts that are expected ([`recorded`]).
    pub fn with_record(mut self, table: &str) -> Self {
        self.expected.extend(recorded(table).map(|row| {
            let more = Some((row.fault.to_string(), row.reach.to_string()));
            let expected = Expected { verdict: row.verdict.to_string(), more, grades: row.grades.to_string() };
            (row.id.to_string(), expected)
        }));
        self
    }

    /// The same with the lines of evidence that are expected, as [`Ledger::evidence_table`] writes them. Without them only the verdicts
    /// are compared.
    pub fn with_evidence(mut self, table: &str) -> Self {
        self.lines = Some(Lines::read(table));
        self
    }

    /// The lines of evidence of these entries as a table: a header, then id, part, grade, scope, clauses, the controls that fail through the
    /// line, and its number of cases in an ordinary and in a full run, separated by tabs. Entries of a `full` run leave the numbers of ordinary runs
    /// as they came with [`Ledger::with_evidence`], and the other way round.
    pub fn evidence_table(&self, entries: &[Entry], full: bool) -> String {
        self.lines.clone().unwrap_or_default().table(entries, full)
    }

    /// The verdicts that came with [`Ledger::with_record`], by id.
    pub fn recorded(&self) -> impl Iterator<Item = Recorded<'_>> {
        self.expected.iter().filter_map(|(id, row)| {
            let (fault, reach) = row.more.as_ref()?;
            Some(Recorded { id, verdict: &row.verdict, fault, reach, grades: &row.grades })
        })
    }

    /// The same with proofs, which join the evidence.
    pub fn with_proofs(mut self, proofs: impl Proofs + 'static) -> Self {
        self.proofs = Box::new(proofs);
        self
    }

    /// Records the verdict and the grades of evidence (strongest first) that a claim is expected to reach.
    pub fn expect(&mut self, id: &str, verdict: Verdict, grades: &[Grade]) {
        let expected = Expected { verdict: verdict.word().to_string(), more: None, grades: words(grades) };
        self.expected.insert(id.to_string(), expected);
    }

    /// Adds a claim.
    ///
    /// # Errors
    /// [`LedgerError::Twice`] or [`LedgerError::NoSource`].
    pub fn register(&mut self, claim: impl Claim + 'static) -> Result<(), LedgerError> {
        self.register_boxed(Box::new(claim))
    }

    /// Adds a boxed claim.
    ///
    /// # Errors
    /// As [`Ledger::register`].
    pub fn register_boxed(&mut self, claim: Box<dyn Claim>) -> Result<(), LedgerError> {
        let id = claim.id().to_string();
        let listed = || self.listed.get(&id).cloned();
        let source = claim.source().or_else(listed).ok_or_else(|| LedgerError::NoSource(id.clone()))?;
        self.insert(Registered { id, claim: claim.into(), source, correction: false })
    }

    /// Adds the corrected statements of the registered claims whose printed form fails, as claims of their own, where
    /// `wanted` says so of the id of the printed claim.
    ///
    /// # Errors
    /// [`LedgerError::Twice`].
    pub fn register_corrections(&mut self, wanted: impl Fn(&str) -> bool) -> Result<(), LedgerError> {
        let printed: Vec<Arc<Registered>> =
            self.claims.values().filter(|r| !r.correction && wanted(&r.id)).cloned().collect();
        for of in printed {
            if let Some(Correction { statement, .. }) = of.claim.correction() {
                let paper = of.id.split('.').next().unwrap_or_default();
                let source = Source { place: format!("corrects {paper}, {}", of.source.place), statement };
                let id = correction_id(&of.id);
                self.insert(Registered { id, claim: of.claim.clone(), source, correction: true })?;
            }
        }
        Ok(())
    }

    fn insert(&mut self, registered: Registered) -> Result<(), LedgerError> {
        match self.claims.entry(registered.id.clone()) {
            btree_map::Entry::Occupied(there) => Err(LedgerError::Twice(there.key().clone())),
            btree_map::Entry::Vacant(place) => {
                place.insert(Arc::new(registered));
                Ok(())
            }
        }
    }

    /// The registered ids, sorted.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        self.claims.keys().map(String::as_str)
    }

    /// The argument in words behind a registered claim.
    pub fn derivation(&self, id: &str) -> Option<&str> {
        self.claims.get(id).map(|registered| registered.claim.derivation())
    }

    /// Place and statement of a registered claim.
    pub fn source(&self, id: &str) -> Option<&Source> {
        self.claims.get(id).map(|registered| &registered.source)
    }

    /// The ids of the list, sorted.
    pub fn listed_ids(&self) -> impl Iterator<Item = &str> {
        self.listed.keys().map(String::as_str)
    }

    /// The ids of the named papers, and of these the named claims, sorted; all where nothing is named.
    ///
    /// # Errors
    /// [`LedgerError`] for a name that is not there.
    pub fn select(&self, papers: &[String], claims: &[String]) -> Result<Vec<String>, LedgerError> {
        let paper_of = |id: &str| id.split('.').next().unwrap_or_default().to_string();
        let known: BTreeSet<String> = self.listed_ids().chain(self.ids()).map(paper_of).collect();
        for paper in papers {
            if !known.iter().any(|known| is_of_paper(known, paper)) {
                let group = |paper: &String| paper.trim_end_matches(|c: char| c.is_ascii_digit()).to_string();
                let groups: BTreeSet<String> = known.iter().map(group).collect();
                let known: Vec<String> = known.union(&groups).cloned().collect();
                return Err(LedgerError::NoPaper(paper.clone(), known.join(", ")));
            }
        }
        for id in claims {
            if !self.claims.contains_key(id) {
                let is_listed = self.listed.contains_key(id);
                return Err(if is_listed { LedgerError::NotBuilt } else { LedgerError::Unknown }(id.clone()));
            }
        }
        let of_papers = |id: &str| papers.is_empty() || papers.iter().any(|paper| is_of_paper(&paper_of(id), paper));
        let wanted = |id: &&str| of_papers(id) && (claims.is_empty() || claims.iter().any(|c| c == id));
        Ok(self.ids().filter(wanted).map(String::from).collect())
    }

    /// Checks the given claims in parallel and compares with the recorded verdicts; `done` is called after each claim.
    /// The result does not depend on the number of threads.
    pub fn verify(&self, ids: &[String], options: &Options, done: impl Fn(&Entry) + Sync) -> Report {
        let next = AtomicUsize::new(0);
        let finished: Mutex<Vec<Entry>> = Mutex::new(Vec::new());
        let checks = self.checks(ids, options);
        std::thread::scope(|scope| {
            for _ in 0..options.threads.clamp(1, ids.len().max(1)) {
                scope.spawn(|| {
                    while let Some((registered, check)) = checks.get(next.fetch_add(1, Ordering::Relaxed)) {
                        let Some(mut entry) = check_in_time(registered, check, options) else { break };
                        join(&mut entry, &*self.proofs);
                        entry.clause_verdicts = entry.verdicts_by_clause();
                        done(&entry);
                        let mut finished = finished.lock().unwrap_or_else(|e| e.into_inner());
                        finished.push(entry);
                        options.progress.tell("claims", finished.len() as u64, Some(ids.len() as u64));
                    }
                });
            }
        });
        let mut entries = finished.into_inner().unwrap_or_else(|e| e.into_inner());
        entries.sort_by(|a, b| a.id.cmp(&b.id));
        let reached: BTreeSet<&str> = entries.iter().map(|entry| entry.id.as_str()).collect();
        let missing = ids.iter().filter(|id| !reached.contains(id.as_str())).cloned().collect();
        let is_recorded_seed = options.seed == Options::default().seed;
        let of_lines = |e: &Entry| {
            self.lines.as_ref().map_or(Vec::new(), |lines| lines.differences(e, options.full, is_recorded_seed))
        };
        let differences = entries.iter().flat_map(|e| difference(e, self.expected.get(&e.id), of_lines(e))).collect();
        Report { entries, differences, missing }
    }

    /// The claims to be checked, each with its check; a claim and its correction share one.
    fn checks(&self, ids: &[String], options: &Options) -> Vec<(Arc<Registered>, Arc<Check>)> {
        let mut shared: BTreeMap<String, Arc<Check>> = BTreeMap::new();
        let registered = ids.iter().filter_map(|id| self.claims.get(id));
        registered
            .map(|registered| {
                let printed = registered.claim.id();
                let check = shared
                    .entry(printed.to_string())
                    .or_insert_with(|| Arc::new(Check::new(registered.claim.clone(), options)));
                (registered.clone(), check.clone())
            })
            .collect()
    }
}

/// The check of one claim on each of its forms, run once however many entries ask for it.
struct Check {
    claim: Arc<dyn Claim>,
    seed: String,
    full: bool,
    most_work: u64,
    printed: OnceLock<Examined>,
    corrected: OnceLock<Examined>,
    controls: Vec<OnceLock<Examined>>,
    /// What a form that does not exist comes to.
    nothing: Examined,
}

impl Check {
    fn new(claim: Arc<dyn Claim>, options: &Options) -> Self {
        let nothing = Err(CheckError::Other("the claim has no such form".to_string()));
        Check {
            controls: claim.alterations().iter().map(|_| OnceLock::new()).collect(),
            claim,
            seed: options.seed.clone(),
            full: options.full,
            most_work: options.most_work,
            printed: OnceLock::new(),
            corrected: OnceLock::new(),
            nothing: Examined { outcome: nothing, values: BTreeMap::new() },
        }
    }

    fn examine(&self, form: Form) -> &Examined {
        let cell = match form {
            Form::Printed => Some(&self.printed),
            Form::Corrected => Some(&self.corrected),
            Form::Control(k) => self.controls.get(k),
        };
        cell.map_or(&self.nothing, |cell| {
            cell.get_or_init(|| {
                let mut run = Run::new(self.claim.id(), &self.seed, self.full, self.most_work);
                let outcome = self.claim.examine(form, &mut run).and_then(with_cases);
                Examined { outcome, values: run.into_values() }
            })
        })
    }
}

/// What holds, unless a piece of its evidence rests on no case.
fn with_cases(outcome: Outcome) -> Result<Outcome, CheckError> {
    let support = match &outcome {
        Outcome::Holds(evidence) | Outcome::NotCheckable(_, evidence) => evidence.as_slice(),
        Outcome::Fails { .. } | Outcome::Undecided(_) => &[],
    };
    match support.iter().find_map(Evidence::empty) {
        Some(empty) => Err(CheckError::NoCases(empty.part.clone())),
        None => Ok(outcome),
    }
}

/// How often a waiting runner asks whether to stop.
const TICK: Duration = Duration::from_millis(50);

/// Runs a check on a thread of its own, so that one that does not end or panics costs only its own verdict; `None` where
/// the run was interrupted.
fn check_in_time(registered: &Arc<Registered>, check: &Arc<Check>, options: &Options) -> Option<Entry> {
    let started = Instant::now();
    let (sender, receiver) = mpsc::channel();
    let (shared, check) = (registered.clone(), check.clone());
    std::thread::spawn(move || {
        let examine = |form| check.examine(form);
        let judge =
            Judge { claim: &*shared.claim, source: &shared.source, correction: shared.correction, examine: &examine };
        // The receiver is gone if the run was interrupted or took too long: nobody waits for this entry any more.
        let _ = sender.send(judge.judge());
    });
    loop {
        if options.progress.is_cancelled() {
            return None;
        }
        let why = match receiver.recv_timeout(TICK) {
            Ok(entry) => return Some(Entry { seconds: started.elapsed().as_secs_f64(), ..entry }),
            Err(mpsc::RecvTimeoutError::Disconnected) => "the check ended in a panic".to_string(),
            Err(mpsc::RecvTimeoutError::Timeout) if started.elapsed() < options.longest => continue,
            Err(mpsc::RecvTimeoutError::Timeout) => format!("not decided within {} s", options.longest.as_secs()),
        };
        return Some(abandoned(registered, why, started.elapsed()));
    }
}

fn abandoned(registered: &Registered, why: String, after: Duration) -> Entry {
    Entry {
        id: registered.id.clone(),
        paper: registered.id.split('.').next().unwrap_or_default().to_string(),
        place: registered.source.place.clone(),
        statement: registered.source.statement.clone(),
        clauses: Vec::new(),
        clause_verdicts: Vec::new(),
        reading: None,
        verdict: Verdict::Undecided,
        fault: None,
        corrected: None,
        counterexample: None,
        witnesses: Vec::new(),
        evidence: Vec::<Evidence>::new(),
        controls: Controls::default(),
        values: BTreeMap::new(),
        why: Some(why),
        seconds: after.as_secs_f64(),
        surviving_controls: Vec::new(),
        derivation: String::new(),
    }
}
fn words(grades: &[Grade]) -> String {
    grades.iter().map(|grade| grade.word()).collect::<Vec<_>>().join(",")
}

/// Whether a paper is the one that is asked for, or one of several by the same authors: `tanner1` and `tanner2` are `tanner`.
pub fn is_of_paper(paper: &str, asked: &str) -> bool {
    let rest = paper.strip_prefix(asked);
    rest.is_some_and(|number| number.bytes().all(|byte| byte.is_ascii_digit())) && !asked.is_empty()
}

/// The row of an entry in the table of recorded verdicts.
pub fn recorded_row(entry: &Entry) -> String {
    let (whole, total) = entry.reach();
    let fault = entry.fault.map_or("-", Fault::word);
    format!("{}\t{}\t{fault}\t{whole}/{total}\t{}", entry.id, entry.verdict.word(), words(&entry.grades()))
}

/// One sentence for each way in which an entry is not as recorded, or says more than its evidence.
fn difference(entry: &Entry, expected: Option<&Expected>, of_lines: Vec<String>) -> Vec<String> {
    let mut sentences = not_as_recorded(entry, expected);
    // A verdict that was not reached has lost its evidence with it.
    if entry.verdict != Verdict::Undecided {
        sentences.extend(of_lines);
    }
    sentences.extend(entry.surviving_controls.iter().map(|what| format!("a negative control was not refuted: {what}")));
    let only_text = entry.grades() == [Grade::Text];
    if !matches!(entry.verdict, Verdict::Undecided | Verdict::NotCheckable) && !only_text {
        sentences.extend(overstated(entry));
    }
    sentences.into_iter().map(|sentence| format!("{}: {sentence}", entry.id)).collect()
}

fn not_as_recorded(entry: &Entry, expected: Option<&Expected>) -> Vec<String> {
    let reached = entry.verdict.word();
    let grades = words(&entry.grades());
    let (whole, total) = entry.reach();
    let more = (entry.fault.map_or("-", Fault::word).to_string(), format!("{whole}/{total}"));
    let sentence = match expected {
        None => format!("reached {reached} ({grades}), but no verdict is recorded"),
        Some(row) if row.verdict != reached => {
            let why = entry.why.as_ref().map(|why| format!(" ({why})")).unwrap_or_default();
            format!("recorded {}, reached {reached}{why}", row.verdict)
        }
        Some(row) if row.grades != grades => format!("recorded evidence {}, reached {grades}", row.grades),
        Some(Expected { more: Some((fault, reach)), .. }) if (fault, reach) != (&more.0, &more.1) => {
            format!("recorded fault {fault} and {reach} clauses for all parameters, reached {} and {}", more.0, more.1)
        }
        Some(_) => return Vec::new(),
    };
    vec![sentence]
}

/// The first text that stands in a list for the second time.
fn repeated(texts: &[String]) -> Option<&String> {
    let mut seen = BTreeSet::new();
    texts.iter().find(|text| !seen.insert(*text))
}

/// Where a decided entry lacks controls, or says more than its evidence.
fn overstated(entry: &Entry) -> Vec<String> {
    let mut sentences = Vec::new();
    let controls = &entry.controls;
    if controls.total == 0 {
        sentences.push("there is no negative control".to_string());
    } else if repeated(&controls.what).is_some() {
        sentences.push("two negative controls alter the same".to_string());
    } else if let Some(said) = repeated(&controls.failed) {
        sentences.push(format!("two negative controls fail at one place for one reason: {said}"));
    }
    let clauses = 1..=entry.clauses.len();
    for e in entry.evidence.iter().filter(|e| e.scope.is_some()) {
        if e.clauses.is_empty() || e.clauses.iter().any(|k| !clauses.contains(k)) {
            sentences.push(format!("the evidence \"{}\" names no clause", e.part));
        }
    }
    let both = entry.contradicted().into_iter().map(|k| format!("clause {k} is refuted and established"));
    sentences.extend(both);
    let covered = entry.covered(false);
    for (k, clause) in clauses.zip(&entry.clauses).filter(|(k, _)| !covered.contains(k)) {
        if entry.verdict == Verdict::Holds || clause.starts_with(CORRECTED) {
            sentences.push(format!("clause {k} is not covered: {clause}"));
        }
    }
    sentences
}
