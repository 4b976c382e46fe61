//! tanner1.eq8, eq9.chain, eq9, Vt_inv, decoupled: rates of energies along the closed loop (1), (4), (5).

use super::closed_loop::{UPWARDS, at_upwards, moving_upwards, upwards};
use super::turning::{ForceVariant, does_no_work, examine_printed};
use crate::prelude::*;
use crate::tanner2::fixtures::{on_connected, total};
use algebra::graph::Graph;
use models::double_integrator::{AnyHeadings, AnyPotentials, Vector, dot, scaled};

const MOST: usize = 3;

/// `dV/dr_i = sign dV/dr_j` and `d/dt factor sum V_i = sum grad V_i . v_i`.
#[derive(Clone, Copy)]
pub struct SymmetryVariant {
    sign: i64,
    factor: (i64, i64),
}

fn symmetry(graph: Graph, variant: &SymmetryVariant) -> Identity<'_> {
    Identity::new(AnyPotentials::variables(&graph), move |at| {
        let flock = AnyPotentials::read(&graph, at)?;
        let (mut left, mut right) = (Vec::new(), Vec::new());
        for ((&(i, j), (at_i, at_j)), slope) in flock.edges.iter().zip(flock.pair_gradients()?).zip(&flock.slopes) {
            // dV/dr_ij of g |r_ij|².
            let own = scaled(&(slope.clone() + slope), &flock.state.separation(i, j));
            left.extend(own.into_iter().chain(at_i.clone()));
            right.extend(at_i.into_iter().chain(scaled(&at[0].integer(variant.sign), &at_j)));
        }
        left.push(total(&at[0], flock.agent_rates()?) * at[0].ratio(variant.factor.0, variant.factor.1));
        let gradients = flock.gradients()?;
        right.push(total(&at[0], gradients.iter().zip(&flock.state.velocities).map(|(g, v)| dot(g, v))));
        Ok((left, right))
    })
}

pub fn eq8() -> Record<SymmetryVariant> {
    Record::new(
        "tanner1.eq8",
        "V_ij depends on r_i - r_j. Half the sum of the V_i is the sum over the edges, whose rate is the sum of grad_{r_i} V_ij . v_i + grad_{r_j} V_ij . v_j.",
        SymmetryVariant { sign: -1, factor: (1, 2) },
        |variant, run| on_connected(run, MOST, "equation (8)", |graph| symmetry(graph, variant)).on([1, 2]),
    )
    .clauses(&["dV_ij/dr_ij = dV_ij/dr_i = -dV_ij/dr_j.", "d/dt sum_i (1/2) V_i = sum_i grad_{r_i} V_i . v_i."])
    .altered("dV/dr_i = dV/dr_j", |v| v.sign = 1)
    .altered("without the half", |v| v.factor = (1, 1))
}

/// What `Vdot_t` is said to be.
#[derive(Clone, Copy)]
pub enum RateVariant {
    /// The chain (9), the last term times a factor.
    Chain(i64),
    /// `form theta^T L_w theta` plus `potential` times the sum of `theta_i` times the potentials' part of its rate.
    Form { form: i64, potential: i64 },
}

fn energy_rate(graph: Graph, variant: &RateVariant) -> Identity<'_> {
    Identity::new(AnyHeadings::variables(&graph), move |at| {
        let whole = AnyHeadings::read(&graph, at)?;
        let like = &at[0];
        let rate = whole.rate_of((1, 2), (1, 2), (1, 2))?;
        let along = |list: Vec<Probe>| total(like, whole.headings.iter().zip(list).map(|(x, y)| x.clone() * y));
        Ok(match *variant {
            RateVariant::Chain(factor) => {
                let v = &whole.flock.state.velocities;
                let work = |list: &[Vector<Probe>]| total(like, v.iter().zip(list).map(|(v, a)| dot(v, a)));
                let turning = along(whole.heading_rates()?) * like.integer(factor);
                let chain = work(&whole.gradients) + work(&whole.accelerations) + turning.clone();
                (vec![rate.clone(), rate], vec![chain, turning])
            }
            RateVariant::Form { form, potential } => {
                let quadratic = along(whole.laplacian()?) * like.integer(form);
                (vec![rate], vec![along(whole.potential_rates()?) * like.integer(potential) + quadratic])
            }
        })
    })
}

