//! tanner1.propIV3a, propIV3b, proof_cases: two agents on one line.
//!
//! Two linked agents start from relative rest on a line with the common velocity `c > 0` along it. As long as both velocities point the same way
//! the headings are equal, no alignment force acts, and the velocities are `c ± u` with `u² + V(s) = V(s_0)`: they swing for ever.

use super::energy_rates::energy_is_constant;
use super::sets::plain_accelerations;
use crate::prelude::*;
use crate::tanner2::fixtures::{on_connected, printed as potential};
use arithmetic::Signed;
use models::double_integrator::{HeadingDifference, turning_triangle};
use std::collections::BTreeSet;

/// A start at the squared distance `square` with the common speed `c`, of agents with headings or with velocities aligned.
#[derive(Clone, Copy)]
pub struct Swing {
    square: i64,
    speed: (i64, i64),
}

/// Both velocities point forwards for ever.
const FAST: Swing = Swing { square: 4, speed: (2, 1) };
/// The front agent comes to rest.
const SLOW: Swing = Swing { square: 4, speed: (1, 2) };
/// At the minimum of the potential.
const AT_MINIMUM: Swing = Swing { square: 1, speed: (2, 1) };

const PRECISION: u32 = 80;

impl Swing {
    /// The largest `u²`: `V(s_0) - V(1)`.
    fn excess(self) -> Result<Interval, CheckError> {
        let s = Interval::from_rational(&rational(self.square, 1), PRECISION);
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

    /// The slopes of the potential where the swing begins and at the squared distance 1/2, if it gets there. The rear agent, which moves
    /// forwards, has `-grad_{r_1} V_1 . v_1` of the same sign.
    fn slopes(self) -> Result<Vec<(Rational, Rational)>, CheckError> {
        let near = Interval::from_rational(&rational(1, 2), PRECISION);
        let from = Interval::from_rational(&rational(self.square, 1), PRECISION);
        let reached = (potential().value(&from)? - potential().value(&near)?).is_certainly_positive();
        let places = [Some(rational(self.square, 1)), reached.then(|| rational(1, 2))];
        places.into_iter().flatten().map(|s| Ok((s.clone(), potential().slope(&s)?))).collect()
    }

    /// The agents, to be seen.
    fn witness(self) -> Witness {
        let (c, point) =
            (Rational::new(self.speed.0.into(), self.speed.1.into()), |x| [rational(x, 1), rational(0, 1)]);
        let velocity = [c, rational(0, 1)];
        Witness::agents(&[point(0), point(2)], &[velocity.clone(), velocity], &[(0, 1)])
    }

    fn describe(self) -> String {
        let c = Rational::new(self.speed.0.into(), self.speed.1.into());
        format!("two agents at (0, 0) and (2, 0), linked, both with velocity ({c}, 0), V = 1/s + log s")
    }
}

/// What is said to become of two agents on a line.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    /// They come to rest relative to each other at the distance 1: then `V(1)` is all that is left of `u² + V(s)`.
    Rest,
    /// They swing for ever: there is more than `V(1)`.
    Swing,
}

/// Evidence of the motion, or what is wrong with it: it keeps its direction, and has the energy of its end.
fn ends(swing: Swing, end: End, run: &mut Run) -> Result<Result<Evidence, Outcome>, CheckError> {
    let evidence = certified(
        "two agents on a line",
        "enclosure of V(4) - V(1): more than 0, less than the square of the common speed; what follows is in notes/tanner1.md, A pair on a line",
    );
    let excess = swing.excess()?;
    run.value("largest_squared_swing", interval_value(&excess, 12));
    let what = match (swing.keeps_direction()?, excess.is_certainly_positive()) {
        (None, _) => return Ok(Err(Outcome::Undecided("the enclosure of the energy is too wide".to_string()))),
        (_, false) if end == End::Swing => {
            format!("two agents at the squared distance {}: the energy allows no swing", swing.square)
        }
        (Some(false), _) => format!("{}: the front one comes to rest, where it has no heading", swing.describe()),
        (_, true) if end == End::Rest => {
            let text = format!(
                "{}: both headings stay 0 and the distance swings for ever about 1, as u² + V(s) is constant and \
                 above V(1) by {}",
                swing.describe(),
                interval_value(&excess, 12)
            );
            return Ok(Err(Outcome::fails(Counterexample::new(text, [swing.witness()]), evidence)));
        }
        _ => return Ok(Ok(evidence)),
    };
    Ok(Err(Outcome::fails(what, evidence.on([2]))))
}

