//! Inequalities that are attained: each with what it becomes when a constant is changed by one part in 10^3 and in 10^6.

use super::{answer, asked, holds_exactly, read, verdict};
use arithmetic::Unwatched;
use question::{Verdict, decide};

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
    // At points without rational coordinates.
    ("x = \"[-2, 2]\"\ny = \"[-4, 4]\"", "x^4 - 4*x^2 + 4 + (y - x^3)^2*exp(x) >= EPS"),
    (
        "x = \"[0, 2]\"\ny = \"[0, 2]\"",
        "exp(x - sqrt(2)) + exp(y - sqrt(3)) >= 2 + (x - sqrt(2)) + (y - sqrt(3)) + EPS",
    ),
    ("x = \"[0, 2]\"\ny = \"[0, 2]\"", "x^3/3 - 2*x + (y - x)^2*exp(y) >= EPS - 4*sqrt(2)/3"),
    ("x = \"[1/10, 3]\"\ny = \"[1/10, 3]\"", "x*log(x) + y*log(y) >= EPS - 2/exp(1)"),
    ("x = \"[1/2, 4]\"\ny = \"[1/2, 4]\"", "x + 2/x + y + 3/y >= 2*sqrt(2) + 2*sqrt(3) + EPS"),
    ("x = \"[-2, 2]\"\ny = \"[-2, 2]\"", "exp(x) - 2*x + exp(y) - 3*y >= 5 - 2*log(2) - 3*log(3) + EPS"),
    ("x = \"[0, 3]\"\ny = \"[0, 3]\"", "sin(x) + sin(y) + sin(x + y) <= 3*sqrt(3)/2 - EPS"),
    ("x = \"[-1, 1]\"\ny = \"[0, 2]\"", "(exp(x) - y)^2 + (y^2 - 2)^2 >= EPS"),
    ("x = \"[-1, 1]\"", "x > 0 implies 1/x >= 1 + EPS"),
    ("x = \"[-1, 3]\"", "x > 0 implies log(x) <= x - 1 - EPS"),
    ("x = \"[-1, 1]\"\ny = \"[-1, 1]\"", "abs(x + y) <= (abs(x) + abs(y))*(1 - EPS)"),
    ("x = \"[-1, 1]\"\ny = \"[-1, 1]\"", "max(x, y) >= (x + y)/2 + EPS"),
    ("x = \"[1, 2]\"\ny = \"[1, 2]\"", "x/y + y/x >= 2 + EPS"),
    ("x = \"[-3, 2]\"", "(x^2 - 2)^2 >= EPS*(x + 4)"),
    ("x = \"[0, 1]\"\ny = \"[0, 1]\"", "x + y <= 1 - EPS implies 4*x*y <= 1 - 3*EPS"),
];

