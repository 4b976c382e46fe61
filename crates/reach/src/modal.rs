//! The platoon on a graph without directions, by the modes of its Laplacian: the greatest value of a row of lags behind a leader of bounded acceleration.
//!
//! With followers `i` that weigh `j` by `P_ij`, and `d_i P_ij = d_j P_ji`, the lags `e = D^(-1/2) q` obey `q'' = -a S q - b S q' - u s`, where `a = -f`, `b = -g`,
//! `S` is symmetric and `s = D^(1/2) 1`. So the response of `c e` to an impulse of the leader is `h = -(D^(-1/2) c) phi(S; t) s`, with `phi'' = -lambda (a phi + b phi')`,
//! `phi(0) = 0`, `phi'(0) = 1`. Eigenvectors and eigenvalues come from floats; that they are not exact is a defect of the equation, whose effect on the integral of `|h|` is
//! bounded. `notes/reach.md` has the derivation.

use crate::scalar::Scalar;
use crate::signs::Expansion;
use crate::support::{Found, Support};
use crate::system::Range;
use arithmetic::{ArithmeticError, Cancelled, Field, FloatInterval, Number, Progress, Rational, Real, Ring, rational};
use dense::faer::Mat;
use models::platoon::modes::{Mode, mode_angle, mode_eigenvalue};
use models::platoon::{Communication, CommunicationGraph, Gains};
use rayon::prelude::*;
use std::collections::VecDeque;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

/// Terms of the expansions over a step.
const TERMS: usize = 16;

/// Steps between two evaluations of the elementary functions.
const BLOCK: usize = 64;

/// Most of these.
const MOST_BLOCKS: usize = 200_000;

/// A part of the largest mode that may be left out.
const SMALLEST: f64 = 1e-16;

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum ModalError {
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    #[error("the modes of the platoon could not be enclosed: {0}")]
    Modes(#[from] ArithmeticError),
    #[error("the worst case of the platoon is too large for floats")]
    Unbounded,
    #[error("the slowest mode of the platoon lasts for more steps of the fastest than are followed")]
    TooLong,
}

pub(crate) fn point(x: f64) -> FloatInterval {
    FloatInterval::point(x)
}

pub(crate) fn quotient(a: FloatInterval, b: &FloatInterval) -> Result<FloatInterval, ArithmeticError> {
    a.over(b)
}

fn norm(vector: &[FloatInterval]) -> Result<FloatInterval, ArithmeticError> {
    Ok(point(vector.iter().fold(FloatInterval::ZERO, |sum, x| sum + x.square()).hi()).sqrt()?.top())
}

/// How fast a mode dies out, for `lambda` in an interval above zero.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Decay {
    /// `b^2 lambda <= 3 a`: `|phi| <= 2 / sqrt(a lambda) e^(-rate t)` and `|phi'| <= 3 e^(-rate t)`, `rate = b lambda / 2`.
    Swinging { most: FloatInterval, rate: FloatInterval },
    /// `b^2 lambda >= 2 a`: `|phi| <= t e^(-rate t)` and `|phi'| <= (1 + b lambda t / 2) e^(-rate t)`, `rate = a / b`.
    Damped { half: FloatInterval, rate: FloatInterval },
}

impl Decay {
    pub fn new(a: &FloatInterval, b: &FloatInterval, lambda: &FloatInterval) -> Result<Self, ArithmeticError> {
        let half = *b * lambda * point(0.5);
        if (b.square() * lambda).hi() <= (*a * point(3.0)).lo() {
            let most = quotient(point(2.0), &(*a * lambda).sqrt()?)?;
            return Ok(Decay::Swinging { most, rate: half });
        }
        if (b.square() * lambda).lo() >= (*a * point(2.0)).hi() {
            return Ok(Decay::Damped { half, rate: quotient(*a, b)? });
        }
        Err(ArithmeticError::Domain("modes whose damping is known"))
    }

    /// Bounds of the integrals of `|phi|` and `|phi'|` for ever.
    pub fn integrals(&self) -> Result<(FloatInterval, FloatInterval), ArithmeticError> {
        match self {
            Decay::Swinging { most, rate } => Ok((quotient(*most, rate)?.top(), quotient(point(3.0), rate)?.top())),
            Decay::Damped { half, rate } => {
                let (once, twice) = (quotient(point(1.0), rate)?, quotient(point(1.0), &rate.square())?);
                Ok((twice.top(), (once + *half * twice).top()))
            }
        }
    }

