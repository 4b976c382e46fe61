//! Velocity alignment with links within a radius, followed by the motions of [`models::double_integrator`]: every arrival at the radius
//! is located, and what has several ways on is followed as a Filippov solution.

use super::agents::Agents;
use super::error::RunError;
use super::known::{Known, options, told};
use super::observables::Observable;
use super::simulation::{Event, Frame, Law, Simulation};
use arithmetic::{ArithmeticError, Progress};
use models::double_integrator::{Flock, Motion, Options};

/// A flock with the motion that is known once it was planned.
pub(super) struct Switching {
    agents: Agents,
    flock: Flock,
    options: Options,
    known: Known,
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
        self.known = Known::new(self.flock.run_as_far(until, times, &self.options, progress));
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
