//! Boxes in rounds: in each round the worst few are looked at side by side, and divided along the side that has mattered most so far. What is found does not depend on
//! the number of threads.

use super::{Division, Missing, OnBox, halved};
use crate::bindings::{Bindings, Value};
use crate::error::QuestionError;
use crate::names::Subject;
use crate::outcome::Decided;
use crate::truth::{Doubt, Margin, Truth};
use arithmetic::threads::side_by_side;
use motion::sets::Range;
use std::collections::BinaryHeap;

/// Boxes that are divided in one round.
const ROUND: usize = 16;

/// Boxes whose middle is looked at for a counterexample; later only every so many.
const PROBED: u64 = 64;
const PROBED_LATER: u64 = 16;

/// Boxes that are still looked at for a counterexample when a value is missing.
const AFTER_MISSING: u64 = 1024;

/// Most boxes where something is asked for that no box has.
const POINTS_ONLY: u64 = 32;

/// A box to be looked at, with how much narrower the margin of a box became, as a share, when it was last divided along each side.
#[derive(Clone)]
struct Cell {
    bindings: Bindings,
    shares: Vec<f64>,
    depth: u32,
    /// The side that it is a half of, and the width of the margin of the whole.
    from: Option<(usize, f64)>,
}

/// A box that is not decided, the one with the smallest margin first.
struct Undecided {
    cell: Cell,
    margin: f64,
    number: u64,
    doubt: Doubt,
    bounds: Margin,
    inequalities: Vec<Margin>,
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

/// What has been found so far.
struct Search {
    found: Decided,
    heap: BinaryHeap<Undecided>,
    missing: Missing,
    number: u64,
    probes: u64,
    most: u64,
    kept: bool,
}

impl Cell {
    /// What the margin on this box says about the side that it is a half of.
    fn learn(&mut self, bounds: Margin) {
        /// Of a side that was not divided yet, and the least that is believed.
        const LEAST: f64 = 0.1;
        if let Some((side, whole)) = self.from
            && whole.is_finite()
            && whole > 0.0
        {
            let share = (bounds.hi - bounds.lo) / whole;
            self.shares[side] = if share.is_finite() { share.clamp(LEAST, 1.0) } else { 1.0 };
        }
    }

    fn halves(&self, original: &[(usize, Range)], bounds: Margin) -> Option<[Cell; 2]> {
        // Every third time the widest one, so that no side is forgotten.
        let shares = if self.depth % 3 == 2 { &[][..] } else { &self.shares };
        let (side, halves) = halved(&self.bindings, original, shares)?;
        let from = Some((side, bounds.hi - bounds.lo));
        Some(halves.map(|bindings| Cell { bindings, shares: self.shares.clone(), depth: self.depth + 1, from }))
    }
}

impl Division<'_> {
    /// Boxes until every one is decided.
    pub fn by_boxes(&self, whole: &Bindings, most: u64) -> Result<Decided, QuestionError> {
        let original = whole.boxes();
        let mut search = Search {
            found: Decided::nothing(),
            heap: BinaryHeap::new(),
            missing: Missing::default(),
            number: 0,
            probes: 0,
            most,
            kept: false,
        };
        /// How much is expected of a side that was not divided yet.
        const EXPECTED: f64 = 0.5;
        let mut queue =
            vec![Cell { bindings: whole.clone(), shares: vec![EXPECTED; original.len()], depth: 0, from: None }];
        loop {
            if self.looked(&mut search, queue)? {
                return Ok(search.found);
            }
            if search.missing.first.is_some() {
                search.most = search.most.min(search.found.boxes + AFTER_MISSING);
            }
            if search.heap.is_empty() {
                search.found.excluded = !search.kept;
                return search.missing.first.map_or(Ok(search.found), Err);
            }
            let mut worst: Vec<Undecided> = std::iter::from_fn(|| search.heap.pop()).take(ROUND).collect();
            if self.probed(&mut search, &mut worst)? {
                return Ok(search.found);
            }
            queue = Vec::new();
            for own in worst {
                let room = search.found.boxes + (queue.len() as u64) < search.most;
                match own.cell.halves(&original, own.bounds).filter(|_| room) {
                    Some(halves) => queue.extend(halves),
                    None => search.heap.push(own),
                }
            }
            if queue.is_empty() {
                return self.open(search);
            }
        }
    }