    /// A bound of the integral of `|phi|` from a time on.
    fn tail(&self, t: &FloatInterval) -> Result<FloatInterval, ArithmeticError> {
        let (factor, rate) = match self {
            Decay::Swinging { most, rate } => (quotient(*most, rate)?, rate),
            Decay::Damped { rate, .. } => (quotient(*t, rate)? + quotient(point(1.0), &rate.square())?, rate),
        };
        Ok((factor * (-(*rate * t)).exp()?).top())
    }
}

/// The platoon turned to its modes.
pub(crate) struct Modal {
    a: FloatInterval,
    b: FloatInterval,
    values: Vec<FloatInterval>,
    modes: Modes,
}

/// Where the modes come from.
enum Modes {
    /// Each follower tracks the cars in front and behind: `sin (k phi_j)`, exactly.
    Sines,
    Proposed(Proposed),
}

/// Modes that floats propose.
struct Proposed {
    /// `d_i^(-1/2)`.
    scale: Vec<FloatInterval>,
    /// Eigenvectors in columns, which are what they are: floats.
    vectors: Mat<f64>,
    /// The parts of `s` along the eigenvectors, floats too.
    shares: Vec<f64>,
    /// Bounds the integral over time of the norm of what the modes miss of `phi(S; t) s`.
    missed: FloatInterval,
}

/// Weights `d` with `d_i P_ij = d_j P_ji` between followers, one at the first of each part; none where there are none.
pub(crate) fn balance(graph: &CommunicationGraph) -> Option<Vec<Rational>> {
    let count = graph.followers();
    let weight = |i: usize, j: usize| graph.tracked_by(i).iter().find(|(k, _)| *k == j).map(|(_, weight)| weight);
    let mut found: Vec<Option<Rational>> = vec![None; count + 1];
    for first in 1..=count {
        if found[first].is_some() {
            continue;
        }
        found[first] = Some(Rational::ONE);
        let mut waiting = VecDeque::from([first]);
        while let Some(i) = waiting.pop_front() {
            let own = found[i].clone()?;
            for (j, there) in graph.tracked_by(i).iter().filter(|(j, _)| *j != 0) {
                let other = &own * there / weight(*j, i)?;
                match &found[*j] {
                    Some(known) if *known != other => return None,
                    Some(_) => {}
                    None => {
                        found[*j] = Some(other);
                        waiting.push_back(*j);
                    }
                }
            }
        }
    }
    found.into_iter().skip(1).collect()
}

impl Modal {
    /// Turns a platoon whose followers all hear of the leader, with gains below zero.
    ///
    /// # Errors
    /// [`ModalError`].
    pub fn new(
        graph: &CommunicationGraph,
        weights: &[Rational],
        gains: &Gains<Rational>,
        progress: &dyn Progress,
    ) -> Result<Self, ModalError> {
        if CommunicationGraph::of(Communication::FrontAndBack, graph.followers()).is_ok_and(|line| line == *graph) {
            return Modal::of_line(graph.followers() as u64, gains);
        }
        let count = graph.followers();
        let (a, b) = (-FloatInterval::from_rational(&gains.f), -FloatInterval::from_rational(&gains.g));
        let roots: Vec<FloatInterval> =
            weights.iter().map(|d| FloatInterval::from_rational(d).sqrt()).collect::<Result<_, _>>()?;
        let scale = roots.iter().map(|root| point(1.0).over(root)).collect::<Result<Vec<_>, _>>()?;
        // Rows of S off the diagonal, which is 1.
        let rows: Vec<Vec<(usize, FloatInterval)>> = (1..=count)
            .map(|i| {
                let others = graph.tracked_by(i).iter().filter(|(j, _)| *j != 0);
                others.map(|(j, p)| (j - 1, -(FloatInterval::from_rational(p) * roots[i - 1] * scale[j - 1]))).collect()
            })
            .collect();
        let mut matrix = Mat::<f64>::identity(count, count);
        for (i, row) in rows.iter().enumerate() {
            row.iter().for_each(|(j, x)| matrix[(i, *j)] = x.midpoint());
        }
        let eigen = left_alone(progress, move || dense::symmetric_eigen(matrix.as_ref()))?
            .ok_or(ArithmeticError::Domain("matrices whose eigenvalues floats find"))?;
        let column = |j: usize| (0..count).map(move |i| (i, j));
        let shares: Vec<f64> = (0..count)
            .map(|j| column(j).map(|(i, j)| eigen.vectors[(i, j)] * roots[i].midpoint()).sum::<f64>())
            .collect();
        let least = least_eigenvalue(&eigen.values, &eigen.vectors, &rows)?;
        // What any defect of size 1 can add up to: |phi| is below the sum of both kinds of bounds at the least eigenvalue.
        let swinging = quotient(point(4.0), &((a * least).sqrt()? * b * least))?;
        let gain = (swinging + quotient(b, &a)?.square()).top();
        let defects: Vec<Result<FloatInterval, ArithmeticError>> = (0..count)
            .into_par_iter()
            .map(|j| {
                if progress.is_cancelled() || shares[j] == 0.0 {
                    return Ok(FloatInterval::ZERO);
                }
                let lambda = point(eigen.values[j]);
                let row = |i: usize| {
                    let at = |k: usize| point(eigen.vectors[(k, j)]);
                    rows[i].iter().fold(at(i) - lambda * at(i), |sum, (k, s)| sum + *s * at(*k))
                };
                let rest: Vec<FloatInterval> = (0..count).map(row).collect();
                let (of, of_rate) = Decay::new(&a, &b, &lambda)?.integrals()?;
                Ok(norm(&rest)? * point(shares[j].abs()) * (a * of + b * of_rate))
            })
            .collect();
        progress.checkpoint()?;
        let start: Vec<FloatInterval> = (0..count)
            .map(|i| {
                shares.iter().enumerate().fold(-roots[i], |sum, (j, x)| sum + point(*x) * point(eigen.vectors[(i, j)]))
            })
            .collect();
        let mut missed = norm(&start)?;
        for defect in defects {
            missed = missed + defect?;
        }
        let missed = (missed * gain).top();
        let modes = Modes::Proposed(Proposed { scale, vectors: eigen.vectors, shares, missed });
        Ok(Modal { a, b, values: eigen.values.into_iter().map(point).collect(), modes })
    }

