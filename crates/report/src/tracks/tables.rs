//! CSV files of an analysis.

use super::TracksReport;
use models::tracks::{Delays, Gap, Histogram, Reason, Scale, csv_field};
use std::fmt::Write;

/// Six significant digits or so; empty for what is not there.
fn cell(x: Option<f64>) -> String {
    x.map_or_else(String::new, |x| format!("{x:.6}"))
}

/// A row for each frame; what cannot be said is empty.
pub(super) fn frames(report: &TracksReport) -> String {
    let analysis = report.analysis;
    let mut text = String::from(
        "t,left_out,seen,bridged,headings,p_1,p_2,momentum,rotation,nearest_distance_mean,W_single,W_complete,W_orientation,\
         orientation_arcs,S_single,S_complete,difference_figure,difference_text,difference_per_arc",
    );
    for n in &analysis.choices.nearest {
        // Writing to a string cannot fail, here and below.
        let _ = write!(text, ",W_{n}");
    }
    text.push('\n');
    for (i, (frame, bridged)) in analysis.frames.iter().zip(report.tracks.on_bridges()).enumerate() {
        let group = frame.group.as_ref();
        let difference = |scale: Scale| group.map(|g| g.difference(scale));
        let counts = [frame.seen - bridged.min(frame.seen), bridged, frame.headed].map(|count| count.to_string());
        let reason = analysis.left_out_for(report.tracks, i).map_or("", Reason::name);
        let mut cells = vec![frame.time.to_string(), reason.to_string()];
        cells.extend(counts);
        cells.extend(
            [
                group.map(|g| g.order[0]),
                group.map(|g| g.order[1]),
                group.map(|g| g.momentum),
                group.map(|g| g.rotation),
                frame.mean_distance(),
                group.map(|g| g.single),
                group.map(|g| g.complete),
                group.map(|g| g.orientation),
            ]
            .map(cell),
        );
        cells.push(group.map_or_else(String::new, |g| g.orientation_arcs.to_string()));
        cells.extend(
            [
                group.map(|g| g.single(Scale::Figure)),
                group.map(|g| g.complete(Scale::Figure)),
                difference(Scale::Figure),
                difference(Scale::Text),
                difference(Scale::PerArc),
            ]
            .map(cell),
        );
        cells.extend((0..analysis.choices.nearest.len()).map(|i| cell(group.map(|g| g.others[i]))));
        text.push_str(&cells.join(","));
        text.push('\n');
    }
    text
}

/// A row for each fish.
pub(super) fn fish(report: &TracksReport) -> String {
    let mut text = String::from(
        "id,frames_seen,frames_missing,gaps,frames_at_rest,mean_speed,speed_frames,mean_nearest_distance,distance_frames,\
         share_repulsion,share_orientation,share_attraction,share_frames\n",
    );
    for (id, fish) in report.tracks.ids.iter().zip(&report.analysis.fish) {
        let zone = |z: usize| cell(fish.zones.map(|zones| zones[z]));
        let _ = writeln!(
            text,
            "{},{},{},{},{},{},{},{},{},{},{},{},{}",
            csv_field(id),
            fish.seen,
            fish.missing.0,
            fish.missing.1,
            fish.still,
            cell(fish.speed),
            fish.over[0],
            cell(fish.distance),
            fish.over[1],
            zone(0),
            zone(1),
            zone(2),
            fish.over[2]
        );
    }
    text
}

/// A row for each pair.
pub(super) fn delays(report: &TracksReport, delays: &Delays) -> String {
    let mut text = String::from(
        "first,second,delay,frames,correlation,correlation_at_once,windows_at_least,windows,share_at_least\n",
    );
    for pair in &delays.pairs {
        let [first, second] = pair.pair.map(|k| csv_field(&report.tracks.ids[k]));
        let _ = writeln!(
            text,
            "{first},{second},{},{},{:.6},{},{},{},{}",
            cell(Some(pair.frames as f64 * report.tracks.step)),
            pair.both,
            pair.correlation,
            cell(pair.at_once),
            pair.beyond.0,
            pair.beyond.1,
            cell(pair.share_at_least())
        );
    }
    text
}

/// A row for each gap.
pub(super) fn gaps(report: &TracksReport) -> String {
    let mut text = String::from("id,from,to,frames,where,bridged\n");
    for (gap, bridged) in all_gaps(report) {
        let place = place(gap.at_start, gap.at_end);
        let _ = writeln!(
            text,
            "{},{},{},{},{place},{bridged}",
            csv_field(&report.tracks.ids[gap.fish]),
            gap.from,
            gap.to,
            gap.frames
        );
    }
    text
}

