//! The files and the table of a simulated scenario.

use super::export::NamedArray;
use super::plot::{Axis, PALETTE, Panel, Picture, Series};
use scenario::{End, Outcome, Part, Row, Value};
use serde_json::{Map, Value as Json, json};
use std::fmt::Write;

/// `summary.json`: model, declaration, samples, events, and how the run ended.
pub fn simulation_summary(outcome: &Outcome) -> Json {
    let sample = |row: &Row| {
        let mut sample = Map::new();
        sample.insert("t".to_string(), json!(row.time));
        for (name, part) in row.frame.parts() {
            let list = match part {
                Part::Vectors(list) => json!(list),
                Part::Numbers(list) => json!(list),
            };
            sample.insert(name.to_string(), list);
        }
        let value = |value: &Value| match value {
            Value::Number(x) => json!(x),
            Value::Count(n) => json!(n),
            Value::List(list) => json!(list),
        };
        let observables: Map<String, Json> =
            row.observables.iter().map(|o| (o.name.to_string(), value(&o.value))).collect();
        sample.insert("observables".to_string(), Json::Object(observables));
        Json::Object(sample)
    };
    let event = |event: &scenario::Event| {
        let kind = if event.gained { "link" } else { "unlink" };
        json!({"t": event.time, "kind": kind, "pair": [event.pair.0, event.pair.1]})
    };
    let ended = match &outcome.end {
        End::Finished => "finished".to_string(),
        End::Interrupted => "interrupted".to_string(),
        End::Failed(error) => error.to_string(),
    };
    json!({
        "model": outcome.model,
        "declaration": outcome.declaration.join("\n"),
        "samples": outcome.samples().map(sample).collect::<Vec<_>>(),
        "events": outcome.events.iter().map(event).collect::<Vec<_>>(),
        "remarks": outcome.remarks,
        "ended": ended,
        "reached": outcome.reached(),
    })
}

/// The columns of what each agent has: `x`, `y` for positions, `vx`, `vy` for velocities, `theta` for phases; of a law of one's own `v_1`, `v_2` for a vector
/// `v`.
fn columns_of(name: &str, part: &Part) -> Vec<String> {
    let Some(width) = part.width() else { return vec![if name == "phases" { "theta" } else { name }.to_string()] };
    let before = match name {
        "positions" => "",
        "velocities" => "v",
        "centres" => "centre_",
        _ => return (1..=width).map(|k| format!("{name}_{k}")).collect(),
    };
    ["x", "y"].iter().take(width).map(|c| format!("{before}{c}")).collect()
}

/// `trajectory.csv`: one line for each agent at each time.
pub fn trajectory_csv(outcome: &Outcome) -> String {
    let Some(first) = outcome.rows.first() else { return "t,agent\n".to_string() };
    let mut header = vec!["t".to_string(), "agent".to_string()];
    header.extend(first.frame.parts().iter().flat_map(|(name, part)| columns_of(name, part)));
    let mut text = header.join(",") + "\n";
    for row in &outcome.rows {
        let parts = row.frame.parts();
        for agent in 0..row.frame.agents() {
            // Writing to a string cannot fail.
            let _ = write!(text, "{:?},{}", row.time, agent + 1);
            for x in parts.iter().flat_map(|(_, part)| part.of(agent)) {
                let _ = write!(text, ",{x:?}");
            }
            text.push('\n');
        }
    }
    text
}

/// `observables.csv`: one line for each time; what has no value is empty.
pub fn observables_csv(outcome: &Outcome) -> String {
    let columns = |row: &Row| row.observables.iter().flat_map(|o| o.columns()).collect::<Vec<_>>();
    let mut text = "t".to_string();
    for (name, _) in outcome.rows.first().map(columns).unwrap_or_default() {
        text += &format!(",{name}");
    }
    text.push('\n');
    for row in &outcome.rows {
        let _ = write!(text, "{:?}", row.time);
        for (_, x) in columns(row) {
            if x.is_finite() { write!(text, ",{x:?}") } else { write!(text, ",") }.unwrap_or_default();
        }
        text.push('\n');
    }
    text
}

