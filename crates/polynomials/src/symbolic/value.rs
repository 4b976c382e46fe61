//! The other way: what a function is at numbers of any scalar, and how fast it changes where its arguments do.

use super::{Extension, Fraction, Function, Meaning, Polynomial, Symbolic};
use crate::function::Function as Valued;
use arithmetic::{ArithmeticError, Dual, Number, Rational, Ring, rational};
use num_bigint::BigInt;
use num_integer::Integer;

/// All that the variables of a computation stand for.
#[derive(Debug, Clone)]
struct Variables {
    arity: usize,
    divisors: Vec<Polynomial>,
    meanings: Vec<Meaning>,
    calls: Vec<(Function, Fraction, usize)>,
}

impl Variables {
    fn of(function: &Symbolic) -> Self {
        let arity = function.extension.arity;
        function.extension.with(|inner| Variables {
            arity,
            divisors: inner.divisors.clone(),
            meanings: inner.meanings.clone(),
            calls: inner.calls.clone(),
        })
    }

    fn call(&self, variable: usize) -> Option<&(Function, Fraction, usize)> {
        self.calls.iter().find(|(_, _, own)| *own == variable)
    }

    /// The polynomials of a quotient.
    fn of_fraction<'a>(&'a self, (numerator, powers): &'a Fraction) -> Vec<&'a Polynomial> {
        let divisors = powers.iter().enumerate().filter(|(_, power)| **power > 0).map(|(k, _)| &self.divisors[k]);
        std::iter::once(numerator).chain(divisors).collect()
    }

    /// The polynomials that the meaning of a variable consists of.
    fn behind(&self, variable: usize) -> Vec<&Polynomial> {
        let call = |variable| self.call(variable).map_or_else(Vec::new, |(_, argument, _)| self.of_fraction(argument));
        match &self.meanings[variable - self.arity] {
            Meaning::Reciprocal(under) => vec![under],
            Meaning::Root(over, under) | Meaning::Absolute(over, under) => vec![over, under],
            Meaning::Sine => call(variable - 1),
            _ => call(variable),
        }
    }

    /// Which of the new variables a function depends on, in the end; those behind a variable stand before it. What stands behind `held` is not asked for.
    fn needed(&self, function: &Fraction, held: Option<usize>) -> Vec<bool> {
        let mut needed = vec![false; self.meanings.len()];
        let note = |needed: &mut [bool], polynomials: Vec<&Polynomial>| {
            for (monomial, _) in polynomials.into_iter().flat_map(|polynomial| polynomial.terms()) {
                let places = monomial.iter().enumerate().skip(self.arity).filter(|(_, power)| **power > 0);
                places.for_each(|(k, _)| needed[k - self.arity] = true);
            }
        };
        note(&mut needed, self.of_fraction(function));
        for place in (0..needed.len()).rev() {
            if needed[place] && held != Some(self.arity + place) {
                note(&mut needed, self.behind(self.arity + place));
            }
        }
        needed
    }

    /// The arguments that a function depends on, other than by what stands behind `held`.
    fn arguments(&self, function: &Fraction, held: Option<usize>) -> Vec<usize> {
        let needed = self.needed(function, held);
        let behind = (0..needed.len()).filter(|place| needed[*place] && held != Some(self.arity + *place));
        let behind = behind.flat_map(|place| self.behind(self.arity + place));
        let all: Vec<&Polynomial> = self.of_fraction(function).into_iter().chain(behind).collect();
        let has = |k: &usize| all.iter().any(|polynomial| polynomial.degree_in(*k) > 0);
        (0..self.arity).filter(has).collect()
    }

    /// Whether something is known of all that a function consists of.
    fn are_known(&self, needed: &[bool]) -> bool {
        let is_known = |place: usize| match self.meanings[place] {
            Meaning::Any | Meaning::Positive | Meaning::Cosine => self.call(self.arity + place).is_some(),
            _ => true,
        };
        (0..needed.len()).all(|place| !needed[place] || is_known(place))
    }

