//! Bounds for any switching: every mode is the mean of the modes plus disturbances, whose bounds are assumed and then proved.
//!
//! Let `A = mean of A_m`, and let `d_i(t)` be what mode `m(t)` adds to row `i`: `d_i = ((A_m - A) x + (drift_m - drift) + (B_m - B) u)_i`. If with `|d_i| <= w_i` the
//! system `x' = A x + drift + B u + d` keeps every `|d_i|` strictly below `w_i`, then so does the switched system: up to the first time at which
//! one reaches its bound it is a motion of the other. So worst cases of one mode with more inputs bound those of any switching.

use crate::ellipsoid::kept_box;
use crate::orders::Times;
use crate::prepared::{Motion, Prepared, Push};
use crate::system::{Range, Switching};
use crate::worst::{Solver, Worst};
use arithmetic::{Cancelled, Progress, Rational, rational};
use num_traits::{Signed, ToPrimitive, Zero};

/// Digits of the bounds: the disturbances leave more of a gap than they do.
const DIGITS: u32 = 5;

/// The number of an input that is none of the system's.
const DISTURBANCE: usize = usize::MAX;

/// No motion is followed further back; less far where each mode that it leads through has a duration of its own.
const LONGEST: i64 = 5000;
const LONGEST_OF_SEVERAL: i64 = 16;

/// The one mode with disturbances, whose motions include those of any switching.
#[derive(Debug, Clone)]
pub(crate) struct Comparison {
    prepared: Prepared,
    times: Times,
}

/// Row `i` of a mode less that of the mean, and the rest of what the mode adds, which is bounded at once.
struct Deviation {
    row: Vec<Rational>,
    rest: Rational,
    /// Which disturbance it belongs to.
    disturbance: usize,
}

fn one_mode() -> Switching {
    Switching::Windows { order: vec![0], windows: Vec::new() }
}

/// The times for one mode: up to the last that is looked at, or for ever.
pub(crate) fn times_of(prepared: &Prepared, until: Option<&Rational>) -> Option<Times> {
    match until {
        Some(until) => Some(Times::Until(until.clone())),
        None => {
            let rest = kept_box(&prepared.motions, &prepared.start)?;
            Some(Times::Forever { back: rational(8, 1), rest })
        }
    }
}

/// The greatest values of rows for one mode, for ever if need be: what lies far back is followed until it no longer matters.
pub(crate) fn greatest(
    prepared: &Prepared,
    switching: &Switching,
    times: &Times,
    rows: &[Vec<Rational>],
    digits: u32,
    progress: &dyn Progress,
) -> Result<Option<Vec<Worst>>, Cancelled> {
    let longest = match switching {
        Switching::Dwell { .. } => LONGEST_OF_SEVERAL,
        Switching::Windows { windows, .. } if windows.iter().any(|window| !window.is_point()) => LONGEST_OF_SEVERAL,
        _ => LONGEST,
    };
    let mut times = times.clone();
    loop {
        let Some(solver) = Solver::new(prepared, switching, &times, digits, progress) else { return Ok(None) };
        let found = solver.all(rows)?;
        match &mut times {
            Times::Forever { back, .. }
                if *back < rational(longest, 1) && found.iter().any(|worst| !worst.is_closed(digits)) =>
            {
                *back *= rational(2, 1);
            }
            _ => return Ok(Some(found)),
        }
    }
}

