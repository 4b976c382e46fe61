//! Alters each formula of chosen files, one at a time, and records which claims and tests notice: `notes/alterations.md`.
//!
//! `cargo run --release --manifest-path proofs_checks/alterations/Cargo.toml -- --file crates/arithmetic/src/interval.rs --shard 1/4`

mod changed;
mod copy;
mod probes;
mod sites;
mod swaps;
mod table;
mod write;

use probes::{Outcome, Probe, Program};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};
use table::{Equivalents, Table};

const USE: &str =
    "use: flockproof-alterations [--file FILE|FOLDER].. [--since REVISION] [--budget SECONDS] [--shard K/N] [--again missed|all]
       [--noticers N] [--jobs N] [--tests PACKAGE].. [--longest SECONDS] [--ledger JSON] [--only FILE].. [--scratch FOLDER]
       [--results FOLDER] [--claims START].. [--no-claims] [--no-tests] | --summary | --missed

--file      a source file or a folder of sources of a crate, from the root of the repository
--since     only lines that are others than in this revision of git; without --file, those of all crates that compute
--budget    no alteration is begun after so many seconds of trying
--shard     every N-th alteration, from the K-th on
--again     try again what is recorded as missed, or all; otherwise what is recorded for the same source stays
--noticers  how many claims and tests are recorded for each alteration (1)
--tests     tests of further packages
--longest   leave out claims and tests that take longer than so many seconds
--ledger    a ledger of `verify --json`: claims that took longer there are not even run once
--only      alter all the files, but try only those of this one
--claims    only claims whose names start so, as `veerman.` or `beyond.veerman.`; --no-claims: only tests; --no-tests: only claims
--scratch   where the altered copy is built (the folder of temporary files)
--results   where the results are kept, a table for each file (target/results beside this program)
--summary   the recorded results in a table, with those that are out of date; --missed: those that are missed";

struct Arguments {
    files: Vec<String>,
    since: Option<String>,
    budget: Duration,
    shard: (usize, usize),
    again: Option<String>,
    noticers: usize,
    jobs: usize,
    packages: BTreeSet<String>,
    longest: f64,
    ledger: Option<PathBuf>,
    only: Vec<String>,
    scratch: PathBuf,
    results: PathBuf,
    claims: bool,
    tests: bool,
    starts: Vec<String>,
    show: Option<String>,
}

fn arguments(root: &Path) -> Result<Arguments, String> {
    let mut parsed = Arguments {
        files: Vec::new(),
        since: None,
        budget: Duration::MAX,
        shard: (1, 1),
        again: None,
        noticers: 1,
        jobs: 1,
        packages: BTreeSet::new(),
        longest: f64::INFINITY,
        ledger: None,
        only: Vec::new(),
        scratch: std::env::temp_dir().join("flockproof-alterations"),
        results: Path::new(env!("CARGO_MANIFEST_DIR")).join("target/results"),
        claims: true,
        tests: true,
        starts: Vec::new(),
        show: None,
    };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        if word == "--no-claims" || word == "--no-tests" {
            *(if word == "--no-claims" { &mut parsed.claims } else { &mut parsed.tests }) = false;
            continue;
        }
        if ["--summary", "--missed"].contains(&word.as_str()) {
            parsed.show = Some(word);
            continue;
        }
        let value = words.next().ok_or(USE)?;
        match word.as_str() {
            "--file" => parsed.files.extend(sources(root, &value)?),
            "--shard" => {
                let (k, n) = value.split_once('/').ok_or(USE)?;
                parsed.shard = (k.parse().map_err(|_| USE)?, n.parse().map_err(|_| USE)?);
            }
            "--again" => parsed.again = Some(value),
            "--noticers" => parsed.noticers = value.parse().map_err(|_| USE)?,
            "--jobs" => parsed.jobs = value.parse().map_err(|_| USE)?,
            "--tests" => {
                parsed.packages.insert(value);
            }
            "--longest" => parsed.longest = value.parse().map_err(|_| USE)?,
            "--ledger" => parsed.ledger = Some(PathBuf::from(value)),
            "--only" => parsed.only.extend(sources(root, &value)?),
            "--claims" => parsed.starts.push(value),
            "--since" => parsed.since = Some(value),
            "--budget" => parsed.budget = Duration::from_secs(value.parse().map_err(|_| USE)?),
            "--results" => parsed.results = PathBuf::from(value),
            "--scratch" => parsed.scratch = PathBuf::from(value),
            _ => return Err(USE.to_string()),
        }
    }
    if parsed.files.is_empty() && parsed.since.is_none() && parsed.show.is_none()
        || parsed.shard.0 == 0
        || parsed.shard.0 > parsed.shard.1
    {
        return Err(USE.to_string());
    }
    Ok(parsed)
}

