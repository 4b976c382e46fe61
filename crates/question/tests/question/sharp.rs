//! Inequalities that are attained: each with what it becomes when a constant is changed by one part in 10^3 and in 10^6.

use super::{answer, asked, verdict};
use question::Verdict;

/// Family, the property with `EPS` where a small number goes that makes it false.
const ATTAINED: &[(&str, &str)] = &[
    ("x = \"[0, 1]\"", "sin(x) <= x*(1 - EPS)"),
    ("x = \"[-3, 3]\"", "cos(x) >= 1 - x^2/2 + EPS*x^2"),
    ("x = \"[-2, 2]\"", "exp(x) >= 1 + x + EPS"),
    ("x = \"[1/10, 10]\"", "log(x) <= x - 1 - EPS"),
    ("x = \"[0, 1]\"\ny = \"[0, 1]\"", "x*y <= (x+y)^2/4 - EPS*x"),
    ("x = \"[0, 1]\"\ny = \"[0, 1]\"", "sqrt(x*y) <= (x+y)/2 - EPS*x"),
    (
        "a = \"[-1, 1]\"\nb = \"[-1, 1]\"\nc = \"[-1, 1]\"\nd = \"[-1, 1]\"",
        "(a*c + b*d)^2 <= (a^2 + b^2)*(c^2 + d^2)*(1 - EPS)",
    ),
    ("x = \"[-2, 2]\"\ny = \"[-2, 2]\"", "x^4*y^2 + x^2*y^4 - 3*x^2*y^2 + 1 >= EPS"),
    ("x = \"[0, 1]\"", "x^2 - x + 1/4 >= EPS"),
    ("x = \"[-1, 1]\"", "x > 0 implies 1/x >= 1 + EPS"),
    ("x = \"[-1, 3]\"", "x > 0 implies log(x) <= x - 1 - EPS"),
    ("x = \"[-1, 1]\"\ny = \"[-1, 1]\"", "abs(x + y) <= (abs(x) + abs(y))*(1 - EPS)"),
    ("x = \"[-1, 1]\"\ny = \"[-1, 1]\"", "max(x, y) >= (x + y)/2 + EPS"),
    ("x = \"[1, 2]\"\ny = \"[1, 2]\"", "x/y + y/x >= 2 + EPS"),
    ("x = \"[-3, 2]\"", "(x^2 - 2)^2 >= EPS*(x + 4)"),
    ("x = \"[0, 1]\"\ny = \"[0, 1]\"", "x + y <= 1 - EPS implies 4*x*y <= 1 - 3*EPS"),
];

/// Estimates of the five papers and of the proofs in the notes, as `notes/questions.md` lists them.
const PAPERS: &[(&str, &str)] = &[
    ("x = \"[-1, 1]\"\nu = \"[-1, 1]\"", "abs(abs(x + u) - abs(x)) <= abs(u)*(1 - EPS)"),
    ("x = \"[0, 2]\"", "1 - x <= exp(-x)*(1 - EPS)"),
    ("x = \"[0, 4]\"", "log(1 + x) <= x - EPS*x"),
    ("x = \"[0, 1]\"", "log(1 + x) >= x/(1 + x) + EPS*x"),
    ("x = \"[0, 3/2]\"", "sin(x) >= 2*x/pi + EPS"),
    ("x = \"[0, 2]\"", "sin(x) >= x - x^3/6 + EPS*x^3"),
    ("x = \"[-2, 2]\"", "1 - cos(x) >= x^2/2 - x^4/24 + EPS*x^4"),
    ("a = \"[0, 1]\"\nb = \"[0, 1]\"\nc = \"[0, 1]\"", "a*b + b*c + c*a <= (a^2 + b^2 + c^2)*(1 - EPS)"),
    ("x = \"[-1, 4]\"", "sqrt(1 + x) <= 1 + x/2 - EPS"),
    ("x = \"[-2, 2]\"", "exp(x) + exp(-x) >= 2 + x^2 + EPS*x^2"),
    ("x = \"[0, 3]\"", "exp(x) - exp(-x) >= 2*x + EPS*x"),
    ("x = \"[-3, 3]\"\ny = \"[-3, 3]\"", "(1 + cos(x) + cos(y))^2 + (sin(x) + sin(y))^2 <= 9 - EPS"),
    ("x = \"[-3, 3]\"\ny = \"[-3, 3]\"", "cos(x - y) <= 1 - EPS"),
    ("r = \"[1/4, 4]\"", "1/r^2 + log(r^2) >= 1 + EPS"),
    (
        "x = \"[-1, 1]\"\ny = \"[-1, 1]\"\nz = \"[-1, 1]\"",
        "(x - y)^2 + (y - z)^2 >= (1 + EPS)*(x^2 + y^2 + z^2 - (x + y + z)^2/3)",
    ),
    ("x = \"[-1, 1]\"\ny = \"[-1, 1]\"\nz = \"[-1, 1]\"", "abs(x - z) <= (abs(x - y) + abs(y - z))*(1 - EPS)"),
    ("x = \"[0, 2]\"\ny = \"[0, 2]\"", "min(x, 1) + min(y, 1) <= min(x + y, 2) - EPS*x*y"),
];