/// What is said to become of which start.
#[derive(Clone, Copy)]
pub struct DistanceVariant {
    end: End,
    start: Swing,
}

fn examine_distances(variant: &DistanceVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let swing = match ends(variant.start, variant.end, run)? {
        Ok(swing) => swing,
        Err(outcome) => return Ok(outcome),
    };
    Run::all([
        energy_is_constant(run).on([1]),
        holds(swing.on([2])),
        argued(&[2], "the swing for ever", "notes/tanner1.md, A pair on a line, steps 1 to 3"),
    ])
}

pub fn distances() -> Record<DistanceVariant> {
    Record::new(
        "tanner1.propIV3b",
        "The alignment forces do no work, so the mechanical energy is constant: the potential energy can settle only if the surplus goes into the common motion. Two agents that move along the line through both have equal headings for ever and no alignment force; their distance swings for ever.",
        DistanceVariant { end: End::Rest, start: FAST },
        examine_distances,
    )
    .repaired(Fault::False, "", DistanceVariant { end: End::Swing, start: FAST })
    .repaired_clauses(&[
        "Along (1), (4), (5), as long as the motion lasts, (1/2) sum_i (V_i + v_i^T v_i) is constant.",
        "Under the same law two linked agents at (0, 0) and (2, 0), both with velocity (2, 0), V = 1/s + log s, s the squared distance, keep \
         the heading 0 and their distance swings for ever: it does not tend to a limit.",
    ])
    .altered("with velocity (1/2, 0)", |v| v.start = SLOW)
    .altered("from the distance 1", |v| v.start = AT_MINIMUM)
}

/// What `theta_i - theta_j` is, and whether the motion has to exist for all time.
#[derive(Clone, Copy)]
pub struct HeadingVariant {
    difference: HeadingDifference,
    stops: bool,
}

fn examine_headings(variant: &HeadingVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    if variant.difference == HeadingDifference::Wrapped && turning_triangle(&potential(), &rational(1, 1), [0; 3])? {
        let what = "three linked agents on an equilateral triangle of squared side 2, omega² = 6 V'(2) = 3/2, V = 1/s + log s: the accelerations of (4), (5) are -omega² r_i; headings stay a third of a turn apart";
        return Ok(Outcome::fails(what, exact("a triangle that turns for ever", "exact field of numbers")));
    }
    if variant.stops && SLOW.keeps_direction()? == Some(false) {
        let what = format!(
            "{}: the velocity of the front one reaches zero before they are at distance 1, as u² reaches V(4) - V(1) > 1/4; there it has no heading and (5) no value",
            SLOW.describe()
        );
        let enclosed = "enclosure of V(4) - V(1), conservation of energy";
        return Ok(Outcome::fails(what, certified("two agents on a line", enclosed)));
    }
    run.value("squared_speed_at_which_the_front_agent_stops", interval_value(&SLOW.excess()?, 12));
    Ok(Outcome::Undecided(
        "with headings as in (2) and the potential of Figure 2 every counterexample that is known is a motion with an instant of zero speed, where (2) says nothing (without a potential two linked agents that part with headings 1 and -1 never agree); for motions without such an instant there is neither a proof (that of the paper rests on tanner1.eq9, which is false) nor a counterexample. With wrapped differences it is false: beyond.tanner1.turning_triangle".to_string(),
    ))
}

