//! The ledger of the project: tables in order, every claim as recorded.

use claims::{EVIDENCE, LISTED, RECORDED};
use ledger::{Grade, Ledger, LedgerError, Options, Report, Verdict, correction_id, listed, recorded, to_json};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

/// Corrections of wording, and by long runs.
const WITHOUT_OWN_CLAIM: [&str; 4] =
    ["tanner2.appA.thm4", "tanner2.appA.thm5", "tanner2.sec6.figures", "veerman.sec7.system"];

#[test]
fn tables_are_in_order() {
    let ids: Vec<&str> = listed(LISTED).map(|row| row.id).collect();
    assert_eq!(ids.len(), 237);
    assert_eq!(ids.iter().collect::<BTreeSet<_>>().len(), ids.len());
    let ledger = claims::ledger().unwrap();
    let built: Vec<&str> = ledger.ids().collect();
    assert!(built.iter().all(|id| ids.contains(id) || id.starts_with("beyond.")));
    let rows: Vec<&str> = recorded(RECORDED).map(|row| row.id).collect();
    assert_eq!(rows, built, "recorded.tsv must hold exactly the claims that are built, sorted");
}

/// What an ordinary run of the whole ledger comes to, once for all tests.
pub fn report() -> &'static Report {
    static REPORT: OnceLock<Report> = OnceLock::new();
    REPORT.get_or_init(|| {
        let ledger = claims::ledger().unwrap();
        let ids = ledger.select(&[], &[]).unwrap();
        ledger.verify(&ids, &Options::default(), |_| {})
    })
}

#[test]
fn every_claim_is_as_recorded() {
    let ledger = claims::ledger().unwrap();
    let ids = ledger.select(&[], &[]).unwrap();
    let (report, options) = (report(), Options::default());
    assert_eq!(report.differences, Vec::<String>::new());
    assert!(report.is_as_recorded());
    let document: serde_json::Value = serde_json::from_str(&to_json(report, &options)).unwrap();
    assert_eq!(document["schema"], "flockproof.ledger/2");
    assert_eq!(document["claims"].as_array().map(Vec::len), Some(ids.len()));
    assert_eq!(super::statements::incomplete(&report.entries), Vec::<String>::new());
    // A proof on paper stands in a note.
    for evidence in report.entries.iter().flat_map(|entry| &entry.evidence).filter(|e| e.grade == Grade::Argued) {
        let note = evidence.detail.split("notes/").nth(1).and_then(|rest| rest.split(".md").next());
        // That there is a note of this name is seen where the notes are: in the documents' tests.
        assert!(note.is_some_and(|name| !name.is_empty()), "{}", evidence.detail);
    }
    // What is true instead of a printed statement is a claim that holds.
    for (printed, corrected) in report.entries.iter().filter_map(|entry| Some((&entry.id, entry.corrected.as_ref()?))) {
        match report.entries.iter().find(|entry| entry.id == correction_id(printed)) {
            Some(own) => assert_eq!((own.verdict, &own.statement), (Verdict::Holds, corrected)),
            None => assert!(WITHOUT_OWN_CLAIM.contains(&printed.as_str()), "{printed}: the correction is not a claim"),
        }
    }
}

/// Where printed statements fail: a check that comes to another place, which may be none, is noticed, though the verdict is the same.
#[test]
fn counterexamples_are_as_recorded() {
    let told = report().entries.iter().filter_map(|entry| Some((entry.id.as_str(), entry.counterexample.as_deref()?)));
    let recorded: BTreeMap<&str, &str> =
        include_str!("counterexamples.tsv").lines().skip(1).filter_map(|row| row.split_once('\t')).collect();
    let told: BTreeMap<&str, &str> = told.collect();
    for (id, counterexample) in &told {
        assert_eq!(recorded.get(id), Some(counterexample), "{id}");
    }
    assert_eq!(told.len(), recorded.len());
}

/// Every row of the table of evidence is read, is about a claim, and rests on cases where cases are counted.
#[test]
fn recorded_evidence_is_in_order() {
    let (ledger, mut seen) = (claims::ledger().unwrap(), BTreeSet::new());
    for row in EVIDENCE.lines().skip(1) {
        let [id, _, grade, _, _, _, cases, full] = row.split('\t').collect::<Vec<_>>()[..] else { panic!("{row}") };
        assert!(ledger.ids().any(|own| own == id), "{row}");
        seen.insert(id);
        for count in [cases, full] {
            let counted = ["identity", "exhaustive", "fuzzed"].contains(&grade) && count != "absent";
            assert!(count.parse::<u64>().map_or(["-", "absent"].contains(&count) && !counted, |n| n > 0), "{row}");
        }
    }
    let without: Vec<&str> = ledger.ids().filter(|id| !seen.contains(id)).collect();
    let bare: Vec<&str> = recorded(RECORDED).filter(|row| row.grades.is_empty()).map(|row| row.id).collect();
    assert_eq!(without, bare);
}

#[test]
fn wrong_names_are_refused() {
    let ledger = claims::ledger().unwrap();
    let select = |papers: &[&str], claims: &[&str]| {
        let own = |names: &[&str]| names.iter().map(|s| s.to_string()).collect::<Vec<_>>();
        ledger.select(&own(papers), &own(claims))
    };
    assert!(matches!(select(&["reynolds"], &[]), Err(LedgerError::NoPaper(..))));
    assert_eq!(select(&[], &["veerman.lem99"]), Err(LedgerError::Unknown("veerman.lem99".into())));
    let nothing_built = Ledger::new().with_list(LISTED).select(&[], &["tanner1.eq2".to_string()]);
    assert_eq!(nothing_built, Err(LedgerError::NotBuilt("tanner1.eq2".into())));
    assert_eq!(select(&[], &["veerman.lem2"]), Ok(vec!["veerman.lem2".to_string()]));
    assert!(select(&["paley"], &[]).is_ok_and(|ids| ids.contains(&"paley.eq7".to_string())));
}

#[test]
fn every_coq_theorem_is_about_a_claim() {
    let ledger = claims::ledger().unwrap();
    let ids: BTreeSet<&str> = ledger.ids().collect();
    for theorem in proofs::kernel::theorems() {
        assert!(ids.contains(theorem.claim), "{} is not a claim of the ledger", theorem.claim);
    }
}