impl Comparison {
    /// Finds bounds of the disturbances and proves them; none where they do not close.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn find(
        prepared: &Prepared,
        until: Option<&Rational>,
        progress: &dyn Progress,
    ) -> Result<Option<Self>, Cancelled> {
        let (mean, deviations, disturbed) = mean(&prepared.motions);
        let alone = Prepared { motions: vec![mean.clone()], start: prepared.start.clone() };
        let Some(times) = times_of(&alone, until) else { return Ok(None) };
        let rows: Vec<Vec<Rational>> = deviations.iter().map(|deviation| deviation.row.clone()).collect();
        let switching = one_mode();
        let bounds = |prepared: &Prepared, times: &Times| -> Result<Option<Vec<Rational>>, Cancelled> {
            let found = greatest(prepared, &switching, times, &rows, DIGITS, progress)?;
            Ok(found.and_then(|found| disturbances(&deviations, &found, disturbed.len())))
        };
        let Some(free) = bounds(&alone, &times)? else { return Ok(None) };
        let mut gains = Vec::new();
        for &state in &disturbed {
            let one = disturbed_by(
                &Motion { drift: vec![Rational::ZERO; mean.a.len()], pushes: Vec::new(), a: mean.a.clone() },
                &[state],
                &[Rational::ONE],
            );
            let still = Prepared { motions: vec![one], start: vec![Range::point(Rational::ZERO); mean.a.len()] };
            let Some(times) = times_of(&still, until) else { return Ok(None) };
            let unit: Vec<Deviation> =
                deviations.iter().map(|d| Deviation { rest: Rational::ZERO, row: d.row.clone(), ..*d }).collect();
            let Some(found) = greatest(&still, &switching, &times, &rows, DIGITS, progress)? else { return Ok(None) };
            let Some(gain) = disturbances(&unit, &found, disturbed.len()) else { return Ok(None) };
            gains.push(gain);
        }
        let Some(limits) = fixed_point(&free, &gains) else { return Ok(None) };
        let moved = Prepared { motions: vec![disturbed_by(&mean, &disturbed, &limits)], start: prepared.start.clone() };
        let Some(times) = times_of(&moved, until) else { return Ok(None) };
        let Some(proved) = bounds(&moved, &times)? else { return Ok(None) };
        let closes = proved.iter().zip(&limits).all(|(found, assumed)| found < assumed);
        Ok(closes.then_some(Comparison { prepared: moved, times }))
    }

    /// The mean of the modes, with its disturbances.
    pub fn mean(&self) -> &Motion {
        &self.prepared.motions[0]
    }

    /// The limits of the disturbances of the first states, 0 where there is none.
    pub fn limits(&self, states: usize) -> Vec<Rational> {
        let mut limits = vec![Rational::ZERO; states];
        for push in self.prepared.motions[0].pushes.iter().filter(|push| push.input == DISTURBANCE) {
            for (limit, entry) in limits.iter_mut().zip(&push.column) {
                *limit += &push.radius * entry;
            }
        }
        limits
    }

    /// Bounds of the greatest values of rows at all times that are looked at.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn bounds(&self, rows: &[Vec<Rational>], progress: &dyn Progress) -> Result<Option<Vec<Rational>>, Cancelled> {
        let found = greatest(&self.prepared, &one_mode(), &self.times, rows, DIGITS, progress)?;
        Ok(found.and_then(|found| found.into_iter().map(|worst| worst.hi).collect()))
    }

    /// A box that no motion leaves, however it is switched.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn kept_box(&self, progress: &dyn Progress) -> Result<Option<Vec<Range>>, Cancelled> {
        let Some(bounds) = self.bounds(&self.prepared.sides(), progress)? else { return Ok(None) };
        Ok(Some(bounds.chunks(2).map(|pair| Range { lo: -pair[1].clone(), hi: pair[0].clone() }).collect()))
    }
}

