//! paley.eq12.pos, paley.zero.dir, paley.fish.zero: where the Laplacian phase potential vanishes.

use super::common::{all_equal, arcs, arcs_of, identities, laplacian, turns};
use crate::prelude::*;
use algebra::graph::{Graph, WeightedGraph};
use models::oscillator::{Neighbours, in_turns, phase_potential, phasors, squared_lengths, up_to_rotation};
use num_traits::{Signed as _, Zero};
use std::rc::Rc;

/// The parts of a graph within which phases are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Parts {
    /// Strongly connected components.
    Strong,
    /// Connected components, the directions of the arcs forgotten.
    Weak,
    /// The whole graph.
    Whole,
}

impl Parts {
    fn of(self, graph: &WeightedGraph) -> Vec<Vec<usize>> {
        let either = |i: usize, j: usize| graph.adjacency().get(i, j).or(graph.adjacency().get(j, i)).is_some();
        match self {
            Parts::Strong => graph.adjacency().strong_components(),
            Parts::Weak => Graph::from_fn(graph.order(), either).components(),
            Parts::Whole => vec![(0..graph.order()).collect()],
        }
    }

    fn synchronised(self, graph: &WeightedGraph, exponents: &[usize]) -> bool {
        let parts = self.of(graph);
        parts.iter().all(|part| all_equal(&part.iter().map(|&k| exponents[k]).collect::<Vec<_>>()))
    }
}

/// Every digraph of few nodes with every arrangement of quarter turns and its potential, until one is wrong.
fn every_digraph(
    run: &Run,
    part: &str,
    wrong: impl Fn(&WeightedGraph, &[usize], &Rational) -> bool,
) -> Result<Outcome, CheckError> {
    const PARTS: usize = 4;
    let quarter = Complex::new(rational(0, 1), rational(1, 1));
    let most = run.cases(3, 4);
    let cases = (1..=most).flat_map(WeightedGraph::all).flat_map(|graph| {
        let arcs: Vec<(usize, usize)> = graph.adjacency().entries().map(|(k, j, _)| (k, j)).collect();
        let network = Neighbours::from_arcs(graph.order(), arcs);
        let (arrangements, both) = (up_to_rotation(graph.order(), PARTS), Rc::new((graph, network)));
        arrangements.map(move |exponents| (both.clone(), exponents))
    });
    let detail = format!("all digraphs of up to {most} nodes with all arrangements of quarter turns");
    run.every(exhaustive(part, detail), cases, |(both, exponents)| {
        let (graph, network) = both.as_ref();
        let z: Vec<Complex<Rational>> = exponents.iter().map(|&k| quarter.power(k as u64)).collect();
        let value = phase_potential(network, &z, 1)?;
        let place = || format!("N = {}, {} (k->j: j is a neighbour of k)", graph.order(), arcs(graph));
        let what = || format!("{}, {}: W_1 = {value}", place(), in_turns(&exponents, PARTS));
        let seen = || Counterexample::new(what(), [arcs_of(graph), turns(&exponents, PARTS)]);
        Ok(wrong(graph, &exponents, &value).then(seen))
    })
}

/// `W_1 = (1/(4N)) sum over arcs of |z_k - z_j|^2`, on a complete digraph with different weights.
fn arc_sums(order: usize, factor: (i64, i64)) -> Result<Identity<'static>, CheckError> {
    let pairs = (0..order * order).map(|place| (place / order, place % order)).filter(|(k, j)| k != j);
    let arcs = pairs.enumerate().map(|(place, (k, j))| (k, j, rational((place * place) as i64 + 1, 3)));
    let graph = WeightedGraph::from_arcs(order, arcs);
    let laplacian = laplacian(&graph)?;
    Ok(Identity::new(order, move |t| {
        let z = phasors(t)?;
        let share = t[0].ratio(factor.0, factor.1 * z.len() as i64);
        // d_k - sum <z_k, z_j>, with the weights of the arcs.
        let cosines = graph
            .adjacency()
            .entries()
            .fold(t[0].zero(), |sum, (k, j, weight)| sum + (t[0].one() - z[k].dot(&z[j])) * t[0].rational(weight));
        let squares = squared_lengths(&graph, &z, &t[0]) * &share * t[0].ratio(1, 2);
        let potential = phase_potential(&laplacian, &z, 1)?;
        Ok((vec![potential.clone(), potential], vec![cosines * share, squares]))
    }))
}

fn sum_of_squares(run: &Run, factor: (i64, i64)) -> Result<Outcome, CheckError> {
    let part = "W_1 as a sum over arcs of 1 - cos theta_kj = |z_k - z_j|^2/2";
    let parts = (2..=3).map(|order| Ok((arc_sums(order, factor)?, format!("{part}, N = {order}"))));
    identities(run, &[], &[], parts)
}

/// The graphs for which `W_1 = 0` exactly at synchronised phases, a factor, and a bound elsewhere.
#[derive(Clone, Copy)]
pub struct ConnectedVariant {
    applies: fn(&WeightedGraph) -> bool,
    factor: (i64, i64),
    above: (i64, i64),
}

