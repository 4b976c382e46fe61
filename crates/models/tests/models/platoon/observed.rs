//! What is measured on motions and responses: extremes, amplitudes in a window of time, kinds of growth, narrow peaks.

use arithmetic::{Complex, Interval, Rational, Unwatched, rational, significant_digits};
use models::platoon::banded::BandedPlatoon;
use models::platoon::growth::{Growth, LARGEST_PEAK, peak, peak_of_car};
use models::platoon::observe::{largest, measured_amplitude, measured_resonance};
use models::platoon::time_domain::Modes;
use models::platoon::{
    Communication, CommunicationGraph, Gains, PeakError, Platoon, next_order, peak_on_graph, resonance, theorem1,
};
use std::cell::RefCell;
use std::f64::consts::PI;

fn floats(f: f64, g: f64) -> Gains<f64> {
    Gains { f, g }
}

fn two_sided(followers: usize) -> CommunicationGraph {
    CommunicationGraph::of(Communication::FrontAndBack, followers).unwrap()
}

/// First the points of the grid, then sections within a step of the best one; ends of the interval count.
#[test]
fn the_largest_value_is_looked_for_on_the_grid_first() {
    let parabola = |x: f64| 7.0 - (x - 2.25) * (x - 2.25);
    let asked = RefCell::new(Vec::new());
    let found = largest((1.0, 3.0), 4, |x| {
        asked.borrow_mut().push(x);
        Ok::<f64, ()>(parabola(x))
    });
    assert!(found.is_ok_and(|found| (found.at - 2.25).abs() < 1e-7 && (found.value - 7.0).abs() < 1e-13));
    let asked = asked.into_inner();
    assert_eq!(asked[..5], [1.0, 1.5, 2.0, 2.5, 3.0]);
    // 2 and 5/2 are equally good: sections around the first of them.
    assert!(asked.len() > 20 && asked[5..].iter().all(|x| (1.5..=2.5).contains(x)));
    let of = |f: fn(f64) -> f64, samples| {
        let found = largest((1.0, 3.0), samples, |x| Ok::<f64, ()>(f(x))).unwrap();
        (found.at, found.value)
    };
    assert_eq!((of(|x| -x, 4), of(|x| x, 4)), ((1.0, -1.0), (3.0, 3.0)));
    // Without samples the whole interval is one step.
    assert!((of(|x| -(x - 2.25).abs(), 0).0 - 2.25).abs() < 1e-7);
    assert_eq!(largest((0.0, 1.0), 3, |x| if x > 0.5 { Err(x) } else { Ok(x) }), Err(2.0 / 3.0));
}

/// The amplitude in the last period, against many instants; the first half of a period is a window of its own.
#[test]
fn amplitudes_are_measured_in_the_last_period() {
    let modes = Modes::new(&floats(-1.0, -0.6), 4).unwrap();
    // At the last frequencies what is left of the start still dies out.
    for (w, periods) in [(0.3, 1.0), (0.3, 3.5), (0.9, 2.0), (0.25, 0.5), (0.9, 6.0), (1.5, 4.0)] {
        let start = modes.behind_harmonic_leader(&w).unwrap();
        let (from, to) = (((periods - 1.0) / w).max(0.0) * 2.0 * PI, periods / w * 2.0 * PI);
        let at = |k: u32| start.last(&(from + (to - from) * f64::from(k) / 4000.0)).unwrap().abs();
        let naive = (0..=4000).map(at).fold(0.0, f64::max);
        let found = measured_amplitude(&modes, w, periods).unwrap();
        assert!(found >= naive - 1e-12 && found - naive < 1e-6, "{w} {periods}: {found} {naive}");
    }
}

