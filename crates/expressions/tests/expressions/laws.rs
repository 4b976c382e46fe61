//! Laws of the literature beside formulas written by hand.

use arithmetic::random::{generator, uniform};
use arithmetic::{Dual, Field, FloatInterval, Rational, Ring, Series, rational};
use expressions::{Everyone, Hearing, Kind, Law, LawText, Parameter, Time};

/// Those whom each agent hears.
pub struct Lists(pub Vec<Vec<usize>>);

impl Hearing for Lists {
    fn agents(&self) -> usize {
        self.0.len()
    }

    fn heard(&self, agent: usize) -> Option<&[usize]> {
        Some(&self.0[agent])
    }
}

fn pairs(list: &[(&str, &str)]) -> Vec<(String, String)> {
    list.iter().map(|(a, b)| (a.to_string(), b.to_string())).collect()
}

pub fn second_order(define: &[(&str, &str)], rate: &str, observables: &[(&str, &str)]) -> LawText {
    LawText {
        time: Time::Continuous,
        dimension: 2,
        state: vec![("x".to_string(), Kind::Vector), ("v".to_string(), Kind::Vector)],
        position: Some("x".to_string()),
        parameters: vec![
            ("K".to_string(), Parameter::One(rational(3, 2))),
            ("beta".to_string(), Parameter::One(rational(1, 4))),
        ],
        define: pairs(define),
        rates: pairs(&[("x", "v"), ("v", rate)]),
        observables: pairs(observables),
        ..LawText::default()
    }
}

fn cucker_smale() -> LawText {
    second_order(
        &[("weight(i, j)", "K / (1 + norm2(x[j] - x[i]))^beta")],
        "mean(j, weight(i, j) * (v[j] - v))",
        &[("momentum", "sum(i, v[i])"), ("fluctuation", "sum(i, norm2(v[i] - mean_velocity)) / 2")],
    )
}

fn random_state(size: usize, replicate: u64) -> Vec<f64> {
    let mut random = generator("expressions", "state", replicate);
    (0..size).map(|_| 4.0 * uniform(&mut random) - 2.0).collect()
}

#[test]
fn cucker_and_smale_as_by_hand_on_every_network() {
    let n = 5;
    let mut text = cucker_smale();
    text.define.push(("mean_velocity".to_string(), "mean(k, v[k])".to_string()));
    let law = text.compile(n).unwrap();
    let everyone: Vec<Vec<usize>> = (0..n).map(|i| (0..n).filter(|j| *j != i).collect()).collect();
    let some = vec![vec![1, 4], vec![], vec![0], vec![0, 1, 2, 4], vec![3]];
    for (replicate, lists) in [(0, everyone), (1, some)] {
        let state = random_state(law.size(), replicate);
        let (x, v) = state.split_at(2 * n);
        let rates = law.rates(&0.0, &state, &Lists(lists.clone())).unwrap();
        assert_eq!(rates[..2 * n], *v);
        for (i, heard) in lists.iter().enumerate() {
            for c in 0..2 {
                let term = |&j: &usize| {
                    let square: f64 = (0..2).map(|k| (x[2 * j + k] - x[2 * i + k]).powi(2)).sum();
                    1.5 / (1.0 + square).powf(0.25) * (v[2 * j + c] - v[2 * i + c])
                };
                let wanted =
                    if heard.is_empty() { 0.0 } else { heard.iter().map(term).sum::<f64>() / heard.len() as f64 };
                assert!((rates[2 * n + 2 * i + c] - wanted).abs() < 1e-14, "{i}, {c}");
            }
        }
        let observed = law.observing(&0.0).flock(&0.0, &state, &Lists(lists)).unwrap();
        let total = |c: usize| (0..n).map(|i| v[2 * i + c]).sum::<f64>();
        let spread: f64 = (0..n)
            .flat_map(|i| (0..2).map(move |c| (i, c)))
            .map(|(i, c)| (v[2 * i + c] - total(c) / n as f64).powi(2))
            .sum();
        for (found, wanted) in observed.iter().zip([total(0), total(1), spread / 2.0]) {
            assert!((found - wanted).abs() < 1e-13);
        }
    }
}

