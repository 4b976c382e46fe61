//! tanner2.thm1a, thm1c, sec4.flocking, def3, cor1, thm2_vel, thm2_pot: where the motions go.

use super::fixtures::{DESCENT, PLANE, SMOOTH, connected, energy_decreases, printed as logarithmic, sloped, spring};
use super::nonsmooth::{HullVariant, hulls};
use crate::prelude::*;
use algebra::graph::Graph;
use arithmetic::Signed;
use models::double_integrator::{Potential, State, SteadyMotion, linked_within, swing_weights, velocity_alignment};

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Conclusion {
    /// All velocities become equal.
    Agree,
    /// All velocities tend to zero.
    Stop,
    /// Every agent's potential is minimised.
    Minimised,
    /// Every agent's potential has gradient zero.
    Critical,
}

#[derive(Clone, Copy)]
pub struct LimitVariant {
    connected: bool,
    /// The alignment of (4) times this.
    damping: i64,
    /// Step 4 on Laplacians: `lambda_2` of a connected graph is more than this.
    connectivity: i64,
    conclusion: Conclusion,
}

/// Whether an exact motion contradicts a conclusion about limits: its velocities and distances are those of its start for ever.
fn contradicts(motion: &SteadyMotion, conclusion: Conclusion) -> Result<Option<String>, CheckError> {
    let zero = rational(0, 1);
    Ok(match conclusion {
        Conclusion::Agree => (!motion.agrees()).then(|| "keep different velocities".to_string()),
        Conclusion::Stop => {
            let moves = motion.state.velocities.iter().flatten().any(|x| *x != zero);
            moves.then(|| "keep their velocities".to_string())
        }
        Conclusion::Minimised => motion.not_minimised()?.map(|agent| {
            format!(
                "stay there, though the potential of agent {} is not least: it decreases when that agent moves aside",
                agent + 1
            )
        }),
        Conclusion::Critical => (!motion.is_critical()?).then(|| "stay at a point that is not critical".to_string()),
    })
}

/// The agents of a motion, to be seen, where their coordinates are Cartesian.
fn seen(motion: &SteadyMotion) -> Option<Witness> {
    let agents = || Witness::agents(&motion.state.positions, &[], &motion.graph.edges());
    (motion.coordinates == PLANE).then(agents)
}

/// That no motion among `motions` contradicts the conclusion, or the first one that does.
fn uncontradicted(
    run: &Run,
    motions: Vec<SteadyMotion>,
    connected: bool,
    conclusion: Conclusion,
) -> Result<Outcome, CheckError> {
    let meant = motions.into_iter().filter(|motion| !connected || motion.graph.is_connected());
    run.instances("exact motions", "accelerations and derivatives, exact", meant, |motion| {
        if !motion.is_steady()? {
            return Err(CheckError::Other(format!("{} is not steady", motion.name)));
        }
        let text = |how| format!("{}: the agents {how}", motion.name);
        Ok(contradicts(&motion, conclusion)?.map(|how| Counterexample::new(text(how), seen(&motion))))
    })
}

/// `lambda_2 > 0`, or another bound, on connected graphs.
fn positive_connectivity(bound: i64, run: &Run) -> Result<Outcome, CheckError> {
    let graphs = connected(5).into_iter().filter(|graph| graph.order() > 1);
    run.instances("lambda_2 > 0", "all connected graphs of 2 to 5 agents, exactly", graphs, |graph: Graph| {
        let above = graph.laplacian()?.characteristic_polynomial()?.count_above(&rational(bound, 1));
        Ok((above + 1 != graph.order()).then(|| format!("edges {:?}: lambda_2 is not above {bound}", graph.edges())))
    })
}

fn examine_fixed(variant: &LimitVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let steps = match variant.conclusion {
        Conclusion::Agree => "notes/tanner2.md, Theorem 1, steps 1 to 4, the last one by Coq",
        _ => "notes/tanner2.md, Theorem 1, steps 1 to 5",
    };
    Run::all([
        uncontradicted(run, SteadyMotion::all_known(), variant.connected, variant.conclusion).checks("the conclusion"),
        energy_decreases(run, variant.damping).checks(DESCENT),
        positive_connectivity(variant.connectivity, run).checks("Laplacians, step 4, which step 4 uses"),
        argued(&[1], "the limits", steps),
    ])
}

