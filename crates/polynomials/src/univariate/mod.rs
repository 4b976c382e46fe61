//! Integer polynomials in one variable: exact signs, common divisors, real roots isolated by Sturm's theorem.

mod abscissa;
mod bernstein;
mod largest;
mod nearest;
mod stability;

pub use abscissa::{complex_abscissa, roots_are_left_of};
pub use largest::{Largest, LargestError, Place, largest_quotient};
pub use nearest::Nearest;

use arithmetic::{Cancelled, Interval, Progress, Rational, Ring, Unwatched, common_denominator, content, rational};
use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_traits::{Signed, Zero};

/// A polynomial with integer coefficients without a common factor, the constant one first, the last one not zero. The zero
/// polynomial has none.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Polynomial {
    coefficients: Vec<BigInt>,
}

/// A simple real root: `lo < root < hi`, or `lo = root = hi`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RealRoot {
    lo: Rational,
    hi: Rational,
}

impl Polynomial {
    /// The primitive multiple of a polynomial with these coefficients, the constant one first.
    pub fn new(mut coefficients: Vec<BigInt>) -> Self {
        while coefficients.last().is_some_and(Zero::is_zero) {
            coefficients.pop();
        }
        let content = content(&coefficients);
        if content > BigInt::from(1) {
            coefficients.iter_mut().for_each(|c| *c /= &content);
        }
        Polynomial { coefficients }
    }

    /// The primitive multiple of a polynomial with rational coefficients.
    pub fn from_rationals(coefficients: &[Rational]) -> Self {
        let denominator = common_denominator(coefficients);
        Polynomial::new(coefficients.iter().map(|c| c.numer() * (&denominator / c.denom())).collect())
    }

    /// The coefficients, the constant one first.
    pub fn coefficients(&self) -> &[BigInt] {
        &self.coefficients
    }

    /// The degree; 0 for constants and for the zero polynomial.
    pub fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// Whether it is the zero polynomial.
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The derivative, up to a positive factor.
    pub fn derivative(&self) -> Self {
        Polynomial::new(self.coefficients.iter().enumerate().skip(1).map(|(k, c)| c * k).collect())
    }

    /// The exact value.
    pub fn at(&self, x: &Rational) -> Rational {
        self.coefficients.iter().rev().fold(x.zero(), |sum, c| sum * x + Rational::from_integer(c.clone()))
    }

    /// An enclosure of the values on an interval.
    pub fn enclose(&self, x: &Interval) -> Interval {
        let constant = |c: &BigInt| Interval::from_rational(&Rational::from_integer(c.clone()), x.precision());
        self.coefficients.iter().rev().fold(x.zero(), |sum, c| sum * x + constant(c))
    }

    /// -1, 0 or 1: the sign at a rational.
    pub(crate) fn sign_at(&self, x: &Rational) -> i8 {
        let (p, q) = (&x.numer(), &x.denom());
        // q^degree f(p/q) by Horner's rule.
        let mut power = BigInt::from(1);
        let mut sum = BigInt::ZERO;
        for c in self.coefficients.iter().rev() {
            sum = sum * p + c * &power;
            power *= q;
        }
        match sum.sign() {
            Sign::Minus => -1,
            Sign::NoSign => 0,
            Sign::Plus => 1,
        }
    }

    /// How often `x - root` divides it, and what is left.
    pub fn without_root(&self, root: i64) -> (usize, Self) {
        let mut rest = self.clone();
        let mut times = 0;
        while !rest.is_zero() && rest.at(&rational(root, 1)).is_zero() {
            // Synthetic division.
            let mut quotient = vec![BigInt::ZERO; rest.degree()];
            let mut carry = BigInt::ZERO;
            for k in (1..rest.coefficients.len()).rev() {
                carry = carry * root + &rest.coefficients[k];
                quotient[k - 1] = carry.clone();
            }
            rest = Polynomial::new(quotient);
            times += 1;
        }
        (times, rest)
    }

    /// The remainder on division by another polynomial, times a positive number.
    fn positive_remainder(&self, divisor: &Self) -> Self {
        let mut rest = self.coefficients.clone();
        let Some(lead) = divisor.coefficients.last() else { return Polynomial::new(rest) };
        let size = lead.abs();
        while rest.len() >= divisor.coefficients.len() {
            let Some(top) = rest.pop() else { break };
            let shift = rest.len() + 1 - divisor.coefficients.len();
            let factor = if lead.is_negative() { -&top } else { top };
            rest.iter_mut().for_each(|c| *c *= &size);
            for (k, c) in divisor.coefficients.iter().enumerate().take(divisor.degree()) {
                rest[shift + k] -= c * &factor;
            }
        }
        Polynomial::new(rest)
    }

