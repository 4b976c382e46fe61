//! paley.length, paley.eq11.kernel, paley.incid, paley.graph, paley.CN: Laplacians and the tutorial on graphs.

use super::common::squared_lengths;
use super::common::{arcs, circulants, complete, digraph, digraphs, holds, identity_of_phases, laplacian, named};
use crate::arithmetic::identity::RationalIdentity;
use crate::arithmetic::{ArithmeticError, Complex, CosineField, Field, Rational, Ring, rational};
use crate::graph::{Graph, LaplacianKind, WeightedGraph};
use crate::ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use crate::matrix::{Inertia, SparseMatrix, inertia};
use crate::oscillator::{laplacian_rows, quadratic_form};
use crate::spectrum::Polynomial;

/// paley.length.
pub struct EdgeLength;

/// `Q_L = (factor/N) sum |x_j - x_k|^power` over directed edges, on undirected graphs or any.
#[derive(Clone, Copy)]
pub struct LengthVariant {
    factor: (i64, i64),
    directed: bool,
}

struct LengthIdentity {
    graph: WeightedGraph,
    laplacian: SparseMatrix,
    factor: (i64, i64),
}

impl RationalIdentity for LengthIdentity {
    fn variables(&self) -> usize {
        2 * self.graph.order()
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let x: Vec<Complex<T>> = at.chunks(2).map(|pair| Complex::new(pair[0].clone(), pair[1].clone())).collect();
        let share = at[0].ratio(self.factor.0, self.factor.1 * x.len() as i64);
        let lengths = squared_lengths(&self.graph, &x, &at[0]);
        Ok((vec![quadratic_form(&self.laplacian, &x)?], vec![lengths * share]))
    }
}

impl Claim for EdgeLength {
    type Variant = LengthVariant;

    fn id(&self) -> &str {
        "paley.length"
    }

    fn derivation(&self) -> &str {
        "In <x, L x> = sum_k d_k |x_k|^2 - sum_k sum_{j in N_k} <x_k, x_j> each pair of neighbours gives |x_j - x_k|^2 once. The set E of the tutorial has \
         both (j,k) and (k,j) of an undirected edge, so the sum over E is twice that. (It is the total of the squared lengths.)"
    }

    fn printed(&self) -> LengthVariant {
        LengthVariant { factor: (1, 2), directed: false }
    }

    fn repair(&self) -> Option<Repair<LengthVariant>> {
        Some(Repair {
            fault: Fault::Misprint,
            statement: "Q_L(x) = (1/(4N)) sum_{(j,k) in E} |x_j - x_k|^2 for undirected G with both directions of each edge in E (or (1/(2N)) with \
                        each edge counted once): proportional to the total squared length of the edges."
                .to_string(),
            variant: LengthVariant { factor: (1, 4), directed: false },
        })
    }

    fn controls(&self) -> Vec<Control<LengthVariant>> {
        vec![
            Control::new("1/N", LengthVariant { factor: (1, 1), directed: false }),
            Control::new("1/(8N)", LengthVariant { factor: (1, 8), directed: false }),
            Control::new("1/(4N) on directed graphs too", LengthVariant { factor: (1, 4), directed: true }),
        ]
    }

    fn examine(&self, variant: &LengthVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let mut graphs = ["path:2", "path:3", "ring:4", "star:5", "complete:4"]
            .map(named)
            .into_iter()
            .collect::<Result<Vec<_>, _>>()?;
        if variant.directed {
            graphs.insert(0, digraph(2, |k, _| k == 0));
        }
        let mut parts = Vec::new();
        for graph in graphs {
            let names: Vec<String> =
                (1..=graph.order()).flat_map(|k| [format!("Re x{k}"), format!("Im x{k}")]).collect();
            let part = format!("Q_L on the graph {}", arcs(&graph));
            let identity = LengthIdentity { laplacian: laplacian(&graph)?, graph, factor: variant.factor };
            parts.push(identity_of_phases(run, &identity, &names, &part));
        }
        let identities = Run::all(parts)?;
        let proof = "both sides are linear in the weights of the edges, so one edge decides";
        Run::all([Ok(identities), holds([Evidence::new(Grade::Exact, "every undirected graph", proof)])])
    }
}

/// The inertia of the form `<x, L x>` over real vectors.
fn form_inertia(laplacian: &SparseMatrix) -> Result<Inertia, CheckError> {
    let transpose = laplacian.transpose();
    let zero = rational(0, 1);
    let entry = |matrix: &SparseMatrix, i: usize, j: usize| matrix.get(i, j).unwrap_or(&zero).clone();
    let order = laplacian.order();
    let rows: Vec<Vec<Rational>> =
        (0..order).map(|i| (0..order).map(|j| entry(laplacian, i, j) + entry(&transpose, i, j)).collect()).collect();
    Ok(inertia(&rows)?)
}

/// paley.eq11.kernel.
pub struct Kernel;

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

impl Claim for Kernel {
    type Variant = KernelVariant;

    fn id(&self) -> &str {
        "paley.eq11.kernel"
    }

    fn derivation(&self) -> &str {
        "Q_L is a sum of |x_j - x_k|^2 over the edges (paley.length): not negative, and zero exactly if x is equal across every edge, that is, constant on a \
         connected graph. x = u + iv: the form is u^T L u + v^T L v, so the span is over the complex numbers."
    }

