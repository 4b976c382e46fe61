//! What an entry says beside its verdict: clauses, the evidence for each, fault, counterexample, controls; and that too little evidence,
//! or another reach than the recorded one, is reported.

use arithmetic::CosineField;
use ledger::{
    CheckError, Entry, Evidence, Fault, Grade, Ledger, Options, Outcome, Record, Report, Run, Scope, Verdict,
    exact_value,
};

/// What the check of a form says: fails, or holds with this evidence.
#[derive(Clone, Copy)]
enum Says {
    Fails,
    /// Clauses and whether for all parameters.
    Holds(&'static [(&'static [usize], bool)]),
    /// Evidence that bears on no clause at all.
    Aside,
    /// Not a statement to check, with evidence on the first clause.
    Beyond,
    Undecided,
    Broken,
}

fn check(says: &Says, _: &mut Run) -> Result<Outcome, CheckError> {
    Ok(match says {
        Says::Fails => Outcome::fails("at 7", Evidence::new(Grade::Exact, "instance", "computed").on([1])),
        Says::Aside => Outcome::Holds(vec![Evidence { scope: None, ..Evidence::new(Grade::Exact, "aside", "seen") }]),
        Says::Beyond => {
            Outcome::NotCheckable("no data".into(), vec![Evidence::new(Grade::Exact, "seen", "detail").on([1])])
        }
        Says::Undecided => Outcome::Undecided("tried".into()),
        Says::Broken => return Err(CheckError::Other("broken".into())),
        Says::Holds(list) => {
            let one = |(clauses, all): &(&'static [usize], bool)| {
                let evidence = Evidence::new(Grade::Exact, "part", "detail").on(*clauses);
                if *all { evidence.for_all() } else { evidence }
            };
            Outcome::Holds(list.iter().map(one).collect())
        }
    })
}

fn record(printed: Says) -> Record<Says> {
    Record::new("test.a", "words", printed, check).stated("test", "").control("another", Says::Fails)
}

fn judged(record: Record<Says>, expected: &str) -> Report {
    let mut ledger = Ledger::new().with_record(&format!("id\tverdict\tfault\treach\tgrades\ntest.a\t{expected}\n"));
    ledger.register(record).unwrap();
    ledger.verify(&["test.a".into()], &Options::default(), |_| {})
}

fn entry(record: Record<Says>) -> Entry {
    judged(record, "holds\t-\t1/1\texact").entries.remove(0)
}

fn places(entry: &Entry) -> Vec<(Vec<usize>, Option<Scope>)> {
    entry.evidence.iter().map(|e| (e.clauses.clone(), e.scope)).collect()
}

const TWO: &[&str] = &["First.", "Second."];

#[test]
fn evidence_bears_on_the_clauses_that_it_names() {
    // With one clause it need not be named.
    let one = entry(record(Says::Holds(&[(&[], true)])).stated("test", "All."));
    assert_eq!((one.clauses.clone(), places(&one)), (vec!["All.".into()], vec![(vec![1], Some(Scope::All))]));
    let aside = entry(record(Says::Aside).stated("test", "All."));
    assert_eq!(places(&aside), [(vec![], None)]);
    let two = entry(record(Says::Holds(&[(&[1], true), (&[2], false)])).clauses(TWO));
    assert_eq!(
        (two.statement.as_str(), two.clauses.as_slice()),
        ("First. Second.", &["First.".to_string(), "Second.".into()][..])
    );
    assert_eq!(places(&two), [(vec![1], Some(Scope::All)), (vec![2], Some(Scope::Instances))]);
    assert_eq!((two.reach(), two.fault, two.counterexample.clone(), two.seconds >= 0.0), ((1, 2), None, None, true));
    let beyond = judged(record(Says::Beyond).clauses(TWO), "not_checkable\t-\t0/2\texact").entries.remove(0);
    assert_eq!(places(&beyond), [(vec![1], Some(Scope::Instances))]);
    // With two clauses, what names none is not placed.
    assert_eq!(places(&entry(record(Says::Holds(&[(&[], true)])).clauses(TWO))), [(vec![], Some(Scope::All))]);
}

