//! Exact motion of the two-sided platoon (2) in time, as a finite sum over its modes: any time costs the same, there are no steps.
//!
//! With `phi_k`, `lambda_k` as in [`super::modes`], the mode `z_k = sum_j w_j sin(j phi_k) y_j` (weights 1, and 1/2 for the last
//! car) obeys `z'' = lambda (f z + g z') - (sin phi_k/2)(f y_0 + g y_0')`, and `y_j = (2/M) sum_k sin(j phi_k) z_k`. For the
//! deviation `e_j = y_j - y_0` from the leader the last term is `-(cot(phi_k/2)/2) y_0''`.
//!
//! The last car costs `M` elementary functions, all cars `M²` products. Over intervals everything is enclosed; over floats the tests
//! compare it with enclosures and with a naive integration.

use super::law::Gains;
use super::modes::{Mode, mode_eigenvalue};
use super::response::gamma_minus_one;
use arithmetic::{ArithmeticError, Complex, Field, Real, Sign};

/// One mode with its eigenvalue and its share in the last car.
#[derive(Debug, Clone)]
struct Part<T> {
    mode: Mode<T>,
    lambda: T,
    /// `(2/M) sin(M phi_k)`.
    share: T,
}

/// Positions and velocities of the followers 1 to M.
#[derive(Debug, Clone, PartialEq)]
pub struct Followers<T> {
    /// `y_1..y_M`, deviations from the desired positions.
    pub positions: Vec<T>,
    /// `u_1..u_M`.
    pub velocities: Vec<T>,
}

/// The modes of a platoon.
#[derive(Debug, Clone)]
pub struct Modes<T> {
    gains: Gains<T>,
    parts: Vec<Part<T>>,
    /// `sin(n pi/(2M))` for n = 0 to M.
    sines: Vec<T>,
}

impl<T: Real> Modes<T> {
    /// The modes of `followers >= 1` cars.
    ///
    /// # Errors
    /// [`ArithmeticError`] where too little is known of the roots of a mode.
    pub fn new(gains: &Gains<T>, followers: u64) -> Result<Self, ArithmeticError> {
        let like = &gains.f;
        let followers = followers.max(1);
        let part = |k: u64| {
            let lambda = mode_eigenvalue(like, followers, k)?;
            let sign = if k % 2 == 1 { 2 } else { -2 };
            Ok(Part { mode: Mode::new(gains, &lambda)?, lambda, share: like.ratio(sign, followers as i64) })
        };
        let sine = |n: u64| (like.pi() * like.ratio(n as i64, 2 * followers as i64)).sin();
        Ok(Modes {
            gains: gains.clone(),
            parts: (1..=followers).map(part).collect::<Result<_, _>>()?,
            sines: (0..=followers).map(sine).collect::<Result<_, _>>()?,
        })
    }

    /// `sin(n pi/(2M))` for any n.
    fn sine(&self, n: usize) -> T {
        let half_turn = 2 * self.parts.len();
        let within = n % half_turn;
        let value = &self.sines[within.min(half_turn - within)];
        if (n / half_turn).is_multiple_of(2) { value.clone() } else { -value.clone() }
    }

    /// The cars from the modes.
    fn cars(&self, modes: &[T]) -> Vec<T> {
        let size = self.parts.len();
        let scale = self.gains.f.ratio(2, size as i64);
        let car = |j: usize| {
            let terms = modes.iter().enumerate().map(|(k, z)| self.sine(j * (2 * k + 1)) * z);
            terms.fold(scale.zero(), |sum, term| sum + term) * &scale
        };
        (1..=size).map(car).collect()
    }

    fn followers(
        &self,
        modes: impl Iterator<Item = Result<(T, T), ArithmeticError>>,
    ) -> Result<Followers<T>, ArithmeticError> {
        let (values, rates): (Vec<T>, Vec<T>) = modes.collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
        Ok(Followers { positions: self.cars(&values), velocities: self.cars(&rates) })
    }

