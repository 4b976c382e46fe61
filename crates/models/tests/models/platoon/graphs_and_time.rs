//! Communication graphs, modes and motion in time against naive twins.

use algebra::matrix::characteristic_coefficients;
use algebra::spectrum::Polynomial;
use arithmetic::{
    ArithmeticError, Complex, Field, Interval, Number, Rational, Real, Ring, Signed, Unwatched, rational,
};
use models::platoon::modes::{Mode, Roots, mode_angle, mode_eigenvalue};
use models::platoon::time_domain::{Followers, Modes};
use models::platoon::vector_form::{characteristic_by_modes, motion_matrix, motion_rows};
use models::platoon::{
    Communication, CommunicationError, CommunicationGraph, Gains, accelerations, amplitude_one_sided,
    amplitude_two_sided, amplitudes_two_sided, gamma, inverse_square_two_sided, is_below_full_phase,
    larger_root_modulus, larger_root_power, lesser_resonance, next_order, peak_on_graph, resonance, slowest_rate,
    theorem1,
};
use proptest::prelude::*;

const SYSTEMS: [Communication; 2] = [Communication::Front, Communication::FrontAndBack];

fn floats(f: f64, g: f64) -> Gains<f64> {
    Gains { f, g }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(30))]

    /// The law, and that of the graphs of the two systems, against equations (1) and (2) as printed.
    #[test]
    fn the_law_is_that_of_the_printed_equations(m in 1usize..7, values in prop::collection::vec(-50i64..50, 16)) {
        let q: Vec<Rational> = values.iter().map(|&v| rational(v, 7)).collect();
        let gains = Gains { f: q[0].clone(), g: q[1].clone() };
        let (leader, positions, velocities) = ((&q[2], &q[3]), &q[4..4 + m], &q[10..10 + m]);
        let half = rational(1, 2);
        let part = |values: &[Rational], first: &Rational, k: usize, both: bool| {
            let front = if k == 0 { first } else { &values[k - 1] };
            match values.get(k + 1).filter(|_| both) {
                Some(behind) => &values[k] - &half * (front + behind),
                None => &values[k] - front,
            }
        };
        for system in SYSTEMS {
            let both = system == Communication::FrontAndBack;
            let printed: Vec<Rational> = (0..m)
                .map(|k| &gains.f * part(positions, leader.0, k, both) + &gains.g * part(velocities, leader.1, k, both))
                .collect();
            let graph = CommunicationGraph::of(system, m).unwrap();
            prop_assert_eq!(&accelerations(system, &gains, leader, positions, velocities), &printed);
            prop_assert_eq!(&graph.accelerations(&gains, leader, positions, velocities), &printed);
        }
    }

    /// `det(xI - M)`, the same over any field, and the product over the modes.
    #[test]
    fn the_spectrum_of_the_motion_is_that_of_the_modes(m in 1usize..5, f in -9i64..9, g in -9i64..9) {
        let gains = Gains { f: rational(f, 4), g: rational(g, 3) };
        for system in SYSTEMS {
            let reduced = CommunicationGraph::of(system, m).unwrap().reduced_laplacian().unwrap();
            let motion = motion_matrix(&reduced, &gains).unwrap().characteristic_polynomial().unwrap().coefficients();
            let spectrum = reduced.characteristic_polynomial().unwrap().coefficients();
            prop_assert_eq!(&characteristic_coefficients(&motion_rows(&reduced, &gains), &gains.f), &motion);
            prop_assert_eq!(&characteristic_by_modes(&spectrum, &gains), &motion);
        }
    }

    /// The modulus of the larger root against the roots themselves, and its power.
    #[test]
    fn the_larger_root_is_that_of_the_quadratic(f in 1i64..30, g in 1i64..30, w in 1i64..40, n in 1u64..9) {
        let gains = floats(-(f as f64) / 7.0, -(g as f64) / 5.0);
        let w = w as f64 / 9.0;
        let gamma = gamma(&gains, &w).unwrap();
        let square = gamma.square() - gamma.one();
        // A square root of a complex number with positive imaginary part.
        let (size, re) = (square.norm_squared().sqrt(), square.re);
        let root = Complex::new((0.5 * (size + re)).max(0.0).sqrt(), 0.5 * square.im / (0.5 * (size + re)).max(1e-300).sqrt());
        let moduli = [gamma.clone() + &root, gamma - root].map(|mu| mu.norm_squared().sqrt());
        let larger = moduli[0].max(moduli[1]);
        let found = larger_root_modulus(&gains, &w).unwrap();
        prop_assert!((found / larger - 1.0).abs() < 1e-9, "{found} {larger}");
        let power = larger_root_power(&gains, &w, n).unwrap();
        prop_assert!((power / found.powi(n as i32) - 1.0).abs() < 1e-9, "{power}");
    }

    /// The solved response is the closed form of the two systems.
    #[test]
    fn the_response_of_a_graph_is_the_closed_form(m in 1usize..6, f in 1i64..30, g in 1i64..30, w in 0i64..40) {
        let gains = Gains { f: rational(-f, 7), g: rational(-g, 5) };
        let w = rational(w, 9);
        let front = CommunicationGraph::of(Communication::Front, m).unwrap().response(&gains, &w).unwrap();
        let expected: Vec<_> = (1..=m as u64).map(|k| amplitude_one_sided(&gains, &w, k).unwrap()).collect();
        prop_assert_eq!(front, expected);
        let both = CommunicationGraph::of(Communication::FrontAndBack, m).unwrap().response(&gains, &w).unwrap();
        for (k, amplitude) in (1..).zip(&both) {
            prop_assert_eq!(&amplitude_two_sided(&gains, &w, m as u64, k).unwrap(), amplitude);
        }
        prop_assert!(amplitude_two_sided(&gains, &w, m as u64, m as u64 + 1).is_err());
        if let Some(last) = both.last() {
            prop_assert_eq!(inverse_square_two_sided(&gains, &w, m as u64).unwrap(), last.norm_squared().recip());
        }
        prop_assert_eq!(both, amplitudes_two_sided(&gains, &w, m).unwrap());
    }

    /// Routh's table against polynomials with known roots: real ones and conjugate pairs.
    #[test]
    fn stability_is_read_off_the_roots(
        real in prop::collection::vec(-6i64..3, 0..4),
        pairs in prop::collection::vec((-6i64..3, 0i64..5), 0..3),
        shift in -4i64..4,
    ) {
        let mut product = vec![rational(-3, 2)];
        let mut times = |factor: &[i64]| {
            let mut next = vec![rational(0, 1); product.len() + factor.len() - 1];
            for (i, a) in product.iter().enumerate() {
                for (j, b) in factor.iter().enumerate() {
                    next[i + j] += a * rational(*b, 1);
                }
            }
            product = next;
        };
        real.iter().for_each(|r| times(&[-r, 1]));
        pairs.iter().for_each(|(re, im)| times(&[re * re + im * im, -2 * re, 1]));
        let stable = |by: i64| real.iter().chain(pairs.iter().map(|(re, _)| re)).all(|re| re + by < 0);
        let polynomial = Polynomial::from_rationals(&product);
        prop_assert_eq!(polynomial.is_hurwitz(), stable(0));
        prop_assert_eq!(polynomial.with_roots_moved(&rational(shift, 1)).is_hurwitz(), stable(shift));
    }
}

