//! The one-sided platoon: the greatest value of a row of lags behind a leader of bounded acceleration, for many cars.
//!
//! The gaps `z_1 = y_1 - y_0`, `z_k = y_k - y_(k-1)` obey `z_k'' + b z_k' + a z_k = a z_(k-1) + b z_(k-1)'`, `a = -f`, `b = -g`, and the first has minus the
//! leader's acceleration on its right side. So their responses `h_1, h_2, ..` to an impulse are followed in floats, step by step, each driven by the
//! one before: they come from polynomials `q_k` on steps that leave a defect in the equations and jumps between steps, both of which are bounded. As all
//! cars are alike, what a unit of defect at car `j` makes of gap `k` is `h_(k-j+1)` itself, so that the integrals `N_k` of `|h_k|` bound the errors:
//!
//! `N_k <= integral of |q_k| + sum over j <= k of (D_j N_(k-j+1) + J_j P_(k-j))`,
//!
//! with the integral `D_j` of the defects and the jumps of the rate of car `j`, the sum `J_j` of the jumps of its gap, and the integrals `P_m` of what a jump of a gap makes
//! of the one `m` places behind.
//!
//! Where each car tracks cars that come earlier in some order, the lags are followed in the same way, each driven by those. With the integral `g` of `|a phi + b phi'|`, `phi` being the response of one car,
//! the errors `E_k` of lags obey `E_k <= (what defects and jumps of car k make of its own lag) + sum over j of P_kj (g E_j + J_j b integral of |phi|)`.
//! `notes/reach.md` has the derivations.

use crate::modal::{Decay, ModalError, point, quotient};
use crate::scalar::Scalar;
use crate::signs::Expansion;
use crate::support::{Found, Support};
use crate::system::Range;
use arithmetic::{FloatInterval, Number, Progress, Rational, rational};
use models::platoon::{CommunicationGraph, Gains, gain_squared_one_sided, strongest_one_sided_square};
use num_traits::Zero;
use std::collections::VecDeque;

/// Terms of the expansions over a step.
const TERMS: usize = 16;

/// More roundings than there are in one coefficient, or in one sum of all of them.
const ROUNDINGS: f64 = 24.0 * f64::EPSILON;

/// Floats that underflow are off by less than this, whatever was made of them in a step.
const UNDERFLOW: f64 = 1e-290;

/// Above all relative errors of sums of positive floats, here of at most 2^26 terms.
const SUMS: f64 = 1.0 + 1e-7;

/// What is small beside the largest motion of a car is left out, with its bound.
const SMALLEST: f64 = 1e-18;

/// Most steps of single cars.
const MOST_STEPS: usize = 1 << 28;

/// Most steps of one car.
const LONGEST: usize = 1 << 22;

/// Steps between two looks at whether to stop.
const BLOCK: usize = 64;

/// One car.
#[derive(Clone)]
struct Car {
    /// Coefficients of its gap on the step that is on, whose length is the unit.
    taylor: [f64; TERMS],
    /// Bounds the integral of the defects and the jumps of the rate.
    defect: f64,
    /// Bounds the jumps of the gap.
    jumps: f64,
    /// Bounds the integral of the absolute value.
    size: f64,
}

const STILL: Car = Car { taylor: [0.0; TERMS], defect: 0.0, jumps: 0.0, size: 0.0 };

/// A row over the gaps: where it is not zero.
type Weights = Vec<(usize, FloatInterval)>;

/// Followers in an order in which those that one tracks come before it.
pub(crate) struct Order {
    /// The place of each follower.
    places: Vec<usize>,
    /// For each place the places of those that are tracked, the leader left out, with weights.
    fronts: Vec<Vec<(usize, Rational)>>,
}

