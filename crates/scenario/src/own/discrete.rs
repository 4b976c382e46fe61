//! A law of one's own in discrete time, over floats or exact rationals.

use super::measured::{Heard, frame, in_words, observe};
use super::read::Described;
use crate::error::RunError;
use crate::network::{Change, Network, Pair, Rule};
use crate::observables::Observable;
use crate::simulation::{Event, Frame, Simulation};
use arithmetic::random::{normal, uniform};
use arithmetic::{ArithmeticError, Number, Progress, Rational, Sign, rational};
use expressions::{Blocks, Drawn, Evaluator, Fault, Hearing, Law};
use num_traits::ToPrimitive;
use rand_chacha::ChaCha8Rng;
use std::cell::RefCell;
use std::cmp::Ordering;
use std::sync::Arc;

/// A scalar over which laws are followed step by step.
pub(super) trait Stepped: Number {
    /// What computes the next state.
    type Machine;

    fn machine(law: &Law) -> Self::Machine;

    /// Writes the next state.
    fn write(
        machine: &mut Self::Machine,
        law: &Law,
        moment: (&Self, &[Self]),
        hearing: &dyn Hearing,
        next: &mut [Self],
    ) -> Result<(), Fault>;

    /// Sets the numbers that were drawn for a step.
    fn set_drawn(machine: &mut Self::Machine, law: &Law, drawn: &[Vec<f64>]);
}

impl Stepped for f64 {
    type Machine = Blocks;

    fn machine(law: &Law) -> Blocks {
        Blocks::rates(law)
    }

    fn write(
        machine: &mut Blocks,
        law: &Law,
        (time, state): (&f64, &[f64]),
        hearing: &dyn Hearing,
        next: &mut [f64],
    ) -> Result<(), Fault> {
        machine.write_rates(law, (*time, state), hearing, next)
    }

    fn set_drawn(machine: &mut Blocks, law: &Law, drawn: &[Vec<f64>]) {
        machine.set_drawn(law, drawn);
    }
}

impl Stepped for Rational {
    type Machine = Evaluator<Rational>;

    fn machine(law: &Law) -> Evaluator<Rational> {
        law.evaluator(&rational(0, 1))
    }

    fn write(
        machine: &mut Evaluator<Rational>,
        law: &Law,
        moment: (&Rational, &[Rational]),
        hearing: &dyn Hearing,
        next: &mut [Rational],
    ) -> Result<(), Fault> {
        law.write_rates(machine, moment, hearing, next)
    }

    /// Exact runs draw nothing.
    fn set_drawn(_: &mut Evaluator<Rational>, _: &Law, _: &[Vec<f64>]) {}
}

/// The law with its state.
pub(super) struct Stepping<T: Stepped> {
    law: Arc<Law>,
    network: Network,
    radius: Option<T>,
    step: Rational,
    /// Steps taken.
    taken: u64,
    state: Vec<T>,
    next: Vec<T>,
    machine: T::Machine,
    random: ChaCha8Rng,
    observed: RefCell<Blocks>,
    rounded: fn(&T) -> f64,
    declaration: Vec<String>,
}

/// What the law draws for a step: of each kind one number for each agent.
fn draw(law: &Law, random: &mut ChaCha8Rng) -> Vec<Vec<f64>> {
    let number = |kind: Drawn, random: &mut ChaCha8Rng| match kind {
        Drawn::Normal => normal(random),
        Drawn::Uniform => uniform(random),
    };
    law.drawn().iter().map(|kind| (0..law.agents()).map(|_| number(*kind, random)).collect()).collect()
}

impl<T: Stepped> Stepping<T> {
    /// The law at its start; `zero` tells the scalar.
    pub fn new(own: Described, state: Vec<T>, zero: &T, rounded: fn(&T) -> f64) -> Self {
        let mut stepping = Stepping {
            radius: own.radius.map(|radius| zero.rational(&radius)),
            machine: T::machine(&own.law),
            random: own.random,
            observed: RefCell::new(Blocks::observables(&own.law)),
            next: vec![zero.clone(); state.len()],
            law: own.law,
            network: own.network,
            step: own.step,
            taken: 0,
            state,
            rounded,
            declaration: own.declaration,
        };
        stepping.relink();
        stepping
    }

    /// One step; the links that came and went with it.
    pub fn step(&mut self) -> Result<Vec<Event>, RunError> {
        let time = self.time();
        let now = time.to_f64().unwrap_or(f64::NAN);
        let Some(scalar) = self.state.first().map(|like| like.rational(&time)) else { return Ok(Vec::new()) };
        let drawn = draw(&self.law, &mut self.random);
        T::set_drawn(&mut self.machine, &self.law, &drawn);
        let moment = (&scalar, &self.state[..]);
        let written = T::write(&mut self.machine, &self.law, moment, &Heard(&self.network), &mut self.next);
        written.map_err(|fault| RunError::Own { time: now, fault: in_words(&self.law, &fault) })?;
        if self.next.iter().any(|x| !(self.rounded)(x).is_finite()) {
            return Err(RunError::Own { time: now, fault: "a number grows beyond the floats".to_string() });
        }
        std::mem::swap(&mut self.state, &mut self.next);
        self.taken += 1;
        let time = self.time().to_f64().unwrap_or(f64::NAN);
        Ok(self.relink().iter().map(|change| Event::new(time, change)).collect())
    }

