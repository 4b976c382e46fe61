//! Large flocks by cells against the law over all pairs.

use arithmetic::rational;
use models::double_integrator::{
    Coordinates, FlockError, Potential, State, SwitchingFlock, Vector, linked_within, velocity_alignment,
};
use motion::{IntegrationError, Rk4, Tolerance, VectorField, integrate};
use proptest::prelude::*;

const PLANE: Coordinates = Coordinates::Cartesian;

fn potentials() -> [Potential; 4] {
    [
        Potential::inverse_square_log(&rational(1, 1)),
        Potential::inverse_square_spring(&rational(3, 2), &rational(1, 3)),
        Potential::with_inflection(&rational(2, 1)),
        // A spring: agents in the same place do no harm.
        Potential::new(vec![(0, rational(1, 2))], (rational(0, 1), rational(0, 1))),
    ]
}

/// The law over all pairs, and the sum of the sizes of its terms for every agent.
fn naive(state: &State<f64>, potential: &Potential, radius: f64) -> Option<(Vec<Vector<f64>>, Vec<f64>)> {
    let edges = linked_within(&state.positions, &(radius * radius), PLANE).edges();
    let slope = |_: usize, _: usize, s: &f64| potential.slope(s);
    let accelerations = velocity_alignment(state, &edges, PLANE, slope).ok()?;
    let mut sizes = vec![0.0; state.count()];
    for &(i, j) in &edges {
        let (r, v) = (state.separation(i, j), state.relative_velocity(i, j));
        let s = PLANE.square(&r);
        // The slopes are sums of powers from -2 to 2 with coefficients below 10.
        let powers = if s > 0.0 { s * s + 1.0 / (s * s) } else { 1.0 };
        let size = 50.0 * powers * s.sqrt() + PLANE.square(&v).sqrt();
        sizes[i] += size;
        sizes[j] += size;
    }
    Some((accelerations, sizes))
}

fn assert_law(state: &State<f64>, radius: f64) {
    for potential in potentials() {
        let mut flock = SwitchingFlock::new(&potential, radius).expect("a radius");
        let mut found = vec![[0.0; 2]; state.count()];
        let result = flock.accelerations(&state.positions, &state.velocities, &mut found);
        let Some((exact, sizes)) = naive(state, &potential, radius) else {
            assert!(matches!(result, Err(FlockError::Coincident(..))), "{result:?}");
            continue;
        };
        assert_eq!(result, Ok(()));
        // A few roundings of each term, and of sums of at most as many as there are agents.
        for ((a, b), size) in found.iter().zip(&exact).zip(&sizes) {
            let bound = (state.count() as f64 + 30.0) * f64::EPSILON * size;
            assert!((a[0] - b[0]).abs() <= bound && (a[1] - b[1]).abs() <= bound, "{a:?} {b:?} {bound}");
        }
    }
}

fn lattice(columns: usize, rows: usize, spread: f64) -> State<f64> {
    let waves = |k: usize, f: f64| (k as f64 * f).sin();
    let place = |k: usize| {
        [(k % columns) as f64 + spread * waves(k, 12.9898), (k / columns) as f64 + spread * waves(k, 78.233)]
    };
    let agents = 0..columns * rows;
    let velocities = agents.clone().map(|k| [waves(k, 3.7), waves(k, 9.1)]).collect();
    State { positions: agents.map(place).collect(), velocities }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_law_over_all_pairs(
        agents in prop::collection::vec((-40i32..40, -12i32..12, -9i32..9, -9i32..9), 0..90),
        radius in prop_oneof![Just(1.0), Just(2.0), 0.3f64..12.0, Just(100.0)],
        stretch in prop_oneof![Just(1.0), Just(0.07), Just(30.0)],
    ) {
        let positions = agents.iter().map(|a| [f64::from(a.0) / 4.0 * stretch, f64::from(a.1) / 3.0]).collect();
        let velocities = agents.iter().map(|a| [f64::from(a.2), f64::from(a.3) / 7.0]).collect();
        assert_law(&State { positions, velocities }, radius);
    }
}