impl Order {
    /// None where followers track each other in a circle.
    pub fn of(graph: &CommunicationGraph) -> Option<Self> {
        let m = graph.followers();
        let tracked = |k: usize| graph.tracked_by(k + 1).iter().filter(|(j, _)| *j != 0);
        let mut missing: Vec<usize> = (0..m).map(|k| tracked(k).count()).collect();
        let mut behind: Vec<Vec<usize>> = vec![Vec::new(); m];
        for k in 0..m {
            tracked(k).for_each(|(j, _)| behind[j - 1].push(k));
        }
        let mut waiting: VecDeque<usize> = (0..m).filter(|&k| missing[k] == 0).collect();
        let (mut places, mut fronts) = (vec![0; m], Vec::new());
        while let Some(k) = waiting.pop_front() {
            places[k] = fronts.len();
            fronts.push(tracked(k).map(|(j, weight)| (places[j - 1], weight.clone())).collect());
            for &later in &behind[k] {
                missing[later] -= 1;
                if missing[later] == 0 {
                    waiting.push_back(later);
                }
            }
        }
        (fronts.len() == m).then_some(Order { places, fronts })
    }

    /// A row of lags by places.
    fn row(&self, row: &[Rational]) -> Weights {
        let weight = |(k, c): (usize, &Rational)| (self.places[k], FloatInterval::from_rational(c));
        row.iter().enumerate().filter(|(_, c)| !c.is_zero()).map(weight).collect()
    }
}

/// The responses of the cars, step by step.
struct Cascade {
    /// Which cars before it drive each car, with weights.
    fronts: Vec<Vec<(usize, f64)>>,
    /// `a step^2` and `b step`.
    stiffness: f64,
    damping: f64,
    step: f64,
    /// The root of `a`, which turns a gap into a rate.
    root: f64,
    /// How far motions come, roughly, by car.
    scales: Vec<f64>,
    cars: Vec<Car>,
    /// Cars that still move, and one more than the last that does.
    first: usize,
    reached: usize,
}

/// Encloses the greatest values of rows of lags at a time, or for ever, from rest and with an acceleration in a range around 0; the gains are below 0. Each car tracks the
/// one in front, or those that an order says.
///
/// # Errors
/// [`ModalError`].
pub(crate) fn greatest(
    gains: &Gains<Rational>,
    order: Option<&Order>,
    rows: &[Vec<Rational>],
    range: &Range,
    until: Option<&Rational>,
    progress: &dyn Progress,
) -> Result<Vec<Found>, ModalError> {
    let rows: Vec<Weights> =
        rows.iter().map(|row| order.map_or_else(|| by_gaps(row), |order| order.row(row))).collect();
    let count = rows.iter().flatten().map(|(j, _)| j + 1).max().unwrap_or(1);
    let mut cascade = match order {
        None => Cascade::of_gaps(gains, count)?,
        Some(order) => {
            let float = |(j, weight): &(usize, Rational)| (*j, FloatInterval::from_rational(weight).midpoint());
            let fronts = order.fronts[..count].iter().map(|front| front.iter().map(float).collect()).collect();
            Cascade::new(gains, fronts, count)?
        }
    };
    let mut supports: Vec<Support> = rows.iter().map(|_| Support::new(range)).collect();
    cascade.run(until, progress, &mut |cascade, from, end, unit| {
        for (row, support) in rows.iter().zip(supports.iter_mut()) {
            if let Some(h) = cascade.response(row) {
                support.add(&h, from, end, (cascade.step, unit));
            }
        }
    })?;
    let errors = match order {
        None => cascade.errors_of_gaps(gains)?,
        Some(_) => cascade.errors_of_lags(gains, progress)?,
    };
    let found = |(row, support): (&Weights, Support)| {
        let missed = row.iter().fold(FloatInterval::ZERO, |sum, (j, c)| sum + point(c.magnitude()) * point(errors[*j]));
        support.found(&missed)
    };
    Ok(rows.iter().zip(supports).map(found).collect())
}

