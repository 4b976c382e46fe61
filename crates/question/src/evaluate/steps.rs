//! Time operators in discrete time: every property is constant on stretches of steps, and its truth at a step is that of its parts at the steps
//! that are meant. Nothing is divided, and nothing is evaluated before it is needed.

use super::time::{Span, horizon, moving_names, now};
use super::{Evaluator, Judged};
use crate::error::Problem;
use crate::failure::Failure;
use crate::names::Quantity;
use crate::syntax::{Kind, Node};
use crate::timeline::{Measured, Moment, Piece, Repeats, Timeline};
use crate::truth::{Doubt, Margin, Truth};
use arithmetic::Rational;
use arithmetic::RealNumber as Number;
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use std::cell::OnceCell;
use std::collections::BTreeSet;

/// Stretches of a window that are looked at for the margin alone, after the truth is known.
const MOST_FOR_MARGIN: usize = 2000;

/// A property with a time operator at the first time of the evaluator's piece.
pub(super) fn over_steps(timeline: &dyn Timeline, evaluator: &Evaluator, node: &Node) -> Judged {
    let start = evaluator.piece.map_or_else(now, Clone::clone).from.ceil().to_integer();
    outermost(timeline, evaluator, node, &start)?.at(&start)
}

/// Goes through the stretches of a part of a time operator in order, with its truth there, as long as it is told to go on.
pub(super) fn each_stretch(
    timeline: &dyn Timeline,
    evaluator: &Evaluator,
    node: &Node,
    part: usize,
    visit: &mut dyn FnMut(&Piece, Truth, Margin) -> bool,
) -> Result<(), Failure> {
    let start = evaluator.piece.map_or_else(now, Clone::clone).from.ceil().to_integer();
    let operator = outermost(timeline, evaluator, node, &start)?;
    let Some(body) = operator.bodies.get(part) else { return Ok(()) };
    // Of `until` the first part is asked for from now on.
    let is_first = operator.meaning == Meaning::Until && part == 0;
    let begin = if is_first { start } else { start + &operator.window.from };
    for (place, stretch) in body.stretches.iter().enumerate().skip(containing(&body.stretches, &begin)) {
        let (truth, margin) = body.value(place)?;
        let from = begin.clone().max(stretch.from.clone());
        if !visit(&Stretch { from, to: stretch.to.clone() }.piece(), truth, margin) {
            break;
        }
    }
    Ok(())
}

/// A time operator that stands in no other one, at a step.
fn outermost<'a, 'c, 'q>(
    timeline: &'a dyn Timeline,
    evaluator: &'a Evaluator<'c, 'q>,
    node: &'a Node,
    start: &BigInt,
) -> Result<Operator<'a, 'c, 'q>, Failure> {
    let mut is_endless = false;
    node.visit(&mut |part| is_endless |= matches!(part.kind, Kind::Infinity));
    let end = if is_endless { None } else { Some(horizon(evaluator, node)? + Rational::from_integer(start.clone())) };
    // Of all quantities or of none: next to others nothing repeats.
    let repeats = timeline.repeats(end.as_ref(), &moving_names(evaluator, node))?;
    let place = Place { timeline, evaluator, repeats };
    Operator::read(&place, node, &Stretch { from: start.clone(), to: Some(start.clone()) })
}

/// Where properties are read.
#[derive(Clone)]
struct Place<'a, 'c, 'q> {
    timeline: &'a dyn Timeline,
    evaluator: &'a Evaluator<'c, 'q>,
    /// Then the truth of every property repeats, since it looks at later steps only.
    repeats: Option<Repeats>,
}

/// Steps of a range before which a property that repeats is told apart one by one.
const MOST_SINGLE: i64 = 100_000;

/// Periods that the bodies of an operator are looked at for: one for now, two for the beginning of a window, one for its length.
const ROUNDS: i64 = 4;

