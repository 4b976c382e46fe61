//! The orders of modes that are looked at, each a family: legs backwards in time whose durations are sums of variables in a box.

use crate::flow::Flows;
use crate::scalar::Scalar;
use crate::system::Range;
use crate::walk::{Depth, Leg, Sums, worst};
use arithmetic::{Rational, rational};
use num_traits::{Signed, Zero};

/// The duration of a leg: a constant plus variables, or minus them.
#[derive(Debug, Clone)]
pub(crate) struct Length {
    pub mode: usize,
    pub constant: Rational,
    pub terms: Vec<(usize, bool)>,
    /// See [`Leg::start`].
    pub start: Option<usize>,
}

impl Length {
    pub fn fixed(mode: usize, constant: Rational) -> Self {
        Length { mode, constant, terms: Vec::new(), start: None }
    }

    pub fn variable(mode: usize, index: usize) -> Self {
        Length { mode, constant: Rational::ZERO, terms: vec![(index, false)], start: None }
    }
}

/// Legs, the box of their variables, and where the states are before the last leg.
#[derive(Debug, Clone)]
pub(crate) struct Family {
    pub legs: Vec<Length>,
    pub variables: Vec<Range>,
    /// The legs together last at most so long.
    pub most: Option<Rational>,
    /// The leg that ends at the time that is looked at lasts at most so long.
    pub latest: Option<Rational>,
    pub start: Vec<Range>,
    /// Whether the start is that of the system, so that a value here is attained; otherwise it only bounds.
    pub attained: bool,
}

/// One box of a family: all of it may be allowed, some, or none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Allowed {
    All,
    Some,
    None,
}

impl Family {
    fn length(&self, leg: &Length, variables: &[Range]) -> Range {
        let mut sum = Range::point(leg.constant.clone());
        for &(index, minus) in &leg.terms {
            let range = &variables[index];
            let (lo, hi) =
                if minus { (-range.hi.clone(), -range.lo.clone()) } else { (range.lo.clone(), range.hi.clone()) };
            sum = Range { lo: sum.lo + lo, hi: sum.hi + hi };
        }
        sum
    }

    /// How long all legs last together, from least to most.
    pub fn time(&self, variables: &[Range]) -> Range {
        let mut total = Length { mode: 0, constant: Rational::ZERO, terms: Vec::new(), start: None };
        // Variables that are in one leg and out of another cancel.
        let mut signs = vec![0i64; variables.len()];
        for leg in &self.legs {
            total.constant += &leg.constant;
            leg.terms.iter().for_each(|&(index, minus)| signs[index] += if minus { -1 } else { 1 });
        }
        for (index, sign) in signs.iter().enumerate() {
            (0..sign.abs()).for_each(|_| total.terms.push((index, *sign < 0)));
        }
        self.length(&total, variables)
    }

    /// Whether the legs of a box are durations that are not negative, and together not too long.
    pub fn allowed(&self, variables: &[Range]) -> Allowed {
        let lengths: Vec<Range> = self.legs.iter().map(|leg| self.length(leg, variables)).collect();
        let time = self.time(variables);
        let over = |x: &Rational| self.most.as_ref().is_some_and(|most| x > most);
        if lengths.iter().any(|length| length.hi.is_negative()) || over(&time.lo) {
            return Allowed::None;
        }
        let latest = |x: &Rational| self.latest.as_ref().is_some_and(|latest| x > latest);
        if lengths.first().is_some_and(|length| latest(&length.lo)) {
            return Allowed::None;
        }
        let kept = lengths.first().is_none_or(|length| !latest(&length.hi));
        let all = kept && lengths.iter().all(|length| !length.lo.is_negative()) && !over(&time.hi);
        if all { Allowed::All } else { Allowed::Some }
    }

    /// A point of the box that is allowed: its middle, else the middle at the least of the first variable, else the lowest corner.
    pub fn point(&self, variables: &[Range]) -> Option<Vec<Rational>> {
        let middle: Vec<Rational> = variables.iter().map(Range::centre).collect();
        let corner: Vec<Rational> = variables.iter().map(|range| range.lo.clone()).collect();
        let mut mixed = middle.clone();
        if let (Some(first), Some(least)) = (mixed.first_mut(), corner.first()) {
            *first = least.clone();
        }
        [middle, mixed, corner].into_iter().find(|point| self.allowed(&points(point)) == Allowed::All)
    }

    /// The legs of a box.
    pub fn legs(&self, variables: &[Range]) -> Vec<Leg> {
        let leg = |leg: &Length| {
            let mut duration = self.length(leg, variables);
            duration.lo = duration.lo.max(Rational::ZERO);
            duration.hi = duration.hi.max(Rational::ZERO);
            Leg { mode: leg.mode, duration, varies: !leg.terms.is_empty(), start: leg.start }
        };
        self.legs.iter().map(leg).collect()
    }

    /// The worst case over a box of variables, with derivatives by the variables.
    pub fn worst<T: Scalar>(&self, flows: &Flows<T>, row: &[T], variables: &[Range], depth: Depth) -> Sums<T> {
        let mut sums = worst(flows, row, &self.legs(variables), &self.start, depth);
        let mut slopes = vec![row[0].zero(); variables.len()];
        let varying = self.legs.iter().filter(|leg| !leg.terms.is_empty());
        for (leg, slope) in varying.zip(&sums.slopes) {
            for &(index, minus) in &leg.terms {
                slopes[index] = if minus { slopes[index].clone() - slope } else { slopes[index].clone() + slope };
            }
        }
        sums.slopes = slopes;
        // The second derivative is that by one duration that is one variable.
        if variables.len() != 1 || self.legs.iter().filter(|leg| !leg.terms.is_empty()).count() != 1 {
            sums.curvature = None;
        }
        sums
    }
}

/// A box of one point.
pub(crate) fn points(point: &[Rational]) -> Vec<Range> {
    point.iter().map(|x| Range::point(x.clone())).collect()
}

/// The two halves of a range.
pub(crate) fn halves(range: &Range) -> [Range; 2] {
    let middle = dyadic_near(&range.centre(), &(&range.hi - &range.lo));
    [Range { lo: range.lo.clone(), hi: middle.clone() }, Range { lo: middle, hi: range.hi.clone() }]
}

/// A number with few digits within an eighth of the width.
pub(crate) fn dyadic_near(x: &Rational, width: &Rational) -> Rational {
    if width.is_zero() {
        return x.clone();
    }
    let mut unit = Rational::ONE;
    let (half, two) = (rational(1, 2), rational(2, 1));
    let fine = width * rational(1, 8);
    while unit > fine {
        unit *= &half;
    }
    while &unit * &two <= fine {
        unit *= &two;
    }
    (x / &unit).floor() * unit
}