/// A bound of the integral of `|a phi + b phi'|`, by which a lag drives the one behind.
fn drive(gains: &Gains<Rational>, progress: &dyn Progress) -> Result<FloatInterval, ModalError> {
    let [a, b] = [&gains.f, &gains.g].map(|gain| -FloatInterval::from_rational(gain));
    let mut one = Cascade::of_gaps(gains, 1)?;
    let mut support = Support::new(&Range { lo: rational(-1, 1), hi: rational(1, 1) });
    one.run(None, progress, &mut |cascade, from, end, unit| {
        let (taylor, per_step) = (cascade.cars[0].taylor, b * point(1.0 / cascade.step));
        let rate = |n: usize| taylor.get(n + 1).map_or(FloatInterval::ZERO, |c| point(*c) * point((n + 1) as f64));
        let coefficients = (0..TERMS).map(|n| a * point(taylor[n]) + per_step * rate(n)).collect();
        support.add(&Expansion { coefficients, error: FloatInterval::ZERO }, from, end, (cascade.step, unit));
    })?;
    let (of, of_rate) = Decay::new(&a, &b, &point(1.0))?.integrals()?;
    let [defect, jumps] = [one.cars[0].defect, one.cars[0].jumps].map(|x| point(point(x * SUMS).hi()));
    // A jump of phi makes phi' + b phi of it, whose derivative is -a phi.
    let missed = defect * (a * of + b * of_rate) + jumps * a * (of_rate + b * of + b * of);
    Ok(support.found(&missed.top()).value.top())
}

/// A row of lags as one of gaps, whose sums the lags are.
fn by_gaps(row: &[Rational]) -> Weights {
    let mut sum = Rational::ZERO;
    let mut weights: Weights = Vec::new();
    for (j, c) in row.iter().enumerate().rev() {
        sum += c;
        if !sum.is_zero() {
            weights.push((j, FloatInterval::from_rational(&sum)));
        }
    }
    weights.reverse();
    weights
}

impl Cascade {
    /// The gaps where each car tracks the one in front: the first is driven by the leader.
    fn of_gaps(gains: &Gains<Rational>, count: usize) -> Result<Self, ModalError> {
        let fronts = (0..count).map(|k| k.checked_sub(1).map(|front| (front, 1.0)).into_iter().collect()).collect();
        Cascade::new(gains, fronts, 1)
    }

    /// Cars of which so many feel the leader's acceleration at once.
    fn new(gains: &Gains<Rational>, fronts: Vec<Vec<(usize, f64)>>, reached: usize) -> Result<Self, ModalError> {
        let floats = gains.map(FloatInterval::from_rational);
        let (a, b) = (-floats.f.midpoint(), -floats.g.midpoint());
        let speed = a.sqrt().max(b);
        let step = 0.5f64.powi((speed * 2.0).log2().ceil().clamp(-300.0, 300.0) as i32);
        let strongest = strongest_one_sided_square(&floats)?;
        let gain = gain_squared_one_sided(&floats, &strongest)?.sqrt()?.midpoint().max(1.0);
        let mut scales: Vec<f64> = Vec::new();
        for front in &fronts {
            scales.push((gain * front.iter().map(|(j, weight)| weight * scales[*j]).sum::<f64>()).max(1.0));
        }
        let (stiffness, damping) = (a * step * step, b * step);
        // Nothing leaves the range in which floats have all their digits.
        if !scales.iter().all(|scale| *scale < 1e290)
            || stiffness.min(damping) < 1e-200
            || !(1e-200..1e200).contains(&speed)
        {
            return Err(ModalError::Unbounded);
        }
        let mut cars = vec![STILL; fronts.len()];
        cars[..reached].iter_mut().for_each(|car| car.taylor[1] = -step);
        Ok(Cascade { fronts, stiffness, damping, step, root: a.sqrt(), scales, cars, first: 0, reached })
    }

