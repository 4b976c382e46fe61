//! Potentials of a pair as functions of the squared distance.

use algebra::spectrum::Polynomial;
use arithmetic::{ArithmeticError, Dual, Field, Number, Rational, Ring, Sign, Signed, rational};

/// A potential whose slope in `s = |r|²` is a sum of powers: `V'(s) = sum c_k s^k` with integers `k`.
#[derive(Debug, Clone, PartialEq)]
pub struct Potential {
    /// Pairs of exponent and coefficient, every exponent once.
    slope: Vec<(i32, Rational)>,
    /// A squared distance and the value there.
    anchor: (Rational, Rational),
}

/// Why a potential is not one of Definition 3 of the second paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum PotentialError {
    /// `V` stays bounded as the agents approach each other.
    #[error("the potential stays bounded as the distance tends to zero")]
    NoRepulsion,
    /// `V` stays bounded as the agents part.
    #[error("the potential is not radially unbounded")]
    Bounded,
    /// There is no single minimum.
    #[error("the potential has no unique minimum")]
    Minimum,
    /// The least value is negative.
    #[error("the potential is negative somewhere")]
    Negative,
}

impl Potential {
    /// The potential with slope `sum c_k s^k` and a given value at one squared distance.
    pub fn new(slope: Vec<(i32, Rational)>, anchor: (Rational, Rational)) -> Self {
        Potential { slope, anchor }
    }

    /// `m/s + log(s/m)`: the one printed in the first paper, with its minimum 1 moved to the squared distance `m`.
    pub fn inverse_square_log(minimum: &Rational) -> Self {
        let slope = vec![(-1, rational(1, 1)), (-2, -minimum)];
        Potential::new(slope, (minimum.clone(), rational(1, 1)))
    }

    /// `stiffness (s/m + m/s - 2)`: rational, with its minimum 0 at the squared distance `m`.
    ///
    /// # Panics
    /// Where `m` is zero, like a division.
    pub fn inverse_square_spring(minimum: &Rational, stiffness: &Rational) -> Self {
        let slope = vec![(0, stiffness / minimum), (-2, -(stiffness * minimum))];
        Potential::new(slope, (minimum.clone(), rational(0, 1)))
    }

    /// The rational potential with slope `(s - 1)(s - a)²(s + a/(a + 2))/s²` and minimum 0 at `s = 1`: it fulfils Definition 3 of the
    /// second paper and increases strictly for `s > 1`, but with slope 0 at `s = a`, where `a > 1`.
    ///
    /// # Panics
    /// Where `a` is -2, like a division.
    pub fn with_inflection(at: &Rational) -> Self {
        let (one, two) = (rational(1, 1), rational(2, 1));
        let shift = at / (at + &two);
        let square = at * at;
        let slope = vec![
            (2, one.clone()),
            (1, &shift - &two * at - &one),
            (0, &square + &two * at - &shift * (&two * at + &one)),
            (-2, -(square * shift)),
        ];
        Potential::new(slope, (one, rational(0, 1)))
    }

    /// The potential times a number.
    pub fn times(&self, factor: &Rational) -> Self {
        let slope = self.slope.iter().map(|(k, c)| (*k, c * factor)).collect();
        Potential::new(slope, (self.anchor.0.clone(), &self.anchor.1 * factor))
    }

    /// The slope with its coefficients as scalars of the kind of `like`, for many values.
    pub fn slope_over<T: Field>(&self, like: &T) -> Slope<T> {
        let mut terms: Vec<(i32, T)> = self.slope.iter().map(|(k, c)| (*k, like.rational(c))).collect();
        terms.sort_by_key(|(k, _)| std::cmp::Reverse(*k));
        Slope { terms }
    }

    /// `V'(s)`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] at `s = 0`.
    pub fn slope<T: Field>(&self, s: &T) -> Result<T, ArithmeticError> {
        self.slope_over(s).at(s)
    }

    /// `V''(s)`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] at `s = 0`.
    pub fn curvature<T: Field>(&self, s: &T) -> Result<T, ArithmeticError> {
        Ok(self.slope(&Dual::new(s.clone(), s.one()))?.derivative)
    }

