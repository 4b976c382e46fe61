//! The first place at which a polynomial falls to zero.

use super::root;

/// Halvings of the interval after which a touch within rounding is no fall.
const MOST_HALVINGS: u32 = 40;

/// The polynomial in `x - shift`: coefficients of `p(shift + x)`, lowest first.
#[inline(always)]
pub fn shifted<const N: usize>(coefficients: &[f64; N], shift: f64) -> [f64; N] {
    let mut all = *coefficients;
    for i in 0..N.saturating_sub(1) {
        for k in (i..N - 1).rev() {
            all[k] += shift * all[k + 1];
        }
    }
    all
}

/// `p(x)`, coefficients lowest first.
#[inline(always)]
pub fn value_at(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// The first `x` in `(0, length]` at which a polynomial that is positive at 0, or zero there and rises, falls to zero; coefficients lowest
/// first. A polynomial that is zero or less at 0 and does not rise is at its fall already: `Some(0)`.
///
/// No fall is passed over: an interval is left only where the sizes of the coefficients around its middle keep the polynomial from zero, or
/// where it has one sign of slope and does not cross. Two roots that no `2^-40` of the length separates count as none.
pub fn first_downcrossing<const N: usize>(coefficients: &[f64; N], length: f64) -> Option<f64> {
    let mut rest = *coefficients;
    if rest[0] <= 0.0 {
        // The first coefficient that is not zero has the sign just after.
        rest[0] = 0.0;
        let place = rest.iter().position(|c| *c != 0.0)?;
        if rest[place] < 0.0 {
            return Some(0.0);
        }
        rest.rotate_left(place);
    }
    let scale = |(k, c): (usize, &f64)| c * length.powi(k as i32);
    let scaled: Vec<f64> = rest.iter().enumerate().map(scale).collect();
    let mut unit = [0.0; N];
    unit.copy_from_slice(&scaled);
    search(&unit, 0.0, 1.0, 0).map(|x| x * length)
}

/// The first fall in an interval of which the beginning is positive.
fn search<const N: usize>(p: &[f64; N], from: f64, to: f64, halvings: u32) -> Option<f64> {
    let (middle, half) = (from.midpoint(to), (to - from) / 2.0);
    let around = shifted(p, middle);
    let size = |from: usize| around[from..].iter().rev().fold(0.0, |sum: f64, c| sum * half + c.abs()) * half;
    if around[0] > size(1) {
        return None;
    }
    // The slope has one sign.
    let slopes: f64 = (2..N).rev().fold(0.0, |sum, k| sum * half + k as f64 * around[k].abs()) * half;
    if around[1].abs() > slopes || halvings == MOST_HALVINGS {
        let falls = around[1] < 0.0 && value_at(p, to) <= 0.0;
        return falls.then(|| root(from, to, false, |x| value_at(p, x)));
    }
    if value_at(p, middle) > 0.0 {
        search(p, from, middle, halvings + 1).or_else(|| search(p, middle, to, halvings + 1))
    } else {
        search(p, from, middle, halvings + 1)
    }
}
