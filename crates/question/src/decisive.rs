//! The inequality that decides a property at one point, with the values of its two sides and the time at which it does.

use crate::bindings::Bindings;
use crate::case::Case;
use crate::error::QuestionError;
use crate::evaluate::Evaluator;
use crate::failure::Failure;
use crate::point::{FIRST_BITS, MOST_BITS};
use crate::question::{Expression, Question};
use crate::syntax::{Kind, Node};
use crate::timeline::Piece;
use crate::truth::{Doubt, Margin, Truth};
use arithmetic::Progress;

/// Bits that are tried: eigenvalues of which there are closed forms or rational ones show themselves above those that floating point has.
const BITS: [u32; 3] = [FIRST_BITS + 1, 4 * FIRST_BITS, 32 * FIRST_BITS];

/// An inequality with the values of its sides.
#[derive(Debug, Clone, PartialEq)]
pub struct Decisive {
    /// The inequality as it stands in the property.
    pub inequality: String,
    /// What stands on its left: exact, or an enclosure `[lo, hi]`.
    pub left: String,
    /// What stands on its right.
    pub right: String,
    /// Its own margin.
    pub margin: Margin,
    /// The time, or the times `[from, to]`, of a property with time operators.
    pub time: Option<String>,
}

impl Question {
    /// What makes a property `wanted`, which is its truth at a point; `None` where no inequality does.
    pub(crate) fn decisive(
        &self,
        property: &Expression,
        at: &Bindings,
        wanted: bool,
        progress: &dyn Progress,
    ) -> Result<Option<Decisive>, QuestionError> {
        let case = Case::new(self, at.clone(), progress);
        let mut all = BITS.to_vec();
        let mut next = 0;
        while let Some(&precision) = all.get(next) {
            progress.checkpoint()?;
            next += 1;
            let evaluator = Evaluator { case: &case, precision, moment: None, piece: None };
            match found(&evaluator, &property.node, wanted) {
                Ok(Some(found)) => return Ok(Some(found)),
                Err(Failure::Cancelled) => progress.checkpoint()?,
                // A tie is known where so many bits agree.
                Err(Failure::Open(Doubt { bits: Some(needed), .. })) if needed <= MOST_BITS && next == all.len() => {
                    all.extend(u32::try_from(needed.next_power_of_two() * 2).ok().filter(|bits| *bits > precision));
                }
                // It was confirmed before; only its sides cannot be shown.
                Ok(None) | Err(_) => {}
            }
        }
        Ok(None)
    }
}

/// What makes a property `wanted`, which is its truth.
fn found(evaluator: &Evaluator, node: &Node, wanted: bool) -> Result<Option<Decisive>, Failure> {
    match &node.kind {
        Kind::Not(body) => found(evaluator, body, !wanted),
        Kind::And(list) => one_of(evaluator, list.iter().map(|node| (node, wanted)), !wanted),
        Kind::Or(list) => one_of(evaluator, list.iter().map(|node| (node, wanted)), wanted),
        // It fails by what it says, not by what it supposes.
        Kind::Implies(first, second) if !wanted => match found(evaluator, second, false)? {
            None => found(evaluator, first, true),
            decisive => Ok(decisive),
        },
        Kind::Implies(first, second) => {
            one_of(evaluator, [(first.as_ref(), false), (second.as_ref(), true)].into_iter(), true)
        }
        Kind::Always(always, parts) => {
            let best = best_time(evaluator, node, 0, wanted, *always != wanted)?;
            match at_time(evaluator, &parts[2], best, wanted)? {
                None => evaluator.at_instant(node, wanted, &|inner| found(inner, &parts[2], wanted)),
                decisive => Ok(decisive),
            }
        }
        Kind::Until(parts) => {
            // Where the second part comes too late, what stands in its way is the first one.
            let comes = best_time(evaluator, node, 1, true, true)?;
            if wanted || comes.is_none() {
                let time = if wanted { comes } else { best_time(evaluator, node, 1, false, false)? };
                return at_time(evaluator, &parts[3], time, wanted);
            }
            let fails = best_time(evaluator, node, 0, false, true)?;
            at_time(evaluator, &parts[2], fails, false)
        }
        Kind::Relation(first, others) => {
            let lefts = std::iter::once(first.as_ref()).chain(others.iter().map(|(_, right)| right));
            let link = |(left, (relation, right)): (&Node, &(_, Node))| Node {
                kind: Kind::Relation(Box::new(left.clone()), vec![(*relation, right.clone())]),
                at: left.at,
            };
            let links: Vec<Node> = lefts.zip(others).map(link).collect();
            let Some(place) = place_of(evaluator, links.iter().map(|node| (node, wanted)), !wanted)? else {
                return Ok(None);
            };
            let Kind::Relation(left, right) = &links[place].kind else { return Ok(None) };
            let [left, right] = [left.as_ref(), &right[0].1].map(|side| evaluator.number(side));
            Ok(Some(Decisive {
                inequality: links[place].to_string(),
                left: left?.text(),
                right: right?.text(),
                margin: evaluator.judge(&links[place])?.1,
                time: evaluator.piece.map(time_of),
            }))
        }
        _ => Ok(None),
    }
}

