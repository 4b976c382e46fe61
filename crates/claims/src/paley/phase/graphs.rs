//! paley.length, paley.eq11.kernel, paley.incid: the Laplacian as a sum over edges.

use super::common::{arcs, arcs_of, laplacian, named, supports};
use crate::prelude::*;
use algebra::graph::{Graph, WeightedGraph};
use algebra::matrix::{Inertia, SparseMatrix};
use models::oscillator::{quadratic_form, squared_lengths};

/// `Q_L = (factor/N) sum |x_j - x_k|^2` over directed edges, on undirected graphs or any.
#[derive(Clone, Copy)]
pub struct LengthVariant {
    factor: (i64, i64),
    directed: bool,
}

/// Variables are the real and imaginary parts of `x`.
fn lengths(laplacian: SparseMatrix, graph: WeightedGraph, factor: (i64, i64)) -> Identity<'static> {
    Identity::new(2 * graph.order(), move |at| {
        let x: Vec<Complex<Probe>> = at.chunks(2).map(|pair| Complex::new(pair[0].clone(), pair[1].clone())).collect();
        let share = at[0].ratio(factor.0, factor.1 * x.len() as i64);
        let lengths = squared_lengths(&graph, &x, &at[0]);
        Ok((vec![quadratic_form(&laplacian, &x)?], vec![lengths * share]))
    })
}

pub fn edge_length() -> Record<LengthVariant> {
    Record::new(
        "paley.length",
        "In <x, L x> = sum_k d_k |x_k|^2 - sum_k sum_{j in N_k} <x_k, x_j> each pair of neighbours gives |x_j - x_k|^2 once. The set E of the tutorial has \
         both (j,k) and (k,j) of an undirected edge, so the sum over E is twice that. (It is the total of the squared lengths.)",
        LengthVariant { factor: (1, 2), directed: false },
        |variant, run| {
            let mut graphs: Vec<_> = ["path:2", "path:3", "ring:4", "star:5", "complete:4"].map(named).into();
            if variant.directed {
                graphs.insert(0, Ok(WeightedGraph::from_fn(2, |k, _| k == 0)));
            }
            let names: Vec<String> = (1..=5).flat_map(|k| [format!("Re x{k}"), format!("Im x{k}")]).collect();
            let tests = graphs.into_iter().map(|graph| {
                let graph = graph?;
                let (order, part) = (graph.order(), format!("Q_L on the graph {}", arcs(&graph)));
                let seen = arcs_of(&graph);
                let tested = run.identity(&lengths(laplacian(&graph)?, graph, variant.factor), &names[..2 * order], &part);
                tested.map(|outcome| outcome.seen(seen))
            });
            Ok(supports(Run::all(tests)?, &[1]))
        },
    )
    .repaired(Fault::Slip, "", LengthVariant { factor: (1, 4), directed: false })
    .repaired_clauses(&[
        "For undirected G, Q_L(x) = (1/(4N)) sum_{(j,k) in E} |x_j - x_k|^2 with both directions of each edge in E.",
        "With each edge counted once it is (1/(2N)) sum |x_j - x_k|^2.",
    ])
    .altered("1/N", |v| v.factor = (1, 1))
    .altered("1/(4N) on directed graphs too", |v| v.directed = true)
}

/// The graphs for which `Q_L` is claimed to vanish on `span{1}` only and to be positive elsewhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum KernelVariant {
    /// Undirected and connected.
    Connected,
    /// Undirected.
    Undirected,
    /// Directed and strongly connected.
    StronglyConnected,
}

impl KernelVariant {
    fn graphs(self, order: usize) -> Vec<WeightedGraph> {
        let undirected = Graph::all(order).filter(|graph| self == KernelVariant::Undirected || graph.is_connected());
        match self {
            KernelVariant::StronglyConnected => {
                WeightedGraph::all(order).filter(WeightedGraph::is_strongly_connected).collect()
            }
            _ => undirected.map(|graph| WeightedGraph::from(&graph)).collect(),
        }
    }
}

