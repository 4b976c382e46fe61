//! The worst case over orders of modes to a number of digits: in floats first, and where they do not reach in dyadic intervals, on the boxes that are left.

use crate::family::Family;
use crate::flow::Flows;
use crate::orders::{Orders, Times, orders};
use crate::prepared::Prepared;
use crate::relaxed::Relaxed;
use crate::scalar::Scalar;
use crate::search::{Best, Found, Goal, Open, Search, allowance};
use crate::system::{Range, Switching};
use crate::walk::Depth;
use arithmetic::{Cancelled, Enclosure, FloatInterval, Interval, Progress, Rational, rational};
use num_traits::Zero;
use rayon::prelude::*;
use std::cell::RefCell;

/// The greatest value of a row over all inputs, starts and orders of modes.
#[derive(Debug, Clone, Default)]
pub(crate) struct Worst {
    /// It lies between the two; attained values reach the lower one, where there is any.
    pub lo: Option<Rational>,
    /// No value is above it, where there is a bound.
    pub hi: Option<Rational>,
    /// When it is attained: the hull of all times that are not excluded.
    pub at: Option<Range>,
    /// The legs, backwards, of the order of modes that attains the lower end, and their durations.
    pub legs: Vec<(usize, Rational)>,
    /// Whether no motion attains the upper end.
    pub is_unattained: bool,
    /// Whether the value never changes along a motion.
    pub stays: bool,
}

impl Worst {
    /// What is found of a row that obeys an equation of its own. A value that never rises is attained at time 0, one that stays at all times.
    pub fn with(self, known: &Relaxed, at: Option<&Rational>) -> Self {
        let is_first = known.most == known.begun;
        let at_start = at.is_none_or(Zero::is_zero);
        if is_first && (at_start || known.stays && self.lo.is_some()) {
            let value = Some(known.begun.clone());
            let legs = if at_start { Vec::new() } else { self.legs };
            let at = Some(Range::point(at.cloned().unwrap_or_default()));
            return Worst { lo: value.clone(), hi: value, at, legs, is_unattained: false, stays: known.stays };
        }
        if self.hi.as_ref().is_some_and(|hi| *hi < known.most) {
            return self;
        }
        // Whoever asks for all times is not told when what is never attained is.
        let shown = if at.is_none() && !is_first { None } else { self.at };
        Worst { hi: Some(known.most.clone()), at: shown, is_unattained: !is_first, ..self }
    }

    /// Whether both ends agree to so many digits.
    pub fn is_closed(&self, digits: u32) -> bool {
        let (Some(lo), Some(hi)) = (&self.lo, &self.hi) else { return false };
        hi - lo <= allowance(&tolerance(digits), hi)
    }
}

/// Four units of the digit after the last.
fn tolerance(digits: u32) -> Rational {
    (0..=digits).fold(rational(4, 1), |x, _| x * rational(1, 10))
}

/// What stays the same for all rows: orders, their flows in floats.
pub(crate) struct Solver<'a> {
    prepared: &'a Prepared,
    orders: Orders,
    flows: Flows<FloatInterval>,
    digits: u32,
    /// Most boxes where several durations vary.
    boxes: usize,
    progress: &'a dyn Progress,
}

/// Most boxes of one search over times.
const BOXES: usize = 20_000;

/// Most boxes of one search over the durations of several modes: fewer where each takes longer, and where their order is free too.
fn boxes_of_several(switching: &Switching, states: usize) -> usize {
    match switching {
        Switching::Dwell { .. } => (40_000 / (states * states)).clamp(200, 10_000),
        _ => (200_000 / (states * states)).clamp(1000, 20_000),
    }
}

impl<'a> Solver<'a> {
    /// None where there is no list of orders.
    pub fn new(
        prepared: &'a Prepared,
        switching: &Switching,
        times: &Times,
        digits: u32,
        progress: &'a dyn Progress,
    ) -> Option<Self> {
        let orders = orders(switching, prepared.motions.len(), &prepared.start, times)?;
        let flows = Flows::new(&prepared.motions, &orders.longest, &orders.chain, &FloatInterval::point(0.0));
        let boxes = boxes_of_several(switching, prepared.order());
        Some(Solver { prepared, orders, flows, digits, boxes, progress })
    }