    fn value<T: Number>(&self, (numerator, powers): &Fraction, point: &[T], like: &T) -> Result<T, ArithmeticError> {
        let of = |polynomial: &Polynomial| polynomial.at(point, like, |q| like.rational(q));
        let divided = |value: T, (k, power): (usize, &u32)| match power {
            0 => Ok(value),
            power => value.over(&of(&self.divisors[k]).power(u64::from(*power))),
        };
        powers.iter().enumerate().try_fold(of(numerator), divided)
    }

    /// What a new variable is, those before it being known.
    fn meant<T: Number>(&self, variable: usize, point: &[T], like: &T) -> Result<T, ArithmeticError> {
        let of = |polynomial: &Polynomial| polynomial.at(point, like, |q| like.rational(q));
        let unknown = || ArithmeticError::Domain("a function of the arguments alone");
        let call = |variable| self.call(variable).ok_or_else(unknown);
        match &self.meanings[variable - self.arity] {
            Meaning::Reciprocal(under) => of(under).recip(),
            Meaning::Root(over, under) => of(over).over(&of(under))?.sqrt(),
            Meaning::Absolute(over, under) => of(over).over(&of(under))?.absolute(),
            Meaning::Between(..) => like.circle(),
            Meaning::Sine => self.value(&call(variable - 1)?.1, point, like)?.sin(),
            _ => {
                let (function, argument, _) = call(variable)?;
                let argument = self.value(argument, point, like)?;
                match function {
                    Function::Cosine => argument.cos(),
                    Function::Exponential => argument.exp(),
                    // Of the absolute value, by the square: intervals below 0 would count as without a value.
                    Function::Logarithm => Ok(argument.square().ln()? * like.ratio(1, 2)),
                    Function::Root(degree) => argument.root(*degree),
                    Function::Other("atan") => argument.atan(),
                    Function::Other(_) => Err(unknown()),
                }
            }
        }
    }
}

impl Symbolic {
    /// Whether it has a derivative wherever it has a value: nothing stands under a root or between bars.
    pub fn is_smooth(&self) -> bool {
        let variables = Variables::of(self);
        let needed = variables.needed(&self.fraction, None);
        let is_root =
            |place: usize| matches!(variables.call(variables.arity + place), Some((super::Function::Root(_), ..)));
        let has_kink = |place: usize| {
            matches!(variables.meanings[place], Meaning::Root(..) | Meaning::Absolute(..)) || is_root(place)
        };
        !(0..needed.len()).any(|place| needed[place] && has_kink(place))
    }

    /// Whether something in it is divided by what is no number.
    pub fn has_divisors(&self) -> bool {
        let variables = Variables::of(self);
        let needed = variables.needed(&self.fraction, None);
        let divides = |meaning: &Meaning| matches!(meaning, Meaning::Reciprocal(_));
        self.fraction.1.iter().any(|power| *power > 0)
            || variables.meanings.iter().zip(needed).any(|(meaning, is_needed)| is_needed && divides(meaning))
    }

    /// How many terms its numerator has, in its arguments and in what else it consists of.
    pub fn count_of_terms(&self) -> usize {
        self.fraction.0.terms().len()
    }

    /// Whether it is a polynomial in its arguments.
    pub fn is_polynomial(&self) -> bool {
        self.fraction.1.iter().all(|power| *power == 0) && self.fraction.0.arity() <= self.extension.arity
    }

    /// The arguments that it depends on.
    pub fn depends_on(&self) -> Vec<usize> {
        Variables::of(self).arguments(&self.fraction, None)
    }

    /// What stands in the exponentials of its products, added up.
    pub(crate) fn exponents(&self) -> Vec<Symbolic> {
        let calls = self.extension.with(|inner| inner.calls.clone());
        let exponent = |monomial: &Vec<u32>| {
            let own = calls.iter().filter(|call| call.0 == Function::Exponential);
            let powers = own.map(|call| (&call.1, i64::from(monomial.get(call.2).copied().unwrap_or(0))));
            let powers: Vec<_> = powers.filter(|own| own.1 > 0).collect();
            let sum = |sum: Symbolic, (argument, power): (&Fraction, i64)| {
                let argument = Symbolic { fraction: argument.clone(), extension: self.extension.clone() };
                sum + argument * self.extension.unit().integer(power)
            };
            let zero = self.extension.of(Polynomial::of(rational(0, 1)));
            (powers.len() > 1).then(|| powers.into_iter().fold(zero, sum))
        };
        self.fraction.0.terms().filter_map(|(monomial, _)| exponent(monomial)).collect()
    }

