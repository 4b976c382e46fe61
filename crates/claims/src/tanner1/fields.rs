//! tanner1.L, L.ones, Lw, anyV, fig2, Vmono, Vt: graph matrices and the potential.

use super::line::potential as printed_potential;
use crate::tanner2::graphs::{LaplacianVariant, examine_laplacian, small_graphs};
use algebra::graph::Graph;
use arithmetic::{Interval, Rational, Signed, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Fault, Grade, Outcome, Run};
use models::double_integrator::{Coordinates, Potential, PotentialError, heading};

pub fn laplacian() -> Record<LaplacianVariant> {
    let printed = LaplacianVariant::PRINTED;
    Record::new(
        "tanner1.L",
        "Each edge adds b b^T with b = ±(e_i - e_j), whatever its direction: D D^T = Delta - A, and x^T L x is the sum of (x_i - x_j)² over the edges, zero exactly where x is constant on every component.",
        printed,
        examine_laplacian,
    )
    .control("Delta + A", LaplacianVariant { sign: 1, ..printed })
    .control("one more zero eigenvalue", LaplacianVariant { offset: 1, ..printed })
}

/// For which graphs the kernel is the span of 1.
type OnesVariant = fn(&Graph) -> bool;

fn examine_ones(variant: &OnesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    let evidence = |cases: usize| {
        Evidence::new(Grade::Exhaustive, "the kernel of L", "every labelled graph of up to 4 vertices, the connected ones of 5 up to isomorphism; for all, x^T L x is the sum of (x_i - x_j)²").cases(cases)
    };
    for graph in small_graphs().into_iter().filter(variant) {
        run.checkpoint()?;
        let kernel = graph.laplacian()?.kernel();
        cases += 1;
        let other = kernel.iter().find(|x| x.iter().any(|value| *value != x[0]));
        if let Some(x) = other {
            let what = format!(
                "{} vertices, edges {:?}: ({}) is an eigenvector for 0",
                graph.order(),
                graph.edges(),
                x.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
            );
            return Ok(Outcome::fails(what, evidence(cases)));
        }
    }
    Ok(Outcome::Holds(vec![evidence(cases)]))
}

pub fn ones() -> Record<OnesVariant> {
    Record::new(
        "tanner1.L.ones",
        "The sentence has no hypothesis. A graph in two pieces has further eigenvectors for 0, constant on each piece. For connected graphs it is true (up to a factor), and the paper uses it for those.",
        |_| true,
        examine_ones,
    )
    .repaired(Fault::False, "For a connected graph the eigenvectors of L(G) for the eigenvalue zero are the multiples of 1_n.", Graph::is_connected)
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
        for graph in small_graphs().into_iter().filter(|graph| !graph.edges().is_empty()) {
            let incidence = graph.incidence()?;
            // D W D, where W is the identity here: D is N by |E|.
            if incidence.times(&incidence).is_err() {
                let what = format!(
                    "{} vertices, edges {:?}: D is {} by {} and W is {} by {}, so that D W D is not defined",
                    graph.order(),
                    graph.edges(),
                    incidence.rows(),
                    incidence.cols(),
                    incidence.cols(),
                    incidence.cols()
                );
                return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "D W D", "shapes of the matrices")));
            }
        }
    }
    examine_laplacian(&variant.properties, run)
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
    .repaired(Fault::Slip, "L_w(G) = D(G^sigma) W D(G^sigma)^T.", repaired)
    .control("D W D^T = Delta_w + A_w", WeightedVariant { properties: LaplacianVariant { sign: 1, ..properties }, ..repaired })
    .control("one more zero eigenvalue", WeightedVariant { properties: LaplacianVariant { offset: 1, ..properties }, ..repaired })
}

// --- The potential ---

fn examine_shape(potential: &Potential, _run: &mut Run) -> Result<Outcome, CheckError> {
    let evidence =
        Evidence::new(Grade::Exact, "one minimum, growing on both sides", "signs of the slope between its exact roots");
    let one = rational(1, 1);
    let critical = potential.critical();
    let problem = match (potential.check_definition3(), &critical) {
        (Err(problem), _) => Some(problem.to_string()),
        (Ok(()), Some(list)) if list.len() == 1 && list[0] == one => None,
        (Ok(()), _) => Some("the slope vanishes elsewhere than at distance 1".to_string()),
    };
    Ok(match problem {
        Some(problem) => Outcome::fails(problem, evidence),
        None => Outcome::Holds(vec![evidence]),
    })
}