/// A file, or the sources of a folder without those of tests, in order.
fn sources(root: &Path, name: &str) -> Result<Vec<String>, String> {
    let path = root.join(name);
    if path.is_file() {
        return Ok(vec![name.to_string()]);
    }
    let entries = std::fs::read_dir(&path).map_err(|error| format!("{name}: {error}"))?;
    let mut names: Vec<String> =
        entries.filter_map(Result::ok).map(|e| e.file_name().to_string_lossy().into()).collect();
    names.sort();
    let mut all = Vec::new();
    for inner in names {
        let inner = format!("{}/{inner}", name.trim_end_matches('/'));
        if root.join(&inner).is_dir() {
            all.extend(sources(root, &inner)?);
        } else if inner.ends_with(".rs") && !inner.ends_with("/tests.rs") {
            all.push(inner);
        }
    }
    Ok(all)
}

/// The package that a file belongs to.
fn package(root: &Path, file: &str) -> Result<String, String> {
    let folder = file.split_once("/src/").map(|(folder, _)| folder).ok_or(format!("{file} is no source of a crate"))?;
    let manifest = std::fs::read_to_string(root.join(folder).join("Cargo.toml")).map_err(|error| error.to_string())?;
    let name =
        manifest.lines().find_map(|line| line.strip_prefix("name = \"")).ok_or(format!("{folder} has no name"))?;
    Ok(name.trim_end_matches('"').to_string())
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

fn run() -> Result<(), String> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = here.join("../..").canonicalize().map_err(|error| error.to_string())?;
    let mut arguments = arguments(&root)?;
    let equivalents = Equivalents::read(&here.join("equivalent.tsv"));
    if let Some(what) = &arguments.show {
        return show(&root, &arguments.results, what == "--missed");
    }
    let changed = arguments.since.as_deref().map(|revision| changed::lines(&root, revision)).transpose()?;
    if let Some(changed) = &changed {
        if arguments.files.is_empty() {
            arguments.files = changed.keys().cloned().collect();
        }
        arguments.files.retain(|file| changed.contains_key(file));
        if arguments.files.is_empty() {
            println!("no formula was changed");
            return Ok(());
        }
    }
    std::fs::create_dir_all(&arguments.results).map_err(|error| error.to_string())?;
    std::fs::create_dir_all(&arguments.scratch).map_err(|error| error.to_string())?;
    let mut packages = arguments.packages.clone();
    for file in &arguments.files {
        packages.insert(package(&root, file)?);
    }
    let packages: Vec<String> = packages.into_iter().filter(|_| arguments.tests).collect();
    let built = copy::build(&root, &arguments.scratch, &arguments.files, &packages, arguments.claims)?;
    let mut programs = Vec::new();
    if let Some(file) = &built.program {
        programs.push(Program { file: file.clone(), folder: arguments.scratch.clone(), is_ledger: true });
    }
    for (folder, file) in &built.tests {
        programs.push(Program { file: file.clone(), folder: folder.clone(), is_ledger: false });
    }
    let probes = recorded_probes(&arguments, &programs, &root)?;
    let results = &arguments.results;
    let campaign = Campaign { root: &root, results, arguments: &arguments, built: &built, changed, programs, probes };
    campaign.run(&equivalents)
}