pub fn headings() -> Record<HeadingVariant> {
    Record::new(
        "tanner1.propIV3a",
        "The proof rests on Vdot_t = -theta^T L_w theta, which is false (tanner1.eq9). The mechanical energy is no obstacle to aligned headings, since it can go into the common motion, as it does for two linked agents with wrapped differences, whose |v_1 + v_2| never decreases (beyond.tanner1.two_agents). \
         A motion may end: the front one of two agents on a line can come to rest, where it has no heading and the law no value. That is an instant of zero speed, about which (2) says nothing. \
         With wrapped differences headings need not align even in a motion that goes on for ever: the alignment forces on a turning equilateral triangle cancel. \
         With the differences of (2) those forces do not cancel (at -2/3 pi, 0, 2/3 pi the first agent's differences sum to -2 pi).",
        HeadingVariant { difference: HeadingDifference::Raw, stops: false },
        examine_headings,
    )
    .reading("headings and their differences as numbers, as in (2); the potential of Figure 2, as for V_t and Omega; motions in which no agent is ever at rest")
    .altered("wrapped differences", |v| v.difference = HeadingDifference::Wrapped)
    .altered("motions that stop too", |v| v.stops = true)
}

/// The signs that `-grad_{r_1} V_1 . v_1` is said to have in a swing, the headings in the identity, and the start of the swing.
#[derive(Clone, Copy)]
pub struct CaseVariant {
    signs: usize,
    equal_headings: bool,
    start: Swing,
}

fn examine_cases(variant: &CaseVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let swing = match ends(variant.start, End::Swing, run)? {
        Ok(swing) => swing,
        Err(outcome) => return Ok(outcome),
    };
    let slopes = variant.start.slopes()?;
    let signs = slopes.iter().map(|(_, slope)| slope.is_certainly_positive()).collect::<BTreeSet<_>>().len();
    if signs != variant.signs {
        let slopes: Vec<String> = slopes.iter().map(|(s, slope)| format!("V' = {slope} at s = {s}")).collect();
        let what = format!(
            "{}: {}, both in every swing, so that -grad V_1 . v_1 has {signs} signs: neither case lasts, and nothing \
             comes to rest",
            variant.start.describe(),
            slopes.join(", ")
        );
        let what = Counterexample::new(what, [variant.start.witness()]);
        return Ok(Outcome::fails(what, swing.on([1, 2, 3])));
    }
    let forces = on_connected(run, 3, "the accelerations", |graph| plain_accelerations(graph, variant.equal_headings));
    Run::all([
        forces.checks("step 5").on([1]),
        argued(&[1], "forces at equal constant headings", "notes/tanner1.md, Heading dynamics, steps 5 and 6"),
        holds(swing.on([2])),
        argued(&[2], "the swing for ever", "notes/tanner1.md, A pair on a line, steps 1 to 4"),
    ])
}

pub fn cases() -> Record<CaseVariant> {
    Record::new(
        "tanner1.proof_cases",
        "The cases need not last: -grad_{r_i} V_i . v_i changes sign in every swing of two agents on a line. Nor does a vanishing gradient make a minimum, and grad_{v_i} in case 2 should read grad_{r_i}.",
        CaseVariant { signs: 1, equal_headings: true, start: FAST },
        examine_cases,
    )
    .clauses(&[
        "Case 1: if -grad_{r_i} V_i . v_i <= 0, then v_i converges to the largest invariant set with grad_{r_i} V_i = 0.",
        "Case 2: if -grad_{v_i} V_i . v_i > 0, then V_i is monotonically decreasing and eventually reaches one of its minima.",
        "In any case the system converges to a minimum of sum_i V_i.",
    ])
    .repaired_by(Fault::False, "", |v| v.signs = 2)
    .repaired_clauses(&[
        "Under (4), (5), on the set of equal constant headings of agents that move, no linked ones in one place, potential forces are along the velocities.",
        "Neither sign of -grad_{r_i} V_i . v_i need last under this law, and the system need not converge to a minimum of sum V_i: two linked agents at (0, 0) and (2, 0), both \
         with velocity (2, 0), V = 1/s + log s, s the squared distance, swing for ever, and -grad_{r_1} V_1 . v_1 has both signs in each \
         swing.",
    ])
    .altered("at any headings", |v| v.equal_headings = false)
    .altered("from the distance 1", |v| v.start = AT_MINIMUM)
}
