//! tanner2.L, rangeB, cor2_merris, and the same statements of tanner1: Laplacians and incidence matrices.

use super::fixtures::{connected, pairs};
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use rand_chacha::rand_core::Rng;

/// Every labelled graph of up to four vertices, and the connected ones of five, one of each class.
pub(crate) fn small_graphs() -> Vec<Graph> {
    (1..=4).flat_map(Graph::all).chain(Graph::connected_up_to_isomorphism(5)).collect()
}

/// A graph to be seen.
pub(crate) fn seen(graph: &Graph) -> Witness {
    Witness::networks(graph.order(), vec![graph.edges()])
}

/// A graph in words.
pub(crate) fn shown(graph: &Graph) -> String {
    let vertices = if graph.order() == 1 { "vertex" } else { "vertices" };
    format!("{} {vertices}, edges {:?}", graph.order(), graph.edges())
}

/// The sum of `w_e b_e c_e^T` over the edges, where `b_e` is the column of the incidence matrix of edge `e`, -1 where the edge
/// leaves and 1 where it enters, and `c_e = b_e`; an edge with `turned` runs from the larger vertex to the smaller one.
pub(crate) fn incidence_product(graph: &Graph, weights: &[Rational], turned: &[bool]) -> Vec<Vec<Rational>> {
    let mut product = vec![vec![rational(0, 1); graph.order()]; graph.order()];
    for (((i, j), weight), &turned) in graph.edges().into_iter().zip(weights).zip(turned) {
        let sign = if turned { 1 } else { -1 };
        let column = [(i, rational(sign, 1)), (j, rational(-sign, 1))];
        for (a, x) in &column {
            for (b, y) in &column {
                product[*a][*b] += x * y * weight;
            }
        }
    }
    product
}

/// `D + sign A`, `offset` more zero eigenvalues than components, with weights or without.
#[derive(Clone, Copy)]
pub(crate) struct LaplacianVariant {
    pub sign: i64,
    pub offset: usize,
    pub weighted: bool,
}

impl LaplacianVariant {
    pub const PRINTED: Self = LaplacianVariant { sign: -1, offset: 0, weighted: false };
}

/// `D + sign A` of a variant, and the weights of the edges.
fn claimed_laplacian(graph: &Graph, variant: &LaplacianVariant) -> (Vec<Vec<Rational>>, Vec<Rational>) {
    let (order, edges) = (graph.order(), graph.edges());
    let weight = |k: usize| if variant.weighted { rational(k as i64 + 1, 2) } else { rational(1, 1) };
    let weights: Vec<Rational> = (0..edges.len()).map(weight).collect();
    let mut rows = vec![vec![rational(0, 1); order]; order];
    for (&(i, j), w) in edges.iter().zip(&weights) {
        rows[i][i] += w;
        rows[j][j] += w;
        rows[i][j] += w * rational(variant.sign, 1);
        rows[j][i] += w * rational(variant.sign, 1);
    }
    (rows, weights)
}

/// Tests the properties of a Laplacian of every small graph.
pub(crate) fn examine_laplacian(variant: &LaplacianVariant, run: &Run) -> Result<Outcome, CheckError> {
    let mut random = run.random(0);
    let detail = "every labelled graph of up to 4 vertices and every connected one of 5 up to isomorphism, two orientations of each";
    let evidence = exhaustive("properties of the Laplacian", detail);
    run.every(evidence, small_graphs(), |graph| {
        let (rows, weights) = claimed_laplacian(&graph, variant);
        let turned: Vec<bool> = weights.iter().map(|_| random.next_u32() & 1 == 1).collect();
        let matrix = RationalMatrix::from_rows(&rows)?;
        let characteristic = matrix.characteristic_polynomial()?;
        let (zero, components) = (rational(0, 1), graph.components().len());
        let oriented = [vec![false; weights.len()], turned];
        let problem = if oriented.iter().any(|turned| incidence_product(&graph, &weights, turned) != rows) {
            "it is not the product of the incidence matrices"
        } else if matrix.transpose() != matrix {
            "it is not symmetric"
        } else if characteristic.count_below(&zero) > 0 {
            "it has a negative eigenvalue"
        } else if characteristic.multiplicity(&zero) != components + variant.offset {
            "0 is an eigenvalue of another multiplicity"
        } else if components == 1 && !is_span_of_ones(&matrix.kernel(), graph.order()) {
            "its kernel is not the span of 1"
        } else {
            return Ok(None);
        };
        Ok(Some(format!("{}: {problem}", shown(&graph))))
    })
}