/// Estimates of the five papers, as the table of `notes/inequalities.md` lists them.
const PAPERS: &[(&str, &str)] = &[
    // Chazelle.
    (
        "x = \"any\"\ny = \"any\"\nu = \"any\"\nw = \"any\"",
        "abs(sqrt((x + u)^2 + (y + w)^2) - sqrt(x^2 + y^2)) <= sqrt(u^2 + w^2)*(1 - EPS)",
    ),
    (
        "a = \"any\"\nb = \"any\"\nc = \"any\"",
        "a + b + c = 0 implies sqrt(a^2 + b^2 + c^2) <= sqrt(2)*(abs(a) + abs(b) + abs(c))/2*(1 - EPS)",
    ),
    ("x = \"any\"", "1 - x <= exp(-x)*(1 - EPS)"),
    ("u = \"[-1/3, 1]\"", "1/4 + EPS <= (5 - u)/16 <= 1/3"),
    ("s = \"[0, 1]\"", "2*sin(pi*s/2) >= 2*s + EPS*s"),
    ("x = \"[0, 3]\"", "2*sin(x/2) <= x*(1 - EPS)"),
    ("s = \"any\"\nt = \"any\"\nr = \"any\"", "abs(s - t) <= r implies abs(s - 1) >= abs(t - 1) - r*(1 - EPS)"),
    ("m = \"[0, 1]\"", "m^3 <= exp(-3*(1 - m))*(1 - EPS)"),
    // Veerman and others.
    (
        "f = \"[-4, -1/10]\"\ng = \"[-4, -1/10]\"\ny = \"[0, 20]\"",
        "y <= -2*f implies (f^2 + y*g^2)/((f + y)^2 + y*g^2) >= 1 + EPS*y",
    ),
    (
        "f = \"[-4, -1/10]\"\ng = \"[-4, -1/10]\"\ny = \"[0, 20]\"",
        "y >= -2*f implies (f^2 + y*g^2)/((f + y)^2 + y*g^2) <= 1 - EPS",
    ),
    (
        "s = \"[6/5, 4]\"\nu = \"[0, 4]\"",
        "(1 + (s^2 - 1)/2*u)/((1 - u)^2 + (s^2 - 1)/2*u) <= (s + 1)^2/((s - 1)*(s + 3))*(1 - EPS)",
    ),
    (
        "l = \"[0, 2]\"\nf = \"[-4, 0]\"\ng = \"[-4, 0]\"",
        "(l*g)^2 + 4*l*f >= 0 implies l*g + sqrt((l*g)^2 + 4*l*f) <= -EPS",
    ),
    ("x = \"any\"", "x > -1 implies log(1 + x) <= x - EPS"),
    ("x = \"any\"", "x >= -1/2 implies sqrt(1 + 2*x) <= 1 + x - EPS"),
    ("x = \"any\"", "x >= 0 implies exp(x) - exp(-x) >= 2*x + EPS*x"),
    // Paley and others.
    ("x = \"any\"\ny = \"any\"", "(1 + cos(x) + cos(y))^2 + (sin(x) + sin(y))^2 <= 9 - EPS"),
    ("x = \"any\"\ny = \"any\"", "cos(x - y) <= 1 - EPS"),
    ("x = \"any\"\ny = \"any\"", "0 <= 3 - cos(x) - cos(y) - cos(x - y) <= 9/2 - EPS"),
    ("x = \"any\"\ny = \"any\"", "(cos(2*x) + cos(2*y))^2 + (sin(2*x) + sin(2*y))^2 <= 4 - EPS"),
    (
        "x = \"any\"\ny = \"any\"\nz = \"any\"\nu = \"any\"\nv = \"any\"\nw = \"any\"",
        "(x - y)^2 + (y - z)^2 + (z - x)^2 + (u - v)^2 + (v - w)^2 + (w - u)^2 >= EPS",
    ),
    // Tanner and others.
    ("r = \"[1/100, 100]\"", "1/r^2 + log(r^2) >= 1 + EPS"),
    ("r = \"[1, 4]\"", "1/min(r, 2)^2 + log(min(r, 2)^2/4) <= 1/4 - EPS"),
    ("x = \"any\"\ny = \"any\"\nz = \"any\"", "(x - y)^2 + (y - z)^2 >= (1 + EPS)*(x^2 + y^2 + z^2 - (x + y + z)^2/3)"),
    (
        "a = \"any\"\nb = \"any\"\nc = \"any\"\nd = \"any\"",
        "abs(a*c + b*d) <= sqrt(a^2 + b^2)*sqrt(c^2 + d^2)*(1 - EPS)",
    ),
];

/// The estimates hold, and none of them does with a constant changed.
#[test]
fn estimates_of_the_papers_are_decided_for_all_numbers() {
    for (family, property) in PAPERS {
        holds_exactly(family, property, &["1/1000", "1/1000000"]);
    }
}

#[test]
fn inequalities_that_are_attained_are_decided() {
    for (family, property) in ATTAINED {
        holds_exactly(family, property, &["1/1000", "1/1000000"]);
    }
}

