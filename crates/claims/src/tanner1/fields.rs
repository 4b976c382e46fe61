//! tanner1.L, L.ones, Lw, anyV, fig2, Vmono, Vt: graph matrices and the potential.

use crate::prelude::*;
use crate::tanner2::fixtures::{PLANE, printed as printed_potential, sloped, spring};
use crate::tanner2::graphs::{LaplacianVariant, examine_laplacian, seen, shown, small_graphs};
use algebra::graph::Graph;
use arithmetic::{Sign, Signed};
use models::double_integrator::{Potential, heading};

pub fn laplacian() -> Record<LaplacianVariant> {
    Record::new(
        "tanner1.L",
        "Each edge adds b b^T with b = ±(e_i - e_j), whatever its direction: D D^T = Delta - A, and x^T L x is the sum of (x_i - x_j)² over the edges, zero exactly where x is constant on every component.",
        LaplacianVariant::PRINTED,
        |variant, run| Run::all([
            examine_laplacian(variant, run).checks("steps 1 to 3").on([1, 2, 3, 4]),
            argued(&[1, 2, 3, 4], "properties of the Laplacian", "notes/tanner2.md, Laplacians, steps 1 to 3"),
        ]),
    )
    .clauses(&[
        "L(G) = Delta(G) - A(G) = D D^T.",
        "It is independent of the choice of orientation.",
        "It is positive semidefinite.",
        "The algebraic multiplicity of its zero eigenvalue is the number of connected components.",
    ])
    .altered("Delta + A", |v| v.sign = 1)
    .altered("one more zero eigenvalue", |v| v.offset = 1)
}

/// For which graphs the kernel is the span of 1.
type OnesVariant = fn(&Graph) -> bool;

fn examine_ones(meant: &OnesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let detail = "every labelled graph of up to 4 vertices, the connected ones of 5 up to isomorphism";
    let evidence = exhaustive("the kernel of L", detail);
    let kernels = run.every(evidence, small_graphs().into_iter().filter(meant), |graph: Graph| {
        let kernel = graph.laplacian()?.kernel();
        let other = kernel.iter().find(|x| x.iter().any(|value| *value != x[0]));
        let text = |x| format!("{}: ({}) is an eigenvector for 0", shown(&graph), list(x));
        Ok(other.map(|x| Counterexample::new(text(x), [seen(&graph)])))
    });
    Run::all([kernels.checks("step 3"), argued(&[1], "the kernel of L", "notes/tanner2.md, Laplacians, steps 1 to 3")])
}

pub fn ones() -> Record<OnesVariant> {
    Record::new(
        "tanner1.L.ones",
        "The sentence has no hypothesis. A graph in two pieces has further eigenvectors for 0, constant on each piece. For connected graphs it is true (up to a factor), and the paper uses it for those.",
        |_| true,
        examine_ones,
    )
    .repaired(Fault::Hypothesis, "For a connected graph the eigenvectors of L(G) for the eigenvalue zero are the nonzero multiples of 1_n.", Graph::is_connected)
    .control("graphs with an edge", |graph| !graph.edges().is_empty())
    .control("graphs without isolated vertices", |graph| (0..graph.order()).all(|i| graph.degree(i) > 0))
}

/// The product that defines the weighted Laplacian, and its properties.
#[derive(Clone, Copy)]
pub struct WeightedVariant {
    transposed: bool,
    properties: LaplacianVariant,
}

fn examine_weighted(variant: &WeightedVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    if !variant.transposed {
        let graphs = small_graphs().into_iter().filter(|graph| !graph.edges().is_empty());
        // D W D, where W is the identity here: D is N by |E|.
        return run
            .instances("D W D", "shapes of the matrices", graphs, |graph: Graph| {
                let incidence = graph.incidence()?;
                let (rows, cols) = (incidence.rows(), incidence.cols());
                Ok(incidence.times(&incidence).is_err().then(|| {
                    let text = format!(
                        "{}: D is {rows} by {cols} and W is {cols} by {cols}, so that D W D is not defined",
                        shown(&graph)
                    );
                    Counterexample::new(text, [seen(&graph)])
                }))
            })
            .on([1]);
    }
    Run::all([
        examine_laplacian(&variant.properties, run).checks("steps 1 to 3").on([1, 2, 3, 4]),
        argued(&[1, 2, 3, 4], "properties of the weighted Laplacian", "notes/tanner2.md, Laplacians, steps 1 to 3"),
    ])
}

