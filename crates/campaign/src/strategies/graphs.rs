//! Graphs.

use super::numbers::positive;
use crate::draws::Draws;
use algebra::graph::{Graph, WeightedGraph};
use arithmetic::{Rational, rational};

/// A graph: every pair is joined with probability 1/2.
pub fn graph(draws: &mut Draws, order: usize) -> Graph {
    let pairs: Vec<bool> = (0..order * order.saturating_sub(1) / 2).map(|_| draws.once_in(2)).collect();
    Graph::from_fn(order, |i, j| pairs[j * (j - 1) / 2 + i])
}

/// A connected graph: a random tree, and every other pair with probability 1/3.
pub fn connected_graph(draws: &mut Draws, order: usize) -> Graph {
    let parents: Vec<usize> = (1..order).map(|k| draws.below(k as u64) as usize).collect();
    let more: Vec<bool> = (0..order * order.saturating_sub(1) / 2).map(|_| draws.once_in(3)).collect();
    Graph::from_fn(order, |i, j| parents[j - 1] == i || more[j * (j - 1) / 2 + i])
}

/// A digraph with positive weights; about a third of the arcs are there.
pub fn digraph(draws: &mut Draws, order: usize) -> WeightedGraph {
    let mut arcs = Vec::new();
    for i in 0..order {
        for j in (0..order).filter(|&j| j != i) {
            if draws.once_in(3) {
                arcs.push((i, j, positive(draws, 3, 2)));
            }
        }
    }
    WeightedGraph::from_arcs(order, arcs)
}

/// A permutation of `0..order`: the number that comes at each place.
pub fn permutation(draws: &mut Draws, order: usize) -> Vec<usize> {
    let mut left: Vec<usize> = (0..order).collect();
    (0..order).map(|_| left.remove(draws.below(left.len() as u64) as usize)).collect()
}

/// Whom the followers of a platoon track, one or two others each, with positive weights that sum to one.
pub fn tracking(draws: &mut Draws, followers: usize) -> Vec<Vec<(usize, Rational)>> {
    let row = |k: usize, draws: &mut Draws| {
        let others: Vec<usize> = (0..=followers).filter(|&agent| agent != k).collect();
        let (first, second) = (*draws.choice(&others), *draws.choice(&others));
        let share = rational(1 + draws.below(3) as i64, 4);
        let mut row = vec![(first, rational(1, 1))];
        if second != first {
            row = vec![(first, rational(1, 1) - &share), (second, share)];
            row.sort_by_key(|(agent, _)| *agent);
        }
        row
    };
    (1..=followers).map(|k| row(k, draws)).collect()
}
