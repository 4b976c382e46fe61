//! Networks made from positions, zones, and runs in floating point.

use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Complex, Rational, rational};
use models::oscillator::{
    BehaviourGains, CircularGains, Everyone, Flight, Interaction, Neighbours, Sensed, State, Zone, ZoneNetworks, Zones,
    behaviour_control, circular_control, laplacian_behaviour_control, phasor,
};
use std::f64::consts::TAU;

fn places() -> Vec<Complex<Rational>> {
    [(0, 0), (3, 0), (0, 4), (3, 4), (-6, 0)].map(|(x, y)| Complex::new(rational(x, 1), rational(y, 1))).to_vec()
}

#[test]
fn ties_of_distance_count_as_near() {
    let within = Neighbours::within(&places(), &rational(4, 1));
    assert_eq!(within.of_particle(0), [1, 2]);
    assert_eq!(within.of_particle(4), [0usize; 0]);
    let within = Neighbours::within(&places(), &rational(5, 1));
    assert_eq!(within.of_particle(0), [1, 2, 3]);
}

#[test]
fn nearest_takes_the_smaller_number_of_two() {
    let nearest = Neighbours::nearest(&places(), 1);
    assert_eq!(nearest.of_particle(0), [1]);
    assert_eq!(nearest.of_particle(3), [2]);
    assert_eq!(nearest.of_particle(4), [0]);
    assert_eq!(Neighbours::nearest(&places(), 4), Neighbours::complete(5));
    assert_eq!(Neighbours::nearest(&places(), 9), Neighbours::complete(5));
}

#[test]
fn neighbours_and_matrices_are_one_operator() {
    let graph = Graph::path(5);
    let matrix = algebra::matrix::SparseMatrix::from_dense(&graph.laplacian().unwrap()).unwrap();
    assert_eq!(Neighbours::of(&graph).laplacian_of(&places()), matrix.laplacian_of(&places()));
    assert_eq!(Neighbours::circulant(4, &[2, 1]), Neighbours::complete(4));
}

#[test]
fn zones_share_their_boundaries_and_leave_out_the_blind_spot() {
    let zones =
        Zones { repulsion: 1.0, orientation: 2.0, attraction: 4.0, blind_cosine_squared: (TAU / 12.0).cos().powi(2) };
    let ahead = Complex::new(1.0, 0.0);
    let seen = |zone, x, y| zones.senses(zone, &ahead, &Complex::new(x, y));
    assert!(seen(Zone::Orientation, 2.0, 0.0) && seen(Zone::Attraction, 2.0, 0.0));
    assert!(seen(Zone::Repulsion, 0.0, 0.0) && !seen(Zone::Repulsion, -0.5, 0.0) && seen(Zone::Repulsion, -0.5, 0.5));
    for degrees in 0..360 {
        let angle = f64::from(degrees) * TAU / 360.0;
        let place = Complex::new(3.0 * angle.cos(), 3.0 * angle.sin());
        let behind = (f64::from(degrees) - 180.0).abs();
        if behind != 30.0 {
            assert_eq!(zones.senses(Zone::Attraction, &ahead, &place), behind > 30.0, "{degrees}");
        }
    }
    // Without a blind spot rounding must not make one.
    let open = Zones { blind_cosine_squared: 1.0, ..zones.clone() };
    for k in 0..1000 {
        let heading = Complex::new(f64::from(k).cos(), f64::from(k).sin());
        assert!(open.senses(Zone::Attraction, &heading, &heading.scale(&-3.0)), "{k}");
    }
    let state = State { positions: vec![Complex::new(0.0, 0.0), Complex::new(-1.5, 0.0)], phasors: vec![ahead; 2] };
    let network = zones.network(Zone::Orientation, &state);
    assert_eq!((network.of_particle(0), network.of_particle(1)), (&[][..], &[0][..]));
}