pub fn weighted() -> Record<WeightedVariant> {
    let properties = LaplacianVariant { weighted: true, ..LaplacianVariant::PRINTED };
    let printed = WeightedVariant { transposed: false, properties };
    let repaired = WeightedVariant { transposed: true, properties };
    Record::new(
        "tanner1.Lw",
        "D is N by |E|: D W D is not defined unless N = |E|, and then is not symmetric in general. With D W D^T each edge adds w_e b b^T, and the properties of L follow in the same way as w_e > 0.",
        printed,
        examine_weighted,
    )
    .repaired(Fault::Typo, "", repaired)
    .repaired_clauses(&[
        "With W the diagonal matrix of positive edge weights, L_w(G) = D(G^sigma) W D(G^sigma)^T is Delta_w - A_w.",
        "L_w(G) is independent of the orientation.",
        "With positive edge weights L_w(G) is symmetric and positive semidefinite.",
        "With positive edge weights the multiplicity of the zero eigenvalue of L_w(G) is the number of components of G.",
    ])
    .altered("D W D^T = Delta_w + A_w", |v| v.properties = LaplacianVariant { sign: 1, ..properties })
    .altered("one more zero eigenvalue", |v| v.properties = LaplacianVariant { offset: 1, ..properties })
}

fn examine_shape(potential: &Potential, _run: &mut Run) -> Result<Outcome, CheckError> {
    let evidence = exact("one minimum, growing on both sides", "signs of the slope between its exact roots");
    let problem = match (potential.check_definition3(), potential.critical()) {
        (Err(problem), _) => problem.to_string(),
        (Ok(()), Some(list)) if list == [rational(1, 1)] => return holds(evidence.for_all()),
        (Ok(()), _) => "the slope vanishes elsewhere than at distance 1".to_string(),
    };
    Ok(Outcome::fails(problem, evidence))
}

pub fn fig2() -> Record<Potential> {
    Record::new(
        "tanner1.fig2",
        "V' = (s - 1)/s² in s = |r_ij|²: it decreases to 1 at distance 1 and grows beyond, without bound on both sides, as the curve of Figure 2 does.",
        printed_potential(),
        examine_shape,
    )
    .control("1/s - log s", sloped(&[(-2, -1), (-1, -1)], 1))
    .control("-1/s + log s", sloped(&[(-2, 1), (-1, 1)], 1))
    .control("1/s + 2 log s, whose minimum lies elsewhere", sloped(&[(-2, -1), (-1, 2)], 1))
}

/// `V` decreases up to the first squared distance and increases from the second one on.
#[derive(Clone)]
pub struct MonotoneVariant {
    decreasing: Rational,
    increasing: Rational,
}

fn examine_monotone(variant: &MonotoneVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let potential = printed_potential();
    let evidence = exact("where V increases", "signs of the slope between its exact roots");
    let roots = potential.critical().unwrap_or_default();
    // The slope has one sign between two neighbours of this list.
    let mut ends: Vec<Rational> = [&[rational(0, 1)], roots.as_slice()].concat();
    ends.extend([variant.decreasing.clone(), variant.increasing.clone()]);
    ends.push(ends.iter().max().map_or(rational(1, 1), |last| last + rational(1, 1)));
    ends.sort();
    ends.dedup();
    for two in ends.windows(2) {
        let s = (&two[0] + &two[1]) / rational(2, 1);
        let slope = potential.slope(&s)?;
        let claimed = if two[1] <= variant.decreasing {
            Sign::Negative
        } else if two[0] >= variant.increasing {
            Sign::Positive
        } else {
            continue;
        };
        if slope.sign() != Some(claimed) {
            let what = format!("V = 1/s + log s at s = |r_ij|² = {s}: dV/ds = {slope}");
            let witness = Witness::Potential {
                slope: vec![(-1, 1.into()), (-2, (-1).into())],
                value: [1.into(), 1.into()],
                tangent: Some([(&s).into(), (&slope).into()]),
                radius: None,
            };
            return Ok(Outcome::fails(Counterexample::new(what, [witness]), evidence));
        }
    }
    holds(evidence.for_all())
}

pub fn monotone() -> Record<MonotoneVariant> {
    let at = |decreasing: (i64, i64), increasing: (i64, i64)| MonotoneVariant {
        decreasing: rational(decreasing.0, decreasing.1),
        increasing: rational(increasing.0, increasing.1),
    };
    Record::new(
        "tanner1.Vmono",
        "A potential that repels near agents decreases with growing distance there: 1/s + log s decreases for |r_ij| < 1 and increases beyond. For the bound of distances, the use that is made of it, it is enough that V is unbounded at infinity (tanner1.Omega.bounded).",
        at((0, 1), (0, 1)),
        examine_monotone,
    )
    .reading("the potential of Figure 2")
    .repaired(
        Fault::Slip,
        "V_ij = 1/|r_ij|² + log |r_ij|² decreases with |r_ij| up to 1 and increases from there on.",
        at((1, 1), (1, 1)),
    )
    .control("it increases from the squared distance 1/2 on", at((0, 1), (1, 2)))
    .control("it decreases up to the squared distance 2", at((2, 1), (2, 1)))
}

/// Potentials that can be used for both purposes: those of the list that pass.
#[derive(Clone, Copy)]
pub struct UsableVariant {
    allowed: fn(&Potential) -> bool,
}

