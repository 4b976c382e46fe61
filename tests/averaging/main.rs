//! Mirrors `src/averaging` and `src/graph`.

use flockproof::arithmetic::{Rational, rational};
use flockproof::averaging::{Affine, HalfOpenRange, LineFlock, Weights, distance_network, transition_matrix};
use flockproof::graph::{Graph, GraphError};
use flockproof::matrix::{MatrixError, StochasticMatrix};
use proptest::prelude::*;

mod control;
mod flock;
mod kinematic;
mod modes;
mod settle;
mod stationary;

fn numbers(range: std::ops::Range<i64>, count: usize, denominator: i64) -> impl Strategy<Value = Vec<Rational>> {
    prop::collection::vec(range, count).prop_map(move |v| v.into_iter().map(|x| rational(x, denominator)).collect())
}

proptest! {
    /// Adding a constant to all velocities changes neither networks nor differences (Galilean invariance), and the
    /// velocities stay within the hull of the first ones.
    #[test]
    fn a_flock_does_not_feel_a_common_velocity(
        x in numbers(0..60, 6, 16), v in numbers(-8..8, 6, 8), common in -20i64..20, lazy in any::<bool>(), held in any::<bool>()
    ) {
        let weights = if lazy { Weights::Lazy } else { Weights::Vicsek };
        let hysteresis = held.then(|| rational(1, 50));
        let moving: Vec<Rational> = v.iter().map(|u| u + rational(common, 3)).collect();
        let (low, high) = (v.iter().min().unwrap().clone(), v.iter().max().unwrap().clone());
        let mut still = LineFlock::new(x.clone(), v, weights.clone(), hysteresis.clone()).unwrap();
        let mut carried = LineFlock::new(x, moving, weights, hysteresis).unwrap();
        for t in 1..8i64 {
            still.step().unwrap();
            carried.step().unwrap();
            prop_assert_eq!(still.network(), carried.network());
            for (a, b) in still.positions().iter().zip(carried.positions()) {
                prop_assert_eq!(b - a, rational(common * t, 3));
            }
            prop_assert!(still.velocities().iter().all(|u| low <= *u && *u <= high));
        }
    }

    /// What is decided about an affine function on a range holds at every point of it.
    #[test]
    fn affine_decisions_hold_on_the_range(c in -40i64..40, s in -40i64..40, end in prop_oneof![-9i64..0, 1i64..9], k in 1i64..50) {
        let f = Affine { constant: rational(c, 16), slope: rational(s, 16) };
        let range = HalfOpenRange { end: rational(end, 9) };
        let r = &range.end * rational(k, 50) ;
        let near = num_traits::Signed::abs(&f.at(&r)) <= rational(1, 1);
        if let Some(decided) = f.is_within_one(&range) {
            prop_assert_eq!(decided, near);
        }
    }
}

#[test]
fn transition_matrices_are_stochastic_with_positive_diagonal() {
    for order in 1..=5 {
        for graph in Graph::all(order) {
            for weights in [Weights::Lazy, Weights::Vicsek] {
                assert!(weights.are_admissible(&graph));
                let matrix = StochasticMatrix::try_from(&transition_matrix(&graph, &weights).unwrap()).unwrap();
                assert!(matrix.footprint().has_full_diagonal() && matrix.footprint().is_symmetric());
            }
        }
    }
    assert!(!Weights::Given(vec![rational(1, 1); 2]).are_admissible(&Graph::path(2)));
    assert!(!Weights::Given(vec![rational(0, 1); 2]).are_admissible(&Graph::path(2)));
    assert!(matches!(
        transition_matrix(&Graph::path(3), &Weights::Given(vec![rational(1, 3)])),
        Err(MatrixError::EntryCount { .. })
    ));
}

#[test]
fn a_tie_at_distance_one_is_an_edge() {
    let at = |x: i64| distance_network(&[rational(0, 1), rational(x, 1_000_000)]).has_edge(0, 1);
    assert!(at(1_000_000) && at(-1_000_000) && at(0) && !at(1_000_001));
}

#[test]
fn graphs() {
    assert_eq!(Graph::all(4).count(), 64);
    assert_eq!(Graph::all(0).count(), 1);
    assert_eq!(Graph::path(4).edges(), vec![(0, 1), (1, 2), (2, 3)]);
    let pairs = Graph::from_edges(4, &[(0, 1), (3, 2)]).unwrap();
    assert_eq!(pairs.components(), vec![vec![0, 1], vec![2, 3]]);
    assert_eq!(Graph::from_edges(2, &[(0, 2)]), Err(GraphError::NoSuchVertex { vertex: 2, order: 2 }));
    assert_eq!(Graph::from_edges(2, &[(1, 1)]), Err(GraphError::Loop(1)));
    // Connected labelled graphs on 1, ..., 5 vertices.
    let connected = |n| Graph::all(n).filter(|g| g.components().len() == 1).count();
    assert_eq!([1, 2, 3, 4, 5].map(connected), [1, 1, 4, 38, 728]);
}

#[test]
fn flocks_that_are_refused() {
    let one = || vec![rational(0, 1)];
    assert_eq!(LineFlock::new(vec![], vec![], Weights::Lazy, None).unwrap_err(), MatrixError::Empty);
    assert!(matches!(LineFlock::new(one(), vec![], Weights::Lazy, None), Err(MatrixError::Shapes { .. })));
}