pub fn fig2() -> Record<Potential> {
    let of = |slope: &[(i32, i64)]| {
        Potential::new(slope.iter().map(|&(k, c)| (k, rational(c, 1))).collect(), (rational(1, 1), rational(1, 1)))
    };
    Record::new(
        "tanner1.fig2",
        "V' = (s - 1)/s² in s = |r_ij|²: it falls to 1 at distance 1 and grows beyond, without bound on both sides, as the curve of Figure 2 does.",
        printed_potential(),
        examine_shape,
    )
    .control("1/s - log s", of(&[(-2, -1), (-1, -1)]))
    .control("-1/s + log s", of(&[(-2, 1), (-1, 1)]))
    .control("1/s + 2 log s, whose minimum lies elsewhere", of(&[(-2, -1), (-1, 2)]))
}

/// Where `V` is said to increase: from this squared distance on, or up to it.
#[derive(Clone, Copy)]
pub enum MonotoneVariant {
    /// For all larger ones.
    From((i64, i64)),
    /// For all smaller ones.
    UpTo((i64, i64)),
}

fn examine_monotone(variant: &MonotoneVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let potential = printed_potential();
    let mut cases = 0;
    for k in 1..200 {
        let s = rational(k, 20);
        let inside = match *variant {
            MonotoneVariant::From((p, q)) => s > rational(p, q),
            MonotoneVariant::UpTo((p, q)) => s < rational(p, q),
        };
        if !inside {
            continue;
        }
        cases += 1;
        let slope = potential.slope(&s)?;
        if !slope.is_certainly_positive() {
            let what = format!("V = 1/s + log s at s = |r_ij|² = {s}: dV/ds = {slope}");
            return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "where V increases", "exact slopes")));
        }
    }
    let detail = "V' = (s - 1)/s² > 0 exactly for s > 1; exact slopes at multiples of 1/20 up to 10";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "where V increases", detail).cases(cases)]))
}

pub fn monotone() -> Record<MonotoneVariant> {
    Record::new(
        "tanner1.Vmono",
        "A potential that repels near agents falls with growing distance there: 1/s + log s falls for |r_ij| < 1 and increases beyond. (For the bound of distances it is enough that it is unbounded.)",
        MonotoneVariant::From((0, 1)),
        examine_monotone,
    )
    .repaired(Fault::False, "V_ij increases with |r_ij| beyond the distance of its minimum (|r_ij| > 1 for the printed choice) and decreases before.", MonotoneVariant::From((1, 1)))
    .control("from half the squared distance on", MonotoneVariant::From((1, 2)))
    .control("up to the minimum", MonotoneVariant::UpTo((1, 1)))
}

/// Potentials that can be used for both purposes: those of the list that pass.
#[derive(Clone, Copy)]
pub struct UsableVariant {
    allowed: fn(&Potential) -> bool,
}

/// Functions of the distance, and hence symmetric; none at all first.
fn functions_of_distance() -> Vec<(&'static str, Potential)> {
    let of = |slope: &[(i32, i64)], value: i64| {
        Potential::new(slope.iter().map(|&(k, c)| (k, rational(c, 1))).collect(), (rational(1, 1), rational(value, 1)))
    };
    vec![
        ("V = 0", of(&[], 0)),
        ("V = s", of(&[(0, 1)], 1)),
        ("V = 1/s", of(&[(-2, -1)], 1)),
        ("V = (s - 1)²", of(&[(1, 2), (0, -2)], 0)),
        ("V = 1/(2s²) - 1/s + 1/2", of(&[(-2, 1), (-3, -1)], 0)),
        ("V = 1/s + log s", printed_potential()),
        ("V = s + 1/s - 2", Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1))),
    ]
}

