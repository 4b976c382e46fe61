//! Simple fractions.

use super::Rational;

/// The rational of the smallest denominator in `[lo, hi]`, and among these of the smallest size (Stern and Brocot).
pub fn simplest_between(lo: &Rational, hi: &Rational) -> Rational {
    let zero = Rational::ZERO;
    if *lo <= zero && zero <= *hi {
        return zero;
    }
    if *hi < zero {
        return -simplest_between(&-hi.clone(), &-lo.clone());
    }
    // A continued fraction: the common beginning of both ends, then the smallest integer that fits.
    let mut whole = Vec::new();
    let (mut a, mut b) = (lo.clone(), hi.clone());
    let last = loop {
        let floor = a.floor();
        if a == floor || floor.clone() + Rational::ONE <= b {
            break a.ceil();
        }
        whole.push(floor.clone());
        (a, b) = ((b - &floor).recip(), (a - floor).recip());
    };
    whole.into_iter().rev().fold(last, |below, term| term + below.recip())
}