/// Rules that hold by definition, or at rest, and what a wrong rule would let pass.
#[test]
fn rules_about_gains_and_eigenvalues_hold_and_no_more() {
    let platoon = "followers = \"1..4\"\nf = -1\ng = -1\nw = \"[0, 3]\"";
    assert_eq!(verdict(platoon, "gain(followers, w) <= peak"), Verdict::Holds);
    assert_eq!(verdict(platoon, "gain(followers, w) <= 99/100*peak"), Verdict::False);
    // Attained at the frequency of the peak, where that is one of those asked for.
    let single = |w: &str| {
        answer(&asked(&format!("followers = 5\nf = -1\ng = -1\nw = \"{w}\""), "gain(followers, w) <= peak", "1 < 0"))
    };
    let at = |w: &str| single(w).attained.map(|at| at.to_string());
    assert!(at("[0, 3]").is_some_and(|at| at.contains("w in [0.219820475421")), "{:?}", at("[0, 3]"));
    assert_eq!(at("[1, 3]"), None);
    let left_out = "followers = 5\nf = -1\ng = -1\nw = \"[0, 3]\"\nwhere = \"w <= 1/5\"";
    assert_eq!(answer(&asked(left_out, "gain(followers, w) <= peak", "1 < 0")).attained, None);
    assert_ne!(verdict(left_out, "gain(followers, w) < peak"), Verdict::False);
    let below = |w: &str| verdict(&format!("followers = 5\nf = -1\ng = -1\nw = \"{w}\""), "gain(followers, w) < peak");
    assert_eq!((below("[0, 3]"), below("[1, 3]")), (Verdict::False, Verdict::Holds));
    // Not every car: the second one of three has a gain above 1 while nobody says that it stays below the peak of the last.
    assert_eq!(verdict("f = -1\ng = -1\nfollowers = 3", "gain(1, 0) >= peak"), Verdict::False);
    let rest = "followers = 3\nf = -1\ng = -1\nw = \"[0, 1/20]\"";
    assert_eq!(verdict(rest, "gain(followers, w) >= 1"), Verdict::Holds);
    assert_eq!(verdict(rest, "gain(followers, w) <= 1"), Verdict::False);
    assert_eq!(verdict("n = \"2..4\"\ngraph = \"connected(n)\"", "lambda(1) <= lambda(2)"), Verdict::Holds);
    assert_eq!(verdict("n = \"2..4\"\ngraph = \"connected(n)\"", "lambda(2) <= lambda(1)"), Verdict::False);
}

/// The sign of the abscissa is that of stability, where both are known on a box; a rule that said more would be wrong at `g = 0`, where the abscissa is 0.
#[test]
fn the_abscissa_and_stability_say_the_same() {
    let boxed = "f = \"[-4, -1]\"\ng = \"[-3, -2]\"\ngraph = \"arcs:4:2-1,2-3,3-2,3-4,4-2,4-3\"";
    assert_eq!(verdict(boxed, "abscissa < 0 and stable"), Verdict::Holds);
    assert_eq!(verdict(boxed, "abscissa >= 0 or not stable"), Verdict::False);
    let unstable = "f = \"[1, 2]\"\ng = \"[-3, -2]\"\ngraph = \"arcs:4:2-1,2-3,3-2,3-4,4-2,4-3\"";
    assert_eq!(verdict(unstable, "abscissa >= 0 and not 0 > abscissa"), Verdict::Holds);
    let verge = "f = -1\ng = 0\nfollowers = 2";
    assert_ne!(verdict(verge, "abscissa > 0"), Verdict::Holds);
    assert_ne!(verdict(verge, "abscissa < 0"), Verdict::Holds);
}

