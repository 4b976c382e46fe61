//! Exact signs with square roots, against intervals of growing precision.

use arithmetic::{
    Field, Interval, Number, Rational, Sign, Signed, rational, sign_of_square_root_difference, sign_of_surd,
};
use proptest::prelude::*;

/// Decides the sign by intervals, or gives up: then it must be a zero.
fn by_intervals(f: impl Fn(u32) -> Interval) -> Sign {
    [64, 256, 1024].into_iter().find_map(|precision| f(precision).sign()).unwrap_or(Sign::Zero)
}

fn small_rational() -> impl Strategy<Value = Rational> {
    (-40i64..40, 1i64..12).prop_map(|(p, q)| rational(p, q))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn surd_sign_agrees_with_intervals(p in small_rational(), q in small_rational(), r in 0i64..50) {
        let r = rational(r, 3);
        let at = |precision| {
            let root = Interval::from_rational(&r, precision).sqrt().unwrap();
            root.rational(&p) + root.rational(&q) * root
        };
        prop_assert_eq!(sign_of_surd(&p, &q, &r), Some(by_intervals(at)));
    }

    #[test]
    fn difference_sign_agrees_with_intervals(a in 0i64..80, b in 0i64..80, c in small_rational()) {
        let (a, b) = (rational(a, 4), rational(b, 4));
        let at = |precision| {
            let root = |x| Interval::from_rational(x, precision).sqrt().unwrap();
            root(&a) - root(&b) - Interval::from_rational(&c, precision)
        };
        prop_assert_eq!(sign_of_square_root_difference(&a, &b, &c), Some(by_intervals(at)));
    }
}

#[test]
fn ties_and_refusals() {
    // sqrt(9/4) - sqrt(1/4) = 1 exactly; sqrt(8) = 2 sqrt(2).
    let sign = |a, b, c| sign_of_square_root_difference(&a, &b, &c);
    assert_eq!(sign(rational(9, 4), rational(1, 4), rational(1, 1)), Some(Sign::Zero));
    assert_eq!(sign(rational(0, 1), rational(4, 1), rational(-2, 1)), Some(Sign::Zero));
    assert_eq!(sign(rational(-1, 1), rational(4, 1), rational(-2, 1)), None);
    assert_eq!(sign(rational(1, 1), rational(-4, 1), rational(-2, 1)), None);
    assert_eq!(sign_of_surd(&rational(1, 1), &rational(1, 1), &rational(-1, 1)), None);
    assert_eq!(sign_of_surd(&rational(-3, 1), &rational(2, 1), &rational(9, 4)), Some(Sign::Zero));
    // A difference of about 10^-40 is still decided.
    let tiny = rational(1, 1) / rational(10, 1).pow(40);
    assert_eq!(sign(rational(2, 1) + tiny, rational(2, 1), rational(0, 1)), Some(Sign::Positive));
}
