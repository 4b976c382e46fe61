//! What runs are said to have reached, on states whose answer is known.

use arithmetic::Complex;
use models::oscillator::{
    CLUSTER, Flight, centre_spread, circular_formation, cluster_gap, nearest_twist, order, pattern, ring_differences,
    shape_rate, winding,
};
use std::f64::consts::{PI, TAU};

const OMEGA: f64 = 0.1;

/// Particles on one circle with these phases, turned by the same angle.
fn on_circle(phases: impl Iterator<Item = f64>) -> Flight {
    let phases: Vec<f64> = phases.map(|theta| theta + 0.4).collect();
    let phasors: Vec<_> = phases.iter().map(|t| Complex::new(t.cos(), t.sin())).collect();
    Flight { positions: circular_formation(&OMEGA, &phasors).unwrap().positions, phases }
}

#[test]
fn twisted_states_are_told_apart() {
    for m in -5i64..=6 {
        let flight = on_circle((0..12).map(|k| TAU * (m * k) as f64 / 12.0 + 1e-3 * (k % 3) as f64));
        let (found, off) = nearest_twist(&flight.phases);
        assert_eq!(found, m);
        assert!(off < 3e-3);
        // Half a turn may be read as minus half a turn, so that only the others have a winding number.
        if m < 6 {
            assert_eq!(winding(&flight.phases), m);
        }
        let clusters = 12 / num_integer::gcd(12, m);
        assert_eq!(pattern(&flight), Some(clusters as usize));
        for divisor in [1usize, 2, 3, 4, 6, 12] {
            assert_eq!(flight.forms_pattern(divisor, CLUSTER), divisor as i64 == clusters);
        }
        // Balanced modulo a turn over j unless the clusters agree modulo it.
        for j in 1..=12 {
            let expected = f64::from(i64::from(j) % clusters == 0);
            assert!((order(&flight, j).unwrap() - expected).abs() < 2e-2);
        }
    }
    assert!(ring_differences(&[0.0, 3.0, -3.0]).iter().all(|d| (-PI..PI).contains(d)));
}

#[test]
fn patterns_of_many_phases_are_no_chains() {
    let evenly = |count: usize, places: usize| {
        let phases = (0..count).map(|k| TAU * (k % places) as f64 / places as f64 + 0.4).collect();
        Flight { positions: Vec::new(), phases }
    };
    for (count, places) in
        [(1, 1), (2, 1), (2, 2), (3, 3), (36, 36), (37, 37), (40, 40), (100, 100), (1000, 8), (1000, 1000)]
    {
        let flight = evenly(count, places);
        assert_eq!(pattern(&flight), Some(places), "{count} phases");
        assert_eq!(flight.clusters(cluster_gap(count)).len(), places, "{count} phases");
    }
    // A chain of phases that are close to the next, but not together.
    let chain = Flight { positions: Vec::new(), phases: (0..12).map(|k| f64::from(k) * 9.9f64.to_radians()).collect() };
    assert_eq!((pattern(&chain), chain.forms_pattern(1, CLUSTER)), (None, false));
    // Equal places with unequal clusters, places that are missing, and nobody.
    let uneven = Flight { positions: Vec::new(), phases: vec![0.0, 0.0, 0.0, PI] };
    assert_eq!((pattern(&uneven), uneven.clusters(CLUSTER).len()), (None, 2));
    let quarter = Flight { positions: Vec::new(), phases: vec![0.0, PI / 2.0] };
    assert_eq!(pattern(&quarter), None);
    assert_eq!(pattern(&Flight { positions: Vec::new(), phases: Vec::new() }), None);
    // Just inside and just outside of the tolerance of 5 degrees.
    for (degrees, expected) in [(4.9, Some(2)), (5.1, None)] {
        let off = f64::to_radians(degrees);
        let flight = Flight { positions: Vec::new(), phases: vec![off, -off, PI + off, PI - off] };
        assert_eq!(pattern(&flight), expected, "{degrees}");
    }
}

#[test]
fn one_circle_is_at_rest_and_two_are_not() {
    let flight = on_circle([0.0, 0.5, 2.0, -1.0].into_iter());
    let state = flight.state();
    assert!(centre_spread(&OMEGA, &state).unwrap() < 1e-12);
    assert!(shape_rate(&state, &[OMEGA; 4]) < 1e-12);
    // At another rate the same particles are on different circles.
    assert!(shape_rate(&state, &[2.0 * OMEGA; 4]) > 0.1);
    let mut apart = flight.clone();
    apart.positions[0].re += 3.0;
    assert!((centre_spread(&OMEGA, &apart.state()).unwrap() - 2.25).abs() < 1e-12);
    assert!((shape_rate(&apart.state(), &[OMEGA; 4]) - 0.3).abs() < 1e-12);
    // The first one, which is apart, alone, and with another one.
    assert_eq!(shape_rate(&apart.state(), &[OMEGA]), 0.0);
    assert!((shape_rate(&apart.state(), &[OMEGA; 2]) - 0.3).abs() < 1e-12);
    assert!(centre_spread(&0.0, &state).is_err());
}

/// Each bound of [`Flight::forms_pattern`], from both sides, and what has no pattern.
#[test]
fn patterns_keep_their_bounds() {
    let of = |phases: &[f64]| Flight { positions: Vec::new(), phases: phases.to_vec() };
    for (phases, clusters) in [(&[][..], 0), (&[], 1), (&[1.0], 0), (&[0.0, 1.0, 2.0], 2)] {
        assert!(!of(phases).forms_pattern(clusters, 1.0), "{phases:?}");
    }
    // Only one phase is off, below the others: by 5/12 from their mean, -1/12.
    let below = of(&[0.0, 0.0, 0.0, 0.0, 0.0, -0.5]);
    assert!(!below.forms_pattern(1, 0.25) && below.forms_pattern(1, 0.9));
    // A sixth of the gap at most, whatever the tolerance.
    for (share, expected) in [(0.98, true), (1.02, false)] {
        let off = share * TAU / 24.0;
        let phases: Vec<f64> = (0..4).flat_map(|k| [-off, off].map(|off| TAU * f64::from(k) / 4.0 + off)).collect();
        assert_eq!(of(&phases).forms_pattern(4, 10.0), expected);
    }
    // All at their places, of which one has two and one none.
    assert!(!of(&[0.0, 0.0, PI / 2.0, PI]).forms_pattern(4, 1.0));
    assert_eq!((cluster_gap(100), cluster_gap(12), cluster_gap(0)), (TAU / 300.0, CLUSTER, CLUSTER));
}

/// Steps of 1.7 forward and back have the mean direction of a half turn, from which each is `pi - 1.7` off; one step may be off alone.
#[test]
fn twists_are_those_of_the_mean_step() {
    let (m, off) = nearest_twist(&[0.0, 1.7, 3.4, 1.7]);
    assert!(m == 2 && (off - (PI - 1.7)).abs() < 1e-12, "{m} {off}");
    for side in [-1.0, 1.0] {
        let (m, off) = nearest_twist(&[0.0, 0.3 * side, 0.2 * side, 0.1 * side]);
        assert!(m == 0 && (off - 0.3).abs() < 1e-12, "{m} {off}");
    }
}

#[test]
fn the_gap_between_clusters_is_known_for_any_number_of_phases() {
    assert_eq!((cluster_gap(0), cluster_gap(1), cluster_gap(24)), (CLUSTER, CLUSTER, TAU / 72.0));
    assert_eq!(cluster_gap(usize::MAX), TAU / (3.0 * usize::MAX as f64));
}
