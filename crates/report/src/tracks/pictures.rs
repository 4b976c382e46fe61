//! Pictures of an analysis, like Figures S2 and S3 of the sidebar.

use super::text::cut;
use super::{TracksReport, tables};
use crate::plot::{Axis, PALETTE, Panel, Picture, Series, literal};
use models::tracks::{Analysis, Delays, FrameMeasures, Histogram, Scale, Vector};
use std::f64::consts::PI;

const BLUE: &str = "#0b5fa5";
const RED: &str = "#c22f2f";
const GREY: &str = "#777777";

/// The period that Figure S3 shows.
const PERIOD: (f64, f64) = (30.0, 60.0);
/// Seconds of a trajectory that a snapshot shows.
const TRAIL: f64 = 5.0;

/// A title with the start of the name of the recording.
fn titled(report: &TracksReport, what: &str) -> String {
    format!("{}: {what}", literal(&cut(report.source, 40)))
}

/// The upper end of an axis of shares, a little above all of them.
fn with_room<'a>(histograms: impl IntoIterator<Item = &'a Histogram>) -> f64 {
    let largest = histograms.into_iter().flat_map(Histogram::bins).map(|bin| bin.3).fold(0.0, f64::max);
    if largest > 0.0 { 1.08 * largest } else { 1.0 }
}

/// A histogram as an outline beside those of the null models.
fn histogram_panel(title: &str, label: &str, observed: &Histogram, nulls: &[(&str, &Histogram)]) -> Panel {
    let highest = with_room([observed].into_iter().chain(nulls.iter().map(|(_, histogram)| *histogram)));
    let (low, high) = observed.range;
    let (x, y) = (Axis::linear(label).between(low, high), Axis::linear("share").between(0.0, highest));
    let name = if nulls.is_empty() { "" } else { "recording" };
    let mut panel = Panel::new(title, x, y).series(Series::line(name, observed.outline()).colour(BLUE).size(2.0));
    // Told apart without their colours, too: a dashed line and a thin one.
    for (k, (name, histogram)) in nulls.iter().enumerate() {
        panel = panel.series(match k {
            0 => Series::dashed(*name, histogram.outline()).colour("#d1580b").size(1.3),
            _ => Series::line(*name, histogram.outline()).colour(GREY).size(0.9),
        });
    }
    panel
}

/// The histogram of the difference of the scaled potentials with the null models.
pub(crate) fn difference_panel(report: &TracksReport, title: &str) -> Panel {
    let uniform = report.null.map(|null| ("independent headings", &null.uniform.histograms[2]));
    let shifted = report.null.and_then(|null| null.shifted.first());
    let shifted = shifted.map(|(kind, _, histogram)| (kind.name(), histogram));
    let nulls: Vec<_> = uniform.into_iter().chain(shifted).collect();
    histogram_panel(title, "2/(n+1) W_1: n = N−1 less n = 1", &tables::difference(report), &nulls)
}

/// The histograms of the scaled potentials for `n = N - 1` and `n = 1`.
pub(crate) fn scaled_panel(report: &TracksReport, title: &str) -> Panel {
    let [blue, red] = tables::scaled(report);
    let shares = Axis::linear("share").between(0.0, with_room([&blue, &red]));
    Panel::new(title, Axis::linear("2/(n+1) W_1").between(0.0, 1.0), shares)
        .series(Series::line("n = N−1", blue.outline()).colour(BLUE).size(2.6))
        .series(Series::line("n = 1", red.outline()).colour(RED).size(1.1))
}

pub(super) fn histograms(report: &TracksReport) -> Picture {
    let mut picture = Picture::new(titled(report, "histograms")).grid(3, (430.0, 330.0));
    for named in tables::all(report) {
        let nulls: Vec<_> = [("independent headings", &named.uniform), ("headings shifted", &named.shifted)]
            .into_iter()
            .filter_map(|(name, histogram)| Some((name, histogram.as_ref()?)))
            .collect();
        picture = picture.panel(histogram_panel("", &named.label, &named.observed, &nulls));
    }
    picture
}

/// The scaled potentials over time: the 30 s from t = 30 s where the recording has them, else all.
pub(crate) fn potential_panel(report: &TracksReport, title: &str) -> Panel {
    let analysis = report.analysis;
    let covered = analysis.groups().any(|(t, _)| t <= PERIOD.0) && analysis.groups().any(|(t, _)| t >= PERIOD.1);
    let shown = |t: f64| !covered || (PERIOD.0..=PERIOD.1).contains(&t);
    // A frame that was left out breaks the line.
    let line = |value: &dyn Fn(&models::tracks::GroupState) -> f64| -> Vec<(f64, f64)> {
        let frames = analysis.frames.iter().filter(|frame| shown(frame.time));
        frames.map(|frame| (frame.time, frame.group.as_ref().map_or(f64::NAN, value))).collect()
    };
    let potential = Axis::linear("2/(n+1) W_1").between(0.0, 1.05).ticks([0.0, 0.25, 0.5, 0.75, 1.0]);
    Panel::new(title, Axis::linear("time (s)"), potential)
        .series(Series::line("n = N−1", line(&|g| g.complete(Scale::Figure))).colour(BLUE).size(2.4))
        .series(Series::line("n = 1", line(&|g| g.single(Scale::Figure))).colour(RED).size(1.1))
}

pub(super) fn potentials(report: &TracksReport) -> Picture {
    Picture::new(titled(report, "scaled phase potentials")).panel(potential_panel(report, ""))
}

