//! paley.graph, paley.CN: the facts of the tutorial on graphs.

use super::common::{arcs, circulants, complete, digraph, digraphs, holds, laplacian, named};
use super::graphs::form_inertia;
use algebra::graph::{LaplacianKind, WeightedGraph};
use algebra::spectrum::Polynomial;
use arithmetic::{CosineField, Rational, Ring, rational};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run};
use models::oscillator::laplacian_rows;

/// paley.graph.
pub struct Laplacians;

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
        let matrix = graph.matrix(self.kind).map_err(|error| CheckError::Other(error.to_string()))?;
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
        if graph.is_undirected() && (!matrix.is_symmetric() || form_inertia(&matrix)?.negative > 0) {
            return Ok(Some("not symmetric positive semidefinite"));
        }
        Ok(None)
    }

    /// Whether the columns of `F` are eigenvectors of a circulant Laplacian.
    fn diagonalises(&self, graph: &WeightedGraph, offsets: &[usize]) -> Result<bool, CheckError> {
        let order = graph.order();
        let field = CosineField::new(order as u32);
        let matrix = laplacian(graph)?;
        for m in 1..=order {
            let column: Vec<_> = (1..=order).map(|k| field.phasor((self.exponent)(m, k) as i64)).collect();
            let one = column[0].one();
            let value = offsets
                .iter()
                .fold(one.integer(offsets.len() as i64), |sum, s| sum - field.phasor(((m - 1) * s) as i64));
            let image = laplacian_rows(&matrix, &column);
            if image.iter().zip(&column).any(|(image, x)| *image != x.clone() * &value) {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

impl Claim for Laplacians {
    type Variant = LaplacianVariant;

    fn id(&self) -> &str {
        "paley.graph"
    }

    fn derivation(&self) -> &str {
        "Gershgorin's discs have centre d_k and radius d_k: they lie in the right half plane and touch the axis at 0. Rows sum to zero. Strongly \
         connected: for c > max d_k the matrix cI - L is nonnegative and irreducible with row sums c, its simple Perron root, so 0 is a simple \
         eigenvalue of L. Undirected: a sum of squares. A circulant matrix with first row c has L f_m = (sum_s c_s w^(ms)) f_m for every column f_m of \
         F, directed or not (notes/paley_phases.md)."
    }

    fn printed(&self) -> LaplacianVariant {
        let exponent = |m, k| (m - 1) * (k - 1);
        LaplacianVariant { kind: LaplacianKind::OutDegree, simple_for_all: false, exponent }
    }

    fn controls(&self) -> Vec<Control<LaplacianVariant>> {
        let printed = self.printed();
        vec![
            Control::new("zero simple for every digraph", LaplacianVariant { simple_for_all: true, ..printed }),
            Control::new("D with the column sums of A", LaplacianVariant { kind: LaplacianKind::InDegree, ..printed }),
            Control::new(
                "F with (m - 1)(k - 1)^2",
                LaplacianVariant { exponent: |m, k| (m - 1) * (k - 1) * (k - 1), ..printed },
            ),
        ]
    }

    fn examine(&self, variant: &LaplacianVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let (most, most_circulant) = (run.cases(3, 4), run.cases(6, 7));
        let fails =
            |what: String| Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "Laplacians", "exact matrices")));
        let (mut cases, mut circulant_cases) = (0, 0);
        let named_graphs = ["path:5", "star:5", "ring:6", "complete:5", "cycle:5"]
            .map(named)
            .into_iter()
            .collect::<Result<Vec<_>, _>>()?;
        for graph in (1..=most).flat_map(digraphs).chain(named_graphs) {
            run.checkpoint()?;
            cases += 1;
            if let Some(what) = variant.fails_at(&graph)? {
                return fails(format!("N = {}, {} (k takes account of j): {what}", graph.order(), arcs(&graph)));
            }
        }
        for order in 1..=most_circulant {
            for (offsets, graph) in circulants(order, false) {
                run.checkpoint()?;
                circulant_cases += 1;
                if !variant.diagonalises(&graph, &offsets)? {
                    return fails(format!(
                        "circulant with N = {order}, offsets {offsets:?}: a column of F is no eigenvector"
                    ));
                }
            }
        }
        let all = format!(
            "all digraphs of up to {most} nodes and some larger graphs: exact characteristic polynomials; proofs for all in the notes"
        );
        let circulant = format!("all directed circulants of up to {most_circulant} nodes, exact roots of unity");
        holds([
            Evidence::new(Grade::Exhaustive, "real parts, L 1 = 0, simple zero, semidefinite", all).cases(cases),
            Evidence::new(Grade::Exhaustive, "F diagonalises circulants", circulant).cases(circulant_cases),
        ])
    }
}