/// From half of the place to one and a half times of it: a guess may be that far off.
#[test]
fn a_resonance_is_measured_near_a_rough_guess() {
    let gains = floats(-1.0, -1.0);
    let known = resonance(&Gains { f: rational(-1, 1), g: rational(-1, 1) }, 3, 12).unwrap();
    let (at, value) = (known.omega.to_f64(), known.amplitude.to_f64());
    for share in [0.7, 1.0, 1.9] {
        let found = measured_resonance(&gains, 3, share * at, 40.0).unwrap();
        assert!((found.at / at - 1.0).abs() < 1e-3 && (found.value / value - 1.0).abs() < 1e-6, "{share}: {found:?}");
    }
    let short = measured_resonance(&gains, 3, 0.6 * at, 40.0).unwrap();
    assert!((short.at / (0.9 * at) - 1.0).abs() < 1e-6, "the largest value at the end of the range: {short:?}");
    let long = measured_resonance(&gains, 3, 2.2 * at, 40.0).unwrap();
    assert!((long.at / (1.1 * at) - 1.0).abs() < 1e-6, "{long:?}");
}

/// Sizes that double, with these exponents between them.
fn of_exponents(exponents: &[f64]) -> Growth {
    let mut peaks = vec![(1.0, 3.0)];
    for exponent in exponents {
        let (size, value) = peaks[peaks.len() - 1];
        peaks.push((2.0 * size, value * 2f64.powf(*exponent)));
    }
    Growth::of(&peaks)
}

#[test]
fn kinds_of_growth_are_told_on_both_sides_of_their_bounds() {
    for (exponents, word) in [
        (&[5.0, 0.96, 1.04][..], "linear"),
        (&[5.0, 1.04, 0.96], "linear"),
        (&[5.0, 0.94, 1.0], "undecided"),
        (&[5.0, 1.0, 1.06], "undecided"),
        (&[5.0, 1.06, 1.04], "polynomial"),
        (&[5.0, 1.04, 1.06], "polynomial"),
        (&[5.0, 2.0, 2.04], "polynomial"),
        (&[5.0, 2.0, 2.06], "undecided"),
        (&[0.0, 0.0, 0.0], "polynomial"),
        (&[1.0, 1.2, 1.49], "undecided"),
        (&[1.0, 1.2, 1.51], "exponential"),
        (&[9.0, 1.0, 1.2, 1.51], "exponential"),
        (&[0.04, 0.5, 1.0], "undecided"),
        (&[0.06, 0.5, 1.0], "exponential"),
        (&[0.06, 2.0, 0.08], "undecided"),
        (&[1.0, 1.0], "undecided"),
        (&[], "undecided"),
    ] {
        assert_eq!(of_exponents(exponents).word(), word, "{exponents:?}");
    }
    assert!(matches!(of_exponents(&[5.0, 2.0, 2.04]), Growth::Power(last) if (last - 2.04).abs() < 1e-12));
    assert_eq!(LARGEST_PEAK, 1e6);
}

/// Peaks that are far narrower than any grid: half-widths down to 10^-5 of the frequency.
#[test]
fn narrow_peaks_are_found_by_their_mode() {
    for (f, g, followers) in [((-1, 1), (-1, 100), 64), ((-1, 4), (-1, 50), 33), ((-3, 1), (-1, 10), 20)] {
        let exact = Gains { f: rational(f.0, f.1), g: rational(g.0, g.1) };
        let gains = floats(f.0 as f64 / f.1 as f64, g.0 as f64 / g.1 as f64);
        let graph = two_sided(followers);
        let known = resonance(&exact, followers as u64, 12).unwrap();
        let own = vec![gains.clone(); followers];
        let last = peak_of_car(&Platoon::new(graph.clone(), own.clone()).unwrap(), followers).unwrap().unwrap();
        assert!((last.value / known.amplitude.to_f64() - 1.0).abs() < 1e-9, "{last:?} {known:?}");
        assert!((last.at / known.omega.to_f64() - 1.0).abs() < 1e-6);
        let any = peak(&graph, &gains).unwrap().unwrap();
        assert!(any.value >= last.value * (1.0 - 1e-12) && (any.at / last.at - 1.0).abs() < 1e-3);
    }
}

