//! Figures 5 and 6 of Tanner, Jadbabaie and Pappas, Flocking in fixed and switching networks: links within 2 m, connected and torn.

use super::tanner::{
    OBSERVED, Row, SIGNS, at, drawn, line, merged, observation_rows, observations, shares_csv, shares_text, snapshot,
    trials,
};
use super::{Reproduced, csv};
use crate::plot::{Axis, PALETTE, Panel, Picture};
use ledger::CheckError;
use models::double_integrator::{LinkRule, Setup, Trial};
use motion::Share;

const RUNS: u64 = 100;
const UNTIL: f64 = 100.0;
/// The paper's times for Figure 5 are not in its text.
const CONNECTED: [f64; 6] = [0.0, 2.0, 5.0, 20.0, 50.0, UNTIL];
/// The times printed below the frames of Figure 6.
const TORN: [f64; 6] = [0.0, 0.589685, 1.00581, 6.11718, 24.8565, UNTIL];

fn setup(connected: bool) -> Setup {
    Setup::velocity_alignment(LinkRule::Within { radius: Setup::RADIUS, connected })
}

fn is_connected(trial: &&Trial) -> bool {
    trial.end.components == 1
}

pub(super) fn connected() -> Result<Reproduced, CheckError> {
    let id = "tanner2.fig5";
    let mut rows = Vec::new();
    let mut shown = None;
    for (start, connected) in [("starts drawn until connected", true), ("any start", false)] {
        let trials = trials(id, &setup(connected), RUNS, UNTIL, None)?;
        let whole: Vec<&Trial> = trials.iter().filter(is_connected).collect();
        let all = |passes: &dyn Fn(&Trial) -> bool| Share::count(&trials, passes);
        rows.push(Row::new(start, "connected at the end", all(&|t| t.end.components == 1)));
        rows.push(Row::new(start, "connected all the time", all(&|t| t.stayed_connected)));
        rows.push(Row::new(start, "all velocities agree (to 1/100)", all(&|t| t.agrees(0.01))));
        rows.push(Row::new(start, "and at least half of all links", all(&|t| is_as_drawn(t))));
        let given = format!("{start}, of the runs that end connected");
        rows.push(Row::new(&given, "all velocities agree (to 1/100)", Share::count(&whole, |t| t.agrees(0.01))));
        rows.push(Row::new(&given, "and at least half of all links", Share::count(&whole, |t| is_as_drawn(t))));
        rows.push(Row::new(&given, "all pairs linked", Share::count(&whole, |t| t.end.links == t.end.pairs)));
        if connected {
            shown = trials.iter().position(|t| t.stayed_connected && is_as_drawn(t) && t.end.links < t.end.pairs);
        }
    }
    draw(id, true, shown.unwrap_or(0) as u64, "5: links within 2 m, connected", &CONNECTED, &rows)
}

/// What Figure 5 is said to show at its end.
fn is_as_drawn(trial: &Trial) -> bool {
    trial.end.components == 1 && trial.agrees(0.01) && trial.end.density() >= 0.5
}

pub(super) fn torn() -> Result<Reproduced, CheckError> {
    let id = "tanner2.fig6";
    let mut rows = Vec::new();
    let mut shown = None;
    for (start, connected) in [("any start", false), ("starts drawn until connected", true)] {
        let trials = trials(id, &setup(connected), RUNS, UNTIL, None)?;
        let parts: Vec<&Trial> = trials.iter().filter(|t| t.end.components > 1).collect();
        rows.push(Row::new(start, "several components at the end", Share::count(&trials, |t| t.end.components > 1)));
        rows.push(Row::new(start, "that agree within themselves (to 1/100)", Share::count(&trials, is_torn)));
        let given = format!("{start}, of the runs with several components");
        rows.push(Row::new(&given, "that agree within themselves (to 1/100)", Share::count(&parts, |t| is_torn(t))));
        if connected {
            // The figure starts connected.
            shown = trials.iter().position(is_torn);
        }
    }
    draw(id, true, shown.unwrap_or(0) as u64, "6: loss of connectivity", &TORN, &rows)
}

fn is_torn(trial: &Trial) -> bool {
    trial.end.components > 1 && trial.components_agree(0.01)
}

fn draw(
    id: &str,
    connected: bool,
    replicate: u64,
    title: &str,
    times: &[f64],
    rows: &[Row],
) -> Result<Reproduced, CheckError> {
    let flock = drawn(id, &setup(connected), replicate)?;
    let (motion, observations) = observations(&flock, &merged((0..500).map(|k| 0.2 * f64::from(k)), times))?;
    let mut picture = Picture::new(format!("Figure {title}")).caption(SIGNS).grid(3, (350.0, 330.0));
    for sample in times.iter().filter_map(|time| at(&motion, *time)) {
        picture = picture.panel(snapshot(format!("t = {} s", sample.time), sample, true));
    }
    let time = || Axis::linear("time (s)").between(0.0, UNTIL);
    picture = picture
        .panel(
            Panel::new("velocities", time(), Axis::log("disagreement (m/s)"))
                .series(line("of all", PALETTE[0], &observations, |o| o.disagreement))
                .series(line("within a component", PALETTE[1], &observations, |o| o.component_disagreement)),
        )
        .panel(
            Panel::new("network", time(), Axis::log("number").between(0.8, 60.0))
                .series(line("links", PALETTE[2], &observations, |o| o.links as f64))
                .series(line("components", PALETTE[3], &observations, |o| o.components as f64)),
        )
        .panel(
            Panel::new("energy", time(), Axis::linear("Q, sum of potentials"))
                .series(line("Q, equation (11)", PALETTE[3], &observations, |o| o.energy))
                .series(line("potential of the links", PALETTE[2], &observations, |o| o.potential)),
        );
    let switches = motion.events.len();
    let monotone = if motion.energy.is_monotone() { "falls" } else { "DOES NOT FALL" };
    let end = observations.last().map_or(String::new(), |o| {
        format!(
            "{} component(s), {} of {} links,\n  disagreement {:.1e} m/s (within components {:.1e}), heading spread {:.2},\n  least distance {:.3} m, Q = {:.4}",
            o.components, o.links, o.pairs, o.disagreement, o.component_disagreement, o.heading_spread, o.least_distance, o.energy
        )
    });
    let text = format!(
        "Ten agents, law (4), links within 2 m; uniform positions in a square of side\n\
         5 m, speeds in (0, 1) m/s and directions; {UNTIL} s. Chosen: V = 1/s + log s; starts\n\
         are any, or drawn again until their network is connected. {RUNS} runs each,\n\
         Wilson 95% intervals. Agreement: against the disagreement at the start.\n\n\
         {}\n\
         Drawn: run {replicate} from a connected start. At its end: {end}.\n\
         {switches} switches, each located; Q {monotone}, within rounding and tolerance.\n",
        shares_text(rows)
    );
    Ok(Reproduced::new(text)
        .table("shares", shares_csv(rows))
        .table("time-series", csv(OBSERVED, observation_rows("switching", &observations)))
        .picture("", picture))
}
