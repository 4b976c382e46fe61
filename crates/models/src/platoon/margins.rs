//! How far a platoon with equal gains is from instability: phase and gain margins of its modes, in floating point.
//!
//! With the reduced Laplacian `P`, `det(s² - (f + g s) P) = 0`. For an eigenvalue `lambda` of `P` the loop is
//! `L(iw) = lambda (|f| + i w |g|)/w²`, and the mode is on the verge where `L(iw) = 1`. The phase margin is the least angle by which all
//! control would have to be turned for that, the critical factor the one by which it would have to be multiplied.

use super::Gains;
use arithmetic::Complex;

/// Margins of all modes together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margins {
    /// The least `|arg L(iw)|` where `|L(iw)| = 1`, in radians.
    pub phase: f64,
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
        let before = all.unwrap_or(Margins { phase: f64::INFINITY, critical_factor: None });
        let critical_factor = match (before.critical_factor, factor) {
            (Some(a), Some(b)) => Some(a.max(b)),
            (a, b) => a.or(b),
        };
        all = Some(Margins { phase: before.phase.min(phase), critical_factor });
    }
    all
}
