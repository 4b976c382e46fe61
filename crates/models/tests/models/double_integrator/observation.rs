//! What is seen of flocks, and the setups of the papers' simulations.

use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Unwatched, rational};
use models::double_integrator::{
    Alignment, Flock, HeadingReading, LinkRule, Network, Observation, Potential, Sample, Setup, State, Trial,
};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

fn log() -> Potential {
    Potential::inverse_square_log(&rational(1, 1))
}

/// Two agents without link pass each other at distance 1, between samples.
#[test]
fn the_closest_approach_is_found_between_samples() {
    let start = State { positions: vec![[0.0, 0.0], [10.0, 1.0]], velocities: vec![[1.0, 0.0], [-1.0, 0.0]] };
    let flock = Flock::new(Alignment::Velocity, log(), Network::Fixed(Graph::empty(2)), start).unwrap();
    let trial = flock.trial(9.0, Some(3.0), &Setup::OPTIONS).unwrap();
    assert!((trial.closest - 1.0).abs() < 1e-9, "{}", trial.closest);
    assert!((trial.end.least_distance - 65f64.sqrt()).abs() < 1e-9);
    assert_eq!((trial.end.components, trial.end.links, trial.end.pairs), (2, 0, 1));
    assert!(!trial.stayed_connected && trial.energy_fell);
    assert!((trial.end.heading_spread - std::f64::consts::PI).abs() < 1e-12);
    assert!((trial.end.disagreement - 2f64.sqrt()).abs() < 1e-12 && trial.end.component_disagreement == 0.0);
}

/// A pair at the desired distance: nothing moves, V = 1.
#[test]
fn a_pair_at_rest() {
    let start = State { positions: vec![[0.0, 0.0], [1.0, 0.0]], velocities: vec![[0.5, 0.0], [0.5, 0.0]] };
    let flock = Flock::new(Alignment::Velocity, log(), Network::Within(2.0), start).unwrap();
    let trial = flock.trial(1.0, None, &Setup::OPTIONS).unwrap();
    for seen in [trial.start, trial.end] {
        assert!((seen.potential - 1.0).abs() < 1e-9 && (seen.energy - 1.25).abs() < 1e-9 && seen.gradient < 1e-9);
        assert!(seen.is_formation(1e-9, 1e-6, 1.0) && (seen.radius - 0.5).abs() < 1e-9);
    }
    assert!(trial.stayed_connected);
}

/// A pair that is pulled apart loses its link, and keeps Q but for the work of alignment.
#[test]
fn losing_the_link_is_noticed() {
    let start = State { positions: vec![[0.0, 0.0], [1.5, 0.0]], velocities: vec![[-20.0, 0.0], [20.0, 0.0]] };
    let flock = Flock::new(Alignment::Velocity, log(), Network::Within(2.0), start).unwrap();
    let trial = flock.trial(1.0, None, &Setup::OPTIONS).unwrap();
    assert!(!trial.stayed_connected && trial.energy_fell && trial.end.components == 2);
}

#[test]
fn setups_keep_to_their_ranges() {
    let mut random = ChaCha8Rng::seed_from_u64(7);
    let norm = |v: &[f64; 2]| v[0].hypot(v[1]);
    for reading in HeadingReading::ALL {
        let flock = Setup::heading_alignment(true, reading).draw(&mut random).unwrap();
        let top = if reading == HeadingReading::Slow { 1.0 } else { 20.0 };
        assert!(flock.start().positions.iter().all(|r| norm(r) <= 20.0));
        assert!(flock.start().velocities.iter().all(|v| norm(v) <= top));
        assert!(flock.start().velocities.iter().any(|v| norm(v) > top / 2.0));
        assert_eq!(flock.links_at_start().len(), 45);
    }
    for _ in 0..20 {
        let within = LinkRule::Within { radius: Setup::RADIUS, connected: true };
        let flock = Setup::velocity_alignment(within).draw(&mut random).unwrap();
        assert!(flock.start().positions.iter().flatten().all(|x| x.abs() <= 2.5));
        let links = flock.links_at_start();
        assert!(Graph::from_edges(10, &links).unwrap().is_connected());
        let sparse = Setup::velocity_alignment(LinkRule::Random(0.25)).draw(&mut random).unwrap();
        assert!(Graph::from_edges(10, &sparse.links_at_start()).unwrap().is_connected());
    }
}

