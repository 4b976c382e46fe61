//! tanner1.propIV3a, propIV3b, proof_cases: two agents on one line.
//!
//! Two linked agents start from relative rest on a line with the common velocity `c > 0` along it. As long as both velocities point the same way
//! the headings are equal, no alignment force acts, and the velocities are `c ± u` with `u² + V(s) = V(s_0)`: they swing for ever.

use super::energy_rates::{ENERGY, InvariantVariant, examine_invariant};
use super::triangle::turns_for_ever;
use arithmetic::{Field, Interval, Rational, Ring, Signed, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Fault, Grade, Outcome, Run, interval_value};
use models::double_integrator::Potential;

/// `1/s + log s`, the printed choice.
pub(super) fn potential() -> Potential {
    Potential::inverse_square_log(&rational(1, 1))
}

/// A swing from `s_0` with the common velocity `c`.
#[derive(Clone, Copy)]
struct Swing {
    start: i64,
    speed: (i64, i64),
}

impl Swing {
    /// The largest `u²`: `V(s_0) - V(1)`.
    fn excess(self) -> Result<Interval, CheckError> {
        let s = Interval::from_rational(&rational(self.start, 1), 80);
        let least = potential().value(&s.one())?;
        Ok(potential().value(&s)? - least)
    }

    /// Whether both velocities point forwards for ever (`Some(true)`), or the front one's reaches zero (`Some(false)`).
    fn keeps_direction(self) -> Result<Option<bool>, CheckError> {
        let excess = self.excess()?;
        let room = excess.rational(&rational(self.speed.0, self.speed.1)).square() - &excess;
        Ok(match (room.is_certainly_positive(), room.is_certainly_negative()) {
            (true, _) => Some(true),
            (_, true) => Some(false),
            _ => None,
        })
    }

    fn describe(self) -> String {
        let c = Rational::new(self.speed.0.into(), self.speed.1.into());
        format!("two agents at (0, 0) and (2, 0), linked, both with velocity ({c}, 0), V = 1/s + log s")
    }
}

/// What is said of the limits.
#[derive(Clone, Copy)]
pub enum LimitVariant {
    /// The distances come to rest at a minimum of the potential.
    Stabilised,
    /// Each `V_i` comes to rest at a minimum, or each velocity at rest, by the cases of the proof.
    Cases,
    /// The potential energy does not increase.
    Falling,
    /// The headings converge to a common value.
    Headings,
    /// All speeds become equal.
    Speeds,
    /// A quantity is constant.
    Kept(InvariantVariant),
}

fn examine(variant: &LimitVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let fast = Swing { start: 4, speed: (2, 1) };
    let slow = Swing { start: 4, speed: (1, 2) };
    let evidence =
        || Evidence::new(Grade::Certified, "two agents on a line", "enclosure of V(4) - V(1), conservation of energy");
    if let LimitVariant::Kept(quantity) = variant {
        return examine_invariant(quantity, run);
    }
    let excess = fast.excess()?;
    run.value("largest_squared_swing", interval_value(&excess, 12));
    let (ahead, stops) = (fast.keeps_direction()?, slow.keeps_direction()?);
    if ahead != Some(true) || stops != Some(false) || !excess.is_certainly_positive() {
        return Ok(Outcome::Undecided("the enclosure of the energy is too wide".to_string()));
    }
    let how = match variant {
        LimitVariant::Headings => {
            let what = format!(
                "{}: the velocity of the front one falls to zero before they are at distance 1, as u² reaches V(4) - V(1) > 1/4; there it has no heading and (5) no value",
                slow.describe()
            );
            if !turns_for_ever(&rational(1, 1))? {
                return Ok(Outcome::fails(what, evidence()));
            }
            let triangle = Evidence::new(
                Grade::Exact,
                "with wrapped differences: a triangle that turns for ever",
                "three linked agents on an equilateral triangle of squared side 2, omega² = 6 V'(2) = 3/2, V = 1/s + log s: the accelerations of (4), (5) are -omega² r_i, exactly; headings stay a third of a turn apart (beyond.tanner1.turning_triangle)",
            );
            return Ok(Outcome::Fails { counterexample: what, evidence: vec![evidence(), triangle] });
        }
        LimitVariant::Stabilised => {
            "both headings stay 0 and the distance swings for ever about 1, as u² + V(s) is constant"
        }
        LimitVariant::Cases => {
            "-grad V_1 . v_1 changes sign in every swing: neither case lasts, and nothing comes to rest"
        }
        LimitVariant::Falling => "the potential energy falls and rises again in every swing",
        LimitVariant::Speeds => "the velocities swing about their mean for ever",
        LimitVariant::Kept(_) => "",
    };
    Ok(Outcome::fails(format!("{}: {how}", fast.describe()), evidence()))
}

pub fn distances() -> Record<LimitVariant> {
    Record::new(
        "tanner1.propIV3b",
        "The alignment forces do no work, so the mechanical energy is constant: the potential energy can settle only if the surplus goes into the common motion. Two agents that move along the line through both have equal headings for ever and no alignment force; their distance swings for ever.",
        LimitVariant::Stabilised,
        examine,
    )
    .repaired(
        Fault::False,
        "Along the closed loop (1/2) sum_i (V_i + v_i^T v_i) is constant; distances need not be stabilised.",
        LimitVariant::Kept(ENERGY),
    )
    .control("the potential energy does not increase", LimitVariant::Falling)
    .control("all speeds become equal", LimitVariant::Speeds)
}

pub fn headings() -> Record<LimitVariant> {
    Record::new(
        "tanner1.propIV3a",
        "The proof rests on Vdot_t = -theta^T L_w theta, which is false (tanner1.eq9). With the law as printed a motion may even end: the front one of two agents on a line comes to rest, where it has no heading and the law no value, so that headings do not converge. \
         With wrapped differences they need not align even in a motion that goes on for ever and fulfils every hypothesis (connected graph, V_t finite, nobody rests): three linked agents on an equilateral triangle of squared side 2 that turns at the rate omega² = 6 V'(2) = 3/2 have headings a third of a turn apart for ever, and their alignment forces cancel. \
         With raw or followed differences those forces do not cancel (at -2/3 pi, 0, 2/3 pi the first agent's differences sum to -2 pi), and whether all motions without a stop align is not decided here; the mechanical energy is no obstacle, since it can go into the common motion.",
        LimitVariant::Headings,
        examine,
    )
    .control("and all speeds become equal", LimitVariant::Speeds)
    .control("and the potential energy does not increase", LimitVariant::Falling)
}

pub fn cases() -> Record<LimitVariant> {
    Record::new(
        "tanner1.proof_cases",
        "The cases need not last: -grad_{r_i} V_i . v_i changes sign in every swing of two agents on a line. Nor does a vanishing gradient make a minimum, and grad_{v_i} in case 2 should read grad_{r_i}.",
        LimitVariant::Cases,
        examine,
    )
    .repaired(
        Fault::False,
        "On the set of equal constant headings potential forces are along the velocities, and the mechanical energy is constant; the system need not converge to a minimum of sum V_i.",
        LimitVariant::Kept(ENERGY),
    )
    .control("the potential energy does not increase", LimitVariant::Falling)
    .control("all speeds become equal", LimitVariant::Speeds)
}
