//! paley.eq12.pos, paley.zero.dir, paley.fish.zero: where the Laplacian phase potential vanishes.

use super::common::{all_equal, arcs, digraphs, holds, identity_of_phases, laplacian, names, phasors, squared_lengths};
use super::common::{turns, up_to_rotation};
use algebra::graph::{Graph, WeightedGraph};
use algebra::matrix::SparseMatrix;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, Field, Rational, Ring, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use models::oscillator::phase_potential;
use num_traits::{Signed as _, Zero};

/// Phases of the exhaustive searches: quarter turns.
const PARTS: usize = 4;

/// The parts of a graph within which phases are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Parts {
    /// Strongly connected components.
    Strong,
    /// Connected components, the directions of the arcs forgotten.
    Weak,
    /// The whole graph.
    Whole,
}

impl Parts {
    fn of(self, graph: &WeightedGraph) -> Vec<Vec<usize>> {
        let either = |i: usize, j: usize| graph.adjacency().get(i, j).or(graph.adjacency().get(j, i)).is_some();
        match self {
            Parts::Strong => graph.adjacency().strong_components(),
            Parts::Weak => Graph::from_fn(graph.order(), either).components(),
            Parts::Whole => vec![(0..graph.order()).collect()],
        }
    }

    fn synchronised(self, graph: &WeightedGraph, exponents: &[usize]) -> bool {
        let parts = self.of(graph);
        parts.iter().all(|part| all_equal(&part.iter().map(|&k| exponents[k]).collect::<Vec<_>>()))
    }
}

/// Every digraph of up to so many nodes with every arrangement of quarter turns and its potential, until one contradicts.
fn first_contradiction(
    run: &Run,
    contradicts: impl Fn(&WeightedGraph, &[usize], &Rational) -> bool,
) -> Result<(usize, Option<String>), CheckError> {
    let quarter = Complex::new(rational(0, 1), rational(1, 1));
    let mut cases = 0;
    for order in 1..=run.cases(3, 4) {
        for graph in digraphs(order) {
            run.checkpoint()?;
            let laplacian = laplacian(&graph)?;
            for exponents in up_to_rotation(order, PARTS) {
                let z: Vec<Complex<Rational>> = exponents.iter().map(|&k| quarter.power(k as u64)).collect();
                let value = phase_potential(&laplacian, &z, 1)?;
                cases += 1;
                if contradicts(&graph, &exponents, &value) {
                    let place = turns(&exponents, PARTS);
                    let what =
                        format!("N = {order}, {} (k->j: k takes account of j), {place}: W_1 = {value}", arcs(&graph));
                    return Ok((cases, Some(what)));
                }
            }
        }
    }
    Ok((cases, None))
}

fn exhaustive(part: &str, cases: usize) -> Evidence {
    let detail = "all digraphs of up to 3 nodes (4 with --full) with all arrangements of quarter turns; for all by the sum of squares";
    Evidence::new(Grade::Exhaustive, part, detail).cases(cases)
}

/// `W_1 = (1/(4N)) sum over arcs of |z_k - z_j|^2`, on a complete digraph with different weights.
struct SumOfSquares {
    graph: WeightedGraph,
    laplacian: SparseMatrix,
    factor: (i64, i64),
}

impl SumOfSquares {
    fn new(order: usize, factor: (i64, i64)) -> Result<Self, CheckError> {
        let pairs = (0..order * order).map(|place| (place / order, place % order)).filter(|(k, j)| k != j);
        let arcs = pairs.enumerate().map(|(place, (k, j))| (k, j, rational((place * place) as i64 + 1, 3)));
        let graph = WeightedGraph::from_arcs(order, arcs);
        Ok(SumOfSquares { laplacian: laplacian(&graph)?, graph, factor })
    }
}

impl RationalIdentity for SumOfSquares {
    fn variables(&self) -> usize {
        self.graph.order()
    }