/// By all pairs, also around the half turn, for headings in any turn.
#[test]
fn the_spread_of_headings_is_the_largest_difference_of_two() {
    use models::double_integrator::heading_spread;
    use std::f64::consts::{PI, TAU};
    let mut random = arithmetic::random::generator("test", "spread", 0);
    for case in 0..500 {
        let width = if case % 2 == 0 { 20.0 } else { 1.0 };
        let headings: Vec<f64> =
            (0..case % 7).map(|_| width * (arithmetic::random::uniform(&mut random) - 0.5) + PI).collect();
        let apart = |a: f64, b: f64| {
            let d = (a - b).rem_euclid(TAU);
            d.min(TAU - d)
        };
        let pairs = headings.iter().flat_map(|a| headings.iter().map(move |b| apart(*a, *b)));
        let naive = pairs.fold(0.0, f64::max);
        assert!((heading_spread(&headings) - naive).abs() < 1e-12, "{headings:?}");
    }
    assert_eq!((heading_spread(&[]), heading_spread(&[5.0])), (0.0, 0.0));
}

fn spring() -> Potential {
    Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1))
}

/// Five agents in two components, one at rest and one that is nobody's neighbour by distance.
#[test]
fn what_is_seen_is_what_the_definitions_say() {
    let state = State {
        positions: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 2.0], [5.0, 5.0], [5.0, 4.0]],
        velocities: vec![[3.0, 0.0], [0.0, 1.0], [0.0, 0.0], [-1.0, 2.0], [1.0, 2.0]],
    };
    let sample = Sample { time: 4.0, state, links: vec![(0, 1), (0, 2), (3, 4)], energy: 9.0 };
    let seen = Observation::of(&sample, &spring()).unwrap();
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{a} {b}");
    assert_eq!((seen.time, seen.energy), (4.0, 9.0));
    assert_eq!((seen.components, seen.links, seen.pairs), (2, 3, 10));
    // The mean velocity is (3/5, 1): 5.76 + 0.36 + 0.36 + 2.56 + 0.16 and 1 + 0 + 1 + 1 + 1.
    close(seen.disagreement, 13.2f64.sqrt());
    // Means (1, 1/3) and (0, 2): 4 + 1 + 1 and 1/9 + 4/9 + 1/9, against 2.
    close(seen.component_disagreement, (6.0f64 + 6.0 / 9.0).sqrt());
    // Headings 0, pi/2, pi - atan 2 and atan 2.
    close(seen.heading_spread, std::f64::consts::PI - 2f64.atan());
    close(seen.least_distance, 1.0);
    close(seen.least_unlinked, 5f64.sqrt());
    // The mean is (11/5, 11/5), the farthest agent 3.
    close(seen.radius, (2.8f64 * 2.8 * 2.0).sqrt());
    // V' = 1 - 1/s²: 15/16 at s = 4, 0 at s = 1.
    close(seen.gradient, 2.0 * 15.0 / 16.0 * 2.0);
    close(seen.potential, 4.0 + 0.25 - 2.0);
    close(seen.density(), 0.3);
    let alone =
        Sample { state: State { positions: vec![[1.0, 2.0]], velocities: vec![[1.0, 0.0]] }, links: vec![], ..sample };
    let seen = Observation::of(&alone, &spring()).unwrap();
    assert_eq!((seen.density(), seen.pairs, seen.radius, seen.least_distance), (0.0, 0, 0.0, f64::INFINITY));
}

/// Each bound of a formation is one that is stayed below, and each counts; so are the parts of a disagreement.
#[test]
fn bounds_are_stayed_below() {
    let start = State { positions: vec![[0.0, 0.0], [2.0, 0.0]], velocities: vec![[1.0, 0.0], [0.0, 1.0]] };
    let sample = Sample { time: 0.0, state: start, links: vec![(0, 1)], energy: 0.0 };
    let seen = Observation::of(&sample, &spring()).unwrap();
    let (spread, gradient, radius) = (seen.heading_spread, seen.gradient, seen.radius);
    assert!(spread > 1.0 && gradient > 1.0 && radius == 1.0);
    assert!(seen.is_formation(1.01 * spread, 1.01 * gradient, 1.01 * radius));
    assert!(!seen.is_formation(spread, 9.0, 9.0) && !seen.is_formation(9.0, gradient, 9.0));
    assert!(!seen.is_formation(9.0, 9.0, radius));
    let end = Observation { disagreement: 3.0, component_disagreement: 2.0, ..seen };
    let start = Observation { disagreement: 4.0, component_disagreement: 50.0, ..seen };
    let trial = Trial { start, end, closest: 1.0, stayed_connected: true, energy_fell: true };
    assert_eq!([0.7, 0.75, 0.8].map(|part| trial.agrees(part)), [false, false, true]);
    assert_eq!([0.45, 0.5, 0.55].map(|part| trial.components_agree(part)), [false, false, true]);
}