/// `events.csv`: one line for each link that came or went.
pub fn events_csv(outcome: &Outcome) -> String {
    let mut text = "t,kind,agent,other\n".to_string();
    for event in &outcome.events {
        let kind = if event.gained { "link" } else { "unlink" };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{:?},{kind},{},{}", event.time, event.pair.0, event.pair.1);
    }
    text
}

/// The run as arrays for NumPy: `t`; `positions`, `velocities` and `centres` (times x agents x coordinates) and `phases` (times x agents) as
/// far as the model has them, of a law of one's own the parts of the state by their names; each observable (times, or times x numbers); `events` (each t, 1 for link or 0 for unlink, the two agents).
pub fn simulation_arrays(outcome: &Outcome) -> Vec<NamedArray> {
    let rows = &outcome.rows;
    let array = |name: &str, axes: &[usize], data: Vec<f64>| NamedArray {
        name: name.to_string(),
        shape: std::iter::once(rows.len()).chain(axes.iter().copied()).collect(),
        data,
    };
    let mut arrays = vec![array("t", &[], rows.iter().map(|row| row.time).collect())];
    let Some(first) = rows.first() else { return arrays };
    let mut flat: Vec<Vec<f64>> = vec![Vec::new(); first.frame.parts().len()];
    for row in rows {
        flat.iter_mut().zip(row.frame.parts()).for_each(|(all, (_, part))| all.extend(part.flat()));
    }
    for ((name, part), data) in first.frame.parts().iter().zip(flat) {
        let axes: Vec<usize> = std::iter::once(first.frame.agents()).chain(part.width()).collect();
        arrays.push(array(name, &axes, data));
    }
    for (k, observable) in first.observables.iter().enumerate() {
        let width = observable.columns().len();
        let axes: &[usize] = if matches!(observable.value, Value::List(_)) { &[width] } else { &[] };
        let data = rows.iter().flat_map(|row| row.observables[k].columns().into_iter().map(|(_, x)| x));
        arrays.push(array(&observable.name, axes, data.collect()));
    }
    let event = |e: &scenario::Event| [e.time, f64::from(u8::from(e.gained)), e.pair.0 as f64, e.pair.1 as f64];
    let events: Vec<f64> = outcome.events.iter().flat_map(event).collect();
    arrays.push(NamedArray { name: "events".to_string(), shape: vec![outcome.events.len(), 4], data: events });
    arrays
}

/// A number of at most 11 characters.
fn short(x: f64) -> String {
    match x.abs() {
        _ if !x.is_finite() => "-".to_string(),
        size if x == x.trunc() && size < 1e6 => format!("{x:.0}"),
        size if (1e-4..1e6).contains(&size) => {
            let decimals = (5 - size.log10().floor() as i32).clamp(0, 8) as usize;
            let text = format!("{x:.decimals$}");
            if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_string() } else { text }
        }
        _ => format!("{x:.4e}"),
    }
}

/// The samples as a table of at most 80 columns; further observables go into further blocks.
pub fn sample_table(outcome: &Outcome) -> String {
    const WIDTH: usize = 80;
    let rows: Vec<(String, Vec<(String, f64)>)> = outcome
        .samples()
        .map(|row| (short(row.time), row.observables.iter().flat_map(|o| o.columns()).collect()))
        .collect();
    let Some((_, first)) = rows.first() else { return "no sample was reached\n".to_string() };
    let time = rows.iter().map(|(t, _)| t.len()).max().unwrap_or(0).max(1);
    let width = |k: usize| rows.iter().map(|(_, x)| short(x[k].1).len()).max().unwrap_or(0).max(first[k].0.len());
    let mut blocks: Vec<Vec<usize>> = vec![Vec::new()];
    let mut used = time;
    for k in 0..first.len() {
        if used + 2 + width(k) > WIDTH {
            blocks.push(Vec::new());
            used = time;
        }
        used += 2 + width(k);
        if let Some(block) = blocks.last_mut() {
            block.push(k);
        }
    }
    let mut text = String::new();
    for block in blocks {
        let line = |head: &str, cell: &dyn Fn(usize) -> String| {
            let cells: String = block.iter().map(|&k| format!("  {:>1$}", cell(k), width(k))).collect();
            format!("{head:>time$}{cells}\n")
        };
        text += &line("t", &|k| first[k].0.clone());
        for (t, values) in &rows {
            text += &line(t, &|k| short(values[k].1));
        }
        text.push('\n');
    }
    text
}

