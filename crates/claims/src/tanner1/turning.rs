//! tanner1.gyro, eq6, eq6b, eq7: what turns headings along the closed loop (1), (4), (5).

use super::closed_loop::{Loop, at_upwards, cross, on_connected};
use crate::tanner2::arbitrary::{dot, total};
use algebra::graph::Graph;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Field, Rational};
use ledger::Record;
use ledger::{CheckError, Fault, Outcome, Run};
use models::double_integrator::{Vector, difference, rotated, scaled};

// --- The alignment force ---

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

struct Force(Graph, ForceVariant);

impl RationalIdentity for Force {
    fn variables(&self) -> usize {
        Loop::<Rational>::variables(&self.0)
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let whole = Loop::read(&self.0, at)?;
        let sums = whole.laplacian()?;
        let state = &whole.flock.state;
        let forces: Vec<Vector<T>> = (0..whole.count())
            .map(|i| match self.1 {
                ForceVariant::TurnedVelocity => scaled(&-sums[i].clone(), &rotated(&state.velocities[i])),
                ForceVariant::TurnedPosition => scaled(&-sums[i].clone(), &rotated(&state.positions[i])),
                ForceVariant::Velocity => scaled(&-sums[i].clone(), &state.velocities[i]),
            })
            .collect();
        let work: Vec<T> = forces.iter().zip(&state.velocities).map(|(a, v)| dot(a, v)).collect();
        let zeros = work.iter().map(|w| w.zero());
        // The library's law has the same force, and none of them does work.
        let law = whole.alignment().into_iter().flatten();
        let right = zeros.chain(law).collect();
        Ok((work.into_iter().chain(forces.into_iter().flatten()).collect(), right))
    }
}

pub fn gyro() -> Record<ForceVariant> {
    Record::new(
        "tanner1.gyro",
        "v_i . (z x v_i) = 0: the force is normal to the velocity and does no work, whatever the heading differences are.",
        ForceVariant::TurnedVelocity,
        |variant, run| on_connected(run, "the alignment force does no work", |graph| Force(graph, *variant)),
    )
    .control("along v_i", ForceVariant::Velocity)
    .control("z x r_i", ForceVariant::TurnedPosition)
}

// --- Equation (6) ---

/// The gradients of the potentials, turned or not, and the sign of the last sum.
#[derive(Clone, Copy)]
pub struct MomentumVariant {
    central: bool,
    sign: i64,
}

struct AngularMomentum(Graph, MomentumVariant);

impl RationalIdentity for AngularMomentum {
    fn variables(&self) -> usize {
        Loop::<Rational>::variables(&self.0)
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let whole = Loop::read(&self.0, at)?;
        let state = &whole.flock.state;
        let push = |g: &Vector<T>| if self.1.central { g.clone() } else { rotated(g) };
        let alignment = whole.alignment();
        let accelerations = alignment.iter().zip(&whole.gradients).map(|(a, g)| difference(a, &push(g)));
        let like = &at[0];
        let left = total(like, state.positions.iter().zip(accelerations).map(|(r, a)| cross(r, &a)));
        let turning = total(like, state.positions.iter().zip(&alignment).map(|(r, a)| cross(r, a)));
        // Both orders of every pair: r_ij x grad V_ij.
        let pairs = whole.flock.edges.iter().zip(whole.flock.pair_gradients()?);
        let internal = total(
            like,
            pairs.map(|(&(i, j), (at_i, _))| cross(&state.separation(i, j), &push(&at_i)) * like.integer(2)),
        );
        // r x (z x v) = r . v.
        let sums = whole.laplacian()?;
        let last = total(like, (0..whole.count()).map(|i| dot(&state.positions[i], &state.velocities[i]) * &sums[i]));
        Ok((vec![left.clone(), left], vec![turning - internal, last * like.integer(-self.1.sign)]))
    }
}

pub fn eq6() -> Record<MomentumVariant> {
    let printed = MomentumVariant { central: true, sign: 1 };
    Record::new(
        "tanner1.eq6",
        "grad V_ij is along r_ij, so every r_ij x grad V_ij vanishes (in both orders, however often a pair is counted), and the potential forces of a pair have opposite torques. What is left is the torque of the alignment forces.",
        printed,
        |variant, run| on_connected(run, "equation (6)", |graph| AngularMomentum(graph, *variant)),
    )
    .control("forces that are not central", MomentumVariant { central: false, ..printed })
    .control("the other sign", MomentumVariant { sign: -1, ..printed })
}

// --- The heading dynamics ---

