//! What is drawn: the least and greatest value of a row at each of some times, and a motion in it.

use crate::orders::Times;
use crate::prepared::Prepared;
use crate::system::{Condition, Switching, System};
use crate::witness::Witness;
use crate::worst::Solver;
use arithmetic::{Cancelled, Progress, Rational, rational};
use num_traits::ToPrimitive;

/// A matrix of floats by rows.
type Rows = Vec<Vec<f64>>;

/// Times, and the ends of a quantity at each.
pub type Tube = Vec<(f64, f64, f64)>;

/// The least and greatest value of the left side of a condition at so many times up to the end, rounded outwards; empty where the order of modes is
/// not fixed.
///
/// # Errors
/// [`Cancelled`].
pub fn tube(
    system: &System,
    condition: &Condition,
    until: &Rational,
    samples: usize,
    progress: &dyn Progress,
) -> Result<Tube, Cancelled> {
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
    let shift = condition.constant.to_f64().unwrap_or(0.0);
    let mut tube = Vec::new();
    for k in 0..=samples {
        progress.checkpoint()?;
        let time = until * rational(k as i64, samples.max(1) as i64);
        let (Some(high), Some(low)) = (solver.at(&row, &time), solver.at(&turned, &time)) else { continue };
        tube.push((time.to_f64().unwrap_or(0.0), shift - low, shift + high));
    }
    Ok(tube)
}

/// The left side of a condition along a witness, in floats.
pub fn along(system: &System, condition: &Condition, witness: &Witness, samples: usize) -> Vec<(f64, f64)> {
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
    let mut points = vec![(0.0, value(&x))];
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
            points.push(((k + 1) as f64 * h, value(&x)));
        }
    }
    points
}
