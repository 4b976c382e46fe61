//! Rational combinations of roots of unity: the eigenvalues of circulants, paths and platoons. Compared exactly, enclosed
//! at any precision.

use super::float_bounds::{SLACK, UNIT};
use super::turn::{CHORD_ERROR, ROOT_ERROR, chord, root_of_unity};
use arithmetic::{ArithmeticError, Complex, Field, Interval, Number, Rational, Real, Ring, rational};
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use std::collections::BTreeMap;

/// `(1/denominator) sum_j c_j z^j` with `z = e^(2 pi i/order)`.
///
/// **Comparison.** Let `g(x)` be the product of `1 - x^(order/p)` over the primes `p` that divide the order. It vanishes at
/// the roots of unity of smaller order and not at `z`. So `f(z) = 0` exactly if `f g` vanishes at all roots of
/// `x^order - 1` (the conjugates of `z` are zeros of `f`, the others of `g`), that is, if `f g` is zero modulo `x^order - 1`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CyclotomicSum {
    order: u64,
    denominator: i64,
    /// Exponents below the order with coefficients that are not zero, in order.
    terms: Vec<(u64, i64)>,
}

/// What there is no such sum or table without.
const ROOTS_OF_UNITY: ArithmeticError = ArithmeticError::Domain("roots of unity of an order from 1 to 2^31");

fn collected(order: u64, terms: impl IntoIterator<Item = (u64, i128)>) -> Vec<(u64, i128)> {
    let mut sum: BTreeMap<u64, i128> = BTreeMap::new();
    for (exponent, coefficient) in terms {
        *sum.entry(exponent % order).or_default() += coefficient;
    }
    sum.into_iter().filter(|&(_, c)| c != 0).collect()
}

impl CyclotomicSum {
    /// From exponents (taken modulo the order) and coefficients. Both numbers and all coefficients may be up to `2^31`.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] for an order or a denominator below 1, and for numbers that are larger.
    pub fn new(
        order: u64,
        denominator: i64,
        terms: impl IntoIterator<Item = (u64, i64)>,
    ) -> Result<Self, ArithmeticError> {
        const MOST: i64 = 1 << 31;
        if !(1..=MOST as u64).contains(&order) {
            return Err(ROOTS_OF_UNITY);
        }
        if !(1..=MOST).contains(&denominator) {
            return Err(ArithmeticError::Domain("a denominator from 1 to 2^31"));
        }
        let sum = CyclotomicSum::of(order, denominator, terms);
        let small = sum.terms.iter().all(|(_, c)| (-MOST..=MOST).contains(c));
        if small { Ok(sum) } else { Err(ArithmeticError::Domain("coefficients up to 2^31")) }
    }

    /// The same for an order and a denominator of at least 1.
    pub(super) fn of(order: u64, denominator: i64, terms: impl IntoIterator<Item = (u64, i64)>) -> Self {
        let terms = collected(order, terms.into_iter().map(|(e, c)| (e, i128::from(c))));
        CyclotomicSum { order, denominator, terms: terms.into_iter().map(|(e, c)| (e, c as i64)).collect() }
    }

    /// Coefficients of `f g` modulo `x^order - 1`: equal for equal numbers of the same order and denominator.
    pub fn canonical(&self) -> Vec<(u64, i128)> {
        let mut terms: Vec<(u64, i128)> = self.terms.iter().map(|&(e, c)| (e, i128::from(c))).collect();
        for p in prime_divisors(self.order) {
            let step = self.order / p;
            terms = collected(self.order, terms.iter().flat_map(|&(e, c)| [(e, c), (e + step, -c)]));
        }
        terms
    }

    /// The order of the roots of unity.
    pub fn order(&self) -> u64 {
        self.order
    }

    /// Whether it is zero.
    pub fn is_zero(&self) -> bool {
        self.canonical().is_empty()
    }

    /// Whether it is real.
    pub fn is_real(&self) -> bool {
        if self.is_mirrored() {
            return true;
        }
        let conjugate = self.terms.iter().map(|&(e, c)| (self.order - e, -c));
        CyclotomicSum::of(self.order, 1, self.terms.iter().copied().chain(conjugate)).is_zero()
    }

    /// Whether its terms are those of its conjugate.
    fn is_mirrored(&self) -> bool {
        self.terms.iter().all(|&(e, c)| self.coefficient((self.order - e) % self.order) == c)
    }

    fn coefficient(&self, exponent: u64) -> i64 {
        self.terms.binary_search_by_key(&exponent, |&(e, _)| e).map_or(0, |place| self.terms[place].1)
    }

    /// Its real part: half its sum with its conjugate.
    pub fn real_part(&self) -> Self {
        if self.is_mirrored() {
            return self.clone();
        }
        let conjugate = self.terms.iter().map(|&(e, c)| (self.order - e, c));
        CyclotomicSum::of(self.order, 2 * self.denominator, self.terms.iter().copied().chain(conjugate))
    }