#[test]
fn lists_that_are_no_platoon_are_refused() {
    let graph = |rows: &[Vec<usize>]| CommunicationGraph::with_equal_weights(rows);
    assert_eq!(graph(&[]), Err(CommunicationError::NoFollowers));
    assert_eq!(graph(&[vec![1]]), Err(CommunicationError::Agent { follower: 1, agent: 1 }));
    assert_eq!(graph(&[vec![0], vec![3]]), Err(CommunicationError::Agent { follower: 2, agent: 3 }));
    let weights = |p, q| CommunicationGraph::new(vec![vec![(0, rational(p, q))]]);
    assert_eq!(weights(1, 2), Err(CommunicationError::Weights(1)));
    assert_eq!(
        CommunicationGraph::new(vec![vec![(0, rational(2, 1)), (2, rational(-1, 1))], vec![(0, rational(1, 1))]]),
        Err(CommunicationError::Weights(1))
    );
    assert!(weights(1, 1).is_ok());
    assert!(CommunicationGraph::nth_neighbours(0, 3).is_err());
}

/// Whom each follower tracks, from the first on.
fn tracked(graph: Result<CommunicationGraph, CommunicationError>) -> Vec<Vec<usize>> {
    let graph = graph.unwrap();
    (1..=graph.followers()).map(|k| graph.tracked_by(k).iter().map(|(agent, _)| *agent).collect()).collect()
}

