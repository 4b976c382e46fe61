//! paley.scale, paley.scale.complete, paley.fishpeak: the potential of the fish on the graph of nearest neighbours.

use super::common::{
    complete, digraphs, holds, identity_of_phases, laplacian, names, on_the_line, phasors, up_to_rotation,
};
use algebra::graph::WeightedGraph;
use algebra::matrix::SparseMatrix;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, Field, Rational, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use models::oscillator::{mean, phase_potential};
use rand_chacha::rand_core::Rng;

type Point = (i64, i64);

/// The graph in which everyone takes account of the nearest `n`, or `None` where a tie leaves open who they are.
fn nearest_graph(points: &[Point], n: usize) -> Option<WeightedGraph> {
    let squared = |a: Point, b: Point| (a.0 - b.0).pow(2) + (a.1 - b.1).pow(2);
    let mut arcs = Vec::new();
    for (k, &own) in points.iter().enumerate() {
        let mut others: Vec<(i64, usize)> =
            (0..points.len()).filter(|&j| j != k).map(|j| (squared(own, points[j]), j)).collect();
        others.sort_unstable();
        if n > others.len() || (n < others.len() && others[n - 1].0 == others[n].0) {
            return None;
        }
        arcs.extend(others[..n].iter().map(|&(_, j)| (k, j, rational(1, 1))));
    }
    Some(WeightedGraph::from_arcs(points.len(), arcs))
}

/// Whether a scale is claimed to do for `n` neighbours of `N` fish.
type Applies = fn(n: usize, fish: usize) -> bool;

/// A scale for the potential, given `n` and `N`.
type ScaleOf = fn(n: i64, fish: i64) -> Rational;

/// The factor with the parentheses as in Figure S3.
fn figure_scale(n: i64, _: i64) -> Rational {
    rational(2, n + 1)
}

/// The factor as printed in the text, `2/n + 1`.
fn text_scale(n: i64, _: i64) -> Rational {
    rational(n + 2, n)
}

/// paley.scale.
pub struct Scale;

/// For which `n` of `N` which scale is claimed to bring the potential into [0, 1].
#[derive(Clone)]
pub struct ScaleVariant(Vec<(Applies, ScaleOf)>);

impl ScaleVariant {
    fn fails_at(&self, graph: &WeightedGraph, n: usize, z: &[Complex<Rational>]) -> Result<Option<String>, CheckError> {
        let potential = phase_potential(&laplacian(graph)?, z, 1)?;
        let fish = z.len();
        for (_, scale) in self.0.iter().filter(|(applies, _)| applies(n, fish)) {
            let scaled = scale(n as i64, fish as i64) * &potential;
            if scaled < rational(0, 1) || scaled > rational(1, 1) {
                let phases: Vec<String> = z.iter().map(|z| format!("({}, {})", z.re, z.im)).collect();
                return Ok(Some(format!(
                    "N = {fish}, n = {n}, velocities {}: scaled W_1 = {scaled}",
                    phases.join(" ")
                )));
            }
        }
        Ok(None)
    }
}

/// All arrangements with phases 0 and pi.
fn signs(fish: usize) -> impl Iterator<Item = Vec<Complex<Rational>>> {
    let number = |sign: &usize| Complex::real(rational(1 - 2 * *sign as i64, 1));
    up_to_rotation(fish, 2).map(move |signs| signs.iter().map(number).collect())
}

impl Claim for Scale {
    type Variant = ScaleVariant;

    fn id(&self) -> &str {
        "paley.scale"
    }

    fn derivation(&self) -> &str {
        "Tried with the factor of Figure S3, 2/(n+1); that of the text, 2/n + 1, fails at once (N = 2, n = 1, opposite fish: 3; a control). W_1 = (1/(2N)) sum \
         over arcs of 1 - cos theta_kj <= n, with nN arcs, so 2 W_1/(n+1) <= 2n/(n+1), which can be reached: four fish at the corners of a square, n = 2, each opposite to \
         both neighbours, give 4/3. For n = 1 the bound is 1, and for n = N - 1 it is 1 - |p|^2 <= 1; N = 4, n = 2 is the smallest case that is neither. W_1/n lies in [0, 1] for \
         all n."
    }

