//! The worst case at one time for one order of modes, walking backwards from that time, with its derivatives by the durations.
//!
//! `F(d_0, d_1, ..) = max c^T x(t)` over all inputs and starts, where the mode of leg 0 has lasted `d_0` at time `t`, that of leg 1 before it `d_1`, and
//! so on. With the costate `p`, `p' = A^T p` backwards in time and `p = c` at `t`,
//!
//! `F = sum over legs of the integral of (drift . p + sum_j radius_j |column_j . p|) + max over the start box of p . x`.
//!
//! By the envelope theorem the derivative by `d_i` is the integrand at the end of leg `i`, plus the same sum over the earlier legs with `p` replaced by its derivative
//! `A_i^T p` there and `|h|` by `sign(h) h'`. `notes/reach.md` has the derivation.

use crate::flow::{Flow, Flows};
use crate::scalar::{Scalar, apply, dot};
use crate::signs::{Expansion, Part};
use crate::system::Range;
use arithmetic::{Rational, Sign, rational};
use num_traits::Zero;

/// A mode and how long it lasts; one that may vary has a derivative by its duration.
#[derive(Debug, Clone)]
pub(crate) struct Leg {
    pub mode: usize,
    pub duration: Range,
    pub varies: bool,
    /// Which product takes the costate at the end of leg 0 to the start of this one, where the legs between are fixed.
    pub start: Option<usize>,
}

/// A worst case with its derivatives by the durations that vary, in the order of the legs.
#[derive(Debug, Clone)]
pub(crate) struct Sums<T> {
    pub value: T,
    pub slopes: Vec<T>,
    /// The second derivative where one duration varies; none where it does not exist or is not bounded.
    pub curvature: Option<T>,
}

/// Where, counted backwards from the time that is looked at, which input has which sign.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stretch {
    pub input: usize,
    pub from: Rational,
    pub to: Rational,
    pub positive: bool,
}

/// How much is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Depth {
    Value,
    Slopes,
    Curvature,
}

/// One walk.
pub(crate) struct Walk<'a, T> {
    flows: &'a Flows<T>,
    depth: Depth,
    value: Vec<T>,
    firsts: Vec<Vec<T>>,
    second: Option<Vec<T>>,
    sums: Sums<T>,
    /// Time walked so far, where it is a number.
    walked: Rational,
    trace: Option<Vec<Stretch>>,
}

/// The worst case with as many derivatives as are asked for. `start` is where the states are before the last leg.
pub(crate) fn worst<T: Scalar>(flows: &Flows<T>, row: &[T], legs: &[Leg], start: &[Range], depth: Depth) -> Sums<T> {
    let mut walk = Walk::new(flows, row, depth);
    walk.run(legs, start);
    walk.sums
}

/// The signs of the inputs and the start of a worst case, for durations that are numbers.
pub(crate) fn trace<T: Scalar>(flows: &Flows<T>, row: &[T], legs: &[Leg], start: &[Range]) -> (Vec<Stretch>, Vec<Rational>) {
    let mut walk = Walk::new(flows, row, Depth::Value);
    walk.trace = Some(Vec::new());
    walk.run(legs, start);
    let corner = |(range, p): (&Range, &T)| match p.sign() {
        Some(Sign::Positive) => range.hi.clone(),
        Some(Sign::Negative) => range.lo.clone(),
        _ => range.centre(),
    };
    (walk.trace.unwrap_or_default(), start.iter().zip(&walk.value).map(corner).collect())
}

impl<'a, T: Scalar> Walk<'a, T> {
    fn new(flows: &'a Flows<T>, row: &[T], depth: Depth) -> Self {
        let zero = row[0].zero();
        let sums = Sums { value: zero.clone(), slopes: Vec::new(), curvature: (depth == Depth::Curvature).then_some(zero) };
        let walked = Rational::ZERO;
        Walk { flows, depth, value: row.to_vec(), firsts: Vec::new(), second: None, sums, walked, trace: None }
    }

    fn run(&mut self, legs: &[Leg], start: &[Range]) {
        let mut base: Option<[Vec<Vec<T>>; 3]> = None;
        for (i, leg) in legs.iter().enumerate() {
            if let (Some(product), Some([value, firsts, second])) = (leg.start, &base) {
                let jump = |columns: &Vec<Vec<T>>| columns.iter().map(|p| apply(&self.flows.products[product], p)).collect::<Vec<_>>();
                (self.value, self.firsts, self.second) = (jump(value).remove(0), jump(firsts), jump(second).pop());
            }
            self.leg(leg);
            if i == 0 {
                base = Some(self.columns());
            }
        }
        self.start(start);
    }

    fn leg(&mut self, leg: &Leg) {
        let flow = &self.flows.modes[leg.mode];
        let only_end = self.depth > Depth::Value && self.firsts.is_empty() && leg.varies && self.trace.is_none();
        if !only_end {
            self.integrate(flow, &leg.duration.lo);
            if !leg.duration.is_point() {
                self.slack(flow, &leg.duration);
            }
        }
        self.advance(flow, &leg.duration);
        self.walked += &leg.duration.lo;
        if leg.varies && self.depth > Depth::Value {
            self.differentiate(flow);
        }
    }