/// Two cars that track each other, the first with a little weight for the leader: `lambda = 1 - sqrt(1 - weight)`, about half of it.
#[test]
fn modes_below_one_part_in_a_thousand_million_are_given_up() {
    let found = |weight: i64| {
        let weight = rational(weight, 10_000_000_000);
        let rest = rational(1, 1) - &weight;
        let graph = CommunicationGraph::new(vec![vec![(0, weight), (2, rest)], vec![(1, rational(1, 1))]]).unwrap();
        peak(&graph, &floats(-1.0, -1.0)).unwrap().is_some()
    };
    assert!(found(22) && found(30) && !found(18) && !found(10));
}

/// `lambda = 1 - cos(pi/(2M))` of the two-sided platoon; 1, as many times as there are cars, of the one-sided one.
#[test]
fn the_smallest_eigenvalue_is_known() {
    for followers in [1usize, 2, 5, 40] {
        let (value, change) = BandedPlatoon::new(&two_sided(followers)).smallest_eigenvalue().unwrap();
        let known = 2.0 * (PI / (4 * followers) as f64).sin().powi(2);
        assert!((value / known - 1.0).abs() < 1e-11 && change < 1e-11, "{followers}: {value} {known} {change}");
    }
    let front = CommunicationGraph::of(Communication::Front, 1).unwrap();
    assert_eq!(BandedPlatoon::new(&front).smallest_eigenvalue(), Ok((1.0, 0.0)));
    // Three cars in a circle, the first also behind the leader: 1 - cbrt(9/10), beside a pair of complex ones.
    let circle = CommunicationGraph::new(vec![
        vec![(0, rational(1, 10)), (3, rational(9, 10))],
        vec![(1, rational(1, 1))],
        vec![(2, rational(1, 1))],
    ]);
    let (value, _) = BandedPlatoon::new(&circle.unwrap()).smallest_eigenvalue().unwrap();
    assert!((value - (1.0 - 0.9f64.cbrt())).abs() < 1e-12);
    let alone = CommunicationGraph::with_equal_weights(&[vec![0], vec![]]).unwrap();
    assert!(BandedPlatoon::new(&alone).smallest_eigenvalue().is_err());
}

/// Without damping at `w² = |f|` the diagonal of the system vanishes: rows have to be swapped.
#[test]
fn pivots_that_vanish_are_swapped() {
    let exact = Gains { f: rational(-1, 1), g: rational(0, 1) };
    for followers in [2usize, 4, 6] {
        let known = two_sided(followers).response(&exact, &rational(1, 1)).unwrap();
        let found = BandedPlatoon::new(&two_sided(followers)).response(&floats(-1.0, 0.0), 1.0).unwrap();
        for (found, known) in found.iter().zip(known) {
            let known = num_traits::ToPrimitive::to_f64(&known.re).unwrap();
            assert!((found.re - known).abs() < 1e-12 && found.im.abs() < 1e-12, "{followers}: {found:?} {known}");
        }
    }
}

#[test]
fn the_largest_amplitude_is_that_of_any_car() {
    let gains = floats(-1.0, -0.5);
    let banded = BandedPlatoon::new(&two_sided(5));
    for w in [0.05, 0.3, 0.8, 1.7, 4.0] {
        let sizes = banded.response(&gains, w).unwrap().iter().map(|z| z.re.hypot(z.im)).fold(0.0, f64::max);
        assert!((banded.largest_amplitude(&gains, w).unwrap() - sizes).abs() < 1e-14 * sizes);
    }
}

