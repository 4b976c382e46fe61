//! Many runs of one file: replicas and grids, on all cores, in shards that resume and merge.

use super::super::interrupt::{self, Watch};
use super::super::{CliError, output, progress};
use super::Arguments;
use flockproof::campaign::ensemble::{Moment, Runs, statistics_json, tables};
use flockproof::campaign::job::{Campaign, digest};
use flockproof::campaign::store::{Shard, merge, run_shard};
use flockproof::report::plot::{Axis, Panel, Picture, Series};
use flockproof::report::{File, Provenance};
use flockproof::scenario::Ensemble;
use num_traits::ToPrimitive;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::Path;
use std::process::ExitCode;

/// Runs that failed are named up to so many.
const MOST_NAMED: usize = 20;

pub fn run(arguments: &Arguments, ensemble: &Ensemble, input: &output::Input) -> Result<ExitCode, CliError> {
    let refuse = |error: &dyn std::fmt::Display| CliError::Use(error.to_string());
    if arguments.animate {
        return Err(refuse(&"--animate plays one run: choose it with --member"));
    }
    if arguments.html.is_some() {
        return Err(refuse(&"--html shows one run: choose it with --member"));
    }
    let folder = arguments.out.as_deref().ok_or_else(|| refuse(&"many runs are written to a folder: --out DIR"))?;
    output::make_folder(folder)?;
    if arguments.merge {
        let merged = merge(folder).map_err(|error| refuse(&error))?;
        let (found, expected) = (&merged.header.campaign, ensemble.canonical());
        if *found != expected {
            let (found, expected) = (digest(found), digest(&expected));
            let why = format!("its shards belong to another file ({found}, not {expected})");
            return Err(CliError::file(folder, why));
        }
        return finished((arguments, folder), ensemble, input, &merged.rows);
    }
    let watch = Watch::with(progress::bar());
    let shard = arguments.shard.unwrap_or(Shard::WHOLE);
    let run = run_shard(ensemble, folder, shard, arguments.resume, &watch).map_err(|error| refuse(&error))?;
    watch.finish();
    interrupt::finishing();
    if !run.is_complete() {
        eprintln!("interrupted: {} of {} runs are finished; --resume goes on", run.rows.len(), run.cases);
        return Ok(interrupt::status(false));
    }
    if shard != Shard::WHOLE {
        output::print(&format!("shard {shard} is finished: {} runs; --merge puts all shards together\n", run.cases))?;
        return Ok(ExitCode::SUCCESS);
    }
    finished((arguments, folder), ensemble, input, &run.rows)
}

/// Writes the tables of all runs and prints the statistics.
fn finished(
    (arguments, folder): (&Arguments, &Path),
    ensemble: &Ensemble,
    input: &output::Input,
    rows: &BTreeMap<u64, Value>,
) -> Result<ExitCode, CliError> {
    let runs = tables(ensemble, rows).map_err(|error| CliError::file(folder, error))?;
    let first = ensemble.sampled(0).map_err(|error| CliError::file(&arguments.config, error))?;
    let configuration = json!({"command": "simulate", "file": input.origin, "toml": ensemble.text()});
    let provenance = Provenance::new("flockproof.ensemble/1", first.seed(), configuration);
    let axes = ensemble.axes().iter().map(|(name, values)| {
        (name.to_string(), values.iter().map(|value| value.to_string().into()).collect::<Vec<Value>>().into())
    });
    let failed = runs.failed.iter().map(|(member, why)| json!({"member": member + 1, "ended": why}));
    let summary = provenance.stamp(json!({
        "declaration": first.declaration().join("\n"),
        "replicas": ensemble.replicas(),
        "sweep": axes.collect::<serde_json::Map<String, Value>>(),
        "members": ensemble.members(),
        "failed": failed.collect::<Vec<_>>(),
        "statistics": statistics_json(ensemble, &runs.moments),
    }));
    let file = |name: &str, contents: String| File { name: name.to_string(), contents: contents.into_bytes() };
    let mut files = vec![
        file("summary.json", format!("{summary:#}\n")),
        file("members.csv", runs.members_csv.clone()),
        file("statistics.csv", runs.statistics_csv.clone()),
    ];
    files.push(file("about.txt", provenance.about(&files)));
    let picture = picture(ensemble, &runs.moments);
    files.push(file("statistics.svg", picture.svg()));
    let contents = picture.png().map_err(|error| CliError::Use(format!("statistics.png: {error}")))?;
    files.push(File { name: "statistics.png".to_string(), contents });
    for file in &files {
        output::write_file(&folder.join(&file.name), &file.contents)?;
    }
    if arguments.json {
        output::print_json(&summary)?;
    } else {
        let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
        let lines = [provenance.line(), format!("written: {}", names.join(", "))];
        let (table, folder) = (table(ensemble, &runs), folder.display());
        output::print(&format!("{table}{}in {folder}\n", super::declared(&lines)))?;
    }
    Ok(ExitCode::SUCCESS)
}

