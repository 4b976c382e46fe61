//! Fixed steps, for many agents whose links depend on distances: each stage reads the links off the positions, neighbours by cells;
//! switches are passed over.

use super::error::{ConfigError, RunError};
use super::network::Network;
use super::simulation::{Event, Follower, Law, replace_due};
use super::source::Source;
use arithmetic::Progress;
use arithmetic::threads::on_a_thread;
use motion::{CellList, Rk4};
use std::ops::Range;

/// Writes the rate of change at a time and state.
type Rate<L> = Box<dyn FnMut(&mut L, f64, &[f64], &mut [f64]) -> Result<(), RunError> + Send>;

/// A law with its state.
pub(super) struct Stepped<L> {
    law: L,
    rate: Rate<L>,
    method: Rk4,
    list: Vec<f64>,
    time: f64,
    /// The longest step.
    step: f64,
    arrangement: Option<Arrangement>,
}

/// How the agents of a large flock are brought into the order of their places, so that neighbours in the plane are neighbours in memory: without it
/// a step of 10⁶ agents waits for memory most of the time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Arrangement {
    /// How many numbers of each agent the parts of the state have, that of the positions first.
    pub widths: &'static [usize],
    /// About how far neighbours are.
    pub radius: f64,
}

/// Numbers of a state from which a rate may be shared out among threads.
const LEAST_SHARED: usize = 1024;

/// Smaller flocks stay as they are.
const LEAST_ARRANGED: usize = 1 << 14;

/// Steps after which agents are arranged anew.
const ARRANGED_FOR: usize = 64;

impl Arrangement {
    /// The agents in the order of their cells; nothing for small flocks and where places are not finite.
    fn order(&self, list: &[f64]) -> Option<Vec<usize>> {
        let count = list.len() / self.widths.iter().sum::<usize>();
        if count < LEAST_ARRANGED {
            return None;
        }
        let points: Vec<[f64; 2]> = list[..2 * count].as_chunks().0.to_vec();
        CellList::new(&points, self.radius).ok().map(|cells| cells.numbers().to_vec())
    }

    /// The state with each agent `order[k]` in place `k`, or the other way round.
    fn renumbered(&self, list: &[f64], order: &[usize], back: bool) -> Vec<f64> {
        let mut to = vec![0.0; list.len()];
        let mut start = 0;
        for &width in self.widths {
            for (place, &agent) in order.iter().enumerate() {
                let (from, into) = if back { (place, agent) } else { (agent, place) };
                let (from, into) = (start + from * width, start + into * width);
                to[into..into + width].copy_from_slice(&list[from..from + width]);
            }
            start += width * order.len();
        }
        to
    }
}

/// The length of fixed steps, where `[run]` asks for them.
pub(super) fn read_step(source: &Source, network: &Network) -> Result<Option<f64>, ConfigError> {
    let Some(entry) = source.needed("run")?.get("step") else { return Ok(None) };
    if !network.switches() {
        return Err(entry.range("left out: only links that depend on distances are followed in fixed steps"));
    }
    entry.positive().map(Some)
}

/// How many steps go from one time to another, and how long they are: at most `step`, but for a remainder of a hair's breadth.
pub(super) fn steps_to(from: f64, until: f64, step: f64) -> (usize, f64) {
    let steps = ((until - from) / step * (1.0 - 1e-12)).ceil().max(0.0);
    (steps as usize, (until - from) / steps.max(1.0))
}

impl<L: Law> Stepped<L> {
    /// A law at its start, with its rate where the links are those of the positions.
    pub fn new(law: L, list: Vec<f64>, step: f64, rate: Rate<L>) -> Self {
        Stepped { law, rate, method: Rk4::new(list.len()), list, time: 0.0, step, arrangement: None }
    }

    /// With agents that are arranged on the way, for a law to which their numbers mean nothing.
    pub fn arranged(self, arrangement: Arrangement) -> Self {
        Stepped { arrangement: Some(arrangement), ..self }
    }

    /// A law at its start, which is settled before its rate is asked for.
    pub fn settled(law: L, list: Vec<f64>, step: f64) -> Self {
        let rate = |law: &mut L, time: f64, list: &[f64], rate: &mut [f64]| {
            law.settle(list);
            law.rate(time, list, rate).map_err(|error| RunError::law(time, error))
        };
        Stepped::new(law, list, step, Box::new(rate))
    }

    fn single_step(&mut self, length: f64) -> Result<(), RunError> {
        let (law, rate) = (&mut self.law, &mut self.rate);
        let mut failure = None;
        let mut field = |time: f64, list: &[f64], slope: &mut [f64]| {
            if failure.is_none() {
                failure = rate(law, time, list, slope).err();
            }
        };
        self.method.step(&mut field, self.time, length, &mut self.list);
        failure.map_or(Ok(()), Err)
    }

    /// Some steps of one length, counted from a time; `false` where `progress` told to stop before.
    fn several(
        &mut self,
        (from, length): (f64, f64),
        steps: Range<usize>,
        progress: &dyn Progress,
    ) -> Result<bool, RunError> {
        for taken in steps {
            if progress.is_cancelled() {
                return Ok(false);
            }
            self.single_step(length)?;
            self.time = from + (taken + 1) as f64 * length;
        }
        Ok(true)
    }
}

impl<L: Law + Send> Stepped<L> {
    /// Equal steps to a time; `false` where `progress` told to stop before.
    fn steps_until(&mut self, until: f64, progress: &dyn Progress) -> Result<bool, RunError> {
        let from = self.time;
        let (steps, length) = steps_to(from, until, self.step);
        let mut taken = 0;
        while taken < steps {
            let until = steps.min(taken + ARRANGED_FOR);
            let arranged = self.arrangement.and_then(|arrangement| Some((arrangement, arrangement.order(&self.list)?)));
            if let Some((arrangement, order)) = &arranged {
                self.list = arrangement.renumbered(&self.list, order, false);
            }
            let ended = if self.list.len() < LEAST_SHARED {
                self.several((from, length), taken..until, progress)
            } else {
                on_a_thread(|| self.several((from, length), taken..until, progress))
            };
            if let Some((arrangement, order)) = &arranged {
                self.list = arrangement.renumbered(&self.list, order, true);
            }
            if !ended? {
                return Ok(false);
            }
            taken = until;
        }
        self.time = until;
        Ok(true)
    }
}

impl<L: Law + Send> Follower for Stepped<L> {
    type Law = L;

    fn go(&mut self, until: f64, events: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError> {
        while self.time < until {
            let end = self.law.held_until(self.time, until);
            if !self.steps_until(end, progress)? {
                return Ok(false);
            }
            replace_due(&mut self.law, end, &self.list, events);
        }
        self.law.settle(&self.list);
        Ok(true)
    }

    fn at(&self) -> (&L, f64, &[f64]) {
        (&self.law, self.time, &self.list)
    }

    fn method(&self) -> Vec<String> {
        vec![format!(
            "integrator: the classical method of Runge and Kutta of order 4, equal steps of at most {} from each time that is written to the next, rows of trajectory.csv included; links are read off the positions in every stage: switches are neither located nor listed, and the tolerance has no effect",
            self.step
        )]
    }
}
