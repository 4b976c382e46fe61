//! tanner1.smooth, eq2, Omega.closed, Omega.bounded, collision, proof_ratio: the law and the set Omega.

use crate::prelude::*;
use crate::tanner2::fixtures::{PLANE, on_connected, printed as printed_potential, sloped, soft};
use crate::tanner2::graphs::shown;
use crate::tanner2::wording::{HeadingVariant, examine_heading, headings};
use algebra::graph::Graph;
use models::double_integrator::{AnyHeadings, HeadingDifference, Pair, Potential, State, gyroscopic, heading};

const PRECISION: u32 = 80;

pub fn eq2() -> Record<HeadingVariant> {
    Record::new(
        "tanner1.eq2",
        "The two-argument arctangent is the angle in (-pi, pi] from the x axis to the velocity. It has a value for every velocity but zero, and there it lies in [-pi, pi].",
        HeadingVariant::TwoArguments,
        |variant, run| examine_heading(variant, run).on([1, 2]),
    )
    .clauses(&["arctan(ydot_i, xdot_i) is the angle of the velocity.", "It lies in [-pi, pi]."])
    .reading("velocities other than zero, of which (2) says nothing")
    .control("one argument", HeadingVariant::Quotient)
    .control("values in [0, 2 pi)", HeadingVariant::Positive)
    .control("the arguments swapped", HeadingVariant::Swapped)
}

/// Where the law is said to be smooth.
#[derive(Clone, Copy)]
pub struct SmoothVariant {
    /// Where a velocity points along the negative x axis.
    at_cut: bool,
    /// Where a velocity is zero.
    at_rest: bool,
    /// Heading differences wrapped to `(-pi, pi]`.
    wrapped: bool,
}

/// The acceleration of agent 2 at (1, 0) with velocity (0, 1), for agent 1 at (0, 0) with this velocity; `V = 0`.
fn second_acceleration(first: [Rational; 2], wrapped: bool) -> Result<Interval, ArithmeticError> {
    let enclose = |q: &Rational| Interval::from_rational(q, PRECISION);
    let q = |n: i64| rational(n, 1);
    let exact = State { positions: vec![[q(0), q(0)], [q(1), q(0)]], velocities: vec![first, [q(0), q(1)]] };
    let state = exact.map(enclose);
    let angles = [heading(&state.velocities[0])?, heading(&state.velocities[1])?];
    let none = vec![[enclose(&q(0)), enclose(&q(0))]; 2];
    // No difference here is within 10^-10 of pi or -pi, so that the enclosures decide how it is read.
    let reading = if wrapped { HeadingDifference::Wrapped } else { HeadingDifference::Raw };
    let differ = |i: usize, j: usize| reading.read(angles[i].clone() - &angles[j]);
    let accelerations = gyroscopic(&state, &none, &[(0, 1)], differ)?;
    Ok(accelerations[1][0].clone())
}

fn examine_smooth(variant: &SmoothVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let step = rational(1, 1_000_000_000);
    let through = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, -1), (0, -1), (1, -1), (-1, 0), (0, 0)];
    let meant = through.into_iter().filter(|&(x, y)| {
        let (rest, cut) = ((x, y) == (0, 0), y == 0 && x < 0);
        (variant.at_cut || !cut) && (variant.at_rest || !rest)
    });
    let evidence = certified(
        "the law on both sides",
        "enclosures at velocities 10^-9 to either side, between which the acceleration changes by at most 10^-7",
    );
    let enclosures = run.every(evidence, meant, |(x, y)| {
        // Two velocities close by, one on each side.
        let near = |side: i64| [x, y].map(|k| rational(k, 1) + &step * rational(side, 1));
        let change = second_acceleration(near(1), variant.wrapped)? - second_acceleration(near(-1), variant.wrapped)?;
        // A law that is smooth there, with slopes of a few units, changes by a few times 10^-9.
        let jumps = !are_within(&change, &change.zero(), &change.ratio(1, 10_000_000))?;
        Ok(jumps.then(|| {
            let text = format!(
                "agents at (0, 0) and (1, 0), V = 0, the second with velocity (0, 1): where the first one's velocity passes ({x}, {y}) the second one's acceleration jumps by {:.4}",
                change.to_f64()
            );
            let places = [0, 1].map(|x| [rational(x, 1), rational(0, 1)]);
            Counterexample::new(text, [Witness::agents(&places, &[], &[])])
        }))
    });
    Run::all([
        enclosures.checks("the conclusion"),
        argued(&[1], "the law is analytic there", "notes/tanner1.md, Headings, steps 1 to 3"),
    ])
}

