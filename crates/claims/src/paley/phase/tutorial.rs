//! paley.graph, paley.CN: the facts of the tutorial on graphs.

use super::common::{arcs, laplacian, named};
use crate::prelude::*;
use algebra::graph::{Graph, LaplacianKind, WeightedGraph};
use algebra::spectrum::Polynomial;
use arithmetic::CosineField;
use models::oscillator::{circulant_eigenvalue, laplacian_rows};

/// Hypotheses and conventions of the facts about Laplacians.
#[derive(Clone, Copy)]
pub struct LaplacianVariant {
    kind: LaplacianKind,
    /// Zero is claimed to be simple for every digraph, not only strongly connected ones.
    simple_for_all: bool,
    /// Exponent of the entries of `F`.
    exponent: fn(m: usize, k: usize) -> usize,
}

impl LaplacianVariant {
    fn fails_at(&self, graph: &WeightedGraph) -> Result<Option<&'static str>, CheckError> {
        let matrix = graph.matrix(self.kind)?;
        if matrix.row_sums().iter().any(|sum| *sum != rational(0, 1)) {
            return Ok(Some("L 1 is not zero"));
        }
        let polynomial = matrix.to_dense()?.characteristic_polynomial()?;
        // The eigenvalues of -L but for zero lie in the open left half plane: the discs touch the axis at zero only.
        let (multiplicity, rest) = Polynomial::from_rationals(&polynomial.coefficients()).without_root(0);
        let turned =
            rest.coefficients().iter().enumerate().map(|(k, c)| if k % 2 == 0 { c.clone() } else { -c.clone() });
        if rest.degree() > 0 && !Polynomial::new(turned.collect()).is_hurwitz() {
            return Ok(Some("an eigenvalue has a negative real part"));
        }
        if multiplicity != 1 && (self.simple_for_all || graph.is_strongly_connected()) {
            return Ok(Some("zero is a multiple eigenvalue"));
        }
        if graph.is_undirected() && (!matrix.is_symmetric() || matrix.form_inertia()?.negative > 0) {
            return Ok(Some("not symmetric positive semidefinite"));
        }
        Ok(None)
    }

    /// Whether the columns of `F` are eigenvectors of a circulant Laplacian, with the eigenvalues `sum_s (1 - w^((m - 1) s))`.
    fn diagonalises(&self, graph: &WeightedGraph, offsets: &[usize]) -> Result<bool, CheckError> {
        let order = graph.order();
        let field = CosineField::new(order as u32);
        let roots: Vec<_> = (0..order).map(|k| field.phasor(k as i64)).collect();
        let matrix = laplacian(graph)?;
        for m in 1..=order {
            let column: Vec<_> = (1..=order).map(|k| field.phasor((self.exponent)(m, k) as i64)).collect();
            let value = circulant_eigenvalue(&roots, offsets.iter().copied(), m - 1);
            let image = laplacian_rows(&matrix, &column);
            if image.iter().zip(&column).any(|(image, x)| *image != x.clone() * &value) {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

pub fn laplacians() -> Record<LaplacianVariant> {
    let exponent = |m, k| (m - 1) * (k - 1);
    let printed = LaplacianVariant { kind: LaplacianKind::OutDegree, simple_for_all: false, exponent };
    Record::new(
        "paley.graph",
        "Gershgorin's discs have centre d_k and radius d_k: they lie in the right half plane and touch the axis at 0. Rows sum to zero. Strongly \
         connected: for c > max d_k the matrix cI - L is nonnegative and irreducible with row sums c, its simple Perron root, so 0 is a simple \
         eigenvalue of L. Undirected: a sum of squares. A circulant matrix with first row c has L f_m = (sum_s c_s w^(ms)) f_m for every column f_m of \
         F, directed or not.",
        printed,
        examine_laplacians,
    )
    .clauses(&[
        "All eigenvalues of L = D - A have nonnegative real part.",
        "L 1 = 0.",
        "If G is strongly connected the eigenvalue zero has multiplicity one.",
        "If G is undirected, L is symmetric positive semidefinite.",
        "If G is circulant, L is diagonalized by the discrete Fourier transform matrix.",
    ])
    .altered("zero simple for every digraph", |v| v.simple_for_all = true)
    .altered("D with the column sums of A", |v| v.kind = LaplacianKind::InDegree)
    .altered("F with (m - 1)(k - 1)^2", |v| v.exponent = |m, k| (m - 1) * (k - 1) * (k - 1))
}

fn examine_laplacians(variant: &LaplacianVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let (most, most_circulant) = (run.cases(3, 4), run.cases(6, 7));
    let named: Vec<_> = ["path:5", "star:5", "ring:6", "complete:5", "cycle:5"].map(named).into();
    let detail = format!("all digraphs of up to {most} nodes and some larger graphs: exact characteristic polynomials");
    let facts = exhaustive("real parts, L 1 = 0, simple zero, semidefinite", detail).on([1, 2, 3, 4]);
    let facts = run.every(facts, (1..=most).flat_map(WeightedGraph::all).map(Ok).chain(named), |graph| {
        let graph = graph?;
        let place = || format!("N = {}, {} (k->j: j is a neighbour of k)", graph.order(), arcs(&graph));
        Ok(variant.fails_at(&graph)?.map(|what| format!("{}: {what}", place())))
    });
    let detail = format!("all directed circulants of up to {most_circulant} nodes, exact roots of unity");
    let columns = exhaustive("F diagonalises circulants", detail).on([5]);
    let columns = run.every(
        columns,
        (1..=most_circulant).flat_map(|n| WeightedGraph::circulants(n, false)),
        |(offsets, graph)| {
            let wrong = !variant.diagonalises(&graph, &offsets)?;
            let place = || format!("circulant with N = {}, offsets {offsets:?}", graph.order());
            Ok(wrong.then(|| format!("{}: a column of F is no eigenvector", place())))
        },
    );
    Run::all([facts, columns])
}

/// First rows, and the least `N` for `C_N`.
#[derive(Clone, Copy)]
pub struct NamedVariant {
    complete_row: fn(usize) -> Vec<i64>,
    cyclic_row: fn(usize) -> Vec<i64>,
    least_cycle: usize,
}

pub fn named_laplacians() -> Record<NamedVariant> {
    let printed = NamedVariant {
        complete_row: |n| (0..n).map(|k| if k == 0 { n as i64 - 1 } else { -1 }).collect(),
        cyclic_row: |n| (0..n).map(|k| if k == 0 { 2 } else { -i64::from(k == 1 || k == n - 1) }).collect(),
        least_cycle: 3,
    };
    Record::new("paley.CN", "By definition. For N = 3 the row of C_N is (2, -1, -1).", printed, examine_named)
        .reading("C_N is meant for N >= 3: two nodes cannot have two neighbours each")
        .clauses(&[
            "K_N, each node of degree N - 1, has first Laplacian row (N-1, -1, ..., -1).",
            "The undirected cyclic graph C_N is connected.",
            "Each of its nodes has degree 2.",
            "Its first Laplacian row is (2, -1, 0, ..., 0, -1).",
        ])
        .altered("C_2 too", |v| v.least_cycle = 2)
        .altered("(2, -1, 0, ..., 0)", |v| {
            v.cyclic_row = |n| (0..n).map(|k| [2, -1].get(k).copied().unwrap_or(0)).collect()
        })
        .altered("(N, -1, ..., -1)", |v| {
            v.complete_row = |n| (0..n).map(|k| if k == 0 { n as i64 } else { -1 }).collect()
        })
}

fn examine_named(variant: &NamedVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const LARGEST: usize = 16;
    let first_row = |graph: &WeightedGraph| -> Result<Vec<Rational>, CheckError> {
        let matrix = laplacian(graph)?;
        Ok((0..graph.order()).map(|j| matrix.get(0, j).cloned().unwrap_or_else(|| rational(0, 1))).collect())
    };
    let wrong = |graph: &WeightedGraph, row: Vec<i64>, degree: i64| -> Result<Option<String>, CheckError> {
        let claimed: Vec<Rational> = row.into_iter().map(|x| rational(x, 1)).collect();
        let regular = graph.out_degrees() == vec![rational(degree, 1); graph.order()];
        let fine = regular && graph.is_undirected() && graph.is_strongly_connected() && first_row(graph)? == claimed;
        let found = format!("degrees {}, first row ({})", list(graph.out_degrees()), list(first_row(graph)?));
        Ok((!fine).then_some(found))
    };
    let complete_graphs = run.every(exact("K_1 to K_16", "exact matrices").on([1]), 1..=LARGEST, |n| {
        let found = wrong(&WeightedGraph::complete(n), (variant.complete_row)(n), n as i64 - 1)?;
        Ok(found.map(|what| format!("K_{n}: {what}")))
    });
    let evidence = exact("C_3 to C_16", "exact matrices").on([2, 3, 4]);
    let cycles = run.every(evidence, variant.least_cycle..=LARGEST, |n| {
        let graph = WeightedGraph::from(&Graph::ring(n));
        Ok(wrong(&graph, (variant.cyclic_row)(n), 2)?.map(|what| format!("C_{n}: {what}")))
    });
    Run::all([complete_graphs, cycles])
}
