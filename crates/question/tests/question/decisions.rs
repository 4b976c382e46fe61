use super::{answer, asked, read, verdict};
use arithmetic::{Unwatched, rational};
use question::{Value, Verdict, decide};

#[test]
fn a_bound_that_is_attained_holds() {
    let answer = answer(&asked(
        "n = \"2..6\"\ngraph = \"connected(n)\"",
        "lambda(2) >= 2*(1 - cos(pi/n))",
        "lambda(2) >= 2*(1 - cos(pi/n)) + 1/100",
    ));
    assert_eq!((answer.verdict, answer.cases, &answer.grades[..]), (Verdict::Holds, 142, &["exhaustive"][..]));
    let margin = answer.margin.expect("a margin");
    assert_eq!((margin.lo, margin.hi), (0.0, 0.0));
}

#[test]
fn the_first_counterexample_is_the_smallest() {
    let answer = answer(&asked("n = \"2..6\"\ngraph = \"connected(n)\"", "lambda(2) <= min_degree", "lambda(n) < 0"));
    assert_eq!(answer.verdict, Verdict::False);
    let found = answer.counterexample.expect("a counterexample");
    assert_eq!(found.to_string(), "n = 2, graph = edges:2:1-2");
    // The replay is decided again, with its own control refuted.
    let replay = read(&answer.replay.expect("a replay")).expect("a question");
    let again = decide(&replay, &Unwatched).expect("an answer");
    assert_eq!((again.verdict, again.cases, again.controls), (Verdict::False, 1, vec![true]));
}

#[test]
fn a_continuum_is_covered_by_boxes() {
    assert_eq!(verdict("x = \"[0, 1]\"", "x*(1 - x) <= 1/4 + 1/1000"), Verdict::Holds);
    let answer = answer(&asked("x = \"[0, 1]\"\ny = \"[0, 1]\"", "x^2 + y^2 < 19/10", "x < 0"));
    assert_eq!(answer.verdict, Verdict::False);
    let found = answer.counterexample.expect("a counterexample");
    let number = |name: &str| match found.get(name) {
        Some(Value::Number(q)) => q.clone(),
        other => panic!("{other:?}"),
    };
    assert!(number("x").pow(2) + number("y").pow(2) >= rational(19, 10));
    // The largest value is attained inside: boxes alone do not decide it.
    assert_eq!(verdict("x = \"[0, 1]\"", "x*(1 - x) <= 1/4"), Verdict::Holds);
}

#[test]
fn a_control_that_is_not_refuted_withholds_the_verdict() {
    let answer = answer(&asked("n = \"2..4\"", "n > 1", "n > 0"));
    assert_eq!((answer.verdict, answer.verdict.status(), answer.controls), (Verdict::Withheld, 4, vec![false]));
}

#[test]
fn the_peak_over_a_box_of_gains_is_that_of_its_corners() {
    // The weakest corner of the box decides, and it is a point of the box.
    let corner = answer(&asked("followers = \"64\"\nf = \"-4\"\ng = \"-1\"", "peak < 200", "peak < 1"));
    let all = answer(&asked("followers = \"64\"\nf = \"[-4, -1/10]\"\ng = \"[-4, -1]\"", "peak < 200", "peak < 1"));
    assert_eq!((corner.verdict, all.verdict), (Verdict::Holds, Verdict::Holds));
    let (corner, all) = (corner.margin.expect("a margin"), all.margin.expect("a margin"));
    assert!((corner.lo - all.lo).abs() < 1e-3 * corner.lo.abs(), "{corner:?} {all:?}");
    // Inside the box nothing is higher.
    for (f, g) in [("-1", "-1"), ("-4", "-2"), ("-1/10", "-1"), ("-2", "-3/2")] {
        let inside = answer(&asked(&format!("followers = \"64\"\nf = \"{f}\"\ng = \"{g}\""), "peak < 200", "peak < 1"));
        assert!(inside.margin.expect("a margin").lo > all.lo);
    }
}