#[test]
fn rules_of_tracking_are_those_of_their_names() {
    assert_eq!(tracked(CommunicationGraph::nth_neighbours(2, 4)), [vec![3], vec![0, 4], vec![1], vec![2]]);
    assert_eq!(tracked(CommunicationGraph::star(3)), [[0], [0], [0]]);
    let series = [vec![0, 2], vec![1], vec![2, 4], vec![3, 5], vec![4]];
    assert_eq!(tracked(CommunicationGraph::in_series(&[2, 3])), series);
    let behind = [vec![0], vec![0], vec![0, 4], vec![3], vec![4]];
    assert_eq!(tracked(CommunicationGraph::in_series_behind(2, &[2, 1])), behind);
}

/// As many accelerations as there are cars with position and velocity.
#[test]
fn lists_of_other_lengths_have_the_accelerations_of_the_shorter() {
    let gains = floats(-1.0, -2.0);
    let graph = CommunicationGraph::of(Communication::Front, 2).unwrap();
    let (y, u) = ([1.0, 3.0, 4.0], [0.5, 0.25, 8.0]);
    let both = [-(1.0 - 2.0 * 0.0) - 2.0 * 0.5, -2.0 + 2.0 * 0.25];
    for count in 0..=3 {
        let expected = &both[..count.min(2)];
        assert_eq!(graph.accelerations(&gains, (&0.0, &0.0), &y[..count], &u[..count]), expected);
        if count < 3 {
            assert_eq!(graph.accelerations(&gains, (&0.0, &0.0), &y, &u[..count]), expected);
            assert_eq!(accelerations(Communication::Front, &gains, (&0.0, &0.0), &y[..2], &u[..count]), expected);
        }
    }
}

#[test]
fn residue_classes_do_not_hear_of_the_leader() {
    let graph = CommunicationGraph::nth_neighbours(3, 7).unwrap();
    assert_eq!(graph.reached_by_leader(), [true, false, false, true, false, false, true, false]);
    assert!(!graph.is_connected());
    let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    let response = graph.response(&gains, &rational(1, 2)).unwrap();
    let at_rest: Vec<bool> = response.iter().map(|a| a.norm_squared() == rational(0, 1)).collect();
    assert_eq!(at_rest, [true, true, false, true, true, false, true]);
    assert_eq!(
        graph.response_of_cars(&vec![gains.clone(); 6], &rational(1, 2)).map(drop),
        Err(ArithmeticError::Domain("gains for each follower"))
    );
    // Car 2 also tracks car 3, which hears of nobody and rests: its amplitude is the response to half of the leader's.
    let aside = CommunicationGraph::with_equal_weights(&[vec![0], vec![0, 3], vec![]]).unwrap();
    let response = aside.response(&gains, &rational(1, 2)).unwrap();
    assert_eq!(response[1], response[0].scale(&rational(1, 2)));
    assert_eq!(response[2], Complex::real(rational(0, 1)));
    // A follower that tracks nobody has a zero row.
    let alone = CommunicationGraph::with_equal_weights(&[vec![0], vec![]]).unwrap();
    assert_eq!(alone.reduced_laplacian().unwrap().entry(1, 1), rational(0, 1));
}

