//! tanner1.smooth, eq2, Omega.closed, Omega.bounded, collision, proof_ratio: the law and the set Omega.

use super::line::potential as printed_potential;
use crate::tanner2::wording::{HeadingVariant, examine_heading};
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Field, Interval, Rational, Signed, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Fault, Grade, Outcome, Run};
use models::double_integrator::{Coordinates, Pair, Potential, State, gyroscopic, heading};

const PRECISION: u32 = 80;

pub fn eq2() -> Record<HeadingVariant> {
    Record::new(
        "tanner1.eq2",
        "The two-argument arctangent is the angle in (-pi, pi] from the x axis to the velocity. It has a value for every velocity but zero, and there it lies in [-pi, pi].",
        HeadingVariant::TwoArguments,
        examine_heading,
    )
    .control("one argument", HeadingVariant::Quotient)
    .control("values in [0, 2 pi)", HeadingVariant::Positive)
    .control("the arguments swapped", HeadingVariant::Swapped)
}

// --- Smoothness ---

/// Where the law is said to be smooth.
#[derive(Clone, Copy)]
pub struct SmoothVariant {
    /// Where a velocity points along the negative x axis.
    at_cut: bool,
    /// Where a velocity is zero.
    at_rest: bool,
}

/// The acceleration of agent 2 at (1, 0) with velocity (0, 1), for agent 1 at (0, 0) with this velocity; `V = 0`.
fn second_acceleration(first: [Rational; 2]) -> Result<Interval, ArithmeticError> {
    let enclose = |q: &Rational| Interval::from_rational(q, PRECISION);
    let q = |n: i64| rational(n, 1);
    let exact = State { positions: vec![[q(0), q(0)], [q(1), q(0)]], velocities: vec![first, [q(0), q(1)]] };
    let state = exact.map(enclose);
    let angles = [heading(&state.velocities[0])?, heading(&state.velocities[1])?];
    let none = vec![[enclose(&q(0)), enclose(&q(0))]; 2];
    let accelerations = gyroscopic(&state, &none, &[(0, 1)], |i, j| angles[i].clone() - &angles[j])?;
    Ok(accelerations[1][0].clone())
}

fn examine_smooth(variant: &SmoothVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let step = rational(1, 1_000_000_000);
    let mut cases = 0;
    for (x, y) in [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, -1), (0, -1), (1, -1), (-1, 0), (0, 0)] {
        let (rest, cut) = ((x, y) == (0, 0), y == 0 && x < 0);
        if cut && !variant.at_cut || rest && !variant.at_rest {
            continue;
        }
        // Two velocities close by, one on each side.
        let near =
            |dx: i64, dy: i64| [rational(x, 1) + &step * rational(dx, 1), rational(y, 1) + &step * rational(dy, 1)];
        let change = second_acceleration(near(1, 1))? - second_acceleration(near(-1, -1))?;
        cases += 1;
        if (change.clone() - change.ratio(1, 10)).is_certainly_positive()
            || (change.clone() + change.ratio(1, 10)).is_certainly_negative()
        {
            let what = format!(
                "agents at (0, 0) and (1, 0), V = 0, the second with velocity (0, 1): where the first one's velocity passes ({x}, {y}) the second one's acceleration jumps by {:.4}",
                change.to_f64()
            );
            return Ok(Outcome::fails(
                what,
                Evidence::new(
                    Grade::Certified,
                    "the law on both sides",
                    "enclosures at velocities 10^-9 to either side",
                ),
            ));
        }
    }
    let detail = "arctan(y, x) is analytic off the negative x axis and 0, 1/|r_ij|² and the gradients are analytic off collisions of linked agents; enclosures on both sides of eight velocities";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Certified, "the law on both sides", detail).cases(cases)]))
}

pub fn smooth() -> Record<SmoothVariant> {
    Record::new(
        "tanner1.smooth",
        "The heading (2) jumps by 2 pi where a velocity passes the negative x axis, and theta_i - theta_j with it, so that the neighbours' accelerations jump; at zero velocity there is no heading. (Wrapped differences jump at opposite headings instead; only headings followed continuously leave the zero velocity alone as an exception.)",
        SmoothVariant { at_cut: true, at_rest: true },
        examine_smooth,
    )
    .repaired(
        Fault::False,
        "The control laws are smooth at states where no velocity is zero or points along the negative x axis and no linked agents coincide.",
        SmoothVariant { at_cut: false, at_rest: false },
    )
    .control("wherever no velocity is zero", SmoothVariant { at_cut: true, at_rest: false })
    .control("wherever no velocity points along the negative x axis", SmoothVariant { at_cut: false, at_rest: true })
}