fn time_of(piece: &Piece) -> String {
    match &piece.to {
        Some(to) if *to == piece.from => to.to_string(),
        Some(to) => format!("[{}, {to}]", piece.from),
        None => format!("[{}, inf]", piece.from),
    }
}

/// The part that decides: where one is enough, one that is as it is wanted; where all have to be, the one that is so by the least margin.
fn one_of<'n>(
    evaluator: &Evaluator,
    parts: impl Iterator<Item = (&'n Node, bool)>,
    is_one_enough: bool,
) -> Result<Option<Decisive>, Failure> {
    let parts: Vec<(&Node, bool)> = parts.collect();
    let Some(place) = place_of(evaluator, parts.iter().copied(), is_one_enough)? else { return Ok(None) };
    found(evaluator, parts[place].0, parts[place].1)
}

fn place_of<'n>(
    evaluator: &Evaluator,
    parts: impl Iterator<Item = (&'n Node, bool)>,
    is_one_enough: bool,
) -> Result<Option<usize>, Failure> {
    let mut least: Option<(usize, f64)> = None;
    let mut unknown = None;
    for (place, (node, wanted)) in parts.enumerate() {
        let Ok((truth, margin)) = evaluator.judge(node) else { continue };
        // Another part is not what decides as long as this one is not known.
        if let Truth::Unknown(doubt) = truth {
            unknown.get_or_insert(doubt);
            continue;
        }
        if truth != Truth::of(wanted) {
            continue;
        }
        if is_one_enough {
            return Ok(Some(place));
        }
        let own = speaking(margin, wanted);
        if least.is_none_or(|(_, least)| own < least) {
            least = Some((place, own));
        }
    }
    match unknown {
        Some(doubt) => Err(Failure::Open(doubt)),
        None => Ok(least.map(|(place, _)| place)),
    }
}

/// How far it is from being otherwise, at least.
fn speaking(margin: Margin, wanted: bool) -> f64 {
    if wanted { margin.lo } else { -margin.hi }
}

/// A time at which a part of a time operator is `wanted`: the first one, or that with the least margin.
fn best_time(
    evaluator: &Evaluator,
    node: &Node,
    part: usize,
    wanted: bool,
    is_one_enough: bool,
) -> Result<Option<Piece>, Failure> {
    let mut best: Option<(Piece, f64)> = None;
    evaluator.each_time(node, part, &mut |piece, truth, margin| {
        if truth != Truth::of(wanted) {
            return true;
        }
        let own = speaking(margin, wanted);
        if best.as_ref().is_none_or(|(_, least)| own < *least) {
            best = Some((piece.clone(), own));
        }
        !is_one_enough
    })?;
    Ok(best.map(|(piece, _)| piece))
}

fn at_time(evaluator: &Evaluator, body: &Node, time: Option<Piece>, wanted: bool) -> Result<Option<Decisive>, Failure> {
    let Some(piece) = time else { return Ok(None) };
    let moment = evaluator.case.timeline()?.moment(&piece)?;
    let inner = Evaluator { moment: Some(moment.as_ref()), piece: Some(&piece), ..*evaluator };
    found(&inner, body, wanted)
}
