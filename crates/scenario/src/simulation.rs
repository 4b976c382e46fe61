//! A model on its way in time: what every model shows, and the continuous ones with their integrator and switches.

use super::error::RunError;
use super::links::Guard;
use super::network::Change;
use super::observables::Observable;
use arithmetic::{ArithmeticError, Progress};
use motion::{FollowError, IntegrationError, Integrator, Tolerance, step_to_crossing};
use std::cell::RefCell;

/// Where the agents are; lists that the model does not have are empty.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Frame {
    /// One list of coordinates for each agent.
    pub positions: Vec<Vec<f64>>,
    /// One list of coordinates for each agent.
    pub velocities: Vec<Vec<f64>>,
    /// Radians, not reduced to one turn.
    pub phases: Vec<f64>,
    /// Centres of the circles that steered particles would fly on without control, one list of coordinates for each.
    pub centres: Vec<Vec<f64>>,
    /// Of a law of one's own, every part of the state by its name; then the other lists serve pictures only.
    pub own: Vec<(String, Part)>,
}

/// Something that each agent has.
#[derive(Debug, Clone, PartialEq)]
pub enum Part {
    /// One list of coordinates for each agent.
    Vectors(Vec<Vec<f64>>),
    /// One number for each agent.
    Numbers(Vec<f64>),
}

impl Part {
    /// Numbers of each agent; none where it is one number and no vector.
    pub fn width(&self) -> Option<usize> {
        match self {
            Part::Vectors(list) => list.first().map(Vec::len),
            Part::Numbers(_) => None,
        }
    }

    /// All numbers, agent by agent.
    pub fn flat(&self) -> Vec<f64> {
        match self {
            Part::Vectors(list) => list.concat(),
            Part::Numbers(list) => list.clone(),
        }
    }

    /// The numbers of an agent.
    pub fn of(&self, agent: usize) -> &[f64] {
        match self {
            Part::Vectors(list) => list.get(agent).map_or(&[], Vec::as_slice),
            Part::Numbers(list) => list.get(agent).map_or(&[], std::slice::from_ref),
        }
    }
}

impl Frame {
    /// What each agent has, by its name: positions, velocities, phases, centres as far as the model has them; the parts of the state of a law of one's
    /// own.
    pub fn parts(&self) -> Vec<(&str, Part)> {
        if !self.own.is_empty() {
            return self.own.iter().map(|(name, part)| (name.as_str(), part.clone())).collect();
        }
        let vectors = |list: &Vec<Vec<f64>>| Part::Vectors(list.clone());
        let all = [
            ("positions", vectors(&self.positions), self.positions.is_empty()),
            ("velocities", vectors(&self.velocities), self.velocities.is_empty()),
            ("phases", Part::Numbers(self.phases.clone()), self.phases.is_empty()),
            ("centres", vectors(&self.centres), self.centres.is_empty()),
        ];
        all.into_iter().filter(|(.., empty)| !empty).map(|(name, part, _)| (name, part)).collect()
    }

    /// The number of agents.
    pub fn agents(&self) -> usize {
        self.positions.len().max(self.phases.len())
    }
}

/// A link that came or went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// When.
    pub time: f64,
    /// Whether it came.
    pub gained: bool,
    /// The agents from 1, the smaller number first; of an arc the one that senses the other first.
    pub pair: (usize, usize),
}

impl Event {
    pub(super) fn new(time: f64, change: &Change) -> Self {
        Event { time, gained: change.gained, pair: (change.pair.0 + 1, change.pair.1 + 1) }
    }
}

/// A model that can be moved forward in time.
pub(super) trait Simulation {
    /// Tells beforehand all times that will be asked for; models that are followed step by step need no plan.
    fn plan(&mut self, _times: &[f64], _progress: &dyn Progress) {}

