//! A law of one's own in continuous time, over any scalar: on a network that stays as it is, or with links by distance on each of their networks.

use super::measured::Heard;
use super::read::Described;
use crate::network::{Network, Rule};
use crate::view::Links;
use arithmetic::{ArithmeticError, Number, Rational};
use expressions::{Asked, Kind, Law, Time, Variable};
use models::double_integrator::{LinkedAgents, Pair};
use motion::System;
use std::borrow::Cow;
use std::cmp::Ordering;
use std::sync::Arc;

/// A law of one's own with its network and its start, all exact.
#[derive(Debug, Clone)]
pub struct OwnMotion {
    law: Arc<Law>,
    network: Network,
    /// The start, in the order of the law's state.
    pub start: Vec<Rational>,
}

impl OwnMotion {
    /// Of a law in continuous time on a fixed network, or with links below a distance; why it is not enclosed otherwise.
    pub(crate) fn of(own: Described) -> Result<Self, &'static str> {
        let Described { law, state, network, time, .. } = own;
        if time == Time::Discrete {
            Err("laws in discrete time are not enclosed")
        } else if law.is_noisy() || !law.drawn().is_empty() {
            Err("laws with noise are not enclosed: their motions are drawn at random")
        } else if matches!(network.rule(), Rule::Nearest(_)) {
            Err("links to the nearest are not enclosed")
        } else if network.switches() && law.position().is_none() {
            Err("links by distance need positions")
        } else if network.next_time().is_some() {
            Err("links that are replaced at given times are not enclosed")
        } else {
            Ok(OwnMotion { law, network, start: state })
        }
    }

    /// The distance below which agents are linked, where that decides.
    pub fn radius(&self) -> Option<&Rational> {
        self.network.exact_radius()
    }

    /// The same on the network of these links `i < j`, where links depend on the distances; on its own network otherwise.
    pub fn with_links(&self, pairs: &[Pair]) -> Cow<'_, Self> {
        if !self.network.switches() {
            return Cow::Borrowed(self);
        }
        let mut own = self.clone();
        own.network.set_pairs(pairs.to_vec());
        Cow::Owned(own)
    }

    /// The same on the network of the start; nothing where two agents are at exactly the radius there.
    pub fn at_start(&self) -> Option<Cow<'_, Self>> {
        let Some(radius) = self.radius() else { return Some(Cow::Borrowed(self)) };
        let places = self.rows(self.position()?);
        let mut linked = Vec::new();
        for (j, second) in places.iter().enumerate() {
            for (i, first) in places[..j].iter().enumerate() {
                let square: Rational = first.iter().zip(second).map(|(a, b)| (a - b) * (a - b)).sum();
                match square.cmp(&(radius * radius)) {
                    Ordering::Less => linked.push((i, j)),
                    Ordering::Equal => return None,
                    Ordering::Greater => {}
                }
            }
        }
        Some(self.with_links(&linked))
    }

    /// The number of agents.
    pub fn agents(&self) -> usize {
        self.law.agents()
    }

    /// The part of the state that says where agents are.
    pub fn position(&self) -> Option<&Variable> {
        self.law.position()
    }

    /// The part of the state of that name.
    pub fn part(&self, name: &str) -> Option<&Variable> {
        self.law.variables().iter().find(|variable| variable.name == name)
    }

    /// The first part that is an angle.
    pub fn angle(&self) -> Option<&Variable> {
        self.law.variables().iter().find(|variable| variable.kind == Kind::Angle)
    }

    /// The part that is called `v`, where it is no angle.
    pub fn velocity(&self) -> Option<&Variable> {
        self.part("v").filter(|part| part.kind != Kind::Angle)
    }

    /// The start of a part, a row for each agent.
    pub fn rows(&self, part: &Variable) -> Vec<Vec<Rational>> {
        let row = |agent: usize| self.start[part.start + agent * part.width..][..part.width].to_vec();
        (0..self.agents()).map(row).collect()
    }

    /// Where a number of an agent, or of an open parameter, stands in the state, all from 0.
    pub fn place(&self, part: &str, agent: usize, coordinate: usize) -> Option<usize> {
        place(&self.law, part, agent, coordinate)
    }

    /// A number of the flock by its name in a property, at a state: of the state itself, or an observable of the law; nothing where there is none of that name.
    ///
    /// # Errors
    /// [`ArithmeticError`] where it has no value, or depends on the time.
    pub fn number<T: Number>(&self, name: &str, state: &[T]) -> Option<Result<T, ArithmeticError>> {
        Some(match self.law.number(name)? {
            Asked::State(place) => state.get(place).cloned().ok_or(ArithmeticError::Domain("a state")),
            Asked::Observed(_) if self.law.observes_time() => Err(ArithmeticError::Domain("the state alone")),
            Asked::Observed(place) => {
                let like = state.first()?.zero();
                let all = self.law.observe(&like, state, &Heard(&self.network));
                let number = all.into_iter().nth(place).ok_or(ArithmeticError::Domain("a number"));
                number.and_then(|number| number.map_err(|fault| fault.error))
            }
        })
    }

    /// The links.
    pub fn links(&self) -> Links<'_> {
        self.network.shown()
    }
}

/// Where a number of an agent, or of an open parameter, stands in the state of a law, all from 0.
pub(super) fn place(law: &Law, part: &str, agent: usize, coordinate: usize) -> Option<usize> {
    if let Some(open) = law.open().iter().find(|open| open.name == part) {
        return (agent < open.values.len() && coordinate == 0).then_some(open.start + agent);
    }
    let part = law.variables().iter().find(|variable| variable.name == part)?;
    (agent < law.agents() && coordinate < part.width).then_some(part.start + agent * part.width + coordinate)
}

impl System for OwnMotion {
    fn rate<T: Number>(&self, time: &T, state: &[T]) -> Result<Vec<T>, ArithmeticError> {
        self.law.rates(time, state, &Heard(&self.network)).map_err(|fault| fault.error)
    }
}

impl LinkedAgents for OwnMotion {
    fn agents(&self) -> usize {
        OwnMotion::agents(self)
    }

    fn width(&self) -> usize {
        self.position().map_or(0, |part| part.width)
    }

    fn place(&self, agent: usize) -> usize {
        self.position().map_or(0, |part| part.start + agent * part.width)
    }

    fn on<'a>(&'a self, edges: &'a [Pair]) -> impl System + 'a {
        OnLinks(self.with_links(edges))
    }
}

/// A law on the network of some links.
struct OnLinks<'a>(Cow<'a, OwnMotion>);

impl System for OnLinks<'_> {
    fn rate<T: Number>(&self, time: &T, state: &[T]) -> Result<Vec<T>, ArithmeticError> {
        self.0.rate(time, state)
    }
}