pub fn thm1a() -> Record<LimitVariant> {
    Record::new(
        "tanner2.thm1a",
        "dW/dt = -v^T (L kron I_2) v <= 0 and Omega is compact in (r_ij, v_i), so the motion exists for all time. The sum of all velocities is kept, \
         so each tends to the mean of the initial ones. A continuous V' is enough: the squared disagreement is integrable along every solution and has a bounded rate (Barbalat), without LaSalle's principle and without uniqueness (notes/tanner2.md).",
        LimitVariant { connected: true, damping: 1, connectivity: 0, conclusion: Conclusion::Agree },
        examine_fixed,
    )
    .reading(SMOOTH)
    .altered("any graph", |v| v.connected = false)
    .altered("alignment with the other sign", |v| v.damping = -1)
    .altered("all velocities tend to zero", |v| v.conclusion = Conclusion::Stop)
    .altered("step 4 of the proof: with lambda_2 > 1", |v| v.connectivity = 1)
}

pub fn thm1c() -> Record<LimitVariant> {
    Record::new(
        "tanner2.thm1c",
        "The proof shows grad V_i = 0 only. Three agents at rest in a row with all pairs linked are in equilibrium where 2 V'(a²) a + 4 V'(4a²) a = 0; with V = m/s + log(s/m) this is a² = 3m/4. The middle one sits at \
         a saddle of its own potential. By symmetry every start in a row with velocities along it stays in a row, so a whole set of starts tends to such points. (Also: with four or more agents no configuration in the plane makes all \
         V_ij least at once.)",
        LimitVariant { connected: true, damping: 1, connectivity: 0, conclusion: Conclusion::Minimised },
        examine_fixed,
    )
    .reading(SMOOTH)
    .repaired_by(
        Fault::False,
        "For agents with dynamics (1) under (4), potentials of Definition 3 with a continuous gradient and a fixed connected neighboring \
         graph, from starts in which no linked agents are in one place, the system approaches the set of critical configurations: \
         grad_{r_i} V_i tends to 0 for all i.",
        |v| v.conclusion = Conclusion::Critical,
    )
    .altered("alignment with the other sign", |v| v.damping = -1)
    .altered("critical and at rest", |v| v.conclusion = Conclusion::Stop)
    .altered("step 4 of the proof: with lambda_2 > 1", |v| v.connectivity = 1)
}

/// Which equilibria are said to be asymptotically stable and free of collisions.
#[derive(Clone, Copy)]
pub struct ManifoldVariant {
    complete: bool,
    minima: bool,
    /// The alignment of (4) times this.
    damping: i64,
    /// Only minima near which there are no other critical configurations.
    isolated: bool,
}

/// Equilibria of two agents near the strict minimum `s = 1` of the potential with `V' = (s - 1)³ sin²(1/(s - 1))/s²`, as near as one likes:
/// between two squared distances at which `sin(1/(s - 1))` has different signs there is one at which it vanishes, and `V'` with it.
fn equilibria_near_one(variant: &ManifoldVariant, run: &Run) -> Result<Outcome, CheckError> {
    let detail = "signs of sin(1/(s - 1)) at 1/(s - 1) = k pi - 1/10 and k pi + 1/10, enclosed";
    // The potential is none of those that are meant where minima are isolated.
    if variant.isolated {
        return Ok(Outcome::Holds(Vec::new()));
    }
    run.every(certified("two agents near a minimum that is not isolated", detail), [[10_i64, 100, 1000, 10_000]], |list| {
        let one = Interval::from_rational(&rational(1, 1), 80);
        for k in list {
            let sine = |tenths: i64| -> Result<Interval, CheckError> {
                let s = one.clone() + (one.pi() * one.integer(k) + one.ratio(tenths, 10)).recip()?;
                Ok((s - &one).recip()?.sin_cos()?.0)
            };
            // Between the two s is less than 1 + 1/(3k).
            if !at_most(&(sine(-1)? * sine(1)?), &one.zero())? {
                return Ok(None);
            }
        }
        let within = list.map(|k| format!("1 + 1/{}", 3 * k)).join(", ");
        Ok(Some(format!(
            "two linked agents, V' = (s - 1)³ sin²(1/(s - 1))/s²: between 1 and each of {within} there is an s at which the slope vanishes; at rest there they stay, so the minimum s = 1 does not attract them"
        )))
    })
}

