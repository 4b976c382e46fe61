//! Values that are missing, in three-valued logic, and names that nothing uses or that contradict each other.

use super::{asked, refusal, refusal_with, verdict};
use question::Verdict;

/// The same numbers as members, as boxes of integers, as a continuum.
const RANGES: [&str; 3] = ["-3..1", "integers(-3, 1)", "[-3, 1]"];

#[test]
fn what_decides_alone_decides_whatever_is_missing() {
    for range in RANGES {
        let family = format!("x = \"{range}\"");
        for property in [
            "x/x*(x*x) >= 0 or x >= -5",
            "x >= -5 or x/x*(x*x) >= 0",
            "x > 5 implies 1/x > 0",
            "not (1/x > 0 and x > 5)",
            "x < 5 or log(x) > 0",
            "x > 5 implies x^(1/3) > 0",
            "x > 5 implies sqrt(x) > 0",
            "not (sqrt(x - 9) > 0 and x > 5)",
        ] {
            assert_eq!(verdict(&family, property), Verdict::Holds, "{range}: {property}");
        }
        // A counterexample decides as well.
        assert_eq!(verdict(&family, "1/x != -1/2"), Verdict::False, "{range}");
        assert_eq!(verdict(&family, "1/(x + 3) > 2 and x > -1"), Verdict::False, "{range}");
        // Between 0 and 1/2 it is false; without numbers there, what is missing at 0 is told.
        if range.starts_with('[') {
            assert_eq!(verdict(&family, "x < 1/2 and 1/x < 2 or x >= 1/2"), Verdict::False);
        }
        let where_guards = format!("{family}\nwhere = \"x < -1 or x > 9\"");
        assert_eq!(verdict(&where_guards, "1/x < 0 and (-x)^(1/2) > 1/2"), Verdict::Holds, "{range}");
    }
}

#[test]
fn a_value_that_matters_and_is_missing_is_refused_with_its_point() {
    for range in RANGES {
        for (property, named) in [
            ("x/x = 1", "division by zero where x = 0"),
            ("1/(x + 3) > 0", "division by zero where x = -3"),
            ("x < 1/2 and x/x = 1 or x >= 1/2", "division by zero where x = 0"),
            ("log(x + 3) < 9", "`log` lies outside its domain where x = -3"),
            ("sqrt(x) >= 0", "`sqrt` lies outside its domain where x = "),
            ("x^(1/3) >= 0", "a negative number has no power with an exponent that is not an integer where x = "),
        ] {
            let message = refusal(&asked(&format!("x = \"{range}\""), property, "1 < 0"));
            assert!(message.starts_with("line 6") && message.contains(named), "{range}, {property}: {message}");
        }
    }
    let guarded = "g = [\"edges:3:1-2\", \"path:3\"]";
    assert_eq!(verdict(guarded, "diameter <= 2 or not connected"), Verdict::Holds);
    assert_eq!(verdict(guarded, "lambda(4) > 9 or n < 4"), Verdict::Holds);
    assert_eq!(verdict("n = \"integers(1, 9)\"", "gcd(n, 2) <= 2"), Verdict::Holds);
}

/// A box that holds a point without a value is never taken to hold.
#[test]
fn no_box_hides_a_missing_point() {
    for property in ["x*x/(x*x) > 0", "1/(x*x) > 0", "abs(x)/abs(x) = 1", "log(x*x) < 99"] {
        let message = refusal(&asked("x = \"[-1, 1]\"", property, "1 < 0"));
        assert!(message.contains("where x = 0"), "{property}: {message}");
    }
    // No rational point is at fault, and none is found.
    assert_eq!(verdict("x = \"[0, 2]\"", "1/(x*x - 2)^2 > 0"), Verdict::Undecided);
}

