//! Links that depend on distances in large flocks: every switch is located, and each agent has steps of its own.

use super::error::RunError;
use super::known::{Known, told};
use super::network::{Change, Network, Rule};
use super::simulation::{Event, Follower, Law};
use arithmetic::{ArithmeticError, Progress};
use motion::{FollowError, IndividualFlock, IndividualLaw, Moving, Pace, Sensing};

/// Most agents that are followed all in the same steps where each switch can be located: each one costs a look at all. Larger flocks have individual
/// steps.
pub(super) const MOST_TOGETHER: usize = 256;

/// Who senses whom in a network that depends on distances.
pub(super) fn sensing(network: &Network) -> Option<Sensing> {
    match network.rule() {
        Rule::Fixed => None,
        Rule::Within(radius) => Some(Sensing::Within(radius)),
        Rule::Nearest(_) => Some(Sensing::Nearest),
    }
}

/// What is measured on agents that are followed one by one, with `F` further states each.
pub(super) trait Located<const F: usize>: Law {
    /// What becomes of motions along the radius, in words.
    const STAYING: Option<&str> = None;

    /// Who is linked.
    fn network(&mut self) -> &mut Network;

    /// The state as a list.
    fn list(agents: &[Moving<f64, F>]) -> Vec<f64>;

    /// The agents of such a list.
    fn agents(&self, list: &[f64]) -> Vec<Moving<f64, F>>;

    /// The motion with all in the same steps from a state in which pairs do as good as stay at the radius, with the links that are shown, until none
    /// stays; samples at some times, and one at the end. Nothing for models and flocks that are not followed so.
    fn stay(&self, _from: f64, _list: &[f64], _to: &Sampling) -> Option<Known> {
        None
    }

    /// An energy that never rises in the exact motion, if there is one.
    fn energy(&self, _list: &[f64]) -> Result<Option<f64>, ArithmeticError> {
        Ok(None)
    }
}

/// Where a motion is to go.
pub(super) struct Sampling<'a> {
    pub times: &'a [f64],
    pub tolerance: f64,
    pub progress: &'a dyn Progress,
}

/// A flock with individual steps.
pub(super) struct Individual<S, L, const F: usize, const M: usize> {
    shown: S,
    flock: IndividualFlock<L, F, M>,
    sensing: Sensing,
    tolerance: f64,
    /// Where it is.
    time: f64,
    list: Vec<f64>,
    /// All times that will be asked for.
    times: Vec<f64>,
    /// The motion while pairs stay at the radius.
    known: Option<Known>,
    remarks: Vec<(f64, String)>,
    warning: Option<String>,
    /// The energy at the last time that was asked for, and its largest rise from one of these times to the next.
    energy: f64,
    rise: f64,
}

impl<S: Located<F>, L: IndividualLaw<F, M> + Clone, const F: usize, const M: usize> Individual<S, L, F, M> {
    /// A flock at its start, with the links that the agents have there.
    pub fn new(mut shown: S, law: L, sensing: Sensing, list: Vec<f64>, tolerance: f64) -> Result<Self, FollowError> {
        let (start, pace) = (shown.agents(&list), Pace::Tolerance(tolerance));
        let flock = IndividualFlock::new(law, sensing, &start, shown.network().pairs(), pace)?;
        let (times, remarks, known, warning) = (Vec::new(), Vec::new(), None, None);
        let (time, energy, rise) = (0.0, f64::INFINITY, 0.0);
        Ok(Individual { shown, flock, sensing, tolerance, time, list, times, known, remarks, warning, energy, rise })
    }

    /// Takes over where the agents are one by one.
    fn look(&mut self) {
        self.time = self.flock.time();
        self.list = S::list(&self.flock.agents().collect::<Vec<_>>());
        self.shown.network().set_pairs(self.flock.links());
    }

