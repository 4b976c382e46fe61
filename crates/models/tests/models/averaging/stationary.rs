//! Stationary distributions, deviation matrices and contraction on fixed networks.

use algebra::graph::Graph;
use algebra::matrix::{MatrixError, RationalMatrix, tau_1};
use arithmetic::{Rational, rational};
use models::averaging::{Weights, contraction, deviation_matrix, stationary_distribution, transition_matrix};
use num_bigint::BigUint;

fn connected(order: usize) -> impl Iterator<Item = Graph> {
    Graph::all(order).filter(|graph| graph.components().len() == 1)
}

#[test]
fn the_stationary_distribution_and_the_group_inverse() {
    for graph in (1..=4).flat_map(connected) {
        let n = graph.order();
        let given = Weights::Given((0..n).map(|i| rational(1, graph.degree(i) as i64 + 1 + i as i64)).collect());
        for weights in [Weights::Lazy, Weights::Vicsek, given] {
            let p = transition_matrix(&graph, &weights).unwrap();
            let pi = stationary_distribution(&graph, &weights).unwrap();
            assert_eq!(pi.iter().sum::<Rational>(), rational(1, 1));
            assert_eq!(p.transpose().apply(&pi).unwrap(), pi);
            // The group inverse G of A = I - P: AGA = A, GAG = G, AG = GA.
            let gamma = deviation_matrix(&p, &pi).unwrap();
            let a = RationalMatrix::identity(n).unwrap().minus(&p).unwrap();
            let (ag, ga) = (a.times(&gamma).unwrap(), gamma.times(&a).unwrap());
            assert_eq!(ag, ga);
            assert_eq!(ag.times(&a).unwrap(), a);
            assert_eq!(ga.times(&gamma).unwrap(), gamma);
            assert_eq!(gamma.apply(&vec![rational(1, 1); n]).unwrap(), vec![rational(0, 1); n]);
            assert_eq!(gamma.transpose().apply(&pi).unwrap(), vec![rational(0, 1); n]);
        }
    }
}

#[test]
fn a_single_bird_and_disconnected_flocks() {
    let alone = Graph::path(1);
    assert_eq!(stationary_distribution(&alone, &Weights::Lazy), Ok(vec![rational(1, 1)]));
    let p = transition_matrix(&alone, &Weights::Lazy).unwrap();
    assert_eq!(deviation_matrix(&p, &[rational(1, 1)]).unwrap(), RationalMatrix::from_integers(&[[0]], 1).unwrap());
    assert_eq!(contraction(&p).unwrap().steps, BigUint::from(1u8));
    let pair = Graph::from_edges(2, &[]).unwrap();
    assert_eq!(stationary_distribution(&pair, &Weights::Lazy), Err(MatrixError::NotErgodic));
    assert_eq!(contraction(&transition_matrix(&pair, &Weights::Lazy).unwrap()), Err(MatrixError::NotErgodic));
    let zero = Weights::Given(vec![rational(0, 1); 2]);
    assert_eq!(stationary_distribution(&Graph::path(2), &zero), Err(MatrixError::Singular));
    let one_zero = Weights::Given(vec![rational(0, 1), rational(1, 2)]);
    assert_eq!(stationary_distribution(&Graph::path(2), &one_zero), Err(MatrixError::Singular));
    let opposite = Weights::Given(vec![rational(1, 2), rational(-1, 2)]);
    assert_eq!(stationary_distribution(&Graph::path(2), &opposite), Err(MatrixError::Singular));
    let swap = RationalMatrix::from_integers(&[[0, 1], [1, 0]], 1).unwrap();
    assert_eq!(contraction(&swap), Err(MatrixError::NotErgodic));
}

/// The rounded bound against the exact definition, and its length.
#[test]
fn contraction_is_an_upper_bound() {
    for graph in [Graph::path(2), Graph::path(7), Graph::path(12), Graph::from_fn(9, |i, _| i == 0)] {
        for weights in [Weights::Lazy, Weights::Vicsek] {
            let p = transition_matrix(&graph, &weights).unwrap();
            let found = contraction(&p).unwrap();
            let mut power = p;
            let mut steps = BigUint::from(1u8);
            while tau_1(&power) > rational(1, 2) {
                power = power.times(&power).unwrap().reduced();
                steps *= 2u8;
            }
            assert_eq!(found.steps, steps);
            let slack = &found.tau - tau_1(&power);
            assert!(slack >= rational(0, 1) && slack < rational(1, 1 << 62) && found.tau <= rational(1, 2));
        }
    }
}

