//! Motions of scenarios: time operators, particles, platoons as sums over modes.

use super::refusal_with;
use arithmetic::Unwatched;
use question::{Answer, Question, Verdict, decide};

pub(super) fn answered(scenario: &str, family: &str, property: &str, control: &str) -> Answer {
    let files = |_: &str| Ok(scenario.to_string());
    let text = asked(family, property, control);
    decide(&Question::read(&text, &files).expect("a question"), &Unwatched).expect("an answer")
}

pub(super) fn asked(family: &str, property: &str, control: &str) -> String {
    // One member, which needs no name.
    let family = if family == "n = 1" { "" } else { family };
    format!(
        "[question]\nid = \"test\"\nscenario = \"motion.toml\"\n[for]\n{family}\n[holds]\nproperty = \"{property}\"\n\
         controls = [\"{control}\"]\n"
    )
}

pub(super) fn verdict(scenario: &str, property: &str) -> Verdict {
    answered(scenario, "n = 1", property, "1 < 0").verdict
}

/// Two agents without forces: their distance is 1 + t.
const APART: &str = "model = \"velocity-alignment\"\n[graph]\nkind = \"edges\"\nedges = []\n[state]\n\
    positions = [[0, 0], [1, 0]]\nvelocities = [[0, 0], [1, 0]]\n[law]\npotential = \"none\"\n[run]\nuntil = 4\n";

/// Twelve steered particles, everyone coupled to everyone.
fn twelve() -> String {
    let places: Vec<String> = (0..12).map(|k| format!("[{}, {}]", k % 4, k / 4)).collect();
    let phases: Vec<String> = (0..12).map(|k| format!("\"{}/10\"", 2 * k - 11)).collect();
    format!(
        "model = \"particles\"\n[state]\npositions = [{}]\nphases = [{}]\n[law]\nomega0 = \"1/2\"\nK1 = -1\nK0 = \"1/5\"\n\
         [run]\nuntil = 1\n",
        places.join(", "),
        phases.join(", ")
    )
}

pub(super) fn platoon(followers: usize) -> String {
    let places: Vec<String> = (0..=followers).map(|k| format!("{}", -2 * (k as i64))).collect();
    let speeds = vec!["0"; followers + 1].join(", ");
    format!(
        "model = \"platoon\"\n[state]\npositions = [{}]\nvelocities = [{speeds}]\n[law]\nf = -1\ng = -1\nspacing = 2\n\
         communication = \"front-and-back\"\nleader = {{ amplitude = \"1/4\", frequency = \"1/3\" }}\n[run]\nuntil = 4\n",
        places.join(", ")
    )
}

#[test]
fn until_counts_from_every_time_of_the_outer_operator() {
    assert_eq!(verdict(APART, "min_distance > 1/2 until[0, 2] min_distance > 2"), Verdict::Holds);
    assert_eq!(verdict(APART, "min_distance > 3/2 until[0, 2] min_distance > 2"), Verdict::False);
    // At t = 2/5 the first one holds, and the second one comes at t = 1; at t = 0 the first one does not.
    let inner = "(min_distance > 13/10 until[0, 1] min_distance > 2)";
    assert_eq!(verdict(APART, &format!("always[0, 1/2]{inner}")), Verdict::False);
    assert_eq!(verdict(APART, &format!("eventually[0, 1/2]{inner}")), Verdict::Holds);
}