    /// The modes of the line, see [`models::platoon::modes`].
    fn of_line(count: u64, gains: &Gains<Rational>) -> Result<Self, ModalError> {
        let [a, b] = [&gains.f, &gains.g].map(|gain| -FloatInterval::from_rational(gain));
        let values = (1..=count).map(|j| mode_eigenvalue(&a, count, j)).collect::<Result<_, _>>()?;
        Ok(Modal { a, b, values, modes: Modes::Sines })
    }

    /// For each mode, the factor of `phi` in the response of a row of lags, and a bound of the integral of what is missed.
    fn weights(&self, row: &[Rational]) -> Result<(Vec<FloatInterval>, FloatInterval), ArithmeticError> {
        let count = self.values.len();
        let looked: Vec<(usize, FloatInterval)> = row
            .iter()
            .enumerate()
            .filter(|(_, c)| **c != Rational::ZERO)
            .map(|(i, c)| (i, FloatInterval::from_rational(c)))
            .collect();
        match &self.modes {
            // 1 = sum of cot (phi_j / 2) / M sin (k phi_j).
            Modes::Sines => {
                let weight = |j: usize| {
                    let half = mode_angle(&self.a, count as u64, j as u64) * point(0.5);
                    let (sin, cos) = half.sin_cos()?;
                    let share = cos.over(&(sin * point(count as f64)))?;
                    looked.iter().try_fold(FloatInterval::ZERO, |sum, (i, c)| {
                        let turns = ((2 * j - 1) * (i + 1)) % (4 * count);
                        let angle = self.a.pi() * point(turns as f64).over(&point((2 * count) as f64))?;
                        let sin = if turns.is_multiple_of(2 * count) { FloatInterval::ZERO } else { angle.sin()? };
                        Ok(sum - *c * sin * share)
                    })
                };
                Ok(((1..=count).map(weight).collect::<Result<_, _>>()?, FloatInterval::ZERO))
            }
            Modes::Proposed(found) => {
                let scaled: Vec<(usize, FloatInterval)> =
                    looked.iter().map(|(i, c)| (*i, *c * found.scale[*i])).collect();
                let weight = |j: usize| {
                    let along =
                        scaled.iter().fold(FloatInterval::ZERO, |sum, (i, c)| sum + *c * point(found.vectors[(*i, j)]));
                    -(along * point(found.shares[j]))
                };
                let size = norm(&scaled.iter().map(|(_, c)| *c).collect::<Vec<_>>())?;
                Ok(((0..count).map(weight).collect(), (size * found.missed).top()))
            }
        }
    }

