//! Gains for each car, and margins.

use arithmetic::{ArithmeticError, Complex, Rational, rational};
use models::platoon::banded::BandedPlatoon;
use models::platoon::gain_margin::{GainMargin, gain_margin};
use models::platoon::growth::peak_of_car;
use models::platoon::phase_margin::{PhaseMargin, phase_margin, phase_of_mode};
use models::platoon::state_space::StateSpace;
use models::platoon::vector_form::{motion_matrix, motion_rows_of_cars};
use models::platoon::{
    Communication, CommunicationGraph, Gains, Platoon, gain_squared_one_sided, resonance, strongest_one_sided_square,
};

fn gains(f: f64, g: f64) -> Gains<f64> {
    Gains { f, g }
}

fn platoon(graph: &CommunicationGraph, gains: Vec<Gains<f64>>) -> Platoon<f64> {
    Platoon::new(graph.clone(), gains).unwrap()
}

#[test]
fn equal_gains_give_the_certified_resonance() {
    let exact = Gains { f: rational(-1, 2), g: rational(-3, 1) };
    for m in [1usize, 2, 5, 16, 64] {
        let graph = CommunicationGraph::of(Communication::FrontAndBack, m).unwrap();
        let certified = resonance(&exact, m as u64, 12).unwrap();
        let found = peak_of_car(&platoon(&graph, vec![gains(-0.5, -3.0); m]), m).unwrap().unwrap();
        assert!((found.value / certified.amplitude.to_f64() - 1.0).abs() < 1e-9, "{m}");
        assert!((found.at / certified.omega.to_f64() - 1.0).abs() < 1e-4, "{m}");
    }
    let graph = CommunicationGraph::of(Communication::Front, 3).unwrap();
    assert!(Platoon::new(graph.clone(), vec![gains(-1.0, -1.0)]).is_err());
    assert!(peak_of_car(&platoon(&graph, vec![gains(-1.0, -1.0); 3]), 4).is_err());
    assert!(peak_of_car(&platoon(&graph, vec![gains(-1.0, -1.0); 3]), 0).is_err());
}