    /// Whether it is `numerator/denominator` with its own denominator.
    fn is_multiple(&self, numerator: i64) -> bool {
        let terms = self.terms.iter().copied().chain([(0, -numerator)]);
        CyclotomicSum::of(self.order, 1, terms).is_zero()
    }

    /// Encloses real and imaginary part with the roots of a table of the same order.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] for a table of another order.
    pub fn enclose(&self, roots: &RootTable) -> Result<Complex<Interval>, ArithmeticError> {
        if roots.order != self.order {
            return Err(ArithmeticError::Domain("a table of roots of unity of the same order"));
        }
        let factor = |n: i64| Interval::from_rational(&rational(n, 1), roots.precision);
        let mut sum = Complex::real(factor(0));
        for &(exponent, coefficient) in &self.terms {
            sum = sum + roots.root(exponent).scale(&factor(coefficient));
        }
        Ok(sum.scale(&Interval::from_rational(&rational(1, self.denominator), roots.precision)))
    }

    /// Real and imaginary part in floats, and a bound of the error of both. The real part is taken as the sum of the
    /// coefficients less the sum of `c_j (1 - cos)`, so that small eigenvalues of Laplacians keep their digits.
    pub fn to_floats(&self) -> (f64, f64, f64) {
        let (n, denominator) = (self.order, self.denominator as f64);
        let whole: i64 = self.terms.iter().map(|&(_, c)| c).sum();
        let (mut re, mut im, mut chords, mut sines) = (0.0, 0.0, 0.0, 0.0);
        for &(e, c) in self.terms.iter().filter(|&&(e, _)| e != 0) {
            let (c, lack) = (c as f64, chord(e.min(n - e) as f64, n as f64));
            let sine = root_of_unity(e, n).1;
            (re, im) = (re + c * lack, im + c * sine);
            (chords, sines) = (chords + (c * lack).abs(), sines + (c * sine).abs());
        }
        let terms = self.terms.len() as f64 + 3.0;
        let real = (whole as f64 - re) / denominator;
        let radius_re = (CHORD_ERROR + terms * UNIT) * chords / denominator.abs() + 3.0 * UNIT * real.abs();
        let radius_im = (ROOT_ERROR + terms * UNIT) * sines / denominator.abs();
        (real, im / denominator, f64::max(radius_re, radius_im) * SLACK)
    }

    /// The number itself where it is rational, given an enclosure of its real part narrower than `1/denominator`.
    pub fn exact(&self, re: &Interval) -> Option<Rational> {
        // An algebraic integer over its denominator is rational only if it is an integer over it.
        let scaled = re.clone() * re.integer(self.denominator);
        let (lo, hi) = (-scaled.lo().negated().floor(), scaled.hi().floor());
        let exact = lo == hi && self.is_multiple(lo.to_i64().filter(|n| n.unsigned_abs() < 1 << 62)?);
        exact.then(|| Rational::new(lo, BigInt::from(self.denominator)))
    }
}

/// The primes that divide a number.
fn prime_divisors(mut n: u64) -> Vec<u64> {
    let mut primes = Vec::new();
    let mut p = 2;
    while p * p <= n {
        if n.is_multiple_of(p) {
            primes.push(p);
            while n.is_multiple_of(p) {
                n /= p;
            }
        }
        p += 1;
    }
    if n > 1 {
        primes.push(n);
    }
    primes
}

/// Enclosures of all roots of unity of one order, each as the product of two stored ones: about `2 sqrt(order)` sines
/// and cosines.
#[derive(Debug)]
pub struct RootTable {
    order: u64,
    step: u64,
    low: Vec<Complex<Interval>>,
    high: Vec<Complex<Interval>>,
    precision: u32,
}

impl RootTable {
    /// The table for an order of at least 1.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] for the order 0.
    pub fn new(order: u64, precision: u32) -> Result<Self, ArithmeticError> {
        if order == 0 {
            return Err(ROOTS_OF_UNITY);
        }
        let root = order.isqrt();
        let step = if root * root < order { root + 1 } else { root };
        let turn = Interval::from_rational(&rational(2, 1), precision);
        let turn = turn.pi() * turn;
        let root = |exponent: u64| {
            let share = Rational::new(BigInt::from(exponent), BigInt::from(order));
            let (sin, cos) = (turn.clone() * turn.rational(&share)).sin_cos()?;
            Ok(Complex::new(cos, sin))
        };
        let low = (0..step).map(root).collect::<Result<_, ArithmeticError>>()?;
        let high = (0..order.div_ceil(step)).map(|k| root(k * step)).collect::<Result<_, ArithmeticError>>()?;
        Ok(RootTable { order, step, low, high, precision })
    }

    /// `z^exponent`, for exponents below the order.
    fn root(&self, exponent: u64) -> Complex<Interval> {
        let (low, high) = ((exponent % self.step) as usize, (exponent / self.step) as usize);
        match (low, high) {
            (_, 0) => self.low[low].clone(),
            (0, _) => self.high[high].clone(),
            _ => self.low[low].clone() * &self.high[high],
        }
    }
}

#[cfg(test)]
mod tests;
