//! How far a platoon is from instability: the phase margin, in floating point; and the critical factor of the modes of equal gains. The gain margin that is
//! decided is in [`super::gain_margin`].
//!
//! With the reduced Laplacian `P`, `det(s² - (f + g s) P) = 0`. For an eigenvalue `lambda` of `P` the loop is
//! `L(iw) = lambda (|f| + i w |g|)/w²`, and the mode is on the verge where `L(iw) = 1`. The phase margin is the least angle by which all
//! control would have to be turned for that, the critical factor the one by which it would have to be multiplied.

//!
//! Where each car has its own gains there are no such loops. There all control is turned by one angle after the other, and
//! stability is read off enclosed eigenvalues of `x' = A x`; the margin is where it ends, found by bisection.

use super::Gains;
use super::vector_form::motion_rows_of_cars;
use algebra::matrix::{RationalMatrix, SparseMatrix};
use algebra::spectrum::matrix_spectrum;
use arithmetic::{ArithmeticError, Complex, Rational, rational};
use std::f64::consts::PI;

/// Margins of all modes together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margins {
    /// The least angle, in radians, by which all control has to be turned for a mode to be on the verge: the least `|arg L(iw)|` where
    /// `|L(iw)| = 1`.
    pub phase: Option<f64>,
    /// The largest factor by which both gains may be multiplied so that a mode is on the verge; a stable platoon is stable for every
    /// larger factor. Nothing where no factor does that, as for real eigenvalues.
    pub critical_factor: Option<f64>,
}

/// The margins of the modes with these eigenvalues of `P`, for negative gains; nothing without eigenvalues other than 0.
pub fn margins(gains: &Gains<f64>, eigenvalues: &[Complex<f64>]) -> Option<Margins> {
    let (f, g) = (gains.f.abs(), gains.g.abs());
    let mut all: Option<Margins> = None;
    for lambda in eigenvalues {
        let (size, angle) = (lambda.re.hypot(lambda.im), lambda.im.atan2(lambda.re));
        if size == 0.0 {
            continue;
        }
        // |L| = 1: w^4 = size² (f² + g² w²).
        let half = size * size * g * g / 2.0;
        let crossing = (half + (half * half + size * size * f * f).sqrt()).sqrt();
        // Of a pair of conjugate eigenvalues the one with the negative angle comes closer.
        let phase = ((crossing * g / f).atan() - angle.abs()).abs();
        // L is positive where atan(w g/f) = -angle.
        let verge = angle.abs().tan() * f / g;
        let factor = (angle != 0.0 && angle.abs() < std::f64::consts::FRAC_PI_2)
            .then(|| verge * verge / (size * f.hypot(verge * g)));
        let before = all.unwrap_or(Margins { phase: None, critical_factor: None });
        let critical_factor = match (before.critical_factor, factor) {
            (Some(a), Some(b)) => Some(a.max(b)),
            (a, b) => a.or(b),
        };
        all = Some(Margins { phase: Some(before.phase.map_or(phase, |least| least.min(phase))), critical_factor });
    }
    all
}

/// The phase margin where follower `k` has the gains `gains[k - 1]`, below zero, and the reduced Laplacian is `reduced`. Angles are tried in steps of
/// pi/32: what is stable again between two of them is passed over. Nothing where the cars are not stable, or enclosures do not tell.
///
/// # Errors
/// [`ArithmeticError::Domain`] where there are not as many gains as rows and columns of `reduced`.
pub fn phase_margin_of_cars(
    reduced: &RationalMatrix,
    gains: &[Gains<Rational>],
) -> Result<Option<f64>, ArithmeticError> {
    if [reduced.rows(), reduced.cols()] != [gains.len(); 2] {
        return Err(ArithmeticError::Domain("gains for each follower"));
    }
    const STEPS: i32 = 32;
    let turned = |angle: f64| turned_is_stable(reduced, gains, angle);
    let first = (0..=STEPS).map(|k| PI * f64::from(k) / f64::from(STEPS)).find(|angle| turned(*angle) != Some(true));
    let phase = first.filter(|angle| *angle > 0.0);
    Ok(phase.and_then(|angle| edge(angle - PI / f64::from(STEPS), angle, turned)))
}

/// Where stability ends between a number with and one without; nothing where enclosures leave that open.
fn edge(mut stable: f64, mut other: f64, is_stable: impl Fn(f64) -> Option<bool>) -> Option<f64> {
    const HALVINGS: u32 = 30;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (stable + other);
        if is_stable(middle) == Some(true) { stable = middle } else { other = middle }
    }
    // At the edge itself nothing can be told; beside it there has to be an answer.
    let beside = other + 1e-6 * (other - stable).signum();
    (is_stable(beside) == Some(false)).then_some(0.5 * (stable + other))
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
    let t = Rational::from_float((0.5 * angle).tan())?;
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
