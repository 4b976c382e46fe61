//! The greatest worst case over families of orders of modes: best box first, with the mean value form, faces where a derivative has a sign, and
//! near a maximum the bound of a concave function by one tangent.

use crate::family::{Allowed, Family, dyadic_near, halves, points};
use crate::flow::Flows;
use crate::scalar::Scalar;
use crate::system::Range;
use crate::walk::{Depth, Sums};
use arithmetic::{Cancelled, Progress, Rational, rational};
use num_traits::Signed;
use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::{BinaryHeap, HashMap};

/// What was found.
#[derive(Debug, Clone)]
pub(crate) struct Found {
    /// No value is above it, where there is a bound.
    pub above: Option<Rational>,
    /// A value that is attained, with its family and variables; none where no allowed point was met.
    pub best: Option<Best>,
    /// The boxes that may hold a value as great as the one attained.
    pub open: Vec<Open>,
}

/// A box of a family.
#[derive(Debug, Clone)]
pub(crate) struct Open {
    pub family: usize,
    pub variables: Vec<Range>,
    /// No value in it is above this, where there is a bound.
    pub bound: Option<Rational>,
}

/// A value that is attained.
#[derive(Debug, Clone)]
pub(crate) struct Best {
    pub value: Rational,
    pub family: usize,
    pub variables: Vec<Rational>,
}

/// When to stop.
#[derive(Debug, Clone)]
pub(crate) struct Goal {
    /// The greatest value and the bound differ by at most so much, relative where the value is above 1.
    pub tolerance: Rational,
    /// Boxes are not cut below this width.
    pub finest: Rational,
    /// At most so many boxes.
    pub boxes: usize,
}

struct Node {
    family: usize,
    variables: Vec<Range>,
    /// No value in the box is above it, where there is a bound.
    bound: Option<Rational>,
    /// The maximum inside is known as well as it can be.
    closed: bool,
    number: usize,
}