/// Records what each claim and each test reaches.
fn recorded_probes(arguments: &Arguments, programs: &[Program], root: &Path) -> Result<Vec<Probe>, String> {
    let mut wanted = Vec::new();
    let starts = &arguments.starts;
    let is_asked = |name: &str| starts.is_empty() || starts.iter().any(|start| name.starts_with(start));
    for (k, program) in programs.iter().enumerate() {
        let names = probes::names(program, root)?.into_iter();
        wanted.extend(names.filter(|name| !program.is_ledger || is_asked(name)).map(|name| (k, name)));
    }
    if let Some(path) = &arguments.ledger {
        let slow = slow_claims(path, arguments.longest)?;
        wanted.retain(|(_, name)| !slow.contains(name));
    }
    // What a program reached is kept with its digest.
    let cache = arguments.scratch.join("reach.tsv");
    let digests: Vec<String> =
        programs.iter().map(|p| table::digest_of(&std::fs::read(&p.file).unwrap_or_default())).collect();
    let known: BTreeMap<String, String> = std::fs::read_to_string(&cache)
        .unwrap_or_default()
        .lines()
        .filter_map(|line| {
            line.rsplit_once('\t').and_then(|(start, reach)| {
                let (key, seconds) = start.rsplit_once('\t')?;
                Some((key.to_string(), format!("{seconds}\t{reach}")))
            })
        })
        .collect();
    let mut kept = Vec::new();
    wanted.retain(|(program, name)| match known.get(&format!("{}\t{name}", digests[*program])) {
        Some(row) => {
            let (seconds, reach) = row.split_once('\t').unwrap_or_default();
            let reach = reach.split(' ').filter_map(|k| k.parse().ok()).collect();
            kept.push(Probe { program: *program, name: name.clone(), seconds: seconds.parse().unwrap_or(1.0), reach });
            false
        }
        None => true,
    });
    let next = AtomicUsize::new(0);
    let found: Mutex<Vec<Probe>> = Mutex::new(kept);
    let wrong: Mutex<Vec<String>> = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for job in 0..arguments.jobs.max(1) {
            let (wanted, next, found, wrong) = (&wanted, &next, &found, &wrong);
            scope.spawn(move || {
                let log = arguments.scratch.join(format!("reach-{job}"));
                // Recording takes a little longer than a run.
                let limit = if arguments.longest.is_finite() { 2 + (3.0 * arguments.longest) as u64 } else { 600 };
                while let Some((program, name)) = wanted.get(next.fetch_add(1, Ordering::Relaxed)) {
                    match probes::record(&programs[*program], name, limit, &log) {
                        Ok(Some((seconds, reach))) => {
                            let probe = Probe { program: *program, name: name.clone(), seconds, reach };
                            found.lock().unwrap_or_else(|e| e.into_inner()).push(probe);
                        }
                        Ok(None) => wrong.lock().unwrap_or_else(|e| e.into_inner()).push(name.clone()),
                        Err(error) => wrong.lock().unwrap_or_else(|e| e.into_inner()).push(error),
                    }
                }
            });
        }
    });
    let wrong = wrong.into_inner().unwrap_or_else(|e| e.into_inner());
    if !wrong.is_empty() {
        eprintln!("left out, because they fail unaltered or take too long: {}", wrong.join(", "));
    }
    let mut found = found.into_inner().unwrap_or_else(|e| e.into_inner());
    found.sort_by(|a, b| a.seconds.total_cmp(&b.seconds).then_with(|| a.name.cmp(&b.name)));
    let mut rows = known;
    rows.retain(|key, _| digests.iter().any(|digest| key.starts_with(digest)));
    rows.extend(found.iter().map(|probe| {
        let reach: Vec<String> = probe.reach.iter().map(u32::to_string).collect();
        let key = format!("{}\t{}", digests[probe.program], probe.name);
        (key, format!("{}\t{}", probe.seconds, reach.join(" ")))
    }));
    let text: String = rows.iter().map(|(key, row)| format!("{key}\t{row}\n")).collect();
    std::fs::write(&cache, text).map_err(|error| error.to_string())?;
    eprintln!("{} claims and tests, {:.0} s", found.len(), found.iter().map(|probe| probe.seconds).sum::<f64>());
    Ok(found)
}

/// The claims that took longer in a ledger.
fn slow_claims(path: &Path, longest: f64) -> Result<BTreeSet<String>, String> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let ledger: serde_json::Value = serde_json::from_str(&text).map_err(|error| error.to_string())?;
    let claims = ledger["claims"].as_array().ok_or_else(|| format!("{} is no ledger", path.display()))?;
    let slow = claims.iter().filter(|claim| claim["seconds"].as_f64().is_some_and(|seconds| seconds > longest));
    Ok(slow.filter_map(|claim| claim["id"].as_str()).map(String::from).collect())
}