/// Polarisation, rotation and the distance to the nearest neighbour over time.
pub(super) fn order(report: &TracksReport) -> Picture {
    let (frames, b) = (&report.analysis.frames, report.analysis.choices.body_length);
    let line = |value: &dyn Fn(&FrameMeasures) -> Option<f64>| -> Vec<(f64, f64)> {
        frames.iter().map(|frame| (frame.time, value(frame).unwrap_or(f64::NAN))).collect()
    };
    let nearest = line(&|frame| Some(frame.mean_distance()? / b));
    let farthest = nearest.iter().map(|(_, d)| *d).filter(|d| d.is_finite()).fold(0.0, f64::max);
    let highest = if farthest > 0.0 { 1.08 * farthest } else { 1.0 };
    let states = Panel::new(
        "",
        Axis::linear("time (s)"),
        Axis::linear("polarisation, rotation").between(-1.05, 1.05).ticks([-1.0, -0.5, 0.0, 0.5, 1.0]),
    )
    .series(
        Series::line("polarisation |p_1|", line(&|frame| Some(frame.group.as_ref()?.order[0]))).colour(BLUE).size(2.0),
    )
    .series(
        Series::dashed("rotation (milling; > 0 to the left)", line(&|frame| Some(frame.group.as_ref()?.rotation)))
            .colour(RED)
            .size(1.3),
    );
    let distances = Panel::new(
        "",
        Axis::linear("time (s)"),
        Axis::linear("nearest neighbour (body lengths)").between(0.0, highest),
    )
    .series(Series::line("mean over the fish", nearest).colour(BLUE).size(1.6));
    Picture::new(titled(report, "order over time")).grid(1, (760.0, 300.0)).panel(states).panel(distances)
}

/// Pairs whose curves are drawn.
const DRAWN: usize = 6;

/// The cosines over the lag, of the pairs of the fish that leads most.
pub(super) fn delays(report: &TracksReport, delays: &Delays) -> Picture {
    let step = report.tracks.step;
    let lags = Axis::linear("lag of the second fish behind the first (s)");
    let mut panel = Panel::new("", lags, Axis::linear("mean cosine of headings"));
    for (k, pair) in delays.leading().into_iter().take(DRAWN).enumerate() {
        let [first, second] = pair.pair.map(|k| literal(&cut(&report.tracks.ids[k], 11)));
        let lag = |i: usize| (i as f64 - delays.largest as f64) * step;
        let curve = pair.curve.iter().enumerate().map(|(i, c)| (lag(i), c.unwrap_or(f64::NAN)));
        let series = Series::line(format!("{first}, {second}"), curve);
        panel = panel.series(series.colour(PALETTE[k % PALETTE.len()]).size(1.6));
    }
    Picture::new(titled(report, "delays of headings")).grid(1, (760.0, 380.0)).panel(panel)
}

pub(super) fn snapshot(report: &TracksReport) -> Picture {
    let panel = snapshot_panel(report, "");
    Picture::new(titled(report, "positions, headings, zones of orientation")).grid(1, (640.0, 640.0)).panel(panel)
}

/// Positions, headings, the last five seconds of the trajectories and the zones of orientation, as in Figure S2.
pub(crate) fn snapshot_panel(report: &TracksReport, title: &str) -> Panel {
    let (analysis, b) = (report.analysis, report.analysis.choices.body_length);
    let i = report.snapshot_frame();
    let time = analysis.frames[i].time;
    let title = if title.is_empty() { format!("t = {time} s") } else { format!("{title}, t = {time} s") };
    let point = |r: &Vector| (r.re, r.im);
    let mut panel = Panel::new(title, Axis::linear("x"), Axis::linear("y")).equal_scales();
    let state: Vec<(&Vector, &Vector)> = analysis
        .positions
        .iter()
        .zip(&analysis.motion.headings)
        .filter_map(|(r, z)| Some((r[i].as_ref()?, z[i].as_ref()?)))
        .collect();
    for &(r, z) in &state {
        panel = panel.series(Series::area("", zone(analysis, r, z)).colour(GREY));
    }
    for places in &analysis.positions {
        let trail = (0..=i)
            .filter(|&j| analysis.frames[j].time >= time - TRAIL)
            .map(|j| places[j].as_ref().map_or((f64::NAN, f64::NAN), point));
        panel = panel.series(Series::line("", trail).colour(BLUE).size(1.2));
    }
    for &(r, z) in &state {
        panel = panel.series(Series::line("", arrow(r, z, 1.2 * b)).colour("#000000").size(1.4));
    }
    panel.series(Series::points("", state.iter().map(|&(r, _)| point(r))).colour(RED).size(3.6))
}

/// The outline of the zone of orientation without the blind spot.
fn zone(analysis: &Analysis, r: &Vector, z: &Vector) -> Vec<(f64, f64)> {
    let zones = analysis.choices.zones();
    let (ahead, widest) = (z.im.atan2(z.re), PI - (analysis.choices.blind / 2.0).to_radians());
    let arc = |radius: f64, sign: f64| {
        (0..=72).map(move |k| {
            let angle = ahead + sign * widest * (f64::from(k) / 36.0 - 1.0);
            (r.re + radius * angle.cos(), r.im + radius * angle.sin())
        })
    };
    arc(zones.orientation, 1.0).chain(arc(zones.repulsion, -1.0)).collect()
}

/// A line with two barbs.
fn arrow(r: &Vector, z: &Vector, length: f64) -> Vec<(f64, f64)> {
    let at = |along: f64, across: f64| {
        (r.re + length * (along * z.re - across * z.im), r.im + length * (along * z.im + across * z.re))
    };
    vec![at(0.0, 0.0), at(1.0, 0.0), at(0.7, 0.16), at(1.0, 0.0), at(0.7, -0.16)]
}
