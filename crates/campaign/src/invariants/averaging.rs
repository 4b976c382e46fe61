//! Flocks of model D (Chazelle).

use super::{Checked, Invariant, OrFails, Stop, Tested, require};
use crate::draws::Draws;
use crate::strategies::{flock, long_flock, start};
use algebra::graph::Graph;
use algebra::matrix::StochasticMatrix;
use arithmetic::{Rational, Unwatched, rational};
use models::averaging::settle::{Ending, Limits, settle};
use models::averaging::{Flock, Hysteresis, Start, State, Switch, motion, transition_matrix};
use num_traits::ToPrimitive;

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "flock.settle_is_stepping",
        statement: "The switches that `flock settle` finds are those of stepping, and what it calls steady does not change.",
        control: "stepping without the hysteresis of the flock, or with that of 1/8",
        block: 1,
        check: settle_is_stepping,
    },
    Invariant {
        id: "flock.long_jumps",
        statement: "The same for slow flocks whose first contacts come after thousands of steps.",
        control: "stepping the flock with its first velocity one part in 64 larger",
        block: 1,
        check: long_jumps,
    },
    Invariant {
        id: "flock.step_is_equation",
        statement: "A step of a flock is x(t) = x(t-1) + v(t), v(t+1) = P(t) v(t) with the transition matrix of its network, whose rows sum to 1.",
        control: "the transition matrices one step earlier",
        block: 20,
        check: step_is_equation,
    },
    Invariant {
        id: "flock.weighted_momentum",
        statement: "As long as the network stays, sum_i v_i / c_i does not change.",
        control: "the sum without the weights",
        block: 50,
        check: weighted_momentum,
    },
    Invariant {
        id: "flock.velocities_stay_inside",
        statement: "The largest velocity of a flock, coordinate by coordinate, never increases.",
        control: "the largest velocity of all birds but the first",
        block: 50,
        check: velocities_stay_inside,
    },
];

fn described(start: &Start) -> String {
    let rows = |rows: &[Vec<Rational>]| super::shown(rows.iter().map(super::shown));
    format!(
        "positions {}, velocities {}, weights {:?}, hysteresis {:?}",
        rows(&start.positions),
        rows(&start.velocities),
        start.weights,
        start.hysteresis
    )
}

fn new_flock(start: &Start) -> Result<Flock, Stop> {
    Flock::new(start).map_err(|error| Stop::Fails { why: format!("refused: {error}"), instance: described(start) })
}

/// Compares jumping with stepping `stepped` until a time.
fn compare(start: &Start, stepped: &Start, until: u32, limits: &Limits) -> Checked {
    let mut jumped: Vec<Switch> = Vec::new();
    let settled = settle(new_flock(start)?, limits, &mut |switch| jumped.push(switch.clone()), &Unwatched);
    let settled = settled.map_err(|error| Stop::Fails { why: error.to_string(), instance: described(start) })?;
    let mut flock = new_flock(stepped)?;
    let mut found = Vec::new();
    for _ in 0..until {
        found.extend(flock.step().or_fails("a step is refused")?);
    }
    jumped.retain(|switch| switch.time <= until.into());
    if let Ending::Undecided(_) | Ending::Beyond { .. } = settled.ending {
        // Stopped on the way: what was found so far.
        found.truncate(jumped.len());
    }
    if let Ending::Alternating { .. } = settled.ending {
        found.truncate(jumped.len());
    }
    let times = |list: &[Switch]| super::shown(list.iter().map(|switch| &switch.time));
    let why = || format!("jumping finds switches at {}, stepping at {}", times(&jumped), times(&found));
    if jumped != found {
        require(false, why(), || described(start))?;
    }
    match settled.ending {
        Ending::Undecided(why) => Err(Stop::Undecided(why)),
        _ => Ok(None),
    }
}

