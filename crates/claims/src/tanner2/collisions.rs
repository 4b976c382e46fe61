//! tanner2.thm1b, cor3, thm2_coll, noninter: which agents can collide.
//!
//! A collision of `i` and `j` can be reached exactly where the law is smooth at a state with `r_i = r_j`: give them different
//! velocities there and follow the motion back; a moment before, they were apart. Where the energy is infinite instead, it
//! cannot.

use super::fixtures::{DESCENT, PLANE, SMOOTH, connected, energy_decreases, pairs, soft, spring};
use super::graphs::shown;
use super::nonsmooth::{HullVariant, along_solutions, hulls};
use crate::prelude::*;
use algebra::graph::Graph;
use models::double_integrator::{Pair, Potential, State, linked_within, velocity_alignment};

/// The networks of a statement.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Networks {
    /// Fixed connected graphs.
    Connected,
    /// Fixed complete graphs.
    Complete,
    /// Complete graphs without one edge.
    AllButOne,
    /// Links within a distance.
    ByDistance,
}

/// The pairs of a statement.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Pairs {
    /// Linked ones.
    Linked,
    /// Those not linked.
    Unlinked,
    All,
}

/// Collisions of these pairs are avoided, or cannot be ruled out.
#[derive(Clone)]
pub struct CollisionVariant {
    networks: Networks,
    pairs: Pairs,
    avoided: bool,
    potential: Potential,
    /// The alignment of (4) times this, on a fixed graph.
    damping: i64,
    /// What is said of Q, for links by distance.
    hull: HullVariant,
}

impl CollisionVariant {
    fn new(networks: Networks, pairs: Pairs) -> Self {
        let potential = spring();
        CollisionVariant { networks, pairs, avoided: true, potential, damping: 1, hull: HullVariant::Subset }
    }
}

/// Agents apart from each other with different velocities, but for `pair`, which is in one place.
fn meeting(count: usize, pair: Pair) -> State<Rational> {
    let q = |n: usize| rational(n as i64, 1);
    let mut positions: Vec<[Rational; 2]> = (0..count).map(|k| [q(k) / q(3), q(k * k) / q(3)]).collect();
    positions[pair.1] = positions[pair.0].clone();
    State { positions, velocities: (0..count).map(|k| [q(k), q(1)]).collect() }
}

/// Whether a collision of `pair` can be reached: the law is smooth at a state where they meet with different velocities.
fn can_meet(graph: Option<&Graph>, count: usize, pair: Pair, potential: &Potential) -> bool {
    let state = meeting(count, pair);
    // By distance: whatever R, agents that meet are linked; all are within 100 here.
    let near = linked_within(&state.positions, &rational(10_000, 1), PLANE);
    let edges = graph.unwrap_or(&near).edges();
    velocity_alignment(&state, &edges, PLANE, |_, _, s| potential.slope(s)).is_ok()
}

impl CollisionVariant {
    fn graphs(&self) -> Vec<Graph> {
        match self.networks {
            Networks::Connected => connected(5),
            Networks::Complete | Networks::ByDistance => (1..=6).map(Graph::complete).collect(),
            Networks::AllButOne => (3..=6).map(|count| Graph::from_fn(count, |i, j| (i, j) != (0, 1))).collect(),
        }
    }

    fn means(&self, graph: &Graph, pair: Pair) -> bool {
        match self.pairs {
            Pairs::Linked => graph.has_edge(pair.0, pair.1),
            Pairs::Unlinked => !graph.has_edge(pair.0, pair.1),
            Pairs::All => true,
        }
    }
}

