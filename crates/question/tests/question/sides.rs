//! Inequalities in several numbers that are attained along lines: what depends on a sum or a difference only, and what is homogeneous.

use super::{answer, asked, holds_exactly, verdict};
use question::Verdict;

/// Domains, the property with `EPS` where a small number goes that makes it false.
const TRUE: &[(&str, &str)] = &[
    // Along parallel lines.
    ("x = \"[-1, 1]\"\ny = \"[-1, 2]\"", "exp(x + y) >= 1 + x + y + EPS"),
    ("x = \"any\"\ny = \"any\"", "exp(x + y) >= 1 + x + y + EPS"),
    ("x = \"any\"\ny = \"any\"", "exp(-(x - 2*y)^2) <= 1/(1 + (2*y - x)^2) - EPS"),
    ("x = \"[0, 2]\"\ny = \"[0, 2]\"\nz = \"[0, 1]\"", "cos(x - y + 3*z) >= 1 - (y - x - 3*z)^2/2 + EPS"),
    // Along rays.
    ("x = \"[1, 2]\"\ny = \"[1, 3]\"", "y*log(y/x) >= y - x + EPS"),
    ("x = \"[0, 1]\"\ny = \"[0, 2]\"\nz = \"[0, 3]\"", "(x*y*z)^(1/3) <= (x + y + z)/3 - EPS"),
    (
        "x = \"[0, 1]\"\ny = \"[0, 1]\"\nz = \"[0, 1]\"",
        "x*(x - y)*(x - z) + y*(y - x)*(y - z) + z*(z - x)*(z - y) >= EPS",
    ),
    ("x = \"any\"\ny = \"any\"\nz = \"any\"", "x^4*y^2 + x^2*y^4 + z^6 >= 3*x^2*y^2*z^2 + EPS"),
    ("x = \"[-1, 1]\"\ny = \"[-1, 1]\"\nz = \"[-2, 1]\"", "x^4*y^2 + x^2*y^4 + z^6 >= 3*x^2*y^2*z^2 + EPS"),
    ("x = \"any\"\ny = \"any\"\nz = \"any\"\nw = \"any\"", "x^4 + y^4 + z^4 + w^4 >= 4*x*y*z*w + EPS"),
];

#[test]
fn what_is_attained_along_lines_is_decided_on_the_sides() {
    for (family, property) in TRUE {
        holds_exactly(family, property, &["1/1000", "1/1000000", "1/1000000000"]);
    }
}

/// Planted: nearly homogeneous, nearly a function of the sum, a guard that is neither, and what fails on a side, inside or at 0 only.
#[test]
fn what_fails_somewhere_is_not_said_to_hold() {
    let square = "x = \"[0, 1]\"\ny = \"[0, 1]\"";
    for (family, property) in [
        (square, "x^2 + y^2 - 199/100*x*y >= 1/10^9*x"),
        (square, "exp(x + y) >= 1 + x + y + x/10^9"),
        (square, "x <= 1/2 or x^2 - 2*x*y + y^2 >= 1/10^12"),
        (square, "x*y*(x - y)^2 > 0"),
        (square, "x + y > 0"),
        ("x = \"any\"\ny = \"any\"", "x^2 + y^2 > 0"),
        ("x = \"any\"\ny = \"any\"", "x^2 - 2*y^2 != 0 or x = 0"),
        ("x = \"[-1, 0]\"\ny = \"[0, 1]\"", "sqrt(x^2 + y^2) + x >= 1/10^6*y - x/10^6"),
        ("x = \"[1, 2]\"\ny = \"[-1, 1]\"", "x^2*y <= x^3 - 1/10^6*x^2*y and x*y^2 >= 0"),
    ] {
        assert_ne!(verdict(family, property), Verdict::Holds, "{property}");
    }
}

/// Over all reals a margin at some points bounds the smallest one from above only.
#[test]
fn margins_over_all_reals_have_no_lower_end_of_their_own() {
    for (family, property) in [
        ("x = \"any\"\nwhere = \"x > 0\"", "exp(-1/x)/x <= exp(-1)"),
        ("x = \"any\"\nwhere = \"x >= 1\"", "sqrt(x - 1) <= x + 1/2"),
        ("x = \"any\"\ny = \"any\"\nwhere = \"x > 0 and y > 0\"", "x*log(x/y) >= x - y"),
    ] {
        let found = answer(&asked(family, property, "1 < 0"));
        assert_eq!(found.verdict, Verdict::Holds, "{property}: {}", found.why);
        assert!(found.margin.is_none_or(|margin| margin.lo <= 0.0), "{property}: {:?}", found.margin);
    }
}

/// A margin that is 0 is told at a point at which it is.
#[test]
fn the_point_of_a_margin_is_one_of_equality() {
    for (property, place) in [("x^(1/2) <= (1 + x)/2", "x = 1"), ("x^(1/5) <= (4 + x)/5", "x = 1")] {
        let found = answer(&asked("x = \"[0, 5]\"", property, "1 < 0"));
        assert_eq!(found.attained.map(|at| at.to_string()), Some(place.to_string()), "{property}");
    }
}
