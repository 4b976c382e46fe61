//! Cases at the edge: matrices that are zero, nilpotent or defective, inputs and starts of no width, switches that change nothing or come too late.

use super::{close, decided, number, one_mode, read, worst};
use arithmetic::{Enclosure, Number, Rational, Ring, Unwatched, rational};
use reach::{System, Verdict, decide};

/// Modes by name with `A` and `B`, of states x, y, ..; one input u in [-1, 1].
fn system(states: &[&str], start: &str, modes: &[(&str, &str, &str)], rest: &str) -> String {
    let names: Vec<String> = states.iter().map(|name| format!("\"{name}\"")).collect();
    let mut text =
        format!("[system]\nstates = [{}]\ninputs = {{ u = [-1, 1] }}\nstart = {{ {start} }}\n", names.join(", "));
    for (name, a, b) in modes {
        text += &format!("[[mode]]\nname = \"{name}\"\nA = {a}\nB = {b}\n");
    }
    text + rest
}

fn overlap(a: &(Rational, Rational), b: &(Rational, Rational)) -> bool {
    a.0 <= b.1 && b.0 <= a.1
}

#[test]
fn nilpotent_and_defective_matrices_have_their_closed_forms() {
    // x''' = u: t^3 / 6.
    let nilpotent = system(
        &["x", "v", "w"],
        "x = 0, v = 0, w = 0",
        &[("m", "[[0, 1, 0], [0, 0, 1], [0, 0, 0]]", "[[0], [0], [1]]")],
        "[run]\nuntil = 3\n[[check]]\nholds = \"x <= 9\"\n",
    );
    close(&worst(&nilpotent, 12), &number("9/2"), 12);
    // (s - 1)^2, unstable and defective: the integral of r e^r is (t - 1) e^t + 1.
    let unstable = system(
        &["x", "v"],
        "x = 0, v = 0",
        &[("m", "[[1, 1], [0, 1]]", "[[0], [1]]")],
        "[run]\nuntil = 5\n[[check]]\nholds = \"x >= -9\"\n",
    );
    let exact = -(number("4") * number("5").exp().expect("finite") + number("1"));
    let found = worst(&unstable, 12);
    let (lo, hi) = exact.ends().expect("bounded");
    assert!(found.0 <= hi && lo <= found.1 && &found.1 - &found.0 < rational(1, 100_000_000), "{found:?} {exact}");
    // (s^2 + 1)^2: x = r sin r is driven by an impulse of x'' + x = y, y'' + y = 2 cos: here the response (sin r - r cos r) / 2.
    let resonant = system(
        &["x", "v", "y", "w"],
        "x = 0, v = 0, y = 0, w = 0",
        &[("m", "[[0, 1, 0, 0], [-1, 0, 1, 0], [0, 0, 0, 1], [0, 0, -1, 0]]", "[[0], [0], [0], [1]]")],
        "[run]\nuntil = 4\n[[check]]\nholds = \"x <= 9\"\n",
    );
    // Its sign is kept up to 4.49: the integral is 1 - cos t - (t sin t) / 2.
    let (sin, cos) = (number("4").sin().expect("finite"), number("4").cos().expect("finite"));
    close(&worst(&resonant, 12), &(number("1") - cos - sin * number("2")), 12);
}

#[test]
fn switches_between_equal_modes_change_nothing() {
    let mode = ("a", "[[0, 1], [-1, -1]]", "[[0], [1]]");
    let equal = ("b", mode.1, mode.2);
    let of = |modes: &[(&str, &str, &str)], switching: &str, run: &str| {
        let rest = format!("{switching}\n[run]\n{run}\n");
        worst(&system(&["x", "v"], "x = [0, 0], v = [\"-1/10\", \"1/5\"]", modes, &rest), 9)
    };
    let check = "[[check]]\nholds = \"x <= 9\"";
    for run in [format!("until = 4\n{check}"), format!("until = 4\n{check}\nat = 3")] {
        let alone = of(&[mode], "", &run);
        for switching in [
            "kind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = \"3/2\"",
            "kind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = 100",
            "kind = \"windows\"\norder = [\"a\", \"b\", \"a\"]\nwindows = [[0, 1], [1, 2]]",
            "kind = \"windows\"\norder = [\"a\", \"b\"]\nwindows = [[3, 5]]",
            "kind = \"dwell\"\nat_least = { a = 2, b = 1 }\nat_most = { b = 2 }",
            "kind = \"arbitrary\"",
        ] {
            let found = of(&[mode, equal], &format!("[switching]\n{switching}"), &run);
            assert!(overlap(&alone, &found), "{switching} {run}: {found:?} instead of {alone:?}");
        }
    }
}

