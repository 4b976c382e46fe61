//! How outcomes become verdicts, and what the runner does with checks that misbehave.

use arithmetic::{Progress, rational};
use ledger::{
    CheckError, Evidence, Fault, Grade, Ledger, LedgerError, Options, Outcome, Record, Run, Verdict, to_json,
};
use rand_chacha::rand_core::Rng;
use std::sync::Arc;
use std::time::Duration;

/// Asks to stop at once.
struct Stopped;

impl Progress for Stopped {
    fn is_cancelled(&self) -> bool {
        true
    }
}

/// What a scripted variant does.
#[derive(Clone, Copy)]
enum Act {
    Hold,
    HoldWithoutEvidence,
    Fail,
    FailElsewhere,
    Undecided,
    NotCheckable,
    Error,
    Panic,
    LoopForever,
    SleepUncooperatively,
    Random,
}

struct Scripted {
    id: &'static str,
    printed: Act,
    repair: Option<(Fault, Act)>,
    controls: Vec<Act>,
}

impl Scripted {
    fn record(self) -> Record<Act> {
        let record = Record::new(self.id, "as the script says", self.printed, act).stated("test", "scripted");
        let record = match self.repair {
            Some((fault, variant)) => record.repaired(fault, "corrected", variant),
            None => record,
        };
        let controls = ["control", "another"].into_iter().zip(self.controls);
        controls.fold(record, |record, (what, act)| record.control(what, act))
    }
}

fn act(act: &Act, run: &mut Run) -> Result<Outcome, CheckError> {
    let evidence = || Evidence::new(Grade::Exact, "part", "detail");
    match act {
        Act::Hold => Ok(Outcome::Holds(vec![evidence()])),
        Act::HoldWithoutEvidence => Ok(Outcome::Holds(vec![])),
        Act::Fail => Ok(Outcome::fails("here", evidence())),
        Act::FailElsewhere => Ok(Outcome::fails("there", evidence())),
        Act::Undecided => Ok(Outcome::Undecided("tried".into())),
        Act::NotCheckable => Ok(Outcome::NotCheckable("no data".into(), vec![])),
        Act::Error => Err(CheckError::Other("broken".into())),
        Act::Panic => panic!("a scripted panic"),
        Act::LoopForever => loop {
            run.checkpoint()?;
        },
        Act::SleepUncooperatively => {
            std::thread::sleep(Duration::from_secs(600));
            Ok(Outcome::Holds(vec![evidence()]))
        }
        Act::Random => {
            run.value("drawn", rational(run.random(3).next_u32().into(), 1).to_string());
            Ok(Outcome::Holds(vec![evidence()]))
        }
    }
}

fn claim(id: &'static str, printed: Act) -> Scripted {
    Scripted { id, printed, repair: None, controls: vec![Act::Fail] }
}

fn run(claims: Vec<Scripted>, options: &Options) -> ledger::Report {
    let mut ledger = Ledger::new();
    for claim in claims {
        ledger.expect(claim.id, Verdict::Holds, &[Grade::Exact]);
        ledger.register(claim.record()).unwrap();
    }
    let ids = ledger.select(&[], &[]).unwrap();
    ledger.verify(&ids, options, |_| {})
}

fn verdict(claim: Scripted) -> (Verdict, Option<String>) {
    let entry = run(vec![claim], &Options::default()).entries.remove(0);
    (entry.verdict, entry.why)
}

#[test]
fn verdicts_follow_from_outcomes() {
    let repaired = |fault, act| Scripted { repair: Some((fault, act)), ..claim("test.a", Act::Fail) };
    assert_eq!(verdict(claim("test.a", Act::Hold)).0, Verdict::Holds);
    assert_eq!(verdict(claim("test.a", Act::Fail)).0, Verdict::False);
    assert_eq!(verdict(repaired(Fault::Typo, Act::Hold)).0, Verdict::Misprint);
    assert_eq!(verdict(repaired(Fault::False, Act::Hold)).0, Verdict::False);
    for act in [Act::Fail, Act::Undecided, Act::NotCheckable, Act::Error, Act::HoldWithoutEvidence] {
        assert_eq!(verdict(repaired(Fault::Typo, act)).0, Verdict::Undecided);
    }
    assert_eq!(verdict(claim("test.a", Act::Undecided)), (Verdict::Undecided, Some("tried".into())));
    assert_eq!(verdict(claim("test.a", Act::NotCheckable)), (Verdict::NotCheckable, Some("no data".into())));
    assert_eq!(verdict(claim("test.a", Act::Error)), (Verdict::Undecided, Some("broken".into())));
    assert_eq!(verdict(claim("test.a", Act::HoldWithoutEvidence)).0, Verdict::Undecided);
}

