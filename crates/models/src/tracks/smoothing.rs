//! Positions and velocities from noisy positions: a moving mean, local cubics, a smoothing spline.

use super::{Tracks, Vector};
use arithmetic::Complex;

/// How positions are smoothed before velocities are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Smoothing {
    /// The mean over the window, and central differences of the means: the sidebar's moving average.
    Mean,
    /// Savitzky and Golay: the cubic through the window by least squares, its value and its slope in the middle.
    SavitzkyGolay,
    /// The cubic spline `s` that makes `Σ |r_i − s(i)|² + λ ∫ |s''|²` least over each run without a gap, `λ = (window/2π)^4` with times in
    /// frames: an oscillation whose period is the window keeps half of its amplitude.
    Spline,
}

/// What is known of a fish in one frame: its smoothed position and its velocity per frame.
type Smooth = (Option<Vector>, Option<Vector>);

impl Smoothing {
    /// All, with their names.
    pub const ALL: [(&'static str, Smoothing); 3] =
        [("mean", Smoothing::Mean), ("savgol", Smoothing::SavitzkyGolay), ("spline", Smoothing::Spline)];

    /// The name.
    pub fn name(self) -> &'static str {
        match self {
            Smoothing::Mean => "mean",
            Smoothing::SavitzkyGolay => "savgol",
            Smoothing::Spline => "spline",
        }
    }

    /// The smallest window, in frames.
    pub fn least_window(self) -> usize {
        if self == Smoothing::SavitzkyGolay { 5 } else { 1 }
    }

    fn of_run(self, run: &[Vector], window: usize) -> Vec<Smooth> {
        match self {
            Smoothing::Mean => means(run, window / 2),
            Smoothing::SavitzkyGolay => local_cubics(run, window / 2),
            Smoothing::Spline => spline(run, window),
        }
    }
}

/// Smoothed positions of one fish, and its velocities in the unit of the file per second, in each frame of the recording; `None` where the
/// window is not filled without a gap. A fish that is not there has none.
pub fn smoothed(
    tracks: &Tracks,
    fish: usize,
    smoothing: Smoothing,
    window: usize,
) -> (Vec<Option<Vector>>, Vec<Option<Vector>>) {
    let places: &[Option<Vector>] = tracks.positions.get(fish).map_or(&[], Vec::as_slice);
    let mut found: Vec<Smooth> = vec![(None, None); places.len()];
    let mut from = 0;
    while from < places.len().min(tracks.frames.len()) {
        let first = tracks.frames[from].number;
        let follows = |(i, place): (usize, &Option<Vector>)| {
            let frame = tracks.frames.get(from + i).filter(|frame| frame.number.checked_sub(first) == Some(i as u64));
            frame.and(place.clone())
        };
        let run: Vec<Vector> = places[from..].iter().enumerate().map_while(follows).collect();
        found.splice(from..from + run.len(), smoothing.of_run(&run, window));
        from += run.len().max(1);
    }
    let (positions, velocities): (Vec<_>, Vec<_>) = found.into_iter().unzip();
    let per_second = |v: Option<Vector>| v.map(|v| v.scale(&(1.0 / tracks.step)));
    (positions, velocities.into_iter().map(per_second).collect())
}

/// The window around a place, if the run fills it.
fn around(run: &[Vector], i: usize, half: usize) -> Option<&[Vector]> {
    run.get(i.checked_sub(half)?..=i.checked_add(half)?)
}

fn means(run: &[Vector], half: usize) -> Vec<Smooth> {
    let average = |i: usize| {
        let window = around(run, i, half)?;
        let sum = window.iter().fold(Complex::new(0.0, 0.0), |sum, r| sum + r);
        Some(sum.scale(&(1.0 / window.len() as f64)))
    };
    let averages: Vec<Option<Vector>> = (0..run.len()).map(average).collect();
    let velocity = |i: usize| {
        averages[i].as_ref()?;
        let (before, after) = (averages.get(i.checked_sub(1)?)?.as_ref()?, averages.get(i + 1)?.clone()?);
        Some((after - before).scale(&0.5))
    };
    (0..run.len()).map(|i| (averages[i].clone(), velocity(i))).collect()
}

/// With `S_k` the sum of `j^k` over the window, odd ones being 0, the normal equations of `a + b j + c j² + d j³` part into two for `a, c`
/// and two for `b, d`.
fn local_cubics(run: &[Vector], half: usize) -> Vec<Smooth> {
    let offsets = || (0..=2 * half).map(|k| k as f64 - half as f64);
    let sum = |power: i32| offsets().map(|j| j.powi(power)).sum::<f64>();
    let [s0, s2, s4, s6] = [0, 2, 4, 6].map(sum);
    let (even, odd) = (s0 * s4 - s2 * s2, s2 * s6 - s4 * s4);
    let value: Vec<f64> = offsets().map(|j| (s4 - s2 * j * j) / even).collect();
    let slope: Vec<f64> = offsets().map(|j| (s6 * j - s4 * j.powi(3)) / odd).collect();
    let weighted = |window: &[Vector], weights: &[f64]| {
        window.iter().zip(weights).fold(Complex::new(0.0, 0.0), |sum, (r, w)| sum + &r.scale(w))
    };
    let fitted = |i: usize| match around(run, i, half) {
        Some(window) => (Some(weighted(window, &value)), Some(weighted(window, &slope))),
        None => (None, None),
    };
    (0..run.len()).map(fitted).collect()
}

/// Reinsch: the second derivatives `c` at the inner knots solve `(R + λ Q^T Q) c = Q^T r`, where `Q^T` takes second differences and `R` has 2/3
/// on the diagonal and 1/6 beside it; then `s = r − λ Q c`. The slope at a knot is that of the cubic after it, or before the last one.
fn spline(run: &[Vector], window: usize) -> Vec<Smooth> {
    let inner = run.len().saturating_sub(2);
    if inner == 0 {
        return vec![(None, None); run.len()];
    }
    let strength = (window as f64 / std::f64::consts::TAU).powi(4);
    let right: Vec<Vector> = run.windows(3).map(|r| r[0].clone() + &r[2] - &r[1].scale(&2.0)).collect();
    let bands = [2.0 / 3.0 + 6.0 * strength, 1.0 / 6.0 - 4.0 * strength, strength];
    let inside = pentadiagonal(bands, right);
    let zero = || Complex::new(0.0, 0.0);
    let mut curvature = vec![zero()];
    curvature.extend(inside);
    curvature.push(zero());
    let bent = |i: usize| {
        let c = |k: Option<usize>| k.and_then(|k| curvature.get(k)).cloned().unwrap_or_else(zero);
        c(i.checked_sub(1)) + &c(Some(i + 1)) - &c(Some(i)).scale(&2.0)
    };
    let s: Vec<Vector> = run.iter().enumerate().map(|(i, r)| r.clone() - &bent(i).scale(&strength)).collect();
    let slope = |i: usize| {
        let (from, at) = if i + 1 < s.len() { (i, 0.0) } else { (i - 1, 1.0) };
        let chord = s[from + 1].clone() - &s[from];
        let (a, b) = (&curvature[from], &curvature[from + 1]);
        // s'(t) of the cubic between two knots with second derivatives a and b, at t = 0 and 1.
        chord + &a.scale(&((3.0 * at - 2.0) / 6.0)) + &b.scale(&((3.0 * at - 1.0) / 6.0))
    };
    (0..s.len()).map(|i| (Some(s[i].clone()), Some(slope(i)))).collect()
}

/// Solves a symmetric positive definite system whose rows are all `.. c b a b c ..`, by `L D L^T` without pivots.
fn pentadiagonal([a, b, c]: [f64; 3], mut x: Vec<Vector>) -> Vec<Vector> {
    let n = x.len();
    // The diagonal, and the entries of L one and two places below it.
    let (mut d, mut l, mut m) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    for i in 0..n {
        let two = if i >= 2 { c / d[i - 2] } else { 0.0 };
        let one = if i >= 1 { (b - two * if i >= 2 { d[i - 2] * l[i - 1] } else { 0.0 }) / d[i - 1] } else { 0.0 };
        d[i] = a;
        if i >= 1 {
            d[i] -= one * one * d[i - 1];
        }
        if i >= 2 {
            d[i] -= two * two * d[i - 2];
        }
        (l[i], m[i]) = (one, two);
    }
    for i in 1..n {
        let mut value = x[i].clone() - &x[i - 1].scale(&l[i]);
        if i >= 2 {
            value = value - &x[i - 2].scale(&m[i]);
        }
        x[i] = value;
    }
    x.iter_mut().zip(&d).for_each(|(x, d)| *x = x.scale(&(1.0 / d)));
    for i in (0..n.saturating_sub(1)).rev() {
        let mut value = x[i].clone() - &x[i + 1].scale(&l[i + 1]);
        if i + 2 < n {
            value = value - &x[i + 2].scale(&m[i + 2]);
        }
        x[i] = value;
    }
    x
}
