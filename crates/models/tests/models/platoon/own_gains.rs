//! Gains for each car, and margins.

use algebra::spectrum::Polynomial;
use arithmetic::{ArithmeticError, Complex, Rational, rational};
use models::platoon::banded::BandedPlatoon;
use models::platoon::gain_margin::{GainMargin, gain_margin};
use models::platoon::growth::peak_of_car;
use models::platoon::margins::{margins, phase_margin_of_cars};
use models::platoon::state_space::StateSpace;
use models::platoon::vector_form::{motion_matrix, motion_rows_of_cars};
use models::platoon::{
    Communication, CommunicationGraph, Gains, gain_squared_one_sided, resonance, strongest_one_sided_square,
};

fn gains(f: f64, g: f64) -> Gains<f64> {
    Gains { f, g }
}

#[test]
fn equal_gains_give_the_certified_resonance() {
    let exact = Gains { f: rational(-1, 2), g: rational(-3, 1) };
    for m in [1usize, 2, 5, 16, 64] {
        let graph = CommunicationGraph::of(Communication::FrontAndBack, m).unwrap();
        let certified = resonance(&exact, m as u64, 12).unwrap();
        let found = peak_of_car(&graph, &vec![gains(-0.5, -3.0); m], m).unwrap().unwrap();
        assert!((found.value / certified.amplitude.to_f64() - 1.0).abs() < 1e-9, "{m}");
        assert!((found.at / certified.omega.to_f64() - 1.0).abs() < 1e-4, "{m}");
    }
    let graph = CommunicationGraph::of(Communication::Front, 3).unwrap();
    assert!(peak_of_car(&graph, &[gains(-1.0, -1.0)], 1).is_err());
    assert!(peak_of_car(&graph, &vec![gains(-1.0, -1.0); 3], 4).is_err());
    assert!(peak_of_car(&graph, &vec![gains(-1.0, -1.0); 3], 0).is_err());
}

/// The last of many cars that all swing more than the one in front: squares of the amplitudes, or of the pivots, are beyond the floats, and
/// at last the amplitude is.
#[test]
fn long_one_sided_platoons_have_a_peak_as_long_as_floats_reach() {
    let one = gains(-1.0, -1.0);
    let gain = gain_squared_one_sided(&one, &strongest_one_sided_square(&one).unwrap()).unwrap().sqrt();
    let peak = |m: usize| {
        let graph = CommunicationGraph::of(Communication::Front, m).unwrap();
        peak_of_car(&graph, &vec![one.clone(); m], m)
    };
    for m in [900, 1000, 1800] {
        let found = peak(m).unwrap().unwrap();
        assert!((found.value / gain.powi(m as i32) - 1.0).abs() < 1e-6, "{m}: {}", found.value);
    }
    // 1.47^2000 is more than the largest float.
    assert!(matches!(peak(2000), Err(ArithmeticError::Domain(_))));
}

/// The response of bands, of dense elimination, and the equations of motion themselves.
#[test]
fn responses_of_cars_solve_the_equations_of_motion() {
    let graph = CommunicationGraph::in_series(&[3, 4]).unwrap();
    let own: Vec<Gains<f64>> = (1..=7).map(|k| gains(-0.5 * k as f64, -2.0 / k as f64)).collect();
    for w in [0.1, 0.7, 2.0] {
        let dense = graph.response_of_cars(&own, &w).unwrap();
        let banded = BandedPlatoon::new(&graph).response_of_cars(&own, w).unwrap();
        for k in 1..=7 {
            assert!((dense[k - 1].clone() - banded[k - 1].clone()).norm_squared() < 1e-20);
            let mean = graph.tracked_by(k).iter().fold(Complex::real(0.0), |sum, (agent, weight)| {
                let value = if *agent == 0 { Complex::real(1.0) } else { dense[agent - 1].clone() };
                sum + value.scale(&num_traits::ToPrimitive::to_f64(weight).unwrap())
            });
            let (deviation, own) = (dense[k - 1].clone() - mean, &own[k - 1]);
            // y'' = f e + g e'.
            let force = Complex::new(own.f, own.g * w) * &deviation;
            assert!((force + dense[k - 1].scale(&(w * w))).norm_squared() < 1e-20, "{k}");
        }
    }
}

