//! Time operators: `always[a, b]`, `eventually[a, b]`, `p until[a, b] q`, decided on pieces of time on which everything is enclosed; in discrete time by
//! [`super::steps`].

use super::growth::Growth;
use super::steps::{each_stretch, over_steps};
use super::until::until;
use super::{Evaluator, Judged};
use crate::error::Problem;
use crate::failure::Failure;
use crate::syntax::{Kind, Node};
use crate::timeline::{Measured, Piece, Timeline, clock};
use crate::truth::{Doubt, Margin, Truth};
use arithmetic::RealNumber as Number;
use arithmetic::{Rational, rational};
use std::collections::VecDeque;

/// Judgements of one operator before it gives up dividing.
pub(super) const MOST_JUDGED: usize = 20_000;

/// Undecided pieces in which single times are tried.
const MOST_TRIED: usize = 1000;

/// Undecided pieces on which comparisons are looked at as functions of one number: at the end, and while that many halvings are left.
pub(super) const MOST_SETTLED: usize = 64;
pub(super) const COARSE: u32 = DEPTH - 6;

/// How often a piece is halved.
pub(super) const DEPTH: u32 = 14;

impl Evaluator<'_, '_> {
    /// A property with a time operator, at time 0 or at the time of the evaluator.
    pub(super) fn over_time(&self, node: &Node) -> Judged {
        if let Some(known) = self.moment.and_then(|moment| moment.known(node)) {
            return known;
        }
        let timeline = self.case.timeline()?;
        if timeline.is_discrete() {
            return over_steps(timeline, self, node);
        }
        if self.piece.is_none() {
            timeline.prepare(&horizon(self, node)?)?;
        }
        over_time(timeline, self, node, self.piece.unwrap_or(&now()))
    }

    /// Goes through the times of a part of a time operator in order, with its truth there, as long as it is told to go on.
    pub(crate) fn each_time(
        &self,
        node: &Node,
        part: usize,
        visit: &mut dyn FnMut(&Piece, Truth, Margin) -> bool,
    ) -> Result<(), Failure> {
        let timeline = self.case.timeline()?;
        if timeline.is_discrete() {
            return each_stretch(timeline, self, node, part, visit);
        }
        let (from, to, bodies) = match &node.kind {
            Kind::Always(_, parts) => (&parts[0], &parts[1], &parts[2..]),
            Kind::Until(parts) => (&parts[0], &parts[1], &parts[2..]),
            _ => return Ok(()),
        };
        if self.piece.is_none() {
            timeline.prepare(&horizon(self, node)?)?;
        }
        let start = now();
        let at = self.piece.unwrap_or(&start);
        let (begin, end) = Span::read(self, from, to)?.possible(at);
        // Of `until` the first part is asked for from now on.
        let begin = if bodies.len() == 2 && part == 0 { at.from.clone() } else { begin };
        let Some(body) = bodies.get(part) else { return Ok(()) };
        let covered = timeline.pieces(&begin, end.as_ref(), &moving_names(self, body))?;
        let mut queue: Vec<(Piece, u32)> = covered.pieces.into_iter().rev().map(|piece| (piece, DEPTH)).collect();
        let operator = Operator { timeline, evaluator: self, body, negated: false };
        let mut judged = 0;
        while let Some((piece, depth)) = queue.pop().filter(|_| judged < MOST_JUDGED) {
            let (truth, margin) = operator.judge(&piece)?;
            judged += 1;
            let halves = timeline.halves(&piece).filter(|_| matches!(truth, Truth::Unknown(_)) && depth > 0);
            match halves {
                Some([first, second]) => queue.extend([(second, depth - 1), (first, depth - 1)]),
                None if !visit(&piece, truth, margin) => break,
                None => {}
            }
        }
        Ok(())
    }

    /// What is found at an instant at which everything is known exactly, and the body of a time operator is `wanted`, while no length of time is known in which it is.
    pub(crate) fn at_instant<R>(
        &self,
        node: &Node,
        wanted: bool,
        find: &dyn Fn(&Evaluator) -> Result<Option<R>, Failure>,
    ) -> Result<Option<R>, Failure> {
        let (timeline, Kind::Always(_, parts)) = (self.case.timeline()?, &node.kind) else { return Ok(None) };
        let mut open = Vec::new();
        self.each_time(node, 0, &mut |piece, truth, _| {
            open.extend(matches!(truth, Truth::Unknown(_)).then(|| piece.clone()));
            true
        })?;
        let operator = Operator { timeline, evaluator: self, body: &parts[2], negated: false };
        operator.at_instants(open, &mut |inner, (truth, _)| {
            if truth == Truth::of(wanted) { find(inner) } else { Ok(None) }
        })
    }