#[test]
fn integers_are_covered_by_boxes_down_to_single_ones() {
    // Equality at 1, which no box with another integer decides.
    let many = answer(&asked("n = \"integers(1, 1000000000)\"", "n^2 >= n", "n^2 > n"));
    assert_eq!((many.verdict, &many.grades[..]), (Verdict::Holds, &["certified"][..]));
    assert!(many.cases < 200, "{}", many.cases);
    assert_eq!(many.margin.map(|margin| (margin.lo, margin.hi)), Some((0.0, 0.0)));
    // Between the integers it fails.
    assert_eq!(verdict("n = \"integers(-9, 9)\"", "(n - 1)*(n - 2) >= 0"), Verdict::Holds);
    assert_eq!(verdict("n = \"[-9, 9]\"", "(n - 1)*(n - 2) >= 0"), Verdict::False);
    let false_one = answer(&asked("n = \"integers(1, 1000000)\"", "n^2 <= 1000000", "n < 0"));
    let found = false_one.counterexample.expect("a counterexample");
    assert!(matches!(found.get("n"), Some(Value::Number(q)) if *q == rational(1001, 1)), "the smallest one");
    // What a single one makes impossible is refused.
    let divided = read(&asked("n = \"integers(1, 9)\"", "1/(n - 7) > -2", "n < 0")).expect("a question");
    assert!(decide(&divided, &Unwatched).expect_err("a division by zero").to_string().contains("n = 7"));
    assert_eq!(verdict("n = \"integers(1, 9)\"\nwhere = \"n != 7\"", "1/(n - 7) > -2"), Verdict::Holds);
}

/// The margins of single numbers of followers against those of all of them at once.
#[test]
fn the_peak_over_a_range_of_followers_is_that_of_its_ends() {
    for (communication, gains) in [
        ("front-and-back", "f = \"-1\"\ng = \"-1/5\""),
        ("front-and-back", "f = \"-1\"\ng = \"-1\""),
        ("front-and-back", "f = \"-1/9\"\ng = \"-3\""),
        ("front", "f = \"-1\"\ng = \"-1\""),
    ] {
        let margin = |followers: &str, property: &str| {
            let text = asked(&format!("followers = \"{followers}\"\n{gains}"), property, "peak < 1/2");
            let text = text.replacen("[for]", &format!("communication = \"{communication}\"\n[for]"), 1);
            answer(&text).margin.expect("a margin")
        };
        for (name, bound) in [("peak", "10^6"), ("abscissa", "1")] {
            let (above, below) = (format!("{name} < {bound}"), format!("{name} > -{bound}"));
            let single = |m: u32| (margin(&m.to_string(), &above).lo, margin(&m.to_string(), &below).lo);
            let all: Vec<_> = (1..=24).map(single).collect();
            // Neither falls with the number of followers.
            assert!(
                all.windows(2).all(|pair| pair[1].0 <= pair[0].0 + 1e-9 && pair[1].1 >= pair[0].1 - 1e-9),
                "{all:?}"
            );
            let range = (margin("integers(1, 24)", &above).lo, margin("integers(1, 24)", &below).lo);
            assert!((range.0 - all[23].0).abs() < 1e-9 && (range.1 - all[0].1).abs() < 1e-9, "{range:?} {all:?}");
        }
    }
}

#[test]
fn ranges_of_followers_and_boxes_of_gains() {
    let family = "followers = \"integers(1, 1000000000000)\"\nf = \"[-4, -1]\"\ng = \"[-2, -1]\"";
    let all = answer(&asked(family, "stable and peak < 8*followers", "peak < 2*followers"));
    assert_eq!((all.verdict, &all.grades[..]), (Verdict::Holds, &["certified"][..]));
    // Behind the front car alone the number of followers does not matter; otherwise it is taken one by one.
    let some = "followers = \"integers(3, 9)\"\nf = \"-1\"\ng = \"-1\"";
    let property = "gain(3, 3) < 2 and peak_frequency < 4";
    assert_eq!(verdict(some, property), Verdict::Holds);
    let one_sided = asked(some, property, "peak < 1").replacen("[for]", "communication = \"front\"\n[for]", 1);
    let one_sided = answer(&one_sided);
    assert_eq!((one_sided.verdict, one_sided.cases), (Verdict::Holds, 1));
}

