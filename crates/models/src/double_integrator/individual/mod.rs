//! Large flocks with every switch located: each agent has steps of its own, and a switch restarts only the agents that notice it.
//!
//! Method, order and cost: `notes/integrators.md`. The motion of an agent is made of power series in time. All that is to come stands in one queue,
//! in the order of time: that the series of an agent ends, or that a pair comes to the radius on its two series. So the results depend neither
//! on threads nor on the times at which they are asked for.

mod cells;
mod next;
mod path;
mod together;

use super::{Pair, Potential, Slope, State};
use arithmetic::{ArithmeticError, Progress};
use cells::{Cells, Place};
use motion::{IntegrationError, first_fall};
use next::Next;
use path::{Acceleration, ORDER, Path};
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use together::Together;

/// How long the pieces of motion are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pace {
    /// The last terms of each series are below this, absolute and relative to the state.
    Tolerance(f64),
    /// All of this length, or shorter after switches; every switch is noticed by all whose series change.
    Fixed(f64),
}

/// A link that came or went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Switch {
    /// When.
    pub time: f64,
    /// Whether it came.
    pub gained: bool,
    /// The agents from 0, the smaller number first.
    pub pair: Pair,
}

/// Why a flock cannot be followed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum IndividualError {
    /// The series ends, as before a singularity.
    #[error(transparent)]
    Integration(#[from] IntegrationError),
    /// The law has no value.
    #[error("the law has no value near t = {time}: {error}")]
    Law {
        /// When.
        time: f64,
        /// What was asked for.
        error: ArithmeticError,
    },
    /// A pair that switches without end: it stays at the radius.
    #[error("links switch without end at t = {0}: the motion along the switching distance is not followed")]
    Sliding(f64),
}

/// Agents move by at most this part of the radius on one series.
const FARTHEST: f64 = 0.125;

/// The longest series, in units of time.
const LONGEST: f64 = 1.0;

/// A switch is noticed by an agent where it changes the velocity, until the agent's series ends, by more than this part of the tolerance.
const NOTICED: f64 = 0.25;

/// So many switches of an agent at one time are taken for a motion along the radius.
const LARGEST_CROWD: usize = 1000;

/// An agent with its piece of motion.
#[derive(Debug, Clone)]
struct Agent {
    from: f64,
    until: f64,
    /// How far it gets until then.
    reach: f64,
    path: Path,
    restarts: u32,
    /// The round of the last restart.
    round: u64,
    /// When it switched last, and how many switches of it there were about then.
    crowd: (f64, usize),
    /// Sorted.
    neighbours: Vec<usize>,
}

/// How far a change has come.
struct Spread {
    changed: Vec<usize>,
    /// Neighbours of these that do not notice, so far.
    asked: Vec<usize>,
}

/// A flock on its way.
#[derive(Debug, Clone)]
pub struct IndividualFlock {
    radius: f64,
    slope: Slope<f64>,
    pace: Pace,
    time: f64,
    agents: Vec<Agent>,
    cells: Cells,
    queue: BinaryHeap<Reverse<Next>>,
    together: Together,
    restarts: u64,
    processor: pulp::Arch,
}

impl IndividualFlock {
    /// A flock at its start, with the links in force there.
    ///
    /// # Errors
    /// [`IndividualError`].
    pub fn new(
        potential: &Potential,
        radius: f64,
        state: &State<f64>,
        links: &[Pair],
        pace: Pace,
    ) -> Result<Self, IndividualError> {
        let count = state.count();
        let mut neighbours = vec![Vec::new(); count];
        for &(i, j) in links {
            neighbours[i].push(j);
            neighbours[j].push(i);
        }
        let agent = |((r, v), mut neighbours): ((&[f64; 2], &[f64; 2]), Vec<usize>)| {
            neighbours.sort_unstable();
            let path = Path::start(*r, *v);
            Agent { from: 0.0, until: 0.0, reach: 0.0, path, restarts: 0, round: 0, crowd: (0.0, 0), neighbours }
        };
        let mut flock = IndividualFlock {
            radius,
            slope: potential.slope_over(&1.0),
            pace,
            time: 0.0,
            agents: state.positions.iter().zip(&state.velocities).zip(neighbours).map(agent).collect(),
            cells: Cells::new(count, radius * (1.0 + 2.0 * FARTHEST) * (1.0 + 1e-9)),
            queue: BinaryHeap::new(),
            together: Together::new(count),
            restarts: 0,
            processor: pulp::Arch::new(),
        };
        let all: Vec<usize> = (0..count).collect();
        let changed = flock.spread(0.0, &all)?;
        flock.install(0.0, &changed)?;
        Ok(flock)
    }

