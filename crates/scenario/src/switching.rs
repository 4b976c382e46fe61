//! Velocity alignment with links within a radius, followed by the motions of [`models::double_integrator`]: every arrival at the radius
//! is located, and what has several ways on is followed as a Filippov solution.

use super::agents::Agents;
use super::error::RunError;
use super::known::{Known, options, told};
use super::simulation::{Event, Follower};
use arithmetic::Progress;
use models::double_integrator::{Flock, Motion, Options};

/// A flock with the motion that is known once it was planned.
pub(super) struct Switching {
    agents: Agents,
    flock: Flock,
    options: Options,
    known: Known,
    time: f64,
    list: Vec<f64>,
}

impl Switching {
    /// A flock at its start.
    pub fn new(agents: Agents, flock: Flock, tolerance: f64) -> Self {
        let known = Known::new((Motion::default(), Ok(())));
        let list = flock.start().to_list();
        Switching { agents, flock, options: options(tolerance), known, time: 0.0, list }
    }
}

impl Follower for Switching {
    type Law = Agents;

    fn plan(&mut self, times: &[f64], progress: &dyn Progress) {
        let until = times.last().copied().unwrap_or(0.0);
        self.known = Known::new(self.flock.run_as_far(until, times, &self.options, progress));
    }

    fn go(&mut self, until: f64, events: &mut Vec<Event>, _: &dyn Progress) -> Result<bool, RunError> {
        let Some(sample) = self.known.next(until, events)? else { return Ok(false) };
        self.agents.relink(&sample.links);
        (self.time, self.list) = (sample.time, sample.state.to_list());
        Ok(true)
    }

    fn at(&self) -> (&Agents, f64, &[f64]) {
        (&self.agents, self.time, &self.list)
    }

    fn method(&self) -> Vec<String> {
        vec![format!(
            "integrator: Dormand and Prince of order 8, error of a step at most {0:e} + {0:e} |y| in each component; states between steps by a step of full order",
            self.options.tolerance.relative
        ), "every arrival of a pair at the radius is located to rounding; where the motion has several ways on (Filippov), pairs stay on their side, and a pair that starts at the radius is not linked; remarks tell where".to_string()]
    }

    fn special(&self) -> Vec<String> {
        told(self.known.remarks()).into_iter().chain(self.known.warning()).collect()
    }
}
