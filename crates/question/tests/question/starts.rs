//! What is attained at the start of every motion of a set, or at all times: for all starts of a box.

use super::motions::answered;
use question::Verdict;

fn velocities(potential: &str) -> String {
    format!(
        "model = \"velocity-alignment\"\n[graph]\nkind = \"complete\"\n[state]\npositions = [[0, 0], [2, 0], [1, 2]]\n\
         velocities = [[1, 0], [\"1/2\", \"1/2\"], [0, -1]]\n[law]\npotential = \"{potential}\"\n[run]\nuntil = 2\n"
    )
}

fn phases(gain: i64) -> String {
    format!("model = \"phase\"\n[state]\nphases = [0, 1, 2]\n[law]\nomega0 = 1\nK1 = {gain}\n[run]\nuntil = 2\n")
}

fn own(state: &str, rates: &str, observables: &str, start: &str) -> String {
    format!(
        "model = \"own\"\n[law]\nname = \"test\"\ndimension = 2\nstate = {{ {state} }}\n[law.rates]\n{rates}\n[law.observables]\n\
         {observables}\n[graph]\nkind = \"complete\"\n[state]\n{start}\n[run]\nuntil = 2\n"
    )
}

fn averaging() -> String {
    let spread = "spread = \"sum(i, (x[i] - mean(k, x[k]))^2)\"";
    own("x = \"number\"", "x = \"sum(j, x[j] - x)\"", spread, "x = [0, 1, 3]")
}

fn repelling() -> String {
    let rates = "x = \"v\"\nv = \"sum(j, (x - x[j])/norm2(x - x[j])^2)\"";
    let start = "x = [[0, 0], [1, 0], [0, 2]]\nv = [[0, 0], [0, 0], [0, 0]]";
    own("x = \"vector\", v = \"vector\"", rates, "", start)
}

fn aligning() -> String {
    let rates = "x = \"v\"\nv = \"sum(j, (v[j] - v)/(1 + norm2(x[j] - x)))\"";
    let start = "x = [[0, 0], [1, 0], [0, 2]]\nv = [[1, 0], [0, 1], [0, 0]]";
    let fluctuation = "fluctuation = \"sum(i, norm2(v[i] - mean(k, v[k])))\"";
    own("x = \"vector\", v = \"vector\"", rates, fluctuation, start)
}

const VELOCITY: &str = "\"state.velocities[1][1]\" = \"[9/10, 11/10]\"";
const PHASE: &str = "\"state.phases[1]\" = \"[-3/10, 3/10]\"";
const NUMBER: &str = "\"state.x[1]\" = \"[-1/2, 1/2]\"";
const PLACE: &str = "\"state.x[1][1]\" = \"[-1/10, 1/10]\"";

#[track_caller]
fn expect(scenario: &str, family: &str, property: &str, verdict: Verdict) {
    let answer = answered(scenario, family, &format!("always[0, 2]({property})"), "0 = 1");
    assert_eq!(answer.verdict, verdict, "{property}: {}", answer.why);
}

#[track_caller]
fn holds(scenario: &str, family: &str, property: &str) {
    expect(scenario, family, property, Verdict::Holds);
}

#[track_caller]
fn fails(scenario: &str, family: &str, property: &str) {
    expect(scenario, family, property, Verdict::False);
}

/// Each true one beside a false one that differs by a millionth.
#[test]
fn what_the_law_makes_monotone_is_attained_at_the_start() {
    let flock = velocities("none");
    holds(&flock, VELOCITY, "disagreement <= initial(disagreement)");
    fails(&flock, VELOCITY, "disagreement <= 999999/1000000*initial(disagreement)");
    fails(&flock, VELOCITY, "disagreement >= initial(disagreement)");
    holds(&averaging(), NUMBER, "spread <= initial(spread)");
    fails(&averaging(), NUMBER, "spread <= initial(spread) - 1/1000000");
    holds(&aligning(), "\"state.v[1][1]\" = \"[9/10, 11/10]\"", "fluctuation <= initial(fluctuation)");
    fails(&aligning(), "\"state.v[1][1]\" = \"[9/10, 11/10]\"", "fluctuation <= 999999/1000000*initial(fluctuation)");
}