fn is_span_of_ones(kernel: &[Vec<Rational>], order: usize) -> bool {
    kernel.len() == 1 && (1..order).all(|i| kernel[0][i] == kernel[0][0]) && kernel[0][0] != rational(0, 1)
}

pub fn laplacian() -> Record<LaplacianVariant> {
    Record::new(
        "tanner2.L",
        "Each edge adds b b^T with b = ±(e_i - e_j), whatever its direction, so B B^T = D - A is symmetric and x^T L x is the sum of \
         (x_i - x_j)² over the edges: non-negative, and zero exactly where x is constant on every component.",
        LaplacianVariant::PRINTED,
        |variant, run| Run::all([
            examine_laplacian(variant, run).checks("steps 1 to 4").on([1, 2, 3, 4, 5]),
            argued(&[1, 2, 3, 4, 5], "properties of the Laplacian", "notes/tanner2.md, Laplacians, steps 1 to 4"),
        ]),
    )
    .clauses(&[
        "L(G) = B B^T is independent of the orientation.",
        "It is symmetric and positive semidefinite.",
        "The multiplicity of its zero eigenvalue is the number of connected components.",
        "For a connected graph the zero eigenvector is 1_n.",
        "For a connected graph lambda_2 > 0.",
    ])
    .reading("lambda_2 for two vertices or more; one vertex has none")
    .altered("D + A", |v| v.sign = 1)
    .altered("one more zero eigenvalue", |v| v.offset = 1)
}

/// For which graphs the range of `B` is said to be the complement of 1, for which the columns to be independent, and how many edges fewer than
/// vertices a tree is said to have.
#[derive(Clone, Copy)]
pub struct RangeVariant {
    range: fn(&Graph) -> bool,
    independent: fn(&Graph) -> bool,
    fewer: usize,
}

fn examine_range(variant: &RangeVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let detail = "every labelled graph of up to 4 vertices and every connected one of 5 up to isomorphism";
    let evidence = exhaustive("range and rank of B", detail).on([1, 2, 3]);
    let ranks = run.every(evidence, small_graphs(), |graph: Graph| {
        // No edges: no columns, the range is {0}.
        let edges = graph.edges().len();
        let rank = if edges == 0 { 0 } else { edges - graph.incidence()?.kernel().len() };
        // Every column sums to zero, so the range lies in the complement of 1, which has N - 1 dimensions.
        Ok(if (variant.range)(&graph) && rank + 1 != graph.order() {
            Some(format!("{}: the rank of B is {rank}", shown(&graph)))
        } else if graph.is_tree() && edges + variant.fewer != graph.order() {
            Some(format!("{}: a tree with {edges} edges", shown(&graph)))
        } else if (variant.independent)(&graph) && rank != edges {
            Some(format!("{}: {edges} columns of rank {rank}", shown(&graph)))
        } else {
            None
        })
    });
    Run::all([
        ranks.checks("step 5"),
        argued(&[1, 2, 3], "range and rank of B", "notes/tanner2.md, Laplacians, step 5"),
    ])
}

pub fn range() -> Record<RangeVariant> {
    Record::new(
        "tanner2.rangeB",
        "Every column sums to zero. y^T B = 0 says that y is equal at both ends of every edge, so for a connected graph the range is the whole \
         complement of 1, of dimension N - 1. A tree has N - 1 edges: its columns are independent. (Full rank means full column rank.)",
        RangeVariant { range: Graph::is_connected, independent: Graph::is_tree, fewer: 1 },
        examine_range,
    )
    .clauses(&[
        "For a connected graph range(B) = span{1}^perp.",
        "A tree has N - 1 edges.",
        "For a tree B is full rank.",
    ])
    .reading("full rank of the columns")
    .altered("any graph", |v| v.range = |_| true)
    .altered("as many edges as vertices", |v| v.independent = |graph| graph.is_connected() && graph.edges().len() == graph.order())
    .altered("a tree has N - 2 edges", |v| v.fewer = 2)
}

/// What a new edge does to the eigenvalues.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Growth {
    /// None decreases; the sum increases by this.
    NoneDecreases { sum: i64 },
    /// Every eigenvalue but the zero one increases.
    AllIncrease,
    /// The second smallest increases.
    SecondIncreases,
    /// None increases by more than one.
    AtMostOne,
}

