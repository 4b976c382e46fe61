//! Sines against enclosures.

use arithmetic::{Interval, Number, Rational};
use motion::{LARGEST_FAST_ANGLE, SINE_ERROR, sin_cos_of};
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

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn sines_are_close(x in -8e5f64..8e5, y in -10f64..10.0) {
        assert_close(x);
        assert_close(y);
    }
}
