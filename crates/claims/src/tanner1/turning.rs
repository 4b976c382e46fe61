//! tanner1.gyro, eq6, eq6b, eq7: what turns headings along the closed loop (1), (4), (5).

use super::closed_loop::at_upwards;
use crate::prelude::*;
use crate::tanner2::fixtures::{on_connected, total};
use algebra::graph::Graph;
use models::double_integrator::{AnyHeadings, Vector, cross, difference, dot, rotated, scaled};

const MOST: usize = 3;

/// The vector that the sum of heading differences multiplies.
#[derive(Clone, Copy)]
pub enum ForceVariant {
    /// `z x v_i`.
    TurnedVelocity,
    /// `z x r_i`.
    TurnedPosition,
    /// `v_i`.
    Velocity,
}

fn work_and_force(graph: Graph, variant: &ForceVariant) -> Identity<'_> {
    Identity::new(AnyHeadings::variables(&graph), move |at| {
        let whole = AnyHeadings::read(&graph, at)?;
        let state = &whole.flock.state;
        let along = |i: usize| match variant {
            ForceVariant::TurnedVelocity => rotated(&state.velocities[i]),
            ForceVariant::TurnedPosition => rotated(&state.positions[i]),
            ForceVariant::Velocity => state.velocities[i].clone(),
        };
        let sums = whole.laplacian()?;
        let forces: Vec<Vector<Probe>> = sums.iter().enumerate().map(|(i, x)| scaled(&-x.clone(), &along(i))).collect();
        let work: Vec<Probe> = forces.iter().zip(&state.velocities).map(|(a, v)| dot(a, v)).collect();
        let zeros = work.iter().map(|w| w.zero());
        // The library's law has the same force, and none of them does work.
        let right = zeros.chain(whole.alignment().into_iter().flatten()).collect();
        Ok((work.into_iter().chain(forces.into_iter().flatten()).collect(), right))
    })
}

/// Tests that the alignment force is the printed one and does no work.
pub(super) fn does_no_work(force: &ForceVariant, run: &Run) -> Result<Outcome, CheckError> {
    on_connected(run, MOST, "the alignment force does no work", |graph| work_and_force(graph, force))
}

pub fn gyro() -> Record<ForceVariant> {
    Record::new(
        "tanner1.gyro",
        "v_i . (z x v_i) = 0: the force is normal to the velocity and does no work, whatever the heading differences are.",
        ForceVariant::TurnedVelocity,
        |variant, run| does_no_work(variant, run).on([1, 2]),
    )
    .clauses(&[
        "a_theta_i = -sum_{j~i} (theta_i - theta_j)/||r_ij||^2 (zhat x v_i) is normal to v_i.",
        "a_theta_i does not contribute to the kinetic energy.",
    ])
    .control("along v_i", ForceVariant::Velocity)
    .control("z x r_i", ForceVariant::TurnedPosition)
}

/// The gradients of the potentials, turned or not, and the sign of the last sum.
#[derive(Clone, Copy)]
pub struct MomentumVariant {
    central: bool,
    sign: i64,
}

fn angular_momentum(graph: Graph, variant: &MomentumVariant) -> Identity<'_> {
    Identity::new(AnyHeadings::variables(&graph), move |at| {
        let whole = AnyHeadings::read(&graph, at)?;
        let state = &whole.flock.state;
        let push = |g: &Vector<Probe>| if variant.central { g.clone() } else { rotated(g) };
        let alignment = whole.alignment();
        let accelerations = alignment.iter().zip(&whole.gradients).map(|(a, g)| difference(a, &push(g)));
        let like = &at[0];
        let left = total(like, state.positions.iter().zip(accelerations).map(|(r, a)| cross(r, &a)));
        let turning = total(like, state.positions.iter().zip(&alignment).map(|(r, a)| cross(r, a)));
        // Both orders of every pair: r_ij x grad V_ij.
        let pairs = whole.flock.edges.iter().zip(whole.flock.pair_gradients()?);
        let both = |(&(i, j), (at_i, _)): (&(usize, usize), (Vector<Probe>, _))| {
            cross(&state.separation(i, j), &push(&at_i)) * like.integer(2)
        };
        let internal = total(like, pairs.map(both));
        // r x (z x v) = r . v.
        let own = state.positions.iter().zip(&state.velocities).zip(whole.laplacian()?);
        let last = total(like, own.map(|((r, v), sum)| dot(r, v) * sum));
        Ok((vec![left.clone(), left], vec![turning - internal, last * like.integer(-variant.sign)]))
    })
}

