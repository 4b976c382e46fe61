//! Rational sequences that obey a linear recurrence: the shortest recurrence, and the sign in the long run.
//!
//! A sequence whose characteristic roots are 0, 1 (any multiplicity) and simple ones in (0, 1) is
//! `f(r) = p(r) + sum_k c_k rho_k^r` from some `r` on, `p` a polynomial. The shortest recurrence has no root whose coefficient
//! vanishes, so that enclosures settle the sign of the leading term.

use super::Polynomial;
use arithmetic::{
    ArithmeticError, Cancelled, Field, Interval, Number, Progress, Rational, Ring, Sign, Signed, rational,
};
use num_bigint::BigInt;
use num_traits::{Signed as _, ToPrimitive, Zero};

/// A sequence with its shortest recurrence.
#[derive(Debug, Clone)]
pub struct Recurrence {
    /// Monic characteristic polynomial, the constant coefficient first.
    characteristic: Vec<Rational>,
    /// The first terms.
    terms: Vec<Rational>,
}

/// Why the sign in the long run is not decided.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RecurrenceError {
    /// More terms are needed for the order of the recurrence.
    #[error("{terms} terms do not determine a recurrence of order {order}")]
    TooFewTerms {
        /// Terms given.
        terms: usize,
        /// Order found.
        order: usize,
    },
    /// Complex, negative, multiple or large roots.
    #[error("a characteristic root is complex, negative, multiple or above 1")]
    Roots,
    /// Refinement did not end.
    #[error("enclosures of {0} bits do not separate the leading terms")]
    Precision(u32),
    /// An interval operation without a result.
    #[error(transparent)]
    Arithmetic(#[from] ArithmeticError),
    /// Stopped by the caller.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// A sign that a sequence keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Eventual {
    /// The sign.
    pub sign: Sign,
    /// It holds from this index on (not necessarily the first such).
    pub from: u64,
}

/// Sign and size of one term far out.
#[derive(Debug, Clone)]
pub struct Leading {
    /// The sign; never zero.
    pub sign: Sign,
    /// An enclosure of the binary logarithm of the absolute value.
    pub log2: Interval,
}

/// Precisions that are tried, in bits.
const PRECISIONS: [u32; 5] = [128, 256, 1024, 4096, 16384];

/// `f(r) = polynomial(r) + sum of coefficient root^r` for `r >= start`.
struct ExponentialSum {
    start: u64,
    /// Coefficients of the powers of `r`.
    polynomial: Vec<Rational>,
    /// By decreasing root.
    terms: Vec<(Interval, Interval)>,
}