    fn sides<T: Field>(&self, t: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let z = phasors(t)?;
        let share = t[0].ratio(self.factor.0, self.factor.1 * z.len() as i64);
        // d_k - sum <z_k, z_j>, with the weights of the arcs.
        let cosines = self
            .graph
            .adjacency()
            .entries()
            .fold(t[0].zero(), |sum, (k, j, weight)| sum + (t[0].one() - z[k].dot(&z[j])) * t[0].rational(weight));
        let squares = squared_lengths(&self.graph, &z, &t[0]) * &share * t[0].ratio(1, 2);
        let potential = phase_potential(&self.laplacian, &z, 1)?;
        Ok((vec![potential.clone(), potential], vec![cosines * share, squares]))
    }
}

fn sum_of_squares(run: &Run, factor: (i64, i64)) -> Result<Outcome, CheckError> {
    let part = "W_1 as a sum over arcs of 1 - cos theta_kj = |z_k - z_j|^2/2";
    let parts = (2..=3).map(|order| {
        identity_of_phases(run, &SumOfSquares::new(order, factor)?, &names(order, &[]), &format!("{part}, N = {order}"))
    });
    Run::all(parts)
}

/// paley.eq12.pos.
pub struct Connected;

/// The graphs for which `W_1 = 0` exactly at synchronised phases, a factor, and a bound elsewhere.
#[derive(Clone, Copy)]
pub struct ConnectedVariant {
    applies: fn(&WeightedGraph) -> bool,
    factor: (i64, i64),
    above: (i64, i64),
}

impl Claim for Connected {
    type Variant = ConnectedVariant;

    fn id(&self) -> &str {
        "paley.eq12.pos"
    }

    fn derivation(&self) -> &str {
        "Row k of L z is d_k z_k - sum z_j, which gives the display. Each term is 1 - cos theta_kj >= 0, zero exactly at equal phases. So W_1 = 0 exactly if \
         phases are equal across every arc; if the graph is strongly connected (weakly is enough), they are all equal."
    }

    fn printed(&self) -> ConnectedVariant {
        ConnectedVariant { applies: WeightedGraph::is_strongly_connected, factor: (1, 2), above: (0, 1) }
    }

    fn controls(&self) -> Vec<Control<ConnectedVariant>> {
        let printed = self.printed();
        vec![
            Control::new("every digraph", ConnectedVariant { applies: |_| true, ..printed }),
            Control::new("1/N instead of 1/(2N)", ConnectedVariant { factor: (1, 1), ..printed }),
            Control::new("above 1/2 where positive", ConnectedVariant { above: (1, 2), ..printed }),
        ]
    }

    fn examine(&self, variant: &ConnectedVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let formula = sum_of_squares(run, variant.factor)?;
        if !matches!(formula, Outcome::Holds(_)) {
            return Ok(formula);
        }
        let above = rational(variant.above.0, variant.above.1);
        let (cases, found) = first_contradiction(run, |graph, exponents, value| {
            let positive = *value > above;
            let wrong = value.is_negative() || positive == all_equal(exponents);
            (variant.applies)(graph) && wrong
        })?;
        match found {
            Some(what) => Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "zero set", "exact values"))),
            None => {
                Run::all([Ok(formula), holds([exhaustive("W_1 >= 0, and 0 exactly at synchronised phases", cases)])])
            }
        }
    }
}

/// Zero exactly, or only, where the phases within each part of the graph are synchronised.
#[derive(Clone, Copy)]
pub struct ZeroVariant {
    parts: Parts,
    /// Phases synchronised within parts are claimed to give zero.
    sufficient: bool,
    /// Zero is claimed to give phases synchronised within parts.
    necessary: bool,
    /// What the potential is claimed to exceed elsewhere.
    above: (i64, i64),
}