/// The motion of a mode behind `e^{iwt}` is `p e^{iwt}` with `p (w² + lambda (f + iwg)) = (f + iwg) sin(phi)/2`; the bound of what is left
/// adds up `(2/M) |p| (1 + (decay + w)/frequency) e^{-rate t}`.
#[test]
fn the_bound_of_the_transient_is_the_sum_over_the_modes() {
    for (f, g, followers, w) in [(-1.0f64, -1.0f64, 4u64, 0.3), (-0.5, -6.0, 3, 0.8), (-2.0, -0.3, 1, 1.1)] {
        let start = Modes::new(&floats(f, g), followers).unwrap().behind_harmonic_leader(&w).unwrap();
        for t in [0.0, 0.7, 5.0, 40.0] {
            let mode = |k: u64| {
                let phi = (2 * k - 1) as f64 * PI / (2 * followers) as f64;
                let lambda = 1.0 - phi.cos();
                let (re, im) = (w * w + lambda * f, lambda * w * g);
                let p = 0.5 * phi.sin() * f.hypot(w * g) / re.hypot(im);
                let (decay, square) = (-0.5 * lambda * g, 0.25 * lambda * lambda * g * g + lambda * f);
                let frequency = square.abs().sqrt();
                let rate = if square > 0.0 { decay - frequency } else { decay };
                2.0 / followers as f64 * p * (1.0 + (decay + w) / frequency) * (-rate * t).exp()
            };
            let naive: f64 = (1..=followers).map(mode).sum();
            let found = start.transient_bound(&t).unwrap();
            assert!((found / naive - 1.0).abs() < 1e-10, "{f} {g} {followers} at {t}: {found} {naive}");
        }
    }
}

/// A leader that starts, goes on evenly and brakes: parabolas and lines, and nothing before the first change.
#[test]
fn the_leader_drives_as_its_accelerations_say() {
    let modes = Modes::new(&floats(-1.0, -1.0), 2).unwrap();
    let start = modes.behind_accelerating_leader(&[(1.0, 2.0), (3.0, -3.0), (4.0, 1.0)]).unwrap();
    for (t, position, velocity) in
        [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (2.0, 1.0, 2.0), (3.0, 4.0, 4.0), (4.0, 7.5, 3.0), (6.0, 13.5, 3.0)]
    {
        assert_eq!(start.leader(&t), Ok((position, velocity)));
    }
    let still = start.deviations(&1.0).unwrap();
    assert!(still.positions.iter().chain(&still.velocities).all(|x| *x == 0.0) && start.last(&0.5) == Ok(0.0));
    // A time that may be before or after a change.
    let number = |x: i64| Interval::from_rational(&rational(x, 3), 60);
    let modes = Modes::new(&Gains { f: number(-3), g: number(-3) }, 2).unwrap();
    let start = modes.behind_accelerating_leader(&[(number(1), number(3))]).unwrap();
    assert!(start.leader(&number(1)).is_err() && start.leader(&number(2)).is_ok());
}