/// The last of many cars that all swing more than the one in front: squares of the amplitudes, or of the pivots, are beyond the floats, and
/// at last the amplitude is.
#[test]
fn long_one_sided_platoons_have_a_peak_as_long_as_floats_reach() {
    let one = gains(-1.0, -1.0);
    let gain = gain_squared_one_sided(&one, &strongest_one_sided_square(&one).unwrap()).unwrap().sqrt();
    let peak = |m: usize| {
        let graph = CommunicationGraph::of(Communication::Front, m).unwrap();
        peak_of_car(&platoon(&graph, vec![one.clone(); m]), m)
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

/// The phase margin of these modes, one of each pair of conjugates.
fn of_modes(own: &Gains<f64>, modes: &[Complex<f64>]) -> f64 {
    let sizes = Gains { f: -own.f, g: -own.g };
    let phase = |mode: &Complex<f64>| {
        phase_of_mode(&sizes, &mode.norm_squared(), &mode.im.atan2(mode.re).abs()).expect("a stable mode")
    };
    modes.iter().map(phase).fold(f64::INFINITY, f64::min)
}

/// The factor of the gains below which a mode is not stable; 0 for real ones.
fn critical_factor(own: &Gains<f64>, modes: &[Complex<f64>]) -> f64 {
    let factor = |mode: &Complex<f64>| -own.f * mode.im * mode.im / (own.g * own.g * mode.re * mode.norm_squared());
    modes.iter().map(factor).fold(0.0, f64::max)
}

/// Cars in a circle, the first of which tracks the leader, too, with this weight; the modes are `1 - r e^(2 pi i k/n)`, `r^n = 1 - weight`.
fn circle(n: usize, weight: Rational) -> (algebra::matrix::RationalMatrix, Vec<Complex<f64>>) {
    let rest = rational(1, 1) - &weight;
    let r = num_traits::ToPrimitive::to_f64(&rest).unwrap().powf(1.0 / n as f64);
    let rows = (1..=n).map(|k| match k {
        1 => vec![(0, weight.clone()), (n, rest.clone())],
        _ => vec![(k - 1, rational(1, 1))],
    });
    let reduced = CommunicationGraph::new(rows.collect()).unwrap().reduced_laplacian().unwrap();
    let angle = |k: usize| 2.0 * std::f64::consts::PI * k as f64 / n as f64;
    (reduced, (0..n).map(angle).map(|a| Complex::new(1.0 - r * a.cos(), -r * a.sin())).collect())
}

/// For one car the loop is (|f| + i w |g|)/w², and the margin is known; a bound by a search agrees with the enclosure.
#[test]
fn phase_margins_are_where_stability_ends() {
    let one = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    let single = CommunicationGraph::of(Communication::Front, 1).unwrap().reduced_laplacian().unwrap();
    let crossing = ((1.0 + 5f64.sqrt()) / 2.0).sqrt();
    match phase_margin(&single, &[one]).unwrap() {
        PhaseMargin::Enclosed(x) => assert!((x.to_f64() - crossing.atan()).abs() < 1e-12, "{x}"),
        other => panic!("{other:?}"),
    }
    let (reduced, modes) = circle(3, rational(1, 10));
    let own = vec![Gains { f: rational(-50, 1), g: rational(-10, 1) }; 3];
    let known = of_modes(&gains(-50.0, -10.0), &modes);
    match phase_margin(&reduced, &own).unwrap() {
        PhaseMargin::Enclosed(x) => assert!((x.to_f64() - known).abs() < 1e-9, "{x} {known}"),
        other => panic!("{other:?}"),
    }
    // Nearly equal gains, for which it is searched: at most a little more.
    let mut nearly = own.clone();
    nearly[2].f = rational(-50_000_001, 1_000_000);
    match phase_margin(&reduced, &nearly).unwrap() {
        PhaseMargin::AtMost(x) => {
            assert!((x.to_f64() - known).abs() < 1e-4 && x.to_f64() > known - 1e-7, "{x} {known}")
        }
        other => panic!("{other:?}"),
    }
    let open = phase_margin(&circle(13, rational(1, 2)).0, &[nearly, vec![own[0].clone(); 10]].concat()).unwrap();
    assert!(matches!(open, PhaseMargin::Open(why) if why == "more than 12 cars"));
}

/// The margin by its definition: the least `|arg L|` where `|L| = 1`, by bisection; and the factor at which the roots of `s² = k lambda (f + g s)`
/// cross the imaginary axis, where that is more than 1 and the mode is not stable.
#[test]
fn phases_of_modes_are_those_of_the_loops() {
    for own in [gains(-2.0, -3.0), gains(-5.0, -0.7)] {
        for (re, im) in [(1.0, 0.0), (0.5, 0.1), (1.5, 0.3), (0.7, 0.15), (2.0, 0.0)] {
            let loop_at =
                |w: f64, im: f64| Complex::new(-own.f, -own.g * w).scale(&(1.0 / (w * w))) * &Complex::new(re, im);
            let phase = |im: f64| {
                let (mut low, mut high) = (1e-6f64, 1e6f64);
                for _ in 0..200 {
                    let middle = (low * high).sqrt();
                    let above = loop_at(middle, im).norm_squared() > 1.0;
                    (low, high) = if above { (middle, high) } else { (low, middle) };
                }
                let there = loop_at(low, im);
                there.im.atan2(there.re).abs()
            };
            let mode = [Complex::new(re, im)];
            assert!(critical_factor(&own, &mode) < 1.0);
            assert!((of_modes(&own, &mode) - phase(im).min(phase(-im))).abs() < 1e-9, "{re} {im}");
            assert_eq!(of_modes(&own, &mode), of_modes(&own, &[Complex::new(re, -im)]));
        }
    }
}

/// Rings of cars, the first of which tracks the leader, too, with equal gains: the exact way for up to 12, the enclosed modes beyond. The modes are
/// `1 - r e^(2 pi i k/n)` with `r^n = 1/2`.
#[test]
fn gain_margins_of_rings_are_those_of_their_modes() {
    for n in [3usize, 7, 12, 13, 20] {
        let (reduced, modes) = circle(n, rational(1, 2));
        let own = vec![Gains { f: rational(-2, 1), g: rational(-60, 1) }; n];
        let known = critical_factor(&gains(-2.0, -60.0), &modes);
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
    let single = |(f, g): (f64, f64)| of_modes(&gains(f, g), &[Complex::real(1.0)]);
    let least = [(-1.0, -1.0), (-4.0, -1.0), (-2.0, -3.0)].map(single).into_iter().fold(9.0, f64::min);
    match phase_margin(&reduced, &own).unwrap() {
        PhaseMargin::AtMost(x) => assert!((x.to_f64() - least).abs() < 1e-5 && x.to_f64() > least, "{x}, {least}"),
        other => panic!("{other:?}"),
    }
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
    let (found, known) = (system.searched_peak().unwrap(), peak_of_car(&platoon(&graph, floats), 5).unwrap().unwrap());
    assert!((found.value / known.value - 1.0).abs() < 1e-9, "{found:?} {known:?}");
    assert!(StateSpace::new(&a, &b[1..], &[c.clone()], None).is_err());
    assert!(StateSpace::new(&a, &b, &[c.clone(), c], None).is_err());
    assert!(StateSpace::new(&[], &[], &[vec![]], None).is_err());
}