fn settle_is_stepping(draws: &mut Draws, tested: Tested) -> Checked {
    let start = start(draws);
    let other = match (&start.hysteresis, tested) {
        (_, Tested::AsItIs) => start.hysteresis.clone(),
        (Hysteresis::None, _) => Hysteresis::Constant(rational(1, 8)),
        _ => Hysteresis::None,
    };
    let stepped = Start { hysteresis: other, ..start.clone() };
    compare(&start, &stepped, 120, &Limits { switches: 200, steps: 4000, ..Limits::default() })
}

fn long_jumps(draws: &mut Draws, tested: Tested) -> Checked {
    let start = long_flock(draws);
    let mut stepped = start.clone();
    if tested.is_altered() {
        stepped.velocities[0][0] *= rational(65, 64);
    }
    compare(&start, &stepped, 1500, &Limits { switches: 100, steps: 4000, ..Limits::default() })
}

fn step_is_equation(draws: &mut Draws, tested: Tested) -> Checked {
    let start = start(draws);
    let mut flock = new_flock(&start)?;
    let mut states = vec![(flock.positions().concat(), flock.velocities().concat())];
    let mut networks: Vec<Graph> = vec![flock.network().clone()];
    for _ in 0..6 {
        flock.step().or_fails("a step is refused")?;
        states.push((flock.positions().concat(), flock.velocities().concat()));
        networks.push(flock.network().clone());
    }
    let used = if tested.is_altered() { &networks[..6] } else { &networks[1..] };
    let matrices: Result<Vec<_>, _> = used.iter().map(|network| transition_matrix(network, &start.weights)).collect();
    let matrices = matrices.or_fails("a transition matrix is refused")?;
    for matrix in &matrices {
        StochasticMatrix::try_from(matrix).or_fails("a transition matrix is not stochastic")?;
    }
    let first = State { positions: states[0].0.clone(), velocities: states[0].1.clone() };
    let found = motion(first, flock.dimension(), &matrices).or_fails("the motion is refused")?;
    let differs = found.iter().zip(&states).position(|(a, b)| (&a.positions, &a.velocities) != (&b.0, &b.1));
    let why = format!("the state at t = {} is another one", differs.unwrap_or_default());
    require(differs.is_none(), why, || described(&start))?;
    Ok(None)
}

fn weighted_momentum(draws: &mut Draws, tested: Tested) -> Checked {
    let start = start(draws);
    let mut flock = new_flock(&start)?;
    for time in 1..=8 {
        let before = flock.velocities();
        flock.step().or_fails("a step is refused")?;
        let after = flock.velocities();
        let weights = start.weights.all(flock.network()).or_fails("a weight is missing")?;
        for k in 0..flock.dimension() {
            let total = |velocities: &[Vec<Rational>]| -> Rational {
                let term =
                    |(v, c): (&Vec<Rational>, &Rational)| if tested.is_altered() { v[k].clone() } else { &v[k] / c };
                velocities.iter().zip(&weights).map(term).sum()
            };
            let (old, new) = (total(&before), total(&after));
            require(old == new, format!("it is {old} before t = {time} and {new} after"), || described(&start))?;
        }
    }
    Ok(None)
}

fn velocities_stay_inside(draws: &mut Draws, tested: Tested) -> Checked {
    let birds = draws.between(1, 5);
    let start = flock(draws, birds, 1, 4);
    let mut flock = new_flock(&start)?;
    let skipped = usize::from(tested.is_altered() && birds > 1);
    let mut least: Option<f64> = None;
    for time in 1..=8 {
        let largest = |flock: &Flock, from: usize| flock.velocities().into_iter().skip(from).flatten().max();
        let before = largest(&flock, skipped);
        flock.step().or_fails("a step is refused")?;
        let (Some(before), Some(after)) = (before, largest(&flock, 0)) else { return Ok(None) };
        let why = format!("the largest velocity grows from {before} to {after} at t = {time}");
        require(after <= before, why, || described(&start))?;
        let margin = (before - after).to_f64();
        least = least.into_iter().chain(margin).reduce(f64::min);
    }
    Ok(least)
}