/// A sum inside a sum, one that needs another one's result, and a definition that is asked for by two others.
#[test]
fn weights_that_are_normalised_agent_by_agent() {
    let define = [("near(i, j)", "1 / (1 + norm2(x[j] - x[i]))"), ("total(i)", "sum(k, near(i, k))")];
    let once = second_order(&define, "sum(j, near(i, j) * (v[j] - v)) / total", &[]);
    let inside = second_order(&define, "sum(j, near(i, j) / total(i) * (v[j] - v))", &[]);
    let n = 4;
    let state = random_state(4 * n, 3);
    let (x, v) = state.split_at(2 * n);
    let near = |i: usize, j: usize| 1.0 / (1.0 + (0..2).map(|c| (x[2 * j + c] - x[2 * i + c]).powi(2)).sum::<f64>());
    for law in [once, inside].map(|text| text.compile(n).unwrap()) {
        let rates = law.rates(&0.0, &state, &Everyone(n)).unwrap();
        for i in 0..n {
            let others: Vec<usize> = (0..n).filter(|j| *j != i).collect();
            let total: f64 = others.iter().map(|&j| near(i, j)).sum();
            for c in 0..2 {
                let sum: f64 = others.iter().map(|&j| near(i, j) * (v[2 * j + c] - v[2 * i + c])).sum();
                assert!((rates[2 * n + 2 * i + c] - sum / total).abs() < 1e-14);
            }
        }
    }
}

/// Those whom one hears in their turn hear others.
#[test]
fn a_sum_inside_a_sum_runs_over_those_whom_that_agent_hears() {
    let text = LawText {
        dimension: 1,
        state: vec![("x".to_string(), Kind::Number)],
        rates: pairs(&[("x", "sum(j, 100*x[j] + sum(k where k_is_large(k), x[k]))")]),
        define: pairs(&[("k_is_large(k)", "x[k] > 1")]),
        ..LawText::default()
    };
    let law = text.compile(4).unwrap();
    let lists = Lists(vec![vec![1, 2], vec![0, 3], vec![3], vec![]]);
    let rates = law.rates(&0.0, &[1.0, 2.0, 3.0, 4.0], &lists).unwrap();
    assert_eq!(rates, [500.0 + 4.0 + 4.0, 500.0 + 5.0, 400.0, 0.0]);
}

#[test]
fn angles_are_compared_and_averaged_on_the_circle() {
    let text = LawText {
        time: Time::Discrete,
        dimension: 2,
        state: vec![("r".to_string(), Kind::Vector), ("theta".to_string(), Kind::Angle)],
        position: Some("r".to_string()),
        rates: pairs(&[
            ("r", "r + turn(vector(1, 0), theta)"),
            ("theta", "mean(j where abs(theta[j] - theta) < 1, theta[j])"),
        ]),
        ..LawText::default()
    };
    let law = text.compile(3).unwrap();
    let state = [0.0, 0.0, 1.0, 0.0, 2.0, 0.0, 3.1, -3.1, 1.0];
    let next = law.rates(&0.0, &state, &Everyone(3)).unwrap();
    assert!((next[6] + 3.1).abs() < 1e-12 && (next[7] - 3.1).abs() < 1e-12);
    // Nobody is near: a mean over none is zero.
    assert_eq!(next[8], 0.0);
    assert!((next[0] - 3.1f64.cos()).abs() < 1e-15 && (next[1] - 3.1f64.sin()).abs() < 1e-15);
}

#[test]
fn rational_laws_are_exact_and_others_say_what_is_missing() {
    let text = LawText {
        time: Time::Discrete,
        dimension: 1,
        state: vec![("x".to_string(), Kind::Number)],
        rates: pairs(&[("x", "(x + sum(j where abs(x[j] - x) <= 1, x[j])) / (1 + count(j, abs(x[j] - x) <= 1))")]),
        ..LawText::default()
    };
    let law = text.compile(3).unwrap();
    assert!(law.is_rational());
    let state = [(0, 1), (1, 1), (5, 2)].map(|(p, q)| rational(p, q));
    let next = law.rates(&rational(0, 1), &state, &Everyone(3)).unwrap();
    assert_eq!(next, [(1, 2), (1, 2), (5, 2)].map(|(p, q)| rational(p, q)));
    let law = cucker_smale_of(3);
    assert!(!law.is_rational());
    let state: Vec<Rational> = (0..12).map(|k| rational(k, 1)).collect();
    let fault = law.rates(&rational(0, 1), &state, &Everyone(3)).unwrap_err();
    assert_eq!((fault.agent, law.name_of(&fault)), (Some(0), "v"));
    assert!(fault.to_string().contains("exact runs"));
    let power = LawText { time: Time::Continuous, rates: pairs(&[("x", "x^(1/3)")]), ..text };
    let fault = power.compile(3).unwrap().rates(&0.0, &[8.0, -8.0, 1.0], &Everyone(3)).unwrap_err();
    assert_eq!(
        fault.to_string(),
        "of agent 2: this needs a number above 0 where a power has an exponent that is not a whole number"
    );
}