/// The point of the grid in words.
fn named(ensemble: &Ensemble, point: u64) -> String {
    let values = ensemble.point(point);
    let parts = ensemble.axes().iter().zip(&values).map(|((name, _), value)| format!("{name} = {value}"));
    parts.collect::<Vec<_>>().join(", ")
}

/// Mean and standard deviation of all observables, at the last time of each point, for at most so many points.
fn table(ensemble: &Ensemble, runs: &Runs) -> String {
    const MOST_POINTS: usize = 20;
    let points: Vec<&[Moment]> = runs.moments.chunk_by(|a, b| a.point == b.point).collect();
    let mut text = format!("{} runs: {} replicas of each point\n", ensemble.members(), ensemble.replicas());
    for moment in points.iter().take(MOST_POINTS).filter_map(|point| point.last()) {
        let mut head = vec![format!("t = {}", moment.time)];
        head.extend((!ensemble.axes().is_empty()).then(|| named(ensemble, moment.point)));
        text += &super::declared(&[head.join(", ")]);
        let widest = moment.spreads.iter().map(|spread| spread.name.len()).max().unwrap_or(0);
        for spread in moment.spreads.iter().filter(|spread| spread.count > 0) {
            let deviation =
                if spread.deviation.is_finite() { format!(" +- {:.3e}", spread.deviation) } else { String::new() };
            text += &format!("  {:<widest$}  {:.6e}{deviation}\n", spread.name, spread.mean);
        }
    }
    if points.len() > MOST_POINTS {
        text += &format!("and {} more points, in statistics.csv\n", points.len() - MOST_POINTS);
    }
    for (member, why) in runs.failed.iter().take(MOST_NAMED) {
        text += &super::declared(&[format!("run {} ended early: {why}", member + 1)]);
    }
    if runs.failed.len() > MOST_NAMED {
        text += &format!("and {} more runs ended early, in summary.json\n", runs.failed.len() - MOST_NAMED);
    }
    text
}

/// Mean of each observable with a standard deviation to both sides: over the number that is swept at the last time where there is one, else
/// over time, with a line for each of the first points.
fn picture(ensemble: &Ensemble, moments: &[Moment]) -> Picture {
    const MOST_LINES: usize = 8;
    let points: Vec<&[Moment]> = moments.chunk_by(|a, b| a.point == b.point).collect();
    let one = matches!(ensemble.axes(), [(_, values)] if values.len() > 1);
    let label = if one { ensemble.axes()[0].0.to_string() } else { "t".to_string() };
    let place = |moment: &Moment| match one {
        true => ensemble.point(moment.point)[0].to_f64().unwrap_or(f64::NAN),
        false => moment.time,
    };
    let lines: Vec<(String, Vec<&Moment>)> = if one {
        vec![(String::new(), points.iter().filter_map(|point| point.last()).collect())]
    } else {
        points.iter().take(MOST_LINES).map(|point| (named(ensemble, point[0].point), point.iter().collect())).collect()
    };
    let title = format!("{} runs: mean and standard deviation of {} replicas", ensemble.members(), ensemble.replicas());
    let mut picture = Picture::new(title).grid(2, (480.0, 280.0));
    let names: Vec<&str> =
        moments.first().map(|m| m.spreads.iter().map(|s| s.name.as_str()).collect()).unwrap_or_default();
    for name in names {
        let mut panel = Panel::new(name, Axis::linear(&label), Axis::linear(""));
        for ((title, line), k) in lines.iter().zip(0..) {
            let colour = flockproof::report::plot::PALETTE[k % MOST_LINES];
            let curve = |sides: f64| -> Vec<(f64, f64)> {
                let value = |m: &&Moment| {
                    let spread = m.spreads.iter().find(|spread| spread.name == name)?;
                    Some((place(m), spread.mean + if sides == 0.0 { 0.0 } else { sides * spread.deviation }))
                };
                line.iter().filter_map(value).collect()
            };
            panel = panel.series(Series::joined(title.clone(), curve(0.0)).colour(colour));
            if ensemble.replicas() > 1 {
                panel = panel.series(Series::dashed("", curve(1.0)).colour(colour));
                panel = panel.series(Series::dashed("", curve(-1.0)).colour(colour));
            }
        }
        picture = picture.panel(panel);
    }
    picture
}
