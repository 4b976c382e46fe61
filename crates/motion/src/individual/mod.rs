//! Large flocks with every switch located: each agent has steps of its own, and a switch restarts only the agents that notice it.
//!
//! Method, order and cost: `notes/integrators.md`. The motion of an agent is made of power series in time. All that is to come stands in one queue,
//! in the order of time: that the series of an agent ends, that a pair comes to the radius on its two series, that an angle comes to half a turn. So the
//! results depend neither on threads nor on the times at which they are asked for.

mod cells;
mod influence;
mod law;
mod next;
mod path;
mod ranks;
mod spread;
mod together;
mod watch;

pub use law::{IndividualLaw, Moving, Rates, Turns};

use crate::{FollowError, whole_turns};
use arithmetic::Progress;
use cells::Cells;
use influence::Neighbour;
use next::{Kind, Next};
use path::Path;
use ranks::Ranks;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::TAU;
use together::Together;

/// A pair of agents, counted from 0.
type Pair = (usize, usize);

/// How long the pieces of motion are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pace {
    /// The last terms of each series are below this, absolute and relative to the velocity, for further states absolute.
    Tolerance(f64),
    /// All of this length, or shorter after switches; every switch is noticed by all whose series change.
    Fixed(f64),
}

/// Who senses whom.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sensing {
    /// Two agents below this distance sense each other. Links are pairs.
    Within(f64),
    /// Each agent senses its nearest, always as many as at the start. Links are arcs, the one that senses first.
    Nearest,
}

/// A link that came or went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Switch {
    /// When.
    pub time: f64,
    /// Whether it came.
    pub gained: bool,
    /// The agents from 0: of a pair the smaller number first, of an arc the one that senses.
    pub pair: Pair,
}

/// Agents move by at most this part of the radius, or of a typical distance of the farthest that one senses, on one series.
const FARTHEST: f64 = 0.125;

/// A pair that switches ever faster is taken for one that stays at the radius where its squared distance swings by less than so many tolerances.
const STAYING: f64 = 100.0;

/// So many switches of an agent at one time are taken for a motion along the radius.
const LARGEST_CROWD: usize = 1000;

/// An agent with its piece of motion.
#[derive(Debug, Clone)]
struct Agent<const F: usize> {
    from: f64,
    until: f64,
    /// How far it gets until then.
    reach: f64,
    path: Path<F>,
    restarts: u32,
    /// The round of the last restart.
    round: u64,
    /// When it switched last, and how many switches of it there were about then.
    crowd: (f64, usize),
    /// Whom it senses, sorted.
    neighbours: Vec<Neighbour>,
    /// Who senses it, sorted.
    observers: Vec<usize>,
}

impl<const F: usize> Agent<F> {
    fn new(from: f64, at: &Moving<f64, F>) -> Self {
        let path = Path::start(at);
        let (crowd, neighbours, observers) = ((0.0, 0), Vec::new(), Vec::new());
        Agent { from, until: from, reach: 0.0, path, restarts: 0, round: 0, crowd, neighbours, observers }
    }

    /// Where a neighbour is in the list, or would be.
    fn place(&self, neighbour: usize) -> Result<usize, usize> {
        self.neighbours.binary_search_by_key(&neighbour, |one| one.agent)
    }

    /// The angle, zero where there is none.
    fn angle(&self, time: f64) -> f64 {
        self.path.at(time - self.from).further.first().copied().unwrap_or(0.0)
    }
}

/// A flock on its way: a law with `F` further states of each agent and `M` influences between two.
#[derive(Debug, Clone)]
pub struct IndividualFlock<L, const F: usize, const M: usize> {
    law: L,
    sensing: Sensing,
    /// The radius, or about the distance of the farthest that one senses.
    scale: f64,
    pace: Pace,
    time: f64,
    agents: Vec<Agent<F>>,
    cells: Cells,
    ranks: Ranks,
    queue: BinaryHeap<Reverse<Next>>,
    together: Together<F>,
    restarts: u64,
    processor: pulp::Arch,
}

