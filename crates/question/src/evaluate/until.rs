//! `p until[a, b] q` in continuous time.

use super::time::{COARSE, DEPTH, MOST_JUDGED, MOST_SETTLED, Operator, Span, at_time, moving_names};
use super::{Evaluator, Judged};
use crate::failure::Failure;
use crate::syntax::{Kind, Node, Relation};
use crate::timeline::{Piece, Timeline};
use crate::truth::{Margin, Truth};
use arithmetic::Rational;
use num_traits::Signed;

/// Whether there is a time in the span at which `second` holds, and `first` does from now until before then.
pub(super) fn until(
    timeline: &dyn Timeline,
    evaluator: &Evaluator,
    span: &Span,
    first: &Node,
    second: &Node,
    at: &Piece,
) -> Judged {
    let possible = span.possible(at);
    let sure = span.sure(at);
    let mut names = moving_names(evaluator, first);
    names.extend(moving_names(evaluator, second));
    let covered = timeline.pieces(&at.from, possible.1.as_ref(), &names)?;
    if sure.is_none()
        && let Some(margin) =
            comes_at_once(span, [first, second].map(|body| Operator { timeline, evaluator, body, negated: true }), at)?
    {
        return Ok((Truth::True, margin));
    }
    let [keeps, comes] = [first, second].map(|body| Operator { timeline, evaluator, body, negated: false });
    // Where the meaning of a time changes: where now may be at the latest, where the window may begin and end.
    let ends = |span: &(Rational, Option<Rational>)| std::iter::once(span.0.clone()).chain(span.1.clone());
    let mut changes: Vec<Rational> = ends(&possible).chain(sure.iter().flat_map(ends)).chain(at.to.clone()).collect();
    changes.sort();
    changes.dedup();
    let cut = covered.pieces.into_iter().flat_map(|piece| cut(piece, &changes));
    let mut queue: Vec<(Piece, u32)> = cut.map(|piece| (piece, DEPTH)).collect();
    queue.reverse();
    let (mut kept, mut may_have_come, mut doubt, mut judged, mut settled) = (true, false, None, 0, 0);
    // Where `q` may come at an instant while `p` holds, and where `p` may fail at one before `q` can have come.
    let (mut comings, mut failings) = (Vec::new(), Vec::new());
    // Where `q` is that `p` fails, `p` holds in the window until `q` comes for the first time.
    let waits = is_closed_opposite(evaluator, first, second);
    let mut margin = LargestUntil::new(covered.rest.is_some());
    while let Some((piece, depth)) = queue.pop() {
        let (keeping, keeps_by) = keeps.judge(&piece)?;
        let is_possible = overlaps(&piece, &possible);
        let (coming, comes_by) =
            if is_possible { comes.judge(&piece)? } else { (Truth::False, Margin::of_truth(false)) };
        judged += 1;
        let (mut keeping, mut coming) = (keeping, coming);
        let looks = matches!(depth, 0 | COARSE) || timeline.halves(&piece).is_none();
        if looks
            && settled < MOST_SETTLED
            && matches!((&keeping, &coming), (Truth::Unknown(_), _) | (_, Truth::Unknown(_)))
        {
            settled += 1;
            (keeping, coming) = (keeps.settled(&piece, keeping)?, comes.settled(&piece, coming)?);
        }
        let inside = sure.as_ref().is_some_and(|sure| lies_in(&piece, sure));
        let keeping = if waits && inside { Truth::True } else { keeping };
        // Only after the last time of `at` does the piece lie between now and then whatever now is.
        let after = at.to.as_ref().is_some_and(|now| piece.from >= *now);
        let keeps_by = if after { keeps_by } else { Margin { hi: f64::INFINITY, ..keeps_by } };
        if coming == Truth::True && kept && inside {
            // It has come when the piece begins.
            margin.include(keeps_by, comes_by, inside);
            let margin = margin.so_far();
            return Ok((Truth::True, Margin { lo: margin.lo.max(0.0), ..margin }));
        }
        let is_decided = coming == Truth::False && !matches!(keeping, Truth::Unknown(_));
        let wanted = !is_decided && judged < MOST_JUDGED && depth > 0 && !may_have_come;
        if let Some([one, two]) = timeline.halves(&piece).filter(|_| wanted) {
            queue.extend([(two, depth - 1), (one, depth - 1)]);
            continue;
        }
        margin.include(keeps_by, comes_by, inside);
        match (keeping, coming) {
            // From here on it is too late.
            (Truth::False, Truth::False) if after && !may_have_come => {
                return Ok((Truth::False, margin.so_far()));
            }
            (Truth::True, Truth::False) => {}
            (Truth::True, truth) => {
                may_have_come = true;
                doubt.get_or_insert_with(|| at_time(truth, &piece));
                comings.extend(Some(piece).filter(|_| kept && inside));
            }
            (truth, coming) => {
                // The first time of the window belongs to the piece before it, and `q` may come then, at which nothing is asked of `p` any more.
                let is_before = is_possible || piece.to.as_ref().is_some_and(|to| *to < possible.0);
                let is_early = after && is_before && !may_have_come && coming == Truth::False;
                failings.extend(Some(piece.clone()).filter(|_| is_early));
                kept = false;
                may_have_come |= coming != Truth::False;
                doubt.get_or_insert_with(|| at_time(truth, &piece));
            }
        }
    }
    let is_open = !(comings.is_empty() && failings.is_empty());
    // What is true has no margin below 0, and what is false none above.
    if keeps.instant_of(Truth::False, failings)?.is_some() {
        return Ok((Truth::False, Margin { hi: margin.whole().hi.min(0.0), ..margin.whole() }));
    }
    if comes.instant_of(Truth::True, comings)?.is_some() {
        return Ok((Truth::True, Margin { lo: margin.whole().lo.max(0.0), ..margin.whole() }));
    }
    let doubt = doubt.map(|doubt| if is_open { comes.explained(doubt) } else { doubt });
    match doubt.or(covered.rest) {
        None => Ok((Truth::False, margin.whole())),
        Some(doubt) => Ok((Truth::Unknown(doubt), margin.whole())),
    }
}

