//! Elementary functions near zero, where relative precision is promised, and at the limits of their arguments.

use arithmetic::{Dyadic, Interval, Number, Rational, Ring, rational};
use num_bigint::BigInt;
use num_traits::Signed;

fn point(mantissa: i64, exponent: i64, precision: u32) -> Interval {
    let x = Dyadic::new(BigInt::from(mantissa), exponent);
    Interval::between(x.clone(), x, precision)
}

fn power_of_two(exponent: i64) -> Rational {
    let power = Rational::from_integer(BigInt::from(1) << exponent.unsigned_abs());
    if exponent < 0 { power.recip() } else { power }
}

/// Whether the interval overlaps `[lo, hi]`, which holds the exact value, and reaches beyond it by no more than `slack`.
fn is_sharp(found: &Interval, (lo, hi): (Rational, Rational), slack: &Rational) -> bool {
    let (below, above) = found.to_rationals();
    below <= hi && above >= lo && below >= &lo - slack && above <= &hi + slack
}

#[test]
fn sine_arctangent_and_hyperbolic_sine_near_zero() {
    for precision in [24, 53, 100, 200] {
        for exponent in [-1, -5, -9, -14, -20, -31, -60, -90, -200, -1000] {
            let x = power_of_two(exponent);
            let (cube, fifth) = (x.power(3), x.power(5));
            let slack = &x * power_of_two(3 - i64::from(precision));
            let third = |n: i64| &cube / rational(n, 1);
            let rest = |n: i64| &fifth / rational(n, 1);
            let argument = point(1, exponent, precision);
            let (sine, cosine) = argument.sin_cos().unwrap();
            let near_cosine = rational(1, 1) - &(&x * &x / rational(2, 1));
            let bounds = (near_cosine.clone(), near_cosine + &(&x * &cube / rational(24, 1)));
            let one_unit = power_of_two(3 - i64::from(precision));
            assert!(is_sharp(&cosine, bounds, &one_unit), "cos 2^{exponent}: {cosine:?}");
            assert!(cosine.to_rationals().1 <= rational(1, 1), "cos 2^{exponent}: {cosine:?}");
            let near_sine = &x - third(6);
            assert!(is_sharp(&sine, (near_sine.clone(), near_sine + rest(120)), &slack), "sin 2^{exponent}: {sine:?}");
            let arctangent = argument.atan().unwrap();
            let near_arctangent = &x - third(3);
            let bounds = (near_arctangent.clone(), near_arctangent + rest(5));
            assert!(is_sharp(&arctangent, bounds, &slack), "atan 2^{exponent}: {arctangent:?}");
            let hyperbolic = argument.sinh_cosh().unwrap().0;
            let near_hyperbolic = &x + third(6);
            let bounds = (near_hyperbolic.clone(), near_hyperbolic + rest(100));
            assert!(is_sharp(&hyperbolic, bounds, &slack), "sinh 2^{exponent}: {hyperbolic:?}");
        }
    }
}

#[test]
fn exponentials_and_logarithms_are_sharp() {
    for precision in [24, 53, 200, 1000] {
        let unit = power_of_two(3 - i64::from(precision));
        for (mantissa, exponent) in [(1, 0), (-3, -1), (5, 1), (300, 0), (1, -20), (-1001, 0), (3, -2), (1023, -10)] {
            let x = point(mantissa, exponent, precision);
            let (below, above) = x.exp().unwrap().to_rationals();
            assert!(below <= above && &above - &below <= &below * &unit, "exp {mantissa} 2^{exponent}");
            if mantissa > 1 {
                let (below, above) = x.ln().unwrap().to_rationals();
                assert!(below <= above && &above - &below <= below.abs() * &unit, "ln {mantissa} 2^{exponent}");
            }
        }
    }
}

#[test]
fn logarithms_near_one_keep_their_relative_precision() {
    for exponent in [-20, -100, -150] {
        let x = Dyadic::new((BigInt::from(1) << (-exponent) as u64) + 1, exponent);
        let (below, above) = Interval::between(x.clone(), x, 200).ln().unwrap().to_rationals();
        // x - x²/2 < ln(1 + x) < x.
        let small = power_of_two(exponent);
        assert!(below <= small && above >= &small - &(&small * &small / rational(2, 1)), "ln(1 + 2^{exponent})");
        assert!(&above - &below <= &small * power_of_two(-197), "ln(1 + 2^{exponent})");
    }
}

#[test]
fn arguments_beyond_the_limits() {
    assert!(point(1, 31, 53).exp().is_ok() && point(1, 32, 53).exp().is_err());
    let least = point(-1, 32, 53).exp().unwrap();
    assert!(least.lo().is_zero() && *least.hi() < Dyadic::new(BigInt::from(1), -1_000_000));
    let everything = |x: &Interval| x.to_rationals() == (rational(-1, 1), rational(1, 1));
    let (sine, cosine) = point(3, 58, 100).sin_cos().unwrap();
    assert!(!everything(&sine) && !everything(&cosine));
    let (sine, cosine) = point(3, 59, 100).sin_cos().unwrap();
    assert!(everything(&sine) && everything(&cosine));
}