/// Most agents that are drawn.
const DRAWN: usize = 256;

/// The pictures with their names: the paths where there are positions, phases where there are only phases, and the observables.
pub fn simulation_pictures(outcome: &Outcome) -> Vec<(&'static str, Picture)> {
    let dimension = outcome.rows.first().and_then(|row| row.frame.positions.first()).map_or(0, Vec::len);
    let first = match dimension {
        0 => (
            "phases",
            over_time(outcome, "phase modulo 2π (radians)", |row, k| {
                row.frame.phases.get(k).map(|theta| models::angles::within_a_turn(*theta))
            }),
        ),
        1 => ("paths", over_time(outcome, "place on the line", |row, k| row.frame.positions.get(k).map(|x| x[0]))),
        _ => ("paths", paths(outcome)),
    };
    vec![first, ("observables", observables(outcome))]
}

fn agents(outcome: &Outcome) -> usize {
    outcome.rows.first().map_or(0, |row| row.frame.agents())
}

fn title(outcome: &Outcome, what: &str) -> String {
    let agents = agents(outcome);
    let drawn = if agents > DRAWN { format!(", {DRAWN} of them drawn") } else { String::new() };
    format!("{}: {what} of {agents} agents{drawn}, t = 0 to {}", outcome.model, short(outcome.reached()))
}

fn colour(agent: usize) -> &'static str {
    PALETTE[agent % PALETTE.len()]
}

/// Paths in the plane, from a circle to a disc.
fn paths(outcome: &Outcome) -> Picture {
    let size = if agents(outcome) > 24 { 0.7 } else { 1.4 };
    let place = |row: &Row, k: usize| row.frame.positions.get(k).map(|r| (r[0], r[1]));
    let mut panel = Panel::new("", Axis::linear("x"), Axis::linear("y")).equal_scales();
    let drawn = agents(outcome).min(DRAWN);
    for k in 0..drawn {
        let line = outcome.rows.iter().filter_map(|row| place(row, k));
        panel = panel.series(Series::line("", line).colour(colour(k)).size(size));
    }
    let linked = links(outcome, drawn);
    if !linked.is_empty() {
        panel = panel.below(Series::line("links at the end", linked).colour("#9a9a9a").size(0.9));
    }
    let ends = |row: Option<&Row>| (0..drawn).filter_map(|k| place(row?, k)).collect::<Vec<_>>();
    panel = panel.series(Series::crosses("start", ends(outcome.rows.first())).colour("#6b6b6b"));
    panel = panel.series(Series::points("end", ends(outcome.rows.last())).colour("#222222").size(2.6));
    let moving = headings(outcome, drawn);
    if !moving.is_empty() {
        panel = panel.series(Series::arrows("direction of motion at the end", moving).colour("#222222"));
    }
    Picture::new(title(outcome, "paths")).grid(1, (760.0, 620.0)).panel(panel)
}

/// The links at the end as one broken line.
fn links(outcome: &Outcome, drawn: usize) -> Vec<(f64, f64)> {
    let Some(row) = outcome.rows.last() else { return Vec::new() };
    let place = |k: usize| row.frame.positions.get(k).map(|r| (r[0], r[1]));
    let ends = row.links.iter().filter(|(i, j)| i.max(j) < &drawn).filter_map(|(i, j)| place(*i).zip(place(*j)));
    ends.flat_map(|(a, b)| [a, b, (f64::NAN, f64::NAN)]).collect()
}

