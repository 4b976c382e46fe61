//! The moving quantities of a property over time: enclosed for all starts of the first member at once, and at single starts in it. For pictures.

use crate::bindings::{Bindings, Value};
use crate::case::Case;
use crate::error::QuestionError;
use crate::evaluate::{Evaluator, horizon};
use crate::failure::Failure;
use crate::point::FIRST_BITS;
use crate::question::{Expression, Question};
use crate::syntax::{Kind, Node};
use crate::timeline::{Piece, Timeline};
use arithmetic::{Progress, Rational, rational};
use motion::sets::{Range, Tube};
use num_traits::ToPrimitive;

/// All moving quantities of a property.
#[derive(Debug, Clone)]
pub struct Tubes {
    /// One for each quantity; their single motions are those of `runs`.
    pub tubes: Vec<Tube>,
    /// The single starts.
    pub runs: Vec<Bindings>,
    /// The one of them that is nearest to failing, or fails most.
    pub worst: Option<usize>,
}

/// Short times that are drawn.
const SECTIONS: i64 = 240;

/// Corners are drawn of boxes with no more sides.
const MOST_SIDES: usize = 3;

/// A quantity by its name, over time.
type Curve = (String, Vec<[f64; 4]>);

impl Question {
    /// The quantities of the property over all the time that it asks for, with runs from the middle of the boxes, from their corners where these are few, and
    /// from `found`, a counterexample.
    ///
    /// # Errors
    /// [`QuestionError`] where there is no property, or a quantity has no value.
    pub fn tubes(&self, found: Option<&Bindings>, progress: &dyn Progress) -> Result<Tubes, QuestionError> {
        let expression = self.asked()?;
        let none = Tubes { tubes: Vec::new(), runs: Vec::new(), worst: None };
        let Some(member) = self.case(0, progress)? else { return Ok(none) };
        let refused = |failure| self.refused(failure, expression.base);
        let all = self.curves(expression, &member, progress).map_err(refused)?;
        let mut runs: Vec<Bindings> = Vec::new();
        let mut points = vec![member.middle()];
        points.extend(corners(&member));
        points.extend(found.map(|found| put_in(&member, found)));
        for point in points.into_iter().filter(|_| !member.boxes().is_empty()) {
            if point.boxes().is_empty() && runs.iter().all(|known| known.to_string() != point.to_string()) {
                runs.push(point);
            }
        }
        let mut tubes: Vec<Tube> =
            all.into_iter().map(|(quantity, sections)| Tube { quantity, sections, runs: Vec::new() }).collect();
        let mut margins = Vec::with_capacity(runs.len());
        for point in &runs {
            let curves = self.curves(expression, point, progress).map_err(refused)?;
            tubes.iter_mut().zip(curves).for_each(|(tube, (_, sections))| tube.runs.push(sections));
            let case = Case::new(self, point.clone(), progress);
            margins.push(self.judged(&case, expression, FIRST_BITS).map_err(refused)?.1.lo);
        }
        let worst = (0..runs.len()).min_by(|i, j| margins[*i].total_cmp(&margins[*j]).then(i.cmp(j)));
        Ok(Tubes { tubes, runs, worst })
    }

    /// Each moving quantity of an expression in one case.
    fn curves(
        &self,
        expression: &Expression,
        bindings: &Bindings,
        progress: &dyn Progress,
    ) -> Result<Vec<Curve>, Failure> {
        let case = Case::new(self, bindings.clone(), progress);
        let evaluator = Evaluator { case: &case, precision: FIRST_BITS, moment: None, piece: None };
        let mut curves: Vec<(String, &Node, Vec<[f64; 4]>)> = Vec::new();
        expression.node.visit(&mut |node| {
            if let Kind::Name { name, .. } = &node.kind
                && bindings.get(name).is_none()
                && case.quantity(None, name).is_ok_and(|quantity| quantity.moves)
                && curves.iter().all(|(known, ..)| *known != node.to_string())
            {
                curves.push((node.to_string(), node, Vec::new()));
            }
        });
        if curves.is_empty() {
            return Ok(Vec::new());
        }
        let (timeline, until) = (case.timeline()?, horizon(&evaluator, &expression.node)?);
        timeline.prepare(&until)?;
        for piece in short_pieces(timeline, &until)? {
            progress.checkpoint()?;
            let moment = timeline.moment(&piece)?;
            let inner = Evaluator { moment: Some(moment.as_ref()), piece: Some(&piece), ..evaluator };
            let float = |q: &Rational| q.to_f64().unwrap_or(f64::NAN);
            let (from, to) = (float(&piece.from), piece.to.as_ref().map_or(f64::NAN, float));
            for (_, node, sections) in &mut curves {
                let (lo, hi) = match inner.number(node) {
                    Ok(number) => {
                        let enclosure = number.enclosure(FIRST_BITS);
                        (enclosure.lo().to_f64(), enclosure.hi().to_f64())
                    }
                    Err(Failure::Open(_)) => (f64::NAN, f64::NAN),
                    Err(failure) => return Err(failure),
                };
                sections.push([from, to, lo, hi]);
            }
        }
        Ok(curves.into_iter().map(|(name, _, sections)| (name, sections)).collect())
    }
}

/// All times up to one in short pieces, as far as the motion is known.
fn short_pieces(timeline: &dyn Timeline, until: &Rational) -> Result<Vec<Piece>, Failure> {
    let longest = until * rational(1, SECTIONS);
    let is_long = |piece: &Piece| piece.to.as_ref().is_some_and(|to| to - &piece.from > longest);
    let covered = timeline.pieces(&rational(0, 1), Some(until), &[])?;
    let mut queue: Vec<Piece> = covered.pieces.into_iter().rev().collect();
    let mut short = Vec::new();
    while let Some(piece) = queue.pop() {
        match timeline.halves(&piece).filter(|_| is_long(&piece)) {
            Some([first, second]) => queue.extend([second, first]),
            None => short.push(piece),
        }
    }
    Ok(short)
}

/// The corners of the boxes, where they are few.
fn corners(member: &Bindings) -> Vec<Bindings> {
    let boxes = member.boxes();
    let count = if boxes.len() > MOST_SIDES { 0 } else { 1usize << boxes.len() };
    let corner = |choice: usize| {
        let mut corner = member.clone();
        for (side, (place, Range { lo, hi })) in boxes.iter().enumerate() {
            corner.set(*place, Value::Number(if choice >> side & 1 == 1 { hi.clone() } else { lo.clone() }));
        }
        corner
    };
    (0..count).map(corner).collect()
}

/// The member with the numbers of a point in it.
fn put_in(member: &Bindings, point: &Bindings) -> Bindings {
    let mut bindings = member.clone();
    let names: Vec<String> = member.iter().map(|(name, _)| name.to_string()).collect();
    for (place, ..) in member.boxes() {
        if let Some(value @ Value::Number(_)) = point.get(&names[place]) {
            bindings.set(place, value.clone());
        }
    }
    bindings
}
