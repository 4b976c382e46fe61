//! What a check is given, how claims are registered and found, what proofs add, and how a document is read back.

use arithmetic::identity::Identity;
use arithmetic::{Probe, Ring};
use ledger::rand_chacha::rand_core::Rng;
use ledger::{
    CheckError, Document, DocumentError, Entry, Evidence, Fault, Grade, Ledger, LedgerError, Options, Outcome, Proofs,
    Record, Run, Scope, Verdict, to_json,
};

/// A claim that an integer is positive.
fn number(id: &'static str, printed: i64) -> Record<i64> {
    Record::new(id, "by looking", printed, |n: &i64, _: &mut Run| {
        let evidence = Evidence::new(Grade::Exact, "the number", format!("{n}"));
        Ok(if *n > 0 {
            Outcome::Holds(vec![evidence.for_all().on([1])])
        } else {
            Outcome::fails(format!("{n}"), evidence)
        })
    })
}

fn entry(ledger: &Ledger, id: &str) -> Entry {
    ledger.verify(&[id.to_string()], &Options::default(), |_| {}).entries.remove(0)
}

#[test]
fn cases_are_counted_and_the_first_wrong_one_is_told() {
    let run = Run::new("test.a", "seed", false, 1000);
    let wrong = |limit: i64| move |n: i64| Ok((n >= limit).then(|| format!("{n} is too large")));
    let held = run.exhaustive("all", "looked at", 0..7, wrong(10)).unwrap();
    let evidence = Evidence::new(Grade::Exhaustive, "all", "looked at").for_all().cases(7);
    assert_eq!((held, evidence.cases), (Outcome::Holds(vec![evidence.clone()]), Some(7)));
    let Ok(Outcome::Fails { counterexample, evidence, .. }) = run.exhaustive("all", "looked at", 0..7, wrong(5)) else {
        panic!()
    };
    assert_eq!((counterexample.text.as_str(), evidence[0].grade), ("5 is too large", Grade::Exact));
    assert_eq!((evidence[0].scope, evidence[0].cases), (Some(Scope::Instances), None));
    let Ok(Outcome::Fails { evidence, .. }) = run.every(Evidence::new(Grade::Simulated, "some", ""), 0..7, wrong(5))
    else {
        panic!()
    };
    assert_eq!(evidence[0].grade, Grade::Simulated);
    assert!(matches!(run.instances("none", "", 0..0, wrong(5)), Err(CheckError::NoCases(part)) if part == "none"));
    assert_eq!(Evidence::new(Grade::Identity, "", "").error_bits(40).error_bound.as_deref(), Some("2^-40"));
}

#[test]
fn as_much_work_is_done_as_is_allowed() {
    for most in [0, 1, 5] {
        let run = Run::new("test.a", "seed", false, most);
        assert_eq!((0..9).take_while(|_| run.checkpoint().is_ok()).count() as u64, most);
        let run = Run::new("test.a", "seed", false, most);
        let all = run.instances("some", "", 0..most + 1, |_| Ok(None::<String>));
        assert!(matches!(all, Err(CheckError::Limit)));
        let within = Run::new("test.a", "seed", false, most).instances("some", "", 0..most, |_| Ok(None::<String>));
        assert!(!matches!(within, Err(CheckError::Limit)));
    }
    assert_eq!([false, true].map(|full| Run::new("a", "b", full, 1).cases(3, 30)), [3, 30]);
    let draw = |id: &str, seed: &str, replicate: u64| Run::new(id, seed, false, 1).random(replicate).next_u64();
    let draws = [draw("a", "s", 0), draw("a", "s", 1), draw("b", "s", 0), draw("a", "t", 0)];
    assert!(draws[0] == draw("a", "s", 0) && draws[1..].iter().all(|x| *x != draws[0]));
    let options = Options::default();
    assert_eq!((options.full, options.most_work, options.longest.as_secs()), (false, 10_000_000, 3600));
}

