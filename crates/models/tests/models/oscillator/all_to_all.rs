//! The law (10) for many phases against the law over any scalar.

use arithmetic::Complex;
use models::oscillator::{AllToAll, gradient_control};
use motion::{Rk4, VectorField};
use proptest::prelude::*;

fn rates(frequency: f64, gain: f64, phases: &[f64]) -> Vec<f64> {
    let mut rates = vec![0.0; phases.len()];
    AllToAll::new(frequency, gain).rate(0.0, phases, &mut rates);
    rates
}

/// (6) with (9).
fn twin(frequency: f64, gain: f64, phases: &[f64]) -> Vec<f64> {
    let phasors: Vec<Complex<f64>> = phases.iter().map(|theta| Complex::new(theta.cos(), theta.sin())).collect();
    gradient_control(&gain, &phasors).unwrap_or_default().into_iter().map(|u| frequency + u).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn both_ways_give_the_same_rates(phases in prop::collection::vec(-20f64..20.0, 0..40), gain in -2f64..2.0) {
        for (a, b) in rates(0.3, gain, &phases).iter().zip(twin(0.3, gain, &phases)) {
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
    let both = rates(0.1, -1.0, &phases).into_iter().zip(twin(0.1, -1.0, &phases));
    assert!(both.into_iter().all(|(a, b)| (a - b).abs() < 1e-12));
}

#[test]
fn one_phase_is_its_own_order_parameter() {
    assert_eq!(AllToAll::new(0.0, 1.0).order_parameter(&[]), (0.0, 0.0));
    let (c, s) = AllToAll::new(0.0, 1.0).order_parameter(&[0.3]);
    assert!((c - 0.3f64.cos()).abs() < 1e-15 && (s - 0.3f64.sin()).abs() < 1e-15);
}
