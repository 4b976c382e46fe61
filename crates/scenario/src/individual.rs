//! Links within a radius in large flocks: every switch is located, and each agent has steps of its own.

use super::error::RunError;
use super::network::{Change, Network};
use super::observables::Observable;
use super::simulation::{Event, Frame, Law, Simulation};
use arithmetic::{ArithmeticError, Progress};
use motion::{FollowError, IndividualFlock, IndividualLaw, Moving, Pace};

/// Most agents that are followed all in the same steps where each switch can be located: each one costs a look at all. Larger flocks have individual
/// steps.
pub(super) const MOST_TOGETHER: usize = 256;

/// What is measured on agents that are followed one by one, with `F` further states each.
pub(super) trait Located<const F: usize>: Law {
    /// Who is linked.
    fn network(&mut self) -> &mut Network;

    /// The state as a list.
    fn list(agents: &[Moving<f64, F>]) -> Vec<f64>;

    /// An energy that never rises in the exact motion, if there is one.
    fn energy(&self, _list: &[f64]) -> Result<Option<f64>, ArithmeticError> {
        Ok(None)
    }
}

/// A flock with individual steps.
pub(super) struct Individual<S, L, const F: usize, const M: usize> {
    shown: S,
    flock: IndividualFlock<L, F, M>,
    tolerance: f64,
    /// Where it is.
    time: f64,
    list: Vec<f64>,
    /// The energy at the last time that was asked for, and its largest rise from one of these times to the next.
    energy: f64,
    rise: f64,
}

impl<S: Located<F>, L: IndividualLaw<F, M>, const F: usize, const M: usize> Individual<S, L, F, M> {
    /// A flock at its start, with the links that the agents have there.
    pub fn new(
        mut shown: S,
        law: L,
        radius: f64,
        start: &[Moving<f64, F>],
        tolerance: f64,
    ) -> Result<Self, FollowError> {
        let flock = IndividualFlock::new(law, radius, start, shown.network().pairs(), Pace::Tolerance(tolerance))?;
        Ok(Individual { shown, flock, tolerance, time: 0.0, list: S::list(start), energy: f64::INFINITY, rise: 0.0 })
    }
}

impl<S: Located<F>, L: IndividualLaw<F, M>, const F: usize, const M: usize> Simulation for Individual<S, L, F, M> {
    fn advance(&mut self, until: f64, events: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError> {
        let mut switches = Vec::new();
        let went = self.flock.advance(until, &mut switches, progress);
        let event = |s: &motion::Switch| Event::new(s.time, &Change { gained: s.gained, pair: s.pair });
        events.extend(switches.iter().map(event));
        if !went? {
            return Ok(false);
        }
        self.time = until;
        self.list = S::list(&self.flock.agents().collect::<Vec<_>>());
        self.shown.network().set_pairs(self.flock.links());
        if let Some(energy) = self.shown.energy(&self.list).map_err(|error| RunError::law(until, error))? {
            self.rise = self.rise.max(energy - self.energy);
            self.energy = energy;
        }
        Ok(true)
    }

    fn frame(&self) -> Frame {
        self.shown.frame(self.time, &self.list)
    }

    fn links(&self) -> Vec<(usize, usize)> {
        self.shown.links()
    }

    fn observe(&self) -> Result<Vec<Observable>, ArithmeticError> {
        self.shown.observe(self.time, &self.list)
    }

    fn declaration(&self) -> Vec<String> {
        let mut lines = self.shown.declaration();
        let angles = if F > 0 { format!(", and in the angle {:e}", self.tolerance) } else { String::new() };
        lines.push(format!(
            "integrator: individual steps, since the flock is large: the motion of each agent is made of power series in time of order 6, whose last terms in the velocity are at most {0:e} + {0:e} |v|{angles}",
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