fn cucker_smale_of(agents: usize) -> Law {
    let mut text = cucker_smale();
    text.define.push(("mean_velocity".to_string(), "mean(k, v[k])".to_string()));
    text.compile(agents).unwrap()
}

/// Enclosures contain what floats compute, series continue the motion, dual numbers differentiate along it.
#[test]
fn enclosures_series_and_duals_agree_with_floats() {
    let law = cucker_smale_of(3);
    let state = random_state(law.size(), 7);
    let rates = law.rates(&0.0, &state, &Everyone(3)).unwrap();
    let boxed: Vec<FloatInterval> = state.iter().map(|x| FloatInterval::point(*x)).collect();
    let enclosed = law.rates(&FloatInterval::point(0.0), &boxed, &Everyone(3)).unwrap();
    for (x, around) in rates.iter().zip(&enclosed) {
        assert!(around.width() < 1e-12 && around.lo() - 1e-13 <= *x && *x <= around.hi() + 1e-13);
    }
    // The change of the rates along the motion, by a dual number and by the second coefficient of a series.
    let moving: Vec<Dual<f64>> = state.iter().zip(&rates).map(|(x, d)| Dual::new(*x, *d)).collect();
    let along = law.rates(&Dual::constant(0.0), &moving, &Everyone(3)).unwrap();
    let series: Vec<Series<f64>> = state.iter().zip(&rates).map(|(x, d)| Series::from_coefficients(*x, [*d])).collect();
    let expanded = law.rates(&Series::constant(0.0, 2), &series, &Everyone(3)).unwrap();
    for (dual, series) in along.iter().zip(&expanded) {
        assert!((dual.derivative - series.coefficients()[1]).abs() < 1e-12);
    }
    let h = 1e-6;
    let shifted: Vec<f64> = state.iter().zip(&rates).map(|(x, d)| x + h * d).collect();
    let later = law.rates(&0.0, &shifted, &Everyone(3)).unwrap();
    for ((after, before), dual) in later.iter().zip(&rates).zip(&along) {
        assert!(((after - before) / h - dual.derivative).abs() < 1e-4);
    }
}

/// A branch that is not taken may have no value; one whose condition is open is not guessed.
#[test]
fn conditions_protect_what_they_guard_and_are_never_guessed() {
    let text = LawText {
        dimension: 1,
        state: vec![("x".to_string(), Kind::Number)],
        rates: pairs(&[("x", "if(x > 0, 1/x, 0) + sum(j where x[j] != x, 1/(x[j] - x))")]),
        ..LawText::default()
    };
    let law = text.compile(2).unwrap();
    assert_eq!(law.rates(&0.0, &[0.0, 0.0], &Everyone(2)).unwrap(), [0.0, 0.0]);
    assert_eq!(law.rates(&0.0, &[-1.0, 1.0], &Everyone(2)).unwrap(), [0.5, 0.5]);
    let around = FloatInterval::between(-1.0, 1.0);
    let apart = FloatInterval::point(2.0);
    assert!(law.rates(&apart, &[around, apart], &Everyone(2)).is_err());
    // At the edge of a condition a series may go either way.
    let edge = Series::from_coefficients(rational(0, 1).zero(), [rational(1, 1)]);
    assert!(edge.integer(0).rational(&rational(1, 2)).coefficients()[0] == rational(1, 2));
}

#[test]
fn parameters_of_each_agent_and_agents_by_number() {
    let text = LawText {
        dimension: 1,
        state: vec![("theta".to_string(), Kind::Angle)],
        parameters: vec![("omega".to_string(), Parameter::Each((1..=3).map(|k| rational(k, 2)).collect()))],
        rates: pairs(&[("theta", "omega + mean(j, omega[j]) + theta[1] + t")]),
        ..LawText::default()
    };
    let law = text.compile(3).unwrap();
    let rates = law.rates(&10.0, &[0.25, 7.0, 8.0], &Everyone(3)).unwrap();
    assert_eq!(rates, [0.5 + 1.25 + 10.25, 1.0 + 1.0 + 10.25, 1.5 + 0.75 + 10.25]);
}
