use arithmetic::{FloatInterval, rational};
use models::double_integrator::{Coordinates, EnclosedFlock, EnclosureError, Potential, State, velocity_alignment};
use motion::{Tolerance, integrate};

fn state(positions: &[[i64; 2]], velocities: &[[i64; 2]], unit: i64) -> State<FloatInterval> {
    let number = |x: i64| FloatInterval::from_rational(&rational(x, unit));
    let vectors = |v: &[[i64; 2]]| v.iter().map(|p| p.map(number)).collect();
    State { positions: vectors(positions), velocities: vectors(velocities) }
}

fn flock(square: Option<i64>) -> EnclosedFlock {
    EnclosedFlock {
        potential: Potential::inverse_square_log(&rational(1, 1)),
        threshold: square.map(|s| rational(s, 1)),
    }
}

#[test]
fn free_flight_meets_the_threshold_when_it_must() {
    // Distance 5 - t, linked below 2: at t = 3.
    let start = state(&[[0, 0], [5, 0]], &[[1, 0], [0, 0]], 1);
    let run = flock(Some(4)).run(&start, &[], 3.5, |_, _| {}).expect("a motion");
    let first = run.events.first().expect("an event");
    assert!(
        first.pair == (0, 1) && first.linked && first.from <= 3.0 && 3.0 <= first.to && first.to - first.from < 1e-6
    );
    assert_eq!(run.edges, vec![(0, 1)]);
}

#[test]
fn passing_close_by_is_decided() {
    // Closest distance 2 + 1/1000 and 2 - 1/1000.
    let pass = |offset: i64| state(&[[0, 0], [5000, offset]], &[[1000, 0], [0, 0]], 1000);
    let apart = flock(Some(4)).run(&pass(2001), &[], 10.0, |_, _| {}).expect("a motion");
    assert!(apart.events.is_empty());
    let linked = flock(Some(4)).run(&pass(1999), &[], 6.0, |_, _| {}).expect("a motion");
    assert!(linked.events[0].linked && linked.events[0].pair == (0, 1));
    // Touching the threshold without crossing it: refused.
    assert!(matches!(flock(Some(4)).run(&pass(2000), &[], 10.0, |_, _| {}), Err(EnclosureError::Threshold { .. })));
}

#[test]
fn a_start_at_the_threshold_is_refused() {
    let start = state(&[[0, 0], [2, 0]], &[[0, 0], [0, 0]], 1);
    let refused = flock(Some(4)).run(&start, &[], 1.0, |_, _| {});
    assert_eq!(refused.err(), Some(EnclosureError::Threshold { time: 0.0, pair: (0, 1) }));
}

#[test]
fn a_fixed_network_encloses_the_run_in_floats() {
    let start = state(&[[0, 0], [12, 1], [3, 14], [-9, 8]], &[[1, 2], [-3, 0], [2, -1], [0, 4]], 10);
    let edges = [(0, 1), (1, 2), (2, 3)];
    let until = 5.0;
    let run = flock(None).run(&start, &edges, until, |_, _| {}).expect("a motion");
    let potential = Potential::inverse_square_log(&rational(1, 1));
    let slope = potential.slope_over(&1.0);
    let flat = |s: &State<f64>| -> Vec<f64> { s.positions.iter().chain(&s.velocities).flatten().copied().collect() };
    let unflat = |y: &[f64]| State {
        positions: y[..8].chunks(2).map(|c| [c[0], c[1]]).collect(),
        velocities: y[8..].chunks(2).map(|c| [c[0], c[1]]).collect(),
    };
    let mut field = |_: f64, y: &[f64], rate: &mut [f64]| {
        let s = unflat(y);
        let forces = velocity_alignment(&s, &edges, Coordinates::Cartesian, |_, _, s| slope.at(s)).expect("apart");
        let all = s.velocities.iter().chain(&forces).flatten();
        rate.iter_mut().zip(all).for_each(|(r, x)| *r = *x);
    };
    let first = flat(&start.map(FloatInterval::midpoint));
    let floats =
        integrate(&mut field, 0.0, &first, &[until], Tolerance { relative: 1e-13, absolute: 1e-13 }).expect("a run");
    let end: Vec<_> = run.end.positions.iter().chain(&run.end.velocities).flatten().collect();
    for (enclosed, x) in end.iter().zip(&floats[0]) {
        assert!(enclosed.lo() - 1e-10 < *x && *x < enclosed.hi() + 1e-10, "{enclosed:?} {x}");
        assert!(enclosed.width() < 1e-9, "{enclosed:?}");
    }
}

#[test]
fn a_link_that_is_lost_and_one_that_is_found() {
    let row = |speed: i64| state(&[[0, 0], [2, 0], [5, 0]], &[[0, 0], [0, 0], [2 * speed, 0]], 2);
    let spring = EnclosedFlock {
        potential: Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1)),
        threshold: Some(rational(4, 1)),
    };
    let slow = spring.run(&row(3), &[], 2.0, |_, _| {}).expect("a motion");
    assert_eq!(slow.events.iter().map(|e| (e.pair, e.linked)).collect::<Vec<_>>(), [((0, 2), true)]);
    let fast = spring.run(&row(4), &[], 2.0, |_, _| {}).expect("a motion");
    assert_eq!(fast.events.iter().map(|e| (e.pair, e.linked)).collect::<Vec<_>>(), [((1, 2), false)]);
    assert!((fast.events[0].from - 0.1676).abs() < 1e-3 && (slow.events[0].from - 1.3651).abs() < 1e-3);
}