#[test]
fn the_peak_decreases_in_the_damping_over_the_square_root_of_the_stiffness() {
    // b = g²/|f| grows along the list; so does the margin below 10^6.
    for followers in ["1", "2", "3", "10"] {
        let gains = [
            ("-4", "-1/10"),
            ("-4", "-1/2"),
            ("-1", "-1/2"),
            ("-1", "-1"),
            ("-1", "-3"),
            ("-1/4", "-4"),
            ("-1/100", "-5"),
        ];
        let margins: Vec<f64> = gains
            .iter()
            .map(|(f, g)| {
                let family = format!("followers = \"{followers}\"\nf = \"{f}\"\ng = \"{g}\"");
                answer(&asked(&family, "peak < 10^6", "peak < 1/2")).margin.expect("a margin").lo
            })
            .collect();
        assert!(margins.windows(2).all(|pair| pair[0] < pair[1]), "{followers}: {margins:?}");
    }
}

#[test]
fn the_abscissa_is_enclosed_where_roots_may_be_double() {
    // At f = -1, g = -2 the one mode of one follower has the double root -1.
    let one = "followers = \"1\"\nf = \"-1\"\ng = \"-2\"";
    assert_eq!(verdict(one, "abs(abscissa + 1) < 10^-8"), Verdict::Holds);
    let all = "followers = \"integers(1, 64)\"\nf = \"[-2, -1]\"\ng = \"[-2, -1]\"";
    assert_eq!(verdict(all, "abscissa < 0"), Verdict::Holds);
}

#[test]
fn other_quantities_of_platoons() {
    let family = "followers = \"3\"\nf = \"-1\"\ng = \"-1\"";
    for property in [
        "stable",
        "abscissa < 0",
        "gain(3, 0) = 1",
        "gain(3, 1/2) > gain(1, 10)",
        "peak >= gain(3, 1/2)",
        "peak_frequency < 1",
    ] {
        assert_eq!(verdict(family, property), Verdict::Holds, "{property}");
    }
    assert_eq!(verdict("followers = \"3\"\nf = \"1\"\ng = \"-1\"", "stable"), Verdict::False);
    let graph = "graph = \"platoon2(3)\"\nf = \"-1\"\ng = \"-1\"";
    assert_eq!(verdict(graph, "stable and abscissa < 0 and gain(3, 0) = 1"), Verdict::Undecided);
    assert_eq!(verdict(graph, "stable and abscissa < 0 and abs(gain(3, 1/2)) > 0"), Verdict::Holds);
    // The line as a graph has the peak of the line.
    let graph_peak = answer(&asked(graph, "peak < 10", "peak < 1")).margin.expect("a margin");
    let line = answer(&asked(family, "peak < 10", "peak < 1")).margin.expect("a margin");
    assert!(graph_peak.lo <= line.hi && line.lo <= graph_peak.hi);
    let ring = "graph = \"arcs:4:2-1,2-3,3-2,3-4,4-2,4-3\"";
    let single = format!("{ring}\nf = \"-1\"\ng = \"-1\"");
    assert_eq!(verdict(&single, "peak < 10 and peak >= gain(3, 1/2) and peak >= gain(3, 1)"), Verdict::Holds);
    assert_eq!(verdict(&single, "peak < 1"), Verdict::False);
    // Stability over a box of gains.
    let boxed = format!("{ring}\nf = \"[-4, -1]\"\ng = \"[-3, -2]\"");
    assert_eq!(verdict(&boxed, "stable"), Verdict::Holds);
    assert_eq!(verdict(&format!("{ring}\nf = \"[-4, -1]\"\ng = \"[1, 2]\""), "stable"), Verdict::False);
}