pub fn eq6() -> Record<MomentumVariant> {
    Record::new(
        "tanner1.eq6",
        "grad V_ij is along r_ij, so every r_ij x grad V_ij vanishes (in both orders, however often a pair is counted), and the potential forces of a pair have opposite torques. What is left is the torque of the alignment forces.",
        MomentumVariant { central: true, sign: 1 },
        |variant, run| on_connected(run, MOST, "equation (6)", |graph| angular_momentum(graph, variant)).on([1, 2, 3]),
    )
    .clauses(&[
        "sum_i r_i x vdot_i = sum_i r_i x a_theta_i - sum_i sum_{j~i} r_ij x grad V_ij.",
        "This is -sum_i r_i x (sum_{j~i} (theta_i - theta_j)/||r_ij||^2 (zhat x v_i)).",
        "The potential forces do not contribute to the angular momentum.",
    ])
    .altered("forces that are not central", |v| v.central = false)
    .altered("the other sign of the last sum", |v| v.sign = -1)
}

/// Headings turn by minus the weighted sum times `alignment`, plus the potentials' part times `potential`.
#[derive(Clone, Copy)]
pub struct HeadingVariant {
    potential: i64,
    alignment: i64,
}

/// The statement (7), or the one before it, weighted by `r_i . v_i` and summed.
fn turning(graph: Graph, variant: &HeadingVariant, weighted: bool) -> Identity<'_> {
    Identity::new(AnyHeadings::variables(&graph), move |at| {
        let whole = AnyHeadings::read(&graph, at)?;
        let (potential, alignment) = (at[0].integer(variant.potential), at[0].integer(variant.alignment));
        let left = whole.heading_rates()?;
        let terms = whole.laplacian()?.into_iter().zip(whole.potential_rates()?);
        let right: Vec<Probe> = terms.map(|(sum, own)| own * &potential - sum * &alignment).collect();
        if !weighted {
            return Ok((left, right));
        }
        let state = &whole.flock.state;
        let weight = |i: usize| dot(&state.positions[i], &state.velocities[i]);
        let sum = |list: Vec<Probe>| total(&at[0], list.into_iter().enumerate().map(|(i, x)| x * weight(i)));
        Ok((vec![sum(left)], vec![sum(right)]))
    })
}

fn examine_turning(variant: &HeadingVariant, weighted: bool, run: &Run) -> Result<Outcome, CheckError> {
    let what = if weighted { "the sum of (r_i . v_i) thetadot_i" } else { "thetadot_1" };
    if let Some(outcome) = at_upwards(&turning(Graph::path(2), variant, weighted), what, what)? {
        return Ok(outcome);
    }
    let steps = if weighted { "steps 1 to 4" } else { "steps 1 to 3" };
    // The rates of headings are those of step 1.
    let computed = if weighted { "steps 2 to 4" } else { "steps 2 and 3" };
    Run::all([
        on_connected(run, MOST, "the heading dynamics", |graph| turning(graph, variant, weighted)).checks(computed),
        argued(&[1], "the heading dynamics", &format!("notes/tanner1.md, Heading dynamics, {steps}")),
    ])
}

/// Tests (7) as printed.
pub(super) fn examine_printed(run: &Run) -> Result<Outcome, CheckError> {
    examine_turning(&PRINTED_HEADINGS, false, run)
}

const PRINTED_HEADINGS: HeadingVariant = HeadingVariant { potential: 0, alignment: 1 };
const TRUE_HEADINGS: HeadingVariant = HeadingVariant { potential: 1, alignment: 1 };

pub fn eq7() -> Record<HeadingVariant> {
    Record::new(
        "tanner1.eq7",
        "thetadot_i = (v_i x vdot_i)/|v_i|²: the alignment force gives the printed sum, but the potential force has a part normal to v_i too and turns the heading as well. The derivation drops it, and then concludes from one scalar equation \
         that each of N terms vanishes.",
        PRINTED_HEADINGS,
        |variant, run| examine_turning(variant, false, run),
    )
    .repaired(
        Fault::False,
        "Under (4), (5), where v_i != 0, no agent linked to i is in its place and theta_i does not jump: thetadot_i = - sum_{j~i} (theta_i - \
         theta_j)/|r_ij|² - (v_i x grad_{r_i} V_i)/|v_i|².",
        TRUE_HEADINGS,
    )
    .altered("the potentials' part with the other sign", |v| v.potential = -1)
    .altered("twice the alignment", |v| v.alignment = 2)
}

pub fn eq6b() -> Record<HeadingVariant> {
    Record::new(
        "tanner1.eq6b",
        "The step before it replaces vdot_i by omega_i x v_i, the part of vdot_i normal to v_i, but the potential forces have such a part too, and torque along v_i as well. With the true heading rates the sum is that of \
         -(r_i . v_i)(v_i x grad_{r_i} V_i)/|v_i|².",
        PRINTED_HEADINGS,
        |variant, run| examine_turning(variant, true, run),
    )
    .repaired(
        Fault::False,
        "Under (4), (5), where no agent is at rest, no linked agents are in one place and no heading jumps: sum_i (r_i . v_i)(thetadot_i + sum_{j~i} \
         (theta_i - theta_j)/|r_ij|² + (v_i x grad_{r_i} V_i)/|v_i|²) = 0.",
        TRUE_HEADINGS,
    )
    .altered("the potentials' part with the other sign", |v| v.potential = -1)
    .altered("twice the alignment", |v| v.alignment = 2)
}
