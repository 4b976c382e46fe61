//! The numbers of a motion: where they stand in its start, and their enclosures between floats, in which motions are followed, and between longer
//! numbers, in which states are measured.

use arithmetic::{Dyadic, FloatInterval, Interval, Rational};

/// Which list of the start.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Start {
    Positions,
    Velocities,
    Phases,
    /// A part of the state of a law of one's own.
    Own(String),
}

/// Bits of what is measured.
pub(super) const BITS: u32 = 64;

/// The narrowest floats around a rational.
pub(super) fn point(q: &Rational) -> FloatInterval {
    FloatInterval::from_rational(q)
}

/// The same enclosure with long ends, for what is measured.
pub(super) fn widened(x: &FloatInterval) -> Interval {
    let end = |x: f64| Dyadic::from_f64(x);
    match (end(x.lo()), end(x.hi())) {
        (Some(lo), Some(hi)) => Interval::between(lo, hi, BITS),
        _ => {
            // Unbounded: nothing is known.
            let far = Dyadic::new(1.into(), 4096);
            Interval::between(far.negated(), far, BITS)
        }
    }
}

/// An enclosure between floats: the ends themselves where they are floats.
pub(super) fn narrowed(x: &Interval) -> FloatInterval {
    let is_float = |end: &Dyadic| Dyadic::from_f64(end.to_f64()).is_some_and(|float| float == *end);
    match is_float(x.lo()) && is_float(x.hi()) {
        true => FloatInterval::between(x.lo().to_f64(), x.hi().to_f64()),
        false => FloatInterval::from_interval(x),
    }
}
