//! What the figures of Paley and others share: starts, scenes in the plane, tables of states.

use crate::plot::{Axis, Panel, Series};
use arithmetic::random::generator;
use arithmetic::{ArithmeticError, Complex};
use ledger::{CheckError, Options};
use models::angles::within_a_turn;
use models::oscillator::{Flight, Zones, mean};
use runs::{Experiment, random_start};
use std::f64::consts::{PI, TAU};

pub(super) const RED: &str = "#c22f2f";
pub(super) const BLACK: &str = "#222222";
pub(super) const GREY: &str = "#b4bfc6";
pub(super) const BLUE: &str = "#0b5fa5";
pub(super) const ORANGE: &str = "#d1580b";
pub(super) const GREEN: &str = "#138a5e";

/// What the text of every run says about its start.
pub(super) const START: &str = "Classical Runge-Kutta with fixed step; at the start positions are uniform in a\n\
     square of half-width 10 around 0 and phases uniform.\n";

/// What the signs of [`scene`] mean.
pub(super) const SIGNS: &str = "Discs and black arrows: particles and velocities; grey: paths; cross and blue arrow: centre of \
     mass and its velocity. The unit of length is the way at unit speed in a unit of time.";

/// A state with its time.
pub(super) type Timed = (f64, Flight);

/// The start that the claim of this id uses for the replicate.
pub(super) fn start(claim: &str, replicate: u64) -> Flight {
    random_start(&mut generator(&Options::default().seed, claim, replicate))
}

/// The first replicate of the claim whose run ends as wanted, with the run; at most `most` are tried.
pub(super) fn first_run<E: Experiment>(
    experiment: &E,
    claim: &str,
    (every, most): (usize, u64),
    wanted: impl Fn(&Flight) -> Result<bool, CheckError>,
) -> Result<(u64, Vec<Timed>), CheckError> {
    for replicate in 0..most {
        let trajectory = experiment.trajectory(start(claim, replicate), every)?;
        if wanted(end(&trajectory)?)? {
            return Ok((replicate, trajectory));
        }
    }
    Err(CheckError::Other(format!("none of {most} runs of {claim} ended as the figure shows")))
}

/// The last state of a trajectory.
pub(super) fn end(trajectory: &[Timed]) -> Result<&Flight, CheckError> {
    trajectory.last().map(|(_, flight)| flight).ok_or_else(|| CheckError::Other("a run without states".to_string()))
}

pub(super) fn pair(z: &Complex<f64>) -> (f64, f64) {
    (z.re, z.im)
}

/// Particles at the end of a trajectory with their velocities and paths, the centre of mass with its velocity, as in the figures of the paper.
/// `drift` is added to all velocities.
pub(super) fn scene(title: String, trajectory: &[Timed], drift: &Complex<f64>) -> Result<Panel, CheckError> {
    let last = end(trajectory)?;
    let state = last.state();
    let points = || trajectory.iter().flat_map(|(_, flight)| flight.positions.iter());
    let (mut low, mut high) = ((f64::INFINITY, f64::INFINITY), (f64::NEG_INFINITY, f64::NEG_INFINITY));
    for r in points() {
        (low, high) = ((low.0.min(r.re), low.1.min(r.im)), (high.0.max(r.re), high.1.max(r.im)));
    }
    // A unit of speed is drawn as a share of the width of the picture.
    let unit = 0.1 * (high.0 - low.0).max(high.1 - low.1);
    let mut panel = Panel::new(title, Axis::linear("x"), Axis::linear("y")).equal_scales();
    for k in 0..last.positions.len() {
        panel = panel.series(Series::line("", path(trajectory, k, drift)).colour(GREY).size(0.7));
    }
    let arrow = |r: &Complex<f64>, v: Complex<f64>| (pair(r), pair(&(v.scale(&unit) + r)));
    let velocities = state.positions.iter().zip(&state.phasors).map(|(r, z)| arrow(r, z.clone() + drift));
    let centre = mean(&state.positions)?;
    let moving = arrow(&centre, mean(&state.phasors)? + drift);
    Ok(panel
        .series(Series::arrows("", velocities).colour(BLACK).size(1.0))
        .series(Series::points("", state.positions.iter().map(pair)).colour(RED))
        .series(Series::arrows("", [moving]).colour(BLUE).size(1.8))
        .series(Series::crosses("", [pair(&centre)]).colour(BLUE)))
}