    /// The start behind a leader that moves as `e^{iwt}`, all followers at rest in their places at time 0.
    ///
    /// # Errors
    /// [`ArithmeticError`] where the periodic motion does not exist.
    pub fn behind_harmonic_leader(&self, w: &T) -> Result<HarmonicStart<T>, ArithmeticError> {
        let shift = gamma_minus_one(&self.gains, w)?;
        let periodic = |(k, part): (usize, &Part<T>)| {
            // sin phi/(2 (lambda + gamma - 1)).
            let divisor = shift.clone() + Complex::real(part.lambda.clone());
            Ok(divisor.recip()?.scale(&(self.sine(2 * k + 1) * w.ratio(1, 2))))
        };
        let periodic = self.parts.iter().enumerate().map(periodic).collect::<Result<_, _>>()?;
        Ok(HarmonicStart { w: w.clone(), modes: self.clone(), periodic })
    }

    /// Any start behind a leader that moves on evenly, with the swing `amplitude cos wt` besides: `deviations` are those of the followers
    /// from the leader at time 0.
    ///
    /// # Errors
    /// [`ArithmeticError`] where the periodic motion does not exist.
    pub fn behind_swinging_leader(
        &self,
        deviations: &Followers<T>,
        amplitude: &T,
        w: &T,
    ) -> Result<SwingingStart<T>, ArithmeticError> {
        let (size, like) = (self.parts.len(), &self.gains.f);
        let of_mode = |k: usize, list: &[T]| {
            let last = like.ratio(1, 2);
            let term = |(j, x): (usize, &T)| {
                let term = self.sine((j + 1) * (2 * k + 1)) * x;
                if j + 1 == size { term * &last } else { term }
            };
            list.iter().enumerate().map(term).fold(like.zero(), |sum, term| sum + term)
        };
        let strength = amplitude.clone() * w.square();
        let mode = |(k, part): (usize, &Part<T>)| {
            // cot(phi/2)/2 = (1 + cos phi)/(2 sin phi).
            let cosine = self.sine(size + 2 * k + 1);
            let share = (cosine + like.one()).over(&(self.sine(2 * k + 1) * like.integer(2)))?;
            let damping = part.lambda.clone() * &self.gains.g * w;
            let divisor = Complex::new(-(w.square() + part.lambda.clone() * &self.gains.f), -damping);
            let periodic = divisor.recip()?.scale(&(share * &strength));
            let value = of_mode(k, &deviations.positions) - &periodic.re;
            let rate = of_mode(k, &deviations.velocities) + w.clone() * &periodic.im;
            Ok((value, rate, periodic))
        };
        let start = self.parts.iter().enumerate().map(mode).collect::<Result<_, _>>()?;
        Ok(SwingingStart { w: w.clone(), modes: self.clone(), start })
    }

    /// The start behind a leader that drives with piecewise constant acceleration, all followers at rest in their places at
    /// time 0: `changes` has the times `>= 0` at which the acceleration changes and by how much.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn behind_accelerating_leader(&self, changes: &[(T, T)]) -> Result<StopAndGo<T>, ArithmeticError> {
        let rest = |(k, part): (usize, &Part<T>)| {
            // cot(phi/2)/2 = (1 + cos phi)/(2 sin phi), over lambda f: where the mode rests under the acceleration 1.
            let size = self.parts.len();
            let cosine = self.sine(size + 2 * k + 1);
            (cosine + self.gains.f.one())
                .over(&(self.sine(2 * k + 1) * self.gains.f.integer(2) * &part.lambda * &self.gains.f))
        };
        let rest = self.parts.iter().enumerate().map(rest).collect::<Result<_, _>>()?;
        Ok(StopAndGo { modes: self.clone(), changes: changes.to_vec(), rest })
    }
}

/// The start of a platoon behind a leader that moves as `e^{iwt}`.
#[derive(Debug, Clone)]
pub struct HarmonicStart<T> {
    w: T,
    modes: Modes<T>,
    /// `p_k`: the periodic motion of mode k is `p_k e^{iwt}`.
    periodic: Vec<Complex<T>>,
}

