//! Exact motion of the two-sided platoon (2) in time, as a finite sum over its modes.
//!
//! With `phi_k`, `lambda_k` as in [`super::modes`], the mode `z_k = sum_j w_j sin(j phi_k) y_j` (weights 1, and 1/2 for the last
//! car) obeys `z'' = lambda (f z + g z') - (sin phi_k/2)(f y_0 + g y_0')`, and `y_j = (2/M) sum_k sin(j phi_k) z_k`. For the
//! deviation `e_j = y_j - y_0` from the leader the last term is `-(cot(phi_k/2)/2) y_0''`.

use super::modes::{Mode, mode_angle, mode_eigenvalue};
use super::{Gains, gamma};
use crate::arithmetic::{ArithmeticError, Complex, Field, Real, Ring, Sign, Signed};

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

    /// What the last car still lacks of its periodic motion at time `t`, when the leader moves as `e^{iwt}` and all followers
    /// start at rest in their places: `y_M(t) - a_M e^{iwt}`. Real and imaginary part belong to the leaders `cos wt` and `sin wt`.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn transient_of_last(&self, w: &T, t: &T) -> Result<Complex<T>, ArithmeticError> {
        let shift = gamma(&self.gains, w)? - Complex::real(w.one());
        let mut sum = shift.zero();
        for part in &self.parts {
            let periodic = self.periodic(part, &shift)?;
            let (c, s) = part.mode.propagator(t)?;
            // z(0) = z'(0) = 0, so the free part starts from minus the periodic one and its rate i w z.
            let evolved = periodic.scale(&c) + periodic * Complex::new(w.zero(), w.clone() * s);
            sum = sum - evolved.scale(&part.share);
        }
        Ok(sum)
    }

    /// An upper bound of `|transient_of_last|` that decreases in `t`.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn transient_bound(&self, w: &T, t: &T) -> Result<T, ArithmeticError> {
        let shift = gamma(&self.gains, w)? - Complex::real(w.one());
        let mut sum = w.zero();
        for part in &self.parts {
            let size = self.periodic(part, &shift)?.norm_squared().sqrt()?;
            // |c| <= e^(-rate t) (1 + decay/frequency), |s| <= e^(-rate t)/frequency.
            let factor = (part.mode.decay.clone() + w).over(&part.mode.frequency)? + w.one();
            let envelope = (-(part.mode.rate() * t)).exp()?;
            sum = sum + size * factor * envelope * w.ratio(2, self.parts.len() as i64);
        }
        Ok(sum)
    }

    /// The amplitude of a mode in the periodic motion, `sin phi/(2 (lambda + gamma - 1))`.
    fn periodic(&self, part: &Part<T>, shift: &Complex<T>) -> Result<Complex<T>, ArithmeticError> {
        let divisor = shift.clone() + Complex::real(part.lambda.clone());
        let half_sine = part.angle.sin()? * part.angle.ratio(1, 2);
        Ok(divisor.recip()?.scale(&half_sine))
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