pub fn eq9_chain() -> Record<i64> {
    Record::new(
        "tanner1.eq9.chain",
        "The alignment force does no work and the potential forces take from the potential what they give to the speeds: half the sum of V_i + |v_i|² is constant, and the rate of V_t is that of half the sum of theta_i².",
        1,
        |factor, run| {
            let chain = RateVariant::Chain(*factor);
            let identity = on_connected(run, MOST, "the rate of V_t", |graph| energy_rate(graph, &chain));
            let steps = "notes/tanner1.md, Energy, steps 1 and 2";
            Run::all([identity.checks("steps 1 and 2").on([1, 2]), argued(&[1], "the product rule, and (8)", steps)])
        },
    )
    .clauses(&[
        "Vdot_t = sum_i grad_{r_i} V_i . v_i + sum_i v_i^T a_i + sum_i theta_i thetadot_i.",
        "Vdot_t = sum_i theta_i thetadot_i.",
    ])
    .reading("away from jumps of the headings (theta_i² does not jump at pi) and of agents at rest")
    .control("twice the last sum", 2)
    .control("without the last sum", 0)
}

fn examine_rate(variant: &RateVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const PART: &str = "a positive rate";
    let pair = energy_rate(Graph::path(2), variant);
    let rate = AnyHeadings::read(&Graph::path(2), &upwards())?.rate_of((1, 2), (1, 2), (1, 2))?;
    let positive = match at_upwards(&pair, PART, "dV_t/dt in units of pi/2 (positive)")? {
        Some(other) => Ok(other),
        None => run.every(exact(PART, format!("{UPWARDS}: {rate} pi/2")).on([2]).for_all(), [rate], |rate| {
            Ok((rate <= rational(0, 1)).then(|| format!("{UPWARDS}: the rate is {rate} pi/2")))
        }),
    };
    Run::all([
        positive,
        on_connected(run, MOST, "the rate of V_t", |graph| energy_rate(graph, variant)).checks("step 3").on([1]),
        argued(&[1], "the rate of V_t", "notes/tanner1.md, Energy, steps 1 to 3"),
    ])
}

pub fn eq9() -> Record<RateVariant> {
    Record::new(
        "tanner1.eq9",
        "It puts (7), which is false, into (9). With the true heading rates the potentials add sum theta_i (-(v_i x grad_{r_i} V_i)/|v_i|²), of either sign: two agents with equal headings pi/2 and different speeds have theta^T L_w theta = 0 and a positive rate.",
        RateVariant::Form { form: -1, potential: 0 },
        examine_rate,
    )
    .repaired(Fault::False, "", RateVariant::Form { form: -1, potential: 1 })
    .repaired_clauses(&[
        "Under (4), (5), while no agent is at rest, no linked agents are in one place and no heading jumps, Vdot_t = - theta^T L_w theta - sum_i theta_i \
         (v_i x grad_{r_i} V_i)/|v_i|².",
        "Under the same law Vdot_t > 0 for two linked agents at (0, 0) and (1, 1) with velocities (0, 2) and (0, 1) and V = 1/s + log s, s the squared distance.",
    ])
    .control("the potentials' part with the other sign", RateVariant::Form { form: -1, potential: -1 })
    .control("plus theta^T L_w theta", RateVariant::Form { form: 1, potential: 1 })
}

/// `potentials sum V_i + kinetic sum |v_i|²` is constant.
#[derive(Clone, Copy)]
pub struct InvariantVariant {
    potentials: (i64, i64),
    kinetic: (i64, i64),
    /// Half the sum of `theta_i²` is part of it.
    headings: bool,
}

fn rate_of_constant(graph: Graph, variant: &InvariantVariant) -> Identity<'_> {
    Identity::new(AnyHeadings::variables(&graph), move |at| {
        let whole = AnyHeadings::read(&graph, at)?;
        Ok((vec![whole.rate_of(variant.potentials, variant.kinetic, (0, 1))?], vec![at[0].zero()]))
    })
}

/// Half the sum of `V_i + |v_i|²`.
const ENERGY: InvariantVariant = InvariantVariant { potentials: (1, 2), kinetic: (1, 2), headings: false };

