//! Exact signs of expressions with square roots of rationals.

use super::{Rational, Ring, Sign, Signed};

fn exact_sign(x: &Rational) -> Sign {
    // A rational always has a sign.
    x.sign().unwrap_or(Sign::Zero)
}

/// The sign of `p + q sqrt(r)` for rational `p`, `q` and `r >= 0`, or `None` where `r < 0`.
pub fn sign_of_surd(p: &Rational, q: &Rational, r: &Rational) -> Option<Sign> {
    let root_part = match exact_sign(r) {
        Sign::Negative => return None,
        Sign::Zero => Sign::Zero,
        Sign::Positive => exact_sign(q),
    };
    let rational_part = exact_sign(p);
    Some(match (rational_part, root_part) {
        (a, Sign::Zero) => a,
        (Sign::Zero, b) => b,
        (a, b) if a == b => a,
        // Opposite signs: the part with the larger square wins.
        (a, _) => match exact_sign(&(p.square() - q.square() * r)) {
            Sign::Positive => a,
            Sign::Zero => Sign::Zero,
            Sign::Negative => a.negate(),
        },
    })
}

/// The sign of `sqrt(a) - sqrt(b) - c` for rational `a, b >= 0` and rational `c`, or `None` where `a < 0` or `b < 0`.
pub fn sign_of_square_root_difference(a: &Rational, b: &Rational, c: &Rational) -> Option<Sign> {
    if exact_sign(a) == Sign::Negative || exact_sign(b) == Sign::Negative {
        return None;
    }
    // Compare sqrt(a) with sqrt(b) + c.
    let one = c.one();
    match sign_of_surd(c, &one, b)? {
        Sign::Negative => Some(Sign::Positive),
        Sign::Zero => Some(exact_sign(a)),
        // Both sides are non-negative: compare a with b + c² + 2 c sqrt(b).
        Sign::Positive => sign_of_surd(&(a.clone() - b - c.square()), &(-(c.clone() + c)), b),
    }
}
