//! tanner2.thm1a, thm1c, sec4.flocking, def3, cor1, thm2_vel, thm2_pot: where the motions go.

use super::agentwise::swing;
use super::arbitrary::Arbitrary;
use super::energy::{EdgeSum, on_connected};
use super::motions::{Motion, inflected_pair, motions, paths, row_of_three, triangle};
use super::nonsmooth::{HullVariant, examine_hull};
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use algebra::spectrum::Polynomial;
use arithmetic::{Rational, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Fault, Grade, Outcome, Run};
use models::double_integrator::{Coordinates, Potential, State, linearisation, linked_within, velocity_alignment};

/// What is said of every motion.
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

/// Under which hypotheses.
#[derive(Clone, Copy)]
pub struct LimitVariant {
    connected: bool,
    conclusion: Conclusion,
}

/// Whether an exact motion contradicts a conclusion about limits: its velocities and distances are those of its start for ever.
fn contradicts(motion: &Motion, conclusion: Conclusion) -> Result<Option<String>, CheckError> {
    let zero = rational(0, 1);
    Ok(match conclusion {
        Conclusion::Agree => (!motion.agrees()).then(|| "keep different velocities".to_string()),
        Conclusion::Stop => {
            let moves = motion.state.velocities.iter().flatten().any(|x| *x != zero);
            moves.then(|| "keep their velocities".to_string())
        }
        Conclusion::Minimised => motion.not_minimised()?.map(|agent| {
            format!(
                "stay there, though the potential of agent {} is not least: it falls when that agent moves aside",
                agent + 1
            )
        }),
        Conclusion::Critical => (!motion.is_critical()?).then(|| "stay at a point that is not critical".to_string()),
    })
}

/// A motion among `motions` that contradicts the conclusion.
fn refuted_by(motions: &[Motion], connected: bool, conclusion: Conclusion) -> Result<Option<Outcome>, CheckError> {
    for motion in motions.iter().filter(|motion| !connected || motion.graph.is_connected()) {
        if !motion.is_steady()? {
            return Err(CheckError::Other(format!("{} is not steady", motion.name)));
        }
        if let Some(how) = contradicts(motion, conclusion)? {
            let what = format!("{}: the agents {how}", motion.name);
            return Ok(Some(Outcome::fails(
                what,
                Evidence::new(Grade::Exact, "an exact motion", "accelerations and derivatives, exact"),
            )));
        }
    }
    Ok(None)
}

/// `lambda_2 > 0` on connected graphs, and the exact motions.
fn support(run: &Run, part: &str, notes: &str) -> Result<Outcome, CheckError> {
    let graphs: Vec<Graph> = Arbitrary::connected(5).into_iter().filter(|graph| graph.order() > 1).collect();
    for graph in &graphs {
        run.checkpoint()?;
        if graph.laplacian()?.characteristic_polynomial()?.count_above(&rational(0, 1)) + 1 != graph.order() {
            return Ok(Outcome::Undecided("a connected graph without positive lambda_2".to_string()));
        }
    }
    let detail = format!(
        "proof in notes/tanner2.md: {notes}; lambda_2 > 0 exactly on all connected graphs of 2 to 5 agents, and no exact motion contradicts it"
    );
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, part, detail).cases(graphs.len())]))
}

fn examine_fixed(variant: &LimitVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    if let Some(outcome) = refuted_by(&motions(), variant.connected, variant.conclusion)? {
        return Ok(outcome);
    }
    let identity = on_connected(run, "dW/dt is minus the sum of |v_i - v_j|² over the edges", EdgeSum);
    Run::all([
        support(
            run,
            "the limits",
            "W decreases, Omega is compact, and LaSalle's principle leaves equal velocities and vanishing gradients",
        ),
        identity,
    ])
}