struct Campaign<'a> {
    root: &'a Path,
    results: &'a Path,
    arguments: &'a Arguments,
    built: &'a copy::Built,
    changed: Option<changed::Lines>,
    programs: Vec<Program>,
    probes: Vec<Probe>,
}

/// The claims and tests of one process take this long together.
const BATCH_SECONDS: f64 = 0.4;

impl Campaign<'_> {
    fn run(&self, equivalents: &Equivalents) -> Result<(), String> {
        let files = &self.arguments.files;
        let mut sources = Vec::new();
        let mut tables = Vec::new();
        for (k, file) in files.iter().enumerate() {
            let source = std::fs::read_to_string(self.root.join(file)).map_err(|error| error.to_string())?;
            equivalents.stale(file, &source).for_each(|line| eprintln!("equivalent.tsv: {file} has no line {line}"));
            let mut table = Table::read(self.results, file, &source);
            let live = self.built.live.iter().filter(|&&number| self.built.alterations[number as usize - 1].file == k);
            table.total = live.count();
            sources.push(source);
            tables.push(table);
        }
        let tables = Mutex::new(tables);
        let wanted: Vec<u32> = self.wanted(&tables.lock().unwrap_or_else(|e| e.into_inner()));
        let next = AtomicUsize::new(0);
        eprintln!("{} alterations, {} to try", self.built.live.len(), wanted.len());
        let error: Mutex<Option<String>> = Mutex::new(None);
        let begun = Instant::now();
        std::thread::scope(|scope| {
            for job in 0..self.arguments.jobs.max(1) {
                let (tables, next, wanted, error, sources) = (&tables, &next, &wanted, &error, &sources);
                scope.spawn(move || {
                    let out = self.arguments.scratch.join(format!("out-{job}"));
                    while begun.elapsed() < self.arguments.budget {
                        let Some(&number) = wanted.get(next.fetch_add(1, Ordering::Relaxed)) else { return };
                        let alteration = &self.built.alterations[number as usize - 1];
                        let noticed = match self.noticed(number, &out) {
                            Ok(noticed) => noticed,
                            Err(why) => {
                                *error.lock().unwrap_or_else(|e| e.into_inner()) = Some(why);
                                return;
                            }
                        };
                        let (_, _, original, altered) = table::key(alteration);
                        let line = sources[alteration.file].lines().nth(alteration.line - 1).unwrap_or_default();
                        let why = equivalents.why(&files[alteration.file], line, &original, &altered);
                        let reached = self.probes.iter().any(|probe| probe.reach.contains(&number));
                        let (verdict, by) = match (noticed.is_empty(), why, reached) {
                            (false, _, _) => ("caught", noticed.join(", ")),
                            (true, Some(why), _) => ("equivalent", why.to_string()),
                            (true, None, true) => ("missed", String::new()),
                            (true, None, false) => ("missed", "not reached".to_string()),
                        };
                        if verdict == "missed" {
                            eprintln!(
                                "missed {}:{}:{} {original} -> {altered} {by}",
                                files[alteration.file], alteration.line, alteration.column
                            );
                        }
                        let mut tables = tables.lock().unwrap_or_else(|e| e.into_inner());
                        tables[alteration.file].put(alteration, verdict, &by);
                        let _ = tables[alteration.file].write(self.results);
                    }
                });
            }
        });
        if let Some(why) = error.into_inner().unwrap_or_else(|e| e.into_inner()) {
            return Err(why);
        }
        let tried = next.into_inner().min(wanted.len());
        if tried < wanted.len() {
            println!(
                "{} of {} alterations were not tried within {:?}",
                wanted.len() - tried,
                wanted.len(),
                self.arguments.budget
            );
        }
        for table in tables.into_inner().unwrap_or_else(|e| e.into_inner()) {
            if table.rows.is_empty() {
                continue;
            }
            table.write(self.results)?;
            println!(
                "{}: {} alterations, {} caught, {} equivalent, {} missed",
                table.file,
                table.total,
                table.count("caught"),
                table.count("equivalent"),
                table.count("missed")
            );
        }
        Ok(())
    }

    /// The alterations of the shard that are not recorded yet, or are to be tried again.
    fn wanted(&self, tables: &[Table]) -> Vec<u32> {
        let (shard, shards) = self.arguments.shard;
        let in_shard = self.built.live.iter().enumerate().filter(|(k, _)| k % shards == shard - 1).map(|(_, &n)| n);
        let again = self.arguments.again.as_deref();
        let is_wanted = |number: &u32| {
            let alteration = &self.built.alterations[*number as usize - 1];
            let only = &self.arguments.only;
            let file = &self.arguments.files[alteration.file];
            if !only.is_empty() && !only.contains(file) {
                return false;
            }
            if self.changed.as_ref().is_some_and(|changed| !changed::holds(changed, file, alteration.line)) {
                return false;
            }
            match tables[alteration.file].rows.get(&table::key(alteration)) {
                None => true,
                Some(row) => again == Some("all") || again == Some("missed") && row.verdict == "missed",
            }
        };
        in_shard.filter(is_wanted).collect()
    }

    /// Which claims and tests notice, quick ones first, until enough are known.
    fn noticed(&self, number: u32, out: &Path) -> Result<Vec<String>, String> {
        let longest = self.arguments.longest;
        let is_asked = |probe: &&Probe| probe.reach.contains(&number) && probe.seconds <= longest;
        let reaching: Vec<&Probe> = self.probes.iter().filter(is_asked).collect();
        let mut noticed = Vec::new();
        let mut batches: Vec<(usize, Vec<&str>, f64)> = Vec::new();
        let mut open: BTreeMap<usize, (Vec<&str>, f64)> = BTreeMap::new();
        for probe in reaching {
            let batch = open.entry(probe.program).or_default();
            batch.0.push(&probe.name);
            batch.1 += probe.seconds;
            if batch.1 > BATCH_SECONDS || batch.0.len() >= 24 {
                let (names, seconds) = std::mem::take(batch);
                batches.push((probe.program, names, seconds));
            }
        }
        batches.extend(open.into_iter().map(|(program, (names, seconds))| (program, names, seconds)));
        batches.retain(|(_, names, _)| !names.is_empty());
        batches.sort_by(|a, b| a.2.total_cmp(&b.2));
        for (program, names, seconds) in batches {
            let program = &self.programs[program];
            if let Outcome::Noticed(mut names) = probes::run(program, &names, number, seconds, out)? {
                if !program.is_ledger {
                    let folder = program.folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
                    names.iter_mut().for_each(|name| *name = format!("test {folder} {name}"));
                }
                noticed.extend(names);
            }
            if noticed.len() >= self.arguments.noticers {
                noticed.truncate(self.arguments.noticers.max(1));
                break;
            }
        }
        Ok(noticed)
    }
}

