//! The separate checker follows the worst motions itself, and refuses what was altered.

use super::{decided, read};
use arithmetic::Unwatched;
use arithmetic::{parse_rational, rational};
use flockproof_checker::check;
use reach::{Unbounded, Unshown, bounded, certificate};

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

/// Where the checker would refuse it, there is no certificate and a sentence that says so.
#[test]
fn motions_that_the_checker_does_not_follow_are_not_written() {
    let text = "[system]\nstates = [\"x\"]\ninputs = { k = { box = [0, 1], constant = true } }\nstart = { x = 0 }\n[[mode]]\nname = \"only\"\nA = [[-1]]\nB = [[1]]\n\
        [run]\nuntil = 3000\n[[check]]\nholds = \"x <= 1/2\"\nat = 3000\n";
    let found = decided(text, 10);
    let error = certificate(&read(text), found[0].decisive()).expect_err("too long");
    assert_eq!(
        error.to_string(),
        "the checker does not follow the motion that was found, 3000 units of time long: a stretch takes too many steps"
    );
    let at_once = text.replace("at = 3000", "at = 0");
    let found = decided(&at_once, 10);
    assert_eq!(certificate(&read(&at_once), found[0].decisive()), Err(Unshown::Missing));
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
    assert!(refused(&asking(&OSCILLATOR.replace("until = 9", "until = 0"), &["x <= 99"])).contains("above 0"));
    let (_, hi) = super::worst(&asking(OSCILLATOR, &["x <= 0"]), 10);
    let near = hi + rational(1, 1_000_000_000);
    assert!(refused(&asking(OSCILLATOR, &[&format!("x <= {near}")])).contains("too near"));
}

/// The certificate of a bound above the worst case by this share of it.
fn near_to_the_worst(text: &str, row: &str, share: arithmetic::Rational) -> String {
    let (_, hi) = super::worst(&asking(text, &[&format!("{row} <= 0")]), 6);
    let near = &hi + hi.clone() * share;
    bound_of(&asking(text, &[&format!("{row} <= {near}")])).unwrap_or_else(|error| panic!("{error}: {near}\n{text}"))
}

fn for_ever(text: &str) -> String {
    let (head, tail) = text.split_once("until = ").expect("a time");
    let (_, rest) = tail.split_once('\n').expect("a line");
    format!("{head}until = \"inf\"\n{rest}")
}

const ANY: &str = "kind = \"arbitrary\"";
const PERIODIC: &str = "kind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = \"3/2\"";

#[test]
fn time_without_end_is_bounded() {
    for (text, order) in [
        (for_ever(OSCILLATOR), "order given for ever\nstretches 1\n"),
        (for_ever(SWITCHED), "order given for ever\nstretches "),
        (for_ever(&SWITCHED.replace(PERIODIC, ANY)), "order any for ever\n"),
        (for_ever(&SWITCHED.replace(PERIODIC, "kind = \"dwell\"\nat_least = { a = 2 }")), "order any for ever\n"),
    ] {
        for row in ["x", "-v"] {
            let certificate = near_to_the_worst(&text, row, rational(2, 100));
            assert!(certificate.contains(order), "{certificate}");
            assert_eq!(check(certificate.as_bytes()).expect("accepted").kind, "bound");
        }
    }
}

#[test]
fn durations_that_are_free_are_bounded_with_any_order() {
    for switching in [
        "kind = \"windows\"\norder = [\"a\", \"b\", \"a\"]\nwindows = [[1, 2], [3, 4]]",
        "kind = \"dwell\"\nat_least = { a = 2, b = 1 }\nat_most = { b = 2 }",
    ] {
        // Any order bounds these, and so do bounds of any order.
        let (_, hi) = super::worst(&asking(&SWITCHED.replace(PERIODIC, ANY), &["x <= 0"]), 6);
        let near = hi * rational(102, 100);
        let certificate = bound_of(&asking(&SWITCHED.replace(PERIODIC, switching), &[&format!("x <= {near}")]));
        assert!(certificate.expect("a proof").contains("order any\n"));
    }
}

