//! The worst case at one time for one order of modes, walking backwards from that time, with its derivatives by the durations.
//!
//! `F(d_0, d_1, ..) = max c^T x(t)` over all inputs and starts, where the mode of leg 0 has lasted `d_0` at time `t`, that of leg 1 before it `d_1`, and
//! so on. With the costate `p`, `p' = A^T p` backwards in time and `p = c` at `t`,
//!
//! `F = sum over legs of the integral of (drift . p + sum_j radius_j |column_j . p|) + max over the start box of p . x`.
//!
//! By the envelope theorem the derivative by `d_i` is the integrand at the end of leg `i`, plus the same sum over the earlier legs with `p` replaced by its derivative
//! `A_i^T p` there and `|h|` by `sign(h) h'`. `notes/reach.md` has the derivation.

use crate::flow::{BLOCK, Flow, Flows, Output, Start};
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

impl Leg {
    /// One that lasts a known time.
    pub fn fixed((mode, duration): &(usize, Rational)) -> Self {
        Leg { mode: *mode, duration: Range::point(duration.clone()), varies: false, start: None }
    }
}

/// The longest time of each of so many modes.
pub(crate) fn longest_of(legs: &[(usize, Rational)], modes: usize) -> Vec<Rational> {
    let mut longest = vec![Rational::ZERO; modes];
    for (mode, duration) in legs {
        longest[*mode] = longest[*mode].clone().max(duration.clone());
    }
    longest
}

/// A worst case with its derivatives by the durations that vary, in the order of the legs.
#[derive(Debug, Clone)]
pub(crate) struct Sums<T> {
    /// None where leg 0 may last from one time to another: only the derivatives are then computed.
    pub value: Option<T>,
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

/// The costates that are carried.
#[derive(Debug, Clone)]
struct Columns<C> {
    value: C,
    firsts: Vec<C>,
    second: Option<C>,
    third: Option<C>,
}

impl<C> Columns<C> {
    fn map<D>(&self, f: impl Fn(&C) -> D) -> Columns<D> {
        Columns {
            value: f(&self.value),
            firsts: self.firsts.iter().map(&f).collect(),
            second: self.second.as_ref().map(&f),
            third: self.third.as_ref().map(&f),
        }
    }
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
    /// Where one duration may lie in an interval, the costates above are those of its middle; this is their third derivative over the interval, and
    /// how far the interval reaches to both sides. So what is correlated stays so.
    third: Option<(Vec<T>, T)>,
    sums: Sums<T>,
    total: T,
    /// Whether a part of the total was left out.
    partial: bool,
    /// Time walked so far, where it is a number.
    walked: Rational,
    trace: Option<Vec<Stretch>>,
}

/// The worst case with as many derivatives as are asked for. `start` is where the states are before the last leg.
pub(crate) fn worst<T: Scalar>(flows: &Flows<T>, row: &[T], legs: &[Leg], start: &[Range], depth: Depth) -> Sums<T> {
    let mut walk = Walk::new(flows, row, depth);
    walk.run(legs, start);
    let value = (!walk.partial).then_some(walk.total);
    Sums { value, ..walk.sums }
}

/// The signs of the inputs and the start of a worst case, for durations that are numbers.
pub(crate) fn trace<T: Scalar>(
    flows: &Flows<T>,
    row: &[T],
    legs: &[Leg],
    start: &[Range],
) -> (Vec<Stretch>, Vec<Rational>) {
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
        let sums =
            Sums { value: None, slopes: Vec::new(), curvature: (depth == Depth::Curvature).then(|| zero.clone()) };
        let walked = Rational::ZERO;
        Walk {
            flows,
            depth,
            value: row.to_vec(),
            firsts: Vec::new(),
            second: None,
            third: None,
            sums,
            total: zero,
            partial: false,
            walked,
            trace: None,
        }
    }

