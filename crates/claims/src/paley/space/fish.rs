//! paley.eq26, paley.vrep, paley.vatt: the steps of the fish model and its behaviours.

use super::instances::{StateIdentity, state_identity};
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, Field, Rational, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use models::oscillator::{State, phasor, quarter_turn, repulsion, steering_towards};

/// paley.eq26.
pub struct EulerStep;

/// Positions move by `T^position e^{i theta}` and phases by `T^phase u`.
#[derive(Clone, Copy)]
pub struct StepVariant {
    position: u64,
    phase: u64,
}

/// The increments of a step against those of Euler's method for (1), (2).
struct StepIdentity(StepVariant);

impl StateIdentity for StepIdentity {
    fn particles(&self) -> usize {
        1
    }

    fn sides<T: Field>(&self, constants: &[T], state: &State<T>) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [fineness, u] = constants else { return Err(ArithmeticError::Domain("two constants")) };
        // A counterexample is looked for at small integers, and T is to be small.
        let step = &(fineness.recip()? * fineness.ratio(1, 10));
        let z = &state.phasors[0];
        let moved = z.scale(&step.power(self.0.position));
        let euler = z.scale(step);
        let turned = step.power(self.0.phase) * u;
        Ok((vec![moved.re, moved.im, turned], vec![euler.re, euler.im, step.clone() * u]))
    }

    fn allows(&self, constants: &[Rational]) -> bool {
        constants[0] > rational(0, 1)
    }
}

impl Claim for EulerStep {
    type Variant = StepVariant;

    fn id(&self) -> &str {
        "paley.eq26"
    }

    fn derivation(&self) -> &str {
        "The forward Euler method of step h for (1), (2) is r + h e^{i theta}, theta + h u: one step for both equations. (26) moves positions with the step 1 and \
         phases with the step T << 1, which is Euler's method for no h (h = 1 from the first line, h = T from the second). It is so for the first line \
         r + T e^{i theta}; or for a model of speed 1/T, not the unit speed of (1). Reading: u_k is one and the same steering in (26) and in (2). As (2) allows any control, (26) is also \
         Euler's method with h = 1 for (1), (2) under the control T u_k (with T = 1 and all gains times T it is the printed model); but the article goes on to compare the gains of u_k in (28) with those of (22), \
         K_1 - K_0 = -K_ori N (paley.fish28ori), which under that reading would be off by the factor T."
    }

    fn printed(&self) -> StepVariant {
        StepVariant { position: 0, phase: 1 }
    }

    fn repair(&self) -> Option<Repair<StepVariant>> {
        Some(Repair {
            fault: Fault::Slip, clauses: Vec::new(),
            statement: "r_k(q+1) = r_k(q) + T e^{i th_k(q)}, th_k(q+1) = th_k(q) + T u_k(q) is the forward Euler method with step T for (1), (2).".to_string(),
            variant: StepVariant { position: 1, phase: 1 },
        })
    }

    fn controls(&self) -> Vec<Control<StepVariant>> {
        vec![
            Control::new("T^2 u", StepVariant { position: 1, phase: 2 }),
            Control::new("T^2 e^{i theta}", StepVariant { position: 2, phase: 1 }),
            Control::new("u without T", StepVariant { position: 1, phase: 0 }),
        ]
    }

    fn examine(&self, variant: &StepVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        state_identity(&StepIdentity(*variant), &["1/(10 T)", "u"], "increments of Euler's method with step T", run)
    }
}

/// paley.vrep and paley.vatt: `v = sign sum rhat_kj` is to point away from the neighbours (`away = 1`) or towards them (-1).
#[derive(Clone, Copy)]
pub struct BehaviourVariant {
    sign: i64,
    away: i64,
    /// The sign with which the behaviour enters (27).
    gain: i64,
}

/// With neighbours at `r_k - d_j e^{i psi_j}`: moving along `v` changes the sum of the distances at the rate `away |v|^2`, and the
/// heading turns towards `v`: `(d/dt) <e^{i theta}, v> = K <i e^{i theta}, v>^2` with `v` held.
struct BehaviourIdentity(BehaviourVariant);

impl RationalIdentity for BehaviourIdentity {
    fn variables(&self) -> usize {
        5
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [gain, theta, first, second, third] = at else { return Err(ArithmeticError::Domain("five variables")) };
        let heading = phasor(theta)?;
        let away = [phasor(first)?, phasor(second)?, phasor(third)?];
        let sum = repulsion(&heading, &away);
        let v = sum.scale(&gain.integer(self.0.sign));
        // d/de |r_k + e v - r_j| = <v, rhat_kj>
        let distances = away.iter().fold(gain.zero(), |rate, unit| rate + v.dot(unit));
        let turning = steering_towards(&heading, &v) * gain * gain.integer(self.0.gain);
        let rate = quarter_turn(&heading).scale(&turning).dot(&v);
        let square = steering_towards(&heading, &v).square();
        Ok((vec![distances, rate], vec![v.norm_squared() * gain.integer(self.0.away), square * gain]))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        at[0] > rational(0, 1)
    }

    fn components(&self) -> Vec<String> {
        vec!["the rate of the sum of distances along v".to_string(), "the rate of <e^{i theta}, v>".to_string()]
    }
}

fn examine_behaviour(variant: &BehaviourVariant, run: &Run) -> Result<Outcome, CheckError> {
    let names = ["K", "tan(theta/2)", "tan(psi_1/2)", "tan(psi_2/2)", "tan(psi_3/2)"];
    let part = "v away from (or towards) the neighbours, rhat_kj = e^{i psi_j}, and steering towards v";
    Run::all([run.identity(&BehaviourIdentity(*variant), &names, part), swim(variant)])
}

