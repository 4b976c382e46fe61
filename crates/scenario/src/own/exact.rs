//! A law of one's own in discrete time on rational numbers, step by step: for what is decided exactly.

use super::discrete::Stepping;
use super::read::describe;
use crate::error::{ConfigError, RunError};
use crate::source::{Entry, Source};
use crate::view::Links;
use arithmetic::{Interval, Rational, RealNumber, rational};
use expressions::{Fault, Kind, Law, Time, Variable};
use num_traits::ToPrimitive;

/// A flock under a law in discrete time, exact; its steps are of length 1.
pub struct OwnSteps {
    stepping: Stepping<Rational>,
}

impl std::fmt::Debug for OwnSteps {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("OwnSteps").field("state", &self.stepping.state()).finish_non_exhaustive()
    }
}

impl OwnSteps {
    /// The flock of a scenario at its start: nothing for other models and for continuous time; in words why it is not followed exactly.
    ///
    /// # Errors
    /// [`ConfigError`].
    pub fn of(source: &Source) -> Result<Option<Result<Self, &'static str>>, ConfigError> {
        if !OwnSteps::are_of(source) {
            return Ok(None);
        }
        let mut described = describe(source)?;
        Ok(Some(if described.time != Time::Discrete {
            Err("time is continuous")
        } else if !described.law.drawn().is_empty() {
            Err("laws with noise are not exact")
        } else if !described.law.is_rational() {
            Err("the law has functions whose values are not rational, and laws in discrete time are not enclosed")
        } else if described.step != rational(1, 1) {
            Err("laws in discrete time are followed in steps of length 1")
        } else {
            let state = std::mem::take(&mut described.state);
            let rounded = |x: &Rational| x.to_f64().unwrap_or(f64::NAN);
            Ok(OwnSteps { stepping: Stepping::new(described, state, &rational(0, 1), rounded) })
        }))
    }

    /// Whether a scenario is of a law of one's own in discrete time.
    pub fn are_of(source: &Source) -> bool {
        let word = |entry: Option<Entry>, wanted: &str| {
            entry.is_some_and(|entry| entry.word().is_ok_and(|word| word == wanted))
        };
        let law = source.section("law").ok().flatten();
        word(source.top().get("model"), "own") && law.is_some_and(|law| word(law.get("time"), "discrete"))
    }

    /// One step.
    ///
    /// # Errors
    /// [`RunError`] where a number has no value.
    pub fn step(&mut self) -> Result<(), RunError> {
        self.stepping.step().map(drop)
    }

    /// The whole state.
    pub fn state(&self) -> &[Rational] {
        self.stepping.state()
    }

    /// The law.
    pub fn law(&self) -> &Law {
        self.stepping.law()
    }

    /// The numbers of the observables: exact, or enclosed.
    ///
    /// # Errors
    /// [`Fault`] where one has no value.
    pub fn observed(&self) -> Result<Vec<RealNumber>, Fault> {
        const BITS: u32 = 192;
        if let Ok(all) = self.stepping.observed(&self.stepping.time(), self.state()) {
            return Ok(all.into_iter().map(RealNumber::Exact).collect());
        }
        let enclosed = |q: &Rational| Interval::from_rational(q, BITS);
        let state: Vec<Interval> = self.state().iter().map(enclosed).collect();
        let all = self.stepping.observed(&enclosed(&self.stepping.time()), &state)?;
        Ok(all.into_iter().map(RealNumber::interval).collect())
    }

    /// Whether a state that stays as it is in a step stays so for ever: neither the law nor the network depends on the time from now on.
    pub fn is_autonomous(&self) -> bool {
        self.stepping.is_autonomous()
    }

    /// The rows of a part of the state.
    fn rows(&self, part: Option<&Variable>) -> Vec<Vec<Rational>> {
        let agents = self.stepping.law().agents();
        let row =
            |part: &Variable, agent: usize| self.state()[part.start + agent * part.stride..][..part.width].to_vec();
        part.map_or_else(Vec::new, |part| (0..agents).map(|agent| row(part, agent)).collect())
    }

    /// Where the agents are.
    pub fn positions(&self) -> Vec<Vec<Rational>> {
        self.rows(self.stepping.law().position())
    }

    /// The part `v` of the state, where it is no angle.
    pub fn velocities(&self) -> Vec<Vec<Rational>> {
        let law = self.stepping.law();
        self.rows(law.variables().iter().find(|part| part.name == "v" && part.kind != Kind::Angle))
    }

    /// Who is linked.
    pub fn links(&self) -> Links<'static> {
        self.stepping.shown()
    }
}
