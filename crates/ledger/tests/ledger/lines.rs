//! Lines of evidence: each is compared with what is recorded, none rests on no case, and the controls that fail in it are known.

use ledger::{CheckError, Entry, Evidence, Grade, Ledger, Options, Outcome, Record, Report, Run, Verdict};

/// Which parts of a check fail, how many cases they have, and what else is said.
#[derive(Clone)]
struct Parts {
    fails: &'static [&'static str],
    cases: fn(&Run) -> u64,
    third: Option<Grade>,
}

const PARTS: Parts = Parts { fails: &[], cases: |run| run.cases(3, 30) as u64, third: None };

fn check(parts: &Parts, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = |name: &str| {
        let count = (parts.cases)(run);
        run.instances(name, "counted", 0..count, |_| Ok(parts.fails.contains(&name).then(|| format!("{name} fails"))))
    };
    let third = parts.third.map(|grade| Ok(Outcome::Holds(vec![Evidence::new(grade, "third", "said")])));
    Run::all([part("first"), part("second")].into_iter().chain(third)).map(|outcome| outcome.on([1]))
}

fn record(printed: Parts) -> Record<Parts> {
    Record::new("test.a", "words", printed, check)
        .stated("test", "It is so.")
        .altered("one", |v| v.fails = &["first"])
        .altered("another", |v| v.fails = &["second"])
        .altered("both", |v| v.fails = &["second", "first"])
}

fn run(record: Record<Parts>, table: Option<&str>, full: bool) -> (Ledger, Report) {
    let mut ledger = Ledger::new();
    if let Some(table) = table {
        ledger = ledger.with_evidence(table);
    }
    ledger.register(record).unwrap();
    ledger.expect("test.a", Verdict::Holds, &[Grade::Exact]);
    let report = ledger.verify(&["test.a".into()], &Options { full, ..Options::default() }, |_| {});
    (ledger, report)
}

const HEAD: &str = "id\tpart\tgrade\tscope\tclauses\tcontrols\tcases\tfull\n";

/// Both rows after an ordinary and a full run.
fn table() -> String {
    format!("{HEAD}test.a\tfirst\texact\tinstances\t1\t1,3\t3\t30\ntest.a\tsecond\texact\tinstances\t1\t2,3\t3\t30\n")
}

fn controls(entry: &Entry) -> Vec<String> {
    entry.evidence.iter().map(|e| e.controls.join(",")).collect()
}

#[test]
fn controls_are_told_of_every_part_in_which_they_fail() {
    let (_, report) = run(record(PARTS), None, false);
    assert_eq!(controls(&report.entries[0]), ["1,3", "2,3"]);
    // The first failure is the counterexample.
    assert_eq!(report.entries[0].controls.failed[2], "first fails");
    assert_eq!(report.differences, ["test.a: two negative controls fail at one place for one reason: first fails"]);
}

#[test]
fn the_table_is_written_by_two_runs_and_read_by_both() {
    let (ledger, report) = run(record(PARTS), None, false);
    let ordinary = ledger.evidence_table(&report.entries, false);
    assert_eq!(ordinary, table().replace("\t30\n", "\t?\n"));
    let (ledger, report) = run(record(PARTS), Some(&ordinary), true);
    assert!(report.differences.iter().any(|sentence| sentence.contains("differs from what is recorded")));
    assert_eq!(ledger.evidence_table(&report.entries, true), table());
    for full in [false, true] {
        let (ledger, report) = run(record(PARTS), Some(&table()), full);
        assert_eq!(report.differences.len(), 1, "{:?}", report.differences);
        assert_eq!(ledger.evidence_table(&report.entries, full), table());
    }
}

/// Any other word of a row, a row more and a row less is told.
#[test]
fn every_word_of_a_line_is_compared() {
    let told = |table: &str, full: bool| run(record(PARTS), Some(table), full).1.differences.len() - 1;
    assert_eq!((told(&table(), false), told(&table(), true)), (0, 0));
    for (from, to) in
        [("first", "other"), ("\texact", "\tfuzzed"), ("\tinstances", "\tall"), ("\t1\t1,3", "\t1,2\t1,3")]
    {
        let other = table().replacen(from, to, 1);
        assert_eq!((told(&other, false), told(&other, true)), (2, 2), "{other}");
    }
    // More cases may refute more controls: those of ordinary runs are recorded and compared.
    let other = table().replacen("\t1,3", "\t1", 1);
    assert_eq!((told(&other, false), told(&other, true)), (2, 0), "{other}");
    let (fewer, fewer_in_full) = (table().replacen("\t3\t", "\t2\t", 1), table().replacen("\t30\n", "\t29\n", 1));
    assert_eq!((told(&fewer, false), told(&fewer, true)), (2, 0));
    assert_eq!((told(&fewer_in_full, false), told(&fewer_in_full, true)), (0, 2));
    let lost: String = table().lines().take(2).map(|line| format!("{line}\n")).collect();
    assert_eq!(told(&lost, false), 1);
    assert_eq!(told(HEAD, false), 2);
    let more = format!("{}test.a\tfourth\texact\tinstances\t1\t-\t3\tabsent\n", table());
    assert_eq!((told(&more, false), told(&more, true)), (1, 0));
    // Without a table nothing is compared.
    assert_eq!(run(record(PARTS), None, false).1.differences.len(), 1);
}