    /// The greatest common divisor, up to a factor.
    pub fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.clone(), other.clone());
        while !b.is_zero() {
            let rest = a.positive_remainder(&b);
            (a, b) = (b, rest);
        }
        a
    }

    /// The quotient by a divisor that is not zero, up to a factor; what remains is dropped.
    pub fn divided_by(&self, divisor: &Self) -> Self {
        let Some(lead) = divisor.coefficients.last() else { return self.clone() };
        let mut rest = self.coefficients.clone();
        let mut quotient = vec![BigInt::ZERO; (rest.len() + 1).saturating_sub(divisor.coefficients.len())];
        while rest.len() >= divisor.coefficients.len() {
            let Some(top) = rest.pop() else { break };
            let shift = rest.len() + 1 - divisor.coefficients.len();
            rest.iter_mut().for_each(|c| *c *= lead);
            quotient.iter_mut().for_each(|c| *c *= lead);
            for (k, c) in divisor.coefficients.iter().enumerate().take(divisor.degree()) {
                rest[shift + k] -= c * &top;
            }
            quotient[shift] = top;
        }
        Polynomial::new(quotient)
    }

    /// Polynomials without multiple roots and without common roots, each with how often it divides this one (which must
    /// not be zero); constants are left out. By repeated division by greatest common divisors (Musser 1975).
    pub fn square_free_factors(&self) -> Vec<(Self, usize)> {
        let mut repeated = self.gcd(&self.derivative());
        let mut left = self.divided_by(&repeated);
        let mut factors = Vec::new();
        for times in 1.. {
            if left.degree() == 0 {
                break;
            }
            let common = left.gcd(&repeated);
            let factor = left.divided_by(&common);
            if factor.degree() > 0 {
                factors.push((factor, times));
            }
            repeated = repeated.divided_by(&common);
            left = common;
        }
        factors
    }

    /// Sturm's chain: the polynomial, its derivative, and the negated remainders.
    fn sturm_chain(&self, progress: &dyn Progress) -> Result<Vec<Self>, Cancelled> {
        let mut chain = vec![self.clone(), self.derivative()];
        while chain.last().is_some_and(|last| last.degree() > 0) {
            progress.checkpoint()?;
            let rest = chain[chain.len() - 2].positive_remainder(&chain[chain.len() - 1]);
            if rest.is_zero() {
                break;
            }
            chain.push(Polynomial { coefficients: rest.coefficients.into_iter().map(|c| -c).collect() });
        }
        chain.retain(|p| !p.is_zero());
        Ok(chain)
    }

    /// The rational root `p/lead` inside the enclosure of a root, where `lead` is the leading coefficient: the enclosure
    /// is refined until it holds only one such number. `None` where the root is irrational.
    pub fn rational_root(&self, root: &mut RealRoot) -> Option<Rational> {
        let lead = self.coefficients.last()?.abs();
        self.refine(root, lead.bits() as u32 + 1);
        let lead = Rational::from_integer(lead);
        let candidate = (&root.hi * &lead).floor() / lead;
        (root.lo <= candidate && self.sign_at(&candidate) == 0).then_some(candidate)
    }

    /// Whether it has no multiple root, real or complex.
    pub fn is_square_free(&self) -> bool {
        // Nobody stops it.
        self.is_square_free_watched(&Unwatched).unwrap_or_default()
    }

    /// As [`Polynomial::is_square_free`], until `progress` stops it.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn is_square_free_watched(&self, progress: &dyn Progress) -> Result<bool, Cancelled> {
        Ok(self.sturm_chain(progress)?.last().is_some_and(|last| last.degree() == 0))
    }

    /// The real roots in `(lo, hi]` of a polynomial without multiple roots, in order, each isolated.
    pub fn roots_in(&self, lo: &Rational, hi: &Rational) -> Vec<RealRoot> {
        // Nobody stops it.
        self.roots_in_watched(lo, hi, &Unwatched).unwrap_or_default()
    }

    /// As [`Polynomial::roots_in`], until `progress` stops it.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn roots_in_watched(
        &self,
        lo: &Rational,
        hi: &Rational,
        progress: &dyn Progress,
    ) -> Result<Vec<RealRoot>, Cancelled> {
        let chain = self.sturm_chain(progress)?;
        let mut found = Vec::new();
        isolate(&chain, lo.clone(), hi.clone(), &mut found, progress)?;
        Ok(found)
    }

    /// Shrinks the enclosure of a root until it is at most `2^-bits` wide, and no further where it is: by halving, and where the ends are dyadic by
    /// quadratic refinement (Abbott 2014), which squares the width at each success.
    pub fn refine(&self, root: &mut RealRoot, bits: u32) {
        let width = Rational::new(BigInt::from(1), BigInt::from(1) << bits);
        let at_hi = self.sign_at(&root.hi);
        if at_hi == 0 {
            root.lo.clone_from(&root.hi);
        }
        // Each division splits the enclosure into 2^cells parts.
        let mut cells = 2;
        while &root.hi - &root.lo > width {
            if cells > 2 && self.refine_by_chord(root, cells) {
                // No finer than asked for.
                let left = (&root.hi - &root.lo) / &width;
                let needed = (left.numer().bits() + 1).saturating_sub(left.denom().bits());
                cells = (2 * cells).min(u32::try_from(needed).unwrap_or(u32::MAX).max(4));
                continue;
            }
            cells = (cells / 2).max(2);
            for _ in 0..2 {
                let middle = (&root.lo + &root.hi) / rational(2, 1);
                match self.sign_at(&middle) {
                    0 => (root.lo, root.hi) = (middle.clone(), middle),
                    sign if sign == at_hi => root.hi = middle,
                    _ => root.lo = middle,
                }
            }
            if cells == 2 {
                cells = 4;
            }
        }
    }

    /// Tries the part, of `2^cells` equal ones, that the chord points to; keeps it if the root is there.
    fn refine_by_chord(&self, root: &mut RealRoot, cells: u32) -> bool {
        let (at_lo, at_hi) = (self.leading_value(&root.lo, cells), self.leading_value(&root.hi, cells));
        let (Some((low, low_shift)), Some((high, high_shift))) = (at_lo, at_hi) else { return false };
        // Both as integers with the smaller exponent.
        let least = low_shift.min(high_shift);
        if low_shift.abs_diff(high_shift) > u64::from(cells) + 64 {
            return false;
        }
        let (low, high) = (low << (low_shift - least) as u64, high << (high_shift - least) as u64);
        let fall = &low - &high;
        if fall.is_zero() {
            return false;
        }
        let place = ((low << cells).div_floor(&fall)).clamp(BigInt::ZERO, (BigInt::from(1) << cells) - 1);
        let step = (&root.hi - &root.lo) / Rational::from_integer(BigInt::from(1) << cells);
        let lo = &root.lo + &step * Rational::from_integer(place);
        let hi = &lo + step;
        let (at_lo, at_hi) = (self.sign_at(&lo), self.sign_at(&hi));
        if at_lo == 0 {
            (root.lo, root.hi) = (lo.clone(), lo);
        } else if at_hi == 0 {
            (root.lo, root.hi) = (hi.clone(), hi);
        } else if at_lo != at_hi {
            (root.lo, root.hi) = (lo, hi);
        } else {
            return false;
        }
        true
    }

    /// The value at a dyadic number as `m 2^e`, with a few more bits than `bits` in `m`; `None` at other numbers. Only the
    /// choice of the part to try depends on it.
    fn leading_value(&self, x: &Rational, bits: u32) -> Option<(BigInt, i64)> {
        let scale = x.denom().trailing_zeros()?;
        if x.denom() != (BigInt::from(1) << scale) {
            return None;
        }
        // 2^(scale degree) f(x).
        let mut sum = BigInt::ZERO;
        for (k, c) in self.coefficients.iter().rev().enumerate() {
            sum = sum * x.numer() + (c << (scale * k as u64));
        }
        let cut = sum.bits().saturating_sub(u64::from(bits) + 64);
        Some((sum >> cut, cut as i64 - (scale * self.degree() as u64) as i64))
    }
}

