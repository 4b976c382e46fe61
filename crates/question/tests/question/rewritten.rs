//! Inequalities in other numbers: what functions have in common, logarithms taken away, powers under roots, exponentials in the place of numbers, sums of functions of
//! different numbers, roots as numbers in sums of squares, surfaces.

use super::{answer, asked, holds_exactly, verdict};
use question::Verdict;

const PLANE: &str = "x = \"any\"\ny = \"any\"";
const SPACE: &str = "x = \"any\"\ny = \"any\"\nz = \"any\"";
const SQUARE: &str = "x = \"[-1, 1]\"\ny = \"[-1, 1]\"";
const UNIT: &str = "x = \"[0, 1]\"\ny = \"[0, 1]\"";

/// Domains, the property with `EPS` where a small number goes that makes it false.
const TRUE: &[(&str, &str)] = &[
    // A polynomial in common.
    (PLANE, "exp(x^2 - y) >= 1 + x^2 - y + EPS"),
    (PLANE, "exp(x*y) >= 1 + x*y + EPS"),
    (SPACE, "exp(x*y*z) >= 1 + x*y*z + EPS"),
    (SQUARE, "exp(x*y) >= 1 + x*y + EPS"),
    (UNIT, "sin(x*y) <= x*y - EPS"),
    (PLANE, "cos(x^2 + y) >= 1 - (x^2 + y)^2/2 + EPS"),
    // A function in common.
    (PLANE, "sin(sqrt(x^2 + y^2)) <= sqrt(x^2 + y^2) - EPS"),
    ("x = \"any\"", "x <= 1 or log(log(x)) <= log(x) - 1 - EPS"),
    // Logarithms.
    (PLANE, "log(exp(x) + exp(y)) >= (x + y)/2 + log(2) + EPS"),
    (SPACE, "log((exp(x) + exp(y) + exp(z))/3) >= (x + y + z)/3 + EPS"),
    ("x = \"[1/100, 100]\"\ny = \"[1/100, 100]\"", "(log(x) + log(y))/2 <= log((x + y)/2) - EPS"),
    // Roots of products.
    ("x = \"[0, 2]\"\ny = \"[0, 2]\"", "x*y <= x^3/3 + 2*y^(3/2)/3 - EPS"),
    (UNIT, "((x + y)/2)^(1/3) >= (x^(1/3) + y^(1/3))/2 + EPS"),
    // Exponentials.
    ("x = \"any\"", "x <= 0 or log(x) <= 50/exp(1)*x^(1/50) - EPS"),
    (PLANE, "y <= 0 or x*y <= exp(x) + y*log(y) - y - EPS"),
    // Sums.
    (PLANE, "exp(x) + exp(y) >= 2 + x + y + EPS"),
    (PLANE, "exp(x) - 2*x + exp(y) - 3*y >= 5 - 2*log(2) - 3*log(3) + EPS"),
    (SPACE, "exp(x) + y^2 + cosh_of_z >= 2 + x + EPS"),
    // Roots as numbers.
    (SQUARE, "abs(x*sqrt(1 - y^2) + y*sqrt(1 - x^2)) <= 1 - EPS"),
    (SQUARE, "sqrt(1 - x^2)*sqrt(1 - y^2) + x*y <= 1 - EPS"),
    // Angles within half a turn.
    ("x = \"[0, 3]\"\ny = \"[0, 3]\"", "sin((x + y)/2) >= (sin(x) + sin(y))/2 + EPS"),
    ("x = \"[0, 3]\"\ny = \"[0, 3]\"", "sin(x + y) <= sin(x) + sin(y) - EPS"),
    // Surfaces.
    (SPACE, "x^2 + y^2 + z^2 = 1 implies x*y + y*z + z*x <= 1 - EPS"),
    (PLANE, "x^2 + y^2 = 1 implies x + y <= sqrt(2) - EPS"),
    // Divided by what is 0 at a point only.
    (PLANE, "x = 0 or x^2*y/(x^4 + y^2) <= 1/2 - EPS"),
];

#[test]
fn what_is_attained_in_other_numbers_is_decided() {
    for (family, property) in TRUE {
        let property = property.replace("cosh_of_z", "(exp(z) + exp(-z))/2");
        holds_exactly(family, &property, &["1/1000", "1/1000000", "1/1000000000"]);
    }
}

/// Not attained, or never decided before.
#[test]
fn what_is_strict_in_other_numbers_is_decided() {
    for (family, property) in [
        ("x = \"any\"", "exp(-exp(-x)) > 0"),
        (PLANE, "exp(-exp(-x)) + exp(-x - y^2) > 0"),
        ("x = \"[0, 1]\"", "x = 0 or exp(1/x) > 1"),
        (PLANE, "x = 0 or x^4 + y^2 > 0"),
        (PLANE, "x = 0 or x^4 + y^2 != 0"),
    ] {
        assert_eq!(verdict(family, property), Verdict::Holds, "{property}");
    }
    for (family, property, place) in [
        ("x = \"[0, 1]\"", "x = 0 or sin(1/x) > -1", "x = 2/(3*pi)"),
        ("x = \"any\"", "x <= 0 or log(x) < 1000", "x = exp(1000)"),
        ("x = \"any\"", "x <= 0 or log(x) < 50/exp(1)*x^(1/50)", "x = exp(50)"),
    ] {
        let found = answer(&asked(family, property, "1 < 0"));
        assert_eq!(found.verdict, Verdict::False, "{property}: {}", found.why);
        assert!(found.text(None).contains(&format!("counterexample: {place}, exactly")), "{}", found.text(None));
    }
}

