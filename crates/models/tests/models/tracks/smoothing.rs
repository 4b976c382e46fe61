//! Smoothing against tables, dense solutions and known frequencies.

use arithmetic::random::{generator, normal};
use models::tracks::{Choices, ChoicesError, Smoothing, Tracks, Vector, smoothed};

/// Two fish along given ways, a frame each second.
fn recording(ways: &[Vec<f64>; 2]) -> Tracks {
    let mut text = String::from("t,id,x,y\n");
    for (k, way) in ways.iter().enumerate() {
        for (i, x) in way.iter().enumerate() {
            text += &format!("{i},{k},{x},{}\n", -2.0 * x);
        }
    }
    Tracks::from_csv(&text).expect("a recording")
}

fn of(way: &[f64], smoothing: Smoothing, window: usize) -> (Vec<Option<Vector>>, Vec<Option<Vector>>) {
    smoothed(&recording(&[way.to_vec(), way.to_vec()]), 0, smoothing, window)
}

fn close(found: Option<&Vector>, known: f64, error: f64) {
    let found = found.expect("a number");
    assert!((found.re - known).abs() <= error && (found.im + 2.0 * known).abs() <= 2.0 * error, "{found:?} {known}");
}

/// The tables of Savitzky and Golay (1964) for cubics: an impulse shows the weights, in reverse.
#[test]
fn local_cubics_have_the_weights_of_the_tables() {
    type Table<'a> = (usize, &'a [f64], f64, &'a [f64], f64);
    let tables: [Table; 2] = [
        (5, &[-3.0, 12.0, 17.0, 12.0, -3.0], 35.0, &[1.0, -8.0, 0.0, 8.0, -1.0], 12.0),
        (7, &[-2.0, 3.0, 6.0, 7.0, 6.0, 3.0, -2.0], 21.0, &[22.0, -67.0, -58.0, 0.0, 58.0, 67.0, -22.0], 252.0),
    ];
    for (window, value, of_value, slope, of_slope) in tables {
        let half = window / 2;
        let mut impulse = vec![0.0; 30];
        impulse[15] = 1.0;
        let (positions, velocities) = of(&impulse, Smoothing::SavitzkyGolay, window);
        for k in 0..window {
            let i = 15 + half - k;
            close(positions[i].as_ref(), value[k] / of_value, 1e-14);
            close(velocities[i].as_ref(), slope[k] / of_slope, 1e-14);
        }
        assert_eq!(positions.iter().flatten().count(), 30 - 2 * half);
        // Cubics stay, with their slopes.
        let cubic: Vec<f64> = (0..20).map(|i| f64::from(i * i * i - 3 * i * i + i)).collect();
        let (positions, velocities) = of(&cubic, Smoothing::SavitzkyGolay, window);
        for i in half..20 - half {
            let t = i as f64;
            close(positions[i].as_ref(), cubic[i], 1e-9);
            close(velocities[i].as_ref(), 3.0 * t * t - 6.0 * t + 1.0, 1e-9);
        }
    }
    let choices = Choices { smoothing: Smoothing::SavitzkyGolay, window: 3, ..Choices::of_sidebar(1.0) };
    assert!(matches!(choices.check(4), Err(ChoicesError::ShortWindow { least: 5, window: 3, .. })));
}

/// Solves a dense system by elimination with pivots.
fn solved(mut a: Vec<Vec<f64>>, mut x: Vec<f64>) -> Vec<f64> {
    let n = x.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs())).expect("rows");
        a.swap(k, pivot);
        x.swap(k, pivot);
        for i in (0..n).filter(|&i| i != k) {
            let factor = a[i][k] / a[k][k];
            let pivot = a[k].clone();
            a[i].iter_mut().zip(&pivot).skip(k).for_each(|(x, y)| *x -= factor * y);
            x[i] -= factor * x[k];
        }
    }
    (0..n).map(|k| x[k] / a[k][k]).collect()
}

