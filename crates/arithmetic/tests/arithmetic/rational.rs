//! Rationals against those of the crate num-rational: every operation on random numbers, small, long and at the edge between.

use arithmetic::{Rational, common_denominator, content, gcd, lcm};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};
use proptest::prelude::*;
use std::hash::{BuildHasher, RandomState};

/// Integers of one word, of a few, and within a few units of `±2^63`, `±2^31` and the like.
fn integers() -> impl Strategy<Value = BigInt> {
    let edges = (0u32..130, -3i64..4, any::<bool>()).prop_map(|(power, off, negative)| {
        let n = (BigInt::from(1) << power) + off;
        if negative { -n } else { n }
    });
    let long = proptest::collection::vec(any::<u32>(), 0..24)
        .prop_map(|words| BigInt::from_slice(num_bigint::Sign::Plus, &words) - (BigInt::from(1) << 300));
    prop_oneof![(-12i64..13).prop_map(BigInt::from), any::<i64>().prop_map(BigInt::from), edges, long]
}

fn pairs() -> impl Strategy<Value = (Rational, BigRational)> {
    (integers(), integers(), integers()).prop_map(|(p, q, common)| {
        let q = if q.is_zero() { BigInt::from(1) } else { q };
        let common = if common.is_zero() { BigInt::from(-7) } else { common };
        (Rational::new(&p * &common, &q * &common), BigRational::new(p, q))
    })
}

fn same(a: &Rational, b: &BigRational) -> bool {
    a.numer() == *b.numer() && a.denom() == *b.denom() && a.to_string() == b.to_string()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn operations_agree((a, x) in pairs(), (b, y) in pairs()) {
        prop_assert!(same(&a, &x));
        prop_assert!(same(&(&a + &b), &(&x + &y)));
        prop_assert!(same(&(&a - &b), &(&x - &y)));
        prop_assert!(same(&(&a * &b), &(&x * &y)));
        prop_assert!(same(&-&a, &-&x));
        prop_assert!(same(&arithmetic::Ring::square(&a), &(&x * &x)));
        prop_assert_eq!(a.cmp(&b), x.cmp(&y));
        prop_assert_eq!(a == b, x == y);
        prop_assert!(same(&a.abs(), &x.abs()));
        prop_assert!(same(&a.signum(), &x.signum()));
        if !y.is_zero() {
            prop_assert!(same(&(&a / &b), &(&x / &y)));
            prop_assert!(same(&(&a % &b), &(&x % &y)));
            prop_assert!(same(&b.pow(-3), &y.pow(-3)));
        }
    }

    #[test]
    fn numbers_go_to_num_rational_and_back((a, x) in pairs(), common in integers()) {
        prop_assert_eq!(&BigRational::from(&a), &x);
        prop_assert_eq!(BigRational::from(a.clone()), x.clone());
        prop_assert_eq!(Rational::from(&x), a.clone());
        // Not in lowest terms, with a denominator of either sign.
        if !common.is_zero() {
            let raw = BigRational::new_raw(x.numer() * &common, x.denom() * &common);
            prop_assert_eq!(Rational::from(&raw), a.clone());
            prop_assert_eq!(Rational::from(raw), a.clone());
        }
        let state = RandomState::new();
        prop_assert_eq!(state.hash_one(Rational::from(x)), state.hash_one(a));
    }

    #[test]
    fn roundings_and_texts_agree((a, x) in pairs()) {
        prop_assert!(same(&a.floor(), &x.floor()));
        prop_assert!(same(&a.ceil(), &x.ceil()));
        prop_assert!(same(&a.round(), &x.round()));
        prop_assert!(same(&a.trunc(), &x.trunc()));
        prop_assert!(same(&a.fract(), &x.fract()));
        prop_assert_eq!(a.to_f64().map(f64::to_bits), x.to_f64().map(f64::to_bits));
        prop_assert_eq!(a.to_i64(), x.to_i64());
        prop_assert_eq!(format!("{a:+}"), format!("{x:+}"));
        prop_assert_eq!(a.to_string().parse::<Rational>(), Ok(a));
    }

    #[test]
    fn equal_numbers_are_equal_however_they_were_made((a, _) in pairs(), (b, _) in pairs()) {
        // Through long numbers and back to short ones.
        let there_and_back = (&a + &b) - &b;
        prop_assert_eq!(&there_and_back, &a);
        let state = RandomState::new();
        prop_assert_eq!(state.hash_one(&there_and_back), state.hash_one(&a));
    }

    #[test]
    fn floats_are_exact(x in any::<f64>()) {
        let (a, y) = (Rational::from_float(x), BigRational::from_float(x));
        prop_assert_eq!(a.is_some(), y.is_some());
        if let (Some(a), Some(y)) = (a, y) {
            prop_assert!(same(&a, &y));
            prop_assert_eq!(a.to_f64(), Some(x));
        }
    }

    #[test]
    fn common_divisors_agree(a in integers(), b in integers(), common in integers()) {
        let (a, b) = (a * &common, b * &common);
        prop_assert_eq!(gcd(a.magnitude(), b.magnitude()), a.magnitude().gcd(b.magnitude()));
        prop_assert_eq!(lcm(&a, &b), a.lcm(&b));
        prop_assert_eq!(content([&a, &b, &common]), a.gcd(&b).gcd(&common));
    }

    #[test]
    fn denominators_agree(numbers in proptest::collection::vec(pairs(), 0..5)) {
        let known = numbers.iter().fold(BigInt::from(1), |d, (_, x)| d.lcm(x.denom()));
        prop_assert_eq!(common_denominator(numbers.iter().map(|(x, _)| x)), known);
    }
}