pub fn connected() -> Record<ConnectedVariant> {
    Record::new(
        "paley.eq12.pos",
        "Row k of L z is d_k z_k - sum z_j, which gives the display. Each term is 1 - cos theta_kj >= 0, zero exactly at equal phases. So W_1 = 0 exactly if \
         phases are equal across every arc; if the graph is strongly connected (weakly is enough), they are all equal.",
        ConnectedVariant { applies: WeightedGraph::is_strongly_connected, factor: (1, 2), above: (0, 1) },
        |variant, run| {
            let above = rational(variant.above.0, variant.above.1);
            let formula = sum_of_squares(run, variant.factor).on([1, 2]);
            let zeros = every_digraph(run, "W_1 >= 0, and 0 exactly at synchronised phases", |graph, exponents, value| {
                let wrong = value.is_negative() || (*value > above) == all_equal(exponents);
                (variant.applies)(graph) && wrong
            });
            let zeros = zeros.checks("step Z2").on([2, 3, 4]);
            Run::all([formula, zeros, argued(&[4], "positive elsewhere, every graph", "notes/paley_phases.md, steps Z1-Z2")])
        },
    )
    .clauses(&[
        "W_1(theta) = (1/(2N)) <e^{i theta}, L e^{i theta}> = (1/(2N)) sum_k (d_k - sum_{j in N_k} <e^{i theta_k}, e^{i theta_j}>).",
        "W_1(theta) >= 0.",
        "If G is strongly connected, W_1(theta) = 0 if and only if theta is synchronized.",
        "Otherwise W_1(theta) > 0.",
    ])
    .altered("every digraph", |v| v.applies = |_| true)
    .altered("1/N instead of 1/(2N)", |v| v.factor = (1, 1))
    .altered("above 1/2 where positive", |v| v.above = (1, 2))
}

/// Zero exactly, or only, where the phases within each part of the graph are synchronised.
#[derive(Clone, Copy)]
pub struct ZeroVariant {
    parts: Parts,
    /// Phases synchronised within parts are claimed to give zero.
    sufficient: bool,
    /// What the potential is claimed to exceed elsewhere.
    above: (i64, i64),
}

impl ZeroVariant {
    /// The zero set on small graphs, and the sum over arcs.
    fn parts(&self, run: &Run) -> [Result<Outcome, CheckError>; 2] {
        let above = rational(self.above.0, self.above.1);
        let zeros = every_digraph(run, "zero set", |graph, exponents, value| {
            let synchronised = self.parts.synchronised(graph, exponents);
            value.is_negative()
                || all_equal(exponents) && !value.is_zero()
                || self.sufficient && synchronised && !value.is_zero()
                || !synchronised && *value <= above
        });
        [zeros, sum_of_squares(run, (1, 2))]
    }
}

pub fn strong_subgraphs() -> Record<ZeroVariant> {
    Record::new(
        "paley.zero.dir",
        "W_1 = (1/(4N)) sum over arcs of |z_k - z_j|^2, so an arc between two strong components counts: each may be synchronised at another phase, \
         and W_1 > 0. Two nodes and one arc are enough (single nodes are strongly connected); so are two 2-cycles joined by an arc. W_1 = 0 exactly if phases are \
         equal across every arc, that is, within each weakly connected component. For undirected graphs the two are the same. Synchronised strong components are \
         necessary for W_1 = 0.",
        ZeroVariant { parts: Parts::Strong, sufficient: true, above: (0, 1) },
        |variant, run| {
            let [zeros, squares] = variant.parts(run);
            let found = Run::all([zeros.checks("step Z2"), squares.checks("step Z1")]).on([1, 2]);
            Run::all([found, argued(&[2], "positive elsewhere, every graph", "notes/paley_phases.md, steps Z1-Z2")])
        },
    )
    .clauses(&[
        "If G is not strongly connected, then W_1(theta) is zero if and only if the phases within each strongly connected subgraph are synchronized.",
        "Otherwise W_1(theta) is positive.",
    ])
    .repaired_by(Fault::False, "", |v| v.parts = Parts::Weak)
    .repaired_clauses(&[
        "W_1(theta) is zero if and only if the phases within each weakly connected component of G are synchronised.",
        "Otherwise W_1(theta) is positive.",
    ])
    .altered("all phases equal", |v| v.parts = Parts::Whole)
    .altered("otherwise above 1/5", |v| v.above = (1, 5))
}

pub fn fish_subgraphs() -> Record<ZeroVariant> {
    Record::new(
        "paley.fish.zero",
        "W_1 = (1/(4N)) sum over arcs of |z_k - z_j|^2 >= 0 for any digraph, 0 at equal phases. W_1 = 0 makes phases equal across every arc, hence within each \
         connected subgraph, in the strong sense and in the weak one (checked: the weak one, which is more). The sentence says \"only if\"; the converse is \
         true for weakly connected components and false for strongly connected ones (paley.zero.dir).",
        ZeroVariant { parts: Parts::Weak, sufficient: false, above: (0, 1) },
        |variant, run| Run::all(variant.parts(run)).on([1, 2, 3]),
    )
    .clauses(&[
        "W_1(theta) is nonnegative for directed or undirected graphs.",
        "It is zero if theta is synchronized.",
        "Even if the network is not connected, W_1(theta) = 0 only if the phases within each connected subgraph are synchronized.",
    ])
    .altered("only if all phases are equal", |v| v.parts = Parts::Whole)
    .altered("if the phases within each strongly connected subgraph are", |v| (v.parts, v.sufficient) = (Parts::Strong, true))
    .altered("above 1/5 otherwise", |v| v.above = (1, 5))
}
