//! Bad input: one sentence with its line.

use super::one_mode;
use arithmetic::{Cancelled, Progress, Unwatched};
use reach::{ReachError, System, decide};

fn good() -> String {
    one_mode(
        "[\"x\", \"v\"]",
        "{ u = [-1, 1] }",
        "{ x = 0, v = 0 }",
        "[[0, 1], [-1, -1]]",
        "[[0], [1]]",
        "2",
        &["x <= 2"],
    )
}

fn refused(from: &str, to: &str) -> String {
    let text = good().replacen(from, to, 1);
    assert_ne!(text, good(), "{from} is there");
    System::read(&text).expect_err(to).to_string()
}

#[test]
fn each_fault_is_named_with_its_line() {
    for (from, to, said) in [
        ("\"v\"]", "\"x\"]", "line 2: `system.states, entry 2`: it must be another name than `x`, which is taken"),
        ("[-1, 1]", "[1, -1]", "line 3: `system.inputs.u`: it must be an interval, but [1, -1] is empty"),
        ("[-1, 1]", "[1, 2, 3]", "it must be a number or a list of two, not of 3"),
        ("v = 0", "w = 0", "there is no key `w` in [system.start] (the states); allowed are x, v"),
        ("x = 0, ", "", "it must be a table with every state, but `x` is missing"),
        ("[[0, 1], [-1, -1]]", "[[0, 1]]", "line 7: `mode.A`: it must be a list of 2 rows, one for each state, not 1"),
        ("[-1, -1]]", "[-1]]", "it must be a list of 2 numbers, not 1"),
        ("[[0], [1]]", "[[0], [1, 2]]", "line 8: `mode.B, entry 2`: it must be a list of 1 numbers, not 2"),
        ("until = 2", "until = -2", "line 10: `run.until`: it must be a time that is not negative, or \"inf\""),
        ("x <= 2", "y <= 2", "line 12, column 10: `check.holds`: there is no state `y`"),
        (
            "x <= 2",
            "x*v <= 2",
            "something linear in the states is expected here, but it is a product or quotient of states",
        ),
        ("x <= 2", "x = 2", "`<`, `<=`, `>` or `>=` is expected here, but it is `=`"),
        ("x <= 2", "1 <= 2", "a state on one side is expected here, but it is numbers on both"),
        ("x <= 2", "x/0 <= 2", "a divisor other than 0 is expected here, but it is 0"),
        ("x <= 2", "x <= 2 or v <= 1", "inequalities between states, joined by `and` is expected here, but it is `or`"),
        (
            "[run]",
            "[switching]\nkind = \"periodic\"\norder = [\"only\"]\nperiod = 0\n[run]",
            "line 12: `switching.period`: it must be a time above 0",
        ),
        (
            "[run]",
            "[switching]\nkind = \"periodic\"\norder = [\"other\"]\nperiod = 1\n[run]",
            "`other` is not known; allowed are only",
        ),
        (
            "[run]",
            "[switching]\nkind = \"windows\"\norder = [\"only\", \"only\"]\nwindows = []\n[run]",
            "it must be a list of 1 intervals, one for each switch, not 0",
        ),
        (
            "[run]",
            "[switching]\nkind = \"dwell\"\nat_least = { only = 2 }\nat_most = { only = 1 }\n[run]",
            "it must be a time from 2 on",
        ),
        (
            "[run]",
            "[switching]\nkind = \"dwell\"\nat_least = 2\n[run]",
            "it must be a table with times of modes, such as { only = 2 }",
        ),
        ("name = \"only\"", "name = \"on ly\"", "it must be a name of letters and digits"),
    ] {
        let error = refused(from, to);
        assert!(error.contains(said), "{error}\ninstead of\n{said}");
    }
    let many = format!("[{}]", (0..3000).map(|i| format!("\"x{i}\"")).collect::<Vec<_>>().join(", "));
    let error = refused("[\"x\", \"v\"]", &many);
    assert!(error.contains("it must be a list of 1 to 200 names, not 3000"), "{error}");
}

#[test]
fn unbounded_time_needs_stable_modes() {
    let text = good().replacen("until = 2", "until = \"inf\"", 1).replacen("[-1, -1]]", "[-1, 1]]", 1);
    let system = System::read(&text).expect("a system");
    let error = decide(&system, 10, &Unwatched).expect_err("unstable");
    assert!(matches!(&error, ReachError::Unstable { mode, growth } if mode == "only" && *growth > 0.49), "{error}");
    // On the verge is not stable either.
    let text = text.replacen("[-1, 1]]", "[-1, 0]]", 1);
    assert!(matches!(
        decide(&System::read(&text).expect("a system"), 10, &Unwatched),
        Err(ReachError::Unstable { .. })
    ));
}

struct Stopped;

impl Progress for Stopped {
    fn is_cancelled(&self) -> bool {
        true
    }
}

#[test]
fn work_can_be_stopped_and_is_not_begun_where_it_is_too_long() {
    let system = System::read(&good()).expect("a system");
    assert_eq!(decide(&system, 10, &Stopped).expect_err("stopped"), ReachError::Cancelled(Cancelled));
    let long = System::read(&good().replacen("until = 2", "until = 1e9", 1)).expect("a system");
    assert!(matches!(decide(&long, 10, &Unwatched), Err(ReachError::TooLong { .. })));
}

/// What is refused for its size is not read to its end, which here cannot be read at all.
#[test]
fn too_many_states_are_refused_before_the_matrices_are_read() {
    let names: Vec<String> = (0..3000).map(|i| format!("\"x{i}\"")).collect();
    let text = format!("[system]\nstates = [{}]\nstart = {{}}\n\n[[mode]]\nA = [[0, 1", names.join(", "));
    let error = System::read(&text).expect_err("too many").to_string();
    assert_eq!(error, "line 2: `system.states`: it must be a list of 1 to 200 names, not 3000");
    // Wherever the section stands.
    let text = format!("[[mode]]\nA = [[0, 1\n[system]\nstates = [{}]\nstart = {{}}\n", names.join(", "));
    let error = System::read(&text).expect_err("too many states").to_string();
    assert_eq!(error, "line 4: `system.states`: it must be a list of 1 to 200 names, not 3000");
}