    /// Goes on to a time that is not before the last one and tells the switches on the way; `false` where `progress` told to stop before.
    ///
    /// # Errors
    /// [`IndividualError`].
    pub fn advance(
        &mut self,
        until: f64,
        switches: &mut Vec<Switch>,
        progress: &dyn Progress,
    ) -> Result<bool, IndividualError> {
        while let Some(&Reverse(next)) = self.queue.peek().filter(|next| next.0.time <= until) {
            if progress.is_cancelled() {
                return Ok(false);
            }
            self.queue.pop();
            let (i, j) = next.pair;
            if next.restarts != (self.agents[i].restarts, self.agents[j].restarts) {
                continue;
            }
            self.time = next.time;
            if i == j {
                self.prolong(next.time, i)?;
            } else {
                switches.push(self.switch(next.time, next.pair)?);
            }
        }
        self.time = until;
        Ok(true)
    }

    /// Positions and velocities at the time reached.
    pub fn state(&self) -> State<f64> {
        let now = self.agents.iter().map(|agent| agent.path.at(self.time - agent.from));
        let (positions, velocities) = now.unzip();
        State { positions, velocities }
    }

    /// The links in force, sorted.
    pub fn links(&self) -> Vec<Pair> {
        let of = |(i, agent): (usize, &Agent)| {
            agent.neighbours.iter().filter(move |j| i < **j).map(move |&j| (i, j)).collect::<Vec<_>>()
        };
        self.agents.iter().enumerate().flat_map(of).collect()
    }

    /// How many series were made.
    pub fn restarts(&self) -> u64 {
        self.restarts
    }

    /// A pair changes its side.
    fn switch(&mut self, time: f64, (i, j): Pair) -> Result<Switch, IndividualError> {
        let crowd = &mut self.agents[i].crowd;
        *crowd = if time - crowd.0 > 1e-9 * (1.0 + time) { (time, 0) } else { (crowd.0, crowd.1 + 1) };
        if crowd.1 > LARGEST_CROWD {
            return Err(IndividualError::Sliding(time));
        }
        let gained = self.agents[i].neighbours.binary_search(&j).is_err();
        for (own, other) in [(i, j), (j, i)] {
            let list = &mut self.agents[own].neighbours;
            match list.binary_search(&other) {
                Ok(place) => drop(list.remove(place)),
                Err(place) => list.insert(place, other),
            }
        }
        let changed = self.spread(time, &[i, j])?;
        self.install(time, &changed)?;
        Ok(Switch { time, gained, pair: (i, j) })
    }

    /// The series of one agent ended: the next one, from the others as they are.
    fn prolong(&mut self, time: f64, agent: usize) -> Result<(), IndividualError> {
        self.together.begin();
        self.bring(time, agent);
        self.bring_neighbours(time, agent);
        self.coefficients::<ORDER>(time, 1, &[agent])?;
        self.install(time, &[agent])
    }

    /// Brings an agent to a time, as it is.
    fn bring(&mut self, time: f64, agent: usize) {
        let from = &self.agents[agent];
        self.together.add(agent, || from.path.after(time - from.from));
    }

    /// Brings the neighbours of an agent to a time.
    fn bring_neighbours(&mut self, time: f64, agent: usize) {
        for k in 0..self.agents[agent].neighbours.len() {
            self.bring(time, self.agents[agent].neighbours[k]);
        }
    }