#[test]
fn at_a_switch_both_modes_agree() {
    let modes = [("a", "[[-1]]", "[[1]]"), ("b", "[[2]]", "[[5]]")];
    let at = |switching: &str, at: &str| {
        let rest = format!("[switching]\n{switching}\n[run]\nuntil = 6\n[[check]]\nholds = \"x <= 9\"\nat = {at}\n");
        worst(&system(&["x"], "x = 1", &modes, &rest), 12)
    };
    // Up to 3 only `a` is on: 1 throughout.
    close(&at("kind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = 3", "3"), &number("1"), 12);
    close(&at("kind = \"windows\"\norder = [\"a\", \"b\"]\nwindows = [3]", "3"), &number("1"), 12);
    close(&at("kind = \"dwell\"\nfirst = \"a\"\nat_least = { a = 3 }", "3"), &number("1"), 3);
    close(&at("kind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = 3", "0"), &number("1"), 12);
    // From 3 to 4 x' = 2 x + 5: 7/2 e^2 - 5/2.
    let grown = number("7/2") * number("2").exp().expect("finite") - number("5/2");
    close(&at("kind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = 3", "4"), &grown, 12);
}

#[test]
fn dwell_times_that_are_fixed_are_a_period() {
    let modes = [("a", "[[0, 1], [-2, -1]]", "[[0], [1]]"), ("b", "[[0, 1], [-1, 0]]", "[[0], [2]]")];
    let of = |switching: &str| {
        let rest = format!("[switching]\n{switching}\n[run]\nuntil = 5\n[[check]]\nholds = \"x <= 9\"\n");
        worst(&system(&["x", "v"], "x = 0, v = 0", &modes, &rest), 9)
    };
    let dwell = of("kind = \"dwell\"\nfirst = \"a\"\nat_least = { a = 2, b = 2 }\nat_most = { a = 2, b = 2 }");
    let period = of("kind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = 2");
    assert!(overlap(&dwell, &period), "{dwell:?} {period:?}");
}

#[test]
fn what_no_input_moves_is_exact() {
    for inputs in ["{ u = [0, 0] }", "{ u = 0 }", "{}"] {
        let b = if inputs == "{}" { "[[], []]" } else { "[[1], [0]]" };
        let checks = ["x <= 2", "x < 2", "x + y >= 3", "y > 1"];
        let still = one_mode("[\"x\", \"y\"]", inputs, "{ x = 2, y = 1 }", "[[0, 0], [0, 0]]", b, "7", &checks);
        let verdicts: Vec<Verdict> = decided(&still, 10).iter().map(|found| found.verdict).collect();
        assert_eq!(verdicts, [Verdict::Holds, Verdict::False, Verdict::Holds, Verdict::False], "{inputs}");
    }
}

/// A mode that has to end and that nothing can follow: there are no motions later, and so nothing to be said of them.
#[test]
fn a_mode_that_nothing_can_follow_is_refused() {
    let text = |most: &str, until: &str| {
        system(
            &["x"],
            "x = 0",
            &[("a", "[[1]]", "[[1]]")],
            &format!(
                "[switching]\nkind = \"dwell\"\nat_most = {{ a = {most} }}\n[run]\nuntil = {until}\n[[check]]\nholds = \"x <= 9\"\n"
            ),
        )
    };
    let error = System::read(&text("2", "10")).expect_err("it ends").to_string();
    assert!(error.contains("no other mode"), "{error}");
    assert!(System::read(&text("2", "\"inf\"")).is_err());
    assert!(decide(&read(&text("10", "10")), 5, &Unwatched).is_ok());
}

/// A greatest value that is attained all along, after a kink at its beginning, is enclosed to all digits.
#[test]
fn flat_greatest_values_are_enclosed_to_all_digits() {
    let text = "[system]\nstates = [\"x\", \"y\"]\ninputs = { u = [0, 1] }\nstart = { x = [-2, 0], y = 0 }\n[[mode]]\nname = \"a\"\nA = [[0, 0], [0, 0]]\nB = [[0], [0]]\n\
        [[mode]]\nname = \"b\"\nA = [[0, 0], [\"-1/4\", 0]]\nB = [[0], [1]]\n[switching]\nkind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = \"1/2\"\n\
        [run]\nuntil = \"5/4\"\n[[check]]\nholds = \"y >= 0\"\n";
    for digits in [9, 30] {
        let (lo, hi) = worst(text, digits);
        let small = rational(4, 1) * rational(1, 10).power(u64::from(digits));
        assert!(lo <= Rational::ZERO && hi >= Rational::ZERO && hi - lo <= small, "{digits}");
    }
}

fn verdicts(text: &str) -> Vec<Verdict> {
    decided(text, 10).iter().map(|found| found.verdict).collect()
}