#[test]
fn margins_of_time_operators_are_enclosed() {
    let margin = |property: &str| {
        let margin = answered(APART, "n = 1", property, "1 < 0").margin.expect("a margin");
        assert!(margin.lo <= margin.hi, "{margin:?}");
        (margin.lo, margin.hi)
    };
    let encloses = |(lo, hi): (f64, f64), value: f64, width: f64| {
        assert!(lo <= value && value <= hi && hi - lo < width, "{value} and [{lo}, {hi}]");
    };
    encloses(margin("always[0, 2](min_distance < 4)"), 1.0, 2.0);
    encloses(margin("always[0, 2](min_distance < 2)"), -1.0, 2.0);
    // The smaller one of 3 - 2 at t = 2 and of 1 - 1/2 at t = 0.
    let (lo, hi) = margin("min_distance > 1/2 until[0, 2] min_distance > 2");
    assert!(lo <= 0.5 && 0.5 <= hi && lo >= -0.5 && hi < 1.5, "[{lo}, {hi}]");
    let (lo, hi) = margin("min_distance > 3/2 until[0, 2] min_distance > 2");
    assert!(lo <= -0.5 && (-0.5..=0.0).contains(&hi), "[{lo}, {hi}]");
}

#[test]
fn every_inequality_has_a_margin_of_its_own() {
    let property = "always[0, 2](min_distance > 1/2 and min_distance < 4) and not eventually[1, 2](min_distance < 3/2)";
    let answer = answered(APART, "n = 1", property, "1 < 0");
    let texts: Vec<&str> = answer.inequalities.iter().map(|(text, _)| text.as_str()).collect();
    let own =
        ["always[0, 2](min_distance > 1/2)", "always[0, 2](min_distance < 4)", "always[1, 2](min_distance >= 3/2)"];
    assert_eq!(texts, own);
    for ((_, margin), value) in answer.inequalities.iter().zip([0.5, 1.0, 0.5]) {
        let margin = margin.expect("a margin");
        assert!(margin.lo <= value && value <= margin.hi && margin.lo > 0.0, "{margin:?} {value}");
    }
    // Over a box of starts the smallest one: of x_2 = 1 + s + t for s in [0, 1] that at s = 0.
    let start = "\"state.positions[2][1]\" = \"[1, 2]\"";
    let answer = answered(APART, start, "always[0, 2](min_distance > 1/2) or always[0, 1](min_distance > 9)", "1 < 0");
    let margins: Vec<_> = answer.inequalities.iter().map(|(_, margin)| margin.expect("a margin")).collect();
    for (margin, value) in margins.iter().zip([0.5, -8.0]) {
        assert!(margin.lo <= value && value <= margin.hi, "{margins:?} {value}");
    }
}

#[test]
fn twelve_steered_particles_are_enclosed() {
    let text = twelve();
    let property = "always[1/10, 1](order > initial(order) and min_distance > 1/2) and \
                    eventually[0, 1](phase_potential < initial(phase_potential) - 1/100)";
    let answer = answered(&text, "n = 1", property, "always[1/10, 1](order < initial(order))");
    assert_eq!(answer.verdict, Verdict::Holds, "{}", answer.why);
    // (17) decreases with a spacing gain below 0 together with the phase potential; with one above 0 particles leave their circle.
    assert_eq!(verdict(&text, "always[0, 1/2](spacing_potential > 0)"), Verdict::Holds);
    // At the start neighbours are exactly as far apart as the radius.
    let switching = text.replace("[state]", "[graph]\nkind = \"within\"\nradius = 1\n[state]");
    let open = answered(&switching, "n = 1", "always[0, 1](order > 0)", "1 < 0");
    assert!(open.verdict == Verdict::Undecided && open.why.contains("pass the radius after t = 0"), "{}", open.why);
    let nearest = text.replace("[state]", "[graph]\nkind = \"nearest\"\nnearest = 2\n[state]");
    let open = answered(&nearest, "n = 1", "always[0, 1](order > 0)", "1 < 0");
    assert!(open.verdict == Verdict::Undecided && open.why.contains("to the nearest"), "{}", open.why);
}

/// Two particles that turn towards each other's direction and one too far away for them, within a radius.
const NEAR_AND_FAR: &str = "model = \"particles\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\n\
    positions = [[0, 0], [1, 0], [7, 0]]\nphases = [\"1/4\", \"1\", 3]\n[law]\nomega0 = \"1/2\"\nK1 = -1\nK0 = \"1/5\"\n\
    [run]\nuntil = 1\n";