/// Tests that the mechanical energy is constant.
pub(super) fn energy_is_constant(run: &Run) -> Result<Outcome, CheckError> {
    is_constant(&ENERGY, run)
}

fn is_constant(variant: &InvariantVariant, run: &Run) -> Result<Outcome, CheckError> {
    on_connected(run, MOST, "a constant of the closed loop", |graph| rate_of_constant(graph, variant))
}

fn examine_invariant(variant: &InvariantVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    if variant.headings {
        let rate = AnyHeadings::read(&Graph::path(2), &upwards())?.rate_of((1, 2), (1, 2), (1, 2))?;
        let evidence = exact("V_t at one state", "exact rate, in units of pi/2").on([1, 2]);
        return run.every(evidence, [rate], |rate: Rational| {
            let what =
                format!("{UPWARDS}: dV_t/dt = {rate} pi/2 > 0, so that {{V_t <= c}} is left for the c of this state");
            Ok((rate > rational(0, 1)).then(|| Counterexample::new(what, [moving_upwards()])))
        });
    }
    let steps = "a constant leaves its sublevel sets invariant; notes/tanner1.md, Energy, steps 1 and 2";
    Run::all([is_constant(variant, run).checks("step 2").on([1, 2]), argued(&[2], "sublevel sets", steps)])
}

pub fn vt_inv() -> Record<InvariantVariant> {
    Record::new(
        "tanner1.Vt_inv",
        "V_t is a constant, the mechanical energy, plus half the sum of theta_i², and potential forces may turn headings away from 0. Two agents with heading pi/2 and different speeds can increase V_t. What is invariant is every level set of the mechanical energy.",
        InvariantVariant { headings: true, ..ENERGY },
        examine_invariant,
    )
    .clauses(&["V_t is nonincreasing along the closed loop.", "Omega = {V_t <= c} is positively invariant."])
    .repaired(Fault::False, "", ENERGY)
    .repaired_clauses(&[
        "The mechanical energy (1/2) sum_i (V_i + v_i^T v_i) is constant along (1), (4), (5), as long as the motion lasts.",
        "{(1/2) sum_i (V_i + v_i^T v_i) <= c} is invariant, in the same sense.",
    ])
    .altered("the kinetic energy alone is constant", |v| v.potentials = (0, 1))
    .altered("sum V_i + half the sum of |v_i|²", |v| v.potentials = (1, 1))
}

/// The alignment force of the law, and whether potentials are said not to turn headings.
#[derive(Clone, Copy)]
pub struct DecoupledVariant {
    alignment: ForceVariant,
    headings: bool,
}

fn examine_decoupled(variant: &DecoupledVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let work = does_no_work(&variant.alignment, run)?.on([1]);
    let turning = match examine_printed(run)? {
        Outcome::Fails { counterexample, evidence, .. } => {
            let part = format!("the potential forces turn headings: {counterexample}");
            let turned = evidence.into_iter().map(|e| Evidence { part: part.clone(), ..e.on([1]) }).collect();
            Outcome::failure(counterexample, turned)
        }
        other => other,
    };
    match (work, turning) {
        (Outcome::Holds(mut evidence), Outcome::Fails { evidence: turned, .. }) if !variant.headings => {
            evidence.extend(turned);
            let why = "\"can be decoupled\" has no meaning that the paper fixes: (3) adds a term for each rule, and alignment does no work on the energy of cohesion and separation, but the potential forces turn headings";
            Ok(Outcome::NotCheckable(why.to_string(), evidence))
        }
        (Outcome::Holds(_), turning) => Ok(turning),
        (work, _) => Ok(work),
    }
}

pub fn decoupled() -> Record<DecoupledVariant> {
    Record::new(
        "tanner1.decoupled",
        "An aside of the introduction. What can be checked of it: the alignment force does no work, so that it does not change the mechanical energy; the potential forces do change the headings (tanner1.eq7).",
        DecoupledVariant { alignment: ForceVariant::TurnedVelocity, headings: false },
        examine_decoupled,
    )
    .altered("with an alignment force along v_i", |v| v.alignment = ForceVariant::Velocity)
    .altered("the potentials do not turn headings", |v| v.headings = true)
}
