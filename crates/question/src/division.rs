//! A continuum divided into boxes until every one is decided.

use crate::bindings::{Bindings, Value};
use crate::case::Case;
use crate::error::QuestionError;
use crate::names::Subject;
use crate::outcome::{Decided, Judged};
use crate::point::FIRST_BITS;
use crate::question::{Expression, Question};
use crate::truth::{Doubt, Margin, Truth};
use arithmetic::{Progress, Rational};
use num_traits::{Signed, ToPrimitive};
use std::collections::BinaryHeap;

/// Boxes whose middle is looked at for a counterexample; later only every so many.
const PROBED: u64 = 64;
const PROBED_LATER: u64 = 16;

/// A continuum that is divided until every box is decided.
pub(crate) struct Division<'a> {
    pub question: &'a Question,
    pub expression: &'a Expression,
    pub progress: &'a dyn Progress,
    pub most: u64,
}

/// A box that is not decided, the one with the smallest margin first.
struct Open {
    bindings: Bindings,
    margin: f64,
    number: u64,
    doubt: Doubt,
    bounds: Margin,
    inequalities: Vec<Margin>,
}

type OnBox = (Option<Truth>, Margin, Vec<Margin>);

impl PartialEq for Open {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Open {}
impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Open {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        other.margin.total_cmp(&self.margin).then_with(|| other.number.cmp(&self.number))
    }
}