#[test]
fn particles_within_a_radius_are_enclosed_until_one_may_pass_it() {
    let property = "always[0, 1](components = 2 and min_distance < 2) and always[1/10, 1](order > initial(order))";
    let control = "always[0, 1](components = 1)";
    let answer = answered(NEAR_AND_FAR, "n = 1", property, control);
    assert_eq!(answer.verdict, Verdict::Holds, "{}", answer.why);
    // With a larger radius the third one turns the others, too.
    let wide = NEAR_AND_FAR.replace("radius = 2", "radius = 20");
    assert_eq!(verdict(&wide, property), Verdict::False);
    // Straight ahead, away from each other: their distance is 2 shortly after t = 1/2.
    let parting = "model = \"particles\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\npositions = [[0, 0], [1, 0]]\n\
                   phases = [3, 0]\n[law]\nomega0 = 0\n[run]\nuntil = 1\n";
    assert_eq!(verdict(parting, "always[0, 1/2](components = 1 and min_distance < 2)"), Verdict::Holds);
    assert_eq!(verdict(parting, "always[0, 1/2](min_distance < 3/2)"), Verdict::False);
    let open = answered(parting, "n = 1", "always[0, 1](min_distance < 4)", "always[0, 1](min_distance < 1)");
    assert!(open.verdict == Verdict::Undecided && open.why.contains("only up to t = 0.50"), "{}", open.why);
    assert!(open.why.contains("particles 1 and 2 may pass the radius"), "{}", open.why);
    // A start that is an interval may have links or not.
    let family = "\"state.positions[2][1]\" = \"[19/10, 21/10]\"";
    let open = answered(parting, family, "always[0, 1/100](min_distance > 1)", "always[0, 0](min_distance > 3)");
    assert_eq!(open.verdict, Verdict::Undecided, "{}", open.why);
}

/// Three agents that turn towards each other.
const TURNING: &str = "model = \"heading-alignment\"\n[graph]\nkind = \"complete\"\n[state]\n\
    positions = [[0, 0], [2, 0], [1, 2]]\nvelocities = [[1, 0], [1, \"1/2\"], [1, \"-1/4\"]]\n[law]\n\
    potential = \"inverse-square-log\"\n[run]\nuntil = \"1/4\"\n";

#[test]
fn heading_alignment_is_enclosed() {
    // The turning force does no work, so that the energy stays, while the potentials turn the agents, too.
    let conserved = "always[0, 1/4](abs(energy - initial(energy)) < 1/50)";
    let answer = answered(TURNING, "n = 1", conserved, "always[0, 1/4](kinetic = initial(kinetic))");
    assert_eq!(answer.verdict, Verdict::Holds, "{}", answer.why);
    // A run in floats ends within the enclosure.
    let rows = scenario::Scenario::read(TURNING).expect("a scenario").run(&Unwatched).rows;
    for name in ["heading_spread", "disagreement", "min_distance"] {
        let observables = &rows.last().expect("a row").observables;
        let value = match &observables.iter().find(|observable| observable.name == name).expect("it is observed").value
        {
            scenario::Value::Number(x) => *x,
            other => panic!("{other:?}"),
        };
        assert_eq!(verdict(TURNING, &format!("always[1/4, 1/4](abs({name} - {value:.12}) < 10^(-6))")), Verdict::Holds);
    }
    // Two agents on either side of the direction -x: their headings are far apart as they are read, and near as angles.
    let behind = "velocities = [[-1, \"1/4\"], [-1, \"-1/4\"], [-1, \"1/2\"]]";
    let turned = TURNING.replace("velocities = [[1, 0], [1, \"1/2\"], [1, \"-1/4\"]]", behind);
    let open =
        answered(&turned.replace("[law]", "[law]\nheading_difference = \"wrapped\""), "n = 1", conserved, "1 < 0");
    assert!(open.verdict == Verdict::Undecided && open.why.contains("opposite directions"), "{}", open.why);
    let raw = answered(&TURNING.replace("[[1, 0]", "[[-1, 0]"), "n = 1", conserved, "1 < 0");
    assert!(raw.verdict == Verdict::Undecided && raw.why.contains("may pass pi"), "{}", raw.why);
    let within = TURNING.replace("kind = \"complete\"", "kind = \"within\"\nradius = 4");
    let open = answered(&within, "n = 1", conserved, "1 < 0");
    assert!(open.verdict == Verdict::Undecided && open.why.contains("do not switch"), "{}", open.why);
}