    /// Functions of different arguments whose sum it is; itself where it is no such sum.
    pub(crate) fn summands(&self) -> Vec<Symbolic> {
        if self.fraction.1.iter().any(|power| *power > 0) {
            return vec![self.clone()];
        }
        let mut groups: Vec<(Vec<usize>, Polynomial)> = Vec::new();
        for (monomial, c) in self.fraction.0.terms() {
            let term = Polynomial::from_terms([(monomial.clone(), c.clone())], &rational(0, 1));
            let mut own = (self.extension.of(term.clone()).depends_on(), term);
            let apart = |group: &(Vec<usize>, Polynomial)| !group.0.iter().any(|k| own.0.contains(k));
            let (rest, joined): (Vec<_>, Vec<_>) = groups.into_iter().partition(apart);
            groups = rest;
            for (arguments, sum) in joined {
                own = ([own.0, arguments].concat(), own.1 + sum);
            }
            groups.push(own);
        }
        // Constants belong to any.
        let (constants, mut groups): (Vec<_>, Vec<_>) = groups.into_iter().partition(|group| group.0.is_empty());
        if let Some(first) = groups.first_mut() {
            first.1 = constants.into_iter().fold(first.1.clone(), |sum, (_, own)| sum + own);
        }
        groups.into_iter().map(|(_, sum)| self.extension.of(sum)).collect()
    }

    /// How fast it changes where its arguments change at these rates, by the chain rule: at every point where it has a value and a derivative.
    ///
    /// # Errors
    /// [`ArithmeticError`] where it has a part of which nothing is known.
    pub fn rate(&self, rates: &[Symbolic]) -> Result<Symbolic, ArithmeticError> {
        let arguments = self.extension.arguments().into_iter().zip(rates);
        let moving: Vec<Dual<Symbolic>> = arguments.map(|(argument, rate)| Dual::new(argument, rate.clone())).collect();
        Ok(self.value(&moving)?.derivative)
    }
}

/// A function as it is now, to be evaluated at many points: what is computed with it later changes nothing in it.
#[derive(Debug, Clone)]
pub struct Settled {
    variables: Variables,
    needed: Vec<bool>,
    fraction: Fraction,
    /// A new variable, and the argument in whose place its value is given.
    held: Option<(usize, usize)>,
}

impl Symbolic {
    /// It as a function of its arguments.
    pub fn settled(&self) -> Settled {
        self.holding(None)
    }

    /// The same with the value of one of its new variables as an argument, in the place of another one.
    fn holding(&self, held: Option<(usize, usize)>) -> Settled {
        let variables = Variables::of(self);
        let needed = variables.needed(&self.fraction, held.map(|own| own.0));
        Settled { needed, variables, fraction: self.fraction.clone(), held }
    }

    /// It as a function of its arguments, where something is known of all that it consists of.
    pub(crate) fn known(&self) -> Option<Settled> {
        Some(self.settled()).filter(|own| own.variables.are_known(&own.needed))
    }

    /// It as a function of the value of a function in it, in the place of one of the arguments of that, and of all others; `None` where it depends on one of those otherwise.
    pub(crate) fn as_function_of(&self, part: &Part) -> Option<Settled> {
        let direct = Variables::of(self).arguments(&self.fraction, Some(part.variable));
        let known = |own: &Settled| {
            let is_held = |place: usize| own.variables.arity + place == part.variable;
            let asked: Vec<bool> = (0..own.needed.len()).map(|place| own.needed[place] && !is_held(place)).collect();
            own.variables.are_known(&asked)
        };
        let whole = !direct.iter().any(|k| part.arguments.contains(k));
        whole.then(|| self.holding(Some((part.variable, part.arguments[0])))).filter(known)
    }
}