impl Place<'_, '_, '_> {
    /// A range up to where everything has come so often, if it repeats.
    fn once(&self, range: &Stretch, rounds: i64) -> Stretch {
        let Some(Repeats { from, period }) = &self.repeats else { return range.clone() };
        let last: BigInt = from.max(&range.from) + period * rounds - 1;
        let to = range.to.as_ref().map_or(last.clone(), |to| to.min(&last).clone());
        Stretch { from: range.from.clone(), to: Some(to) }
    }

    /// Where something repeats: the steps of a range whose window begins where it does.
    fn every_step(&self, range: &Stretch, window: &BigInt) -> Result<BTreeSet<BigInt>, Failure> {
        let (Some(Repeats { from, .. }), Some(to)) = (&self.repeats, &range.to) else { return Ok(BTreeSet::new()) };
        let first = (from - window).max(range.from.clone());
        let count = (to - &first + 1i32).to_i64().unwrap_or(i64::MAX).max(0);
        if count > MOST_SINGLE {
            return Err(Failure::open("a window begins so late that too many steps would have to be told apart", None));
        }
        Ok((0..count).map(|k| &first + k).collect())
    }
}

/// Steps from one to another, or on for ever.
#[derive(Debug, Clone)]
struct Stretch {
    from: BigInt,
    to: Option<BigInt>,
}

impl Stretch {
    fn piece(&self) -> Piece {
        Piece {
            from: Rational::from_integer(self.from.clone()),
            to: self.to.as_ref().map(|to| Rational::from_integer(to.clone())),
        }
    }

    /// The stretches between some steps at which something may change.
    fn cut(&self, changes: BTreeSet<BigInt>) -> Vec<Stretch> {
        let inside = |t: &BigInt| *t > self.from && self.to.as_ref().is_none_or(|to| t <= to);
        let starts: Vec<BigInt> =
            std::iter::once(self.from.clone()).chain(changes.into_iter().filter(inside)).collect();
        let end = |k: usize| starts.get(k + 1).map(|next| next - 1).or_else(|| self.to.clone());
        (0..starts.len()).map(|k| Stretch { from: starts[k].clone(), to: end(k) }).collect()
    }
}

/// The stretch with a step; they follow each other without gaps.
fn containing(stretches: &[Stretch], step: &BigInt) -> usize {
    stretches.partition_point(|stretch| stretch.from <= *step).saturating_sub(1)
}

/// A property on a range of steps.
struct Body<'a, 'c, 'q> {
    place: Place<'a, 'c, 'q>,
    node: &'a Node,
    /// The time operators in it that stand in no other one.
    operators: Vec<Operator<'a, 'c, 'q>>,
    stretches: Vec<Stretch>,
    values: Vec<OnceCell<Judged>>,
}

impl<'a, 'c, 'q> Body<'a, 'c, 'q> {
    fn read(place: &Place<'a, 'c, 'q>, node: &'a Node, range: &Stretch) -> Result<Self, Failure> {
        // The stretches of operators in it are those of their first period only.
        let (mut operators, mut changes) = (Vec::new(), place.every_step(range, &BigInt::ZERO)?);
        let mut open = vec![node];
        while let Some(part) = open.pop() {
            match &part.kind {
                Kind::Always(..) | Kind::Until(_) => {
                    let operator = Operator::read(place, part, range)?;
                    changes.extend(operator.stretches.iter().map(|stretch| stretch.from.clone()));
                    operators.push(operator);
                }
                Kind::Not(body) => open.push(body),
                Kind::And(list) | Kind::Or(list) => open.extend(list),
                Kind::Implies(first, second) => open.extend([first.as_ref(), second.as_ref()]),
                _ => changes.extend(changes_of(place, part, range)?),
            }
        }
        let stretches = range.cut(changes);
        let values = stretches.iter().map(|_| OnceCell::new()).collect();
        Ok(Body { place: place.clone(), node, operators, stretches, values })
    }

