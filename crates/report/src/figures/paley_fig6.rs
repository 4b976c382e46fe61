//! Figure 6 of Paley and others: a circular formation in a drift field, without and with a beacon.

use super::paley::{COLUMNS, ORANGE, START, Timed, circle, end, pair, rows, scene, start};
use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::Complex;
use ledger::CheckError;
use models::oscillator::{Flight, centre_spread, circle_centres, mean, order, quarter_turn};
use runs::{DriftingOrbit, Experiment, OMEGA};
use std::f64::consts::TAU;
use std::fmt::Write;

const CLAIM: &str = "paley.beacon";
/// Turns over which the mean position is followed.
const TURNS: usize = 3;

/// The mean of the circle centres.
fn centre(flight: &Flight) -> Result<Complex<f64>, CheckError> {
    Ok(mean(&circle_centres(&OMEGA, &flight.state())?)?)
}

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let beacon = DriftingOrbit::BEACON;
    let mut text = format!(
        "N = 12, f = {}, w0 = K_0 = {OMEGA}, all-to-all. The caption prints K_1 > 0, a sign\n\
         slip: K_1 < 0 synchronises (paley.fig6.gain, misprint; panel c). Chosen: K_1 =\n\
         -0.1; (a), (c): the control (22); (b): (14) and, in the place of (20), w0 K_0\n\
         <e^(i th_k), c_k - c_0> of the beacon c_0 = {} (with K_0/N, which (20) becomes, the\n\
         centre settles near -14: paley.beacon); step {}, to t = {}, then\n\
         {TURNS} turns more, start 0 of {CLAIM}.\n{START}\n\
         \x20        |p_theta|  centres/radius  mean position of all over each turn\n",
        DriftingOrbit::FIELD.re,
        beacon.re,
        DriftingOrbit::STEP,
        DriftingOrbit::STEP * DriftingOrbit::STEPS as f64,
    );
    let mut picture = Picture::new("Figure 6: the synchronised circular formation in a drift field")
        .caption(super::paley::SIGNS)
        .grid(2, (520.0, 430.0));
    let mut distance = Panel::new(
        "(d) distance of the mean of the circle centres",
        Axis::linear("time (speed 1, lengths as in the panel)"),
        Axis::linear("from 10 (beacon)"),
    );
    let mut table = Vec::new();
    let settled = DriftingOrbit::around_beacon(-0.1, DriftingOrbit::GAINS[1]).settled_centre();
    let mut measured = Vec::new();
    for (panel, orbit, name) in [
        ("a", DriftingOrbit::free(-0.1), "(a) no beacon, K_1 = −0.1"),
        ("b", DriftingOrbit::around_beacon(-0.1, DriftingOrbit::GAINS[1]), "(b) beacon at 10, K_1 = −0.1"),
        ("c", DriftingOrbit::free(0.1), "(c) as (a), but K_1 = +0.1 as printed"),
    ] {
        let trajectory = orbit.trajectory(start(CLAIM, 0), 10)?;
        let mut flight = end(&trajectory)?.clone();
        let (spread, synchrony) = (centre_spread(&OMEGA, &flight.state())? * OMEGA, order(&flight, 1)?);
        let means = (0..TURNS).map(|_| Ok(orbit.turn(&mut flight)?)).collect::<Result<Vec<_>, CheckError>>()?;
        let list: Vec<String> = means.iter().map(|c| format!("{:.2}{:+.2}i", c.re, c.im)).collect();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "({panel})      {synchrony:8.6}  {spread:14.1e}  {}", list.join(", "));
        measured.push((
            means,
            centre(&flight)? - &centre(end(&trajectory)?)?,
            flight.phases[0] - end(&trajectory)?.phases[0],
        ));
        let mut scene = scene(name.to_string(), &trajectory, &DriftingOrbit::FIELD)?;
        if panel == "b" {
            scene = scene
                .series(Series::crosses("beacon", [pair(&beacon)]).colour(ORANGE))
                .series(circle(pair(&settled), 1.0 / OMEGA).colour(ORANGE));
        }
        picture = picture.panel(scene);
        if panel != "c" {
            let off = |(t, flight): &Timed| -> Result<(f64, f64), CheckError> {
                Ok((*t, (centre(flight)? - &beacon).norm_squared().sqrt()))
            };
            let name = if panel == "a" { "no beacon" } else { "beacon" };
            distance = distance
                .series(Series::line(name, trajectory.iter().map(off).collect::<Result<Vec<_>, CheckError>>()?));
        }
        table.extend(rows(panel, &trajectory));
    }
    // Whole turns at w0 in (a): the time is the angle over w0.
    let (_, carried, angle) = &measured[0];
    let time = angle / OMEGA;
    let last = &measured[1].0[TURNS - 1];
    // In a closed orbit the mean velocity is 0, so that the mean phasor is -f and the mean position that of the centres plus i f/w0.
    let turning = last.clone() - &quarter_turn(&DriftingOrbit::FIELD).scale(&(1.0 / OMEGA));
    let _ = writeln!(
        text,
        "\n(a) The mean circle centre has the velocity {:.5}{:+.5}i: that of the field\n\
         (paley.drift: the motion without drift, carried along), {:.3} in a turn.\n\
         (b) The orbit closes and its centre is fixed (paley.beacon, holds), but not at\n\
         the beacon: over a turn the circle centres c_k have the mean {:.3}{:+.3}i, which\n\
         averaging puts at c_0 + 2 f/K_0 = {} to first order; the particles have it\n\
         plus i f/w0, because their mean velocity is 0. Distance to the beacon: {:.3}.\n\
         (c) With the printed K_1 > 0 the formation is not synchronised.",
        carried.re / time,
        carried.im / time,
        TAU * DriftingOrbit::FIELD.re / OMEGA,
        turning.re,
        turning.im,
        settled.re,
        (last.clone() - &beacon).norm_squared().sqrt(),
    );
    Ok(Reproduced::new(text).table("", csv(COLUMNS, table)).picture("", picture.panel(distance)))
}
