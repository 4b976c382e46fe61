//! tanner2.L, rangeB, cor2_merris, and the same statements of tanner1: Laplacians and incidence matrices.

use super::arbitrary::Arbitrary;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use arithmetic::{Rational, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Grade, Outcome, Run};
use rand_chacha::rand_core::Rng;

/// Every labelled graph of up to four vertices, and the connected ones of five, one of each class.
pub(crate) fn small_graphs() -> Vec<Graph> {
    (1..=4).flat_map(Graph::all).chain(Graph::connected_up_to_isomorphism(5)).collect()
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

/// Tests the properties of a Laplacian of every small graph.
pub(crate) fn examine_laplacian(variant: &LaplacianVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let graphs = small_graphs();
    let mut random = run.random(0);
    let exhaustive = |detail: &str| Evidence::new(Grade::Exhaustive, "properties of the Laplacian", detail.to_string());
    for graph in &graphs {
        run.checkpoint()?;
        let order = graph.order();
        let edges = graph.edges();
        let weight = |k: usize| if variant.weighted { rational(k as i64 + 1, 2) } else { rational(1, 1) };
        let weights: Vec<Rational> = (0..edges.len()).map(weight).collect();
        // D + sign A.
        let mut rows = vec![vec![rational(0, 1); order]; order];
        for (&(i, j), w) in edges.iter().zip(&weights) {
            rows[i][i] += w;
            rows[j][j] += w;
            rows[i][j] += w * rational(variant.sign, 1);
            rows[j][i] += w * rational(variant.sign, 1);
        }
        let turned: Vec<bool> = edges.iter().map(|_| random.next_u32() & 1 == 1).collect();
        let matrix = RationalMatrix::from_rows(&rows)?;
        let characteristic = matrix.characteristic_polynomial()?;
        let zero = rational(0, 1);
        let components = graph.components().len();
        let oriented = [vec![false; edges.len()], turned];
        let problem = if oriented.iter().any(|turned| incidence_product(graph, &weights, turned) != rows) {
            "it is not the product of the incidence matrices"
        } else if matrix.transpose() != matrix {
            "it is not symmetric"
        } else if characteristic.count_below(&zero) > 0 {
            "it has a negative eigenvalue"
        } else if characteristic.multiplicity(&zero) != components + variant.offset {
            "0 is an eigenvalue of another multiplicity"
        } else if components == 1 && !is_span_of_ones(&matrix.kernel(), order) {
            "its kernel is not the span of 1"
        } else {
            continue;
        };
        return Ok(Outcome::fails(
            format!("{order} vertices, edges {edges:?}: {problem}"),
            exhaustive("exact matrices"),
        ));
    }
    let detail = "every labelled graph of up to 4 vertices and every connected one of 5 up to isomorphism, two orientations of each; \
                  for all graphs the proof is in notes/tanner2.md";
    Ok(Outcome::Holds(vec![exhaustive(detail).cases(graphs.len())]))
}

fn is_span_of_ones(kernel: &[Vec<Rational>], order: usize) -> bool {
    kernel.len() == 1 && (1..order).all(|i| kernel[0][i] == kernel[0][0]) && kernel[0][0] != rational(0, 1)
}

pub fn laplacian() -> Record<LaplacianVariant> {
    let printed = LaplacianVariant::PRINTED;
    Record::new(
        "tanner2.L",
        "Each edge adds b b^T with b = ±(e_i - e_j), whatever its direction, so B B^T = D - A is symmetric and x^T L x is the sum of \
         (x_i - x_j)² over the edges: non-negative, and zero exactly where x is constant on every component. (lambda_2 needs two vertices.)",
        printed,
        examine_laplacian,
    )
    .control("D + A", LaplacianVariant { sign: 1, ..printed })
    .control("one more zero eigenvalue", LaplacianVariant { offset: 1, ..printed })
}

/// For which graphs the range of `B` is said to be the complement of 1, and for which the columns to be independent.
#[derive(Clone, Copy)]
pub struct RangeVariant {
    range: fn(&Graph) -> bool,
    independent: fn(&Graph) -> bool,
}

fn is_tree(graph: &Graph) -> bool {
    graph.is_connected() && graph.edges().len() + 1 == graph.order()
}

fn examine_range(variant: &RangeVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let graphs = small_graphs();
    let evidence = Evidence::new(
        Grade::Exhaustive,
        "range and rank of B",
        "every labelled graph of up to 4 vertices and every connected one of 5 up to isomorphism; for all graphs the proof is in notes/tanner2.md",
    );
    for graph in &graphs {
        run.checkpoint()?;
        // No edges: no columns, the range is {0}.
        let edges = graph.edges();
        let rank = if edges.is_empty() { 0 } else { edges.len() - graph.incidence()?.kernel().len() };
        // Every column sums to zero, so the range lies in the complement of 1, which has N - 1 dimensions.
        if (variant.range)(graph) && rank + 1 != graph.order() {
            let what = format!("{} vertices, edges {edges:?}: the rank of B is {rank}", graph.order());
            return Ok(Outcome::fails(what, evidence));
        }
        if (variant.independent)(graph) && rank != edges.len() {
            let what = format!("{} vertices, edges {edges:?}: {} columns of rank {rank}", graph.order(), edges.len());
            return Ok(Outcome::fails(what, evidence));
        }
    }
    Ok(Outcome::Holds(vec![evidence.cases(graphs.len())]))
}

pub fn range() -> Record<RangeVariant> {
    let printed = RangeVariant { range: Graph::is_connected, independent: is_tree };
    Record::new(
        "tanner2.rangeB",
        "Every column sums to zero. y^T B = 0 says that y is equal at both ends of every edge, so for a connected graph the range is the whole \
         complement of 1, of dimension N - 1. A tree has N - 1 edges: its columns are independent. (Full rank means full column rank.)",
        printed,
        examine_range,
    )
    .control("any graph", RangeVariant { range: |_| true, ..printed })
    .control("as many edges as vertices", RangeVariant {
        independent: |graph| graph.is_connected() && graph.edges().len() == graph.order(),
        ..printed
    })
}

/// What a new edge does to the eigenvalues.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Growth {
    /// None decreases; the sum increases by two.
    NoneDecreases,
    /// Every eigenvalue but the zero one increases.
    AllIncrease,
    /// The second smallest increases.
    SecondIncreases,
    /// None increases by more than one.
    AtMostOne,
}