#[test]
fn the_peak_over_a_box_of_gains_on_any_graph_is_that_of_its_corners() {
    // A cycle of three behind the leader, one of four with a chord, and one that hangs on another car: with complex eigenvalues.
    for graph in ["arcs:4:2-1,2-3,3-4,4-2", "arcs:5:2-1,2-5,3-2,4-3,5-4,5-2", "arcs:5:2-1,3-2,3-5,4-3,5-4"] {
        let margin = |gains: &str| {
            let family = format!("graph = \"{graph}\"\n{gains}");
            answer(&asked(&family, "stable and peak < 10^6", "peak < 1/2")).margin.expect("a margin")
        };
        let single = |f: &str, g: &str| margin(&format!("f = \"{f}\"\ng = \"{g}\""));
        let boxed = margin("f = \"[-4, -1]\"\ng = \"[-8, -4]\"");
        // b = g²/|f| grows along the list.
        let points = [("-4", "-4"), ("-2", "-4"), ("-3", "-6"), ("-1", "-5"), ("-1", "-8")].map(|(f, g)| single(f, g));
        assert!(points.windows(2).all(|pair| pair[0].lo <= pair[1].hi), "{graph}: {points:?}");
        assert!((boxed.lo - points[0].lo).abs() < 1e-6 && boxed.lo < points[1].lo, "{graph}: {boxed:?} {points:?}");
    }
    // Where only a part of the box is stable, its boxes are decided one by one.
    let cycle = "graph = \"arcs:4:2-1,2-3,3-4,4-2\"\nf = \"[-4, -1]\"\n";
    let found = answer(&asked(&format!("{cycle}g = \"[-2, -1/10]\""), "stable and peak < 100", "peak < 1/2"));
    assert_eq!((found.verdict, found.counterexample.is_some()), (Verdict::False, true), "{}", found.why);
}

#[test]
fn products_of_matrices() {
    let family = "matrices = \"matrices:1/2 1/2; 0 1 | 1 0; 1/2 1/2\"";
    assert_eq!(verdict(family, "tau_1 = 1/4 and tau_2^2 = 1/8"), Verdict::Holds);
    assert_eq!(verdict("matrices = \"products(2, 2, 2)\"", "tau_1 <= 1"), Verdict::Holds);
    assert_eq!(verdict("seed = \"1..5\"\nmatrices = \"random_products(4, 3)\"", "tau_1 <= 1"), Verdict::Undecided);
}

#[test]
fn every_inequality_stands_by_itself() {
    let of = |property: &str| -> Vec<String> {
        let found = answer(&asked("n = \"1..3\"", property, "n < 0"));
        found.inequalities.into_iter().map(|(text, _)| text).collect()
    };
    assert_eq!(of("gcd(n, 2) = 1 or 0 < n <= 3 and n <= 3"), ["gcd(n, 2) = 1", "0 < n", "n <= 3"]);
    assert_eq!(of("n >= 1 implies not n != 2"), ["n < 1", "n = 2"]);
}

