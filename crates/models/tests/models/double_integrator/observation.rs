//! What is seen of flocks, and the setups of the papers' simulations.

use algebra::graph::Graph;
use arithmetic::rational;
use models::double_integrator::{Alignment, Flock, HeadingReading, LinkRule, Network, Potential, Setup, State};
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