#[test]
fn networks_among_near_pairs_are_those_among_all() {
    let blind_cosine_squared = (TAU / 8.0).cos().powi(2);
    let zones = Zones { repulsion: 1.0, orientation: 2.0, attraction: 4.0, blind_cosine_squared };
    // A lattice, with ties at every boundary, and every fish with its own heading.
    let place = |k: u32| Complex::new(f64::from(k % 7), f64::from(k / 7));
    let heading = |k: u32| Complex::new(f64::from(k).cos(), f64::from(k).sin());
    let state = State { positions: (0..40).map(place).collect(), phasors: (0..40).map(heading).collect() };
    let square = |i: usize, j: usize| (state.positions[i].clone() - &state.positions[j]).norm_squared();
    let pairs: Vec<(usize, usize)> =
        (0..40).flat_map(|i| (i + 1..40).map(move |j| (i, j))).filter(|&(i, j)| square(i, j) <= 16.0).collect();
    let networks = zones.networks_among(&state, &pairs);
    assert_eq!(networks.repulsion, zones.network(Zone::Repulsion, &state));
    assert_eq!(networks.orientation, zones.network(Zone::Orientation, &state));
    assert_eq!(networks.attraction, zones.network(Zone::Attraction, &state));
}

#[test]
fn runge_kutta_follows_a_circle_with_its_order() {
    let error = |steps: usize| {
        let mut flight = Flight { positions: vec![Complex::new(0.0, 0.0)], phases: vec![0.0] };
        flight.advance((2.0 / steps as f64, steps), &Complex::new(0.25, 0.0), |_| Ok(vec![1.0])).unwrap();
        assert!((flight.phases[0] - 2.0).abs() < 1e-12);
        // On the circle around i, carried along by the drift.
        (flight.positions[0].re - 0.5 - 2f64.sin()).hypot(flight.positions[0].im - 1.0 + 2f64.cos())
    };
    let (coarse, fine) = (error(4), error(8));
    assert!(coarse < 1e-2 && fine < coarse / 8.0, "{coarse} {fine}");
}

#[test]
fn halving_the_step_divides_the_error_by_sixteen() {
    let run = |steps: usize| {
        let phases = vec![0.0, 1.0, 2.5];
        let positions = vec![Complex::new(0.0, 0.0), Complex::new(4.0, 1.0), Complex::new(-2.0, 3.0)];
        let mut flight = Flight { positions, phases };
        let gains = CircularGains { omega: 0.5, spacing: 0.6, orientation: -0.4 };
        let all = Neighbours::complete(3);
        let law = |state: &State<f64>| circular_control(&gains, &all, &all, state);
        flight.advance((8.0 / steps as f64, steps), &Complex::new(0.0, 0.0), law).unwrap();
        flight.phases
    };
    let far = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
    let (coarse, middle, fine) = (run(32), run(64), run(128));
    let ratio = far(&coarse, &middle) / far(&middle, &fine);
    assert!((8.0..32.0).contains(&ratio), "{ratio}");
}

#[test]
fn clusters_go_around_the_circle() {
    let clusters = |phases: &[f64]| {
        let flight = Flight { positions: vec![Complex::new(0.0, 0.0); phases.len()], phases: phases.to_vec() };
        flight.clusters(0.2).into_iter().map(|(size, _)| size).collect::<Vec<_>>()
    };
    assert_eq!(clusters(&[1.0, 1.0, 1.0 + TAU]), [3]);
    assert_eq!(clusters(&[0.05, TAU - 0.05, 2.0, 4.0, 4.1]), [2, 1, 2]);
    assert_eq!(clusters(&[0.0]), [1]);
    let turned = phasor(&rational(0, 1)).unwrap();
    assert_eq!(turned, Complex::real(rational(1, 1)));
}

#[test]
fn everyone_is_the_complete_network() {
    for count in 0..6 {
        let x: Vec<Complex<_>> = (0..count).map(|k| Complex::new(rational(k * k, 3), rational(1 - k, 7))).collect();
        assert_eq!(Everyone.laplacian_of(&x), Neighbours::complete(count as usize).laplacian_of(&x));
    }
    let arcs = Neighbours::from_arcs(3, [(0, 2), (0, 1), (0, 2), (1, 1), (2, 9)]);
    assert_eq!((arcs.of_particle(0), arcs.of_particle(1), arcs.of_particle(2)), (&[1, 2][..], &[][..], &[][..]));
}