    fn run(&mut self, legs: &[Leg], start: &[Range]) {
        let mut base: Option<Columns<Vec<T>>> = None;
        for (i, leg) in legs.iter().enumerate() {
            if let (Some(product), Some(base)) = (leg.start, &base) {
                self.keep(base.map(|p| apply(&self.flows.products[product], p)));
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
        let only_end = self.depth > Depth::Value && self.firsts.is_empty() && leg.varies && !leg.duration.is_point();
        if only_end {
            self.partial = true;
        } else {
            self.integrate(flow, &leg.duration.lo);
            if !leg.duration.is_point() {
                self.slack(flow, &leg.duration);
            }
        }
        let before = self.columns();
        self.keep(before.map(|p| flow.over(&leg.duration.lo, &leg.duration.hi, p)));
        self.walked += &leg.duration.lo;
        if leg.varies && self.depth > Depth::Value {
            self.differentiate(flow);
            if only_end && self.depth == Depth::Curvature {
                self.centre(flow, &leg.duration, &before.value);
            }
        }
    }

    /// Replaces the costates over an interval of durations by those of its middle.
    fn centre(&mut self, flow: &Flow<T>, duration: &Range, before: &[T]) {
        let middle = duration.centre();
        let value = flow.over(&middle, &middle, before);
        let first = apply(&flow.adjoint, &value);
        let third = self.second.as_ref().map(|second| apply(&flow.adjoint, second));
        let away = value[0].around(&(&duration.lo - &middle), &(&duration.hi - &middle));
        self.third = third.map(|third| (third, away));
        self.second = Some(apply(&flow.adjoint, &first));
        self.firsts = vec![first];
        self.value = value;
    }

    fn columns(&self) -> Columns<Vec<T>> {
        Columns {
            value: self.value.clone(),
            firsts: self.firsts.clone(),
            second: self.second.clone(),
            third: self.third.as_ref().map(|(third, _)| third.clone()),
        }
    }

    fn keep(&mut self, columns: Columns<Vec<T>>) {
        (self.value, self.firsts, self.second) = (columns.value, columns.firsts, columns.second);
        if let (Some((kept, _)), Some(third)) = (&mut self.third, columns.third) {
            *kept = third;
        }
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
                Some((_, centre, radius)) => {
                    let (low, high) = (centre.clone() - radius, centre.clone() + radius);
                    let known = match (h.sign(), rate.sign()) {
                        (Some(Sign::Zero), Some(Sign::Zero)) | (Some(Sign::Positive), _) => Some(high.clone()),
                        (Some(Sign::Negative), _) => Some(low.clone()),
                        _ => None,
                    };
                    slope = slope + h * known.clone().unwrap_or_else(|| low.joined(&high));
                    curvature = curvature.zip(known).map(|(sum, edge)| sum + edge * rate);
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
        let whole = self.columns();
        for block in 0..=steps / BLOCK {
            let starts = whole.map(|p| Start::new(flow.block(block, p)));
            for step in block * BLOCK..((block + 1) * BLOCK).min(steps) {
                flow.outputs.iter().for_each(|output| self.step(flow, output, step, None, &starts));
            }
            if block == steps / BLOCK && !rest.is_zero() {
                flow.outputs.iter().for_each(|output| self.step(flow, output, steps, Some(&rest), &starts));
            }
        }
    }

    /// One step, or the beginning of it.
    fn step(
        &mut self,
        flow: &Flow<T>,
        output: &Output<T>,
        step: usize,
        end: Option<&Rational>,
        starts: &Columns<Start<T>>,
    ) {
        let place = step % BLOCK;
        let Some((input, centre, radius)) = &output.push else {
            return match end {
                None => self.add(&flow.step_scalar, |p| flow.integral(output, place, p), starts),
                Some(end) => self.add(
                    &flow.step_scalar,
                    |p| flow.expansion(output, place, p).integral(&rational(0, 1), end),
                    starts,
                ),
            };
        };
        let weight = |sign: Sign| {
            let edge = if sign == Sign::Negative { centre.clone() - radius } else { centre.clone() + radius };
            edge * &flow.step_scalar
        };
        let moved = match (&starts.third, &self.third, &starts.second, &starts.firsts[..]) {
            (Some(third), Some((_, away)), Some(second), [first]) => Some((first, second, third, away.clone())),
            _ => None,
        };
        // Most steps have a sign that no duration of the interval changes.
        let slack = moved.as_ref().map_or(0.0, |(first, second, third, away)| {
            let size = |p: &Start<T>| flow.size(output, place, p);
            let far = away.largest();
            (size(first) + (size(second) + size(third) * far / 3.0) * far / 2.0) * far
        });
        let whole = end.is_none();
        let short = || flow.short(output, place, &starts.value).plain_sign(1.0, slack);
        if let Some(sign) = Some(()).filter(|()| whole).and_then(|()| short()) {
            return self.add_whole(flow, (output, *input, step), sign, &weight(sign), starts);
        }
        let mut h = flow.expansion(output, place, &starts.value);
        if let Some(sign) = h.plain_sign(1.0, slack).filter(|_| whole) {
            return self.add_whole(flow, (output, *input, step), sign, &weight(sign), starts);
        }
        let all = Columns {
            value: h.clone(),
            firsts: starts.firsts.iter().map(|p| flow.expansion(output, place, p)).collect(),
            second: starts.second.as_ref().map(|p| flow.expansion(output, place, p)),
            third: starts.third.as_ref().map(|p| flow.expansion(output, place, p)),
        };
        if let (Some((.., away)), [first], Some(second), Some(third)) =
            (&moved, &all.firsts[..], &all.second, &all.third)
        {
            let half = away.square() * away.ratio(1, 2);
            h.add(first, away);
            h.add(second, &half);
            h.add(third, &(half.clone() * away * away.ratio(1, 3)));
            if let Some(sign) = h.plain_sign(1.0, 0.0).filter(|_| whole) {
                return self.add_whole(flow, (output, *input, step), sign, &weight(sign), starts);
            }
        }
        let parts = h.parts(end.unwrap_or(&rational(1, 1)));
        for (i, part) in parts.iter().enumerate() {
            self.note(flow, step, *input, part, &h);
            if let Some(sign) = part.sign {
                self.add_expansions(&weight(sign), part, &all);
                continue;
            }
            self.add_expansions(&(centre.clone() * &flow.step_scalar), part, &all);
            let beside = |i: Option<usize>| i.and_then(|i| parts.get(i)?.sign);
            let inside = match (beside(i.checked_sub(1)), beside(Some(i + 1))) {
                (Some(before), Some(after)) => before != after,
                _ => false,
            };
            self.add_unsigned(&(radius.clone() * &flow.step_scalar), &h, &all, part, inside);
        }
    }

    /// A step on which an input has one sign.
    fn add_whole(
        &mut self,
        flow: &Flow<T>,
        (output, input, step): (&Output<T>, usize, usize),
        sign: Sign,
        weight: &T,
        starts: &Columns<Start<T>>,
    ) {
        let from = (rational(step as i64, 1), rational(step as i64 + 1, 1));
        self.keep_sign(flow, (&from.0, &from.1), input, sign == Sign::Positive);
        self.add(weight, |p| flow.integral(output, step % BLOCK, p), starts);
    }

    fn add_expansions(&mut self, scale: &T, part: &Part<T>, all: &Columns<Expansion<T>>) {
        self.add(scale, |f| f.integral(&part.from, &part.to), all);
    }

    /// Adds integrals, which are linear in the costate.
    fn add<C>(&mut self, scale: &T, integral: impl Fn(&C) -> T, columns: &Columns<C>) {
        let value = integral(&columns.value);
        let mut firsts: Vec<T> = columns.firsts.iter().map(&integral).collect();
        let mut second = columns.second.as_ref().map(&integral);
        if let (Some(third), Some((_, away)), Some(bent), [first]) =
            (&columns.third, &self.third, &mut second, &mut firsts[..])
        {
            let third = integral(third);
            let half = away.square() * away.ratio(1, 2);
            *first = first.clone() + bent.clone() * away + third.clone() * &half;
            *bent = bent.clone() + third * away;
        }
        self.total = self.total.clone() + value * scale;
        for (sum, first) in self.sums.slopes.iter_mut().zip(firsts) {
            *sum = sum.clone() + first * scale;
        }
        if let (Some(sum), Some(second)) = (&mut self.sums.curvature, second) {
            *sum = sum.clone() + second * scale;
        }
    }

    /// A part in which the sign is not known: everything between both; a root that moves adds to the second derivative.
    fn add_unsigned(&mut self, scale: &T, h: &Expansion<T>, all: &Columns<Expansion<T>>, part: &Part<T>, inside: bool) {
        let width = scale.rational(&(&part.to - &part.from)) * scale;
        let zero = scale.zero();
        self.total = self.total.clone() + zero.joined(&(h.size(&part.from, &part.to) * &width));
        if self.sums.slopes.is_empty() {
            return;
        }
        let (mut rates, mut second) = (all.firsts.clone(), all.second.clone());
        if let (Some(third), Some((_, away)), Some(bent), [rate]) =
            (&all.third, &self.third, &mut second, &mut rates[..])
        {
            let half = away.square() * away.ratio(1, 2);
            rate.add(bent, away).add(third, &half);
            bent.add(third, away);
        }
        for (sum, rate) in self.sums.slopes.iter_mut().zip(&rates) {
            *sum = sum.clone() + T::symmetric(&(rate.size(&part.from, &part.to) * &width));
        }
        let (Some(sum), Some(second)) = (&mut self.sums.curvature, second) else { return };
        if h.is_zero() && rates.iter().all(Expansion::is_zero) {
            return;
        }
        let moved = part.slope.as_ref().zip(rates.first()).and_then(|(slope, rate)| {
            let speed = rate.over(&part.from, &part.to).square();
            Some(speed.over(&slope.moduli()).ok()? * scale * scale.integer(2))
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

    /// Keeps where an input has which sign, of a part of a step.
    fn note(&mut self, flow: &Flow<T>, step: usize, input: usize, part: &Part<T>, h: &Expansion<T>) {
        if self.trace.is_some() {
            let at = |x: &Rational| rational(step as i64, 1) + x;
            let middle = || h.over(&part.from, &part.to);
            let positive =
                part.sign.map_or_else(|| middle().lower() + middle().upper() > 0.0, |sign| sign == Sign::Positive);
            self.keep_sign(flow, (&at(&part.from), &at(&part.to)), input, positive);
        }
    }

    /// Keeps a sign between two instants of a leg, in steps.
    fn keep_sign(&mut self, flow: &Flow<T>, (from, to): (&Rational, &Rational), input: usize, positive: bool) {
        let Some(trace) = &mut self.trace else { return };
        let at = |x: &Rational| &self.walked + &flow.step * x;
        let (from, to) = (at(from), at(to));
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
            let pushed = match &output.push {
                None => h.clone(),
                Some((_, centre, radius)) => h.clone() * edges(&h, centre, radius),
            };
            self.total = self.total.clone() + pushed * &some;
            for (sum, p) in self.sums.slopes.iter_mut().zip(&firsts) {
                let rate = dot(&output.row, p, &zero);
                let pushed = match &output.push {
                    None => rate,
                    Some((_, centre, radius)) => rate * edges(&h, centre, radius),
                };
                *sum = sum.clone() + pushed * &some;
            }
        }
        // The curvature is asked of one duration only.
        if !self.firsts.is_empty() {
            self.sums.curvature = None;
        }
    }

    /// The costates over the interval of durations, from those of its middle.
    fn spread(&mut self) {
        let (Some((third, away)), Some(second), [first]) = (&self.third, &mut self.second, &mut self.firsts[..]) else {
            return;
        };
        let half = away.square() * away.ratio(1, 2);
        let sixth = half.clone() * away * away.ratio(1, 3);
        for i in 0..third.len() {
            let (b, c) = (first[i].clone(), second[i].clone());
            self.value[i] = self.value[i].clone() + b.clone() * away + c.clone() * &half + third[i].clone() * &sixth;
            first[i] = b + c.clone() * away + third[i].clone() * &half;
            second[i] = c + third[i].clone() * away;
        }
    }

    /// The greatest value over the start, and its derivatives.
    fn start(&mut self, start: &[Range]) {
        let like = self.value[0].clone();
        self.spread();
        for (i, range) in start.iter().enumerate() {
            let (centre, radius) = (like.rational(&range.centre()), like.rational(&range.radius()));
            let p = &self.value[i];
            self.total = self.total.clone() + centre.clone() * p + radius.clone() * p.moduli();
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

/// The values of an input that are worst where the sign of `h` is known, or all of them.
fn edges<T: Scalar>(h: &T, centre: &T, radius: &T) -> T {
    let (low, high) = (centre.clone() - radius, centre.clone() + radius);
    match h.sign() {
        Some(Sign::Positive) => high,
        Some(Sign::Negative) => low,
        _ => low.joined(&high),
    }
}