/// Planted: parts that nearly agree, ranges that nearly exclude what fails, logarithms of negative numbers, numbers at 0, least values at different points.
#[test]
fn what_nearly_has_a_common_part_is_not_said_to_hold() {
    for (family, property) in [
        (SQUARE, "exp(x*y) >= 1 + x*y + x/10^9"),
        (SQUARE, "exp(x*y) >= 1 + 1000000001*x*y/10^9"),
        (PLANE, "exp(x^2 - y) >= 1 + x^2 - y + y/10^9"),
        (UNIT, "x*y <= 999999999/10^9 or x > 1"),
        ("x = \"[0, 11/10]\"\ny = \"[0, 1]\"", "exp(x*y) <= 3"),
        ("x = \"[-2, -1]\"\ny = \"[-2, -1]\"", "log(x*y) + exp(x*y - 1) <= 1"),
        ("x = \"[-2, -1]\"\ny = \"[-2, -1]\"", "log(x*y) <= 1386/1000"),
        ("x = \"[-2, -1]\"\ny = \"[-2, -1]\"", "log(log(x*y) + 1) <= 869/1000"),
        ("x = \"[0, 60]\"", "x = 0 or log(x) <= 147/100*x^(1/4)"),
        ("x = \"[0, 1]\"\ny = \"[0, 1]\"\nz = \"[0, 1]\"", "(x*y*z)^(1/3) < (x + y + z)/3"),
        ("x = \"[0, 2]\"\ny = \"[0, 2]\"", "(x*y)^(1/3) <= 1587401/1000000"),
        (PLANE, "exp(x) + exp(y) > 2 + x + y"),
        (PLANE, "exp(x) - x + exp(y) - 2*y >= 3 - 2*log(2) + 1/10^12"),
        (SQUARE, "x*sqrt(1 - y^2) + y*sqrt(1 - x^2) < 1"),
        ("x = \"[0, 32/10]\"\ny = \"[0, 32/10]\"", "sin(x + y) <= sin(x) + sin(y)"),
        ("x = \"[-1/1000, 3]\"\ny = \"[-1/1000, 3]\"", "sin(x + y) <= sin(x) + sin(y)"),
        (PLANE, "x^2 + y^2 = 1 implies x + y < sqrt(2)"),
        (PLANE, "x^2 + y^2 = 1 implies x*y <= 499999/1000000"),
        (SPACE, "x^2 + y^2 + z^2 = 1 implies x*y*z <= 192/1000"),
        (PLANE, "x = 0 or x^4 + y^2 > x^4/10^9 + x^6"),
        ("x = \"any\"", "x = 0 or exp(1/x) > 1/10^9"),
        ("x = \"any\"", "exp(-exp(-x)) > exp(-exp(-x - 1))/2"),
        // A common part along which a function has no value at one place, and another sign beyond.
        (
            "x = \"[-1, 1]\"\ny = \"[0, 2]\"\nz = \"[-1, 1]\"",
            "x = 0 or z = 0 or sqrt((x*z)^2)/(x*z) + exp(x*z)/exp(x*z) + (exp(y) - y - 2)^2 > 0",
        ),
        (
            "x = \"[-1, 1]\"\ny = \"[0, 2]\"\nz = \"[-1, 1]\"",
            "x = 0 or z = 0 or exp(x*z)*(sqrt((x*z)^2)/(x*z) + 1 + (exp(y) - y - 2)^2) >= exp(x*z)/10^9",
        ),
    ] {
        assert_ne!(verdict(family, property), Verdict::Holds, "{property}");
    }
}

/// The slow twin: statements about one number with polynomials in two in its place, beside exact values on a grid.
#[test]
fn common_parts_agree_with_a_grid() {
    const OUTER: &[&str] = &[
        "exp(T) >= 1 + T + EPS",
        "sin(T)^2 <= T^2 - EPS",
        "cos(T) >= 1 - T^2/2 + EPS",
        "1/(1 + T^2) <= 1 - EPS",
        "abs(T) <= (1 + T^2)/2 - EPS",
        "exp(-T^2) <= 1/(1 + T^2) - EPS",
        "T <= 2 - EPS",
        "T >= -1 + EPS",
    ];
    const INNER: &[&str] = &["x*y", "x^2 - y", "x^2 + y^2", "x - 3*y^2", "x*y + y^2", "x^2*y - 1", "(x + y)^3"];
    for outer in OUTER {
        for (number, inner) in INNER.iter().enumerate() {
            for eps in ["0", "-1/1000000", "1/1000000"] {
                let property = outer.replace('T', &format!("({inner})")).replace("EPS", &format!("({eps})"));
                let found = verdict(SQUARE, &property);
                let fails = (0..5usize).any(|k| {
                    let (p, q) = ((2 * k + number) % 9, (3 * k + 2 * number) % 9);
                    let point = format!("x = \"{}/4\"\ny = \"{}/4\"", p as i64 - 4, q as i64 - 4);
                    verdict(&point, &property) == Verdict::False
                });
                assert!(!(found == Verdict::Holds && fails), "{property}");
                assert!(fails || found != Verdict::Undecided, "{property} stays open");
            }
        }
    }
}
