//! Motions of [`models::double_integrator`] that are followed to their end before they are told sample by sample.

use super::error::RunError;
use super::network::Change;
use super::simulation::Event;
use models::double_integrator::{EventKind, Motion, MotionError, Options, Sample};
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
