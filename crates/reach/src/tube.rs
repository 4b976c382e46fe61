//! What is drawn: a quantity over time, enclosed over all motions, and a motion in it.

use crate::answer::left_side;
use crate::decide::Part;
use crate::orders::Times;
use crate::prepared::Prepared;
use crate::system::{Condition, Range, Switching, System};
use crate::witness::Witness;
use crate::worst::Solver;
use arithmetic::{Cancelled, FloatInterval, Progress, Rational, rational};
use motion::sets::Tube;
use num_traits::ToPrimitive;

/// A matrix of floats by rows.
type Rows = Vec<Vec<f64>>;

/// The left side of a condition in so many sections of the time that it is drawn for: enclosed over all motions where the order of modes is fixed, and along
/// the motion that was found.
///
/// # Errors
/// [`Cancelled`].
pub fn tube(system: &System, part: &Part, samples: usize, progress: &dyn Progress) -> Result<Tube, Cancelled> {
    let (condition, witness) = (&part.condition, part.witness.as_ref());
    Ok(Tube {
        quantity: left_side(system, condition),
        sections: sections(system, condition, (&part.drawn_until(system), samples), progress)?,
        runs: witness.map(|witness| along(system, condition, witness, samples)).into_iter().collect(),
    })
}

fn sections(
    system: &System,
    condition: &Condition,
    (until, samples): (&Rational, usize),
    progress: &dyn Progress,
) -> Result<Vec<[f64; 4]>, Cancelled> {
    let fixed = match &system.switching {
        Switching::Periodic { .. } => true,
        Switching::Windows { windows, .. } => windows.iter().all(|window| window.is_point()),
        _ => false,
    };
    if !fixed || !system.is_written_out() {
        return Ok(Vec::new());
    }
    let prepared = Prepared::new(system);
    let Some(solver) = Solver::new(&prepared, &system.switching, &Times::Until(until.clone()), 6, progress) else {
        return Ok(Vec::new());
    };
    let mut row = condition.row.clone();
    row.resize(prepared.order(), Rational::ZERO);
    let turned: Vec<Rational> = row.iter().map(|x| -x).collect();
    let constant = FloatInterval::from_rational(&condition.constant);
    let shifted = |x: f64| FloatInterval::point(x) + constant;
    let at = |k: usize| until * rational(k as i64, samples.max(1) as i64);
    let float = |x: &Rational| x.to_f64().unwrap_or(f64::NAN);
    let mut sections = Vec::new();
    for k in 0..samples {
        progress.checkpoint()?;
        let time = Range { lo: at(k), hi: at(k + 1) };
        if let (Some(high), Some(low)) = (solver.over(&row, &time), solver.over(&turned, &time)) {
            sections.push([float(&time.lo), float(&time.hi), shifted(-low).lo(), shifted(high).hi()]);
        }
    }
    Ok(sections)
}

/// The left side of a condition along a witness, in floats.
fn along(system: &System, condition: &Condition, witness: &Witness, samples: usize) -> Vec<[f64; 4]> {
    if !system.is_written_out() {
        return Vec::new();
    }
    let float = |x: &Rational| x.to_f64().unwrap_or(f64::NAN);
    let floats = |row: &[Rational]| row.iter().map(float).collect::<Vec<f64>>();
    let latest = |list: &[(Rational, Rational)], t: f64| {
        list.iter().rev().find(|(from, _)| float(from) <= t).map_or(0.0, |(_, x)| float(x))
    };
    let modes: Vec<(Rows, Rows, Vec<f64>)> = system
        .modes
        .iter()
        .map(|mode| {
            (
                mode.a.iter().map(|row| floats(row)).collect(),
                mode.b.iter().map(|row| floats(row)).collect(),
                floats(&mode.c),
            )
        })
        .collect();
    let rate = |t: f64, x: &[f64]| -> Vec<f64> {
        let mode = witness.modes.iter().rev().find(|(from, _)| float(from) <= t).map_or(0, |(_, mode)| *mode);
        let u: Vec<f64> = witness.inputs.iter().map(|input| latest(input, t)).collect();
        let (a, b, c) = &modes[mode];
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        (0..x.len()).map(|i| dot(&a[i], x) + dot(&b[i], &u) + c[i]).collect()
    };
    let (end, row) = (float(&witness.at), floats(&condition.row));
    let mut x = floats(&witness.start);
    let value = |x: &[f64]| x.iter().zip(&row).map(|(x, c)| x * c).sum::<f64>() + float(&condition.constant);
    let point = |t: f64, x: f64| [t, t, x, x];
    let mut points = vec![point(0.0, value(&x))];
    const FINE: usize = 10;
    let h = end / (samples * FINE).max(1) as f64;
    for k in 0..samples * FINE {
        // The middle of a step says which mode and input are on.
        let t = (k as f64 + 0.5) * h;
        let shifted = |k: &[f64], f: f64| x.iter().zip(k).map(|(x, k)| x + f * k).collect::<Vec<f64>>();
        let k1 = rate(t, &x);
        let k2 = rate(t, &shifted(&k1, h / 2.0));
        let k3 = rate(t, &shifted(&k2, h / 2.0));
        let k4 = rate(t, &shifted(&k3, h));
        x = (0..x.len()).map(|i| x[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i])).collect();
        if (k + 1).is_multiple_of(FINE) {
            points.push(point((k + 1) as f64 * h, value(&x)));
        }
    }
    points
}
