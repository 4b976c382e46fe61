//! tanner1.figs3_6, figs7_10: the simulations of Section V, over many seeds.
//!
//! Declared, since the paper does not give it: the printed potential; positions even in the disc of radius 20 m; a radius in
//! metres says nothing of speeds, so velocities are even in the disc of 1 m/s, the range of the companion paper; headings
//! and their differences as in (2), not wrapped; random incomplete graphs with each edge present with probability 1/2, drawn
//! until connected; 200 s. A common heading is a largest wrapped difference below 1/10; a potential energy minimum shows in
//! every `|grad V_i|` below 1/10.

use super::line::potential;
use crate::arithmetic::{ArithmeticError, wilson_interval};
use crate::claims::record::Record;
use crate::claims::tanner2::figures::random_connected;
use crate::double_integrator::{
    Coordinates, HeadingDifference, State, Stepper, Vector, gyroscopic, heading, potential_gradients,
};
use crate::graph::Graph;
use crate::ledger::{CheckError, Evidence, Grade, Outcome, Run};
use crate::simulate::uniform;
use rand_chacha::ChaCha8Rng;

const AGENTS: usize = 10;
const RADIUS: f64 = 20.0;
const SPEED: f64 = 1.0;
const PLANE: Coordinates = Coordinates::Cartesian;

/// The runs and what is claimed of them.
#[derive(Clone, Copy)]
pub struct FigureVariant {
    complete: bool,
    /// Largest initial speed.
    speed: f64,
    difference: HeadingDifference,
    until: f64,
    heading: f64,
    gradient: f64,
    /// The interval of the share has to lie above this.
    above: f64,
}

fn disc(count: usize, radius: f64, random: &mut ChaCha8Rng) -> Vec<Vector<f64>> {
    let mut even = || uniform(random);
    let mut point = || {
        let (size, angle) = (radius * even().sqrt(), std::f64::consts::TAU * even());
        [size * angle.cos(), size * angle.sin()]
    };
    (0..count).map(|_| point()).collect()
}

/// The largest wrapped difference of two headings and the largest gradient at the end of a run.
fn simulate(variant: &FigureVariant, random: &mut ChaCha8Rng) -> Result<(f64, f64), CheckError> {
    let graph = if variant.complete { Graph::from_fn(AGENTS, |_, _| true) } else { random_connected(AGENTS, random) };
    let edges = graph.edges();
    let slope = potential().slope_over(&1.0);
    let start = State { positions: disc(AGENTS, RADIUS, random), velocities: disc(AGENTS, variant.speed, random) };
    let gradients = |state: &State<f64>| potential_gradients(&state.positions, &edges, PLANE, |_, _, s| slope.at(s));
    let law = |state: &State<f64>| {
        let angles: Result<Vec<f64>, ArithmeticError> = state.velocities.iter().map(heading).collect();
        let angles = angles?;
        gyroscopic(state, &gradients(state)?, &edges, |i, j| variant.difference.read(angles[i] - angles[j]))
    };
    let end = Stepper { tolerance: 1e-5, ..Stepper::default() }
        .run(&start, variant.until, law, |_, _| ())
        .map_err(|e| CheckError::Other(e.to_string()))?;
    let mut spread: f64 = 0.0;
    for v in &end.velocities {
        for w in &end.velocities {
            spread = spread.max(HeadingDifference::Wrapped.read(heading(v)? - heading(w)?).abs());
        }
    }
    let push = gradients(&end)?.iter().map(|g| PLANE.square(g).sqrt()).fold(0.0, f64::max);
    Ok((spread, push))
}

fn examine(variant: &FigureVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let total = run.cases(6, 100);
    let (mut hits, mut headings) = (0, 0);
    for seed in 0..total {
        run.checkpoint()?;
        let (spread, push) = simulate(variant, &mut run.random(seed as u64))?;
        headings += usize::from(spread < variant.heading);
        hits += usize::from(spread < variant.heading && push < variant.gradient);
    }
    let ((lo, hi), (low, high)) = (wilson_interval(hits, total), wilson_interval(headings, total));
    run.value("share", format!("~{:.4}", hits as f64 / total as f64));
    run.value("share_headings", format!("~{:.4}", headings as f64 / total as f64));
    let what = format!(
        "speeds up to {} m/s, {} s: common heading and potential minimum in {hits} of {total} runs, share {lo:.2} to {hi:.2} (95%); common heading in {headings}, share {low:.2} to {high:.2}",
        variant.speed, variant.until
    );
    let evidence = Evidence::new(Grade::Simulated, "end of the run", what.clone()).cases(total);
    if hits > 0 && lo > variant.above {
        return Ok(Outcome::Holds(vec![evidence]));
    }
    Ok(Outcome::Fails { counterexample: what, evidence: vec![evidence] })
}

const PRINTED: FigureVariant = FigureVariant {
    complete: true,
    speed: SPEED,
    difference: HeadingDifference::Raw,
    until: 200.0,
    heading: 0.1,
    gradient: 0.1,
    above: 0.5,
};

pub fn complete() -> Record<FigureVariant> {
    Record::new(
        "tanner1.figs3_6",
        "Ten agents, complete graph: typical if more than half of all runs end with a common heading and small gradients. Energy is constant, so this is a matter of where it goes: into the common motion, in these runs. With velocities in a disc of 20 m/s the flock scatters \
         instead, and no run agrees after 200 s: see the control.",
        PRINTED,
        examine,
    )
    .control("speeds up to 20 m/s", FigureVariant { speed: RADIUS, ..PRINTED })
    .control("after 5 s", FigureVariant { until: 5.0, ..PRINTED })
}

pub fn incomplete() -> Record<FigureVariant> {
    let printed = FigureVariant { complete: false, above: 0.0, ..PRINTED };
    Record::new(
        "tanner1.figs7_10",
        "Ten agents, random connected incomplete graphs: flocking \"can still be established\" is read as a positive share of runs; about half of them are there after 200 s.",
        printed,
        examine,
    )
    .control("speeds up to 20 m/s", FigureVariant { speed: RADIUS, ..printed })
    .control("after 5 s", FigureVariant { until: 5.0, ..printed })
}
