//! The corpus, and bytes altered at random.

use flockproof_checker::{check, check_for, check_within};
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
fn no_work_is_done_beyond_what_is_granted() {
    for (name, bytes) in folder("pass") {
        assert_eq!(check_within(&bytes, 1 << 31), check(&bytes), "{name}");
        let refusal = check_within(&bytes, 0).expect_err(&name);
        assert_eq!(refusal.reason, "checking it would take too long", "{name}");
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
fn a_refusal_names_the_line_at_fault() {
    let line = |bytes: &[u8]| check(bytes).expect_err("it is refused").line;
    assert_eq!(line(&[b' '; (4 << 20) + 1]), 1);
    assert_eq!(line(b"nothing\n"), 1);
    assert_eq!(line(b"flockproof-certificate 1 product\n\t\n\t\n"), 2);
    let good = String::from_utf8(folder("pass")["extra_product_rectangular.cert"].clone()).unwrap();
    let second_row = good.replace("\n2 4\n", "\n2 3\n");
    assert_eq!(line(second_row.as_bytes()), 7);
}

#[test]
fn a_flock_may_be_followed_for_no_step() {
    let text = String::from_utf8(folder("pass")["extra_switches_wide_threshold.cert"].clone()).unwrap();
    let at_once = text.replace("until 12", "until 0").replace("to t = 12", "to t = 0");
    assert!(check(at_once.as_bytes()).is_ok());
}

/// A certificate of the ledger names its claim, and is refused for every other one; one that names none is refused for all.
#[test]
fn a_certificate_belongs_to_one_claim() {
    for (name, bytes) in folder("pass") {
        let certified = check(&bytes).unwrap();
        let Some((claim, result)) = certified.belongs.clone() else {
            assert!(name.starts_with("extra_"), "{name} names no claim");
            assert!(check_for(&bytes, "veerman.lem1").is_err(), "{name}");
            continue;
        };
        assert_eq!(format!("{claim}.{result}.cert"), name);
        assert_eq!(check_for(&bytes, &claim), Ok(certified));
        for other in ["veerman.lem1", "", &claim[1..], &format!("{claim}.{result}")] {
            let refusal = check_for(&bytes, other).expect_err(&name);
            assert!(refusal.reason.contains(&format!("belongs to {claim}")), "{name}: {refusal:?}");
        }
    }
    let good = String::from_utf8(folder("pass")["chazelle.exAB.60_factors.cert"].clone()).unwrap();
    for line in ["for chazelle.exAB", "for chazelle.exAB 60 factors", "for  60_factors", "for a b\nfor a b"] {
        let text = good.replace("for chazelle.exAB 60_factors", line);
        assert!(text != good && check(text.as_bytes()).is_err(), "{line}");
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
/// a column of L without weight, the denominator of zero; another system of which the same sentence is true.
fn may_differ(kind: &str, before: &[&str], line: usize) -> bool {
    let place = |keyword: &str| before.iter().position(|line| line.starts_with(keyword)).unwrap_or(usize::MAX);
    // What a certificate belongs to is compared where that is asked for.
    if line == place("for ") {
        return true;
    }
    match kind {
        "switches" => place("weights ") <= line && line < place("until "),
        "peak" => line == place("at "),
        // Zero over another denominator.
        "limit" => line == place("Gamma over ") && before[line + 1] == "0",
        "inertia" => {
            let without_weight = before[place("D over ") + 1].split(' ').any(|d| d == "0");
            without_weight && place("L over ") < line && line < place("D over ")
        }
        "motion" | "bound" | "kept" => line > 1,
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
    let of = |claim: &str| run(&["--claim".into(), claim.into(), good.clone()]);
    assert_eq!(of("chazelle.ex4birds.alt").0, Some(0));
    let (status, said) = of("chazelle.exAB");
    assert!(status == Some(1) && said.contains("it belongs to chazelle.ex4birds.alt, not to chazelle.exAB"), "{said}");
    assert_eq!((run(&["--claim".into()]).0, run(&["--claim".into(), "chazelle.exAB".into()]).0), (Some(2), Some(2)));
    assert_eq!(run(&[bad, corpus.join("nothing")]).0, Some(2));
}

fn corpus_text(folder_name: &str, name: &str) -> String {
    String::from_utf8(folder(folder_name)[name].clone()).unwrap()
}

/// The limits of `../README.md`, each to the last unit.
#[test]
fn limits_are_those_that_are_written_down() {
    let file = |kind: &str, lines: &str| format!("flockproof-certificate 1 {kind}\nclaim words\n{lines}\nend\n");
    let flock = corpus_text("pass", "extra_switches_none.cert");
    let limit = corpus_text("pass", "extra_limit_one_bird.cert");
    let power = limit.lines().find(|line| line.starts_with("power ")).unwrap().to_string();
    type Text<'a> = Box<dyn Fn(usize) -> String + 'a>;
    let limits: [(usize, usize, Text); 9] = [
        (1, 64, Box::new(|n| file("switches", &format!("birds {n}")))),
        (1, 8, Box::new(|n| file("switches", &format!("birds 1\ndimension {n}")))),
        (0, 100_000, Box::new(|n| flock.replace("until 20", &format!("until {n}")))),
        (0, 100_000, Box::new(|n| flock.replace("network 0", &format!("network {n}")))),
        (1, 10_000, Box::new(|n| file("product", &format!("factors {n}")))),
        (1, 128, Box::new(|n| file("product", &format!("factors 1\nshape {n} 1")))),
        (1, 128, Box::new(|n| file("inertia", &format!("order {n}")))),
        (1, 96, Box::new(|n| file("peak", &format!("followers {n}")))),
        (1, 65_536, Box::new(|n| limit.replace(&power, &format!("power {n}")))),
    ];
    for (least, most, text) in limits {
        let expected = format!("a number from {least} to {most} is expected");
        let is_refused = |n: usize| check(text(n).as_bytes()).is_err_and(|refusal| refusal.reason == expected);
        assert!(is_refused(most + 1), "{}", text(most + 1));
        assert!(!is_refused(most) && !is_refused(least), "{}", text(most));
        assert!(least == 0 || is_refused(least - 1), "{}", text(least - 1));
    }
    let digits = |n: usize| check(file("peak", &format!("followers 1\nf {}", "1".repeat(n))).as_bytes());
    let too_long = "a number of more than 10000 digits";
    assert!(digits(10_001).is_err_and(|refusal| refusal.reason == too_long));
    assert!(digits(10_000).is_err_and(|refusal| refusal.reason != too_long));
    let bytes = |n: usize| check(&vec![b'a'; n]).unwrap_err().reason == "the file is longer than 4 MiB";
    assert!(bytes((4 << 20) + 1) && !bytes(4 << 20));
}

/// A refusal names the line at fault, the one that was read last.
#[test]
fn refusals_name_the_line() {
    for (name, line) in [
        ("inertia_pivot.cert", 9),
        ("inertia_symmetric.cert", 8),
        ("limit_pi.cert", 10),
        ("limit_row.cert", 5),
        ("product_trailing.cert", 306),
        ("switches_until.cert", 82),
        ("peak_frequency_negative.cert", 6),
        ("switches_count.cert", 2),
    ] {
        assert_eq!(check(corpus_text("fail", name).as_bytes()).unwrap_err().line, line, "{name}");
    }
    assert_eq!(check(b"flockproof-certificate 1 peak\n\x80\n").unwrap_err().line, 2);
}