pub fn smooth() -> Record<SmoothVariant> {
    Record::new(
        "tanner1.smooth",
        "The heading (2) jumps by 2 pi where a velocity passes the negative x axis, and theta_i - theta_j with it, so that the neighbours' accelerations jump; at zero velocity there is no heading. (Wrapped differences jump at opposite headings instead; only headings followed continuously leave the zero velocity alone as an exception.)",
        SmoothVariant { at_cut: true, at_rest: true, wrapped: false },
        examine_smooth,
    )
    .repaired(
        Fault::Hypothesis,
        "For smooth potentials the control laws are smooth at states where no velocity is zero or points along the negative x axis and no linked agents coincide.",
        SmoothVariant { at_cut: false, at_rest: false, wrapped: false },
    )
    .altered("with wrapped differences", |v| v.wrapped = true)
    .altered("wherever no velocity points along the negative x axis", |v| v.at_rest = true)
}

/// Which numbers the coordinate `theta_i` of a triple may be, in units of pi.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Headings {
    /// `[-pi, pi]`.
    Closed,
    /// `(-pi, pi]`, the values that (2) takes.
    HalfOpen,
    /// No coordinate of its own: what (2) makes of the velocity.
    OfVelocity,
}

/// The set `V_t <= c` or `V_t < c`, with which headings.
#[derive(Clone, Copy)]
pub struct ClosedVariant {
    strict: bool,
    headings: Headings,
}

/// Two agents at distance 1, where V = 1, with the same velocity `(speed, 0)` and the same heading `turn pi`.
struct Twins {
    speed: Rational,
    turn: Rational,
}

impl Twins {
    /// Why it is not in the set of `c`, if it is not: `V_t = 1 + |v|² + theta²`, taken with 10 in place of `pi²`, at least as much.
    fn outside(&self, variant: &ClosedVariant, c: &Rational) -> Option<&'static str> {
        let value = rational(1, 1) + self.speed.square() + self.turn.square() * rational(10, 1);
        let (zero, one) = (rational(0, 1), rational(1, 1));
        if variant.headings == Headings::OfVelocity && self.speed == zero {
            return Some("has no headings");
        }
        let named = match variant.headings {
            Headings::Closed => self.turn >= -one.clone() && self.turn <= one,
            Headings::HalfOpen => self.turn > -one.clone() && self.turn <= one,
            Headings::OfVelocity => self.turn == zero && self.speed > zero,
        };
        let low = if variant.strict { value < *c } else { value <= *c };
        (!named || !low).then_some("is not in the set")
    }
}

fn examine_closed(variant: &ClosedVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    // The limit 0 from above and 1 from below of the speed, at headings 0; the limits pi and -pi of the heading, at rest.
    let sequences = [
        ("speed", 0, 1, rational(2, 1)),
        ("speed", 1, -1, rational(2, 1)),
        ("turn", 1, -1, rational(12, 1)),
        ("turn", -1, 1, rational(12, 1)),
    ];
    // Where headings are those of velocities, the only ones along (speed, 0) are 0.
    let meant = sequences.into_iter().filter(|(what, ..)| *what == "speed" || variant.headings != Headings::OfVelocity);
    let detail = "values along four sequences, exact but for pi² < 10";
    let limits = run.instances("limits of points of Omega", detail, meant, |(what, limit, side, c)| {
        let point = |x: Rational| match what {
            "speed" => Twins { speed: x, turn: rational(0, 1) },
            _ => Twins { speed: rational(0, 1), turn: x },
        };
        let near = |n: i64| point(rational(limit, 1) + rational(side, n));
        let members = (2..50).all(|n| near(n).outside(variant, &c).is_none());
        let outside = point(rational(limit, 1)).outside(variant, &c);
        Ok(outside.filter(|_| members).map(|why| match what {
            "speed" => format!("two agents at distance 1 with equal velocities (v, 0), c = {c}: the limit v = {limit} of points of the set {why}"),
            _ => format!("two agents at rest at distance 1 with equal headings, c = {c}: the limit theta = {}pi of points of the set {why}", if limit < 0 { "-" } else { "" }),
        }))
    });
    Run::all([
        limits.checks("step 2"),
        argued(&[1], "Omega is closed", "notes/tanner1.md, The set Omega, steps 1 and 2"),
    ])
}

