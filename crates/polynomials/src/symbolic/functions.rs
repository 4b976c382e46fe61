//! Roots, exponentials, sines and the like as new variables, and what is known of them.

use super::{Fraction, Function, Meaning, Symbolic};
use crate::multivariate::Multivariate;
use arithmetic::{ArithmeticError, Field, Number, Rational, Ring, rational};
use num_traits::{Signed as _, ToPrimitive, Zero};

/// More terms of a sum, or larger multiples, are not taken apart.
const MOST_PARTS: usize = 4;
const MOST_COUNT: u64 = 8;

/// Sine and cosine of a sum of two angles.
fn turned(a: &(Symbolic, Symbolic), b: &(Symbolic, Symbolic)) -> (Symbolic, Symbolic) {
    let of = |p: &Symbolic, q: &Symbolic| p.clone() * q;
    (of(&a.0, &b.1) + of(&a.1, &b.0), of(&a.1, &b.1) - of(&a.0, &b.0))
}

impl Symbolic {
    /// The variable of a function of this argument.
    fn call(&self, function: Function) -> usize {
        let known = self.extension.with(|inner| {
            let same = |own: &&(Function, Fraction, usize)| own.0 == function && own.1 == self.fraction;
            inner.calls.iter().find(same).map(|(_, _, variable)| *variable)
        });
        known.unwrap_or_else(|| {
            let variable = match function {
                Function::Cosine => {
                    let cosine = self.extension.variable(Meaning::Cosine);
                    self.extension.variable(Meaning::Sine);
                    cosine
                }
                Function::Exponential => self.extension.variable(Meaning::Positive),
                Function::Other(_) => self.extension.variable(Meaning::Any),
            };
            self.extension.with(|inner| inner.calls.push((function, self.fraction.clone(), variable)));
            variable
        })
    }

    /// The value where it is rational, otherwise the variable of the function.
    fn called(
        &self,
        function: Function,
        exact: impl Fn(&Rational) -> Result<Rational, ArithmeticError>,
    ) -> Result<Self, ArithmeticError> {
        if let Some(value) = self.as_constant().and_then(|c| exact(&c).ok()) {
            return Ok(self.rational(&value));
        }
        Ok(self.extension.of(Multivariate::x(self.call(function))))
    }

    /// A polynomial as a sum of integer multiples of terms without a numerator: `2/3 x y - x` is 2 times `x y/3` and -1 times `x`. Multiples of pi and constants are not
    /// taken apart.
    fn parts_of_sum(&self) -> Option<Vec<(Symbolic, i64)>> {
        let (sum, powers) = &self.fraction;
        if powers.iter().any(|power| *power > 0) || sum.terms().len() > MOST_PARTS {
            return None;
        }
        let part = |(monomial, c): (&Vec<u32>, &Rational)| {
            let term =
                |c: Rational| self.extension.of(Multivariate::from_terms([(monomial.clone(), c)], &rational(0, 1)));
            if monomial.is_empty() || self.extension.is_circle(monomial) {
                return Some((term(c.clone()), 1));
            }
            let count = c.numer().to_i64().filter(|count| count.unsigned_abs() <= MOST_COUNT)?;
            Some((term(Rational::new(1.into(), c.denom())), count))
        };
        sum.terms().map(part).collect()
    }

    /// Sine and cosine of an angle that is not taken apart: exact at multiples of a twelfth of a turn.
    fn of_part(&self) -> Result<(Self, Self), ArithmeticError> {
        if self.as_constant().is_some_and(|c| c.is_zero()) {
            return Ok((self.zero(), self.one()));
        }
        if let Some(twelfths) = self.twelfths() {
            let root = self.integer(3).sqrt()?;
            let (half, long) = (self.ratio(1, 2), root * self.ratio(1, 2));
            let cosine = |k: i64| {
                let k = k.rem_euclid(12);
                let size = match k.min(12 - k) {
                    0 | 6 => self.one(),
                    1 | 5 => long.clone(),
                    2 | 4 => half.clone(),
                    _ => self.zero(),
                };
                if k.min(12 - k) > 3 { -size } else { size }
            };
            return Ok((cosine(3 - twelfths), cosine(twelfths)));
        }
        let cosine = self.call(Function::Cosine);
        let of = |variable: usize| self.extension.of(Multivariate::x(variable));
        Ok((of(cosine + 1), of(cosine)))
    }