    /// A quantity at time 0.
    pub(super) fn initially(&self, node: &Node) -> Result<Measured, Failure> {
        let timeline = self.case.timeline()?;
        let now = now();
        if self.piece.is_none() {
            timeline.prepare(&now.from)?;
        }
        let moment = timeline.moment(&now)?;
        Evaluator { moment: Some(moment.as_ref()), piece: Some(&now), ..*self }.measured(node)
    }
}

/// The time 0.
pub(super) fn now() -> Piece {
    Piece { from: rational(0, 1), to: Some(rational(0, 1)) }
}

/// The last time that a property looks at, bounded times only.
pub(crate) fn horizon(evaluator: &Evaluator, node: &Node) -> Result<Rational, Failure> {
    let zero = rational(0, 1);
    let end = |to: &Node| match to.kind {
        Kind::Infinity => Ok(zero.clone()),
        _ => match evaluator.number(to)? {
            Number::Exact(q) => Ok(q),
            other => Err(Failure::Refused(to.at, Problem::expected("a rational number", other.text()))),
        },
    };
    let most = |list: Vec<&Node>| {
        list.into_iter().try_fold(zero.clone(), |most, node| Ok::<_, Failure>(most.max(horizon(evaluator, node)?)))
    };
    match &node.kind {
        Kind::Always(_, parts) => Ok(end(&parts[1])? + horizon(evaluator, &parts[2])?),
        Kind::Until(parts) => Ok(end(&parts[1])? + most(vec![&parts[2], &parts[3]])?),
        Kind::Not(body) => horizon(evaluator, body),
        Kind::And(list) | Kind::Or(list) => most(list.iter().collect()),
        Kind::Implies(a, b) => most(vec![a, b]),
        _ => Ok(zero.clone()),
    }
}

/// The truth of a property with a time operator at a piece of time: for all its times at once.
fn over_time(timeline: &dyn Timeline, evaluator: &Evaluator, node: &Node, at: &Piece) -> Judged {
    match &node.kind {
        Kind::Always(always, parts) => {
            let [from, to, body] = parts.as_ref();
            let span = Span::read(evaluator, from, to)?;
            Operator { timeline, evaluator, body, negated: !always }.always(&span, at).map(|(truth, margin)| {
                // Eventually is not always not.
                if *always { (truth, margin) } else { (truth.negated(), margin.negated()) }
            })
        }
        Kind::Until(parts) => {
            let [from, to, first, second] = parts.as_ref();
            let span = Span::read(evaluator, from, to)?;
            until(timeline, evaluator, &span, first, second, at)
        }
        _ => evaluator.judge(node),
    }
}

/// The times of an operator, from its own time on.
pub(super) struct Span {
    pub from: Rational,
    pub to: Option<Rational>,
}

impl Span {
    pub fn read(evaluator: &Evaluator, from: &Node, to: &Node) -> Result<Self, Failure> {
        let exact = |node: &Node| match evaluator.number(node)? {
            Number::Exact(q) if q >= rational(0, 1) => Ok(q),
            other => Err(Failure::Refused(
                node.at,
                Problem::Range {
                    what: "a time".to_string(),
                    expected: "a rational number that is not negative".to_string(),
                    found: other.text(),
                },
            )),
        };
        let start = exact(from)?;
        let end = if matches!(to.kind, Kind::Infinity) { None } else { Some(exact(to)?) };
        if let Some(end) = &end
            && *end < start
        {
            let why = format!("the time [{start}, {end}] ends before it begins");
            return Err(Failure::Refused(to.at, Problem::Empty(why)));
        }
        Ok(Span { from: start, to: end })
    }

    /// All times that may be meant at a piece.
    pub fn possible(&self, at: &Piece) -> (Rational, Option<Rational>) {
        (&at.from + &self.from, at.to.as_ref().zip(self.to.as_ref()).map(|(end, to)| end + to))
    }

    /// The first times that are meant at the times of a piece.
    pub fn first(&self, at: &Piece) -> Option<Piece> {
        Some(Piece { from: &at.from + &self.from, to: Some(at.to.as_ref()? + &self.from) })
    }