/// The least distance on all cubics between samples, looked at closely.
fn closest_on_a_grid(samples: &[Sample]) -> f64 {
    let mut least = f64::INFINITY;
    let count = samples[0].state.count();
    for (i, j) in (0..count).flat_map(|j| (0..j).map(move |i| (i, j))) {
        for two in samples.windows(2) {
            let h = two[1].time - two[0].time;
            let [(r, v), (s, w)] =
                [0, 1].map(|k| (two[k].state.separation(i, j), two[k].state.relative_velocity(i, j)));
            // Hermite's polynomial by its coefficients: r + h v x + (3d - h(2v + w)) x² + (h(v + w) - 2d) x³.
            let at = |x: f64, k: usize| {
                let d = s[k] - r[k];
                r[k] + x * (h * v[k] + x * (3.0 * d - h * (2.0 * v[k] + w[k]) + x * (h * (v[k] + w[k]) - 2.0 * d)))
            };
            let turns = r[0] * v[0] + r[1] * v[1] < 0.0 && s[0] * w[0] + s[1] * w[1] > 0.0;
            for n in 0..=20_000 {
                let x = f64::from(n) / 20_000.0;
                if turns || n == 0 || n == 20_000 {
                    least = least.min(at(x, 0).hypot(at(x, 1)));
                }
            }
        }
    }
    least
}

/// Springs that swing: the least distance comes between samples, more than once.
#[test]
fn the_closest_approach_is_that_of_the_cubics() {
    let start = State {
        positions: vec![[0.0, 0.0], [2.5, 0.3], [1.0, 2.2]],
        velocities: vec![[0.4, 0.1], [-0.3, 1.0], [0.2, -1.5]],
    };
    let network = Network::Fixed(Graph::from_edges(3, &[(0, 1), (1, 2)]).unwrap());
    let flock = Flock::new(Alignment::Velocity, spring(), network, start).unwrap();
    // As many stretches as are needed for none to be longer than asked for, and at least one.
    for (until, every, steps) in [(4.0, Some(0.75), 6), (4.0, Some(1.0), 4), (4.0, Some(9.0), 1), (4.0, None, 1)] {
        let times: Vec<f64> = (0..=steps).map(|k| until * f64::from(k) / f64::from(steps)).collect();
        let samples = flock.run(until, &times, &Setup::OPTIONS, &Unwatched).unwrap().samples;
        let trial = flock.trial(until, every, &Setup::OPTIONS).unwrap();
        assert_eq!((trial.start.time, trial.end.time), (0.0, until));
        assert_eq!(trial.end, Observation::of(&samples[samples.len() - 1], &spring()).unwrap());
        let naive = closest_on_a_grid(&samples);
        assert!((trial.closest - naive).abs() < 1e-7, "{every:?}: {} {naive}", trial.closest);
    }
    assert_eq!(flock.potential(), &spring());
}

#[test]
fn samples_whose_lists_do_not_fit_are_refused() {
    let sample = |positions: Vec<[f64; 2]>, velocities: Vec<[f64; 2]>, links: Vec<(usize, usize)>| {
        let sample = Sample { time: 0.0, state: State { positions, velocities }, links, energy: 0.0 };
        Observation::of(&sample, &log())
    };
    let (here, there) = ([0.0, 0.0], [1.0, 0.0]);
    assert!(sample(vec![here, there], vec![here, here], vec![(0, 1)]).is_ok());
    let domain = |found: Result<Observation, ArithmeticError>| matches!(found, Err(ArithmeticError::Domain(_)));
    assert!(domain(sample(vec![here, there], vec![here], vec![])));
    assert!(domain(sample(vec![here], vec![here, here], vec![])));
    assert!(domain(sample(vec![here, there], vec![here, here], vec![(0, 2)])));
    assert!(domain(sample(vec![], vec![], vec![])));
}