/// The recorded results: a row for each file.
fn show(root: &Path, results: &Path, missed: bool) -> Result<(), String> {
    let entries = std::fs::read_dir(results).map_err(|error| format!("{}: {error}", results.display()))?;
    let mut paths: Vec<PathBuf> = entries.filter_map(Result::ok).map(|entry| entry.path()).collect();
    paths.sort();
    if !missed {
        println!("| file | alterations | tried | caught | equivalent | missed | |\n|---|---|---|---|---|---|---|");
    }
    let mut sums = [0; 5];
    for path in paths {
        let Some(table) = Table::recorded(&path) else { return Err(format!("{} is no table", path.display())) };
        let source = std::fs::read_to_string(root.join(&table.file)).unwrap_or_default();
        let is_stale = table.digest != table::digest(&source);
        if missed {
            for row in table.rows.values().filter(|row| row.verdict == "missed") {
                println!("{}:{}:{}\t{}\t{}\t{}", table.file, row.line, row.column, row.original, row.altered, row.by);
            }
            continue;
        }
        let numbers =
            [table.total, table.rows.len(), table.count("caught"), table.count("equivalent"), table.count("missed")];
        sums.iter_mut().zip(numbers).for_each(|(sum, n)| *sum += n);
        let [total, tried, caught, equivalent, not] = numbers;
        let note = if is_stale { "out of date" } else { "" };
        println!("| `{}` | {total} | {tried} | {caught} | {equivalent} | {not} | {note} |", table.file);
    }
    if !missed {
        let [total, tried, caught, equivalent, not] = sums;
        println!("| all | {total} | {tried} | {caught} | {equivalent} | {not} | |");
    }
    Ok(())
}