fn examine_manifold(variant: &ManifoldVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let is_complete = |graph: &Graph| *graph == Graph::complete(graph.order());
    let mut list: Vec<SteadyMotion> = SteadyMotion::paths().into_iter().rev().collect();
    list.extend([SteadyMotion::row_of_three(), SteadyMotion::triangle(), SteadyMotion::pair()]);
    let detail = "exact forces; characteristic polynomials of the pair and the triangle: 0 five times, the rest stable";
    let equilibria = run.instances("equilibria", detail, list, |motion| {
        if variant.complete && !is_complete(&motion.graph) || variant.minima && motion.not_minimised()?.is_some() {
            return Ok(None);
        }
        if !motion.is_steady()? {
            return Err(CheckError::Other(format!("{} is not steady", motion.name)));
        }
        if let Some((i, j)) = motion.coincident() {
            let (name, i, j) = (motion.name, i + 1, j + 1);
            let text = format!("{name}: an equilibrium in which agents {i} and {j} are in the same place");
            return Ok(Some(Counterexample::new(text, seen(&motion))));
        }
        let unstable = is_complete(&motion.graph) && motion.is_stable_up_to_motions() != Some(true);
        let how = "an equilibrium whose linearisation has an eigenvalue with positive real part";
        Ok(unstable.then(|| Counterexample::new(format!("{}: {how}", motion.name), seen(&motion))))
    })?;
    Run::all([
        Ok(equilibria.on([1, 2])).checks("the conclusion"),
        equilibria_near_one(variant, run).checks("the hypothesis").on([1]),
        energy_decreases(run, variant.damping).checks(DESCENT).on([1]),
        argued(&[1, 2], "isolated minima", "notes/tanner2.md, Theorem 1, steps 1 and 7"),
    ])
}

pub fn flocking() -> Record<ManifoldVariant> {
    Record::new(
        "tanner2.sec4.flocking",
        "Definition 1 forbids collisions of any two agents. On the path 1-2-3 agents 1 and 3 do not know each other, and the equilibrium with both in the same place belongs to the manifold. \
         On the complete graph nobody collides, but the equilibria include saddles (three agents in a row), which are not stable. A minimum has to be isolated among the critical configurations: \
         V' = (s - 1)³ sin²(1/(s - 1))/s² has a strict minimum at s = 1 with other equilibria as near as one likes.",
        ManifoldVariant { complete: false, minima: false, damping: 1, isolated: false },
        examine_manifold,
    )
    .clauses(&[
        "On a time invariant connected graph (4) creates an asymptotically stable equilibrium manifold.",
        "On it the group satisfies Definition 1: same velocity, distances stabilized, no collisions between agents.",
    ])
    .repaired(Fault::False, "", ManifoldVariant { complete: true, minima: true, damping: 1, isolated: true })
    .repaired_clauses(&[
        "Under (4) on the complete graph of N >= 2 agents with potentials of Definition 3 with a continuous gradient, the translates and \
         rotations of a strict minimum (up to motions) of the sum of the V_ij, near which there are no critical configurations but these, \
         with a common velocity, form an asymptotically stable set of equilibria in (r_ij, v_i - v_j).",
        "In them no two agents are in one place.",
    ])
    .altered("all equilibria of the complete graph", |v| v.minima = false)
    .altered("strict minima with other critical configurations near them too", |v| v.isolated = false)
    .altered("alignment with the other sign", |v| v.damping = -1)
}

fn examine_definition(potentials: &Vec<Potential>, run: &mut Run) -> Result<Outcome, CheckError> {
    let detail = "signs of the slope and of its leading terms, exact roots";
    let fulfilled = run.instances("the conditions of Definition 3", detail, potentials, |potential| {
        Ok(potential.check_definition3().err().map(|problem| {
            let (numerator, power) = potential.slope_numerator();
            format!("slope with numerator coefficients {:?} over s^{power}: {problem}", numerator.coefficients())
        }))
    })?;
    Ok(match fulfilled {
        Outcome::Holds(evidence) => Outcome::NotCheckable(
            "a definition: it says what the theorems assume, and has no truth value".to_string(),
            evidence.into_iter().map(|e| e.on([1])).collect(),
        ),
        other => other,
    })
}