    /// Encloses the greatest value of a row of lags at a time, or for ever, from rest and with an acceleration in a range around 0.
    ///
    /// # Errors
    /// [`ModalError`].
    pub fn greatest(
        &self,
        row: &[Rational],
        range: &Range,
        until: Option<&Rational>,
        progress: &dyn Progress,
    ) -> Result<Found, ModalError> {
        let (weights, missed) = self.weights(row)?;
        let term = |(weight, value)| Term::new(&self.a, &self.b, value, weight);
        let modes = weights.into_iter().zip(&self.values).map(term).collect::<Result<_, _>>()?;
        let mut sum = Sum { support: Support::new(range), left_out: FloatInterval::ZERO };
        sum.run(modes, until, progress)?;
        Ok(sum.support.found(&(sum.left_out + missed)))
    }
}

/// What work gives that never asks whether to stop. Where it is not waited for any more, it ends by itself, unheard.
fn left_alone<R: Send + 'static>(
    progress: &dyn Progress,
    work: impl FnOnce() -> R + Send + 'static,
) -> Result<R, ModalError> {
    const TICK: Duration = Duration::from_millis(5);
    let (sender, receiver) = mpsc::channel();
    std::thread::spawn(move || sender.send(work()));
    loop {
        progress.checkpoint()?;
        match receiver.recv_timeout(TICK) {
            Ok(result) => return Ok(result),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => {
                return Err(ArithmeticError::Domain("matrices whose eigenvalues floats find").into());
            }
        }
    }
}

/// A lower bound of the least eigenvalue: off the diagonal nothing is positive, and so it is at least `min (S u)_i / u_i` for every positive `u`.
fn least_eigenvalue(
    values: &[f64],
    vectors: &Mat<f64>,
    rows: &[Vec<(usize, FloatInterval)>],
) -> Result<FloatInterval, ArithmeticError> {
    let count = values.len();
    let mut u = vec![0.0; count];
    for (j, value) in values.iter().enumerate() {
        let along: f64 = (0..count).map(|i| vectors[(i, j)]).sum::<f64>() / (value * value);
        (0..count).for_each(|i| u[i] += along * vectors[(i, j)]);
    }
    let mut least = f64::INFINITY;
    for (i, row) in rows.iter().enumerate() {
        let moved = row.iter().fold(point(u[i]), |sum, (j, s)| sum + *s * point(u[*j]));
        let ratio = if u[i] > 0.0 { moved.over(&point(u[i]))?.lo() } else { 0.0 };
        least = least.min(ratio);
    }
    if least > 0.0 { Ok(point(least)) } else { Err(ArithmeticError::Domain("matrices that are proved to be positive")) }
}

/// `weight phi(lambda; t)`.
struct Term {
    weight: FloatInterval,
    /// `a lambda` and `b lambda`.
    stiffness: FloatInterval,
    damping: FloatInterval,
    mode: Mode<FloatInterval>,
    decay: Decay,
    /// Steps are shorter than the inverse of this.
    speed: f64,
}

impl Term {
    fn new(
        a: &FloatInterval,
        b: &FloatInterval,
        lambda: &FloatInterval,
        weight: FloatInterval,
    ) -> Result<Self, ArithmeticError> {
        let (stiffness, damping) = (*a * lambda, *b * lambda);
        let mode = Mode::new(&Gains { f: -*a, g: -*b }, lambda)?;
        let speed = stiffness.sqrt()?.hi().max(damping.hi());
        Ok(Term { weight, stiffness, damping, mode, decay: Decay::new(a, b, lambda)?, speed })
    }

    /// `phi` and `phi'`.
    fn at(&self, t: &FloatInterval) -> Result<[FloatInterval; 2], ArithmeticError> {
        if t.magnitude() == 0.0 {
            return Ok([FloatInterval::ZERO, point(1.0)]);
        }
        let (c, s) = self.mode.propagator(t)?;
        Ok([s, c - self.damping * s])
    }
}

/// What a term needs while steps have one length.
struct Table {
    /// `(c, s)` after so many steps.
    moved: Vec<[FloatInterval; 2]>,
    /// Coefficients of the expansion by `phi` and by `phi'`, times the weight.
    taylor: Vec<[FloatInterval; 2]>,
    /// Bounds what follows them by the square root of the energy.
    rest: FloatInterval,
}

