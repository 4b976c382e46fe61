//! paley.eq16, paley.eq16.eigvec, paley.balexist: stationary points of the Laplacian phase potential.

use super::common::{
    Exact, all_equal, all_zero, arcs, at, circulants, digraphs, holds, laplacian, named, turns, up_to_rotation,
};
use algebra::graph::{Graph, WeightedGraph};
use algebra::matrix::SparseMatrix;
use arithmetic::{Complex, CosineField, RealCyclotomic, Ring};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run};
use models::oscillator::{laplacian_control, laplacian_rows, mean, misalignment, phase_gradient, phase_potential};

/// Graphs of up to three or four nodes, all undirected ones or all digraphs.
fn graphs(most: usize, directed: bool) -> Vec<WeightedGraph> {
    let undirected = (1..=most).flat_map(Graph::all).map(|graph| WeightedGraph::from(&graph));
    if directed { (1..=most).flat_map(digraphs).collect() } else { undirected.collect() }
}

/// The gradient of `W_1` by duals.
fn slopes(laplacian: &SparseMatrix, z: &Exact) -> Result<Vec<RealCyclotomic>, CheckError> {
    Ok(phase_gradient(z, |z| phase_potential(laplacian, z, 1))?)
}

/// paley.eq16.
pub struct StationaryPoints;

/// Whether directed graphs count, and which product with `L_k e^{i theta}` is to vanish.
#[derive(Clone, Copy)]
pub struct StationaryVariant {
    directed: bool,
    unturned: bool,
}

impl Claim for StationaryPoints {
    type Variant = StationaryVariant;

    fn id(&self) -> &str {
        "paley.eq16"
    }

    fn derivation(&self) -> &str {
        "By paley.gradW the left sides of (16) are N times the derivatives of W_1. (On directed graphs they are not, and (16) may hold at a point that is not \
         stationary: a control.)"
    }

    fn printed(&self) -> StationaryVariant {
        StationaryVariant { directed: false, unturned: false }
    }

    fn controls(&self) -> Vec<Control<StationaryVariant>> {
        vec![
            Control::new("directed graphs too", StationaryVariant { directed: true, unturned: false }),
            Control::new("<e^{i theta_k}, L_k e^{i theta}>", StationaryVariant { directed: false, unturned: true }),
        ]
    }

    fn examine(&self, variant: &StationaryVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const PARTS: usize = 4;
        let field = CosineField::new(PARTS as u32);
        let mut cases = 0;
        for graph in graphs(if variant.directed { 3 } else { run.cases(3, 4) }, variant.directed) {
            let laplacian = laplacian(&graph)?;
            for exponents in up_to_rotation(graph.order(), PARTS) {
                run.checkpoint()?;
                let z = at(&field, &exponents);
                let products: Vec<RealCyclotomic> = if variant.unturned {
                    z.iter().zip(laplacian_rows(&laplacian, &z)).map(|(z, lz)| z.dot(&lz)).collect()
                } else {
                    misalignment(&laplacian, &z)
                };
                cases += 1;
                if all_zero(&products) != all_zero(&slopes(&laplacian, &z)?) {
                    return Ok(Outcome::fails(
                        format!("{}, {}: only one of the two vanishes", arcs(&graph), turns(&exponents, PARTS)),
                        Evidence::new(Grade::Exact, "stationary points", "derivatives by duals"),
                    ));
                }
            }
        }
        holds([
            Evidence::new(Grade::Exact, "every undirected graph", "the identity paley.gradW"),
            Evidence::new(
                Grade::Exhaustive,
                "(16) and the gradient by duals",
                "all undirected graphs of up to 3 nodes (4 with --full), all arrangements of quarter turns",
            )
            .cases(cases),
        ])
    }
}

/// paley.eq16.eigvec.
pub struct EigenvectorsAreStationary;

/// Graphs, direction of the implication, and what an equilibrium is.
#[derive(Clone, Copy)]
pub struct EigenvectorVariant {
    directed: bool,
    converse: bool,
    at_rest: bool,
}

/// Whether `L z` is a multiple of `z`: then `L_k z` conj(z_k) is the same for all `k`.
pub fn is_eigenvector(laplacian: &SparseMatrix, z: &[Complex<RealCyclotomic>]) -> bool {
    let factors: Vec<_> = laplacian_rows(laplacian, z).into_iter().zip(z).map(|(lz, z)| lz * z.conj()).collect();
    all_equal(&factors)
}

impl Claim for EigenvectorsAreStationary {
    type Variant = EigenvectorVariant;

    fn id(&self) -> &str {
        "paley.eq16.eigvec"
    }

    fn derivation(&self) -> &str {
        "L is real and symmetric, so the eigenvalue is real and <i z_k, lambda z_k> = 0: (16) holds, the control vanishes, and all phases turn at omega_0 (an \
         equilibrium modulo rotation, as throughout the paper; at rest for omega_0 = 0). On directed graphs eigenvalues may be complex and it fails; the converse \
         fails too (controls)."
    }

    fn printed(&self) -> EigenvectorVariant {
        EigenvectorVariant { directed: false, converse: false, at_rest: false }
    }

    fn controls(&self) -> Vec<Control<EigenvectorVariant>> {
        let printed = self.printed();
        vec![
            Control::new("directed graphs too", EigenvectorVariant { directed: true, ..printed }),
            Control::new("and conversely", EigenvectorVariant { converse: true, ..printed }),
            Control::new("at rest for any omega_0", EigenvectorVariant { at_rest: true, ..printed }),
        ]
    }