/// The formulas with `b² = g²/|f|` and `a0² = pi²/(8 M²)`, in floats, and the errors that are stated, at the smallest sizes too.
#[test]
fn the_next_order_is_its_formula_and_keeps_its_bounds() {
    assert_eq!(
        (next_order::SMALLEST_SIZE, next_order::FREQUENCY_BOUND, next_order::AMPLITUDE_BOUND),
        (5, (17, 10), (11, 1))
    );
    for (f, g) in [((-1, 1), (-1, 1)), ((-3, 2), (-1, 5)), ((-1, 3), (-2, 1)), ((-9, 1), (-1, 1))] {
        let exact = Gains { f: rational(f.0, f.1), g: rational(g.0, g.1) };
        let (f, g) = (f.0 as f64 / f.1 as f64, g.0 as f64 / g.1 as f64);
        let (gains, b2) = (floats(f, g), -g * g / f);
        assert!((next_order::relative_damping_square(&gains).unwrap() - b2).abs() < 1e-14);
        for followers in [5u64, 7, 20, 100] {
            let a2 = PI * PI / (8 * followers * followers) as f64;
            assert!((next_order::square_of_leading(&1.0, followers).unwrap() / a2 - 1.0).abs() < 1e-14);
            let (w, a) =
                (next_order::frequency(&gains, followers).unwrap(), next_order::amplitude(&gains, followers).unwrap());
            let w0 = (-f).sqrt() * PI / (2.0 * 2f64.sqrt() * followers as f64);
            let a0 = 8.0 * (-2.0 * f).sqrt() * followers as f64 / (-g * PI * PI);
            assert!((w / (w0 * (1.0 - a2 * (1.0 / 12.0 + b2 / 8.0))) - 1.0).abs() < 1e-13);
            let share = 1.0 / 12.0 - 3.0 * b2 / 8.0 + PI * PI * b2 / 96.0;
            assert!((a / (a0 * (1.0 - a2 * share)) - 1.0).abs() < 1e-13);
            let b = b2.sqrt().max(1.0);
            if followers as f64 >= 5.0 * b {
                let known = resonance(&exact, followers, 15).unwrap();
                let unit = (a2 * b * b).powi(2);
                assert!((known.omega.to_f64() - w).abs() <= 1.7 * unit * w0, "{f} {g} {followers}");
                assert!((known.amplitude.to_f64() - a).abs() <= 11.0 * unit * a0, "{f} {g} {followers}");
            }
        }
        assert!(
            (theorem1::frequency(&gains, 4).unwrap() / ((-f).sqrt() * PI / (8.0 * 2f64.sqrt())) - 1.0).abs() < 1e-14
        );
    }
    assert!(next_order::square_of_leading(&1.0, 0).is_err() && next_order::frequency(&floats(-1.0, -1.0), 0).is_err());
}

/// The bands of a graph that is not symmetric, with entries far from the diagonal on one side only, against the equations of the amplitudes.
#[test]
fn bands_of_any_width_solve_the_equations() {
    let graphs = [
        CommunicationGraph::with_equal_weights(&[vec![0, 4], vec![0, 1], vec![1, 5], vec![3], vec![2, 4]]).unwrap(),
        CommunicationGraph::with_equal_weights(&[vec![0], vec![0, 1], vec![0, 1, 2], vec![1]]).unwrap(),
        CommunicationGraph::with_equal_weights(&[vec![2, 3, 4], vec![3], vec![4], vec![0]]).unwrap(),
        // A pivot that vanishes at first: car 1 tracks nobody.
        CommunicationGraph::with_equal_weights(&[vec![0, 2], vec![1, 3], vec![0, 2]]).unwrap(),
    ];
    let gains = floats(-0.7, -0.2);
    for (graph, w) in graphs.iter().flat_map(|graph| [0.2, 0.9, 3.0].map(|w| (graph, w))) {
        let all = BandedPlatoon::new(graph).response(&gains, w).unwrap();
        for k in 1..=graph.followers() {
            let amplitude = |agent: usize| if agent == 0 { Complex::real(1.0) } else { all[agent - 1].clone() };
            let tracked = graph.tracked_by(k);
            let share = 1.0 / tracked.len() as f64;
            let mean = tracked.iter().fold(Complex::real(0.0), |sum, (agent, _)| sum + amplitude(*agent).scale(&share));
            let force = Complex::new(gains.f, gains.g * w) * &(amplitude(k) - mean);
            assert!((force + amplitude(k).scale(&(w * w))).norm_squared() < 1e-24, "{graph:?} {w} {k}");
        }
    }
}

