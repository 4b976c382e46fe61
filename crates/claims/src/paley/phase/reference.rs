//! paley.ref: the potential with a reference phase.

use super::common::up_to_rotation;
use super::common::{
    all_equal, arcs, at, holds, identity_of_phases, laplacian, named, names, phasors, squared_lengths, turns,
};
use algebra::graph::{Graph, WeightedGraph};
use algebra::matrix::SparseMatrix;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, CosineField, Field, Sign, Signed};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run};
use models::oscillator::phase_potential;

/// paley.ref.
pub struct ReferencePhase;

/// The sign before the cosine, and the graphs for which there is no other minimiser.
#[derive(Clone, Copy)]
pub struct ReferenceVariant {
    sign: i64,
    unique_on: fn(&Graph) -> bool,
}

/// `W_1 + 1 + sign cos(theta_0 - theta_N)`, with `z_0` first.
fn potential<T: Field>(laplacian: &SparseMatrix, z: &[Complex<T>], sign: i64) -> Result<T, ArithmeticError> {
    let (reference, particles) = z.split_first().ok_or(ArithmeticError::Domain("a reference"))?;
    let last = particles.last().ok_or(ArithmeticError::Domain("a particle"))?;
    let cosine = reference.dot(last) * reference.re.integer(sign);
    Ok(phase_potential(laplacian, particles, 1)? + reference.re.one() + cosine)
}

/// The potential as a sum of squares.
struct Squares {
    graph: WeightedGraph,
    laplacian: SparseMatrix,
    sign: i64,
}

impl RationalIdentity for Squares {
    fn variables(&self) -> usize {
        self.graph.order() + 1
    }

    fn sides<T: Field>(&self, t: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let z = phasors(t)?;
        let n = self.graph.order();
        let lengths = squared_lengths(&self.graph, &z[1..], &t[0]) * t[0].ratio(1, 4 * n as i64);
        let pulled = (z[0].clone() - &z[n]).norm_squared() * t[0].ratio(1, 2);
        Ok((vec![potential(&self.laplacian, &z, self.sign)?], vec![lengths + pulled]))
    }
}

impl Claim for ReferencePhase {
    type Variant = ReferenceVariant;

    fn id(&self) -> &str {
        "paley.ref"
    }

    fn derivation(&self) -> &str {
        "W_1 >= 0 and 1 - cos >= 0, both zero at theta_k = theta_0. The sum is (1/(4N)) sum over arcs of |z_k - z_j|^2 + |z_0 - z_N|^2/2: on a connected graph, as the \
         section assumes, there is no other global minimiser. (There may be other stationary points.)"
    }

    fn printed(&self) -> ReferenceVariant {
        ReferenceVariant { sign: -1, unique_on: Graph::is_connected }
    }

    fn controls(&self) -> Vec<Control<ReferenceVariant>> {
        vec![
            Control::new("1 + cos", ReferenceVariant { sign: 1, ..self.printed() }),
            Control::new("unique on every graph", ReferenceVariant { unique_on: |_| true, ..self.printed() }),
        ]
    }

    fn examine(&self, variant: &ReferenceVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const PARTS: usize = 4;
        let field = CosineField::new(PARTS as u32);
        let mut cases = 0;
        for graph in (1..=3).flat_map(Graph::all) {
            let weighted = WeightedGraph::from(&graph);
            let laplacian = laplacian(&weighted)?;
            for exponents in up_to_rotation(graph.order() + 1, PARTS) {
                run.checkpoint()?;
                let z = at(&field, &exponents);
                let sign = potential(&laplacian, &z, variant.sign)?.sign();
                let together = all_equal(&exponents);
                cases += 1;
                let zero = sign == Some(Sign::Zero);
                if sign == Some(Sign::Negative) || together && !zero || zero && !together && (variant.unique_on)(&graph)
                {
                    let what = format!(
                        "{}, the reference and the particles at {}: the potential is {}zero",
                        arcs(&weighted),
                        turns(&exponents, PARTS),
                        if zero { "" } else { "not " }
                    );
                    return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "minimisers", "exact values")));
                }
            }
        }
        let mut parts = Vec::new();
        for name in ["path:2", "path:3", "ring:3"] {
            let graph = named(name)?;
            let identity = Squares { laplacian: laplacian(&graph)?, graph, sign: variant.sign };
            let names = names(identity.variables(), &[]);
            parts.push(identity_of_phases(run, &identity, &names, &format!("the sum of squares, {name}")));
        }
        let identities = Run::all(parts)?;
        Run::all([
            Ok(identities),
            holds([Evidence::new(
                Grade::Exhaustive,
                "global minimisers",
                "all undirected graphs of up to 3 nodes, all arrangements of quarter turns; for all by the sum of squares",
            )
            .cases(cases)]),
        ])
    }
}