/// The least `Σ (r_i − s_i)² + λ s^T Q R^-1 Q^T s` by dense matrices, whose columns come from the natural splines through unit vectors.
fn dense(way: &[f64], strength: f64) -> Vec<f64> {
    let n = way.len();
    let inner = n - 2;
    let r: Vec<Vec<f64>> =
        (0..inner).map(|i| (0..inner).map(|j| [2.0 / 3.0, 1.0 / 6.0, 0.0][i.abs_diff(j).min(2)]).collect()).collect();
    let q = |i: usize, k: usize| match i as i64 - k as i64 {
        0 | 2 => 1.0,
        1 => -2.0,
        _ => 0.0,
    };
    let curvatures: Vec<Vec<f64>> = (0..n).map(|j| solved(r.clone(), (0..inner).map(|k| q(j, k)).collect())).collect();
    let entry = |i: usize, j: usize| {
        let bending: f64 = (0..inner).map(|k| q(i, k) * curvatures[j][k]).sum();
        f64::from(u8::from(i == j)) + strength * bending
    };
    solved((0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect(), way.to_vec())
}

#[test]
fn splines_are_those_of_dense_matrices() {
    let mut random = generator("test", "splines", 0);
    for n in [3, 4, 5, 12] {
        for window in [1, 3, 9, 41] {
            let way: Vec<f64> = (0..n).map(|_| 10.0 * normal(&mut random)).collect();
            let known = dense(&way, (window as f64 / std::f64::consts::TAU).powi(4));
            let (positions, _) = of(&way, Smoothing::Spline, window);
            known.iter().enumerate().for_each(|(i, x)| close(positions[i].as_ref(), *x, 1e-9));
        }
    }
}

/// Lines stay lines; an oscillation keeps half of its amplitude where its period is the window; velocities are slopes of the positions.
#[test]
fn splines_keep_lines_and_halve_an_oscillation_of_the_window() {
    let line: Vec<f64> = (0..9).map(|i| 3.0 - 0.5 * f64::from(i)).collect();
    let (positions, velocities) = of(&line, Smoothing::Spline, 41);
    (0..9).for_each(|i| close(positions[i].as_ref(), line[i], 1e-12));
    (0..9).for_each(|i| close(velocities[i].as_ref(), -0.5, 1e-12));
    let period = 41.0;
    let frequency = std::f64::consts::TAU / period;
    let wave: Vec<f64> = (0..400).map(|i| (frequency * f64::from(i)).sin()).collect();
    let (positions, velocities) = of(&wave, Smoothing::Spline, 41);
    for i in 150..250 {
        close(positions[i].as_ref(), 0.5 * wave[i], 1e-3);
        close(velocities[i].as_ref(), 0.5 * frequency * (frequency * i as f64).cos(), 1e-3);
    }
    // The slope at a knot from either side: of the last one it is that of the cubic before it.
    let (positions, velocities) = of(&[0.0, 1.0, 0.0, 2.0, 5.0], Smoothing::Spline, 3);
    let (turned, back) = of(&[5.0, 2.0, 0.0, 1.0, 0.0], Smoothing::Spline, 3);
    for i in 0..5 {
        close(turned[4 - i].as_ref(), positions[i].as_ref().expect("there").re, 1e-12);
        close(back[4 - i].as_ref(), -velocities[i].as_ref().expect("there").re, 1e-12);
    }
}

/// Nothing crosses a gap, and a run of two frames has no spline.
#[test]
fn runs_are_smoothed_by_themselves() {
    let text: String = (0..20)
        .flat_map(|i: i32| [(i, 0), (i, 1)])
        .filter(|(i, k)| *k == 1 || !([3, 6].contains(i) || *i > 16))
        .map(|(i, k)| format!("{i},{k},{},{}\n", i * i, (i * 7) % 5))
        .collect();
    let tracks = Tracks::from_csv(&format!("t,id,x,y\n{text}")).expect("a recording");
    for (smoothing, window) in [(Smoothing::Mean, 3), (Smoothing::SavitzkyGolay, 5), (Smoothing::Spline, 5)] {
        let (positions, velocities) = smoothed(&tracks, 0, smoothing, window);
        assert_eq!((positions.len(), velocities.len()), (20, 20));
        for (from, to) in [(0, 3), (4, 6), (7, 17)] {
            let alone: String = tracks.frames[from..to]
                .iter()
                .enumerate()
                .flat_map(|(i, _)| {
                    let r = tracks.positions[0][from + i].as_ref().expect("seen");
                    [0, 1].map(|k| format!("{i},{k},{},{}\n", r.re, r.im))
                })
                .collect();
            let Ok(alone) = Tracks::from_csv(&format!("t,id,x,y\n{alone}")) else { continue };
            let (p, v) = smoothed(&alone, 0, smoothing, window);
            let same = |a: &[Option<Vector>], b: &[Option<Vector>]| {
                a.iter().zip(b).all(|(a, b)| match (a, b) {
                    (Some(a), Some(b)) => (a.clone() - b).norm_squared() < 1e-18,
                    (a, b) => a.is_none() && b.is_none(),
                })
            };
            assert!(same(&p, &positions[from..to]) && same(&v, &velocities[from..to]), "{smoothing:?} {from}");
        }
        assert!([3, 6, 17, 18, 19].iter().all(|&i: &usize| positions[i].is_none() && velocities[i].is_none()));
    }
}