impl ZeroVariant {
    fn examine(&self, run: &Run) -> Result<Outcome, CheckError> {
        let above = rational(self.above.0, self.above.1);
        let (cases, found) = first_contradiction(run, |graph, exponents, value| {
            let synchronised = self.parts.synchronised(graph, exponents);
            let whole = all_equal(exponents);
            value.is_negative()
                || whole && !value.is_zero()
                || self.sufficient && synchronised && !value.is_zero()
                || self.necessary && !synchronised && *value <= above
        })?;
        match found {
            Some(what) => {
                Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "zero set", "exact values of W_1 on digraphs")))
            }
            None => Run::all([sum_of_squares(run, (1, 2)), holds([exhaustive("zero set", cases)])]),
        }
    }
}

/// paley.zero.dir.
pub struct StrongSubgraphs;

impl Claim for StrongSubgraphs {
    type Variant = ZeroVariant;

    fn id(&self) -> &str {
        "paley.zero.dir"
    }

    fn derivation(&self) -> &str {
        "W_1 = (1/(4N)) sum over arcs of |z_k - z_j|^2, so an arc between two strong components counts: each may be synchronised at another phase, \
         and W_1 > 0. Two nodes and one arc are enough (single nodes are strongly connected); so are two 2-cycles joined by an arc. W_1 = 0 exactly if phases are \
         equal across every arc, that is, within each weakly connected component. For undirected graphs the two are the same."
    }

    fn printed(&self) -> ZeroVariant {
        ZeroVariant { parts: Parts::Strong, sufficient: true, necessary: true, above: (0, 1) }
    }

    fn repair(&self) -> Option<Repair<ZeroVariant>> {
        Some(Repair {
            fault: Fault::False, clauses: Vec::new(),
            statement: "W_1(theta) is zero if and only if the phases within each weakly connected component of G are synchronised; otherwise W_1(theta) is \
                        positive. (Synchronised strong components are necessary, but sufficient only if no arc joins two of them.)"
                .to_string(),
            variant: ZeroVariant { parts: Parts::Weak, ..self.printed() },
        })
    }

    fn controls(&self) -> Vec<Control<ZeroVariant>> {
        let weak = ZeroVariant { parts: Parts::Weak, ..self.printed() };
        vec![
            Control::new("all phases equal", ZeroVariant { parts: Parts::Whole, ..weak }),
            Control::new("otherwise above 1/4", ZeroVariant { above: (1, 4), ..weak }),
            Control::new(
                "strong components, sufficient only",
                ZeroVariant { parts: Parts::Strong, necessary: false, ..weak },
            ),
        ]
    }

    fn examine(&self, variant: &ZeroVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        variant.examine(run)
    }
}

/// paley.fish.zero.
pub struct FishSubgraphs;

impl Claim for FishSubgraphs {
    type Variant = ZeroVariant;

    fn id(&self) -> &str {
        "paley.fish.zero"
    }

    fn derivation(&self) -> &str {
        "W_1 = (1/(4N)) sum over arcs of |z_k - z_j|^2 >= 0 for any digraph, 0 at equal phases. W_1 = 0 makes phases equal across every arc, hence within each \
         connected subgraph, in the strong sense and in the weak one (checked: the weak one, which is more). The sentence says \"only if\"; the converse is \
         true for weakly connected components and false for strongly connected ones (paley.zero.dir)."
    }

    fn printed(&self) -> ZeroVariant {
        ZeroVariant { parts: Parts::Weak, sufficient: false, necessary: true, above: (0, 1) }
    }

    fn controls(&self) -> Vec<Control<ZeroVariant>> {
        vec![
            Control::new("only if all phases are equal", ZeroVariant { parts: Parts::Whole, ..self.printed() }),
            Control::new(
                "if the phases within each strongly connected subgraph are",
                ZeroVariant { parts: Parts::Strong, sufficient: true, ..self.printed() },
            ),
            Control::new("above 1/4 otherwise", ZeroVariant { above: (1, 4), ..self.printed() }),
        ]
    }

    fn examine(&self, variant: &ZeroVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        variant.examine(run)
    }
}
