//! tanner2.eq6, eq8, eq9, cor2_decomp, S_config, eq14, vdotB: the energy and its rate of change on a fixed graph.

use super::fixtures::{PLANE, energy_decreases, on_connected, quadratic, spring, total};
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use arithmetic::{Signed, gradient};
use models::double_integrator::{
    AnyPotentials, Potential, State, SteadyMotion, difference, disagreements, dot, kinetic_energy, potential_energy,
    scaled, sum, velocity_alignment,
};

fn most(run: &Run) -> usize {
    run.cases(3, 4)
}

/// `Wdot = factor v^T (M kron I_2) v = factor (v_x^T M v_x + v_y^T M v_y)`.
#[derive(Clone, Copy)]
pub struct RateVariant {
    factor: i64,
    /// `D + A` in place of `D - A`.
    signless: bool,
    /// All x components first in the stack vector, but the same matrix `M kron I_2`.
    by_axis: bool,
}

/// `D - A`, or `D + A`.
fn laplacian(graph: &Graph, signless: bool) -> Result<RationalMatrix, ArithmeticError> {
    let square = |_| ArithmeticError::Domain("a graph with vertices");
    let laplacian = graph.laplacian().map_err(square)?;
    if !signless {
        return Ok(laplacian);
    }
    let rows: Vec<Vec<Rational>> =
        laplacian.to_rows().into_iter().map(|row| row.iter().map(num_traits::Signed::abs).collect()).collect();
    RationalMatrix::from_rows(&rows).map_err(square)
}

fn energy_rate(graph: Graph, variant: &RateVariant) -> Identity<'_> {
    Identity::new(AnyPotentials::variables(&graph), move |at| {
        let flock = AnyPotentials::read(&graph, at)?;
        let matrix = laplacian(&graph, variant.signless)?;
        let plane =
            RationalMatrix::identity(2).map_err(|_| ArithmeticError::Domain("a matrix with at least one row"))?;
        let stack: Vec<Probe> = if variant.by_axis {
            [flock.axis(0), flock.axis(1)].concat()
        } else {
            flock.state.velocities.iter().flatten().cloned().collect()
        };
        let factor = at[0].integer(variant.factor);
        let stacked = quadratic(&matrix.kronecker(&plane), &stack) * &factor;
        let axes = (quadratic(&matrix, &flock.axis(0)) + quadratic(&matrix, &flock.axis(1))) * factor;
        let rate = flock.energy_rate()?;
        Ok((vec![rate.clone(), rate], vec![stacked, axes]))
    })
    .named(["dW/dt, stacked", "dW/dt, by axes"])
}

pub fn eq9() -> Record<RateVariant> {
    Record::new(
        "tanner2.eq9",
        "dW/dt = sum v_i . (grad V_i + u_i) = -sum over i of v_i . sum over j ~ i of (v_i - v_j), which is minus the sum over the edges of \
         |v_i - v_j|². With the stack vector (v_1, v_2, ...) the matrix L kron I_2 gives the same sum. Any graph, any potentials. \
         (The text calls the velocities three dimensional; the agents move in the plane, and I_2 in the formula is right. In three dimensions it would be I_3, with a third form in v_z.)",
        RateVariant { factor: -1, signless: false, by_axis: false },
        |variant, run| on_connected(run, most(run), "equation (9)", |graph| energy_rate(graph, variant)).on([1, 2]),
    )
    .clauses(&["Wdot = -v^T (L kron I_2) v.", "Wdot = -v_x^T L v_x - v_y^T L v_y."])
    .altered("twice", |v| v.factor = -2)
    .altered("D + A in place of L", |v| v.signless = true)
    .altered("L kron I_2 with all x components first", |v| v.by_axis = true)
}

/// The chain of equations, with a factor before the first sum, the number of times an edge is counted, and the sign of the second term.
#[derive(Clone, Copy)]
pub struct ChainVariant {
    half: (i64, i64),
    counted: i64,
    sign: i64,
}