/// Weights ahead and behind, and numbers for each car, in one line each; against the graph of the same weights and the words of what is refused.
#[test]
fn asymmetric_platoons_are_platoons_on_graphs() {
    let margin = |family: &str| answer(&asked(family, "peak < 10", "peak < 1")).margin.expect("a margin");
    let gains = "f = \"-1\"\ng = \"-2\"\n";
    let line = margin(&format!("followers = 3\n{gains}ahead = \"3/5\""));
    let graph = margin(&format!("graph = \"arcs:4:2-1*3,2-3*2,3-2*3,3-4*2,4-3\"\n{gains}"));
    assert!((line.lo - graph.lo).abs() < 1e-12, "{line:?} {graph:?}");
    let each =
        margin("followers = 3\nf = \"each:-1,-1,-1\"\ng = \"-2\"\nf_ahead = \"3/5\"\ng_ahead = \"each:3/5,3/5,1/7\"");
    assert!((line.lo - each.lo).abs() < 1e-12, "{line:?} {each:?}");
    let plain = margin(&format!("followers = 3\n{gains}"));
    let half = margin(&format!("followers = 3\n{gains}ahead = \"each:1/2,1/2,1\""));
    assert!((plain.lo - half.lo).abs() < 1e-12 && (plain.lo - line.lo).abs() > 1e-3);
    // Over a box of gains, and of other weights for velocities: where that is decided.
    let boxed = "followers = 3\nf = \"[-2, -1]\"\ng = \"[-3, -2]\"\n";
    assert_eq!(verdict(&format!("{boxed}ahead = \"3/5\""), "stable and peak < 10 and abscissa < 0"), Verdict::Holds);
    let apart = format!("followers = 3\n{gains}f_ahead = \"3/5\"\ng_ahead = \"1/2\"");
    assert_eq!(verdict(&apart, "stable and peak < 10 and peak >= gain(3, 1/2) and abscissa < 0"), Verdict::Holds);
    assert_eq!(verdict(&apart, "peak < 1"), Verdict::False);
    // Positions heard more from ahead than velocities: long platoons are not stable, which the peak says.
    let long = format!("followers = 60\n{gains}f_ahead = \"3/5\"\ng_ahead = \"1/2\"");
    let long = long.replace("g = \"-2\"", "g = \"-1\"");
    assert_eq!(verdict(&long, "stable"), Verdict::False);
    let refused = |family: &str, words: &str| {
        let question = read(&asked(family, "peak < 10", "peak < 1")).expect("a question");
        let error = decide(&question, &Unwatched).expect_err(family).to_string();
        assert!(error.contains(words), "{error}");
    };
    refused(&long, "the platoon is not stable, so that it has no peak");
    // One list in each of its forms, in a list of families, too; two numbers in brackets are an interval.
    for list in ["\"3/5,3/5,1/7\"", "\"[3/5, 3/5, 1/7]\"", "\"each:3/5,3/5,1/7\"", "[[0.6, \"3/5\", \"1/7\"]]"] {
        let same = margin(&format!("followers = 3\nf = \"-1,-1,-1\"\ng = \"-2\"\nahead = {list}"));
        assert!((line.lo - same.lo).abs() < 1e-12, "{list}: {line:?} {same:?}");
    }
    refused(&format!("followers = 3\n{gains}ahead = \"each:1,1\""), "`ahead` has 2 numbers for 3 followers");
    refused("followers = 3\nf = \"each:-1,1,-1\"\ng = \"-1\"", "`f` must be negative, but it is 1: the law is");
    refused(&format!("graph = \"path:4\"\n{gains}ahead = \"1/2\""), "`ahead` is for cars on a line");
}

/// Over intervals of weights stability is decided for all at once where the modes are real; of what is known at single numbers only the reason comes soon.
#[test]
fn intervals_of_weights() {
    let gains = "followers = 6\nf = \"[-2, -1]\"\ng = \"[-3, -1/2]\"\n";
    for weights in ["ahead = \"[1/10, 9/10]\"", "ahead = \"[1/10, 1]\"\nbehind = \"[0, 7]\""] {
        let found = answer(&asked(&format!("{gains}{weights}"), "stable and abscissa < 0", "not stable"));
        assert_eq!((found.verdict, found.cases), (Verdict::Holds, 1), "{}", found.why);
    }
    // The characteristic polynomials of single platoons say the same.
    for weights in ["1/10", "1/2", "9/10", "each:1/10,9/10,1/2,1,1/100,1"] {
        for (f, g) in [("-2", "-1/2"), ("-1", "-3")] {
            let single = format!("followers = 6\nf = \"{f}\"\ng = \"{g}\"\nahead = \"{weights}\"");
            assert_eq!(verdict(&single, "stable"), Verdict::Holds, "{single}");
        }
    }
    // False somewhere: a gain that is not negative, velocities heard in another way.
    let long = "followers = 60\nf = \"-1\"\ng = \"-1\"\nf_ahead = \"[1/2, 3/5]\"\ng_ahead = \"1/2\"";
    for family in ["followers = 3\nf = \"[-1, 1/10]\"\ng = \"-1\"\nahead = \"[1/3, 2/3]\"", long] {
        assert_eq!(verdict(family, "stable"), Verdict::False, "{family}");
    }
    let weights = "followers = 3\nf = \"-1\"\ng = \"-2\"\nahead = \"[1/2, 3/5]\"";
    let each = "followers = 3\nf = \"each:-1,-2,-1\"\ng = \"[-3, -2]\"";
    for (family, property) in
        [(weights, "peak < 10"), (weights, "abscissa < -1/100"), (each, "peak < 10"), (each, "stable")]
    {
        let open = answer(&asked(family, property, "1 < 0"));
        assert_eq!(open.verdict, Verdict::Undecided, "{family}: {property}");
        assert!(
            open.cases <= 33 && open.why.contains("is known at single numbers only"),
            "{} {}",
            open.cases,
            open.why
        );
        // Points are looked at nevertheless.
        assert_eq!(verdict(family, "peak < 1"), Verdict::False, "{family}");
    }
}