/// One reading for every claim about Omega.
const OMEGA: &str = "as printed, a set of triples (r_ij, v_i, theta_i), in which theta_i is a coordinate of its own with values in [-pi, pi], \
     the range that the text names for (2); the potential of Figure 2";

pub fn closed() -> Record<ClosedVariant> {
    Record::new(
        "tanner1.Omega.closed",
        "V_t is a continuous function of the triples where linked agents are apart, and infinite where they meet, and [-pi, pi] is closed. (As a set of states with the headings of (2) Omega would not be closed: at zero velocity there is no heading, and (2) takes the value pi but not -pi.)",
        ClosedVariant { strict: false, headings: Headings::Closed },
        examine_closed,
    )
    .reading(OMEGA)
    .altered("V_t < c", |v| v.strict = true)
    .altered("in (r_ij, v_i), with the headings of (2)", |v| v.headings = Headings::OfVelocity)
    .altered("theta_i in (-pi, pi]", |v| v.headings = Headings::HalfOpen)
}

/// Graphs, a potential, and the range of the headings.
#[derive(Clone)]
pub struct BoundedVariant {
    graphs: fn(&Graph) -> bool,
    potential: Potential,
    headings: HeadingVariant,
}

fn examine_bounded(variant: &BoundedVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let far = Interval::from_rational(&rational(10, 1).pow(40), PRECISION);
    let rise = variant.potential.value(&far)? - variant.potential.value(&far.one())?;
    let small = at_most(&rise, &rise.integer(10))?;
    let detail =
        "graphs of up to 4 agents, enclosures of V at the squared distances 1 and 10^40: it grows by more than 10";
    let evidence = certified("distances", detail);
    let graphs = (1..=4).flat_map(Graph::all).filter(|graph| (variant.graphs)(graph));
    let distances = run.every(evidence, graphs, |graph| {
        // One of the components 10^20 away from the others, or the ends of one edge.
        Ok(if !graph.is_connected() {
            Some(format!("{}: V_t does not see how far the components are apart", shown(&graph)))
        } else {
            (!graph.edges().is_empty() && small)
                .then(|| format!("{}: from distance 1 to 10^20 V_ij grows by {:.1} only", shown(&graph), rise.to_f64()))
        })
    });
    // V_t >= |v_i|²/2, as no V_ij is negative.
    let least = variant.potential.critical().and_then(|list| list.first().cloned());
    let speeds = run.every(certified("speeds", "the least value of V"), least, |s| {
        let value = variant.potential.value(&Interval::from_rational(&s, PRECISION))?;
        Ok((!at_most(&value.zero(), &value)?).then(|| "V_ij is negative at its minimum".to_string()))
    });
    Run::all([
        distances.on([1]).checks("step 4"),
        speeds.on([2]).checks("step 3"),
        headings(&variant.headings, run).checks("step 5").on([3]),
        argued(&[1, 2, 3], "bounds", "notes/tanner1.md, The set Omega, steps 3 to 5"),
    ])
}