/// Functions of the distance, and hence symmetric; none at all first.
fn functions_of_distance() -> Vec<(&'static str, Potential)> {
    vec![
        ("V = 0", sloped(&[], 0)),
        ("V = s", sloped(&[(0, 1)], 1)),
        ("V = 1/s", sloped(&[(-2, -1)], 1)),
        ("V = (s - 1)²", sloped(&[(1, 2), (0, -2)], 0)),
        ("V = 1/(2s²) - 1/s + 1/2", sloped(&[(-2, 1), (-3, -1)], 0)),
        ("V = 1/s + log s", printed_potential()),
        ("V = s + 1/s - 2", spring()),
    ]
}

fn examine_usable(variant: &UsableVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let list = functions_of_distance().into_iter().filter(|(_, potential)| (variant.allowed)(potential));
    let detail = "leading terms of the slopes of the listed potentials; conservation of energy on the line";
    let listed = run.instances("collisions and cohesion", detail, list, |(name, potential)| {
        // Two agents on one line with equal headings feel no alignment force: half the squared relative speed plus 2 V(s) is constant, so
        // that with enough relative speed a finite barrier is passed, inwards or outwards.
        Ok(if !potential.repels() {
            Some(format!(
                "{name}: two agents that follow each other on a line with equal headings, the rear one fast enough, collide: V is bounded near 0"
            ))
        } else {
            (!potential.confines()).then(|| format!(
                "{name}: two agents on a line with equal headings, the front one fast enough, part for ever: V is bounded far away"
            ))
        })
    })?;
    let steps = "notes/tanner1.md, Energy, steps 4 to 6";
    Run::all([
        Ok(listed.on([1, 2])).checks("the hypotheses of steps 5 and 6"),
        argued(&[1, 2], "collisions and cohesion", steps),
    ])
}

pub fn any_potential() -> Record<UsableVariant> {
    Record::new(
        "tanner1.anyV",
        "Every function of |r_ij| is symmetric, V = 0 too. Collision avoidance needs V to be unbounded at 0, cohesion needs it unbounded at infinity: the mechanical energy is constant, and bounded barriers are passed by fast agents.",
        UsableVariant { allowed: |_| true },
        examine_usable,
    )
    .clauses(&[
        "Any symmetric potential can be used for collision avoidance.",
        "Any symmetric potential can be used for group cohesion.",
    ])
    .reading("any potential, as the sentence says; collisions of linked agents, cohesion of a connected graph")
    .repaired(Fault::False, "", UsableVariant { allowed: |potential| potential.repels() && potential.confines() })
    .repaired_clauses(&[
        "Along (1), (4), (5) with any differentiable, non-negative potential V_ij(|r_ij|) = V_ji(|r_ij|) that tends to infinity as |r_ij| tends to 0 linked \
         agents on a fixed graph that start in different places do not collide as long as the motion lasts.",
        "If it tends to infinity with |r_ij| too, under the same law and from such starts all distances of a connected graph stay bounded as long as the motion lasts.",
    ])
    .altered("any that is unbounded near 0", |v| v.allowed = Potential::repels)
    .altered("any with a critical distance that is unbounded at infinity", |v| v.allowed = |potential| potential.confines() && potential.critical().is_some_and(|list| !list.is_empty()))
}

fn examine_sign(potential: &Potential, run: &mut Run) -> Result<Outcome, CheckError> {
    const PRECISION: u32 = 80;
    let enclose = |q: Rational| Interval::from_rational(&q, PRECISION);
    let evidence = certified("V_t >= 0", "enclosures for two agents at distances from 1/100 to 100");
    let velocities = [(1, 0), (0, 1), (-1, 1)];
    let states = (-4..=4).flat_map(|k| velocities.map(|v| (k, v)));
    let enclosures = run.every(evidence, states, |(k, (x, y))| {
        let s = enclose(rational(10, 1).pow(k));
        let v = [enclose(rational(x, 100)), enclose(rational(y, 100))];
        let angle = heading(&v)?;
        let value = potential.value(&s)? + PLANE.square(&v) + angle.square();
        Ok((!at_most(&value.zero(), &value)?).then(|| {
            format!("two agents at |r|² = 10^{k}, both with velocity ({x}/100, {y}/100): V_t = {:.4}", value.to_f64())
        }))
    })?;
    if matches!(enclosures, Outcome::Holds(_)) && potential.check_definition3().is_err() {
        return Ok(Outcome::Undecided("no lower bound of the potential".to_string()));
    }
    Ok(enclosures)
}

pub fn vt() -> Record<Potential> {
    Record::new(
        "tanner1.Vt",
        "The potential of Figure 2 has the least value 1; with it (and any that is not negative) V_t is a sum of non-negative terms. \
         \"Any potential function can be used\" is tanner1.anyV: potentials that take negative values, for which V_t is not positive semi-definite, are among those that it would admit (see the controls).",
        printed_potential(),
        examine_sign,
    )
    .reading("the potential of Figure 2, as for Omega and the collisions")
    .control("V = log s", sloped(&[(-1, 1)], 0))
    .control("V = 1/s + log s - 30", sloped(&[(-2, -1), (-1, 1)], -29))
}