// --- Omega ---

/// The set `V_t <= c` or `V_t < c`, in which variables.
#[derive(Clone, Copy)]
pub struct ClosedVariant {
    strict: bool,
    /// `(r_ij, v_i)` with the headings from (2), not `(r_ij, v_i, theta_i)`.
    from_velocities: bool,
}

fn examine_closed(variant: &ClosedVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let evidence = |detail: &str| Evidence::new(Grade::Exact, "limits of points of Omega", detail.to_string());
    // Two agents at rest distance 1, where V = 1; V_t = 1 + |v|² for headings 0 and equal velocities (v, 0).
    let value = |v: &Rational| rational(1, 1) + v * v;
    let c = rational(2, 1);
    let belongs = |v: &Rational| if variant.strict { value(v) < c } else { value(v) <= c };
    let sequences = [(0, "0"), (1, "1")];
    for (limit, name) in sequences {
        let limit = rational(limit, 1);
        let members =
            (2..50).map(|n| &limit + rational(if limit > rational(0, 1) { -1 } else { 1 }, n)).all(|v| belongs(&v));
        let without_heading = variant.from_velocities && limit == rational(0, 1);
        if members && (without_heading || !belongs(&limit)) {
            let why = if without_heading { "has no headings" } else { "is not in the set" };
            return Ok(Outcome::fails(
                format!(
                    "two agents at distance 1 with equal velocities (v, 0), c = 2: the limit v = {name} of points of the set {why}"
                ),
                evidence("exact values"),
            ));
        }
    }
    let detail = "V_t is continuous in (r_ij, v_i, theta_i) where linked agents are apart and tends to infinity where they meet; exact values along two sequences";
    Ok(Outcome::Holds(vec![evidence(detail).cases(2)]))
}

pub fn closed() -> Record<ClosedVariant> {
    let printed = ClosedVariant { strict: false, from_velocities: false };
    Record::new(
        "tanner1.Omega.closed",
        "As printed, a set of triples (r_ij, v_i, theta_i), for the printed potential: V_t is a continuous function of them where linked agents are apart, and infinite where they meet. (As a set of states with the headings of (2) it would not be closed: at zero velocity there is no heading.)",
        printed,
        examine_closed,
    )
    .control("V_t < c", ClosedVariant { strict: true, ..printed })
    .control("in (r_ij, v_i), with the headings of (2)", ClosedVariant { from_velocities: true, ..printed })
}

/// Two agents with these potentials, linked or not.
#[derive(Clone)]
pub struct BoundedVariant {
    connected: bool,
    potential: Potential,
}

fn examine_bounded(variant: &BoundedVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let evidence = |grade, detail: &str| Evidence::new(grade, "boundedness of Omega", detail.to_string());
    let value = |s: &Rational| variant.potential.value(&Interval::from_rational(s, PRECISION));
    let start = value(&rational(1, 1))?;
    let far = value(&rational(10, 1).pow(40))?;
    let grows = variant.connected && (far - start).to_f64() > 10.0;
    if !grows {
        let what =
            "two agents with velocities (1, 0), distance 10^20: V_t exceeds its value at distance 1 by less than 10";
        return Ok(Outcome::fails(what, evidence(Grade::Certified, "enclosures of V at 1 and 10^20")));
    }
    if let Err(problem) = variant.potential.check_definition3() {
        return Ok(Outcome::Undecided(problem.to_string()));
    }
    let detail = "V_t <= c gives V_ij <= c on links, |v_i|² <= 2c; V is unbounded, so linked distances are bounded, and along paths all are; leading terms of the slope and values at 1 and 10^20";
    Ok(Outcome::Holds(vec![evidence(Grade::Certified, detail)]))
}

pub fn bounded() -> Record<BoundedVariant> {
    let printed = BoundedVariant { connected: true, potential: printed_potential() };
    Record::new(
        "tanner1.Omega.bounded",
        "For the printed potential: V_ij >= 1 > 0, so V_t <= c bounds every V_ij and every speed. V_ij is unbounded as the distance grows, so linked distances are bounded and, along paths, all of them (by N - 1 times the bound). Not because V increases: it does not near 0 (tanner1.Vmono).",
        printed.clone(),
        examine_bounded,
    )
    .control("agents that are not linked", BoundedVariant { connected: false, ..printed })
    .control("V = 1/(2s²) - 1/s + 1/2, bounded", BoundedVariant {
        connected: true,
        potential: Potential::new(vec![(-2, rational(1, 1)), (-3, rational(-1, 1))], (rational(1, 1), rational(0, 1))),
    })
}

// --- Collisions ---