/// One step of the classical method of order four for the positions and velocities of the followers.
fn step(gains: &Gains<f64>, leader: &dyn Fn(f64) -> (f64, f64), t: f64, h: f64, state: &mut (Vec<f64>, Vec<f64>)) {
    let rate = |t: f64, y: &[f64], u: &[f64]| {
        let (y0, u0) = leader(t);
        (u.to_vec(), accelerations(Communication::FrontAndBack, gains, (&y0, &u0), y, u))
    };
    let moved =
        |base: &[f64], rate: &[f64], h: f64| -> Vec<f64> { base.iter().zip(rate).map(|(a, b)| a + h * b).collect() };
    let (y, u) = state.clone();
    let k1 = rate(t, &y, &u);
    let k2 = rate(t + h / 2.0, &moved(&y, &k1.0, h / 2.0), &moved(&u, &k1.1, h / 2.0));
    let k3 = rate(t + h / 2.0, &moved(&y, &k2.0, h / 2.0), &moved(&u, &k2.1, h / 2.0));
    let k4 = rate(t + h, &moved(&y, &k3.0, h), &moved(&u, &k3.1, h));
    for k in 0..y.len() {
        state.0[k] += h / 6.0 * (k1.0[k] + 2.0 * k2.0[k] + 2.0 * k3.0[k] + k4.0[k]);
        state.1[k] += h / 6.0 * (k1.1[k] + 2.0 * k2.1[k] + 2.0 * k3.1[k] + k4.1[k]);
    }
}

fn assert_close(found: &(Vec<f64>, Vec<f64>), expected: &Followers<f64>, tolerance: f64) {
    let pairs = found.0.iter().zip(&expected.positions).chain(found.1.iter().zip(&expected.velocities));
    pairs.for_each(|(a, b)| assert!((a - b).abs() < tolerance, "{found:?} {expected:?}"));
}

/// Floats against enclosures, also far out in time and for many cars.
#[test]
fn floats_agree_with_enclosures() {
    for (f, g, m, t) in [(-1, -1, 128u64, 2000), (-3, -7, 40, 5), (-1, -20, 5, 10_000), (-2, -1, 1, 1)] {
        let interval = |p, q| Interval::from_rational(&rational(p, q), 100);
        let w = |m: u64| (1, m as i64);
        let floats = Modes::new(&floats(f as f64 / 2.0, g as f64 / 3.0), m).unwrap();
        let exact = Modes::new(&Gains { f: interval(f, 2), g: interval(g, 3) }, m).unwrap();
        let harmonic = floats.behind_harmonic_leader(&(1.0 / m as f64)).unwrap();
        let enclosed = exact.behind_harmonic_leader(&interval(w(m).0, w(m).1)).unwrap();
        let abrupt = floats.behind_accelerating_leader(&[(0.0, 1.0), (0.75, -1.0)]).unwrap();
        let enclosed_abrupt = exact
            .behind_accelerating_leader(&[(interval(0, 1), interval(1, 1)), (interval(3, 4), interval(-1, 1))])
            .unwrap();
        let (time, enclosed_time) = (t as f64, interval(t, 1));
        for (found, enclosed) in [
            (harmonic.followers(&time).unwrap(), enclosed.followers(&enclosed_time).unwrap()),
            (abrupt.deviations(&time).unwrap(), enclosed_abrupt.deviations(&enclosed_time).unwrap()),
        ] {
            let enclosed = (
                enclosed.positions.iter().map(Interval::to_f64).collect(),
                enclosed.velocities.iter().map(Interval::to_f64).collect(),
            );
            let size = found.positions.iter().fold(1f64, |a, b| a.max(b.abs()));
            assert_close(&enclosed, &found, 1e-11 * size);
        }
    }
}

/// The sum of the modes is what a naive integration finds, with and without overdamped modes.
#[test]
fn modes_follow_the_start_behind_a_periodic_leader() {
    const STEPS: usize = 4000;
    for (f, g, m, w) in [(-1.0, -1.0, 3usize, 0.4), (-0.5, -3.0, 4, 0.7), (-2.0, -0.3, 1, 1.1), (-1.0, -2.0, 3, 0.4)] {
        let gains = floats(f, g);
        let start = Modes::new(&gains, m as u64).unwrap().behind_harmonic_leader(&w).unwrap();
        let amplitude = amplitudes_two_sided(&gains, &w, m).unwrap().pop().unwrap();
        let (until, h) = (20.0, 20.0 / STEPS as f64);
        for cosine in [true, false] {
            let leader = move |t: f64| {
                let (s, c) = (w * t).sin_cos();
                if cosine { (c, -w * s) } else { (s, w * c) }
            };
            let mut state = (vec![0.0; m], vec![0.0; m]);
            for k in 0..STEPS {
                step(&gains, &leader, k as f64 * h, h, &mut state);
            }
            let (s, c) = (w * until).sin_cos();
            let motion = amplitude.clone() * Complex::new(c, s) + start.transient(&until).unwrap();
            let expected = if cosine { motion.re } else { motion.im };
            // Order four: (h w_max)^4 times the length, with room.
            assert!((state.0[m - 1] - expected).abs() < 1e-8, "{f} {g} {m}: {} {expected}", state.0[m - 1]);
            if cosine {
                assert!((start.last(&until).unwrap() - expected).abs() < 1e-12);
                assert_close(&state, &start.followers(&until).unwrap(), 1e-8);
            }
        }
        let (bound, size) = (start.transient_bound(&until).unwrap(), start.transient(&until).unwrap());
        assert!(size.norm_squared().sqrt() <= bound);
    }
}