/// Everyone alike with share `q`: `tau_1(P^k) = (1 - n q)^k`. Powers of more than 256 bits are rounded, and the bound stays above.
#[test]
fn contraction_of_rounded_powers_is_an_upper_bound() {
    for order in [2i64, 3] {
        for share in 600..630i64 {
            let row = |i: i64| (0..order).map(move |j| if i == j { share - order + 1 } else { 1 }).collect::<Vec<_>>();
            let rows: Vec<Vec<i64>> = (0..order).map(row).collect();
            let found = contraction(&RationalMatrix::from_integers(&rows, share).unwrap()).unwrap();
            let factor = rational(share - order, share);
            let power = |k: u64| arithmetic::Ring::power(&factor, k);
            let steps = u64::try_from(found.steps).unwrap();
            assert!(power(steps) < found.tau && found.tau <= rational(1, 2) && power(steps / 2) > rational(1, 2));
            assert!(found.tau - power(steps) < Rational::new(1.into(), num_bigint::BigInt::from(1) << 230));
        }
    }
}

/// Without rounding the bound is `tau_1` itself, also where that is 1/2.
#[test]
fn contraction_of_short_powers_is_exact() {
    let half = RationalMatrix::from_integers(&[[3, 1], [1, 3]], 4).unwrap();
    let found = contraction(&half).unwrap();
    assert_eq!((found.steps, found.tau), (BigUint::from(1u8), rational(1, 2)));
    let mean = contraction(&RationalMatrix::from_integers(&[[1, 1], [1, 1]], 2).unwrap()).unwrap();
    assert_eq!((mean.steps, mean.tau), (BigUint::from(1u8), rational(0, 1)));
}

/// Weights so small that the powers take more than 2^300 steps: the length of the rounding must grow.
#[test]
fn contraction_of_tiny_weights() {
    let tiny = Rational::new(1.into(), num_bigint::BigInt::from(1) << 300);
    let p = transition_matrix(&Graph::path(2), &Weights::Given(vec![tiny.clone(), tiny])).unwrap();
    // tau_1(P^k) = (1 - 2^-299)^k, which is below 1/2 from k = ln 2 * 2^299 on.
    assert_eq!(contraction(&p).unwrap().steps, BigUint::from(1u8) << 299);
}

/// Contraction needs a bird that all hear, and not one that hears all.
#[test]
fn directed_networks_contract_towards_a_bird_that_all_hear() {
    let all_hear_one = RationalMatrix::from_integers(&[[2, 0, 0], [1, 1, 0], [1, 0, 1]], 2).expect("a shape");
    assert!(contraction(&all_hear_one).is_ok());
    let all_hear_the_last = RationalMatrix::from_integers(&[[1, 0, 1], [0, 1, 1], [0, 0, 2]], 2).expect("a shape");
    assert!(contraction(&all_hear_the_last).is_ok());
    // Cycles of 5 and of 4 birds with a common part: only from the ninth power on any two rows share a column.
    let wielandt = [[0, 2, 0, 0, 0], [0, 0, 2, 0, 0], [0, 0, 0, 2, 0], [0, 0, 0, 0, 2], [1, 1, 0, 0, 0]];
    assert!(contraction(&RationalMatrix::from_integers(&wielandt, 2).expect("a shape")).is_ok());
    let one_hears_all = RationalMatrix::from_integers(&[[1, 1, 1], [0, 3, 0], [0, 0, 3]], 3).expect("a shape");
    assert_eq!(contraction(&one_hears_all), Err(MatrixError::NotErgodic));
    // Through others: 4 hears 3, 3 hears 2, 2 hears 1.
    let chain = RationalMatrix::from_integers(&[[2, 0, 0, 0], [1, 1, 0, 0], [0, 1, 1, 0], [0, 0, 1, 1]], 2);
    assert!(contraction(&chain.expect("a shape")).is_ok());
    let two_chains = RationalMatrix::from_integers(&[[2, 0, 0, 0], [1, 1, 0, 0], [0, 0, 2, 0], [0, 0, 1, 1]], 2);
    assert_eq!(contraction(&two_chains.expect("a shape")), Err(MatrixError::NotErgodic));
    let wide = RationalMatrix::from_integers(&[[1, 1]], 2).expect("a shape");
    assert_eq!(contraction(&wide), Err(MatrixError::NotSquare { rows: 1, cols: 2 }));
}

/// Twice and three times the number of neighbours have to be numbers still.
#[test]
fn weights_are_for_numbers_of_neighbours_that_a_graph_has() {
    for degree in [usize::MAX, 1 << 63, (1 << 63) - 1] {
        assert_eq!((Weights::Lazy.of(degree, 0), Weights::Vicsek.of(degree, 0)), (None, None), "{degree}");
    }
    assert_eq!(Weights::Lazy.of(1 << 61, 0), Some(rational(2, 3 << 61)));
    assert_eq!(Weights::Vicsek.of((1 << 63) - 2, 0), Some(rational(1, i64::MAX)));
}
