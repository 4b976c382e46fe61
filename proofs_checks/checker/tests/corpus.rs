//! The corpus, and bytes altered at random.

use flockproof_checker::check;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

fn folder(name: &str) -> BTreeMap<String, Vec<u8>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus").join(name);
    let read =
        |path: PathBuf| (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read(&path).unwrap());
    let files: BTreeMap<_, _> = std::fs::read_dir(path).unwrap().map(|entry| read(entry.unwrap().path())).collect();
    assert!(!files.is_empty());
    files
}

#[test]
fn what_must_pass_passes() {
    for (name, bytes) in folder("pass") {
        let certified = check(&bytes).unwrap_or_else(|refusal| panic!("{name}: {refusal:?}"));
        let claim = String::from_utf8(bytes).unwrap().lines().nth(1).unwrap().to_string();
        assert_eq!(claim, format!("claim {}", certified.claim), "{name}");
    }
}

#[test]
fn what_must_fail_fails() {
    let table = include_str!("../corpus/fail.tsv");
    let reasons: BTreeMap<&str, &str> = table.lines().skip(1).filter_map(|line| line.split_once('\t')).collect();
    let files = folder("fail");
    assert_eq!(reasons.len(), files.len());
    for (name, bytes) in files {
        let refusal = check(&bytes).expect_err(&name);
        let reason = reasons[name.as_str()];
        assert!(refusal.reason.contains(reason), "{name}: {refusal:?}, not {reason}");
    }
}

#[test]
fn what_is_no_certificate_is_refused() {
    for (name, bytes) in folder("crash") {
        assert!(check(&bytes).is_err(), "{name}");
    }
}

/// Numbers as arbitrary as they come, always the same.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % bound.max(1)
    }
}

/// Whether a file may differ in this line and still be true: the start of a flock, the place where the peak is reached,
/// a column of L without weight, the denominator of zero.
fn may_differ(kind: &str, before: &[&str], line: usize) -> bool {
    let place = |keyword: &str| before.iter().position(|line| line.starts_with(keyword)).unwrap_or(usize::MAX);
    match kind {
        "switches" => place("weights ") <= line && line < place("until "),
        "peak" => line == place("at "),
        // Zero over another denominator.
        "limit" => line == place("Gamma over ") && before[line + 1] == "0",
        "inertia" => {
            let without_weight = before[place("D over ") + 1].split(' ').any(|d| d == "0");
            without_weight && place("L over ") < line && line < place("D over ")
        }
        _ => false,
    }
}

#[test]
fn altered_bytes_never_panic_and_never_pass_unless_true() {
    let mut numbers = Numbers(7);
    for (name, bytes) in folder("pass") {
        let text = String::from_utf8(bytes.clone()).unwrap();
        let lines: Vec<&str> = text.split('\n').collect();
        let kind = lines[0].rsplit(' ').next().unwrap();
        // Long checks are left to the others of their kind.
        let rounds = if ["M_16", "M_32", "M_64"].iter().any(|size| name.contains(size)) { 3 } else { 200 };
        for round in 0..rounds {
            let mut altered = bytes.clone();
            let at = numbers.below(altered.len());
            match numbers.below(5) {
                0 => altered[at] = numbers.below(256) as u8,
                1 => altered[at] ^= 1 << numbers.below(8),
                2 => drop(altered.remove(at)),
                3 => altered.insert(at, b"0123456789-/ \n"[numbers.below(14)]),
                _ => altered.truncate(at),
            }
            if altered != bytes
                && let Ok(certified) = check(&altered)
            {
                let line = bytes[..at].iter().filter(|&&byte| byte == b'\n').count();
                assert!(may_differ(kind, &lines, line), "{name}, round {round}, byte {at}: {certified:?}");
            }
        }
    }
}

#[test]
fn every_altered_digit_of_a_number_is_noticed() {
    for (name, bytes) in folder("pass") {
        let text = String::from_utf8(bytes.clone()).unwrap();
        let lines: Vec<&str> = text.split('\n').collect();
        let kind = lines[0].rsplit(' ').next().unwrap();
        if bytes.len() > 2500 || name.contains("table1") && !name.contains("M_4.") {
            continue;
        }
        for at in (0..bytes.len()).filter(|&at| bytes[at].is_ascii_digit()) {
            let mut altered = bytes.clone();
            altered[at] = if bytes[at] == b'9' { b'8' } else { bytes[at] + 1 };
            if check(&altered).is_ok() {
                let line = bytes[..at].iter().filter(|&&byte| byte == b'\n').count();
                assert!(may_differ(kind, &lines, line), "{name}, line {}: `{}`", line + 1, lines[line]);
            }
        }
    }
}

#[test]
fn the_program_tells_by_its_exit_status() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus");
    let run = |files: &[PathBuf]| {
        let output = Command::new(env!("CARGO_BIN_EXE_flockproof-checker")).args(files).output().unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    let one = |folder_name: &str| {
        let name = folder(folder_name).into_keys().next().unwrap();
        corpus.join(folder_name).join(name)
    };
    let (good, bad) = (one("pass"), one("fail"));
    let (status, said) = run(std::slice::from_ref(&good));
    assert!(status == Some(0) && said.starts_with("ok switches: the flock"), "{said}");
    let (status, said) = run(&[good.clone(), bad.clone()]);
    let refused = said.lines().nth(1).unwrap().to_string();
    assert!(status == Some(1) && refused.starts_with(&format!("REFUSED {}:", bad.display())), "{said}");
    assert_eq!(run(&[]).0, Some(2));
    assert_eq!(run(&[bad, corpus.join("nothing")]).0, Some(2));
}
