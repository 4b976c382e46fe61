//! Worst cases against closed forms, against naive twins in floats, and against statements that are planted to be false.

extern crate flockproof_reach as reach;

mod certificates;
mod degenerate;
mod inputs;
mod platoon;
mod random;
mod switching;
mod tubes;

use arithmetic::{Enclosure, Interval, Number, Rational, Real, Ring, Unwatched, parse_rational, rational};
use reach::{Decided, Part, System, Verdict, decide};

/// One mode with the rows of `A` and `B` as texts of TOML.
fn one_mode(states: &str, inputs: &str, start: &str, a: &str, b: &str, until: &str, checks: &[&str]) -> String {
    let mut text = format!(
        "[system]\nstates = {states}\ninputs = {inputs}\nstart = {start}\n[[mode]]\nname = \"only\"\nA = {a}\nB = {b}\n[run]\nuntil = {until}\n"
    );
    checks.iter().for_each(|check| text += &format!("[[check]]\nholds = \"{check}\"\n"));
    text
}

fn read(text: &str) -> System {
    System::read(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn decided(text: &str, digits: u32) -> Vec<Decided> {
    decide(&read(text), digits, &Unwatched).unwrap_or_else(|error| panic!("{error}"))
}

/// The worst value of the only check, between its ends.
fn worst(text: &str, digits: u32) -> (Rational, Rational) {
    let found = decided(text, digits).remove(0);
    let part = &found.parts[0];
    consistent(part);
    (part.lo.clone().expect("a bound"), part.hi.clone().expect("a bound"))
}

/// The witness is a motion of the system: its value, computed forwards, is not beyond the worst case, and near it.
fn consistent(part: &Part) {
    let (Some(lo), Some(hi), Some(witness)) = (&part.lo, &part.hi, &part.witness) else { return };
    let slack = rational(1, 1_000_000_000);
    assert!(lo <= hi, "{lo} <= {hi}");
    assert!(witness.value.hi >= lo - &slack && witness.value.lo <= hi + &slack, "{witness:?} {lo} {hi}");
}

fn close(found: &(Rational, Rational), exact: &Interval, digits: u32) {
    let (lo, hi) = exact.ends().expect("bounded");
    assert!(found.0 <= hi && lo <= found.1, "{found:?} {exact}");
    let width = rational(1, 10).power(u64::from(digits));
    assert!(&found.1 - &found.0 <= width.clone() * (hi.max(Rational::ONE)), "{found:?} is wider than 1e-{digits}");
}

fn number(text: &str) -> Interval {
    Interval::from_rational(&parse_rational(text).expect("a number"), 400)
}

#[test]
fn one_state_has_its_closed_form_to_any_number_of_digits() {
    // x' = -x + u with |u| <= 1 from 0: 1 - e^-t.
    for digits in [5, 10, 30, 60] {
        let text = one_mode("[\"x\"]", "{ u = [-1, 1] }", "{ x = 0 }", "[[-1]]", "[[1]]", "2", &["x <= 2"]);
        let exact = number("1") - number("-2").exp().expect("finite");
        close(&worst(&text, digits), &exact, digits);
    }
}

#[test]
fn an_integrator_and_a_double_one_are_polynomials() {
    let single = one_mode("[\"x\"]", "{ u = [-2, 3] }", "{ x = [1, 2] }", "[[0]]", "[[1]]", "3", &["x <= 0"]);
    close(&worst(&single, 10), &number("11"), 10);
    let double = one_mode(
        "[\"x\", \"v\"]",
        "{ u = [-1, 3] }",
        "{ x = 0, v = 0 }",
        "[[0, 1], [0, 0]]",
        "[[0], [1]]",
        "4",
        &["x >= 0"],
    );
    close(&worst(&double, 10), &number("-8"), 10);
}

#[test]
fn an_oscillator_is_pushed_at_each_half_turn() {
    // x'' = -x + u: the integral of |sin|, 2 for each half turn; in 20 there are six and 1 - cos(20 - 6 pi).
    let text = one_mode(
        "[\"x\", \"v\"]",
        "{ u = [-1, 1] }",
        "{ x = 0, v = 0 }",
        "[[0, 1], [-1, 0]]",
        "[[0], [1]]",
        "20",
        &["x <= 1"],
    );
    let rest = (number("20") - number("6") * number("20").pi()).cos().expect("finite");
    close(&worst(&text, 25), &(number("13") - rest), 25);
}

#[test]
fn an_unknown_constant_is_worse_than_nothing_and_better_than_a_function() {
    let systems = ["{ u = { box = [-1, 1], constant = true } }", "{ u = [-1, 1] }"];
    let of = |inputs: &str| {
        worst(
            &one_mode(
                "[\"x\", \"v\"]",
                inputs,
                "{ x = 0, v = 0 }",
                "[[0, 1], [-1, 0]]",
                "[[0], [1]]",
                "20",
                &["x <= 1"],
            ),
            10,
        )
    };
    // Constant: 1 - cos t, at most 2.
    close(&of(systems[0]), &number("2"), 10);
    assert!(of(systems[1]).0 > rational(12, 1));
}

#[test]
fn starts_and_constant_terms_count() {
    // x' = -x + 1 from [0, 3]: at t = 1 from 1 - 1/e to 1 + 2/e.
    let text = "[system]\nstates = [\"x\"]\nstart = { x = [0, 3] }\n[[mode]]\nname = \"m\"\nA = [[-1]]\nc = [1]\n[run]\nuntil = 1\n\
        [[check]]\nholds = \"2*x - 1 <= 3\"\nat = 1\n[[check]]\nholds = \"-1 <= x <= 3\"\n[[check]]\nholds = \"x < 3\"\n";
    let found = decided(text, 20);
    let part = &found[0].parts[0];
    let exact = number("1") + number("4") * number("-1").exp().expect("finite");
    close(&(part.lo.clone().expect("lo"), part.hi.clone().expect("hi")), &exact, 20);
    assert_eq!(
        found.iter().map(|found| found.verdict).collect::<Vec<_>>(),
        [Verdict::Holds, Verdict::Holds, Verdict::False]
    );
    assert_eq!(found[1].parts.len(), 2);
    assert_eq!(found[1].parts[1].hi, Some(rational(3, 1)));
}

#[test]
fn nothing_happens_in_no_time_and_without_inputs() {
    let text = one_mode(
        "[\"x\"]",
        "{ u = [-1, 1] }",
        "{ x = [-1, 2] }",
        "[[5]]",
        "[[1]]",
        "0",
        &["x <= 2", "x >= -1", "x < 2", "x > -1"],
    );
    let verdicts: Vec<Verdict> = decided(&text, 10).iter().map(|found| found.verdict).collect();
    assert_eq!(verdicts, [Verdict::Holds, Verdict::Holds, Verdict::False, Verdict::False]);
    // An input without an effect, and a state that only others see.
    let still = one_mode(
        "[\"x\", \"y\"]",
        "{ u = [-1, 1] }",
        "{ x = 0, y = 1 }",
        "[[0, 0], [1, -1]]",
        "[[0], [1]]",
        "5",
        &["x <= 0 and x >= 0"],
    );
    assert_eq!(decided(&still, 10)[0].verdict, Verdict::Holds);
}

#[test]
fn for_ever_means_the_limit() {
    let text = one_mode(
        "[\"x\", \"v\"]",
        "{ u = [-1, 1] }",
        "{ x = 0, v = 0 }",
        "[[0, 1], [-1, -2]]",
        "[[0], [1]]",
        "\"inf\"",
        &["x <= 2"],
    );
    // A double eigenvalue -1: the integral of r e^-r is 1.
    close(&worst(&text, 8), &number("1"), 7);
}

/// The published instance, whose worst cases were first found by a separate program in floats of 16 digits.
#[test]
fn the_platooning_benchmark_is_decided() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/systems");
    let text = std::fs::read_to_string(format!("{folder}/platoon_plad01.toml")).expect("a file");
    let found = decided(&text, 10);
    for (found, near) in found.iter().zip(["-26.84664675766", "-24.22923748499", "-9.409853811"]) {
        assert_eq!(found.verdict, Verdict::Holds);
        let part = &found.parts[0];
        consistent(part);
        let near = parse_rational(near).expect("a number");
        let (lo, hi) = (part.lo.clone().expect("lo"), part.hi.clone().expect("hi"));
        assert!(
            (&lo - &near) < rational(1, 1_000_000_000)
                && &near - &hi < rational(1, 1_000_000_000)
                && hi - lo < rational(1, 1_000_000_000)
        );
    }
    // Statements that miss the worst case by little: one holds, the other is false.
    let planted = text.replace("e1 >= -42", "e1 >= -26.846646758").replace("e1 >= -30", "e1 >= -26.846646757");
    let verdicts: Vec<Verdict> = decided(&planted, 10).iter().map(|found| found.verdict).collect();
    assert_eq!((verdicts[0], verdicts[3]), (Verdict::Holds, Verdict::False));
}
