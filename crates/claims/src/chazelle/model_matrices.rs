//! chazelle.modelD.stoch and chazelle.modelK.matrix: the matrices of the two models.

use super::sequences::show;
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::StochasticMatrix;
use models::averaging::{Weights, transition_matrix};

fn graphs(most: usize) -> impl Iterator<Item = Graph> {
    (1..=most).flat_map(Graph::all)
}

/// The shares `c_i d_i` that are tried.
type Shares = &'static [(i64, i64)];

pub fn stochastic() -> Record<Shares> {
    let printed: Shares = &[(1, 1_000_000), (1, 3), (1, 2), (2, 3), (999_999, 1_000_000)];
    Record::new(
        "chazelle.modelD.stoch",
        "Row i of I - CL has the diagonal entry 1 - c_i d_i > 0, entries c_i > 0 at the d_i neighbours and 0 \
         elsewhere; it sums to 1.",
        printed,
        check_stochastic,
    )
    .reading(
        "The condition is on birds with neighbours; a bird without any has c_i d_i = 0 and the row of the \
              identity, whatever c_i.",
    )
    .clauses(&[
        "If 0 < c_i(t) d_i(t) < 1, P(t) = I_n - C_t L_t is row-stochastic.",
        "If 0 < c_i(t) d_i(t) < 1, the diagonal of P(t) is strictly positive.",
    ])
    .control("c_i d_i = 1 allowed", &[(1, 2), (1, 1)])
    .control("c_i d_i up to 1 + 10^-6", &[(1, 2), (1_000_001, 1_000_000)])
    .control("negative c_i", &[(-1, 1_000_000)])
}

fn check_stochastic(shares: &Shares, run: &mut Run) -> Result<Outcome, CheckError> {
    let detail = "all graphs on up to 5 birds, five shares c_i d_i from 10^-6 to 1 - 10^-6";
    let evidence = exhaustive("row-stochastic with a positive diagonal", detail).on([1, 2]);
    let cases = graphs(5).flat_map(|graph| shares.iter().map(move |&share| (graph.clone(), share)));
    run.every(evidence, cases, |(graph, share)| {
        let (p, q) = share;
        let matrix = transition_matrix(&graph, &Weights::of_share(&graph, &rational(p, q)))?;
        let problem = match StochasticMatrix::try_from(&matrix) {
            Err(error) => error.to_string(),
            Ok(matrix) if !matrix.footprint().has_full_diagonal() => "a diagonal entry is 0".to_string(),
            Ok(_) => return Ok(None),
        };
        Ok(Some(format!("{} birds, {}, c_i d_i = {p}/{q}: {problem}", graph.order(), show(&graph))))
    })
}

/// The weights and the rule they are compared with.
#[derive(Clone, Copy)]
pub struct HeadingsVariant {
    /// `c_i = 1/(d_i + offset)`.
    offset: i64,
    /// `I - CL` or `I + CL`.
    sign: i64,
    /// Multiples of the bird's own heading in its sum.
    own: i64,
}

impl HeadingsVariant {
    fn matrix(&self, graph: &Graph) -> Result<Vec<Vec<Rational>>, CheckError> {
        let c = (0..graph.order()).map(|i| {
            let denominator = graph.degree(i) as i64 + self.offset;
            if denominator == 0 { rational(0, 1) } else { rational(self.sign, denominator) }
        });
        Ok(transition_matrix(graph, &Weights::Given(c.collect()))?.to_rows())
    }

    /// The heading rule for the headings with a one at bird `j`: the column `j` of its matrix.
    fn rule(&self, graph: &Graph, i: usize, j: usize) -> Rational {
        let theta = |k: usize| i64::from(k == j);
        let neighbours: i64 = (0..graph.order()).filter(|&k| graph.has_edge(i, k)).map(theta).sum();
        rational(self.own * theta(i) + neighbours, graph.degree(i) as i64 + 1)
    }
}

pub fn headings() -> Record<HeadingsVariant> {
    Record::new(
        "chazelle.modelK.matrix",
        "1 - c_i d_i = 1/(d_i + 1) = c_i: the bird's own heading and its neighbours' have the same weight. The rule \
         is linear in the headings as real numbers, so it is its matrix.",
        HeadingsVariant { offset: 1, sign: 1, own: 1 },
        check_headings,
    )
    .clauses(&[
        "The heading update has the matrix P(t) = I_n - C_t L_t with c_i(t) = (d_i(t)+1)^{-1}.",
        "p_ij = (d_i+1)^{-1} if i = j or (i,j) in G_t.",
    ])
    .altered("c_i = 1/d_i", |v| v.offset = 0)
    .altered("c_i = 1/(d_i + 2)", |v| v.offset = 2)
    .altered("I + CL", |v| v.sign = -1)
    .altered("without the bird's own heading", |v| v.own = 0)
}

fn check_headings(variant: &HeadingsVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let detail = "all graphs on up to 5 birds, on a basis of headings";
    let evidence = exhaustive("entries, I - CL and the heading rule", detail).on([1, 2]);
    run.every(evidence, graphs(5), |graph| {
        let matrix = variant.matrix(&graph)?;
        let places = (0..graph.order()).flat_map(|i| (0..graph.order()).map(move |j| (i, j)));
        Ok(places.into_iter().find_map(|(i, j)| {
            let (entry, rule) = (&matrix[i][j], variant.rule(&graph, i, j));
            let joined = i == j || graph.has_edge(i, j);
            let printed = if joined { rational(1, graph.degree(i) as i64 + 1) } else { rational(0, 1) };
            let what = || format!("entry ({}, {}) is {entry}, printed {printed}, by the rule {rule}", i + 1, j + 1);
            (*entry != printed || *entry != rule)
                .then(|| format!("{} birds, {}: {}", graph.order(), show(&graph), what()))
        }))
    })
}
