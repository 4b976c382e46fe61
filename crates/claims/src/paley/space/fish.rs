//! paley.eq26, paley.vrep, paley.vatt: the steps of the fish model and its behaviours.

use super::instances::{StateIdentity, state_identity};
use crate::prelude::*;
use models::oscillator::{phasor, quarter_turn, repulsion, steering_towards};

/// Positions move by `T^position e^{i theta}` and phases by `T^phase u`.
#[derive(Clone, Copy)]
pub struct StepVariant {
    position: u64,
    phase: u64,
}

/// The increments of a step against those of Euler's method for (1), (2).
fn euler_increments(variant: &StepVariant) -> StateIdentity<'_> {
    StateIdentity::of(1, move |[fineness, u], state| {
        // A counterexample is looked for at small integers, and T is to be small.
        let step = &(fineness.recip()? * fineness.ratio(1, 10));
        let z = &state.phasors[0];
        let moved = z.scale(&step.power(variant.position));
        let euler = z.scale(step);
        let turned = step.power(variant.phase) * u;
        Ok((vec![moved.re, moved.im, turned], vec![euler.re, euler.im, step.clone() * u]))
    })
    .allowing(|constants| constants[0] > rational(0, 1))
}

pub fn euler_step() -> Record<StepVariant> {
    Record::new(
        "paley.eq26",
        "The forward Euler method of step h for (1), (2) is r + h e^{i theta}, theta + h u: one step for \
         both equations. (26) moves positions with the step 1 and phases with the step T << 1, which is \
         Euler's method for no h (h = 1 from the first line, h = T from the second). It is so for the first \
         line r + T e^{i theta}; or for a model of speed 1/T, not the unit speed of (1). As (2) allows any \
         control, (26) is also Euler's method with h = 1 for (1), (2) under the control T u_k (with T = 1 \
         and all gains times T it is the printed model); but the article goes on to compare the gains of \
         u_k in (28) with those of (22), K_1 - K_0 = -K_ori N (paley.fish28ori), which under that reading \
         would be off by the factor T.",
        StepVariant { position: 0, phase: 1 },
        |variant, run| {
            // Each fish for itself: an identity in all that its step depends on.
            state_identity(
                euler_increments(variant),
                &["1/(10 T)", "u"],
                "increments of Euler's method with step T",
                run,
            )
            .for_all()
        },
    )
    .reading("u_k is one and the same steering in (26) and in (2).")
    .repaired(
        Fault::Slip,
        "For T > 0 and one and the same steering u_k in both, r_k(q+1) = r_k(q) + T e^{i th_k(q)}, th_k(q+1) = th_k(q) + T u_k(q) is the \
         forward Euler method with step T for (1), (2).",
        StepVariant { position: 1, phase: 1 },
    )
    .altered("T^2 u", |v| v.phase = 2)
    .altered("T^2 e^{i theta}", |v| v.position = 2)
    .altered("u without T", |v| v.phase = 0)
}

/// paley.vrep and paley.vatt: the field is `sign i^turns sum rhat_kj`, which is to point away from the neighbours (`away = 1`) or towards
/// them (-1), and enters (27) with the sign `gain`.
#[derive(Clone, Copy)]
pub struct BehaviourVariant {
    sign: i64,
    turns: u32,
    away: i64,
    gain: i64,
}

impl BehaviourVariant {
    const REPULSION: Self = BehaviourVariant { sign: 1, turns: 0, away: 1, gain: 1 };
    const ATTRACTION: Self = BehaviourVariant { sign: -1, turns: 0, away: -1, gain: 1 };

    /// With the other sign of the field, as printed.
    fn reversed(self) -> Self {
        BehaviourVariant { sign: -self.sign, ..self }
    }
}

/// With neighbours at `r_k - d_j e^{i psi_j}`: moving along `v` changes the sum of the distances at the rate `away |v|^2`, and the
/// heading turns towards `v`: `(d/dt) <e^{i theta}, v> = K <i e^{i theta}, v>^2` at a fixed `v`.
fn behaviour(variant: &BehaviourVariant) -> Identity<'_> {
    Identity::of(move |[gain, theta, first, second, third]| {
        let heading = phasor(theta)?;
        let away = [phasor(first)?, phasor(second)?, phasor(third)?];
        let sum = repulsion(&heading, &away).scale(&gain.integer(variant.sign));
        let v = (0..variant.turns).fold(sum, |v, _| quarter_turn(&v));
        // d/de |r_k + e v - r_j| = <v, rhat_kj>
        let distances = away.iter().fold(gain.zero(), |rate, unit| rate + v.dot(unit));
        let turning = steering_towards(&heading, &v) * gain * gain.integer(variant.gain);
        let rate = quarter_turn(&heading).scale(&turning).dot(&v);
        let square = steering_towards(&heading, &v).square();
        Ok((vec![distances, rate], vec![v.norm_squared() * gain.integer(variant.away), square * gain]))
    })
    .within(|at| at[0] > rational(0, 1))
    .named(vec!["the rate of the sum of distances along v".to_string(), "the rate of <e^{i theta}, v>".to_string()])
}

