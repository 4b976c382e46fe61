//! Velocity alignment within a radius for large flocks: steps of fixed length, neighbours by cells; switches are passed over.

use super::alignment::Agents;
use super::course::{Course, Event, Frame, Law};
use super::error::RunError;
use super::observables::Observable;
use crate::arithmetic::ArithmeticError;
use crate::double_integrator::SwitchingFlock;
use crate::simulate::Rk4;

/// A flock with its state.
pub(super) struct LargeFlock {
    agents: Agents,
    field: SwitchingFlock,
    method: Rk4,
    list: Vec<f64>,
    time: f64,
    /// The longest step.
    step: f64,
}

impl LargeFlock {
    /// A flock at its start.
    pub fn new(agents: Agents, field: SwitchingFlock, list: Vec<f64>, step: f64) -> Self {
        LargeFlock { agents, field, method: Rk4::new(list.len()), list, time: 0.0, step }
    }
}

impl Course for LargeFlock {
    fn advance(&mut self, until: f64, _: &mut Vec<Event>, halt: &dyn Fn() -> bool) -> Result<bool, RunError> {
        let from = self.time;
        // A remainder of a hair's breadth is taken along.
        let steps = ((until - from) / self.step * (1.0 - 1e-12)).ceil().max(0.0);
        let length = (until - from) / steps.max(1.0);
        let mut taken = 0.0;
        while taken < steps {
            if halt() {
                return Ok(false);
            }
            self.method.step(&mut self.field, self.time, length, &mut self.list);
            taken += 1.0;
            self.time = from + taken * length;
            if let Some(error) = self.field.take_failure() {
                return Err(RunError::Large { time: self.time, error });
            }
        }
        self.time = until;
        self.agents.settle(&self.list);
        Ok(true)
    }

    fn frame(&self) -> Frame {
        self.agents.frame(self.time, &self.list)
    }

    fn observe(&self) -> Result<Vec<Observable>, ArithmeticError> {
        self.agents.observe(self.time, &self.list)
    }

    fn declaration(&self) -> Vec<String> {
        let mut lines = self.agents.declaration();
        lines.push(format!(
            "integrator: the classical method of Runge and Kutta of order 4, steps of {} or a little less, so that they end at every time that is written; links are read off the positions in every stage: switches are neither located nor listed, and the tolerance has no effect",
            self.step
        ));
        lines
    }
}
