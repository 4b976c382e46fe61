//! Figure 4 of Tanner, Jadbabaie and Pappas, Flocking in fixed and switching networks: a fixed random network; and how often agents without link
//! come close.

use super::tanner::{
    OBSERVED, Row, SIGNS, at, drawn, line, merged, observation_rows, observations, shares_csv, shares_text, snapshot,
    trials,
};
use super::{Reproduced, csv};
use crate::plot::{Axis, PALETTE, Panel, Picture};
use ledger::CheckError;
use models::double_integrator::{LinkRule, Setup, Trial};
use motion::Share;

const ID: &str = "tanner2.fig4";
/// The times printed below the frames.
const TIMES: [f64; 6] = [0.0, 2.22842, 5.21464, 22.8931, 55.0766, 100.0];
/// Edge probabilities.
const DENSITIES: [f64; 5] = [0.2, 0.35, 0.5, 0.7, 1.0];
const RUNS: u64 = 40;
/// Closer than this, in metres, is a collision for the table.
const COLLISION: f64 = 0.1;
/// Time between samples.
const EVERY: f64 = 0.1;

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let until = TIMES[TIMES.len() - 1];
    let mut rows = Vec::new();
    let mut shown = None;
    for density in DENSITIES {
        let trials = trials(ID, &Setup::velocity_alignment(LinkRule::Random(density)), RUNS, until, Some(EVERY))?;
        let links = trials.iter().map(|t| t.end.links).sum::<usize>() as f64 / trials.len() as f64;
        let setting = format!("edge probability {density}: {links:.1} of 45 links on average");
        let count = |passes: &dyn Fn(&Trial) -> bool| Share::count(&trials, passes);
        let apart = trials.iter().filter(|t| t.start.least_distance >= COLLISION);
        rows.push(Row::new(&setting, "velocities agree (to 1/100)", count(&|t| t.agrees(0.01))));
        rows.push(Row::new(
            &setting,
            "a pair comes closer than 0.1 m (*)",
            Share::count(apart, |t| t.closest < COLLISION),
        ));
        rows.push(Row::new(
            &setting,
            "some pair closer than 0.1 m at the end",
            count(&|t| t.end.least_distance < COLLISION),
        ));
        rows.push(Row::new(
            &setting,
            "two without link within 0.25 m at the end",
            count(&|t| t.end.least_unlinked < 0.25),
        ));
        if density == 0.5 {
            shown = trials.iter().position(|t| t.agrees(0.01) && t.end.least_unlinked < 0.25);
        }
    }
    let shown = shown.unwrap_or(0) as u64;
    let flock = drawn(ID, &Setup::velocity_alignment(LinkRule::Random(0.5)), shown)?;
    let (motion, observations) = observations(&flock, &merged((0..500).map(|k| 0.2 * f64::from(k)), &TIMES))?;
    let mut picture =
        Picture::new("Figure 4: ten agents on a fixed random network").caption(SIGNS).grid(3, (350.0, 330.0));
    for sample in TIMES.iter().filter_map(|time| at(&motion, *time)) {
        picture = picture.panel(snapshot(format!("t = {} s", sample.time), sample, true));
    }
    let time = || Axis::linear("time (s)").between(0.0, until);
    picture = picture
        .panel(Panel::new("velocities", time(), Axis::log("disagreement (m/s)")).series(line(
            "",
            PALETTE[0],
            &observations,
            |o| o.disagreement,
        )))
        .panel(
            Panel::new("distances", time(), Axis::log("least distance (m)"))
                .series(line("all pairs", PALETTE[0], &observations, |o| o.least_distance))
                .series(line("pairs without link", PALETTE[1], &observations, |o| o.least_unlinked)),
        )
        .panel(
            Panel::new("energy", time(), Axis::log("energy (masses 1)"))
                .series(line("sum of potentials", PALETTE[2], &observations, |o| o.potential))
                .series(line("kinetic, W less that sum", PALETTE[3], &observations, |o| o.energy - o.potential)),
        );
    let end = observations.last().map_or(String::new(), |o| {
        format!(
            "disagreement {:.1e} m/s, heading spread {:.1e},\nleast distance {:.3} m (without link {:.3} m), W = {:.4},\nlargest |grad V_i| {:.1e}",
            o.disagreement, o.heading_spread, o.least_distance, o.least_unlinked, o.energy, o.gradient
        )
    });
    let text = format!(
        "Ten agents, law (4), uniform positions in a square of side 5 m, speeds in\n\
         (0, 1) m/s and directions, links fixed, {until} s. Chosen, since the paper does\n\
         not say: V = 1/s + log s, and how graphs are drawn (each edge with a\n\
         probability, until connected). {RUNS} runs each, Wilson 95% intervals.\n\n\
         {}\n\
         (*) Of the runs with all pairs at least 0.1 m apart at the start. Agents without\n\
         link but with the same neighbours are drawn to the same place.\n\n\
         The figure's statement, velocities synchronised after {until} s, is typical. Drawn:\n\
         run {shown} with probability 1/2, the first in which two agents without link end\n\
         close. At its end: {end}\n\
         Distances between samples ({EVERY} s) by cubics; nothing here is proved.\n",
        shares_text(&rows)
    );
    Ok(Reproduced::new(text)
        .table("shares", shares_csv(&rows))
        .table("time-series", csv(OBSERVED, observation_rows("fixed", &observations)))
        .picture("", picture))
}