pub fn definition3() -> Record<Vec<Potential>> {
    let one = rational(1, 1);
    Record::new(
        "tanner2.def3",
        "It can be fulfilled, by the companion's 1/s + log s and by s + 1/s - 2. The proofs use more: a continuous gradient (Section 4: smooth laws), a positive slope at R \
         (Lemma 1), and for Corollary 1 no critical point but the minimum, which Definition 3 does not give: see tanner2.cor1.",
        vec![
            logarithmic(),
            spring(),
            Potential::inverse_square_spring(&rational(4, 1), &rational(1, 2)),
            SteadyMotion::inflected_pair().potential,
        ],
        examine_definition,
    )
    .control("V = s, without repulsion", vec![sloped(&[(0, 1)], 1)])
    .control("1/(2s²) - 1/s + 1/2, bounded", vec![sloped(&[(-2, 1), (-3, -1)], 0)])
    .control("s + 1/s - 3, negative at its minimum", vec![Potential::new(
        vec![(0, one.clone()), (-2, -one.clone())],
        (one, rational(-1, 1)),
    )])
}

/// Trees or any connected graph; potentials of Definition 3 or those without other critical points; distances of edges or of all pairs.
#[derive(Clone, Copy)]
pub struct SetpointVariant {
    trees: bool,
    single: bool,
    all_pairs: bool,
}

/// The desired squared distance, and whether a variant means this equilibrium.
fn setpoint(variant: &SetpointVariant, motion: &SteadyMotion) -> (Rational, bool) {
    let critical = motion.potential.critical().unwrap_or_default();
    let meant = (motion.graph.is_tree() || !variant.trees) && (critical.len() == 1 || !variant.single);
    (critical.into_iter().min().unwrap_or(rational(1, 1)), meant)
}

fn examine_setpoints(variant: &SetpointVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    // Equilibria of two and three agents.
    let list = [
        vec![SteadyMotion::inflected_pair(), SteadyMotion::triangle(), SteadyMotion::row_of_three()],
        SteadyMotion::paths().to_vec(),
    ]
    .concat();
    let equilibria = run.instances("distances in equilibrium", "exact forces", list, |motion| {
        let (desired, meant) = setpoint(variant, &motion);
        motion.potential.check_definition3()?;
        let all = Graph::complete(motion.graph.order());
        let graph = if variant.all_pairs { all } else { motion.graph.clone() };
        let squares = SteadyMotion { graph, ..motion.clone() }.squares();
        let off = squares.iter().find(|square| meant && **square != desired);
        let name = motion.name;
        Ok(off.map(|square| format!("{name}: an equilibrium with a squared distance {square}, not {desired}")))
    })?;
    let trees = connected(6).into_iter().filter(|graph| graph.order() > 1 && (graph.is_tree() || !variant.trees));
    let kernels = run.instances("kernels of B", "all trees of 2 to 6 agents", trees, |tree: Graph| {
        let dependent = !tree.incidence()?.kernel().is_empty();
        Ok(dependent.then(|| format!("edges {:?}: dependent columns", tree.edges())))
    })?;
    Run::all([
        Ok(equilibria.on([3])).checks("the conclusion"),
        Ok(kernels.on([2])).checks("Laplacians, step 5"),
        argued(&[1, 2, 3], "setpoints", "notes/tanner2.md, Theorem 1, steps 1 to 6, and Laplacians, step 5"),
    ])
}

pub fn cor1() -> Record<SetpointVariant> {
    Record::new(
        "tanner2.cor1",
        "B has full column rank, so every grad_{r_ij} V_ij vanishes in the limit. But V' = 0 does not say that V is least: V' = (s - 1)(s - 4)²(s + 2/3)/s² gives a potential of Definition 3, rational, with its unique minimum at s = 1 and \
         increasing beyond, and two agents at rest at s = 4 stay there.",
        SetpointVariant { trees: true, single: false, all_pairs: false },
        examine_setpoints,
    )
    .clauses(&[
        "If the neighboring graph is a tree, inter-agent distances can be stabilized to desired setpoints.",
        "B full rank gives grad_{r_ij} V_ij = 0.",
        "dV_ij/d||r_ij|| = 0 implies ||r_ij|| = r_d, where V_ij attains its unique minimum.",
    ])
    .reading("distances of linked agents, under (4) as in Theorem 1; potentials of Definition 3 with a continuous gradient, starts in which no linked agents coincide")
    .repaired_by(Fault::Hypothesis, "", |v| v.single = true)
    .repaired_clauses(&[
        "Under (4), with potentials of Definition 3 with a continuous gradient, from starts in which no linked agents are in one place: if \
         the fixed graph is a tree and V_ij' vanishes at the minimum only, every distance of linked agents tends to its desired value.",
        "If the fixed graph is a tree, B has independent columns, so that under the same hypotheses, but for the one on V_ij', every \
         grad_{r_ij} V_ij of linked agents tends to 0.",
        "In an equilibrium of a tree whose V_ij, potentials of Definition 3 with a continuous gradient, have V_ij' = 0 at the minimum only, \
         every linked distance is the desired one.",
    ])
    .altered("any connected graph", |v| v.trees = false)
    .altered("the distances of all pairs", |v| v.all_pairs = true)
}

