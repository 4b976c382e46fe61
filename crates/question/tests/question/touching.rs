//! Values that are touched at one instant and not passed: decided where the motion is known in closed form.

use super::motions::{answered, verdict};
use question::Verdict;

/// Asks for a value that is touched, a control beyond it, and one before it.
fn touches(scenario: &str, touched: &str, beyond: &str, before: &str, window: &str) {
    let of = |body: &str| verdict(scenario, &format!("eventually{window}({body})"));
    assert_eq!(of(touched), Verdict::Holds, "{touched}");
    assert_eq!(of(before), Verdict::Holds, "{before}");
    assert_eq!(of(beyond), Verdict::False, "{beyond}");
}

/// Two agents that pass each other at the distance `3/7`, at the time `time`.
fn passing(time: (i64, i64)) -> String {
    let (p, q) = time;
    format!(
        "model = \"velocity-alignment\"\n[graph]\nkind = \"edges\"\nedges = []\n[state]\n\
         positions = [[0, 0], [\"{p}/{q}\", \"3/7\"]]\nvelocities = [[1, 0], [0, 0]]\n[law]\npotential = \"none\"\n\
         [run]\nuntil = 4\n"
    )
}

#[test]
fn agents_without_forces_pass_each_other_at_a_distance() {
    for time in [(1, 1), (1, 3), (5, 7), (22, 17), (355, 113)] {
        let [touched, beyond, before] =
            ["3/7", "299999/700000", "300001/700000"].map(|bound| format!("min_distance <= {bound}"));
        touches(&passing(time), &touched, &beyond, &before, "[0, 4]");
    }
    // Not in windows that do not hold the instant.
    assert_eq!(verdict(&passing((1, 3)), "eventually[2/5, 1](min_distance <= 3/7)"), Verdict::False);
    assert_eq!(verdict(&passing((1, 3)), "eventually[0, 33333/100000](min_distance <= 3/7)"), Verdict::False);
    assert_eq!(verdict(&passing((1, 3)), "always[0, 2](min_distance > 3/7)"), Verdict::False);
}

/// One number and its rate under a law.
fn own(rate: &str, x: &str, v: &str) -> String {
    format!(
        "model = \"own\"\n[law]\ntime = \"continuous\"\ndimension = 1\nstate = {{ x = \"number\", v = \"number\" }}\n\
         [law.rates]\nx = \"v\"\nv = \"{rate}\"\n[state]\nx = [\"{x}\"]\nv = [\"{v}\"]\n[run]\nuntil = 4\n"
    )
}

#[test]
fn laws_of_ones_own_touch_a_value() {
    // A fall upward: x = (t - 2/3)².
    touches(&own("2", "4/9", "-4/3"), "x[1] <= 0", "x[1] <= -1/100000", "x[1] <= 1/100000", "[0, 2]");
    // Exponents 1 and 2: x = z² - z with z = exp(-t), -1/4 at t = log 2.
    touches(&own("-3*v - 2*x", "0", "-1"), "x[1] <= -1/4", "x[1] <= -25001/100000", "x[1] <= -24999/100000", "[0, 2]");
    // x = cos t, -1 at pi; x = 3 cos 2t + 4 sin 2t, 5 at tan t = 1/2; x = cos t at pi/3 and its rate there.
    touches(&own("-x", "1", "0"), "x[1] <= -1", "x[1] <= -100001/100000", "x[1] <= -99999/100000", "[0, 4]");
    touches(&own("-4*x", "3", "8"), "x[1] >= 5", "x[1] >= 500001/100000", "x[1] >= 499999/100000", "[0, 2]");
    // 1 = cos² + sin²: equal to 5/4 nowhere, and the product is 1/2 at pi/4 only.
    touches(&own("-x", "1", "0"), "x[1]*v[1] <= -1/2", "x[1]*v[1] <= -51/100", "x[1]*v[1] <= -49/100", "[0, 2]");
    // A common exponential: x = (t - 1)² exp(-t) needs three states; v = (3 - t) (t - 1) exp(-t).
    let three = "model = \"own\"\n[law]\ntime = \"continuous\"\ndimension = 1\n\
        state = { x = \"number\", y = \"number\", z = \"number\" }\n[law.rates]\nx = \"y - x\"\ny = \"2*z - y\"\nz = \"-z\"\n\
        [state]\nx = [1]\ny = [-2]\nz = [1]\n[run]\nuntil = 4\n";
    touches(three, "x[1] <= 0", "x[1] <= -1/1000000", "x[1] <= 1/100000", "[0, 2]");
}

#[test]
fn platoons_touch_a_value() {
    // One follower with exponents 1 and 2, as above.
    let one = "model = \"platoon\"\n[state]\npositions = [0, -2]\nvelocities = [0, -1]\n[law]\nf = -2\ng = -3\nspacing = 2\n\
        communication = \"front\"\n[run]\nuntil = 4\n";
    touches(
        one,
        "last_deviation <= -1/4",
        "last_deviation <= -25001/100000",
        "last_deviation <= -24999/100000",
        "[0, 5]",
    );
    touches(one, "max_gap >= 9/4", "max_gap >= 225001/100000", "max_gap >= 224999/100000", "[0, 5]");
    // Velocities that align: v = 1/2 + z/2 and its mirror, z = exp(-2t); (v1 - 3/4)² is 0 at z = 1/2.
    let aligned = "model = \"velocity-alignment\"\n[graph]\nkind = \"edges\"\nedges = [[1, 2]]\n[state]\n\
        positions = [[0, 0], [5, 0]]\nvelocities = [[1, 0], [0, 0]]\n[law]\npotential = \"none\"\n[run]\nuntil = 4\n";
    touches(
        aligned,
        "(kinetic - 5/16)^2 <= 0",
        "(kinetic - 5/16)^2 <= -1/1000000",
        "(kinetic - 5/16)^2 <= 1/1000000",
        "[0, 2]",
    );
}

