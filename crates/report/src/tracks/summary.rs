//! `summary.json`.

use super::{TracksReport, tables};
use models::tracks::{Delays, NearestRule, NullModels, PositionsUsed, Scale, Smoothing, Statistics};
use motion::Share;
use serde_json::{Map, Value, json};

/// A number of JSON, or null.
fn number(x: f64) -> Value {
    if x.is_finite() { json!(x) } else { Value::Null }
}

pub(super) fn summary(report: &TracksReport) -> Value {
    let (tracks, analysis) = (report.tracks, report.analysis);
    let left = analysis.left_out;
    let gaps: Vec<Value> = tables::all_gaps(report)
        .map(|(gap, bridged)| {
            let place = tables::place(gap.at_start, gap.at_end);
            let id = &tracks.ids[gap.fish];
            json!({"id": id, "from": gap.from, "to": gap.to, "frames": gap.frames, "where": place, "bridged": bridged})
        })
        .collect();
    let fish: Vec<Value> = tracks
        .ids
        .iter()
        .zip(&analysis.fish)
        .map(|(id, fish)| {
            json!({
                "id": id, "frames_seen": fish.seen, "frames_missing": fish.missing.0, "gaps": fish.missing.1,
                "frames_at_rest": fish.still, "mean_speed": fish.speed, "speed_frames": fish.over[0],
                "mean_nearest_distance": fish.distance, "distance_frames": fish.over[1],
                "zones": fish.zones.map(|[r, o, a]| json!({"repulsion": r, "orientation": o, "attraction": a})),
                "zones_frames": fish.over[2],
            })
        })
        .collect();
    json!({
        "schema": "flockproof.tracks/1",
        "source": report.source,
        "fish": tracks.fish(),
        "frames": left.recorded,
        "step": tracks.step,
        "start": tracks.start,
        "from": tracks.frames.first().map(|frame| frame.time),
        "to": tracks.frames.last().map(|frame| frame.time),
        "declaration": declaration(report),
        "left_out": {"missing": left.missing, "window": left.window, "at_rest": left.still, "used": left.used},
        "mean_fish": left.members as f64 / left.used as f64,
        "frames_on_bridges": tracks.on_bridges().iter().filter(|&&fish| fish > 0).count(),
        "frames_with_all_fish": analysis.whole_frames(),
        "few_frames": {"means": report.is_few(left.used), "null_models": report.is_few(analysis.whole_frames() as u64)},
        "snapshot": analysis.frames[report.snapshot_frame()].time,
        "gaps": gaps,
        "per_fish": fish,
        "means": means(report),
        "delays": report.delays.map(|found| delays(report, found)),
        "null_models": report.null.map(|models| null_models(report, models)),
    })
}

fn delays(report: &TracksReport, delays: &Delays) -> Value {
    let (ids, step) = (&report.tracks.ids, report.tracks.step);
    let pairs: Vec<Value> = delays
        .pairs
        .iter()
        .map(|pair| {
            json!({
                "pair": pair.pair.map(|k| &ids[k]), "delay": pair.frames as f64 * step, "frames": pair.both, "correlation": pair.correlation,
                "correlation_at_once": pair.at_once, "windows_at_least": pair.beyond.0, "windows": pair.beyond.1,
                "share_at_least": pair.share_at_least(),
            })
        })
        .collect();
    let lead: Map<String, Value> = ids
        .iter()
        .zip(&delays.lead)
        .map(|(id, lead)| (id.clone(), lead.map_or(Value::Null, |frames| number(frames * step))))
        .collect();
    json!({"largest": delays.largest as f64 * step, "pairs": pairs, "lead": lead})
}

