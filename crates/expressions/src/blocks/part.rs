//! Code with its columns and its working space.

use super::code::{Code, Column};
use super::lanes::BLOCK;
use super::run::{Moment, Space};
use crate::evaluate::Hearing;
use crate::law::Law;
use crate::program::Program;
use arithmetic::Rational;
use num_traits::ToPrimitive;
use rayon::prelude::*;
use std::sync::{Mutex, PoisonError};

/// Pairs of agents that are worth a task of their own.
const TASK: usize = 4096;

/// A program that runs by itself.
#[derive(Debug)]
pub(super) struct Part {
    code: Code,
    columns: Vec<Vec<f64>>,
    spaces: Mutex<Vec<Space>>,
    arch: pulp::Arch,
}

impl Part {
    /// Of the agents' numbers, or of those of the flock.
    pub fn new(program: &Program, law: &Law, of_agents: bool) -> Self {
        let code = Code::new(program, of_agents);
        let rounded = |q: &Rational| q.to_f64().unwrap_or(f64::NAN);
        let column = |column: &Column| match column {
            Column::Parameter(list) if *list < law.lists.len() => law.lists[*list].iter().map(rounded).collect(),
            Column::State { .. } | Column::Parameter(_) => vec![0.0; law.agents()],
        };
        let columns = code.columns.iter().map(column).collect();
        let spaces = Mutex::new(vec![Space::new(&code)]);
        Part { code, columns, spaces, arch: pulp::Arch::new() }
    }

    /// Numbers for each agent.
    pub fn width(&self) -> usize {
        self.code.outputs.len()
    }

    /// Sets parameters: `of` writes the numbers of a list, one for each agent, where it has them.
    pub fn set_parameters(&mut self, of: impl Fn(usize, &mut Vec<f64>)) {
        for (numbers, column) in self.columns.iter_mut().zip(&self.code.columns) {
            if let Column::Parameter(list) = column {
                of(*list, numbers);
            }
        }
    }

    fn fill_columns(&mut self, state: &[f64]) {
        for (numbers, column) in self.columns.iter_mut().zip(&self.code.columns) {
            if let Column::State { start, stride, component } = column {
                let from = state[start + component..].iter().step_by(*stride);
                numbers.iter_mut().zip(from).for_each(|(to, x)| *to = *x);
            }
        }
    }

    /// Writes the numbers of all agents, agent by agent.
    pub fn agents(&mut self, time: f64, state: &[f64], hearing: &dyn Hearing, outputs: &mut Vec<f64>) {
        self.fill_columns(state);
        let (agents, width) = (hearing.agents(), self.width());
        outputs.resize(agents * width, 0.0);
        let moment = Moment { arch: self.arch, time, columns: &self.columns, hearing };
        let mut space = self.space();
        space.flock(&self.code, &moment);
        let heard = |agent| hearing.heard(agent).map_or(agents - 1, <[usize]>::len);
        let pairs: usize = if self.code.looks_at_others() { (0..agents).map(heard).sum() } else { 0 };
        let work = pairs.max(agents);
        // Agents that are computed together: it depends on the network only.
        let together = (TASK * agents / work.max(1)).clamp(1, BLOCK);
        if work <= TASK {
            for (task, outputs) in outputs.chunks_mut(together * width.max(1)).enumerate() {
                space.agents(&self.code, &moment, task * together, outputs);
            }
            self.keep(space);
            return;
        }
        let flock = space.flock_numbers(&self.code, &moment);
        self.keep(space);
        outputs.par_chunks_mut(together * width.max(1)).enumerate().for_each(|(task, outputs)| {
            let mut space = self.space();
            space.take_flock(&self.code, &flock);
            space.agents(&self.code, &moment, task * together, outputs);
            self.keep(space);
        });
    }

    /// The numbers of the flock.
    pub fn flock(&mut self, time: f64, state: &[f64], hearing: &dyn Hearing) -> Vec<f64> {
        self.fill_columns(state);
        let moment = Moment { arch: self.arch, time, columns: &self.columns, hearing };
        let mut space = self.space();
        space.flock(&self.code, &moment);
        let numbers = space.flock_numbers(&self.code, &moment);
        self.keep(space);
        self.code.outputs.iter().map(|&register| numbers[register]).collect()
    }

    fn space(&self) -> Space {
        let kept = self.spaces.lock().unwrap_or_else(PoisonError::into_inner).pop();
        kept.unwrap_or_else(|| Space::new(&self.code))
    }

    fn keep(&self, space: Space) {
        self.spaces.lock().unwrap_or_else(PoisonError::into_inner).push(space);
    }
}