#[test]
fn bounds_for_ever_that_are_altered_are_refused() {
    let periodic = near_to_the_worst(&for_ever(SWITCHED), "x", rational(2, 100));
    let any = near_to_the_worst(&for_ever(&SWITCHED.replace(PERIODIC, ANY)), "x", rational(2, 100));
    let altered = |certificate: &str, from: &str, to: &str| {
        let at = certificate.lines().position(|line| line.starts_with(from)).expect(from);
        let mut lines: Vec<String> = certificate.lines().map(str::to_string).collect();
        let rows = to.split('\n').count();
        lines.splice(at..at + rows, to.split('\n').map(str::to_string));
        check((lines.join("\n") + "\n").as_bytes()).expect_err(to).reason
    };
    for certificate in [&periodic, &any] {
        // A box that motions leave, and one from which they come too far.
        assert!(altered(certificate, "box over", "box over 1000\n1 1").contains("not shown to stay in the box"));
        assert!(altered(certificate, "box over", "box over 1\n1000000 1000000").contains("not shown to stay"));
        assert!(altered(certificate, "box over", "box over 1\n0 1").contains("not positive"));
        assert!(altered(certificate, "box over", "box over 1\n-9 1").contains("not positive"));
        assert!(altered(certificate, "bound over", "bound over 1000\n1").contains("row 1 is not shown"));
        assert!(altered(certificate, "claim", "claim all is well").contains("what is shown is"));
        // Time that is too short to forget.
        assert!(altered(certificate, "time", "time 1/100\nsteps 4").contains("not"));
    }
    assert!(altered(&periodic, "cycle", "cycle 1").contains("not those of a cycle earlier"));
    assert!(altered(&periodic, "cycle", "cycle 0").contains("a number from 1"));
    assert!(altered(&periodic, "order", "order for ever").contains("is expected"));
    // What is attained is never shown to be avoided.
    let (lo, _) = super::worst(&asking(&for_ever(SWITCHED), &["x <= 0"]), 6);
    let below = format!("bound over {}\n{}", lo.denom(), lo.numer());
    assert!(altered(&periodic, "bound over", &below).contains("row 1 is not shown"));
}

/// Modes that grow by themselves and are stable in turn only.
#[test]
fn modes_that_are_stable_in_turn_only() {
    let turning = "[system]\nstates = [\"x\", \"y\"]\nstart = { x = 1, y = 0 }\n[[mode]]\nname = \"a\"\nA = [[\"-3/2\", 0], [0, \"1/2\"]]\n\
        [[mode]]\nname = \"b\"\nA = [[\"1/2\", 0], [0, \"-3/2\"]]\n[switching]\nkind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = 1\n\
        [run]\nuntil = \"inf\"\n[[check]]\nholds = \"x <= 2\"\n";
    if let Ok(certificate) = bound_of(turning) {
        assert!(certificate.contains("order given for ever"), "{certificate}");
        // In another order the same modes grow.
        let wrong = certificate.replacen("mode 2\n", "mode 1\n", 1);
        assert!(check(wrong.as_bytes()).is_err());
    }
}

/// Where limits for each state leave too much, polygons for pairs of states are certified.
#[test]
fn disturbances_of_two_states_are_bounded_together() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/systems/platoon_plad01.toml"))
        .expect("a file");
    let (modes, _) = text.split_once("[switching]").expect("modes");
    let head = format!("{modes}[switching]\n{ANY}\n[run]\nuntil = 20\n");
    let certificate = bound_of(&format!("{head}[[check]]\nholds = \"e3 >= -25\"\n")).expect("a proof");
    assert_eq!(check(certificate.as_bytes()).expect("accepted").kind, "bound");
    let line = certificate.lines().position(|line| line.starts_with("edge over")).expect("edges");
    let altered = |rows: &[(usize, &str)]| {
        let mut lines: Vec<String> = certificate.lines().map(str::to_string).collect();
        rows.iter().for_each(|(row, to)| lines[line + row] = (*to).to_string());
        check((lines.join("\n") + "\n").as_bytes()).expect_err("altered").reason
    };
    // A set that is too small, an edge through three states, one that joins another pair.
    assert!(altered(&[(1, "0 0 1 0 0 0 0 0 0")]).contains("not shown to stay below"));
    assert!(altered(&[(1, "1 0 1 0 0 1 0 0 0")]).contains("edge 1 does not lead"));
    assert!(altered(&[(1, "0 0 0 0 0 1 0 0 1")]).contains("edge 2 does not lead"));
    let flat: Vec<(usize, &str)> = (1..=8).map(|row| (row, "0 0 1 0 0 1 0 0 0")).collect();
    assert!(altered(&flat).contains("are parallel"));
}