/// Arrows in the directions of motion at the end, a thirtieth of what the paths span; none for agents at rest.
fn headings(outcome: &Outcome, drawn: usize) -> Vec<((f64, f64), (f64, f64))> {
    let Some(frame) = outcome.rows.last().map(|row| &row.frame) else { return Vec::new() };
    let span = |k: usize| {
        let places = || outcome.rows.iter().flat_map(|row| &row.frame.positions).filter_map(move |r| r.get(k).copied());
        places().fold(f64::MIN, f64::max) - places().fold(f64::MAX, f64::min)
    };
    let length = span(0).max(span(1)).max(1e-9) / 30.0;
    let direction = |k: usize| match (frame.phases.get(k), frame.velocities.get(k)) {
        (Some(phase), _) => Some((phase.cos(), phase.sin())),
        (None, Some(v)) if v.len() == 2 && v[0].hypot(v[1]) > 0.0 => {
            let speed = v[0].hypot(v[1]);
            Some((v[0] / speed, v[1] / speed))
        }
        _ => None,
    };
    let arrow = |k: usize| {
        let (place, (x, y)) = (frame.positions.get(k)?, direction(k)?);
        Some(((place[0], place[1]), (place[0] + length * x, place[1] + length * y)))
    };
    (0..drawn).filter_map(arrow).collect()
}

/// One number of each agent over time.
fn over_time(outcome: &Outcome, label: &str, value: impl Fn(&Row, usize) -> Option<f64>) -> Picture {
    let mut panel = Panel::new("", Axis::linear("t"), Axis::linear(label));
    for k in 0..agents(outcome).min(DRAWN) {
        let points: Vec<(f64, f64)> = outcome.rows.iter().filter_map(|row| Some((row.time, value(row, k)?))).collect();
        // A line is broken where the value jumps by most of a turn.
        let mut line = Vec::with_capacity(points.len());
        for (i, point) in points.iter().enumerate() {
            if i > 0 && outcome.rows[0].frame.positions.is_empty() && (point.1 - points[i - 1].1).abs() > 5.0 {
                line.push((point.0, f64::NAN));
            }
            line.push(*point);
        }
        panel = panel.series(Series::line("", line).colour(colour(k)).size(1.0));
    }
    Picture::new(title(outcome, label)).grid(1, (760.0, 460.0)).panel(panel)
}

/// One panel for each observable that changes; logarithmic where positive values differ much.
fn observables(outcome: &Outcome) -> Picture {
    let mut picture = Picture::new(title(outcome, "observables")).grid(2, (480.0, 280.0));
    let Some(first) = outcome.rows.first() else { return picture };
    for (place, observable) in first.observables.iter().enumerate() {
        let curve = |column: usize| -> Vec<(f64, f64)> {
            let value = |row: &Row| row.observables[place].columns().get(column).map_or(f64::NAN, |(_, x)| *x);
            outcome.rows.iter().map(|row| (row.time, value(row))).collect()
        };
        let curves: Vec<(String, Vec<(f64, f64)>)> =
            observable.columns().into_iter().zip(0..).map(|((name, _), k)| (name, curve(k))).collect();
        let numbers = || curves.iter().flat_map(|(_, curve)| curve).map(|(_, x)| *x).filter(|x| x.is_finite());
        let (least, most) = numbers().fold((f64::INFINITY, 0.0f64), |(a, b), x| (a.min(x), b.max(x)));
        // A constant is a number, and stands in the summary.
        if numbers().all(|x| x == least) && first.observables.len() > 1 {
            continue;
        }
        let axis = if least > 0.0 && most > 1e3 * least { Axis::log("") } else { Axis::linear("") };
        let mut panel = Panel::new(observable.name.replace('_', " "), Axis::linear("t"), axis);
        let several = curves.len() > 1;
        for (name, curve) in curves {
            panel = panel.series(Series::line(if several { name } else { String::new() }, curve));
        }
        picture = picture.panel(panel);
    }
    picture
}