    /// The times that are meant at every time of the piece.
    pub fn sure(&self, at: &Piece) -> Option<(Rational, Option<Rational>)> {
        let from = at.to.as_ref()? + &self.from;
        let to = self.to.as_ref().map(|to| &at.from + to);
        to.as_ref().is_none_or(|to| from <= *to).then_some((from, to))
    }
}

/// What is made of the truth and the margin at an instant; nothing goes on.
type Visit<'v, R> = dyn FnMut(&Evaluator, (Truth, Margin)) -> Result<Option<R>, Failure> + 'v;

pub(super) struct Operator<'a, 'c, 'q> {
    pub timeline: &'a dyn Timeline,
    pub evaluator: &'a Evaluator<'c, 'q>,
    pub body: &'a Node,
    pub negated: bool,
}

/// The moving quantities in an expression.
pub(super) fn moving_names<'n>(evaluator: &Evaluator, node: &'n Node) -> Vec<&'n str> {
    let mut names = Vec::new();
    node.visit(&mut |node| {
        if let Kind::Name { name, .. } = &node.kind
            && evaluator.case.bindings.get(name).is_none()
            && evaluator.case.quantity(None, name).is_ok_and(|quantity| quantity.moves)
        {
            names.push(name.as_str());
        }
    });
    names
}