/// Theorem 2 with the graph connected always, or at the start only, or never.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Connected {
    /// At all times.
    Always,
    /// At the start.
    AtFirst,
}

/// Hypothesis and conclusion of Theorem 2.
#[derive(Clone, Copy)]
pub struct SwitchingVariant {
    connected: Connected,
    /// Whether each agent takes its own weights of tied links.
    pub(super) agentwise: bool,
    /// As in [`LimitVariant`].
    pub(super) connectivity: i64,
    conclusion: Conclusion,
}

/// Whether two agents can part for good from a linked start: a state at the threshold on its way out from which the law of the linked
/// side can be followed back, and without link the squared distance grows for ever.
fn two_agents_part() -> Option<String> {
    let q = |n: i64| rational(n, 1);
    let state = State { positions: vec![[q(0), q(0)], [q(2), q(0)]], velocities: vec![[q(0), q(0)], [q(1), q(0)]] };
    let out = PLANE.product(&state.separation(0, 1), &state.relative_velocity(0, 1));
    let linked = velocity_alignment(&state, &[(0, 1)], PLANE, |_, _, s| spring().slope(s));
    // |r + vt|² has the rate 2 r.v + 2 |v|² t.
    let parts = out > q(0) && linked.is_ok();
    parts.then(|| "two agents at distance R = 2 with relative velocity (1, 0) outward: followed back they come from a linked start, followed on they keep different velocities for ever".to_string())
}

/// Whether the swing of [`swing_weights`] is a solution: with any weights in `[0, 1]`, or with the same one for both agents.
fn swing(agentwise: bool) -> Result<Option<String>, CheckError> {
    if !agentwise {
        let same = swing_weights(&rational(1, 1), &rational(0, 1))?.is_some_and(|[a, b]| a == b);
        return Ok(same.then(|| "the weights agree at t = pi/2".to_string()));
    }
    // The whole period at once.
    let all = Interval::hull_of_rationals(&rational(-1, 1), &rational(1, 1), 80);
    let Some(found) = swing_weights(&all, &all)? else { return Ok(None) };
    let between = |m: &Interval| m.is_certainly_positive() && (m.one() - m).is_certainly_positive();
    Ok(found.iter().all(between).then(|| {
        "V = s + 1/s - 2, R = 9/5, agents 1 and 2 at distance R and agent 3 between them, at (1/50) sin t from the middle: a solution for all time if agents 1 and 2 weigh their link differently; velocities never agree".to_string()
    }))
}

/// Motions that hold up, and what else is computed beside the proof of Theorem 2.
fn beside_section_5(steady: Outcome, connectivity: i64, run: &Run) -> Result<Outcome, CheckError> {
    Run::all([
        Ok(steady).checks("the conclusion"),
        positive_connectivity(connectivity, run).checks("Laplacians, step 4, which step 6 uses"),
        hulls(&HullVariant::Subset, run).checks("Equation (13), step 4"),
    ])
}

