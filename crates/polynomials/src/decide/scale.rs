//! Scales by which functions are compared far out: `x^a log(x)^b exp(sum c_k x^(e_k))`.

use super::Extended;
use arithmetic::{Number, Rational, rational};
use num_traits::Zero;
use std::cmp::Ordering;

/// `x^power log(x)^logs exp(sum c x^e)` with the pairs `(e, c)` by falling `e > 0`, `c` other than 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Scale {
    exponent: Vec<(Rational, Rational)>,
    power: Rational,
    logs: Rational,
}

impl Scale {
    pub fn one() -> Self {
        Scale { exponent: Vec::new(), power: rational(0, 1), logs: rational(0, 1) }
    }

    /// `x^power`.
    pub fn power(power: Rational) -> Self {
        Scale { power, ..Scale::one() }
    }

    /// `log(x)`.
    pub fn log() -> Self {
        Scale { logs: rational(1, 1), ..Scale::one() }
    }

    pub fn times(&self, other: &Self) -> Self {
        let mut exponent = self.exponent.clone();
        for (e, c) in &other.exponent {
            match exponent.iter_mut().find(|own| own.0 == *e) {
                Some(own) => own.1 += c,
                None => exponent.push((e.clone(), c.clone())),
            }
        }
        exponent.retain(|own| !own.1.is_zero());
        exponent.sort_by(|a, b| b.0.cmp(&a.0));
        Scale { exponent, power: &self.power + &other.power, logs: &self.logs + &other.logs }
    }

    pub fn raised(&self, q: &Rational) -> Self {
        let mut exponent: Vec<_> = self.exponent.iter().map(|(e, c)| (e.clone(), c * q)).collect();
        exponent.retain(|own| !own.1.is_zero());
        Scale { exponent, power: &self.power * q, logs: &self.logs * q }
    }

    pub fn over(&self, other: &Self) -> Self {
        self.times(&other.raised(&rational(-1, 1)))
    }

    /// Whether it grows without bound (greater), falls to 0 (less), or is 1.
    pub fn growth(&self) -> Ordering {
        let zero = rational(0, 1);
        let lead = self.exponent.first().map_or(Ordering::Equal, |own| own.1.cmp(&zero));
        lead.then_with(|| self.power.cmp(&zero)).then_with(|| self.logs.cmp(&zero))
    }

    /// `exp(c s)` as a scale, where that is one: `s` is a power that grows, or the logarithm.
    pub fn exponential(&self, c: &Rational) -> Option<Self> {
        match (self.exponent.is_empty(), self.logs.is_zero(), self.power.is_zero()) {
            (true, true, false) => Some(Scale { exponent: vec![(self.power.clone(), c.clone())], ..Scale::one() }),
            (true, false, true) if self.logs == rational(1, 1) => Some(Scale::power(c.clone())),
            _ => None,
        }
    }

    /// Its logarithm as multiples of scales; `None` where the logarithm of a logarithm is in it.
    pub fn logarithm(&self) -> Option<Vec<(Scale, Rational)>> {
        let powers = self.exponent.iter().map(|(e, c)| (Scale::power(e.clone()), c.clone()));
        let log = (!self.power.is_zero()).then(|| (Scale::log(), self.power.clone()));
        self.logs.is_zero().then(|| powers.chain(log).collect())
    }

    /// Encloses it for all `x` from a number above 1 on; `None` where it cannot be shown that it only grows, or only falls, from there.
    pub fn enclosed(&self, from: &Extended) -> Option<Extended> {
        match self.growth() {
            Ordering::Equal => Some(Extended::between(1.0, 1.0)),
            Ordering::Less => Some(Extended::between(0.0, self.largest(from)?)),
            Ordering::Greater => {
                let inverse = self.raised(&rational(-1, 1)).largest(from)?;
                let least = arithmetic::Field::recip(&Extended::between(inverse, inverse)).ok()?.lo;
                Some(Extended::between(least.max(0.0), f64::INFINITY))
            }
        }
    }

    /// The value at `from` of one that falls to 0, from above, if it falls from there on: the slope of its logarithm, over the leading power of `x`, is negative.
    fn largest(&self, from: &Extended) -> Option<f64> {
        let log = from.ln().ok().filter(|log| log.defined && log.lo > 0.0)?;
        let of = Extended::of;
        let lead = self.exponent.first().map_or_else(|| rational(0, 1), |own| own.0.clone());
        // From there on `x^-e` lies between 0 and its value there.
        let falling = |e: &Rational| -> Option<Extended> {
            let there = (log * of(&-e.clone())).exp().ok()?;
            Some(if e.is_zero() { Extended::between(1.0, 1.0) } else { Extended::between(0.0, there.hi) })
        };
        let inverse = Extended::between(0.0, arithmetic::Field::recip(&log).ok()?.hi);
        let mut slope = (of(&self.power) + of(&self.logs) * inverse) * falling(&lead)?;
        for (e, c) in &self.exponent {
            slope = slope + of(&(e * c)) * falling(&(&lead - e))?;
        }
        let falls = slope.hi < 0.0 || self.exponent.is_empty() && self.power.is_zero();
        let mut there = of(&self.power) * log + of(&self.logs) * log.ln().ok()?;
        for (e, c) in &self.exponent {
            there = there + of(c) * (log * of(e)).exp().ok()?;
        }
        falls.then(|| there.exp().ok()).flatten().map(|value| value.hi)
    }
}