    /// The truth on the stretch with that number; what only further knowledge could tell is unknown.
    fn value(&self, place: usize) -> Judged {
        self.values[place].get_or_init(|| self.found(&self.stretches[place])).clone()
    }

    fn found(&self, stretch: &Stretch) -> Judged {
        let piece = stretch.piece();
        let known = self.operators.iter().map(|operator| Ok((operator.node, operator.at(&stretch.from))));
        let known = known.collect::<Result<Vec<_>, Failure>>()?;
        let moment = self.place.timeline.moment(&piece)?;
        let moment = WithKnown { moment: moment.as_ref(), known };
        let inner = Evaluator { moment: Some(&moment), piece: Some(&piece), ..*self.place.evaluator };
        match inner.judge(self.node) {
            Err(Failure::Open(doubt)) => Ok((Truth::Unknown(doubt), Margin::ANY)),
            judged => judged,
        }
    }
}

/// The steps of a range at which the moving quantities of an expression may change.
fn changes_of(place: &Place, node: &Node, range: &Stretch) -> Result<Vec<BigInt>, Failure> {
    let whole = range.piece();
    let mut changes = Vec::new();
    for name in moving_names(place.evaluator, node) {
        for piece in place.timeline.pieces(&whole.from, whole.to.as_ref(), &[name])?.pieces {
            changes.push(piece.from.to_integer());
            changes.extend(piece.to.map(|to| to.to_integer() + 1));
        }
    }
    Ok(changes)
}

/// A moment at which the truth of some time operators is known, too.
struct WithKnown<'a> {
    moment: &'a dyn Moment,
    known: Vec<(&'a Node, Judged)>,
}

impl Moment for WithKnown<'_> {
    fn measure(&self, quantity: &Quantity, arguments: &[Number], precision: u32) -> Result<Measured, Failure> {
        self.moment.measure(quantity, arguments, precision)
    }

    fn own(&self, name: &str, precision: u32) -> Result<Measured, Failure> {
        self.moment.own(name, precision)
    }

    fn known(&self, node: &Node) -> Option<Judged> {
        self.known.iter().find(|(own, _)| std::ptr::eq(*own, node)).map(|(_, judged)| judged.clone())
    }
}

/// What a time operator asks of the steps of its window.
#[derive(Clone, Copy, PartialEq)]
enum Meaning {
    Always,
    Eventually,
    Until,
}

/// A time operator on a range of steps.
struct Operator<'a, 'c, 'q> {
    repeats: Option<Repeats>,
    node: &'a Node,
    meaning: Meaning,
    /// Its window, counted from now.
    window: Stretch,
    /// One, or two of `until`.
    bodies: Vec<Body<'a, 'c, 'q>>,
    /// The first step of the bodies.
    begin: BigInt,
    stretches: Vec<Stretch>,
    values: Vec<OnceCell<Judged>>,
}