/// Sign changes of a Sturm chain at `x`.
fn changes(chain: &[Polynomial], x: &Rational) -> usize {
    let signs: Vec<i8> = chain.iter().map(|p| p.sign_at(x)).filter(|&s| s != 0).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

fn isolate(
    chain: &[Polynomial],
    lo: Rational,
    hi: Rational,
    found: &mut Vec<RealRoot>,
    progress: &dyn Progress,
) -> Result<(), Cancelled> {
    progress.checkpoint()?;
    match changes(chain, &lo).saturating_sub(changes(chain, &hi)) {
        0 => {}
        // The sign at `lo` has to differ from that at `hi` for later halving.
        1 if chain[0].sign_at(&hi) == 0 => found.push(RealRoot { lo: hi.clone(), hi }),
        1 if chain[0].sign_at(&lo) != 0 => found.push(RealRoot { lo, hi }),
        _ => {
            let middle = (&lo + &hi) / rational(2, 1);
            isolate(chain, lo, middle.clone(), found, progress)?;
            isolate(chain, middle, hi, found, progress)?;
        }
    }
    Ok(())
}

impl RealRoot {
    /// The root of a polynomial that has exactly one between two numbers, neither of which is one, and changes its sign there.
    pub(crate) fn between(lo: Rational, hi: Rational) -> Self {
        RealRoot { lo, hi }
    }

    /// The enclosure.
    pub fn enclosure(&self, precision: u32) -> Interval {
        Interval::hull_of_rationals(&self.lo, &self.hi, precision)
    }

    /// The root itself where it was met exactly.
    pub fn exact(&self) -> Option<&Rational> {
        (self.lo == self.hi).then_some(&self.lo)
    }

    /// A lower bound.
    pub fn lo(&self) -> &Rational {
        &self.lo
    }

    /// An upper bound.
    pub fn hi(&self) -> &Rational {
        &self.hi
    }
}

#[cfg(test)]
mod tests;