/// Quotients of Euclid's algorithm that are all 1, where the leading words decide least at a time, and one that is very large.
#[test]
fn common_divisors_of_extreme_numbers() {
    let mut fibonacci = (BigInt::from(0), BigInt::from(1));
    for n in 0..2000u32 {
        let (a, b) = (fibonacci.0.magnitude(), fibonacci.1.magnitude());
        assert_eq!(gcd(a, b), 1u32.into());
        let (c, d) = (a * 12_345_678_901_234_567_891u64, b * 12_345_678_901_234_567_891u64);
        assert_eq!(gcd(&c, &d), 12_345_678_901_234_567_891u64.into());
        let power = BigInt::from(1) << n;
        let near: BigInt = &power * 3 + 1;
        assert_eq!(gcd(power.magnitude(), near.magnitude()), power.magnitude().gcd(near.magnitude()));
        let next = &fibonacci.0 + &fibonacci.1;
        fibonacci = (fibonacci.1, next);
    }
}

#[test]
fn what_is_no_number_is_refused() {
    for text in ["", "/", "1/0", "1/", "a", "1/2/3", "1.5"] {
        assert!(text.parse::<Rational>().is_err(), "{text}");
    }
    assert_eq!("-6/4".parse(), Ok(arithmetic::rational(-3, 2)));
    assert!(Rational::from_float(f64::NAN).is_none());
}

#[test]
fn sums_and_products_of_many_and_positive_differences() {
    let list = [arithmetic::rational(1, 2), arithmetic::rational(-3, 4), arithmetic::rational(5, 3)];
    let (sum, product) = (arithmetic::rational(17, 12), arithmetic::rational(-5, 8));
    assert_eq!(list.iter().sum::<arithmetic::Rational>(), sum);
    assert_eq!(list.iter().cloned().sum::<arithmetic::Rational>(), sum);
    assert_eq!(list.iter().product::<arithmetic::Rational>(), product);
    assert_eq!(list.iter().cloned().product::<arithmetic::Rational>(), product);
    let above = num_traits::Signed::abs_sub(&list[0], &list[1]);
    assert_eq!(
        (above, num_traits::Signed::abs_sub(&list[1], &list[0])),
        (arithmetic::rational(5, 4), arithmetic::rational(0, 1))
    );
}
