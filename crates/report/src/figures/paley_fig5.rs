//! Figure 5 of Paley and others: twelve particles follow a reference direction that changes at the corners of a path.

use super::paley::{COLUMNS, START, Timed, end, rows, scene, start};
use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::Complex;
use ledger::CheckError;
use models::oscillator::mean;
use runs::{Experiment, ReferenceTracking};
use std::f64::consts::PI;
use std::fmt::Write;

const GAIN: f64 = -1.0;
/// A group that is within this of the reference follows it, in radians.
const TOLERANCE: f64 = 1e-2;

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let length = ReferenceTracking::STEP * ReferenceTracking::STEPS as f64;
    let mut text = format!(
        "(14), all-to-all, and the gradient of 1 - cos(th_0 - th_N) on particle N; N = 12\n\
         and w0 = 0. The paper gives K_1 < 0 and the reference phases. Chosen: K_1 = {GAIN},\n\
         legs of {length} time units, step {}, start 0 of paley.fig5.\n{START}\n\
         \x20 leg  th_0      largest |th_k - th_0|  within {TOLERANCE}  direction of R over\n\
         \x20                at the end of the leg  after        its last tenth\n",
        ReferenceTracking::STEP
    );
    let mut flight = start("paley.fig5", 0);
    let (mut trajectory, mut errors): (Vec<Timed>, Vec<(f64, f64)>) = (Vec::new(), Vec::new());
    for (leg, tracking) in ReferenceTracking::legs(GAIN, true).iter().enumerate() {
        let from = leg as f64 * length;
        let part = tracking.trajectory(flight, 4)?;
        flight = end(&part)?.clone();
        let off: Vec<(f64, f64)> = part.iter().map(|(t, flight)| (*t, tracking.error(flight))).collect();
        let settled =
            off.iter().rposition(|(_, error)| *error > TOLERANCE).map_or(0.0, |k| off[(k + 1).min(off.len() - 1)].0);
        let before = mean(&part[part.len() - 1 - part.len() / 10].1.positions)?;
        let way = mean(&flight.positions)? - &before;
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{:5}  {:+.5}  {:21.1e}  {settled:11}  {:+.5}",
            leg + 1,
            tracking.reference,
            tracking.error(&flight),
            way.im.atan2(way.re),
        );
        // At a corner the old and the new reference meet.
        trajectory.extend(part.into_iter().skip(usize::from(leg > 0)).map(|(t, flight)| (from + t, flight)));
        errors.extend(off.into_iter().map(|(t, error)| (from + t, error)));
    }
    let _ = writeln!(
        text,
        "\nThe references are pi/8 = {:.5} and -3 pi/8 = {:.5}. The group tracks them\n\
         (paley.fig5, holds): theta = th_0 1 minimises W_1 + 1 - cos(th_0 - th_N)\n\
         (paley.ref). One particle of N feels the reference, so that the group settles\n\
         at the slow rate of about |K_1|/(2N).",
        PI / 8.0,
        -3.0 * PI / 8.0
    );
    let scale = Axis::log("largest |θ_k − θ_0| (radians)").between(1e-4, 10.0);
    let error = Panel::new("tracking error", Axis::linear("time (speed 1, lengths as in the panel)"), scale)
        .series(Series::line("", errors.iter().copied()).size(1.4))
        .series(Series::dashed("0.01", [(0.0, TOLERANCE), (4.0 * length, TOLERANCE)]).size(1.0));
    let picture = Picture::new("Figure 5: a group tracks a reference direction, N = 12, ω_0 = 0, K_1 = −1")
        .caption(super::paley::SIGNS)
        .grid(2, (500.0, 420.0))
        .panel(scene("paths; the velocities are those at the end".to_string(), &trajectory, &Complex::new(0.0, 0.0))?)
        .panel(error);
    let errors = csv("t,largest_error", errors.into_iter().map(|(t, error)| [t.to_string(), format!("{error:.6e}")]));
    Ok(Reproduced::new(text)
        .table("", csv(COLUMNS, rows("all", &trajectory)))
        .table("error", errors)
        .picture("", picture))
}
