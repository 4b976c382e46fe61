//! Numbers of agents that are not there, and lists of other lengths: an answer or an error, never a panic.

use algebra::graph::{Graph, NamedGraph};
use algebra::matrix::{MatrixError, RationalMatrix, SparseMatrix};
use arithmetic::{ArithmeticError, Complex, Dual, FloatInterval, Interval, Rational, rational};
use models::averaging::{Flock, FlockError, Hysteresis, Mode, Start, Weights, rational_modes};
use models::double_integrator::{
    Coordinates, EnclosedFlock, ForkError, Potential, State, TiedRate, disagreements, fork, gyroscopic,
    potential_energy, potential_gradients, saturated_rate, velocity_alignment,
};
use models::oscillator::{
    FourierFormation, Interaction, Neighbours, State as Phases, laplacian_rows, linearisation, pairwise_control,
};
use models::platoon::phase_margin::phase_margin;
use models::platoon::{Communication, CommunicationGraph, Gains, accelerations, next_order, theorem1};
use models::tracks::{Scale, Smoothing, Tracks, nearest_neighbour, partner_potential, smoothed};

#[test]
fn links_to_agents_that_are_not_there_are_refused() {
    let state = State { positions: vec![[0.0, 0.0], [1.0, 0.0]], velocities: vec![[1.0, 0.0], [0.0, 1.0]] };
    let (edges, plane) = (&[(0, 1), (1, 2)][..], Coordinates::Cartesian);
    let slope = |_: usize, _: usize, _: &f64| Ok(1.0);
    let refused = ArithmeticError::Domain("links between agents that are there");
    assert_eq!(potential_gradients(&state.positions, edges, plane, slope), Err(refused.clone()));
    assert_eq!(velocity_alignment(&state, edges, plane, slope), Err(refused.clone()));
    assert_eq!(potential_energy(&state.positions, edges, plane, slope), Err(refused.clone()));
    assert_eq!(gyroscopic(&state, &state.velocities, edges, |_, _| 0.0), Err(refused));
    assert_eq!(disagreements(&state.velocities, edges), disagreements(&state.velocities, &edges[..1]));
}

#[test]
fn networks_leave_out_what_is_not_there() {
    let x: Vec<Complex<f64>> = [1.0, 3.0, 7.0].map(|x| Complex::new(x, 0.0)).to_vec();
    let complete = Neighbours::complete(3);
    assert_eq!(complete.laplacian_of(&x[..2]), Neighbours::complete(2).laplacian_of(&x[..2]));
    assert!(complete.of_particle(3).is_empty());
    // Offsets count modulo the number of particles, as for a formation on the same network; usize::MAX is a multiple of 5.
    assert_eq!(Neighbours::circulant(5, &[1, usize::MAX]), Neighbours::circulant(5, &[1]));
    assert_eq!(Neighbours::circulant(5, &[7]), Neighbours::circulant(5, &[2]));
    let formation = |offset| {
        let formation = FourierFormation::new(5, [offset], 1, (&rational(1, 2), &rational(1, 1)));
        (0..5).map(|q| formation.mode(q)).collect::<Vec<_>>()
    };
    assert_eq!(formation(7), formation(2));
    assert_eq!(FourierFormation::new(5, [1], 1, (&rational(1, 2), &rational(1, 1))).mode(usize::MAX), formation(1)[0]);
    assert_eq!(Neighbours::circulant(0, &[1]).particles(), 0);
    let entries = [(0, 0, rational(1, 1)), (0, 1, rational(-1, 1)), (1, 1, rational(2, 1))];
    let laplacian = SparseMatrix::from_entries(2, entries);
    assert_eq!(laplacian_rows(&laplacian, &x), laplacian_rows(&laplacian, &x[..2]));
    assert_eq!(laplacian_rows(&laplacian, &x[..1]), x[..1]);
}

