//! A law of one's own in discrete time, over floats, exact rationals, or numbers that are exact where they can be and enclosed elsewhere.

use super::affine::AffineNumber;
use super::measured::{Heard, frame, in_words, observe};
use super::read::Described;
use crate::error::RunError;
use crate::network::{Change, Network, Pair, Rule};
use crate::observables::Observable;
use crate::simulation::{Event, Frame, Simulation};
use crate::start::float;
use arithmetic::random::{normal, uniform};
use arithmetic::{ArithmeticError, Dyadic, Number, Progress, Rational, RealNumber, Ring, Sign};
use expressions::{Blocks, Drawn, Evaluator, Fault, Hearing, Law};
use num_traits::ToPrimitive;
use rand_chacha::ChaCha8Rng;
use std::cell::RefCell;
use std::sync::Arc;

/// Rationals with more bits in numerator or denominator are not followed further: under a law that squares, each step doubles them.
pub(super) const MOST_BITS: u64 = 1 << 20;

/// A scalar over which laws are followed step by step.
pub(super) trait Stepped: Number {
    /// What computes the next state.
    type Machine;

    /// What computes for scalars like this one.
    fn machine(&self, law: &Law, complete: bool) -> Self::Machine;

    /// The nearest float, roughly.
    fn rounded(&self) -> f64;

    /// How far the number may be from that float, beyond its rounding.
    fn spread(&self) -> f64 {
        0.0
    }

    /// Whether two places are farther apart than the radius; nothing where it cannot be told.
    fn is_beyond(own: &[Self], other: &[Self], radius: &Self) -> Option<bool> {
        let square = square(own, other)?;
        Some((square - radius.square()).sign()? == Sign::Positive)
    }

    /// Whether the number has more digits than are followed.
    fn is_too_long(&self) -> bool {
        false
    }

    /// Writes the next state.
    fn write(
        machine: &mut Self::Machine,
        law: &Law,
        moment: (&Self, &[Self]),
        hearing: &dyn Hearing,
        next: &mut [Self],
    ) -> Result<(), Fault>;

    /// Sets the numbers that were drawn for a step; what is not in floats draws nothing.
    fn set_drawn(_: &mut Self::Machine, _: &[Vec<f64>]) {}
}

impl Stepped for f64 {
    type Machine = Blocks;

    fn machine(&self, law: &Law, complete: bool) -> Blocks {
        Blocks::rates(law, complete)
    }

    fn rounded(&self) -> f64 {
        *self
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

    fn set_drawn(machine: &mut Blocks, drawn: &[Vec<f64>]) {
        machine.set_drawn(drawn);
    }
}

impl Stepped for Rational {
    type Machine = Evaluator<Rational>;

    fn machine(&self, law: &Law, _: bool) -> Evaluator<Rational> {
        law.evaluator(self)
    }

    fn rounded(&self) -> f64 {
        float(self)
    }

    fn is_too_long(&self) -> bool {
        self.numer().bits().max(self.denom().bits()) > MOST_BITS
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
}

impl Stepped for AffineNumber {
    type Machine = Evaluator<AffineNumber>;

    fn machine(&self, law: &Law, _: bool) -> Evaluator<AffineNumber> {
        law.evaluator(self)
    }

    fn rounded(&self) -> f64 {
        let plain = self.plain();
        match &plain.number {
            RealNumber::Exact(q) => float(q),
            other => other.enclosure(plain.precision).midpoint(64).lo().to_f64(),
        }
    }

    fn spread(&self) -> f64 {
        let plain = self.plain();
        match &plain.number {
            RealNumber::Exact(_) => 0.0,
            other => other.enclosure(plain.precision).width().to_f64(),
        }
    }

    /// Exactly on a line, also where some starts are at the radius itself.
    fn is_beyond(own: &[Self], other: &[Self], radius: &Self) -> Option<bool> {
        let ends = match (own, other) {
            ([own], [other]) => (own.clone() - other).ends(),
            _ => None,
        };
        let Some(([lo, hi], radius)) = ends.zip(radius.exact()) else {
            let difference = (square(own, other)? - radius.square()).plain().number;
            let is_near = *difference.enclosure(radius.plain().precision).hi() <= Dyadic::zero();
            return if is_near { Some(false) } else { Some(difference.sign()? == Sign::Positive) };
        };
        if lo > *radius || hi < -radius.clone() {
            return Some(true);
        }
        (lo >= -radius.clone() && hi <= *radius).then_some(false)
    }

