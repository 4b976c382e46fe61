//! Figures 3 to 6 and 7 to 10 of Tanner, Jadbabaie and Pappas, part I: heading alignment on complete and incomplete graphs.

use super::tanner::{
    OBSERVED, Row, SIGNS, at, drawn, line, merged, observation_rows, observations, shares_csv, shares_text, snapshot,
    trials,
};
use super::{Reproduced, csv};
use crate::plot::{Axis, Colour, PALETTE, Panel, Picture};
use ledger::CheckError;
use models::double_integrator::{HeadingReading, Observation, Setup, Trial};
use motion::Share;

const RUNS: u64 = 40;
const UNTIL: f64 = 200.0;
/// For the four pictures: initial configuration, converging to a common heading, approaching a potential minimum, steady state.
const TIMES: [f64; 4] = [0.0, 2.0, 10.0, UNTIL];
/// Headings (radians), gradients, radius (m) of a formation.
const FORMATION: (f64, f64, f64) = (0.1, 0.1, 10.0);

/// What the signs mean where links say nothing.
const ALL_LINKED: &str = "Discs: agents; orange: velocities, drawn to the scale of each picture. All pairs are linked.";
/// What the legend means.
const CURVES: &str = "Curves: this run in three readings. m/s: the largest speed at the start; logarithm: V = 1/s + log s, as printed \
                      with 20 m/s; spring: V = s + 1/s − 2; s: the squared distance.";

pub(super) fn complete() -> Result<Reproduced, CheckError> {
    reproduce(true)
}

pub(super) fn incomplete() -> Result<Reproduced, CheckError> {
    reproduce(false)
}

fn colour(reading: HeadingReading) -> Colour {
    match reading {
        HeadingReading::Printed => PALETTE[1],
        HeadingReading::Spring => PALETTE[0],
        HeadingReading::Slow => PALETTE[2],
    }
}

fn is_formation(trial: &Trial) -> bool {
    trial.end.is_formation(FORMATION.0, FORMATION.1, FORMATION.2)
}

fn reproduce(complete: bool) -> Result<Reproduced, CheckError> {
    let (id, figures, first) =
        if complete { ("tanner1.figs3_6", "3 to 6", 3) } else { ("tanner1.figs7_10", "7 to 10", 7) };
    let (mut rows, mut ends) = (Vec::new(), String::new());
    let mut shown = 0;
    for reading in HeadingReading::ALL {
        let setup = Setup::heading_alignment(complete, reading);
        let trials = trials(id, &setup, RUNS, UNTIL, None)?;
        let count = |passes: &dyn Fn(&Trial) -> bool| Share::count(&trials, passes);
        let name = reading.describe();
        rows.push(Row::new(name, "common heading", count(&|t| t.end.heading_spread < FORMATION.0)));
        rows.push(Row::new(name, "and tight, at a potential minimum", count(&is_formation)));
        let median = |quantity: fn(&Trial) -> f64| {
            let mut all: Vec<f64> = trials.iter().map(quantity).collect();
            all.sort_by(f64::total_cmp);
            all[all.len() / 2]
        };
        ends.push_str(&format!(
            " {name:36} {:8.2e} {:9.2e} {:6.1} {:8.1e} {:6.0e}\n",
            median(|t| t.end.heading_spread),
            median(|t| t.end.disagreement),
            median(|t| t.end.radius),
            median(|t| t.end.gradient),
            median(|t| ((t.end.energy - t.start.energy) / t.start.energy).abs()),
        ));
        if reading == HeadingReading::Spring {
            shown = trials.iter().position(is_formation).unwrap_or(0) as u64;
        }
    }
    let (picture, runs) = draw(complete, id, figures, first, shown)?;
    let text = format!(
        "Ten agents, {} graph, law (4), (5). Printed:\n\
         positions and velocities in a ball of radius 20. Chosen: all drawn evenly; the\n\
         potential; raw differences of headings (2){}; {UNTIL} s.\n\
         Common heading: largest difference below {}; minimum: all |grad V_i| below {};\n\
         tight: all within {} m of the mean. {RUNS} runs each, Wilson 95% intervals.\n\n\
         {}\n\
         medians after {UNTIL} s                   headings disagreem. radius gradient energy\n\
         \x20                                        (rad)     (m/s)    (m)           drift\n\
         {ends}\n\
         With the numbers and the potential as printed the flock scatters over\n\
         kilometres: alignment does no work, and 1/s + log s can store the energy of\n\
         speeds up to 20 m/s only at distances of hundreds of kilometres. Both other\n\
         readings show the figures. Drawn: run {shown}; pictures with V = s + 1/s - 2 and\n\
         speeds up to 20 m/s.\n",
        if complete { "complete" } else { "random connected incomplete" },
        if complete { "" } else { ";\neach edge with probability 1/2" },
        FORMATION.0,
        FORMATION.1,
        FORMATION.2,
        shares_text(&rows),
    );
    Ok(Reproduced::new(text)
        .table("shares", shares_csv(&rows))
        .table("time-series", csv(OBSERVED, runs))
        .picture("", picture))
}