#[test]
fn a_correction_adds_its_clauses_and_its_evidence() {
    let holds = Says::Holds(&[(&[1], true), (&[2], false)]);
    let repaired =
        record(Says::Fails).clauses(TWO).repaired(Fault::Slip, "", holds).repaired_clauses(&["Third.", "Fourth."]);
    let found = entry(repaired);
    assert_eq!(found.clauses, ["First.", "Second.", "corrected: Third.", "corrected: Fourth."]);
    assert_eq!(places(&found)[1..], [(vec![3], Some(Scope::All)), (vec![4], Some(Scope::Instances))]);
    assert!(found.evidence[1].part == "corrected: part" && found.evidence[0].part == "instance");
    assert_eq!((found.fault, found.corrected.as_deref()), (Some(Fault::Slip), Some("Third. Fourth.")));
    assert_eq!(found.counterexample.as_deref(), Some("at 7"));
    // A correction of one clause; and none.
    let single =
        entry(record(Says::Fails).stated("test", "All.").repaired(Fault::Typo, "Better.", Says::Holds(&[(&[], true)])));
    assert_eq!(
        (single.clauses.as_slice(), places(&single)[1].0.as_slice()),
        (&["All.".to_string(), "corrected: Better.".into()][..], &[2][..])
    );
    let narrower = record(Says::Fails).clauses(TWO).repaired(Fault::Slip, "Third.", Says::Holds(&[(&[], true)]));
    assert_eq!(places(&entry(narrower))[1], (vec![3], Some(Scope::All)));
    let none = entry(record(Says::Fails).stated("test", "All."));
    assert_eq!((none.clauses.len(), none.fault, none.corrected), (1, Some(Fault::False), None));
    assert_eq!(none.counterexample.as_deref(), Some("at 7"));
}

#[test]
fn controls_say_where_they_failed() {
    let found =
        entry(record(Says::Holds(&[(&[], true)])).stated("test", "All.").control("kept", Says::Holds(&[(&[], true)])));
    assert_eq!((found.controls.total, found.controls.refuted), (2, 1));
    assert_eq!(
        (found.controls.what.as_slice(), found.controls.failed.as_slice()),
        (&["another".to_string(), "kept".into()][..], &["at 7".to_string(), "it holds".into()][..])
    );
    assert_eq!(found.surviving_controls, ["kept: it holds"]);
    let open = record(Says::Holds(&[(&[], true)])).stated("test", "All.");
    let open =
        entry(open.control("tried", Says::Undecided).control("not run", Says::Broken).control("no", Says::Beyond));
    assert_eq!((open.controls.total, open.controls.refuted), (4, 1));
    assert_eq!(open.surviving_controls, ["tried: tried", "not run: broken", "no: no data"]);
}

/// The correction as a statement of its own has the clauses of the correction and no reading.
#[test]
fn a_correction_of_its_own_has_its_own_clauses() {
    let repaired = record(Says::Fails).clauses(TWO).repaired(Fault::Slip, "", Says::Holds(&[(&[1], true)]));
    let mut ledger = Ledger::new();
    ledger.expect("beyond.test.a", Verdict::Holds, &[Grade::Exact]);
    ledger.register(repaired.reading("read so").repaired_clauses(&["Third."])).unwrap();
    ledger.register_corrections(|_| true).unwrap();
    let ids = ledger.select(&["beyond".into()], &[]).unwrap();
    let found = ledger.verify(&ids, &Options::default(), |_| {}).entries.remove(0);
    assert_eq!((found.clauses.as_slice(), found.reading.as_deref()), (&["Third.".to_string()][..], None));
    assert_eq!(places(&found), [(vec![1], Some(Scope::All))]);
}

/// One sentence, which contains these words, or none.
fn differs(record: Record<Says>, expected: &str, words: &[&str]) {
    let report = judged(record, expected);
    assert_eq!(report.differences.len(), words.len(), "{:?}", report.differences);
    for (sentence, word) in report.differences.iter().zip(words) {
        assert!(sentence.starts_with("test.a: ") && sentence.contains(word), "{sentence}");
    }
    assert_eq!(report.is_as_recorded(), words.is_empty());
}