    fn printed(&self) -> ScaleVariant {
        ScaleVariant(vec![(|_, _| true, figure_scale)])
    }

    fn repair(&self) -> Option<Repair<ScaleVariant>> {
        Some(Repair {
            fault: Fault::False, clauses: Vec::new(),
            statement: "2/(n+1) W_1 lies in [0,1] for n = 1 and n = N - 1 (those of Figure S3), but not for every n: it is 4/3 for four fish on a square, \
                        n = 2, each opposite to both neighbours. For all n the scaled potential W_1/n lies in [0,1]."
                .to_string(),
            variant: ScaleVariant(vec![
                (|n, fish| n == 1 || n + 1 == fish, figure_scale),
                (|_, _| true, |n, _| rational(1, n)),
            ]),
        })
    }

    fn controls(&self) -> Vec<Control<ScaleVariant>> {
        vec![
            Control::new("2/n + 1, as in the text", ScaleVariant(vec![(|_, _| true, text_scale)])),
            Control::new(
                "2/(n+1) for n = 2 too",
                ScaleVariant(vec![(|n, fish| n <= 2 || n + 1 == fish, figure_scale)]),
            ),
            Control::new("1.01/n", ScaleVariant(vec![(|_, _| true, |n, _| rational(101, 100 * n))])),
        ]
    }

    fn examine(&self, variant: &ScaleVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let fails =
            |what: String| Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "scaled potential", "exact values")));
        let mut random = run.random(0);
        let square = vec![(0, 0), (1, 0), (1, 1), (0, 1)];
        let mut schools = vec![vec![(0, 0), (1, 0)], vec![(0, 0), (1, 0), (3, 0)], square];
        for case in 0..run.cases(12, 60) {
            let mut number = || i64::from(random.next_u32() % 1000);
            schools.push((0..2 + case % 5).map(|_| (number(), number())).collect());
        }
        let mut cases = 0;
        for school in &schools {
            for n in 1..school.len() {
                let Some(graph) = nearest_graph(school, n) else { continue };
                for z in signs(school.len()) {
                    run.checkpoint()?;
                    cases += 1;
                    if let Some(what) = variant.fails_at(&graph, n, &z)? {
                        return fails(format!("fish at {school:?}, {what}"));
                    }
                }
            }
        }
        let mut graphs = 0;
        for fish in 2..=4 {
            for graph in digraphs(fish) {
                let degrees = graph.out_degrees();
                let Some(n) = (1..fish).find(|&n| degrees.iter().all(|d| *d == rational(n as i64, 1))) else {
                    continue;
                };
                run.checkpoint()?;
                graphs += 1;
                for z in signs(fish) {
                    if let Some(what) = variant.fails_at(&graph, n, &z)? {
                        return fails(format!("a digraph with n = {n} neighbours each, {what}"));
                    }
                }
            }
        }
        holds([
            Evidence::new(Grade::Exact, "every N and n", "the bounds of the derivation"),
            Evidence::new(
                Grade::Exhaustive,
                "all phases 0 and pi",
                "all digraphs of up to 4 fish with the same number of neighbours, where the bounds are reached",
            )
            .cases(graphs),
            Evidence::new(Grade::Fuzzed, "nearest neighbours", "schools of 2 to 6 fish at random, all phases 0 and pi")
                .cases(cases),
        ])
    }
}

/// paley.scale.complete.
pub struct CompleteScale;

struct CompleteIdentity {
    laplacian: SparseMatrix,
    scale: Rational,
}

impl RationalIdentity for CompleteIdentity {
    fn variables(&self) -> usize {
        self.laplacian.order()
    }

    fn sides<T: Field>(&self, t: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let z = phasors(t)?;
        let scaled = phase_potential(&self.laplacian, &z, 1)? * t[0].rational(&self.scale);
        Ok((vec![scaled], vec![t[0].one() - mean(&z)?.norm_squared()]))
    }
}

impl Claim for CompleteScale {
    type Variant = ScaleOf;

    fn id(&self) -> &str {
        "paley.scale.complete"
    }