#[test]
fn rows_of_cars_with_equal_gains_are_those_of_the_paper() {
    let graph = CommunicationGraph::of(Communication::FrontAndBack, 4).unwrap();
    let reduced = graph.reduced_laplacian().unwrap();
    let equal: Gains<Rational> = Gains { f: rational(-1, 3), g: rational(-2, 1) };
    let rows = motion_rows_of_cars(&reduced, |_| &equal);
    assert_eq!(rows, motion_matrix(&reduced, &equal).unwrap().to_rows());
}

/// For one car the loop is (|f| + i w |g|)/w², and the margin is known; complex modes lose stability at the factor that is told.
#[test]
fn margins_are_where_stability_ends() {
    let one = margins(&gains(-1.0, -1.0), &[Complex::real(1.0)]).unwrap();
    let crossing = ((1.0 + 5f64.sqrt()) / 2.0).sqrt();
    assert!((one.phase.unwrap() - crossing.atan()).abs() < 1e-12 && one.critical_factor.is_none());
    assert!(margins(&gains(-1.0, -1.0), &[]).is_none());
    // Three cars that track each other in a circle, the first of them also the leader: complex eigenvalues of P.
    let graph = CommunicationGraph::new(vec![
        vec![(0, rational(1, 10)), (3, rational(9, 10))],
        vec![(1, rational(1, 1))],
        vec![(2, rational(1, 1))],
    ])
    .unwrap();
    let reduced = graph.reduced_laplacian().unwrap();
    // (1 - p)³ = 9/10.
    let root = 0.9f64.cbrt();
    let eigenvalues: Vec<Complex<f64>> = (0..3)
        .map(|k| 2.0 * std::f64::consts::PI * f64::from(k) / 3.0)
        .map(|angle| Complex::new(1.0 - root * angle.cos(), -root * angle.sin()))
        .collect();
    let known = margins(&gains(-5.0, -1.0), &eigenvalues).unwrap();
    let factor = known.critical_factor.unwrap();
    // The exact way finds the same, from a stable start.
    let own = vec![Gains { f: rational(-50, 1), g: rational(-10, 1) }; 3];
    let strong = margins(&gains(-50.0, -10.0), &eigenvalues).unwrap();
    let found = phase_margin_of_cars(&reduced, &own).unwrap().unwrap();
    assert!((found - strong.phase.unwrap()).abs() < 1e-6, "{found:?} {strong:?}");
    match gain_margin(&reduced, &own).unwrap() {
        GainMargin::Ends { below: Some(below), above: None } => {
            assert!((10.0 * below.to_f64() / factor - 1.0).abs() < 1e-12, "{below} {factor}");
        }
        other => panic!("{other:?}"),
    }
    let stable = |factor: f64| {
        let factor = Rational::from_float(factor).unwrap();
        let scaled = Gains { f: rational(-5, 1) * &factor, g: rational(-1, 1) * factor };
        let motion = motion_matrix(&reduced, &scaled).unwrap();
        Polynomial::from_rationals(&motion.characteristic_polynomial().unwrap().coefficients()).is_hurwitz()
    };
    assert!(stable(factor * 1.0001) && !stable(factor * 0.9999), "{factor}");
}

