//! Velocity alignment with links within a radius, followed by the motions of [`models::double_integrator`]: every arrival at the radius
//! is located, and what has several ways on is followed as a Filippov solution.

use super::agents::Agents;
use super::error::RunError;
use super::network::Change;
use super::observables::Observable;
use super::simulation::{Event, Frame, Law, Simulation};
use arithmetic::{ArithmeticError, Progress};
use models::double_integrator::{EventKind, Flock, Motion, MotionError, Options, Sample};
use motion::Tolerance;

/// A motion that is known beforehand, on its way from sample to sample.
pub(super) struct Known {
    motion: Motion,
    /// Why there is no more of the motion.
    end: Result<(), MotionError>,
    /// The sample where it is, none before the first; and the events that were told.
    sample: Option<usize>,
    told: usize,
}

/// A flock with the motion that is known once it was planned.
pub(super) struct Switching {
    agents: Agents,
    flock: Flock,
    options: Options,
    known: Known,
}

/// The integrator of such motions.
pub(super) fn options(tolerance: f64) -> Options {
    Options { tolerance: Tolerance { relative: tolerance, absolute: tolerance }, ..Options::default() }
}

impl Known {
    /// What was followed, and why there is no more of it.
    pub fn new((motion, end): (Motion, Result<(), MotionError>)) -> Self {
        Known { motion, end, sample: None, told: 0 }
    }

    /// Goes on to the next sample and tells what happened before a time; nothing where `progress` told to stop before.
    pub fn next(&mut self, until: f64, events: &mut Vec<Event>) -> Result<Option<&Sample>, RunError> {
        let next = self.sample.map_or(0, |k| k + 1);
        let Some(sample) = self.motion.samples.get(next) else {
            return match self.end.clone() {
                Err(MotionError::Halted(_)) | Ok(()) => Ok(None),
                Err(error) => Err(error.into()),
            };
        };
        self.sample = Some(next);
        for event in self.motion.events.iter().skip(self.told).take_while(|event| event.time <= until) {
            self.told += 1;
            let gained = match event.kind {
                EventKind::Link => true,
                EventKind::Unlink => false,
                EventKind::Touch | EventKind::Stay => continue,
            };
            events.push(Event::new(event.time, &Change { gained, pair: event.pair }));
        }
        Ok(Some(sample))
    }

    /// That the energy rose by more than the tolerance allows, if it did.
    pub fn warning(&self) -> Option<String> {
        let rises = "the energy Q rose by more than the tolerance allows: the motion is not reliable";
        (!self.motion.energy.is_monotone()).then(|| rises.to_string())
    }

    /// Whether it is at its last sample, with nothing that ended it before.
    pub fn is_over(&self) -> bool {
        self.end.is_ok() && self.sample.map_or(0, |k| k + 1) >= self.motion.samples.len()
    }

    /// The sample where it is.
    fn sample(&self) -> Option<&Sample> {
        self.sample.and_then(|k| self.motion.samples.get(k))
    }

    /// What was special about the motion, with its time.
    pub fn remarks(&self) -> Vec<(f64, String)> {
        let stays = self.motion.events.iter().filter_map(|event| {
            let what = match event.kind {
                EventKind::Touch => "reach the radius and go back",
                EventKind::Stay => "stay at the radius for a while",
                _ => return None,
            };
            Some((
                event.time,
                format!("t = {}: agents {} and {} {what}", event.time, event.pair.0 + 1, event.pair.1 + 1),
            ))
        });
        let forks = self.motion.choices.iter().map(|choice| {
            let (count, taken) = (choice.branches.len(), choice.taken + 1);
            (
                choice.time,
                format!("t = {}: {count} ways on for the pairs at the radius, followed is number {taken}", choice.time),
            )
        });
        stays.chain(forks).collect()
    }
}

/// Remarks in the order of time.
pub(super) fn told(mut all: Vec<(f64, String)>) -> Vec<String> {
    /// More are only counted.
    const MOST: usize = 100;
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let count = all.len();
    let mut lines: Vec<String> = all.into_iter().take(MOST).map(|(_, line)| line).collect();
    if count > MOST {
        lines.push(format!("and {} more", count - MOST));
    }
    lines
}

impl Switching {
    /// A flock at its start.
    pub fn new(agents: Agents, flock: Flock, tolerance: f64) -> Self {
        let known = Known::new((Motion::default(), Ok(())));
        Switching { agents, flock, options: options(tolerance), known }
    }

    fn list(&self) -> Vec<f64> {
        self.known.sample().map_or_else(|| self.flock.start().to_list(), |sample| sample.state.to_list())
    }

    fn time(&self) -> f64 {
        self.known.sample().map_or(0.0, |sample| sample.time)
    }
}

impl Simulation for Switching {
    fn plan(&mut self, times: &[f64], progress: &dyn Progress) {
        let until = times.last().copied().unwrap_or(0.0);
        self.known = Known::new(self.flock.run_watched(until, times, &self.options, progress));
    }

    fn advance(&mut self, until: f64, events: &mut Vec<Event>, _: &dyn Progress) -> Result<bool, RunError> {
        let Some(sample) = self.known.next(until, events)? else { return Ok(false) };
        self.agents.relink(&sample.links);
        Ok(true)
    }

    fn frame(&self) -> Frame {
        self.agents.frame(self.time(), &self.list())
    }

    fn links(&self) -> Vec<(usize, usize)> {
        self.agents.links()
    }

    fn observe(&self) -> Result<Vec<Observable>, ArithmeticError> {
        self.agents.observe(self.time(), &self.list())
    }

    fn declaration(&self) -> Vec<String> {
        let mut lines = self.agents.declaration();
        lines.push(format!(
            "integrator: Dormand and Prince of order 8, error of a step at most {0:e} + {0:e} |y| in each component; states between steps by a step of full order",
            self.options.tolerance.relative
        ));
        lines.push("every arrival of a pair at the radius is located to rounding; where the motion has several ways on (Filippov), pairs stay on their side, and a pair that starts at the radius is not linked; remarks tell where".to_string());
        lines
    }

    fn remarks(&self) -> Vec<String> {
        told(self.known.remarks()).into_iter().chain(self.known.warning()).collect()
    }
}