fn chain(graph: Graph, variant: &ChainVariant) -> Identity<'_> {
    Identity::new(AnyPotentials::variables(&graph), move |at| {
        let flock = AnyPotentials::read(&graph, at)?;
        let (like, v) = (&at[0], &flock.state.velocities);
        let half = total(like, flock.agent_rates()?) * like.ratio(variant.half.0, variant.half.1);
        let gradients = flock.gradients()?;
        let damping = disagreements(v, &flock.edges);
        let work = total(like, (0..v.len()).map(|i| dot(&v[i], &sum(&damping[i], &gradients[i]))));
        let counted = like.integer(variant.counted);
        let pairs = flock.pair_gradients()?;
        let relative = flock.edges.iter().zip(&pairs).map(|(&(i, j), (at_i, _))| dot(&difference(&v[i], &v[j]), at_i));
        let relative = total(like, relative) * &counted;
        let both = flock
            .edges
            .iter()
            .zip(&pairs)
            .map(|(&(i, j), (at_i, at_j))| dot(&v[i], at_i) + dot(&v[j], at_j) * like.integer(variant.sign));
        let both = total(like, both) * counted;
        let single = total(like, (0..v.len()).map(|i| dot(&v[i], &gradients[i])));
        Ok((
            vec![flock.energy_rate()?, half.clone(), half.clone(), half.clone()],
            vec![half - work, relative, both, single],
        ))
    })
    .named(["dW/dt", "the sum of rdot_ij . grad V_ij", "the sum over i and j", "the sum of rdot_i . grad V_i"])
}

pub fn eq8() -> Record<ChainVariant> {
    Record::new(
        "tanner2.eq8",
        "Each V_ij occurs in V_i and in V_j, so half the sum of the V_i is the sum over the edges, each once. V_ij depends on r_i - r_j, so grad_{r_j} = -grad_{r_i} = -grad_{r_ij}. Any graph, any potentials.",
        ChainVariant { half: (1, 2), counted: 1, sign: 1 },
        |variant, run| Run::all([
            on_connected(run, most(run), "equation (8)", |graph| chain(graph, variant)).checks("steps 1 and 2").on([1, 2, 3, 4]),
            argued(&[1, 2, 3, 4], "the chain of equations", "notes/tanner2.md, Identities, steps 1 and 2"),
        ]),
    )
    .clauses(&[
        "Wdot = (1/2) sum_i Vdot_i - sum_i v_i^T (sum_{j~i} (v_i - v_j) + grad_{r_i} V_i).",
        "(1/2) sum_i Vdot_i = sum_{j~i} rdot_ij^T grad_{r_ij} V_ij.",
        "This is sum_{j~i} (rdot_i^T grad_{r_i} V_ij + rdot_j^T grad_{r_j} V_ij).",
        "This is sum_i rdot_i^T grad_{r_i} V_i.",
    ])
    .reading("sums over j ~ i without i take every edge once")
    .altered("without the half", |v| v.half = (1, 1))
    .altered("each edge twice", |v| v.counted = 2)
    .altered("minus grad_{r_j}", |v| v.sign = -1)
}

/// `W = factor sum V_i + 1/2 sum |v_i|²` with potentials whose least value is `least`.
#[derive(Clone, Copy)]
pub struct MechanicalVariant {
    factor: (i64, i64),
    least: i64,
}

fn gradient_of_energy(graph: Graph, variant: &MechanicalVariant) -> Identity<'_> {
    Identity::new(AnyPotentials::variables(&graph), move |at| {
        let flock = AnyPotentials::read(&graph, at)?;
        let count = graph.order();
        let derivatives = gradient(&at[..4 * count], |list: &[Dual<Probe>]| {
            let state = State::from_list(count, list).ok_or(ArithmeticError::Domain("four numbers for each agent"))?;
            flock.energy(&state, variant.factor)
        })?;
        // grad_{r_i} W against minus the force, grad_{v_i} W against the momentum.
        let forces = flock.gradients()?.into_iter().flatten();
        Ok((derivatives, forces.chain(flock.state.velocities.iter().flatten().cloned()).collect()))
    })
}

