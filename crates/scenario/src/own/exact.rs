//! A law of one's own in discrete time, step by step, for what is decided: on rational numbers where it has no other functions, else enclosed.

use super::discrete::{Stepped, Stepping};
use super::read::{Described, describe};
use crate::error::{ConfigError, RunError};
use crate::source::{Entry, Source};
use crate::view::Links;
use arithmetic::{Interval, PreciseNumber, Rational, RealNumber, rational};
use expressions::{Fault, Kind, Law, Variable};

/// A flock under a law in discrete time at its start; its steps are of length 1.
pub struct OwnFlock {
    described: Described,
    /// Numbers of the start that are only known to lie between two others, by their places in the state.
    wide: Vec<(usize, [Rational; 2])>,
}

impl OwnFlock {
    /// The flock of a scenario at its start: nothing for other models and for continuous time; in words why it is not followed.
    ///
    /// # Errors
    /// [`ConfigError`].
    pub fn of(source: &Source) -> Result<Option<Result<Self, &'static str>>, ConfigError> {
        if !OwnFlock::is_of(source) {
            return Ok(None);
        }
        let described = describe(source)?;
        Ok(Some(if !described.law.drawn().is_empty() {
            Err("laws with noise are not enclosed")
        } else if described.step != rational(1, 1) {
            Err("laws in discrete time are followed in steps of length 1")
        } else {
            Ok(OwnFlock { described, wide: Vec::new() })
        }))
    }

    /// Whether a scenario is of a law of one's own in discrete time.
    pub fn is_of(source: &Source) -> bool {
        let word = |entry: Option<Entry>, wanted: &str| {
            entry.is_some_and(|entry| entry.word().is_ok_and(|word| word == wanted))
        };
        let law = source.section("law").ok().flatten();
        word(source.top().get("model"), "own") && law.is_some_and(|law| word(law.get("time"), "discrete"))
    }

    /// The law.
    pub fn law(&self) -> &Law {
        &self.described.law
    }

    /// Lets a number of the start lie anywhere between two others; agents and coordinates count from 0. Whether there is such a number.
    pub fn widen(&mut self, part: &str, agent: usize, coordinate: usize, ends: [Rational; 2]) -> bool {
        let law = &self.described.law;
        let part = law.variables().iter().find(|variable| variable.name == part);
        let Some(part) = part.filter(|part| agent < law.agents() && coordinate < part.width) else { return false };
        self.wide.push((part.start + agent * part.width + coordinate, ends));
        true
    }

    /// Whether all numbers of the start are known exactly.
    pub fn is_exact(&self) -> bool {
        self.wide.is_empty()
    }

    /// The flock at its start, whose enclosures have so many bits.
    ///
    /// # Errors
    /// [`RunError`] where it cannot be told who is linked.
    pub fn start(&self, bits: u32) -> Result<OwnSteps, RunError> {
        let exact = |q: &Rational| PreciseNumber::exact(q.clone(), bits);
        let mut state: Vec<PreciseNumber> = self.described.state.iter().map(exact).collect();
        for (place, [lo, hi]) in &self.wide {
            let [lo, hi] = [lo, hi].map(|end| Interval::from_rational(end, bits));
            state[*place].number = RealNumber::interval(lo.hull(&hi));
        }
        let stepping = Stepping::new(self.described.clone(), state, &exact(&rational(0, 1)))?;
        Ok(OwnSteps { stepping })
    }
}

/// A flock under a law in discrete time after some steps: numbers are exact where they are rational by their making, and enclosed elsewhere.
pub struct OwnSteps {
    stepping: Stepping<PreciseNumber>,
}

impl OwnSteps {
    /// One step.
    ///
    /// # Errors
    /// [`RunError`] where a number has no value, or it cannot be told which one.
    pub fn step(&mut self) -> Result<(), RunError> {
        self.stepping.step().map(drop)
    }

    /// Goes on with enclosures of all numbers where an exact one has more digits than exact runs follow, or all together have more bits: exact numbers under a law that squares grow without use.
    pub fn enclose_beyond(&mut self, bits: u64) {
        let length = |x: &PreciseNumber| match &x.number {
            RealNumber::Exact(q) => (q.numer().bits() + q.denom().bits(), q.is_too_long()),
            _ => (0, false),
        };
        let lengths = self.state().iter().map(length);
        let (together, any) = lengths.fold((0, false), |(sum, any), (own, long)| (sum + own, any || long));
        if together > bits || any {
            self.stepping.change(|x| x.number = RealNumber::interval(x.number.enclosure(x.precision)));
        }
    }

    /// The whole state.
    pub fn state(&self) -> &[PreciseNumber] {
        self.stepping.state()
    }

    /// The numbers of the observables, each with a value or why it has none, or why it cannot be told which one.
    pub fn observed(&self) -> Vec<Result<RealNumber, Fault>> {
        let Some(like) = self.state().first() else { return Vec::new() };
        let time = PreciseNumber::exact(self.stepping.time(), like.precision);
        let all = self.stepping.observed(&time, self.state());
        all.into_iter().map(|number| number.map(|x| x.number)).collect()
    }

    /// Whether a state that stays as it is in a step stays so for ever: neither the law nor the network depends on the time from now on.
    pub fn is_autonomous(&self) -> bool {
        self.stepping.is_autonomous()
    }

    /// The rows of a part of the state.
    fn rows(&self, part: Option<&Variable>) -> Vec<Vec<PreciseNumber>> {
        let agents = self.stepping.law().agents();
        let row =
            |part: &Variable, agent: usize| self.state()[part.start + agent * part.width..][..part.width].to_vec();
        part.map_or_else(Vec::new, |part| (0..agents).map(|agent| row(part, agent)).collect())
    }

    /// Where the agents are.
    pub fn positions(&self) -> Vec<Vec<PreciseNumber>> {
        self.rows(self.stepping.law().position())
    }

    /// The part `v` of the state, where it is no angle.
    pub fn velocities(&self) -> Vec<Vec<PreciseNumber>> {
        let law = self.stepping.law();
        self.rows(law.variables().iter().find(|part| part.name == "v" && part.kind != Kind::Angle))
    }

    /// Who is linked.
    pub fn links(&self) -> Links<'static> {
        self.stepping.shown()
    }
}
