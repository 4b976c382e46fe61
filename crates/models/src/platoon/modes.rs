//! The modes of the two-sided platoon (2): the spectrum of `P_2` and how its modes move.
//!
//! `P_2` has the eigenvalues `lambda_k = 1 - cos phi_k`, `phi_k = (2k - 1) pi/(2M)`, k = 1 to M, and the eigenvectors
//! `sin(j phi_k)`. With the weights 1 for j < M and 1/2 for j = M these are orthogonal with the squared norm M/2
//! (`notes/veerman_platoons.md`).

use super::law::Gains;
use arithmetic::{ArithmeticError, Dyadic, Interval, Number, Rational, Real, Sign, Signed};

/// The angle `phi_k`, of the kind of `like`; `1 <= k <= followers`.
pub fn mode_angle<T: Real>(like: &T, followers: u64, k: u64) -> T {
    let (over, under) = (2 * i128::from(k) - 1, 2 * i128::from(followers.max(1)));
    let share = match (i64::try_from(over), i64::try_from(under)) {
        (Ok(over), Ok(under)) => like.ratio(over, under),
        _ => like.rational(&Rational::new(over.into(), under.into())),
    };
    like.pi() * share
}

/// The eigenvalue `lambda_k = 1 - cos phi_k = 2 sin²(phi_k/2)` of `P_2`.
///
/// # Errors
/// [`ArithmeticError`] of the sine.
pub fn mode_eigenvalue<T: Real>(like: &T, followers: u64, k: u64) -> Result<T, ArithmeticError> {
    let half = mode_angle(like, followers, k) * like.ratio(1, 2);
    Ok(half.sin()?.square() * like.integer(2))
}

/// The free motion of one mode, `z'' = lambda (f z + g z')`, whose characteristic roots are `-decay ± sqrt(d)` with the discriminant
/// `d = lambda² g²/4 - lambda |f|`.
#[derive(Debug, Clone)]
pub struct Mode<T> {
    /// `lambda |g|/2`, 1/s.
    pub decay: T,
    /// What is known of the roots.
    pub roots: Roots<T>,
    /// The slower of the two rates at which it decays, 1/s; half of `decay`, which is below both, where the roots may coincide.
    pub rate: T,
}

/// What is known of the characteristic roots of a mode.
#[derive(Debug, Clone)]
pub enum Roots<T> {
    /// `-decay ± i w`: it oscillates with this angular frequency `w`, rad/s.
    Complex(T),
    /// `-decay ± w`: it is overdamped, with this `w`.
    Real(T),
    /// They coincide, or may: this discriminant is 0, or encloses 0, and is at most `decay²/16` in size.
    Close(T),
}

impl<T: Real> Mode<T> {
    /// The mode of the eigenvalue `lambda > 0`, for `f, g < 0`.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] where too little is known of the roots.
    pub fn new(gains: &Gains<T>, lambda: &T) -> Result<Self, ArithmeticError> {
        let (decay, discriminant) = decay_and_discriminant(gains, lambda);
        match discriminant.sign() {
            Some(Sign::Positive) => {
                let apart = discriminant.sqrt()?;
                // decay - sqrt(d) without the cancellation: the product of the two rates is lambda |f|.
                let faster = decay.clone() + &apart;
                let rate = (-(lambda.clone() * &gains.f)).over(&faster)?;
                Ok(Mode { decay, roots: Roots::Real(apart), rate })
            }
            Some(Sign::Negative) => {
                let frequency = (-discriminant).sqrt()?;
                Ok(Mode { rate: decay.clone(), decay, roots: Roots::Complex(frequency) })
            }
            _ if is_within(&discriminant, &(decay.square() * decay.ratio(1, 16))) => {
                let rate = decay.clone() * decay.ratio(1, 2);
                Ok(Mode { decay, roots: Roots::Close(discriminant), rate })
            }
            _ => Err(ArithmeticError::Domain("modes whose roots are known to be distinct, or close to each other")),
        }
    }

    /// `(c, s)` such that the free motion is `z(t) = c z(0) + s z'(0)`.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the elementary functions.
    pub fn propagator(&self, t: &T) -> Result<(T, T), ArithmeticError> {
        let ((sine, cosine), apart) = match &self.roots {
            Roots::Close(discriminant) => return self.of_close_roots(discriminant, t),
            Roots::Complex(frequency) => ((frequency.clone() * t).sin_cos()?, frequency),
            Roots::Real(apart) => {
                let angle = apart.clone() * t;
                if (angle.clone() - t.one()).is_certainly_positive() {
                    // Both exponentials decrease; their difference is far from zero here.
                    let slow = (-(self.rate.clone() * t)).exp()?;
                    let fast = (-((self.decay.clone() + apart) * t)).exp()?;
                    let half = t.ratio(1, 2);
                    let s = (slow.clone() - &fast).over(apart)? * &half;
                    return Ok(((slow + fast) * half + self.decay.clone() * &s, s));
                }
                (angle.sinh_cosh()?, apart)
            }
        };
        let envelope = (-(self.decay.clone() * t)).exp()?;
        let s = sine.over(apart)?;
        Ok((envelope.clone() * (cosine + self.decay.clone() * &s), envelope * s))
    }