/// Two agents that are linked up to the distance 5/4, which they pass at t = log(2)/2.
const PARTING: &str = "model = \"velocity-alignment\"\n[graph]\nkind = \"within\"\nradius = \"5/4\"\n[state]\n\
    positions = [[0, 0], [1, 0]]\nvelocities = [[0, 0], [1, 0]]\n[law]\npotential = \"none\"\n[run]\nuntil = 1\n";

#[test]
fn observables_of_runs_lie_in_their_enclosures() {
    let shared = ["momentum(1)", "momentum(2)", "components"];
    let agents = [shared.as_slice(), &["energy", "saturated_energy"]].concat();
    let particles =
        [shared.as_slice(), &["centre_spread", "orientation_potential", "spacing_potential", "composite_potential"]]
            .concat();
    let repelling = PARTING.replace("\"none\"", "\"inverse-square-log\"");
    let fixed = repelling.replace("\"within\"\nradius = \"5/4\"", "\"complete\"");
    let drifting = twelve().replace("K0 =", "drift = [\"1/3\", \"-1/7\"]\nK0 =");
    let circling = twelve().replace("K0 =", "beacon = [\"1/3\", 1]\nK0 =");
    let runs: [(&str, &[&str]); 9] = [
        (PARTING, &agents),
        (&repelling, &agents),
        (&fixed, &agents),
        (TURNING, &shared),
        (&twelve(), &particles),
        (&drifting, &particles),
        (&circling, &particles),
        (NEAR_AND_FAR, &particles),
        (&platoon(3), &["components"]),
    ];
    for (text, names) in runs {
        let rows = scenario::Scenario::read(text).expect("a scenario").run(&Unwatched).rows;
        let row = rows.last().expect("a row");
        let columns: Vec<(String, f64)> = row.observables.iter().flat_map(|observable| observable.columns()).collect();
        let near = names.iter().map(|name| {
            let column = name.replace('(', "_").replace(')', "");
            let (_, value) = columns.iter().find(|(own, _)| *own == column).expect("it is observed");
            format!("abs({name} - ({value:.12})) < 10^(-6)")
        });
        let property = format!("always[{0}, {0}]({1})", row.time, near.collect::<Vec<_>>().join(" and "));
        assert_eq!(verdict(text, &property), Verdict::Holds, "{property} of {text}");
    }
}

#[test]
fn links_that_change_are_counted_where_they_are_known() {
    assert_eq!(verdict(PARTING, "always[0, 1/3](components = 1) and always[2/5, 1](components = 2)"), Verdict::Holds);
    assert_eq!(verdict(PARTING, "always[0, 1](components >= 1 and components <= 2)"), Verdict::Holds);
    assert_eq!(verdict(PARTING, "always[0, 1](components = 1)"), Verdict::False);
    // Q does not rise where a link breaks; its energy is not known at that moment.
    let repelling = PARTING.replace("\"none\"", "\"inverse-square-log\"");
    let falls = "always[0, 1](saturated_energy < initial(saturated_energy) + 1/100)";
    let answer = answered(&repelling, "n = 1", falls, "always[0, 1](saturated_energy > initial(saturated_energy))");
    assert_eq!(answer.verdict, Verdict::Holds, "{}", answer.why);
}

