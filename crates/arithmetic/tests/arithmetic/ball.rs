//! Balls against exact rationals: chains of operations contain the exact value or say that they overflowed.

use arithmetic::{Ball, Interval, Rational, Ring, rational};
use num_bigint::BigInt;
use num_traits::Signed as _;
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

/// Midpoint and radius, exactly.
fn parts<const LIMBS: usize>(ball: &Ball<LIMBS>) -> (Rational, Rational) {
    let (lo, hi) = ball.to_interval(6000).unwrap().to_rationals();
    ((&lo + &hi) / rational(2, 1), (hi - lo) / rational(2, 1))
}

fn power_of_two(k: i32) -> Rational {
    rational(2, 1).pow(k)
}

/// The radius of a result covers the corners of wide operands, and not much more.
fn corners<const LIMBS: usize>(a: &Interval, b: &Interval) -> Result<(), TestCaseError> {
    let unit = power_of_two(-(Ball::<LIMBS>::SCALE as i32));
    let about_one = rational(1, 1) + rational(1, 1_000_000_000_000);
    let (x, y) = (Ball::<LIMBS>::from_interval(a), Ball::<LIMBS>::from_interval(b));
    let ((p, r), (q, s)) = (parts(&x), parts(&y));
    for (interval, (middle, radius)) in [(a, (&p, &r)), (b, (&q, &s))] {
        let (lo, hi) = interval.to_rationals();
        prop_assert!(middle - radius <= lo && hi <= middle + radius);
        prop_assert!(*radius <= (hi - lo) / rational(2, 1) * &about_one + &unit * rational(2, 1));
    }
    // Writing a ball as an interval makes its radius a little longer, which must not count twice.
    let t = &s * (rational(1, 1) - rational(2, 100_000_000_000_000));
    let limb = (&r + &s) * power_of_two(-62);
    for (result, middle, radius, slack) in [
        (x.clone() + &y, &p + &q, &r + &s, rational(0, 1)),
        (x.clone() - &y, &p - &q, &r + &s, rational(0, 1)),
        (x.clone() * &y, &p * &q, p.abs() * &t + q.abs() * &r + r.clone() * &t, limb),
    ] {
        let (found, around) = parts(&result);
        let distance = (&found - &middle).abs();
        prop_assert!(distance <= unit, "{} units off", distance / unit);
        prop_assert!(&radius + &distance <= around, "{} does not cover {}", around, radius);
        prop_assert!(around <= radius * &about_one + slack + &unit * rational(2, 1));
    }
    prop_assert_eq!(parts(&-x), (-p, r));
    Ok(())
}

/// An interval of any size, with ends that are cut to a unit or not.
fn wide() -> impl Strategy<Value = Interval> {
    (any::<i64>(), -200i32..-20, any::<u32>(), -200i32..-20).prop_map(|(p, shift, width, scale)| {
        let middle = rational(p >> 32, 1) * power_of_two(shift);
        let slack = rational(i64::from(width), 1) * power_of_two(scale);
        Interval::hull_of_rationals(&(&middle - &slack), &(middle + slack), 500)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn the_radius_covers_the_corners_and_little_more(a in wide(), b in wide()) {
        corners::<2>(&a, &b)?;
        corners::<3>(&a, &b)?;
        corners::<5>(&a, &b)?;
    }
}

/// Midpoints below `2^62` in size are kept, others given up; whole numbers are exact.
#[test]
fn the_range_ends_at_two_to_the_62() {
    let ball = |k: i64| Ball::<3>::from_interval(&Interval::from_rational(&rational(k, 1), 100));
    let (half, side) = (1i64 << 61, 1i64 << 31);
    for (result, is_kept) in [
        (ball((1 << 62) - 1), true),
        (ball(1 << 62), false),
        (ball(-(1 << 62)), false),
        (ball(half) + ball(half - 1), true),
        (ball(half) + ball(half), false),
        (ball(-half) - ball(half - 1), true),
        (ball(-half) - ball(half) - ball(1), false),
        (ball(side) * ball(side - 1), true),
        (ball(-side) * ball(side - 1), true),
        (ball(side) * ball(side), false),
        (ball(-side) * ball(side), false),
        (ball(0).integer((1 << 62) - 1), true),
        (ball(0).integer(1 << 62), false),
    ] {
        assert_eq!(result.to_interval(100).is_some(), is_kept, "{result:?}");
    }
    assert_eq!(parts(&ball(7).integer(-3)), (rational(-3, 1), rational(0, 1)));
    assert_eq!(parts(&ball(7)).0, rational(7, 1));
}
