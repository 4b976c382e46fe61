//! Velocity alignment with links within a radius in large flocks: every switch is located, and each agent has steps of its own.

use super::agents::Agents;
use super::error::RunError;
use super::network::Change;
use super::observables::Observable;
use super::simulation::{Event, Frame, Law, Simulation};
use arithmetic::{ArithmeticError, Progress};
use models::double_integrator::{IndividualError, IndividualFlock, Pace, State};

/// A flock with individual steps.
pub(super) struct Individual {
    agents: Agents,
    flock: IndividualFlock,
    tolerance: f64,
    /// Where it is.
    time: f64,
    list: Vec<f64>,
    /// The energy at the last time that was asked for, and its largest rise from one of these times to the next.
    energy: f64,
    rise: f64,
}

impl Individual {
    /// A flock at its start, with the links that the agents have there.
    pub fn new(agents: Agents, radius: f64, state: &State<f64>, tolerance: f64) -> Result<Self, IndividualError> {
        let pace = Pace::Tolerance(tolerance);
        let flock = IndividualFlock::new(agents.potential.exact(), radius, state, agents.network.pairs(), pace)?;
        let list = state.to_list();
        Ok(Individual { agents, flock, tolerance, time: 0.0, list, energy: f64::INFINITY, rise: 0.0 })
    }
}

impl Simulation for Individual {
    fn advance(&mut self, until: f64, events: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError> {
        let mut switches = Vec::new();
        let went = self.flock.advance(until, &mut switches, progress);
        let event =
            |s: &models::double_integrator::Switch| Event::new(s.time, &Change { gained: s.gained, pair: s.pair });
        events.extend(switches.iter().map(event));
        if !went? {
            return Ok(false);
        }
        self.time = until;
        self.list = self.flock.state().to_list();
        self.agents.relink(&self.flock.links());
        let energy = self.agents.saturated_energy(&self.list).map_err(|error| RunError::Law { time: until, error })?;
        self.rise = self.rise.max(energy - self.energy);
        self.energy = energy;
        Ok(true)
    }

    fn frame(&self) -> Frame {
        self.agents.frame(self.time, &self.list)
    }

    fn links(&self) -> Vec<(usize, usize)> {
        self.agents.links()
    }

    fn observe(&self) -> Result<Vec<Observable>, ArithmeticError> {
        self.agents.observe(self.time, &self.list)
    }

    fn declaration(&self) -> Vec<String> {
        let mut lines = self.agents.declaration();
        lines.push(format!(
            "integrator: individual steps, since the flock is large: the motion of each agent is made of power series in time of order 6, whose last terms in the velocity are at most {0:e} + {0:e} |v|",
            self.tolerance
        ));
        lines.push("every arrival of a pair at the radius is located to rounding on the series of the two, which then start anew, as do those of all agents whose velocity it changes by more than a quarter of that on one series; a motion along the radius (Filippov) is not followed but ends the run".to_string());
        lines
    }

    fn remarks(&self) -> Vec<String> {
        let rise = format!(
            "the energy Q rose by up to {:.1e} from one written time to the next, which the exact motion never does",
            self.rise
        );
        (self.rise > 0.0).then_some(rise).into_iter().collect()
    }
}
