use campaign::fuzz::one_case;
use campaign::invariants::{Stop, Tested, table};

/// The whole table with few cases; a campaign is the same with many.
#[test]
fn all_invariants_hold() {
    for invariant in table() {
        let cases = (invariant.block / 4).clamp(3, 40);
        let mut decided = 0;
        for case in 0..cases {
            match one_case(invariant, "test", case, Tested::AsItIs).0 {
                Err(Stop::Fails { why, instance }) => panic!("{}, case {case}: {why}\n{instance}", invariant.id),
                Err(Stop::Undecided(_)) => {}
                Ok(margin) => {
                    decided += 1;
                    assert!(margin.is_none_or(|margin| margin >= 0.0), "{}: {margin:?}", invariant.id);
                }
            }
        }
        assert!(2 * decided >= cases, "{}: only {decided} of {cases} cases are decided", invariant.id);
    }
}

/// Every invariant has a planted fault, and the same check finds it.
#[test]
fn every_planted_fault_is_found() {
    for invariant in table() {
        let found = (0..400).any(|case| {
            let (checked, _) = one_case(invariant, "test", case, Tested::Altered);
            matches!(checked, Err(Stop::Fails { why, .. }) if !why.contains("panics"))
        });
        assert!(found, "{}: {} is not found", invariant.id, invariant.control);
    }
}

#[test]
fn names_are_different_and_told() {
    let mut names: Vec<&str> = table().map(|invariant| invariant.id).collect();
    names.sort_unstable();
    assert!(names.windows(2).all(|pair| pair[0] != pair[1]));
    assert!(table().all(|i| !i.statement.is_empty() && !i.control.is_empty() && i.block > 0));
}
