//! Ensembles: many runs of one scenario, and their statistics.

use crate::job::{Campaign, JobError};
use arithmetic::{Cancelled, Progress};
use scenario::{End, Ensemble, Outcome};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;

impl Campaign for Ensemble {
    fn canonical(&self) -> String {
        json!({"ensemble": self.text()}).to_string()
    }

    fn cases(&self) -> u64 {
        self.members()
    }

    /// The observables of one run at its samples: `{"names": [..], "samples": [[t, ..], ..], "events": count, "ended": null or why not}`.
    fn run(&self, case: u64, progress: &dyn Progress) -> Result<Value, JobError> {
        let scenario = self.sampled(case).map_err(|error| JobError::Refused(error.to_string()))?;
        let outcome = scenario.run(&Quiet(progress));
        match &outcome.end {
            End::Interrupted => Err(JobError::Cancelled(Cancelled)),
            End::Finished => Ok(result(&outcome, None)),
            End::Failed(error) => Ok(result(&outcome, Some(error.to_string()))),
        }
    }
}

/// Passes on that the work is to stop, and not how far one of many runs is.
struct Quiet<'a>(&'a dyn Progress);

impl Progress for Quiet<'_> {
    fn is_cancelled(&self) -> bool {
        self.0.is_cancelled()
    }

    fn tell(&self, _: &str, _: u64, _: Option<u64>) {}
}

fn result(outcome: &Outcome, ended: Option<String>) -> Value {
    let columns = |row: &scenario::Row| row.observables.iter().flat_map(|o| o.columns()).collect::<Vec<_>>();
    let names: Vec<String> = outcome
        .samples()
        .next()
        .map(|row| columns(row).into_iter().map(|(name, _)| name).collect())
        .unwrap_or_default();
    let sample = |row: &scenario::Row| -> Vec<f64> {
        std::iter::once(row.time).chain(columns(row).into_iter().map(|(_, x)| x)).collect()
    };
    let samples: Vec<Vec<f64>> = outcome.samples().map(sample).collect();
    json!({"names": names, "samples": samples, "events": outcome.events.len(), "ended": ended})
}

/// A finished run in numbers.
struct Member<'a> {
    number: u64,
    names: Vec<&'a str>,
    /// Times, and the observables there; what has no value is NaN.
    samples: Vec<(f64, Vec<f64>)>,
    events: u64,
    ended: Option<&'a str>,
}

/// Results that are not those of an ensemble.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("it holds no runs of `simulate`")]
pub struct NoEnsemble;

fn member<'a>((number, value): (&u64, &'a Value)) -> Option<Member<'a>> {
    let names = value["names"].as_array()?.iter().map(Value::as_str).collect::<Option<_>>()?;
    let sample = |row: &Value| {
        let numbers: Vec<f64> = row.as_array()?.iter().map(|x| x.as_f64().unwrap_or(f64::NAN)).collect();
        let (time, rest) = numbers.split_first()?;
        Some((*time, rest.to_vec()))
    };
    let samples = value["samples"].as_array()?.iter().map(sample).collect::<Option<_>>()?;
    let ended = value["ended"].as_str();
    Some(Member { number: *number, names, samples, events: value["events"].as_u64()?, ended })
}

/// Mean and spread of one observable over the replicas.
#[derive(Debug, Clone, PartialEq)]
pub struct Spread {
    /// The observable.
    pub name: String,
    /// How many replicas have a value there.
    pub count: u64,
    /// Their mean.
    pub mean: f64,
    /// Their standard deviation, with `count - 1`; NaN for fewer than two.
    pub deviation: f64,
}

/// The statistics at one point of the grid and one time.
#[derive(Debug, Clone, PartialEq)]
pub struct Moment {
    /// The point of the grid, from 0.
    pub point: u64,
    /// The time.
    pub time: f64,
    /// One for each observable.
    pub spreads: Vec<Spread>,
}

/// All runs of an ensemble as tables.
#[derive(Debug, Clone, PartialEq)]
pub struct Runs {
    /// One line for each run and sample.
    pub members_csv: String,
    /// One line for each point, time and observable.
    pub statistics_csv: String,
    /// By points, then times.
    pub moments: Vec<Moment>,
    /// Runs that could not go on to the end, by their number from 0, with the reason.
    pub failed: Vec<(u64, String)>,
}