    /// The value with its coefficients as scalars of the kind of `like`, for many values.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] where the value at `s = 0` is given and the potential has none there; [`ArithmeticError::Domain`] for the
    /// largest exponent of 32 bits.
    pub fn value_over<T: Field>(&self, like: &T) -> Result<Value<T>, ArithmeticError> {
        let (at, start) = &self.anchor;
        let too_large = ArithmeticError::Domain("exponents of the slope below 2^31 - 1");
        let terms: Vec<(i32, Rational)> = self
            .slope
            .iter()
            .filter(|(k, _)| *k != -1)
            .map(|(k, c)| Ok((k.checked_add(1).ok_or_else(|| too_large.clone())?, c / rational(i64::from(*k) + 1, 1))))
            .collect::<Result<_, ArithmeticError>>()?;
        let constant: Result<Rational, ArithmeticError> =
            terms.iter().try_fold(start.clone(), |sum, (k, c)| Ok(sum - power(at, *k)? * c));
        let log = self.slope.iter().find(|(k, _)| *k == -1).map(|(_, c)| (like.rational(c), like.rational(at)));
        Ok(Value {
            terms: terms.iter().map(|(k, c)| (*k, like.rational(c))).collect(),
            constant: like.rational(&constant?),
            log,
        })
    }

    /// `V(s)` of a potential without a logarithm.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] where there is a logarithm, [`ArithmeticError::DivisionByZero`] at `s = 0`.
    pub fn rational_value<T: Field>(&self, s: &T) -> Result<T, ArithmeticError> {
        let value = self.value_over(s)?;
        if value.log.is_some() {
            return Err(ArithmeticError::Domain("potentials without logarithm"));
        }
        value.powers(s)
    }

    /// `V(s)`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] or [`ArithmeticError::Argument`] where `s` is not certainly positive.
    pub fn value<T: Number>(&self, s: &T) -> Result<T, ArithmeticError> {
        self.value_over(s)?.at(s)
    }

    /// The polynomial `s^k V'(s)`, up to a positive factor, with the least `k >= 0` that makes it one, and `k`.
    pub fn slope_numerator(&self) -> (Polynomial, u32) {
        let lowest = self.slope.iter().fold(0, |least, (k, _)| least.min(*k));
        let highest = self.slope.iter().fold(0, |most, (k, _)| most.max(*k));
        let coefficient =
            |k: i32| self.slope.iter().find(|(exponent, _)| *exponent == k).map_or(rational(0, 1), |(_, c)| c.clone());
        let coefficients: Vec<Rational> = (lowest..=highest).map(coefficient).collect();
        (Polynomial::from_rationals(&coefficients), lowest.unsigned_abs())
    }

    /// The squared distances at which the slope vanishes, in order; `None` where one is irrational, and for a constant potential.
    pub fn critical(&self) -> Option<Vec<Rational>> {
        let (numerator, _) = self.slope_numerator();
        if numerator.is_zero() {
            return None;
        }
        let size = numerator.coefficients().iter().map(num_traits::Signed::abs).sum();
        let (zero, bound) = (rational(0, 1), Rational::from_integer(size) + rational(1, 1));
        let mut found = Vec::new();
        for (factor, _) in numerator.square_free_factors() {
            for mut root in factor.roots_in(&zero, &bound) {
                found.push(factor.rational_root(&mut root)?);
            }
        }
        found.sort();
        Some(found)
    }

    /// Whether it tends to infinity as `s` tends to 0: `V ~ -∫ c s^k` with the lowest power of the slope does so where `k <= -1` and `c < 0`.
    pub fn repels(&self) -> bool {
        let lowest = self.terms().min_by_key(|(k, _)| *k);
        lowest.is_some_and(|(k, c)| *k <= -1 && c.is_certainly_negative())
    }

    /// Whether it tends to infinity with `s`: with the highest power, where `k >= -1` and `c > 0`.
    pub fn confines(&self) -> bool {
        self.terms().max_by_key(|(k, _)| *k).is_some_and(|(k, c)| *k >= -1 && c.is_certainly_positive())
    }

    fn terms(&self) -> impl Iterator<Item = &(i32, Rational)> {
        self.slope.iter().filter(|(_, c)| c.sign() != Some(Sign::Zero))
    }