#[test]
fn observables_that_are_not_decided_say_why() {
    for name in ["clusters", "pattern_order", "mean_neighbours"] {
        let message = refusal_with(&asked("n = 1", &format!("always[0, 1]({name} > 0)"), "1 < 0"), &twelve());
        assert!(message.starts_with("line 7, column 26: ") && message.contains("no question decides"), "{message}");
    }
    let message = refusal_with(&asked("n = 1", "always[0, 1](momentum(3) > 0)", "1 < 0"), APART);
    assert!(message.starts_with("line 7, column 26: ") && message.contains("1 or 2"), "{message}");
}

#[test]
fn platoons_on_a_line_are_decided_on_the_sum_over_modes() {
    // Far more cars and far longer than steps could follow.
    let (text, long) = (platoon(12), "always[0, 40](abs(last_deviation) < 3 and min_gap > 1)");
    assert_eq!(verdict(&text, long), Verdict::Holds);
    assert_eq!(verdict(&text, "always[0, 40](abs(last_deviation) < 1/4)"), Verdict::False);
    // The same platoon by steps: with the graph written as arcs that say the same, but in a network of its own.
    let short = platoon(3);
    let stepped = short.replace("communication = \"front-and-back\"\n", "").replace(
        "[state]",
        "[graph]\nkind = \"edges\"\ndirected = true\nedges = [[2, 1], [2, 3], [3, 2], [3, 4], [4, 3]]\n[state]",
    );
    let family = "\"state.velocities[2]\" = \"[0, 1/1000]\"";
    for property in ["always[0, 4](largest_deviation < 1/2)", "eventually[3, 4](last_deviation < -1/20)"] {
        let [a, b] = [&short, &stepped].map(|text| answered(text, family, property, "1 < 0"));
        let (a, b) = (a.margin.expect("a margin"), b.margin.expect("a margin"));
        assert!(a.lo <= b.hi && b.lo <= a.hi, "{property}: {a:?} {b:?}");
    }
}

/// Cars that track the one in front have a closed form, too, also where the roots of `s² = f + g s` coincide: no time is out of reach, and by steps the
/// same platoon has the same margins.
#[test]
fn one_sided_platoons_are_decided_at_any_time() {
    for gains in ["f = -1\ng = -1\n", "f = -1\ng = -2\n", "f = -1\ng = -5\n"] {
        let front =
            |followers: usize| platoon(followers).replace("front-and-back", "front").replace("f = -1\ng = -1\n", gains);
        let stepped = front(3).replace("communication = \"front\"\n", "").replace(
            "[state]",
            "[graph]\nkind = \"edges\"\ndirected = true\nedges = [[2, 1], [3, 2], [4, 3]]\n[state]",
        );
        let family = "\"state.velocities[2]\" = \"[0, 1/1000]\"";
        let property = "always[0, 4](largest_deviation < 1/2)";
        let [a, b] =
            [&front(3), &stepped].map(|text| answered(text, family, property, "1 < 0").margin.expect("a margin"));
        assert!(a.lo <= b.hi && b.lo <= a.hi, "{gains}: {a:?} {b:?}");
        let long = "always[0, 10](largest_deviation < 2) and always[100000, 100001](largest_deviation < 2)";
        assert_eq!(verdict(&front(4), long), Verdict::Holds, "{gains}");
        assert_eq!(verdict(&front(4), "always[100000, 100001](largest_deviation < 1/1000)"), Verdict::False, "{gains}");
    }
}

