//! The phase margin of a platoon: the least angle by which all control would have to be turned for it to be on the verge. With equal gains it is enclosed;
//! with gains for each car it is searched, and only a bound from above is certain. The gain margin is in [`super::gain_margin`].
//!
//! With the reduced Laplacian `P` and equal gains, `det(s² - (f + g s) P) = 0`. For an eigenvalue `lambda` of `P` the loop is
//! `L(iw) = lambda (|f| + i w |g|)/w²`, whose modulus decreases with `w`, and the mode is on the verge where `L(iw) = 1`. So the margin is the least
//! `|arg L(iw)|` where `|L(iw)| = 1`; of two conjugate modes the one that lags comes closer.
//!
//! Where each car has its own gains there are no such loops. There all control is turned by one angle after the other, and
//! stability is read off enclosed eigenvalues of `x' = A x`.

use super::gain_margin::MOST_MODES;
use super::law::Gains;
use super::vector_form::motion_rows_of_cars;
use algebra::matrix::{RationalMatrix, SparseMatrix};
use algebra::spectrum::matrix_spectrum;
use arithmetic::{ArithmeticError, Field, Interval, Number, Rational, Real, Ring, Sign, Signed, rational};
use std::f64::consts::PI;

/// Most followers with gains of their own of which it is searched.
pub const MOST_SEARCHED: usize = 12;

/// Bits of the angle at which a platoon is unstable.
const PRECISION: u32 = 80;

/// The angles that are tried are multiples of pi over this.
pub const STEPS: i32 = 32;

/// What is known of the phase margin of a **stable** platoon, in radians.
#[derive(Debug, Clone)]
pub enum PhaseMargin {
    /// It lies here.
    Enclosed(Interval),
    /// Turned by this angle the platoon is unstable. It was stable at all smaller multiples of pi/[`STEPS`]; what is unstable only between two of them
    /// was passed over.
    AtMost(Interval),
    /// It is not known, for this reason.
    Open(String),
}

/// The phase margin of a **stable** platoon with the reduced Laplacian `P`, whose follower `k` has the negative gains `gains[k - 1]`.
///
/// # Errors
/// [`ArithmeticError::Domain`] where there are not as many gains as rows and columns of `reduced`.
pub fn phase_margin(reduced: &RationalMatrix, gains: &[Gains<Rational>]) -> Result<PhaseMargin, ArithmeticError> {
    let followers = gains.len();
    if followers == 0 || [reduced.rows(), reduced.cols()] != [followers; 2] {
        return Err(ArithmeticError::Domain("gains for each follower"));
    }
    let open = |why: &str| PhaseMargin::Open(why.to_string());
    let equal = gains.iter().all(|other| *other == gains[0]);
    let most = if equal { MOST_MODES } else { MOST_SEARCHED };
    Ok(if followers > most {
        PhaseMargin::Open(format!("more than {most} cars"))
    } else if equal {
        by_modes(reduced, &gains[0]).unwrap_or_else(|| open("the modes are not told apart from the verge"))
    } else {
        searched(reduced, gains).unwrap_or_else(|| open("enclosed eigenvalues do not tell where stability ends"))
    })
}

/// `|arg L(iw)|` where `|L(iw)| = 1`, for the one of `lambda` and its conjugate that lags; the real part of `lambda` is positive, and the gains
/// are given by their moduli. `turn` is the modulus of the argument of `lambda`.
pub fn phase_of_mode<T: Real>(gains: &Gains<T>, square: &T, turn: &T) -> Result<T, ArithmeticError> {
    let (f2, g2) = (gains.f.square(), gains.g.square());
    // |L| = 1: w⁴ = |lambda|² (f² + g² w²).
    let half = square.clone() * g2 * square.ratio(1, 2);
    let crossing = (half.clone() + (half.square() + square.clone() * f2).sqrt()?).sqrt()?;
    Ok((crossing * &gains.g).over(&gains.f)?.atan()? - turn)
}

fn by_modes(reduced: &RationalMatrix, gains: &Gains<Rational>) -> Option<PhaseMargin> {
    let spectrum = matrix_spectrum(&SparseMatrix::from_dense(reduced).ok()?, None).ok()?;
    let mut least: Option<Interval> = None;
    for part in &spectrum.eigenvalues {
        if !part.re.is_certainly_positive() {
            return None;
        }
        let gains = gains.map(|q| part.re.rational(&-q.clone()));
        let turn = modulus(&part.im.over(&part.re).ok()?).atan().ok()?;
        let phase = phase_of_mode(&gains, &(part.re.square() + part.im.square()), &turn).ok()?;
        least = Some(match least {
            None => phase,
            Some(other) => {
                let (lo, hi) = (other.lo().min(phase.lo()).clone(), other.hi().min(phase.hi()).clone());
                Interval::between(lo, hi, other.precision())
            }
        });
    }
    least.filter(Interval::is_certainly_positive).map(PhaseMargin::Enclosed)
}