/// The eigenvalues from the smallest on, if all are rational.
fn rational_spectrum(graph: &Graph) -> Result<Option<Vec<Rational>>, CheckError> {
    let values = graph.laplacian()?.characteristic_polynomial()?.rational_eigenvalues();
    let mut list: Vec<Rational> = values.into_iter().flat_map(|(x, times)| vec![x; times]).collect();
    list.reverse();
    Ok((list.len() == graph.order()).then_some(list))
}

fn examine_growth(variant: &Growth, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    let part = "a new edge and the eigenvalues of L";
    for graph in Arbitrary::connected(5) {
        run.checkpoint()?;
        let order = graph.order();
        let before = graph.laplacian()?.characteristic_polynomial()?;
        for (i, j) in (0..order).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| !graph.has_edge(i, j)) {
            let more = graph.with_edges(&[(i, j)]);
            let after = more.laplacian()?.characteristic_polynomial()?;
            cases += 1;
            // Counts above a grid of rationals, and the eigenvalues themselves where all are rational.
            let lost =
                (0..=8 * order as i64).map(|k| rational(k, 4)).any(|x| after.count_above(&x) < before.count_above(&x));
            let pair = (rational_spectrum(&graph)?, rational_spectrum(&more)?);
            let against = |fails: &dyn Fn(usize, &Rational, &Rational) -> bool| match &pair {
                (Some(a), Some(b)) => (0..order).find(|&k| fails(k, &a[k], &b[k])),
                _ => None,
            };
            let found = match variant {
                Growth::NoneDecreases => {
                    if lost {
                        Some(0)
                    } else {
                        against(&|_, a, b| b < a)
                    }
                }
                Growth::AllIncrease => against(&|k, a, b| k > 0 && b <= a),
                Growth::SecondIncreases => against(&|k, a, b| k == 1 && b <= a),
                Growth::AtMostOne => against(&|_, a, b| b - a > rational(1, 1)),
            };
            if let Some(k) = found {
                let what = format!(
                    "{order} vertices, edges {:?} and then {:?}: eigenvalue {} from below goes {:?}",
                    graph.edges(),
                    (i, j),
                    k + 1,
                    pair.0.zip(pair.1).map(|(a, b)| format!("from {} to {}", a[k], b[k]))
                );
                return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, part, "rational eigenvalues")));
            }
        }
    }
    let detail = "every connected graph of up to 5 vertices and every new edge: numbers of eigenvalues above the multiples of 1/4, and rational eigenvalues; \
                  for all graphs L grows by b b^T, notes/tanner2.md";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exhaustive, part, detail).cases(cases)]))
}

pub fn merris() -> Record<Growth> {
    Record::new(
        "tanner2.cor2_merris",
        "A new edge adds b b^T, which is positive semidefinite of trace 2: no eigenvalue decreases (Courant and Fischer), and their sum increases by 2. \
         \"Generally increases\" is read in this sense. Some may stay: 0 always, 3 from the path to the triangle, lambda_2 = 1 from the star of 4 to the star with \
         an edge.",
        Growth::NoneDecreases,
        examine_growth,
    )
    .control("every eigenvalue but 0 increases", Growth::AllIncrease)
    .control("lambda_2 increases", Growth::SecondIncreases)
    .control("none by more than 1", Growth::AtMostOne)
}