/// The margins by their definition: the least `|arg L|` where `|L| = 1`, of each eigenvalue and its conjugate, by bisection; and the factor
/// at which the roots of `s² = k lambda (f + g s)` cross the imaginary axis.
#[test]
fn margins_are_those_of_the_loops() {
    let conjugates = |(re, im): (f64, f64)| [Complex::new(re, im), Complex::new(re, -im)];
    let both = |list: &[(f64, f64)]| list.iter().copied().flat_map(conjugates).collect::<Vec<_>>();
    for own in [gains(-2.0, -3.0), gains(-5.0, -0.7)] {
        let loop_at = |lambda: &Complex<f64>, w: f64| Complex::new(-own.f, -own.g * w).scale(&(1.0 / (w * w))) * lambda;
        let phase = |lambda: &Complex<f64>| {
            let (mut low, mut high) = (1e-6f64, 1e6f64);
            for _ in 0..200 {
                let middle = (low * high).sqrt();
                let above = loop_at(lambda, middle).norm_squared() > 1.0;
                (low, high) = if above { (middle, high) } else { (low, middle) };
            }
            let there = loop_at(lambda, low);
            there.im.atan2(there.re).abs()
        };
        // The real parts of the roots.
        let growth = |lambda: &Complex<f64>, k: f64| {
            let half = lambda.scale(&(0.5 * k * own.g));
            let square = half.clone() * &half + lambda.scale(&(k * own.f));
            let root = square.norm_squared().sqrt();
            half.re + (0.5 * (root + square.re)).max(0.0).sqrt()
        };
        for list in [&[(1.0, 0.0)][..], &[(0.5, 0.8)], &[(1.5, 0.3), (0.5, 0.8), (0.7, 0.2)], &[(1.5, 0.3), (2.0, 0.0)]]
        {
            let all = both(list);
            let found = margins(&own, &all).unwrap();
            let least = all.iter().map(phase).fold(9.0, f64::min);
            assert!((found.phase.unwrap() - least).abs() < 1e-9, "{list:?}");
            let grows = |k: f64| all.iter().any(|lambda| growth(lambda, k) > 1e-15);
            match found.critical_factor {
                Some(k) => assert!(grows(k * (1.0 - 1e-6)) && !grows(k * (1.0 + 1e-6)), "{list:?}"),
                None => assert!(list.iter().all(|(_, im)| *im == 0.0)),
            }
            // One of each pair is enough, whichever it is, and 0 tells nothing.
            for one in [0, 1] {
                let half: Vec<_> = list.iter().map(|lambda| conjugates(*lambda)[one].clone()).collect();
                assert_eq!(margins(&own, &half), Some(found));
                assert_eq!(margins(&own, &[half, vec![Complex::real(0.0)]].concat()), Some(found));
            }
        }
        for left in [(0.0, 1.0), (-0.3, 0.9), (-0.3, -0.9)] {
            let found = margins(&own, &[Complex::new(left.0, left.1)]).unwrap();
            assert!(found.critical_factor.is_none() && found.phase.is_some());
        }
        assert_eq!(margins(&own, &[Complex::real(0.0)]), None);
    }
}

/// Rings of cars, the first of which tracks the leader, too, with equal gains: the exact way for up to 12, the enclosed modes beyond. The modes are
/// `1 - r e^(2 pi i k/n)` with `r^n = 1/2`.
#[test]
fn gain_margins_of_rings_are_those_of_their_modes() {
    for n in [3usize, 7, 12, 13, 20] {
        let half = || rational(1, 2);
        let rows = (1..=n).map(|k| if k == 1 { vec![(0, half()), (n, half())] } else { vec![(k - 1, rational(1, 1))] });
        let reduced = CommunicationGraph::new(rows.collect()).unwrap().reduced_laplacian().unwrap();
        let own = vec![Gains { f: rational(-2, 1), g: rational(-60, 1) }; n];
        let r = 0.5f64.powf(1.0 / n as f64);
        let mode = |k: usize| 2.0 * std::f64::consts::PI * k as f64 / n as f64;
        let modes: Vec<_> = (0..n).map(mode).map(|a| Complex::new(1.0 - r * a.cos(), -r * a.sin())).collect();
        // What is real is not met by rounding.
        let modes: Vec<_> = modes.into_iter().filter(|lambda| lambda.im.abs() > 1e-9).collect();
        let known = margins(&gains(-2.0, -60.0), &modes).unwrap().critical_factor.unwrap();
        match gain_margin(&reduced, &own).unwrap() {
            GainMargin::Ends { below: Some(below), above: None } => {
                assert!((below.to_f64() / known - 1.0).abs() < 1e-9, "{n}: {below} {known}");
            }
            other => panic!("{n}: {other:?}"),
        }
    }
}