    /// All costates at the end of a leg.
    fn advance(&mut self, flow: &Flow<T>, duration: &Range) {
        let end = |p: &Vec<T>| flow.over(&duration.lo, &duration.hi, p);
        self.value = end(&self.value);
        self.firsts = self.firsts.iter().map(end).collect();
        self.second = self.second.as_ref().map(end);
    }

    /// A duration that varies: what its end adds to the derivatives, and the costate's own.
    fn differentiate(&mut self, flow: &Flow<T>) {
        let zero = self.value[0].zero();
        let p = &self.value;
        let change = apply(&flow.adjoint, p);
        let (mut slope, mut curvature) = (zero.clone(), Some(zero.clone()));
        for output in &flow.outputs {
            let (h, rate) = (dot(&output.row, p, &zero), dot(&output.row, &change, &zero));
            match &output.push {
                None => {
                    slope = slope + h;
                    curvature = curvature.map(|sum| sum + rate);
                }
                Some((_, radius)) => {
                    slope = slope + radius.clone() * h.absolute();
                    curvature = match h.sign() {
                        Some(Sign::Zero) if rate.sign() == Some(Sign::Zero) => curvature,
                        Some(Sign::Positive) => curvature.map(|sum| sum + radius.clone() * rate),
                        Some(Sign::Negative) => curvature.map(|sum| sum - radius.clone() * rate),
                        _ => None,
                    };
                }
            }
        }
        self.sums.slopes.push(slope);
        if self.depth == Depth::Curvature {
            self.sums.curvature = curvature;
            self.second = Some(apply(&flow.adjoint, &change));
        }
        self.firsts.push(change);
    }

    /// The integrals over a duration that is a number.
    fn integrate(&mut self, flow: &Flow<T>, duration: &Rational) {
        let steps = flow.whole_steps(duration);
        let rest = duration / &flow.step - rational(steps as i64, 1);
        let mut blocks: Option<[Vec<Vec<T>>; 3]> = None;
        for step in 0..=steps {
            let end = if step < steps { rational(1, 1) } else { rest.clone() };
            if let Some(block) = Flow::<T>::starts_block(step) {
                blocks = Some(self.columns().map(|columns| columns.iter().map(|p| flow.block(block, p)).collect()));
            }
            let Some([value, firsts, second]) = blocks.as_ref().filter(|_| !end.is_zero()) else { continue };
            let at = |columns: &Vec<Vec<T>>| columns.iter().map(|p| flow.fine(Flow::<T>::in_block(step), p)).collect::<Vec<_>>();
            self.step(flow, step, &end, &at(value)[0], &at(firsts), at(second).first().map(Vec::as_slice));
        }
    }

    fn columns(&self) -> [Vec<Vec<T>>; 3] {
        [vec![self.value.clone()], self.firsts.clone(), self.second.iter().cloned().collect()]
    }

    /// One step, or the beginning of it.
    fn step(&mut self, flow: &Flow<T>, step: usize, end: &Rational, p: &[T], firsts: &[Vec<T>], second: Option<&[T]>) {
        for output in &flow.outputs {
            let expand = |p: &[T]| {
                let (coefficients, error) = flow.expansion(output, p);
                Expansion { coefficients, error }
            };
            let h = expand(p);
            let rates: Vec<Expansion<T>> = firsts.iter().map(|p| expand(p)).collect();
            let second = second.map(expand);
            if h.is_zero() && rates.iter().chain(&second).all(Expansion::is_zero) {
                continue;
            }
            let whole = rational(0, 1);
            match &output.push {
                None => self.add(&flow.step_scalar, &h, &rates, second.as_ref(), &whole, end, false),
                Some((input, radius)) => {
                    let scale = radius.clone() * &flow.step_scalar;
                    let float_end = flow.step_scalar.rational(end).upper();
                    let parts = match h.plain_sign(float_end) {
                        Some(sign) => vec![Part { from: whole, to: end.clone(), sign: Some(sign), slope: None }],
                        None => h.parts(end),
                    };
                    for (i, part) in parts.iter().enumerate() {
                        self.note(flow, step, *input, part, &h);
                        match part.sign {
                            Some(sign) => {
                                self.add(&scale, &h, &rates, second.as_ref(), &part.from, &part.to, sign == Sign::Negative);
                            }
                            None => {
                                let beside = |i: Option<usize>| i.and_then(|i| parts.get(i)?.sign);
                                let inside = match (beside(i.checked_sub(1)), beside(Some(i + 1))) {
                                    (Some(before), Some(after)) => before != after,
                                    _ => false,
                                };
                                self.add_unsigned(&scale, &h, &rates, second.as_ref(), part, inside);
                            }
                        }
                    }
                }
            }
        }
    }

