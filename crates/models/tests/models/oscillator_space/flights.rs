//! Runs of particles against circles and other closed forms; gaps, clusters, lists.

use arithmetic::random::generator;
use arithmetic::{ArithmeticError, Complex};
use models::oscillator::{Flight, ParticleLaw, State, sine_of_difference, write_rate};
use motion::{IndividualLaw, Moving};
use std::f64::consts::{PI, TAU};

fn flight(agents: &[(f64, f64, f64)]) -> Flight {
    Flight {
        positions: agents.iter().map(|a| Complex::new(a.0, a.1)).collect(),
        phases: agents.iter().map(|a| a.2).collect(),
    }
}

fn start() -> Flight {
    flight(&[(0.5, -1.0, 0.3), (2.0, 0.25, -4.0), (-1.5, 1.0, 7.0)])
}

fn distance(a: &Complex<f64>, b: &Complex<f64>) -> f64 {
    (a.re - b.re).hypot(a.im - b.im)
}

/// `r + (e^{i theta} - e^{i theta_0})/(iu) + drift t` and `theta = theta_0 + ut`; Simpson's rule, which the method is here, makes circles
/// too large by `(2 + cos h)/3 · h/sin h` with `h = u step/2`, a share of `(u step)^4/2880`.
#[test]
fn steady_turns_are_circles() {
    let rates = [0.8, -0.5, 1.1];
    let (step, steps) = (0.5, 6);
    let time = step * steps as f64;
    for drift in [Complex::new(0.0, 0.0), Complex::new(0.3, -0.2)] {
        let mut found = start();
        found.advance((step, steps), &drift, |_| Ok(rates.to_vec())).unwrap();
        for (k, u) in rates.into_iter().enumerate() {
            let (from, to) = (start().phases[k], start().phases[k] + u * time);
            assert!((found.phases[k] - to).abs() < 1e-13);
            let (x, y) = ((to.sin() - from.sin()) / u, (from.cos() - to.cos()) / u);
            let half: f64 = 0.5 * u * step;
            let larger = (2.0 + half.cos()) / 3.0 * half / half.sin();
            assert!(((larger - 1.0) / (u * step).powi(4) * 2880.0 - 1.0).abs() < 1e-2);
            let r = &start().positions[k];
            let circle =
                |share: f64| Complex::new(r.re + share * x + drift.re * time, r.im + share * y + drift.im * time);
            assert!(distance(&found.positions[k], &circle(larger)) < 1e-12, "{k}");
            assert!(distance(&found.positions[k], &circle(1.0)) > 1e-6);
        }
    }
}

/// In the centres the circles at the common rate are exact; under another steering both ways come to the same.
#[test]
fn centres_rest_where_all_turn_alike() {
    let omega = -0.7;
    let mut found = start();
    found.advance_by_centres(omega, (0.5, 9), |_| Ok(vec![omega; 3])).unwrap();
    for k in 0..3 {
        let (from, to) = (start().phases[k], start().phases[k] + 4.5 * omega);
        let r = &start().positions[k];
        let known = Complex::new(r.re + (to.sin() - from.sin()) / omega, r.im + (from.cos() - to.cos()) / omega);
        assert!(distance(&found.positions[k], &known) < 1e-13 && (found.phases[k] - to).abs() < 1e-13, "{k}");
    }
    // Steering that reads positions and phasors.
    let steering = |state: &State<f64>| -> Result<Vec<f64>, ArithmeticError> {
        let of = |(r, z): (&Complex<f64>, &Complex<f64>)| omega + 0.3 * r.im * z.re - 0.2 * r.re * r.re * z.im;
        Ok(state.positions.iter().zip(&state.phasors).map(of).collect())
    };
    let (mut one, mut other) = (start(), start());
    one.advance((0.001, 2000), &Complex::new(0.0, 0.0), steering).unwrap();
    other.advance_by_centres(omega, (0.001, 2000), steering).unwrap();
    for k in 0..3 {
        assert!(distance(&one.positions[k], &other.positions[k]) < 1e-9, "{k}");
        assert!((one.phases[k] - other.phases[k]).abs() < 1e-9);
    }
    // Halving the step divides the error by 16.
    let error = |step: f64, by_centres: bool| {
        let mut coarse = start();
        let steps = (step, (2.0 / step).round() as usize);
        let result = match by_centres {
            true => coarse.advance_by_centres(omega, steps, steering),
            false => coarse.advance(steps, &Complex::new(0.0, 0.0), steering),
        };
        result.unwrap();
        coarse.positions.iter().zip(&one.positions).map(|(a, b)| distance(a, b)).fold(0.0, f64::max)
    };
    for by_centres in [true, false] {
        let order = (error(0.04, by_centres) / error(0.02, by_centres)).log2();
        assert!((3.6..4.4).contains(&order), "{order}");
    }
    assert_eq!(start().advance_by_centres(0.0, (0.1, 1), steering), Err(ArithmeticError::DivisionByZero));
}

