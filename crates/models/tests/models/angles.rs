//! Angles modulo whole turns against adding and taking away turns one by one.

use models::angles::{modulo_turns, within_a_turn};
use models::double_integrator::HeadingDifference;
use motion::whole_turns;
use std::f64::consts::{PI, TAU};

/// The angle with as few turns added or taken away as bring it to `least` or above, and below one turn more.
fn naive(mut angle: f64, least: f64) -> f64 {
    while angle < least {
        angle += TAU;
    }
    while angle >= least + TAU {
        angle -= TAU;
    }
    angle
}

#[test]
fn turns_are_taken_away() {
    for k in -400..=400 {
        let angle = f64::from(k) * 0.1;
        assert!((modulo_turns(angle) - naive(angle, -PI)).abs() < 1e-12, "{angle}");
        assert!((within_a_turn(angle) - naive(angle, 0.0)).abs() < 1e-12, "{angle}");
    }
    assert_eq!(modulo_turns(1e-20), 1e-20);
    for k in -40..=40 {
        let angle = f64::from(k) * 0.3;
        let wrapped = HeadingDifference::Wrapped.read(modulo_turns(angle));
        assert!((angle - TAU * whole_turns(angle) - wrapped).abs() < 1e-12, "{angle}");
    }
    assert_eq!([PI, -PI, 3.0 * PI, 0.0].map(whole_turns), [0.0, -1.0, 1.0, 0.0]);
    assert!(modulo_turns(PI).abs() == PI && modulo_turns(-PI).abs() == PI);
}