/// The mean mode, what each mode adds to which row, in both signs, and the states that are disturbed.
fn mean(motions: &[Motion]) -> (Motion, Vec<Deviation>, Vec<usize>) {
    let n = motions[0].a.len();
    let share = rational(1, motions.len() as i64);
    let average = |entry: &dyn Fn(&Motion) -> Rational| motions.iter().map(entry).sum::<Rational>() * &share;
    let mut inputs: Vec<&Push> = Vec::new();
    for push in motions.iter().flat_map(|motion| &motion.pushes) {
        if inputs.iter().all(|known| known.input != push.input) {
            inputs.push(push);
        }
    }
    let effect = |motion: &Motion, input: usize, i: usize| {
        motion.pushes.iter().find(|push| push.input == input).map_or(Rational::ZERO, |push| push.column[i].clone())
    };
    let pushes = inputs.iter().map(|push| {
        let column = (0..n).map(|i| average(&|motion| effect(motion, push.input, i))).collect();
        Push { column, ..(*push).clone() }
    });
    let mean = Motion {
        a: (0..n).map(|i| (0..n).map(|j| average(&|motion| motion.a[i][j].clone())).collect()).collect(),
        drift: (0..n).map(|i| average(&|motion| motion.drift[i].clone())).collect(),
        pushes: pushes.collect(),
    };
    let (mut deviations, mut disturbed): (Vec<Deviation>, Vec<usize>) = (Vec::new(), Vec::new());
    for i in 0..n {
        for motion in motions {
            let row: Vec<Rational> = motion.a[i].iter().zip(&mean.a[i]).map(|(x, y)| x - y).collect();
            let mut rest = (&motion.drift[i] - &mean.drift[i]).abs();
            for push in &mean.pushes {
                let most = push.centre.abs() + &push.radius;
                rest += (effect(motion, push.input, i) - &push.column[i]).abs() * most;
            }
            if rest.is_zero() && row.iter().all(Zero::is_zero) {
                continue;
            }
            if disturbed.last() != Some(&i) {
                disturbed.push(i);
            }
            let disturbance = disturbed.len() - 1;
            for row in [row.iter().map(|x| -x).collect(), row] {
                match deviations.iter_mut().find(|d| d.disturbance == disturbance && d.row == row) {
                    Some(known) => known.rest = known.rest.clone().max(rest.clone()),
                    None => deviations.push(Deviation { row, rest: rest.clone(), disturbance }),
                }
            }
        }
    }
    (mean, deviations, disturbed)
}

/// The motion with a disturbance of each of some states.
fn disturbed_by(mean: &Motion, states: &[usize], limits: &[Rational]) -> Motion {
    let mut motion = mean.clone();
    for (&state, limit) in states.iter().zip(limits) {
        let column = (0..motion.a.len()).map(|i| rational(i64::from(i == state), 1)).collect();
        motion.pushes.push(Push { input: DISTURBANCE, centre: Rational::ZERO, radius: limit.clone(), column });
    }
    motion
}

/// How large each disturbance can be.
fn disturbances(deviations: &[Deviation], found: &[Worst], count: usize) -> Option<Vec<Rational>> {
    let mut most = vec![Rational::ZERO; count];
    for (deviation, worst) in deviations.iter().zip(found) {
        let size = worst.hi.as_ref()? + &deviation.rest;
        let most = &mut most[deviation.disturbance];
        *most = most.clone().max(size);
    }
    Some(most)
}

/// Limits a little above the solution of `w = free + G w`, in floats: they are proved afterwards. None where there is no positive one.
fn fixed_point(free: &[Rational], gains: &[Vec<Rational>]) -> Option<Vec<Rational>> {
    let n = free.len();
    let float = |q: &Rational| q.to_f64().filter(|x| x.is_finite());
    let mut limits: Vec<f64> = free.iter().map(float).collect::<Option<_>>()?;
    let start = limits.clone();
    for _ in 0..20_000 {
        let mut next = start.clone();
        for (j, gains) in gains.iter().enumerate() {
            for (i, gain) in gains.iter().enumerate() {
                next[i] += float(gain)? * limits[j];
            }
        }
        let still = (0..n).all(|i| next[i] <= limits[i] * (1.0 + 1e-9));
        limits = next;
        if still {
            return limits
                .iter()
                .map(|x| Rational::from_float((x * 1.0005 + 1e-9) as f32).map(|x| x * rational(10_001, 10_000)))
                .collect();
        }
        if limits.iter().any(|x| *x > 1e12) {
            return None;
        }
    }
    None
}