/// Whether `second` says that `first` does not hold, and of continuous quantities with `<=` or `>=`: then its times are a closed set, and there is a first one
/// if there are any.
fn is_closed_opposite(evaluator: &Evaluator, first: &Node, second: &Node) -> bool {
    /// What jumps where links change.
    const JUMPING: [&str; 3] = ["components", "potential", "energy"];
    let (Kind::Relation(a, before), Kind::Relation(c, after)) = (&first.kind, &second.kind) else { return false };
    let ([(keeping, b)], [(coming, d)]) = (before.as_slice(), after.as_slice()) else { return false };
    let is_same = |x: &Node, y: &Node| x.to_string() == y.to_string();
    matches!(coming, Relation::AtMost | Relation::AtLeast)
        && keeping.turned() == *coming
        && is_same(a, c)
        && is_same(b, d)
        && moving_names(evaluator, second).iter().all(|name| !JUMPING.contains(name))
        && is_continuous(evaluator, second)
}

/// Whether an expression is continuous in its moving quantities wherever they are: no divisor moves, and no argument of a function with a domain.
fn is_continuous(evaluator: &Evaluator, node: &Node) -> bool {
    let is_still = |node: &Node| moving_names(evaluator, node).is_empty();
    let mut continuous = true;
    node.visit(&mut |node| {
        continuous &= match &node.kind {
            Kind::Product(factors) => factors.iter().all(|(divides, factor)| !divides || is_still(factor)),
            Kind::Power(base, exponent) => {
                is_still(base) && is_still(exponent)
                    || matches!(&exponent.kind, Kind::Number(q) if q.is_integer() && !q.is_negative())
            }
            Kind::Name { name, .. } if matches!(name.as_str(), "log" | "sqrt" | "gcd") => is_still(node),
            _ => true,
        };
    });
    continuous
}

/// A bound of the margins, if at all times of a piece `q` comes at the first time that is meant, and `p` holds until then. Both are given negated.
fn comes_at_once(span: &Span, [keeps, comes]: [Operator; 2], at: &Piece) -> Result<Option<Margin>, Failure> {
    let Some(first) = span.first(at) else { return Ok(None) };
    let Some(coming) = comes.fails_throughout(&first)? else { return Ok(None) };
    let Some(keeping) = keeps.fails_throughout(&Piece { from: at.from.clone(), to: first.to })? else {
        return Ok(None);
    };
    Ok(Some(coming.largest(keeping).negated()))
}

/// A piece cut at some times in order, each of which becomes a piece of its own.
fn cut(piece: Piece, times: &[Rational]) -> Vec<Piece> {
    let mut parts = Vec::new();
    let mut from = piece.from.clone();
    for time in times.iter().filter(|time| **time >= piece.from && piece.to.as_ref().is_none_or(|to| *time <= to)) {
        if from < *time {
            parts.push(Piece { from, to: Some(time.clone()) });
        }
        parts.push(Piece { from: time.clone(), to: Some(time.clone()) });
        from = time.clone();
    }
    if piece.to.as_ref().is_none_or(|to| from < *to) || parts.is_empty() {
        parts.push(Piece { from, ..piece });
    }
    parts
}

/// Whether a piece has times of a stretch in its inside, or is one of them; the ends of the stretch are pieces of their own.
fn overlaps(piece: &Piece, span: &(Rational, Option<Rational>)) -> bool {
    if piece.to.as_ref() == Some(&piece.from) {
        return lies_in(piece, span);
    }
    let (from, to) = span;
    piece.to.as_ref().is_none_or(|end| from < end) && to.as_ref().is_none_or(|to| piece.from < *to)
}

/// Whether all times of a piece are meant.
fn lies_in(piece: &Piece, (from, to): &(Rational, Option<Rational>)) -> bool {
    piece.from >= *from && to.as_ref().is_none_or(|to| piece.to.as_ref().is_some_and(|end| end <= to))
}

/// The margin of `p until q`: the largest, over the times at which `q` may come, of the smaller one of the margin of `q` there and the
/// smallest of `p` before then.
struct LargestUntil {
    /// Of `p` so far.
    kept: Margin,
    /// Of the pieces so far.
    found: Margin,
    /// Whether the motion is not known to the end.
    is_cut: bool,
}

impl LargestUntil {
    fn new(is_cut: bool) -> Self {
        LargestUntil { kept: Margin::of_truth(true), found: Margin::of_truth(false), is_cut }
    }

    /// The next piece; `inside` where all its times are meant.
    fn include(&mut self, keeps: Margin, comes: Margin, inside: bool) {
        // At its first time `p` is not asked for on the piece.
        let most = self.kept.hi.min(comes.hi);
        let least = if inside { self.kept.lo.min(comes.lo) } else { f64::NEG_INFINITY };
        self.kept = self.kept.least(keeps);
        self.found = self.found.largest(Margin { lo: least, hi: most });
    }

    /// With later pieces that were not looked at: they have at most what `p` still has.
    fn so_far(&self) -> Margin {
        Margin { hi: self.found.hi.max(self.kept.hi), ..self.found }
    }

    fn whole(&self) -> Margin {
        if self.is_cut { self.so_far() } else { self.found }
    }
}
