//! The separate checker follows the worst motions itself, and refuses what was altered.

use super::{decided, read};
use arithmetic::{parse_rational, rational};
use flockproof_checker::check;
use reach::certificate;

fn written(text: &str) -> String {
    let found = decided(text, 10);
    certificate(&read(text), found[0].decisive()).expect("a motion")
}

const OSCILLATOR: &str = "[system]\nstates = [\"x\", \"v\"]\ninputs = { u = [-1, 1], w = { box = [0, \"1/2\"], constant = true } }\nstart = { x = 0, v = [0, \"1/3\"] }\n\
    [[mode]]\nname = \"only\"\nA = [[0, 1], [-1, \"-1/5\"]]\nB = [[0, 0], [1, 1]]\nc = [0, \"1/7\"]\n[run]\nuntil = 9\n[[check]]\nholds = \"x <= 1\"\n";

#[test]
fn motions_are_followed_again() {
    let platoon = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/systems/platoon_plad01.toml"))
        .expect("a file");
    for text in [OSCILLATOR, &platoon] {
        let certificate = written(text);
        let certified = check(certificate.as_bytes()).unwrap_or_else(|refusal| panic!("{refusal:?}\n{certificate}"));
        assert_eq!(certified.kind, "motion");
    }
    let certificate = written(&platoon);
    let bound = certificate.lines().find_map(|line| line.strip_prefix("bound ")).expect("a bound");
    let bound = parse_rational(bound).expect("a number");
    assert!(bound > rational(268, 10) && bound < rational(269, 10), "{bound}");
}

#[test]
fn what_is_altered_is_refused() {
    let good = written(OSCILLATOR);
    let line = |name: &str| good.lines().position(|line| line.starts_with(name)).expect("a line");
    let altered = |at: usize, to: &str| {
        let mut lines: Vec<&str> = good.lines().collect();
        lines[at] = to;
        let text = lines.join("\n") + "\n";
        check(text.as_bytes()).expect_err(to).reason
    };
    let bound = good.lines().nth(line("bound")).expect("a line").trim_start_matches("bound ").to_string();
    let beyond = good.replace(&bound, &format!("{}", bound.len() * 1000));
    assert!(check(beyond.as_bytes()).expect_err("beyond").reason.contains("does not come beyond the bound"));
    assert!(altered(line("u over") + 1, "4 0").contains("an input is not within its bounds"));
    assert!(altered(line("start over") + 1, "9 0").contains("the start is not within its bounds"));
    assert!(altered(line("time"), "time 0").contains("a time is not positive"));
    assert!(altered(line("time"), "time 100000").contains("too many steps"));
    assert!(altered(line("claim"), "claim all is well").contains("what is shown is"));
}