#[test]
fn what_is_not_decided_says_why() {
    let why = |scenario: &str, property: &str| {
        let answer = answered(scenario, "n = 1", property, "1 < 0");
        assert_eq!(answer.verdict, Verdict::Undecided, "{property}");
        answer.why
    };
    // x = exp(-t) (t - 1)² has an exponential and powers of the time.
    let three = "model = \"own\"\n[law]\ntime = \"continuous\"\ndimension = 1\n\
        state = { x = \"number\", y = \"number\", z = \"number\" }\n[law.rates]\nx = \"y - x\"\ny = \"2*z - y\"\nz = \"-z\"\n\
        [state]\nx = [1]\ny = [-2]\nz = [1]\n[run]\nuntil = 4\n";
    let stays = why(three, "always[0, 2](x[1] >= 0)");
    assert!(stays.contains("that two sides only touch and never pass is not proved"), "{stays}");
    // The product of the roots of s² + 3 s + 1 is 1, and they are not rational; the least value is no simple number.
    let open = why(&own("-3*v - x", "0", "-1"), "eventually[0, 4](x[1] <= x[1])");
    assert!(open.contains("since the motion has no closed form with rational exponents and frequencies"), "{open}");
}

/// What touches a bound and never passes keeps to it, and what would pass it does not.
fn keeps(scenario: &str, property: &str, false_one: &str) {
    assert_eq!(verdict(scenario, property), Verdict::Holds, "{property}");
    assert_eq!(verdict(scenario, false_one), Verdict::False, "{false_one}");
}

#[test]
fn what_touches_a_bound_and_never_passes_keeps_to_it() {
    for time in [(1, 1), (1, 3), (355, 113)] {
        let scenario = passing(time);
        keeps(&scenario, "always[0, 4](min_distance >= 3/7)", "always[0, 4](min_distance >= 300001/700000)");
        keeps(&scenario, "always[0, 4](min_distance > 299999/700000)", "always[0, 4](min_distance > 3/7)");
        assert_eq!(verdict(&scenario, "eventually[0, 4](min_distance < 3/7)"), Verdict::False);
        keeps(
            &scenario,
            "always[0, 4](min_distance^2 >= 9/49 and min_distance >= 3/7)",
            "always[0, 4](min_distance^2 >= 9/49 and min_distance >= 3/7 + 1/1000000)",
        );
    }
    // Polynomials, at an irrational time: x = (t² - 2)² is 4 - 4 t² + t⁴.
    let quartic = "model = \"own\"\n[law]\ntime = \"continuous\"\ndimension = 1\n\
        state = { x = \"number\", a = \"number\", b = \"number\", c = \"number\" }\n[law.rates]\nx = \"a\"\na = \"b\"\nb = \"c\"\n\
        c = \"24\"\n[state]\nx = [4]\na = [0]\nb = [-8]\nc = [0]\n[run]\nuntil = 4\n";
    keeps(quartic, "always[0, 2](x[1] >= 0)", "always[0, 2](x[1] >= 1/1000000)");
    // An exponential, an angle at half a turn and one at a tangent, and a product.
    keeps(&own("-3*v - 2*x", "0", "-1"), "always[0, 2](x[1] >= -1/4)", "always[0, 2](x[1] >= -24999/100000)");
    keeps(&own("-x", "1", "0"), "always[0, 4](x[1] >= -1)", "always[0, 4](x[1] > -1)");
    keeps(&own("-4*x", "3", "8"), "always[0, 2](x[1] <= 5)", "always[0, 2](x[1] <= 4999999/1000000)");
    keeps(&own("-x", "1", "0"), "always[0, 2](x[1]*v[1] >= -1/2)", "always[0, 2](x[1]*v[1] > -1/2)");
    // It passes within a millionth of a time: x = (t - 2/3)² - 10^-12.
    let passes = own("2", "444444444443/1000000000000", "-4/3");
    assert_eq!(verdict(&passes, "always[0, 2](x[1] >= -1/500000000000)"), Verdict::Holds);
    assert_ne!(verdict(&passes, "always[0, 2](x[1] >= 0)"), Verdict::Holds);
}

#[test]
fn until_and_windows_of_one_instant_are_decided_where_something_is_touched() {
    let scenario = passing((1, 3));
    keeps(&scenario, "eventually[1/3, 1/3](min_distance = 3/7)", "eventually[1/4, 1/4](min_distance <= 3/7)");
    keeps(&scenario, "always[1/3, 1/3](min_distance <= 3/7)", "always[1/3, 1/3](min_distance > 3/7)");
    // It comes at one instant, or not in the window, or too late.
    keeps(
        &scenario,
        "min_distance < 1 until[0, 4] min_distance <= 3/7",
        "min_distance < 1 until[1/2, 4] min_distance <= 3/7",
    );
    keeps(
        &scenario,
        "min_distance > 2/5 until[0, 2] min_distance >= 1",
        "min_distance > 3/7 until[0, 2] min_distance >= 1",
    );
    keeps(
        &scenario,
        "min_distance >= 3/7 until[0, 2] min_distance >= 1",
        "min_distance >= 3/7 until[0, 2] min_distance < 3/7",
    );
}