/// The estimates hold, and none of them does with a constant changed.
#[test]
fn estimates_of_the_papers_are_decided_for_all_numbers() {
    let mut wrong = Vec::new();
    for (family, property) in PAPERS {
        let found = answer(&asked(family, &property.replace("EPS", "0"), "1 < 0"));
        if found.verdict != Verdict::Holds {
            wrong.push(format!("{property}: {:?} {}", found.verdict, found.why));
        }
        for small in ["1/1000", "1/1000000"] {
            let altered = verdict(family, &property.replace("EPS", small));
            if altered != Verdict::False {
                wrong.push(format!("{property} with {small}: {altered:?}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn inequalities_that_are_attained_are_decided() {
    for (family, property) in ATTAINED {
        let found = answer(&asked(family, &property.replace("EPS", "0"), "1 < 0"));
        assert_eq!(found.verdict, Verdict::Holds, "{property}: {}", found.why);
        for small in ["1/1000", "1/1000000"] {
            assert_eq!(verdict(family, &property.replace("EPS", small)), Verdict::False, "{property} with {small}");
        }
    }
}

/// Rules that hold by definition, or at rest, and what a wrong rule would let pass.
#[test]
fn rules_about_gains_and_eigenvalues_hold_and_no_more() {
    let platoon = "followers = \"1..4\"\nf = -1\ng = -1\nw = \"[0, 3]\"";
    assert_eq!(verdict(platoon, "gain(followers, w) <= peak"), Verdict::Holds);
    assert_eq!(verdict(platoon, "gain(followers, w) <= 99/100*peak"), Verdict::False);
    // Not every car: the second one of three has a gain above 1 while nobody says that it stays below the peak of the last.
    assert_eq!(verdict("f = -1\ng = -1\nfollowers = 3", "gain(1, 0) >= peak"), Verdict::False);
    let rest = "followers = 3\nf = -1\ng = -1\nw = \"[0, 1/20]\"";
    assert_eq!(verdict(rest, "gain(followers, w) >= 1"), Verdict::Holds);
    assert_eq!(verdict(rest, "gain(followers, w) <= 1"), Verdict::False);
    assert_eq!(verdict("n = \"2..4\"\ngraph = \"connected(n)\"", "lambda(1) <= lambda(2)"), Verdict::Holds);
    assert_eq!(verdict("n = \"2..4\"\ngraph = \"connected(n)\"", "lambda(2) <= lambda(1)"), Verdict::False);
}

/// Forty numbers: a corner refutes.
#[test]
fn points_refute_in_many_numbers() {
    let family: String = (1..=40).map(|k| format!("x{k} = \"[0, 1]\"\n")).collect();
    let sum: Vec<String> = (1..=40).map(|k| format!("x{k}")).collect();
    assert_eq!(verdict(&family, &format!("{} >= 0", sum.join(" + "))), Verdict::Holds);
    assert_eq!(verdict(&family, &format!("x1 >= 1/2 or {} >= 1/1000000", sum.join(" + "))), Verdict::False);
}

/// The answer tells where the margin is 0, and what is open.
#[test]
fn the_point_of_equality_and_the_open_part_are_told() {
    let found = answer(&asked("x = \"[-1, 2]\"", "exp(x) >= 1 + x", "exp(x) > 1 + x"));
    assert!(found.text(None).contains("smallest margin = 0 at (x = 0)"), "{}", found.text(None));
    // Equal by an identity that no polynomial tells: undecided, with the share that is open.
    let found = answer(&asked("x = \"[1, 2]\"\ny = \"[1, 2]\"", "log(x*y) <= log(x) + log(y)", "1 < 0"));
    assert_eq!(found.verdict, Verdict::Undecided);
    let document = found.json(None);
    assert!(document["open"]["boxes"][0]["x"].is_string(), "{document}");
    assert!(found.why.contains("of the volume"), "{}", found.why);
}