/// For which pairs `V_t` is said to be infinite where they meet.
#[derive(Clone)]
pub struct CollisionVariant {
    linked_only: bool,
    potential: Potential,
}

fn examine_collision(variant: &CollisionVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    // The path 1-2-3 with agents at (0, 0), (1, 0), (0, 0) or with 1 and 2 in one place.
    let edges: [Pair; 2] = [(0, 1), (1, 2)];
    let mut cases = 0;
    for pair in [(0, 1), (1, 2), (0, 2)] {
        let linked = edges.contains(&pair);
        if variant.linked_only && !linked {
            continue;
        }
        let mut places = [0, 1, 3].map(|x| [rational(x, 1), rational(0, 1)]);
        places[pair.1] = places[pair.0].clone();
        let finite = edges.iter().all(|&(i, j)| {
            let s = Coordinates::Cartesian.square(&[&places[i][0] - &places[j][0], rational(0, 1)]);
            variant.potential.slope(&s).is_ok()
        });
        cases += 1;
        let evidence = Evidence::new(Grade::Exact, "V_t where agents meet", "exact, the path of three agents");
        if finite {
            let what = format!(
                "the path 1-2-3, agents {} and {} in one place: V_t is finite, and the law smooth; followed back from different velocities there, they start apart",
                pair.0 + 1,
                pair.1 + 1
            );
            return Ok(Outcome::fails(what, evidence));
        }
    }
    if variant.potential.check_definition3().is_err() {
        return Ok(Outcome::Undecided("no barrier".to_string()));
    }
    let detail = "V_ij tends to infinity where linked agents meet, and the mechanical energy, which contains it, is constant; the path of three agents";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "V_t where agents meet", detail).cases(cases)]))
}

pub fn collision() -> Record<CollisionVariant> {
    let printed = CollisionVariant { linked_only: false, potential: printed_potential() };
    let repaired = CollisionVariant { linked_only: true, ..printed.clone() };
    Record::new(
        "tanner1.collision",
        "V_t contains V_ij for linked pairs only. On the path 1-2-3 agents 1 and 3 may meet with V_t finite, and do so from suitable starts. For linked agents the conclusion holds, by the conserved mechanical energy rather than by V_t.",
        printed.clone(),
        examine_collision,
    )
    .repaired(Fault::False, "Collisions of linked agents are avoided, since the mechanical energy is constant and V_ij tends to infinity there (all collisions, if the graph is complete).", repaired.clone())
    .control("V = (s - 1)², linked agents", CollisionVariant {
        potential: Potential::new(vec![(1, rational(2, 1)), (0, rational(-2, 1))], (rational(1, 1), rational(0, 1))),
        ..repaired
    })
    .control("V = s + 1/s - 2, all agents", CollisionVariant {
        potential: Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1)),
        ..printed
    })
}

// --- The ratios in the proof ---

/// The first quotient of the line: `numerator/denominator` among `xdot, ydot, xddot, yddot`.
#[derive(Clone, Copy)]
pub struct RatioVariant {
    numerator: usize,
    denominator: usize,
}

struct Ratio(RatioVariant);

impl RationalIdentity for Ratio {
    fn variables(&self) -> usize {
        3
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [k, x, xx] = at else { return Err(ArithmeticError::Domain("three variables")) };
        // ydot/xdot = k for all time: yddot = k xddot.
        let all = [x.clone(), k.clone() * x, xx.clone(), k.clone() * xx];
        Ok((vec![all[self.0.numerator].over(&all[self.0.denominator])?, all[1].over(x)?], vec![k.clone(), k.clone()]))
    }
}

pub fn ratio() -> Record<RatioVariant> {
    let printed = RatioVariant { numerator: 3, denominator: 0 };
    Record::new(
        "tanner1.proof_ratio",
        "d/dt (ydot/xdot) = 0 says yddot xdot = ydot xddot, so yddot/xddot = k where xddot != 0; the printed denominator xdot lacks a dot. On the set of equal headings the acceleration is -grad V_i, which gives the last quotient.",
        printed,
        |variant, run| run.identity(&Ratio(*variant), &["k", "xdot", "xddot"], "the quotients, for ydot = k xdot at all times"),
    )
    .repaired(Fault::Slip, "yddot_i/xddot_i = ydot_i/xdot_i = k = a_{y_i}/a_{x_i} = (grad_{r_i} V_i)_y/(grad_{r_i} V_i)_x (where the denominators are not zero).", RatioVariant { numerator: 3, denominator: 2 })
    .control("xddot/xdot", RatioVariant { numerator: 2, denominator: 0 })
    .control("xddot/yddot", RatioVariant { numerator: 2, denominator: 3 })
}
