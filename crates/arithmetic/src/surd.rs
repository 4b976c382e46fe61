//! Exact signs of expressions with square roots, over integers or rationals.

use super::{Sign, Signed};

/// The sign of `p + q sqrt(r)` for `r >= 0`, or `None` where `r < 0` (or a sign is not decided).
pub fn sign_of_surd<T: Signed>(p: &T, q: &T, r: &T) -> Option<Sign> {
    let root_part = match r.sign()? {
        Sign::Negative => return None,
        Sign::Zero => Sign::Zero,
        Sign::Positive => q.sign()?,
    };
    let rational_part = p.sign()?;
    Some(match (rational_part, root_part) {
        (a, Sign::Zero) => a,
        (Sign::Zero, b) => b,
        (a, b) if a == b => a,
        // Opposite signs: the part with the larger square wins.
        (a, _) => match (p.square() - q.square() * r).sign()? {
            Sign::Positive => a,
            Sign::Zero => Sign::Zero,
            Sign::Negative => a.negate(),
        },
    })
}

/// The sign of `sqrt(a) - sqrt(b) - c` for `a, b >= 0`, or `None` where `a < 0` or `b < 0` (or a sign is not decided).
pub fn sign_of_square_root_difference<T: Signed>(a: &T, b: &T, c: &T) -> Option<Sign> {
    if a.sign()? == Sign::Negative {
        return None;
    }
    // Compare sqrt(a) with sqrt(b) + c, which has no sign where b < 0.
    let one = c.one();
    match sign_of_surd(c, &one, b)? {
        Sign::Negative => Some(Sign::Positive),
        Sign::Zero => a.sign(),
        // Both sides are non-negative: compare a with b + c² + 2 c sqrt(b).
        Sign::Positive => sign_of_surd(&(a.clone() - b - c.square()), &(-(c.clone() + c)), b),
    }
}
