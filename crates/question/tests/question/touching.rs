//! Values that are touched at one instant and not passed: decided where the motion is known in closed form.

use super::motions::{answered, asked, verdict};
use arithmetic::random::{generator, uniform};
use arithmetic::{Rational, Ring, Unwatched, rational};
use num_traits::ToPrimitive;
use question::{Question, Verdict, decide};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::{PI, TAU};

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
    // At time 0 the start itself would tell.
    let open = why(&own("-3*v - x", "0", "-1"), "eventually[1, 4](x[1] <= x[1])");
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

/// A motion `x` of one number with the value of its extremes and the times at which it has them, in floats.
struct Extreme {
    scenario: String,
    value: Rational,
    is_least: bool,
    times: Vec<f64>,
}

/// A motion drawn at random: a fall, two exponentials, or a swing.
fn drawn(random: &mut ChaCha8Rng) -> Extreme {
    let mut pick = |from: i64, to: i64| from + (uniform(random) * (to - from + 1) as f64) as i64;
    let (kind, sign, shift) = (pick(0, 2), if pick(0, 1) == 0 { 1 } else { -1 }, rational(pick(-9, 9), pick(1, 9)));
    let text = |rate: String, x: Rational, v: Rational| own(&rate, &x.to_string(), &v.to_string());
    let float = |q: &Rational| q.to_f64().expect("finite");
    match kind {
        0 => {
            // x = sign k (t - time)² + shift.
            let (k, time) = (rational(sign * pick(1, 5), 1), rational(pick(1, 40), pick(7, 13)));
            let scenario =
                text((&k * rational(2, 1)).to_string(), &k * time.square() + &shift, &k * &time * rational(-2, 1));
            Extreme { scenario, value: shift, is_least: sign > 0, times: vec![float(&time)] }
        }
        1 => {
            // x = B (z² - 2 at z), z = exp(-t): least or greatest where z = at.
            let (b, at) = (rational(sign * pick(1, 9), pick(1, 4)), rational(pick(1, 9), 10));
            let a = &b * &at * rational(-2, 1);
            let scenario = text("-3*v - 2*x".to_string(), &a + &b, -(&a + &b * rational(2, 1)));
            let value = -(&b * at.square());
            Extreme { scenario, value, is_least: sign > 0, times: vec![-float(&at).ln()] }
        }
        _ => {
            // x = s (p cos wt + q sin wt), of amplitude s r, its extremes every half turn by turns.
            let (p, q, r) = [(3, 4, 5), (5, 12, 13), (8, 15, 17)][pick(0, 2) as usize];
            let (w, s) = (pick(1, 3), rational(pick(1, 9), pick(1, 9)));
            let [p, q] = [p * sign, q * if pick(0, 1) == 0 { 1 } else { -1 }];
            let x = &s * rational(p, 1);
            let scenario = text(format!("-{}*x", w * w), x, &s * rational(q * w, 1));
            let is_least = pick(0, 1) == 0;
            let greatest = (q as f64).atan2(p as f64) + if is_least { PI } else { 0.0 };
            let times = (-2..5).map(|k| (greatest + TAU * f64::from(k)) / w as f64).filter(|t| *t > 0.0);
            let value = s * rational(if is_least { -r } else { r }, 1);
            Extreme { scenario, value, is_least, times: times.collect() }
        }
    }
}

/// What is known of extremes without the program: nothing passes them, and they are attained at their times only.
#[test]
fn random_motions_keep_to_their_extremes_and_attain_them_at_their_times() {
    let mut random = generator("question.touching", "extremes", 0);
    let (mut decided, mut asked) = (0, 0);
    for _ in 0..40 {
        let Extreme { scenario, value, is_least, times } = drawn(&mut random);
        let from = (uniform(&mut random) * 20.0) as i64;
        let to = from + 2 + (uniform(&mut random) * 20.0) as i64;
        let (a, b) = (from as f64 / 10.0, to as f64 / 10.0);
        if times.iter().any(|t| (t - a).abs() < 1e-3 || (t - b).abs() < 1e-3) {
            continue;
        }
        let inside = times.iter().any(|t| a < *t && *t < b);
        let is_first = times.iter().copied().reduce(f64::min).is_some_and(|first| a < first && first < b);
        let window = format!("[{from}/10, {to}/10]");
        let [keeps, above, touches, passes] = if is_least { [">=", ">", "<=", "<"] } else { ["<=", "<", ">=", ">"] };
        let little = rational(if is_least { 1 } else { -1 }, 1_000_000);
        let (inner, outer) = (&value + &little, &value - &little);
        for (property, truth) in [
            (format!("always{window}(x[1] {keeps} {value})"), true),
            (format!("always{window}(x[1] {above} {value})"), !inside),
            (format!("always{window}(x[1] {keeps} {outer})"), true),
            (format!("eventually{window}(x[1] {touches} {value})"), inside),
            (format!("eventually{window}(x[1] {passes} {value})"), false),
            (format!("eventually{window}(x[1] {touches} {outer})"), false),
            (format!("x[1] {above} {value} until{window} x[1] {touches} {value}"), is_first),
            (format!("x[1] {keeps} {value} until{window} x[1] {passes} {value}"), false),
        ]
        .into_iter()
        // Within a millionth of the extreme outside of its time, too: only said where the time is inside.
        .chain(inside.then(|| (format!("always{window}(x[1] {keeps} {inner})"), false)))
        {
            let found = verdict(&scenario, &property);
            let wrong = if truth { Verdict::False } else { Verdict::Holds };
            assert_ne!(found, wrong, "{property} of\n{scenario}");
            asked += 1;
            decided += usize::from(found != Verdict::Undecided);
        }
    }
    assert!(decided * 10 >= asked * 9, "{decided} of {asked} were decided");
}