    /// Steps up to a time, or until all cars rest; of each the length in parts and units of time, and where it begins.
    fn run(
        &mut self,
        until: Option<&Rational>,
        progress: &dyn Progress,
        each: &mut dyn FnMut(&Self, &Rational, &Rational, &Rational),
    ) -> Result<(), ModalError> {
        let unit = Rational::from_float(self.step).unwrap_or_default();
        let mut work = 0;
        for k in 0..LONGEST {
            if k % BLOCK == 0 {
                progress.checkpoint()?;
            }
            let from = &unit * rational(k as i64, 1);
            let end = match until {
                Some(until) if *until <= from => return Ok(()),
                Some(until) => ((until - &from) / &unit).min(Rational::ONE),
                None => Rational::ONE,
            };
            self.expand();
            each(self, &from, &end, &unit);
            work += self.reached - self.first;
            if work > MOST_STEPS {
                return Err(ModalError::TooLong);
            }
            self.advance();
            if self.first == self.reached {
                return Ok(());
            }
        }
        Err(ModalError::TooLong)
    }

    /// The coefficients of all cars on this step from the first two, and what they leave of the equations.
    fn expand(&mut self) {
        let (stiff, damp) = (self.stiffness, self.damping);
        for j in self.first..self.cars.len() {
            // What drives it, with the sizes of what was added; cars that rest are zero.
            let (mut front, mut sizes) = ([0.0; TERMS], [0.0; TERMS]);
            for (i, weight) in &self.fronts[j] {
                for (n, c) in self.cars[*i].taylor.iter().enumerate() {
                    front[n] += weight * c;
                    sizes[n] += (weight * c).abs();
                }
            }
            let of = |list: &[f64; TERMS], n: usize| {
                (stiff * list[n], damp * (n + 1) as f64 * list.get(n + 1).unwrap_or(&0.0))
            };
            if j >= self.reached {
                let loudest = self.fronts[j].iter().map(|(i, _)| self.scales[*i]).fold(0.0, f64::max);
                if sizes.iter().all(|c| *c <= SMALLEST * loudest) {
                    // It rests a while longer: all that pushes it is a defect.
                    let left = (0..TERMS).map(|n| (of(&sizes, n).0 + of(&sizes, n).1) / (n + 1) as f64).sum::<f64>();
                    self.cars[j].defect += (left + UNDERFLOW) / self.step;
                    return;
                }
                self.reached = j + 1;
            }
            let roundings = ROUNDINGS + f64::EPSILON * self.fronts[j].len().saturating_sub(1) as f64;
            let car = &mut self.cars[j];
            let (mut left, mut size) = (0.0, 0.0);
            for n in 0..TERMS {
                let (own, push, most) = (of(&car.taylor, n), of(&front, n), of(&sizes, n));
                let all = own.0.abs() + own.1.abs() + most.0 + most.1;
                if n + 2 < TERMS {
                    car.taylor[n + 2] = (push.0 + push.1 - own.0 - own.1) / ((n + 1) * (n + 2)) as f64;
                    left += roundings * all / (n + 1) as f64;
                } else {
                    left += all / (n + 1) as f64;
                }
                size += car.taylor[n].abs() / (n + 1) as f64;
            }
            car.defect += (left + UNDERFLOW) / self.step;
            car.size += size * self.step;
        }
    }

    /// A row over the step; none where all of it rests.
    fn response(&self, row: &Weights) -> Option<Expansion<FloatInterval>> {
        let moving = row.iter().filter(|(j, _)| (self.first..self.reached).contains(j));
        let mut coefficients: Option<Vec<FloatInterval>> = None;
        for (j, weight) in moving {
            let sums = coefficients.get_or_insert_with(|| vec![FloatInterval::ZERO; TERMS]);
            for (sum, c) in sums.iter_mut().zip(&self.cars[*j].taylor) {
                *sum = *sum + *weight * point(*c);
            }
        }
        coefficients.map(|coefficients| Expansion { coefficients, error: FloatInterval::ZERO })
    }

