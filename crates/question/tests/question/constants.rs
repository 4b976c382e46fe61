//! Numbers of a law that are intervals: answers for all of them at once.

use super::motions::{answered, asked, platoon};
use super::refusal_with;
use arithmetic::Unwatched;
use arithmetic::random::{generator, uniform};
use question::{Question, Verdict};

#[track_caller]
fn expect(scenario: &str, family: &str, property: &str, verdict: Verdict) {
    let answer = answered(scenario, family, property, "0 = 1");
    assert_eq!(answer.verdict, verdict, "{property}: {}", answer.why);
}

/// `quantity` is at most `most` during these times, and no bound that is smaller by a millionth is one.
#[track_caller]
fn largest(scenario: &str, family: &str, times: &str, quantity: &str, most: f64) {
    let bound = |shift: f64| format!("always[{times}]({quantity} <= {:.0}/10^7)", 1e7 * most + shift);
    expect(scenario, family, &bound(5.0), Verdict::Holds);
    expect(scenario, family, &bound(-5.0), Verdict::False);
}

fn own(parameters: &str, rates: &str, observables: &str, start: &str) -> String {
    format!(
        "model = \"own\"\n[law]\ndimension = 1\nstate = {{ x = \"number\" }}\nparameters = {{ {parameters} }}\n[law.rates]\nx = \"{rates}\"\n\
         [law.observables]\n{observables}\n[state]\nx = [{start}]\n[run]\nuntil = 2\n"
    )
}

/// `x' = -K x` from 1: `exp(-K t)`, and what is measured of it with `K`.
#[test]
fn a_parameter_of_ones_own_may_be_an_interval() {
    let observables = "force = \"K*x[1]\"\npace = \"-rate(K*x[1])\"";
    let decay = own("K = 1", "-K*x", observables, "1");
    let family = "\"law.parameters.K\" = \"[1, 2]\"";
    largest(&decay, family, "1, 1", "x[1]", (-1f64).exp());
    largest(&decay, family, "1, 2", "1 - x[1]", 1.0 - (-4f64).exp());
    largest(&decay, family, "0, 1", "force", 2.0);
    largest(&decay, family, "0, 1", "pace", 4.0);
    expect(&decay, family, "always[0, 2](x[1] <= initial(x[1]))", Verdict::Holds);
    expect(&decay, family, "always[0, 2](x[1] >= initial(x[1]))", Verdict::False);
    // With a start that is one as well.
    let both = format!("{family}\n\"state.x[1]\" = \"[1/2, 1]\"");
    largest(&decay, &both, "1, 1", "x[1]", (-1f64).exp());
    largest(&decay, &both, "1, 1", "-x[1]", -0.5 * (-2f64).exp());
}

/// Of a list one number may be an interval, and others stay what they are; two lists of equal numbers stay two.
#[test]
fn of_a_list_each_number_is_its_own() {
    let observables = "total = \"x[1] + x[2]\"\nfirst = \"w[1]\"\nequal = \"u[2]\"";
    let drift = own("w = [1, 2], u = [1, 2]", "w + mean(j, sin(x[j] - x))", observables, "0, 0");
    let family = "\"law.parameters.w[2]\" = \"[19/10, 21/10]\"";
    largest(&drift, family, "2, 2", "total", 6.2);
    largest(&drift, family, "0, 2", "first", 1.0);
    largest(&drift, family, "0, 2", "equal", 2.0);
}

/// Exponents are numbers as others are.
#[test]
fn exponents_may_be_intervals() {
    let power = own("beta = 1", "-1/(1 + x)^beta", "", "1");
    // At beta = 1: (1 + x)^2 = 4 - 2 t; at beta = 2: (1 + x)^3 = 8 - 3 t.
    let family = "\"law.parameters.beta\" = \"[1, 2]\"";
    largest(&power, family, "1, 1", "x[1]", 5f64.cbrt() - 1.0);
    largest(&power, family, "1, 1", "-x[1]", 1.0 - 2f64.sqrt());
}

fn phases(gain: i64) -> String {
    format!("model = \"phase\"\n[state]\nphases = [0, 1]\n[law]\nomega0 = 1\nK1 = {gain}\n[run]\nuntil = 2\n")
}