/// `|x|`.
fn modulus(x: &Interval) -> Interval {
    match x.sign() {
        Some(Sign::Negative) => -x.clone(),
        Some(_) => x.clone(),
        None => Interval::between(x.zero().lo().clone(), x.magnitude(), x.precision()),
    }
}

fn searched(reduced: &RationalMatrix, gains: &[Gains<Rational>]) -> Option<PhaseMargin> {
    let turned = |angle: f64| turned_is_stable(reduced, gains, angle);
    let step = PI / f64::from(STEPS);
    let first = (1..=STEPS).map(|k| step * f64::from(k)).find(|angle| turned(*angle) != Some(true))?;
    let unstable = edge(first - step, first, turned)?;
    let tangent = Interval::from_rational(&half_tangent(unstable)?, PRECISION);
    Some(PhaseMargin::AtMost(tangent.atan().ok()?.scaled(1)))
}

/// An angle at which there is no stability, just beyond where it ends; nothing where enclosures leave that open.
fn edge(mut stable: f64, mut other: f64, is_stable: impl Fn(f64) -> Option<bool>) -> Option<f64> {
    const HALVINGS: u32 = 30;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (stable + other);
        if is_stable(middle) == Some(true) { stable = middle } else { other = middle }
    }
    // At the edge itself nothing can be told; beside it there has to be an answer.
    let beside = other + 1e-6 * (other - stable).signum();
    (is_stable(beside) == Some(false)).then_some(beside)
}

/// The rational number that stands for the tangent of half of this angle.
fn half_tangent(angle: f64) -> Option<Rational> {
    Rational::from_float((0.5 * angle).tan())
}

/// Whether all enclosed eigenvalues are on the left of the imaginary axis, or one on the right.
fn is_stable(rows: &[Vec<Rational>]) -> Option<bool> {
    let matrix = SparseMatrix::from_dense(&RationalMatrix::from_rows(rows).ok()?).ok()?;
    let spectrum = matrix_spectrum(&matrix, None).ok()?;
    let zero = rational(0, 1);
    let ends: Vec<(Rational, Rational)> = spectrum.eigenvalues.iter().map(|part| part.re.to_rationals()).collect();
    match () {
        () if ends.iter().all(|(_, hi)| *hi < zero) => Some(true),
        () if ends.iter().any(|(lo, _)| *lo > zero) => Some(false),
        () => None,
    }
}

/// All control turned by about this angle, exactly on the circle; `u + iv` as the pair `(u, v)`.
fn turned_is_stable(reduced: &RationalMatrix, gains: &[Gains<Rational>], angle: f64) -> Option<bool> {
    let t = half_tangent(angle)?;
    let (one, square) = (rational(1, 1), &t * &t);
    let (cos, sin) = ((&one - &square) / (&one + &square), rational(2, 1) * &t / (&one + &square));
    let rows: Vec<Vec<Rational>> = motion_rows_of_cars(reduced, |k| &gains[k]);
    let order = rows.len();
    let entry = |i: usize, j: usize| {
        let (own, value) = (i / order == j / order, &rows[i % order][j % order]);
        // Rates of positions are not control.
        match (i.is_multiple_of(2), own, i < order) {
            (true, true, _) => value.clone(),
            (true, false, _) => rational(0, 1),
            (false, true, _) => value * &cos,
            (false, false, true) => -(value * &sin),
            (false, false, false) => value * &sin,
        }
    };
    let all: Vec<Vec<Rational>> = (0..2 * order).map(|i| (0..2 * order).map(|j| entry(i, j)).collect()).collect();
    is_stable(&all)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One car with `f = g = -1`, whose margin is `atan w = 0.9046` with `w⁴ = 1 + w²`.
    #[test]
    fn one_car_turned() {
        let reduced = RationalMatrix::from_integers(&[[1]], 1).unwrap();
        let one = [Gains { f: rational(-1, 1), g: rational(-1, 1) }];
        assert_eq!(turned_is_stable(&reduced, &one, 0.9), Some(true));
        assert_eq!(turned_is_stable(&reduced, &one, 0.91), Some(false));
    }
}
