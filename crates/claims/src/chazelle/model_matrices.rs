//! chazelle.modelD.stoch and chazelle.modelK.matrix: the matrices of the two models.

use super::sequences::{share_weights, show};
use algebra::graph::Graph;
use algebra::matrix::StochasticMatrix;
use arithmetic::{Rational, rational};
use ledger::{CheckError, Evidence, Grade, Outcome, Record, Run};
use models::averaging::{Weights, transition_matrix};

fn graphs(most: usize) -> impl Iterator<Item = Graph> {
    (1..=most).flat_map(Graph::all)
}

/// The shares `c_i d_i` that are tried.
#[derive(Clone, Copy)]
pub struct StochasticVariant {
    shares: &'static [(i64, i64)],
}

pub fn stochastic() -> Record<StochasticVariant> {
    Record::new(
        "chazelle.modelD.stoch",
        "Row i of I - CL has the diagonal entry 1 - c_i d_i > 0, entries c_i > 0 at the d_i neighbours and 0 \
         elsewhere; it sums to 1.",
        StochasticVariant { shares: &[(1, 1_000_000), (1, 3), (1, 2), (2, 3), (999_999, 1_000_000)] },
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
    .control("c_i d_i = 1 allowed", StochasticVariant { shares: &[(1, 2), (1, 1)] })
    .control("c_i d_i up to 1 + 10^-6", StochasticVariant { shares: &[(1, 2), (1_000_001, 1_000_000)] })
    .control("negative c_i", StochasticVariant { shares: &[(-1, 1_000_000)] })
}

fn check_stochastic(variant: &StochasticVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    for graph in graphs(5) {
        run.checkpoint()?;
        for &share in variant.shares {
            cases += 1;
            let matrix = transition_matrix(&graph, &share_weights(&graph, share))?;
            let problem = match StochasticMatrix::try_from(&matrix) {
                Err(error) => Some(error.to_string()),
                Ok(p) if !p.footprint().has_full_diagonal() => Some("a diagonal entry is 0".to_string()),
                Ok(_) => None,
            };
            if let Some(problem) = problem {
                let what =
                    format!("{} birds, {}, c_i d_i = {}/{}: {problem}", graph.order(), show(&graph), share.0, share.1);
                return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "P = I - CL", "one matrix")));
            }
        }
    }
    Ok(Outcome::Holds(vec![
        Evidence::new(
            Grade::Exhaustive,
            "row-stochastic with a positive diagonal",
            "all graphs on up to 5 birds, five shares c_i d_i from 10^-6 to 1 - 10^-6",
        )
        .on([1, 2])
        .cases(cases),
    ]))
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
    let printed = HeadingsVariant { offset: 1, sign: 1, own: 1 };
    Record::new(
        "chazelle.modelK.matrix",
        "1 - c_i d_i = 1/(d_i + 1) = c_i: the bird's own heading and its neighbours' have the same weight. The rule \
         is linear in the headings as real numbers, so it is its matrix.",
        printed,
        check_headings,
    )
    .clauses(&[
        "The heading update has the matrix P(t) = I_n - C_t L_t with c_i(t) = (d_i(t)+1)^{-1}.",
        "p_ij = (d_i+1)^{-1} if i = j or (i,j) in G_t.",
    ])
    .control("c_i = 1/d_i", HeadingsVariant { offset: 0, ..printed })
    .control("c_i = 1/(d_i + 2)", HeadingsVariant { offset: 2, ..printed })
    .control("I + CL", HeadingsVariant { sign: -1, ..printed })
    .control("without the bird's own heading", HeadingsVariant { own: 0, ..printed })
}

fn check_headings(variant: &HeadingsVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    for graph in graphs(5) {
        run.checkpoint()?;
        cases += 1;
        let matrix = variant.matrix(&graph)?;
        for (i, row) in matrix.iter().enumerate() {
            for (j, entry) in row.iter().enumerate() {
                let joined = i == j || graph.has_edge(i, j);
                let printed = if joined { rational(1, graph.degree(i) as i64 + 1) } else { rational(0, 1) };
                let rule = variant.rule(&graph, i, j);
                if *entry != printed || *entry != rule {
                    let what = format!(
                        "{} birds, {}: entry ({}, {}) is {entry}, printed {printed}, by the rule {rule}",
                        graph.order(),
                        show(&graph),
                        i + 1,
                        j + 1
                    );
                    return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "entries", "one matrix")));
                }
            }
        }
    }
    Ok(Outcome::Holds(vec![
        Evidence::new(
            Grade::Exhaustive,
            "entries, I - CL and the heading rule",
            "all graphs on up to 5 birds, on a basis of headings",
        )
        .on([1, 2])
        .cases(cases),
    ]))
}