/// Two phases: the difference d has `d' = K1 sin d`, so `tan(d/2)` is that of the start times `exp(K1 t)`, and the order is `cos(d/2)`.
#[test]
fn the_gain_of_phases_may_be_an_interval() {
    let family = "\"law.K1\" = \"[-3/2, -1]\"\n\"law.omega0\" = \"[9/10, 11/10]\"";
    let order = |gain: f64| 1.0 / (1.0 + (0.5f64.tan() * gain.exp()).powi(2)).sqrt();
    largest(&phases(-1), family, "0, 1", "order", order(-1.5));
    largest(&phases(-1), family, "1, 1", "-order", -order(-1.0));
    // -K1 (1 - cos 1)/2 at the start: with the gain itself, not with that of the middle.
    largest(&phases(-1), family, "0, 1", "orientation_potential", 0.75 * (1.0 - 1f64.cos()));
    expect(&phases(-1), family, "always[0, 2](order >= initial(order))", Verdict::Holds);
    // Where the sign of the gain is open, so is the way that the order goes.
    expect(&phases(-1), "\"law.K1\" = \"[-1, 1]\"", "always[0, 2](order >= initial(order))", Verdict::False);
}

fn particles(spacing: &str) -> String {
    format!(
        "model = \"particles\"\n[state]\npositions = [[0, 0], [1, 0]]\nphases = [0, 1]\n[law]\nomega0 = 1\nK1 = -1\n{spacing}\n[run]\nuntil = 1\n"
    )
}

/// What is measured with the frequency and the gains is measured with those of the box.
#[test]
fn particles_have_their_own_numbers() {
    let spread = |w: f64| f64::hypot(1.0 - 1f64.sin() / w, (1.0 - 1f64.cos()) / w) / 2.0;
    let family = "\"law.omega0\" = \"[1, 2]\"";
    largest(&particles(""), family, "0, 0", "centre_spread", spread(2.0));
    // S = |c_1 - c_2|²/4, and K0 S + orientation: K1 = -1 and omega0 = 1.
    let (share, order) = (spread(1.0).powi(2), (1.0 - 1f64.cos()) / 2.0);
    largest(&particles("K0 = 1"), "\"law.K0\" = \"[1, 3]\"", "0, 0", "composite_potential", 3.0 * share + order);
    // The middle of this one is 0, where there is no spacing control.
    largest(&particles("K0 = 1"), "\"law.K0\" = \"[-3, 3]\"", "0, 0", "composite_potential", 3.0 * share + order);
}

/// Two followers of a car that stands still; the first gap is 2 and the swing of the leader at the start, whatever the spacing, and the deviations are `k (spacing - 2)`.
#[test]
fn platoons_have_their_own_numbers() {
    let cars = platoon(2);
    let family = "\"law.spacing\" = \"[1, 3]\"\n\"law.leader.amplitude\" = \"[0, 1/4]\"";
    largest(&cars, family, "0, 0", "max_gap", 2.25);
    largest(&cars, family, "0, 0", "-max_gap", -2.0);
    // The second follower is 2 off, and the leader a quarter on the other side.
    largest(&cars, family, "0, 0", "largest_deviation", 2.25);
}

#[test]
fn what_is_a_single_number_says_so() {
    let velocities = "model = \"velocity-alignment\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\npositions = [[0, 0], [1, 0]]\n\
                      velocities = [[0, 0], [1, 0]]\n[law]\npotential = \"inverse-square-log\"\nminimum = 1\n[run]\nuntil = 1\n";
    for (scenario, name, words) in [
        (velocities.to_string(), "graph.radius", "`graph.radius`: a radius is a single number"),
        (velocities.to_string(), "law.minimum", "`law.minimum` is a single number in this model; intervals are for"),
        (velocities.to_string(), "run.until", "`run.until` is a single number"),
        (own("K = 1", "-K*x", "", "1"), "run.until", "intervals are for numbers of [state], and of [law] for"),
        (phases(-1), "law.K1", ""),
    ] {
        let text = asked(&format!("\"{name}\" = \"[1, 2]\""), "always[0, 1](components > 0)", "1 < 0");
        let files = |_: &str| Ok(scenario.clone());
        let found = Question::read(&text, &files).map_err(|error| error.to_string());
        let told = found.and_then(|q| question::decide(&q, &Unwatched).map(|_| ()).map_err(|error| error.to_string()));
        match words {
            "" => assert_eq!(told, Ok(())),
            _ => assert!(told.clone().is_err_and(|told| told.contains(words)), "{name}: {told:?}"),
        }
    }
    // A file may not say so at an end of the interval.
    let message =
        refusal_with(&asked("\"law.spacing\" = \"[-1, 3]\"", "always[0, 1](min_gap > 0)", "1 < 0"), &platoon(2));
    assert!(message.contains("spacing"), "{message}");
}

