//! Mirrors `src/averaging` and `src/graph`.

use algebra::graph::{Graph, GraphError};
use algebra::matrix::{MatrixError, StochasticMatrix};
use arithmetic::rational;
use models::averaging::{Affine, HalfOpenRange, Weights, transition_matrix};
use proptest::prelude::*;

mod chosen;
mod control;
mod filling;
mod filtered;
mod flock;
mod history;
mod horizons;
mod hysteresis;
mod interrupted;
mod kinematic;
mod modes;
mod near_ties;
mod noisy;
mod observed;
mod reading;
mod settle;
mod stationary;
mod switches;
mod transients;

proptest! {
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

/// The ends: values of 1 at the closed end are within, values that only tend to 1 are not beyond.
#[test]
fn affine_decisions_at_the_ends_of_the_range() {
    let f = |c: i64, s: i64| Affine { constant: rational(c, 1), slope: rational(s, 1) };
    let range = HalfOpenRange { end: rational(1, 1) };
    let decided = [f(0, 1), f(0, -1), f(1, 0), f(-2, 0), f(-1, -1), f(1, 1), f(0, 2)].map(|f| f.is_within_one(&range));
    assert_eq!(decided, [Some(true), Some(true), Some(true), Some(false), Some(false), Some(false), None]);
    assert!(!f(1, 0).exceeds(&rational(1, 1), &range) && f(1, 0).is_at_most(&rational(1, 1), &range));
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