#[test]
fn records_have_what_was_said_of_them() {
    let claim = number("test.a", 0)
        .stated("here", "it is positive")
        .reading("as an integer")
        .repaired_by(Fault::Typo, "it is 2", |n| *n = 2)
        .altered("its sign", |n| *n = -*n);
    let mut ledger = Ledger::new();
    ledger.register(claim).unwrap();
    let found = entry(&ledger, "test.a");
    assert_eq!(
        (found.verdict, found.fault, found.reading.as_deref()),
        (Verdict::Misprint, Some(Fault::Typo), Some("as an integer"))
    );
    assert_eq!((found.corrected.as_deref(), found.counterexample.as_deref()), (Some("it is 2"), Some("0")));
    // The control alters the corrected number.
    assert_eq!((found.controls.what, found.controls.failed), (vec!["its sign".to_string()], vec!["-2".to_string()]));
}

/// Says what it is told to say of one claim.
struct Said(Result<Grade, &'static str>);

impl Proofs for Said {
    fn evidence(&self, claim: &str, verdict: Verdict, printed: usize) -> Result<Vec<Evidence>, String> {
        assert_eq!((claim, printed), ("test.a", 1));
        assert!(matches!(verdict, Verdict::Holds | Verdict::Misprint));
        self.0.map(|grade| vec![Evidence::new(grade, "a theorem", "")]).map_err(str::to_string)
    }
}

#[test]
fn proofs_add_evidence_or_leave_a_claim_undecided() {
    for (printed, corrected) in [(1, None), (0, Some(2))] {
        let with = |said: Result<Grade, &'static str>| {
            let claim = number("test.a", printed).stated("here", "it is positive");
            let claim = match corrected {
                Some(n) => claim.repaired(Fault::Slip, "it is 2", n),
                None => claim,
            };
            let mut ledger = Ledger::new().with_proofs(Said(said));
            ledger.register(claim).unwrap();
            entry(&ledger, "test.a")
        };
        let proved = with(Ok(Grade::Kernel));
        assert!(proved.grades().contains(&Grade::Kernel) && proved.verdict != Verdict::Undecided);
        assert!(proved.grades().is_sorted());
        let contradicted = with(Err("a theorem says otherwise"));
        assert_eq!(
            (contradicted.verdict, contradicted.why.as_deref()),
            (Verdict::Undecided, Some("a theorem says otherwise"))
        );
        assert_eq!((contradicted.fault, contradicted.corrected, contradicted.counterexample), (None, None, None));
        assert!(contradicted.evidence.is_empty());
    }
}

#[test]
fn claims_are_found_by_paper_and_by_id() {
    let table = "id\tplace\tstatement\none.a\tsection 1\tfirst\none.b\tsection 2\tsecond\n";
    let mut ledger = Ledger::new().with_list(table);
    ledger.register(number("one.a", 0).repaired(Fault::Slip, "it is 2", 2)).unwrap();
    ledger.register(number("two.c", 0).stated("here", "third").repaired(Fault::Slip, "it is 2", 2)).unwrap();
    let source = ledger.source("one.a").unwrap();
    assert_eq!((source.place.as_str(), source.statement.as_str()), ("section 1", "first"));
    assert_eq!(ledger.register(number("one.d", 1)), Err(LedgerError::NoSource("one.d".into())));
    assert_eq!(ledger.register(number("one.a", 1)), Err(LedgerError::Twice("one.a".into())));
    ledger.register_corrections(|id| id == "one.a").unwrap();
    let select = |papers: &[&str], claims: &[&str]| {
        let owned = |list: &[&str]| list.iter().map(|x| x.to_string()).collect::<Vec<_>>();
        ledger.select(&owned(papers), &owned(claims)).map(|ids| ids.join(" "))
    };
    assert_eq!(select(&[], &[]), Ok("beyond.one.a one.a two.c".into()));
    assert_eq!((select(&["one"], &[]), select(&["two"], &[])), (Ok("one.a".into()), Ok("two.c".into())));
    assert_eq!((select(&[], &["two.c"]), select(&["one"], &["two.c"])), (Ok("two.c".into()), Ok(String::new())));
    assert_eq!(select(&["three"], &[]), Err(LedgerError::NoPaper("three".into(), "beyond, one, two".into())));
    assert_eq!(select(&[], &["one.b"]), Err(LedgerError::NotBuilt("one.b".into())));
    assert_eq!(select(&[], &["one.c"]), Err(LedgerError::Unknown("one.c".into())));
    // A correction has none of its own.
    ledger.register_corrections(|id| id != "one.a").unwrap();
    assert_eq!(ledger.ids().collect::<Vec<_>>(), ["beyond.one.a", "beyond.two.c", "one.a", "two.c"]);
    let statement = |id: &str| ledger.source(id).map(|source| (source.place.clone(), source.statement.clone()));
    assert_eq!(statement("beyond.one.a"), Some(("corrects one, section 1".into(), "it is 2".into())));
}