    fn printed(&self) -> KernelVariant {
        KernelVariant::Connected
    }

    fn controls(&self) -> Vec<Control<KernelVariant>> {
        vec![
            Control::new("every undirected graph", KernelVariant::Undirected),
            Control::new("strongly connected digraphs", KernelVariant::StronglyConnected),
        ]
    }

    fn examine(&self, variant: &KernelVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let most = if *variant == KernelVariant::StronglyConnected { 3 } else { run.cases(4, 5) };
        let mut cases = 0;
        for order in 1..=most {
            run.checkpoint()?;
            let graphs: Vec<WeightedGraph> = match variant {
                KernelVariant::Connected => {
                    Graph::all(order).filter(Graph::is_connected).map(|graph| WeightedGraph::from(&graph)).collect()
                }
                KernelVariant::Undirected => Graph::all(order).map(|graph| WeightedGraph::from(&graph)).collect(),
                KernelVariant::StronglyConnected => {
                    digraphs(order).filter(WeightedGraph::is_strongly_connected).collect()
                }
            };
            for graph in graphs {
                cases += 1;
                let found = form_inertia(&laplacian(&graph)?)?;
                if found != (Inertia { positive: order - 1, negative: 0, zero: 1 }) {
                    return Ok(Outcome::fails(
                        format!("N = {order}, {}: the form has {found:?}", arcs(&graph)),
                        Evidence::new(Grade::Exact, "kernel", "exact inertia of L + L^T"),
                    ));
                }
            }
        }
        let detail = format!(
            "exact inertia (N - 1, 0, 1) for all labelled graphs of up to {most} nodes; for all by the sum of squares"
        );
        holds([Evidence::new(Grade::Exhaustive, "positive but on span{1}", detail).cases(cases)])
    }
}

/// paley.incid.
pub struct Incidence;

/// The columns of `B`, their lower sign, and the factor in `L = factor B B^T`.
#[derive(Clone, Copy)]
pub struct IncidenceVariant {
    both_directions: bool,
    tail: i64,
    factor: (i64, i64),
}

impl Claim for Incidence {
    type Variant = IncidenceVariant;

    fn id(&self) -> &str {
        "paley.incid"
    }

    fn derivation(&self) -> &str {
        "A column with 1 and -1 adds to B B^T the Laplacian of its edge, whatever its direction. For undirected G the set E of directed edges holds each edge \
         twice, so B B^T = 2 L."
    }

    fn printed(&self) -> IncidenceVariant {
        IncidenceVariant { both_directions: true, tail: -1, factor: (1, 1) }
    }

    fn repair(&self) -> Option<Repair<IncidenceVariant>> {
        Some(Repair {
            fault: Fault::Misprint,
            statement: "For undirected G, L = B B^T if B has one column for each undirected edge, directed either way; with one column for each \
                        directed edge in E, L = (1/2) B B^T."
                .to_string(),
            variant: IncidenceVariant { both_directions: false, tail: -1, factor: (1, 1) },
        })
    }

    fn controls(&self) -> Vec<Control<IncidenceVariant>> {
        vec![
            Control::new(
                "half of B B^T with a column for each undirected edge",
                IncidenceVariant { both_directions: false, tail: -1, factor: (1, 2) },
            ),
            Control::new("both entries 1", IncidenceVariant { both_directions: false, tail: 1, factor: (1, 1) }),
            Control::new("a third", IncidenceVariant { both_directions: true, tail: -1, factor: (1, 3) }),
        ]
    }

    fn examine(&self, variant: &IncidenceVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let most = run.cases(4, 5);
        let mut cases = 0;
        for graph in (1..=most).flat_map(Graph::all) {
            run.checkpoint()?;
            let one_way = graph.edges();
            let reversed = one_way.iter().map(|&(j, k)| (k, j)).filter(|_| variant.both_directions);
            let columns: Vec<(usize, usize)> = one_way.iter().copied().chain(reversed).collect();
            // Column (j, k): b_k = 1, b_j = tail; B B^T is the sum of the products of columns.
            let entries = columns.iter().flat_map(|&(j, k)| {
                let column = [(k, 1), (j, variant.tail)];
                column.into_iter().flat_map(move |(a, x)| column.map(|(b, y)| (a, b, x * y)))
            });
            let factor = rational(variant.factor.0, variant.factor.1);
            let product = SparseMatrix::from_entries(
                graph.order(),
                entries.map(|(a, b, entry)| (a, b, rational(entry, 1) * &factor)),
            );
            cases += 1;
            if product != laplacian(&WeightedGraph::from(&graph))? {
                return Ok(Outcome::fails(
                    format!(
                        "N = {}, undirected edges {:?} (from 0): the product has {} in the corner of its first edge, not L",
                        graph.order(),
                        one_way,
                        one_way
                            .first()
                            .and_then(|&(i, _)| product.get(i, i))
                            .map_or("0".to_string(), Rational::to_string)
                    ),
                    Evidence::new(Grade::Exact, "B B^T", "exact product"),
                ));
            }
        }
        let detail =
            format!("all labelled graphs of up to {most} nodes; for all because both sides add up over the edges");
        holds([Evidence::new(Grade::Exhaustive, "L and B B^T", detail).cases(cases)])
    }
}

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
