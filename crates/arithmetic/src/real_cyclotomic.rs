//! The real numbers of a cyclotomic field, exactly: cosines and sines of rational parts of a turn, with sums, products,
//! inverses and signs.

use super::operators::operators;
use super::{ArithmeticError, Complex, Field, Interval, Number, Rational, Real, Ring, Sign, Signed, rational};
use num_integer::Integer;
use num_traits::Zero;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

/// The field `Q(y)` with `y = 2 cos(2 pi/order)`, four dividing the order, so that it has the cosines and the sines of all
/// multiples of `1/order` of a turn.
#[derive(Debug, Clone)]
pub struct CosineField {
    parts: i64,
    data: Arc<FieldData>,
}

#[derive(Debug)]
struct FieldData {
    order: i64,
    /// The minimal polynomial of `y`, lowest coefficient first, the leading one (1) left out.
    minimal: Vec<Rational>,
    /// `y` at the precisions that were asked for.
    enclosures: Mutex<BTreeMap<u32, Interval>>,
}

impl FieldData {
    /// `y = 2 cos(2 pi/order)`.
    fn generator(&self, precision: u32) -> Result<Interval, ArithmeticError> {
        let mut known = self.enclosures.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(y) = known.get(&precision) {
            return Ok(y.clone());
        }
        let one = Interval::from_rational(&rational(1, 1), precision);
        let y = (one.pi() * one.ratio(2, self.order)).cos()? * one.integer(2);
        known.insert(precision, y.clone());
        Ok(y)
    }
}

/// A number of a [`CosineField`]. Both operands of an operation belong to the same field.
#[derive(Debug, Clone)]
pub struct RealCyclotomic {
    field: Arc<FieldData>,
    /// Of the powers of `y` below the degree of the field.
    coefficients: Vec<Rational>,
}

/// Bits at which the search for a sign starts.
const FIRST_PRECISION: u32 = 64;

impl CosineField {
    /// The field of the cosines and sines of multiples of `1/parts` of a turn; `parts` is at least 1, and 0 counts as 1.
    pub fn new(parts: u32) -> Self {
        let parts = i64::from(parts.max(1));
        let order = parts.lcm(&4);
        CosineField {
            parts,
            data: Arc::new(FieldData { order, minimal: minimal_polynomial(order), enclosures: Mutex::default() }),
        }
    }

    /// Degree over the rationals.
    pub fn degree(&self) -> usize {
        self.data.minimal.len()
    }

    /// A rational number.
    pub fn number(&self, q: &Rational) -> RealCyclotomic {
        let mut coefficients = vec![Rational::ZERO; self.degree()];
        coefficients[0].clone_from(q);
        RealCyclotomic { field: self.data.clone(), coefficients }
    }

    /// `cos(2 pi k/parts)`.
    pub fn cos(&self, k: i64) -> RealCyclotomic {
        self.cosine(k * (self.data.order / self.parts))
    }

    /// `sin(2 pi k/parts)`.
    pub fn sin(&self, k: i64) -> RealCyclotomic {
        self.cosine(k * (self.data.order / self.parts) - self.data.order / 4)
    }

    /// `e^(2 pi i k/parts)`.
    pub fn phasor(&self, k: i64) -> Complex<RealCyclotomic> {
        Complex::new(self.cos(k), self.sin(k))
    }

    /// `cos(2 pi k/order)`, half the `k`-th polynomial with `D_k(x + 1/x) = x^k + x^-k`.
    fn cosine(&self, k: i64) -> RealCyclotomic {
        let k = k.rem_euclid(self.data.order);
        let k = k.min(self.data.order - k);
        let y = reduce(vec![Rational::ZERO, rational(1, 1)], &self.data.minimal);
        let y = RealCyclotomic { field: self.data.clone(), coefficients: y };
        let (mut now, mut next) = (y.integer(2), y.clone());
        for _ in 0..k {
            let after = y.clone() * &next - &now;
            now = std::mem::replace(&mut next, after);
        }
        now * y.ratio(1, 2)
    }
}

/// The remainder of a polynomial by the monic one with these lower coefficients.
fn reduce(mut polynomial: Vec<Rational>, lower: &[Rational]) -> Vec<Rational> {
    let degree = lower.len();
    while polynomial.len() > degree {
        let Some(leading) = polynomial.pop().filter(|c| !c.is_zero()) else { continue };
        let shift = polynomial.len() - degree;
        for (c, l) in polynomial[shift..].iter_mut().zip(lower) {
            *c -= &leading * l;
        }
    }
    polynomial.resize(degree, Rational::ZERO);
    polynomial
}

/// Quotient and remainder by a polynomial whose last coefficient is not zero.
fn divide(mut dividend: Vec<Rational>, divisor: &[Rational]) -> (Vec<Rational>, Vec<Rational>) {
    let degree = divisor.len() - 1;
    let mut quotient = vec![Rational::ZERO; dividend.len().saturating_sub(degree)];
    while dividend.len() > degree {
        let shift = dividend.len() - 1 - degree;
        let factor = &dividend[dividend.len() - 1] / &divisor[degree];
        for (c, d) in dividend[shift..].iter_mut().zip(divisor) {
            *c -= &factor * d;
        }
        dividend.pop();
        quotient[shift] = factor;
    }
    (quotient, trimmed(dividend))
}

fn trimmed(mut polynomial: Vec<Rational>) -> Vec<Rational> {
    while polynomial.last().is_some_and(Zero::is_zero) {
        polynomial.pop();
    }
    polynomial
}