    /// Follows all together while pairs stay at the radius.
    fn stay(&mut self, progress: &dyn Progress) -> Result<(), RunError> {
        self.look();
        let times: Vec<f64> = self.times.iter().copied().filter(|time| *time >= self.time).collect();
        let sampling = Sampling { times: &times, tolerance: self.tolerance, progress };
        let known = self.shown.stay(self.time, &self.list, &sampling).ok_or(FollowError::Sliding(self.time))?;
        self.remarks.extend(known.remarks());
        self.warning = self.warning.take().or(known.warning());
        self.known = Some(known);
        Ok(())
    }

    /// Goes on as far as the motion with all together is known; `None` where no pair stays at the radius any more.
    fn follow(&mut self, until: f64, events: &mut Vec<Event>) -> Result<Option<bool>, RunError> {
        while let Some(known) = &mut self.known {
            if known.is_over() {
                let (start, links) = (self.shown.agents(&self.list), self.shown.network().pairs());
                self.flock = self.flock.resumed(self.time, &start, links)?;
                self.known = None;
                return Ok(None);
            }
            let Some(sample) = known.next(until, events)? else { return Ok(Some(false)) };
            self.time = sample.time;
            self.list = sample.state.to_list();
            self.shown.network().set_pairs(sample.links.clone());
            if self.time >= until {
                return Ok(Some(true));
            }
        }
        Ok(None)
    }

    /// Goes on, one by one or together; `false` where `progress` told to stop before.
    fn follow_on(&mut self, until: f64, events: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError> {
        loop {
            if let Some(went) = self.follow(until, events)? {
                return Ok(went);
            }
            let mut switches = Vec::new();
            let went = self.flock.advance(until, &mut switches, progress);
            let event = |s: &motion::Switch| Event::new(s.time, &Change { gained: s.gained, pair: s.pair });
            events.extend(switches.iter().map(event));
            match went {
                Err(FollowError::Sliding(_)) => self.stay(progress)?,
                went => {
                    let went = went?;
                    self.look();
                    return Ok(went);
                }
            }
        }
    }
}

impl<S: Located<F>, L: IndividualLaw<F, M> + Clone, const F: usize, const M: usize> Follower
    for Individual<S, L, F, M>
{
    type Law = S;

    fn plan(&mut self, times: &[f64], _: &dyn Progress) {
        self.times = times.to_vec();
    }

    fn go(&mut self, until: f64, events: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError> {
        if !self.follow_on(until, events, progress)? {
            return Ok(false);
        }
        if let Some(energy) = self.shown.energy(&self.list).map_err(|error| RunError::law(until, error))? {
            self.rise = self.rise.max(energy - self.energy);
            self.energy = energy;
        }
        Ok(true)
    }

    fn at(&self) -> (&S, f64, &[f64]) {
        (&self.shown, self.time, &self.list)
    }

    fn method(&self) -> Vec<String> {
        let angles = if F > 0 { format!(", and in the angle {:e}", self.tolerance) } else { String::new() };
        let mut lines = vec![format!(
            "integrator: individual steps, since the flock is large: the motion of each agent is made of power series in time of order 6, whose last terms in the velocity are at most {0:e} + {0:e} |v|{angles}",
            self.tolerance
        )];
        let switch = match self.sensing {
            Sensing::Within(_) => {
                "every arrival of a pair at the radius is located to rounding on the series of the two, which then start"
            }
            Sensing::Nearest => {
                "every change among the nearest is located to rounding on the series of the three concerned; that of the one that senses the others then starts"
            }
        };
        lines.push(format!("{switch} anew, as do those of all agents whose velocity it changes by more than a quarter of that on one series"));
        lines.extend(S::STAYING.map(str::to_string));
        lines
    }

    fn special(&self) -> Vec<String> {
        let rise = format!(
            "the energy Q rose by up to {:.1e} from one written time to the next, which the exact motion never does",
            self.rise
        );
        let rises = (self.rise > 0.0).then_some(rise);
        told(self.remarks.clone()).into_iter().chain(self.warning.clone()).chain(rises).collect()
    }
}