/// A function that stands in others.
pub(crate) struct Part {
    variable: usize,
    /// The arguments that it depends on, at least one.
    pub arguments: Vec<usize>,
    /// It as a function of them.
    pub function: Settled,
    /// Whether it is above 0 wherever it has a value.
    pub is_positive: bool,
}

impl Extension {
    /// A new variable as a function of the arguments, where it is known.
    pub(crate) fn variable_at(&self, place: usize) -> Option<Settled> {
        self.of(Polynomial::x(self.arity + place)).known()
    }

    /// A rational number that is a little more than a period in an argument, if functions depend on it by sines and cosines of multiples only.
    pub(crate) fn period(&self, functions: &[Symbolic], argument: usize) -> Option<Rational> {
        let of = |call: &(Function, Fraction, usize)| call.1.0.degree_in(argument) > 0;
        let (mut over, mut under) = (BigInt::from(0), BigInt::from(1));
        let mut turning = Vec::new();
        for (function, (inside, powers), variable) in
            self.with(|inner| inner.calls.clone()).iter().filter(|call| of(call))
        {
            let mut terms = inside.terms();
            let (Some((monomial, c)), None) = (terms.next(), terms.next()) else { return None };
            let whole = monomial.iter().sum::<u32>() == 1 && powers.iter().all(|power| *power == 0);
            if *function != Function::Cosine || !whole {
                return None;
            }
            // The greatest common divisor of the multiples.
            over = (&over * c.denom()).gcd(&(c.numer() * &under));
            under = &under * c.denom();
            turning.push(*variable);
        }
        let plain = |own: &Symbolic| {
            let variables = Variables::of(own);
            let needed = variables.needed(&own.fraction, None);
            let skipped =
                |variable: usize| turning.contains(&variable) || turning.contains(&(variable.wrapping_sub(1)));
            let behind = (0..needed.len()).filter(|place| needed[*place] && !skipped(self.arity + place));
            let behind = behind.flat_map(|place| variables.behind(self.arity + place));
            let mut all = variables.of_fraction(&own.fraction).into_iter().chain(behind);
            all.all(|polynomial| polynomial.degree_in(argument) == 0)
        };
        // Above 2 pi.
        let period = || Rational::new(BigInt::from(6_283_186) * &under, BigInt::from(1_000_000) * &over);
        (!turning.is_empty() && functions.iter().all(plain)).then(period)
    }

    /// The roots, exponentials and logarithms that were asked for, which depend on arguments.
    pub(crate) fn functions(&self) -> Vec<Part> {
        let calls = self.with(|inner| inner.calls.clone());
        let wanted = |function: &Function| {
            matches!(
                function,
                Function::Exponential | Function::Logarithm | Function::Root(_) | Function::Other("atan")
            )
        };
        let called = calls
            .iter()
            .filter(|(function, ..)| wanted(function))
            .map(|(function, _, variable)| (*variable, *function == Function::Exponential));
        let roots = self.meanings().into_iter().enumerate();
        let roots = roots.filter(|(_, meaning)| matches!(meaning, Meaning::Root(..) | Meaning::Absolute(..)));
        let roots = roots.map(|(place, _)| (self.arity + place, false));
        let part = |(variable, is_positive): (usize, bool)| {
            let own = self.of(Polynomial::x(variable));
            let arguments = own.depends_on();
            let function = own.known().filter(|_| !arguments.is_empty())?;
            Some(Part { variable, arguments, function, is_positive })
        };
        called.chain(roots).collect::<Vec<_>>().into_iter().filter_map(part).collect()
    }
}

impl Valued for Settled {
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        let like = at.first().ok_or(ArithmeticError::Domain("a variable"))?;
        let mut point = at.to_vec();
        for (place, is_needed) in self.needed.iter().enumerate() {
            let variable = self.variables.arity + place;
            point.push(match (self.held, is_needed) {
                (Some((held, argument)), _) if held == variable => at[argument].clone(),
                (_, true) => self.variables.meant(variable, &point, like)?,
                _ => like.zero(),
            });
        }
        self.variables.value(&self.fraction, &point, like)
    }
}

/// A function of the arguments alone: nothing stands in it of which nothing is known.
impl Valued for Symbolic {
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        self.settled().value(at)
    }
}