/// All reals, and what only numbers can be.
#[test]
fn all_reals_are_a_domain() {
    assert_eq!(verdict("x = \"any\"\ny = \"[0, 1]\"", "x^2 + y >= 0"), Verdict::Holds);
    let found = answer(&asked("x = \"any\"", "x^3 <= 1000000000", "1 < 0"));
    assert_eq!(found.verdict, Verdict::False);
    let replay = read(&found.replay.expect("a replay")).expect("a question");
    assert_eq!(decide(&replay, &Unwatched).expect("an answer").verdict, Verdict::False);
    // Quantities of a subject are not functions of a number alone.
    assert_eq!(verdict("w = \"any\"\nf = -1\ng = -1\nfollowers = 1", "gain(1, w) < 10^6"), Verdict::Undecided);
    assert_eq!(verdict("n = \"integers(1, 1000000000000)\"", "n^3 + 1/2 != 9/8"), Verdict::Holds);
    assert_eq!(verdict("n = \"integers(-9, 9)\"", "(2*n - 1)^2 >= 1"), Verdict::Holds);
    assert_eq!(verdict("n = \"integers(-9, 9)\"", "(2*n - 1)^2 > 1"), Verdict::False);
    assert_eq!(verdict("n = \"integers(0, 9)\"\nx = \"[0, 1]\"", "2*x = n implies x = n/2 and n <= 2"), Verdict::Holds);
}

/// Certificates say the question itself where it is one of polynomials.
#[test]
fn certificates_say_the_question() {
    let mut question =
        read(&asked("x = \"[0, 1]\"\ny = \"any\"", "x >= x^2 + y^2 implies 2*x*y <= x", "1 < 0")).expect("a question");
    question.certified = true;
    let found = decide(&question, &Unwatched).expect("an answer");
    assert_eq!((found.verdict, found.certificates.len(), found.uncertified), (Verdict::Holds, 1, 0));
    let text = found.certificates[0].text();
    assert!(text.contains("says for all x in [0, 1], y in R: "), "{text}");
}

/// Forty numbers: a corner refutes.
#[test]
fn points_refute_in_many_numbers() {
    let family: String = (1..=40).map(|k| format!("x{k} = \"[0, 1]\"\n")).collect();
    let sum: Vec<String> = (1..=40).map(|k| format!("x{k}")).collect();
    assert_eq!(verdict(&family, &format!("{} >= 0", sum.join(" + "))), Verdict::Holds);
    assert_eq!(verdict(&family, &format!("x1 >= 1/2 or {} >= 1/1000000", sum.join(" + "))), Verdict::False);
}

/// A polynomial of degree 2 has one Gram matrix: decided for all reals, in forty numbers too, with a certificate.
#[test]
fn polynomials_of_degree_two_in_many_numbers() {
    let family: String = (1..=40).map(|k| format!("x{k} = \"any\"\n")).collect();
    let sum = (1..=40).map(|k| format!("x{k}")).collect::<Vec<_>>().join(" + ");
    let squares = (1..=40).map(|k| format!("x{k}^2")).collect::<Vec<_>>().join(" + ");
    let decided = |property: &str| {
        let mut question = read(&asked(&family, property, "1 < 0")).expect("a question");
        question.certified = true;
        let found = decide(&question, &Unwatched).expect("an answer");
        (found.verdict, found.certificates.len())
    };
    assert_eq!(decided(&format!("({sum})^2 <= 40*({squares})")), (Verdict::Holds, 1));
    assert_eq!(decided(&format!("({sum})^2/39 <= {squares}")), (Verdict::False, 0));
    assert_eq!(decided(&format!("({sum} - 1)^2 < 40*({squares}) + 1 + 1/1000000 - 2*({sum})")), (Verdict::Holds, 1));
    assert_ne!(decided(&format!("({sum} - 1)^2 < 40*({squares}) + 1 - 2*({sum})")).0, Verdict::Holds);
    assert_ne!(decided(&format!("({sum})^2 <= 40*({squares}) - x1*x2/1000000")).0, Verdict::Holds);
}

/// The answer tells where the margin is 0, and what is open.
#[test]
fn the_point_of_equality_and_the_open_part_are_told() {
    let found = answer(&asked("x = \"[-1, 2]\"", "exp(x) >= 1 + x", "exp(x) > 1 + x"));
    assert!(found.text(None).contains("smallest margin = 0 at (x = 0)"), "{}", found.text(None));
    // Equal along a curve that no polynomial tells: undecided, with the share that is open.
    let property = "exp(x*y)*(2 + sin(x)) >= (1 + x*y)*(2 + sin(x))";
    let found = answer(&asked("x = \"[-1, 1]\"\ny = \"[-1, 1]\"", property, "1 < 0"));
    assert_eq!(found.verdict, Verdict::Undecided);
    let document = found.json(None);
    assert!(document["open"]["boxes"][0]["x"].is_string(), "{document}");
    assert!(found.why.contains("of the volume"), "{}", found.why);
}