impl<L: IndividualLaw<F, M>, const F: usize, const M: usize> IndividualFlock<L, F, M> {
    /// A flock at its start, with the links in force there, each a pair of two agents that are there and each once.
    ///
    /// # Errors
    /// [`FollowError`].
    pub fn new(
        law: L,
        sensing: Sensing,
        start: &[Moving<f64, F>],
        links: &[Pair],
        pace: Pace,
    ) -> Result<Self, FollowError> {
        IndividualFlock::starting(0.0, (law, sensing, pace), start, links)
    }

    /// The same flock from another time on, with other states and links.
    ///
    /// # Errors
    /// [`FollowError`].
    pub fn resumed(&self, time: f64, start: &[Moving<f64, F>], links: &[Pair]) -> Result<Self, FollowError>
    where
        L: Clone,
    {
        IndividualFlock::starting(time, (self.law.clone(), self.sensing, self.pace), start, links)
    }

    fn starting(
        time: f64,
        (law, sensing, pace): (L, Sensing, Pace),
        start: &[Moving<f64, F>],
        links: &[Pair],
    ) -> Result<Self, FollowError> {
        let count = start.len();
        if let Some(&pair) = links.iter().find(|(i, j)| i == j || *i.max(j) >= count) {
            return Err(FollowError::Link { pair, count });
        }
        let scale = match sensing {
            Sensing::Within(radius) => radius,
            Sensing::Nearest => ranks::typical(start, links),
        };
        let mut flock = IndividualFlock {
            law,
            sensing,
            scale,
            pace,
            time,
            agents: start.iter().map(|at| Agent::new(time, at)).collect(),
            cells: Cells::new(count, scale * (1.0 + 2.0 * FARTHEST) * (1.0 + 1e-9)),
            ranks: Ranks::new(count),
            queue: BinaryHeap::new(),
            together: Together::new(count),
            restarts: 0,
            processor: pulp::Arch::new(),
        };
        for &(i, j) in links {
            flock.link(time, if sensing == Sensing::Nearest { (i, j) } else { (i.min(j), i.max(j)) });
        }
        let all: Vec<usize> = (0..count).collect();
        flock.restart(time, &all)?;
        Ok(flock)
    }

    /// Goes on to a time that is not before the last one and tells the switches on the way; `false` where `progress` told to stop before.
    ///
    /// # Errors
    /// [`FollowError`].
    pub fn advance(
        &mut self,
        until: f64,
        switches: &mut Vec<Switch>,
        progress: &dyn Progress,
    ) -> Result<bool, FollowError> {
        while let Some(&Reverse(next)) = self.queue.peek().filter(|next| next.0.time <= until) {
            if progress.is_cancelled() {
                return Ok(false);
            }
            self.queue.pop();
            let (i, j) = next.pair;
            let restarts = match next.kind {
                Kind::Rank => (self.ranks.looks(i), self.ranks.looks(i)),
                _ => (self.agents[i].restarts, self.agents[j].restarts),
            };
            if next.restarts != restarts {
                continue;
            }
            self.time = next.time;
            match next.kind {
                Kind::End => self.prolong(next.time, i)?,
                Kind::Radius => {
                    self.count_switch(next.time, i)?;
                    if self.stays(next.time, next.pair) {
                        return Err(FollowError::Sliding(next.time));
                    }
                    switches.push(self.switch(next.time, next.pair)?);
                }
                Kind::Rank => {
                    self.count_switch(next.time, i)?;
                    switches.extend(self.change_places(next.time, i)?);
                }
                Kind::Turn => {
                    self.count_switch(next.time, i)?;
                    self.turn(next.time, next.pair)?;
                }
            }
        }
        self.time = until;
        Ok(true)
    }

    /// The last time that was reached, also where the flock could not be followed any more.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The agents at the time reached.
    pub fn agents(&self) -> impl Iterator<Item = Moving<f64, F>> {
        self.agents.iter().map(|agent| agent.path.at(self.time - agent.from))
    }

    /// The links in force, sorted.
    pub fn links(&self) -> Vec<Pair> {
        let arcs = self.sensing == Sensing::Nearest;
        let of = |(i, agent): (usize, &Agent<F>)| {
            let others = agent.neighbours.iter().map(|other| other.agent);
            others.filter(move |j| arcs || i < *j).map(move |j| (i, j)).collect::<Vec<_>>()
        };
        self.agents.iter().enumerate().flat_map(of).collect()
    }