    fn write(
        machine: &mut Evaluator<AffineNumber>,
        law: &Law,
        moment: (&AffineNumber, &[AffineNumber]),
        hearing: &dyn Hearing,
        next: &mut [AffineNumber],
    ) -> Result<(), Fault> {
        law.write_rates(machine, moment, hearing, next)
    }
}

/// The square of the distance of two places; nothing where there are none.
fn square<T: Ring>(own: &[T], other: &[T]) -> Option<T> {
    let products = own.iter().zip(other).map(|(x, y)| (x.clone() - y).square());
    products.reduce(|sum, square| sum + square)
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
    ///
    /// # Errors
    /// [`RunError`] where it cannot be told who is linked.
    pub fn new(own: Described, state: Vec<T>, zero: &T) -> Result<Self, RunError> {
        let complete = own.network.is_all_to_all();
        let mut stepping = Stepping {
            radius: own.radius.map(|radius| zero.rational(&radius)),
            machine: zero.machine(&own.law, complete),
            random: own.random,
            observed: RefCell::new(Blocks::observables(&own.law, complete)),
            // What stands behind the state stays as it is.
            next: state.clone(),
            law: own.law,
            network: own.network,
            step: own.step,
            taken: 0,
            state,
            declaration: own.declaration,
        };
        stepping.relink()?;
        Ok(stepping)
    }

    /// One step; the links that came and went with it.
    pub fn step(&mut self) -> Result<Vec<Event>, RunError> {
        let time = self.time();
        let now = time.to_f64().unwrap_or(f64::NAN);
        let Some(scalar) = self.state.first().map(|like| like.rational(&time)) else { return Ok(Vec::new()) };
        if self.state.iter().any(T::is_too_long) {
            let fault =
                "an exact number has more than 300000 digits; without `exact = true` the steps are taken in floats";
            return Err(RunError::Own { time: now, fault: fault.to_string() });
        }
        let drawn = draw(&self.law, &mut self.random);
        T::set_drawn(&mut self.machine, &drawn);
        let moment = (&scalar, &self.state[..]);
        let written = T::write(&mut self.machine, &self.law, moment, &Heard(&self.network), &mut self.next);
        written.map_err(|fault| RunError::Own { time: now, fault: in_words(&self.law, &fault) })?;
        if self.next.iter().any(|x| !x.rounded().is_finite()) {
            return Err(RunError::Own { time: now, fault: "a number grows beyond the floats".to_string() });
        }
        std::mem::swap(&mut self.state, &mut self.next);
        self.taken += 1;
        let time = self.time().to_f64().unwrap_or(f64::NAN);
        Ok(self.relink()?.iter().map(|change| Event::new(time, change)).collect())
    }

    pub fn state(&self) -> &[T] {
        &self.state
    }

    /// Changes each number of the state in its place.
    pub fn change(&mut self, change: impl FnMut(&mut T)) {
        self.state.iter_mut().for_each(change);
    }

    pub fn law(&self) -> &Law {
        &self.law
    }

    /// The numbers of the observables over any scalar, each with a value or why it has none.
    pub fn observed<U: Number>(&self, time: &U, state: &[U]) -> Vec<Result<U, Fault>> {
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
        self.state.iter().map(T::rounded).collect()
    }

    pub fn time(&self) -> Rational {
        &self.step * Rational::from_integer(self.taken.into())
    }

    /// The numbers of an agent's place.
    fn place(&self, agent: usize) -> &[T] {
        self.law.position().map_or(&[], |position| {
            let from = position.start + agent * position.width;
            &self.state[from..from + position.width]
        })
    }

    fn square(&self, (i, j): Pair) -> Option<T> {
        square(self.place(i), self.place(j))
    }

    /// The links of the places, or those that are due; what has changed.
    fn relink(&mut self) -> Result<Vec<Change>, RunError> {
        let pairs = match self.network.rule() {
            Rule::Fixed => {
                let now = self.time().to_f64().unwrap_or(f64::NAN);
                let mut changes = Vec::new();
                while self.network.next_time().is_some_and(|due| due <= now) {
                    changes.extend(self.network.replace());
                }
                return Ok(changes);
            }
            Rule::Within(radius) => self.within(radius)?,
            Rule::Nearest(count) => self.nearest(count)?,
        };
        Ok(self.network.exchange(pairs))
    }

    /// Why it is not known who is linked.
    fn untold(&self, what: &str) -> RunError {
        RunError::Own { time: self.time().to_f64().unwrap_or(f64::NAN), fault: what.to_string() }
    }

    /// Floats propose who may be near, the scalar decides: at most the radius.
    fn within(&self, radius: f64) -> Result<Vec<Pair>, RunError> {
        let Some(exact) = &self.radius else { return Ok(Vec::new()) };
        let floats = self.floats();
        let far = floats.iter().fold(radius, |most: f64, x| most.max(x.abs()));
        let spread = self.state.iter().fold(0.0, |most: f64, x| most.max(x.spread()));
        let mut pairs = Vec::new();
        for pair in self.network.within(&floats, radius + 1e-9 * far + 4.0 * spread) {
            let (own, other) = (self.place(pair.0), self.place(pair.1));
            if own.is_empty() {
                continue;
            }
            let is_beyond = T::is_beyond(own, other, exact).ok_or_else(|| {
                self.untold(&format!(
                    "whether agents {} and {} are within the radius of each other cannot be told",
                    pair.0 + 1,
                    pair.1 + 1
                ))
            })?;
            if !is_beyond {
                pairs.push(pair);
            }
        }
        Ok(pairs)
    }

    /// The so many nearest of each; of two at one distance the one with the smaller number.
    fn nearest(&self, count: usize) -> Result<Vec<Pair>, RunError> {
        let agents = self.law.agents();
        let mut arcs = Vec::new();
        for agent in 0..agents {
            let others = (0..agents).filter(|other| *other != agent);
            let mut rest: Vec<(T, usize)> =
                others.filter_map(|other| Some((self.square((agent, other))?, other))).collect();
            for _ in 0..count.min(rest.len()) {
                let mut nearest = 0;
                for k in 1..rest.len() {
                    let (i, j, of) = (rest[k].1 + 1, rest[nearest].1 + 1, agent + 1);
                    let what = || format!("which of agents {i} and {j} is nearer to agent {of} cannot be told");
                    let sign = (rest[k].0.clone() - &rest[nearest].0).sign();
                    if sign.ok_or_else(|| self.untold(&what()))? == Sign::Negative {
                        nearest = k;
                    }
                }
                arcs.push((agent, rest.remove(nearest).1));
            }
        }
        Ok(arcs)
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