pub fn kernel() -> Record<KernelVariant> {
    Record::new(
        "paley.eq11.kernel",
        "Q_L is a sum of |x_j - x_k|^2 over the edges (paley.length): not negative, and zero exactly if x is equal across every edge, that is, constant on a \
         connected graph. x = u + iv: the form is u^T L u + v^T L v, so the span is over the complex numbers.",
        KernelVariant::Connected,
        |variant, run| {
            let most = if *variant == KernelVariant::StronglyConnected { 3 } else { run.cases(4, 5) };
            let detail = format!("exact inertia (N - 1, 0, 1) for all labelled graphs of up to {most} nodes");
            let evidence = exhaustive("positive but on span{1}", detail).on([1, 2]);
            run.every(evidence, (1..=most).flat_map(|order| variant.graphs(order)), |graph| {
                let (order, found) = (graph.order(), laplacian(&graph)?.form_inertia()?);
                let right = found == Inertia { positive: order - 1, negative: 0, zero: 1 };
                Ok((!right).then(|| format!("N = {order}, {}: the form has {found:?}", arcs(&graph))))
            })
        },
    )
    .clauses(&[
        "If G is undirected and connected, then Q_L(x) = 0 if and only if x in span{1}.",
        "Q_L(x) > 0 otherwise.",
    ])
    .control("every undirected graph", KernelVariant::Undirected)
    .control("strongly connected digraphs", KernelVariant::StronglyConnected)
}

/// The lower sign in the columns of `B`, and the factors in `L = factor B B^T` with a column for each undirected edge and with one for each
/// directed edge, as far as they are claimed.
#[derive(Clone, Copy)]
pub struct IncidenceVariant {
    tail: i64,
    once: Option<(i64, i64)>,
    twice: Option<(i64, i64)>,
}

pub fn incidence() -> Record<IncidenceVariant> {
    Record::new(
        "paley.incid",
        "A column with 1 and -1 adds to B B^T the Laplacian of its edge, whatever its direction. For undirected G the set E of directed edges holds each edge \
         twice, so B B^T = 2 L.",
        IncidenceVariant { tail: -1, once: None, twice: Some((1, 1)) },
        examine_incidence,
    )
    .repaired(Fault::Slip, "", IncidenceVariant { tail: -1, once: Some((1, 1)), twice: Some((1, 2)) })
    .repaired_clauses(&[
        "For undirected G, L = B B^T if B has one column for each undirected edge, directed either way.",
        "With one column for each directed edge in E, for the same G, L = (1/2) B B^T.",
    ])
    .altered("half of B B^T with a column for each undirected edge", |v| v.once = Some((1, 2)))
    .altered("both entries 1", |v| v.tail = 1)
    .altered("a third with a column for each directed edge", |v| v.twice = Some((1, 3)))
}

fn examine_incidence(variant: &IncidenceVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let most = run.cases(4, 5);
    let detail = format!("all labelled graphs of up to {most} nodes");
    let evidence = exhaustive("L and B B^T", detail);
    let graphs = run.every(evidence, (1..=most).flat_map(Graph::all), |graph| {
        let turned = |(place, &(j, k)): (usize, &(usize, usize))| if place % 2 == 0 { (j, k) } else { (k, j) };
        let once: Vec<(usize, usize)> = graph.edges().iter().enumerate().map(turned).collect();
        let twice: Vec<(usize, usize)> = once.iter().flat_map(|&(j, k)| [(j, k), (k, j)]).collect();
        let own = laplacian(&WeightedGraph::from(&graph))?;
        for (columns, factor) in [(&once, variant.once), (&twice, variant.twice)] {
            let Some(factor) = factor else { continue };
            let product = incidence_product(graph.order(), columns, variant.tail, &rational(factor.0, factor.1));
            if product != own {
                let corner =
                    columns.first().and_then(|&(i, _)| product.get(i, i)).map_or("0".into(), Rational::to_string);
                let what = format!("N = {}, columns {columns:?} (nodes from 0)", graph.order());
                return Ok(Some(format!("{what}: the product has {corner} in the corner of its first edge, not L")));
            }
        }
        Ok(None)
    })?;
    let proof = argued(&[1, 2], "every undirected graph", "notes/paley_phases.md, steps L3");
    Run::all([Ok(supports(graphs, &[1, 2])).checks("step L3"), proof])
}

/// `factor B B^T` with the columns `b_k = 1`, `b_j = tail` for `(j, k)`: the sum of the products of columns.
fn incidence_product(order: usize, columns: &[(usize, usize)], tail: i64, factor: &Rational) -> SparseMatrix {
    let entries = columns.iter().flat_map(|&(j, k)| {
        let column = [(k, 1), (j, tail)];
        column.into_iter().flat_map(move |(a, x)| column.map(|(b, y)| (a, b, rational(x * y, 1) * factor)))
    });
    SparseMatrix::from_entries(order, entries)
}