pub fn bounded() -> Record<BoundedVariant> {
    let printed = BoundedVariant {
        graphs: Graph::is_connected,
        potential: printed_potential(),
        headings: HeadingVariant::TwoArguments,
    };
    Record::new(
        "tanner1.Omega.bounded",
        "V_ij >= 1 > 0, so V_t <= c bounds every V_ij and every speed. V_ij is unbounded as the distance grows, so linked distances are bounded and, along paths, all of them (by N - 1 times the bound). Not because V increases: it does not near 0 (tanner1.Vmono). The third clause is the reading itself; that (2) makes it a right one is what is computed: its values lie there.",
        printed.clone(),
        examine_bounded,
    )
    .clauses(&[
        "For a connected graph boundedness of V_t implies boundedness of every r_ij.",
        "It implies boundedness of v_i.",
        "theta_i lies in [-pi, pi].",
    ])
    .reading(OMEGA)
    .altered("graphs with an edge", |v| v.graphs = |graph| !graph.edges().is_empty())
    .altered("V = 1/(2s²) - 1/s + 1/2, bounded", |v| v.potential = sloped(&[(-2, 1), (-3, -1)], 0))
    .altered("step 3: V = s + 1/s - 3, negative at its minimum", |v| v.potential = sloped(&[(0, 1), (-2, -1)], -1))
    .altered("headings in [0, 2 pi)", |v| v.headings = HeadingVariant::Positive)
}

/// For which pairs `V_t` is said to be infinite where they meet.
#[derive(Clone)]
pub struct CollisionVariant {
    linked_only: bool,
    potential: Potential,
}

fn examine_collision(variant: &CollisionVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    // The path 1-2-3, with two agents in one place.
    let edges: [Pair; 2] = [(0, 1), (1, 2)];
    let meant = [(0, 1), (1, 2), (0, 2)].into_iter().filter(|pair| !variant.linked_only || edges.contains(pair));
    let detail = "the slope where they meet, exact, the path of three agents";
    // V rises without bound towards 0 where s V' is negative and does not tend to 0 there.
    let towards = |k: u32| {
        let s = rational(1, 4_i64.pow(k));
        variant.potential.slope(&s).map(|slope| slope * s)
    };
    let rise = [towards(8)?, towards(12)?];
    let instances = run.instances("V_t where agents meet", detail, meant, |pair: Pair| {
        if !variant.potential.repels() {
            let text = format!(
                "agents {} and {}: V_ij does not tend to infinity as they approach each other: s dV/ds is {} at s = 4^-8, {} at 4^-12",
                pair.0 + 1,
                pair.1 + 1,
                rise[0],
                rise[1]
            );
            return Ok(Some(text.into()));
        }
        let mut places = [0, 1, 3].map(|x| [rational(x, 1), rational(0, 1)]);
        places[pair.1] = places[pair.0].clone();
        let finite = edges.iter().all(|&(i, j)| {
            let s = PLANE.square(&[&places[i][0] - &places[j][0], rational(0, 1)]);
            variant.potential.slope(&s).is_ok()
        });
        Ok(finite.then(|| {
            let text = format!(
                "the path 1-2-3, agents {} and {} in one place: V_t is finite, and the law smooth; followed back from different velocities there, they start apart",
                pair.0 + 1,
                pair.1 + 1
            );
            Counterexample::new(text, [Witness::networks(3, vec![vec![(0, 1), (1, 2)]])])
        }))
    })?;
    let steps = "notes/tanner1.md, Energy, steps 4 and 5";
    Run::all([Ok(instances.on([1, 2])).checks("step 4"), argued(&[1, 2], "linked agents", steps)])
}