#[test]
fn a_line_that_only_one_kind_of_run_has_stays_recorded() {
    let more = format!("{}test.a\tfourth\texact\tinstances\t1\t-\tabsent\t7\n", table());
    let (ledger, report) = run(record(PARTS), Some(&more), false);
    assert_eq!((report.differences.len(), ledger.evidence_table(&report.entries, false)), (1, more.clone()));
    // A full run that lacks it forgets it.
    let (ledger, report) = run(record(PARTS), Some(&more), true);
    assert_eq!((report.differences.len(), ledger.evidence_table(&report.entries, true)), (2, table()));
}

/// With another seed other random controls may fail in a line; everything else is the same with every seed.
#[test]
fn controls_are_compared_with_the_seed_that_was_recorded() {
    let told = |table: &str, seed: &str| {
        let mut ledger = Ledger::new().with_evidence(table);
        ledger.register(record(PARTS)).unwrap();
        ledger.expect("test.a", Verdict::Holds, &[Grade::Exact]);
        let options = Options { seed: seed.to_string(), ..Options::default() };
        ledger.verify(&["test.a".into()], &options, |_| {}).differences.len() - 1
    };
    let (fewer_controls, fewer_cases) = (table().replace("1,3", "1"), table().replacen("\t3\t", "\t2\t", 1));
    assert_eq!((told(&fewer_controls, "flockproof"), told(&fewer_controls, "other")), (2, 0));
    assert_eq!((told(&fewer_cases, "flockproof"), told(&fewer_cases, "other"), told(&table(), "other")), (2, 2, 0));
}

/// A part that looks at nothing is no evidence: the claim is undecided, by name; so are a grade that counts its cases without a count, and a count of zero.
#[test]
fn evidence_of_no_case_is_an_error() {
    let (_, report) = run(record(Parts { cases: |_| 0, ..PARTS }), None, false);
    let entry = &report.entries[0];
    assert_eq!(
        (entry.verdict, entry.why.as_deref()),
        (Verdict::Undecided, Some("no case was looked at for \"first\""))
    );
    for grade in Grade::ALL {
        let (_, report) = run(record(Parts { third: Some(grade), ..PARTS }), None, false);
        let counted = matches!(grade, Grade::Identity | Grade::Exhaustive | Grade::Fuzzed);
        assert_eq!(grade.counts_cases(), counted);
        assert_eq!(report.entries[0].verdict == Verdict::Undecided, counted, "{grade:?}");
    }
    let zero = Record::new("test.a", "words", (), |_, _| {
        Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "none", "counted").cases(0)]))
    });
    let mut ledger = Ledger::new();
    ledger.register(zero.stated("test", "It is so.")).unwrap();
    let report = ledger.verify(&["test.a".into()], &Options::default(), |_| {});
    assert_eq!(report.entries[0].why.as_deref(), Some("no case was looked at for \"none\""));
    // What was computed beside a proof counts as well.
    let beside = Record::new("test.a", "words", (), |_, _| {
        let step = Evidence::new(Grade::Fuzzed, "a step", "not counted");
        Ok(Outcome::Holds(vec![Evidence::argued("all", "notes").on([1]).beside(vec![step])]))
    });
    let mut ledger = Ledger::new();
    ledger.register(beside.stated("test", "It is so.")).unwrap();
    let report = ledger.verify(&["test.a".into()], &Options::default(), |_| {});
    assert_eq!(report.entries[0].why.as_deref(), Some("no case was looked at for \"a step\""));
}

/// The printed form is a control of its correction, `p`; what was computed beside a proof has lines of its own.
#[test]
fn the_printed_form_and_steps_beside_a_proof_have_their_lines() {
    let with_step = |parts: &Parts, run: &mut Run| {
        let steps = match check(parts, run)? {
            Outcome::Holds(steps) => steps,
            other => return Ok(other),
        };
        Ok(Outcome::Holds(vec![Evidence::argued("all", "notes").on([1]).beside(steps)]))
    };
    let claim = Record::new("test.a", "words", Parts { fails: &["second"], ..PARTS }, with_step)
        .stated("test", "It is so.")
        .repaired(ledger::Fault::Slip, "It is otherwise.", PARTS)
        .altered("one", |v| v.fails = &["first"]);
    let mut ledger = Ledger::new();
    ledger.register(claim).unwrap();
    let report = ledger.verify(&["test.a".into()], &Options::default(), |_| {});
    let table = ledger.evidence_table(&report.entries, false);
    let rows: Vec<&str> = table.lines().skip(1).collect();
    assert_eq!(
        rows,
        [
            "test.a\tsecond\texact\tinstances\t1\t-\t-\t?",
            "test.a\tcorrected: all\targued\tall\t2\t-\t-\t?",
            "test.a\tcorrected: all, beside it: first\texact\tinstances\t1\t1\t3\t?",
            "test.a\tcorrected: all, beside it: second\texact\tinstances\t1\tp\t3\t?",
        ]
    );
}