fn product(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    let mut result = vec![Rational::ZERO; (a.len() + b.len()).saturating_sub(1)];
    for (i, x) in a.iter().enumerate().filter(|(_, x)| !x.is_zero()) {
        for (j, y) in b.iter().enumerate().filter(|(_, y)| !y.is_zero()) {
            result[i + j] += x * y;
        }
    }
    result
}

/// The minimal polynomial of `2 cos(2 pi/order)`, order at least 3, from the cyclotomic polynomial: that is palindromic of
/// even degree 2h, so `Phi(x)/x^h = a_h + sum_j a_(h+j) (x^j + x^-j)`.
fn minimal_polynomial(order: i64) -> Vec<Rational> {
    let mut cyclotomic: Vec<(i64, Vec<Rational>)> = Vec::new();
    for n in (1..=order).filter(|n| order % n == 0) {
        let mut polynomial = vec![Rational::ZERO; n as usize + 1];
        polynomial[0] = rational(-1, 1);
        polynomial[n as usize] = rational(1, 1);
        for (_, factor) in cyclotomic.iter().filter(|(d, _)| n % d == 0) {
            polynomial = divide(polynomial, factor).0;
        }
        cyclotomic.push((n, polynomial));
    }
    let phi = cyclotomic.pop().map(|(_, polynomial)| polynomial).unwrap_or_default();
    let half = phi.len() / 2;
    let (mut now, mut next) = (vec![rational(2, 1)], vec![Rational::ZERO, rational(1, 1)]);
    let mut minimal = vec![Rational::ZERO; half + 1];
    minimal[0] += &phi[half];
    for j in 1..=half {
        let mut after = product(&next, &[Rational::ZERO, rational(1, 1)]);
        for (a, b) in after.iter_mut().zip(&now) {
            *a -= b;
        }
        now = std::mem::replace(&mut next, after);
        for (sum, c) in minimal.iter_mut().zip(&now) {
            *sum += &phi[half + j] * c;
        }
    }
    minimal.pop();
    minimal
}

impl RealCyclotomic {
    /// The number itself where it is rational.
    pub fn rational_value(&self) -> Option<&Rational> {
        self.coefficients[1..].iter().all(Zero::is_zero).then(|| &self.coefficients[0])
    }

    /// An enclosure.
    ///
    /// # Errors
    /// [`ArithmeticError`], which does not happen for an angle in one turn.
    pub fn enclose(&self, precision: u32) -> Result<Interval, ArithmeticError> {
        let y = self.field.generator(precision)?;
        Ok(self.coefficients.iter().rev().fold(y.zero(), |sum, c| sum * &y + y.rational(c)))
    }

    fn combined(&self, other: &Self, f: impl Fn(&Rational, &Rational) -> Rational) -> Self {
        let coefficients = self.coefficients.iter().zip(&other.coefficients).map(|(a, b)| f(a, b)).collect();
        RealCyclotomic { field: self.field.clone(), coefficients }
    }
}

impl PartialEq for RealCyclotomic {
    fn eq(&self, other: &Self) -> bool {
        self.field.order == other.field.order && self.coefficients == other.coefficients
    }
}

operators!(
    [] RealCyclotomic,
    |a, b| a.combined(b, |x, y| x + y),
    |a, b| a.combined(b, |x, y| x - y),
    |a, b| {
        let coefficients = reduce(product(&a.coefficients, &b.coefficients), &a.field.minimal);
        RealCyclotomic { field: a.field.clone(), coefficients }
    },
    |a| a.combined(a, |x, _| -x)
);

impl Ring for RealCyclotomic {
    fn integer(&self, n: i64) -> Self {
        self.rational(&rational(n, 1))
    }
}

impl Field for RealCyclotomic {
    fn rational(&self, q: &Rational) -> Self {
        let mut coefficients = vec![Rational::ZERO; self.field.minimal.len()];
        coefficients[0].clone_from(q);
        RealCyclotomic { field: self.field.clone(), coefficients }
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        // Euclid: each remainder r is s times this number modulo the minimal polynomial, which is irreducible.
        let mut minimal = self.field.minimal.clone();
        minimal.push(rational(1, 1));
        let (mut r0, mut r1) = (minimal, trimmed(self.coefficients.clone()));
        let (mut s0, mut s1) = (Vec::new(), vec![rational(1, 1)]);
        while r1.len() > 1 {
            let (quotient, remainder) = divide(r0, &r1);
            let subtracted = product(&quotient, &s1);
            s0.resize(subtracted.len().max(s0.len()), Rational::ZERO);
            for (a, b) in s0.iter_mut().zip(&subtracted) {
                *a -= b;
            }
            (r0, r1) = (r1, remainder);
            (s0, s1) = (s1, s0);
        }
        let constant = r1.first().ok_or(ArithmeticError::DivisionByZero)?;
        let coefficients = reduce(s1.iter().map(|c| c / constant).collect(), &self.field.minimal);
        Ok(RealCyclotomic { field: self.field.clone(), coefficients })
    }
}

impl Signed for RealCyclotomic {
    fn sign(&self) -> Option<Sign> {
        if let Some(q) = self.rational_value() {
            return q.sign();
        }
        // Not rational, hence not zero: some precision decides.
        let mut precision = FIRST_PRECISION;
        loop {
            let enclosure = self.enclose(precision).ok()?;
            if !enclosure.contains_zero() {
                return enclosure.sign();
            }
            precision = precision.checked_mul(2)?;
        }
    }
}