/// The least value of `W` is that at rest at the minimum of every potential, for two agents.
fn non_negative(variant: &MechanicalVariant) -> Result<Outcome, CheckError> {
    let (one, least) = (rational(1, 1), rational(variant.least, 1));
    let potential = Potential::new(vec![(0, one.clone()), (-2, -one.clone())], (one.clone(), least));
    let zero = [rational(0, 1), rational(0, 1)];
    let positions = [zero.clone(), [one.clone(), rational(0, 1)]];
    let value = |_: usize, _: usize, s: &Rational| potential.rational_value(s);
    let edges = potential_energy(&positions, &[(0, 1)], PLANE, value)?;
    let energy =
        edges * rational(2 * variant.factor.0, variant.factor.1) + kinetic_energy(&[zero.clone(), zero], PLANE)?;
    let what = || format!("two agents at rest at the desired distance: W = {energy}");
    let evidence = exact("W >= 0", "its least value for two agents and s + 1/s - 2");
    unless(energy.is_certainly_negative().then(what), evidence)
}

pub fn eq6() -> Record<MechanicalVariant> {
    Record::new(
        "tanner2.eq6",
        "V_ij >= 0 by Definition 3, so W is a sum of non-negative terms, differentiable where no linked agents coincide. Half the sum of \
         the V_i counts each edge once, so -grad_{r_i} W = -grad_{r_i} V_i is the force of (4): W is potential plus kinetic energy (unit masses).",
        MechanicalVariant { factor: (1, 2), least: 0 },
        |variant, run| {
            Run::all([
                on_connected(run, most(run), "the forces are -grad W", |graph| gradient_of_energy(graph, variant)).checks("step 5").on([2]),
                non_negative(variant).checks("step 1").on([1]),
                argued(&[1, 2], "energy and forces", "notes/tanner2.md, Identities, steps 1 and 5"),
            ])
        },
    )
    .clauses(&["W is nonnegative.", "W is the (differentiable) mechanical energy of the group."])
    .altered("without the half before V_i", |v| v.factor = (1, 1))
    .altered("a potential that is negative at its minimum", |v| v.least = -1)
}

/// `Wdot = -(x_p or x_n part) - (the same of y)`, where p is the mean, n the rest.
#[derive(Clone, Copy)]
pub struct PartVariant {
    mean: bool,
    power: usize,
}

fn part_of_rate(graph: Graph, variant: &PartVariant) -> Identity<'_> {
    Identity::new(AnyPotentials::variables(&graph), move |at| {
        let flock = AnyPotentials::read(&graph, at)?;
        let mut matrix = laplacian(&graph, false)?;
        if variant.power == 2 {
            matrix = matrix.times(&matrix).map_err(|_| ArithmeticError::Domain("a square matrix"))?;
        }
        let form = (0..2).map(|k| {
            let v = flock.axis(k);
            let mean = total(&at[0], v.iter().cloned()) * at[0].ratio(1, v.len() as i64);
            let part: Vec<Probe> =
                v.iter().map(|x| if variant.mean { mean.clone() } else { x.clone() - &mean }).collect();
            -quadratic(&matrix, &part)
        });
        Ok((vec![flock.energy_rate()?], vec![total(&at[0], form)]))
    })
}

pub fn cor2_decomp() -> Record<PartVariant> {
    Record::new(
        "tanner2.cor2_decomp",
        "L 1 = 0 and L is symmetric, so the part of v_x along 1 drops out of v_x^T L v_x; the same for v_y.",
        PartVariant { mean: false, power: 1 },
        |variant, run| {
            Run::all([
                on_connected(run, most(run), "Wdot by the parts normal to 1", |graph| part_of_rate(graph, variant))
                    .checks("step 6"),
                argued(&[1], "Wdot by the parts normal to 1", "notes/tanner2.md, Identities, step 6"),
            ])
        },
    )
    .altered("the parts along 1", |v| v.mean = true)
    .altered("L² in place of L", |v| v.power = 2)
}

