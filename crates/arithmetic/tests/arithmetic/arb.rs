//! Differential run against Arb (python-flint), an independent implementation of ball arithmetic.
//!
//! Skipped, and says so, where Python or python-flint is missing; with `FLOCKPROOF_REQUIRE_ARB=1` that is a failure.

use arithmetic::{Field, Interval, Number, Real, Ring, parse_rational, rational};
use std::io::Write;
use std::process::{Command, Stdio};

/// Reads `function p/q bits` lines, answers `lo hi` as exact fractions.
const ORACLE: &str = r#"
import sys
from fractions import Fraction
from flint import arb, ctx, fmpq
def exact(x):
    man, exp = x.man_exp()
    man, exp = int(man), int(exp)
    return Fraction(man) * Fraction(2) ** exp
for line in sys.stdin:
    name, p, q, bits = line.split()
    ctx.prec = int(bits)
    x = arb(fmpq(int(p), int(q)))
    if name == "pi": y = arb.pi()
    elif name == "over": y = 1 / x
    elif name == "square": y = x * x
    else: y = getattr(x, name)()
    lo, hi = y.lower(), y.upper()
    lo, hi = exact(lo), exact(hi)
    print("%d/%d %d/%d" % (lo.numerator, lo.denominator, hi.numerator, hi.denominator))
"#;

fn python_with_flint() -> bool {
    Command::new("python3")
        .args(["-c", "import flint"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok_and(|status| status.success())
}

fn ours(name: &str, x: &Interval) -> Option<Interval> {
    match name {
        "pi" => Some(x.pi()),
        "over" => x.recip().ok(),
        "square" => Some(x.square()),
        "sqrt" => x.sqrt().ok(),
        "exp" => x.exp().ok(),
        "log" => x.ln().ok(),
        "sin" => x.sin().ok(),
        "cos" => x.cos().ok(),
        "atan" => x.atan().ok(),
        "cosh" => x.cosh().ok(),
        "sinh" => x.sinh_cosh().ok().map(|pair| pair.0),
        _ => None,
    }
}

#[test]
fn every_function_overlaps_arb() {
    if !python_with_flint() {
        assert!(std::env::var_os("FLOCKPROOF_REQUIRE_ARB").is_none(), "python-flint is required here and missing");
        // Written past the capture of the test harness, so that the skip is always seen.
        let _ = writeln!(
            std::io::stderr(),
            "SKIPPED arb::every_function_overlaps_arb: python3 with python-flint is not installed"
        );
        return;
    }
    let names = ["pi", "over", "square", "sqrt", "exp", "log", "sin", "cos", "atan", "cosh", "sinh"];
    let fractions = [(1, 3), (-1, 3), (22, 7), (-355, 113), (1, 1 << 40), (-3, 1 << 50), (1000, 7), (-1000, 7), (1, 1)];
    let mut questions = Vec::new();
    for name in names {
        for (p, q) in fractions {
            for bits in [30u32, 53, 113, 300, 2000] {
                let x = Interval::from_rational(&rational(p, q), bits);
                if let Some(answer) = ours(name, &x) {
                    questions.push((format!("{name} {p} {q} {bits}\n"), answer));
                }
            }
        }
    }
    assert!(questions.len() > 350);
    let mut child = Command::new("python3")
        .args(["-c", ORACLE])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("python3 was there a moment ago");
    let input: String = questions.iter().map(|(line, _)| line.as_str()).collect();
    let mut stdin = child.stdin.take().expect("piped");
    let writer = std::thread::spawn(move || stdin.write_all(input.as_bytes()));
    let output = child.wait_with_output().expect("the oracle ends");
    writer.join().expect("no panic").expect("the oracle reads");
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).expect("ascii");
    assert_eq!(text.lines().count(), questions.len());
    for (line, (question, answer)) in text.lines().zip(&questions) {
        let (lo, hi) = line.split_once(' ').expect("two numbers");
        // Arb's fractions can be longer than the reader of user input allows: they are dyadic, read them directly.
        let read = |s: &str| parse_rational(s).unwrap_or_else(|_| s.parse().expect("a fraction"));
        let (lo, hi) = (read(lo), read(hi));
        let (our_lo, our_hi) = answer.to_rationals();
        assert!(our_lo <= hi && lo <= our_hi, "{question}: ours {answer:?}, Arb [{lo}, {hi}]");
        // Comparable tightness: at most 64 times the width of the ball, or a few units in the last place.
        let width = &our_hi - &our_lo;
        let unit = answer.magnitude().to_rational() * rational(1, 1 << 20) * rational(1, 1);
        assert!(width <= (&hi - &lo) * rational(64, 1) + unit, "{question}: too wide");
    }
}
