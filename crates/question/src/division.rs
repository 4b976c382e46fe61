//! A continuum divided into boxes until every one is decided.

use crate::bindings::{Bindings, Value};
use crate::case::Case;
use crate::error::QuestionError;
use crate::failure::Failure;
use crate::formula::{Clause, clauses};
use crate::names::Subject;
use crate::outcome::{Decided, Judged, Unsettled};
use crate::point::FIRST_BITS;
use crate::question::{Expression, Question};
use crate::syntax::Kind;
use crate::truth::{Doubt, Margin, Truth};
use arithmetic::{Progress, Rational};
use num_traits::{Signed, ToPrimitive};
use polynomials::Side;
use polynomials::decide::{Decision, Effort, Open};
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
struct Undecided {
    bindings: Bindings,
    margin: f64,
    number: u64,
    doubt: Doubt,
    bounds: Margin,
    inequalities: Vec<Margin>,
}

/// What is known on a box.
pub(crate) struct OnBox {
    /// `None` where `where` leaves all of it out.
    pub truth: Option<Truth>,
    pub margin: Margin,
    /// Those of its inequalities.
    pub inequalities: Vec<Margin>,
    /// Whether something was asked for that no box has.
    pub points_only: bool,
}

impl PartialEq for Undecided {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}
impl Eq for Undecided {}
impl PartialOrd for Undecided {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Undecided {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        other.margin.total_cmp(&self.margin).then_with(|| other.number.cmp(&self.number))
    }
}

/// Points without a value: the first one found, and how many there were.
#[derive(Default)]
struct Missing {
    first: Option<QuestionError>,
    count: u64,
}

/// Boxes before a property of numbers alone is decided where it is attained.
const FIRST_BOXES: u64 = 64;

/// Most boxes then.
const MOST_SHARP: u64 = 20_000;

/// Open boxes that are told.
const TOLD: usize = 64;

fn boxed(whole: &Bindings, places: &[(usize, Side)], sides: &[Side]) -> Bindings {
    let mut bindings = whole.clone();
    for ((place, _), side) in places.iter().zip(sides) {
        if let (Some(lo), Some(hi)) = (&side.lo, &side.hi) {
            let value = if lo == hi { Value::Number(lo.clone()) } else { Value::Box(lo.clone(), hi.clone()) };
            bindings.set(*place, value);
        }
    }
    bindings
}

/// What is left open, in words.
fn told(open: &Open, first: Option<&Bindings>) -> String {
    let mut text = open.why.clone();
    if !open.degrees.is_empty() {
        let degrees: Vec<String> = open.degrees.iter().map(ToString::to_string).collect();
        text += &format!("; sums of squares were looked for in vain, of degree {}", degrees.join(", "));
    }
    if let Some(share) = open.share {
        text += &format!("; open is a share of {share:.3e} of the volume");
    }
    first.map_or(text.clone(), |bindings| format!("{text} (a box: {bindings})"))
}

/// Boxes that are still looked at for a counterexample when a value is missing.
const AFTER_MISSING: u64 = 1024;

/// Most boxes where something is asked for that no box has.
const POINTS_ONLY: u64 = 256;