/// Four snapshots, and quantities over time in all readings.
fn draw(
    complete: bool,
    id: &str,
    figures: &str,
    first: usize,
    replicate: u64,
) -> Result<(Picture, Vec<Vec<String>>), CheckError> {
    let kind = if complete { "complete" } else { "incomplete" };
    let mut picture =
        Picture::new(format!(
            "Figures {figures}: headings align, {kind} graph, ten agents. Run {replicate}; snapshots with V = s + 1/s − 2, up to 20 m/s"
        ))
        .caption(if complete { ALL_LINKED } else { SIGNS })
        .caption(CURVES)
        .grid(2, (430.0, 330.0));
    let mut runs = Vec::new();
    // Equal ratios from 1/10 s on.
    let times = merged((0..400).map(|k| 0.1 * (UNTIL / 0.1).powf(f64::from(k) / 400.0)), &TIMES);
    for reading in HeadingReading::ALL {
        let flock = drawn(id, &Setup::heading_alignment(complete, reading), replicate)?;
        let (motion, seen) = observations(&flock, &times)?;
        if reading == HeadingReading::Spring {
            for (k, sample) in TIMES.iter().filter_map(|time| at(&motion, *time)).enumerate() {
                let title = format!("Figure {}: t = {} s", first + k, sample.time);
                picture = picture.panel(snapshot(title, sample, !complete));
            }
        }
        runs.push((reading, seen));
    }
    let over_time = |title: &str, axis: Axis, quantity: fn(&Observation) -> f64| {
        let time = Axis::log("time (s)").between(0.1, UNTIL);
        runs.iter().fold(Panel::new(title, time, axis), |panel, (reading, observations)| {
            panel.series(line(reading.name(), colour(*reading), observations, quantity))
        })
    };
    picture = picture
        .panel(over_time("heading spread", Axis::linear("largest difference (rad)"), |o| o.heading_spread))
        .panel(over_time("velocities", Axis::log("disagreement (m/s)"), |o| o.disagreement))
        .panel(over_time("distances", Axis::log("least distance of all pairs (m)"), |o| o.least_distance))
        .panel(over_time("size", Axis::log("radius of the flock (m)"), |o| o.radius))
        .panel(over_time("potential", Axis::log("sum of all V_ij"), |o| o.potential))
        .panel(over_time("forces", Axis::log("largest |grad V_i|"), |o| o.gradient));
    let rows = runs.iter().flat_map(|(reading, observations)| {
        observation_rows(
            match reading {
                HeadingReading::Printed => "printed",
                HeadingReading::Spring => "spring",
                HeadingReading::Slow => "slow",
            },
            observations,
        )
    });
    let rows = rows.collect();
    Ok((picture, rows))
}