#[test]
fn modes_follow_an_abrupt_start() {
    const STEPS: usize = 2000;
    for (f, g, m) in [(-1.0, -1.0, 3usize), (-0.5, -3.0, 4), (-1.0, -2.0, 1), (-1.0, -2.0, 5)] {
        let gains = floats(f, g);
        let (until, end) = (4.0, 16.0);
        let changes = [(0.0, 1.0), (until, -1.0)];
        let start = Modes::new(&gains, m as u64).unwrap().behind_accelerating_leader(&changes).unwrap();
        let h = end / STEPS as f64;
        let leader = |t: f64| if t < until { (t * t / 2.0, t) } else { (until * (t - until / 2.0), until) };
        let mut state = (vec![0.0; m], vec![0.0; m]);
        for k in 0..STEPS {
            step(&gains, &leader, k as f64 * h, h, &mut state);
            let t = (k + 1) as f64 * h;
            if k == STEPS / 8 || k + 1 == STEPS {
                let (y0, u0) = leader(t);
                assert_eq!(start.leader(&t).unwrap(), (y0, u0));
                let found = (state.0.iter().map(|y| y - y0).collect(), state.1.iter().map(|u| u - u0).collect());
                let expected = start.deviations(&t).unwrap();
                assert!((start.last(&t).unwrap() - expected.positions[m - 1]).abs() < 1e-12);
                assert_close(&found, &expected, 1e-7);
            }
        }
    }
}

#[test]
fn eigenvectors_of_the_modes_are_orthogonal() {
    let m = 6u64;
    let angle = |k| mode_angle(&1.0f64, m, k);
    for k in 1..=m {
        assert!((mode_eigenvalue(&1.0f64, m, k).unwrap() - (1.0 - angle(k).cos())).abs() < 1e-14);
        for l in 1..=m {
            let weight = |j| if j == m { 0.5 } else { 1.0 };
            let product: f64 =
                (1..=m).map(|j| weight(j) * (j as f64 * angle(k)).sin() * (j as f64 * angle(l)).sin()).sum();
            let expected = if k == l { m as f64 / 2.0 } else { 0.0 };
            assert!((product - expected).abs() < 1e-12);
        }
    }
}

/// The slowest rate moves the spectrum of M just to the axis, decided exactly on both sides; one follower with the last gains has a double root.
#[test]
fn the_slowest_rate_is_exact() {
    for (f, g) in [((-1, 1), (-1, 1)), ((-1, 5), (-4, 1)), ((-3, 1), (-1, 7)), ((-1, 1), (-2, 1))] {
        let gains = Gains { f: rational(f.0, f.1), g: rational(g.0, g.1) };
        for m in 1..=5usize {
            let graph = CommunicationGraph::of(Communication::FrontAndBack, m).unwrap();
            let motion = motion_matrix(&graph.reduced_laplacian().unwrap(), &gains).unwrap();
            let polynomial = Polynomial::from_rationals(&motion.characteristic_polynomial().unwrap().coefficients());
            let rate = slowest_rate(&gains.map(|q| Interval::from_rational(q, 80)), m as u64).unwrap();
            let (lo, hi) = rate.to_rationals();
            let step = rational(1, 1 << 30);
            assert!(polynomial.with_roots_moved(&(lo - &step)).is_hurwitz(), "{gains:?} {m}");
            assert!(!polynomial.with_roots_moved(&(hi + step)).is_hurwitz(), "{gains:?} {m}");
        }
    }
}

