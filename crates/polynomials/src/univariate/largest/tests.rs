//! Largest values that are known, and dense scans.

use super::*;
use arithmetic::{Unwatched, rational};
use proptest::prelude::*;

fn list(numbers: &[i64]) -> Vec<BigInt> {
    numbers.iter().map(|n| BigInt::from(*n)).collect()
}

fn product(a: &[BigInt], b: &[BigInt]) -> Vec<BigInt> {
    let mut all = vec![BigInt::ZERO; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            all[i + j] += x * y;
        }
    }
    all
}

fn largest(p: &[BigInt], q: &[BigInt], digits: u32) -> Result<Largest, LargestError> {
    largest_quotient(p, q, digits, &Unwatched)
}

fn place(found: &Largest) -> &Interval {
    match &found.places[..] {
        [Place::At(x)] => x,
        other => panic!("{other:?}"),
    }
}

#[test]
fn values_that_are_known() {
    // 1/(1 + (x - 3)²) = 1/(10 - 6x + x²): 1 at 3.
    let found = largest(&list(&[1]), &list(&[10, -6, 1]), 40).unwrap();
    assert!(place(&found).contains(&rational(3, 1)) && found.value.contains(&rational(1, 1)));
    assert!(significant_digits(place(&found)) >= 40 && significant_digits(&found.value) >= 40);
    // At the end: 1/(1 + x), and flat there: 1/(1 + x^6).
    for q in [list(&[1, 1]), list(&[1, 0, 0, 0, 0, 0, 1])] {
        let found = largest(&list(&[1]), &q, 20).unwrap();
        assert!(place(&found).contains(&rational(0, 1)) && significant_digits(place(&found)) > 1000);
        assert!(found.value.contains(&rational(1, 1)));
    }
    // At infinity: x/(1 + x).
    let found = largest(&list(&[0, 1]), &list(&[1, 1]), 20).unwrap();
    assert!(matches!(&found.places[..], [Place::Infinity]) && found.value.contains(&rational(1, 1)));
    // Constant, and zero.
    for (p, height) in [([2, 6], 2), ([0, 0], 0)] {
        let found = largest(&list(&p), &list(&[1, 3]), 20).unwrap();
        assert!(place(&found).contains(&rational(0, 1)) && found.value.contains(&rational(height, 1)));
    }
    // Irrational: x/(2 + x²) at the root of 2.
    let found = largest(&list(&[0, 1]), &list(&[2, 0, 1]), 1000).unwrap();
    let (lo, hi) = place(&found).to_rationals();
    assert!(&lo * &lo <= rational(2, 1) && &hi * &hi >= rational(2, 1) && significant_digits(place(&found)) >= 1000);
    assert!(matches!(largest(&list(&[0, 0, 1]), &list(&[1, 1]), 5), Err(LargestError::Unbounded)));
    for q in [list(&[2, -3, 1]), list(&[0, 1]), list(&[-1, 1])] {
        assert!(matches!(largest(&list(&[1]), &q, 5), Err(LargestError::Pole)), "{q:?}");
    }
}

/// A flat top, `1/(1 + (x - 1/3)^4)`, and two peaks of the same height, which are not told apart.
#[test]
fn flat_tops_and_equal_heights() {
    // 81 + (3x - 1)^4.
    let fourth = product(&list(&[1, -6, 9]), &list(&[1, -6, 9]));
    let mut q = fourth.clone();
    q[0] += 81;
    let found = largest(&list(&[81]), &q, 20).unwrap();
    assert!(found.places.iter().any(|place| matches!(place, Place::At(x) if x.contains(&rational(1, 3)))));
    assert!(found.value.contains(&rational(1, 1)) && significant_digits(&found.value) >= 20, "{}", found.value);
    // 1/(1 + (x - 1)²(x - 5)²).
    let mut q = product(&list(&[1, -2, 1]), &list(&[25, -10, 1]));
    q[0] += 1;
    let found = largest(&list(&[1]), &q, 20).unwrap();
    assert!(found.places.len() == 2 && found.value.contains(&rational(1, 1)));
    // Just as high but for 10^-30: 1 + (x - 1)²(x - 5)² + x/10^30.
    let scale = BigInt::from(10).pow(30);
    let mut q: Vec<BigInt> = q.iter().map(|c| c * &scale).collect();
    q[1] += 1;
    let found = largest(&[scale], &q, 20).unwrap();
    assert!((place(&found).to_f64() - 1.0).abs() < 1e-9);
}

/// A peak whose width is 10^-9 of its frequency, beside broad ones.
#[test]
fn needles_are_found() {
    let needle = 1_000_000_007i64;
    // (x - 7)² + 10^-18 and (x - 2)² + 1, and the needle's height is the largest by little.
    let narrow = vec![
        BigInt::from(49) * BigInt::from(needle).pow(2) + 1,
        BigInt::from(-14) * BigInt::from(needle).pow(2),
        BigInt::from(needle).pow(2),
    ];
    let broad = list(&[5, -4, 1]);
    // 1/narrow + c/broad with c = 9/10, over a common denominator: (10 broad + 9 narrow)/(10 narrow broad).
    let p: Vec<BigInt> = (0..3).map(|k| &broad[k] * 10 + &narrow[k] * 9).collect();
    let q: Vec<BigInt> = product(&narrow, &broad).into_iter().map(|c| c * 10).collect();
    let found = largest(&p, &q, 30).unwrap();
    assert!((place(&found).to_f64() - 7.0).abs() < 1e-12, "{:?}", found.places);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// No point of a dense scan is higher, and the value is taken: random products of quadratic factors.
    #[test]
    fn no_point_of_a_scan_is_higher(
        factors in prop::collection::vec((1i64..200, 1i64..2000), 1..6), top in prop::collection::vec(0i64..50, 1..12),
    ) {
        // (a x - b)² + 1 and so on: positive everywhere.
        let q = factors.iter().fold(list(&[1]), |all, (a, b)| product(&all, &list(&[b * b + 1, -2 * a * b, a * a])));
        let mut p = list(&top);
        p.truncate(q.len());
        let found = largest(&p, &q, 12).unwrap();
        let (lo, hi) = found.value.to_rationals();
        let height = |x: &Rational| value(&p, x) / value(&q, x);
        let poles = factors.iter().map(|(a, b)| rational(*b, *a));
        let grid = (-40..60).map(|k| if k < 0 { rational(1, 1 << -k) } else { rational(k * k, 7) });
        for x in poles.chain(grid) {
            prop_assert!(height(&x) <= hi, "{x}");
        }
        if let [Place::At(x)] = &found.places[..] {
            let (from, to) = x.to_rationals();
            let middle = (from + to) / rational(2, 1);
            prop_assert!(&lo - height(&middle) <= &lo * rational(1, 1_000_000_000));
        }
    }
}
