//! Inequalities in one number with any of the language's functions, attained at rational, algebraic and transcendental places, inside and at ends.

use super::{answer, asked, holds_exactly, verdict};
use question::Verdict;

/// Domain of `x`, the property with `EPS` where a small number goes that makes it false.
const TRUE: &[(&str, &str)] = &[
    // At rational numbers, with constants that are not.
    ("[-3, 3]", "exp(x) >= exp(1)*x + EPS"),
    ("[1/10, 10]", "x - log(x) >= 1 + EPS"),
    ("[0, 5]", "x*exp(-x) <= exp(-1) - EPS"),
    ("[0, 10]", "x^2*exp(-x) <= 4*exp(-2) - EPS"),
    ("[0, 3]", "x*exp(-2*x^2) <= exp(-1/2)/2 - EPS"),
    ("[0, 10]", "sqrt(x)*exp(-x) <= exp(-1/2)*sqrt(1/2) - EPS"),
    ("[0, 10]", "cos(x) <= cos(1) - sin(1)*(x - 1) + (x - 1)^2/2 - EPS"),
    ("[0, 3]", "2^x >= 1 + x*log(2) + EPS"),
    ("[0, 4]", "log(1 + exp(x)) >= log(2) + x/2 + EPS"),
    ("[0, 1]", "x*(1 - x) <= exp(-2*log(2)) - EPS"),
    ("[1/2, 4]", "sqrt(x) <= exp(x/2 - 1/2) - EPS"),
    ("[-2, 2]", "(exp(x) + exp(-x))/2 >= 1 + EPS"),
    ("[-5, 5]", "x >= 0 implies (exp(2*x) - 1)/(exp(2*x) + 1) <= x - EPS"),
    ("[-10, 10]", "x/(1 + x^2) <= 1/2 - EPS"),
    ("[0, 5]", "(x - 1)^2*exp(-x) >= EPS"),
    // At roots.
    ("[0, 3]", "x*exp(-x^2) <= exp(-1/2)/sqrt(2) - EPS"),
    ("[1/10, 10]", "x^2 - 4*log(x) >= 2 - 2*log(2) + EPS"),
    ("[1/10, 10]", "x + 2/x >= 2*sqrt(2) + EPS"),
    ("[-1, 1]", "abs(x^3 - x) <= 2*sqrt(3)/9 - EPS"),
    ("[0, 4]", "max(x, 3 - x^2) >= (sqrt(13) - 1)/2 + EPS"),
    ("[0, 2]", "(x^2 - 2)^2*exp(x) >= EPS"),
    ("[0, 2]", "x <= sqrt(2) implies x^2*exp(x) <= 2*exp(sqrt(2)) - EPS"),
    // At logarithms and exponentials.
    ("[-3, 3]", "exp(x) >= 2*x + 2 - 2*log(2) + EPS"),
    ("[1/100, 3]", "x*log(x) >= -exp(-1) + EPS"),
    ("[1/10, 2]", "x^x >= exp(-exp(-1)) + EPS"),
    ("[1/10, 10]", "log(x)/x <= exp(-1) - EPS"),
    ("[1/2, 4]", "x^(1/x) <= exp(exp(-1)) - EPS"),
    ("[-2, 2]", "exp(2*x) >= 6*exp(x) - 9 + EPS"),
    ("[0, 2]", "x >= log(2) implies exp(x) >= 2 + 2*(x - log(2)) + (x - log(2))^2 + EPS"),
    ("[-3, 3]", "abs(exp(x) - 2) >= EPS"),
    // At parts of a turn.
    ("[0, 3]", "sin(x) <= 1 - EPS"),
    ("[0, 4]", "cos(x) >= -1 + EPS"),
    ("[0, 2]", "x <= pi/2 implies sin(x) >= 2*x/pi + EPS"),
    ("[0, 3]", "sin(x) + cos(x) <= sqrt(2) - EPS"),
    ("[0, 3]", "exp(-x)*sin(x) <= exp(-pi/4)*sqrt(2)/2 - EPS"),
    ("[0, 3/2]", "max(sin(x), cos(x)) >= sqrt(2)/2 + EPS"),
    ("[0, 6]", "exp(sin(x)) <= exp(1) - EPS"),
    ("[0, 7]", "sin(x)*(1 + cos(x)) <= 3*sqrt(3)/4 - EPS"),
    ("[-5, 5]", "abs(sin(x)) <= abs(x) - EPS"),
    // With ends far out.
    ("any", "exp(-x^2) <= 1/(1 + x^2) - EPS"),
    ("any", "x^2*exp(-x^2) <= exp(-1) - EPS"),
    ("any", "exp(-abs(x)) <= 1/(1 + abs(x)) - EPS"),
    ("any", "log(1 + x^2) <= abs(x) - EPS"),
    ("any", "x*sin(x) <= x^2 - EPS"),
    ("any", "(exp(x) + exp(-x))/2 <= exp(x^2/2) - EPS"),
    ("any", "x <= 0 or log(x) <= 3*(x^(1/3) - 1) - EPS"),
    // Where there is no slope.
    ("[0, 5]", "x^(1/5) <= (4 + x)/5 - EPS"),
    ("[-1, 4]", "(1 + x)^(1/3) <= 1 + x/3 - EPS"),
    ("[0, 5]", "sqrt(x)*sin(sqrt(x)) <= x - EPS"),
    ("[0, 1]", "x = 0 or x^x >= exp(-exp(-1)) + EPS"),
    ("[0, 3]", "x = 0 or x*log(x) >= x - 1 + EPS"),
    ("[0, 1]", "x = 0 or exp(-1/x) <= exp(-1)*x - EPS"),
    ("[0, 2]", "x^(1/3)*(2 - x) <= 3/2*(1/2)^(1/3) - EPS"),
    // At roots of other degree.
    ("[0, 4]", "x^3 - 3*x*2^(2/3) + 4 >= EPS"),
    ("[0, 2]", "x^5 + 12 >= 5*3^(4/5)*x + EPS"),
    ("[-3, 3]", "abs(x^3 + 2) >= EPS"),
    // Everywhere, by identities.
    ("any", "sin(x)^2 + cos(x)^2 = 1 + EPS"),
    ("any", "sin(x/2)^2 = (1 - cos(x))/2 + EPS"),
    ("any", "3*sin(x) - 4*sin(x)^3 = sin(3*x) + EPS"),
    ("[1, 3]", "log(3*x) = log(3) + log(x) + EPS"),
    ("[1/10, 10]", "log(x^2) = 2*log(x) + EPS"),
    ("[1/10, 10]", "exp(log(x)) = x + EPS"),
    ("[-2, 2]", "sqrt(x^2) = abs(x) + EPS"),
];

