//! beyond.tanner2.certified_split: an open set of connected starts from which a flock breaks up for ever.

use crate::prelude::*;
use arithmetic::{FloatInterval, Signed};
use models::double_integrator::{Coordinates, EnclosedEvent, EnclosedFlock, Potential, State};

/// The speed of the agent that leaves, the time by which it has left, and how far each coordinate of a start may be from the stated one.
#[derive(Clone)]
pub struct Split {
    speed: i64,
    by: Rational,
    within: Rational,
    /// Agent 3 turns round when the proof for all later times begins.
    turns_round: bool,
}

/// When the proof that the parts stay apart begins.
const SETTLED: f64 = 2.0;

const PLANE: Coordinates = Coordinates::Cartesian;

/// Agents in a row at 0, 1 and 5/2, links below 2; the last one moves away from the others, which are at rest.
fn starts(variant: &Split) -> State<FloatInterval> {
    let around = |x: Rational| {
        let interval = |q: &Rational| FloatInterval::from_rational(q);
        interval(&(&x - &variant.within)).hull(&interval(&(&x + &variant.within)))
    };
    let vectors = |along: [Rational; 3]| along.map(|x| [around(x), around(rational(0, 1))]).to_vec();
    State {
        positions: vectors([rational(0, 1), rational(1, 1), rational(5, 2)]),
        velocities: vectors([rational(0, 1), rational(0, 1), rational(variant.speed, 1)]),
    }
}

/// Whether agents 1 and 2 stay linked and agent 3 stays out of reach from this state on. The first two keep the velocity of their middle, and
/// the energy `|v12|²/4 + V(s12)` of the rest does not grow, so that they stay linked if it is below `V(R²)`. Each is then within `R/2` of
/// the middle, and agent 3, which nothing pulls, moves straight away from that, or towards it and past it at less than `R/2`, where it is
/// within reach of both.
fn apart_for_ever(
    state: &State<FloatInterval>,
    potential: &Potential,
    square: &Rational,
) -> Result<Option<bool>, CheckError> {
    let number = FloatInterval::from_rational;
    let half = FloatInterval::point(0.5);
    let middle = |v: &[[FloatInterval; 2]]| [0, 1].map(|k| v[2][k] - (v[0][k] + v[1][k]) * half);
    let (offset, drift) = (middle(&state.positions), middle(&state.velocities));
    let energy = PLANE.square(&state.relative_velocity(0, 1)) * half.square()
        + potential.rational_value(&PLANE.square(&state.separation(0, 1)))?;
    let stay_linked = (number(&potential.rational_value(square)?) - energy).is_certainly_positive();
    // |offset| > R + R/2.
    let far = PLANE.square(&offset) - number(&(square * rational(9, 4)));
    let (outward, aside) = (PLANE.product(&offset, &drift), offset[0] * drift[1] - offset[1] * drift[0]);
    let nearest = PLANE.square(&drift) * number(&(square * rational(1, 4))) - aside * aside;
    let parts = far.is_certainly_positive() && outward.is_certainly_positive();
    let meets = outward.is_certainly_negative() && nearest.is_certainly_positive();
    Ok((stay_linked && (parts || meets)).then_some(parts))
}

fn examine(variant: &Split, run: &mut Run) -> Result<Outcome, CheckError> {
    let square = rational(4, 1);
    let potential = Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1));
    let flock = EnclosedFlock { potential: potential.clone(), threshold: Some(square.clone()) };
    let mut steps = 0;
    let found = match flock.run(&starts(variant), &[], SETTLED, |_, _| steps += 1) {
        Ok(found) => found,
        Err(error) => return Ok(Outcome::Undecided(error.to_string())),
    };
    let number = |x: f64| format!("~{x:.6}");
    let evidence = certified(
        "all starts of the box",
        "validated integration (Taylor expansions with parallelepipeds), Filippov's solutions at the threshold",
    )
    .on([1, 2])
    .for_all()
    .cases(steps);
    let [EnclosedEvent { pair: (1, 2), linked: false, from, to }] = found.events[..] else {
        return Ok(Outcome::fails(format!("changes of the network until t = {SETTLED}: {:?}", found.events), evidence));
    };
    if found.edges != [(0, 1)] {
        return Ok(Outcome::fails(format!("links at t = {SETTLED}: {:?}", found.edges), evidence));
    }
    if let (Some(from), Some(to)) = (Rational::from_float(from), Rational::from_float(to)) {
        run.value("link_lost", interval_value(&Interval::hull_of_rationals(&from, &to, 80), 7));
    }
    if FloatInterval::point(to).hi() > FloatInterval::from_rational(&variant.by).lo() {
        return Ok(Outcome::fails(format!("the link ends between {} and {}", number(from), number(to)), evidence));
    }
    let mut later = found.end;
    if variant.turns_round {
        later.velocities[2] = later.velocities[2].map(|v| -v);
    }
    let detail = format!("enclosures at t = {SETTLED}: the energy of the pair, the offset of agent 3 and its rate");
    let parts = certified("the parts after t = 2", detail).on([3]);
    match apart_for_ever(&later, &potential, &square)? {
        Some(true) => {}
        Some(false) => {
            let what = "after t = 2 agents 1 and 2 stay linked and agent 3 passes their middle at less than R/2: it is linked again";
            return Ok(Outcome::fails(what, parts));
        }
        None => {
            return Ok(Outcome::Undecided(format!("at t = {SETTLED} it is not certain that the parts stay apart")));
        }
    }
    Run::all([
        Ok(Outcome::Holds(vec![evidence, parts])),
        argued(&[3], "for ever", "notes/validated.md, Two parts that stay apart, steps 1 to 4"),
    ])
}

pub fn certified_split() -> Record<Split> {
    let printed = Split { speed: 4, by: rational(17, 100), within: rational(1, 100_000), turns_round: false };
    Record::new(
        "beyond.tanner2.certified_split",
        "Certified instead of simulated: the solution is enclosed from a whole box of starts, through the end of the link, until the parts are further apart than R + R/2 and the energy of the pair \
         is too small to part it. From then on the pair keeps the velocity of its middle and agent 3 its own, so the network never changes again; velocities of the pair agree in the limit \
         (tanner2.thm1a for two agents). At speed 3 instead of 4 agent 3 is caught and the network becomes complete.",
        printed.clone(),
        examine,
    )
    .stated("sharpens tanner2, Section 6 and Figure 6 (loss of connectivity)", "")
    .clauses(&[
        "Three agents under (4) with V = s + 1/s - 2, s the squared distance, and links below R = 2, from (0,0), (1,0), (5/2,0) with velocities (0,0), (0,0), (4,0), each coordinate up to 1/100000 away: the network is a connected path at first.",
        "The link 2-3 ends before t = 17/100, and until t = 2 nothing else changes.",
        "After t = 2 the network never changes: {1,2} and {3} part for ever.",
    ])
    .control("at speed 3", Split { speed: 3, within: rational(0, 1), ..printed.clone() })
    .control("before t = 4/25", Split { by: rational(4, 25), ..printed.clone() })
    .control("agent 3 turns round at t = 2", Split { turns_round: true, ..printed })
}