#[test]
fn both_forms_of_the_fish_agree_at_unit_distance() {
    // All distances are 1: an equilateral triangle, every fish in every other's zones of orientation and attraction.
    let height = 3f64.sqrt() / 2.0;
    let positions = vec![Complex::new(0.0, 0.0), Complex::new(1.0, 0.0), Complex::new(0.5, height)];
    let phases = [0.3f64, 1.1, 4.0];
    let state = State { positions, phasors: phases.iter().map(|t| Complex::new(t.cos(), t.sin())).collect() };
    let all = Neighbours::complete(3);
    let none = Neighbours::from_arcs(3, []);
    let networks = ZoneNetworks { repulsion: none, orientation: all.clone(), attraction: all.clone() };
    let gains = BehaviourGains { repulsion: 5.0, orientation: 0.7, attraction: 0.4 };
    let behaviours = behaviour_control(&0.2, &gains, &networks, &state).unwrap();
    let laplacians = laplacian_behaviour_control(&0.2, &gains, &networks, &state);
    for (a, b) in behaviours.iter().zip(&laplacians) {
        assert!((a - b).abs() < 1e-12, "{behaviours:?} {laplacians:?}");
    }
    // By hand: a fish that swims north turns left, away from one close to its right, and right, towards one far off there.
    let north = Complex::new(0.0, 1.0);
    let state =
        State { positions: vec![Complex::new(0.0, 0.0), Complex::new(1.0, 0.0)], phasors: vec![north.clone(), north] };
    let zones =
        |repulsion: f64| Zones { repulsion, orientation: repulsion, attraction: 10.0, blind_cosine_squared: 1.0 };
    let gains = BehaviourGains { repulsion: 5.0, orientation: 0.0, attraction: 2.0 };
    let pair = [(0, 1)];
    let turn =
        |zones: &Zones<f64>| behaviour_control(&0.0, &gains, &zones.networks_among(&state, &pair), &state).unwrap()[0];
    assert_eq!((turn(&zones(2.0)), turn(&zones(0.5))), (5.0, -2.0));
    let together = State { positions: vec![Complex::new(0.0, 0.0); 2], phasors: state.phasors.clone() };
    assert!(behaviour_control(&0.0, &gains, &zones(2.0).networks_among(&together, &pair), &together).is_err());
}

/// Arcs in any order, some of them twice, to itself, or to particles that are not there.
#[test]
fn lists_of_arcs_are_networks() {
    let arcs = [(2, 1), (0, 2), (0, 1), (2, 0), (0, 2), (2, 1), (1, 1), (0, 3), (3, 0)];
    let network = Neighbours::from_arcs(3, arcs);
    assert_eq!(network, Neighbours::from_fn(3, |k, j| k != 1 && k != j));
    assert_eq!([0, 1, 2].map(|k| network.of_particle(k).to_vec()), [vec![1, 2], vec![], vec![0, 1]]);
}

/// Networks of more fish than have a place or a heading.
#[test]
fn networks_of_other_fish_are_refused() {
    let one = || Complex::new(1.0, 0.0);
    let networks = |sizes: [usize; 3]| {
        let [repulsion, orientation, attraction] = sizes.map(|n| Neighbours::from_fn(n, |_, _| true));
        ZoneNetworks { repulsion, orientation, attraction }
    };
    let gains = BehaviourGains { repulsion: 1.0, orientation: 1.0, attraction: 1.0 };
    let control = |sizes: [usize; 3], places: usize, headings: usize| {
        let state = State { positions: vec![one(); places], phasors: vec![one(); headings] };
        behaviour_control(&0.0, &gains, &networks(sizes), &state).map(drop)
    };
    assert_eq!(control([1, 1, 1], 1, 1), Ok(()));
    let refused = Err(ArithmeticError::Domain("networks of the fish of the state"));
    for sizes in [[3, 1, 1], [1, 3, 1], [1, 1, 3]] {
        for (places, headings) in [(2, 2), (2, 3), (3, 2)] {
            assert_eq!(control(sizes, places, headings), refused);
        }
    }
}