    fn derivation(&self) -> &str {
        "By (13) and (8) W_1 = (N/2)(1 - |p|^2), and N = n + 1: the factor is 2/(n+1), as the labels of Figure S3 have it."
    }

    fn printed(&self) -> ScaleOf {
        text_scale
    }

    fn repair(&self) -> Option<Repair<ScaleOf>> {
        Some(Repair {
            fault: Fault::Slip,
            clauses: Vec::new(),
            statement: "n = N-1 corresponds to the complete graph, in which case 2/(n+1) W_1(theta) = 1 - |p_theta|^2."
                .to_string(),
            variant: figure_scale,
        })
    }

    fn controls(&self) -> Vec<Control<ScaleOf>> {
        vec![
            Control::new("2/n", |n, _| rational(2, n)),
            Control::new("1/(n+1)", |n, _| rational(1, n + 1)),
            Control::new("2/(N+1)", |_, fish| rational(2, fish + 1)),
        ]
    }

    fn examine(&self, variant: &ScaleOf, run: &mut Run) -> Result<Outcome, CheckError> {
        let mut parts = Vec::new();
        for fish in 2..=4usize {
            let scale = variant(fish as i64 - 1, fish as i64);
            let identity = CompleteIdentity { laplacian: laplacian(&complete(fish))?, scale };
            parts.push(identity_of_phases(run, &identity, &names(fish, &[]), &format!("N = {fish}, n = {}", fish - 1)));
        }
        let identities = Run::all(parts)?;
        Run::all([Ok(identities), holds([Evidence::new(Grade::Exact, "every N", "the line of the derivation")])])
    }
}

/// paley.fishpeak.
pub struct ThreeAndOne;

/// The value, the sizes of the clusters, the scale, and whether equal clusters count as unbalanced.
#[derive(Clone, Copy)]
pub struct PeakVariant {
    value: (i64, i64),
    sizes: (usize, usize),
    scale: ScaleOf,
    equal_clusters: bool,
}

impl Claim for ThreeAndOne {
    type Variant = PeakVariant;

    fn id(&self) -> &str {
        "paley.fishpeak"
    }

    fn derivation(&self) -> &str {
        "1 - |p|^2 with p = (3 - 1)/4. Unbalanced (2, 4)-patterns have M = 1 or 3 phases theta_0, which is the same shape: three and one, unique up to rotation and \
         exchange of fish. M = 2 is balanced, M = 0 synchronised: one cluster. (The scale is that of Figure S3, paley.scale.complete.)"
    }

    fn printed(&self) -> PeakVariant {
        PeakVariant { value: (3, 4), sizes: (1, 3), scale: figure_scale, equal_clusters: false }
    }

    fn controls(&self) -> Vec<Control<PeakVariant>> {
        let printed = self.printed();
        vec![
            Control::new("the value 1/2", PeakVariant { value: (1, 2), ..printed }),
            Control::new("the scale 2/n + 1", PeakVariant { scale: text_scale, ..printed }),
            Control::new("two and two counted too", PeakVariant { equal_clusters: true, ..printed }),
        ]
    }

    fn examine(&self, variant: &PeakVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const FISH: usize = 4;
        run.checkpoint()?;
        let laplacian = laplacian(&complete(FISH))?;
        for m in (1..FISH).filter(|&m| variant.equal_clusters || 2 * m != FISH) {
            let z = on_the_line(FISH, FISH - m);
            let scaled = phase_potential(&laplacian, &z, 1)? * (variant.scale)(FISH as i64 - 1, FISH as i64);
            let sizes = (m.min(FISH - m), m.max(FISH - m));
            if scaled != rational(variant.value.0, variant.value.1) || sizes != variant.sizes {
                return Ok(Outcome::fails(
                    format!("M = {m} of N = 4: clusters of {} and {}, scaled potential {scaled}", sizes.0, sizes.1),
                    Evidence::new(Grade::Exact, "(2, 4)-patterns", "exact values"),
                ));
            }
        }
        holds([Evidence::new(
            Grade::Exhaustive,
            "value and uniqueness",
            "M = 1 and 3 of N = 4, all unbalanced (2, 4)-patterns",
        )
        .cases(2)])
    }
}
