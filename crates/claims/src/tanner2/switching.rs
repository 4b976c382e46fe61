//! tanner2.arbswitch, thm2_stop: switching by any signal, and switching by distance that ends or does not.

use super::fixtures::spring;
use super::limits::{SwitchingVariant, VELOCITIES, switching_checks};
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use models::double_integrator::{Pair, Potential, crosses_for_ever};

/// Two trees in turn, and the dimension of space.
#[derive(Clone)]
pub(crate) struct Trees {
    pub agents: usize,
    pub trees: [Vec<Pair>; 2],
    pub dimension: usize,
}

impl Trees {
    /// Two paths through four agents that together have all six edges.
    pub fn two_paths() -> Self {
        let trees = [vec![(0, 1), (1, 2), (2, 3)], vec![(1, 3), (0, 3), (0, 2)]];
        Trees { agents: 4, trees, dimension: 2 }
    }
}

/// The dimension of a regular simplex with so many corners: the rank of the Gram matrix of its edges at one corner.
fn dimension_of_regular_simplex(corners: usize) -> Result<usize, CheckError> {
    let edges = corners - 1;
    let rows: Vec<Vec<i64>> = (0..edges).map(|i| (0..edges).map(|j| 1 + i64::from(i == j)).collect()).collect();
    Ok(edges - RationalMatrix::from_integers(&rows, 2)?.kernel().len())
}

/// Whether both graphs are spanning trees with all pairs together, and no configuration makes all distances 1; or a configuration at
/// which the velocities agree.
pub(crate) fn no_common_configuration(variant: &Trees) -> Result<Outcome, CheckError> {
    let empty = Graph::empty(variant.agents);
    let graphs = variant.trees.each_ref().map(|edges| empty.with_edges(edges));
    let union = empty.with_edges(&variant.trees.concat());
    let needed = dimension_of_regular_simplex(variant.agents)?;
    let evidence = exact("common critical configurations", "the Gram matrix of the regular simplex");
    if graphs.iter().all(Graph::is_tree) && union == Graph::complete(variant.agents) && needed > variant.dimension {
        return holds(evidence);
    }
    let what = if union == graphs[0] {
        "the links do not change: velocities agree in the limit (tanner2.thm1a)".to_string()
    } else {
        format!(
            "{} agents can have all distances 1 in dimension {}: at rest there they stay, with equal velocities",
            variant.agents, variant.dimension
        )
    };
    Ok(Outcome::fails(what, evidence))
}

/// Whether velocities are said to agree under any signal, and the trees that are used in turn.
#[derive(Clone)]
pub struct SignalVariant {
    any_signal: bool,
    trees: Trees,
    /// Theorem 2 for switching by distance.
    by_distance: SwitchingVariant,
}

fn examine_signal(variant: &SignalVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let apart = no_common_configuration(&variant.trees)?;
    if !variant.any_signal {
        return Run::all([
            switching_checks(&variant.by_distance, run).on([1]),
            argued(&[1], "switching by distance", "notes/tanner2.md, Section 5, steps 1 to 7"),
            Ok(apart.on([2])),
        ]);
    }
    let Outcome::Holds(evidence) = apart else {
        return Ok(Outcome::Undecided("the graphs have a common critical configuration".to_string()));
    };
    let what = "four agents, V = s + 1/s - 2 with s the squared distance, links 1-2-3-4 and 2-4-1-3 in turn for equal times, from any start without collision: if the velocities agreed in the limit, all six distances would tend to 1, which no four points of the plane have";
    let paths = vec![vec![(0, 1), (1, 2), (2, 3)], vec![(1, 3), (0, 3), (0, 2)]];
    Ok(Outcome::failure(Counterexample::new(what, [Witness::networks(4, paths)]), evidence))
}

pub fn arbitrary() -> Record<SignalVariant> {
    Record::new(
        "tanner2.arbswitch",
        "Q is no Lyapunov function for a switch that does not happen at |r_ij| = R: there energy may jump up. Let four agents use the paths 1-2-3-4 and 2-4-1-3 in turn for the same fixed time each, both connected. If the velocities agreed in the limit, the \
         forces on every edge of the path in use would tend to zero in the mean, so its three distances to 1, at the switches too: there all six are near 1, which is impossible in the plane. So the velocities never agree, from any start. \
         What Section 5 analyses is switching by distance.",
        SignalVariant { any_signal: true, trees: Trees::two_paths(), by_distance: VELOCITIES },
        examine_signal,
    )
    .reading("arbitrary switching: by any signal among connected graphs")
    .repaired_by(Fault::False, "", |v| v.any_signal = false)
    .repaired_clauses(&[
        "With potentials of Definition 3 with a continuous gradient, no two agents in one place at the start and the graph of the links \
         |r_ij| < R connected at all times, every Filippov solution of (10), with K of the whole vector field, has velocities that agree in \
         the limit: so it is if links switch by distance.",
        "They do not for all switching signals among connected graphs: of four agents in the plane under (4) with V = s + 1/s - 2, s the \
         squared distance, and the links 1-2-3-4 and 2-4-1-3 in turn, each for the same fixed time T > 0, no motion that lasts for all time \
         has velocities that agree in the limit.",
    ])
    .altered("by distance, with K agent by agent", |v| v.by_distance.agentwise = true)
    .altered("step 6 of the proof: with lambda_2 > 1", |v| v.by_distance.connectivity = 1)
    .altered("the two paths in space", |v| v.trees = Trees { dimension: 3, ..Trees::two_paths() })
}

fn examine_stop((potential, square): &(Potential, Rational), _run: &mut Run) -> Result<Outcome, CheckError> {
    if potential.slope(square)? > rational(0, 1) {
        return Ok(Outcome::Undecided(
            "with a positive slope at R it is proved where no limit configuration has more than one pair at distance R (beyond.tanner2.thm2_stop); for several pairs at R at once there is neither a proof nor a counterexample. With slope zero at R it is false (beyond.tanner2.endless_switching)".to_string(),
        ));
    }
    if !crosses_for_ever(potential, square)? {
        return Ok(Outcome::Undecided("the slope at R is zero".to_string()));
    }
    let what = format!(
        "four agents near two equilateral triangles side by side, R² = {square}, V'(R²) = 0: symmetric motions tend to this rhombus in decaying oscillations on both sides, so agents 1 and 3 pass |r_13| = R for ever"
    );
    let detail = "characteristic polynomials of the symmetric modes with and without the link: stable, no real root (Sturm, Routh)";
    Ok(Outcome::fails(what, exact("switching near the rhombus", detail)))
}

pub fn stops() -> Record<(Potential, Rational)> {
    Record::new(
        "tanner2.thm2_stop",
        "That v does not change in steady state does not end switching by itself: with slope zero at R four agents near two equilateral triangles side by side \
         switch for ever on a graph that is connected at all times, although their velocities agree in the limit. With a positive slope the link pulls with a force that jumps at R, so that after or before a late crossing the relative speed would change at a rate bounded away from 0 for a fixed time; with \
         several pairs at R at once this argument has a gap (notes/tanner2.md).",
        (spring(), rational(4, 1)),
        examine_stop,
    )
    .reading("with a positive slope of V_ij at R, as Lemma 1 has it (c < 0 there) and Figure 3 shows it, and where no two agents coincide")
    .control("V increasing at R² = 3 with slope zero", (Potential::with_inflection(&rational(3, 1)), rational(3, 1)))
}