/// All gaps of the recording, by fish and time, and whether each was bridged.
pub(super) fn all_gaps<'a>(report: &TracksReport<'a>) -> impl Iterator<Item = (&'a Gap, bool)> {
    let (bridged, left) = (&report.tracks.bridged, &report.analysis.gaps);
    let mut gaps: Vec<(&Gap, bool)> =
        bridged.iter().map(|gap| (gap, true)).chain(left.iter().map(|gap| (gap, false))).collect();
    gaps.sort_by_key(|(gap, _)| (gap.fish, gap.first));
    gaps.into_iter()
}

/// Where in the recording a gap is.
pub(super) fn place(at_start: bool, at_end: bool) -> &'static str {
    match (at_start, at_end) {
        (true, true) => "never seen",
        (true, false) => "not yet seen",
        (false, true) => "not seen again",
        (false, false) => "between",
    }
}

/// The histograms of the potentials beside those of independent uniform headings, and of distances, speeds and order.
pub(super) fn histograms(report: &TracksReport) -> String {
    let mut text = String::from("quantity,from,to,count,share,share_independent,share_headings_shifted\n");
    for named in all(report) {
        let null = |histogram: &Option<Histogram>| -> Vec<String> {
            let shares = |h: &Histogram| h.bins().map(|bin| format!("{:.6}", bin.3)).collect();
            histogram.as_ref().map_or_else(|| vec![String::new(); named.observed.counts.len()], shares)
        };
        let nulls = null(&named.uniform).into_iter().zip(null(&named.shifted));
        for ((from, to, count, share), (uniform, shifted)) in named.observed.bins().zip(nulls) {
            let _ = writeln!(text, "{},{from:.6},{to:.6},{count},{share:.6},{uniform},{shifted}", named.name);
        }
    }
    text
}

/// A histogram with the same one under null models.
pub(super) struct Named {
    pub name: &'static str,
    pub label: String,
    pub observed: Histogram,
    pub uniform: Option<Histogram>,
    pub shifted: Option<Histogram>,
}

/// The scaled potentials (Figure S3) for `n = N - 1` and `n = 1`.
pub(super) fn scaled(report: &TracksReport) -> [Histogram; 2] {
    let complete = report.analysis.groups().map(|(_, g)| g.complete(Scale::Figure));
    let single = report.analysis.groups().map(|(_, g)| g.single(Scale::Figure));
    [Histogram::of(0.0, 1.0, 20, complete), Histogram::of(0.0, 1.0, 20, single)]
}

/// Their difference.
pub(super) fn difference(report: &TracksReport) -> Histogram {
    Histogram::of(-1.0, 1.0, 40, report.analysis.groups().map(|(_, g)| g.difference(Scale::Figure)))
}

/// All histograms.
pub(super) fn all(report: &TracksReport) -> Vec<Named> {
    let analysis = report.analysis;
    let b = analysis.choices.body_length;
    let of =
        |name, label: &str, observed| Named { name, label: label.to_string(), observed, uniform: None, shifted: None };
    let [complete, single] = scaled(report);
    let uniform = |k: usize| report.null.map(|null| null.uniform.histograms[k].clone());
    let shifted = report.null.and_then(|null| null.shifted.first());
    let upper = |values: &mut dyn Iterator<Item = f64>| {
        let largest = values.fold(0.0, f64::max);
        if largest > 0.0 { largest } else { 1.0 }
    };
    let fastest = upper(&mut analysis.speeds());
    let farthest = upper(&mut analysis.distances()) / b;
    vec![
        Named { uniform: uniform(0), ..of("S_complete", "2/(n+1) W_1, n = N−1", complete) },
        Named { uniform: uniform(1), ..of("S_single", "2/(n+1) W_1, n = 1", single) },
        Named {
            uniform: uniform(2),
            shifted: shifted.map(|(_, _, histogram)| histogram.clone()),
            ..of("difference", "difference of the two", difference(report))
        },
        of("p_1", "|p_1|", Histogram::of(0.0, 1.0, 20, analysis.groups().map(|(_, g)| g.order[0]))),
        of(
            "nearest_distance",
            "nearest neighbour (body lengths)",
            Histogram::of(0.0, farthest, 20, analysis.distances().map(|d| d / b)),
        ),
        of("speed", "speed (units of the file per second)", Histogram::of(0.0, fastest, 20, analysis.speeds())),
    ]
}