/// The tables of some finished runs; sums go in the order of the members, so that nothing depends on threads or shards.
///
/// # Errors
/// [`NoEnsemble`].
pub fn tables(ensemble: &Ensemble, rows: &BTreeMap<u64, Value>) -> Result<Runs, NoEnsemble> {
    let members: Vec<Member> = rows.iter().map(member).collect::<Option<_>>().ok_or(NoEnsemble)?;
    let point = |member: &Member| member.number / ensemble.replicas();
    let mut moments = Vec::new();
    for group in members.chunk_by(|a, b| point(a) == point(b)) {
        let longest = group.iter().max_by_key(|member| (member.samples.len(), std::cmp::Reverse(member.number)));
        let Some(longest) = longest else { continue };
        for (k, (time, _)) in longest.samples.iter().enumerate() {
            let spreads = longest.names.iter().map(|name| spread(name, group, k)).collect();
            moments.push(Moment { point: point(&group[0]), time: *time, spreads });
        }
    }
    let failed = members.iter().filter_map(|member| Some((member.number, member.ended?.to_string()))).collect();
    let (members_csv, statistics_csv) = (members_csv(ensemble, &members), statistics_csv(ensemble, &moments));
    Ok(Runs { members_csv, statistics_csv, moments, failed })
}

/// Of the observable in the k-th sample of each run; two passes, so that the mean does not swallow the spread.
fn spread(name: &str, group: &[Member], k: usize) -> Spread {
    let value = |member: &Member| {
        let column = member.names.iter().position(|known| *known == name)?;
        member.samples.get(k)?.1.get(column).copied().filter(|x| x.is_finite())
    };
    let values: Vec<f64> = group.iter().filter_map(value).collect();
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let squares: f64 = values.iter().map(|x| (x - mean) * (x - mean)).sum();
    let deviation = (squares / (values.len() as f64 - 1.0)).sqrt();
    let deviation = if values.len() > 1 { deviation } else { f64::NAN };
    Spread { name: name.to_string(), count: values.len() as u64, mean, deviation }
}

/// What has no value is empty.
fn cell(x: f64) -> String {
    if x.is_finite() { format!("{x:?}") } else { String::new() }
}

/// The columns of the numbers that are put in, and their values at a point as the file would have them.
fn heading(ensemble: &Ensemble) -> String {
    ensemble.axes().iter().map(|(name, _)| format!(",{name}")).collect()
}

fn put_in(ensemble: &Ensemble, point: u64) -> String {
    ensemble.point(point).iter().map(|value| format!(",{value}")).collect()
}

fn members_csv(ensemble: &Ensemble, members: &[Member]) -> String {
    // Points may differ in their observables.
    let mut names: Vec<&str> = Vec::new();
    for name in members.iter().flat_map(|member| &member.names) {
        if !names.contains(name) {
            names.push(name);
        }
    }
    let observables: String = names.iter().map(|name| format!(",{name}")).collect();
    let mut text = format!("member{},replica,events,t{observables}\n", heading(ensemble));
    for member in members {
        let (point, replica) = (member.number / ensemble.replicas(), member.number % ensemble.replicas() + 1);
        let head = format!("{}{},{replica},{}", member.number + 1, put_in(ensemble, point), member.events);
        let places: Vec<Option<usize>> =
            names.iter().map(|name| member.names.iter().position(|known| known == name)).collect();
        for (time, values) in &member.samples {
            // Writing to a string cannot fail.
            let _ = write!(text, "{head},{time:?}");
            for place in &places {
                let _ = write!(text, ",{}", cell(place.map_or(f64::NAN, |place| values[place])));
            }
            text.push('\n');
        }
    }
    text
}

fn statistics_csv(ensemble: &Ensemble, moments: &[Moment]) -> String {
    let mut text = format!("point{},t,observable,replicas,mean,deviation\n", heading(ensemble));
    for moment in moments {
        let head = format!("{}{}", moment.point + 1, put_in(ensemble, moment.point));
        for spread in &moment.spreads {
            let (mean, deviation) = (cell(spread.mean), cell(spread.deviation));
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{head},{:?},{},{},{mean},{deviation}", moment.time, spread.name, spread.count);
        }
    }
    text
}

/// The statistics as JSON: `[{"point": {place: value, ..}, "t", "observables": {name: {"replicas", "mean", "deviation"}}}]`.
pub fn statistics_json(ensemble: &Ensemble, moments: &[Moment]) -> Value {
    let spread = |s: &Spread| (s.name.clone(), json!({"replicas": s.count, "mean": s.mean, "deviation": s.deviation}));
    let moment = |moment: &Moment| {
        let values = ensemble.point(moment.point);
        let names = ensemble.axes().iter().map(|(name, _)| name.to_string());
        let point: Map<String, Value> = names.zip(values.iter().map(|value| value.to_string().into())).collect();
        let observables: Map<String, Value> = moment.spreads.iter().map(spread).collect();
        json!({"point": point, "t": moment.time, "observables": observables})
    };
    moments.iter().map(moment).collect()
}