fn examine_behaviour(variant: &BehaviourVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let names = ["K", "tan(theta/2)", "tan(psi_1/2)", "tan(psi_2/2)", "tan(psi_3/2)"];
    let part = "v away from (or towards) three neighbours, rhat_kj = e^{i psi_j}, and steering towards v";
    let section = "notes/paley_particles.md, Behaviours of fish, steps 1-2";
    let identity = run.identity(&behaviour(variant), &names, part)?;
    Run::all([Ok(identity.on([1, 2])).checks("steps 1 and 2"), argued(&[1, 2], "any number of neighbours", section)])
}

pub fn repulsion_field() -> Record<BehaviourVariant> {
    let right = BehaviourVariant::REPULSION;
    Record::new(
        "paley.vrep",
        "r_kj = r_k - r_j (defined in the text on shape controls) points from j to k, away from the \
         neighbour. Moving along v changes the sum of distances to the neighbours at the rate <v, sum \
         rhat_kj>: it is -|v|^2 for the printed v^rep = -sum rhat_kj, and (27) with K_rep > 0 steers \
         towards v. So the printed field attracts. The sign belongs to the convention r_j - r_k (reference \
         [19]). What the law of steering does to a pair of fish in the long run is another matter: at \
         constant speed they overshoot and come back.",
        right.reversed(),
        examine_behaviour,
    )
    .clauses(&[
        "v_k^rep = - sum_{j in N_k^rep} rhat_kj with rhat_kj = r_kj/|r_kj|, r_kj = r_k - r_j, points away \
         from the neighbours.",
        "With K_rep > 0 in (27) it produces repulsion.",
    ])
    .reading(
        "A field produces repulsion where moving along it lengthens the distances to the neighbours, and \
         (27) steers towards it.",
    )
    .repaired(Fault::Slip, "", right)
    .repaired_clauses(&[
        "Where no neighbour is at r_k, and while the neighbours rest, moving fish k along v_k^rep = sum_{j in N_k^rep} rhat_kj, rhat_kj = \
         (r_k - r_j)/|r_k - r_j|, r_k' = v_k^rep, lengthens the sum of the distances to these neighbours at the rate |v_k^rep|^2.",
        "With K_rep > 0 the steering th_k' = K_rep <i e^{i th_k}, v_k^rep>, the term of (27) in continuous time, turns the heading towards \
         it: <e^{i th_k}, v_k^rep> does not decrease at a fixed v_k^rep.",
    ])
    .altered("the field turned by a quarter", |v| v.turns = 1)
    .altered("K_rep < 0", |v| v.gain = -1)
}

pub fn attraction_field() -> Record<BehaviourVariant> {
    let right = BehaviourVariant::ATTRACTION;
    Record::new(
        "paley.vatt",
        "As for paley.vrep: rhat_kj points away from the neighbour, so the printed v^att = sum rhat_kj \
         increases the sum of distances at the rate |v|^2. With r_kj = r_k - r_j attraction is v^att = -sum \
         rhat_kj. That two fish with this steering stay near each other is not said: from the distance 2 \
         with equal headings and T = 0.05 they pass each other and are as far apart again after 11 steps.",
        right.reversed(),
        examine_behaviour,
    )
    .clauses(&[
        "v_k^att = sum_{j in N_k^att} rhat_kj with rhat_kj = r_kj/|r_kj|, r_kj = r_k - r_j, points towards \
         the neighbours.",
        "With K_att > 0 in (27) it produces attraction.",
    ])
    .reading(
        "A field produces attraction where moving along it shortens the distances to the neighbours, and \
         (27) steers towards it.",
    )
    .repaired(Fault::Slip, "", right)
    .repaired_clauses(&[
        "Where no neighbour is at r_k, and while the neighbours rest, moving fish k along v_k^att = - sum_{j in N_k^att} rhat_kj, rhat_kj = \
         (r_k - r_j)/|r_k - r_j|, r_k' = v_k^att, shortens the sum of the distances to these neighbours at the rate |v_k^att|^2.",
        "With K_att > 0 the steering th_k' = K_att <i e^{i th_k}, v_k^att>, the term of (27) in continuous time, turns the heading towards \
         it: <e^{i th_k}, v_k^att> does not decrease at a fixed v_k^att.",
    ])
    .altered("the field turned by a quarter", |v| v.turns = 1)
    .altered("K_att < 0", |v| v.gain = -1)
}
