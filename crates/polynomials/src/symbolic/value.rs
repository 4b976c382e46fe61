//! The other way: what a function is at numbers of any scalar, and how fast it changes where its arguments do.

use super::{Fraction, Function, Meaning, Polynomial, Symbolic};
use crate::function::Function as Valued;
use arithmetic::{ArithmeticError, Dual, Number};

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

    /// Which of the new variables a function depends on, in the end; those behind a variable stand before it.
    fn needed(&self, function: &Fraction) -> Vec<bool> {
        let mut needed = vec![false; self.meanings.len()];
        let note = |needed: &mut [bool], polynomials: Vec<&Polynomial>| {
            for (monomial, _) in polynomials.into_iter().flat_map(|polynomial| polynomial.terms()) {
                let places = monomial.iter().enumerate().skip(self.arity).filter(|(_, power)| **power > 0);
                places.for_each(|(k, _)| needed[k - self.arity] = true);
            }
        };
        note(&mut needed, self.of_fraction(function));
        for place in (0..needed.len()).rev() {
            if needed[place] {
                note(&mut needed, self.behind(self.arity + place));
            }
        }
        needed
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
                    Function::Logarithm => argument.ln().or_else(|_| (-argument).ln()),
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
        let needed = variables.needed(&self.fraction);
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
        let needed = variables.needed(&self.fraction);
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
        let variables = Variables::of(self);
        let needed = variables.needed(&self.fraction);
        let behind = (0..needed.len()).filter(|place| needed[*place]);
        let behind = behind.flat_map(|place| variables.behind(variables.arity + place));
        let all: Vec<&Polynomial> = variables.of_fraction(&self.fraction).into_iter().chain(behind).collect();
        let has = |k: &usize| all.iter().any(|polynomial| polynomial.degree_in(*k) > 0);
        (0..variables.arity).filter(has).collect()
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
}

impl Symbolic {
    /// It as a function of its arguments.
    pub fn settled(&self) -> Settled {
        let variables = Variables::of(self);
        Settled { needed: variables.needed(&self.fraction), variables, fraction: self.fraction.clone() }
    }
}

impl Valued for Settled {
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        let like = at.first().ok_or(ArithmeticError::Domain("a variable"))?;
        let mut point = at.to_vec();
        for (place, is_needed) in self.needed.iter().enumerate() {
            point.push(match is_needed {
                true => self.variables.meant(self.variables.arity + place, &point, like)?,
                false => like.zero(),
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