/// The path of a particle, smooth between the states that are kept: a cubic through places and velocities (Hermite).
fn path(trajectory: &[Timed], particle: usize, drift: &Complex<f64>) -> Vec<(f64, f64)> {
    const PARTS: u32 = 8;
    let at = |flight: &Flight| {
        let (sin, cos) = flight.phases[particle].sin_cos();
        (pair(&flight.positions[particle]), (cos + drift.re, sin + drift.im))
    };
    let mut points: Vec<(f64, f64)> = trajectory.first().map(|(_, flight)| at(flight).0).into_iter().collect();
    for step in trajectory.windows(2) {
        let [(from, before), (to, after)] = step else { continue };
        let (((x0, y0), (u0, v0)), ((x1, y1), (u1, v1)), h) = (at(before), at(after), to - from);
        points.extend((1..=PARTS).map(|k| {
            let s = f64::from(k) / f64::from(PARTS);
            let r = 1.0 - s;
            let (a, b, c, d) = ((1.0 + 2.0 * s) * r * r, s * r * r * h, s * s * (3.0 - 2.0 * s), -s * s * r * h);
            (a * x0 + b * u0 + c * x1 + d * u1, a * y0 + b * v0 + c * y1 + d * v1)
        }));
    }
    points
}

/// Rows of a CSV table with the header [`COLUMNS`].
pub(super) fn rows<'a>(panel: &'a str, trajectory: &'a [Timed]) -> impl Iterator<Item = Vec<String>> + 'a {
    trajectory.iter().flat_map(move |(t, flight)| {
        flight.positions.iter().zip(&flight.phases).enumerate().map(move |(k, (r, theta))| {
            let numbers = [r.re, r.im, within_a_turn(*theta)].map(|x| format!("{x:.6}"));
            [panel.to_string(), format!("{t:.3}"), (k + 1).to_string()].into_iter().chain(numbers).collect()
        })
    })
}

/// The header of [`rows`].
pub(super) const COLUMNS: &str = "panel,t,particle,x,y,theta";

/// A dashed circle.
pub(super) fn circle(centre: (f64, f64), radius: f64) -> Series {
    let point = |k: u32| {
        let (sin, cos) = (TAU * f64::from(k) / 120.0).sin_cos();
        (centre.0 + radius * cos, centre.1 + radius * sin)
    };
    Series::dashed("", (0..=120).map(point)).size(0.8)
}

/// The outline of the zone between two radii around a fish, without its blind spot.
pub(super) fn zone_outline(
    zones: &Zones<f64>,
    (inner, outer): (f64, f64),
    at: &Complex<f64>,
    heading: f64,
) -> Vec<(f64, f64)> {
    const STEPS: u32 = 90;
    // Half of the angle that is seen.
    let half = PI - zones.blind_cosine_squared.sqrt().acos();
    let arc = |radius: f64| {
        (0..=STEPS).map(move |k| {
            let (sin, cos) = (heading - half + 2.0 * half * f64::from(k) / f64::from(STEPS)).sin_cos();
            (at.re + radius * cos, at.im + radius * sin)
        })
    };
    arc(outer).chain(arc(inner).rev()).collect()
}

/// The largest difference between a rate of turning and `omega`.
pub(super) fn turning_error(omega: f64, steering: &[f64]) -> f64 {
    steering.iter().map(|u| (u - omega).abs()).fold(0.0, f64::max)
}

/// The largest `|p_m|` with `m` below `clusters`, times `m`: 0 in an (M,N)-pattern.
pub(super) fn largest_lower_moment(flight: &Flight, clusters: usize) -> Result<f64, ArithmeticError> {
    let mut moments = (1..clusters as u32).map(|m| models::oscillator::order(flight, m));
    moments.try_fold(0.0, |largest: f64, p| Ok(largest.max(p?)))
}
