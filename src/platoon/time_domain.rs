//! Exact motion of the two-sided platoon (2) in time, as a finite sum over its modes.
//!
//! With `phi_k`, `lambda_k` as in [`super::modes`], the mode `z_k = sum_j w_j sin(j phi_k) y_j` (weights 1, and 1/2 for the last
//! car) obeys `z'' = lambda (f z + g z') - (sin phi_k/2)(f y_0 + g y_0')`, and `y_j = (2/M) sum_k sin(j phi_k) z_k`. For the
//! deviation `e_j = y_j - y_0` from the leader the last term is `-(cot(phi_k/2)/2) y_0''`.

use super::modes::{Mode, mode_angle, mode_eigenvalue};
use super::{Gains, gamma};
use crate::arithmetic::{ArithmeticError, Complex, Field, Real, Sign, Signed};

/// One mode with what is needed to follow the last car.
#[derive(Debug, Clone)]
struct Part<T> {
    mode: Mode<T>,
    lambda: T,
    /// `phi_k`.
    angle: T,
    /// `(2/M) sin(M phi_k)`: its share in the last car.
    share: T,
}

/// The modes of a platoon.
#[derive(Debug, Clone)]
pub struct Modes<T> {
    gains: Gains<T>,
    parts: Vec<Part<T>>,
}

impl<T: Real + Signed> Modes<T> {
    /// The modes of `followers >= 1` cars.
    ///
    /// # Errors
    /// [`ArithmeticError`] where a mode may have a double root.
    pub fn new(gains: &Gains<T>, followers: u64) -> Result<Self, ArithmeticError> {
        let like = &gains.f;
        let part = |k: u64| {
            let lambda = mode_eigenvalue(like, followers, k)?;
            let sign = if k % 2 == 1 { 2 } else { -2 };
            Ok(Part {
                mode: Mode::new(gains, &lambda)?,
                lambda,
                angle: mode_angle(like, followers, k),
                share: like.ratio(sign, followers as i64),
            })
        };
        Ok(Modes { gains: gains.clone(), parts: (1..=followers).map(part).collect::<Result<_, _>>()? })
    }

    /// The start behind a leader that moves as `e^{iwt}`, all followers at rest in their places at time 0.
    ///
    /// # Errors
    /// [`ArithmeticError`] where the periodic motion does not exist.
    pub fn behind_harmonic_leader(&self, w: &T) -> Result<HarmonicStart<T>, ArithmeticError> {
        let shift = gamma(&self.gains, w)? - Complex::real(w.one());
        let periodic = |part: &Part<T>| {
            // sin phi/(2 (lambda + gamma - 1)), times the share in the last car.
            let divisor = shift.clone() + Complex::real(part.lambda.clone());
            let half_sine = part.angle.sin()? * part.angle.ratio(1, 2);
            Ok((part.mode.clone(), divisor.recip()?.scale(&(half_sine * &part.share))))
        };
        Ok(HarmonicStart { w: w.clone(), parts: self.parts.iter().map(periodic).collect::<Result<_, _>>()? })
    }

    /// The deviation of the last car from the leader, `y_M - y_0`, at time `t`, when everyone is at rest in its place until the
    /// leader accelerates with 1 from time 0 to `until` and then keeps its velocity.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions, and where it is not certain whether `t` is before `until`.
    pub fn last_after_start(&self, until: &T, t: &T) -> Result<T, ArithmeticError> {
        let remaining = t.clone() - until;
        let coasting = match remaining.sign() {
            Some(sign) => sign != Sign::Negative,
            None => return Err(ArithmeticError::Domain("a time before or after the acceleration")),
        };
        let mut sum = t.zero();
        for part in &self.parts {
            let half = part.angle.clone() * t.ratio(1, 2);
            let (sine, cosine) = half.sin_cos()?;
            // The step response is rest (1 - c(t)), with 0 = lambda f rest - cot(phi/2)/2.
            let rest = cosine.over(&(sine * t.integer(2) * &part.lambda * &self.gains.f))?;
            let (c, _) = part.mode.propagator(t)?;
            let later = if coasting { part.mode.propagator(&remaining)?.0 } else { t.one() };
            sum = sum + (later - c) * rest * &part.share;
        }
        Ok(sum)
    }
}

/// The start of a platoon behind a leader that moves as `e^{iwt}`.
#[derive(Debug, Clone)]
pub struct HarmonicStart<T> {
    w: T,
    /// The modes with their shares in the periodic motion of the last car.
    parts: Vec<(Mode<T>, Complex<T>)>,
}

impl<T: Real + Signed> HarmonicStart<T> {
    /// What the last car still lacks of its periodic motion at time `t`: `y_M(t) - a_M e^{iwt}`. Real and imaginary part
    /// belong to the leaders `cos wt` and `sin wt`.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn transient(&self, t: &T) -> Result<Complex<T>, ArithmeticError> {
        self.parts.iter().try_fold(Complex::real(t.zero()), |sum, (mode, periodic)| {
            let (c, s) = mode.propagator(t)?;
            // The mode and its rate are 0 at first, so the free part starts from minus the periodic one and its rate.
            Ok(sum - periodic.clone() * Complex::new(c, self.w.clone() * s))
        })
    }

    /// An upper bound of `|transient|` that decreases in `t >= 0`.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn transient_bound(&self, t: &T) -> Result<T, ArithmeticError> {
        self.parts.iter().try_fold(t.zero(), |sum, (mode, periodic)| {
            // |c| <= e^(-rate t) (1 + decay/frequency), |s| <= e^(-rate t)/frequency.
            let factor = (mode.decay.clone() + &self.w).over(&mode.frequency)? + t.one();
            Ok(sum + periodic.norm_squared().sqrt()? * factor * (-(mode.rate() * t)).exp()?)
        })
    }
}
