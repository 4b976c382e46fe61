//! A law of one's own in discrete time, step by step, for what is decided: on rational numbers where it has no other functions, else enclosed.

use super::affine::{AffineNumber, start_of};
use super::discrete::{MOST_BITS, Stepping};
use super::enclosed::place;
use super::read::{Described, describe_open};
use crate::error::{ConfigError, RunError};
use crate::source::{Entry, Source};
use crate::view::Links;
use arithmetic::{Field, PreciseNumber, Rational, RealNumber, rational};
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
        OwnFlock::of_open(source, &[])
    }

    /// The same, where the numbers of some parameters stand behind the state ([`expressions::LawText::compile_open`]).
    ///
    /// # Errors
    /// [`ConfigError`].
    pub fn of_open(source: &Source, open: &[&str]) -> Result<Option<Result<Self, &'static str>>, ConfigError> {
        if !OwnFlock::is_of(source) {
            return Ok(None);
        }
        let described = describe_open(source, open)?;
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

    /// Lets a number of the start, or of an open parameter, lie anywhere between two others; agents and coordinates count from 0. Whether there is such a number.
    pub fn widen(&mut self, part: &str, agent: usize, coordinate: usize, ends: [Rational; 2]) -> bool {
        let place = place(&self.described.law, part, agent, coordinate);
        self.wide.extend(place.map(|place| (place, ends)));
        place.is_some()
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
        let state = start_of(&self.described.state, &self.wide, bits);
        let zero = AffineNumber::Plain(PreciseNumber::exact(rational(0, 1), bits));
        let stepping = Stepping::new(self.described.clone(), state, &zero)?;
        Ok(OwnSteps { stepping })
    }
}

/// A flock under a law in discrete time after some steps: numbers are exact where they are rational by their making, and enclosed elsewhere.
pub struct OwnSteps {
    stepping: Stepping<AffineNumber>,
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
        let length = |x: &AffineNumber| match x {
            AffineNumber::Affine(f) => f.bits(),
            AffineNumber::Plain(PreciseNumber { number: RealNumber::Exact(q), .. }) => {
                (q.numer().bits() + q.denom().bits(), q.numer().bits().max(q.denom().bits()))
            }
            AffineNumber::Plain(_) => (0, 0),
        };
        let (together, most) =
            self.state().iter().map(length).fold((0, 0), |(sum, most), (own, long)| (sum + own, most.max(long)));
        if together > bits || most > MOST_BITS {
            self.stepping.change(|x| {
                let plain = x.plain();
                let number = RealNumber::interval(plain.number.enclosure(plain.precision));
                *x = AffineNumber::Plain(PreciseNumber { number, ..plain });
            });
        }
    }

    /// The whole state.
    pub fn state(&self) -> &[AffineNumber] {
        self.stepping.state()
    }

    /// The numbers of the observables, each with a value or why it has none, or why it cannot be told which one.
    pub fn observed(&self) -> Vec<Result<RealNumber, Fault>> {
        let Some(like) = self.state().first() else { return Vec::new() };
        let time = like.rational(&self.stepping.time());
        let all = self.stepping.observed(&time, self.state());
        all.into_iter().map(|number| number.map(|x| x.plain().number)).collect()
    }

    /// Whether a state that stays as it is in a step stays so for ever: neither the law nor the network depends on the time from now on.
    pub fn is_autonomous(&self) -> bool {
        self.stepping.is_autonomous()
    }

    /// The rows of a part of the state.
    fn rows(&self, part: Option<&Variable>) -> Vec<Vec<AffineNumber>> {
        let agents = self.stepping.law().agents();
        let row =
            |part: &Variable, agent: usize| self.state()[part.start + agent * part.width..][..part.width].to_vec();
        part.map_or_else(Vec::new, |part| (0..agents).map(|agent| row(part, agent)).collect())
    }

    /// Where the agents are.
    pub fn positions(&self) -> Vec<Vec<AffineNumber>> {
        self.rows(self.stepping.law().position())
    }

    /// The part `v` of the state, where it is no angle.
    pub fn velocities(&self) -> Vec<Vec<AffineNumber>> {
        let law = self.stepping.law();
        self.rows(law.variables().iter().find(|part| part.name == "v" && part.kind != Kind::Angle))
    }

    /// Who is linked.
    pub fn links(&self) -> Links<'static> {
        self.stepping.shown()
    }
}