    /// Which multiple of `pi/6` it is.
    fn twelfths(&self) -> Option<i64> {
        if self.fraction.1.iter().any(|power| *power > 0) {
            return None;
        }
        let mut terms = self.fraction.0.terms();
        let (_, c) = terms.next().filter(|(monomial, _)| self.extension.is_circle(monomial))?;
        let count = c * rational(6, 1);
        if terms.next().is_some() || !count.is_integer() { None } else { (count.to_integer() % 12i64).to_i64() }
    }
}

impl Number for Symbolic {
    fn circle(&self) -> Result<Self, ArithmeticError> {
        let scale = num_bigint::BigInt::from(1) << 60u32;
        let pi = arithmetic::Real::pi(&arithmetic::Interval::from_rational(&rational(1, 1), 100));
        let lo = (pi.to_rationals().0 * Rational::from_integer(scale.clone())).floor();
        let end = |q: Rational| q / Rational::from_integer(scale.clone());
        let meaning = Meaning::Between(end(lo.clone()), end(lo + rational(1, 1)));
        Ok(self.extension.of(Multivariate::x(self.extension.known(meaning))))
    }

    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        if let Some(c) = self.as_constant() {
            if c.is_negative() {
                return Err(ArithmeticError::Argument("sqrt"));
            }
            if let Ok(root) = c.sqrt() {
                return Ok(self.rational(&root));
            }
        }
        let meaning = Meaning::Root(self.fraction.0.clone(), self.denominator());
        Ok(self.extension.of(Multivariate::x(self.extension.known(meaning))))
    }

    /// Of a sum the product; of an integer multiple the power.
    fn exp(&self) -> Result<Self, ArithmeticError> {
        let Some(parts) = self.parts_of_sum() else { return self.called(Function::Exponential, Number::exp) };
        parts.into_iter().try_fold(self.one(), |product, (base, count)| {
            let own = base.called(Function::Exponential, Number::exp)?.power(count.unsigned_abs());
            Ok(product * if count < 0 { own.recip()? } else { own })
        })
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        self.called(Function::Other("ln"), Number::ln)
    }

    /// By the formulas for sums and integer multiples of angles.
    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        let whole = || vec![(self.clone(), 1)];
        let parts = self.parts_of_sum().unwrap_or_else(whole);
        parts.into_iter().try_fold((self.zero(), self.one()), |angle, (base, count)| {
            let (sin, cos) = base.of_part()?;
            let own = if count < 0 { (-sin, cos) } else { (sin, cos) };
            Ok((0..count.unsigned_abs()).fold(angle, |angle, _| turned(&angle, &own)))
        })
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        self.called(Function::Other("atan"), Number::atan)
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        let up = self.exp()?;
        let down = up.recip()?;
        let half = self.ratio(1, 2);
        Ok(((up.clone() - &down) * &half, (up + down) * half))
    }

    fn angle(_: &Self, _: &Self) -> Result<Self, ArithmeticError> {
        Err(ArithmeticError::Domain("a quotient of polynomials"))
    }
}

#[cfg(test)]
mod tests {
    use crate::symbolic::Extension;
    use arithmetic::{Field, Number, Ring};

    /// `sin(pi/6) = 1/2`, but `sin(pi/(6 x))` is a function of `x`.
    #[test]
    fn only_constant_multiples_of_pi_have_exact_sines() {
        let extension = Extension::new(1);
        let x = extension.arguments().remove(0);
        let sixth = x.circle().unwrap() * x.ratio(1, 6);
        assert_eq!(sixth.sin().unwrap().as_constant(), Some(arithmetic::rational(1, 2)));
        assert_eq!(sixth.over(&x).unwrap().sin().unwrap().as_constant(), None);
        assert_eq!((sixth.clone() * &x).sin().unwrap().as_constant(), None);
        assert_eq!((sixth + &x.integer(1)).sin().unwrap().as_constant(), None);
    }
}