impl<'a, 'c, 'q> Operator<'a, 'c, 'q> {
    fn read(place: &Place<'a, 'c, 'q>, node: &'a Node, range: &Stretch) -> Result<Self, Failure> {
        let (meaning, from, to, parts) = match &node.kind {
            Kind::Always(true, parts) => (Meaning::Always, &parts[0], &parts[1], &parts[2..]),
            Kind::Always(false, parts) => (Meaning::Eventually, &parts[0], &parts[1], &parts[2..]),
            Kind::Until(parts) => (Meaning::Until, &parts[0], &parts[1], &parts[2..]),
            _ => return Err(Failure::Refused(node.at, Problem::expected("a time operator", "something else"))),
        };
        let span = Span::read(place.evaluator, from, to)?;
        let (first, last) = place.timeline.inside(span.from, span.to);
        let window = Stretch { from: first.to_integer(), to: last.map(|last| last.to_integer()) };
        if window.to.as_ref().is_some_and(|to| *to < window.from) {
            let why = "no time at which the flock moves lies between the bounds".to_string();
            return Err(Failure::Refused(parts[0].at, Problem::Empty(why)));
        }
        let range = place.once(range, 1);
        let end = range.to.as_ref().zip(window.to.as_ref()).map(|(now, to)| now + to);
        // Of `until` the steps from now on count, not only those of the window.
        let begin = if meaning == Meaning::Until { range.from.clone() } else { &range.from + &window.from };
        let looked_at = place.once(&Stretch { from: begin.clone(), to: end }, ROUNDS);
        let body = |node| Body::read(place, node, &looked_at);
        let bodies = parts.iter().map(body).collect::<Result<Vec<_>, _>>()?;
        let mut changes = place.every_step(&range, &window.from)?;
        for start in bodies.iter().flat_map(|body| &body.stretches).map(|stretch| &stretch.from) {
            // Where the window begins there, or just after it, or ends there; where now is there.
            changes.extend([start - &window.from, start - &window.from + 1, start.clone()]);
            changes.extend(window.to.as_ref().map(|to| start - to));
        }
        let stretches = range.cut(changes);
        let values = stretches.iter().map(|_| OnceCell::new()).collect();
        Ok(Operator { repeats: place.repeats.clone(), node, meaning, window, bodies, begin, stretches, values })
    }

    /// The truth at a step of the range.
    fn at(&self, now: &BigInt) -> Judged {
        let first = self.stretches.first().map(|stretch| &stretch.from);
        let now = match self.repeats.as_ref().zip(first) {
            Some((repeats, first)) => now - repeats.whole_periods(now, &repeats.from.clone().max(first.clone())),
            None => now.clone(),
        };
        let place = containing(&self.stretches, &now);
        self.values[place].get_or_init(|| self.found(&self.stretches[place].from)).clone()
    }

    /// The steps that are meant at a step of the range, or others with the same answer.
    fn window_at(&self, now: &BigInt) -> Stretch {
        let (from, to) = (now + &self.window.from, self.window.to.as_ref().map(|to| now + to));
        let Some(repeats) = &self.repeats else { return Stretch { from, to } };
        let Repeats { from: start, period } = repeats;
        // Of `until` a whole period after now is left before the window: what holds there holds for ever.
        let least = match self.meaning {
            Meaning::Until => now.max(start) + period,
            _ => start.clone().max(self.begin.clone()),
        };
        let shift = repeats.whole_periods(&from, &least);
        let from = from - &shift;
        // After a period of it nothing new comes.
        let last: BigInt = start.clone().max(from.clone()) + period - 1;
        let to = to.map_or(last.clone(), |to| (to - shift).min(last));
        Stretch { from, to: Some(to) }
    }

    fn found(&self, now: &BigInt) -> Judged {
        let window = self.window_at(now);
        match (self.meaning, self.bodies.as_slice()) {
            (Meaning::Until, [keeps, comes]) => until(keeps, comes, now, &window),
            (meaning, [body, ..]) => {
                let is_negated = meaning == Meaning::Eventually;
                let (truth, margin) = always(body, &window, is_negated)?;
                // Eventually is not always not.
                Ok(if is_negated { (truth.negated(), margin.negated()) } else { (truth, margin) })
            }
            _ => Err(Failure::Refused(self.node.at, Problem::expected("a property", "nothing"))),
        }
    }
}

/// Whether a property, or its negation, holds at all steps of a window.
fn always(body: &Body, window: &Stretch, is_negated: bool) -> Judged {
    let mut all = All::new();
    let first = containing(&body.stretches, &window.from);
    for (place, stretch) in body.stretches.iter().enumerate().skip(first) {
        if window.to.as_ref().is_some_and(|to| stretch.from > *to) {
            break;
        }
        if all.is_false && (window.to.is_none() || place - first > MOST_FOR_MARGIN) {
            all.margin.lo = f64::NEG_INFINITY;
            break;
        }
        let judged = body.value(place).map(|(truth, margin)| match is_negated {
            true => (truth.negated(), margin.negated()),
            false => (truth, margin),
        });
        all.include(told(judged, stretch)?);
    }
    all.judged()
}