/// Nothing is asked of `p` at the time at which `q` comes, the first of the window too.
#[test]
fn until_asks_nothing_of_its_first_part_when_the_second_comes_as_the_window_begins() {
    // x = 1 - t, and x = (t - 2/3)².
    let (line, fall) = (own("0", "1", "-1"), own("2", "4/9", "-4/3"));
    for (scenario, property) in [
        (&line, "x[1] > 0 until[1, 2] x[1] <= 0"),
        (&line, "x[1] > 0 until[1, 1] x[1] <= 0"),
        (&line, "x[1]^2 > 0 until[1, 2] x[1] <= 0"),
        (&line, "abs(x[1]) > 0 until[1, 2] x[1] <= 0"),
        (&line, "x[1] > -1 until[2, 2] x[1] <= -1"),
        (&fall, "x[1] > 0 until[2/3, 2] x[1] = 0"),
        (&fall, "x[1] > 0 until[2/3, 2/3] x[1] <= 0"),
        (&fall, "v[1] < 0 until[2/3, 1] x[1] <= 0"),
    ] {
        assert_ne!(verdict(scenario, property), Verdict::False, "{property}");
    }
    assert_eq!(verdict(&line, "x[1] > 0 until[11/10, 2] x[1] <= 0"), Verdict::False);
}

/// What has no value at an instant does not hold for all times, whatever becomes of it when it is simplified.
#[test]
fn missing_values_are_not_simplified_away() {
    let (line, fall, passes) =
        (own("0", "1", "-1"), own("2", "4/9", "-4/3"), own("2", "444444444443/1000000000000", "-4/3"));
    for (scenario, property) in [
        (&line, "always[0, 2](1/(v[1]/x[1]) <= 1)"),
        (&line, "always[1, 1](1/(v[1]/x[1]) = 0)"),
        (&line, "not eventually[0, 2](1/(v[1]/x[1]) > 5)"),
        (&line, "x[1] <= 5 until[1, 1] 1/(v[1]/x[1]) <= 1"),
        (&fall, "always[2/3, 2/3]((1/x[1])^0 >= 1)"),
        (&fall, "always[0, 2](1/(1/x[1]) >= 0)"),
        (&fall, "always[0, 2](abs(0*(1/x[1])) >= 0)"),
        (&passes, "always[0, 2](sqrt(x[1])^2 >= -1)"),
        (&passes, "always[0, 2](0*sqrt(x[1]) >= 0)"),
        (&passes, "always[0, 2](sqrt(x[1])^0 >= 1)"),
    ] {
        let text = asked("n = 1", property, "1 < 0");
        let read = Question::read(&text, &|_| Ok(scenario.clone())).expect("a question");
        let holds = decide(&read, &Unwatched).is_ok_and(|answer| answer.verdict == Verdict::Holds);
        assert!(!holds, "{property}");
    }
    // Observables of the law too.
    let own = own("0", "1", "-1").replace("[state]", "[law.observables]\nh = \"1/(v[1]/x[1])\"\n[state]");
    for property in ["always[1, 1](h = 0)", "always[0, 2](h >= -1)"] {
        let read = Question::read(&asked("n = 1", property, "1 < 0"), &|_| Ok(own.clone())).expect("a question");
        assert!(!decide(&read, &Unwatched).is_ok_and(|answer| answer.verdict == Verdict::Holds), "{property}");
    }
}
