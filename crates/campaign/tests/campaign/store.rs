use arithmetic::{Progress, Unwatched};
use campaign::job::{Campaign, JobError};
use campaign::store::{MERGED, Shard, StoreError, aside, merge, run_in_memory, run_shard};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// Squares, counted as they are computed.
#[derive(Default)]
struct Squares {
    cases: u64,
    name: &'static str,
    computed: AtomicU64,
}

impl Campaign for Squares {
    fn canonical(&self) -> String {
        format!("squares {} {}", self.name, self.cases)
    }

    fn cases(&self) -> u64 {
        self.cases
    }

    fn run(&self, case: u64, progress: &dyn Progress) -> Result<Value, JobError> {
        progress.checkpoint()?;
        self.computed.fetch_add(1, Ordering::Relaxed);
        Ok(json!({"square": case * case}))
    }
}

fn squares(cases: u64) -> Squares {
    Squares { cases, ..Squares::default() }
}

fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("store").join(name);
    let _ = std::fs::remove_dir_all(&path);
    path
}

fn merged(name: &str, cases: u64, shards: &[u64], of: u64) -> Result<Vec<u8>, StoreError> {
    let store = folder(name);
    for &index in shards {
        run_shard(&squares(cases), &store, Shard { index, of }, false, &Unwatched)?;
    }
    merge(&store)?;
    Ok(std::fs::read(store.join(MERGED)).expect("written"))
}

#[test]
fn the_result_depends_on_no_number_and_order_of_shards() {
    let whole = merged("whole", 23, &[1], 1).unwrap();
    assert_eq!(whole, merged("three", 23, &[3, 1, 2], 3).unwrap());
    // More shards than cases: some are empty.
    let all: Vec<u64> = (1..=30).rev().collect();
    assert_eq!(whole, merged("thirty", 23, &all, 30).unwrap());
    assert_eq!(run_in_memory(&squares(23), &Unwatched).unwrap().rows, merge(&folder_of("whole")).unwrap().rows);
}

fn folder_of(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("store").join(name)
}

#[test]
fn gaps_and_overlaps_are_refused() {
    let gap = merged("gap", 23, &[1, 3], 3).unwrap_err().to_string();
    assert!(gap.contains("8 of 23 cases are in no finished shard, the first is case 1"), "{gap}");
    let end = merged("end", 4, &[1, 2, 3], 4).unwrap_err().to_string();
    assert!(end.contains("the first is case 3"), "{end}");
    merged("overlap", 23, &[1], 1).unwrap();
    let store = folder_of("overlap");
    run_shard(&squares(23), &store, Shard { index: 2, of: 3 }, false, &Unwatched).unwrap();
    let overlap = merge(&store).unwrap_err().to_string();
    assert!(overlap.contains("case 1 is both in"), "{overlap}");
    let nothing = folder("nothing");
    std::fs::create_dir_all(&nothing).unwrap();
    assert!(merge(&nothing).unwrap_err().to_string().contains("no finished shard"));
}

#[test]
fn other_campaigns_and_versions_are_refused() {
    let store = folder("others");
    run_shard(&squares(10), &store, Shard { index: 1, of: 2 }, false, &Unwatched).unwrap();
    let other = Squares { name: "other", ..squares(10) };
    run_shard(&other, &store, Shard { index: 2, of: 2 }, false, &Unwatched).unwrap();
    assert!(merge(&store).unwrap_err().to_string().contains("another question"));
    // Nor is one gone on with.
    let refused = run_shard(&other, &store, Shard { index: 1, of: 2 }, true, &Unwatched);
    assert!(matches!(refused, Err(StoreError::Campaign { .. })));
    let store = folder("versions");
    merged("versions", 10, &[1, 2], 2).unwrap();
    let path = Shard { index: 2, of: 2 }.path(&store);
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, by_version_9(&text, "2/2")).unwrap();
    assert!(merge(&store).unwrap_err().to_string().contains("made by version 9"));
    let refused = run_shard(&squares(10), &store, Shard { index: 2, of: 2 }, true, &Unwatched);
    assert!(matches!(refused, Err(StoreError::Version { .. })));
}

/// A line with the digest that it should have, by hand: that of what it belongs to, a line's end and the text before it.
fn sealed(open: &str, salt: &str) -> String {
    let hash = Sha256::digest(format!("{salt}\n{open}"));
    let digits: String = hash.iter().take(16).map(|byte| format!("{byte:02x}")).collect();
    format!("{open},\"sha256\":\"{digits}\"}}")
}