impl<T: Real> HarmonicStart<T> {
    /// What the last car still lacks of its periodic motion at time `t`: `y_M(t) - a_M e^{iwt}`. Real and imaginary part
    /// belong to the leaders `cos wt` and `sin wt`.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn transient(&self, t: &T) -> Result<Complex<T>, ArithmeticError> {
        self.modes.parts.iter().zip(&self.periodic).try_fold(Complex::real(t.zero()), |sum, (part, periodic)| {
            let (c, s) = part.mode.propagator(t)?;
            // The mode and its rate are 0 at first, so the free part starts from minus the periodic one and its rate.
            Ok(sum - periodic.clone() * Complex::new(c * &part.share, self.w.clone() * s * &part.share))
        })
    }

    /// An upper bound of `|transient|` that decreases in `t >= 0`.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn transient_bound(&self, t: &T) -> Result<T, ArithmeticError> {
        let share = t.ratio(2, self.periodic.len() as i64);
        self.modes.parts.iter().zip(&self.periodic).try_fold(t.zero(), |sum, (Part { mode, .. }, periodic)| {
            let (c, s) = mode.bounds()?;
            let factor = c + s * &self.w;
            Ok(sum + periodic.norm_squared().sqrt()? * &share * factor * (-(mode.rate.clone() * t)).exp()?)
        })
    }

    /// The last car behind the leader `cos wt`: `y_M(t)`.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn last(&self, t: &T) -> Result<T, ArithmeticError> {
        let (sin, cos) = (self.w.clone() * t).sin_cos()?;
        self.modes.parts.iter().zip(&self.periodic).try_fold(t.zero(), |sum, (part, p)| {
            let (c, s) = part.mode.propagator(t)?;
            let value = (cos.clone() - c) * &p.re - (sin.clone() - self.w.clone() * s) * &p.im;
            Ok(sum + value * &part.share)
        })
    }

    /// All followers behind the leader `cos wt`.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn followers(&self, t: &T) -> Result<Followers<T>, ArithmeticError> {
        let (sin, cos) = (self.w.clone() * t).sin_cos()?;
        let gains = &self.modes.gains;
        let modes = self.modes.parts.iter().zip(&self.periodic).map(|(part, p)| {
            let (c, s) = part.mode.propagator(t)?;
            // c' = lambda f s and s' = c + lambda g s.
            let c_rate = part.lambda.clone() * &gains.f * &s;
            let s_rate = part.lambda.clone() * &gains.g * &s + &c;
            let value = (cos.clone() - c) * &p.re - (sin.clone() - self.w.clone() * s) * &p.im;
            let rate = -(self.w.clone() * &sin + c_rate) * &p.re - (cos.clone() - s_rate) * &self.w * &p.im;
            Ok((value, rate))
        });
        self.modes.followers(modes)
    }
}

/// Any start of a platoon behind a leader that swings.
#[derive(Debug, Clone)]
pub struct SwingingStart<T> {
    w: T,
    modes: Modes<T>,
    /// Value and rate of the free part of each mode at time 0, and its periodic part `p_k`: the real part of `p_k e^{iwt}`.
    start: Vec<(T, T, Complex<T>)>,
}

impl<T: Real> SwingingStart<T> {
    /// The deviations of all followers from the leader at time `t`, in position and velocity.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn deviations(&self, t: &T) -> Result<Followers<T>, ArithmeticError> {
        let (sin, cos) = (self.w.clone() * t).sin_cos()?;
        let gains = &self.modes.gains;
        let modes = self.modes.parts.iter().zip(&self.start).map(|(part, (value, rate, p))| {
            let (c, s) = part.mode.propagator(t)?;
            // c' = lambda f s and s' = c + lambda g s.
            let c_rate = part.lambda.clone() * &gains.f * &s;
            let s_rate = part.lambda.clone() * &gains.g * &s + &c;
            let periodic = cos.clone() * &p.re - sin.clone() * &p.im;
            let periodic_rate = -(sin.clone() * &p.re + cos.clone() * &p.im) * &self.w;
            Ok((periodic + c * value + s * rate, periodic_rate + c_rate * value + s_rate * rate))
        });
        self.modes.followers(modes)
    }
}