/// What is said to vanish where `Wdot = 0`.
#[derive(Clone, Copy)]
pub enum Vanishing {
    /// `r_ij`.
    Separations,
    /// `rdot_ij`.
    RelativeVelocities,
    /// `v_i`.
    Velocities,
    /// `vdot_i`.
    Accelerations,
}

/// Two agents with a common velocity, half a unit further apart than they should be.
fn drifting_pair() -> State<Rational> {
    let q = |p, d| rational(p, d);
    State {
        positions: vec![[q(0, 1), q(0, 1)], [q(3, 2), q(0, 1)]],
        velocities: vec![[q(1, 1), q(0, 1)], [q(1, 1), q(0, 1)]],
    }
}

fn examine_vanishing(variant: &Vanishing, run: &mut Run) -> Result<Outcome, CheckError> {
    let state = drifting_pair();
    let potential = spring();
    let accelerations = velocity_alignment(&state, &[(0, 1)], PLANE, |_, _, s| potential.slope(s))?;
    let moving = state.moving(&accelerations);
    let value = |_: usize, _: usize, s: &Dual<Rational>| potential.rational_value(s);
    let energy =
        potential_energy(&moving.positions, &[(0, 1)], PLANE, value)? + kinetic_energy(&moving.velocities, PLANE)?;
    let is_zero = |v: &[Rational; 2]| v.iter().all(num_traits::Zero::is_zero);
    let (name, vanishes) = match variant {
        Vanishing::Separations => ("r_12", is_zero(&state.separation(0, 1))),
        Vanishing::RelativeVelocities => ("rdot_12", is_zero(&state.relative_velocity(0, 1))),
        Vanishing::Velocities => ("v_1", is_zero(&state.velocities[0])),
        Vanishing::Accelerations => ("vdot_1", is_zero(&accelerations[0])),
    };
    let rate = &energy.derivative;
    let what = || {
        let text = format!(
            "two linked agents at (0, 0) and (3/2, 0), both with velocity (1, 0): dW/dt = {rate}, {name} is not 0"
        );
        Counterexample::new(text, [Witness::agents(&state.positions, &state.velocities, &[(0, 1)])])
    };
    let wrong = !num_traits::Zero::is_zero(rate) || !vanishes;
    Run::all([
        unless(wrong.then(what), exact("two agents with a common velocity", "exact rates of change"))
            .checks("the conclusion"),
        energy_decreases(run, 1).checks("step 3"),
        argued(&[1], "all of them", "notes/tanner2.md, Identities, step 7"),
    ])
}

pub fn s_config() -> Record<Vanishing> {
    Record::new(
        "tanner2.S_config",
        "dW/dt is minus the sum of |v_i - v_j|² over the edges: it vanishes exactly where linked agents, and on a connected graph all \
         agents, have equal velocities. Then rdot_ij = v_i - v_j = 0; r_ij = 0 would be a collision. A dot is missing in print.",
        Vanishing::Separations,
        examine_vanishing,
    )
    .repaired(
        Fault::Typo,
        "Under (4) on a connected graph, at a state with Wdot = 0, rdot_ij = v_i - v_j = 0 for all (i, j).",
        Vanishing::RelativeVelocities,
    )
    .control("v_i = 0", Vanishing::Velocities)
    .control("vdot_i = 0", Vanishing::Accelerations)
}

/// In the invariant set the accelerations lie along 1 and are normal to 1.
#[derive(Clone, Copy)]
pub struct SteadyVariant {
    /// `V_ij` and `V_ji` are the same potential.
    mutual: bool,
    /// Velocities stay equal, not only at one instant.
    invariant: bool,
    /// Accelerations are equal too, for the conclusion that they are zero.
    equal: bool,
}

