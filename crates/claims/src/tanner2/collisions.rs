//! tanner2.thm1b, cor3, thm2_coll, noninter: which agents can collide.
//!
//! A collision of `i` and `j` can be reached exactly where the law is smooth at a state with `r_i = r_j`: give them different
//! velocities there and follow the motion back; a moment before, they were apart. Where the energy is infinite instead, it
//! cannot.

use super::arbitrary::Arbitrary;
use super::energy::{EdgeSum, on_connected};
use super::nonsmooth::{HullVariant, examine_hull};
use algebra::graph::Graph;
use arithmetic::{Rational, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Grade, Outcome, Run};
use models::double_integrator::{Coordinates, Pair, Potential, State, linked_within, velocity_alignment};

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
    /// All.
    All,
}

/// Collisions of these pairs are avoided, or cannot be ruled out.
#[derive(Clone)]
pub struct CollisionVariant {
    networks: Networks,
    pairs: Pairs,
    avoided: bool,
    potential: Potential,
}

/// `s + 1/s - 2`.
fn repulsive() -> Potential {
    Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1))
}

/// `(s - 1)²`, bounded where agents meet.
fn soft() -> Potential {
    Potential::new(vec![(1, rational(2, 1)), (0, rational(-2, 1))], (rational(1, 1), rational(0, 1)))
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
    let near = linked_within(&state.positions, &rational(10_000, 1), Coordinates::Cartesian);
    let edges = graph.unwrap_or(&near).edges();
    velocity_alignment(&state, &edges, Coordinates::Cartesian, |_, _, s| potential.slope(s)).is_ok()
}

fn examine(variant: &CollisionVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let evidence = |detail: &str| Evidence::new(Grade::Exact, "collisions", detail.to_string());
    let complete = |count: usize| Graph::from_fn(count, |_, _| true);
    let graphs: Vec<Graph> = match variant.networks {
        Networks::Connected => Arbitrary::connected(5),
        Networks::Complete | Networks::ByDistance => (1..=6).map(complete).collect(),
        Networks::AllButOne => (3..=6).map(|count| Graph::from_fn(count, |i, j| (i, j) != (0, 1))).collect(),
    };
    let mut cases = 0;
    for graph in &graphs {
        run.checkpoint()?;
        let count = graph.order();
        for pair in (0..count).flat_map(|j| (0..j).map(move |i| (i, j))) {
            let linked = graph.has_edge(pair.0, pair.1);
            if variant.pairs == Pairs::Linked && !linked || variant.pairs == Pairs::Unlinked && linked {
                continue;
            }
            let fixed = (variant.networks != Networks::ByDistance).then_some(graph);
            cases += 1;
            if can_meet(fixed, count, pair, &variant.potential) == variant.avoided {
                let what = if variant.avoided {
                    format!(
                        "{count} agents, edges {:?}: the law is smooth where agents {} and {} meet with different velocities; followed back from there they start apart",
                        graph.edges(),
                        pair.0 + 1,
                        pair.1 + 1
                    )
                } else {
                    format!(
                        "{count} agents, edges {:?}: the energy is infinite where agents {} and {} meet",
                        graph.edges(),
                        pair.0 + 1,
                        pair.1 + 1
                    )
                };
                return Ok(Outcome::fails(what, evidence("the law at a state where they meet, exact")));
            }
        }
    }
    if !variant.avoided {
        let detail = "for every graph and every such pair a start apart leads to a collision (smooth law at a meeting, followed back); the law at a meeting, exact, all connected graphs of up to 5 agents";
        return Ok(Outcome::Holds(vec![evidence(detail).cases(cases)]));
    }
    if let Err(problem) = variant.potential.check_definition3() {
        return Ok(Outcome::Undecided(format!("no barrier: {problem}")));
    }
    let detail = "for all: the energy does not increase (equation (9); for links by distance the notes) and is infinite where such a pair meets; the law is singular there, graphs of up to 5 or 6 agents";
    let barrier = Outcome::Holds(vec![evidence(detail).cases(cases)]);
    let decrease = if variant.networks == Networks::ByDistance {
        examine_hull(&HullVariant::Subset, run)
    } else {
        on_connected(run, "dW/dt is minus the sum of |v_i - v_j|² over the edges", EdgeSum)
    };
    Run::all([Ok(barrier), decrease])
}

pub fn thm1b() -> Record<CollisionVariant> {
    let printed =
        CollisionVariant { networks: Networks::Connected, pairs: Pairs::Linked, avoided: true, potential: repulsive() };
    Record::new(
        "tanner2.thm1b",
        "W does not increase and is at least V_ij, which tends to infinity where linked agents meet: |r_ij| stays above the smallest distance with V_ij <= W(0).",
        printed.clone(),
        examine,
    )
    .control("all agents", CollisionVariant { pairs: Pairs::All, ..printed.clone() })
    .control("V = (s - 1)², which stays bounded", CollisionVariant { potential: soft(), ..printed })
}

pub fn cor3() -> Record<CollisionVariant> {
    let printed =
        CollisionVariant { networks: Networks::Complete, pairs: Pairs::All, avoided: true, potential: repulsive() };
    Record::new(
        "tanner2.cor3",
        "All pairs are linked: Theorem 1's bound for linked agents is one for all.",
        printed.clone(),
        examine,
    )
    .control("complete but for one edge", CollisionVariant { networks: Networks::AllButOne, ..printed.clone() })
    .control("V = (s - 1)², which stays bounded", CollisionVariant { potential: soft(), ..printed })
}

pub fn thm2_coll() -> Record<CollisionVariant> {
    let printed =
        CollisionVariant { networks: Networks::ByDistance, pairs: Pairs::All, avoided: true, potential: repulsive() };
    Record::new(
        "tanner2.thm2_coll",
        "Q does not increase along any Filippov solution (tanner2.eq13) and is at least U_ij, which is V_ij near a collision, as close agents are linked, and tends to infinity. Connectivity is not needed.",
        printed.clone(),
        examine,
    )
    .control("links fixed, any connected graph", CollisionVariant { networks: Networks::Connected, ..printed.clone() })
    .control("V = (s - 1)², which stays bounded", CollisionVariant { potential: soft(), ..printed })
}

pub fn noninter() -> Record<CollisionVariant> {
    let printed = CollisionVariant {
        networks: Networks::Connected,
        pairs: Pairs::Unlinked,
        avoided: false,
        potential: repulsive(),
    };
    Record::new(
        "tanner2.noninter",
        "At a state where two agents without link meet and no linked ones do, the law is smooth. Let the two have different velocities there and follow the motion back for a short time: it starts with all agents apart and ends in \
         the collision. This works for every graph and every pair that is not linked.",
        printed.clone(),
        examine,
    )
    .control("linked pairs", CollisionVariant { pairs: Pairs::Linked, ..printed.clone() })
    .control("all pairs", CollisionVariant { pairs: Pairs::All, ..printed })
}
