//! Sines and cosines of fractions of a turn in floats, with a proved error.
//!
//! **Bound.** For integers `0 <= p <= q < 2^53` let `x = (pi/4)(p/q)`. Its float has three relative roundings: the quotient and the
//! product (`u` each) and `pi/4` (`0.36 u`, from its next digits). As `x cot x <= 1` and `x tan x <= 0.79`, that moves `sin x`
//! by less than `2.37 u` and `cos x` by less than `1.87 u`, relatively. Taylor's series are cut after `x^17` and `x^16`, which
//! leaves out less than `0.001 u` and `0.03 u`. In Horner's rule for the tails the terms fall by factors above 12, so the tails have
//! errors below `6 u`; they are at most `0.103` of the sine and `0.42` of the cosine. With the last rounding (`u` each) the
//! errors are below `4 u` and `5.5 u`.

use super::float_bounds::UNIT;
use std::f64::consts::FRAC_PI_4;

/// Bound of the relative error of [`sine`], [`cosine`] and both parts of [`root_of_unity`], and so of the latter itself.
pub(super) const ROOT_ERROR: f64 = 5.5 * UNIT;

/// `sin (pi/4)(p/q)` for `0 <= p <= q`.
#[inline(always)]
pub(super) fn sine(p: f64, q: f64) -> f64 {
    let x = FRAC_PI_4 * (p / q);
    let y = x * x;
    let tail = 1.0 / 6_227_020_800.0 + y * (-1.0 / 1_307_674_368_000.0 + y * (1.0 / 355_687_428_096_000.0));
    let tail = -1.0 / 5040.0 + y * (1.0 / 362_880.0 + y * (-1.0 / 39_916_800.0 + y * tail));
    let tail = -1.0 / 6.0 + y * (1.0 / 120.0 + y * tail);
    x + x * (y * tail)
}

/// `cos (pi/4)(p/q)` for `0 <= p <= q`.
#[inline(always)]
pub(super) fn cosine(p: f64, q: f64) -> f64 {
    let x = FRAC_PI_4 * (p / q);
    let y = x * x;
    let tail = 1.0 / 479_001_600.0 + y * (-1.0 / 87_178_291_200.0 + y * (1.0 / 20_922_789_888_000.0));
    let tail = -1.0 / 720.0 + y * (1.0 / 40_320.0 + y * (-1.0 / 3_628_800.0 + y * tail));
    let tail = -0.5 + y * (1.0 / 24.0 + y * tail);
    1.0 + y * tail
}

/// `1 - cos(2 pi k/n) = 2 sin² (pi k/n)` for `2k <= n`, within [`CHORD_ERROR`] relatively.
#[inline(always)]
pub(super) fn chord(k: f64, n: f64) -> f64 {
    let half = if 4.0 * k <= n { sine(4.0 * k, n) } else { cosine(2.0 * n - 4.0 * k, n) };
    2.0 * (half * half)
}

/// Two factors and a product.
pub(super) const CHORD_ERROR: f64 = 2.0 * ROOT_ERROR + 1.5 * UNIT;

/// Real and imaginary part of `e^(2 pi i k/n)` for `k < n < 2^50`.
pub(super) fn root_of_unity(k: u64, n: u64) -> (f64, f64) {
    let (eighth, rest) = (8 * k / n, 8 * k % n);
    let (p, q) = (if eighth % 2 == 0 { rest } else { n - rest } as f64, n as f64);
    let (cos, sin) = (cosine(p, q), sine(p, q));
    match eighth {
        0 => (cos, sin),
        1 => (sin, cos),
        2 => (-sin, cos),
        3 => (-cos, sin),
        4 => (-cos, -sin),
        5 => (-sin, -cos),
        6 => (sin, -cos),
        _ => (cos, -sin),
    }
}
