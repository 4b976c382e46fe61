//! chazelle.foot.mono: footprints of products never lose a one.

use super::sequences::{seen_from_one_side, show};
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::{Footprint, StochasticMatrix};
use models::averaging::{Weights, transition_matrix};

#[derive(Clone, Copy)]
pub struct MonotoneVariant {
    /// `c_i d_i` is this share of one: below 1 the diagonal is positive.
    share: (i64, i64),
    /// Whether the footprint of a single matrix is part of the claim.
    single: bool,
    /// Whether every product is claimed to be symmetric too.
    products_symmetric: bool,
    /// Whether edges may be seen from one side only (`j` sees `i < j`).
    one_sided: bool,
}

impl MonotoneVariant {
    /// The matrix of a graph: `c_i = share/d_i`.
    fn matrix(&self, graph: &Graph) -> Result<StochasticMatrix, CheckError> {
        let matrix = transition_matrix(graph, &Weights::of_share(graph, &rational(self.share.0, self.share.1)))?;
        let matrix = if self.one_sided { seen_from_one_side(&matrix)? } else { matrix };
        Ok(StochasticMatrix::try_from(&matrix)?)
    }
}

pub fn monotone() -> Record<MonotoneVariant> {
    Record::new(
        "chazelle.foot.mono",
        "P(t+1,s)_ij >= p_ii(t+1) P(t,s)_ij > 0 wherever P(t,s)_ij > 0, because the diagonal is positive and nothing \
         is negative. p_ij > 0 for i != j exactly when i and j are joined, which is symmetric. P(2) P(1) with edges \
         1-2 at time 1 and 2-3 at time 2 lets bird 1 influence bird 3 but not the converse (notes/chazelle.md).",
        MonotoneVariant { share: (2, 3), single: true, products_symmetric: false, one_sided: false },
        check_monotone,
    )
    .clauses(&[
        "The footprint of P(t,s) can never lose a 1 as t grows.",
        "The footprint of P(t,s) is in general not symmetric.",
        "The footprint of a single P(t) is symmetric with its diagonal full of ones.",
    ])
    .altered("a one is kept without a positive diagonal", |v| (v.share, v.single) = ((1, 1), false))
    .altered("a full diagonal with c_i d_i = 1", |v| v.share = (1, 1))
    .altered("products always symmetric", |v| v.products_symmetric = true)
    .altered("edges seen from one side", |v| v.one_sided = true)
}

fn check_monotone(variant: &MonotoneVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let exact = |what: &str| exact(what, "exact products");
    let mut graphs = 0;
    let mut sequences = 0;
    let mut asymmetric = None;
    for order in 1..=4usize {
        let length = if order <= 3 { 4 } else { run.cases(2, 3) };
        let all: Vec<Graph> = Graph::all(order).collect();
        let matrices: Vec<StochasticMatrix> = all.iter().map(|g| variant.matrix(g)).collect::<Result<_, _>>()?;
        let prints: Vec<Footprint> = matrices.iter().map(StochasticMatrix::footprint).collect();
        for (graph, print) in all.iter().zip(&prints) {
            graphs += 1;
            if variant.single && !(print.is_symmetric() && print.has_full_diagonal()) {
                return Ok(Outcome::fails(
                    format!("{order} birds, edges {}: the footprint of P(t) is {print}", show(graph)),
                    exact("a single footprint"),
                ));
            }
        }
        // Every sequence of graphs; the footprint of the exact product and the product of footprints agree.
        let mut open: Vec<(Vec<usize>, StochasticMatrix)> =
            matrices.iter().cloned().enumerate().map(|(k, m)| (vec![k], m)).collect();
        for step in 1..length {
            let mut longer = Vec::new();
            for (names, product) in &open {
                run.checkpoint()?;
                let before = product.footprint();
                for (k, matrix) in matrices.iter().enumerate() {
                    let next = matrix.times(product)?;
                    let after = next.footprint();
                    sequences += 1;
                    let history = || {
                        let mut parts: Vec<String> = names.iter().map(|&n| show(&all[n])).collect();
                        parts.push(show(&all[k]));
                        parts.join(", then ")
                    };
                    if !after.contains(&before) || after != prints[k].times(&before) {
                        return Ok(Outcome::fails(
                            format!("{order} birds, {}: {before} becomes {after}", history()),
                            exact("no one is ever lost"),
                        ));
                    }
                    if !after.is_symmetric() {
                        asymmetric.get_or_insert_with(|| format!("{order} birds, {}: {after}", history()));
                    }
                    if step + 1 < length {
                        let mut names = names.clone();
                        names.push(k);
                        longer.push((names, next));
                    }
                }
            }
            open = longer;
        }
    }
    match asymmetric {
        Some(example) if variant.products_symmetric => Ok(Outcome::fails(example, exact("in general not symmetric"))),
        None => Ok(Outcome::fails("every product is symmetric", exact("in general not symmetric"))),
        Some(example) => {
            let all = "all sequences of 4 graphs on up to 3 birds, of 2 graphs on 4 birds (3 with --full), against the \
                       footprints of the exact products";
            let single = "symmetric with a full diagonal, all graphs on up to 4 birds";
            Ok(Outcome::Holds(vec![
                exhaustive("no one is ever lost", all).on([1]).cases(sequences),
                exhaustive("a single footprint", single).on([3]).cases(graphs),
                Evidence::new(Grade::Exact, "in general not symmetric", example).on([2]).for_all(),
            ]))
        }
    }
}