    /// Whether this is a potential of Definition 3 of the second paper: differentiable and non-negative for `s > 0`,
    /// unbounded towards `s = 0` and towards infinity, with one minimum. Decided exactly from the signs of the slope; the
    /// critical squared distances must be rational.
    ///
    /// # Errors
    /// [`PotentialError`].
    pub fn check_definition3(&self) -> Result<(), PotentialError> {
        if !self.repels() {
            return Err(PotentialError::NoRepulsion);
        }
        if !self.confines() {
            return Err(PotentialError::Bounded);
        }
        let critical = self.critical().ok_or(PotentialError::Minimum)?;
        // The slope changes sign once: then its only descent ends in the minimum.
        let mut rises = Vec::new();
        for (index, s) in critical.iter().enumerate() {
            let after = critical.get(index + 1).map_or(s + rational(1, 1), |next| (s + next) / rational(2, 1));
            let slope = self.slope(&after).map_err(|_| PotentialError::Minimum)?;
            rises.push((s, slope.is_certainly_positive()));
        }
        let minimum = rises.iter().find(|(_, up)| *up).ok_or(PotentialError::Minimum)?.0;
        if rises.iter().skip_while(|(_, up)| !up).any(|(_, up)| !up) {
            return Err(PotentialError::Minimum);
        }
        let least = if *minimum == self.anchor.0 { Ok(self.anchor.1.clone()) } else { self.rational_value(minimum) };
        match least.map_err(|_| PotentialError::Minimum)?.sign() {
            Some(Sign::Negative) => Err(PotentialError::Negative),
            _ => Ok(()),
        }
    }
}

/// The slope of a [`Potential`] over one kind of scalar.
#[derive(Debug, Clone)]
pub struct Slope<T> {
    /// Exponents and coefficients, the highest exponent first.
    terms: Vec<(i32, T)>,
}

impl<T: Field> Slope<T> {
    /// `V'(s)`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] at `s = 0`.
    #[inline(always)]
    pub fn at(&self, s: &T) -> Result<T, ArithmeticError> {
        self.over(s, T::clone)
    }
}

impl<C> Slope<C> {
    /// `V'(s)` over another kind of scalar, of which `number` makes the coefficients: Horner's scheme, then the lowest power, so that there is one
    /// division at most.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] at `s = 0`.
    #[inline(always)]
    pub fn over<T: Field>(&self, s: &T, number: impl Fn(&C) -> T) -> Result<T, ArithmeticError> {
        let Some((first, rest)) = self.terms.split_first() else { return Ok(s.zero()) };
        let (mut value, mut exponent) = (number(&first.1), first.0);
        for (k, c) in rest {
            value = raised(value, s, exponent.abs_diff(*k)) + number(c);
            exponent = *k;
        }
        Ok(if exponent < 0 {
            raised(value, &s.recip()?, exponent.unsigned_abs())
        } else {
            raised(value, s, exponent.unsigned_abs())
        })
    }

    /// The same over another kind of scalar.
    #[inline(always)]
    pub fn map<U>(&self, convert: impl Fn(&C) -> U) -> Slope<U> {
        Slope { terms: self.terms.iter().map(|(k, c)| (*k, convert(c))).collect() }
    }

    /// The coefficients.
    pub fn coefficients(&self) -> impl Iterator<Item = &C> {
        self.terms.iter().map(|(_, c)| c)
    }
}

/// `value s^exponent`.
#[inline(always)]
fn raised<T: Ring>(value: T, s: &T, exponent: u32) -> T {
    match exponent {
        0 => value,
        1 => value * s,
        2 => value * s.square(),
        _ => value * Ring::power(s, u64::from(exponent)),
    }
}

/// The value of a [`Potential`] over one kind of scalar.
#[derive(Debug, Clone)]
pub struct Value<T> {
    terms: Vec<(i32, T)>,
    constant: T,
    /// Factor and unit of the logarithm.
    log: Option<(T, T)>,
}

impl<T: Field> Value<T> {
    fn powers(&self, s: &T) -> Result<T, ArithmeticError> {
        self.terms.iter().try_fold(self.constant.clone(), |total, (k, c)| Ok(total + power(s, *k)? * c))
    }
}

impl<T: Number> Value<T> {
    /// `V(s)`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] or [`ArithmeticError::Argument`] where `s` is not certainly positive.
    pub fn at(&self, s: &T) -> Result<T, ArithmeticError> {
        let powers = self.powers(s)?;
        match &self.log {
            None => Ok(powers),
            Some((factor, unit)) => Ok(powers + s.over(unit)?.ln()? * factor),
        }
    }
}

fn power<T: Field>(s: &T, exponent: i32) -> Result<T, ArithmeticError> {
    let positive = Ring::power(s, u64::from(exponent.unsigned_abs()));
    if exponent < 0 { positive.recip() } else { Ok(positive) }
}
