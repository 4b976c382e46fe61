//! Exact motion of the one-sided platoon (1) in time: any time costs the same, there are no steps.
//!
//! The deviations from the leader obey `e'' = P (f e + g e') - y_0''` with `P = 1 - N`, where `N` hands every car what the one in front of it has. So a
//! function of `P` is the power series in `N` of the same function of one mode with the eigenvalue `lambda = 1 - h`, and `N^M = 0`: the free
//! motion is `e_k(t) = sum_j c_j e_(k-j)(0) + s_j e'_(k-j)(0)` with the coefficients of [`Mode::propagator`] over series in `h`.

use super::law::Gains;
use super::modes::{Mode, Roots};
use super::response::gamma;
use super::time_domain::Followers;
use arithmetic::{ArithmeticError, Complex, Field, Number, Real, Ring, Series, Sign};

/// The free motion of a one-sided platoon.
#[derive(Debug, Clone)]
pub struct FrontMotion<T> {
    gains: Gains<T>,
    lambda: Series<T>,
    mode: Mode<Series<T>>,
}

impl<T: Real> FrontMotion<T> {
    /// That of `followers >= 1` cars.
    ///
    /// # Errors
    /// [`ArithmeticError`] where the roots of `s² = f + g s` may coincide, and it is not certain that they do.
    pub fn new(gains: &Gains<T>, followers: usize) -> Result<Self, ArithmeticError> {
        let order = followers.max(1);
        let one = Series::constant(gains.f.one(), order);
        let lambda = one - Series::variable(gains.f.one(), order);
        let mode = Mode::new(&gains.map(|x| Series::constant(x.clone(), order)), &lambda)?;
        match &mode.roots {
            Roots::Close(d) if d.coefficients()[0].sign() != Some(Sign::Zero) => {
                Err(ArithmeticError::Domain("roots that are known to be distinct, or to coincide"))
            }
            _ => Ok(FrontMotion { gains: gains.clone(), lambda, mode }),
        }
    }

    /// [`Mode::propagator`]. Where the roots of the mode coincide, the discriminant has no constant term, and `d t²` need be raised to no power beyond
    /// the order.
    fn propagator(&self, t: &T) -> Result<(Series<T>, Series<T>), ArithmeticError> {
        let order = self.lambda.coefficients().len();
        let time = Series::constant(t.clone(), order);
        let Roots::Close(discriminant) = &self.mode.roots else { return self.mode.propagator(&time) };
        let x = discriminant.clone() * time.square();
        let (mut even, mut odd) = (x.one(), x.one());
        let (mut of_even, mut of_odd) = (x.one(), x.one());
        for k in 1..order as i64 {
            of_even = (of_even * &x).scale(&t.ratio(1, (2 * k - 1) * 2 * k));
            of_odd = (of_odd * &x).scale(&t.ratio(1, 2 * k * (2 * k + 1)));
            (even, odd) = (even + &of_even, odd + &of_odd);
        }
        let envelope = (-(self.mode.decay.clone() * &time)).exp()?;
        let s = odd * &time;
        Ok((envelope.clone() * (even + self.mode.decay.clone() * &s), envelope * s))
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
    ) -> Result<FrontStart<T>, ArithmeticError> {
        let factor = gamma(&self.gains, w)?.recip()?;
        // Car k swings as gamma^-k times the leader.
        let mut own = Complex::real(amplitude.clone());
        let (mut free, mut periodic) = (deviations.clone(), Vec::new());
        for (x, u) in free.positions.iter_mut().zip(&mut free.velocities) {
            own = own * &factor;
            let swing = own.clone() - Complex::real(amplitude.clone());
            *x = x.clone() - &swing.re;
            *u = u.clone() + w.clone() * &swing.im;
            periodic.push(swing);
        }
        Ok(FrontStart { motion: self.clone(), w: w.clone(), free, periodic })
    }
}

/// Any start of a one-sided platoon behind a leader that swings.
#[derive(Debug, Clone)]
pub struct FrontStart<T> {
    motion: FrontMotion<T>,
    w: T,
    /// The free part at time 0.
    free: Followers<T>,
    /// `p_k`: the periodic part of car k is the real part of `p_k e^{iwt}`.
    periodic: Vec<Complex<T>>,
}

impl<T: Real> FrontStart<T> {
    /// The deviations of all followers from the leader at time `t`, in position and velocity.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn deviations(&self, t: &T) -> Result<Followers<T>, ArithmeticError> {
        let FrontMotion { gains, lambda, .. } = &self.motion;
        let (c, s) = self.motion.propagator(t)?;
        // c' = lambda f s and s' = c + lambda g s.
        let moved = lambda.clone() * &s;
        let (c_rate, s_rate) = (moved.scale(&gains.f), moved.scale(&gains.g) + &c);
        let along = |of_x: &Series<T>, of_u: &Series<T>, k: usize| {
            let term = |j: usize| {
                let (x, u) = (&self.free.positions[k - j], &self.free.velocities[k - j]);
                of_x.coefficients()[j].clone() * x + of_u.coefficients()[j].clone() * u
            };
            (1..=k).fold(term(0), |sum, j| sum + term(j))
        };
        let (sin, cos) = (self.w.clone() * t).sin_cos()?;
        let value = |(k, p): (usize, &Complex<T>)| along(&c, &s, k) + cos.clone() * &p.re - sin.clone() * &p.im;
        let rate = |(k, p): (usize, &Complex<T>)| {
            along(&c_rate, &s_rate, k) - (sin.clone() * &p.re + cos.clone() * &p.im) * &self.w
        };
        Ok(Followers {
            positions: self.periodic.iter().enumerate().map(value).collect(),
            velocities: self.periodic.iter().enumerate().map(rate).collect(),
        })
    }
}