pub fn thm1a() -> Record<LimitVariant> {
    let printed = LimitVariant { connected: true, conclusion: Conclusion::Agree };
    Record::new(
        "tanner2.thm1a",
        "dW/dt = -v^T (L kron I_2) v <= 0 and Omega is compact in (r_ij, v_i), so the motion exists for all time and tends to the largest invariant set with equal velocities. The sum of all velocities is kept, \
         so each tends to the mean of the initial ones. A continuous V' is enough for this part: the squared disagreement is integrable along every solution and has a bounded rate (Barbalat), without LaSalle's principle and without uniqueness (notes/tanner2.md).",
        printed,
        examine_fixed,
    )
    .control("any graph", LimitVariant { connected: false, ..printed })
    .control("all velocities tend to zero", LimitVariant { conclusion: Conclusion::Stop, ..printed })
}

pub fn thm1c() -> Record<LimitVariant> {
    let printed = LimitVariant { connected: true, conclusion: Conclusion::Minimised };
    let repaired = LimitVariant { conclusion: Conclusion::Critical, ..printed };
    Record::new(
        "tanner2.thm1c",
        "The proof shows grad V_i = 0 only. Three agents at rest in a row with all pairs linked are in equilibrium where 2 V'(a²) a + 4 V'(4a²) a = 0; with V = m/s + log(s/m) this is a² = 3m/4. The middle one sits at \
         a saddle of its own potential. By symmetry every start in a row with velocities along it stays in a row, so a whole set of starts tends to such points. (Also: with four or more agents no configuration in the plane makes all \
         V_ij least at once.)",
        printed,
        examine_fixed,
    )
    .repaired(
        Fault::False,
        "... and the system approaches the set of critical configurations, grad_{r_i} V_i = 0 for all i (which minimise every V_ij if the graph is a tree and V_ij' vanishes at the minimum only).",
        repaired,
    )
    .control("minimised, on any graph", LimitVariant { connected: false, ..printed })
    .control("critical and at rest", LimitVariant { conclusion: Conclusion::Stop, ..repaired })
}

// --- Section 4, first paragraph ---

/// Which equilibria are said to be asymptotically stable and free of collisions.
#[derive(Clone, Copy)]
pub struct ManifoldVariant {
    complete: bool,
    minima: bool,
}

/// The characteristic polynomial of the linearised loop.
fn characteristic(motion: &Motion) -> Result<Polynomial, CheckError> {
    let rows = linearisation(&motion.state, &motion.graph.edges(), motion.coordinates, &motion.potential)?;
    let polynomial = RationalMatrix::from_rows(&rows)?.characteristic_polynomial()?;
    Ok(Polynomial::from_rationals(&polynomial.coefficients()))
}

/// Stable up to translations, rotations and a common velocity, which give the eigenvalue 0 five times.
fn is_stable_up_to_motions(motion: &Motion) -> Result<bool, CheckError> {
    let (zero, rest) = characteristic(motion)?.without_root(0);
    Ok(zero == 5 && rest.is_hurwitz())
}

fn examine_manifold(variant: &ManifoldVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let is_complete = |graph: &Graph| graph.edges().len() == graph.order() * (graph.order() - 1) / 2;
    let mut list: Vec<Motion> = paths().into_iter().rev().collect();
    list.extend([row_of_three(), triangle(), super::motions::pair()]);
    let mut cases = 0;
    for motion in &list {
        if variant.complete && !is_complete(&motion.graph) || variant.minima && motion.not_minimised()?.is_some() {
            continue;
        }
        let evidence = Evidence::new(Grade::Exact, "equilibria", "exact forces and characteristic polynomials");
        if !motion.is_steady()? {
            return Err(CheckError::Other(format!("{} is not steady", motion.name)));
        }
        if let Some((i, j)) = motion.coincident() {
            let what = format!(
                "{}: an equilibrium in which agents {} and {} are in the same place",
                motion.name,
                i + 1,
                j + 1
            );
            return Ok(Outcome::fails(what, evidence));
        }
        if is_complete(&motion.graph) && !is_stable_up_to_motions(motion)? {
            let what = format!(
                "{}: an equilibrium whose linearisation has an eigenvalue with positive real part",
                motion.name
            );
            return Ok(Outcome::fails(what, evidence));
        }
        cases += 1;
    }
    let detail = "for all: proof in notes/tanner2.md (W as Lyapunov function near a strict minimum of the potential); characteristic polynomials of the pair and the triangle: 0 five times, the rest stable";
    let instances = Outcome::Holds(vec![Evidence::new(Grade::Exact, "equilibria", detail).cases(cases)]);
    Run::all([Ok(instances), on_connected(run, "dW/dt is minus the sum of |v_i - v_j|² over the edges", EdgeSum)])
}