/// Few bits enclose what many show, whether the first or the last mode is the slowest one, and where few bits do not tell whether a mode oscillates.
#[test]
fn slowest_rates_of_few_bits_hold_those_of_many() {
    let almost = rational(1, 1) - rational(1, 1 << 30);
    for (f, g) in [(rational(-1, 3), rational(-1, 7)), (rational(-1, 3), rational(-10, 1)), (-&almost, rational(-2, 1))]
    {
        let enclosed = |m: u64, bits: u32| {
            let gains = Gains { f: f.clone(), g: g.clone() }.map(|q| Interval::from_rational(q, bits));
            slowest_rate(&gains, m).expect("a rate").to_rationals()
        };
        for m in [1, 2, 3, 8] {
            let ((low, high), (lo, hi)) = (enclosed(m, 24), enclosed(m, 200));
            assert!(low <= lo && hi <= high && low < high, "{f} {g} {m}");
            assert!(&high - &low < rational(1, 1 << 10) * &high, "{f} {g} {m}");
        }
    }
    // One follower with f = -(1 - 2^-30), g = -2: the rates are 1 -+ 2^-15.
    let gains = Gains { f: -almost, g: rational(-2, 1) }.map(|q| Interval::from_rational(q, 24));
    let (low, high) = slowest_rate(&gains, 1).expect("a rate").to_rationals();
    let exact = rational(1, 1) - rational(1, 1 << 15);
    assert!(low <= exact && exact <= high);
}

/// The least real part of `lambda (|f| + |g| s) = -s²` over all modes, with the sign turned, in floats.
#[test]
fn the_slowest_rate_is_the_least_of_all_modes() {
    for (f, g) in [(-1, -1), (-1, -9), (-4, -2), (-9, -40)] {
        let gains = Gains { f: rational(f, 4), g: rational(g, 4) }.map(|q| Interval::from_rational(q, 80));
        for m in [1u64, 2, 7] {
            let rate = |k: u64| {
                let lambda = 1.0 - (std::f64::consts::PI * (2 * k - 1) as f64 / (2 * m) as f64).cos();
                let (decay, stiffness) = (-lambda * g as f64 / 8.0, -lambda * f as f64 / 4.0);
                decay - (decay * decay - stiffness).max(0.0).sqrt()
            };
            let naive = (1..=m).map(rate).fold(f64::INFINITY, f64::min);
            let found = slowest_rate(&gains, m).unwrap();
            assert!(
                (found.to_f64() / naive - 1.0).abs() < 1e-9 && found.width().to_f64() < 1e-15 * naive,
                "{f} {g} {m}"
            );
        }
    }
}

/// With `lambda = 1` and `g² = 4 |f|` the double root is `g/2`: `c = (1 + d t) e^(-d t)` and `s = t e^(-d t)` with `d = |g|/2`, at any time, whether the
/// discriminant is known to be 0 or only encloses it.
#[test]
fn a_double_root_has_its_closed_form() {
    for (f, g) in [((-1, 1), (-2, 1)), ((-1, 4), (-1, 1)), ((-25, 9), (-10, 3))] {
        for precision in [24, 53, 64, 300] {
            let number = |(p, q)| Interval::from_rational(&rational(p, q), precision);
            let gains = Gains { f: number(f), g: number(g) };
            // The middle one of three cars.
            let lambda = mode_eigenvalue(&gains.f, 3, 2).expect("an eigenvalue");
            let mode = Mode::new(&gains, &lambda).expect("a mode");
            assert!(matches!(mode.roots, Roots::Close(_)), "{:?}", mode.roots);
            for time in [(0, 1), (1, 3), (4, 1), (30, 1), (5000, 1), (1 << 17, 1)] {
                let t = number(time);
                let (c, s) = mode.propagator(&t).expect("a motion");
                let decay = number((-g.0, 2 * g.1));
                let fall = (-(decay.clone() * &t)).exp().expect("an exponential");
                let (exact_c, exact_s) = (fall.clone() * (decay * &t + t.one()), fall * &t);
                for (found, exact) in [(&c, &exact_c), (&s, &exact_s)] {
                    let ((lo, hi), (low, high)) = (found.to_rationals(), exact.to_rationals());
                    assert!(lo <= high && low <= hi, "{f:?} {g:?} {time:?}: {found:?} {exact:?}");
                    assert!(hi - lo < rational(1, 1 << (precision.min(100) / 2)), "{f:?} {g:?} {time:?}: {found:?}");
                }
                let (bound_c, bound_s) = mode.bounds().expect("bounds");
                let envelope = (-(mode.rate.clone() * &t)).exp().expect("an exponential");
                assert!((bound_c * &envelope - c).is_certainly_positive());
                assert!(time.0 == 0 || (bound_s * &envelope - s).is_certainly_positive());
            }
        }
    }
    // Too wide to tell.
    let wide = Interval::from_rational(&rational(1, 1), 4).hull(&Interval::from_rational(&rational(3, 2), 4));
    let gains = Gains { f: wide.integer(-1), g: wide.integer(-2) };
    assert!(Mode::new(&gains, &wide).is_err());
}

