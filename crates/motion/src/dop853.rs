//! Adaptive steps by the method of Dormand and Prince of order eight.

use super::VectorField;
use super::dop853_table::{ALL_STAGES, DENSE, ERROR_FIVE, ERROR_THREE, STAGES, TIMES, WEIGHTS};

/// The error of a step that is accepted, component by component: `absolute + relative |y|`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Relative part, at least `1e-14`.
    pub relative: f64,
    /// Absolute part.
    pub absolute: f64,
}

/// Why an integration stopped.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum IntegrationError {
    /// The state or its rate is not finite, or the step shrank to nothing, as before a singularity.
    #[error("the solution cannot be followed beyond t = {0}")]
    Stuck(f64),
    /// More steps than allowed.
    #[error("{steps} steps were not enough: t = {time} was reached")]
    TooManySteps {
        /// Steps taken.
        steps: usize,
        /// Where it was.
        time: f64,
    },
}

/// Steps that one call may take.
const MOST_STEPS: usize = 50_000_000;

/// A solution on its way. After a step the states between its two ends are known to order seven, and to the full order
/// by [`Self::within`].
#[derive(Debug, Clone)]
pub struct Integrator {
    tolerance: Tolerance,
    time: f64,
    state: Vec<f64>,
    /// The length that is tried next; none before the first step.
    trial: Option<f64>,
    before: (f64, Vec<f64>),
    slopes: Vec<Vec<f64>>,
    stage: Vec<f64>,
    /// Coefficients of the dense output, where they are known.
    dense: Option<Vec<[f64; 7]>>,
    steps: usize,
    rejected: usize,
}

impl Integrator {
    /// Starts at a state.
    pub fn new(time: f64, state: &[f64], tolerance: Tolerance) -> Self {
        let relative = tolerance.relative.max(1e-14);
        Integrator {
            tolerance: Tolerance { relative, ..tolerance },
            time,
            state: state.to_vec(),
            trial: None,
            before: (time, state.to_vec()),
            slopes: vec![vec![0.0; state.len()]; ALL_STAGES],
            stage: vec![0.0; state.len()],
            dense: None,
            steps: 0,
            rejected: 0,
        }
    }

    /// Where it is.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The state there.
    pub fn state(&self) -> &[f64] {
        &self.state
    }

    /// Where the last step began.
    pub fn previous_time(&self) -> f64 {
        self.before.0
    }

    /// Steps taken and steps that were tried in vain.
    pub fn counts(&self) -> (usize, usize) {
        (self.steps, self.rejected)
    }

    /// One step forward, not beyond `until`, which must lie ahead.
    ///
    /// # Errors
    /// [`IntegrationError::Stuck`].
    pub fn step(&mut self, field: &mut impl VectorField, until: f64) -> Result<(), IntegrationError> {
        self.before.0 = self.time;
        self.before.1.clone_from(&self.state);
        self.dense = None;
        field.rate(self.time, &self.state, &mut self.slopes[0]);
        let mut length = match self.trial {
            Some(length) => length,
            None => self.first_length(field),
        };
        let mut growth: f64 = 10.0;
        loop {
            let left = until - self.time;
            // A remainder of a hair's breadth is taken along.
            let h = if length * (1.0 + 1e-10) >= left { left } else { length };
            if h.is_nan() || self.time + h <= self.time {
                return Err(IntegrationError::Stuck(self.time));
            }
            self.stages(field, h, STAGES);
            let end = self.before.0 + h;
            self.partial(STAGES, h);
            field.rate(end, &self.stage, &mut self.slopes[STAGES]);
            let error = self.error(&self.stage, h);
            if error <= 1.0 {
                let factor = if error == 0.0 { growth } else { (0.9 * error.powf(-0.125)).clamp(0.2, growth) };
                // A step that was cut short to end at `until` says little about the next one.
                self.trial = Some(if h < length { length.max(h * factor) } else { h * factor });
                self.time = if h == left { until } else { end };
                std::mem::swap(&mut self.state, &mut self.stage);
                self.steps += 1;
                return Ok(());
            }
            self.rejected += 1;
            growth = 1.0;
            length = h * if error.is_finite() { (0.9 * error.powf(-0.125)).max(0.2) } else { 0.1 };
        }
    }

    /// The state at a time within the last step, by the dense output of order seven.
    pub fn interpolate(&mut self, field: &mut impl VectorField, time: f64) -> Vec<f64> {
        self.prepare(field);
        (0..self.state.len()).map(|k| self.component(k, time)).collect()
    }

    /// One component of [`Self::interpolate`], which must have been asked since the last step; NaN for one that is not there.
    pub fn component(&self, k: usize, time: f64) -> f64 {
        let h = self.time - self.before.0;
        let (Some(state), Some(before)) = (self.state.get(k), self.before.1.get(k)) else { return f64::NAN };
        let Some(dense) = self.dense.as_ref().filter(|_| h != 0.0) else { return *state };
        let x = (time - self.before.0) / h;
        // Alternately times x and 1 - x, from the last coefficient.
        let add = |sum: f64, (place, f): (usize, &f64)| (sum + f) * if place % 2 == 0 { x } else { 1.0 - x };
        before + dense[k].iter().rev().enumerate().fold(0.0, add)
    }