#[test]
fn documents_are_read_back_and_others_refused() {
    let mut ledger = Ledger::new();
    for id in ["test.b", "test.a"] {
        ledger.register(number(id, 1).stated("here", "it is positive")).unwrap();
    }
    let (ids, options) = (["test.b".to_string(), "test.a".to_string()], Options::default());
    let report = ledger.verify(&ids, &options, |_| {});
    let text = to_json(&report, &options);
    let document = Document::read(&text).unwrap();
    let read: Vec<&str> = document.claims.iter().map(|entry| entry.id.as_str()).collect();
    assert_eq!((read, document.interrupted, document.missing.len()), (vec!["test.a", "test.b"], false, 0));
    // In another order too.
    let exchanged = text.replace("\"test.a\"", "\"test.c\"");
    let read = Document::read(&exchanged).unwrap();
    assert_eq!(read.claims.iter().map(|entry| entry.id.as_str()).collect::<Vec<_>>(), ["test.b", "test.c"]);
    assert!(
        matches!(Document::read(&text.replace("ledger/2", "ledger/1")), Err(DocumentError::Schema(name)) if name.ends_with("/1"))
    );
    assert!(
        matches!(Document::read(&text.replace("test.b", "test.a")), Err(DocumentError::Twice(id)) if id == "test.a")
    );
    assert!(matches!(Document::read("{}"), Err(DocumentError::Json(_))));
    let long = format!("t.{}", "x".repeat(118));
    for good in ["t", "t.a-b_c.7", long.as_str()] {
        assert!(Document::read(&text.replace("test.b", good)).is_ok(), "{good}");
    }
    let longer = format!("{long}x");
    for bad in ["", "t.", ".t", "t..a", "t/a", "../t", "t a", "t.ä", longer.as_str()] {
        assert!(matches!(Document::read(&text.replace("test.b", bad)), Err(DocumentError::Id(_))), "{bad}");
    }
    let paper = text.replace("\"paper\": \"test\"", "\"paper\": \"../test\"");
    assert!(matches!(Document::read(&paper), Err(DocumentError::Id(_))));
    let stopped = Document::new(&ledger::Report { missing: ids.to_vec(), ..report.clone() }, &options).json();
    assert!(Document::read(&stopped).unwrap().interrupted);
}

#[test]
fn identities_are_evidence_with_their_number_of_points() {
    let square = |wrong: i64| {
        Identity::of(move |[x]: &[Probe; 1]| Ok((vec![x.square()], vec![x.clone() * x + x.integer(wrong)])))
    };
    for (full, points) in [(false, 16), (true, 64)] {
        let run = Run::new("test.a", "seed", full, 10);
        let Ok(Outcome::Holds(evidence)) = run.identity(&square(0), &["x"], "a square") else { panic!() };
        assert_eq!((evidence[0].grade, evidence[0].cases), (Grade::Identity, Some(points)));
        assert!(evidence[0].detail.contains(" in x;") && evidence[0].error_bound.is_some());
        let Ok(Outcome::Fails { counterexample, .. }) = run.identity(&square(1), &["x"], "a square") else { panic!() };
        assert!(counterexample.contains("at x = ") && counterexample.contains("component 1"), "{counterexample}");
    }
    assert!(matches!(Run::new("a", "b", false, 0).identity(&square(0), &["x"], ""), Err(CheckError::Limit)));
}