pub fn flocking() -> Record<ManifoldVariant> {
    let printed = ManifoldVariant { complete: false, minima: false };
    let repaired = ManifoldVariant { complete: true, minima: true };
    Record::new(
        "tanner2.sec4.flocking",
        "Definition 1 forbids collisions of any two agents. On the path 1-2-3 agents 1 and 3 do not know each other, and the equilibrium with both in the same place belongs to the manifold. \
         On the complete graph nobody collides, but the equilibria include saddles (three agents in a row), which are not stable.",
        printed,
        examine_manifold,
    )
    .repaired(
        Fault::False,
        "On the complete graph the equilibria at strict minima of the potential (up to translation and rotation) with a common velocity form an asymptotically stable manifold without collisions; on any connected graph \
         velocities agree in the limit and linked agents do not collide.",
        repaired,
    )
    .control("all equilibria of the complete graph", ManifoldVariant { complete: true, minima: false })
    .control("minima on any connected graph", ManifoldVariant { complete: false, minima: true })
}

// --- Definition 3 and Corollary 1 ---

fn examine_definition(potentials: &Vec<Potential>, _run: &mut Run) -> Result<Outcome, CheckError> {
    let evidence = Evidence::new(
        Grade::Exact,
        "the conditions of Definition 3",
        "signs of the slope and of its leading terms, exact roots",
    );
    for potential in potentials {
        if let Err(problem) = potential.check_definition3() {
            let (numerator, power) = potential.slope_numerator();
            let what =
                format!("slope with numerator coefficients {:?} over s^{power}: {problem}", numerator.coefficients());
            return Ok(Outcome::fails(what, evidence));
        }
    }
    Ok(Outcome::Holds(vec![evidence.cases(potentials.len())]))
}

pub fn definition3() -> Record<Vec<Potential>> {
    let one = rational(1, 1);
    let of = |slope: &[(i32, i64)], least: i64| {
        vec![Potential::new(
            slope.iter().map(|&(k, c)| (k, rational(c, 1))).collect(),
            (one.clone(), rational(least, 1)),
        )]
    };
    Record::new(
        "tanner2.def3",
        "A definition: it is what the theorems assume, and it can be fulfilled, by the companion's 1/s + log s and by s + 1/s - 2. The proofs use more: a continuous gradient (Section 4: smooth laws), a positive slope at R \
         (Lemma 1), and for Corollary 1 no critical point but the minimum, which Definition 3 does not give: see tanner2.cor1.",
        vec![
            Potential::inverse_square_log(&one),
            Potential::inverse_square_spring(&one, &one),
            Potential::inverse_square_spring(&rational(4, 1), &rational(1, 2)),
            inflected_pair().potential,
        ],
        examine_definition,
    )
    .control("V = s, without repulsion", of(&[(0, 1)], 1))
    .control("log s - 1/s, which tends to minus infinity at 0", of(&[(-1, 1), (-2, 1)], 0))
    .control("1/(2s²) - 1/s + 1/2, bounded", of(&[(-2, 1), (-3, -1)], 0))
    .control("s + 1/s - 3, negative at its minimum", of(&[(0, 1), (-2, -1)], -1))
}

/// Trees or any connected graph; potentials of Definition 3 or those without other critical points; distances of edges or of all pairs.
#[derive(Clone, Copy)]
pub struct SetpointVariant {
    trees: bool,
    single: bool,
    all_pairs: bool,
}