    /// The state at a time within the last step, by a step of full order from its beginning. The step's slopes are lost: the
    /// dense output must not be asked afterwards unless it was asked before.
    pub fn within(&mut self, field: &mut impl VectorField, time: f64) -> Vec<f64> {
        let h = time - self.before.0;
        if h == 0.0 {
            return self.before.1.clone();
        }
        self.stages(field, h, STAGES);
        self.partial(STAGES, h);
        self.stage.clone()
    }

    /// The slopes before stage `last`, from the first one on.
    fn stages(&mut self, field: &mut impl VectorField, h: f64, last: usize) {
        for i in 1..last {
            self.slope(field, h, i);
        }
    }

    fn slope(&mut self, field: &mut impl VectorField, h: f64, i: usize) {
        self.partial(i, h);
        field.rate(self.before.0 + TIMES[i] * h, &self.stage, &mut self.slopes[i]);
    }

    /// Makes `self.stage` the state that the weights of stage `i` give.
    fn partial(&mut self, i: usize, h: f64) {
        self.stage.clone_from(&self.before.1);
        for (weight, slope) in WEIGHTS[i].iter().zip(&self.slopes).filter(|(weight, _)| **weight != 0.0) {
            let factor = weight * h;
            self.stage.iter_mut().zip(slope).for_each(|(y, k)| *y += factor * k);
        }
    }

    /// The error of a step against the tolerance, by the two estimates.
    fn error(&self, next: &[f64], h: f64) -> f64 {
        let (mut five, mut three) = (0.0, 0.0);
        for (i, (&y, &z)) in self.before.1.iter().zip(next).enumerate() {
            let scale = self.tolerance.absolute + self.tolerance.relative * y.abs().max(z.abs());
            let sum = |weights: &[f64; 13]| -> f64 { weights.iter().zip(&self.slopes).map(|(w, k)| w * k[i]).sum() };
            let (a, b) = (sum(&ERROR_FIVE) / scale, sum(&ERROR_THREE) / scale);
            (five, three) = (five + a * a, three + b * b);
        }
        if five == 0.0 && three == 0.0 {
            return 0.0;
        }
        let error = h.abs() * five / ((five + 0.01 * three) * next.len() as f64).sqrt();
        if error.is_nan() { f64::INFINITY } else { error }
    }

    /// A first guess of the length of a step (Hairer, Nørsett and Wanner, II.4).
    fn first_length(&mut self, field: &mut impl VectorField) -> f64 {
        let scales: Vec<f64> =
            self.state.iter().map(|y| self.tolerance.absolute + self.tolerance.relative * y.abs()).collect();
        let norm = |x: &mut dyn Iterator<Item = f64>| -> f64 {
            let squares: f64 = x.zip(&scales).map(|(x, scale)| (x / scale) * (x / scale)).sum();
            (squares / scales.len().max(1) as f64).sqrt()
        };
        let size = norm(&mut self.state.iter().copied());
        let slope = norm(&mut self.slopes[0].iter().copied());
        let short = if size < 1e-5 || slope < 1e-5 { 1e-6 } else { 0.01 * size / slope };
        let ahead: Vec<f64> = self.state.iter().zip(&self.slopes[0]).map(|(y, k)| y + short * k).collect();
        field.rate(self.time + short, &ahead, &mut self.slopes[1]);
        let bend = norm(&mut self.slopes[1].iter().zip(&self.slopes[0]).map(|(a, b)| a - b)) / short;
        let steepest = slope.max(bend);
        let long = if steepest <= 1e-15 { (short * 1e-3).max(1e-6) } else { (0.01 / steepest).powf(0.125) };
        let length = long.min(100.0 * short);
        if length.is_finite() { length } else { short }
    }

    /// The coefficients of the dense output: three more slopes.
    fn prepare(&mut self, field: &mut impl VectorField) {
        let h = self.time - self.before.0;
        if h == 0.0 || self.dense.is_some() {
            return;
        }
        for i in STAGES + 1..ALL_STAGES {
            self.slope(field, h, i);
        }
        let coefficients = (0..self.state.len()).map(|i| {
            let difference = self.state[i] - self.before.1[i];
            let (first, last) = (h * self.slopes[0][i], h * self.slopes[STAGES][i]);
            let upper = |row: usize| h * DENSE[row].iter().zip(&self.slopes).map(|(w, k)| w * k[i]).sum::<f64>();
            [difference, first - difference, 2.0 * difference - (last + first), upper(0), upper(1), upper(2), upper(3)]
        });
        self.dense = Some(coefficients.collect());
    }
}

/// The states at some times, which must not decrease, from `state` at `time`; steps end where the tolerance lets them, and the
/// states between come from the dense output.
///
/// # Errors
/// [`IntegrationError`].
pub fn integrate(
    field: &mut impl VectorField,
    time: f64,
    state: &[f64],
    times: &[f64],
    tolerance: Tolerance,
) -> Result<Vec<Vec<f64>>, IntegrationError> {
    let mut solution = Integrator::new(time, state, tolerance);
    let end = times.last().copied().unwrap_or(time);
    let mut states = Vec::with_capacity(times.len());
    for &asked in times {
        while solution.time() < asked {
            solution.step(field, end)?;
            if solution.steps >= MOST_STEPS {
                return Err(IntegrationError::TooManySteps { steps: MOST_STEPS, time: solution.time() });
            }
        }
        let there = solution.time() == asked;
        states.push(if there { solution.state().to_vec() } else { solution.interpolate(field, asked) });
    }
    Ok(states)
}