    /// Moves to a time that is not before the last one; `false` where `progress` told to stop before.
    fn advance(&mut self, until: f64, events: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError>;

    /// Where the agents are.
    fn frame(&self) -> Frame;

    /// What is measured there.
    fn observe(&self) -> Result<Vec<Observable>, ArithmeticError>;

    /// Who is linked with whom, agents from 0; nothing where that is not told.
    fn links(&self) -> Vec<(usize, usize)> {
        Vec::new()
    }

    /// What is run, in words: equations and every choice that the configuration leaves open.
    fn declaration(&self) -> Vec<String>;

    /// What was special about the run, in words.
    fn remarks(&self) -> Vec<String> {
        Vec::new()
    }
}

/// A model in continuous time: `dy/dt = f(t, y)`, with links that are held between switches.
pub(super) trait Law {
    /// Writes `f(t, y)`.
    fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]) -> Result<(), ArithmeticError>;

    /// Whether anything ever switches; by default nothing does.
    fn switches(&self) -> bool {
        false
    }

    /// What may fail, so that something has to switch, while no component of the state moves by more than `moved`.
    fn guards(&self, _state: &[f64], _moved: &[f64]) -> Vec<Guard> {
        Vec::new()
    }

    /// Switches what is due.
    fn switch(&mut self, _state: &[f64]) -> Vec<Change> {
        Vec::new()
    }

    /// When something is replaced whatever the state is, if ever again.
    fn next_time(&self) -> Option<f64> {
        None
    }

    /// Up to when, from one time to another, nothing is replaced.
    fn held_until(&self, from: f64, until: f64) -> f64 {
        self.next_time().map_or(until, |due| due.clamp(from, until))
    }

    /// Replaces what is due at that time.
    fn replace(&mut self, _state: &[f64]) -> Vec<Change> {
        Vec::new()
    }

    /// Makes everything that is held between switches anew from a state.
    fn settle(&mut self, _state: &[f64]) {}

    /// Where the agents are.
    fn frame(&self, time: f64, state: &[f64]) -> Frame;

    /// What is measured there.
    fn observe(&self, time: f64, state: &[f64]) -> Result<Vec<Observable>, ArithmeticError>;

    /// Who is linked with whom, agents from 0; nothing where that is not told.
    fn links(&self) -> Vec<(usize, usize)> {
        Vec::new()
    }

    /// What is run, in words.
    fn declaration(&self) -> Vec<String>;

    /// What was special about the run, in words.
    fn remarks(&self) -> Vec<String> {
        Vec::new()
    }
}

/// A law on its way: what is shown is what the law shows where it is.
pub(super) trait Follower {
    /// The law.
    type Law: Law;

    /// As [`Simulation::plan`].
    fn plan(&mut self, _times: &[f64], _progress: &dyn Progress) {}

    /// As [`Simulation::advance`].
    fn go(&mut self, until: f64, events: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError>;

    /// The law, the time and the state.
    fn at(&self) -> (&Self::Law, f64, &[f64]);

    /// How it is followed, in words.
    fn method(&self) -> Vec<String>;

    /// What was special about the run, in words.
    fn special(&self) -> Vec<String> {
        self.at().0.remarks()
    }
}

impl<T: Follower> Simulation for T {
    fn plan(&mut self, times: &[f64], progress: &dyn Progress) {
        Follower::plan(self, times, progress);
    }

    fn advance(&mut self, until: f64, events: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError> {
        self.go(until, events, progress)
    }

    fn frame(&self) -> Frame {
        let (law, time, state) = self.at();
        law.frame(time, state)
    }

    fn observe(&self) -> Result<Vec<Observable>, ArithmeticError> {
        let (law, time, state) = self.at();
        law.observe(time, state)
    }

    fn links(&self) -> Vec<(usize, usize)> {
        self.at().0.links()
    }

    fn declaration(&self) -> Vec<String> {
        [self.at().0.declaration(), self.method()].concat()
    }

    fn remarks(&self) -> Vec<String> {
        self.special()
    }
}

/// Replaces what is due by a time, whatever the state is; whether anything was.
pub(super) fn replace_due(law: &mut impl Law, time: f64, state: &[f64], events: &mut Vec<Event>) -> bool {
    let mut replaced = false;
    while law.next_time().is_some_and(|due| due <= time) {
        events.extend(law.replace(state).iter().map(|change| Event::new(time, change)));
        replaced = true;
    }
    replaced
}

/// A law with its solution.
pub(super) struct Continuous<L> {
    law: L,
    solution: Integrator,
    tolerance: Tolerance,
    /// Switches in a row that took no time worth speaking of, and when the last switch was.
    crowd: (usize, f64),
    /// Steps tried in vain, all steps tried and the time at the last look at the pace.
    pace: (usize, usize, f64),
}

/// So many switches in no time are taken for a sliding motion; more in a state of many numbers, where each may switch once.
const LARGEST_CROWD: usize = 1000;

/// The pace of the steps is looked at after so many tries.
const TRIES: usize = 1 << 14;

/// More tries than these to the next time that is asked are not taken where a third of them are in vain: a jump of the law that the motion does not leave.
const MOST_TRIES: f64 = 1048576.0;

impl<L: Law> Continuous<L> {
    /// The law at its start.
    pub fn new(law: L, state: &[f64], tolerance: f64) -> Self {
        let tolerance = Tolerance { relative: tolerance, absolute: tolerance };
        Continuous {
            law,
            solution: Integrator::new(0.0, state, tolerance),
            tolerance,
            crowd: (0, 0.0),
            pace: (0, 0, 0.0),
        }
    }