fn examine(variant: &CollisionVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let graphs = variant.graphs();
    let cases = graphs.iter().flat_map(|graph| pairs(graph.order()).map(move |pair| (graph, pair)));
    let cases = cases.filter(|(graph, pair)| variant.means(graph, *pair));
    let detail = "the law at a state where they meet, exact, graphs of up to 5 or 6 agents";
    let meetings = run.instances("collisions", detail, cases, |(graph, pair)| {
        let fixed = (variant.networks != Networks::ByDistance).then_some(graph);
        let meet = can_meet(fixed, graph.order(), pair, &variant.potential);
        let (i, j) = (pair.0 + 1, pair.1 + 1);
        Ok((meet == variant.avoided).then(|| match variant.avoided {
            true => {
                let why = if fixed.is_none_or(|graph| graph.has_edge(pair.0, pair.1)) {
                    "linked by a potential with a slope at distance 0"
                } else {
                    "which are not linked"
                };
                format!("{}: the law is smooth where agents {i} and {j}, {why}, meet with different velocities; followed back from there they start apart", shown(graph))
            }
            false => format!("{}: the energy is infinite where agents {i} and {j} meet", shown(graph)),
        }))
    })?;
    if !variant.avoided {
        return Run::all([
            Ok(meetings).checks("step 8"),
            argued(&[1], "collisions", "notes/tanner2.md, Theorem 1, step 8"),
        ]);
    }
    if !matches!(meetings, Outcome::Holds(_)) {
        return Ok(meetings);
    }
    if let Err(problem) = variant.potential.check_definition3() {
        return Ok(Outcome::Undecided(format!("no barrier: {problem}")));
    }
    let (decrease, steps) = if variant.networks == Networks::ByDistance {
        let hulls = hulls(&variant.hull, run).checks("Equation (13), step 4");
        let both = [hulls, along_solutions(&variant.hull, run).checks("step 3")];
        (Run::all(both), "notes/tanner2.md, Section 5, steps 1 to 5")
    } else {
        (energy_decreases(run, variant.damping).checks(DESCENT), "notes/tanner2.md, Theorem 1, steps 1 and 2")
    };
    Run::all([Ok(meetings).checks("the conclusion"), decrease, argued(&[1], "the barrier", steps)])
}

pub fn thm1b() -> Record<CollisionVariant> {
    Record::new(
        "tanner2.thm1b",
        "W does not increase and is at least V_ij, which tends to infinity where linked agents meet: |r_ij| stays above the smallest distance with V_ij <= W(0).",
        CollisionVariant::new(Networks::Connected, Pairs::Linked),
        examine,
    )
    .reading(SMOOTH)
    .altered("all agents", |v| v.pairs = Pairs::All)
    .altered("alignment with the other sign", |v| v.damping = -1)
    .altered("V = (s - 1)², which stays bounded", |v| v.potential = soft())
}

pub fn cor3() -> Record<CollisionVariant> {
    Record::new(
        "tanner2.cor3",
        "All pairs are linked: Theorem 1's bound for linked agents is one for all.",
        CollisionVariant::new(Networks::Complete, Pairs::All),
        examine,
    )
    .reading(SMOOTH)
    .altered("complete but for one edge", |v| v.networks = Networks::AllButOne)
    .altered("alignment with the other sign", |v| v.damping = -1)
    .altered("V = (s - 1)², which stays bounded", |v| v.potential = soft())
}

pub fn thm2_coll() -> Record<CollisionVariant> {
    Record::new(
        "tanner2.thm2_coll",
        "Q does not increase along any Filippov solution (tanner2.eq13) and is at least U_ij, which is V_ij near a collision, as close agents are linked, and tends to infinity. Connectivity is not needed.",
        CollisionVariant::new(Networks::ByDistance, Pairs::All),
        examine,
    )
    .reading("every Filippov solution, K of the whole vector field; potentials of Definition 3 with a continuous gradient, starts in which no two agents coincide")
    .altered("links fixed, any connected graph", |v| v.networks = Networks::Connected)
    .altered("Q with potentials that are not cut off at R", |v| v.hull = HullVariant::Uncut)
    .altered("V = (s - 1)², which stays bounded", |v| v.potential = soft())
}

pub fn noninter() -> Record<CollisionVariant> {
    let printed = CollisionVariant { avoided: false, ..CollisionVariant::new(Networks::Connected, Pairs::Unlinked) };
    Record::new(
        "tanner2.noninter",
        "At a state where two agents without link meet and no linked ones do, the law is smooth. Let the two have different velocities there and follow the motion back for a short time: it starts with all agents apart and ends in \
         the collision. This works for every graph and every pair that is not linked.",
        printed.clone(),
        examine,
    )
    .reading("\"cannot be ensured\": for every graph and every pair that is not linked some start leads to a collision")
    .altered("linked pairs", |v| v.pairs = Pairs::Linked)
}