#[test]
fn lattices_rows_and_columns() {
    for (columns, rows) in [(1, 1), (2, 1), (3, 1), (1, 40), (40, 1), (17, 23)] {
        for radius in [0.5, 1.0, 1.5, 2.0, 50.0] {
            assert_law(&lattice(columns, rows, 0.0), radius);
            assert_law(&lattice(columns, rows, 0.2), radius);
        }
    }
}

#[test]
fn results_do_not_depend_on_the_threads() {
    // Fewer and more than are copied by several processors.
    for (columns, rows) in [(40, 30), (100, 90)] {
        let start = lattice(columns, rows, 0.2);
        let run = || {
            let mut flock = SwitchingFlock::new(&potentials()[0], 2.0).expect("a radius");
            let (mut state, mut method) = (start.to_list(), Rk4::new(4 * start.count()));
            (0..5).for_each(|k| method.step(&mut flock, f64::from(k) * 0.01, 0.01, &mut state));
            assert_eq!(flock.take_failure(), None);
            state
        };
        let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let alone = pool(1).install(run);
        assert!([2, 3].iter().all(|&threads| pool(threads).install(run) == alone));
        let mean = |list: &[f64]| list[2 * start.count()..].iter().sum::<f64>();
        assert!((mean(&alone) - mean(&start.to_list())).abs() < 1e-9);
        assert_eq!(State::from_list(start.count(), &start.to_list()), Some(start));
    }
}

#[test]
fn what_has_no_accelerations_is_refused() {
    let potential = &potentials()[0];
    let build = |radius| SwitchingFlock::new(potential, radius).map(|_| ());
    assert_eq!(build(0.0), Err(FlockError::Radius(0.0)));
    assert!(matches!(build(f64::NAN), Err(FlockError::Radius(_))));
    assert_eq!(build(1e200), Err(FlockError::Radius(1e200)));
    let huge = Potential::new(vec![(0, rational(10, 1).pow(400))], (rational(1, 1), rational(0, 1)));
    assert_eq!(SwitchingFlock::new(&huge, 1.0).map(|_| ()), Err(FlockError::Potential));
    let mut flock = SwitchingFlock::new(potential, 2.0).expect("a radius");
    let mut start = |positions: &[Vector<f64>], velocities: &[Vector<f64>]| {
        flock.start(&State { positions: positions.to_vec(), velocities: velocities.to_vec() })
    };
    let still = [[0.0; 2]; 3];
    assert_eq!(start(&[], &[]), Ok(vec![]));
    let pair = [[1.0, 2.0], [1.5, 2.0], [1.0, 2.0]];
    assert_eq!(start(&pair, &still), Err(FlockError::Coincident(0, 2)));
    assert_eq!(start(&[[0.0, f64::NAN], [1.0, 1.0], [2.0, 1.0]], &still), Err(FlockError::Position(0)));
    assert_eq!(start(&[[0.0, 0.0], [1.0, 1.0]], &[[0.0; 2], [0.0, f64::INFINITY]]), Err(FlockError::Velocity(1)));
    assert_eq!(start(&[[0.0, 0.0]], &still), Err(FlockError::Length { positions: 2, velocities: 6 }));
    assert_eq!(start(&[[0.0, 0.0], [1e-110, 0.0]], &still[..2]), Err(FlockError::Acceleration(0)));
    // As a field: no rate and a reason, and an integrator that stops.
    let mut rate = [0.0; 8];
    flock.rate(0.0, &[1.0; 8], &mut rate);
    assert!(rate.iter().all(|x| x.is_nan()));
    assert_eq!(flock.take_failure(), Some(FlockError::Coincident(0, 1)));
    assert_eq!(flock.take_failure(), None);
    flock.rate(0.0, &[1.0; 6], &mut rate[..6]);
    assert_eq!(flock.take_failure(), Some(FlockError::Length { positions: 3, velocities: 3 }));
    let tolerance = Tolerance { relative: 1e-9, absolute: 1e-9 };
    let stopped = integrate(&mut flock, 0.0, &[1.0; 8], &[1.0], tolerance);
    assert_eq!(stopped, Err(IntegrationError::Stuck(0.0)));
}