impl PartialEq for Node {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Node {}

impl PartialOrd for Node {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Node {
    fn cmp(&self, other: &Self) -> Ordering {
        let bounds = match (&self.bound, &other.bound) {
            (Some(a), Some(b)) => a.cmp(b),
            (a, b) => b.is_some().cmp(&a.is_some()),
        };
        bounds.then_with(|| other.number.cmp(&self.number))
    }
}

/// One search.
pub(crate) struct Search<'a, T> {
    pub flows: &'a Flows<T>,
    pub row: Vec<T>,
    pub families: &'a [Family],
    pub goal: Goal,
    pub progress: &'a dyn Progress,
    /// Values at points that were visited: the middle of a box is an end of its halves.
    pub known: RefCell<HashMap<(usize, Vec<Rational>), T>>,
}

impl<T: Scalar> Search<'_, T> {
    /// The greatest worst case, from the boxes given.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn run(&self, boxes: Vec<(usize, Vec<Range>)>) -> Result<Found, Cancelled> {
        let mut best: Option<Best> = None;
        let mut heap = BinaryHeap::new();
        let mut waiting: Vec<(usize, Vec<Range>)> = boxes.into_iter().rev().collect();
        let (mut number, mut closed) = (0, Vec::<Node>::new());
        loop {
            while let Some((family, variables)) = waiting.pop() {
                self.progress.checkpoint()?;
                number += 1;
                if let Some(node) = self.node(family, variables, number, &mut best) {
                    heap.push(node);
                }
            }
            let Some(node) = heap.pop() else { break };
            let near = best.as_ref().zip(node.bound.as_ref());
            let near = near.is_some_and(|(best, bound)| *bound <= &best.value + self.allowance(&best.value));
            if near || number >= self.goal.boxes {
                heap.push(node);
                break;
            }
            if node.closed {
                closed.push(node);
                continue;
            }
            let widest = (0..node.variables.len()).max_by_key(|&i| &node.variables[i].hi - &node.variables[i].lo);
            let Some(widest) = widest else { continue };
            for half in halves(&node.variables[widest]) {
                let mut variables = node.variables.clone();
                variables[widest] = half;
                waiting.push((node.family, variables));
            }
        }
        let all: Vec<Node> = heap.into_iter().chain(closed).collect();
        let value = best.as_ref().map(|best| best.value.clone());
        let mut above = value.clone().or_else(|| all.first().and_then(|node| node.bound.clone()));
        for node in &all {
            above = above.zip(node.bound.clone()).map(|(a, b)| a.max(b));
        }
        let may = |node: &Node| value.as_ref().zip(node.bound.as_ref()).is_none_or(|(value, bound)| bound >= value);
        let mut open: Vec<Node> = all.into_iter().filter(may).collect();
        open.sort_by_key(|node| node.number);
        let open = open.into_iter().map(|Node { family, variables, bound, .. }| Open { family, variables, bound });
        Ok(Found { above, best, open: open.collect() })
    }

    fn allowance(&self, value: &Rational) -> Rational {
        allowance(&self.goal.tolerance, value)
    }

    /// The value at a point, kept where it is the greatest so far.
    fn visit(&self, family: usize, point: &[Rational], depth: Depth, best: &mut Option<Best>) -> Sums<T> {
        let place = (family, point.to_vec());
        if depth == Depth::Value
            && let Some(value) = self.known.borrow().get(&place)
        {
            return Sums { value: Some(value.clone()), slopes: Vec::new(), curvature: None };
        }
        let sums = self.families[family].worst(self.flows, &self.row, &points(point), depth);
        if let Some(value) = &sums.value {
            self.known.borrow_mut().insert(place, value.clone());
        }
        if self.families[family].attained
            && let Some((value, _)) = sums.value.as_ref().and_then(|value| value.ends())
            && best.as_ref().is_none_or(|best| best.value < value)
        {
            *best = Some(Best { value, family, variables: point.to_vec() });
        }
        sums
    }

    /// Bounds the values of a box; none where nothing in it is allowed.
    fn node(&self, index: usize, mut variables: Vec<Range>, number: usize, best: &mut Option<Best>) -> Option<Node> {
        let family = &self.families[index];
        if family.allowed(&variables) == Allowed::None {
            return None;
        }
        let done = |variables: Vec<Range>, bound: Option<Rational>, closed: bool| {
            Some(Node { family: index, variables, bound, closed, number })
        };
        let depth = if variables.len() == 1 { Depth::Curvature } else { Depth::Slopes };
        let over = family.worst(self.flows, &self.row, &variables, depth);
        if family.allowed(&variables) == Allowed::All {
            for (range, slope) in variables.iter_mut().zip(&over.slopes) {
                if slope.lower() >= 0.0 {
                    *range = Range::point(range.hi.clone());
                } else if slope.upper() <= 0.0 {
                    *range = Range::point(range.lo.clone());
                }
            }
        }
        if variables.iter().all(Range::is_point) {
            let point: Vec<Rational> = variables.iter().map(|range| range.lo.clone()).collect();
            let sums = self.visit(index, &point, Depth::Value, best);
            let bound = above(sums.value);
            return done(variables, bound, true);
        }
        if let ([range], Some(curvature)) = (&variables[..], &over.curvature)
            && curvature.upper() < 0.0
            && let Some((found, bound)) = self.concave(index, range, curvature, best)
        {
            let enough = best.as_ref().is_some_and(|best| bound <= &best.value + self.allowance(&best.value));
            let closed = enough || &found.hi - &found.lo <= self.goal.finest;
            return done(vec![found], Some(bound), closed);
        }
        let middle: Vec<Rational> = match steepest(&variables, &over.slopes) {
            point if family.allowed(&points(&point)) == Allowed::All => point,
            _ => match family.point(&variables) {
                Some(point) => point,
                // The bound holds as well from a point that is not allowed, as long as its legs are durations.
                None => variables.iter().map(|range| range.lo.clone()).collect(),
            },
        };
        let known = family.allowed(&points(&middle)) == Allowed::All;
        let closed = variables.iter().all(|range| &range.hi - &range.lo <= self.goal.finest);
        if !known {
            // Nothing to start from: it is cut further, or bounded by the values of the whole box.
            let value = family.worst(self.flows, &self.row, &variables, Depth::Value).value;
            return done(variables, above(value), closed);
        }
        let Some(at) = self.visit(index, &middle, Depth::Value, best).value else {
            return done(variables, above::<T>(None), closed);
        };
        let ends = at.ends();
        let bound = over.slopes.iter().zip(&variables).zip(&middle).fold(at, |sum, ((slope, range), middle)| {
            let away = slope.around(&(&range.lo - middle), &(&range.hi - middle));
            sum + slope.clone() * away
        });
        let bound = above(Some(bound));
        // What adds less than the value itself is uncertain by is not made less by cutting.
        let flat = bound.as_ref().zip(ends).is_some_and(|(bound, (lo, hi))| bound - &hi <= hi - lo);
        done(variables, bound, closed || flat)
    }

    /// Newton steps to the maximum of a concave function of one variable on a range: where it is, and a bound. With second derivatives of
    /// at most `-k`, `F <= F(m) + F'(m)^2 / (2 k)`.
    fn concave(
        &self,
        index: usize,
        range: &Range,
        curvature: &T,
        best: &mut Option<Best>,
    ) -> Option<(Range, Rational)> {
        let like = curvature;
        let (_, flattest) = curvature.ends()?;
        let twice = like.rational(&(flattest * rational(-2, 1)));
        let (mut place, mut bound): (Range, Option<Rational>) = (range.clone(), None);
        let mut last: Option<(Rational, Rational)> = None;
        let mut point =
            dyadic_near(&range.centre(), &(&range.hi - &range.lo)).clamp(range.lo.clone(), range.hi.clone());
        for _ in 0..30 {
            let sums = self.visit(index, std::slice::from_ref(&point), Depth::Slopes, best);
            let slope = sums.slopes.first()?;
            let above = (sums.value? + slope.square().over(&twice).ok()?).ends()?.1;
            bound = Some(bound.map_or(above.clone(), |bound| bound.min(above)));
            let (low, high) = (like.rational(&point) - slope.clone().over(curvature).ok()?).ends()?;
            place = Range { lo: low.max(place.lo), hi: high.min(place.hi) };
            let enough = match (&*best, &bound) {
                (Some(best), Some(bound)) => *bound <= &best.value + self.allowance(&best.value),
                _ => false,
            };
            if enough || place.lo >= place.hi {
                break;
            }
            // The line through the last two derivatives; their rounding ends it.
            let here = slope.middle().ends()?.0;
            let secant = last.as_ref().filter(|(x, y)| *x != point && *y != here).map(|(x, y)| {
                let step = &here * (&point - x) / (&here - y);
                &point - step
            });
            let next = secant.unwrap_or_else(|| place.centre());
            let next = if next < place.lo || next > place.hi { place.centre() } else { next };
            let away = (&next - &point).abs();
            last = Some((point.clone(), here));
            let fine = &away * rational(1, 1 << 20);
            let next = dyadic_near(&next, &fine.max(&self.goal.finest * &self.goal.finest))
                .clamp(place.lo.clone(), place.hi.clone());
            if next == point {
                break;
            }
            point = next;
        }
        (place.lo <= place.hi).then_some(())?;
        Some((place, bound?))
    }
}

/// The point from which the mean value form tells most: of each variable the end from which values mostly fall, or else the middle.
fn steepest<T: Scalar>(variables: &[Range], slopes: &[T]) -> Vec<Rational> {
    let point = |(range, slope): (&Range, &T)| match (slope.lower(), slope.upper()) {
        (down, up) if -down >= 8.0 * up => range.lo.clone(),
        (down, up) if up >= -8.0 * down => range.hi.clone(),
        _ => range.centre(),
    };
    variables.iter().zip(slopes).map(point).collect()
}

/// The tolerance is relative where a value is above 1.
pub(crate) fn allowance(tolerance: &Rational, value: &Rational) -> Rational {
    tolerance * value.abs().max(Rational::ONE)
}

/// The upper end, where there is one.
fn above<T: Scalar>(value: Option<T>) -> Option<Rational> {
    value.and_then(|value| value.ends()).map(|(_, hi)| hi)
}