#[test]
fn another_reach_fault_verdict_or_grade_is_reported() {
    let holds = || record(Says::Holds(&[(&[1], true), (&[2], false)])).clauses(TWO);
    differs(holds(), "holds\t-\t1/2\texact", &[]);
    differs(holds(), "holds\t-\t2/2\texact", &["recorded fault - and 2/2 clauses for all parameters"]);
    differs(holds(), "holds\tslip\t1/2\texact", &["recorded fault slip"]);
    differs(holds(), "holds\t-\t1/2\tkernel", &["recorded evidence kernel"]);
    differs(holds(), "false\t-\t1/2\texact", &["recorded false, reached holds"]);
    let repaired = || {
        record(Says::Fails).stated("test", "All.").repaired(Fault::Hypothesis, "Better.", Says::Holds(&[(&[], true)]))
    };
    differs(repaired(), "needs_hypothesis\thypothesis\t1/2\texact", &[]);
    differs(repaired(), "needs_hypothesis\ttypo\t1/2\texact", &["recorded fault typo"]);
}

/// The text against itself reaches nowhere: it covers no clause, even where it names one.
#[test]
fn evidence_without_a_scope_covers_nothing() {
    let mut found = entry(record(Says::Holds(&[(&[1, 2], true)])).clauses(TWO));
    assert_eq!((found.covered(false).len(), found.covered(true).len()), (2, 2));
    found.evidence[0].scope = None;
    assert!(found.covered(false).is_empty() && found.covered(true).is_empty());
}

#[test]
fn what_says_more_than_its_evidence_is_reported() {
    let uncovered = record(Says::Holds(&[(&[1], true)])).clauses(TWO);
    differs(uncovered, "holds\t-\t1/2\texact", &["clause 2 is not covered: Second."]);
    let nowhere = record(Says::Holds(&[(&[1, 2], true), (&[3], true)])).clauses(TWO);
    differs(nowhere, "holds\t-\t2/2\texact", &["names no clause"]);
    let beside = record(Says::Holds(&[(&[1], true), (&[2], true)])).stated("test", "All.");
    differs(beside, "holds\t-\t1/1\texact", &["names no clause"]);
    let unnamed = record(Says::Holds(&[(&[1, 2], true), (&[], true)])).clauses(TWO);
    differs(unnamed, "holds\t-\t2/2\texact", &["names no clause"]);
    let half = record(Says::Fails).stated("test", "All.").repaired(Fault::Slip, "", Says::Holds(&[(&[2], true)]));
    differs(half.repaired_clauses(TWO), "misprint\tslip\t1/3\texact", &["clause 2 is not covered: corrected: First."]);
    let twice = record(Says::Holds(&[(&[1, 2], true)])).clauses(TWO).control("another", Says::Fails);
    differs(twice, "holds\t-\t2/2\texact", &["two negative controls alter the same"]);
    let alike = record(Says::Holds(&[(&[1, 2], true)])).clauses(TWO).control("one more", Says::Fails);
    differs(alike, "holds\t-\t2/2\texact", &["two negative controls fail at one place for one reason: at 7"]);
}

/// The ledger tells the verdicts that it was given as a table, by id; what a user expects of a claim is none of them.
#[test]
fn recorded_verdicts_come_back() {
    let rows =
        "id\tverdict\tfault\treach\tgrades\ntest.b\tfalse\tslip\t1/2\texact,fuzzed\ntest.a\tholds\t-\t0/1\tkernel\n";
    let mut ledger = Ledger::new().with_record(rows);
    let told = |ledger: &Ledger| -> Vec<String> {
        ledger.recorded().map(|r| [r.id, r.verdict, r.fault, r.reach, r.grades].join(" ")).collect()
    };
    assert_eq!(told(&ledger), ["test.a holds - 0/1 kernel", "test.b false slip 1/2 exact,fuzzed"]);
    ledger.expect("test.b", Verdict::Holds, &[Grade::Exact]);
    ledger.expect("test.c", Verdict::Holds, &[Grade::Exact]);
    assert_eq!(told(&ledger), ["test.a holds - 0/1 kernel"]);
}

