//! Numbers at which what stands inside a function is a rational number: roots of polynomials of any degree, and of equations such as `exp(x) = x + 2`. Floats propose
//! the equation, Newton's method in intervals proves that it has one solution there, and the equation itself says which values are 0 at it.

use super::exact::Exact;
use super::places::{Place, simple};
use crate::function::{Function, Side};
use crate::symbolic::{Extension, Settled, Symbolic};
use arithmetic::{ArithmeticError, Dual, Field, Interval, Number, PreciseNumber, Rational, RealNumber, rational};
use num_bigint::BigInt;
use std::sync::Arc;

/// How far a float may be from a solution, after Newton's method, and how wide the interval around it is.
const REACH: f64 = 1e-6;

/// How far floats of flat functions may be from where they are 0, and so their parts from their values.
const FAR: f64 = 1e-4;

/// Largest denominator of the value of a part.
const DENOMINATOR: i64 = 24;

/// Of more parts no differences are looked at.
const MOST_PAIRED: usize = 5;

/// Bits of the numbers, and of the enclosure of a solution that is looked for.
const BITS: u32 = 420;
const WANTED: i64 = 300;

/// A part of a function that has a value, as an equation for one of its arguments.
#[derive(Debug, Clone)]
pub(super) struct Equation {
    part: Arc<Settled>,
    arity: usize,
    variable: usize,
    value: Rational,
}

/// The same equation, and not one that says the same.
impl PartialEq for Equation {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.part, &other.part) && self.value == other.value
    }
}

impl Equation {
    /// How far the part is from its value at a number.
    fn at<T: Number>(&self, x: &T) -> Result<T, ArithmeticError> {
        let point: Vec<T> = (0..self.arity).map(|k| if k == self.variable { x.clone() } else { x.zero() }).collect();
        Ok(self.part.value(&point)? - x.rational(&self.value))
    }

    /// Newton's method in floats; nothing where it leads away.
    fn approached(&self, start: f64) -> Option<f64> {
        const STEPS: usize = 6;
        let mut x = start;
        for _ in 0..STEPS {
            let at = self.at(&Dual::new(x, 1.0)).ok()?;
            x -= at.value / at.derivative;
        }
        ((x - start).abs() <= 10.0 * FAR * start.abs().max(1.0)).then_some(x)
    }

    /// The ends of an interval around the only solution near a float: the slope is nowhere 0 on a wider one, and Newton's operator maps that into its inside.
    fn solution(&self, x: f64) -> Option<(Rational, Rational)> {
        const STEPS: usize = 12;
        let scale = Rational::from_integer(BigInt::from(1) << BITS);
        let rounded = |q: Rational, up: bool| {
            let scaled = q * &scale;
            (if up { scaled.ceil() } else { scaled.floor() }) / &scale
        };
        let (middle, reach) = (Rational::from_float(x)?, Rational::from_float(REACH * x.abs().max(1.0))?);
        let (mut lo, mut hi) = (&middle - &reach, middle + reach);
        let narrow = rational(1, 1) / Rational::from_integer(BigInt::from(1) << WANTED);
        for step in 0..STEPS {
            let middle = rounded((&lo + &hi) * rational(1, 2), false);
            let whole = RealNumber::interval(Interval::hull_of_rationals(&lo, &hi, BITS));
            let one = PreciseNumber::exact(rational(1, 1), BITS);
            let moving = Dual::new(PreciseNumber { number: whole, precision: BITS }, one.clone());
            let slope = self.at(&moving).ok()?.derivative;
            let change = self.at(&PreciseNumber::exact(middle.clone(), BITS)).ok()?;
            let (least, most) = change.over(&slope).ok()?.number.enclosure(BITS).to_rationals();
            let (from, to) = (&middle - most, middle - least);
            if step == 0 && !(lo < from && to < hi) {
                return None;
            }
            (lo, hi) = (rounded(from.max(lo), false), rounded(to.min(hi), true));
            if &hi - &lo <= narrow {
                return Some((lo, hi));
            }
        }
        None
    }

    /// The solution as a number of which the equation is known.
    pub fn put(&self, (lo, hi): (&Rational, &Rational), one: &Exact) -> Option<Exact> {
        let unknown = one.unknown(lo, hi);
        self.at(&unknown).ok()?.is_zero_from_now();
        Some(unknown)
    }
}

/// A function, what stands inside the functions that it consists of and, of few, the differences of these, where numbers near simple ones are these.
fn parts<F: Function>(function: &F, x: &[f64], sides: &[Side]) -> Vec<Symbolic> {
    let extension = Extension::listening(sides.len());
    let known = |((own, x), side): ((Symbolic, &f64), &Side)| {
        let number = side.as_point().cloned().or_else(|| near_to(*x, REACH));
        number.map_or_else(|| own.clone(), |q| own.rational(&q))
    };
    let arguments: Vec<Symbolic> = extension.arguments().into_iter().zip(x).zip(sides).map(known).collect();
    // Where it has no value as a whole, its parts may have.
    let whole = function.value(&arguments);
    let mut all: Vec<Symbolic> = extension.heard();
    if all.len() <= MOST_PAIRED {
        let pairs = (0..all.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        let differences: Vec<Symbolic> = pairs.map(|(i, j)| all[i].clone() - &all[j]).collect();
        all.extend(differences);
    }
    all.extend(whole);
    all
}

/// For each number of a point those near it at which a part of a function is rational.
pub(super) fn near<F: Function>(function: &F, x: &[f64], sides: &[Side]) -> Vec<Vec<Place>> {
    let mut found: Vec<Vec<Place>> = vec![Vec::new(); sides.len()];
    for part in parts(function, x, sides) {
        let [variable] = part.depends_on()[..] else { continue };
        let settled = part.settled();
        let Some(value) = settled.value(x).ok().and_then(|value| near_to(value, FAR)) else { continue };
        let equation = Equation { part: Arc::new(settled), arity: sides.len(), variable, value };
        if let Some((lo, hi)) = equation.approached(x[variable]).and_then(|x| equation.solution(x)) {
            found[variable].push(Place::solution(equation, lo, hi));
        }
    }
    found
}

/// A simple rational near a float.
fn near_to(x: f64, reach: f64) -> Option<Rational> {
    simple(x, reach * x.abs().max(1.0), DENOMINATOR)
}
