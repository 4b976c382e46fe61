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
//! of the one `m` places behind. `notes/reach.md` has the derivation.

use crate::modal::{Decay, ModalError, point, quotient};
use crate::signs::Expansion;
use crate::support::{Found, Support};
use crate::system::Range;
use arithmetic::{FloatInterval, Number, Progress, Rational, rational};
use models::platoon::{Gains, gain_squared_one_sided, strongest_one_sided_square};
use num_traits::Zero;

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

/// The responses of the cars, step by step.
struct Cascade {
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

/// Encloses the greatest values of rows of lags at a time, or for ever, from rest and with an acceleration in a range around 0; the gains are below 0.
///
/// # Errors
/// [`ModalError`].
pub(crate) fn greatest(
    gains: &Gains<Rational>,
    rows: &[Vec<Rational>],
    range: &Range,
    until: Option<&Rational>,
    progress: &dyn Progress,
) -> Result<Vec<Found>, ModalError> {
    let rows: Vec<Weights> = rows.iter().map(|row| by_gaps(row)).collect();
    let count = rows.iter().flatten().map(|(j, _)| j + 1).max().unwrap_or(1);
    let mut cascade = Cascade::new(gains, count)?;
    let mut supports: Vec<Support> = rows.iter().map(|_| Support::new(range)).collect();
    cascade.run(&rows, &mut supports, until, progress)?;
    let errors = cascade.errors(gains)?;
    let found = |(row, support): (&Weights, Support)| {
        let missed = row.iter().fold(FloatInterval::ZERO, |sum, (j, c)| sum + point(c.magnitude()) * point(errors[*j]));
        support.found(&missed)
    };
    Ok(rows.iter().zip(supports).map(found).collect())
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
    fn new(gains: &Gains<Rational>, count: usize) -> Result<Self, ModalError> {
        let floats = gains.map(FloatInterval::from_rational);
        let (a, b) = (-floats.f.midpoint(), -floats.g.midpoint());
        let speed = a.sqrt().max(b);
        let step = 0.5f64.powi((speed * 2.0).log2().ceil().clamp(-300.0, 300.0) as i32);
        let strongest = strongest_one_sided_square(&floats)?;
        let gain = gain_squared_one_sided(&floats, &strongest)?.sqrt()?.midpoint().max(1.0);
        let scales: Vec<f64> = (0..count).map(|k| gain.powi(k as i32)).collect();
        let (stiffness, damping) = (a * step * step, b * step);
        // Nothing leaves the range in which floats have all their digits.
        if gain.powi(count as i32) > 1e290 || stiffness.min(damping) < 1e-200 || !(1e-200..1e200).contains(&speed) {
            return Err(ModalError::Unbounded);
        }
        let mut cars = vec![STILL; count];
        cars[0].taylor[1] = -step;
        Ok(Cascade { stiffness, damping, step, root: a.sqrt(), scales, cars, first: 0, reached: 1 })
    }

    fn run(
        &mut self,
        rows: &[Weights],
        supports: &mut [Support],
        until: Option<&Rational>,
        progress: &dyn Progress,
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
            for (row, support) in rows.iter().zip(supports.iter_mut()) {
                if let Some(h) = self.response(row) {
                    support.add(&h, &from, &end, (self.step, &unit));
                }
            }
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
            let front = if j > self.first { self.cars[j - 1].taylor } else { [0.0; TERMS] };
            let push = |n: usize| (stiff * front[n], damp * (n + 1) as f64 * front.get(n + 1).unwrap_or(&0.0));
            if j >= self.reached {
                if front.iter().all(|c| c.abs() <= SMALLEST * self.scales[j - 1]) {
                    // It rests a while longer: all that pushes it is a defect.
                    let left = (0..TERMS).map(|n| (push(n).0.abs() + push(n).1.abs()) / (n + 1) as f64).sum::<f64>();
                    self.cars[j].defect += left / self.step;
                    return;
                }
                self.reached = j + 1;
            }
            let car = &mut self.cars[j];
            let (mut left, mut size) = (0.0, 0.0);
            for n in 0..TERMS {
                let own = (stiff * car.taylor[n], damp * (n + 1) as f64 * car.taylor.get(n + 1).unwrap_or(&0.0));
                let push = push(n);
                let all = own.0.abs() + own.1.abs() + push.0.abs() + push.1.abs();
                if n + 2 < TERMS {
                    car.taylor[n + 2] = (push.0 + push.1 - own.0 - own.1) / ((n + 1) * (n + 2)) as f64;
                    left += ROUNDINGS * all / (n + 1) as f64;
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
    fn errors(&self, gains: &Gains<Rational>) -> Result<Vec<f64>, ModalError> {
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
}