    /// The same by power series in the discriminant `d`, which encloses 0: `e^(-decay t) (C + decay t S, t S)` with `C = cosh sqrt(d t²)` and
    /// `S = sinh sqrt(d t²)/sqrt(d t²)`. The time is halved until `d t²` is small, and then the motion is doubled as often.
    fn of_close_roots(&self, discriminant: &T, t: &T) -> Result<(T, T), ArithmeticError> {
        const MOST_HALVINGS: usize = 4096;
        let (mut time, mut halvings) = (t.clone(), 0);
        let mut x = discriminant.clone() * time.square();
        while !is_within(&x, &t.ratio(1, 16)) {
            if halvings == MOST_HALVINGS {
                return Err(ArithmeticError::Domain("times at which the motion of close roots can be told"));
            }
            time = time * t.ratio(1, 2);
            x = discriminant.clone() * time.square();
            halvings += 1;
        }
        let [c, s] = near_one(&x)?;
        let envelope = (-(self.decay.clone() * &time)).exp()?;
        let s = s * &time;
        let mut moved = (envelope.clone() * (c + self.decay.clone() * &s), envelope * s);
        // lambda f = d - decay² and lambda g = -2 decay.
        let stiffness = discriminant.clone() - self.decay.square();
        for _ in 0..halvings {
            let (c, s) = moved;
            let twice = (c.clone() - self.decay.clone() * &s) * &s * t.integer(2);
            moved = (c.square() + stiffness.clone() * s.square(), twice);
        }
        Ok(moved)
    }

    /// Upper bounds of `|c|` and `|s|` for all `t >= 0`, each to be multiplied by `e^(-rate t)`.
    ///
    /// # Errors
    /// [`ArithmeticError`] of the divisions.
    pub fn bounds(&self) -> Result<(T, T), ArithmeticError> {
        let one = self.decay.one();
        match &self.roots {
            Roots::Complex(apart) | Roots::Real(apart) => Ok((self.decay.over(apart)? + &one, one.over(apart)?)),
            // With sqrt(d) <= decay/4, C <= e^(decay t/4) and S <= e^(decay t/4), so that t S e^(-decay t) <= (4/decay) (decay t/4) e^(-decay t/4) e^(-rate t),
            // which is at most (2/decay) e^(-rate t).
            Roots::Close(_) => Ok((one.integer(3), one.integer(2).over(&self.decay)?)),
        }
    }
}

/// Whether `|x| <= bound` is certain.
fn is_within<T: Real>(x: &T, bound: &T) -> bool {
    (bound.clone() - x).is_certainly_positive() && (bound.clone() + x).is_certainly_positive()
}

/// `cosh sqrt(x)` and `sinh sqrt(x)/sqrt(x)` for `|x| < 1/16`, where `x` is 0 or encloses 0.
fn near_one<T: Real>(x: &T) -> Result<[T; 2], ArithmeticError> {
    const TERMS: i64 = 9;
    let mut power = x.one();
    let (mut sums, mut factorial) = ([x.zero(), x.zero()], 1);
    for k in 0..TERMS {
        let [even, odd] = &mut sums;
        *even = even.clone() + power.clone() * x.ratio(1, factorial);
        *odd = odd.clone() + power.clone() * x.ratio(1, factorial * (2 * k + 1));
        factorial *= (2 * k + 1) * (2 * k + 2);
        power = power * x;
    }
    // The rest is `power` times a number between 0 and 2/(2 TERMS)!; `power` encloses 0, so that its multiple encloses all of these.
    let rest = power * x.ratio(2, factorial);
    Ok(sums.map(|sum| sum + &rest))
}

/// `lambda |g|/2` and its square less `lambda |f|`, whose roots are the imaginary or real distances of the characteristic roots from `-lambda |g|/2`.
fn decay_and_discriminant<T: Real>(gains: &Gains<T>, lambda: &T) -> (T, T) {
    let decay = -(lambda.clone() * &gains.g) * lambda.ratio(1, 2);
    let discriminant = decay.square() + lambda.clone() * &gains.f;
    (decay, discriminant)
}

/// The slower of the two rates of a mode, also where its roots may be double.
fn slower_rate(gains: &Gains<Interval>, lambda: &Interval) -> Result<Interval, ArithmeticError> {
    let (decay, discriminant) = decay_and_discriminant(gains, lambda);
    if matches!(discriminant.sign(), Some(Sign::Positive | Sign::Negative)) {
        return Ok(Mode::new(gains, lambda)?.rate);
    }
    // The rate is decay - sqrt(max(discriminant, 0)).
    let above = Interval::between(Dyadic::zero(), discriminant.hi().clone(), decay.precision());
    Ok(decay - above.sqrt()?)
}

/// The slowest rate of decay of the platoon (2), `-max Re spec(M)`.
///
/// As a function of `lambda` the rate of a mode is `|g| lambda/2` up to `lambda = 4|f|/g²` and
/// `2|f|/(|g| + sqrt(g² - 4|f|/lambda))`, which decreases, beyond; so the slowest mode is the first or the last.
///
/// # Errors
/// [`ArithmeticError`] of the elementary functions.
pub fn slowest_rate(gains: &Gains<Interval>, followers: u64) -> Result<Interval, ArithmeticError> {
    let rate = |k| slower_rate(gains, &mode_eigenvalue(&gains.f, followers, k)?);
    let (first, last) = (rate(1)?, rate(followers.max(1))?);
    let (lo, hi) = (first.lo().min(last.lo()), first.hi().min(last.hi()));
    Ok(Interval::between(lo.clone(), hi.clone(), first.precision()))
}
