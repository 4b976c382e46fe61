//! Generators as strategies of proptest.

use algebra::matrix::product_sequential;
use campaign::draws::Draws;
use campaign::strategies::proptest::strategy;
use campaign::strategies::{connected_graph, stochastic_sequence};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(30))]

    #[test]
    fn tau_1_is_submultiplicative(factors in strategy(40, |draws| stochastic_sequence(draws, 3, 2, 8))) {
        let factors = factors.expect("stochastic matrices");
        let product = product_sequential(&factors).expect("factors of one order");
        prop_assert!(product.tau_1() <= factors[0].tau_1() * factors[1].tau_1());
    }

    #[test]
    fn connected_graphs_are_connected(graph in strategy(40, |draws| connected_graph(draws, 6))) {
        prop_assert!(graph.is_connected() && graph.order() == 6);
    }
}

/// Shrinking the draws leads to the simplest instance: all of them 0.
#[test]
fn strategies_shrink_to_the_simplest() {
    let mut tree =
        strategy(40, |draws| connected_graph(draws, 5)).new_tree(&mut TestRunner::deterministic()).expect("a graph");
    while tree.simplify() {}
    let simplest = connected_graph(&mut Draws::given(&[]), 5);
    assert_eq!(tree.current().edges(), simplest.edges());
}
