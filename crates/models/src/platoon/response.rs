//! Harmonic response of the followers: `y_k = a_k e^{i w t}` with `a_0 = 1`.

use super::law::Gains;
use arithmetic::{ArithmeticError, Complex, Field, Rational, Real, Ring};

/// `gamma = (f + i w g + w²)/(f + i w g) = 1 + w²/(f + i w g)` (Corollary 1).
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where `f + i w g` may be zero.
pub fn gamma<T: Field>(gains: &Gains<T>, w: &T) -> Result<Complex<T>, ArithmeticError> {
    Ok(Complex::real(w.one()) + gamma_minus_one(gains, w)?)
}

/// `gamma - 1 = w²/(f + i w g)`, which is small at small frequencies.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where `f + i w g` may be zero.
pub fn gamma_minus_one<T: Field>(gains: &Gains<T>, w: &T) -> Result<Complex<T>, ArithmeticError> {
    Ok(complex_gain(gains, w).recip()?.scale(&w.square()))
}

/// `f + i w g`, by which the force on a car answers its deviation.
pub(super) fn complex_gain<T: Field>(gains: &Gains<T>, w: &T) -> Complex<T> {
    Complex::new(gains.f.clone(), gains.g.clone() * w)
}

/// System (1): `a_k = gamma^-k`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where `gamma` does not exist or may be zero.
pub fn amplitude_one_sided<T: Field>(gains: &Gains<T>, w: &T, k: u64) -> Result<Complex<T>, ArithmeticError> {
    Ok(gamma(gains, w)?.recip()?.power(k))
}

/// System (1): `|1/gamma|²` as a function of `y = w²`, which is `(f² + g² y)/((f + y)² + g² y)`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where the denominator may be zero.
pub fn gain_squared_one_sided<T: Field>(gains: &Gains<T>, y: &T) -> Result<T, ArithmeticError> {
    let (numerator, denominator) = gain_fraction_one_sided(gains, y);
    numerator.over(&denominator)
}

/// Numerator and denominator of [`gain_squared_one_sided`]; both are positive for `f, g < 0` and `y > 0`.
pub fn gain_fraction_one_sided<T: Field>(gains: &Gains<T>, y: &T) -> (T, T) {
    let damping = gains.g.square() * y;
    (gains.f.square() + &damping, (gains.f.clone() + y).square() + damping)
}

/// System (1): the `w²` at which `|1/gamma|` is largest: the positive root of `g² y² + 2 f² y + 2 f³ = 0`
/// (`notes/veerman.md`).
///
/// # Errors
/// [`ArithmeticError`] where `f` or `g` may be zero or `f` may be positive.
pub fn strongest_one_sided_square<T: Real>(gains: &Gains<T>) -> Result<T, ArithmeticError> {
    let ratio = gains.g.square().over(&-gains.f.clone())?;
    Ok(-gains.f.clone() * positive_root(&ratio, &ratio.one())?)
}

/// The positive root `s` of `b s² + 2 s = 2 d`, without cancellation: `2 d/(1 + sqrt(1 + 2 b d))`. With `b = g²/|f|` and `s = w²/|f|`,
/// this is where `|gamma - 1 + d|` is smallest.
///
/// # Errors
/// [`ArithmeticError`] of the square root.
pub(super) fn positive_root<T: Real>(b: &T, d: &T) -> Result<T, ArithmeticError> {
    let two_d = d.clone() + d;
    let root = (b.one() + b.clone() * &two_d).sqrt()?;
    two_d.over(&(root + b.one()))
}

/// The Chebyshev polynomials `(T_n, U_{n-1})` at `gamma`, with `distance = gamma - 1` given apart because it is small
/// where this is used. About `2 log2 n` products.
pub fn chebyshev<T: Ring>(n: u64, distance: &T) -> (T, T) {
    let one = distance.one();
    let gamma = one.clone() + distance;
    let s2 = distance.clone() * (gamma.clone() + &one);
    let (mut t, mut u) = (one.clone(), one.zero());
    for bit in (0..u64::BITS - n.leading_zeros()).rev() {
        let product = t.clone() * &u;
        let square = t.square();
        t = square.clone() + square - &one;
        u = product.clone() + product;
        if n >> bit & 1 == 1 {
            (t, u) = (gamma.clone() * &t + s2.clone() * &u, gamma.clone() * u + t);
        }
    }
    (t, u)
}

/// `e^y` for `gamma = cos(x - iy)`, `y > 0`: the modulus of the larger root of `mu² - 2 gamma mu + 1 = 0`, from
/// `cosh y = (|gamma + 1| + |gamma - 1|)/2`. It does not depend on the number of cars.
///
/// # Errors
/// [`ArithmeticError`] where `gamma` does not exist.
pub fn larger_root_modulus<T: Real>(gains: &Gains<T>, w: &T) -> Result<T, ArithmeticError> {
    let gamma = gamma(gains, w)?;
    let distance = |to: i64| (gamma.clone() - gamma.integer(to)).norm_squared().sqrt();
    let cosh = (distance(-1)? + distance(1)?) * w.ratio(1, 2);
    Ok((cosh.square() - cosh.one()).sqrt()? + cosh)
}

