//! A run of a law of one's own as it is described: in floats, with rational numbers in discrete time, or for enclosures.

use super::continuous::Moving;
use super::discrete::Stepping;
use super::enclosed::OwnMotion;
use super::noisy::Noisy;
use super::read::Described;
use crate::described::{Built, Described as Motion};
use crate::error::{ConfigError, Problem, RunError};
use crate::exact::ExactMotion;
use crate::simulation::{Continuous, Simulation};
use crate::source::Source;
use crate::start::float;
use arithmetic::rational;
use expressions::Time;

/// The run in floats, or of discrete time exactly; with it the step of discrete time.
fn simulation(mut own: Described, source: &Source, tolerance: f64) -> Result<Built, ConfigError> {
    let run = source.needed("run")?;
    let fixed = run.get("step").map(|entry| entry.positive()).transpose()?;
    let at_start = |problem: Problem| source.needed("state").map_or_else(|error| error, |own| own.problem(problem));
    if own.time == Time::Discrete {
        if let Some(entry) = run.get("step") {
            return Err(entry.range("left out: in discrete time `step` stands in [law]"));
        }
        let exact = run.get("exact").map_or(Ok(false), |entry| entry.flag())?;
        if exact && !own.law.drawn().is_empty() {
            return Err(run.need("exact", "true or false")?.range("false: the law has noise"));
        }
        if exact && !own.law.is_rational() {
            let why = "false: the law has functions whose values are not rational";
            return Err(run.need("exact", "true or false")?.range(why));
        }
        let step = own.step.clone();
        let untold = |error: RunError| at_start(Problem::Start(error.to_string()));
        let state = std::mem::take(&mut own.state);
        let simulation: Box<dyn Simulation> = if exact {
            own.declaration.push("exact steps on rational numbers, rounded once where they are written".to_string());
            Box::new(Stepping::new(own, state, &rational(0, 1)).map_err(untold)?)
        } else {
            let state = state.iter().map(float).collect();
            Box::new(Stepping::new(own, state, &0.0).map_err(untold)?)
        };
        return Ok((simulation, Some(step)));
    }
    if let Some(entry) = run.get("exact") {
        return Err(entry.range("left out: only laws in discrete time run exactly; `check` encloses continuous ones"));
    }
    let state: Vec<f64> = own.state.iter().map(float).collect();
    if own.law.is_noisy() {
        let Some(step) = fixed else {
            let why = "given: a law with noise is followed in fixed steps, by the method of Euler and Maruyama";
            return Err(run.problem(Problem::Needs("step", why)));
        };
        return Ok((Box::new(Noisy::new(own, state, step)), None));
    }
    let mut moving = Moving::new(own);
    moving.start(&state).map_err(at_start)?;
    let simulation: Box<dyn Simulation> = match fixed {
        Some(step) => Box::new(moving.stepped(state, step)),
        None => Box::new(Continuous::new(moving.located(&state), &state, tolerance)),
    };
    Ok((simulation, None))
}

impl Motion for Described {
    fn exact(&self) -> ExactMotion {
        OwnMotion::of(self.clone()).map_or_else(ExactMotion::Other, |own| ExactMotion::Own(Box::new(own)))
    }

    fn simulation(self: Box<Self>, source: &Source, tolerance: f64) -> Result<Built, ConfigError> {
        simulation(*self, source, tolerance)
    }
}
