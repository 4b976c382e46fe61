//! Roots, exponentials, sines and the like as new variables, and what is known of them.

use super::{Fraction, Function, Meaning, Polynomial, Symbolic};
use crate::multivariate::Multivariate;
use arithmetic::{ArithmeticError, Field, Number, Rational, Ring, rational};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed as _, ToPrimitive, Zero};

/// More terms of a sum, or larger multiples, are not taken apart.
const MOST_PARTS: usize = 4;
const MOST_COUNT: i64 = 8;

/// Larger multiples of an angle are not added up one by one.
const MOST_TURNS: i64 = 32;

/// Arguments of exponentials and sines of larger denominators have no common grid.
const FINEST: i64 = 720;

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
                Function::Root(_) if self.as_constant().is_some_and(|c| c.is_positive()) => {
                    self.extension.variable(Meaning::Positive)
                }
                Function::Logarithm | Function::Root(_) | Function::Other(_) => self.extension.variable(Meaning::Any),
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

    fn term(&self, monomial: &[u32], c: Rational) -> Symbolic {
        self.extension.of(Multivariate::from_terms([(monomial.to_vec(), c)], &rational(0, 1)))
    }

    /// The terms of a polynomial of few of them.
    fn terms(&self) -> Option<Vec<(Vec<u32>, Rational)>> {
        let (sum, powers) = &self.fraction;
        let few = powers.iter().all(|power| *power == 0) && sum.terms().len() <= MOST_PARTS;
        few.then(|| sum.terms().map(|(monomial, c)| (monomial.clone(), c.clone())).collect())
    }

    /// A term as an integer multiple: of one with the denominator of the grid where that is possible, else of one without a numerator: `2/3 x y` is 2 times
    /// `x y/3`. Large multiples are not taken apart.
    fn multiple(&self, monomial: &[u32], c: &Rational) -> (Symbolic, i64) {
        let grid = self.extension.grid;
        let denominator = c.denom().to_i64().filter(|d| *d <= FINEST);
        if let Some(d) = denominator {
            self.extension.with(|inner| {
                let finest = num_integer::lcm(inner.finest.max(1), d);
                inner.finest = if finest <= FINEST { finest } else { inner.finest };
            });
        }
        let unit = denominator.map_or(grid, |d| if grid % d == 0 { grid } else { d });
        let count = (c * rational(unit, 1)).to_integer().to_i64();
        match count.filter(|count| denominator.is_some() && count.abs() <= MOST_COUNT * grid) {
            Some(count) => (self.term(monomial, rational(1, unit)), count),
            None if c.is_negative() => (self.term(monomial, -c), -1),
            None => (self.term(monomial, c.clone()), 1),
        }
    }

    /// A polynomial as a sum of integer multiples of angles. Multiples of pi and constants are not taken apart.
    fn angles(&self) -> Option<Vec<(Symbolic, i64)>> {
        let part = |(monomial, c): &(Vec<u32>, Rational)| {
            let whole = monomial.is_empty() || self.extension.is_circle(monomial);
            match c.is_negative() {
                _ if !whole => Some(self.multiple(monomial, c))
                    .filter(|(_, count)| count.abs() <= MOST_TURNS)
                    .unwrap_or_else(|| {
                        let sign = if c.is_negative() { -1 } else { 1 };
                        (self.term(monomial, c.abs()), sign)
                    }),
                true => (self.term(monomial, -c), -1),
                false => (self.term(monomial, c.clone()), 1),
            }
        };
        Some(self.terms()?.iter().map(part).collect())
    }

    /// The exponential of a term: of a multiple of a logarithm the power.
    fn exp_of_term(&self, monomial: &[u32], c: &Rational) -> Result<Self, ArithmeticError> {
        if let Some(power) = self.power_of_argument(monomial, c)? {
            return Ok(power);
        }
        let (base, count) = self.multiple(monomial, c);
        let root = base.called(Function::Exponential, Number::exp)?;
        if let Some((degree, power)) = base.as_root() {
            root.has_power(degree, &power);
            if degree % 2 == 0 {
                root.has_power(degree / 2, &self.extension.of(power.clone()).sqrt()?.fraction.0);
            }
            // `1/r = r^(n-1)/p`.
            let whole = if count < 0 { count.unsigned_abs().div_ceil(degree) } else { 0 };
            let rest = (count + (whole * degree) as i64).unsigned_abs();
            return Ok(root.power(rest) * self.extension.of(power).power(whole).recip()?);
        }
        let own = root.power(count.unsigned_abs());
        if count < 0 { own.recip() } else { Ok(own) }
    }

    /// Of `log(p)/n` the degree `n` of the root that its exponential is, and `p`; for numbers only.
    fn as_root(&self) -> Option<(u64, Polynomial)> {
        let mut terms = self.fraction.0.terms();
        let (monomial, c) = terms.next().filter(|_| self.extension.arity == 0)?;
        let alone = terms.next().is_none() && monomial.iter().sum::<u32>() == 1 && c.numer() == BigInt::from(1);
        let of = |call: &&(Function, Fraction, usize)| call.0 == Function::Logarithm && call.2 + 1 == monomial.len();
        let inside = self.extension.with(|inner| inner.calls.iter().find(of).map(|call| call.1.0.clone()));
        let inside = inside.filter(|inside| alone && self.extension.is_known_positive(inside))?;
        Some((c.denom().to_u64()?, inside))
    }

    /// The exponential of a sum, of however many terms.
    fn exp_of_terms(&self) -> Result<Self, ArithmeticError> {
        let term = |product: Self, (monomial, c): (&Vec<u32>, &Rational)| Ok(product * self.exp_of_term(monomial, c)?);
        self.fraction.0.terms().try_fold(self.one(), term)
    }

    /// The root of a product of numbers by its logarithm, so that roots of all degrees are powers of one another.
    fn root_by_logarithms(&self, degree: u64) -> Result<Option<Self>, ArithmeticError> {
        let Some((c, powers)) = self.as_powers().filter(|(c, _)| self.extension.arity == 0 && !c.is_zero()) else {
            return Ok(None);
        };
        let mut logarithm = self.log_number(&c.abs());
        for (k, power) in powers {
            logarithm = logarithm + self.log_variable(k)? * self.integer(power);
        }
        (logarithm * self.ratio(1, degree as i64)).exp_of_terms().map(Some)
    }

    /// `exp(c log|f|) = |f|^c`, for multiples of 1/4.
    fn power_of_argument(&self, monomial: &[u32], c: &Rational) -> Result<Option<Self>, ArithmeticError> {
        let [before @ .., 1] = monomial else { return Ok(None) };
        let quarters = (c * rational(4, 1)).to_integer().to_i64().filter(|k| rational(*k, 4) == *c);
        let Some(quarters) = quarters.filter(|k| k.unsigned_abs() <= 4 * MOST_COUNT as u64) else { return Ok(None) };
        let argument = self.extension.with(|inner| {
            let own = |call: &&(Function, Fraction, usize)| call.0 == Function::Logarithm && call.2 == before.len();
            inner.calls.iter().find(own).map(|(_, (f, _), _)| f.clone())
        });
        let argument = argument.map(|f| (self.extension.is_known_positive(&f), f));
        let Some((positive, f)) = argument.filter(|_| before.iter().all(|power| *power == 0)) else { return Ok(None) };
        let f = self.extension.of(f);
        let size = if positive { f } else { f.size() };
        let root = match quarters % 4 {
            0 => size.power(quarters.unsigned_abs() / 4),
            2 | -2 => size.sqrt()?.power(quarters.unsigned_abs() / 2),
            _ => size.sqrt()?.sqrt()?.power(quarters.unsigned_abs()),
        };
        Ok(Some(if quarters < 0 { root.recip()? } else { root }))
    }

    /// `log|p|`: of a product the sum.
    fn log_size(&self, p: &Polynomial) -> Result<Self, ArithmeticError> {
        let (first, lead) = p.terms().next().ok_or(ArithmeticError::Argument("ln"))?;
        let common: Vec<u32> = (0..first.len())
            .map(|k| p.terms().map(|(own, _)| own.get(k).copied().unwrap_or(0)).min().unwrap_or(0))
            .collect();
        let mut sum = self.log_number(&lead.abs());
        for (k, power) in common.iter().enumerate().filter(|(_, power)| **power > 0) {
            sum = sum + self.log_variable(k)? * self.integer(i64::from(*power));
        }
        let divided = p.terms().map(|(own, c)| {
            let rest = own.iter().enumerate().map(|(k, power)| power - common.get(k).unwrap_or(&0));
            (rest.collect(), c / lead)
        });
        let rest = Multivariate::from_terms(divided, &rational(0, 1));
        if rest.as_constant().is_none() {
            sum = sum + self.log_of(rest);
        }
        Ok(sum)
    }

    /// The logarithm of the size of a polynomial that is not taken apart.
    fn log_of(&self, p: Polynomial) -> Self {
        let variable = self.extension.of(p).call(Function::Logarithm);
        self.extension.of(Multivariate::x(variable))
    }

    /// Of an exponential the argument, of a root half of the logarithm of what is under it.
    fn log_variable(&self, k: usize) -> Result<Self, ArithmeticError> {
        let meanings = self.extension.meanings();
        match k.checked_sub(self.extension.arity).and_then(|place| meanings.get(place)) {
            Some(Meaning::Positive) => {
                let own = |call: &&(Function, Fraction, usize)| call.0 == Function::Exponential && call.2 == k;
                let argument = self.extension.with(|inner| inner.calls.iter().find(own).map(|call| call.1.clone()));
                argument.map(|argument| self.made(argument)).ok_or(ArithmeticError::Argument("ln"))
            }
            Some(Meaning::Root(over, under)) => Ok((self.log_size(over)? - self.log_size(under)?) * self.ratio(1, 2)),
            Some(Meaning::Absolute(over, under)) => Ok(self.log_size(over)? - self.log_size(under)?),
            _ => Ok(self.log_of(Multivariate::x(k))),
        }
    }

    /// The logarithm of a positive number by its small prime factors.
    fn log_number(&self, q: &Rational) -> Self {
        let mut sum = self.zero();
        for (number, sign) in [(q.numer(), 1), (q.denom(), -1)] {
            for (prime, power) in small_factors(number) {
                let prime = Multivariate::of(Rational::from_integer(prime));
                self.extension.with(|inner| {
                    if !inner.positive.contains(&prime) {
                        inner.positive.push(prime.clone());
                    }
                });
                sum = sum + self.log_of(prime) * self.integer(sign * power);
            }
        }
        sum
    }

    /// From now on its power is known.
    fn has_power(&self, degree: u64, power: &Polynomial) {
        let relation = self.fraction.0.power(degree) - power;
        self.extension.with(|inner| {
            if !inner.relations.contains(&relation) {
                inner.relations.push(relation);
            }
        });
    }

    /// The root of a positive number.
    fn root_of_number(&self, q: &Rational, degree: u64) -> Result<Self, ArithmeticError> {
        if let Ok(root) = q.root(degree) {
            return Ok(self.rational(&root));
        }
        let mut product = self.one();
        for (number, divides) in [(q.numer(), false), (q.denom(), true)] {
            for (prime, power) in small_factors(number.clone()) {
                let prime = Multivariate::of(Rational::from_integer(prime));
                let root =
                    self.extension.of(Multivariate::x(self.extension.of(prime.clone()).call(Function::Root(degree))));
                root.has_power(degree, &prime);
                // `1/r = r^(n-1)/p`.
                let (power, whole) = match divides {
                    false => (power.unsigned_abs(), self.one()),
                    true => (
                        (degree - 1) * power.unsigned_abs(),
                        self.extension.of(prime).power(power.unsigned_abs()).recip()?,
                    ),
                };
                product = product * root.power(power) * whole;
            }
        }
        Ok(product)
    }

    /// Of a product of exponentials, times a number, by half of the arguments; of a number by its prime factors. Only where there are no arguments: there all that is
    /// wanted is whether a number is zero.
    fn root_of_constant(&self) -> Result<Option<Self>, ArithmeticError> {
        let Some((c, powers)) = self.as_powers().filter(|(c, _)| self.extension.arity == 0 && !c.is_negative()) else {
            return Ok(None);
        };
        let meanings = self.extension.meanings();
        let mut argument = self.zero();
        for (k, power) in powers {
            if meanings.get(k) != Some(&Meaning::Positive) {
                return Ok(None);
            }
            argument = argument + self.log_variable(k)? * self.ratio(power, 2);
        }
        let mut root = argument.exp()?;
        for (number, sign) in [(c.numer(), 1), (c.denom(), -1)] {
            for (prime, power) in small_factors(number) {
                let whole = Rational::from_integer(prime.clone()).power((power / 2) as u64);
                let meaning =
                    Meaning::Root(Multivariate::of(Rational::from_integer(prime)), Multivariate::of(rational(1, 1)));
                let odd = if power % 2 == 1 {
                    self.extension.of(Multivariate::x(self.extension.known(meaning)))
                } else {
                    self.one()
                };
                let own = odd * self.rational(&whole);
                root = root * if sign < 0 { own.recip()? } else { own };
            }
        }
        Ok(Some(root))
    }

    /// The root of a product of powers: of arguments that are not negative, to multiples of the degree, and of exponentials where `exponentials`.
    fn root_of_powers(&self, degree: u64, exponentials: bool) -> Result<Option<Self>, ArithmeticError> {
        let of_function = |(c, powers): &(Rational, Vec<_>)| c.is_positive() && !powers.is_empty();
        let Some((c, powers)) = self.as_powers().filter(of_function) else { return Ok(None) };
        let (arity, known) = (self.extension.arity, self.extension.with(|inner| inner.not_negative.clone()));
        let (mut product, mut argument) = (self.one(), self.zero());
        for (k, power) in powers {
            let is_exponential = || {
                let own = |call: &(Function, Fraction, usize)| call.0 == Function::Exponential && call.2 == k;
                exponentials && self.extension.with(|inner| inner.calls.iter().any(own))
            };
            if k < arity && known.contains(&k) && power.unsigned_abs().is_multiple_of(degree) {
                let own = self.extension.of(Multivariate::x(k)).power(power.unsigned_abs() / degree);
                product = product * if power < 0 { own.recip()? } else { own };
            } else if is_exponential() {
                argument = argument + self.log_variable(k)? * self.ratio(power, degree as i64);
            } else {
                return Ok(None);
            }
        }
        let number = if degree == 2 { self.rational(&c).sqrt()? } else { self.root_of_number(&c, degree)? };
        Ok(Some(product * argument.exp()? * number))
    }

    /// `exp(s f)` with a number `s > 0`, for a sum in which multiples of logarithms are terms: the product of the powers of what they were taken of, and of exponentials.
    /// `None` where there is no such logarithm of a function.
    pub(crate) fn exponentiated(&self) -> Option<Self> {
        const MOST: usize = 12;
        let (sum, powers) = &self.fraction;
        if powers.iter().any(|power| *power > 0) || sum.terms().len() > MOST {
            return None;
        }
        let logarithms: Vec<usize> = self.extension.with(|inner| {
            let calls = inner.calls.iter().filter(|call| call.0 == Function::Logarithm);
            calls.filter(|call| call.1.0.as_constant().is_none()).map(|call| call.2).collect()
        });
        let mut scale: i64 = 1;
        let mut is_one = false;
        for (monomial, c) in sum.terms() {
            if !logarithms.iter().any(|k| monomial.get(*k).is_some_and(|power| *power > 0)) {
                continue;
            }
            if monomial.iter().sum::<u32>() > 1 {
                return None;
            }
            scale = num_integer::lcm(scale, c.denom().to_i64().filter(|d| *d <= MOST_COUNT)?);
            is_one = true;
        }
        let product = (self.clone() * self.integer(scale)).exp_of_terms();
        product.ok().filter(|_| is_one && scale <= MOST_COUNT)
    }

    /// Sine and cosine of an angle that is not taken apart: exact at multiples of `pi/12`.
    fn of_part(&self) -> Result<(Self, Self), ArithmeticError> {
        if self.as_constant().is_some_and(|c| c.is_zero()) {
            return Ok((self.zero(), self.one()));
        }
        if let Some(parts) = self.parts_of_turn() {
            let (half, long) = (self.ratio(1, 2), self.integer(3).sqrt()? * self.ratio(1, 2));
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
            let twelfths = |k: i64| (cosine(3 - k), cosine(k));
            if parts % 2 == 0 {
                return Ok(twelfths(parts / 2));
            }
            let eighth = self.integer(2).sqrt()? * &half;
            return Ok(turned(&(eighth.clone(), eighth), &twelfths((parts - 3) / 2)));
        }
        let cosine = self.call(Function::Cosine);
        let of = |variable: usize| self.extension.of(Multivariate::x(variable));
        Ok((of(cosine + 1), of(cosine)))
    }

    /// Which multiple of `pi/12` it is.
    fn parts_of_turn(&self) -> Option<i64> {
        if self.fraction.1.iter().any(|power| *power > 0) {
            return None;
        }
        let mut terms = self.fraction.0.terms();
        let (_, c) = terms.next().filter(|(monomial, _)| self.extension.is_circle(monomial))?;
        let count = c * rational(12, 1);
        if terms.next().is_some() || !count.is_integer() { None } else { (count.to_integer() % 24i64).to_i64() }
    }
}