/// Whether `comes` holds at some step of the window, and `keeps` at all steps from now until before it.
fn until(keeps: &Body, comes: &Body, now: &BigInt, window: &Stretch) -> Judged {
    // That it comes at no step.
    let mut never = All::new();
    let mut kept = All::new();
    let (mut step, mut looked_at) = (now.clone(), 0);
    loop {
        let places = [&keeps.stretches, &comes.stretches].map(|stretches| containing(stretches, &step));
        let stretches = [&keeps.stretches[places[0]], &comes.stretches[places[1]]];
        let is_inside = step >= window.from;
        if is_inside {
            // Later steps of the same stretches ask for `keeps` besides.
            let mut both = All::new();
            both.include(kept.judged());
            both.include(told(comes.value(places[1]), stretches[1])?);
            never.include(both.judged().map(|(truth, margin)| (truth.negated(), margin.negated())));
        }
        kept.include(told(keeps.value(places[0]), stretches[0])?);
        looked_at += 1;
        let ends = stretches.into_iter().filter_map(|stretch| stretch.to.clone());
        let before = (!is_inside).then(|| &window.from - 1);
        let end = ends.chain(before).chain(window.to.clone()).min();
        let Some(next) = end.filter(|end| window.to.as_ref().is_none_or(|to| end < to)).map(|end| end + 1) else {
            break;
        };
        if (never.is_false || kept.is_false) && (window.to.is_none() || looked_at > MOST_FOR_MARGIN) {
            // At later steps it comes with at most what is kept.
            never.margin.lo = never.margin.lo.min(-kept.margin.hi);
            break;
        }
        step = next;
    }
    never.judged().map(|(truth, margin)| (truth.negated(), margin.negated()))
}

/// A value of a stretch, its doubt with the time where it arose. Only being told to stop stops everything at once.
fn told(judged: Judged, stretch: &Stretch) -> Result<Judged, Failure> {
    match judged {
        Err(Failure::Cancelled) => Err(Failure::Cancelled),
        // A comparison that more digits would decide; what is not followed that far says so itself.
        Ok((Truth::Unknown(doubt), margin)) if doubt.bits.is_some() => {
            let why = format!("at t = {} {}", stretch.from, doubt.why);
            Ok(Ok((Truth::Unknown(Doubt { why, ..doubt }), margin)))
        }
        other => Ok(other),
    }
}

/// That all of some properties hold: false if one is false, whatever the others are; without a value if one has none and all others are true.
struct All {
    margin: Margin,
    is_false: bool,
    doubt: Option<Doubt>,
    failure: Option<Failure>,
}

impl All {
    fn new() -> Self {
        All { margin: Margin::of_truth(true), is_false: false, doubt: None, failure: None }
    }

    fn include(&mut self, judged: Judged) {
        match judged {
            Ok((truth, margin)) => {
                self.margin = self.margin.least(margin);
                match truth {
                    Truth::True => {}
                    Truth::False => self.is_false = true,
                    Truth::Unknown(doubt) => {
                        self.doubt.get_or_insert(doubt);
                    }
                }
            }
            Err(failure) => {
                self.margin.lo = f64::NEG_INFINITY;
                self.failure.get_or_insert(failure);
            }
        }
    }

    fn judged(&self) -> Judged {
        match (self.is_false, &self.doubt, &self.failure) {
            (true, ..) => Ok((Truth::False, self.margin)),
            // What is not known may still be false.
            (false, Some(doubt), _) => Ok((Truth::Unknown(doubt.clone()), self.margin)),
            (false, None, Some(failure)) => Err(failure.clone()),
            (false, None, None) => Ok((Truth::True, self.margin)),
        }
    }
}