/// The `n`-th power of [`larger_root_modulus`], `e^{ny}`, without the cancellation at small frequencies: from
/// `|T_n|² + |gamma² - 1| |U_{n-1}|² = 1 + 2 sinh²(ny)`.
///
/// # Errors
/// [`ArithmeticError`] where `gamma` does not exist.
pub fn larger_root_power<T: Real>(gains: &Gains<T>, w: &T, n: u64) -> Result<T, ArithmeticError> {
    let d = gamma_minus_one(gains, w)?;
    let (t, u) = chebyshev(n, &d);
    let two = d.one() + d.one();
    let s2 = d.clone() * (two + d);
    let double = t.norm_squared() + s2.norm_squared().sqrt()? * u.norm_squared() - w.one();
    let sinh = (double * w.ratio(1, 2)).sqrt()?;
    Ok((sinh.square() + w.one()).sqrt()? + sinh)
}

/// System (2): `1/|a_M|² = |T_M(gamma)|²` for the last of `followers` cars, which exists at every frequency.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where `gamma` does not exist.
pub fn inverse_square_two_sided<T: Field>(gains: &Gains<T>, w: &T, followers: u64) -> Result<T, ArithmeticError> {
    Ok(chebyshev(followers, &gamma_minus_one(gains, w)?).0.norm_squared())
}

/// System (2): the amplitude `a_k = T_{M-k}(gamma)/T_M(gamma)` of car `k`, 0 for the leader, up to `followers`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where `gamma` does not exist or `T_M(gamma)` may be zero;
/// [`ArithmeticError::Domain`] where there is no car `k`.
pub fn amplitude_two_sided<T: Field>(
    gains: &Gains<T>,
    w: &T,
    followers: u64,
    k: u64,
) -> Result<Complex<T>, ArithmeticError> {
    let behind = followers.checked_sub(k).ok_or(ArithmeticError::Domain("a car of the platoon"))?;
    let distance = gamma_minus_one(gains, w)?;
    chebyshev(behind, &distance).0.over(&chebyshev(followers, &distance).0)
}

/// System (2): all amplitudes `a_1, ..., a_M`, `a_k = T_{M-k}(gamma)/T_M(gamma)`, by the three-term recurrence.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where `gamma` does not exist or `T_M(gamma)` may be zero.
pub fn amplitudes_two_sided<T: Field>(
    gains: &Gains<T>,
    w: &T,
    followers: usize,
) -> Result<Vec<Complex<T>>, ArithmeticError> {
    let gamma = gamma(gains, w)?;
    let two_gamma = gamma.clone() + &gamma;
    let mut values = vec![gamma.one(), gamma];
    while values.len() <= followers {
        let n = values.len();
        values.push(two_gamma.clone() * &values[n - 1] - &values[n - 2]);
    }
    values.truncate(followers + 1);
    let Some(last) = values.pop() else { return Ok(Vec::new()) };
    let scale = last.recip()?;
    Ok(values.into_iter().rev().map(|value| value * &scale).collect())
}

/// System (2) with another first car: `a_M` where car 1 compares its velocity as `own u_1 - leader u_0 - behind u_2` (in
/// equation (2) the weights are 1, 1/2, 1/2). The other cars give `a_k = a_M T_{M-k}(gamma)`, k >= 1; `followers >= 2`.
///
/// # Errors
/// [`ArithmeticError::DivisionByZero`] where the response may not exist.
pub fn amplitude_with_first_car<T: Field>(
    gains: &Gains<T>,
    w: &T,
    followers: u64,
    weights: &[Rational; 3],
) -> Result<Complex<T>, ArithmeticError> {
    let [own, leader, behind] = weights.each_ref().map(|q| w.rational(q));
    let distance = gamma_minus_one(gains, w)?;
    let [(t1, _), (t2, _)] = [1, 2].map(|k| chebyshev(followers.saturating_sub(k), &distance));
    // w² a_1 + f (a_1 - (a_0 + a_2)/2) + iwg (own a_1 - leader a_0 - behind a_2) = 0.
    let half = w.ratio(1, 2);
    let damping = Complex::new(w.zero(), gains.g.clone() * w);
    let position = (t1.clone() - t2.scale(&half)).scale(&gains.f);
    let velocity = (t1.scale(&own) - t2.scale(&behind)) * &damping;
    let drive = Complex::real(gains.f.clone() * half) + damping.scale(&leader);
    drive.over(&(t1.scale(&w.square()) + position + velocity))
}
