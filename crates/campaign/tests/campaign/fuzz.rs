use arithmetic::Unwatched;
use campaign::fuzz::{Again, Failed, Fuzz, FuzzError, Replay, Summary, one_case};
use campaign::invariants::{Stop, Tested, find};
use campaign::job::Campaign;
use campaign::store::run_in_memory;

fn names(list: &[&str]) -> Vec<String> {
    list.iter().map(ToString::to_string).collect()
}

#[test]
fn campaigns_are_read_from_their_canonical_text() {
    let fuzz = Fuzz::new(&names(&["matrix.inverse", "matrix.tau_1_twin"]), 750, "x").unwrap();
    let again = Fuzz::read(&fuzz.canonical()).unwrap();
    assert_eq!(again.canonical(), fuzz.canonical());
    assert_eq!((again.cases(), again.seed()), (fuzz.cases(), "x"));
    assert!(matches!(Fuzz::read("{}"), Err(FuzzError::NoFuzz)));
    assert!(matches!(Fuzz::new(&names(&["nonsense"]), 1, "0"), Err(FuzzError::Unknown(..))));
    assert!(matches!(Fuzz::new(&[], 0, "0"), Err(FuzzError::Cases(0))));
}

/// The last job of an invariant is shorter, and every case is tried once.
#[test]
fn every_case_is_tried_once() {
    let fuzz = Fuzz::new(&names(&["matrix.tau_1_twin", "matrix.tau_1_of_products"]), 1201, "0").unwrap();
    let run = run_in_memory(&fuzz, &Unwatched).unwrap();
    assert!(run.is_complete());
    let summary = Summary::new(&fuzz.names(), fuzz.seed(), run.cases, &run.rows).unwrap();
    assert_eq!((summary.cases(), summary.failed(), summary.missing), (2402, 0, 0));
    let margin = summary.invariants.iter().find_map(|own| own.margin).unwrap();
    let invariant = find("matrix.tau_1_of_products").unwrap();
    assert_eq!(one_case(invariant, "0", margin.case, Tested::AsItIs).0, Ok(Some(margin.value)));
}

#[test]
fn a_replay_decides_the_same_case() {
    let invariant = find("matrix.tau_1_of_products").unwrap();
    let (checked, draws) = one_case(invariant, "0", 7, Tested::AsItIs);
    let failed = Failed { case: 7, draws, why: "none".to_string(), instance: "none".to_string(), question: None };
    let replay = Replay::read(&Replay::text(invariant.id, &failed)).unwrap();
    assert_eq!(replay.decide(), checked);
    assert_eq!(replay.compared(&checked), Again::NoMore);
    let fails = |why: &str| Err(Stop::Fails { why: why.to_string(), instance: "none".to_string() });
    assert_eq!(replay.compared(&fails("none")), Again::Same);
    assert_eq!(replay.compared(&fails("another")), Again::Otherwise);
    assert_eq!(replay.compared(&Err(Stop::Undecided("open".to_string()))), Again::Undecided);
    for (text, named) in [
        ("[", "JSON"),
        ("{}", "schema"),
        ("{\"schema\": \"flockproof.replay/1\", \"version\": \"0.0.0\"}", "version 0.0.0"),
    ] {
        assert!(Replay::read(text).err().unwrap().to_string().contains(named));
    }
}