    fn examine(&self, variant: &EigenvectorVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const PARTS: usize = 6;
        let field = CosineField::new(PARTS as u32);
        let gain = field.cos(0);
        let (mut cases, mut found) = (0, 0);
        let more = ["ring:6", "complete:6"].map(named).into_iter().collect::<Result<Vec<_>, _>>()?;
        for graph in graphs(3, variant.directed).into_iter().chain(more) {
            let laplacian = laplacian(&graph)?;
            // On more nodes the columns of the Fourier matrix only.
            let order = graph.order();
            let arrangements: Vec<Vec<usize>> = if order > 3 {
                (0..order).map(|m| (0..order).map(|k| m * k % PARTS).collect()).collect()
            } else {
                up_to_rotation(order, PARTS).collect()
            };
            for exponents in arrangements {
                run.checkpoint()?;
                let z = at(&field, &exponents);
                cases += 1;
                let eigenvector = is_eigenvector(&laplacian, &z);
                if !eigenvector && !variant.converse {
                    continue;
                }
                found += usize::from(eigenvector);
                let stationary = all_zero(&slopes(&laplacian, &z)?) && all_zero(&misalignment(&laplacian, &z));
                let rates: Vec<_> =
                    laplacian_control(&gain, &laplacian, &z)?.into_iter().map(|u| u + gain.one()).collect();
                let equilibrium = if variant.at_rest { all_zero(&rates) } else { all_equal(&rates) };
                if eigenvector != (stationary && equilibrium) {
                    let what = format!(
                        "{}, {}: eigenvector {eigenvector}, stationary {stationary}, equilibrium {equilibrium} for omega_0 = 1",
                        arcs(&graph),
                        turns(&exponents, PARTS)
                    );
                    return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "eigenvectors", "exact products")));
                }
            }
        }
        let detail = format!(
            "all undirected graphs of up to 3 nodes with phases at multiples of 1/6 turn, columns of F for C_6 and K_6: {found} eigenvectors"
        );
        holds([
            Evidence::new(Grade::Exact, "every undirected graph", "<i z_k, lambda z_k> = 0 for real lambda"),
            Evidence::new(Grade::Exhaustive, "eigenvectors of modulus one", detail).cases(cases),
        ])
    }
}

/// paley.balexist.
pub struct BalancedPoint;

/// The graphs that are claimed to have a balanced stationary point.
#[derive(Clone, Copy)]
pub struct BalancedVariant {
    graphs: fn(run: &Run) -> Vec<WeightedGraph>,
}

fn circulants_from(least: usize, run: &Run) -> Vec<WeightedGraph> {
    let most = run.cases(6, 9);
    let undirected = (least..=most).flat_map(|order| circulants(order, true));
    let directed = (least..=5).flat_map(|order| circulants(order, false));
    undirected.chain(directed).map(|(_, graph)| graph).collect()
}

/// A balanced stationary point among the columns of the Fourier matrix and the arrangements on a line.
fn balanced_point(laplacian: &SparseMatrix) -> Result<Option<Exact>, CheckError> {
    let order = laplacian.order();
    let field = CosineField::new(2 * order as u32);
    let columns = (1..order).map(|m| (0..order).map(|k| 2 * m * k % (2 * order)).collect::<Vec<_>>());
    let line = up_to_rotation(order.min(4), 2).filter(|signs| signs.len() == order);
    for exponents in columns.chain(line.map(|signs| signs.iter().map(|sign| sign * order).collect())) {
        let z = at(&field, &exponents);
        let centre = mean(&z)?;
        if centre == centre.zero() && all_zero(&slopes(laplacian, &z)?) {
            return Ok(Some(z));
        }
    }
    Ok(None)
}

impl Claim for BalancedPoint {
    type Variant = BalancedVariant;

    fn id(&self) -> &str {
        "paley.balexist"
    }

    fn derivation(&self) -> &str {
        "N >= 2 (one particle is never balanced: a control). The second column of F has entries of modulus one with sum zero, and it is an eigenvector \
         of the circulant L + L^T, whose eigenvalues are real: stationary, for directed circulants too. Connectedness alone is not sufficient: on a tree \
         stationary means all phases on a line (from the leaves inward), which an odd N cannot balance (a control)."
    }

    fn printed(&self) -> BalancedVariant {
        BalancedVariant { graphs: |run| circulants_from(2, run) }
    }

    fn controls(&self) -> Vec<Control<BalancedVariant>> {
        let path = |_: &Run| vec![WeightedGraph::from(&Graph::path(3))];
        vec![
            Control::new("one particle too", BalancedVariant { graphs: |run| circulants_from(1, run) }),
            Control::new("connected graphs: the path of three", BalancedVariant { graphs: path }),
        ]
    }

    fn examine(&self, variant: &BalancedVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let mut cases = 0;
        for graph in (variant.graphs)(run) {
            run.checkpoint()?;
            cases += 1;
            if balanced_point(&laplacian(&graph)?)?.is_none() {
                return Ok(Outcome::fails(
                    format!("N = {}, {}: no balanced stationary point", graph.order(), arcs(&graph)),
                    Evidence::new(Grade::Exact, "balanced points", "columns of F and all arrangements on a line"),
                ));
            }
        }
        holds([
            Evidence::new(Grade::Exact, "every circulant graph", "the second column of F, by the derivation"),
            Evidence::new(
                Grade::Exhaustive,
                "a balanced point with zero gradient",
                "all undirected circulants of 2 to 6 nodes (9 with --full), all directed ones of 2 to 5",
            )
            .cases(cases),
        ])
    }
}