/// What a quantity is over time: short times with ends.
fn curve(scenario: &str, family: &str, quantity: &str) -> Vec<[f64; 4]> {
    let files = |_: &str| Ok(scenario.to_string());
    let text = asked(family, &format!("always[0, 2]({quantity} > -1000)"), "1 < 0");
    let question = Question::read(&text, &files).expect("a question");
    question.tubes(None, &Unwatched).expect("tubes").tubes.remove(0).sections
}

/// Single numbers of the box, each followed alone by its own scenario, lie in what is enclosed for all of them.
#[test]
fn single_numbers_lie_in_the_tube() {
    let kuramoto =
        own("K = 1, w = [-1, 0, 1]", "w + K*mean(j, sin(x[j] - x))", "apart = \"K*(x[3] - x[1])\"", "0, 0, 0");
    let steered = particles("K0 = \"1/2\"").replace("until = 1", "until = 2");
    let cars = platoon(3);
    let cases = [
        (kuramoto, "apart", &[("parameters.K", 0.5, 1.5), ("parameters.w[3]", 0.8, 1.2)][..]),
        (phases(1), "order", &[("omega0", 0.9, 1.1), ("K1", 0.8, 1.0)][..]),
        (steered.clone(), "centre_spread", &[("omega0", 0.9, 1.1), ("K0", 0.4, 0.6), ("K1", -1.1, -0.9)][..]),
        (steered.clone(), "composite_potential", &[("omega0", 0.9, 1.1), ("K0", 0.4, 0.6), ("K1", -1.1, -0.9)][..]),
        (
            steered.replace("omega0 = 1", "omega0 = 1\ndrift = [1, 0]\nbeacon = [0, 0]"),
            "composite_potential",
            &[("drift[1]", 0.5, 1.0), ("beacon[2]", -0.2, 0.2)][..],
        ),
        (cars.clone(), "min_gap", &[("f", -1.2, -0.8), ("g", -1.2, -0.8), ("leader.frequency", 0.3, 0.5)][..]),
        (cars.clone(), "last_deviation", &[("spacing", 1.8, 2.2), ("leader.amplitude", 0.2, 0.3)][..]),
        (cars.replace("f = -1", "f = [-1, -1, -1]"), "largest_deviation", &[("f[2]", -1.5, -0.5)][..]),
    ];
    let mut random = generator("question", "constants", 0);
    for (scenario, quantity, numbers) in cases {
        let all = |of: &mut dyn FnMut(f64, f64) -> String| {
            let line = |(name, lo, hi): &(&str, f64, f64)| format!("\"law.{name}\" = \"{}\"", of(*lo, *hi));
            numbers.iter().map(line).collect::<Vec<_>>().join("\n")
        };
        let tube = curve(&scenario, &all(&mut |lo, hi| format!("[{lo}, {hi}]")), quantity);
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        for _ in 0..6 {
            let single = all(&mut |lo, hi| format!("{:.6}", lo + (hi - lo) * uniform(&mut random)));
            let sections = curve(&scenario, &single, quantity);
            for [from, to, lo, hi] in &sections {
                let near = tube.iter().filter(|other| other[0] <= *to && *from <= other[1]);
                let (a, b) =
                    near.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), other| (a.min(other[2]), b.max(other[3])));
                let (middle, half) = (f64::midpoint(*lo, *hi), (hi - lo) / 2.0 + 1e-9);
                assert!(
                    a <= middle + half && middle - half <= b,
                    "{quantity}, {single}: [{lo}, {hi}] at {from} and [{a}, {b}]"
                );
            }
            let last = sections.last().expect("a section");
            (least, most) = (least.min(last[2]), most.max(last[3]));
        }
        let last = tube.last().expect("a section");
        assert!(last[3] - last[2] < 8.0 * (most - least) + 1e-6, "{quantity}: {last:?} for [{least}, {most}]");
    }
}
