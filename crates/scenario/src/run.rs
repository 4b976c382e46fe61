//! From a scenario to its samples, rows and events.

use super::error::RunError;
use super::observables::Observable;
use super::simulation::{Event, Frame, Simulation};
use arithmetic::Progress;
use std::sync::{Arc, Mutex, PoisonError};

/// Most agents of which the links are told.
const MOST_LINKED: usize = 64;

/// When something is written.
pub(super) struct Schedule {
    /// All times that are written, with whether they are samples.
    pub times: Vec<(f64, bool)>,
    /// Equal intervals of the trajectory.
    pub rows: usize,
    /// Whether a tolerance was given that has no effect.
    pub ignored: bool,
    /// The observables that are asked for by name; all of them where nothing is.
    pub observables: Option<Vec<String>>,
}

impl Schedule {
    pub fn declaration(&self) -> Vec<String> {
        let rows = format!("trajectory: {} equal intervals from 0 to the end, and the samples", self.rows);
        let ignored = "tolerance: no effect, time is discrete".to_string();
        let written = (self.rows > 0).then_some(rows);
        written.into_iter().chain(self.ignored.then_some(ignored)).collect()
    }
}

/// One time that is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The time.
    pub time: f64,
    /// Whether it was asked for by name.
    pub sample: bool,
    /// Where the agents are.
    pub frame: Frame,
    /// What is measured.
    pub observables: Vec<Observable>,
    /// Who is linked with whom, agents from 0, arcs as edges; not told of large flocks and of models whose links are made anew in every step.
    pub links: Arc<Vec<(usize, usize)>>,
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    /// At its last time.
    Finished,
    /// Before, because it was told to.
    Interrupted,
    /// Before, because it could not go on.
    Failed(RunError),
}

/// All that a run leaves behind; of one that ended early what was finished.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The name of the model.
    pub model: &'static str,
    /// Equations and choices, one sentence or more a line.
    pub declaration: Vec<String>,
    /// The times that are written, in order.
    pub rows: Vec<Row>,
    /// Links that came and went, in order.
    pub events: Vec<Event>,
    /// What was special about the run, in words.
    pub remarks: Vec<String>,
    /// How it ended.
    pub end: End,
}

impl Outcome {
    /// The rows that were asked for by name.
    pub fn samples(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(|row| row.sample)
    }

    /// The last time that was written; 0 where there is none.
    pub fn reached(&self) -> f64 {
        self.rows.last().map_or(0.0, |row| row.time)
    }
}

/// Runs a simulation; `progress` may stop it and is told of each row. What is finished is added to the outcome at once, for others to see.
pub(super) fn run(
    schedule: &Schedule,
    simulation: &mut dyn Simulation,
    progress: &dyn Progress,
    outcome: &Mutex<Outcome>,
) {
    let outcome = || outcome.lock().unwrap_or_else(PoisonError::into_inner);
    let small = simulation.frame().agents() <= MOST_LINKED;
    let (mut links, mut end, mut written) = (Arc::new(Vec::new()), End::Finished, 0);
    simulation.plan(&schedule.times.iter().map(|(time, _)| *time).collect::<Vec<_>>(), progress);
    for &(time, sample) in &schedule.times {
        let mut events = Vec::new();
        let went = simulation.advance(time, &mut events, progress);
        outcome().events.extend(events);
        match went {
            Ok(true) => {}
            Ok(false) => {
                end = End::Interrupted;
                break;
            }
            Err(error) => {
                end = End::Failed(error);
                break;
            }
        }
        match simulation.observe() {
            Ok(mut observables) => {
                if let Some(wanted) = &schedule.observables {
                    observables.retain(|observable| wanted.iter().any(|name| *name == observable.name));
                }
                if small {
                    let now = simulation.links();
                    // Most rows have the links of the one before.
                    if now != *links {
                        links = Arc::new(now);
                    }
                }
                let row = Row { time, sample, frame: simulation.frame(), observables, links: links.clone() };
                outcome().rows.push(row);
                written += 1;
            }
            Err(error) => {
                end = End::Failed(RunError::Observed { time, error });
                break;
            }
        }
        progress.tell("rows", written, Some(schedule.times.len() as u64));
    }
    let mut outcome = outcome();
    outcome.remarks = simulation.remarks();
    outcome.end = end;
}