/// The start of a platoon behind a leader with piecewise constant acceleration.
#[derive(Debug, Clone)]
pub struct StopAndGo<T> {
    modes: Modes<T>,
    changes: Vec<(T, T)>,
    /// Where each mode of the deviation from the leader rests while the leader accelerates with 1.
    rest: Vec<T>,
}

impl<T: Real> StopAndGo<T> {
    /// The changes of the acceleration up to time `t`, with the times since.
    fn past(&self, t: &T) -> Result<Vec<(T, &T)>, ArithmeticError> {
        let mut past = Vec::new();
        for (time, change) in &self.changes {
            let since = t.clone() - time;
            match since.sign() {
                Some(Sign::Negative) => {}
                Some(_) => past.push((since, change)),
                None => return Err(ArithmeticError::Domain("times before or after a change of the acceleration")),
            }
        }
        Ok(past)
    }

    /// Position and velocity of the leader at time `t`.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] where it is not certain whether `t` is before a change, here and below.
    pub fn leader(&self, t: &T) -> Result<(T, T), ArithmeticError> {
        let (mut position, mut velocity) = (t.zero(), t.zero());
        for (since, change) in self.past(t)? {
            position = position + since.square() * t.ratio(1, 2) * change;
            velocity = velocity + since * change;
        }
        Ok((position, velocity))
    }

    /// Deviation of the last car from the leader, `y_M - y_0`, at time `t`.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn last(&self, t: &T) -> Result<T, ArithmeticError> {
        let past = self.past(t)?;
        self.modes.parts.iter().zip(&self.rest).try_fold(t.zero(), |sum, (part, rest)| {
            let step = |(since, change): &(T, &T)| Ok((t.one() - part.mode.propagator(since)?.0) * *change);
            let steps = past.iter().try_fold(t.zero(), |sum, change| Ok::<T, ArithmeticError>(sum + step(change)?))?;
            Ok(sum + steps * rest * &part.share)
        })
    }

    /// Deviations of all followers from the leader, in position and velocity.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn deviations(&self, t: &T) -> Result<Followers<T>, ArithmeticError> {
        let past = self.past(t)?;
        let modes = self.modes.parts.iter().zip(&self.rest).map(|(part, rest)| {
            let (mut value, mut rate) = (t.zero(), t.zero());
            for (since, change) in &past {
                let (c, s) = part.mode.propagator(since)?;
                value = value + (t.one() - c) * *change;
                rate = rate - part.lambda.clone() * &self.modes.gains.f * s * *change;
            }
            Ok((value * rest, rate * rest))
        });
        self.modes.followers(modes)
    }
}

impl StopAndGo<f64> {
    /// The first passages of the last car by its place, at most so many, within so many steps from the time `from + step` on (at `from` itself it may
    /// be at its place), bisected; of two within one step none is seen.
    ///
    /// # Errors
    /// As for [`StopAndGo::last`].
    pub fn passages(&self, from: f64, step: f64, (most, steps): (usize, usize)) -> Result<Vec<f64>, ArithmeticError> {
        let mut passages = Vec::new();
        let mut t = from + step;
        for _ in 0..steps {
            if passages.len() == most {
                break;
            }
            let (mut low, mut high) = (t, t + step);
            if self.last(&low)? * self.last(&high)? < 0.0 {
                for _ in 0..40 {
                    let middle = 0.5 * (low + high);
                    if self.last(&low)? * self.last(&middle)? < 0.0 { high = middle } else { low = middle }
                }
                passages.push(low);
            }
            t += step;
        }
        Ok(passages)
    }
}