/// A shard as another version of the program would have written it.
fn by_version_9(text: &str, shard: &str) -> String {
    let mut open = text.lines().map(|line| line.rsplit_once(",\"sha256\"").unwrap().0);
    let header = open.next().unwrap();
    let of_all = |header: &str| sealed(&header.replace(&format!("\"{shard}\""), "null"), "");
    let again: String = open.clone().map(|row| sealed(row, &of_all(header)) + "\n").collect();
    assert_eq!(sealed(header, "") + "\n" + &again, text);
    let header = header.replace("\"version\":\"", "\"version\":\"9");
    sealed(&header, "") + "\n" + &open.map(|row| sealed(row, &of_all(&header)) + "\n").collect::<String>()
}

#[test]
fn what_is_there_is_not_overwritten() {
    let store = folder("there");
    let campaign = squares(5);
    run_shard(&campaign, &store, Shard::WHOLE, false, &Unwatched).unwrap();
    assert!(matches!(run_shard(&campaign, &store, Shard::WHOLE, false, &Unwatched), Err(StoreError::Exists(_))));
    let again = run_shard(&campaign, &store, Shard::WHOLE, true, &Unwatched).unwrap();
    assert!(again.is_complete() && campaign.computed.load(Ordering::Relaxed) == 5);
}

/// Refuses its first case.
struct Wrong;

impl Campaign for Wrong {
    fn canonical(&self) -> String {
        "wrong".to_string()
    }

    fn cases(&self) -> u64 {
        3
    }

    fn run(&self, _: u64, _: &dyn Progress) -> Result<Value, JobError> {
        Err(JobError::Refused("nothing makes sense".to_string()))
    }
}

/// What failed or was stopped before anything was finished stands in nobody's way; what was finished does, with a sentence that says what to do.
#[test]
fn a_run_without_results_can_be_run_again() {
    let store = folder("again");
    for _ in 0..2 {
        let failed = run_shard(&Wrong, &store, Shard::WHOLE, false, &Unwatched);
        assert!(matches!(failed, Err(StoreError::Refused { .. })), "{failed:?}");
    }
    // Nor of another campaign, whether it goes on or begins.
    for resume in [true, false] {
        let store = folder("again_other");
        assert!(run_shard(&Wrong, &store, Shard::WHOLE, false, &Unwatched).is_err());
        assert!(run_shard(&squares(4), &store, Shard::WHOLE, resume, &Unwatched).unwrap().is_complete());
    }
    let store = folder("again_part");
    let stopped = run_shard(&squares(9), &store, Shard::WHOLE, false, &After(AtomicU64::new(4))).unwrap();
    assert!(!stopped.is_complete() && !stopped.rows.is_empty());
    let told = run_shard(&squares(9), &store, Shard::WHOLE, false, &Unwatched).unwrap_err().to_string();
    assert!(told.ends_with("it is there already; --resume goes on with it, another folder begins anew"), "{told}");
    assert!(run_shard(&squares(9), &store, Shard::WHOLE, true, &Unwatched).unwrap().is_complete());
}

/// Stops after some cases.
struct After(AtomicU64);

impl Progress for After {
    fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed) == 0 || self.0.fetch_sub(1, Ordering::Relaxed) == 0
    }
}

/// Cut at every byte, the file of finished cases is gone on with, and only what is missing is computed.
#[test]
fn a_shard_cut_at_any_byte_goes_on() {
    let whole = merged("uncut", 4, &[1], 1).unwrap();
    let store = folder("cut");
    let stopped = run_shard(&squares(4), &store, Shard::WHOLE, false, &After(AtomicU64::new(4))).unwrap();
    assert!(!stopped.is_complete() && !stopped.rows.is_empty());
    let part = store.join("shard-1-of-1.jsonl.part");
    let bytes = std::fs::read(&part).unwrap();
    assert!(merge(&store).unwrap_err().to_string().contains("no finished shard"));
    for cut in (0..=bytes.len()).rev() {
        let store = folder("cut");
        std::fs::create_dir_all(&store).unwrap();
        std::fs::write(&part, &bytes[..cut]).unwrap();
        let lines = bytes[..cut].iter().filter(|b| **b == b'\n').count().saturating_sub(1);
        let campaign = squares(4);
        let run = run_shard(&campaign, &store, Shard::WHOLE, true, &Unwatched).unwrap();
        assert!(run.is_complete());
        assert_eq!(campaign.computed.load(Ordering::Relaxed), 4 - lines as u64);
        merge(&store).unwrap();
        assert_eq!(std::fs::read(store.join(MERGED)).unwrap(), whole);
    }
}