impl Recurrence {
    /// The shortest recurrence of a sequence that is known to obey one of order at most half the number of terms given.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn new(terms: Vec<Rational>, progress: &dyn Progress) -> Result<Self, Cancelled> {
        Ok(Recurrence { characteristic: shortest(&terms, progress)?, terms })
    }

    /// The order.
    pub fn order(&self) -> usize {
        self.characteristic.len() - 1
    }

    /// Whether the sequence is zero throughout.
    pub fn is_zero(&self) -> bool {
        self.order() == 0
    }

    /// The sign in the long run, and from where on it is certain.
    ///
    /// # Errors
    /// [`RecurrenceError`].
    pub fn eventual_sign(&self, progress: &dyn Progress) -> Result<Eventual, RecurrenceError> {
        self.with_precision(progress, |sum| {
            if sum.polynomial.is_empty() && sum.terms.is_empty() {
                return Ok(Some(Eventual { sign: Sign::Zero, from: sum.start }));
            }
            let mut from = sum.start.max(1);
            for _ in 0..64 {
                if let Some(sign) = sum.sign_from(from)? {
                    return Ok(Some(Eventual { sign, from }));
                }
                from *= 2;
            }
            Ok(None)
        })
    }

    /// Sign and size of the term `r`, which must be far out; `None` where it is zero.
    ///
    /// # Errors
    /// [`RecurrenceError`].
    pub fn leading(&self, r: &BigInt, progress: &dyn Progress) -> Result<Option<Leading>, RecurrenceError> {
        if self.is_zero() {
            return Ok(None);
        }
        let needed = 64 + r.bits() as u32;
        self.with_precision(progress, |sum| {
            let Some((root, coefficient)) = sum.terms.first() else {
                // Nothing but the root 0: zero far out.
                return if sum.polynomial.is_empty() { Ok(Some(None)) } else { Err(RecurrenceError::Roots) };
            };
            // 1 + eta with |eta| <= 2^-32 from some index below r on.
            let far = r.to_u64().unwrap_or(u64::MAX).min(1 << 40);
            if !sum.polynomial.is_empty() || root.precision() < needed || !sum.leads_from(far, 32)? {
                return Ok(None);
            }
            let Some(sign) = coefficient.sign() else { return Ok(None) };
            let size = if sign == Sign::Negative { -coefficient.clone() } else { coefficient.clone() };
            let ln2 = root.integer(2).ln()?;
            let log2 = |x: &Interval| -> Result<Interval, ArithmeticError> { x.ln()?.over(&ln2) };
            let power = root.rational(&Rational::from_integer(r.clone()));
            let slack = root.ratio(1, 1 << 31).hull(&root.ratio(-1, 1 << 31));
            Ok(Some(Some(Leading { sign, log2: log2(&size)? + power * log2(root)? + slack })))
        })
    }

    fn with_precision<T>(
        &self,
        progress: &dyn Progress,
        attempt: impl Fn(&ExponentialSum) -> Result<Option<T>, RecurrenceError>,
    ) -> Result<T, RecurrenceError> {
        if self.terms.len() < 2 * self.order() {
            return Err(RecurrenceError::TooFewTerms { terms: self.terms.len(), order: self.order() });
        }
        for precision in PRECISIONS {
            if let Some(sum) = self.decompose(precision, progress)?
                && let Some(result) = attempt(&sum)?
            {
                return Ok(result);
            }
        }
        Err(RecurrenceError::Precision(PRECISIONS[PRECISIONS.len() - 1]))
    }

    /// The closed form at a precision, or `None` where that is too low.
    fn decompose(&self, precision: u32, progress: &dyn Progress) -> Result<Option<ExponentialSum>, RecurrenceError> {
        let start = self.characteristic.iter().take_while(|c| c.is_zero()).count();
        let full = &self.characteristic[start..];
        let integers = Polynomial::from_rationals(full);
        let (ones, rest) = integers.without_root(1);
        if rest.degree() > 0 && !rest.is_square_free_watched(progress)? {
            return Err(RecurrenceError::Roots);
        }
        let mut roots = rest.roots_in_watched(&rational(0, 1), &rational(1, 1), progress)?;
        if roots.len() != rest.degree() {
            return Err(RecurrenceError::Roots);
        }
        roots.reverse();
        let mut terms = Vec::with_capacity(roots.len());
        for root in &mut roots {
            progress.checkpoint()?;
            rest.refine(root, precision);
            let enclosure = root.enclosure(precision);
            match self.coefficient(full, start, &enclosure) {
                Ok(coefficient) if !coefficient.contains_zero() => terms.push((enclosure, coefficient)),
                Ok(_) | Err(ArithmeticError::DivisionByZero) => return Ok(None),
                Err(error) => return Err(error.into()),
            }
        }
        let polynomial = self.polynomial_part(&rest, ones, start);
        Ok(Some(ExponentialSum { start: start as u64, polynomial, terms }))
    }

    /// The coefficient of a simple root: the quotient of the characteristic polynomial by `x - root`, applied to the terms
    /// as an operator of shifts, removes all others. With respect to the sequence from index 0.
    fn coefficient(&self, full: &[Rational], start: usize, root: &Interval) -> Result<Interval, ArithmeticError> {
        let (mut carry, mut applied, mut value, mut power) = (root.zero(), root.zero(), root.zero(), root.one());
        // Synthetic division gives the quotient's coefficients from the top.
        let mut quotient = Vec::with_capacity(full.len() - 1);
        for c in full.iter().skip(1).rev() {
            carry = carry * root + root.rational(c);
            quotient.push(carry.clone());
        }
        for (k, q) in quotient.iter().rev().enumerate() {
            applied = applied + q.clone() * root.rational(&self.terms[start + k]);
            value = value + q.clone() * &power;
            power = power * root;
        }
        // The applied operator gives coefficient root^start quotient(root).
        applied.over(&(value * root.power(start as u64)))
    }

    /// The polynomial that belongs to the root 1 of the given multiplicity, exactly.
    fn polynomial_part(&self, rest: &Polynomial, ones: usize, start: usize) -> Vec<Rational> {
        let h: Vec<Rational> = rest.coefficients().iter().map(|c| Rational::from_integer(c.clone())).collect();
        // (h(E) f)(start + i) for i < ones, a polynomial of degree below `ones`.
        let filtered =
            |i: usize| -> Rational { h.iter().enumerate().map(|(k, c)| c * &self.terms[start + i + k]).sum() };
        let moment = |m: u32| -> Rational {
            let at = |k: usize| rational(i64::try_from(k).unwrap_or(i64::MAX), 1).pow(m as i32);
            h.iter().enumerate().map(|(k, c)| c * at(k)).sum()
        };
        let mut values: Vec<Rational> = (0..ones).map(filtered).collect();
        let mut polynomial = vec![rational(0, 1); ones];
        // From the top: the leading difference settles the leading coefficient; subtract what it contributes.
        for j in (0..ones).rev() {
            let mut differences = values.clone();
            for _ in 0..j {
                differences = differences.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
            }
            let factorial: i64 = (1..=j as i64).product();
            let Some(top) = differences.first() else { break };
            let lead = top / (moment(0) * rational(factorial, 1));
            for (i, value) in values.iter_mut().enumerate() {
                // h(E) applied to lead (r)^j at r = start + i.
                let r = (start + i) as i64;
                let contribution: Rational =
                    h.iter().enumerate().map(|(k, c)| c * rational(r + k as i64, 1).pow(j as i32)).sum();
                *value -= contribution * &lead;
            }
            polynomial[j] = lead;
        }
        while polynomial.last().is_some_and(Zero::is_zero) {
            polynomial.pop();
        }
        polynomial
    }
}