/// The sum of all accelerations is zero; the slope at the second agent of each edge is a variable of its own where forces are not mutual.
fn sum_of_accelerations(graph: Graph, mutual: bool) -> Identity<'static> {
    Identity::new(AnyPotentials::variables(&graph) + if mutual { 0 } else { graph.edges().len() }, move |at| {
        let flock = AnyPotentials::read(&graph, at)?;
        let mut accelerations = flock.accelerations()?;
        if !mutual {
            let own = &at[AnyPotentials::variables(&graph)..];
            for ((&(i, j), mutual), other) in flock.edges.iter().zip(&flock.slopes).zip(own) {
                let extra = scaled(&((other.clone() - mutual) * at[0].integer(2)), &flock.state.separation(i, j));
                accelerations[j] = sum(&accelerations[j], &extra);
            }
        }
        let sums = [0, 1].map(|k| total(&at[0], accelerations.iter().map(|a| a[k].clone())));
        Ok((sums.to_vec(), vec![at[0].zero(), at[0].zero()]))
    })
}

fn examine_steady(variant: &SteadyVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let momentum = on_connected(run, most(run), "the accelerations sum to zero", |graph| {
        sum_of_accelerations(graph, variant.mutual)
    });
    let momentum = momentum.on([1]);
    let steps = "notes/tanner2.md, Identities, step 4";
    Run::all([
        momentum.checks("step 4"),
        equal_velocities(variant, run).checks("the conclusion").on([2, 3]),
        only_zero(variant, run).checks("step 4").on([3]),
        argued(&[1, 2, 3], "accelerations in the invariant set", steps),
    ])
}

/// The accelerations of states with equal velocities: of those that have equal velocities just after too, or of all.
fn equal_velocities(variant: &SteadyVariant, run: &Run) -> Result<Outcome, CheckError> {
    let name = "two linked agents at distance 3/2 with a common velocity, V = s + 1/s - 2";
    let drifting = SteadyMotion { state: drifting_pair(), name, ..SteadyMotion::pair() };
    let meant = SteadyMotion::all_known().into_iter().chain([drifting]).filter(SteadyMotion::agrees);
    let mut cases = Vec::new();
    for motion in meant {
        let slope = |_: usize, _: usize, s: &Rational| motion.potential.slope(s);
        let accelerations = velocity_alignment(&motion.state, &motion.graph.edges(), motion.coordinates, slope)?;
        // How the velocities relative to agent 1 change.
        let moving = motion.state.moving(&accelerations);
        let rates = (0..accelerations.len()).flat_map(|i| moving.relative_velocity(i, 0).map(|x| x.derivative));
        let stays = rates.into_iter().all(|x| num_traits::Zero::is_zero(&x));
        if stays || !variant.invariant {
            cases.push((motion.name, accelerations));
        }
    }
    let detail =
        "exact accelerations of equilibria of two and three agents with a common velocity, in which it stays common";
    run.instances("accelerations where velocities stay equal", detail, cases, |(name, accelerations)| {
        let moves = accelerations.iter().find(|a| a.iter().any(|x| !num_traits::Zero::is_zero(x)));
        Ok(moves.map(|[x, y]| format!("{name}: an agent has the acceleration ({x}, {y})")))
    })
}

/// What lies in the complement of 1 and, if so said, in the span of 1 too: only zero, by the kernel of these conditions.
fn only_zero(variant: &SteadyVariant, run: &Run) -> Result<Outcome, CheckError> {
    let detail = "the conditions \"sum zero\" and \"equal\" have the kernel 0, N = 1 to 8";
    run.instances("span{1} and its complement", detail, 1..=8_usize, |count| {
        let mut rows = vec![vec![rational(1, 1); count]];
        if variant.equal {
            rows.extend((1..count).map(|i| {
                (0..count).map(|j| rational(i64::from(j == i) - i64::from(j == 0), 1)).collect::<Vec<Rational>>()
            }));
        }
        let kernel = RationalMatrix::from_rows(&rows)?.kernel();
        Ok(kernel.first().map(|x| format!("{count} agents: ({}) is normal to 1 and not zero", list(x))))
    })
}