/// In several numbers, too, a point of equality is told in closed form, and refutes what is said to be strict; where none is known, that is told.
#[test]
fn points_of_equality_without_rational_coordinates() {
    let sides = "exp(x) - 2*x + exp(y) - 3*y RELATION 5 - 2*log(2) - 3*log(3)";
    let family = "x = \"[-2, 2]\"\ny = \"[-2, 2]\"";
    let found = answer(&asked(family, &sides.replace("RELATION", ">="), "1 < 0"));
    assert!(found.text(None).contains("smallest margin = 0 at (x = log(2), y = log(3))"), "{}", found.text(None));
    let found = answer(&asked(family, &sides.replace("RELATION", ">"), "1 < 0"));
    assert_eq!(found.verdict, Verdict::False);
    assert!(found.text(None).contains("x = log(2), y = log(3), exactly"), "{}", found.text(None));
    // The point lies outside, or another literal is true at it.
    assert_eq!(verdict("x = \"[-2, 2/3]\"\ny = \"[-2, 2]\"", &sides.replace("RELATION", ">")), Verdict::Holds);
    let guarded = format!("x + y = log(6) or {}", sides.replace("RELATION", ">"));
    assert_ne!(verdict(family, &guarded), Verdict::False);
    // A cube root has none of the forms that are tried.
    let found = answer(&asked("x = \"[1, 2]\"\ny = \"[-1, 1]\"", "exp(x^3 - 2) + y^2*exp(y) >= x^3 - 1", "1 < 0"));
    assert_ne!(found.verdict, Verdict::False);
    let least = "there is one point, proved by Newton's method in intervals, at which their difference is least; it is at most 10^-";
    let told = found.why.contains(least) && found.why.contains("no identity tells whether it is 0");
    assert!(found.verdict == Verdict::Holds || told, "{}", found.why);
}

/// Without a closed form a point of equality is enclosed, where the function is a sum of squares as it is written; it refutes what is strict.
#[test]
fn points_of_equality_without_a_closed_form() {
    let family = "x = \"[-2, 2]\"\ny = \"[-2, 3]\"";
    let told = |property: &str| answer(&asked(family, property, "1 < 0")).text(None);
    for (property, place) in [
        ("(x^3+x-3)^2 + (y-x)^2 >= 0", "smallest margin = 0 at (x in [1.2134"),
        ("(x^3+x-3)^2 + (y-x)^2*exp(x) >= 0", "smallest margin = 0 at (x in [1.2134"),
        ("(x^2-2)^2 + (y-2)^2 >= 0", "sqrt(2), y = 2)"),
        ("(x^3+x-3)^2 + (y-x)^2 > 0", "counterexample: x in [1.2134"),
    ] {
        assert!(told(property).contains(place), "{}", told(property));
    }
    let above = told("(x^3+x-3)^2 + (y-x)^2 + 1/1000000000 >= 0");
    assert!(!above.contains("= 0 at"), "{above}");
    // Kinks have no slopes, and roots no finite ones: what stands in them has.
    for sum in [
        "(x^3+x-3)^2 + abs(y-x)",
        "abs(x^3+x-3) + abs(y-x)",
        "abs(x^3+x-3) + sqrt(abs(y-x))",
        "max(abs(x^3+x-3), abs(y-x))",
        "abs((x^3+x-3)*exp(y)) + abs(y-x)",
    ] {
        let strict = told(&format!("{sum} > 0"));
        assert!(strict.contains("counterexample: x in [1.2134"), "{strict}");
        assert!(told(&format!("{sum} + 1/1000000000 > 0")).contains("holds"), "{sum}");
        assert!(!told(&format!("{sum} + abs(y - x - 1/1000000000) > 0")).contains("counterexample"), "{sum}");
    }
    assert!(!told("min(abs(x^3+x-3), 1) + abs(y-x) + abs(y+x) > 0").contains("counterexample"));
}