impl ExponentialSum {
    /// The sign from an index on, where that is certain.
    fn sign_from(&self, from: u64) -> Result<Option<Sign>, RecurrenceError> {
        let Some(lead) = self.polynomial.last() else {
            return Ok(match (self.terms.first(), self.leads_from(from, 0)?) {
                (Some((_, coefficient)), true) => coefficient.sign(),
                _ => None,
            });
        };
        // |p| does not decrease where all coefficients have one sign, nor beyond Cauchy's bound of the roots of p and of p'; the
        // exponentials do.
        let one_sign = self.polynomial.iter().all(|c| c.is_zero() || Signed::sign(c) == Signed::sign(lead));
        let bound: Rational = self.polynomial.iter().map(|c| (c / lead).abs()).sum();
        let r = rational(i64::try_from(from).unwrap_or(i64::MAX), 1);
        if r < bound && !one_sign {
            return Ok(None);
        }
        let value = self.polynomial.iter().rev().fold(r.zero(), |sum, c| sum * &r + c).abs();
        let Some((first, _)) = self.terms.first() else { return Ok(Signed::sign(lead)) };
        let mut margin = first.rational(&value);
        // Terms of the same sign do no harm.
        for (root, coefficient) in self.terms.iter().filter(|(_, c)| c.sign() != Signed::sign(lead)) {
            margin = margin - absolute(&(root.power(from) * coefficient));
        }
        Ok(if margin.is_certainly_positive() { Signed::sign(lead) } else { None })
    }

    /// Whether all exponential terms but the leading one together are below `2^-bits` of that, from an index on.
    fn leads_from(&self, from: u64, bits: i64) -> Result<bool, RecurrenceError> {
        let Some(((first, lead), rest)) = self.terms.split_first() else { return Ok(true) };
        let mut margin = first.one().scaled(-bits);
        for (root, coefficient) in rest {
            let ratio = root.over(first)?;
            if !(ratio.one() - &ratio).is_certainly_positive() {
                return Ok(false);
            }
            margin = margin - absolute(&(ratio.power(from) * coefficient.over(lead)?));
        }
        Ok(margin.is_certainly_positive())
    }
}

/// The absolute value of an interval that does not contain zero; otherwise its hull with the negated one.
fn absolute(x: &Interval) -> Interval {
    match x.sign() {
        Some(Sign::Negative) => -x.clone(),
        Some(_) => x.clone(),
        None => x.hull(&-x.clone()),
    }
}

/// The monic characteristic polynomial of the shortest recurrence of the terms (Berlekamp and Massey).
fn shortest(terms: &[Rational], progress: &dyn Progress) -> Result<Vec<Rational>, Cancelled> {
    let (one, zero) = (rational(1, 1), rational(0, 1));
    // connection(x) = 1 + c_1 x + ...: f(r) + c_1 f(r-1) + ... = 0.
    let (mut connection, mut previous) = (vec![one.clone()], vec![one.clone()]);
    let (mut order, mut gap, mut last) = (0usize, 1usize, one);
    for r in 0..terms.len() {
        progress.checkpoint()?;
        let discrepancy: Rational = connection.iter().zip(terms[..=r].iter().rev()).map(|(c, f)| c * f).sum();
        if discrepancy.is_zero() {
            gap += 1;
            continue;
        }
        let factor = &discrepancy / &last;
        let mut next = connection.clone();
        next.resize(next.len().max(previous.len() + gap), zero.clone());
        for (k, c) in previous.iter().enumerate() {
            next[k + gap] -= c * &factor;
        }
        if 2 * order <= r {
            order = r + 1 - order;
            previous = std::mem::replace(&mut connection, next);
            last = discrepancy;
            gap = 1;
        } else {
            connection = next;
            gap += 1;
        }
    }
    connection.resize(order + 1, zero);
    connection.reverse();
    Ok(connection)
}

#[cfg(test)]
mod tests;