pub fn eq14() -> Record<SteadyVariant> {
    Record::new(
        "tanner2.eq14",
        "All forces are mutual, so the accelerations sum to zero in every state (they are normal to 1), and so does every convex \
         combination of them over graphs. In an invariant set of equal velocities all accelerations are equal. Equal vectors that sum to zero are zero.",
        SteadyVariant { mutual: true, invariant: true, equal: true },
        examine_steady,
    )
    .clauses(&[
        "vdot_x and vdot_y belong to span{1}^perp.",
        "In the invariant set vdot_x and vdot_y belong to span{1}.",
        "Hence vdot_x, vdot_y = 0: the agent velocities do not change in steady state.",
    ])
    .altered("forces that are not mutual", |v| v.mutual = false)
    .altered("equal velocities at one instant only", |v| v.invariant = false)
    .altered("from vdot_x, vdot_y in span{1}^perp alone", |v| v.equal = false)
}

/// `vdot = factor (B kron I_2) [grad_{r_ij} V_ij]`; in `B` the entry of the vertex an edge leaves is -1, that of the one it enters `incoming`.
#[derive(Clone, Copy)]
pub struct IncidenceVariant {
    factor: i64,
    incoming: i64,
}

fn by_incidence(graph: Graph, variant: &IncidenceVariant) -> Identity<'_> {
    Identity::new(AnyPotentials::variables(&graph), move |at| {
        let flock = AnyPotentials::read(&graph, at)?;
        // In S the velocities are equal: the accelerations are minus the gradients.
        let left = flock.gradients()?.into_iter().flatten().map(|x| -x).collect();
        let mut right: Vec<[Probe; 2]> = vec![[at[0].zero(), at[0].zero()]; graph.order()];
        for (&(i, j), (gradient, _)) in flock.edges.iter().zip(&flock.pair_gradients()?) {
            // The arc from i to j.
            let entry = |weight: i64| scaled(&at[0].integer(variant.factor * weight), gradient);
            right[i] = sum(&right[i], &entry(-1));
            right[j] = sum(&right[j], &entry(variant.incoming));
        }
        Ok((left, right.into_iter().flatten().collect()))
    })
}

pub fn vdot_b() -> Record<IncidenceVariant> {
    let printed = IncidenceVariant { factor: -1, incoming: 1 };
    Record::new(
        "tanner2.vdotB",
        "The edge (i, j) is an arc from i to j, so in its column of B the entry of i is -1 and that of j is 1 (Section 2.1). As grad_{r_ij} V_ij = grad_{r_i} V_ij, \
         row i of (B kron I_2)[grad_{r_ij} V_ij] is -grad_{r_i} V_i: the minus sign before B is one too many. The range of B, which is all the \
         proof uses, does not depend on the sign.",
        printed,
        |variant, run| Run::all([
            on_connected(run, most(run), "vdot in S by the incidence matrix", |graph| by_incidence(graph, variant)).checks("step 8"),
            argued(&[1], "vdot in S by the incidence matrix", "notes/tanner2.md, Identities, step 8"),
        ]),
    )
    .repaired(
        Fault::Slip,
        "Under (4), where all velocities are equal, vdot = (B kron I_2) [..., grad_{r_ij} V_ij, ...]^T with B as in Section 2.1 (or the \
         minus sign with 1 for outgoing edges).",
        IncidenceVariant { factor: 1, ..printed },
    )
    .control("-1 for incoming edges too", IncidenceVariant { factor: 1, incoming: -1 })
    .control("twice", IncidenceVariant { factor: 2, ..printed })
}