/// True wherever there is a value, with a point at which there is none: no rule may make `holds` of that.
#[test]
fn no_rule_hides_a_missing_value() {
    for (family, property) in [
        ("x = \"[-1, 1]\"", "0*sqrt(x) >= 0"),
        ("x = \"[-1, 1]\"", "sqrt(x)^2 >= 0"),
        ("x = \"[-1, 1]\"", "1/(1/x) = x"),
        ("x = \"any\"", "x/x = 1"),
        ("x = \"any\"", "exp(log(x)) > 0"),
        ("x = \"any\"", "(x^2 - 2)/(x^2 - 2) = 1"),
        ("x = \"[0, 2]\"", "(x^2 - 2)/(x^2 - 2) >= 1"),
        ("x = \"[0, 1]\"", "x*log(x) <= 0"),
        ("x = \"[0, 1]\"", "min(1/x, 1) <= 1"),
        ("x = \"[0, 1]\"\nwhere = \"x >= 0\"", "1/x >= 1"),
        ("x = \"[-1, 1]\"", "x >= 0 or log(x + 1) <= 0"),
        ("x = \"[-1, 1]\"", "sqrt(x) >= 0 implies x >= 0"),
        ("x = \"[-1, 1]\"\ny = \"[-1, 1]\"", "x = y implies 0/(x - y) = 0"),
        ("n = \"integers(-1000, 1000)\"", "n/n = 1"),
        ("x = \"any\"\nwhere = \"1/x > 0\"", "x > 0"),
    ] {
        let found = decide(&read(&asked(family, property, "1 < 0")).expect("a question"), &Unwatched);
        assert!(!found.is_ok_and(|answer| answer.verdict == Verdict::Holds), "{family}, {property}");
    }
    // Beside them, what is protected.
    for (family, property) in [
        ("x = \"[0, 1]\"\nwhere = \"x > 0\"", "1/x >= 1"),
        ("x = \"[-1, 1]\"", "x > -1 implies (x >= 0 or log(x + 1) <= 0)"),
        ("n = \"integers(-1000, 1000)\"", "n != 0 implies n/n = 1"),
    ] {
        assert_eq!(verdict(family, property), Verdict::Holds, "{family}, {property}");
    }
    // A sine of a multiple of pi is a number; of pi divided by a variable it is not.
    let narrow = "x = \"[999999/1000000, 1000001/1000000]\"";
    assert_eq!(verdict(narrow, "sin(pi/(6*x)) >= 1/2"), Verdict::False);
    assert_eq!(verdict(narrow, "sin(pi/(6*x)) <= 1/2"), Verdict::False);
}

/// Sums of powers of all eigenvalues are traces, also where each of them is irrational.
#[test]
fn sums_of_eigenvalues_are_exact() {
    let all = "g = \"connected(5)\"";
    assert_eq!(verdict(all, "sum(i, lambda(i)) = 2*edges"), Verdict::Holds);
    assert_eq!(verdict(all, "sum(i, lambda(i)^2) = sum(i, degree(i)^2 + degree(i))"), Verdict::Holds);
    assert_eq!(verdict(all, "sum(i, lambda(i)) <= 2*edges - 1/1000000000"), Verdict::False);
    assert_eq!(verdict(all, "sum(i, lambda(i)^2) = sum(i, degree(i)^2) + 2*edges + 1/1000000000"), Verdict::False);
}

/// Numbers that are equal by identities, without an interval.
#[test]
fn single_numbers_are_compared_exactly() {
    assert_eq!(verdict("", "exp(log(2)) = 2 and sqrt(2)*sqrt(3) = sqrt(6)"), Verdict::Holds);
    assert_eq!(verdict("", "exp(log(2)) < 2"), Verdict::False);
    assert_eq!(verdict("", "exp(log(2)) = 2 + 1/1000000000"), Verdict::False);
}