/// The eigenvalues of the Laplacian from the smallest on, if all are rational.
pub(crate) fn rational_spectrum(graph: &Graph) -> Result<Option<Vec<Rational>>, CheckError> {
    Ok(graph.laplacian()?.characteristic_polynomial()?.rational_spectrum())
}

/// By how much the sum of the eigenvalues grows: that of the diagonal, which is minus the second coefficient of the characteristic polynomial.
fn growth_of_sum(graph: &Graph, more: &Graph) -> Result<Rational, CheckError> {
    let sum = |graph: &Graph| -> Result<Rational, CheckError> {
        let coefficients = graph.laplacian()?.characteristic_polynomial()?.coefficients();
        coefficients.iter().rev().nth(1).map(|c| -c.clone()).ok_or(CheckError::Other("no eigenvalues".to_string()))
    };
    Ok(sum(more)? - sum(graph)?)
}

/// Which eigenvalue from below goes against the statement, from 0; an eigenvalue whose numbers are not rational counts as the first.
fn against(variant: Growth, graph: &Graph, more: &Graph) -> Result<Option<usize>, CheckError> {
    let [before, after] = [graph, more].map(|graph| graph.laplacian().and_then(|l| l.characteristic_polynomial()));
    let (before, after) = (before?, after?);
    // Counts above a grid of rationals, and the eigenvalues themselves where all are rational.
    let grid = (0..=8 * graph.order() as i64).map(|k| rational(k, 4));
    if matches!(variant, Growth::NoneDecreases { .. })
        && grid.into_iter().any(|x| after.count_above(&x) < before.count_above(&x))
    {
        return Ok(Some(0));
    }
    let (Some(a), Some(b)) = (rational_spectrum(graph)?, rational_spectrum(more)?) else { return Ok(None) };
    Ok((0..a.len()).find(|&k| match variant {
        Growth::NoneDecreases { .. } => b[k] < a[k],
        Growth::AllIncrease => k > 0 && b[k] <= a[k],
        Growth::SecondIncreases => k == 1 && b[k] <= a[k],
        Growth::AtMostOne => &b[k] - &a[k] > rational(1, 1),
    }))
}

fn examine_growth(variant: &Growth, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = "a new edge and the eigenvalues of L";
    let detail = "every connected graph of up to 5 vertices and every new edge: numbers of eigenvalues above the multiples of 1/4, rational eigenvalues, and the sum of all";
    let additions = connected(5).into_iter().flat_map(|graph| {
        let free: Vec<_> = pairs(graph.order()).filter(|&(i, j)| !graph.has_edge(i, j)).collect();
        free.into_iter().map(move |pair| (graph.clone(), pair))
    });
    let evidence = exhaustive(part, detail);
    let growth = run.every(evidence, additions, |(graph, pair): (Graph, (usize, usize))| {
        let more = graph.with_edges(&[pair]);
        if let Growth::NoneDecreases { sum } = *variant {
            let grown = growth_of_sum(&graph, &more)?;
            if grown != rational(sum, 1) {
                let what = format!("{} and then {pair:?}: the sum of the eigenvalues grows by {grown}", shown(&graph));
                return Ok(Some(what));
            }
        }
        let Some(k) = against(*variant, &graph, &more)? else { return Ok(None) };
        let change = rational_spectrum(&graph)?.zip(rational_spectrum(&more)?);
        let change = change.map(|(a, b)| format!("from {} to {}", a[k], b[k])).unwrap_or_default();
        Ok(Some(format!("{} and then {pair:?}: eigenvalue {} from below goes {change}", shown(&graph), k + 1)))
    });
    Run::all([growth.checks("step 6"), argued(&[1], part, "notes/tanner2.md, Laplacians, step 6")])
}

pub fn merris() -> Record<Growth> {
    Record::new(
        "tanner2.cor2_merris",
        "A new edge adds b b^T, which is positive semidefinite of trace 2: no eigenvalue decreases (Courant and Fischer), and their sum increases by 2. \
         Some may stay: 0 always, 3 from the path to the triangle, lambda_2 = 1 from the star of 4 to the star with \
         an edge.",
        Growth::NoneDecreases { sum: 2 },
        examine_growth,
    )
    .reading("\"generally increases\": no eigenvalue decreases, and their sum grows by 2")
    .control("every eigenvalue but 0 increases", Growth::AllIncrease)
    .control("lambda_2 increases", Growth::SecondIncreases)
    .control("none by more than 1", Growth::AtMostOne)
    .control("the sum grows by 1", Growth::NoneDecreases { sum: 1 })
}