const WINDOWS: &str = "kind = \"windows\"\norder = [\"a\", \"b\", \"a\"]\nwindows = [[1, 2], [3, 4]]";
const DWELL: &str = "kind = \"dwell\"\nat_least = { a = 2, b = 1 }\nat_most = { b = 2 }";

/// Nearer to the worst case than what any switching does, and never below what is attained.
#[test]
fn windows_are_bounded_by_what_they_allow() {
    let text = SWITCHED.replace(PERIODIC, WINDOWS);
    let certificate = bound_of(&asking(&text, &["x <= 11/20"])).expect("a proof");
    assert!(certificate.contains("order free\n"), "{certificate}");
    let found = decided(&asking(&text, &["x <= 11/20"]), 6);
    let attained = found[0].decisive().lo.clone().expect("a witness");
    let at = certificate.lines().position(|line| line.starts_with("bound over")).expect("a line");
    let mut lines: Vec<String> = certificate.lines().map(str::to_string).collect();
    let below = attained - rational(1, 1_000_000_000);
    (lines[at], lines[at + 1]) = (format!("bound over {}", below.denom()), below.numer().to_string());
    let refusal = check((lines.join("\n") + "\n").as_bytes()).expect_err("attained");
    assert!(refusal.reason.contains("row 1 is not shown"), "{refusal:?}");
    // Later windows than those that it is about.
    let later = certificate.replace("window 3 4", "window 3 8");
    assert!(check(later.as_bytes()).is_err());
}

/// A motion is followed only where its modes follow each other as the switching allows.
#[test]
fn orders_that_are_not_allowed_are_refused() {
    for (switching, changes) in [
        (WINDOWS, [("turns 1 2 1", "turns 2 1 2"), ("window 1 2", "window 0 1/100"), ("window 3 4", "window 7 8")]),
        (DWELL, [("stay 2 none", "stay 0 1/100"), ("stay 2 none", "stay 8 none"), ("stay 1 2", "stay 0 1/100")]),
        (PERIODIC, [("turns 1 2", "turns 2 1"), ("period 3/2", "period 1"), ("until 8", "until 1/100")]),
    ] {
        let good = written(&SWITCHED.replace(PERIODIC, switching));
        assert!(good.contains("its modes for the times below, as the switching below allows"), "{good}");
        for (from, to) in changes {
            assert!(good.contains(from), "{from}: {good}");
            let refusal = check(good.replace(from, to).as_bytes()).expect_err(to).reason;
            assert!(refusal.contains("does not allow") || refusal.contains("last longer"), "{to}: {refusal}");
        }
    }
}

/// A bound by one order of modes says nothing where others are allowed.
#[test]
fn one_order_of_modes_is_no_bound_of_others() {
    for text in [SWITCHED.to_string(), for_ever(SWITCHED)] {
        let certificate = bound_of(&asking(&text, &["x <= 9"])).expect("a proof");
        for (from, to) in [
            ("switching periodic\nturns 1 2\nperiod 3/2\n", "switching any\n"),
            ("switching periodic\nturns 1 2\nperiod 3/2\n", "switching dwell\nfirst any\nstay 0 none\nstay 0 none\n"),
            ("turns 1 2\n", "turns 2 1\n"),
            ("turns 1 2\n", "turns 1 2 2\n"),
            ("period 3/2", "period 3/4"),
        ] {
            assert!(certificate.contains(from), "{from}: {certificate}");
            assert!(check(certificate.replace(from, to).as_bytes()).is_err(), "{to}");
        }
    }
    let certificate = bound_of(&asking(SWITCHED, &["x <= 9"])).expect("a proof");
    let longer = certificate.replace("until 8", "until 9");
    assert!(check(longer.as_bytes()).expect_err("longer").reason.contains("do not last as long"));
}