    /// Integrals over a part with a sign.
    #[allow(clippy::too_many_arguments)]
    fn add(&mut self, scale: &T, h: &Expansion<T>, rates: &[Expansion<T>], second: Option<&Expansion<T>>, from: &Rational, to: &Rational, turned: bool) {
        let signed = |f: &Expansion<T>| {
            let integral = f.integral(from, to) * scale;
            if turned { -integral } else { integral }
        };
        self.sums.value = self.sums.value.clone() + signed(h);
        for (sum, rate) in self.sums.slopes.iter_mut().zip(rates) {
            *sum = sum.clone() + signed(rate);
        }
        if let (Some(sum), Some(second)) = (&mut self.sums.curvature, second) {
            *sum = sum.clone() + signed(second);
        }
    }

    /// A part in which the sign is not known: everything between both; a root that moves adds to the second derivative.
    fn add_unsigned(&mut self, scale: &T, h: &Expansion<T>, rates: &[Expansion<T>], second: Option<&Expansion<T>>, part: &Part<T>, inside: bool) {
        let width = scale.rational(&(&part.to - &part.from)) * scale;
        let zero = scale.zero();
        self.sums.value = self.sums.value.clone() + zero.joined(&(h.size(&part.from, &part.to) * &width));
        for (sum, rate) in self.sums.slopes.iter_mut().zip(rates) {
            *sum = sum.clone() + T::symmetric(&(rate.size(&part.from, &part.to) * &width));
        }
        let (Some(sum), Some(second)) = (&mut self.sums.curvature, second) else { return };
        let moved = part.slope.as_ref().zip(rates.first()).and_then(|(slope, rate)| {
            let speed = rate.over(&part.from, &part.to).square();
            Some(speed.over(&slope.absolute()).ok()? * scale * scale.integer(2))
        });
        match moved {
            None => self.sums.curvature = None,
            Some(moved) => {
                // At an end of the step the root may lie beyond it.
                let moved = if inside { moved } else { zero.joined(&moved) };
                *sum = sum.clone() + moved + T::symmetric(&(second.size(&part.from, &part.to) * &width));
            }
        }
    }

    /// Keeps where an input has which sign.
    fn note(&mut self, flow: &Flow<T>, step: usize, input: usize, part: &Part<T>, h: &Expansion<T>) {
        let Some(trace) = &mut self.trace else { return };
        let at = |x: &Rational| &self.walked + &flow.step * (rational(step as i64, 1) + x);
        let (from, to) = (at(&part.from), at(&part.to));
        let middle = h.over(&part.from, &part.to);
        let positive = part.sign.map_or(middle.lower() + middle.upper() > 0.0, |sign| sign == Sign::Positive);
        match trace.iter_mut().rev().find(|last| last.input == input) {
            Some(last) if last.positive == positive && last.to == from => last.to = to,
            _ => trace.push(Stretch { input, from, to, positive }),
        }
    }

    /// What is added between the least and the greatest of a duration.
    fn slack(&mut self, flow: &Flow<T>, duration: &Range) {
        let p = flow.over(&duration.lo, &duration.hi, &self.value);
        let firsts: Vec<Vec<T>> = self.firsts.iter().map(|p| flow.over(&duration.lo, &duration.hi, p)).collect();
        let zero = p[0].zero();
        let width = zero.rational(&(&duration.hi - &duration.lo));
        let some = zero.joined(&width);
        for output in &flow.outputs {
            let h = dot(&output.row, &p, &zero);
            let (h, scale) = match &output.push {
                None => (h, zero.one()),
                Some((_, radius)) => (h.absolute(), radius.clone()),
            };
            self.sums.value = self.sums.value.clone() + h * &scale * &some;
            for (sum, p) in self.sums.slopes.iter_mut().zip(&firsts) {
                let rate = dot(&output.row, p, &zero);
                let rate = if output.push.is_some() { T::symmetric(&rate.magnitude()) } else { rate };
                *sum = sum.clone() + rate * &scale * &some;
            }
        }
        // The curvature is asked of one duration only.
        if !self.firsts.is_empty() {
            self.sums.curvature = None;
        }
    }

    /// The greatest value over the start, and its derivatives.
    fn start(&mut self, start: &[Range]) {
        let like = self.value[0].clone();
        for (i, range) in start.iter().enumerate() {
            let (centre, radius) = (like.rational(&range.centre()), like.rational(&range.radius()));
            let p = &self.value[i];
            self.sums.value = self.sums.value.clone() + centre.clone() * p + radius.clone() * p.absolute();
            // The start that is worst: at one end where the sign is known.
            let worst = match p.sign() {
                Some(Sign::Positive) => like.rational(&range.hi),
                Some(Sign::Negative) => like.rational(&range.lo),
                _ => centre + T::symmetric(&radius),
            };
            for (sum, first) in self.sums.slopes.iter_mut().zip(&self.firsts) {
                *sum = sum.clone() + worst.clone() * &first[i];
            }
            let known = range.is_point() || matches!(p.sign(), Some(Sign::Positive | Sign::Negative));
            self.sums.curvature = match (&self.sums.curvature, &self.second) {
                (Some(sum), Some(second)) if known => Some(sum.clone() + worst * &second[i]),
                _ => None,
            };
        }
    }
}