impl Table {
    fn new(term: &Term, step: &FloatInterval) -> Result<Self, ArithmeticError> {
        let mut moved = Vec::new();
        for k in 0..BLOCK {
            let t = *step * point(k as f64);
            moved.push(if k == 0 { [point(1.0), FloatInterval::ZERO] } else { term.mode.propagator(&t)?.into() });
        }
        let (stiff, damp) = (term.stiffness * step.square(), term.damping * step);
        let mut taylor = vec![[term.weight, FloatInterval::ZERO], [FloatInterval::ZERO, term.weight * step]];
        for n in 0..TERMS - 2 {
            let over = point(1.0).over(&point(((n + 1) * (n + 2)) as f64))?;
            let next = |k: usize| -(stiff * taylor[n][k] + damp * point((n + 1) as f64) * taylor[n + 1][k]) * over;
            taylor.push([next(0), next(1)]);
        }
        // Derivatives in units of the step, by the root of the energy, which does not grow: |phi| <= it / sqrt(stiffness), |phi'| <= it.
        let mut derivatives = [point(1.0).over(&term.stiffness.sqrt()?)?, *step];
        let mut factorial = 1.0;
        for n in 2..=TERMS {
            derivatives = [derivatives[1], damp * derivatives[1] + stiff * derivatives[0]];
            factorial *= n as f64;
        }
        let rest = (derivatives[1].over(&point(factorial))? * point(term.weight.magnitude())).top();
        Ok(Table { moved, taylor, rest })
    }
}

/// The sum over the modes.
struct Sum {
    support: Support,
    /// Bounds the integral of the absolute value of all that was left out.
    left_out: FloatInterval,
}

impl Sum {
    fn run(&mut self, terms: Vec<Term>, until: Option<&Rational>, progress: &dyn Progress) -> Result<(), ModalError> {
        let mut largest = 0.0f64;
        for term in &terms {
            largest = largest.max(term.weight.magnitude() * term.decay.integrals()?.0.hi());
        }
        if !largest.is_finite() {
            return Err(ModalError::Unbounded);
        }
        let mut active: Vec<(Term, Option<Table>)> = terms.into_iter().map(|term| (term, None)).collect();
        let mut time = 0.0;
        let mut step = 0.0;
        for _ in 0..MOST_BLOCKS {
            progress.checkpoint()?;
            let mut kept = Vec::new();
            for (term, table) in active {
                let rest = term.decay.tail(&point(time))?.hi() * term.weight.magnitude();
                if rest <= SMALLEST * largest {
                    self.left_out = (self.left_out + point(rest)).top();
                } else {
                    kept.push((term, table));
                }
            }
            active = kept;
            let speed = active.iter().map(|(term, _)| term.speed).fold(0.0, f64::max);
            if active.is_empty() {
                return Ok(());
            }
            let wanted = 0.5f64.powi((speed * 2.0).log2().ceil().clamp(-1000.0, 1000.0) as i32);
            if wanted != step {
                step = wanted;
                let h = point(step);
                let made: Result<Vec<_>, ArithmeticError> = active
                    .into_par_iter()
                    .map(|(term, _)| Table::new(&term, &h).map(|table| (term, Some(table))))
                    .collect();
                active = made?;
            }
            if self.block(&active, time, step, until)? {
                return Ok(());
            }
            // Blocks join without a gap: times are exact.
            let (span, before) = (step * BLOCK as f64, time);
            time = before + span;
            if time - before != span || time - span != before {
                return Err(ModalError::TooLong);
            }
        }
        Err(ModalError::TooLong)
    }

    /// Adds a block of steps; whether the end was reached.
    fn block(
        &mut self,
        active: &[(Term, Option<Table>)],
        time: f64,
        step: f64,
        until: Option<&Rational>,
    ) -> Result<bool, ArithmeticError> {
        let starts: Vec<[FloatInterval; 2]> =
            active.par_iter().map(|(term, _)| term.at(&point(time))).collect::<Result<_, _>>()?;
        let unit = Rational::from_float(step).unwrap_or_default();
        let begun = Rational::from_float(time).unwrap_or_default();
        for k in 0..BLOCK {
            let from = &begun + &unit * rational(k as i64, 1);
            let end = match until {
                Some(until) if *until <= from => return Ok(true),
                Some(until) => ((until - &from) / &unit).min(Rational::ONE),
                None => Rational::ONE,
            };
            let mut expansion =
                Expansion { coefficients: vec![FloatInterval::ZERO; TERMS], error: FloatInterval::ZERO };
            for ((term, table), start) in active.iter().zip(&starts) {
                let Some(table) = table else { continue };
                let [c, s] = table.moved[k];
                let phi = c * start[0] + s * start[1];
                let rate = (c - term.damping * s) * start[1] - term.stiffness * s * start[0];
                for (sum, [of, of_rate]) in expansion.coefficients.iter_mut().zip(&table.taylor) {
                    *sum = *sum + *of * phi + *of_rate * rate;
                }
                let energy = point((rate.square() + term.stiffness * phi.square()).hi()).sqrt()?;
                expansion.error = (expansion.error + table.rest * energy).top();
            }
            self.support.add(&expansion, &from, &end, (step, &unit));
        }
        Ok(false)
    }
}