    /// How many series were made.
    pub fn restarts(&self) -> u64 {
        self.restarts
    }

    /// That an agent does not switch without end.
    fn count_switch(&mut self, time: f64, agent: usize) -> Result<(), FollowError> {
        let crowd = &mut self.agents[agent].crowd;
        *crowd = if time - crowd.0 > 1e-9 * (1.0 + time) { (time, 0) } else { (crowd.0, crowd.1 + 1) };
        if crowd.1 > LARGEST_CROWD { Err(FollowError::Sliding(time)) } else { Ok(()) }
    }

    /// Whether a pair at the radius, where links push apart, does as good as stay there.
    fn stays(&self, time: f64, (i, j): Pair) -> bool {
        let (Pace::Tolerance(tolerance), square) = (self.pace, self.scale * self.scale) else { return false };
        let push = self.law.push(square);
        let at = |agent: &Agent<F>| agent.path.after(time - agent.from);
        let side = at(&self.agents[i]).squared_distance(&at(&self.agents[j]));
        let (rate, bend) = (side[1], 2.0 * side[2].abs() + push);
        push > 0.0 && rate * rate <= 2.0 * bend * STAYING * tolerance * square
    }

    /// A pair changes its side.
    fn switch(&mut self, time: f64, (i, j): Pair) -> Result<Switch, FollowError> {
        let gained = self.agents[i].place(j).is_err();
        if gained {
            self.link(time, (i, j));
        } else {
            self.unlink((i, j));
        }
        self.restart(time, &[i, j])?;
        Ok(Switch { time, gained, pair: (i, j) })
    }

    /// Of a new pair the difference of the angles is read in `(-pi, pi]`.
    fn link(&mut self, time: f64, (i, j): Pair) {
        let turns = match self.law.turns() {
            Turns::OfPairs => whole_turns(self.agents[i].angle(time) - self.agents[j].angle(time)),
            Turns::Never | Turns::OfAgents => 0.0,
        };
        for (own, agent, turns) in self.directions((i, j), turns) {
            if let Err(place) = self.agents[own].place(agent) {
                self.agents[own].neighbours.insert(place, Neighbour { agent, turns });
                let observers = &mut self.agents[agent].observers;
                observers.insert(observers.partition_point(|other| *other < own), own);
            }
        }
    }

    fn unlink(&mut self, pair: Pair) {
        for (own, other, _) in self.directions(pair, 0.0) {
            if let Ok(place) = self.agents[own].place(other) {
                self.agents[own].neighbours.remove(place);
                self.agents[other].observers.retain(|observer| *observer != own);
            }
        }
    }

    /// Who senses whom on a link, with the whole turns that are added to the angle of the one that is sensed.
    fn directions(&self, (i, j): Pair, turns: f64) -> impl Iterator<Item = (usize, usize, f64)> + use<L, F, M> {
        let back = matches!(self.sensing, Sensing::Within(_)).then_some((j, i, -turns));
        std::iter::once((i, j, turns)).chain(back)
    }

    /// An angle, or the difference of two, came to half a turn and jumps.
    fn turn(&mut self, time: f64, (i, j): Pair) -> Result<(), FollowError> {
        if i == j {
            let turned = TAU.copysign(self.agents[i].angle(time));
            if let Some(angle) = self.agents[i].path.further.first_mut() {
                angle[0] -= turned;
            }
            let noticed = self.agents[i].observers.clone();
            return self.restart(time, &[&[i], &noticed[..]].concat());
        }
        let difference = self.agents[i].angle(time) - self.agents[j].angle(time);
        if let Ok(place) = self.agents[i].place(j) {
            let turns = &mut self.agents[i].neighbours[place].turns;
            *turns += 1f64.copysign(difference - TAU * *turns);
            let turns = *turns;
            if let Ok(place) = self.agents[j].place(i) {
                self.agents[j].neighbours[place].turns = -turns;
            }
        }
        self.restart(time, &[i, j])
    }

    /// Some agents start anew, with all that notice.
    fn restart(&mut self, time: f64, agents: &[usize]) -> Result<(), FollowError> {
        let changed = self.spread(time, agents)?;
        self.install(time, &changed)
    }
}