/// A lesser resonance beats its neighbourhood and is where the chain of maxima puts it.
#[test]
fn lesser_resonances_are_local_maxima() {
    let gains = Gains { f: rational(-2, 1), g: rational(-1, 1) };
    for (m, k) in [(40u64, 2u64), (100, 2), (100, 4)] {
        let found = lesser_resonance(&gains, m, k, 12).unwrap();
        let height = |w: f64| {
            let floats = floats(-2.0, -1.0);
            amplitudes_two_sided(&floats, &w, m as usize).unwrap().pop().unwrap().norm_squared().sqrt()
        };
        let (w, top) = (found.omega.to_f64(), found.amplitude.to_f64());
        assert!((height(w) - top).abs() < 1e-9 * top);
        assert!((1..100).all(|j| height(w * (1.0 + 1e-4 * f64::from(j))) < top && height(w * (1.0 - 1e-4 * f64::from(j))) < top));
        let main = resonance(&gains, m, 12).unwrap().omega.to_f64();
        assert!((w / main / (2 * k - 1) as f64 - 1.0).abs() < 0.05);
    }
    // Damped away.
    assert!(lesser_resonance(&gains, 1, 2, 12).is_err());
    assert!(lesser_resonance(&Gains { f: rational(-1, 1), g: rational(-50, 1) }, 20, 3, 12).is_err());
}

#[test]
fn the_next_order_is_closer_than_theorem_1() {
    let exact = Gains { f: rational(-3, 1), g: rational(-1, 1) };
    let found = resonance(&exact, 50, 20).unwrap();
    let gains = exact.map(|q| Interval::from_rational(q, 100));
    let distance = |x: Interval, y: &Interval| (x - y).to_f64().abs();
    let (w0, w1) = (theorem1::frequency(&gains, 50).unwrap(), next_order::frequency(&gains, 50).unwrap());
    assert!(100.0 * distance(w1, &found.omega) < distance(w0, &found.omega));
    let (a0, a1) = (theorem1::amplitude(&gains, 50).unwrap(), next_order::amplitude(&gains, 50).unwrap());
    assert!(100.0 * distance(a1, &found.amplitude) < distance(a0, &found.amplitude));
}

#[test]
fn the_peak_on_a_graph_is_that_of_the_line_and_above_every_frequency() {
    let gains = Gains { f: rational(-2, 1), g: rational(-3, 2) };
    for m in [1, 2, 5] {
        let line = CommunicationGraph::of(Communication::FrontAndBack, m).unwrap();
        let found = peak_on_graph(&line, &vec![gains.clone(); m], m, 20, &Unwatched).unwrap();
        let known = resonance(&gains, m as u64, 18).unwrap();
        assert!(found.amplitude.overlaps(&known.amplitude) && found.omega.unwrap().overlaps(&known.omega), "{m}");
        assert!(found.amplitude.width().to_f64() < 1e-15);
    }
    // Directed: the second car looks two ahead and one behind, the fourth at the leader.
    let graph = CommunicationGraph::with_equal_weights(&[vec![0, 2], vec![0, 1, 3], vec![2], vec![0, 3]]).unwrap();
    let peak = peak_on_graph(&graph, &vec![gains; 4], 4, 20, &Unwatched).unwrap().amplitude.to_f64();
    let floats = floats(-2.0, -1.5);
    let response = |w: f64| graph.response(&floats, &w).unwrap()[3].norm_squared().sqrt();
    let most = (1..4000).map(|k| response(f64::from(k) * 1e-3)).fold(0.0, f64::max);
    assert!(most <= peak && peak - most < 1e-5, "{most} {peak}");
}