impl Division<'_> {
    pub fn decide(&self, whole: &Bindings) -> Result<Decided, QuestionError> {
        let original = whole.boxes();
        let mut found = Decided::nothing();
        let mut heap = BinaryHeap::new();
        let mut queue = vec![whole.clone()];
        let (mut number, mut probes, mut kept) = (0, 0u64, false);
        loop {
            for bindings in queue.drain(..) {
                self.progress.checkpoint()?;
                found.boxes += 1;
                number += 1;
                let (truth, margin, inequalities) = self.on_box(&bindings, number == 1)?;
                kept |= truth.is_some();
                if number == 1 && self.fails_at_a_corner(&bindings, &mut found)? {
                    return Ok(found);
                }
                match truth {
                    None => {}
                    Some(Truth::True) => {
                        found.margin = found.margin.least(margin);
                        Margin::least_of_each(&mut found.inequalities, &inequalities);
                    }
                    Some(Truth::False) => {
                        if self.fails_at(bindings.middle(), &mut found)? {
                            return Ok(found);
                        }
                        let doubt =
                            Doubt { why: "a box fails, but its middle is left out by `where`".to_string(), bits: None };
                        heap.push(Open { bindings, margin: margin.lo, number, doubt, bounds: margin, inequalities });
                    }
                    Some(Truth::Unknown(doubt)) => {
                        heap.push(Open { bindings, margin: margin.lo, number, doubt, bounds: margin, inequalities });
                    }
                }
            }
            let Some(worst) = heap.pop() else {
                found.excluded = !kept;
                return Ok(found);
            };
            probes += 1;
            if (probes <= PROBED || probes.is_multiple_of(PROBED_LATER))
                && self.fails_at(worst.bindings.middle(), &mut found)?
            {
                return Ok(found);
            }
            let halves = if found.boxes < self.most { halved(&worst.bindings, &original) } else { None };
            match halves {
                Some(halves) => queue.extend(halves),
                None => {
                    let open = heap.iter().fold(worst.bounds, |least, open| least.least(open.bounds));
                    found.open = 1 + heap.len() as u64;
                    found.margin = found.margin.least(open);
                    let each = heap.iter().chain([&worst]);
                    each.for_each(|open| Margin::least_of_each(&mut found.inequalities, &open.inequalities));
                    let at = worst.bindings.to_string();
                    let why = format!("{} (on the box {at})", worst.doubt.why);
                    found.truth = Truth::Unknown(Doubt { why, bits: None });
                    return Ok(found);
                }
            }
        }
    }

    /// The truth on a box, `None` where `where` leaves all of it out; its margin, and those of its inequalities.
    pub fn on_box(&self, bindings: &Bindings, is_first: bool) -> Result<OnBox, QuestionError> {
        // Of a range of integers a single one is left in the end.
        if bindings.boxes().is_empty() {
            if !self.question.is_kept(bindings, self.progress)? {
                return Ok((None, Margin::of_truth(true), Vec::new()));
            }
            let Judged { truth, margin, inequalities } =
                self.question.decide_point(self.expression, bindings, self.progress)?;
            return Ok((Some(truth), margin, inequalities));
        }
        let case = Case::new(self.question, bindings.clone(), is_first, self.progress);
        let mut kept = Truth::True;
        if let Some(restriction) = &self.question.restriction {
            kept = self.question.judged(&case, restriction, FIRST_BITS)?.0;
            if kept == Truth::False {
                return Ok((None, Margin::of_truth(true), Vec::new()));
            }
        }
        let (truth, margin) = self.question.judged(&case, self.expression, FIRST_BITS)?;
        let truth = match (truth, kept) {
            (Truth::False, Truth::Unknown(doubt)) => Truth::Unknown(doubt),
            (truth, _) => truth,
        };
        let inequalities = self.question.each_margin(&case, self.expression, FIRST_BITS, margin)?;
        Ok((Some(truth), margin, inequalities))
    }

    /// Whether the property fails at a corner of the box, where extremes often are.
    fn fails_at_a_corner(&self, bindings: &Bindings, found: &mut Decided) -> Result<bool, QuestionError> {
        const MOST_SIDES: usize = 4;
        let boxes = bindings.boxes();
        // A motion takes too long for that.
        if boxes.len() > MOST_SIDES || self.question.subjects().contains(&Subject::Motion) {
            return Ok(false);
        }
        for choice in 0..1usize << boxes.len() {
            let mut corner = bindings.clone();
            for (side, (place, lo, hi)) in boxes.iter().enumerate() {
                corner.set(*place, Value::Number(if choice >> side & 1 == 1 { hi.clone() } else { lo.clone() }));
            }
            if self.fails_at(corner, found)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether the property fails at a point, exactly or by enclosure; its margin bounds the smallest one from above.
    fn fails_at(&self, point: Bindings, found: &mut Decided) -> Result<bool, QuestionError> {
        if !matches!(self.question.is_kept(&point, self.progress), Ok(true)) {
            return Ok(false);
        }
        let Judged { truth, margin, inequalities } =
            self.question.decide_point(self.expression, &point, self.progress)?;
        // Of the smallest margins these are upper bounds.
        let below = |margin: Margin| Margin { lo: f64::INFINITY, ..margin };
        let bounds: Vec<Margin> = inequalities.iter().copied().map(below).collect();
        found.margin = found.margin.least(below(margin));
        found.margin.lo = found.margin.lo.min(found.margin.hi);
        Margin::least_of_each(&mut found.inequalities, &bounds);
        found.inequalities.iter_mut().for_each(|own| own.lo = own.lo.min(own.hi));
        if truth != Truth::False {
            return Ok(false);
        }
        found.margin = found.margin.least(margin);
        Margin::least_of_each(&mut found.inequalities, &inequalities);
        found.truth = Truth::False;
        found.counterexample = Some(point);
        Ok(true)
    }
}

/// Two halves of a box, across the side that is widest compared with its numbers; `None` where it has become too thin.
pub(crate) fn halved(bindings: &Bindings, original: &[(usize, Rational, Rational)]) -> Option<[Bindings; 2]> {
    const THINNEST: f64 = 1e-12;
    let relative = |(place, lo, hi): &(usize, Rational, Rational)| {
        let width = (hi - lo).to_f64().unwrap_or(0.0);
        let size = lo.abs().max(hi.abs()).to_f64().unwrap_or(1.0);
        let whole =
            original.iter().find(|(other, ..)| other == place).map_or(1.0, |(_, a, b)| (b - a).to_f64().unwrap_or(1.0));
        if lo.is_positive() || hi.is_negative() { width / size } else { width / whole }
    };
    let boxes = bindings.boxes();
    let widest = boxes.iter().max_by(|a, b| relative(a).total_cmp(&relative(b)))?;
    if relative(widest) < THINNEST { None } else { bindings.halves(widest.0) }
}