#[test]
fn every_name_is_used() {
    let unused = |family: &str, property: &str, place: &str, name: &str| {
        let message = refusal(&asked(family, property, "1 < 0"));
        assert!(message.starts_with(place) && message.contains(&format!("nothing uses `{name}`")), "{message}");
    };
    unused("n = 3", "1 > 0", "line 4, column 1: ", "n");
    unused("f = -1\ng = \"ring:4\"", "edges = 4", "line 4, column 1: ", "f");
    unused("g = \"ring:4\"\nh = \"ring:5\"", "g.edges = 4", "line 5, column 1: ", "h");
    unused("n = 3\nm = \"n + 1\"", "n > 0", "line 5, column 1: ", "m");
    // By a later name, by `where`, by a control alone.
    assert_eq!(verdict("n = 3\ng = \"ring(n)\"", "edges = 3"), Verdict::Holds);
    assert_eq!(verdict("n = \"1..2\"\nx = 1\nwhere = \"n > 1\"", "x > 0"), Verdict::Holds);
    assert_eq!(super::answer(&asked("n = 3", "1 > 0", "n < 0")).verdict, Verdict::Holds);
}

#[test]
fn names_that_contradict_each_other() {
    let refused = |family: &str, property: &str, named: &str| {
        let message = refusal(&asked(family, property, "1 < 0"));
        assert!(message.contains(named), "{message}");
    };
    let gains = "f = -1\ng = -1\n";
    refused(&format!("{gains}followers = 5\ngraph = \"arcs:3:2-1,3-2\""), "stable", "`followers` and `graph`");
    refused(&format!("{gains}a = \"platoon1:2\"\nb = \"platoon2:2\""), "peak < 9", "which one");
    let front = asked(&format!("{gains}graph = \"platoon2:2\""), "stable", "1 < 0");
    assert!(refusal(&front.replacen("[for]", "communication = \"front\"\n[for]", 1)).contains("`communication`"));
    refused("n = 3\ngraph = \"ring:5\"", "n = 5 and edges = 5", "`n` is bound to 3, but `graph` has 5 vertices");
    refused("edges = 3\ngraph = \"ring:5\"", "edges = 3", "`edges` is a quantity of a graph");
    assert_eq!(verdict("n = 5\ngraph = \"ring:5\"", "n = edges"), Verdict::Holds);
    let scenario = "[model]\nname = \"platoon\"\nf = -1\ng = -1\ncommunication = \"front-and-back\"\n\
        [state]\ndeviations = [0, 1]\nvelocities = [0, 0]\n[run]\nuntil = 1\n";
    let both = asked(&format!("{gains}followers = 5"), "stable", "1 < 0");
    let both = both.replacen("[for]", "scenario = \"motion.toml\"\n[for]", 1);
    assert!(!refusal_with(&both, scenario).is_empty());
}

/// The abscissa over a box of gains on a graph, and what no box of gains has.
#[test]
fn the_abscissa_over_boxes_of_gains() {
    let graph = "graph = \"arcs:4:2-1,2-3,3-2,3-4,4-2,4-3\"\n";
    let of = |gains: &str, property: &str| verdict(&format!("{graph}{gains}"), property);
    assert_eq!(of("f = \"[-2, -1]\"\ng = \"[-2, -1]\"", "abscissa < 0"), Verdict::Holds);
    assert_eq!(of("f = \"[-2, -1]\"\ng = \"[1, 2]\"", "abscissa < 0"), Verdict::False);
    // At single gains it is that of the characteristic polynomial.
    for (f, g) in [("-1", "-1"), ("-2", "-1/2"), ("1/2", "-1"), ("-1", "1")] {
        let (point, narrow) = (format!("f = \"{f}\"\ng = \"{g}\""), format!("f = \"[{f}, {f} + 10^-9]\"\ng = \"{g}\""));
        let margin = |gains: &str| {
            super::answer(&asked(&format!("{graph}{gains}"), "abscissa < 9", "abscissa > 9")).margin.expect("a margin")
        };
        let (point, narrow) = (margin(&point), margin(&narrow));
        // Of real eigenvalues (|w| + Re w)/2 is 0 up to the width of the box, and its root up to the root of that.
        // The smallest margin of the box is at most that of its point, and no farther from it.
        assert!(narrow.lo <= point.hi && point.lo - narrow.lo < 1e-4, "{f}, {g}: {point:?} {narrow:?}");
    }
}