#[test]
fn a_table_of_who_senses_whom_is_the_network_of_these_arcs() {
    let senses = |k: usize, j: usize| (3 * k + j) % 4 != 1;
    let (table, lists) = (Sensed::from_fn(5, senses), Neighbours::from_fn(5, senses));
    assert!(table.arcs().eq(lists.arcs()));
    assert_eq!(table.laplacian_of(&places()), lists.laplacian_of(&places()));
    let fewer = |k: usize, j: usize| k < j;
    assert!(table.among(fewer).arcs().eq(lists.arcs().filter(|&(k, j)| fewer(k, j))));
}

/// Stepping circle centres is the same motion as stepping places; but a circular formation is followed without error at any step, where
/// Simpson's rule makes its circle too large by a share `(omega h)^4/2880`.
#[test]
fn circle_centres_follow_circles_without_error() {
    let gains = CircularGains { omega: 0.1, spacing: 0.7, orientation: -0.4 };
    let law = |state: &State<f64>| circular_control(&gains, &Everyone, &Everyone, state);
    let phases = vec![0.3, 1.1, 2.0, 4.4, 5.9];
    let spread = Flight { positions: phases.iter().map(|t| Complex::new(9.0 * t - 7.0, t * t)).collect(), phases };
    let (mut by_places, mut by_centres) = (spread.clone(), spread);
    by_places.advance((0.01, 500), &Complex::new(0.0, 0.0), law).unwrap();
    by_centres.advance_by_centres(0.1, (0.01, 500), law).unwrap();
    for (a, b) in by_places.to_list().iter().zip(by_centres.to_list()) {
        assert!((a - b).abs() < 1e-8, "{a} and {b}");
    }
    let circle = |theta: &f64| Complex::new(10.0 * theta.sin(), -10.0 * theta.cos());
    let phases = vec![0.2, 0.2 + TAU / 2.0];
    let start = Flight { positions: phases.iter().map(circle).collect(), phases };
    let turning = |state: &State<f64>| Ok(vec![0.1; state.phasors.len()]);
    let apart = |flight: &Flight| (flight.positions[0].clone() - &flight.positions[1]).norm_squared().sqrt();
    let (mut by_places, mut by_centres) = (start.clone(), start);
    by_centres.advance_by_centres(0.1, (1.0, 600), turning).unwrap();
    assert!((apart(&by_centres) - 20.0).abs() < 1e-12);
    // The method keeps the centre, so that the places are off by the share of the radius at some times.
    by_places.advance((1.0, 31), &Complex::new(0.0, 0.0), turning).unwrap();
    let share = 0.1f64.powi(4) / 2880.0;
    let largest = (0..63).map(|_| {
        by_places.advance((1.0, 1), &Complex::new(0.0, 0.0), turning).unwrap();
        apart(&by_places) / 20.0 - 1.0
    });
    let largest = largest.fold(0.0, f64::max);
    assert!(largest > share && largest < 3.0 * share, "{largest}");
    assert!(by_places.advance_by_centres(0.0, (1.0, 1), turning).is_err());
}

#[test]
fn fish_without_a_place_are_alone() {
    let zones = Zones { repulsion: 1.0, orientation: 2.0, attraction: 4.0, blind_cosine_squared: 1.0 };
    let (places, heading) = (vec![Complex::new(0.0, 0.0), Complex::new(0.5, 0.0)], Complex::new(1.0, 0.0));
    let network = |fish: usize| {
        zones.network(Zone::Repulsion, &State { positions: places.clone(), phasors: vec![heading.clone(); fish] })
    };
    assert_eq!(network(3), Neighbours::from_arcs(3, network(2).arcs().collect::<Vec<_>>()));
    assert_eq!((network(2).arcs().count(), network(1).arcs().count()), (2, 0));
}
