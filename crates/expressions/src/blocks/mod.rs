//! Programs over floats, many lanes at a time: agents, pairs of them and what else a law loops over stand side by side in blocks, and every operation is
//! done for a whole block. What is written once for one agent so runs at the pace of vectors. [`crate::Evaluator`] computes the same one number
//! after the other over any scalar; it is the reference, and it tells why a number has no value.
//!
//! Results depend neither on the number of threads nor on the processor: which lanes stand in a block depends on the network only.

mod code;
mod fuse;
mod lanes;
mod run;

use crate::evaluate::{Evaluator, Fault, Hearing};
use crate::law::Law;
use arithmetic::Rational;
use code::{Code, Column};
use lanes::BLOCK;
use num_traits::ToPrimitive;
use rayon::prelude::*;
use run::{Moment, Space};
use std::sync::{Mutex, PoisonError};

/// Pairs of agents that are worth a task of their own.
const TASK: usize = 4096;

/// A program for blocks with its working space; used again and again, it allocates little.
#[derive(Debug)]
pub struct Blocks {
    code: Code,
    columns: Vec<Vec<f64>>,
    spaces: Mutex<Vec<Space>>,
    outputs: Vec<f64>,
    arch: pulp::Arch,
    /// What computes single numbers, where one has no value.
    slow: Evaluator<f64>,
}

impl Blocks {
    /// For the rates of a law.
    pub fn rates(law: &Law) -> Self {
        Blocks::new(Code::new(&law.rates, true), law, law.evaluator(&0.0))
    }

    /// For the observables of a law.
    pub fn observables(law: &Law) -> Self {
        Blocks::new(Code::new(&law.observed, false), law, law.observing(&0.0))
    }

    fn new(code: Code, law: &Law, slow: Evaluator<f64>) -> Self {
        let rounded = |q: &Rational| q.to_f64().unwrap_or(f64::NAN);
        let column = |column: &Column| match column {
            Column::State { .. } => vec![0.0; law.agents()],
            Column::Parameter(list) => law.lists[*list].iter().map(rounded).collect(),
        };
        let columns = code.columns.iter().map(column).collect();
        let spaces = Mutex::new(vec![Space::new(&code)]);
        Blocks { code, columns, spaces, outputs: Vec::new(), arch: pulp::Arch::new(), slow }
    }

    /// Sets the numbers that were drawn for this step: of each list one for each agent.
    pub fn set_drawn(&mut self, law: &Law, drawn: &[Vec<f64>]) {
        self.slow.set_drawn(drawn);
        let first = law.lists.len() - drawn.len().min(law.lists.len());
        for (numbers, column) in self.columns.iter_mut().zip(&self.code.columns) {
            if let Column::Parameter(list) = column
                && let Some(drawn) = list.checked_sub(first).and_then(|k| drawn.get(k))
            {
                numbers.clone_from(drawn);
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

    /// Writes the rates, or the next state, of a state.
    ///
    /// # Errors
    /// [`Fault`] where a number has no value.
    pub fn write_rates(
        &mut self,
        law: &Law,
        (time, state): (f64, &[f64]),
        hearing: &dyn Hearing,
        rates: &mut [f64],
    ) -> Result<(), Fault> {
        self.fill_columns(state);
        let width = law.targets.len();
        let agents = hearing.agents();
        let mut outputs = std::mem::take(&mut self.outputs);
        outputs.resize(agents * width, 0.0);
        let moment = Moment { arch: self.arch, time, columns: &self.columns, hearing };
        let mut space = self.space();
        space.flock(&self.code, &moment);
        let pairs: usize = (0..agents).map(|agent| hearing.heard(agent).map_or(agents - 1, <[usize]>::len)).sum();
        // Agents that are computed together: it depends on the network only.
        let together = (TASK * agents / pairs.max(1)).clamp(1, BLOCK);
        if pairs <= TASK {
            for (task, outputs) in outputs.chunks_mut(together * width.max(1)).enumerate() {
                space.agents(&self.code, &moment, task * together, outputs);
            }
            self.keep(space);
        } else {
            let flock = space.flock_numbers(&self.code, &moment);
            self.keep(space);
            outputs.par_chunks_mut(together * width.max(1)).enumerate().for_each(|(task, outputs)| {
                let mut space = self.space();
                space.take_flock(&self.code, &flock);
                space.agents(&self.code, &moment, task * together, outputs);
                self.keep(space);
            });
        }
        for (agent, row) in outputs.chunks_exact(width.max(1)).enumerate() {
            for (x, (variable, component)) in row.iter().zip(&law.targets) {
                let variable = &law.variables[*variable];
                rates[variable.start + agent * variable.width + component] = *x;
            }
        }
        let missing = |row: &[f64]| row.iter().any(|x| x.is_nan());
        let rows = outputs.chunks_exact(width.max(1)).enumerate();
        let open: Vec<usize> = rows.filter(|(_, row)| missing(row)).map(|(agent, _)| agent).collect();
        self.outputs = outputs;
        if open.is_empty() {
            return Ok(());
        }
        // The slow way decides what is missing and why.
        law.write_rates_of(open.into_iter(), &mut self.slow, (&time, state), hearing, rates)
    }

    /// The numbers of all observables, in their order.
    ///
    /// # Errors
    /// [`Fault`] where a number has no value.
    pub fn observe(&mut self, time: f64, state: &[f64], hearing: &dyn Hearing) -> Result<Vec<f64>, Fault> {
        self.fill_columns(state);
        let moment = Moment { arch: self.arch, time, columns: &self.columns, hearing };
        let mut space = self.space();
        space.flock(&self.code, &moment);
        let numbers = space.flock_numbers(&self.code, &moment);
        self.keep(space);
        let found: Vec<f64> = self.code.outputs.iter().map(|&register| numbers[register]).collect();
        if found.iter().any(|x| x.is_nan()) { self.slow.flock(&time, state, hearing) } else { Ok(found) }
    }

    fn space(&self) -> Space {
        let kept = self.spaces.lock().unwrap_or_else(PoisonError::into_inner).pop();
        kept.unwrap_or_else(|| Space::new(&self.code))
    }

    fn keep(&self, space: Space) {
        self.spaces.lock().unwrap_or_else(PoisonError::into_inner).push(space);
    }
}
