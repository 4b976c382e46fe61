//! Sines, and the phase model against its definition.

use arithmetic::{Field, Interval, Rational, Real, rational};
use motion::{AllToAll, LARGEST_FAST_ANGLE, Rk4, SINE_ERROR, VectorField, sin_cos_of};
use proptest::prelude::*;

fn exact(x: f64) -> Interval {
    Interval::from_rational(&Rational::from_float(x).expect("finite"), 160)
}

fn assert_close(x: f64) {
    let (mut s, mut c) = ([0.0], [0.0]);
    sin_cos_of(&[x], &mut s, &mut c);
    let (sin, cos) = exact(x).sin_cos().expect("an angle");
    for (found, exact_value) in [(s[0], sin), (c[0], cos)] {
        let error = (exact(found) - exact_value).magnitude().to_f64();
        assert!(error <= SINE_ERROR, "{x}: {found} is off by {error}");
    }
}

#[test]
fn sines_near_the_borders_of_quadrants() {
    for k in -40i64..=40 {
        for shift in [0.0, 1e-16, -1e-16, 1e-9, -1e-9] {
            assert_close(k as f64 * std::f64::consts::FRAC_PI_4 + shift);
        }
    }
    for x in
        [0.0, -0.0, 5e-324, 1e-300, LARGEST_FAST_ANGLE, -LARGEST_FAST_ANGLE, 523_598.0 * std::f64::consts::FRAC_PI_2]
    {
        assert_close(x);
    }
    let (mut s, mut c) = ([0.0; 3], [0.0; 3]);
    sin_cos_of(&[1e18, f64::NAN, 1.0], &mut s, &mut c);
    assert!(s[0] == 1e18f64.sin() && s[1].is_nan() && c[1].is_nan() && s[2] == 1f64.sin());
}

/// The sum over all pairs.
fn naive(frequency: f64, gain: f64, phases: &[f64]) -> Vec<f64> {
    let mean = |x: f64| phases.iter().map(|y| (x - y).sin()).sum::<f64>() / phases.len() as f64;
    phases.iter().map(|&x| frequency + gain * mean(x)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn sines_are_close(x in -8e5f64..8e5, y in -10f64..10.0) {
        assert_close(x);
        assert_close(y);
    }

    #[test]
    fn the_order_parameter_gives_all_pairs(phases in prop::collection::vec(-20f64..20.0, 0..40), gain in -2f64..2.0) {
        let mut rate = vec![0.0; phases.len()];
        AllToAll::new(0.3, gain).rate(0.0, &phases, &mut rate);
        for (a, b) in rate.iter().zip(naive(0.3, gain, &phases)) {
            prop_assert!((a - b).abs() < 1e-13, "{a} {b}");
        }
    }
}

#[test]
fn long_lists_are_cut_into_the_same_parts() {
    let phases: Vec<f64> = (0..10_001).map(|k| (k as f64 * 0.7).sin() * 3.0).collect();
    let run = || {
        let (mut state, mut field, mut method) = (phases.clone(), AllToAll::new(0.1, -1.0), Rk4::new(phases.len()));
        (0..5).for_each(|k| method.step(&mut field, f64::from(k) * 0.01, 0.01, &mut state));
        state
    };
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool").install(run);
    let three = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("a pool").install(run);
    assert!(alone == three);
    let share = rational(1, 10_001);
    let mean = exact(0.0).rational(&share);
    assert!(mean.contains(&share));
    let rates = naive(0.1, -1.0, &phases[..]);
    let mut found = vec![0.0; phases.len()];
    AllToAll::new(0.1, -1.0).rate(0.0, &phases, &mut found);
    assert!(found.iter().zip(rates).all(|(a, b)| (a - b).abs() < 1e-12));
}