impl Division<'_> {
    /// Boxes first; what they leave open is decided where it is attained, as far as the property is one of numbers alone.
    pub fn decide(&self, whole: &Bindings) -> Result<Decided, QuestionError> {
        let restriction = self.question.restriction.as_ref().map(|own| &own.node);
        let Some(clauses) = clauses(whole, restriction, &self.expression.node) else {
            return Ok(self.by_boxes(whole, self.most)?.0);
        };
        let (found, missing) = self.by_boxes(whole, self.most.min(FIRST_BOXES))?;
        if missing || !matches!(found.truth, Truth::Unknown(_)) {
            return if missing { Ok(self.by_boxes(whole, self.most)?.0) } else { Ok(found) };
        }
        self.where_attained(whole, &clauses, found)
    }

    /// Whether the property, one of numbers alone, holds on all of a box, with little effort.
    pub fn holds_where_attained(&self, whole: &Bindings) -> Result<bool, QuestionError> {
        const EFFORT: Effort = Effort { boxes: 64, squares: false };
        let restriction = self.question.restriction.as_ref().map(|own| &own.node);
        let Some(clauses) = clauses(whole, restriction, &self.expression.node) else { return Ok(false) };
        let domain: Vec<Side> = whole.boxes().into_iter().map(|(_, lo, hi)| Side::between(lo, hi)).collect();
        for clause in &clauses {
            let decision = polynomials::decide::decide(clause, &domain, EFFORT, self.progress)?;
            if !matches!(decision, Decision::Holds(_)) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Every clause by itself.
    fn where_attained(
        &self,
        whole: &Bindings,
        clauses: &[Clause],
        mut found: Decided,
    ) -> Result<Decided, QuestionError> {
        let places: Vec<(usize, Side)> =
            whole.boxes().into_iter().map(|(place, lo, hi)| (place, Side::between(lo, hi))).collect();
        let domain: Vec<Side> = places.iter().map(|(_, side)| side.clone()).collect();
        let at = |point: &[Rational]| {
            let mut bindings = whole.clone();
            places.iter().zip(point).for_each(|((place, _), q)| bindings.set(*place, Value::Number(q.clone())));
            bindings
        };
        let effort = Effort { boxes: self.most.min(MOST_SHARP), ..Effort::default() };
        let mut missing = Missing::default();
        let mut left: Option<Open> = None;
        (found.open, found.truth) = (0, Truth::True);
        for clause in clauses {
            let decision = polynomials::decide::decide(clause, &domain, effort, self.progress)?;
            match decision {
                Decision::Holds(proof) => {
                    found.boxes += proof.boxes;
                    found.certificates.extend(proof.certificates);
                    for zero in proof.zeros {
                        let point = at(&zero);
                        self.fails_at(point.clone(), &mut found, &mut missing)?;
                        if found.margin.hi == 0.0 && found.attained.is_none() {
                            found.attained = Some(point);
                        }
                    }
                }
                Decision::Fails(point) => {
                    // The language itself has the last word.
                    if self.fails_at(at(&point), &mut found, &mut missing)? {
                        return Ok(found);
                    }
                    if let Some(error) = missing.first {
                        return Err(error);
                    }
                    let at = at(&point);
                    left.get_or_insert_with(|| Open::at_point(format!("the two sides may be equal at {at}")));
                }
                Decision::Undecided(open) => {
                    found.boxes += open.looked;
                    found.open += open.boxes.len() as u64;
                    left.get_or_insert(open);
                }
            }
        }
        if let Some(open) = left {
            found.open = found.open.max(1);
            found.attained = None;
            let boxes: Vec<Bindings> = open.boxes.iter().take(TOLD).map(|sides| boxed(whole, &places, sides)).collect();
            let why = told(&open, boxes.first());
            found.unsettled = Some(Unsettled { share: open.share, boxes });
            found.truth = Truth::Unknown(Doubt { why, bits: None });
            return Ok(found);
        }
        // True everywhere: no inequality that has to be true misses.
        let least = |margin: Margin| Margin { lo: margin.lo.max(0.0).min(margin.hi.max(0.0)), ..margin };
        found.margin = least(found.margin);
        if !matches!(self.expression.node.kind, Kind::Or(_) | Kind::Implies(..) | Kind::Not(_))
            && self.question.restriction.is_none()
        {
            found.inequalities.iter_mut().for_each(|own| *own = least(*own));
        }
        Ok(found)
    }

    /// Boxes until every one is decided, and whether a value was missing somewhere.
    fn by_boxes(&self, whole: &Bindings, most: u64) -> Result<(Decided, bool), QuestionError> {
        let original = whole.boxes();
        let mut found = Decided::nothing();
        let mut heap = BinaryHeap::new();
        let mut queue = vec![whole.clone()];
        let (mut number, mut probes, mut kept, mut most) = (0, 0u64, false, most);
        let mut missing = Missing::default();
        loop {
            for bindings in queue.drain(..) {
                self.progress.checkpoint()?;
                found.boxes += 1;
                number += 1;
                let seen = Self::unless_missing(self.on_box(&bindings), &mut missing)?;
                let fails = number == 1 && self.fails_at_a_corner(&bindings, &mut found, &mut missing)?;
                if fails {
                    return Ok((found, false));
                }
                // A single one without a value.
                let Some(OnBox { truth, margin, inequalities, points_only }) = seen else { continue };
                kept |= truth.is_some();
                if points_only {
                    most = most.min(POINTS_ONLY);
                }
                let doubt = match truth {
                    None => continue,
                    Some(Truth::True) => {
                        found.margin = found.margin.least(margin);
                        Margin::least_of_each(&mut found.inequalities, &inequalities);
                        continue;
                    }
                    Some(Truth::False) => {
                        if self.fails_at(bindings.middle(), &mut found, &mut missing)? {
                            return Ok((found, false));
                        }
                        Doubt { why: "a box fails, but its middle is left out by `where`".to_string(), bits: None }
                    }
                    Some(Truth::Unknown(doubt)) => doubt,
                };
                heap.push(Undecided { bindings, margin: margin.lo, number, doubt, bounds: margin, inequalities });
            }
            if missing.first.is_some() {
                most = most.min(found.boxes + AFTER_MISSING);
            }
            let Some(mut worst) = heap.pop() else {
                found.excluded = !kept;
                return missing.first.map_or(Ok((found, false)), Err);
            };
            probes += 1;
            let before = missing.count;
            if (probes <= PROBED || probes.is_multiple_of(PROBED_LATER))
                && self.fails_at(worst.bindings.middle(), &mut found, &mut missing)?
            {
                return Ok((found, false));
            }
            // Around a point without a value boxes stay open; the others come first.
            if missing.count > before && worst.margin < f64::INFINITY && !heap.is_empty() {
                worst.margin = f64::INFINITY;
                heap.push(worst);
                continue;
            }
            let halves = if found.boxes < most { halved(&worst.bindings, &original) } else { None };
            match halves {
                Some(halves) => queue.extend(halves),
                None => {
                    if self.fails_at(worst.bindings.simplest(), &mut found, &mut missing)? {
                        return Ok((found, false));
                    }
                    if let Some(missing) = missing.first {
                        return Err(missing);
                    }
                    let open = heap.iter().fold(worst.bounds, |least, open| least.least(open.bounds));
                    found.open = 1 + heap.len() as u64;
                    found.margin = found.margin.least(open);
                    let each = heap.iter().chain([&worst]);
                    each.for_each(|open| Margin::least_of_each(&mut found.inequalities, &open.inequalities));
                    let at = worst.bindings.to_string();
                    let why = format!("{} (on the box {at})", worst.doubt.why);
                    found.truth = Truth::Unknown(Doubt { why, bits: None });
                    return Ok((found, missing.first.is_some()));
                }
            }
        }
    }

    /// What was found, or nothing where a value is missing, which is kept; the first one is told.
    fn unless_missing<T>(found: Result<T, QuestionError>, missing: &mut Missing) -> Result<Option<T>, QuestionError> {
        match found {
            Err(error @ QuestionError::At { .. }) => {
                missing.first.get_or_insert(error);
                missing.count += 1;
                Ok(None)
            }
            found => found.map(Some),
        }
    }

    /// What is known on a box.
    pub fn on_box(&self, bindings: &Bindings) -> Result<OnBox, QuestionError> {
        // Of a range of integers a single one is left in the end.
        if bindings.boxes().is_empty() {
            let decided = self.question.decide_expression(self.expression, bindings, 1, self.progress)?;
            let truth = (!decided.excluded).then_some(decided.truth);
            let (margin, inequalities) = (decided.margin, decided.inequalities);
            return Ok(OnBox { truth, margin, inequalities, points_only: false });
        }
        let case = Case::new(self.question, bindings.clone(), self.progress);
        // What is missing at some points is looked for at points; here it is not known.
        let judged = |expression: &Expression| match self.question.judged(&case, expression, FIRST_BITS) {
            Err(Failure::Refused(_, problem)) => Ok((Truth::unknown(problem.to_string(), None), Margin::ANY)),
            judged => judged.map_err(|failure| self.question.refused(failure, expression.base)),
        };
        let kept =
            self.question.restriction.as_ref().map_or(Ok(Truth::True), |own| judged(own).map(|(truth, _)| truth))?;
        if kept == Truth::False {
            let margin = Margin::of_truth(true);
            return Ok(OnBox { truth: None, margin, inequalities: Vec::new(), points_only: false });
        }
        let (truth, margin) = judged(self.expression)?;
        let inequalities = self.question.each_margin(&case, self.expression, FIRST_BITS, margin)?;
        let truth = match (truth, kept) {
            (Truth::False, Truth::Unknown(doubt)) => Truth::Unknown(doubt),
            (truth, _) => truth,
        };
        Ok(OnBox { truth: Some(truth), margin, inequalities, points_only: case.points_only.get() })
    }

    /// Whether the property fails at a corner of the box, where extremes often are.
    fn fails_at_a_corner(
        &self,
        bindings: &Bindings,
        found: &mut Decided,
        missing: &mut Missing,
    ) -> Result<bool, QuestionError> {
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
            if self.fails_at(corner, found, missing)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether the property fails at a point, exactly or by enclosure; its margin bounds the smallest one from above. A value that is missing there is kept.
    fn fails_at(&self, point: Bindings, found: &mut Decided, missing: &mut Missing) -> Result<bool, QuestionError> {
        let kept = self.question.kept(&point, self.progress);
        match &kept {
            Err(QuestionError::At { .. }) | Ok(Truth::True) => {}
            _ => return kept.map(|_| false),
        }
        let decided = self.question.decide_point(self.expression, &point, self.progress);
        // Where the property is true it does not matter whether `where` keeps the point.
        let decided = match (kept, decided) {
            (Err(_), Ok(judged)) if judged.truth == Truth::True => return Ok(false),
            (Err(error), _) => Err(error),
            (Ok(_), decided) => decided,
        };
        let Some(Judged { truth, margin, inequalities }) = Self::unless_missing(decided, missing)? else {
            return Ok(false);
        };
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