#[test]
fn a_correction_is_a_claim_that_refutes_the_printed_form() {
    let judged = |printed, repair| {
        let mut ledger = Ledger::new();
        let controls = vec![Act::FailElsewhere];
        ledger.register(Scripted { repair, controls, ..claim("test.a", printed) }.record()).unwrap();
        ledger.expect("beyond.test.a", Verdict::Holds, &[Grade::Exact]);
        ledger.register_corrections(|id| id == "test.a").unwrap();
        let ids = ledger.select(&["beyond".into()], &[]).unwrap_or_default();
        ledger.verify(&ids, &Options::default(), |_| {})
    };
    let report = judged(Act::Fail, Some((Fault::Typo, Act::Hold)));
    let entry = &report.entries[0];
    assert_eq!((entry.id.as_str(), entry.paper.as_str(), entry.verdict), ("beyond.test.a", "beyond", Verdict::Holds));
    assert_eq!((entry.statement.as_str(), entry.place.as_str()), ("corrected", "corrects test, test"));
    assert_eq!((entry.controls.refuted, entry.controls.total), (2, 2), "its own control and the printed form");
    assert!(entry.derivation.contains("test.a is misprinted") && report.is_as_recorded());
    // A correction that the check cannot tell from the printed form says nothing.
    let same = judged(Act::Hold, Some((Fault::False, Act::Hold)));
    assert!(same.differences[0].contains("as printed: it holds"), "{:?}", same.differences);
    assert_eq!(judged(Act::Fail, Some((Fault::False, Act::Fail))).entries[0].verdict, Verdict::False);
    assert!(judged(Act::Fail, None).entries.is_empty());
}

#[test]
fn a_correction_needs_an_id_of_its_own() {
    let mut ledger = Ledger::new();
    for id in ["test.a", "beyond.test.a"] {
        ledger.register(Scripted { repair: Some((Fault::False, Act::Hold)), ..claim(id, Act::Fail) }.record()).unwrap();
    }
    let twice = ledger.register_corrections(|id| id == "test.a");
    assert_eq!(twice, Err(LedgerError::Twice("beyond.test.a".into())));
}

#[test]
fn misbehaving_checks_cost_only_their_own_verdict() {
    let claims = vec![claim("test.a", Act::Panic), claim("test.b", Act::LoopForever), claim("test.c", Act::Hold)];
    let report = run(claims, &Options { most_work: 1000, threads: 2, ..Options::default() });
    let verdicts: Vec<Verdict> = report.entries.iter().map(|e| e.verdict).collect();
    assert_eq!(verdicts, [Verdict::Undecided, Verdict::Undecided, Verdict::Holds]);
    assert!(report.entries[0].why.as_ref().is_some_and(|why| why.contains("panic")));
    assert_eq!(report.entries[1].why.as_deref(), Some("the limit of work was reached"));
    assert!(!report.is_as_recorded());
}

/// The last resort: a check that passes no checkpoints is given up, however fast or busy the machine is.
#[test]
fn a_check_that_sleeps_is_given_up() {
    let options = Options { longest: Duration::from_millis(1), ..Options::default() };
    let entry = run(vec![claim("test.a", Act::SleepUncooperatively)], &options).entries.remove(0);
    assert_eq!(
        (entry.verdict, entry.why.is_some_and(|why| why.starts_with("not decided"))),
        (Verdict::Undecided, true)
    );
}

#[test]
fn every_deviation_is_reported() {
    let surviving = Scripted { controls: vec![Act::Fail, Act::Hold], ..claim("test.survivor", Act::Hold) };
    let uncontrolled = Scripted { controls: vec![], ..claim("test.uncontrolled", Act::Hold) };
    for (claim, expected) in [(surviving, "was not refuted"), (uncontrolled, "no negative control")] {
        let report = run(vec![claim], &Options::default());
        assert_eq!(report.differences.len(), 1, "{:?}", report.differences);
        assert!(report.differences[0].contains(expected));
    }
    let mut ledger = Ledger::new();
    ledger.register(claim("test.unrecorded", Act::Hold).record()).unwrap();
    let report = ledger.verify(&["test.unrecorded".into()], &Options::default(), |_| {});
    assert!(report.differences[0].contains("no verdict is recorded"));
}

#[test]
fn the_document_does_not_depend_on_the_number_of_threads() {
    let document = |threads| {
        let options = Options { threads, ..Options::default() };
        let claims = ["test.a", "test.b", "test.c", "test.d"].map(|id| claim(id, Act::Random)).into_iter().collect();
        let text = to_json(&run(claims, &options), &options);
        text.lines().filter(|line| !line.contains("\"seconds\"")).map(String::from).collect::<Vec<_>>()
    };
    assert_eq!(document(1), document(4));
    let other = Options { seed: "another".into(), ..Options::default() };
    let drawn = |options: &Options| run(vec![claim("test.a", Act::Random)], options).entries[0].values["drawn"].clone();
    assert_ne!(drawn(&other), drawn(&Options::default()));
}

#[test]
fn an_interrupted_run_keeps_what_was_finished() {
    let options = Options { progress: Arc::new(Stopped), ..Options::default() };
    let report = run(vec![claim("test.a", Act::Hold)], &options);
    assert_eq!((report.entries.len(), report.missing.as_slice()), (0, &["test.a".to_string()][..]));
    assert!(!report.is_as_recorded());
}

/// A family without members is no evidence.
#[test]
fn no_case_is_undecided() {
    let empty = Record::new("test.empty", "nothing to look at", (), |(), run| {
        run.exhaustive("the empty family", "looked at", std::iter::empty::<u64>(), |_| Ok(None::<String>))
    });
    let mut ledger = Ledger::new();
    ledger.register(empty.stated("test", "every member of the empty family")).unwrap();
    let report = ledger.verify(&["test.empty".into()], &Options::default(), |_| {});
    assert_eq!(report.entries[0].verdict, Verdict::Undecided);
}
