//! Mirrors `src/spectrum`.

mod abscissa;
mod closed_forms;
mod enclosures;
mod stability;
mod tridiagonals;

use algebra::spectrum::{Polynomial, Recurrence, RecurrenceError};
use arithmetic::{Rational, Sign, Unwatched, rational};
use num_bigint::BigInt;
use num_traits::Signed;
use proptest::prelude::*;

/// Half an ulp of one.
const UNIT: f64 = f64::EPSILON / 2.0;

/// By how much a bound may be rounded up at each step.
const SLACK: f64 = 1.0 + 1e-6;

fn float(x: f64) -> Rational {
    Rational::from_float(x).expect("finite")
}

fn product(roots: &[Rational]) -> Polynomial {
    let mut coefficients = vec![rational(1, 1)];
    for root in roots {
        let mut next = vec![rational(0, 1); coefficients.len() + 1];
        for (k, c) in coefficients.iter().enumerate() {
            next[k] -= c * root;
            next[k + 1] += c;
        }
        coefficients = next;
    }
    Polynomial::from_rationals(&coefficients)
}

/// Distinct numbers in (0, 1) and coefficients that are not zero.
fn sums() -> impl Strategy<Value = Vec<(Rational, Rational)>> {
    let coefficient = prop_oneof![-40i64..0, 1i64..40];
    prop::collection::btree_map(1i64..60, coefficient, 0..6)
        .prop_map(|map| map.into_iter().map(|(r, c)| (rational(r, 60), rational(c, 7))).collect())
}

fn value(polynomial: &[i64], sum: &[(Rational, Rational)], r: i32) -> Rational {
    let powers = polynomial.iter().enumerate().map(|(k, &c)| rational(i64::from(r), 1).pow(k as i32) * rational(c, 3));
    powers.sum::<Rational>() + sum.iter().map(|(root, c)| root.pow(r) * c).sum::<Rational>()
}

proptest! {
    #[test]
    fn roots_are_isolated(roots in prop::collection::btree_set(-30i64..30, 1..8)) {
        let roots: Vec<Rational> = roots.into_iter().map(|r| rational(r, 12)).collect();
        let polynomial = product(&roots);
        let inside: Vec<&Rational> = roots.iter().filter(|r| **r > rational(-1, 1) && **r <= rational(2, 1)).collect();
        let mut found = polynomial.roots_in(&rational(-1, 1), &rational(2, 1));
        prop_assert_eq!(found.len(), inside.len());
        for (root, expected) in found.iter_mut().zip(inside) {
            polynomial.refine(root, 80);
            prop_assert!(root.enclosure(128).contains(expected));
            prop_assert!(polynomial.enclose(&root.enclosure(128)).contains_zero());
        }
        prop_assert!(polynomial.is_square_free());
        let doubled = product(&[roots.clone(), roots[..1].to_vec()].concat());
        prop_assert!(!doubled.is_square_free());
    }

    #[test]
    fn the_long_run_is_that_of_the_terms(polynomial in prop::collection::vec(-5i64..5, 0..3), sum in sums()) {
        let terms: Vec<Rational> = (0..20).map(|r| value(&polynomial, &sum, r)).collect();
        let recurrence = Recurrence::new(terms, &Unwatched).unwrap();
        let degree = polynomial.iter().rposition(|&c| c != 0).map_or(0, |k| k + 1);
        prop_assert_eq!(recurrence.order(), degree + sum.len());
        let eventual = recurrence.eventual_sign(&Unwatched).unwrap();
        for k in 0..12 {
            let at = value(&polynomial, &sum, eventual.from as i32 + k);
            let sign = if at.is_positive() { Sign::Positive } else if at.is_negative() { Sign::Negative } else { Sign::Zero };
            prop_assert_eq!(sign, eventual.sign);
        }
    }

    #[test]
    fn sizes_far_out_are_enclosed(sum in sums()) {
        let recurrence = Recurrence::new((0..14).map(|r| value(&[], &sum, r)).collect(), &Unwatched).unwrap();
        let r = 3000;
        match recurrence.leading(&BigInt::from(r), &Unwatched) {
            Ok(None) => prop_assert!(sum.is_empty()),
            Ok(Some(leading)) => {
                let exact = value(&[], &sum, r);
                prop_assert_eq!(leading.sign == Sign::Positive, exact.is_positive());
                // 2^lo <= |exact| <= 2^hi, seen through the number of bits.
                let bits = exact.numer().bits() as f64 - exact.denom().bits() as f64;
                prop_assert!((leading.log2.to_f64() - bits).abs() <= 1.01);
            }
            Err(error) => prop_assert!(matches!(error, RecurrenceError::Precision(_)), "{error}"),
        }
    }
}

#[test]
fn sequences_that_are_not_decided() {
    // Fibonacci grows; (-1/2)^r has a negative root; r 2^-r a double one.
    let fibonacci = [0, 1, 1, 2, 3, 5, 8, 13].map(|x| rational(x, 1)).to_vec();
    assert_eq!(Recurrence::new(fibonacci, &Unwatched).unwrap().eventual_sign(&Unwatched), Err(RecurrenceError::Roots));
    let negative = (0..6).map(|r| rational(-1, 2).pow(r)).collect();
    assert_eq!(Recurrence::new(negative, &Unwatched).unwrap().eventual_sign(&Unwatched), Err(RecurrenceError::Roots));
    let double = (0..8).map(|r| rational(i64::from(r), 1) * rational(1, 2).pow(r)).collect();
    assert_eq!(Recurrence::new(double, &Unwatched).unwrap().eventual_sign(&Unwatched), Err(RecurrenceError::Roots));
    let short = vec![rational(0, 1), rational(0, 1), rational(1, 1)];
    assert!(matches!(
        Recurrence::new(short, &Unwatched).unwrap().eventual_sign(&Unwatched),
        Err(RecurrenceError::TooFewTerms { .. })
    ));
}
