//! Whether all roots of a real polynomial have negative real parts, decided exactly (Routh's table).

use super::Polynomial;
use arithmetic::{Cancelled, Interval, Progress, Rational, Ring, Sign, Signed, Unwatched, content};
use num_bigint::BigInt;

/// Degrees from which enclosures are tried first: exact entries have as many digits as all coefficients together.
const LONG: usize = 24;

/// Bits of these enclosures.
const PRECISIONS: [u32; 3] = [256, 1024, 4096];

impl Polynomial {
    /// Whether every complex root has a negative real part. A constant other than zero has no roots; the zero polynomial is not
    /// stable. Cost: `degree²/2` products, of enclosures where these tell.
    pub fn is_hurwitz(&self) -> bool {
        self.is_hurwitz_watched(&Unwatched).unwrap_or_default()
    }

    /// [`Polynomial::is_hurwitz`], which can be stopped.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn is_hurwitz_watched(&self, progress: &dyn Progress) -> Result<bool, Cancelled> {
        // Where entries vanish, only exact ones tell.
        let vanishes = self.coefficients().first().is_none_or(|c| c.sign() == num_bigint::Sign::NoSign);
        if self.degree() >= LONG && !vanishes {
            for bits in PRECISIONS {
                let number = |c: &BigInt| Interval::from_rational(&Rational::from_integer(c.clone()), bits);
                let descending = self.coefficients().iter().rev().map(number).collect();
                if let Some(stable) = routh(descending, near_one, progress)? {
                    return Ok(stable);
                }
            }
        }
        let descending = self.coefficients().iter().rev().cloned().collect();
        Ok(routh(descending, without_content, progress)? == Some(true))
    }

    /// A positive multiple of the polynomial whose roots are these roots plus `shift`.
    pub fn with_roots_moved(&self, shift: &Rational) -> Self {
        let coefficients: Vec<Rational> = self.coefficients().iter().cloned().map(Rational::from_integer).collect();
        Polynomial::from_rationals(&roots_moved(&coefficients, shift))
    }
}

/// Whether every root of the real polynomial with these coefficients, the leading one first, has a negative real part; `None`
/// where the sign that decides is not known. `scaled` multiplies a row of the table by a positive number.
///
/// Routh: with a positive leading coefficient, this is so exactly where every entry of the first column of the table is
/// positive.
pub(super) fn routh<T: Ring + Signed>(
    mut descending: Vec<T>,
    scaled: impl Fn(Vec<T>) -> Vec<T>,
    progress: &dyn Progress,
) -> Result<Option<bool>, Cancelled> {
    match descending.first().and_then(Signed::sign) {
        Some(Sign::Positive) => {}
        Some(Sign::Negative) => descending.iter_mut().for_each(|c| *c = -c.clone()),
        Some(Sign::Zero) | None => return Ok(None),
    }
    let every_other = |start: usize| descending.iter().skip(start).step_by(2).cloned().collect::<Vec<_>>();
    let (mut upper, mut lower) = (every_other(0), every_other(1));
    // The first entry of the upper row is positive.
    while let Some(bottom) = lower.first() {
        progress.checkpoint()?;
        match bottom.sign() {
            Some(Sign::Positive) => {}
            Some(_) => return Ok(Some(false)),
            None => return Ok(None),
        }
        // Scaling a row by a positive number does not change the signs.
        let entry = |k: usize| {
            let product = bottom.clone() * &upper[k];
            lower.get(k).map_or_else(|| product.clone(), |below| product.clone() - upper[0].clone() * below)
        };
        let next = scaled((1..upper.len()).map(entry).collect());
        upper = std::mem::replace(&mut lower, next);
    }
    Ok(Some(true))
}

/// The coefficients, constant one first, of `p(x - shift)`, whose roots are those of `p` plus `shift`.
pub(super) fn roots_moved<T: Ring>(coefficients: &[T], shift: &T) -> Vec<T> {
    // Horner's rule.
    let mut moved: Vec<T> = Vec::new();
    for c in coefficients.iter().rev() {
        let mut next = vec![shift.zero(); moved.len() + 1];
        for (k, x) in moved.iter().enumerate() {
            next[k + 1] = next[k + 1].clone() + x;
            next[k] = next[k].clone() - x.clone() * shift;
        }
        next[0] = next[0].clone() + c;
        moved = next;
    }
    moved
}

/// The row times a power of two, so that the exponents, which double from row to row, stay small.
fn near_one(row: Vec<Interval>) -> Vec<Interval> {
    let top = row.iter().map(Interval::magnitude).filter(|size| size.is_positive()).map(|size| size.top()).max();
    row.iter().map(|x| x.scaled(-top.unwrap_or(0))).collect()
}

/// The row divided by the greatest common divisor of its entries.
fn without_content(mut row: Vec<BigInt>) -> Vec<BigInt> {
    let content = content(&row);
    if content > BigInt::from(1) {
        row.iter_mut().for_each(|c| *c /= &content);
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `(s² + 4s + 100)^100`, and with a factor `s² - s/1000 + 1`: exponents of the table double from row to row.
    #[test]
    fn long_polynomials_are_decided() {
        let times = |a: &[BigInt], b: [i64; 3]| {
            let mut all = vec![BigInt::ZERO; a.len() + 2];
            a.iter().enumerate().for_each(|(i, x)| (0..3).for_each(|j| all[i + j] += x * b[j]));
            all
        };
        let power = (0..100).fold(vec![BigInt::from(1)], |all, _| times(&all, [100, 4, 1]));
        assert!(Polynomial::new(power.clone()).is_hurwitz());
        assert!(!Polynomial::new(times(&power, [1000, -1, 1000])).is_hurwitz());
    }
}