    /// Looks at boxes, all at once; whether the property fails in one of them.
    fn looked(&self, search: &mut Search, queue: Vec<Cell>) -> Result<bool, QuestionError> {
        let look = |cell: &Cell| {
            self.progress.checkpoint()?;
            self.on_box(&cell.bindings)
        };
        let seen = side_by_side(&queue, look);
        for (mut cell, seen) in queue.into_iter().zip(seen) {
            search.found.boxes += 1;
            search.number += 1;
            let seen = Self::unless_missing(seen, &mut search.missing)?;
            if search.number == 1 && self.fails_at_a_corner(&cell.bindings, &mut search.found, &mut search.missing)? {
                return Ok(true);
            }
            // A single one without a value.
            let Some(OnBox { truth, margin, inequalities, points_only }) = seen else { continue };
            search.kept |= truth.is_some();
            if points_only {
                search.most = search.most.min(POINTS_ONLY);
            }
            let doubt = match truth {
                None => continue,
                Some(Truth::True) => {
                    search.found.margin = search.found.margin.least(margin);
                    Margin::least_of_each(&mut search.found.inequalities, &inequalities);
                    continue;
                }
                Some(Truth::False) => {
                    if self.fails_at(cell.bindings.middle(), &mut search.found, &mut search.missing)? {
                        return Ok(true);
                    }
                    Doubt { why: "a box fails, but its middle is left out by `where`".to_string(), bits: None }
                }
                Some(Truth::Unknown(doubt)) => doubt,
            };
            if search.number == 1
                && self.question.subjects().contains(&Subject::Motion)
                && self.fails_downhill(&cell.bindings, &mut search.found, &mut search.missing)?
            {
                return Ok(true);
            }
            cell.learn(margin);
            let number = search.number;
            search.heap.push(Undecided { cell, margin: margin.lo, number, doubt, bounds: margin, inequalities });
        }
        Ok(false)
    }

    /// Looks at the middles of boxes, all at once; whether the property fails at one of them. Boxes around a point without a value wait until the others are
    /// decided.
    fn probed(&self, search: &mut Search, worst: &mut Vec<Undecided>) -> Result<bool, QuestionError> {
        let chosen: Vec<bool> = worst
            .iter()
            .map(|_| {
                search.probes += 1;
                search.probes <= PROBED || search.probes.is_multiple_of(PROBED_LATER)
            })
            .collect();
        let middles: Vec<Option<Bindings>> =
            worst.iter().zip(&chosen).map(|(own, chosen)| chosen.then(|| own.cell.bindings.middle())).collect();
        let judged = side_by_side(&middles, |middle| middle.as_ref().map(|point| self.judged_at(point)));
        let mut waiting = Vec::new();
        for (place, (middle, judged)) in middles.into_iter().zip(judged).enumerate() {
            let Some((middle, judged)) = middle.zip(judged) else { continue };
            let before = search.missing.count;
            if Self::fails(middle, judged, &mut search.found, &mut search.missing)? {
                return Ok(true);
            }
            if search.missing.count > before && worst[place].margin < f64::INFINITY {
                waiting.push(place);
            }
        }
        // The last of all is divided nevertheless.
        if waiting.len() == worst.len() && search.heap.is_empty() {
            waiting.remove(0);
        }
        for place in waiting.into_iter().rev() {
            let mut own = worst.remove(place);
            own.margin = f64::INFINITY;
            search.heap.push(own);
        }
        Ok(false)
    }

    /// What is told where boxes are left that are not decided.
    fn open(&self, mut search: Search) -> Result<Decided, QuestionError> {
        let Some(worst) = search.heap.pop() else { return Ok(search.found) };
        let mut found = search.found;
        if self.fails_at(worst.cell.bindings.simplest(), &mut found, &mut search.missing)? {
            return Ok(found);
        }
        if let Some(missing) = search.missing.first {
            return Err(missing);
        }
        let open = search.heap.iter().fold(worst.bounds, |least, open| least.least(open.bounds));
        found.open = 1 + search.heap.len() as u64;
        found.margin = found.margin.least(open);
        let each = search.heap.iter().chain([&worst]);
        each.for_each(|open| Margin::least_of_each(&mut found.inequalities, &open.inequalities));
        let why = format!("{} (on the box {})", worst.doubt.why, worst.cell.bindings);
        found.truth = Truth::Unknown(Doubt { why, bits: None });
        Ok(found)
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
            for (side, (place, Range { lo, hi })) in boxes.iter().enumerate() {
                corner.set(*place, Value::Number(if choice >> side & 1 == 1 { hi.clone() } else { lo.clone() }));
            }
            if self.fails_at(corner, found, missing)? {
                return Ok(true);
            }
        }
        Ok(false)
    }
}