/// A list of TOML is a family; that is told where it looks like one number for each car. Other signs than commas are no list.
#[test]
fn lists_that_look_like_cars() {
    let of =
        |ahead: &str| asked(&format!("followers = 3\nf = \"-1\"\ng = \"-2\"\nahead = {ahead}"), "peak < 100", "1 < 0");
    let told = answer(&of("[0.6, 0.5, 1]"));
    assert_eq!(told.cases, 3);
    assert!(told.why.contains("The list of `ahead` makes 3 platoons") && told.why.contains("`ahead = \"each:..\"`"));
    for other in ["[0.6, 0.5]", "[[0.6, 0.5, 1]]", "\"0.6,0.5,1\"", "[\"0.6,0.5,1\", \"0.5,0.6,1\", \"1,1,1\"]"] {
        assert!(!answer(&of(other)).why.contains("platoons"), "{other}");
    }
    for wrong in ["\"0.6 0.5 1\"", "\"0.6;0.5;1\""] {
        let error = read(&of(wrong)).expect_err(wrong).to_string();
        assert!(error.contains("with commas between, `0.6,0.5,1`, is expected here, but it is"), "{error}");
    }
}

/// Ends of intervals that are no weights are named.
#[test]
fn intervals_of_numbers_that_are_no_weights() {
    for (ahead, words) in [
        ("[-1/10, 3/5]", "`ahead` is -1/10, but a weight is not negative"),
        ("[1/2, 3/2]", "`ahead` is 3/2, but a weight is between 0 and 1"),
        ("[0, 3/5]", "car 3 has the weight zero ahead, and nobody behind"),
    ] {
        let family = format!("followers = 3\nf = \"-1\"\ng = \"-2\"\nahead = \"{ahead}\"");
        let question = read(&asked(&family, "peak < 10^30", "peak < 1")).expect("a question");
        let error = decide(&question, &Unwatched).expect_err(ahead).to_string();
        assert!(error.contains(words), "{error}");
    }
}

/// Who takes gains for positive is told, whatever is asked of the platoon; who does not, is not.
#[test]
fn the_signs_of_gains_are_told() {
    let why = |f: &str, property: &str| {
        answer(&asked(&format!("followers = 3\nf = \"{f}\"\ng = \"-1\""), property, "1 < 0")).why
    };
    for (f, found) in [("1", "`f` is 1, not negative"), ("0", "`f` is 0, not negative"), ("[1, 2]", "not negative")] {
        for property in ["stable", "abscissa < 0", "gain(1, 1) < 1/100"] {
            let why = why(f, property);
            assert!(why.contains(found) && why.contains("f = g = -1 pulls it back"), "{f}, {property}: {why}");
        }
    }
    assert!(why("[-1, 2]", "stable").contains("pulls"));
    assert!(!why("-1", "stable").contains("pulls"));
    // Another `f` than that of a platoon.
    assert!(!answer(&asked("f = \"1\"", "f > 0", "f < 0")).why.contains("pulls"));
}
