//! New series: of one agent whose series ended, and of all that notice a switch.

use super::influence::{Influences, Neighbour};
use super::path::{ORDER, Path};
use super::{IndividualFlock, IndividualLaw, Pace, Rates};
use crate::{FollowError, IntegrationError, Jet};
use std::convert::identity;

/// A switch is noticed by an agent where it changes the velocity or a further state, until the agent's series ends, by more than this part of the
/// tolerance.
const NOTICED: f64 = 0.25;

/// How far a change has come.
struct Spread {
    changed: Vec<usize>,
    /// Those that sense these and do not notice, so far.
    asked: Vec<usize>,
}

impl<L: IndividualLaw<F, M>, const F: usize, const M: usize> IndividualFlock<L, F, M> {
    /// The series of one agent ended: the next one, from the others as they are.
    pub(super) fn prolong(&mut self, time: f64, agent: usize) -> Result<(), FollowError> {
        self.together.begin();
        self.bring(time, agent);
        self.bring_neighbours(time, agent);
        self.coefficients::<ORDER>(time, 1, &[agent])?;
        self.install(time, &[agent])
    }

    /// New series at a time of some agents and of all that notice; who changed.
    ///
    /// What jumps at a switch is the acceleration of the two; of their neighbours its rate of change, and so on. So the series are made one
    /// coefficient after the other, each from those of the neighbours that came before, in ever more agents.
    pub(super) fn spread(&mut self, time: f64, seeds: &[usize]) -> Result<Vec<usize>, FollowError> {
        self.together.begin();
        for &agent in seeds {
            self.together.see(agent);
            self.bring(time, agent);
            self.bring_neighbours(time, agent);
        }
        let mut spread = Spread { changed: seeds.to_vec(), asked: Vec::new() };
        self.level::<1>(time, &mut spread)?;
        self.ask(time, &mut spread, seeds);
        self.level::<2>(time, &mut spread)?;
        self.level::<3>(time, &mut spread)?;
        self.level::<4>(time, &mut spread)?;
        self.level::<5>(time, &mut spread)?;
        self.level::<ORDER>(time, &mut spread)?;
        Ok(spread.changed)
    }

    /// Brings an agent to a time, as it is.
    fn bring(&mut self, time: f64, agent: usize) {
        let (from, law) = (&self.agents[agent], &self.law);
        self.together.add(agent, || {
            let mut path = from.path.after(time - from.from);
            let velocity = law.velocity(&path.at(0.0));
            path.place.iter_mut().zip(velocity).for_each(|(to, v)| to[1] = v);
            path
        });
    }

    /// Brings the neighbours of an agent to a time.
    fn bring_neighbours(&mut self, time: f64, agent: usize) {
        for k in 0..self.agents[agent].neighbours.len() {
            self.bring(time, self.agents[agent].neighbours[k].agent);
        }
    }

    /// The influences of some neighbours on an agent, as series; a number that is not finite is an error.
    fn influences<'a, const K: usize>(
        &'a self,
        time: f64,
        agent: usize,
        neighbours: &'a [Neighbour],
        path: &'a dyn Fn(usize) -> &'a Path<F>,
    ) -> Result<[Jet<f64, K>; M], FollowError> {
        let all = Influences { law: &self.law, own: self.together.path(agent), neighbours, path };
        let found = self.processor.dispatch(all).map_err(|error| FollowError::Law { time, error })?;
        let finite = found.iter().all(|jet| jet.0.iter().all(|c| c.is_finite()));
        if finite { Ok(found) } else { Err(IntegrationError::Stuck(time).into()) }
    }

    /// The rates of change of an agent under some influences, as series.
    fn rates<const K: usize>(
        &self,
        time: f64,
        agent: usize,
        influences: &[Jet<f64, K>; M],
    ) -> Result<Rates<Jet<f64, K>, F>, FollowError> {
        let own = self.together.path(agent).series(identity);
        self.law.rates(&own, influences, Jet::constant).map_err(|error| FollowError::Law { time, error })
    }

    /// The coefficients of some velocities and further states from power `first` to `K`, each from those of the neighbours that come before.
    fn coefficients<const K: usize>(&mut self, time: f64, first: usize, agents: &[usize]) -> Result<(), FollowError> {
        let path = |agent: usize| self.together.path(agent);
        let of = |&agent: &usize| self.influences::<K>(time, agent, &self.agents[agent].neighbours, &path);
        let all: Result<Vec<_>, _> = agents.iter().map(of).collect();
        for (influences, &agent) in all?.iter().zip(agents) {
            let rates = self.rates(time, agent, influences)?;
            let path = self.together.path_mut(agent);
            (first..=K).for_each(|k| path.set(k, &rates));
        }
        Ok(())
    }

    /// By how much the coefficient `K` of an agent's velocity, and of its further states, changes through those of its neighbours that changed.
    fn change<const K: usize>(&self, time: f64, agent: usize) -> Result<(f64, f64), FollowError> {
        let changed = |other: &Neighbour| self.together.is_changed(other.agent);
        let others: Vec<Neighbour> = self.agents[agent].neighbours.iter().copied().filter(changed).collect();
        let (new, old) = (|agent: usize| self.together.path(agent), |agent: usize| self.together.old(agent));
        let is = self.rates(time, agent, &self.influences::<K>(time, agent, &others, &new)?)?;
        let was = self.rates(time, agent, &self.influences::<K>(time, agent, &others, &old)?)?;
        let last = |is: &Jet<f64, K>, was: &Jet<f64, K>| (is.0[K - 1] - was.0[K - 1]) / K as f64;
        let [x, y] = [0, 1].map(|c| last(&is.velocity[c], &was.velocity[c]));
        let further = is.further.iter().zip(&was.further).map(|(is, was)| last(is, was).abs());
        Ok(((x * x + y * y).sqrt(), further.fold(0.0, f64::max)))
    }

    /// One coefficient more for those that changed; of those asked, who notices gets all up to this one, and its neighbours are asked next.
    fn level<const K: usize>(&mut self, time: f64, spread: &mut Spread) -> Result<(), FollowError> {
        self.coefficients::<K>(time, K, &spread.changed)?;
        let (mut noticed, mut not) = (Vec::new(), Vec::new());
        for &agent in &spread.asked {
            let old = &self.agents[agent];
            // Not what is left of its series: its neighbours go on from its coefficients too.
            let length = (old.until - old.from).powi(K as i32);
            let (velocity, further) = self.change::<K>(time, agent)?;
            let few = match self.pace {
                Pace::Fixed(_) => false,
                Pace::Tolerance(tolerance) => {
                    let allowed = NOTICED * tolerance;
                    velocity * length <= allowed * (1.0 + old.path.size(1)) && further * length <= allowed
                }
            };
            if few { not.push(agent) } else { noticed.push(agent) }
        }
        noticed.iter().for_each(|&agent| self.bring_neighbours(time, agent));
        self.coefficients::<K>(time, 1, &noticed)?;
        // Those that do not notice yet are asked again: what comes from the two of a switch can cancel in the first coefficient.
        spread.asked = not;
        self.ask(time, spread, &noticed);
        spread.changed.append(&mut noticed);
        Ok(())
    }

    /// Asks those that sense some that changed.
    fn ask(&mut self, time: f64, spread: &mut Spread, changed: &[usize]) {
        for &agent in changed {
            self.together.set_changed(agent);
        }
        for &agent in changed {
            for k in 0..self.agents[agent].observers.len() {
                let other = self.agents[agent].observers[k];
                if self.together.see(other) {
                    self.bring(time, other);
                    spread.asked.push(other);
                }
            }
        }
    }
}
