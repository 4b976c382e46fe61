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

#[test]
fn inequalities_that_are_attained_are_decided() {
    for (family, property) in ATTAINED {
        let started = std::time::Instant::now();
        let found = answer(&asked(family, &property.replace("EPS", "0"), "1 < 0"));
        println!("{:?} {property} {:?} {}", started.elapsed(), found.verdict, found.why);
    }
    for (family, property) in ATTAINED {
        let found = answer(&asked(family, &property.replace("EPS", "0"), "1 < 0"));
        assert_eq!(found.verdict, Verdict::Holds, "{property}: {}", found.why);
        for small in ["1/1000", "1/1000000"] {
            assert_eq!(verdict(family, &property.replace("EPS", small)), Verdict::False, "{property} with {small}");
        }
    }
}