/// Numbers that nothing moves are those of the start, also where they are no finite binary fractions.
#[test]
fn constants_are_the_same_in_every_check() {
    let checks = ["x + y <= 1/3", "y < 1/3", "y - x >= 1/3", "y > 1/3", "2*y <= 2/3"];
    let still =
        one_mode("[\"x\", \"y\"]", "{}", "{ x = 0, y = \"1/3\" }", "[[0, 0], [0, 0]]", "[[], []]", "8", &checks);
    let expected = [Verdict::Holds, Verdict::False, Verdict::Holds, Verdict::False, Verdict::Holds];
    assert_eq!(verdicts(&still), expected);
    assert_eq!(verdicts(&(still.clone() + "at = 8\n")), expected);
    assert_eq!(worst(&still, 10), (rational(1, 3), rational(1, 3)));
    let system = read(&still);
    let text = reach::answer::text(&system, &decide(&system, 10, &Unwatched).expect("answers"), 10);
    assert!(!text.contains("near it"), "{text}");
    // Exact numbers are shown as such.
    assert!(text.contains("greatest value 1/3 at t = 0"), "{text}");
    let later = read(&(still + "at = \"1/3\"\n"));
    let text = reach::answer::text(&later, &decide(&later, 10, &Unwatched).expect("answers"), 10);
    assert!(text.contains("2/3 at t = 1/3"), "{text}");
}

/// `x' = -x + u` from 0 comes near to 1 and -1 and never there; with more input it passes.
#[test]
fn a_supremum_that_is_not_attained_is_no_violation() {
    let checks = ["x < 1", "x <= 1", "x > -1", "x < 999999/1000000", "3*x < 3", "3*x < 2999999/1000000"];
    let of = |input: &str, until: &str| {
        one_mode("[\"x\"]", &format!("{{ u = {input} }}"), "{ x = 0 }", "[[-1]]", "[[1]]", until, &checks)
    };
    let (holds, fails) = (Verdict::Holds, Verdict::False);
    assert_eq!(verdicts(&of("[-1, 1]", "\"inf\"")), [holds, holds, holds, fails, holds, fails]);
    assert_eq!(verdicts(&of("[-1, 1]", "5")), [holds; 6]);
    let more = "[\"-1000001/1000000\", \"1000001/1000000\"]";
    assert_eq!(verdicts(&of(more, "\"inf\"")), [fails; 6]);
    // A start at the bound attains it.
    let from =
        one_mode("[\"x\"]", "{ u = [-1, 1] }", "{ x = [0, 1] }", "[[-1]]", "[[1]]", "\"inf\"", &["x < 1", "x <= 1"]);
    assert_eq!(verdicts(&from), [fails, holds]);
    let system = read(&of("[-1, 1]", "\"inf\""));
    let text = reach::answer::text(&system, &decide(&system, 10, &Unwatched).expect("answers"), 10);
    assert!(text.contains(", 1], which no motion attains"), "{text}");
}

/// What holds of one equation holds of any switching between several: the larger limit counts, `1/2` and `1`.
#[test]
fn the_larger_limit_bounds_any_switching() {
    let text = system(
        &["x"],
        "x = 0",
        &[("a", "[[-1]]", "[[1]]"), ("b", "[[-2]]", "[[1]]")],
        "[switching]\nkind = \"arbitrary\"\n[run]\nuntil = \"inf\"\n[[check]]\nholds = \"x < 1\"\n[[check]]\nholds = \"x <= 9/10\"\n",
    );
    assert_eq!(verdicts(&text), [Verdict::Holds, Verdict::False]);
}

/// An input that is always 0 is none: the answer is that without it.
#[test]
fn an_input_without_width_changes_no_question() {
    for input in ["[0, 0]", "0", "{ box = [0, 0], constant = true }"] {
        let inputs = format!("{{ u = {input} }}");
        let text = one_mode("[\"x\"]", &inputs, "{ x = [1, 2] }", "[[0]]", "[[1]]", "\"inf\"", &["x <= 2", "x < 2"]);
        assert_eq!(verdicts(&text), [Verdict::Holds, Verdict::False], "{input}");
    }
    // One that is always 1/3 leads there, and never attains it.
    let text =
        one_mode("[\"x\"]", "{ u = \"1/3\" }", "{ x = 0 }", "[[-1]]", "[[1]]", "\"inf\"", &["x < 1/3", "x < 33/100"]);
    assert_eq!(verdicts(&text), [Verdict::Holds, Verdict::False]);
    let moved = one_mode("[\"x\"]", "{ u = 1 }", "{ x = 0 }", "[[0]]", "[[1]]", "\"inf\"", &["x <= 2"]);
    assert!(decide(&read(&moved), 5, &Unwatched).is_err());
}

/// Durations that are free sum up to no more than the time that is looked at.
#[test]
fn no_time_is_told_after_the_last() {
    let text = system(
        &["x"],
        "x = 0",
        &[("a", "[[-1]]", "[[1]]"), ("b", "[[\"-1/8\"]]", "[[1]]")],
        "[switching]\nkind = \"dwell\"\nat_least = { a = 1, b = 1 }\nat_most = { a = 3 }\n[run]\nuntil = 9\n[[check]]\nholds = \"x <= 9\"\n",
    );
    let found = decided(&text, 10);
    let at = found[0].parts[0].at.clone().expect("a time");
    assert!(at.hi <= rational(9, 1) && at.lo <= at.hi, "{at:?}");
}