#[test]
fn fish_that_are_not_there_have_no_neighbours() {
    let places: Vec<Complex<f64>> = [0.0, 1.0, 3.0].map(|x| Complex::new(x, 0.0)).to_vec();
    assert_eq!(nearest_neighbour(&places, 3, None), 3);
    assert_eq!(nearest_neighbour(&places[..1], 0, Some(1.0)), 0);
    assert_eq!(partner_potential(&[1, 9], &places[..2]), 0.25);
    assert!(Scale::Figure.difference(0, 0.0, 0.0).is_finite());
    let tracks = Tracks::from_csv("t,id,x,y\n0,a,0,0\n0,b,1,0\n1,a,0,1\n1,b,1,1\n2,a,0,2\n2,b,1,2\n").expect("a table");
    assert!(smoothed(&tracks, 7, Smoothing::Mean, 1).0.is_empty());
    assert!(smoothed(&tracks, 0, Smoothing::Mean, usize::MAX).0.iter().all(Option::is_none));
}

#[test]
fn cars_that_are_not_there_have_no_acceleration() {
    let gains = Gains { f: -1.0, g: -2.0 };
    let (y, u) = ([1.0, 3.0, 4.0], [0.5, 0.25, 8.0]);
    let two = accelerations(Communication::FrontAndBack, &gains, (&0.0, &0.0), &y[..2], &u[..2]);
    assert_eq!(accelerations(Communication::FrontAndBack, &gains, (&0.0, &0.0), &y, &u[..2]), two);
    // Of three cars that track both sides the first alone tracks nobody beyond two; nobody is left where the first tracks the last.
    let line = CommunicationGraph::of(Communication::FrontAndBack, 3).unwrap();
    let all = line.accelerations(&gains, (&0.0, &0.0), &y, &u);
    assert_eq!(line.accelerations(&gains, (&0.0, &0.0), &y, &u[..2]), all[..1]);
    let last = CommunicationGraph::with_equal_weights(&[vec![3], vec![0], vec![0]]).unwrap();
    assert!(last.accelerations(&gains, (&0.0, &0.0), &y[..2], &u).is_empty());
    assert!(line.accelerations(&gains, (&0.0, &0.0), &[], &[]).is_empty());
    let fourth = CommunicationGraph::with_equal_weights(&[vec![0], vec![4], vec![4], vec![0]]).unwrap();
    assert_eq!(fourth.accelerations(&gains, (&0.0, &0.0), &y, &u).len(), 1);
    // Who tracks nobody does not accelerate.
    let free = CommunicationGraph::with_equal_weights(&[vec![], vec![1]]).unwrap();
    assert_eq!(free.accelerations(&gains, (&0.0, &0.0), &y[..2], &u[..2]), [0.0, -1.5]);
    let far = CommunicationGraph::nth_neighbours(usize::MAX, 3).unwrap();
    assert!((1..=3).all(|k| far.tracked_by(k).is_empty()));
}

#[test]
fn margins_need_gains_for_each_car() {
    let reduced = CommunicationGraph::of(Communication::FrontAndBack, 3).unwrap().reduced_laplacian().unwrap();
    let gains = vec![Gains { f: rational(-1, 1), g: rational(-1, 1) }; 4];
    for count in [0, 2, 4] {
        let refused = ArithmeticError::Domain("gains for each follower");
        assert_eq!(phase_margin(&reduced, &gains[..count]).unwrap_err(), refused);
    }
}

/// A number of followers with 64 bits is no negative number.
#[test]
fn many_followers_are_counted() {
    let gains = Gains { f: -1.0, g: -1.0 };
    let twice = |followers| theorem1::amplitude(&gains, followers).unwrap();
    assert!((twice(u64::MAX) / twice(1 << 62) - 4.0).abs() < 1e-12);
    assert!(theorem1::frequency(&gains, u64::MAX).unwrap() > 0.0);
    assert!(next_order::frequency(&gains, u64::MAX).unwrap() > 0.0);
    let like = |n: i64| Interval::from_rational(&rational(n, 1), 160);
    let exact = next_order::square_of_leading(&like(1), u64::MAX).unwrap();
    let expected = next_order::square_of_leading(&like(1), 1).unwrap();
    let square = like(i64::MAX) * like(2) + like(1);
    assert!((exact * &square * &square - expected).contains_zero());
}

