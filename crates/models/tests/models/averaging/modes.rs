//! Modes, motion, and the graphs that claims are checked on.

use algebra::graph::Graph;
use algebra::matrix::{MatrixError, RationalMatrix};
use arithmetic::{RadicalSum, Rational, rational};
use models::averaging::{Mode, State, Weights, motion, rational_modes, transition_matrix};

#[test]
fn graphs_up_to_isomorphism() {
    let counts: Vec<usize> = (1..=7).map(|n| Graph::connected_up_to_isomorphism(n).len()).collect();
    assert_eq!(counts, [1, 1, 2, 6, 21, 112, 853]);
    assert!(!Graph::from_edges(2, &[]).unwrap().is_connected() && !Graph::path(0).is_connected());
    let laplacian = Graph::path(3).laplacian().unwrap();
    assert_eq!(laplacian, RationalMatrix::from_integers(&[[1, -1, 0], [-1, 2, -1], [0, -1, 1]], 1).unwrap());
    assert_eq!(Graph::path(0).laplacian(), Err(MatrixError::Empty));
}

/// The sum of the terms of equation (3.8).
fn rebuilt(modes: &[Mode], c: &[Rational]) -> RationalMatrix {
    modes.iter().fold(RationalMatrix::from_integers(&[[0; 4]; 4], 1).unwrap(), |sum, mode| {
        let dyad = RationalMatrix::from_rows(&mode.dyad(c, 1, -1).unwrap()).unwrap();
        sum.plus(&dyad.scaled(&mode.eigenvalue)).unwrap()
    })
}

/// The modes of the lazy path on four birds, whose eigenvalues are 1, 2/3, 0 and -1/3.
#[test]
fn modes_rebuild_the_matrix() {
    let graph = Graph::path(4);
    let (p, c) = (transition_matrix(&graph, &Weights::Lazy).unwrap(), Weights::Lazy.all(&graph).unwrap());
    let modes = rational_modes(&p, &c).unwrap().unwrap();
    let values: Vec<Rational> = modes.iter().map(|mode| mode.eigenvalue.clone()).collect();
    assert_eq!(values, [rational(1, 1), rational(2, 3), rational(0, 1), rational(-1, 3)]);
    assert_eq!(rebuilt(&modes, &c), p);
    let times = |a: i32, power: fn(&Rational) -> Rational| {
        assert!(modes.iter().all(|mode| {
            let naive: Vec<Rational> = mode.right.iter().zip(&c).map(|(r, c)| r * power(c)).collect();
            mode.scaled(&c, a).unwrap() == naive
        }));
    };
    times(3, Clone::clone);
    times(1, |_| rational(1, 1));
    times(-1, Rational::recip);
    times(-3, |c| (c * c).recip());
}

#[test]
fn irrational_and_repeated_eigenvalues() {
    let of = |graph: &Graph| {
        let p = transition_matrix(graph, &Weights::Lazy).unwrap();
        rational_modes(&p, &Weights::Lazy.all(graph).unwrap()).unwrap()
    };
    assert!(of(&Graph::path(5)).is_none());
    let complete = of(&Graph::from_fn(4, |_, _| true)).unwrap();
    assert_eq!(complete.iter().filter(|mode| mode.eigenvalue == rational(1, 9)).count(), 3);
    let graph = Graph::from_fn(4, |_, _| true);
    assert_eq!(rebuilt(&complete, &vec![rational(2, 9); 4]), transition_matrix(&graph, &Weights::Lazy).unwrap());
    // Not diagonalisable: no full set of modes.
    let jordan = RationalMatrix::from_integers(&[[1, 1], [0, 1]], 1).unwrap();
    assert_eq!(rational_modes(&jordan, &[rational(1, 1), rational(1, 1)]).unwrap(), None);
}

#[test]
fn motion_in_two_dimensions() {
    let p = RationalMatrix::from_integers(&[[1, 1], [1, 1]], 2).unwrap();
    let numbers = |x: [i64; 4]| x.map(|x| rational(x, 1)).to_vec();
    let start = State { positions: numbers([0, 1, 2, 3]), velocities: numbers([2, 0, 0, 4]) };
    let states = motion(start, 2, &[p.clone(), p.clone()]).unwrap();
    assert_eq!(states[1], State { positions: numbers([2, 1, 2, 7]), velocities: numbers([1, 2, 1, 2]) });
    assert_eq!(states[2].positions, numbers([3, 3, 3, 9]));
    let bad = State { positions: numbers([0; 4]), velocities: vec![] };
    assert!(matches!(motion(bad, 2, std::slice::from_ref(&p)), Err(MatrixError::Shapes { .. })));
    let more = State { positions: vec![rational(0, 1); 6], velocities: numbers([0; 4]) };
    assert_eq!(motion(more, 2, &[p]), Err(MatrixError::Shapes { left_cols: 6, right_rows: 4 }));
}

#[test]
fn radical_sums_are_exact() {
    let sum = |terms: &[(i64, i64, i64)]| {
        let mut sum = RadicalSum::default();
        for &(coefficient, p, q) in terms {
            assert!(sum.add_root(&rational(coefficient, 1), &rational(p, q)));
        }
        sum
    };
    assert_eq!(sum(&[(1, 8, 1), (-2, 2, 1)]), RadicalSum::default());
    assert_eq!(sum(&[(6, 1, 12)]), sum(&[(1, 3, 1), (5, 0, 1)]));
    assert_ne!(sum(&[(1, 2, 1), (1, 3, 1)]), sum(&[(1, 5, 1)]));
    assert!(!RadicalSum::default().add_root(&rational(1, 1), &rational(-1, 1)));
}
