//! The runs of the figures of Paley and others, on states whose end is known.

use arithmetic::Complex;
use models::oscillator::{Flight, circular_formation, nearest_twist, order, winding};
use runs::{CyclicFormation, Experiment, FourMotions, OMEGA, Rim, RingPhases, ZoneFormation, ZoneLaw};
use std::f64::consts::{PI, TAU};

/// Particles on one circle with these phases, turned by the same angle.
fn on_circle(phases: impl Iterator<Item = f64>) -> Flight {
    let phases: Vec<f64> = phases.map(|theta| theta + 0.4).collect();
    let phasors: Vec<_> = phases.iter().map(|t| Complex::new(t.cos(), t.sin())).collect();
    Flight { positions: circular_formation(&OMEGA, &phasors).unwrap().positions, phases }
}

/// Clusters on the rim of each other's zone sense each other after any time where circle centres are stepped; in steps of the positions
/// they soon do not, because the circle of the method is too large.
#[test]
fn clusters_on_the_rim_are_sensed() {
    for clusters in ZoneFormation::CLUSTERS {
        // At K_1 = K_0 the printed law does not contain the zone.
        let formation = ZoneFormation::new(ZoneLaw::Printed, (0.1, 0.1), clusters);
        let angle = TAU / clusters as f64;
        let start = on_circle((0..12).map(|k| angle * (k % clusters) as f64));
        let by_centres = formation.end(start.clone()).unwrap();
        if clusters == 2 {
            assert!((formation.sensed_apart(&by_centres) - PI).abs() < 1e-9);
            let by_places = ZoneFormation { rim: Rim { by_centres: false, ..Rim::EXACT }, ..formation };
            assert!(by_places.sensed_apart(&by_places.end(start).unwrap()) < 1e-9);
        } else {
            assert!((formation.sensed_apart(&start) - angle).abs() < 1e-9, "M = {clusters}");
        }
    }
}

#[test]
fn trajectories_end_where_runs_end() {
    let start = on_circle((0..12).map(|k| f64::from(k * k)));
    let motion = FourMotions { omega: OMEGA, gain: -1.0 };
    let trajectory = motion.trajectory(start.clone(), 100).unwrap();
    let end = motion.end(start.clone()).unwrap();
    assert_eq!(trajectory.len(), 6);
    assert_eq!(trajectory[5], (100.0, end.clone()));
    assert!(order(&end, 1).unwrap() > 0.999_999);
    let asked = motion.until(start.clone(), (100, 500), |flight| Ok((*flight == end).then_some(()))).unwrap();
    assert_eq!(asked, Some(()));
    assert_eq!(motion.until(start, (100, 500), |_| Ok(None::<()>)).unwrap(), None);
}

/// From a twisted state with small disturbances both models come back to it exactly where it is stable.
#[test]
fn stable_twists_attract() {
    for m in [0i64, 1, 2, 4, 5, 6] {
        let disturbed = |k: i64| TAU * (m * k) as f64 / 12.0 + 0.05 * ((7 * k % 12) as f64 / 12.0 - 0.5);
        let start = on_circle((0..12).map(disturbed));
        let sign = if m <= 2 { -1.0 } else { 1.0 };
        let end = CyclicFormation::new(sign * CyclicFormation::GAIN).end(start.clone()).unwrap();
        assert_eq!(nearest_twist(&end.phases).0, m);
        assert!(nearest_twist(&end.phases).1 < 0.02, "m = {m}");
        // The other sign drives it away.
        let other = CyclicFormation::new(-sign * CyclicFormation::GAIN).end(start.clone()).unwrap();
        assert!(nearest_twist(&other.phases).0 != m, "m = {m}");
        if m <= 2 {
            let mut phases = start;
            RingPhases::default().advance(&mut phases, 1000).unwrap();
            assert!(nearest_twist(&phases.phases).1 < 1e-3 && winding(&phases.phases) == m);
        }
    }
}