#[test]
fn broken_lines_are_named() {
    let store = folder("broken");
    run_shard(&squares(5), &store, Shard::WHOLE, false, &Unwatched).unwrap();
    let path = Shard::WHOLE.path(&store);
    let good = std::fs::read_to_string(&path).unwrap();
    let with = |text: String| {
        std::fs::write(&path, text).unwrap();
        merge(&store).unwrap_err().to_string()
    };
    assert!(with(good.replace("{\"case\":2", "{case")).contains("line 4: it is not JSON"));
    assert!(with(good.replace("flockproof.shard/2", "other")).contains("line 1: it does not begin"));
    assert!(with(String::new()).contains("it is empty"));
    let lines: Vec<&str> = good.lines().collect();
    let of = |lines: &[&str]| lines.iter().map(|line| format!("{line}\n")).collect::<String>();
    assert!(with(of(&[lines[0], lines[1], lines[2], lines[2]])).contains("line 4: case 1 comes twice"));
    let lost = of(&[lines[0], lines[1], lines[2], lines[4], lines[5]]);
    assert!(with(lost).contains("1 of 5 cases are in no finished shard, the first is case 2"));
    // A line of another campaign, and one of another shard of the same.
    run_shard(&squares(6), &folder("other"), Shard::WHOLE, false, &Unwatched).unwrap();
    let other = std::fs::read_to_string(Shard::WHOLE.path(&folder_of("other"))).unwrap();
    let strange = of(&[lines[0], lines[1], other.lines().nth(2).unwrap()]);
    assert!(with(strange).contains("line 3: it was altered"));
    let half = Shard { index: 1, of: 2 };
    let folder = folder("half");
    run_shard(&squares(5), &folder, half, false, &Unwatched).unwrap();
    let text = std::fs::read_to_string(half.path(&folder)).unwrap();
    std::fs::write(half.path(&folder), text + lines[2] + "\n").unwrap();
    assert!(merge(&folder).unwrap_err().to_string().contains("line 5: case 1 is not one of this shard"));
}

/// Whatever digit of a finished file is changed, it is noticed, by `merge` and by who goes on with the shard, and the line is named.
#[test]
fn altered_digits_are_noticed() {
    let store = folder("altered");
    run_shard(&squares(12), &store, Shard::WHOLE, false, &Unwatched).unwrap();
    let path = Shard::WHOLE.path(&store);
    let good = std::fs::read(&path).unwrap();
    let (mut line, mut altered) = (1, 0);
    for (place, byte) in good.iter().enumerate() {
        line += usize::from(*byte == b'\n');
        if byte.is_ascii_digit() {
            let mut bad = good.clone();
            bad[place] = b'0' + (byte - b'0' + 1) % 10;
            std::fs::write(&path, bad).unwrap();
            for error in [
                merge(&store).unwrap_err(),
                run_shard(&squares(12), &store, Shard::WHOLE, true, &Unwatched).unwrap_err(),
            ] {
                let said = error.to_string();
                assert!(said.contains(&format!("shard-1-of-1.jsonl, line {line}: ")), "{place}: {said}");
            }
            altered += 1;
        }
    }
    assert!(altered > 200, "{altered}");
}

#[test]
fn shards_are_read() {
    assert_eq!("3/8".parse::<Shard>().unwrap(), Shard { index: 3, of: 8 });
    for wrong in ["", "3", "0/8", "9/8", "1/0", "-1/2", "+1/2", "1/2/3", "a/b", "1/99999999999999999999"] {
        assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
    }
    let shard = |index: u64| Shard { index, of: 4 };
    let all: Vec<u64> = (1..=4).flat_map(|i| (0..shard(i).count(10)).map(move |k| shard(i).case(k))).collect();
    assert_eq!(all, [0, 4, 8, 1, 5, 9, 2, 6, 3, 7]);
}

#[test]
fn what_is_written_aside_has_a_name_of_its_own() {
    let path = Path::new("folder/table.jsonl");
    let names = std::thread::scope(|scope| {
        let running = [(); 4].map(|()| scope.spawn(|| (0..100).map(|_| aside(path)).collect::<Vec<PathBuf>>()));
        running.map(|one| one.join().expect("no panic")).concat()
    });
    let different: std::collections::BTreeSet<&PathBuf> = names.iter().collect();
    assert_eq!(different.len(), 400);
    assert!(names.iter().all(|name| name.parent() == path.parent() && name != path));
}