    /// What some neighbours add to the acceleration of an agent, as a series; a number that is not finite is an error.
    fn series<'a, const K: usize>(
        &'a self,
        time: f64,
        agent: usize,
        neighbours: &'a [usize],
        path: &'a dyn Fn(usize) -> &'a Path,
    ) -> Result<[[f64; K]; 2], IndividualError> {
        let all = Acceleration { own: self.together.path(agent), neighbours, path, slope: &self.slope };
        let found = self.processor.dispatch(all).map_err(|error| IndividualError::Law { time, error })?;
        let finite = found.iter().flatten().all(|c| c.is_finite());
        if finite { Ok(found) } else { Err(IntegrationError::Stuck(time).into()) }
    }

    /// The coefficients of some velocities from power `first` to `K`, each from those of the neighbours that come before.
    fn coefficients<const K: usize>(
        &mut self,
        time: f64,
        first: usize,
        agents: &[usize],
    ) -> Result<(), IndividualError> {
        let path = |agent: usize| self.together.path(agent);
        let of = |&agent: &usize| self.series::<K>(time, agent, &self.agents[agent].neighbours, &path);
        let all: Result<Vec<_>, _> = agents.iter().map(of).collect();
        for ([x, y], &agent) in all?.iter().zip(agents) {
            let path = self.together.path_mut(agent);
            (first..=K).for_each(|k| path.set_velocity(k, [x[k - 1], y[k - 1]]));
        }
        Ok(())
    }

    /// By how much the coefficient `K` of an agent's velocity changes through those of its neighbours that changed.
    fn change<const K: usize>(&self, time: f64, agent: usize) -> Result<f64, IndividualError> {
        let changed = |k: &usize| self.together.is_changed(*k);
        let others: Vec<usize> = self.agents[agent].neighbours.iter().copied().filter(changed).collect();
        let (new, old) = (|agent: usize| self.together.path(agent), |agent: usize| self.together.old(agent));
        let is = self.series::<K>(time, agent, &others, &new)?;
        let was = self.series::<K>(time, agent, &others, &old)?;
        let [x, y] = [0, 1].map(|c| (is[c][K - 1] - was[c][K - 1]) / K as f64);
        Ok((x * x + y * y).sqrt())
    }

    /// One coefficient more for those that changed; of those asked, who notices gets all up to this one, and its neighbours are asked next.
    fn level<const K: usize>(&mut self, time: f64, spread: &mut Spread) -> Result<(), IndividualError> {
        self.coefficients::<K>(time, K, &spread.changed)?;
        let (mut noticed, mut not) = (Vec::new(), Vec::new());
        for &agent in &spread.asked {
            let old = &self.agents[agent];
            // Not what is left of its series: its neighbours go on from its coefficients too.
            let effect = self.change::<K>(time, agent)? * (old.until - old.from).powi(K as i32);
            let allowed = match self.pace {
                Pace::Tolerance(tolerance) => NOTICED * tolerance * (1.0 + old.path.size(1)),
                Pace::Fixed(_) => -1.0,
            };
            if effect <= allowed { not.push(agent) } else { noticed.push(agent) }
        }
        noticed.iter().for_each(|&agent| self.bring_neighbours(time, agent));
        self.coefficients::<K>(time, 1, &noticed)?;
        // Those that do not notice yet are asked again: what comes from the two of a switch can cancel in the first coefficient.
        spread.asked = not;
        self.ask(time, spread, &noticed);
        spread.changed.append(&mut noticed);
        Ok(())
    }

    /// Asks the neighbours of some that changed.
    fn ask(&mut self, time: f64, spread: &mut Spread, changed: &[usize]) {
        for &agent in changed {
            self.together.set_changed(agent);
        }
        for &agent in changed {
            for k in 0..self.agents[agent].neighbours.len() {
                let other = self.agents[agent].neighbours[k];
                if self.together.see(other) {
                    self.bring(time, other);
                    spread.asked.push(other);
                }
            }
        }
    }

    /// New series at a time of some agents and of all that notice; who changed.
    ///
    /// What jumps at a switch is the acceleration of the two; of their neighbours its rate of change, and so on. So the series are made one
    /// coefficient after the other, each from those of the neighbours that came before, in ever more agents.
    fn spread(&mut self, time: f64, seeds: &[usize]) -> Result<Vec<usize>, IndividualError> {
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

    /// Puts new series into force and looks for what happens on them.
    fn install(&mut self, time: f64, changed: &[usize]) -> Result<(), IndividualError> {
        for &k in changed {
            let path = *self.together.path(k);
            let (length, reach) = self.length(&path);
            let until = time + length;
            if until.is_nan() || until <= time {
                return Err(IntegrationError::Stuck(time).into());
            }
            let agent = &mut self.agents[k];
            (agent.from, agent.until, agent.reach, agent.path) = (time, until, reach, path);
            agent.restarts = agent.restarts.wrapping_add(1);
            agent.round = self.together.round;
            self.restarts += 1;
            let restarts = (agent.restarts, agent.restarts);
            self.queue.push(Reverse(Next { time: until, pair: (k, k), restarts }));
            self.cells.put(Place { agent: k, anchor: [path.0[0][0], path.0[1][0]], reach });
        }
        changed.iter().for_each(|&k| self.watch(time, k));
        Ok(())
    }

    /// How long a series may be used, and how far it leads.
    fn length(&self, path: &Path) -> (f64, f64) {
        let mut length = match self.pace {
            Pace::Fixed(length) => length,
            Pace::Tolerance(tolerance) => {
                let allowed = tolerance * (1.0 + path.size(1));
                let of = |m: usize| (allowed / ((m + 1) as f64 * path.size(m + 1))).powf(1.0 / m as f64);
                of(ORDER).min(of(ORDER - 1)).min(LONGEST)
            }
        };
        let farthest = FARTHEST * self.radius;
        let mut reach = path.reach(length);
        while reach > farthest {
            length *= (farthest / reach).clamp(0.1, 0.9);
            reach = path.reach(length);
        }
        (if reach.is_finite() { length } else { f64::NAN }, reach)
    }

    /// Finds the next arrivals of an agent's pairs at the radius while both series last.
    fn watch(&mut self, time: f64, i: usize) {
        let own = &self.agents[i];
        let point = [own.path.0[0][0], own.path.0[1][0]];
        let mut found = Vec::new();
        for other in self.cells.around(point) {
            let (x, y) = (point[0] - other.anchor[0], point[1] - other.anchor[1]);
            let (square, both) = (x * x + y * y, own.reach + other.reach + 1e-9 * self.radius);
            let (near, far) = (self.radius - both, self.radius + both);
            if square > far * far || square < near * near || other.agent == i {
                continue;
            }
            let (j, agent) = (other.agent, &self.agents[other.agent]);
            // Of two that are new both would find it.
            if agent.round == self.together.round && j < i {
                continue;
            }
            let linked = own.neighbours.binary_search(&j).is_ok();
            let mut side = own.path.squared_distance(&agent.path.after(time - agent.from));
            side[0] -= self.radius * self.radius;
            if linked {
                side.iter_mut().for_each(|c| *c = -*c);
            }
            // A pair that has just switched is at zero within rounding and leaves it.
            let rounding = 16.0 * f64::EPSILON * self.radius * (self.radius + 2.0 * (point[0].abs() + point[1].abs()));
            if side[0].abs() <= rounding && side[1] > 0.0 {
                side[0] = 0.0;
            }
            let length = own.until.min(agent.until) - time;
            if let Some(delay) = first_fall(&side, length) {
                let (a, b) = (i.min(j), i.max(j));
                found.push(Next {
                    time: time + delay,
                    pair: (a, b),
                    restarts: (self.agents[a].restarts, self.agents[b].restarts),
                });
            }
        }
        self.queue.extend(found.into_iter().map(Reverse));
    }
}