#[test]
fn order_grows_or_falls_with_the_sign_of_the_gain() {
    holds(&phases(-1), PHASE, "order >= initial(order)");
    fails(&phases(-1), PHASE, "order <= initial(order)");
    holds(&phases(1), PHASE, "order <= initial(order)");
    fails(&phases(1), PHASE, "order >= initial(order)");
    holds(&phases(-1), PHASE, "phase_potential <= initial(phase_potential)");
}

/// The forces have potentials with logarithms, and alignment takes energy.
#[test]
fn energy_falls_and_momentum_stays() {
    let flock = velocities("inverse-square-log");
    holds(&flock, VELOCITY, "energy <= initial(energy)");
    fails(&flock, VELOCITY, "energy <= 999999/1000000*initial(energy)");
    fails(&flock, VELOCITY, "kinetic >= initial(kinetic)");
    holds(&flock, VELOCITY, "momentum(1) = initial(momentum(1)) and momentum(2) >= initial(momentum(2))");
    fails(&flock, VELOCITY, "momentum(1) = initial(momentum(1)) + 1/1000000");
}

/// At rest the rates are 0 at the start: the second derivative decides.
#[test]
fn second_derivatives_decide_where_first_ones_are_zero() {
    holds(&repelling(), PLACE, "min_distance >= initial(min_distance)");
    holds(&repelling(), PLACE, "min_distance >= 9/10");
    fails(&repelling(), PLACE, "min_distance >= 900001/1000000");
    fails(&repelling(), PLACE, "min_distance <= initial(min_distance)");
}

/// The least and the largest of three numbers stay so for these starts; the one between them goes up or down.
#[test]
fn numbers_of_ones_own() {
    holds(&averaging(), NUMBER, "x[1] >= initial(x[1])");
    holds(&averaging(), NUMBER, "x[1] >= -1/2");
    fails(&averaging(), NUMBER, "x[1] >= -499999/1000000");
    fails(&averaging(), NUMBER, "x[2] <= initial(x[2])");
    holds(&averaging(), NUMBER, "x[1] + x[2] + x[3] = initial(x[1]) + initial(x[2] + x[3])");
    fails(&averaging(), NUMBER, "x[1] + x[2] = initial(x[1] + x[2])");
}

/// What begins by falling may rise later: a rule that looks at the start alone would be wrong.
#[test]
fn the_start_alone_decides_nothing() {
    let swing = own("x = \"number\", v = \"number\"", "x = \"v\"\nv = \"-9*x\"", "", "x = [1]\nv = [-1]");
    let family = "\"state.v[1]\" = \"[-11/10, -9/10]\"";
    fails(&swing, family, "x[1] <= initial(x[1])");
    holds(&swing, family, "9*x[1]^2 + v[1]^2 = initial(9*x[1]^2 + v[1]^2)");
    holds(&swing, family, "sqrt(9*x[1]^2 + v[1]^2) <= initial(sqrt(9*x[1]^2 + v[1]^2))");
    fails(&swing, family, "abs(x[1]) <= abs(initial(x[1]))");
}

/// A rotation keeps the distance from the origin, of all starts of a box of two numbers.
#[test]
fn a_rotation_keeps_the_distance() {
    let turning = own("x = \"number\", y = \"number\"", "x = \"y\"\ny = \"-x\"", "", "x = [1]\ny = [0]");
    let family = "\"state.x[1]\" = \"[9/10, 11/10]\"\n\"state.y[1]\" = \"[-1/10, 1/10]\"";
    holds(&turning, family, "x[1]^2 + y[1]^2 = initial(x[1]^2 + y[1]^2)");
    fails(&turning, family, "x[1]^2 + y[1]^2 = initial(x[1]^2 + y[1]^2) + 1/1000000");
    fails(&turning, family, "x[1]^2 + 1000001/1000000*y[1]^2 = initial(x[1]^2 + 1000001/1000000*y[1]^2)");
    fails(&turning, family, "x[1] = initial(x[1])");
}