#[test]
fn a_swinging_leader_and_any_start_are_followed_as_by_the_law() {
    let gains = floats(-1.0, -0.8);
    let modes = Modes::new(&gains, 3).unwrap();
    let (amplitude, w) = (0.7, 0.4);
    let first = Followers { positions: vec![0.3, -0.2, 0.5], velocities: vec![0.1, 0.0, -0.4] };
    let start = modes.behind_swinging_leader(&first, &amplitude, &w).unwrap();
    let found = start.deviations(&0.0).unwrap();
    let close = |a: &[f64], b: &[f64], most: f64| a.iter().zip(b).all(|(x, y)| (x - y).abs() < most);
    assert!(close(&found.positions, &first.positions, 1e-12) && close(&found.velocities, &first.velocities, 1e-12));
    // The second derivative is that of the law, in the frame of the leader.
    let (t, h) = (2.3, 1e-4);
    let [before, now, after] = [t - h, t, t + h].map(|t| start.deviations(&t).unwrap());
    let leader = -amplitude * w * w * (w * t).cos();
    let forces = accelerations(Communication::FrontAndBack, &gains, (&0.0, &0.0), &now.positions, &now.velocities);
    assert_eq!(forces.len(), 3);
    for (k, force) in forces.iter().enumerate() {
        let slope = (after.velocities[k] - before.velocities[k]) / (2.0 * h);
        assert!((slope - (force - leader)).abs() < 1e-6, "{k}");
        let rate = (after.positions[k] - before.positions[k]) / (2.0 * h);
        assert!((rate - now.velocities[k]).abs() < 1e-6, "{k}");
    }
}

#[test]
fn platoons_that_no_list_holds_are_refused() {
    let most = usize::MAX;
    let refused = Err(CommunicationError::TooManyFollowers(most));
    assert_eq!(CommunicationGraph::of(Communication::Front, most), refused);
    assert_eq!(CommunicationGraph::star(most), refused);
    assert_eq!(CommunicationGraph::nth_neighbours(1, most), refused);
    assert_eq!(CommunicationGraph::in_series(&[2, most]), refused);
    assert_eq!(CommunicationGraph::in_series(&[most, most]), refused);
    assert_eq!(CommunicationGraph::in_series_behind(most, &[2]), refused);
}

/// The angle of the last mode is `pi (1 - 1/(2M))`, that of the first `pi/(2M)`, also where twice `M` does not fit 64 bits.
#[test]
fn modes_of_platoons_of_any_length_have_angles() {
    let like = Interval::from_rational(&rational(1, 1), 120);
    for m in [1, 3, u64::MAX / 4, u64::MAX / 2, u64::MAX] {
        let share = Rational::new(1.into(), num_bigint::BigInt::from(m) * 2);
        for (k, exact) in [(1, share.clone()), (m, rational(1, 1) - &share)] {
            let angle = mode_angle(&like, m, k);
            let off = (angle.clone() - like.pi() * like.rational(&exact)).to_f64().abs();
            assert!(off < 1e-30 && angle.is_certainly_positive(), "{m} {k} {angle}");
        }
    }
    let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    let slow = slowest_rate(&gains.map(|q| Interval::from_rational(q, 200)), u64::MAX).expect("a rate");
    // lambda |g|/2 with lambda = 2 sin²(pi/(4M)).
    assert!((slow.to_f64() * (4.0 * u64::MAX as f64 / std::f64::consts::PI).powi(2) - 1.0).abs() < 1e-9, "{slow}");
    // |gamma - 1| = w² at f = 0-like gains is far above 4/M² at w = 1 and far below at the frequency of the first mode.
    let below =
        |w: f64| is_below_full_phase(&gains, u64::MAX, &Interval::from_rational(&Rational::from_float(w).unwrap(), 64));
    assert!(!below(1.0) && below(0.1 / u64::MAX as f64));
}
