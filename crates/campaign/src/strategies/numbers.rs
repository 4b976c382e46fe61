//! Numbers.

use crate::draws::Draws;
use arithmetic::{Rational, rational};

/// An integer from `-most` to `most`; simplest are 0, 1, -1, 2, ..
pub fn integer(draws: &mut Draws, most: u64) -> i64 {
    let value = draws.below(2 * most + 1) as i64;
    if value % 2 == 1 { (value + 1) / 2 } else { -value / 2 }
}

/// `p/q` with `|p| <= most` and `1 <= q <= denominator`.
pub fn fraction(draws: &mut Draws, most: u64, denominator: u64) -> Rational {
    let p = integer(draws, most);
    rational(p, 1 + draws.below(denominator) as i64)
}

/// `p/q` with `1 <= p <= most` and `1 <= q <= denominator`.
pub fn positive(draws: &mut Draws, most: u64, denominator: u64) -> Rational {
    let p = 1 + draws.below(most) as i64;
    rational(p, 1 + draws.below(denominator) as i64)
}