/// Links by distance: as long as none switches, roots and sums go by the links that there are. The third agent is out of reach.
#[test]
fn links_by_distance_that_do_not_switch() {
    let flock = "model = \"velocity-alignment\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\npositions = [[0, 0], [1, 0], [7, 0]]\n\
         velocities = [[0, 0], [\"1/4\", 0], [0, 1]]\n[law]\npotential = \"none\"\n[run]\nuntil = 1\n";
    let family = "\"state.velocities[1][1]\" = \"[-1/10, 1/10]\"";
    for (property, verdict) in [
        ("disagreement <= initial(disagreement)", Verdict::Holds),
        ("disagreement <= 999999/1000000*initial(disagreement)", Verdict::False),
        ("disagreement >= initial(disagreement)", Verdict::False),
        ("kinetic <= initial(kinetic)", Verdict::Holds),
        ("kinetic >= initial(kinetic)", Verdict::False),
    ] {
        let answer = answered(flock, family, &format!("always[0, 1]({property})"), "0 = 1");
        assert_eq!(answer.verdict, verdict, "{property}: {}", answer.why);
    }
}

/// The smallest cases: a box of width 0, a single agent, two agents in one place, all of them in one place.
#[test]
fn smallest_cases_of_rates() {
    let single = own("x = \"number\"", "x = \"-x\"", "", "x = [1]");
    let positive = "\"state.x[1]\" = \"[1/2, 1]\"";
    holds(&single, positive, "x[1] <= initial(x[1])");
    fails(&single, positive, "x[1] >= initial(x[1])");
    fails(&single, NUMBER, "x[1] <= initial(x[1])");
    holds(&single, NUMBER, "x[1]^2 <= initial(x[1]^2)");
    holds(&single, NUMBER, "sqrt(x[1]^2) <= initial(sqrt(x[1]^2))");
    for point in ["0", "1/2"] {
        let family = format!("\"state.x[1]\" = \"[{point}, {point}]\"");
        holds(&averaging(), &family, "spread <= initial(spread)");
        fails(&averaging(), &family, "spread <= initial(spread) - 1/1000000");
        holds(&averaging(), &family, "x[1] >= initial(x[1])");
        fails(&averaging(), &family, "x[1] <= initial(x[1])");
    }
    let meeting = |start: &str| own("x = \"vector\"", "x = \"sum(j, x[j] - x)\"", "", &format!("x = {start}"));
    let third = "\"state.x[3][1]\" = \"[1/2, 1]\"";
    let together = meeting("[[0, 0], [0, 0], [1, 1]]");
    holds(&together, third, "min_distance <= initial(min_distance)");
    fails(&together, third, "min_distance > initial(min_distance)");
    fails(&together, third, "min_distance >= initial(min_distance) + 1/1000000");
    let all = meeting("[[0, 0], [0, 0], [0, 0]]");
    let still = "\"state.x[3][1]\" = \"[0, 0]\"";
    fails(&all, still, "min_distance > initial(min_distance)");
}

/// Two agents start in one place: 0 is the smallest distance that there is, whatever the motion does. With other velocities they part at once.
#[test]
fn what_is_never_negative_is_not_below_nothing() {
    let fluctuation = "fluctuation = \"sum(i, norm2(v[i] - mean(k, v[k])))\"";
    let from = |velocities: &str| {
        let rates = "x = \"v\"\nv = \"sum(j, (v[j] - v)/(1 + norm2(x[j] - x)))\"";
        let start = format!("x = [[0, 0], [0, 0], [0, 2]]\nv = {velocities}");
        own("x = \"vector\", v = \"vector\"", rates, fluctuation, &start)
    };
    let third = "\"state.v[3][1]\" = \"[0, 1/10]\"";
    for velocities in ["[[1, 0], [1, 0], [0, 0]]", "[[1, 0], [0, 0], [0, 0]]"] {
        let flock = from(velocities);
        holds(&flock, third, "min_distance >= initial(min_distance)");
        holds(&flock, third, "min_distance >= -initial(min_distance)");
        holds(&flock, third, "fluctuation >= 0 and disagreement >= initial(min_distance)");
        fails(&flock, third, "min_distance >= initial(min_distance) + 1/1000000");
        fails(&flock, third, "min_distance > initial(min_distance)");
        fails(&flock, third, "min_distance < initial(min_distance)");
    }
    fails(&from("[[1, 0], [0, 0], [0, 0]]"), third, "min_distance <= initial(min_distance)");
    // One start.
    let flock = from("[[1, 0], [0, 0], [0, 0]]");
    holds(&flock, "n = 1", "min_distance >= initial(min_distance)");
    fails(&flock, "n = 1", "min_distance <= initial(min_distance)");
    // In an interval around the place of another one the first distance is not always 0.
    let beside = "\"state.x[1][1]\" = \"[0, 1/10]\"";
    fails(&from("[[-1, 0], [0, 0], [0, 0]]"), beside, "min_distance > 0");
}