/// Twelve different cars in a ring, for which enclosed eigenvalues do not tell where stability ends; and what is open says so.
#[test]
fn gain_margins_are_decided_or_open() {
    let ring = |n: usize| {
        let half = || rational(1, 2);
        let rows = (1..=n).map(|k| if k == 1 { vec![(0, half()), (n, half())] } else { vec![(k - 1, rational(1, 1))] });
        CommunicationGraph::new(rows.collect()).unwrap().reduced_laplacian().unwrap()
    };
    let own = |n: usize| -> Vec<Gains<Rational>> {
        (1..=n as i64).map(|k| Gains { f: rational(-1, k), g: rational(-50 - k, 1) }).collect()
    };
    let stable = |gains: &[Gains<Rational>], factor: &Rational| {
        let gains: Vec<_> = gains.iter().map(|gains| gains.map(|q| q * factor)).collect();
        let rows = motion_rows_of_cars(&ring(gains.len()), |k| &gains[k]);
        models::platoon::vector_form::is_stable(&algebra::matrix::RationalMatrix::from_rows(&rows).unwrap()).unwrap()
    };
    let gains = own(12);
    assert!(stable(&gains, &rational(1, 1)));
    match gain_margin(&ring(12), &gains).unwrap() {
        GainMargin::Ends { below: Some(below), above: None } => {
            let (lo, hi) = below.to_rationals();
            assert!(stable(&gains, &(hi * rational(1_000_001, 1_000_000))));
            assert!(!stable(&gains, &(lo * rational(999_999, 1_000_000))));
        }
        other => panic!("{other:?}"),
    }
    assert!(matches!(gain_margin(&ring(13), &own(13)).unwrap(), GainMargin::Open(why) if why == "more than 12 cars"));
    assert!(gain_margin(&ring(3), &own(4)).is_err());
    for n in [1, 2, 12] {
        let line = CommunicationGraph::of(Communication::FrontAndBack, n).unwrap().reduced_laplacian().unwrap();
        assert!(matches!(gain_margin(&line, &vec![own(1)[0].clone(); n]).unwrap(), GainMargin::Infinite), "{n}");
    }
}

/// Cars that only track the car in front are blocks of their own: the least margin is that of the worst car.
#[test]
fn margins_of_different_cars_are_those_of_the_worst() {
    let reduced = CommunicationGraph::of(Communication::Front, 3).unwrap().reduced_laplacian().unwrap();
    let own = [(-1, -1), (-4, -1), (-2, -3)].map(|(f, g)| Gains { f: rational(f, 1), g: rational(g, 1) });
    let found = phase_margin_of_cars(&reduced, &own).unwrap().unwrap();
    let single = |(f, g): (f64, f64)| margins(&gains(f, g), &[Complex::real(1.0)]).unwrap().phase.unwrap();
    let least = [(-1.0, -1.0), (-4.0, -1.0), (-2.0, -3.0)].map(single).into_iter().fold(9.0, f64::min);
    assert!((found - least).abs() < 1e-6, "{found:?}, {least}");
    assert!(matches!(gain_margin(&reduced, &own).unwrap(), GainMargin::Infinite));
}

/// The matrices of a platoon have the response and the peak of the platoon.
#[test]
fn matrices_of_a_platoon_respond_as_it_does() {
    let graph = CommunicationGraph::of(Communication::FrontAndBack, 5).unwrap();
    let own: Vec<Gains<Rational>> = (1..=5).map(|k| Gains { f: rational(-1, k), g: rational(-2 * k, 5) }).collect();
    let a = motion_rows_of_cars(&graph.reduced_laplacian().unwrap(), |k| &own[k]);
    let zero = || vec![rational(0, 1), rational(0, 1)];
    let column = graph.leader_column().unwrap();
    let b: Vec<Vec<Rational>> =
        own.iter().zip(&column).flat_map(|(own, weight)| [zero(), vec![&own.f * weight, &own.g * weight]]).collect();
    let mut c = vec![rational(0, 1); 10];
    c[8] = rational(1, 1);
    let system = StateSpace::new(&a, &b, &[c.clone()], None).unwrap();
    let floats: Vec<Gains<f64>> = own.iter().map(|g| g.map(|q| num_traits::ToPrimitive::to_f64(q).unwrap())).collect();
    for w in [rational(1, 7), rational(1, 1), rational(9, 2)] {
        assert_eq!(system.response(&w).unwrap(), graph.response_of_cars(&own, &w).unwrap()[4]);
    }
    let (found, known) = (system.searched_peak().unwrap(), peak_of_car(&graph, &floats, 5).unwrap().unwrap());
    assert!((found.value / known.value - 1.0).abs() < 1e-9, "{found:?} {known:?}");
    assert_eq!(system.is_stable(), Some(true));
    assert!(StateSpace::new(&a, &b[1..], &[c.clone()], None).is_err());
    assert!(StateSpace::new(&a, &b, &[c.clone(), c], None).is_err());
    assert!(StateSpace::new(&[], &[], &[vec![]], None).is_err());
}
