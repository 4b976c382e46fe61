//! Laws of one's own: texts, and what is compiled from them.

use super::compile::Compiler;
use super::evaluate::{Evaluator, Fault, Hearing};
use super::problem::Problem;
use super::program::Program;
use arithmetic::{Number, Rational};
use std::sync::Arc;

/// What an agent has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// As many numbers as the law has dimensions.
    Vector,
    /// A number.
    Number,
    /// An angle in radians.
    Angle,
}

/// How time goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Time {
    /// The expressions are rates of change.
    #[default]
    Continuous,
    /// The expressions are the next state.
    Discrete,
}

/// A law as it is written. Expressions are texts of the language; `notes/laws.md` of the program shows them.
#[derive(Debug, Clone, Default)]
pub struct LawText {
    /// Continuous or discrete.
    pub time: Time,
    /// Numbers of a vector: 1, 2 or 3.
    pub dimension: usize,
    /// What each agent has.
    pub state: Vec<(String, Kind)>,
    /// The vector, or in one dimension the number, that says where an agent is.
    pub position: Option<String>,
    /// Parameters: one value, or a list with one for each agent.
    pub parameters: Vec<(String, Parameter)>,
    /// Abbreviations, `name` or `name(i, j)` with the agents that they speak of.
    pub define: Vec<(String, String)>,
    /// The rate of change, or the next value, of each part of the state.
    pub rates: Vec<(String, String)>,
    /// Of parts of the state in continuous time the strength of the noise: the standard deviation of each of its numbers after one unit of time.
    pub noise: Vec<(String, String)>,
    /// What is measured on the flock.
    pub observables: Vec<(String, String)>,
    /// Whether links may be others after a step of discrete time, so that nobody knows from a state who is heard after it.
    pub links_change: bool,
}

/// How a number is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Drawn {
    /// Standard normal.
    Normal,
    /// Uniform between 0 and 1.
    Uniform,
}

/// The value of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub enum Parameter {
    /// The same for all agents.
    One(Rational),
    /// One for each agent.
    Each(Vec<Rational>),
}

/// Why a law cannot be compiled.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{problem}")]
pub struct LawError {
    /// The table of the law: `define`, `rates`, `observables`, `state`, `parameters`.
    pub table: &'static str,
    /// The key in it.
    pub key: String,
    /// The byte of the expression; nothing where the whole entry is at fault.
    pub at: Option<usize>,
    /// What is wrong.
    pub problem: Problem,
}

/// A number of a flock that a property asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Asked {
    /// Where it stands in the state.
    State(usize),
    /// Where it stands among the numbers of the observables.
    Observed(usize),
}

/// A part of the state.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Variable {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: Kind,
    /// Where those of the first agent begin in a state.
    pub start: usize,
    /// Numbers for each agent.
    pub width: usize,
}

/// A compiled law for so many agents. A state is a list: the numbers of the position of all agents, agent by agent, then those of the other parts in
/// the order of their names in [`LawText::state`].
#[derive(Debug, Clone)]
pub struct Law {
    pub(crate) agents: usize,
    pub(crate) variables: Vec<Variable>,
    /// How many of the variables, from the first one, are the position: 1 or 0.
    pub(crate) placed: bool,
    pub(crate) lists: Vec<Vec<Rational>>,
    pub(crate) rates: Arc<Program>,
    /// Where each number of an agent that the program computes goes: variable and component.
    pub(crate) targets: Vec<(usize, usize)>,
    /// The lists, behind those of the parameters, that are drawn anew for every step, one number for each agent.
    pub(crate) drawn: Vec<Drawn>,
    /// The strength of the noise of each number that the rates have; zero where there is none.
    pub(crate) noise: Option<Arc<Program>>,
    pub(crate) observed: Arc<Program>,
    /// Names of the observables with how many numbers each has.
    pub(crate) observables: Vec<(String, usize)>,
    pub(crate) open: Vec<OpenParameter>,
}

/// A parameter whose numbers are read behind the state, so that they may be other ones each time.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenParameter {
    /// Its name.
    pub name: String,
    /// Where its numbers begin.
    pub start: usize,
    /// What the text has: one number for all agents, or one for each.
    pub values: Vec<Rational>,
}

impl LawText {
    /// Compiles the law for so many agents.
    ///
    /// # Errors
    /// [`LawError`], with the place.
    pub fn compile(&self, agents: usize) -> Result<Law, LawError> {
        self.compile_open(agents, &[])
    }

    /// The same with some parameters left open: their numbers stand behind those of the agents in every state, in this order, and have no rate.
    ///
    /// # Errors
    /// [`LawError`], with the place.
    pub fn compile_open(&self, agents: usize, open: &[&str]) -> Result<Law, LawError> {
        Compiler::new(self, agents)?.law(open)
    }
}

impl Law {
    /// The number of agents.
    pub fn agents(&self) -> usize {
        self.agents
    }

    /// The parts of the state, in their order; the position first, where there is one.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The part that says where agents are.
    pub fn position(&self) -> Option<&Variable> {
        self.variables.first().filter(|_| self.placed)
    }

    /// Numbers of a state, without those of open parameters.
    pub fn size(&self) -> usize {
        self.variables.iter().map(|variable| variable.width * self.agents).sum()
    }

    /// The parameters that were left open.
    pub fn open(&self) -> &[OpenParameter] {
        &self.open
    }

    /// The observables with how many numbers each has.
    pub fn observables(&self) -> &[(String, usize)] {
        &self.observables
    }

    /// Whether the rates, or the next state, do not depend on the time.
    pub fn is_autonomous(&self) -> bool {
        self.rates.is_autonomous()
    }