    /// Goes on from a state after a change.
    fn restart(&mut self, time: f64, state: &[f64]) {
        self.solution = Integrator::new(time, state, self.tolerance);
        self.pace = (0, 0, time);
    }

    /// Whether the steps have become so short, by being refused, that the motion does not get to a time.
    fn is_caught(&mut self, until: f64) -> bool {
        let (steps, rejected) = self.solution.counts();
        let (vain, tries, from) = self.pace;
        if steps + rejected < tries + TRIES {
            return false;
        }
        let time = self.solution.time();
        self.pace = (rejected, steps + rejected, time);
        3 * (rejected - vain) > TRIES && (until - time) * TRIES as f64 > MOST_TRIES * (time - from)
    }

    /// Replaces what is due by now.
    fn replace_due(&mut self, events: &mut Vec<Event>) {
        let time = self.solution.time();
        if replace_due(&mut self.law, time, self.solution.state(), events) {
            let state = self.solution.state().to_vec();
            self.restart(time, &state);
        }
    }

    /// One step, up to the next switch at most; whether there was one.
    fn step(&mut self, until: f64) -> Result<Option<(f64, Vec<f64>)>, RunError> {
        let failure = RefCell::new(None);
        let law = &self.law;
        let mut field = |time: f64, state: &[f64], rate: &mut [f64]| {
            if let Err(error) = law.rate(time, state, rate) {
                failure.replace(Some(error));
                rate.fill(f64::NAN);
            }
        };
        let moved = if law.switches() {
            step_to_crossing(&mut field, &mut self.solution, until, |state, moved| law.guards(state, moved))
        } else {
            self.solution.step(&mut field, until).map(|()| None)
        };
        let explained = |error| match (error, failure.take()) {
            (IntegrationError::Stuck(time), Some(error)) => FollowError::Law { time, error },
            (error, _) => FollowError::Integration(error),
        };
        Ok(moved.map_err(explained)?.map(|crossing| (crossing.time, crossing.state)))
    }
}

impl<L: Law> Follower for Continuous<L> {
    type Law = L;

    fn go(&mut self, until: f64, events: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError> {
        while self.solution.time() < until {
            if progress.is_cancelled() {
                return Ok(false);
            }
            let end = self.law.held_until(self.solution.time(), until);
            if let Some((time, state)) = self.step(end)? {
                let changes = self.law.switch(&state);
                events.extend(changes.iter().map(|change| Event::new(time, change)));
                self.restart(time, &state);
                let (count, last) = self.crowd;
                self.crowd = (if time - last > 1e-9 * (1.0 + time) { 0 } else { count + 1 }, time);
                if self.crowd.0 > LARGEST_CROWD.max(4 * state.len()) {
                    return Err(FollowError::Sliding(time).into());
                }
            }
            self.replace_due(events);
            if self.is_caught(until) {
                return Err(FollowError::Jumps(self.solution.time()).into());
            }
        }
        Ok(true)
    }

    fn at(&self) -> (&L, f64, &[f64]) {
        (&self.law, self.solution.time(), self.solution.state())
    }

    fn method(&self) -> Vec<String> {
        let mut lines = vec![format!(
            "integrator: Dormand and Prince of order 8, error of a step at most {0:e} + {0:e} |y| in each component; steps end at every time that is written",
            self.tolerance.relative
        )];
        if self.law.switches() {
            lines.push("the links stay as they are between switches, and each switch is located to rounding; a pair at exactly the switching distance at the start is linked if it approaches".to_string());
        }
        lines
    }
}