/// Headings turn by minus the weighted sum times `alignment`, plus the potentials' part times `potential`.
#[derive(Clone, Copy)]
pub struct HeadingVariant {
    potential: i64,
    alignment: i64,
}

/// The statement before (7): weighted by `r_i . v_i` and summed.
struct Weighted(Graph, HeadingVariant);
/// The statement (7).
struct Separate(Graph, HeadingVariant);

/// The loop, its heading rates, and the rates that are claimed.
type HeadingSides<T> = (Loop<T>, Vec<T>, Vec<T>);

fn heading_sides<T: Field>(
    graph: &Graph,
    at: &[T],
    variant: HeadingVariant,
) -> Result<HeadingSides<T>, ArithmeticError> {
    let whole = Loop::read(graph, at)?;
    let left = whole.heading_rates()?;
    let own = whole.potential_rates()?;
    let right = whole
        .laplacian()?
        .into_iter()
        .zip(own)
        .map(|(sum, own)| own * at[0].integer(variant.potential) - sum * at[0].integer(variant.alignment));
    let right = right.collect();
    Ok((whole, left, right))
}

impl RationalIdentity for Separate {
    fn variables(&self) -> usize {
        Loop::<Rational>::variables(&self.0)
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let (_, left, right) = heading_sides(&self.0, at, self.1)?;
        Ok((left, right))
    }
}

impl RationalIdentity for Weighted {
    fn variables(&self) -> usize {
        Loop::<Rational>::variables(&self.0)
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let (whole, left, right) = heading_sides(&self.0, at, self.1)?;
        let state = &whole.flock.state;
        let weight = |i: usize| dot(&state.positions[i], &state.velocities[i]);
        let sum = |list: &[T]| total(&at[0], list.iter().enumerate().map(|(i, x)| x.clone() * weight(i)));
        Ok((vec![sum(&left)], vec![sum(&right)]))
    }
}

pub(super) fn examine_separate(variant: &HeadingVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let pair = Separate(Graph::path(2), *variant);
    if let Some(outcome) = at_upwards(&pair, "thetadot_1")? {
        return Ok(outcome);
    }
    on_connected(run, "the heading dynamics", |graph| Separate(graph, *variant))
}

fn examine_weighted(variant: &HeadingVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let pair = Weighted(Graph::path(2), *variant);
    if let Some(outcome) = at_upwards(&pair, "the sum of (r_i . v_i) thetadot_i")? {
        return Ok(outcome);
    }
    on_connected(run, "the weighted sum", |graph| Weighted(graph, *variant))
}

pub(super) const PRINTED_HEADINGS: HeadingVariant = HeadingVariant { potential: 0, alignment: 1 };
const TRUE_HEADINGS: HeadingVariant = HeadingVariant { potential: 1, alignment: 1 };

pub fn eq7() -> Record<HeadingVariant> {
    Record::new(
        "tanner1.eq7",
        "thetadot_i = (v_i x vdot_i)/|v_i|²: the alignment force gives the printed sum, but the potential force has a part normal to v_i too and turns the heading as well. The derivation drops it, and then concludes from one scalar equation \
         that each of N terms vanishes.",
        PRINTED_HEADINGS,
        examine_separate,
    )
    .repaired(
        Fault::False,
        "thetadot_i = - sum_{j~i} (theta_i - theta_j)/|r_ij|² - (v_i x grad_{r_i} V_i)/|v_i|², where v_i != 0.",
        TRUE_HEADINGS,
    )
    .control("the potentials' part with the other sign", HeadingVariant { potential: -1, ..TRUE_HEADINGS })
    .control("twice the alignment", HeadingVariant { alignment: 2, ..TRUE_HEADINGS })
}

pub fn eq6b() -> Record<HeadingVariant> {
    Record::new(
        "tanner1.eq6b",
        "The step before it replaces vdot_i by omega_i x v_i, the part of vdot_i normal to v_i, but the potential forces have such a part too, and torque along v_i as well. With the true heading rates the sum is that of \
         -(r_i . v_i)(v_i x grad_{r_i} V_i)/|v_i|².",
        PRINTED_HEADINGS,
        examine_weighted,
    )
    .repaired(
        Fault::False,
        "sum_i (r_i . v_i)(thetadot_i + sum_{j~i} (theta_i - theta_j)/|r_ij|² + (v_i x grad_{r_i} V_i)/|v_i|²) = 0.",
        TRUE_HEADINGS,
    )
    .control("the potentials' part with the other sign", HeadingVariant { potential: -1, ..TRUE_HEADINGS })
    .control("twice the alignment", HeadingVariant { alignment: 2, ..TRUE_HEADINGS })
}