    /// What is drawn for every step, each once for every agent, in the order of [`Evaluator::set_drawn`] and [`crate::Blocks::set_drawn`].
    pub fn drawn(&self) -> &[Drawn] {
        &self.drawn
    }

    /// Whether there is noise in continuous time.
    pub fn is_noisy(&self) -> bool {
        self.noise.is_some()
    }

    /// Writes the strength of the noise of each number of a state.
    ///
    /// # Errors
    /// [`Fault`] where a number has no value.
    pub fn write_noise(
        &self,
        evaluator: &mut Evaluator<f64>,
        (time, state): (f64, &[f64]),
        hearing: &dyn Hearing,
        strength: &mut [f64],
    ) -> Result<(), Fault> {
        evaluator.agents(0..hearing.agents(), (&time, state), hearing, |agent, output, value| {
            self.put(agent, output, value, strength);
        })
    }

    /// What computes [`Self::write_noise`].
    pub fn noise_evaluator(&self) -> Option<Evaluator<f64>> {
        self.noise.as_ref().map(|program| Evaluator::new(program, &self.lists, &0.0))
    }

    pub(crate) fn put<T>(&self, agent: usize, output: usize, value: T, to: &mut [T]) {
        let (variable, component) = self.targets[output];
        let variable = &self.variables[variable];
        to[variable.start + agent * variable.width + component] = value;
    }

    /// Whether rational states stay rational.
    pub fn is_rational(&self) -> bool {
        self.rates.is_rational()
    }

    /// An evaluator of the rates (or next values) for scalars like this one.
    pub fn evaluator<T: Number>(&self, like: &T) -> Evaluator<T> {
        Evaluator::new(&self.rates, &self.lists, like)
    }

    /// Writes the rates, or the next state, of a state.
    ///
    /// # Errors
    /// [`Fault`] where a number has no value.
    pub fn write_rates<T: Number>(
        &self,
        evaluator: &mut Evaluator<T>,
        moment: (&T, &[T]),
        hearing: &dyn Hearing,
        rates: &mut [T],
    ) -> Result<(), Fault> {
        self.write_rates_of(0..hearing.agents(), evaluator, moment, hearing, rates)
    }

    /// Those of some agents only, from 0.
    pub(crate) fn write_rates_of<T: Number>(
        &self,
        agents: impl Iterator<Item = usize>,
        evaluator: &mut Evaluator<T>,
        moment: (&T, &[T]),
        hearing: &dyn Hearing,
        rates: &mut [T],
    ) -> Result<(), Fault> {
        evaluator.agents(agents, moment, hearing, |agent, output, value| self.put(agent, output, value, rates))
    }

    /// The rates, or the next state, of a state; zeros for open parameters.
    ///
    /// # Errors
    /// [`Fault`] where a number has no value.
    pub fn rates<T: Number>(&self, time: &T, state: &[T], hearing: &dyn Hearing) -> Result<Vec<T>, Fault> {
        let mut rates = vec![time.zero(); state.len()];
        self.write_rates(&mut self.evaluator(time), (time, state), hearing, &mut rates)?;
        Ok(rates)
    }

    /// An evaluator of the observables, in their order ([`Evaluator::flock`]).
    pub fn observing<T: Number>(&self, like: &T) -> Evaluator<T> {
        Evaluator::new(&self.observed, &self.lists, like)
    }

    /// The numbers of all observables, in their order, each with a value or why it has none.
    pub fn observe<T: Number>(&self, time: &T, state: &[T], hearing: &dyn Hearing) -> Vec<Result<T, Fault>> {
        self.observing(time).flock_each(time, state, hearing)
    }

    /// A number by its name in a property: `x[2].1` and `v[1]` of the state, observables by their names, `momentum.1` where they are vectors.
    pub fn number(&self, name: &str) -> Option<Asked> {
        if let Some((part, rest)) = name.split_once('[') {
            let (agent, component) = rest.split_once(']')?;
            let variable = self.variables.iter().find(|variable| variable.name == part)?;
            let agent = agent.parse::<usize>().ok()?.checked_sub(1).filter(|agent| *agent < self.agents)?;
            let component = match component.strip_prefix('.') {
                Some(component) if variable.width > 1 => component.parse::<usize>().ok()?.checked_sub(1)?,
                None if component.is_empty() && variable.width == 1 => 0,
                _ => return None,
            };
            let place = variable.start + agent * variable.width + component;
            return (component < variable.width).then_some(Asked::State(place));
        }
        let (name, component) = name.split_once('.').map_or((name, None), |(name, k)| (name, Some(k)));
        let mut start = 0;
        for (known, width) in &self.observables {
            if known == name {
                let component = match component {
                    Some(component) if *width > 1 => component.parse::<usize>().ok()?.checked_sub(1)?,
                    None if *width == 1 => 0,
                    _ => return None,
                };
                return (component < *width).then_some(Asked::Observed(start + component));
            }
            start += width;
        }
        None
    }

    /// Whether that is the name of an angle of an agent.
    pub fn is_angle(&self, name: &str) -> bool {
        let part = name.split_once('[').map(|(part, _)| part);
        let is_one = |variable: &Variable| Some(variable.name.as_str()) == part && variable.kind == Kind::Angle;
        self.variables.iter().any(is_one) && self.number(name).is_some()
    }

    /// Whether the observables depend on the time.
    pub fn observes_time(&self) -> bool {
        !self.observed.is_autonomous()
    }

    /// The name of the part of the state whose rate a [`Fault`] is about.
    pub fn name_of(&self, fault: &Fault) -> &str {
        self.targets.get(fault.output).map_or("", |(variable, _)| &self.variables[*variable].name)
    }
}