/// Two fish side by side, 2 apart, with equal headings, under (26) and (27) with this behaviour alone: they part, or come nearer.
fn swim(variant: &BehaviourVariant) -> Result<Outcome, CheckError> {
    const T: f64 = 0.05;
    const STEPS: usize = 6;
    let (mut places, mut headings) = ([Complex::new(0.0, 1.0), Complex::new(0.0, -1.0)], [0.0f64; 2]);
    let between = |places: &[Complex<f64>; 2]| places[0].clone() - &places[1];
    let mut distances = vec![2.0];
    for _ in 0..STEPS {
        let apart = between(&places);
        let unit = apart.scale(&(1.0 / apart.norm_squared().sqrt()));
        let directions = headings.map(|theta| Complex::new(theta.cos(), theta.sin()));
        for (k, away) in [unit.clone(), -unit].into_iter().enumerate() {
            let v = repulsion(&directions[k], &[away]).scale(&(variant.sign as f64));
            headings[k] += T * variant.gain as f64 * steering_towards(&directions[k], &v);
            places[k] = places[k].clone() + &directions[k];
        }
        distances.push(between(&places).norm_squared().sqrt());
    }
    let (least, most) = distances.iter().fold((f64::INFINITY, 0.0f64), |(a, b), d| (a.min(*d), b.max(*d)));
    let last = distances[STEPS];
    let detail = format!(
        "(26) as printed and (27), K = {}, T = {T}, w = 0, from the distance 2 with equal headings: {last:.3} after {STEPS} steps, between {least:.3} and {most:.3}",
        variant.gain
    );
    let evidence = Evidence::new(Grade::Simulated, "two fish side by side", detail.clone()).cases(1);
    // Steadily farther apart, or nearer.
    let steady = distances.windows(2).all(|pair| (pair[1] - pair[0]) * variant.away as f64 >= 0.0) && last != 2.0;
    Ok(if steady { Outcome::Holds(vec![evidence]) } else { Outcome::fails(detail, evidence) })
}

/// paley.vrep.
pub struct RepulsionField;

impl Claim for RepulsionField {
    type Variant = BehaviourVariant;

    fn id(&self) -> &str {
        "paley.vrep"
    }

    fn derivation(&self) -> &str {
        "r_kj = r_k - r_j (defined in the text on shape controls) points from j to k, away from the neighbour. Moving along v changes the sum of distances to \
         the neighbours at the rate <v, sum rhat_kj>: it is -|v|^2 for the printed v^rep = -sum rhat_kj, and (27) with K_rep > 0 steers towards v. So the \
         printed field attracts. The sign belongs to the convention r_j - r_k (reference [19]); here v^rep = +sum rhat_kj repels."
    }

    fn printed(&self) -> BehaviourVariant {
        BehaviourVariant { sign: -1, away: 1, gain: 1 }
    }

    fn repair(&self) -> Option<Repair<BehaviourVariant>> {
        Some(Repair {
            fault: Fault::Slip, clauses: Vec::new(),
            statement: "v_k^rep = sum_{j in N_k^rep} rhat_kj with rhat_kj = (r_k - r_j)/|r_k - r_j| (or - sum with rhat_jk); with K_rep > 0 it produces repulsion."
                .to_string(),
            variant: BehaviourVariant { sign: 1, away: 1, gain: 1 },
        })
    }

    fn controls(&self) -> Vec<Control<BehaviourVariant>> {
        vec![
            Control::new("sum rhat_kj attracts", BehaviourVariant { sign: 1, away: -1, gain: 1 }),
            Control::new("K_rep < 0", BehaviourVariant { sign: 1, away: 1, gain: -1 }),
        ]
    }

    fn examine(&self, variant: &BehaviourVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_behaviour(variant, run)
    }
}

/// paley.vatt.
pub struct AttractionField;

impl Claim for AttractionField {
    type Variant = BehaviourVariant;

    fn id(&self) -> &str {
        "paley.vatt"
    }

    fn derivation(&self) -> &str {
        "As for paley.vrep: rhat_kj points away from the neighbour, so the printed v^att = sum rhat_kj increases the sum of distances at the rate |v|^2. With \
         r_kj = r_k - r_j attraction is v^att = -sum rhat_kj."
    }

    fn printed(&self) -> BehaviourVariant {
        BehaviourVariant { sign: 1, away: -1, gain: 1 }
    }

    fn repair(&self) -> Option<Repair<BehaviourVariant>> {
        Some(Repair {
            fault: Fault::Slip, clauses: Vec::new(),
            statement: "v_k^att = - sum_{j in N_k^att} rhat_kj with rhat_kj = (r_k - r_j)/|r_k - r_j| (or sum with rhat_jk); with K_att > 0 it produces attraction."
                .to_string(),
            variant: BehaviourVariant { sign: -1, away: -1, gain: 1 },
        })
    }

    fn controls(&self) -> Vec<Control<BehaviourVariant>> {
        vec![
            Control::new("-sum rhat_kj repels", BehaviourVariant { sign: -1, away: 1, gain: 1 }),
            Control::new("K_att < 0", BehaviourVariant { sign: -1, away: -1, gain: -1 }),
        ]
    }

    fn examine(&self, variant: &BehaviourVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_behaviour(variant, run)
    }
}