/// Factors of a positive integer with their powers: small primes, and what is left.
fn small_factors(mut n: BigInt) -> Vec<(BigInt, i64)> {
    const LARGEST: u32 = 1000;
    let mut list = Vec::new();
    for p in 2..LARGEST {
        let mut power = 0;
        while n.is_multiple_of(&p.into()) {
            n /= p;
            power += 1;
        }
        if power > 0 {
            list.push((p.into(), power));
        }
        if n <= (p * p).into() {
            break;
        }
    }
    if n > 1.into() {
        list.push((n, 1));
    }
    list
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
        self.heard();
        if let Some(c) = self.as_constant() {
            if c.is_negative() {
                return Err(ArithmeticError::Argument("sqrt"));
            }
            if let Ok(root) = c.sqrt() {
                return Ok(self.rational(&root));
            }
        }
        if let Some(root) = self.root_of_constant()? {
            return Ok(root);
        }
        if let Some(root) = self.root_of_powers(2, false)? {
            return Ok(root);
        }
        // `sqrt(pi/4) = sqrt(pi)/2`.
        let is_product =
            |(c, powers): &(Rational, Vec<(usize, i64)>)| !c.is_one() && powers.iter().all(|own| own.1 == 1);
        if self.as_powers().is_some_and(|own| is_product(&own))
            && let Some(root) = self.root_by_logarithms(2)?
        {
            return Ok(root);
        }
        let meaning = Meaning::Root(self.fraction.0.clone(), self.denominator());
        Ok(self.extension.of(Multivariate::x(self.extension.known(meaning))))
    }

    /// Of a number the product of the roots of its prime factors, whose powers are known; of a function a variable of which nothing is known, since the logarithm
    /// would say that the argument is above 0.
    fn root(&self, degree: u64) -> Result<Self, ArithmeticError> {
        match self.heard().as_constant() {
            Some(c) if c.is_negative() => Err(ArithmeticError::Argument("root")),
            Some(c) if c.is_positive() => match (c.root(degree), self.root_by_logarithms(degree)) {
                (Ok(root), _) => Ok(self.rational(&root)),
                (_, Ok(Some(root))) => Ok(root),
                _ => self.root_of_number(&c, degree),
            },
            Some(_) => Ok(self.zero()),
            None => {
                if let Some(root) = self.root_by_logarithms(degree)? {
                    return Ok(root);
                }
                if let Some(root) = self.root_of_powers(degree, true)? {
                    return Ok(root);
                }
                let root = self.extension.of(Multivariate::x(self.call(Function::Root(degree))));
                // Of numbers, that is: of functions the power is only known where there is a root.
                if self.extension.arity == 0 && self.parts().1.is_empty() {
                    root.has_power(degree, &self.fraction.0);
                }
                Ok(root)
            }
        }
    }

    /// Of a sum the product; of an integer multiple the power; of a multiple of a logarithm a power of its argument.
    fn exp(&self) -> Result<Self, ArithmeticError> {
        let Some(terms) = self.heard().terms() else { return self.called(Function::Exponential, Number::exp) };
        terms.iter().try_fold(self.one(), |product, (monomial, c)| Ok(product * self.exp_of_term(monomial, c)?))
    }

    /// Of the absolute value, which is the same wherever there is a logarithm: of a product the sum, of a power the multiple.
    fn ln(&self) -> Result<Self, ArithmeticError> {
        self.heard();
        if self.as_constant().is_some_and(|c| !c.is_positive()) {
            return Err(ArithmeticError::Argument("ln"));
        }
        let (numerator, divisors) = self.parts();
        let whole = match &divisors[..] {
            [] => Some(&numerator),
            [(divisor, power)] if power % 2 == 1 && numerator.as_constant().is_some_and(|c| c.is_positive()) => {
                Some(divisor)
            }
            _ => None,
        };
        if let Some((p, lead)) =
            whole.and_then(|p| Some((p, p.terms().next()?.1))).filter(|(_, lead)| lead.is_positive())
        {
            let p = p.scaled(&lead.recip());
            self.extension.with(|inner| inner.positive.push(p));
        }
        let over = self.log_size(&numerator)?;
        divisors
            .iter()
            .try_fold(over, |sum, (divisor, power)| Ok(sum - self.log_size(divisor)? * self.integer(i64::from(*power))))
    }

    /// By the formulas for sums and integer multiples of angles.
    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        let whole = || vec![(self.clone(), 1)];
        let parts = self.heard().angles().unwrap_or_else(whole);
        parts.into_iter().try_fold((self.zero(), self.one()), |angle, (base, count)| {
            let (sin, cos) = base.of_part()?;
            let own = if count < 0 { (-sin, cos) } else { (sin, cos) };
            Ok((0..count.unsigned_abs()).fold(angle, |angle, _| turned(&angle, &own)))
        })
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        self.heard().called(Function::Other("atan"), Number::atan)
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