fn examine_setpoints(variant: &SetpointVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let evidence = |detail: &str| Evidence::new(Grade::Exact, "distances in equilibrium", detail.to_string());
    let one = rational(1, 1);
    // Equilibria of two and three agents.
    for motion in [vec![inflected_pair(), triangle(), row_of_three()], paths().to_vec()].concat() {
        let is_tree = motion.graph.edges().len() + 1 == motion.graph.order();
        let critical = motion.potential.critical();
        if variant.trees && !is_tree || variant.single && critical.as_ref().is_none_or(|list| list.len() != 1) {
            continue;
        }
        motion.potential.check_definition3().map_err(|error| CheckError::Other(error.to_string()))?;
        let desired = critical.and_then(|list| list.into_iter().min()).unwrap_or(one.clone());
        let pairs: Vec<Rational> = if variant.all_pairs {
            let all = Graph::from_fn(motion.graph.order(), |_, _| true);
            Motion { graph: all, ..motion.clone() }.squares()
        } else {
            motion.squares()
        };
        if let Some(square) = pairs.iter().find(|square| **square != desired) {
            let what = format!("{}: an equilibrium with a squared distance {square}, not {desired}", motion.name);
            return Ok(Outcome::fails(what, evidence("exact forces")));
        }
    }
    // On a tree B has no kernel, so every force vanishes.
    let trees: Vec<Graph> =
        Arbitrary::connected(6).into_iter().filter(|g| g.order() > 1 && g.edges().len() + 1 == g.order()).collect();
    for tree in &trees {
        if !tree.incidence()?.kernel().is_empty() {
            return Ok(Outcome::Undecided("a tree with dependent columns".to_string()));
        }
    }
    let detail = "for all trees: B has independent columns, each force vanishes in the limit, and V' vanishes at the minimum only; kernels of B for all trees of 2 to 6 agents, critical points by Sturm";
    Run::all([
        Ok(Outcome::Holds(vec![evidence(detail).cases(trees.len())])),
        on_connected(run, "dW/dt is minus the sum of |v_i - v_j|² over the edges", EdgeSum),
    ])
}

pub fn cor1() -> Record<SetpointVariant> {
    let printed = SetpointVariant { trees: true, single: false, all_pairs: false };
    let repaired = SetpointVariant { single: true, ..printed };
    Record::new(
        "tanner2.cor1",
        "B has full column rank, so every grad_{r_ij} V_ij vanishes in the limit. But V' = 0 does not say that V is least: V' = (s - 1)(s - 4)²(s + 2/3)/s² gives a potential of Definition 3, rational, with its unique minimum at s = 1 and \
         increasing beyond, and two agents at rest at s = 4 stay there.",
        printed,
        examine_setpoints,
    )
    .repaired(
        Fault::False,
        "If the graph is a tree and V_ij' vanishes at the minimum only, every distance of linked agents tends to its desired value.",
        repaired,
    )
    .control("any connected graph", SetpointVariant { trees: false, ..repaired })
    .control("the distances of all pairs", SetpointVariant { all_pairs: true, ..repaired })
}

// --- Theorem 2 ---

/// Theorem 2 with the graph connected always, or at the start only, or never.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Connected {
    /// At all times.
    Always,
    /// At the start.
    AtFirst,
    /// Not assumed.
    Never,
}

/// Hypothesis and conclusion of Theorem 2.
#[derive(Clone, Copy)]
pub struct SwitchingVariant {
    connected: Connected,
    /// Whether each agent takes its own weights of tied links.
    agentwise: bool,
    conclusion: Conclusion,
}

/// Whether two agents can part for good from a linked start: a state at the threshold on its way out from which the law of the linked
/// side can be followed back, and without link the squared distance grows for ever.
fn two_agents_part() -> Result<Option<String>, CheckError> {
    let q = |n: i64| rational(n, 1);
    let potential = Potential::inverse_square_spring(&q(1), &q(1));
    let state = State { positions: vec![[q(0), q(0)], [q(2), q(0)]], velocities: vec![[q(0), q(0)], [q(1), q(0)]] };
    let out = Coordinates::Cartesian.product(&state.separation(0, 1), &state.relative_velocity(0, 1));
    let linked = velocity_alignment(&state, &[(0, 1)], Coordinates::Cartesian, |_, _, s| potential.slope(s));
    // |r + vt|² has the rate 2 r.v + 2 |v|² t.
    let parts = out > q(0) && linked.is_ok();
    Ok(parts.then(|| "two agents at distance R = 2 with relative velocity (1, 0) outward: followed back they come from a linked start, followed on they keep different velocities for ever".to_string()))
}

