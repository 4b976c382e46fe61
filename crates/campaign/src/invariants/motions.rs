//! Enclosures of motions against floats.

use super::{Checked, Invariant, OrFails, Stop, Tested, require};
use crate::draws::Draws;
use crate::strategies::{graph, positive, separated_state};
use arithmetic::{FloatInterval, Rational, rational};
use models::double_integrator::{
    Coordinates, EnclosedFlock, EnclosureError, Potential, State, follow, velocity_alignment,
};
use models::platoon::time_domain::Modes;
use models::platoon::{Communication, Gains, accelerations};
use motion::{Tolerance, integrate};
use num_traits::ToPrimitive;

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "motion.enclosure_holds_floats",
        statement: "The enclosure of a motion of aligning agents on a fixed network holds the run in floats, up to 1e-7, ten times the tolerance of \
                    that run and more than its error on these short times.",
        control: "a run in floats with a potential one part in 64 stronger",
        block: 1,
        check: enclosure,
    },
    Invariant {
        id: "motion.platoon_modes",
        statement: "The last car of a two-sided platoon behind a harmonic leader by the sum over modes is that of the run in floats, up to 1e-7.",
        control: "a run in floats with the gain f one part in 64 larger",
        block: 5,
        check: modes,
    },
];

const TOLERANCE: Tolerance = Tolerance { relative: 1e-12, absolute: 1e-12 };

/// What rounding and the step control of a run may add up to.
const SLACK: f64 = 1e-7;

fn enclosure(draws: &mut Draws, tested: Tested) -> Checked {
    let agents = draws.between(2, 4);
    let (exact, network) = (separated_state(draws, agents), graph(draws, agents));
    let potential = match draws.below(2) {
        0 => Potential::inverse_square_log(&positive(draws, 4, 2)),
        _ => Potential::inverse_square_spring(&positive(draws, 4, 2), &rational(1, 4)),
    };
    let until = 0.25 * draws.between(1, 4) as f64;
    let described = || format!("{exact:?}, links {:?}, {potential:?}, until {until}", network.edges());
    let start = exact.map(FloatInterval::from_rational);
    let flock = EnclosedFlock { potential: potential.clone(), threshold: None };
    let run = match flock.run(&start, &network.edges(), until, |_, _| {}) {
        Ok(run) => run,
        Err(EnclosureError::Validation(error)) => return Err(Stop::Undecided(error.to_string())),
        Err(error) => return Err(Stop::Fails { why: error.to_string(), instance: described() }),
    };
    let used = if tested.is_altered() { potential.times(&rational(65, 64)) } else { potential.clone() };
    let slope = used.slope_over(&1.0);
    let edges = network.edges();
    let law = |state: &State<f64>| velocity_alignment(state, &edges, Coordinates::Cartesian, |_, _, s| slope.at(s));
    let float = |x: &Rational| x.to_f64().unwrap_or(f64::NAN);
    let floats = follow(&exact.map(float), &[until], TOLERANCE, law).or_fails("no run in floats")?;
    let Some(end) = floats.last() else { return Ok(None) };
    for (enclosed, x) in run.end.to_list().iter().zip(end.to_list()) {
        let (lo, hi) = (enclosed.lo(), enclosed.hi());
        if hi - lo > 1.0 {
            return Err(Stop::Undecided("the enclosure is wider than 1".to_string()));
        }
        let slack = SLACK * x.abs().max(1.0);
        require(lo - slack <= x && x <= hi + slack, format!("{x} is not in [{lo}, {hi}]"), described)?;
    }
    Ok(None)
}

fn modes(draws: &mut Draws, tested: Tested) -> Checked {
    let followers = draws.between(1, 5);
    // No double roots: g² = 2 lambda |f| with lambda = 1 - cos needs other numbers than these.
    let gains = Gains { f: -0.37 * draws.between(1, 8) as f64, g: -0.29 * draws.between(1, 8) as f64 };
    let w = 0.31 * draws.between(1, 8) as f64;
    let until = draws.between(1, 6) as f64;
    let described = || format!("{followers} followers, {gains:?}, w = {w}, t = {until}");
    let modes = Modes::new(&gains, followers as u64).or_fails("no modes")?;
    let start = modes.behind_harmonic_leader(&w).or_fails("no motion")?;
    let found = start.last(&until).or_fails("no motion")?;
    let used = Gains { f: gains.f * if tested.is_altered() { 65.0 / 64.0 } else { 1.0 }, g: gains.g };
    let mut field = |t: f64, list: &[f64], rate: &mut [f64]| {
        let (y, u) = list.split_at(followers);
        let (leader, velocity) = ((w * t).cos(), -w * (w * t).sin());
        rate[..followers].copy_from_slice(u);
        let forces = accelerations(Communication::FrontAndBack, &used, (&leader, &velocity), y, u);
        rate[followers..].copy_from_slice(&forces);
    };
    let states = integrate(&mut field, 0.0, &vec![0.0; 2 * followers], &[until], TOLERANCE);
    let states = states.or_fails("no run in floats")?;
    let ran = states[0][followers - 1];
    let why = format!("the sum over modes gives {found}, the run {ran}");
    require((found - ran).abs() <= SLACK * ran.abs().max(1.0), why, described)?;
    Ok(None)
}
