//! A bad order of modes for arbitrary switching, in floats: at each time the mode that drives the row most, given the motion and the costate, until
//! nothing changes. It only proposes; its value is enclosed afterwards.

use crate::prepared::{Motion, Prepared};
use arithmetic::{Cancelled, Progress, Rational, rational};
use num_traits::ToPrimitive;

/// Most steps of time.
const STEPS: usize = 3000;
/// Rounds from one first guess.
const ROUNDS: usize = 40;

/// A mode in floats.
struct Floats {
    a: Vec<Vec<f64>>,
    drift: Vec<f64>,
    /// Centre, radius, column.
    pushes: Vec<(f64, f64, Vec<f64>)>,
    /// `e^(A h)`.
    step: Vec<Vec<f64>>,
}

fn floats(row: &[Rational]) -> Vec<f64> {
    row.iter().map(|x| x.to_f64().unwrap_or(f64::NAN)).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

impl Floats {
    fn new(motion: &Motion, h: f64) -> Self {
        let a: Vec<Vec<f64>> = motion.a.iter().map(|row| floats(row)).collect();
        let n = a.len();
        let identity = |i: usize, j: usize| f64::from(u8::from(i == j));
        let mut step: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| identity(i, j)).collect()).collect();
        let mut term = step.clone();
        for k in 1..=12 {
            term = (0..n)
                .map(|i| (0..n).map(|j| (0..n).map(|l| term[i][l] * a[l][j]).sum::<f64>() * h / f64::from(k)).collect())
                .collect();
            step.iter_mut().flatten().zip(term.iter().flatten()).for_each(|(x, y)| *x += y);
        }
        let push = |push: &crate::prepared::Push| {
            (push.centre.to_f64().unwrap_or(f64::NAN), push.radius.to_f64().unwrap_or(f64::NAN), floats(&push.column))
        };
        Floats { a, drift: floats(&motion.drift), pushes: motion.pushes.iter().map(push).collect(), step }
    }

    /// The costate a step earlier.
    fn back(&self, p: &[f64]) -> Vec<f64> {
        (0..p.len()).map(|j| (0..p.len()).map(|i| p[i] * self.step[i][j]).sum()).collect()
    }

    /// What the mode adds to the value in a unit of time, with its worst input.
    fn drive(&self, p: &[f64], x: &[f64]) -> f64 {
        let moved: f64 = self.a.iter().zip(p).map(|(row, p)| p * dot(row, x)).sum();
        let pushed = self.pushes.iter().map(|(centre, radius, column)| {
            let h = dot(column, p);
            centre * h + radius * h.abs()
        });
        moved + dot(&self.drift, p) + pushed.sum::<f64>()
    }

    /// The state a step later, with the worst input.
    fn forth(&self, x: &[f64], p: &[f64], h: f64) -> Vec<f64> {
        let mut force = self.drift.clone();
        for (centre, radius, column) in &self.pushes {
            let value = centre + radius * dot(column, p).signum();
            force.iter_mut().zip(column).for_each(|(sum, b)| *sum += value * b);
        }
        self.step.iter().zip(&force).map(|(row, f)| dot(row, x) + h * f).collect()
    }
}

/// Legs backwards from `until` whose value of the row is large.
///
/// # Errors
/// [`Cancelled`].
pub(crate) fn bad_order(
    prepared: &Prepared,
    row: &[Rational],
    until: &Rational,
    progress: &dyn Progress,
) -> Result<Vec<(usize, Rational)>, Cancelled> {
    let norm = prepared
        .motions
        .iter()
        .flat_map(|motion| &motion.a)
        .map(|row| crate::ellipsoid::size(row))
        .max()
        .unwrap_or_default();
    let wanted = (norm * until * rational(4, 1)).ceil().to_integer().to_usize().unwrap_or(STEPS).clamp(20, STEPS);
    let step = until / rational(wanted as i64, 1);
    let h = step.to_f64().unwrap_or(f64::NAN);
    let modes: Vec<Floats> = prepared.motions.iter().map(|motion| Floats::new(motion, h)).collect();
    let c = floats(row);
    let mut best: Option<(f64, Vec<usize>)> = None;
    for first in first_guesses(modes.len(), wanted) {
        let mut word = first;
        for _ in 0..ROUNDS {
            progress.checkpoint()?;
            let mut costates = vec![c.clone()];
            for &mode in &word {
                let next = modes[mode].back(&costates[costates.len() - 1]);
                costates.push(next);
            }
            let last = &costates[wanted];
            let mut x: Vec<f64> = prepared.start.iter().zip(last).map(|(range, p)| corner(range, *p)).collect();
            let mut better = word.clone();
            for k in (0..wanted).rev() {
                let drive = |mode: usize| modes[mode].drive(&costates[k], &x);
                better[k] = (0..modes.len()).reduce(|a, b| if drive(b) > drive(a) { b } else { a }).unwrap_or(0);
                x = modes[word[k]].forth(&x, &costates[k], h);
            }
            let value = dot(&c, &x);
            if best.as_ref().is_none_or(|(most, _)| value > *most) {
                best = Some((value, word.clone()));
            }
            if better == word {
                break;
            }
            word = better;
        }
    }
    let mut legs: Vec<(usize, Rational)> = Vec::new();
    for mode in best.map_or_else(Vec::new, |(_, word)| word) {
        match legs.last_mut() {
            Some((last, duration)) if *last == mode => *duration += &step,
            _ => legs.push((mode, step.clone())),
        }
    }
    Ok(legs)
}

fn corner(range: &crate::system::Range, p: f64) -> f64 {
    let end = if p >= 0.0 { &range.hi } else { &range.lo };
    end.to_f64().unwrap_or(f64::NAN)
}

/// One mode throughout, and two modes with one or two switches at some places.
fn first_guesses(modes: usize, steps: usize) -> Vec<Vec<usize>> {
    let mut guesses: Vec<Vec<usize>> = (0..modes.min(8)).map(|mode| vec![mode; steps]).collect();
    for a in 0..modes.min(4) {
        for b in (0..modes.min(4)).filter(|b| *b != a) {
            for eighths in [1, 2, 3, 4] {
                let cut = steps * eighths / 10;
                guesses.push((0..steps).map(|k| if k < cut { a } else { b }).collect());
                guesses.push((0..steps).map(|k| if (cut..2 * cut).contains(&k) { b } else { a }).collect());
            }
        }
    }
    guesses
}