fn examine_switching(variant: &SwitchingVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let far = rational(9, 1);
    let mut list = Vec::new();
    for motion in motions() {
        // The motions whose graph is that of R = 3 (in units of the desired distance), for potentials increasing at R.
        let by_distance = linked_within(&motion.state.positions, &far, motion.coordinates) == motion.graph;
        if by_distance && motion.potential.slope(&far)? > rational(0, 1) {
            list.push(motion);
        }
    }
    if let Some(outcome) = refuted_by(&list, variant.connected != Connected::Never, variant.conclusion)? {
        return Ok(outcome);
    }
    if variant.connected != Connected::Always
        && variant.conclusion == Conclusion::Agree
        && let Some(what) = two_agents_part()?
    {
        return Ok(Outcome::fails(
            what,
            Evidence::new(Grade::Exact, "an exact motion", "rates at the threshold, exact"),
        ));
    }
    if variant.conclusion == Conclusion::Agree
        && let Some(what) = swing(variant.agentwise)?
    {
        let detail = "weights of the tied link, enclosed for the whole period";
        return Ok(Outcome::fails(what, Evidence::new(Grade::Certified, "a motion for all time", detail)));
    }
    let notes = "Q does not increase along any Filippov solution, the integral of |v - mean|² is finite, and velocities change at a bounded rate (Barbalat); the limits are invariant";
    Run::all([support(run, "the limits", notes), examine_hull(&HullVariant::Subset, run)])
}

pub fn thm2_vel() -> Record<SwitchingVariant> {
    let printed = SwitchingVariant { connected: Connected::Always, agentwise: false, conclusion: Conclusion::Agree };
    Record::new(
        "tanner2.thm2_vel",
        "Read with the graph connected at all times and with K of the whole vector field, as in Definition 4 (agent by agent, as (10b) is written, the two agents of a tied pair could weigh it differently; then momentum is not kept and velocities need not agree). The printed proof needs regularity (Lemma 1, false) and uniqueness (false), but the statement holds for every Filippov solution: almost everywhere dQ/dt = -v^T (L_m kron I_2) v, where L_m has \
         weights in [0, 1] on tied pairs and 1 on links, so dQ/dt <= -l |v - mean|² with l the least lambda_2 of connected graphs. Hence |v - mean|² is integrable; its rate is bounded since distances of linked agents stay away from 0; it tends to 0.",
        printed,
        examine_switching,
    )
    .control("with K agent by agent", SwitchingVariant { agentwise: true, ..printed })
    .control("connected at the start only", SwitchingVariant { connected: Connected::AtFirst, ..printed })
    .control("all velocities tend to zero", SwitchingVariant { conclusion: Conclusion::Stop, ..printed })
}

pub fn thm2_pot() -> Record<SwitchingVariant> {
    let printed =
        SwitchingVariant { connected: Connected::Always, agentwise: false, conclusion: Conclusion::Minimised };
    let repaired = SwitchingVariant { conclusion: Conclusion::Critical, ..printed };
    Record::new(
        "tanner2.thm2_pot",
        "The same row of three agents: with R = 3 every pair is linked, V is increasing at R, and they stay at rest at a saddle. What survives: every limit point has equal velocities and is a Filippov equilibrium, 0 in K[grad_{r_i} V_i] for all i; without ties \
         that is grad_{r_i} V_i = 0.",
        printed,
        examine_switching,
    )
    .repaired(
        Fault::False,
        "... and the system approaches the set of configurations with 0 in K[(grad_{r_i} V_i)_i] (critical configurations, where no pair is at distance R).",
        repaired,
    )
    .control("minimised, connected or not", SwitchingVariant { connected: Connected::Never, ..printed })
    .control("critical and at rest", SwitchingVariant { conclusion: Conclusion::Stop, ..repaired })
}
