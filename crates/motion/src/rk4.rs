//! The classical method of order four with steps of fixed length.

use super::{CHUNK, VectorField};
use rayon::prelude::*;

/// Lengths of states from which the work is shared out among processors: handing it over takes longer than adding fewer.
const MANY: usize = 1 << 16;

/// Runge's and Kutta's classical method, with its working space.
#[derive(Debug, Clone)]
pub struct Rk4 {
    slope: Vec<f64>,
    stage: Vec<f64>,
    /// The weighted sum of the slopes so far.
    sum: Vec<f64>,
}

impl Rk4 {
    /// For states of this length.
    pub fn new(dimension: usize) -> Self {
        Rk4 { slope: vec![0.0; dimension], stage: vec![0.0; dimension], sum: vec![0.0; dimension] }
    }

    /// Moves the state from `time` to `time + dt`. The state must have the length given to [`Self::new`].
    pub fn step(&mut self, field: &mut impl VectorField, time: f64, dt: f64, state: &mut [f64]) {
        field.rate(time, state, &mut self.slope);
        self.next_stage(state, dt / 6.0, dt / 2.0, true);
        field.rate(time + dt / 2.0, &self.stage, &mut self.slope);
        self.next_stage(state, dt / 3.0, dt / 2.0, false);
        field.rate(time + dt / 2.0, &self.stage, &mut self.slope);
        self.next_stage(state, dt / 3.0, dt, false);
        field.rate(time + dt, &self.stage, &mut self.slope);
        let last = dt / 6.0;
        let add = |state: &mut [f64], sum: &[f64], slope: &[f64]| {
            for ((y, sum), slope) in state.iter_mut().zip(sum).zip(slope) {
                *y += sum + last * slope;
            }
        };
        let parts = self.sum.par_chunks(CHUNK).zip(self.slope.par_chunks(CHUNK));
        if state.len() < MANY {
            add(state, &self.sum, &self.slope);
        } else {
            state.par_chunks_mut(CHUNK).zip(parts).for_each(|(state, (sum, slope))| add(state, sum, slope));
        }
    }

    /// Adds `weight slope` to the sum, and sets the stage to `state + ahead slope`.
    fn next_stage(&mut self, state: &[f64], weight: f64, ahead: f64, first: bool) {
        let update = |stage: &mut [f64], sum: &mut [f64], state: &[f64], slope: &[f64]| {
            for (((stage, sum), y), slope) in stage.iter_mut().zip(sum).zip(state).zip(slope) {
                *sum = if first { 0.0 } else { *sum } + weight * slope;
                *stage = y + ahead * slope;
            }
        };
        if state.len() < MANY {
            update(&mut self.stage, &mut self.sum, state, &self.slope);
        } else {
            let to = self.stage.par_chunks_mut(CHUNK).zip(self.sum.par_chunks_mut(CHUNK));
            let from = state.par_chunks(CHUNK).zip(self.slope.par_chunks(CHUNK));
            to.zip(from).for_each(|((stage, sum), (state, slope))| update(stage, sum, state, slope));
        }
    }
}
