//! Floats as scalars: quotients of integers are rounded once, and what has no value is refused.

use arithmetic::{Field, Number, Sign, Signed, rational};

#[test]
fn quotients_of_integers_are_rounded_once() {
    assert_eq!(0.0.ratio(1, 3), 1.0 / 3.0);
    let edge = 1i64 << 53;
    for (p, q) in [(edge + 1, 3), (3, edge + 1), (edge + 1, edge + 3), (edge, 7), (7, -edge), (-edge - 1, edge)] {
        assert_eq!(0.0.ratio(p, q), 0.0.rational(&rational(p, q)), "{p}/{q}");
    }
    // Rounded to a float first, the numerator would lose its last bit.
    assert_eq!(0.0.ratio(edge + 1, 3), ((edge + 1) / 3) as f64);
}

#[test]
fn what_has_no_value_is_refused() {
    assert!(0.0.recip().is_err() && 0.5.recip() == Ok(2.0));
    assert!(3.0.over(&0.0).is_err() && 3.0.over(&4.0) == Ok(0.75) && 0.0.over(&4.0) == Ok(0.0));
    assert!(Number::sqrt(&-1e-300).is_err() && Number::sqrt(&0.0) == Ok(0.0) && Number::sqrt(&0.25) == Ok(0.5));
    assert!(Number::ln(&0.0).is_err() && Number::ln(&-1.0).is_err() && Number::ln(&1.0) == Ok(0.0));
    assert!(Number::ln(&0.5).is_ok_and(|x| x < 0.0));
    let sign = |x: f64| Signed::sign(&x);
    assert_eq!([-0.5, 0.0, 0.5].map(sign), [Sign::Negative, Sign::Zero, Sign::Positive].map(Some));
    assert_eq!(sign(f64::NAN), None);
}