/// paley.CN.
pub struct NamedLaplacians;

/// First rows, the degree of the nodes of `C_N`, and the least `N` for `C_N`.
#[derive(Clone, Copy)]
pub struct NamedVariant {
    complete_row: fn(usize) -> Vec<i64>,
    cyclic_row: fn(usize) -> Vec<i64>,
    least_cycle: usize,
}

impl Claim for NamedLaplacians {
    type Variant = NamedVariant;

    fn id(&self) -> &str {
        "paley.CN"
    }

    fn derivation(&self) -> &str {
        "By definition. C_N is there for N >= 3: two nodes cannot have two neighbours each (a control), and for N = 3 the row is (2, -1, -1)."
    }

    fn printed(&self) -> NamedVariant {
        NamedVariant {
            complete_row: |n| (0..n).map(|k| if k == 0 { n as i64 - 1 } else { -1 }).collect(),
            cyclic_row: |n| (0..n).map(|k| if k == 0 { 2 } else { -i64::from(k == 1 || k == n - 1) }).collect(),
            least_cycle: 3,
        }
    }

    fn controls(&self) -> Vec<Control<NamedVariant>> {
        let printed = self.printed();
        vec![
            Control::new("C_2 too", NamedVariant { least_cycle: 2, ..printed }),
            Control::new(
                "(2, -1, 0, ..., 0)",
                NamedVariant {
                    cyclic_row: |n| (0..n).map(|k| [2, -1].get(k).copied().unwrap_or(0)).collect(),
                    ..printed
                },
            ),
            Control::new(
                "(N, -1, ..., -1)",
                NamedVariant {
                    complete_row: |n| (0..n).map(|k| if k == 0 { n as i64 } else { -1 }).collect(),
                    ..printed
                },
            ),
        ]
    }

    fn examine(&self, variant: &NamedVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const LARGEST: usize = 16;
        run.checkpoint()?;
        let first_row = |graph: &WeightedGraph| -> Result<Vec<Rational>, CheckError> {
            let matrix = laplacian(graph)?;
            Ok((0..graph.order()).map(|j| matrix.get(0, j).cloned().unwrap_or_else(|| rational(0, 1))).collect())
        };
        let as_claimed = |row: Vec<i64>| -> Vec<Rational> { row.into_iter().map(|x| rational(x, 1)).collect() };
        let fails =
            |what: String| Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "first rows", "exact matrices")));
        for n in 1..=LARGEST {
            let graph = complete(n);
            if first_row(&graph)? != as_claimed((variant.complete_row)(n))
                || graph.out_degrees() != vec![rational(n as i64 - 1, 1); n]
            {
                return fails(format!("K_{n}: the first row is {:?}", first_row(&graph)?));
            }
        }
        for n in variant.least_cycle..=LARGEST {
            let graph = digraph(n, |k, j| (k + 1) % n == j || (j + 1) % n == k);
            let fine = graph.is_strongly_connected()
                && graph.is_undirected()
                && graph.out_degrees() == vec![rational(2, 1); n];
            if !fine || first_row(&graph)? != as_claimed((variant.cyclic_row)(n)) {
                return fails(format!("C_{n}: degrees {:?}, first row {:?}", graph.out_degrees(), first_row(&graph)?));
            }
        }
        holds([Evidence::new(
            Grade::Exact,
            "first rows and degrees",
            "K_1 to K_16 and C_3 to C_16; the same for all N",
        )
        .cases(2 * LARGEST - 2)])
    }
}
