//! The separate checker follows the worst motions itself, and refuses what was altered.

use super::{decided, read};
use arithmetic::Unwatched;
use arithmetic::{parse_rational, rational};
use flockproof_checker::check;
use reach::{Unbounded, bounded, certificate};

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

fn bound_of(text: &str) -> Result<String, Unbounded> {
    bounded(&read(text), &decided(text, 6), &Unwatched)
}

/// The same system with other checks.
fn asking(text: &str, checks: &[&str]) -> String {
    let head = text.split("[[check]]").next().expect("a part");
    checks.iter().fold(head.to_string(), |text, check| text + &format!("[[check]]\nholds = \"{check}\"\n"))
}

const SWITCHED: &str = "[system]\nstates = [\"x\", \"v\"]\ninputs = { u = [-1, \"1/2\"] }\nstart = { x = [0, \"1/10\"], v = 0 }\n\
    [[mode]]\nname = \"a\"\nA = [[0, 1], [-2, -2]]\nB = [[0], [1]]\n[[mode]]\nname = \"b\"\nA = [[0, 1], [-3, -2]]\nB = [[0], [2]]\nc = [0, \"1/5\"]\n\
    [switching]\nkind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = \"3/2\"\n[run]\nuntil = 8\n[[check]]\nholds = \"x <= 9\"\n";

#[test]
fn bounds_from_above_are_shown_again() {
    let platoon = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/systems/platoon_plad01.toml"))
        .expect("a file");
    for text in [OSCILLATOR, SWITCHED] {
        // A bound above the worst case by a thousandth of it is shown, both ways.
        for side in ["x", "-x"] {
            let (_, hi) = super::worst(&asking(text, &[&format!("{side} <= 0")]), 6);
            let near = hi * rational(1001, 1000) + rational(1, 1000);
            let certificate = bound_of(&asking(text, &[&format!("{side} <= {near}")])).expect("a proof");
            assert_eq!(check(certificate.as_bytes()).expect("accepted").kind, "bound");
        }
    }
    let certificate = bound_of(&platoon).expect("a proof");
    assert_eq!(check(certificate.as_bytes()).expect("accepted").kind, "bound");
}

#[test]
fn any_order_of_modes_is_bounded() {
    let text =
        SWITCHED.replace("kind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = \"3/2\"", "kind = \"arbitrary\"");
    let (_, hi) = super::worst(&asking(&text, &["x <= 0"]), 6);
    let near = hi * rational(102, 100);
    let certificate = bound_of(&asking(&text, &[&format!("x <= {near}"), "v >= -40"])).expect("a proof");
    assert!(certificate.contains("order any"), "{certificate}");
    // Disturbances that are assumed to be smaller than they are.
    let line = certificate.lines().position(|line| line.starts_with("disturbance over")).expect("a line");
    let mut lines: Vec<String> = certificate.lines().map(str::to_string).collect();
    lines[line] = "disturbance over 1000000".to_string();
    lines[line + 1] = "0 1".to_string();
    let refusal = check((lines.join("\n") + "\n").as_bytes()).expect_err("too small");
    assert!(refusal.reason.contains("not shown to stay below"), "{refusal:?}");
}

#[test]
fn bounds_that_are_altered_are_refused() {
    let certificate = bound_of(SWITCHED).expect("a proof");
    // What is attained is never shown to be avoided, whatever the steps.
    let (lo, _) = super::worst(&asking(SWITCHED, &["x <= 0"]), 6);
    let line = |name: &str| certificate.lines().position(|line| line.starts_with(name)).expect("a line");
    let altered = |changes: &[(usize, String)]| {
        let mut lines: Vec<String> = certificate.lines().map(str::to_string).collect();
        changes.iter().for_each(|(at, to)| lines[*at].clone_from(to));
        check((lines.join("\n") + "\n").as_bytes()).expect_err("altered").reason
    };
    let below = &lo - rational(1, 1_000_000_000);
    let tight = [
        (line("bound over"), format!("bound over {}", below.denom())),
        (line("bound over") + 1, below.numer().to_string()),
    ];
    let lines: Vec<usize> =
        certificate.lines().enumerate().filter(|(_, line)| line.starts_with("steps ")).map(|(at, _)| at).collect();
    for steps in [20, 200] {
        let mut changes = tight.to_vec();
        changes.extend(lines.iter().map(|at| (*at, format!("steps {steps}"))));
        assert!(altered(&changes).contains("row 1 is not shown"), "{steps}");
    }
    assert!(altered(&[(line("steps"), "steps 1".to_string())]).contains("the steps are too long"));
    assert!(altered(&[(line("input_most over") + 1, "-9".to_string())]).contains("has no values"));
    assert!(altered(&[(line("time"), "time 0".to_string())]).contains("not positive"));
}

#[test]
fn what_cannot_be_bounded_is_named() {
    let refused = |text: &str| bound_of(text).expect_err("refused").to_string();
    assert!(refused(&asking(SWITCHED, &["x <= 1/1000"])).contains("no check"));
    assert!(
        refused(&OSCILLATOR.replace("until = 9", "until = \"inf\"").replace("x <= 1", "x <= 99"))
            .contains("up to a time")
    );
    let (_, hi) = super::worst(&asking(OSCILLATOR, &["x <= 0"]), 10);
    let near = hi + rational(1, 1_000_000_000);
    assert!(refused(&asking(OSCILLATOR, &[&format!("x <= {near}")])).contains("too near"));
}