    pub fn state(&self) -> &[T] {
        &self.state
    }

    pub fn law(&self) -> &Law {
        &self.law
    }

    /// The numbers of the observables over any scalar.
    pub fn observed<U: Number>(&self, time: &U, state: &[U]) -> Result<Vec<U>, Fault> {
        self.law.observe(time, state, &Heard(&self.network))
    }

    pub fn shown(&self) -> crate::view::Links<'static> {
        match self.network.shown() {
            crate::view::Links::These(order, links) => crate::view::Links::These(order, links.into_owned().into()),
            crate::view::Links::Everyone(order) => crate::view::Links::Everyone(order),
            crate::view::Links::Between(order, ends) => crate::view::Links::Between(order, ends),
        }
    }

    /// Whether neither the law nor the network depends on the time from now on.
    pub fn is_autonomous(&self) -> bool {
        self.law.is_autonomous() && self.network.next_time().is_none()
    }

    fn floats(&self) -> Vec<f64> {
        self.state.iter().map(self.rounded).collect()
    }

    pub fn time(&self) -> Rational {
        &self.step * Rational::from_integer(self.taken.into())
    }

    /// The numbers of an agent's place.
    fn place(&self, agent: usize) -> &[T] {
        self.law.position().map_or(&[], |position| {
            let from = position.start + agent * position.stride;
            &self.state[from..from + position.width]
        })
    }

    fn square(&self, (i, j): Pair) -> Option<T> {
        let products = self.place(i).iter().zip(self.place(j)).map(|(x, y)| (x.clone() - y).square());
        products.reduce(|sum, square| sum + square)
    }

    /// The links of the places, or those that are due; what has changed.
    fn relink(&mut self) -> Vec<Change> {
        let pairs = match self.network.rule() {
            Rule::Fixed => {
                let now = self.time().to_f64().unwrap_or(f64::NAN);
                let mut changes = Vec::new();
                while self.network.next_time().is_some_and(|due| due <= now) {
                    changes.extend(self.network.replace());
                }
                return changes;
            }
            Rule::Within(radius) => self.within(radius),
            Rule::Nearest(count) => self.nearest(count),
        };
        self.network.exchange(pairs)
    }

    /// Floats propose who may be near, the scalar decides: at most the radius.
    fn within(&self, radius: f64) -> Vec<Pair> {
        let Some(exact) = &self.radius else { return Vec::new() };
        let floats = self.floats();
        let far = floats.iter().fold(radius, |most: f64, x| most.max(x.abs()));
        let is_near = |pair: &Pair| {
            let excess = self.square(*pair).map(|square| (square - exact.square()).sign());
            matches!(excess, Some(Some(Sign::Negative | Sign::Zero)))
        };
        self.network.within(&floats, radius + 1e-9 * far).into_iter().filter(is_near).collect()
    }

    /// The so many nearest of each; of two at one distance the one with the smaller number.
    fn nearest(&self, count: usize) -> Vec<Pair> {
        let agents = self.law.agents();
        let mut arcs = Vec::new();
        for agent in 0..agents {
            let mut others: Vec<(T, usize)> = (0..agents)
                .filter(|other| *other != agent)
                .filter_map(|other| Some((self.square((agent, other))?, other)))
                .collect();
            others.sort_by(|a, b| {
                let order = match (a.0.clone() - &b.0).sign() {
                    Some(Sign::Negative) => Ordering::Less,
                    Some(Sign::Positive) => Ordering::Greater,
                    _ => Ordering::Equal,
                };
                order.then(a.1.cmp(&b.1))
            });
            arcs.extend(others.into_iter().take(count).map(|(_, other)| (agent, other)));
        }
        arcs
    }
}

impl<T: Stepped> Simulation for Stepping<T> {
    fn advance(&mut self, until: f64, events: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError> {
        let length = self.step.to_f64().unwrap_or(f64::NAN);
        let last = (until / length).round();
        while (self.taken as f64) < last {
            if progress.is_cancelled() {
                return Ok(false);
            }
            events.extend(self.step()?);
        }
        Ok(true)
    }

    fn frame(&self) -> Frame {
        frame(&self.law, &self.floats())
    }

    fn observe(&self) -> Result<Vec<Observable>, ArithmeticError> {
        let time = self.time().to_f64().unwrap_or(f64::NAN);
        let observed = observe(&self.law, &self.network, (&mut self.observed.borrow_mut(), time), &self.floats());
        observed.map_err(|fault| fault.error)
    }

    fn links(&self) -> Vec<(usize, usize)> {
        // Pictures of everybody with everybody say nothing.
        if self.network.is_all_to_all() { Vec::new() } else { self.network.links() }
    }

    fn declaration(&self) -> Vec<String> {
        self.declaration.clone()
    }
}