/// Place and height have as many digits as asked for, among several maxima and minima; platoons that are not stable have no peak.
#[test]
fn peaks_on_graphs_are_enclosed_with_their_places() {
    let gains = |f: (i64, i64), g: (i64, i64)| Gains { f: rational(f.0, f.1), g: rational(g.0, g.1) };
    let peak = |own: &Gains<Rational>, followers: usize, digits: u32| {
        peak_on_graph(&two_sided(followers), &vec![own.clone(); followers], followers, digits, &Unwatched)
    };
    for (own, followers) in [(gains((-1, 1), (-1, 20)), 4), (gains((-3, 2), (-1, 9)), 6), (gains((-1, 3), (-7, 1)), 3)]
    {
        for digits in [5, 12, 29] {
            let found = peak(&own, followers, digits).unwrap();
            let omega = found.omega.unwrap();
            let known = resonance(&own, followers as u64, 30).unwrap();
            assert!(omega.overlaps(&known.omega) && found.amplitude.overlaps(&known.amplitude));
            assert!(significant_digits(&omega) >= digits && significant_digits(&found.amplitude) >= digits);
        }
    }
    for (f, g) in [((0, 1), (-1, 1)), ((-1, 1), (0, 1)), ((1, 1), (-1, 1)), ((-1, 1), (1, 1)), ((1, 1), (1, 1))] {
        assert_eq!(peak(&gains(f, g), 2, 12).unwrap_err(), PeakError::NotStable, "{f:?} {g:?}");
    }
}

/// Twelve cars that each track the car in front swing most at the last of them, far above the frequency of the slow modes of the thirty cars
/// behind, who track both sides: against a fine grid of frequencies.
#[test]
fn peaks_far_from_the_slow_mode_are_found() {
    let tracked = |k: usize| match k {
        0..=11 => vec![k],
        41 => vec![41],
        _ => vec![k, k + 2],
    };
    let graph = CommunicationGraph::with_equal_weights(&(0..42).map(tracked).collect::<Vec<_>>()).unwrap();
    for (f, g) in [(-1.0, -1.0), (-4.0, -1.0), (-0.25, -0.4)] {
        let gains = floats(f, g);
        let banded = BandedPlatoon::new(&graph);
        let at = |k: u32| 0.002 * 1.0005f64.powi(k as i32) * f64::sqrt(-f);
        let best = |of: &dyn Fn(f64) -> f64| (0..15_000).step_by(3).map(|k| of(at(k))).fold(0.0, f64::max);
        let found = peak(&graph, &gains).unwrap().unwrap();
        let naive = best(&|w| banded.largest_amplitude(&gains, w).unwrap());
        assert!(found.value >= naive && found.value < naive * (1.0 + 1e-4), "{f} {g}: {found:?} {naive}");
        assert!((banded.largest_amplitude(&gains, found.at).unwrap() / found.value - 1.0).abs() < 1e-12);
        let own = vec![gains.clone(); 42];
        let car = peak_of_car(&Platoon::new(graph.clone(), own.clone()).unwrap(), 12).unwrap().unwrap();
        // One car after the other: the gain of one to the power 12.
        let one = |w: f64| {
            let (fs, gs) = (w * w + f, g * w);
            (f.hypot(gs) / fs.hypot(gs)).powi(12)
        };
        let known = best(&one);
        assert!(car.value >= known && car.value < known * (1.0 + 1e-4), "{f} {g}: {car:?} {known}");
    }
    // The strongest gains reach up to their own frequencies: the first car is far stiffer than the others, with little damping.
    let mut own = vec![floats(-1.0, -2.0); 6];
    own[0] = floats(-100.0, -0.5);
    let found = peak_of_car(&Platoon::new(two_sided(6), own.to_vec()).unwrap(), 1).unwrap().unwrap();
    let banded = BandedPlatoon::new(&two_sided(6));
    let size = |w: f64| banded.response_of_cars(&own, w).map(|all| all[0].re.hypot(all[0].im)).unwrap();
    let naive = (1..30_000).map(|k| size(f64::from(k) * 5e-4)).fold(0.0, f64::max);
    assert!(
        found.value >= naive * (1.0 - 1e-9) && found.value < naive * (1.0 + 1e-3) && found.at > 5.0,
        "{found:?} {naive}"
    );
}