    /// The greatest value of `row x`.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn greatest(&self, row: &[Rational]) -> Result<Worst, Cancelled> {
        let whole = self.orders.families.iter().enumerate().map(|(i, family)| (i, family.variables.clone())).collect();
        let tolerance = tolerance(self.digits);
        let mut found = self.search(&self.flows, &FloatInterval::point(0.0), row, &tolerance, 24, whole)?;
        let most = found.best.as_ref().map(|best| &best.value + allowance(&tolerance, &best.value));
        let enough =
            |bound: &Option<Rational>| most.as_ref().zip(bound.as_ref()).is_some_and(|(most, bound)| bound <= most);
        // What only bounds, and by far too much, is not made better by digits but by looking further back.
        let far = |found: &Found| {
            let gap = found.above.as_ref().zip(found.best.as_ref()).map(|(above, best)| above - &best.value);
            gap.is_some_and(|gap| gap > rational(1, 1_000_000_000))
                && found.open.iter().any(|open| !self.orders.families[open.family].attained)
        };
        if !enough(&found.above) && !far(&found) && found.best.is_some() && self.digits > 8 {
            // Where a greatest value is attained all along, many boxes are level with it: they are done.
            let (level, rest): (Vec<Open>, Vec<Open>) =
                found.open.iter().cloned().partition(|open| enough(&open.bound));
            if rest.len() < 1000 {
                found = self.finer(row, &tolerance, found, level, rest)?;
            }
        }
        Ok(self.worst(&found))
    }

    /// The search in dyadic intervals on the boxes of another that are not done.
    fn finer(
        &self,
        row: &[Rational],
        tolerance: &Rational,
        found: Found,
        level: Vec<Open>,
        rest: Vec<Open>,
    ) -> Result<Found, Cancelled> {
        let bits = 80 + (f64::from(self.digits) * std::f64::consts::LOG2_10) as u32;
        let like = Interval::from_rational(&Rational::ZERO, bits);
        let flows = Flows::new(&self.prepared.motions, &self.orders.longest, &self.orders.chain, &like);
        let rest = rest.into_iter().map(|open| (open.family, open.variables)).collect();
        let finer = self.search(&flows, &like, row, tolerance, bits / 2, rest)?;
        // Boxes that are in neither list are below the value that was attained before.
        let best = finer.best.into_iter().chain(found.best).reduce(|a, b| if b.value > a.value { b } else { a });
        let attained = best.as_ref().map(|best| &best.value);
        let level = level.into_iter().filter(|open| open.bound.as_ref() >= attained);
        let open: Vec<Open> = level.chain(finer.open).collect();
        let bounds = open.iter().map(|open| open.bound.as_ref()).chain([attained, finer.above.as_ref()]);
        let above = bounds.collect::<Option<Vec<_>>>().and_then(|bounds| bounds.into_iter().max().cloned());
        Ok(Found { above: above.or(found.above), best, open })
    }

    /// The greatest values of rows, side by side.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn all(&self, rows: &[Vec<Rational>]) -> Result<Vec<Worst>, Cancelled> {
        rows.par_iter().map(|row| self.greatest(row)).collect()
    }

    /// An upper bound of the row over a stretch of time, in floats, where the order of modes is fixed.
    pub fn over(&self, row: &[Rational], time: &Range) -> Option<f64> {
        let row: Vec<FloatInterval> = row.iter().map(FloatInterval::from_rational).collect();
        let (mut most, mut covered) = (f64::NEG_INFINITY, Rational::ZERO);
        for family in &self.orders.families {
            let [range] = &family.variables[..] else { continue };
            let begun = family.time(std::slice::from_ref(&Range::point(range.lo.clone()))).lo - &range.lo;
            let part =
                Range { lo: (&time.lo - &begun).max(range.lo.clone()), hi: (&time.hi - &begun).min(range.hi.clone()) };
            if part.lo < part.hi {
                covered += &part.hi - &part.lo;
                most = most.max(self.most(family, &row, part)?);
            }
        }
        (covered == &time.hi - &time.lo).then_some(most)
    }

    /// An upper bound over an interval of durations: at an end where the derivative has a sign, or else by the mean value.
    fn most(&self, family: &Family, row: &[FloatInterval], part: Range) -> Option<f64> {
        let slopes = family.worst(&self.flows, row, std::slice::from_ref(&part), Depth::Slopes).slopes;
        let [slope] = &slopes[..] else { return None };
        let place = match slope {
            slope if slope.lo() >= 0.0 => part.hi.clone(),
            slope if slope.hi() <= 0.0 => part.lo.clone(),
            _ => part.centre(),
        };
        let value = family.worst(&self.flows, row, &[Range::point(place.clone())], Depth::Value).value?;
        let away = slope.around(&(&part.lo - &place), &(&part.hi - &place));
        let reach = if place == part.centre() { (*slope * away).hi() } else { 0.0 };
        Some((value + FloatInterval::point(reach)).hi())
    }

    fn search<T: Scalar>(
        &self,
        flows: &Flows<T>,
        like: &T,
        row: &[Rational],
        tolerance: &Rational,
        bits: u32,
        boxes: Vec<(usize, Vec<Range>)>,
    ) -> Result<Found, Cancelled> {
        let finest = (0..bits).fold(rational(1, 1), |x, _| x * rational(1, 2));
        let several = self.orders.families.iter().any(|family| family.variables.len() > 1);
        let goal = Goal { tolerance: tolerance.clone(), finest, boxes: if several { self.boxes } else { BOXES } };
        let row = row.iter().map(|q| like.rational(q)).collect();
        Search { flows, row, families: &self.orders.families, goal, progress: self.progress, known: RefCell::default() }
            .run(boxes)
    }

    fn worst(&self, found: &Found) -> Worst {
        // Durations may be free to sum up to more than the time that is looked at.
        let times = found.open.iter().map(|open| {
            let family = &self.orders.families[open.family];
            let Range { lo, hi } = family.time(&open.variables);
            Range { lo, hi: family.most.iter().cloned().chain([hi]).min().unwrap_or_default() }
        });
        let at = times.reduce(|a, b| Range { lo: a.lo.min(b.lo), hi: a.hi.max(b.hi) });
        let legs = found.best.as_ref().map_or_else(Vec::new, |best| self.legs(best));
        Worst {
            lo: found.best.as_ref().map(|best| best.value.clone()),
            hi: found.above.clone(),
            at,
            legs,
            ..Worst::default()
        }
    }

    fn legs(&self, best: &Best) -> Vec<(usize, Rational)> {
        let family: &Family = &self.orders.families[best.family];
        let legs = family.legs(&crate::family::points(&best.variables));
        legs.into_iter().map(|leg| (leg.mode, leg.duration.lo)).collect()
    }
}
