//! Integrators and events against known solutions.

use motion::{IntegrationError, Integrator, Margin, Rk4, Tolerance, VectorField, integrate, step_to_crossing};

fn oscillator() -> impl VectorField {
    |_: f64, y: &[f64], rate: &mut [f64]| {
        (rate[0], rate[1]) = (y[1], -y[0]);
    }
}

const TIGHT: Tolerance = Tolerance { relative: 1e-12, absolute: 1e-12 };

#[test]
fn the_classical_method_has_order_four() {
    let error = |steps: usize| {
        let (mut y, mut method, dt) = ([0.0, 1.0], Rk4::new(2), 2.0 / steps as f64);
        (0..steps).for_each(|k| method.step(&mut oscillator(), k as f64 * dt, dt, &mut y));
        (y[0] - 2f64.sin()).abs()
    };
    let ratio = error(40) / error(80);
    assert!((14.0..18.0).contains(&ratio), "{ratio}");
    // Fields that depend on time: y' = 4t³.
    let (mut y, mut method) = ([0.0], Rk4::new(1));
    method.step(&mut |t: f64, _: &[f64], rate: &mut [f64]| rate[0] = 3.0 * t * t, 1.0, 1.0, &mut y);
    assert!((y[0] - 7.0).abs() < 1e-14);
}

#[test]
fn adaptive_steps_keep_the_tolerance() {
    let times: Vec<f64> = (1..=100).map(|k| f64::from(k) * 0.37).collect();
    for relative in [1e-6, 1e-9, 1e-12] {
        let tolerance = Tolerance { relative, absolute: relative };
        let states = integrate(&mut oscillator(), 0.0, &[0.0, 1.0], &times, tolerance).expect("smooth");
        for (t, y) in times.iter().zip(states) {
            let error = (y[0] - t.sin()).abs().max((y[1] - t.cos()).abs());
            assert!(error < 300.0 * relative, "{relative} at {t}: {error}");
        }
    }
    let mut solution = Integrator::new(0.0, &[0.0, 1.0], TIGHT);
    while solution.time() < 100.0 {
        solution.step(&mut oscillator(), 100.0).expect("smooth");
    }
    assert!(solution.time() == 100.0 && solution.counts().0 < 600, "{:?}", solution.counts());
    assert!((solution.state()[0] - 100f64.sin()).abs() < 1e-10);
}

#[test]
fn states_within_a_step_have_the_full_order() {
    let mut solution = Integrator::new(0.0, &[0.0, 1.0], Tolerance { relative: 1e-9, absolute: 1e-9 });
    (0..5).for_each(|_| solution.step(&mut oscillator(), 50.0).expect("smooth"));
    let (a, b) = (solution.previous_time(), solution.time());
    let (mut dense, mut full): (f64, f64) = (0.0, 0.0);
    let start = solution.within(&mut oscillator(), a)[0] - a.sin();
    for k in 1..10 {
        let t = a + (b - a) * f64::from(k) / 10.0;
        dense = dense.max((solution.interpolate(&mut oscillator(), t)[0] - t.sin()).abs());
    }
    for k in 1..10 {
        let t = a + (b - a) * f64::from(k) / 10.0;
        full = full.max((solution.within(&mut oscillator(), t)[0] - t.sin()).abs());
    }
    assert!(full < 1e-8 + start.abs() && dense < 1e-7, "{dense} {full}");
}

#[test]
fn singularities_stop() {
    let mut square = |_: f64, y: &[f64], rate: &mut [f64]| rate[0] = y[0] * y[0];
    let found = integrate(&mut square, 0.0, &[1.0], &[2.0], TIGHT);
    assert!(matches!(found, Err(IntegrationError::Stuck(t)) if (t - 1.0).abs() < 1e-6), "{found:?}");
}

/// `scale (y_k - level)`.
#[derive(Clone, Copy)]
struct Side {
    component: usize,
    level: f64,
    scale: f64,
}

impl Margin for Side {
    fn value(&self, at: &dyn Fn(usize) -> f64) -> f64 {
        self.scale * (at(self.component) - self.level)
    }
}

/// The times at which `sin` leaves the side of a level on which it is, whatever else is watched.
fn crossings(level: f64, below: bool, until: f64, tolerance: Tolerance) -> Vec<f64> {
    let mut solution = Integrator::new(0.0, &[0.0, 1.0], tolerance);
    let mut found = Vec::new();
    let mut watched = Side { component: 0, level, scale: if below { -1.0 } else { 1.0 } };
    // Never falls, and hides the other in the least of both.
    let other = Side { component: 1, level: -2.0, scale: 1e-12 };
    let near = |watched: Side| {
        move |state: &[f64], moved: &[f64]| {
            let can = |side: &Side| {
                side.value(&|c| state[c]) <= side.scale.abs() * moved[side.component] || side.scale < 1e-6
            };
            [watched, other].into_iter().filter(can).collect::<Vec<Side>>()
        }
    };
    while solution.time() < until {
        let crossing = step_to_crossing(&mut oscillator(), &mut solution, until, near(watched)).expect("smooth");
        let Some(crossing) = crossing else { continue };
        found.push(crossing.time);
        watched.scale = -watched.scale;
        solution = Integrator::new(crossing.time, &crossing.state, tolerance);
    }
    found
}

#[test]
fn crossings_are_found_to_the_last_digits() {
    // The zero at the start is none.
    let found = crossings(0.0, false, 40.0, TIGHT);
    assert_eq!(found.len(), 12);
    for (k, time) in found.into_iter().enumerate() {
        let exact = std::f64::consts::PI * (k + 1) as f64;
        assert!((time - exact).abs() < 1e-10, "{time} {exact}");
    }
}

#[test]
fn grazing_crossings_are_not_missed() {
    // sin t is above 1 - depth for a short while near pi/2 + 2 pi k only.
    for depth in [1e-3, 1e-5, 1e-7, 1e-9] {
        for relative in [1e-6, 1e-9, 1e-12] {
            let tolerance = Tolerance { relative, absolute: relative };
            if depth < 1e3 * relative {
                continue;
            }
            let found = crossings(1.0 - depth, true, 30.0, tolerance);
            assert_eq!(found.len(), 10, "depth {depth}, tolerance {relative}: {found:?}");
            for (k, pair) in found.chunks(2).enumerate() {
                let middle = std::f64::consts::FRAC_PI_2 + std::f64::consts::TAU * k as f64;
                let half = (1.0 - depth).acos();
                let error = (pair[0] - (middle - half)).abs().max((pair[1] - (middle + half)).abs());
                assert!(error < 1e4 * relative / half, "{depth} {relative}: {error}");
            }
            // A little too far away: no crossing.
            assert!(crossings(1.0 + depth, true, 30.0, tolerance).is_empty());
        }
    }
}