/// A velocity that is too large in one coordinate only, for few and for many agents; the first agent that has no acceleration is named, and of
/// those in its place the first.
#[test]
fn the_first_agent_without_an_acceleration_is_named() {
    let potential = &potentials()[0];
    for (columns, rows) in [(5, 4), (100, 90)] {
        let good = lattice(columns, rows, 0.2);
        let refused = |change: &dyn Fn(&mut State<f64>)| {
            let mut state = good.clone();
            change(&mut state);
            SwitchingFlock::new(potential, 1.3).expect("a radius").start(&state).map(|list| list.len())
        };
        assert_eq!(refused(&|_| {}), Ok(4 * columns * rows));
        for axis in [0, 1] {
            let fast = |a: usize, b: usize| {
                refused(&|state| (state.velocities[a][axis], state.velocities[b][axis]) = (1.7e308, -1.7e308))
            };
            assert_eq!(fast(7, 8), Err(FlockError::Acceleration(7)));
            assert_eq!(fast(8, 7), Err(FlockError::Acceleration(7)));
        }
        let together = |places: &[(usize, usize)]| {
            refused(&|state| places.iter().for_each(|&(to, from)| state.positions[to] = state.positions[from]))
        };
        assert_eq!(together(&[(13, 12)]), Err(FlockError::Coincident(12, 13)));
        assert_eq!(together(&[(19, 3)]), Err(FlockError::Coincident(3, 19)));
        assert_eq!(together(&[(19, 11), (17, 11), (18, 12)]), Err(FlockError::Coincident(11, 17)));
        assert_eq!(
            refused(&|state| state.velocities.truncate(columns * rows - 1)),
            Err(FlockError::Length { positions: 2 * columns * rows, velocities: 2 * columns * rows - 2 })
        );
    }
    // As a field: the rates of positions are the velocities, and another length of the list is refused.
    let state = lattice(3, 2, 0.1);
    let mut flock = SwitchingFlock::new(potential, 1.3).expect("a radius");
    let (list, mut rate) = (state.to_list(), vec![0.0; 24]);
    flock.rate(0.0, &list, &mut rate);
    assert_eq!(rate[..12], list[12..]);
    assert_eq!(flock.take_failure(), None);
    for length in [2, 6, 10] {
        flock.rate(0.0, &list[..length], &mut rate[..length]);
        let failure = FlockError::Length { positions: length / 2, velocities: length / 2 };
        assert_eq!(flock.take_failure(), Some(failure));
    }
    let mut few = vec![[0.0; 2]; 5];
    assert!(flock.accelerations(&state.positions, &state.velocities, &mut few).is_err());
    for radius in [-1.0, 0.0, 1e150, f64::INFINITY] {
        assert_eq!(SwitchingFlock::new(potential, radius).map(|_| ()), Err(FlockError::Radius(radius)));
    }
    assert!(SwitchingFlock::new(potential, 9e149).is_ok());
}

/// The first agent without an acceleration is named wherever it is: in each place of a lattice the number 0 is next to the number 1, and the two are too
/// fast for each other.
#[test]
fn the_first_agent_is_named_in_every_place() {
    let good = lattice(5, 4, 0.2);
    let mut flock = SwitchingFlock::new(&potentials()[0], 1.3).expect("a radius");
    let (mut found, count) = (0, good.count());
    for (first, second) in (0..count).flat_map(|i| (0..count).map(move |j| (i, j))) {
        if first == second || PLANE.square(&good.separation(first, second)) > 1.4 {
            continue;
        }
        let mut state = good.clone();
        state.positions.swap(0, first);
        state.positions.swap(1, if second == 0 { first } else { second });
        (state.velocities[0][0], state.velocities[1][0]) = (1.7e308, -1.7e308);
        assert_eq!(flock.start(&state), Err(FlockError::Acceleration(0)), "{first} {second}");
        found += 1;
    }
    assert!(found > 40, "{found}");
    // One coefficient of the potential that is too large, of two.
    let large = rational(10, 1).pow(400);
    for slope in [vec![(0, large.clone()), (-2, rational(-1, 1))], vec![(0, rational(1, 1)), (-2, -large)]] {
        let potential = Potential::new(slope, (rational(1, 1), rational(0, 1)));
        assert_eq!(SwitchingFlock::new(&potential, 1.0).map(|_| ()), Err(FlockError::Potential));
    }
}