    /// Goes to the end of the step: cars start the next one near where they are, and those at the front that do not move any more stop.
    fn advance(&mut self) {
        for j in self.first..self.reached {
            let car = &mut self.cars[j];
            let (mut next, mut sizes) = ([0.0, 0.0], [0.0, 0.0]);
            for (n, c) in car.taylor.iter().enumerate().rev() {
                next = [next[0] + c, next[1] + n as f64 * c];
                sizes = [sizes[0] + c.abs(), sizes[1] + n as f64 * c.abs()];
            }
            let speed = next[1].abs() / self.step + self.root * next[0].abs();
            let stops = j == self.first && speed <= SMALLEST * self.scales[j];
            if stops {
                self.first += 1;
                (sizes, next) = (sizes.map(|size| size * ROUNDINGS), [next[0].abs(), next[1].abs()]);
                sizes = [sizes[0] + next[0], sizes[1] + next[1]];
                next = [0.0, 0.0];
            } else {
                sizes = sizes.map(|size| size * ROUNDINGS);
            }
            car.jumps += sizes[0] + UNDERFLOW;
            car.defect += (sizes[1] + UNDERFLOW) / self.step;
            car.taylor = [0.0; TERMS];
            (car.taylor[0], car.taylor[1]) = (next[0], next[1]);
        }
    }

    /// For each car, a bound of the integral of the absolute value of what its polynomials miss of its response.
    fn errors_of_gaps(&self, gains: &Gains<Rational>) -> Result<Vec<f64>, ModalError> {
        let [a, b] = [&gains.f, &gains.g].map(|gain| -FloatInterval::from_rational(gain));
        let (of, of_rate) = Decay::new(&a, &b, &point(1.0))?.integrals()?;
        // What a jump of a gap makes of that gap, and, as a multiple of N_m, of that m places behind.
        let (own, behind) = ((of_rate + b * of).hi(), (a * of_rate).hi());
        let up = |x: f64| point(x * SUMS).hi();
        let cars: Vec<[f64; 3]> = self.cars.iter().map(|car| [car.defect, car.jumps, car.size].map(up)).collect();
        let first = point(1.0) - point(cars[0][0]);
        let (mut errors, mut norms): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        for (k, car) in cars.iter().enumerate() {
            // All that does not ask for N_k itself.
            let mut known = car[1] * own;
            for j in 0..=k {
                if j > 0 {
                    known += cars[j][0] * norms[k - j];
                }
                if j < k {
                    known += cars[j][1] * behind * norms[k - j - 1];
                }
            }
            let known = point(up(known));
            let norm = if first.lo() > 0.0 { quotient(known + point(car[2]), &first)?.hi() } else { f64::INFINITY };
            let error = (known + point(cars[0][0]) * point(norm)).hi();
            if !error.is_finite() {
                return Err(ModalError::Unbounded);
            }
            norms.push(norm);
            errors.push(error);
        }
        Ok(errors)
    }

    /// The same where cars track several.
    fn errors_of_lags(&self, gains: &Gains<Rational>, progress: &dyn Progress) -> Result<Vec<f64>, ModalError> {
        let [a, b] = [&gains.f, &gains.g].map(|gain| -FloatInterval::from_rational(gain));
        let (of, of_rate) = Decay::new(&a, &b, &point(1.0))?.integrals()?;
        let drive = drive(gains, progress)?;
        let up = |x: f64| point(point(x * SUMS).hi());
        let mut errors: Vec<f64> = Vec::new();
        for (car, front) in self.cars.iter().zip(&self.fronts) {
            let mut error = up(car.defect) * of + up(car.jumps) * (of_rate + b * of);
            for (j, weight) in front {
                error =
                    error + point(weight.next_up()) * (drive * point(errors[*j]) + b * of * up(self.cars[*j].jumps));
            }
            if !error.hi().is_finite() {
                return Err(ModalError::Unbounded);
            }
            errors.push(error.hi());
        }
        Ok(errors)
    }
}