fn declaration(report: &TracksReport) -> Value {
    let choices = &report.analysis.choices;
    json!({
        "window_frames": choices.window,
        "window_seconds": choices.window as f64 * report.tracks.step,
        "positions": match choices.positions {
            PositionsUsed::File => "file",
            PositionsUsed::Smoothed => "smoothed",
        },
        "table": report.tracks.form.words(),
        "body_parts": report.tracks.parts,
        "smoothing": choices.smoothing.name(),
        "velocity": match choices.smoothing {
            Smoothing::Mean => "central differences of positions averaged over the window; no window crosses a gap",
            Smoothing::SavitzkyGolay => "slope of the cubic through the window by least squares; no window crosses a gap",
            Smoothing::Spline => "slope of the smoothing spline of each run without a gap, lambda = (window/2 pi)^4",
        },
        "heading": "direction of the velocity",
        "at_rest": choices.still,
        "bridges": (!report.tracks.bridged.is_empty()).then(|| report.tracks.bridged_by.words()),
        "least_fish": choices.least_fish(report.tracks.fish()),
        "unit": report.known.unit,
        "times_from": report.known.times,
        "body_length": choices.body_length,
        "body_length_from": report.known.body_length,
        "zones_in_body_lengths": choices.zones.map(number),
        "blind_degrees": choices.blind,
        "single_neighbour": match choices.rule {
            NearestRule::SecondInRepulsion => "nearest, or second nearest where the nearest is in the zone of repulsion",
            NearestRule::Nearest => "nearest",
        },
        "p_m": "(1/(m N)) sum e^(i m theta), so |p_2| is at most 1/2",
        "null_frames": "frames with headings of all fish, in a row; shifts run around the end",
    })
}

fn means(report: &TracksReport) -> Value {
    let analysis = report.analysis;
    let mut scaled = Map::new();
    for scale in Scale::ALL {
        scaled.insert(
            scale.name().to_string(),
            json!({
                "single": analysis.mean(|g| g.single(scale)),
                "complete": analysis.mean(|g| g.complete(scale)),
            }),
        );
    }
    let mut others = Map::new();
    for (i, n) in analysis.choices.nearest.iter().enumerate() {
        others.insert(n.to_string(), json!(analysis.mean(|g| g.others[i])));
    }
    json!({
        "p_1": analysis.mean(|g| g.order[0]),
        "p_2": analysis.mean(|g| g.order[1]),
        "momentum": analysis.mean(|g| g.momentum),
        "rotation": analysis.mean(|g| g.rotation),
        "nearest_distance": analysis.mean_nearest(),
        "W_single": analysis.mean(|g| g.single),
        "W_complete": analysis.mean(|g| g.complete),
        "W_nearest": others,
        "W_orientation": analysis.mean(|g| g.orientation),
        "orientation_arcs": analysis.mean(|g| g.orientation_arcs as f64),
        "scaled": scaled,
    })
}

fn null_models(report: &TracksReport, models: &NullModels) -> Value {
    let fish = report.tracks.fish();
    let draws = models.uniform.draws;
    let mut uniform = Map::new();
    for (scale, &positive) in Scale::ALL.iter().zip(&models.uniform.positive) {
        let (low, high) = Share::new(positive, draws).interval();
        // W_1 has the mean n/2.
        let mean = scale.difference(fish, (fish - 1) as f64 / 2.0, 0.5);
        uniform.insert(
            scale.name().to_string(),
            json!({"positive": positive as f64 / draws as f64, "wilson_95": [low, high], "exact_mean_difference": mean}),
        );
    }
    let named = |values: [Value; Statistics::NAMES.len()]| -> Map<String, Value> {
        Statistics::NAMES.iter().map(ToString::to_string).zip(values).collect()
    };
    let mut shifted = Map::new();
    for (kind, comparisons, _) in &models.shifted {
        let values = comparisons.map(|c| {
            c.map_or(Value::Null, |c| {
                let (low, high) = Share::new(c.at_least.0, c.at_least.1).interval();
                json!({
                    "shifts": c.at_least.1, "mean": c.mean, "points_2.5_97.5": [c.range.0, c.range.1],
                    "share_at_least": c.share_at_least, "share_at_most": c.share_at_most, "wilson_95": [low, high],
                })
            })
        });
        shifted.insert(kind.name().to_string(), Value::Object(named(values)));
    }
    json!({
        "observed": named(models.observed.values().map(|x| x.map_or(Value::Null, number))),
        "single_neighbours_in_pairs": models.in_pairs,
        "independent_uniform_headings": {"draws": draws, "scales": uniform},
        "shifts": models.shifts,
        "shifted": shifted,
    })
}
