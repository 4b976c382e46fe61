//! A start that fails, looked for by going down the margin from the middle of a box: what a motion does worst it often does from a corner, where boxes come last.

use super::{Division, Missing};
use crate::bindings::{Bindings, Value};
use crate::error::QuestionError;
use crate::outcome::{Decided, Judged};
use arithmetic::rational;
use arithmetic::threads::side_by_side;
use motion::sets::Range;

/// Sides of a box of which more would cost more than halving it.
const MOST_SIDES: usize = 12;

/// Steps from the middle of a side to its end.
const END: i64 = 4;

/// Rounds, each with one start for each side and one for all together.
const ROUNDS: usize = 5;

/// A place in the box, in steps from its middle, with its margin.
struct Start {
    place: Vec<i64>,
    margin: f64,
}

impl Division<'_> {
    /// Whether the property fails at a start that is found downhill. In every round each number of the start is moved by itself; then all are moved at once, each
    /// to where the margin fell, or away from where it rose. Where the margin would not come near to 0 at that pace, boxes are better.
    pub(super) fn fails_downhill(
        &self,
        whole: &Bindings,
        found: &mut Decided,
        missing: &mut Missing,
    ) -> Result<bool, QuestionError> {
        let boxes = whole.boxes();
        let are_intervals = whole.iter().all(|(_, value)| !matches!(value, Value::Integers(..)));
        if boxes.len() > MOST_SIDES || !are_intervals {
            return Ok(false);
        }
        let mut step = END;
        let middle = vec![0; boxes.len()];
        let Some(mut here) = self.lowest(whole, &boxes, vec![middle], found, missing)? else {
            return Ok(found.counterexample.is_some());
        };
        for left in (0..ROUNDS).rev() {
            if found.counterexample.is_some() {
                return Ok(true);
            }
            let before = here.margin;
            let moved = |k: usize, by: i64| {
                let mut place = here.place.clone();
                place[k] += by;
                (place[k].abs() <= END).then_some(place)
            };
            let singles: Vec<Vec<i64>> =
                (0..boxes.len()).filter_map(|k| moved(k, step).or_else(|| moved(k, -step))).collect();
            let margins = self.margins(whole, &boxes, &singles, found, missing)?;
            if found.counterexample.is_some() {
                return Ok(true);
            }
            // As much again for what is bent.
            let fall: f64 = margins.iter().map(|margin| (before - margin).abs()).filter(|fall| fall.is_finite()).sum();
            if before > 2.0 * fall * (END / step) as f64 {
                break;
            }
            let mut together = here.place.clone();
            for (single, margin) in singles.iter().zip(&margins) {
                let Some(k) = (0..boxes.len()).find(|&k| single[k] != here.place[k]) else { continue };
                let by = single[k] - here.place[k];
                let by = if *margin < before { by } else { -by };
                together[k] = (together[k] + by).clamp(-END, END);
            }
            let best = singles.into_iter().zip(margins).map(|(place, margin)| Start { place, margin });
            let all = self.lowest(whole, &boxes, vec![together], found, missing)?;
            if let Some(best) = best.chain(all).min_by(|a, b| a.margin.total_cmp(&b.margin))
                && best.margin < before
            {
                here = best;
            } else if step > 1 {
                step /= 2;
                continue;
            } else {
                break;
            }
            if here.margin > (before - here.margin) * (left as f64) {
                break;
            }
        }
        Ok(found.counterexample.is_some())
    }

    /// The place with the smallest margin.
    fn lowest(
        &self,
        whole: &Bindings,
        boxes: &[(usize, Range)],
        places: Vec<Vec<i64>>,
        found: &mut Decided,
        missing: &mut Missing,
    ) -> Result<Option<Start>, QuestionError> {
        let margins = self.margins(whole, boxes, &places, found, missing)?;
        let all = places.into_iter().zip(margins).map(|(place, margin)| Start { place, margin });
        Ok(all.min_by(|a, b| a.margin.total_cmp(&b.margin)).filter(|start| start.margin.is_finite()))
    }

    /// The margins at places, side by side: from below, where time is not cut into pieces that matter.
    fn margins(
        &self,
        whole: &Bindings,
        boxes: &[(usize, Range)],
        places: &[Vec<i64>],
        found: &mut Decided,
        missing: &mut Missing,
    ) -> Result<Vec<f64>, QuestionError> {
        let points: Vec<Bindings> = places.iter().map(|place| point(whole, boxes, place)).collect();
        let judged = side_by_side(&points, |point| self.judged_at(point));
        let mut margins = Vec::with_capacity(places.len());
        for (point, judged) in points.into_iter().zip(judged) {
            margins.push(match &judged {
                Ok(Some(Judged { margin, .. })) if margin.lo.is_finite() => margin.lo,
                _ => f64::INFINITY,
            });
            if Self::fails(point, judged, found, missing)? {
                break;
            }
        }
        margins.resize(places.len(), f64::INFINITY);
        Ok(margins)
    }
}

/// The start at a place.
fn point(whole: &Bindings, boxes: &[(usize, Range)], place: &[i64]) -> Bindings {
    let mut point = whole.clone();
    for ((side, range), steps) in boxes.iter().zip(place) {
        let radius = (&range.hi - &range.lo) * rational(*steps, 2 * END);
        point.set(*side, Value::Number(range.centre() + radius));
    }
    point
}