pub fn collision() -> Record<CollisionVariant> {
    Record::new(
        "tanner1.collision",
        "V_t contains V_ij for linked pairs only. On the path 1-2-3 agents 1 and 3 may meet with V_t finite, and do so from suitable starts. For linked agents the conclusion is true, by the conserved mechanical energy rather than by V_t.",
        CollisionVariant { linked_only: false, potential: printed_potential() },
        examine_collision,
    )
    .clauses(&["V_t tends to infinity where r_ij = 0 for some i, j.", "Collision avoidance is guaranteed."])
    .reading("the potential of Figure 2, as for V_t and Omega")
    .repaired_by(Fault::Hypothesis, "", |v| v.linked_only = true)
    .repaired_clauses(&[
        "With V_ij = 1/|r_ij|² + log |r_ij|² on the linked pairs V_t tends to infinity where linked agents meet.",
        "With these V_ij, along (1), (4), (5) from starts in which no linked agents are in one place, collisions of linked agents are avoided as long as the \
         motion lasts (all collisions, if the graph is complete).",
    ])
    .altered("V = (s - 1)²", |v| v.potential = soft())
    .altered("V = s + log s, which attracts at all distances", |v| v.potential = sloped(&[(0, 1), (-1, 1)], 0))
}

/// The first quotient of the line, `numerator/denominator` among `xdot, ydot, xddot, yddot`, and whether headings are equal.
#[derive(Clone, Copy)]
pub struct RatioVariant {
    numerator: usize,
    denominator: usize,
    equal_headings: bool,
}

fn quotients(variant: &RatioVariant) -> Identity<'_> {
    Identity::of(move |[k, x, xx]| {
        // ydot/xdot = k for all time: yddot = k xddot.
        let all = [x.clone(), k.clone() * x, xx.clone(), k.clone() * xx];
        Ok((vec![all[variant.numerator].over(&all[variant.denominator])?, all[1].over(x)?], vec![k.clone(), k.clone()]))
    })
}

/// At equal headings the accelerations are minus the gradients.
pub(super) fn plain_accelerations(graph: Graph, equal_headings: bool) -> Identity<'static> {
    Identity::new(AnyHeadings::variables(&graph), move |at| {
        let mut at = at.to_vec();
        if equal_headings {
            let first = at.len() - graph.order();
            let common = at[first].clone();
            at[first..].fill(common);
        }
        let whole = AnyHeadings::read(&graph, &at)?;
        let minus = |list: Vec<[Probe; 2]>| list.into_iter().flatten().map(|x| -x).collect();
        Ok((whole.accelerations.into_iter().flatten().collect(), minus(whole.gradients)))
    })
}

fn examine_ratio(variant: &RatioVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = "the quotients, for ydot = k xdot at all times";
    Run::all([
        run.identity(&quotients(variant), &["k", "xdot", "xddot"], part).on([1]).for_all(),
        on_connected(run, 3, "the accelerations", |graph| plain_accelerations(graph, variant.equal_headings))
            .checks("step 5")
            .on([2]),
        argued(&[2], "the accelerations at equal headings", "notes/tanner1.md, Heading dynamics, step 5"),
    ])
}

pub fn ratio() -> Record<RatioVariant> {
    Record::new(
        "tanner1.proof_ratio",
        "d/dt (ydot/xdot) = 0 says yddot xdot = ydot xddot, so yddot/xddot = k where xddot != 0; the printed denominator xdot lacks a dot. On the set of equal headings the acceleration is -grad V_i, which gives the last quotient.",
        RatioVariant { numerator: 3, denominator: 0, equal_headings: true },
        examine_ratio,
    )
    .clauses(&[
        "d/dt (ydot_i/xdot_i) = 0 implies yddot_i/xdot_i = ydot_i/xdot_i = k.",
        "On the set of equal constant headings k = a_{y_i}/a_{x_i} = (grad_{r_i} V_i)_y/(grad_{r_i} V_i)_x.",
    ])
    .repaired_by(Fault::Typo, "", |v| v.denominator = 2)
    .repaired_clauses(&[
        "d/dt (ydot_i/xdot_i) = 0 implies yddot_i/xddot_i = ydot_i/xdot_i = k (where the denominators are not zero).",
        "Under (4), (5), on the set of equal constant headings k = a_{y_i}/a_{x_i} = (grad_{r_i} V_i)_y/(grad_{r_i} V_i)_x (where the denominators are not \
         zero).",
    ])
    .altered("xddot/yddot", |v| (v.numerator, v.denominator) = (2, 3))
    .altered("at any headings", |v| v.equal_headings = false)
}