/// False at one number only, which is not rational, or at which an identity tells.
const FALSE: &[(&str, &str, &str)] = &[
    ("[0, 3]", "sin(x) < 1", "x = pi/2"),
    ("[0, 2]", "x^2 != 2", "x = sqrt(2)"),
    ("[0, 2]", "(x^2 - 2)^2 > 0", "x = sqrt(2)"),
    ("[0, 2]", "exp(x) != 2", "x = log(2)"),
    ("[1/100, 3]", "x*log(x) > -exp(-1)", "x = exp(-1)"),
    ("[0, 5]", "x*exp(-x) < exp(-1)", "x = 1"),
    ("[0, 4]", "x^3 - 3*x*2^(2/3) + 4 > 0", "x = 2^(1/3)"),
];

#[test]
fn one_number_is_decided_wherever_the_inequality_is_attained() {
    for (domain, property) in TRUE {
        holds_exactly(&format!("x = \"{domain}\""), property, &["1/1000", "1/1000000", "1/1000000000"]);
    }
}

#[test]
fn a_property_may_fail_at_one_number_only() {
    let mut wrong = Vec::new();
    for (domain, property, place) in FALSE {
        let found = answer(&asked(&format!("x = \"{domain}\""), property, "1 < 0"));
        let closed = found.closed.as_ref().map(ToString::to_string).unwrap_or_default();
        if (found.verdict, closed.as_str()) != (Verdict::False, *place) {
            wrong.push(format!("{property}: {:?} {closed} {}", found.verdict, found.why));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // Where there is no value nothing fails.
    let found = verdict("x = \"[0, 2]\"", "(x^2 - 2)^2/(x^2 - 2)^2 = 1 or (x^2 - 2)^2 > 0");
    assert_ne!(found, Verdict::Holds);
}

/// Two roots that are one, as no identity tells: named, and not decided.
#[test]
fn a_coincidence_is_named() {
    let found = answer(&asked("x = \"[0, 1]\"", "(2 + cos(x))*(exp(x)*exp(sin(x) - 1) - x - sin(x)) >= 0", "1 < 0"));
    assert_eq!(found.verdict, Verdict::Undecided);
    assert!(found.why.contains("agree to 2^-") && found.why.contains("0.51097342938"), "{}", found.why);
    // Without the factor both sides are functions of one number, `x + sin(x)`.
    assert_eq!(verdict("x = \"[0, 1]\"", "exp(x)*exp(sin(x) - 1) >= x + sin(x)"), Verdict::Holds);
    assert_eq!(verdict("x = \"[0, 1]\"", "exp(x)*exp(sin(x) - 1) > x + sin(x)"), Verdict::False);
}

/// Roots of other degree than 2, 4 and 8 of numbers that are above 0.
#[test]
fn other_roots_of_positive_numbers_are_decided_where_they_are_attained() {
    for (range, property, is_true) in [
        ("[1/10, 5]", "x^(1/3) <= (2 + x)/3", true),
        ("[1/10, 5]", "x^(1/3) <= (2 + x)/3 - 1/10^9", false),
        ("[1/10, 5]", "x^(1/3) < (2 + x)/3", false),
        ("[-1/2, 3]", "(1 + x)^(1/3) <= 1 + x/3", true),
        ("[-1/2, 3]", "(1 + x)^(2/5) <= 1 + 2*x/5", true),
        ("[-1/2, 3]", "(1 + x)^(2/5) <= 1 + 2*x/5 - x/10^6", false),
        ("[1/10, 5]", "x^(-1/3) >= (4 - x)/3", true),
    ] {
        let expected = if is_true { Verdict::Holds } else { Verdict::False };
        assert_eq!(verdict(&format!("x = \"{range}\""), property), expected, "{property}");
    }
    assert_eq!(verdict("x = \"integers(1, 100000)\"\ny = \"integers(1, 100000)\"", "x^2 - 2*y^2 != 1"), Verdict::False);
}

/// Numbers without a closed form, by the equation that a part of the property gives.
#[test]
fn what_is_attained_at_a_solution_of_an_equation_is_decided() {
    for (property, is_true) in [
        ("x >= cos(x) or exp(x) < exp(cos(x))", true),
        ("x > cos(x) or exp(x) < exp(cos(x))", false),
        ("exp(cos(x)) >= exp(x)*(1 + cos(x) - x)", true),
        ("exp(cos(x)) >= exp(x)*(1 + cos(x) - x) + x/10^12", false),
        ("log(2 + x - cos(x)) <= log(2) + (x - cos(x))/2", true),
        ("log(2 + x - cos(x)) < log(2) + (x - cos(x))/2", false),
        ("exp(x^3 + x - 1) >= x^3 + x", true),
        ("exp(x^3 + x - 1) >= x^3 + x + (x^3 + x - 1)/10^9", false),
        ("exp(x^3 + x - 1) >= x^3 + x + 1/10^12", false),
    ] {
        let expected = if is_true { Verdict::Holds } else { Verdict::False };
        assert_eq!(verdict("x = \"[0, 1]\"", property), expected, "{property}");
    }
}

/// The place at which the margin is 0 is told.
#[test]
fn a_margin_of_zero_has_its_place() {
    for (property, place) in [
        ("x*log(x) >= -exp(-1)", "x = exp(-1)"),
        ("x^2 - 4*log(x) >= 2 - 2*log(2)", "x = sqrt(2)"),
        ("x*exp(-x) <= exp(-1)", "x = 1"),
    ] {
        let text = answer(&asked("x = \"[1/100, 3]\"", property, "1 < 0")).text(None);
        assert!(text.contains("smallest margin = 0 at (") && text.contains(place), "{text}");
    }
}

/// A place just outside of the domain is not where the margin is 0, however near it is for floats.
#[test]
fn a_margin_of_zero_is_told_within_the_domain() {
    let factor = |q: i64| format!("(exp(x) - exp(sqrt({q}))*(1 + x - sqrt({q})))");
    let text = asked(
        "x = \"[141421356237309504881/100000000000000000000, 2]\"",
        &format!("{}*{} >= 0", factor(2), factor(3)),
        "x < 0",
    );
    let found = answer(&text);
    assert_eq!(found.verdict, Verdict::Holds);
    assert!(found.text(None).contains("= 0 at (x = sqrt(3))"), "{}", found.text(None));
}

/// Fine parts of an angle beside large multiples of it are not added up without end.
#[test]
fn fine_parts_of_angles_take_no_time() {
    let text = asked(
        "x = \"[1, 2]\"",
        "exp(x^2 - 2) >= x^2 - 1 + (sin(x) - 2*sin(x/2)*cos(x/2))*cos(8*x)*sin(x/16)*sin(x/45)",
        "x < 0",
    );
    assert_ne!(answer(&text).verdict, Verdict::False);
}
