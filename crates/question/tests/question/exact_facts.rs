//! Facts that are known exactly: the start, what is conserved, what stays at rest; distances of exactly 0.

use super::motions::{answered, platoon, verdict};
use num_traits::ToPrimitive;
use question::Verdict;

/// Agents with these rows, without forces.
fn agents(positions: &str, velocities: &str, graph: &str) -> String {
    format!(
        "model = \"velocity-alignment\"\n[graph]\n{graph}\n[state]\npositions = {positions}\nvelocities = {velocities}\n\
         [law]\npotential = \"none\"\n[run]\nuntil = 1\n"
    )
}

const COMPLETE: &str = "kind = \"complete\"";

#[test]
fn a_distance_of_exactly_zero_has_a_root() {
    let one_velocity = agents("[[0, 0], [2, 0], [0, 3]]", "[[1, \"1/3\"], [1, \"1/3\"], [1, \"1/3\"]]", COMPLETE);
    assert_eq!(verdict(&one_velocity, "always[0, 1](disagreement < 1/10)"), Verdict::Holds);
    // They meet at t = 1.
    let meeting = agents("[[0, 0], [1, 0]]", "[[1, 0], [0, 0]]", "kind = \"edges\"\nedges = []");
    assert_eq!(verdict(&meeting, "always[1, 1](min_distance < 1/1000)"), Verdict::Holds);
    assert_eq!(verdict(&meeting, "eventually[0, 1](min_distance < 1/1000)"), Verdict::Holds);
    // At 1 - t these begin to fail, at ends of halved pieces of time and elsewhere.
    for k in (1..=40).chain([50, 64, 100, 128, 512]) {
        assert_eq!(verdict(&meeting, &format!("always[0, 2](min_distance >= 1/{k})")), Verdict::False, "1/{k}");
        assert_eq!(verdict(&meeting, &format!("eventually[0, 2](min_distance < 1/{k})")), Verdict::Holds, "1/{k}");
        assert_ne!(
            verdict(&meeting, &format!("eventually[0, {k}/{}](min_distance < 1/{})", k + 1, k + 1)),
            Verdict::Holds,
            "{k}"
        );
    }
    let phases =
        |list: &str| format!("model = \"phase\"\n[state]\nphases = {list}\n[law]\nK1 = -1\n[run]\nuntil = 1\n");
    assert_eq!(verdict(&phases("[1, 1, 1]"), "always[0, 1](order = 1 and phase_potential = 0)"), Verdict::Holds);
    assert_eq!(verdict(&phases("[1, 1, \"10/9\"]"), "always[0, 1](order = 1)"), Verdict::False);
}

#[test]
fn the_start_is_exact() {
    let start = agents("[[0, 0], [2, 0], [0, 3]]", "[[1, 0], [\"1/3\", 1], [\"-1/3\", 0]]", COMPLETE);
    for property in [
        "initial(min_distance) = 2",
        "initial(disagreement)^2 = 14/9",
        "initial(kinetic) = 10/9",
        "always[0, 0](min_distance = 2 and momentum(2) = 1)",
        "eventually[0, 1](min_distance = 2)",
    ] {
        assert_eq!(verdict(&start, property), Verdict::Holds, "{property}");
    }
    for property in ["initial(min_distance) != 2", "initial(min_distance) > 2", "always[0, 1](min_distance < 2)"] {
        assert_eq!(verdict(&start, property), Verdict::False, "{property}");
    }
    // Cars with their swing: y_0 = 1/4 and all others at 0.
    let cars = platoon(3);
    for property in [
        "initial(min_gap) = 2 and initial(max_gap) = 9/4",
        "initial(last_deviation) = -1/4 and initial(largest_deviation) = 1/4",
        "initial(min_distance) = 2 and initial(disagreement) = 0",
    ] {
        assert_eq!(verdict(&cars, property), Verdict::Holds, "{property}");
    }
    // A start that is an interval is none.
    let family = "\"state.positions[2][1]\" = \"[2, 5/2]\"";
    let open = answered(&start, family, "initial(min_distance) >= 1", "initial(min_distance) > 5");
    assert_eq!(open.verdict, Verdict::Holds, "{}", open.why);
}

