//! What the figures of the two papers of Tanner, Jadbabaie and Pappas share: runs, snapshots, observations over time, shares.

use super::csv;
use crate::plot::{Axis, Colour, Panel, Series};
use arithmetic::Unwatched;
use arithmetic::random::generator;
use arithmetic::threads::side_by_side;
use ledger::{CheckError, Options};
use models::double_integrator::{Flock, Motion, Observation, Sample, Setup, Trial, Vector};
use motion::Share;

const BREAK: (f64, f64) = (f64::NAN, f64::NAN);

pub(super) fn other(error: impl std::fmt::Display) -> CheckError {
    CheckError::Other(error.to_string())
}

/// The flock that the claim of this id draws for a replicate.
pub(super) fn drawn(id: &str, setup: &Setup, replicate: u64) -> Result<Flock, CheckError> {
    setup.draw(&mut generator(&Options::default().seed, id, replicate)).map_err(other)
}

/// The runs of the claim of this id, and more of the same kind.
pub(super) fn trials(
    id: &str,
    setup: &Setup,
    runs: u64,
    until: f64,
    every: Option<f64>,
) -> Result<Vec<Trial>, CheckError> {
    let trial = |&replicate: &u64| drawn(id, setup, replicate)?.trial(until, every, &Setup::OPTIONS).map_err(other);
    let replicates: Vec<u64> = (0..runs).collect();
    side_by_side(&replicates, trial).into_iter().collect()
}

/// A motion with what is seen of it at its samples.
pub(super) fn observations(flock: &Flock, times: &[f64]) -> Result<(Motion, Vec<Observation>), CheckError> {
    let until = times.last().copied().unwrap_or(0.0);
    let motion = flock.run(until, times, &Setup::OPTIONS, &Unwatched).map_err(other)?;
    let seen = motion.samples.iter().map(|sample| Observation::of(sample, flock.potential()));
    let seen = seen.collect::<Result<_, _>>()?;
    Ok((motion, seen))
}

/// The sample at a time that was asked for.
pub(super) fn at(motion: &Motion, time: f64) -> Option<&Sample> {
    motion.samples.iter().find(|sample| sample.time == time)
}

/// Times in order, without repetitions.
pub(super) fn merged(a: impl IntoIterator<Item = f64>, b: &[f64]) -> Vec<f64> {
    let mut all: Vec<f64> = a.into_iter().chain(b.iter().copied()).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// One row of a table of shares.
pub(super) struct Row {
    /// The runs.
    pub setting: String,
    /// What is counted.
    pub statement: &'static str,
    pub share: Share,
}

impl Row {
    pub(super) fn new(setting: impl Into<String>, statement: &'static str, share: Share) -> Self {
        Row { setting: setting.into(), statement, share }
    }
}

pub(super) fn shares_csv(rows: &[Row]) -> String {
    csv(
        "setting,statement,found,runs,share,low_95,high_95",
        rows.iter().map(|row| {
            let (low, high) = row.share.interval();
            let quoted = |text: &str| format!("\"{text}\"");
            [
                quoted(&row.setting),
                quoted(row.statement),
                row.share.found.to_string(),
                row.share.of.to_string(),
                format!("{:.4}", row.share.value()),
                format!("{low:.4}"),
                format!("{high:.4}"),
            ]
        }),
    )
}

/// The rows as text, each setting once, within 80 columns.
pub(super) fn shares_text(rows: &[Row]) -> String {
    let mut text = String::new();
    let mut last = "";
    for row in rows {
        if row.setting != last {
            text.push_str(&format!("{}\n", row.setting));
            last = &row.setting;
        }
        text.push_str(&format!("  {:42} {}\n", row.statement, row.share));
    }
    text
}

pub(super) const OBSERVED: &str = "run,time,disagreement,component_disagreement,heading_spread,least_distance,least_unlinked,radius,largest_gradient,potential,energy,components,links";

pub(super) fn observation_rows<'a>(
    name: &'a str,
    observations: &'a [Observation],
) -> impl Iterator<Item = Vec<String>> + 'a {
    observations.iter().map(move |seen| {
        let numbers = [
            seen.time,
            seen.disagreement,
            seen.component_disagreement,
            seen.heading_spread,
            seen.least_distance,
            seen.least_unlinked,
            seen.radius,
            seen.gradient,
            seen.potential,
            seen.energy,
        ];
        let mut row = vec![name.to_string()];
        row.extend(numbers.map(|x| format!("{x:.6e}")));
        row.extend([seen.components.to_string(), seen.links.to_string()]);
        row
    })
}

/// A quantity of a run over time.
pub(super) fn line(
    name: &str,
    colour: Colour,
    observations: &[Observation],
    quantity: impl Fn(&Observation) -> f64,
) -> Series {
    Series::line(name, observations.iter().map(|seen| (seen.time, quantity(seen)))).colour(colour)
}

/// What the signs of [`snapshot`] mean.
pub(super) const SIGNS: &str = "Discs: agents; orange: velocities, drawn to the scale of each picture; grey: links.";

/// Positions relative to their mean, links, and velocities as lines whose longest is a sixth of the picture.
pub(super) fn snapshot(title: String, sample: &Sample, links: bool) -> Panel {
    let state = &sample.state;
    let count = state.count().max(1) as f64;
    let mean = [0, 1].map(|k| state.positions.iter().map(|r| r[k]).sum::<f64>() / count);
    let place = |r: &Vector<f64>| (r[0] - mean[0], r[1] - mean[1]);
    let size = state.positions.iter().map(|r| place(r).0.abs().max(place(r).1.abs())).fold(0.5, f64::max);
    let speed = state.velocities.iter().map(|v| v[0].hypot(v[1])).fold(1e-12, f64::max);
    let factor = 2.0 * size / (6.0 * speed);
    let arrows = state.positions.iter().zip(&state.velocities).flat_map(|(r, v)| {
        let (x, y) = place(r);
        [(x, y), (x + factor * v[0], y + factor * v[1]), BREAK]
    });
    let joined = sample.links.iter().filter(|_| links);
    let joined = joined.flat_map(|&(i, j)| [place(&state.positions[i]), place(&state.positions[j]), BREAK]);
    let axis = |label: &str| Axis::linear(label).between(-1.4 * size, 1.4 * size);
    Panel::new(title, axis("x − mean (m)"), axis("y − mean (m)"))
        .equal_scales()
        .series(Series::line("", joined).colour("#b8c4cc").size(0.8))
        .series(Series::line("", arrows).colour("#d1580b").size(1.4))
        .series(Series::points("", state.positions.iter().map(place)).colour("#1d2b36").size(3.0))
}
