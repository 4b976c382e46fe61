//! paley.length, paley.eq11.kernel, paley.incid: the Laplacian as a sum over edges.

use super::common::{arcs, digraph, digraphs, holds, identity_of_phases, laplacian, named, squared_lengths};
use algebra::graph::{Graph, WeightedGraph};
use algebra::matrix::{Inertia, SparseMatrix, inertia};
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, Field, Rational, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use models::oscillator::quadratic_form;

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
            fault: Fault::Slip, clauses: Vec::new(),
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
pub fn form_inertia(laplacian: &SparseMatrix) -> Result<Inertia, CheckError> {
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
            fault: Fault::Slip, clauses: Vec::new(),
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