#[test]
fn laws_of_phases_need_an_entry_for_each_particle() {
    let z: Vec<Complex<f64>> = vec![Complex::new(1.0, 0.0); 3];
    for order in [2, 4] {
        let graph = NamedGraph::Path(order).build().unwrap();
        assert_eq!(pairwise_control(&1.0, &graph, &z), Err(ArithmeticError::Domain("a vertex for each particle")));
    }
    let still = |rates: usize| move |_: &Phases<Dual<f64>>| Ok(vec![Dual::constant(0.0); rates]);
    let state = |positions: usize| Phases { positions: z[..positions].to_vec(), phasors: z.clone() };
    assert_eq!(linearisation(&state(2), &1.0, still(3)), Err(ArithmeticError::Domain("a position for each phasor")));
    let few = ArithmeticError::Domain("a rate of steering for each phasor");
    assert_eq!(linearisation(&state(3), &1.0, still(2)), Err(few));
    assert!(linearisation(&state(3), &1.0, still(3)).is_ok());
}

#[test]
fn modes_need_a_positive_weight_for_each_bird() {
    let p = RationalMatrix::from_integers(&[[1, 1], [1, 1]], 2).unwrap();
    let (one, zero) = (rational(1, 1), rational(0, 1));
    assert!(matches!(rational_modes(&p, std::slice::from_ref(&one)), Err(MatrixError::Shapes { .. })));
    for c in [&zero, &-one.clone()] {
        assert_eq!(rational_modes(&p, &[one.clone(), c.clone()]), Ok(None));
    }
    let mode = Mode { eigenvalue: one.clone(), right: vec![one.clone(); 2], norm: zero.clone() };
    let refused = ArithmeticError::Domain("a positive weight for each bird");
    for c in [vec![one.clone(), zero], vec![one.clone()]] {
        assert_eq!(mode.scaled(&c, -1), Err(refused.clone()));
    }
    assert_eq!(mode.scaled(&vec![one.clone(); 2], i32::MIN + 1), Ok(vec![one.clone(); 2]));
    assert_eq!(mode.dyad(&vec![one; 2], 1, -1), Err(ArithmeticError::DivisionByZero));
}

#[test]
fn agents_without_velocity_are_refused() {
    let potential = Potential::new(vec![(0, rational(1, 1))], (rational(0, 1), rational(0, 1)));
    let row = |x: i64| [rational(x, 1), rational(0, 1)];
    let state = State { positions: vec![row(0), row(2), row(3)], velocities: vec![row(1)] };
    let (square, refused) = (rational(4, 1), ArithmeticError::Domain("a velocity for each position"));
    assert_eq!(fork(&state, &square, Coordinates::Cartesian, &potential), Err(ForkError::Law(refused.clone())));
    assert_eq!(saturated_rate(&state, &square, &potential), Err(refused.clone()));
    assert_eq!(TiedRate::of(&state, &square, &potential), Err(refused));
    for threshold in [None, Some(square)] {
        let flock = EnclosedFlock { potential: potential.clone(), threshold };
        let found = flock.run(&state.map(FloatInterval::from_rational), &[(0, 1)], 1.0, |_, _| {});
        assert!(found.is_err_and(|error| error.to_string().contains("a velocity for each position")));
    }
}

#[test]
fn networks_of_other_orders_are_refused() {
    let row = |x: i64| vec![rational(x, 2)];
    let start = Start {
        positions: vec![row(0), row(1)],
        velocities: vec![row(1), row(0)],
        weights: Weights::Lazy,
        hysteresis: Hysteresis::None,
    };
    let mut flock = Flock::new(&start).unwrap();
    let before: Vec<Vec<Rational>> = flock.positions();
    for vertices in [0, 1, 3] {
        let refused = Some(FlockError::Network { birds: 2, vertices });
        assert_eq!(Flock::resume(&start, Graph::empty(vertices), 0.into()).err(), refused);
        assert_eq!(flock.step_on(&Graph::empty(vertices)).err(), refused);
    }
    assert_eq!(flock.positions(), before);
}