/// The checks beside the proof of Theorem 2, without clauses.
pub(super) fn switching_checks(variant: &SwitchingVariant, run: &Run) -> Result<Outcome, CheckError> {
    let far = rational(9, 1);
    let mut list = Vec::new();
    for motion in SteadyMotion::all_known() {
        // The motions whose graph is that of R = 3 (in units of the desired distance), for potentials increasing at R.
        let by_distance = linked_within(&motion.state.positions, &far, motion.coordinates) == motion.graph;
        if by_distance && motion.potential.slope(&far)? > rational(0, 1) {
            list.push(motion);
        }
    }
    let steady = uncontradicted(run, list, true, variant.conclusion)?;
    if !matches!(steady, Outcome::Holds(_)) || variant.conclusion != Conclusion::Agree {
        return beside_section_5(steady, variant.connectivity, run);
    }
    if let Some(what) = two_agents_part().filter(|_| variant.connected == Connected::AtFirst) {
        return Ok(Outcome::fails(what, exact("an exact motion", "rates at the threshold, exact")));
    }
    if let Some(what) = swing(variant.agentwise)? {
        let detail = "weights of the tied link, enclosed for the whole period";
        return Ok(Outcome::fails(what, certified("a motion for all time", detail)));
    }
    beside_section_5(steady, variant.connectivity, run)
}

/// Theorem 2's first conclusion, under the reading of `tanner2.thm2_vel`.
pub(super) const VELOCITIES: SwitchingVariant =
    SwitchingVariant { connected: Connected::Always, agentwise: false, connectivity: 0, conclusion: Conclusion::Agree };

pub fn thm2_vel() -> Record<SwitchingVariant> {
    Record::new(
        "tanner2.thm2_vel",
        "The printed proof needs regularity (Lemma 1, false) and uniqueness (false), but the statement is true for every Filippov solution: almost everywhere dQ/dt = -v^T (L_m kron I_2) v, where L_m has \
         weights in [0, 1] on tied pairs and 1 on links, so dQ/dt <= -l |v - mean|² with l the least lambda_2 of connected graphs. Hence |v - mean|² is integrable; its rate is bounded since distances of linked agents stay away from 0; it tends to 0. \
         With K agent by agent the two agents of a tied pair could weigh it differently; then momentum is not kept and velocities need not agree (a control).",
        VELOCITIES,
        |variant, run| Run::all([
            switching_checks(variant, run),
            argued(&[1], "the limits", "notes/tanner2.md, Section 5, steps 1 to 7"),
        ]),
    )
    .reading("K of the whole vector field, as in Definition 4, every Filippov solution, potentials of Definition 3 with a continuous gradient, starts in which no two agents are in one place, and a graph of the links |r_ij| < R that is connected at all times. As (10b) is printed, agent by agent (v'_i in K[u_i]), the statement is false: three agents on a line, V = s + 1/s - 2, R = 9/5, agents 1 and 2 at distance R and agent 3 swinging between them, never agree (the control with K agent by agent)")
    .altered("with K agent by agent", |v| v.agentwise = true)
    .altered("connected at the start only", |v| v.connected = Connected::AtFirst)
    .altered("all velocities tend to zero", |v| v.conclusion = Conclusion::Stop)
    .altered("step 6 of the proof: with lambda_2 > 1", |v| v.connectivity = 1)
}

pub fn thm2_pot() -> Record<SwitchingVariant> {
    Record::new(
        "tanner2.thm2_pot",
        "The same row of three agents: with R = 3 every pair is linked, V is increasing at R, and they stay at rest at a saddle. What survives: every limit point has equal velocities and is a Filippov equilibrium, 0 in K[grad_{r_i} V_i] for all i; without ties \
         that is grad_{r_i} V_i = 0.",
        SwitchingVariant { conclusion: Conclusion::Minimised, ..VELOCITIES },
        |variant, run| Run::all([
            switching_checks(variant, run),
            argued(&[1], "the limits", "notes/tanner2.md, Section 5, steps 1 to 9"),
        ]),
    )
    .reading("as tanner2.thm2_vel")
    .repaired(
        Fault::False,
        "With potentials of Definition 3 with a continuous gradient, no two agents in one place at the start and the graph of the links \
         |r_ij| < R connected at all times, every Filippov solution of (10), with K of the whole vector field, approaches the set of \
         configurations with 0 in K[(grad_{r_i} V_i)_i], K again of the gradients of all agents together (critical configurations, where no \
         pair is at distance R).",
        SwitchingVariant { conclusion: Conclusion::Critical, ..VELOCITIES },
    )
    .altered("critical and at rest", |v| v.conclusion = Conclusion::Stop)
    .altered("step 6 of the proof: with lambda_2 > 1", |v| v.connectivity = 1)
}