#[test]
fn velocity_alignment_conserves_momentum_and_heading_alignment_does_not() {
    let velocities = "[[1, 0], [\"1/3\", 1], [\"-1/3\", 0]]";
    for graph in [COMPLETE, "kind = \"path\"", "kind = \"within\"\nradius = \"5/2\""] {
        let text = agents("[[0, 0], [2, 0], [0, 3]]", velocities, graph);
        for text in [text.clone(), text.replace("\"none\"", "\"inverse-square-log\"")] {
            let property = "always[0, 1](momentum(1) = 1 and momentum(2) = initial(momentum(2)))";
            assert_eq!(verdict(&text, property), Verdict::Holds, "{text}");
            assert_eq!(verdict(&text, "eventually[0, 1](momentum(1) != 1)"), Verdict::False, "{text}");
        }
    }
    let turning = "model = \"heading-alignment\"\n[graph]\nkind = \"complete\"\n[state]\npositions = [[0, 0], [2, 0]]\n\
                   velocities = [[1, 0], [1, \"1/2\"]]\n[law]\npotential = \"inverse-square-log\"\n[run]\nuntil = \"1/4\"\n";
    assert_eq!(verdict(turning, "initial(momentum(2)) = 1/2"), Verdict::Holds);
    assert_eq!(verdict(turning, "always[0, 1/4](momentum(2) = 1/2)"), Verdict::False);
    let wide = agents("[[0, 0], [2, 0]]", "[[0, 0], [0, 0]]", COMPLETE);
    let family = "\"state.velocities[1][1]\" = \"[0, 1]\"";
    let answer = answered(&wide, family, "always[0, 1](momentum(1) >= 0)", "always[0, 1](momentum(1) >= 1/2)");
    assert_eq!(answer.verdict, Verdict::Holds, "{}", answer.why);
}

#[test]
fn what_rests_stays_as_it_is() {
    let together = agents("[[0, 0], [2, 0], [0, 3]]", "[[1, \"1/3\"], [1, \"1/3\"], [1, \"1/3\"]]", COMPLETE);
    assert_eq!(verdict(&together, "always[0, 1](disagreement = 0 and min_distance = 2)"), Verdict::Holds);
    // At the distance 1 of the least potential there is no force, at another one there is.
    let resting =
        agents("[[0, 0], [1, 0]]", "[[1, 2], [1, 2]]", COMPLETE).replace("\"none\"", "\"inverse-square-log\"");
    assert_eq!(verdict(&resting, "always[0, 1](min_distance = 1)"), Verdict::Holds);
    let pushed = resting.replace("[1, 0]]", "[\"3/2\", 0]]");
    assert_eq!(verdict(&pushed, "always[0, 1](min_distance = 3/2)"), Verdict::False);
    let even = platoon(3).replace("amplitude = \"1/4\"", "amplitude = 0");
    let property = "always[0, 1000000](min_gap = 2 and disagreement = 0 and last_deviation = 0)";
    assert_eq!(verdict(&even, property), Verdict::Holds);
    assert_eq!(verdict(&platoon(3), "always[0, 1](min_gap = 2)"), Verdict::False);
}

/// Where roots of modes coincide time has no end either.
#[test]
fn critically_damped_platoons_are_followed_to_any_time() {
    for followers in [1, 3, 5, 8] {
        for (f, g) in [("-1", "-2"), ("\"-1/4\"", "-1"), ("-1", "-1"), ("-4", "-4")] {
            let text = platoon(followers).replace("f = -1", &format!("f = {f}")).replace("g = -1", &format!("g = {g}"));
            let text = text.replace("amplitude = \"1/4\"", "amplitude = 0").replacen("[0, ", "[1, ", 1);
            let property = "always[1000000, 1000000](abs(last_deviation) < 10^(-9))";
            let answer = answered(&text, "n = 1", property, "1 < 0");
            assert_eq!(answer.verdict, Verdict::Holds, "{followers} {f} {g}: {}", answer.why);
        }
    }
    // One car from 1 behind its place: -(1 + t) e^(-t).
    let one = "model = \"platoon\"\n[state]\npositions = [0, -2]\nvelocities = [0, 0]\n[law]\nf = -1\ng = -2\nspacing = 1\n\
               communication = \"front-and-back\"\n[run]\nuntil = 4\n";
    let property = "always[3, 3](abs(last_deviation + 4*exp(-3)) < 10^(-12)) and \
                    always[20, 20](abs(last_deviation + 21*exp(-20)) < 10^(-12)) and always[0, 20](last_deviation < 0)";
    assert_eq!(verdict(one, property), Verdict::Holds);
}

