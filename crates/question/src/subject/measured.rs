//! What the rows of the observables give, as numbers of the language.

use crate::error::Problem;
use crate::failure::Failure;
use crate::names::Quantity;
use crate::number::Number;
use crate::timeline::Measured;
use arithmetic::{Dyadic, FloatInterval, Interval, Number as _, PreciseNumber, Rational};
use motion::enclose::Expanded;
use num_traits::ToPrimitive;
use scenario::{AffineNumber, Amount};

/// A scalar in which observables are measured for questions.
pub(crate) trait Scalar: Sized {
    /// The number.
    fn number(self) -> Number;

    /// The root of a number that is not negative; `None` where it is not found.
    fn root(self, precision: u32) -> Option<Number>;

    /// An enclosure in which nothing of the start is left, where the number is a polynomial in it.
    fn boxed(&self) -> Option<Interval> {
        None
    }
}

impl Scalar for Rational {
    fn number(self) -> Number {
        Number::Exact(self)
    }

    fn root(self, precision: u32) -> Option<Number> {
        Number::Exact(self).sqrt(precision).ok()
    }
}

impl Scalar for PreciseNumber {
    fn number(self) -> Number {
        self.number
    }

    fn root(self, precision: u32) -> Option<Number> {
        self.number.sqrt(precision).ok()
    }
}

impl Scalar for AffineNumber {
    fn number(self) -> Number {
        self.plain().number
    }

    fn root(self, precision: u32) -> Option<Number> {
        Scalar::root(self.plain(), precision)
    }
}

impl Scalar for Interval {
    fn number(self) -> Number {
        Number::interval(self)
    }

    /// It is not negative, whatever rounding says.
    fn root(self, _: u32) -> Option<Number> {
        let zero = Dyadic::zero();
        let from = |end: &Dyadic| end.clone().max(zero.clone());
        Interval::between(from(self.lo()), from(self.hi()), self.precision()).sqrt().ok().map(Number::interval)
    }
}

impl Scalar for Expanded {
    fn number(self) -> Number {
        Number::interval(between_floats(&self.range()))
    }

    fn root(self, precision: u32) -> Option<Number> {
        Scalar::root(between_floats(&self.range()), precision)
    }

    fn boxed(&self) -> Option<Interval> {
        Some(between_floats(&self.natural()))
    }
}

/// Bits of what is enclosed between floats.
pub(crate) const BITS: u32 = 64;

/// The same enclosure with long ends.
pub(crate) fn between_floats(x: &FloatInterval) -> Interval {
    let end = |x: f64| Dyadic::from_f64(x);
    match (end(x.lo()), end(x.hi())) {
        (Some(lo), Some(hi)) => Interval::between(lo, hi, BITS),
        _ => {
            // Unbounded: nothing is known.
            let far = Dyadic::new(1.into(), 4096);
            Interval::between(far.negated(), far, BITS)
        }
    }
}

/// Most moments of phases.
const MOST_ORDERS: usize = 64;

/// Which of the numbers of a list is asked for, from 1.
pub(crate) fn index_of(quantity: &Quantity, arguments: &[Number]) -> Result<usize, Failure> {
    let (most, expected) = match (quantity.arguments, quantity.name) {
        ([], _) => return Ok(1),
        (_, "momentum") => (2, "1 or 2".to_string()),
        _ => (MOST_ORDERS, format!("an integer from 1 to {MOST_ORDERS}")),
    };
    // The first one is meant where one number is enough.
    if arguments.is_empty() && most == MOST_ORDERS {
        return Ok(1);
    }
    let index = arguments.first().and_then(Number::as_integer).and_then(|k| k.to_usize());
    index.filter(|k| (1..=most).contains(k)).ok_or_else(|| {
        let found = arguments.first().map_or(String::new(), Number::text);
        Failure::Refused(0, Problem::Range { what: format!("the index of `{}`", quantity.name), expected, found })
    })
}

/// What was measured, of a list the entry with that index.
pub(crate) fn measured<T: Scalar>(amount: Amount<T>, index: usize, precision: u32) -> Result<Measured, Failure> {
    let unknown = || Failure::open("it has no value", None);
    Ok(Measured::Number(match amount {
        Amount::Number(x) => x.number(),
        Amount::Root(x) => x.root(precision).ok_or_else(unknown)?,
        Amount::Count(Some([least, most])) if least == most => Number::integer(least as i64),
        Amount::Count(Some(ends)) => {
            let [least, most] = ends.map(|count| Number::integer(count as i64).enclosure(precision));
            Number::interval(least.hull(&most))
        }
        Amount::Count(None) => return Err(unknown()),
        Amount::List(list) => {
            let entry = list.into_iter().nth(index - 1).ok_or_else(unknown)?;
            return measured(entry, index, precision);
        }
        Amount::Unknown(why) => return Err(Failure::open(why, None)),
    }))
}
