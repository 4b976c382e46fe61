//! Balls against exact rationals: chains of operations contain the exact value or say that they overflowed.

use arithmetic::{Ball, Interval, Rational, Ring, rational};
use num_bigint::BigInt;
use proptest::prelude::*;

/// A rational of a size from 2^-200 to 2^40, with an interval around it.
fn enclosed() -> impl Strategy<Value = (Interval, Rational)> {
    (any::<i64>(), -220i32..20, 0u32..3).prop_map(|(p, shift, width)| {
        let power = Rational::from_integer(BigInt::from(1) << shift.unsigned_abs());
        let size = rational(p >> 40, 1);
        let x = if shift < 0 { size / power } else { size * power };
        let slack = Rational::new(BigInt::from(width), BigInt::from(1) << 90);
        (Interval::hull_of_rationals(&(x.clone() - &slack), &(x.clone() + slack), 400), x)
    })
}

fn chain<T: Ring>(x: &T, y: &T, z: &T, steps: &[u8]) -> T {
    steps.iter().fold(x.clone(), |value, step| match step % 6 {
        0 => value * y,
        1 => value + z,
        2 => value - y,
        3 => value.square(),
        4 => -value * z,
        _ => value.integer(i64::from(*step)) - value,
    })
}

fn check<const LIMBS: usize>(values: &[(Interval, Rational); 3], steps: &[u8]) -> Result<(), TestCaseError> {
    let balls = values.each_ref().map(|(interval, _)| Ball::<LIMBS>::from_interval(interval));
    let exact = values.each_ref().map(|(_, x)| x);
    let result = chain(&balls[0], &balls[1], &balls[2], steps);
    if let Some(interval) = result.to_interval(600) {
        prop_assert!(interval.contains(&chain(exact[0], exact[1], exact[2], steps)));
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn chains_contain_the_exact_value(a in enclosed(), b in enclosed(), c in enclosed(), steps in prop::collection::vec(any::<u8>(), 0..9)) {
        let values = [a, b, c];
        check::<2>(&values, &steps)?;
        check::<3>(&values, &steps)?;
        check::<4>(&values, &steps)?;
        check::<8>(&values, &steps)?;
        check::<16>(&values, &steps)?;
    }
}

#[test]
fn overflow_is_never_lost() {
    let huge = Ball::<3>::from_interval(&Interval::from_rational(&rational(1 << 40, 1), 100));
    let lost = huge.square();
    assert!(lost.to_interval(100).is_none());
    assert!((lost.clone() * lost.zero()).to_interval(100).is_none());
    assert!((lost.clone() - &lost).to_interval(100).is_none());
    let beyond =
        Ball::<3>::from_interval(&Interval::from_rational(&Rational::from_integer(BigInt::from(1) << 80), 100));
    assert!(beyond.to_interval(100).is_none());
    assert!((huge.clone() - huge).to_interval(100).is_some_and(|x| x.contains(&rational(0, 1))));
}