/// `q` at the end of a window, at its beginning, at a window of one point; `p` fails when `q` comes.
#[test]
fn until_of_a_motion_asks_for_its_first_part_before_the_second_one_comes() {
    // The distance is 1 + t.
    let apart = agents("[[0, 0], [1, 0]]", "[[0, 0], [1, 0]]", "kind = \"edges\"\nedges = []");
    for (property, expected) in [
        ("min_distance < 2 until[3/2, 2] min_distance > 2", Verdict::False),
        ("min_distance < 3 until[1/3, 1/3] min_distance > 5/4", Verdict::Holds),
        ("min_distance < 3 until[1/3, 1/3] min_distance > 3/2", Verdict::False),
        // Until it fails: at the first time at which it does.
        ("min_distance < 2 until[0, 2] min_distance >= 2", Verdict::Holds),
        ("min_distance < 2 until[1/2, 2] min_distance >= 2", Verdict::Holds),
        ("min_distance < 2 until[3/2, 2] min_distance >= 2", Verdict::False),
        ("min_distance < 7 until[0, 2] min_distance >= 7", Verdict::False),
        ("always[0, 1/2](min_distance < 2 until[0, 2] min_distance >= 2)", Verdict::Holds),
        // Nothing is said of the moment at which a divisor is 0, so that there is no first time.
        ("1/(min_distance - 2) < 5 until[0, 2] 1/(min_distance - 2) >= 5", Verdict::Undecided),
        // At time 0 alone: nothing is asked of the first part.
        ("min_distance > 5 until[0, 0] min_distance = 1", Verdict::Holds),
        ("min_distance > 5 until[0, 2] min_distance < 2", Verdict::Holds),
        ("min_distance > 5 until[1/7, 2] min_distance < 2", Verdict::False),
        ("always[0, 1](min_distance < 3 until[1/3, 1/3] min_distance > 5/4)", Verdict::Holds),
        (
            "always[0, 1](eventually[1/3, 1/3](min_distance > 5/4) and always[1/3, 1/3](min_distance < 3))",
            Verdict::Holds,
        ),
        ("eventually[0, 1](eventually[1/3, 1/3](min_distance < 1))", Verdict::False),
        ("eventually[0, 1](min_distance > 3/2 until[1/2, 1] min_distance > 5/2)", Verdict::Holds),
    ] {
        assert_eq!(verdict(&apart, property), expected, "{property}");
    }
}

/// The inequality that decides with the values of its sides, of every kind of property.
#[test]
fn a_counterexample_shows_both_sides() {
    let apart = agents("[[0, 0], [1, 0]]", "[[0, 0], [1, 0]]", "kind = \"edges\"\nedges = []");
    let shown = |property: &str| {
        let answer = answered(&apart, "n = 1", property, "1 < 0");
        assert_eq!(answer.verdict, Verdict::False, "{property}");
        let found = answer.decisive.clone().expect("an inequality");
        let json = answer.json(None)["decisive"].clone();
        assert_eq!(json["left"], found.left.as_str());
        let line =
            format!("there {} has {} on its left and {} on its right", found.inequality, found.left, found.right);
        assert!(answer.text(None).contains(&line), "{}", answer.text(None));
        let [left, right] = [&found.left, &found.right].map(|side| {
            let ends = side.trim_matches(['[', ']']).split(", ");
            let ends: Vec<f64> =
                ends.map(|x| arithmetic::parse_rational(x).map_or(f64::NAN, |q| q.to_f64().unwrap())).collect();
            (ends[0], ends[ends.len() - 1])
        });
        (found.inequality, left, right, found.time)
    };
    // The distance is 1 + t.
    let (inequality, left, right, time) = shown("always[0, 4](min_distance < 3 or min_distance < 2)");
    assert_eq!((inequality.as_str(), right), ("min_distance < 3", (3.0, 3.0)));
    assert!(left.0 > 2.9 && left.1 < 4.1 && time.is_some(), "{left:?} {time:?}");
    let (inequality, left, _, _) = shown("min_distance > 0 until[1, 2] min_distance > 7");
    assert!(inequality == "min_distance > 7" && left.1 > 2.9 && left.1 < 3.1, "{inequality} {left:?}");
    let (inequality, left, _, time) = shown("min_distance > 1 until[1, 2] min_distance > 2");
    assert_eq!((inequality.as_str(), left, time.as_deref()), ("min_distance > 1", (1.0, 1.0), Some("0")));
    let (inequality, left, right, time) = shown("1 < 2 and initial(min_distance) < 1/2");
    assert_eq!((inequality.as_str(), left, right, time), ("initial(min_distance) < 1/2", (1.0, 1.0), (0.5, 0.5), None));
    let (inequality, left, right, _) = shown("initial(min_distance) >= 1 implies initial(kinetic) > 2");
    assert_eq!((inequality.as_str(), left, right), ("initial(kinetic) > 2", (0.5, 0.5), (2.0, 2.0)));
    let (inequality, ..) = shown("not eventually[0, 1](1/2 < min_distance < 3/2)");
    assert!(inequality.contains("min_distance"), "{inequality}");
}