#[test]
fn what_a_motion_cannot_be_asked() {
    for (property, column, named) in [
        ("always[0, inf](min_distance > 0)", 23, "`inf`"),
        ("always[2, 1](min_distance > 0)", 23, "ends before it begins"),
        ("always[-1, 1](min_distance > 0)", 20, "not negative"),
        ("min_distance > 0", 13, "changes in time"),
        ("always[0, 1](order > 0)", 26, "no observable of this model"),
    ] {
        let message = refusal_with(&asked("n = 1", property, "1 < 0"), APART);
        assert!(message.starts_with(&format!("line 7, column {column}: ")) && message.contains(named), "{message}");
        assert!(!message.contains('\n'));
    }
}

#[test]
fn every_inequality_stands_under_its_time_operators() {
    let of = |property: &str| -> Vec<String> {
        let found = answered(APART, "n = 1", property, "1 < 0");
        found.inequalities.into_iter().map(|(text, _)| text).collect()
    };
    assert_eq!(
        of("not always[0, 2](min_distance < 1 or eventually[1, 3](min_distance > 2))"),
        ["eventually[0, 2](min_distance >= 1)", "eventually[0, 2](always[1, 3](min_distance <= 2))"]
    );
    assert_eq!(
        of("min_distance < 9 until[2, 3] min_distance > 0"),
        ["always[0, 2](min_distance < 9)", "eventually[2, 3](min_distance > 0)"]
    );
}

#[test]
fn a_counterexample_is_shown_in_the_shortest_time() {
    // The distance 1 + t reaches 2 at t = 1.
    let family = "\"state.velocities[2][1]\" = [1, 2]";
    let found = answered(APART, family, "always[0, 3](min_distance < 2) and 1 < 2", "always[0, 3](min_distance < 3/2)");
    assert_eq!(found.verdict, Verdict::False);
    let shorter = found.shorter.expect("a shorter time");
    let end = shorter.split(['[', ']']).nth(1).and_then(|span| span.strip_prefix("0, ")).expect("a span");
    let end = arithmetic::parse_rational(end).expect("a number");
    assert!(end >= arithmetic::rational(1, 1) && end < arithmetic::rational(11, 10), "{shorter}");
    // The replay decides that by itself, with the own control.
    let replay = found.replay.expect("a replay");
    assert!(
        replay.contains(&shorter) && replay.contains("controls = [\"always[0, 3](min_distance < 3/2)\"]"),
        "{replay}"
    );
    let files = |_: &str| Ok(APART.to_string());
    let again = decide(&Question::read(&replay, &files).expect("a question"), &Unwatched).expect("an answer");
    assert_eq!((again.verdict, again.controls), (Verdict::False, vec![true]));
    // With a shorter time the second half could hold: nothing is made shorter.
    let eventually = answered(APART, "n = 1", "eventually[0, 1/2](min_distance > 2)", "1 < 0");
    assert_eq!((eventually.verdict, eventually.shorter), (Verdict::False, None));
}

/// Three arcs of three phases are not all-to-all: the order at t = 1 is that of SciPy's motion along the arcs, 0.504216, and not 0.655934.
#[test]
fn phases_are_enclosed_along_their_arcs() {
    let text = "model = \"phase\"\n[graph]\nkind = \"edges\"\nedges = [[1, 2], [2, 3], [3, 1]]\ndirected = true\n[state]\nphases = [0, 1, 3]\n\
                [law]\nK1 = -1\n[run]\nuntil = 1\n";
    assert_eq!(verdict(text, "always[1, 1](abs(order - 504216/1000000) < 1/1000000)"), Verdict::Holds);
    assert_eq!(verdict(text, "always[1, 1](order > 6/10)"), Verdict::False);
    // Two phases with one arc: the second one senses nobody.
    let pair = text.replace("[[1, 2], [2, 3], [3, 1]]", "[[1, 2]]").replace("[0, 1, 3]", "[0, 1]");
    // cos of half the difference, 1 - 0.360072.
    assert_eq!(verdict(&pair, "always[1, 1](abs(order - cos(63992756/200000000)) < 1/1000000)"), Verdict::Holds);
}