fn examine_usable(variant: &UsableVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    for (name, potential) in functions_of_distance().into_iter().filter(|(_, potential)| (variant.allowed)(potential)) {
        cases += 1;
        // Two agents on one line with equal headings feel no alignment force: half the squared relative speed plus 2 V(s) is constant, so
        // that with enough relative speed a finite barrier is passed, inwards or outwards.
        let what = match potential.check_definition3() {
            Err(PotentialError::NoRepulsion) => {
                "two agents that follow each other on a line with equal headings, the rear one fast enough, collide: V is bounded near 0"
            }
            Err(PotentialError::Bounded) => {
                "two agents on a line with equal headings, the front one fast enough, part for ever: V is bounded"
            }
            _ => continue,
        };
        return Ok(Outcome::fails(
            format!("{name}: {what}"),
            Evidence::new(
                Grade::Exact,
                "collisions and cohesion",
                "leading terms of the slope; conservation of energy on the line",
            ),
        ));
    }
    let detail = "linked agents stay between the two distances at which V reaches the energy, which is constant (tanner1.Vt_inv); leading terms of the slopes of the listed potentials";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "collisions and cohesion", detail).cases(cases)]))
}

pub fn any_potential() -> Record<UsableVariant> {
    Record::new(
        "tanner1.anyV",
        "Every function of |r_ij| is symmetric, V = 0 too. Collision avoidance needs V to be unbounded at 0, cohesion needs it unbounded at infinity: the mechanical energy is constant, and bounded barriers are passed by fast agents.",
        UsableVariant { allowed: |_| true },
        examine_usable,
    )
    .repaired(
        Fault::False,
        "Any differentiable potential V_ij(|r_ij|) that tends to infinity as |r_ij| tends to 0 and to infinity can be used (for linked agents of a connected graph).",
        UsableVariant {
            allowed: |potential| !matches!(potential.check_definition3(), Err(PotentialError::NoRepulsion | PotentialError::Bounded)),
        },
    )
    .control("any with a critical distance", UsableVariant { allowed: |potential| potential.critical().is_some_and(|list| !list.is_empty()) })
    .control("any that is unbounded at infinity", UsableVariant { allowed: |potential| potential.check_definition3() != Err(PotentialError::Bounded) })
}

// --- V_t ---

fn examine_sign(potential: &Potential, _run: &mut Run) -> Result<Outcome, CheckError> {
    const PRECISION: u32 = 80;
    let enclose = |q: Rational| Interval::from_rational(&q, PRECISION);
    let evidence = Evidence::new(
        Grade::Certified,
        "V_t >= 0",
        "enclosures for two agents at distances from 1/100 to 100; for all: a sum of non-negative terms",
    );
    let mut cases = 0;
    for k in -4..=4 {
        let s = enclose(rational(10, 1).pow(k));
        for (x, y) in [(1, 0), (0, 1), (-1, 1)] {
            let v = [enclose(rational(x, 100)), enclose(rational(y, 100))];
            let angle = heading(&v)?;
            let value = potential.value(&s)? + Coordinates::Cartesian.square(&v) + angle.clone() * angle;
            cases += 1;
            if value.is_certainly_negative() {
                return Ok(Outcome::fails(
                    format!(
                        "two agents at |r|² = 10^{k}, both with velocity ({x}/100, {y}/100): V_t = {:.4}",
                        value.to_f64()
                    ),
                    evidence,
                ));
            }
        }
    }
    if potential.check_definition3().is_err() {
        return Ok(Outcome::Undecided("no lower bound of the potential".to_string()));
    }
    Ok(Outcome::Holds(vec![evidence.cases(cases)]))
}

pub fn vt() -> Record<Potential> {
    let of = |slope: &[(i32, i64)], value: i64| {
        Potential::new(slope.iter().map(|&(k, c)| (k, rational(c, 1))).collect(), (rational(1, 1), rational(value, 1)))
    };
    Record::new(
        "tanner1.Vt",
        "Reading: the potentials of this section are those of Figure 2, the one that is printed, with the least value 1; with them (and any that are not negative) V_t is a sum of non-negative terms. \
         The second form puts in the definition of V_i. \"Any potential function can be used\" is tanner1.anyV, where it is taken at its word and is false: potentials that take negative values, for \
         which V_t is not positive semi-definite, are among those that it would admit (see the controls).",
        printed_potential(),
        examine_sign,
    )
    .control("V = log s", of(&[(-1, 1)], 0))
    .control("V = 1/s + log s - 30", of(&[(-2, -1), (-1, 1)], -29))
}