/// What the steering returns at first stops the run, which has not moved then.
#[test]
fn steering_that_fails_stops_the_run() {
    let fails = |_: &State<f64>| Err(ArithmeticError::Domain("a steering"));
    let (mut one, mut other) = (start(), start());
    assert_eq!(one.advance((0.1, 3), &Complex::new(0.0, 0.0), fails), Err(ArithmeticError::Domain("a steering")));
    assert_eq!(other.advance_by_centres(1.0, (0.1, 3), fails), Err(ArithmeticError::Domain("a steering")));
    assert_eq!((&one, &other), (&start(), &start()));
    let mut rate = [9.0; 9];
    write_rate(&start().state(), &Complex::new(0.5, -0.5), &[1.0, 2.0, 3.0], &mut rate);
    for k in 0..3 {
        let angle = start().phases[k];
        assert_eq!(rate[2 * k..2 * k + 2], [angle.cos() + 0.5, angle.sin() - 0.5]);
    }
    assert_eq!(rate[6..], [1.0, 2.0, 3.0]);
    assert_eq!(start().to_list(), [0.5, -1.0, 2.0, 0.25, -1.5, 1.0, 0.3, -4.0, 7.0]);
    assert_eq!(Flight::from_list(&start().to_list()), start());
}

#[test]
fn gaps_and_clusters_go_around_the_circle() {
    let close = |found: &[f64], known: &[f64]| {
        assert!(found.len() == known.len() && found.iter().zip(known).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
    };
    let of = |phases: &[f64]| Flight { positions: Vec::new(), phases: phases.to_vec() };
    // In order: 1/4, 1, 3, 6; 1 is given a turn later, 6 a turn before.
    let four = of(&[3.0, 1.0 + TAU, 6.0 - TAU, 0.25]);
    close(&four.gaps(), &[0.75, 2.0, 3.0, 0.25 + TAU - 6.0]);
    assert!(of(&[]).gaps().is_empty());
    close(&of(&[2.0]).gaps(), &[TAU]);
    let clusters = |phases: &[f64], tolerance: f64| -> Vec<(usize, f64)> { of(phases).clusters(tolerance) };
    let sizes = |list: &[(usize, f64)]| list.iter().map(|c| c.0).collect::<Vec<_>>();
    // 6 and 1/4 are together around 0; the first cluster ends at 1/4 or at 1.
    let found = clusters(&four.phases, 0.6);
    assert_eq!(sizes(&found), [2, 1, 1]);
    close(&found.iter().map(|c| c.1).collect::<Vec<_>>(), &[0.75, 2.0, 3.0]);
    assert_eq!(sizes(&clusters(&four.phases, 0.8)), [3, 1]);
    assert_eq!(sizes(&clusters(&four.phases, 0.1)), [1, 1, 1, 1]);
    // A gap as wide as the tolerance parts.
    assert_eq!(sizes(&clusters(&[0.0, 0.5, 1.0, 1.25], 0.5)), [1, 1, 2]);
    assert_eq!(clusters(&[0.1, 0.2], TAU + 1.0), [(2, 0.0)]);
    assert_eq!(clusters(&[], 1.0), [(0, 0.0)]);
}

#[test]
fn random_flights_fill_their_square() {
    let drawn = Flight::random(&mut generator("test", "flights", 0), 4000, 3.0);
    assert_eq!((drawn.positions.len(), drawn.phases.len()), (4000, 4000));
    let all = || drawn.positions.iter().flat_map(|r| [r.re, r.im]);
    let (low, high) = (all().fold(9.0, f64::min), all().fold(-9.0, f64::max));
    assert!((-3.0..-2.99).contains(&low) && (2.99..=3.0).contains(&high), "{low} {high}");
    let mean = all().sum::<f64>() / 8000.0;
    assert!(mean.abs() < 0.1);
    let phases = |f: fn(f64, f64) -> f64, from: f64| drawn.phases.iter().copied().fold(from, f);
    assert!((0.0..0.01).contains(&phases(f64::min, 9.0)) && (TAU - 0.01..=TAU).contains(&phases(f64::max, 0.0)));
    assert!((drawn.phases.iter().sum::<f64>() / 4000.0 - PI).abs() < 0.1);
}

/// The influence of one particle on another: sines of differences, and how far the centre is ahead, with any gain of the spacing; without one the
/// frequency may be 0.
#[test]
fn influences_of_pairs_are_their_formulas() {
    let angles = [0.4f64, 1.9];
    let at = [[0.5, -1.0], [2.0, 0.25]];
    let drift = Complex::new(0.25, -0.125);
    let agent = |k: usize| {
        let (sin, cos) = angles[k].sin_cos();
        Moving { position: at[k], velocity: [cos + drift.re, sin + drift.im], further: [angles[k]] }
    };
    for (frequency, spacing) in [(0.5, 1.0), (0.5, 0.3), (-2.0, 0.0), (0.0, 0.0)] {
        let law = ParticleLaw { frequency, orientation: 0.7, spacing, beacon: None, drift: drift.clone() };
        let [found] = law.pair(&agent(0), &agent(1), |x| x).unwrap();
        let mut turn = 0.7 * law_of_sines(angles[0], angles[1]);
        if spacing != 0.0 {
            let centre = |k: usize| [at[k][0] - angles[k].sin() / frequency, at[k][1] + angles[k].cos() / frequency];
            let (own, other) = (centre(0), centre(1));
            turn += spacing * (angles[0].cos() * (own[0] - other[0]) + angles[0].sin() * (own[1] - other[1]));
        }
        assert!((found - turn).abs() < 1e-14, "{frequency} {spacing}: {found} {turn}");
    }
}

/// `sin` of the difference in the order of the law, from [`sine_of_difference`].
fn law_of_sines(own: f64, other: f64) -> f64 {
    let phasor = |theta: f64| Complex::new(theta.cos(), theta.sin());
    sine_of_difference(&phasor(own), &phasor(other))
}