/// `2 cos(2 pi/6) = 1`, and `2 cos(2 pi/12) = 1.7320508075688...`.
#[test]
fn cyclotomic_values_are_exact_or_enclosed() {
    let field = CosineField::new(12);
    let twice = |k: i64| field.cos(k) + &field.cos(k);
    assert_eq!(exact_value(&twice(2)).as_deref(), Ok("1"));
    assert_eq!(exact_value(&twice(1)).as_deref(), Ok("[1.73205080756, 1.73205080757]"));
}

/// What a record says of its clauses.
fn clause_verdicts(record: Record<Says>) -> Vec<Option<Verdict>> {
    entry(record).clause_verdicts
}

#[test]
fn every_clause_has_a_verdict_where_one_is_known() {
    use Verdict::{Holds, Misprint, NotCheckable, Undecided};
    let holds = record(Says::Holds(&[(&[1], true), (&[2], false)])).clauses(TWO);
    assert_eq!(clause_verdicts(holds), [Some(Holds); 2]);
    // What refutes the first clause says nothing of the second; clauses of the correction hold.
    let repaired = record(Says::Fails).clauses(TWO).repaired(Fault::Slip, "Third.", Says::Holds(&[(&[], true)]));
    assert_eq!(clause_verdicts(repaired), [Some(Misprint), None, Some(Holds)]);
    assert_eq!(clause_verdicts(record(Says::Fails).clauses(TWO)), [Some(Verdict::False), None]);
    // On instances nothing is established of a statement that is not checkable as a whole.
    assert_eq!(clause_verdicts(record(Says::Beyond).clauses(TWO)), [Some(NotCheckable); 2]);
    assert_eq!(clause_verdicts(record(Says::Undecided).clauses(TWO)), [Some(Undecided); 2]);
}

/// A found entry with other evidence, and what becomes of its clauses.
fn with_evidence(verdict: Verdict, evidence: Vec<Evidence>) -> (Vec<Option<Verdict>>, Vec<usize>) {
    let mut found = entry(record(Says::Beyond).clauses(TWO));
    (found.verdict, found.evidence) = (verdict, evidence);
    found.clause_verdicts = found.verdicts_by_clause();
    let held = found.clauses_that_hold();
    (found.clause_verdicts, held)
}

#[test]
fn a_clause_is_not_hidden_behind_its_neighbour_nor_carried_by_it() {
    use Verdict::{False, Holds, NotCheckable};
    let one = |clauses: &[usize]| Evidence::new(Grade::Kernel, "part", "theorem").on(clauses);
    let proved = |clauses: &[usize]| one(clauses).for_all();
    let refuted = |clauses: &[usize]| one(clauses).refuting();
    let none: Vec<usize> = Vec::new();
    assert_eq!(with_evidence(NotCheckable, vec![proved(&[1])]), (vec![Some(Holds), Some(NotCheckable)], vec![1]));
    assert_eq!(with_evidence(False, vec![refuted(&[1]), proved(&[2])]), (vec![Some(False), Some(Holds)], vec![2]));
    // Refuted together: nobody says which; instances establish nothing; what is refuted does not hold, whatever else is said.
    assert_eq!(with_evidence(False, vec![refuted(&[1, 2])]), (vec![None, None], none.clone()));
    assert_eq!(with_evidence(False, vec![refuted(&[1, 2]), proved(&[2])]), (vec![None, None], none.clone()));
    assert_eq!(with_evidence(False, vec![refuted(&[1]), one(&[2])]), (vec![Some(False), None], none.clone()));
    assert_eq!(with_evidence(False, vec![refuted(&[1]), proved(&[1])]), (vec![Some(False), None], none.clone()));
    assert_eq!(with_evidence(False, vec![refuted(&[2]).for_all()]), (vec![None, Some(False)], none.clone()));
    // Of what holds there is nothing to be said apart.
    assert_eq!(with_evidence(Holds, vec![proved(&[1, 2])]), (vec![Some(Holds); 2], none));
}