/// Time itself is one more number: `x' = t` grows, `x' = t - 1/2` does not.
#[test]
fn laws_that_depend_on_time() {
    let law = |rate: &str| own("x = \"number\"", &format!("x = \"{rate}\""), "", "x = [0]");
    holds(&law("t"), NUMBER, "x[1] >= initial(x[1])");
    fails(&law("t - 1/2"), NUMBER, "x[1] >= initial(x[1])");
}

/// Steps of Runge and Kutta, written down again without the program.
fn followed(rate: &dyn Fn(&[f64]) -> Vec<f64>, start: Vec<f64>, visit: &mut dyn FnMut(&[f64])) {
    const STEPS: usize = 400;
    let h = 2.0 / STEPS as f64;
    let moved = |x: &[f64], k: &[f64], h: f64| -> Vec<f64> { x.iter().zip(k).map(|(x, k)| x + h * k).collect() };
    let mut x = start;
    for _ in 0..STEPS {
        visit(&x);
        let a = rate(&x);
        let b = rate(&moved(&x, &a, h / 2.0));
        let c = rate(&moved(&x, &b, h / 2.0));
        let d = rate(&moved(&x, &c, h));
        let k: Vec<f64> = (0..x.len()).map(|i| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) / 6.0).collect();
        x = moved(&x, &k, h);
    }
    visit(&x);
}

/// Numbers from -1 to 1 that look random.
fn spread(k: usize) -> f64 {
    (1.0 + 12.9898 * k as f64).sin()
}

/// What is said to hold of all starts of a box does so for single ones, in floats.
#[test]
fn single_starts_agree() {
    let differences = |x: &[f64]| -> Vec<f64> { x.iter().map(|own| x.iter().map(|other| other - own).sum()).collect() };
    let repelled = |s: &[f64]| -> Vec<f64> {
        let mut rates = s[6..].to_vec();
        for i in 0..3 {
            let mut force = [0.0; 2];
            for j in (0..3).filter(|j| *j != i) {
                let (dx, dy) = (s[2 * i] - s[2 * j], s[2 * i + 1] - s[2 * j + 1]);
                let square = dx * dx + dy * dy;
                force[0] += dx / (square * square);
                force[1] += dy / (square * square);
            }
            rates.extend(force);
        }
        rates
    };
    let least = |s: &[f64]| {
        let square = |i: usize, j: usize| (s[2 * i] - s[2 * j]).powi(2) + (s[2 * i + 1] - s[2 * j + 1]).powi(2);
        square(0, 1).min(square(0, 2)).min(square(1, 2)).sqrt()
    };
    let aligned = |theta: &[f64]| -> Vec<f64> {
        theta.iter().map(|own| 1.0 + theta.iter().map(|other| (other - own).sin()).sum::<f64>() / 3.0).collect()
    };
    let order = |theta: &[f64]| {
        let (x, y) = theta.iter().fold((0.0, 0.0), |(x, y), own: &f64| (x + own.cos(), y + own.sin()));
        f64::hypot(x, y) / 3.0
    };
    for k in 0..50 {
        let start = vec![0.5 * spread(k), 1.0, 3.0];
        let mean = start.iter().sum::<f64>() / 3.0;
        let scatter = |x: &[f64]| x.iter().map(|x| (x - mean).powi(2)).sum::<f64>();
        let (first, all) = (start[0], scatter(&start));
        followed(&differences, start, &mut |x| {
            assert!(scatter(x) <= all + 1e-9 && x[0] >= first - 1e-9 && x[0] >= -0.5 - 1e-9, "start {k}");
        });
        let start = [vec![0.1 * spread(k), 0.0, 1.0, 0.0, 0.0, 2.0], vec![0.0; 6]].concat();
        let apart = least(&start);
        assert!(apart >= 0.9 - 1e-12);
        followed(&repelled, start, &mut |s| assert!(least(s) >= apart - 1e-9, "start {k}"));
        let start = vec![0.3 * spread(k), 1.0, 2.0];
        let together = order(&start);
        followed(&aligned, start, &mut |theta| assert!(order(theta) >= together - 1e-9, "start {k}"));
    }
}