impl Operator<'_, '_, '_> {
    pub fn judge(&self, piece: &Piece) -> Judged {
        let moment = self.timeline.moment(piece)?;
        self.judge_at(&Evaluator { moment: Some(moment.as_ref()), piece: Some(piece), ..*self.evaluator })
    }

    fn judge_at(&self, inner: &Evaluator) -> Judged {
        let (truth, margin) = inner.judge(self.body)?;
        Ok(if self.negated { (truth.negated(), margin.negated()) } else { (truth, margin) })
    }

    /// Whether the body holds at all times of the span, for every time of `at`.
    fn always(&self, span: &Span, at: &Piece) -> Judged {
        let (from, to) = span.possible(at);
        let (from, to) = self.timeline.inside(from, to);
        if to.as_ref().is_some_and(|to| *to < from) {
            let why = "no time at which the flock moves lies between the bounds".to_string();
            return Err(Failure::Refused(self.body.at, Problem::Empty(why)));
        }
        let sure = span.sure(at).map(|(from, to)| self.timeline.inside(from, to));
        if sure.is_none()
            && let Some(first) = span.first(at)
            && let Some(margin) = self.fails_throughout(&first)?
        {
            return Ok((Truth::False, margin));
        }
        let covered = self.timeline.pieces(&from, to.as_ref(), &moving_names(self.evaluator, self.body))?;
        let mut queue: Vec<(Piece, u32)> = covered.pieces.into_iter().rev().map(|piece| (piece, DEPTH)).collect();
        let (mut margin, mut doubt, mut missing, mut judged) = (Margin::of_truth(true), None, None, 0);
        let (mut open, mut settled) = (Vec::new(), 0);
        let mut growth = Growth::of(self.body, self.negated);
        while let Some((piece, depth)) = queue.pop() {
            judged += 1;
            let is_sure = sure.as_ref().is_some_and(|sure| meets(&piece, sure));
            let (truth, own) = match self.judge(&piece) {
                // It may still be false at another time.
                Err(failure @ Failure::Refused(..)) if is_sure => {
                    margin.lo = f64::NEG_INFINITY;
                    missing.get_or_insert(failure);
                    continue;
                }
                judged => judged?,
            };
            // What happens at times that may not be meant bounds the smallest margin from below only.
            let own = if is_sure { own } else { Margin { hi: f64::INFINITY, ..own } };
            match truth {
                Truth::True => {
                    growth.note(&piece);
                    margin = margin.least(own);
                }
                Truth::False if is_sure => {
                    let rest = if covered.rest.is_none() { self.least(&queue) } else { f64::NEG_INFINITY };
                    let margin = margin.least(own);
                    return Ok((Truth::False, Margin { lo: margin.lo.min(rest), ..margin }));
                }
                truth => {
                    let halves = self.timeline.halves(&piece);
                    let is_tried = matches!(truth, Truth::Unknown(_)) && (depth > DEPTH - 3 || depth == COARSE);
                    if is_tried && growth.is_worth_while() {
                        if self.grows(&growth, &piece)? {
                            growth.note(&piece);
                            margin = margin.least(own.held());
                            continue;
                        }
                        growth.left -= 1;
                    }
                    let looks = settled < MOST_SETTLED && (matches!(depth, 0 | COARSE) || halves.is_none());
                    settled += usize::from(looks);
                    let truth = if looks { self.settled(&piece, truth)? } else { truth };
                    if truth == Truth::True {
                        margin = margin.least(Margin { lo: own.lo.max(0.0), ..own });
                        continue;
                    }
                    let wanted = judged < MOST_JUDGED && depth > 0 && (doubt.is_none() || depth > DEPTH - 4);
                    match halves.filter(|_| wanted) {
                        Some([first, second]) => queue.extend([(second, depth - 1), (first, depth - 1)]),
                        None => {
                            margin = margin.least(own);
                            doubt.get_or_insert_with(|| at_time(truth, &piece));
                            open.push(piece);
                        }
                    }
                }
            }
        }
        if covered.rest.is_some() {
            margin.lo = f64::NEG_INFINITY;
        }
        // A piece may begin or end just where the body becomes false.
        for piece in open.iter().take(MOST_TRIED) {
            if let Some(found) = self.fails_inside(piece, sure.as_ref())? {
                return Ok((Truth::False, margin.least(found)));
            }
        }
        let is_open = !open.is_empty();
        if let Some(found) = self.fails_at_instant(open, sure.as_ref())? {
            return Ok((Truth::False, margin.least(found)));
        }
        let doubt = doubt.map(|doubt| if is_open { self.explained(doubt) } else { doubt });
        match (doubt.or(covered.rest), missing) {
            (Some(doubt), _) => Ok((Truth::Unknown(doubt), margin)),
            (None, Some(failure)) => Err(failure),
            (None, None) => Ok((Truth::True, margin)),
        }
    }

    /// The margin at a time in a piece of some length, if that time is meant for sure and the body is false then.
    fn fails_inside(
        &self,
        piece: &Piece,
        sure: Option<&(Rational, Option<Rational>)>,
    ) -> Result<Option<Margin>, Failure> {
        let Some((to, sure)) = piece.to.as_ref().zip(sure) else { return Ok(None) };
        for part in [rational(1, 8), rational(1, 2), rational(7, 8)] {
            let time = &piece.from + (to - &piece.from) * part;
            let moment = Piece { from: time.clone(), to: Some(time) };
            if !meets(&moment, sure) {
                continue;
            }
            match self.judge(&moment) {
                Ok((Truth::False, margin)) => return Ok(Some(margin)),
                Ok(_) | Err(Failure::Refused(..) | Failure::Open(_)) => {}
                Err(stopped) => return Err(stopped),
            }
        }
        Ok(None)
    }

    /// The margin at an instant in undecided pieces at which everything is known exactly, if that is meant for sure and the body is false then: a value that is
    /// touched, and not passed, has no length of time.
    fn fails_at_instant(
        &self,
        open: Vec<Piece>,
        sure: Option<&(Rational, Option<Rational>)>,
    ) -> Result<Option<Margin>, Failure> {
        let Some((from, to)) = sure else { return Ok(None) };
        let is_meant = |piece: &Piece| {
            let within = |end: &Rational| to.as_ref().is_none_or(|to| end <= to);
            piece.from >= *from && piece.to.as_ref().is_some_and(within)
        };
        self.instant_of(Truth::False, open.into_iter().filter(is_meant).collect())
    }

    /// The margin at an instant in undecided pieces at which everything is known exactly, and the body has this truth.
    pub fn instant_of(&self, wanted: Truth, open: Vec<Piece>) -> Result<Option<Margin>, Failure> {
        self.at_instants(open, &mut |_, (truth, margin)| Ok((truth == wanted).then_some(margin)))
    }

    /// Whether there are time operators in the body.
    fn has_times(&self) -> bool {
        let mut has_times = false;
        self.body.visit(&mut |node| has_times |= matches!(node.kind, Kind::Always(..) | Kind::Until(_)));
        has_times
    }

    /// A doubt about short pieces with what is not decided there.
    pub fn explained(&self, doubt: Doubt) -> Doubt {
        if self.has_times() || self.timeline.is_discrete() {
            return doubt;
        }
        let why = match self.timeline.has_instants() {
            true => {
                "no instant at which the motion is known exactly decides it, and that two sides only touch and never pass is not proved".to_string()
            }
            false => {
                format!("whether two sides only touch there is not decided, since {}", self.timeline.without_instants())
            }
        };
        Doubt { why: format!("{}; {why}", doubt.why), ..doubt }
    }

    /// What is found first at instants of undecided pieces at which everything is known exactly, of a body without time operators.
    pub fn at_instants<R>(&self, open: Vec<Piece>, visit: &mut Visit<R>) -> Result<Option<R>, Failure> {
        /// Judgements of pieces, and pieces in which instants are looked for.
        const MOST: usize = 400;
        const SHORTEST: i64 = 1 << 20;
        let mut queue: VecDeque<Piece> = open.into_iter().filter(|_| !self.has_times()).collect();
        let (mut pieces, mut judged) = (Vec::new(), 0);
        while let Some(piece) = queue.pop_front().filter(|_| pieces.len() < MOST) {
            let length = piece.to.as_ref().map_or(rational(0, 1), |to| to - &piece.from);
            let halves = self.timeline.halves(&piece).filter(|_| judged < MOST && length > rational(1, SHORTEST));
            let Some(halves) = halves else {
                pieces.push(piece);
                continue;
            };
            for half in halves {
                judged += 1;
                match self.judge(&half) {
                    Ok((Truth::Unknown(_), _)) => queue.push_back(half),
                    Ok(_) | Err(Failure::Refused(..) | Failure::Open(_)) => {}
                    Err(stopped) => return Err(stopped),
                }
            }
        }
        for piece in &pieces {
            for (piece, moment) in self.timeline.instants(piece, self.evaluator.precision) {
                let inner = Evaluator { moment: Some(moment.as_ref()), piece: Some(&piece), ..*self.evaluator };
                match self.judge_at(&inner) {
                    Ok(judged) => match visit(&inner, judged)? {
                        None => {}
                        found => return Ok(found),
                    },
                    Err(Failure::Refused(..) | Failure::Open(_)) => {}
                    Err(stopped) => return Err(stopped),
                }
            }
        }
        Ok(None)
    }

    /// A bound of the margins, if the body is false at all times of a piece: of short windows no time is meant at every time of a piece, but each of its times
    /// has a time of its own.
    pub fn fails_throughout(&self, times: &Piece) -> Result<Option<Margin>, Failure> {
        const HALVINGS: u32 = 5;
        let covered = self.timeline.pieces(&times.from, times.to.as_ref(), &moving_names(self.evaluator, self.body))?;
        if covered.rest.is_some() {
            return Ok(None);
        }
        let mut margin = Margin { lo: f64::NEG_INFINITY, hi: f64::NEG_INFINITY };
        let mut queue: Vec<(Piece, u32)> = covered.pieces.into_iter().map(|piece| (piece, HALVINGS)).collect();
        while let Some((piece, depth)) = queue.pop() {
            let (truth, own) = self.judge(&piece)?;
            match (truth, self.timeline.halves(&piece)) {
                (Truth::False, _) => margin.hi = margin.hi.max(own.hi),
                (Truth::Unknown(_), Some(halves)) if depth > 0 => queue.extend(halves.map(|half| (half, depth - 1))),
                _ => return Ok(None),
            }
        }
        Ok(Some(margin))
    }

    /// A lower bound of the margins in pieces that were not looked at yet.
    fn least(&self, pieces: &[(Piece, u32)]) -> f64 {
        const MOST: usize = 2000;
        if pieces.len() > MOST {
            return f64::NEG_INFINITY;
        }
        let own = |(piece, _): &(Piece, u32)| self.judge(piece).map_or(f64::NEG_INFINITY, |(_, margin)| margin.lo);
        pieces.iter().map(own).fold(f64::INFINITY, f64::min)
    }
}

fn meets(piece: &Piece, (from, to): &(Rational, Option<Rational>)) -> bool {
    let first = (&piece.from).max(from);
    [&piece.to, to].into_iter().flatten().all(|end| first <= end)
}

/// A doubt with the time where it arose.
pub(super) fn at_time(truth: Truth, piece: &Piece) -> Doubt {
    use num_traits::ToPrimitive;
    let time = format!("at t = {}", clock(piece.from.to_f64().unwrap_or(f64::NAN)));
    match truth {
        Truth::Unknown(doubt) => Doubt { why: format!("{time} {}", doubt.why), bits: doubt.bits },
        _ => Doubt { why: format!("{time} it depends on the exact time"), bits: None },
    }
}
